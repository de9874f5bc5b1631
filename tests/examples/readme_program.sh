#!/usr/bin/env bash
# The program in README.md compiles, and prints what README.md says it prints.
#   readme_program.sh source_directory libwrc.so
set -euo pipefail
source=$1 library=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sed -n '/^```c$/,/^```$/{/^```/!p}' "$source/README.md" >"$folder/program.c"
sed -n 's/^It prints `\(.*\)`\.$/\1/p' "$source/README.md" >"$folder/promised"
test -s "$folder/program.c" && test "$(wc -l <"$folder/promised")" -eq 1
cc -std=c99 -Wall -Wextra -Werror -I"$source/include_c" "$folder/program.c" "$library" \
  -Wl,-rpath,"$(dirname "$library")" -o "$folder/program"
"$source/tests/examples/check_output.py" "$folder/promised" "$folder/program"
