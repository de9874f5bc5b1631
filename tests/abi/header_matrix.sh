#!/usr/bin/env bash
# The public headers alone, under every language standard a host may use, with the strictest warnings of both compilers.
#   header_matrix.sh include_directory
set -euo pipefail
include=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for header in "$include"/wrc/*.h; do
  name="wrc/$(basename "$header")"
  printf '#include "%s"\n#include "%s"\nint main(void) { return 0; }\n' "$name" "$name" >"$scratch/main.c"
  cp "$scratch/main.c" "$scratch/main.cpp"
  for pair in gcc:g++ clang:clang++; do
    cc=${pair%%:*} cxx=${pair##*:}
    command -v "$cc" >/dev/null || { echo "skipped: $cc is not installed"; continue; }
    for standard in c99 c11 c17 c2x; do
      "$cc" -std=$standard -Wall -Wextra -Wpedantic -Werror -I"$include" -fsyntax-only "$scratch/main.c"
      echo "$name $cc $standard"
    done
    for standard in c++98 c++11 c++14 c++17 c++20 c++2b; do
      "$cxx" -std=$standard -Wall -Wextra -Wpedantic -Werror -I"$include" -fsyntax-only "$scratch/main.cpp"
      echo "$name $cxx $standard"
    done
  done
done
