#!/usr/bin/env bash
# The units compiled for an instruction set beyond the baseline must define nothing that the linker may merge with, or
# take instead of, what another unit defines: one exported table, and nothing weak, at any optimisation.
#   kernel_symbols.sh compiler source_directory
set -euo pipefail
compiler=$1 source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
check() { # room, name, flags
  local room=$1 name=$2
  shift 2
  for level in -O0 -O1 -O3; do
    "$compiler" -std=c++20 $level "$@" -fPIC -ffp-contract=off -I"$source/src" -I"$source/include_c" \
      -c "$room/kernels_$name.cpp" -o "$scratch/$name.o"
    local others
    others=$(nm -C --defined-only "$scratch/$name.o" |
      awk '$2 ~ /[A-Zuvw]/ && $0 !~ / [RD] wrc::simd::'"$name"'(_[a-z]+)?_kernels$/')
    if [ -n "$others" ]; then
      echo "$room/kernels_$name.cpp at $level shares these with other units:" >&2
      echo "$others" >&2
      exit 1
    fi
    echo "${room#"$source/"} $name $level: nothing shared"
  done
}
for room in "$source"/src/*/simd; do
  check "$room" avx2 -mavx2
  check "$room" avx512 -mavx512f -mavx512dq -mavx512vl
done
