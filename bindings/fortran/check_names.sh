#!/usr/bin/env bash
# Every function of the public headers has a bind(C) name in the Fortran module, and no other has.
#   check_names.sh include_directory fortran_directory
set -euo pipefail
declared=$(grep -hoE '^WRC_API .*' "$1"/wrc/*.h | grep -oE 'wrc_[a-z0-9_]+\(' | tr -d '(' | sort -u)
bound=$(grep -hoE "bind\(C, name='wrc_[a-z0-9_]+'\)" "$2"/wrc.f90 "$2"/wrc_interface.inc | grep -oE 'wrc_[a-z0-9_]+' | sort -u)
if [ "$declared" != "$bound" ]; then
  echo "declared in the headers (<) and bound in Fortran (>) differ: run make_interface.py"
  diff <(echo "$declared") <(echo "$bound")
  exit 1
fi
echo "$(echo "$bound" | wc -l) functions bound"
