#!/usr/bin/env bash
# No name of src stands for two things: in one source file of the whole library (tools/amalgamate) the compiler refuses a second
# definition. Names in unnamed namespaces may stand in several files; that file renames them.
#   one_definition.sh COMPILER [FOLDER_OF_SOURCES]
set -euo pipefail
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$(dirname "$0")/../../tools/amalgamate/amalgamate.py" "$out" "${@:2}"
"$1" -std=c++17 -w -fsyntax-only "$out/wrc.cpp"
