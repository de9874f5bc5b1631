#!/usr/bin/env bash
# The units of kernels compiled for an instruction set beyond the baseline must define nothing that the linker may merge
# with, or take instead of, what another unit defines: one exported table each, and nothing weak.
#   kernel_symbols.sh compiler source_directory built objects of the library
#   kernel_symbols.sh compiler source_directory -O0 objects of the library      besides: compiled again at this level, by ./test.sh all
#                                                                               at -O1 and -O3 too
set -euo pipefail
compiler=$1 source=$2
objects=("${@:4}")
levels=()
[ "$3" = built ] || levels+=("$3")
[ "$3" = built ] || [ -z "${WRC_TEST_ALL:-}" ] || levels+=(-O1 -O3)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
nothing_shared() { # module, set, how it was built, object
  local others
  # DW.ref.*: a pointer to the C++ runtime's handler, the same in every unit; no code.
  others=$(nm -C --defined-only "$4" |
    awk '$2 ~ /[A-Zuvw]/ && $0 !~ / V DW\.ref\./ && $0 !~ / [RD] wrc::simd::'"$2::$1"'_kernels$/')
  if [ -n "$others" ]; then
    echo "src/$1/simd/kernels.cpp for $2 $3 shares these with other units:" >&2
    echo "$others" >&2
    exit 1
  fi
  echo "$1 $2 $3: nothing shared"
}
check() { # set, flags
  local name=$1 unit module object each level
  for unit in "$source"/src/*/simd/kernels.cpp; do
    module=${unit#"$source"/src/} object=
    module=${module%/simd/kernels.cpp}
    for each in "${objects[@]}"; do [[ $each != */kernels/${module}_$name.cpp.o ]] || object=$each; done
    [ -n "$object" ] || { echo "no object of $unit for $name among those given" >&2; exit 1; }
    nothing_shared "$module" "$name" "as built" "$object"
    for level in "${levels[@]}"; do
      "$compiler" -std=c++17 "$level" "${@:2}" -DWRC_SET="$name" -fPIC -ffp-contract=off -I"$source/src" \
        -I"$source/include_c" -c "$unit" -o "$scratch/$name.o"
      nothing_shared "$module" "$name" "at $level" "$scratch/$name.o"
    done
  done
}
check avx2 -mavx2
check avx512 -mavx512f -mavx512dq -mavx512vl
