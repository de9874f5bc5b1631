#!/usr/bin/env bash
# clang-tidy, as .clang-tidy says, over sources of the library: 1.3 s of processor each.
#   tidy.sh BUILD            all of src
#   tidy.sh BUILD FILE...    these
# Exit status 77 (skipped) without clang-tidy.
set -euo pipefail
build=$1
cd "$(dirname "$0")/../.."
command -v clang-tidy >/dev/null || { echo "skipped: clang-tidy is not installed"; exit 77; }
files=("${@:2}")
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(find src -name '*.cpp' | sort)
# What it counts on its second output are warnings of others' headers, which it does not show.
printf '%s\n' "${files[@]}" | xargs -P 2 -n 2 clang-tidy --quiet -p "$build" 2>/dev/null
echo "${#files[@]} files"
