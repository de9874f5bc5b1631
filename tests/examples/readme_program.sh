#!/usr/bin/env bash
# The program in README.md has 25 lines at most, compiles, and prints what README.md says it prints.
#   readme_program.sh source_directory libwrc.so
set -euo pipefail
source=$1 library=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sed -n '/^```c$/,/^```$/{/^```/!p}' "$source/README.md" >"$folder/program.c"
sed -n '/^```text$/,/^```$/{/^```/!p}' "$source/README.md" >"$folder/promised"
test -s "$folder/program.c" && test -s "$folder/promised"
test "$(wc -l <"$folder/program.c")" -le 25 || { echo "README's program is too long"; exit 1; }
cc -std=c99 -Wall -Wextra -Wconversion -Wpedantic -Werror -I"$source/include_c" "$folder/program.c" "$library" \
  -Wl,-rpath,"$(dirname "$library")" -o "$folder/program"
"$source/tests/examples/check_output.py" "$folder/promised" "$folder/program"
