#!/usr/bin/env bash
# No name of src stands for two things: gcc's link-time optimiser sees all types of all files at once and says where two
# structs of one name differ (-Wodr). Units of kernels are left out: the same text for each instruction set.
#   one_definition.sh COMPILER [FOLDER_OF_SOURCES]      status 77: the compiler is not gcc
set -euo pipefail
compiler=$1
root=$(cd "$(dirname "$0")/../.." && pwd)
sources=${2:-$root/src}
"$compiler" --version | grep -q 'Free Software Foundation' || { echo "skipped: $compiler is not gcc"; exit 77; }
objects=$(mktemp -d)
trap 'rm -rf "$objects"' EXIT
files=$(find "$sources" -name '*.cpp' -not -path '*/kernels/*' -not -path '*/simd/*' | sort)
[ -n "$files" ] || { echo "WRONG: no sources in $sources"; exit 1; }
compile() { "$compiler" -std=c++17 -O0 -flto -w -I"$root/src" -I"$root/include_c" \
  -DWRC_COMMIT='"none"' -DWRC_FLAGS='"none"' -c "$1" -o "$(mktemp "$objects/XXXXXX.o")"; }
export -f compile
export compiler root objects
xargs -P "$(nproc)" -I{} bash -c 'compile {}' <<<"$files"
# The linker only says so: its status is that of the link.
"$compiler" -flto -Wodr -r "$objects"/*.o -o "$objects/all" 2>"$objects/said" || { cat "$objects/said"; exit 1; }
cat "$objects/said"
violations=$(grep -c 'Wodr' "$objects/said" || true)
echo "$(wc -l <<<"$files") files, $violations names with two definitions"
[ "$violations" -eq 0 ]
