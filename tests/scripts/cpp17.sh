#!/usr/bin/env bash
# The library's sources are C++17 with the standard library of gcc 8: clang refuses later language, and names that libraries brought
# later are searched for. Designated initialisers are let through: gcc 8 and clang have them in C++17.
#   cpp17.sh [DIRECTORY]     src unless told. Status 77 without clang
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
src=${1:-$root/src}
fail=0

# Headers, functions and builtins newer than gcc 8.
later='#include <(bit|span|concepts|ranges|numbers|compare|format|memory_resource|execution|filesystem|semaphore|latch|barrier|version)>'
later+='|std::(bit_cast|span|numbers|endian|chars_format|from_chars|ssize|erase_if|lerp|midpoint|to_address|remove_cvref|type_identity'
later+='|reduce|transform_reduce|(in|ex)clusive_scan|is_constant_evaluated|make_unique_for_overwrite|assume_aligned|construct_at)\b'
later+='|__builtin_(bit_cast|convertvector|shufflevector|is_constant_evaluated|assoc_barrier|has_attribute)\b'
if grep -rnE "$later" "$src" --include='*.cpp' --include='*.hpp'; then
  echo "not in the standard library or the compiler of gcc 8"
  fail=1
fi

clang=$(command -v clang++ || true)
if [ -z "$clang" ]; then
  echo "skipped: no clang++"
  exit $((fail ? fail : 77))
fi
export root clang
check() {
  local set=()
  case $1 in */simd/kernels.cpp) set=(-DWRC_SET=baseline) ;; esac
  "$clang" -std=c++17 -pedantic-errors -Werror=c++20-extensions -Wno-c++20-designator -fsyntax-only -I"$root/src" -I"$root/include_c" \
           '-DWRC_COMMIT="none"' '-DWRC_FLAGS=""' "${set[@]}" "$1"
}
export -f check
find "$src" -name '*.cpp' -print0 | sort -z | xargs -0 -P"$(nproc)" -I{} bash -c 'check {}' || fail=1
exit $fail
