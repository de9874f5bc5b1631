#!/usr/bin/env bash
# No module but the offline solver's calls the C library's transcendental functions: glibc picks their code by
# instruction set, and the last bit of a result with it. src/base/elementary.hpp has what the others need.
#   elementary_functions.sh object...      the library's object files, .../src/<module>/<file>.o
set -euo pipefail
functions='(a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|[lt]gamma|erfc?|fma|fmod|remainder|j[01n]|y[01n])[fl]?'
status=0 checked=0 offline=
for object in "$@"; do
  used=$(nm --undefined-only "$object" | awk '{print $2}' | sed 's/@.*//' | grep -xE "$functions" | sort -u || true)
  case $object in
    */src/halfspace/*) offline="$offline $used"; continue ;;
  esac
  checked=$((checked + 1))
  if [ -n "$used" ]; then
    echo "$object calls" $used
    status=1
  fi
done
if [ "$checked" -lt 20 ] || [ -z "${offline// /}" ]; then
  echo "$checked objects checked, offline solver uses '${offline}': the search does not see what it should"
  exit 1
fi
echo "$checked objects call none; the offline solver calls:" $(echo $offline | tr ' ' '\n' | sort -u)
exit $status
