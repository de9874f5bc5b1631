#!/usr/bin/env bash
# clang-tidy, as .clang-tidy says, over sources of the library.
#   tidy.sh BUILD            those that the last three commits touched, or that are not committed; status 77: none, or no
#                            clang-tidy
#   tidy.sh BUILD FILE...    these;  tidy.sh BUILD all: all of src
set -euo pipefail
build=$1
cd "$(dirname "$0")/../.."
command -v clang-tidy >/dev/null || { echo "skipped: clang-tidy is not installed"; exit 77; }
case ${2:-} in
  "") mapfile -t files < <(git diff --name-only --diff-filter=d HEAD~3 -- 'src/*.cpp') ;;
  all) mapfile -t files < <(find src -name '*.cpp') ;;
  *) files=("${@:2}") ;;
esac
[ ${#files[@]} -gt 0 ] || { echo "skipped: the last commits touched no source of the library"; exit 77; }
# What it counts on its second output are warnings of others' headers, which it does not show.
printf '%s\n' "${files[@]}" | xargs -P 2 -n 2 clang-tidy --quiet -p "$build" 2>/dev/null
echo "${#files[@]} files"
