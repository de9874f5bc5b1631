#!/usr/bin/env bash
# Is everything laid out as .clang-format says?     formatted.sh [ROOT]     status 77 without clang-format
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"
command -v clang-format >/dev/null || { echo "skipped: clang-format is not installed"; exit 77; }
mapfile -t files < <(find . \( -name build -o -name out -o -name .git \) -prune -o \( -name '*.cpp' -o -name '*.hpp' -o -name '*.c' \) -print)
[ ${#files[@]} -gt 0 ] || { echo "WRONG: no sources in $PWD"; exit 1; }
clang-format --dry-run --Werror "${files[@]}"
echo "${#files[@]} files"
