#!/usr/bin/env bash
# No module calls the C library's transcendental functions: glibc picks their code by instruction set, and the last bit
# of a result with it. src/base/elementary.hpp has what they need.
#   elementary_functions.sh object...      the library's object files
set -euo pipefail
functions='(a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|[lt]gamma|erfc?|fma|fmod|remainder|j[01n]|y[01n])[fl]?'
called=$(nm -A --undefined-only "$@" | awk '{ sub(/@.*/, "", $3); print $1, $3 }') # object, name
used=$(awk -v functions="^$functions\$" '$2 ~ functions { print $1, "calls", $2 }' <<<"$called" | sort -u)
exact=$(awk '$2 ~ /^(floor|ldexp|frexp)$/ { print $1 }' <<<"$called" | sort -u | wc -l) # exact, so they may be called
checked=$#
if [ "$checked" -lt 20 ] || [ "$exact" -lt 3 ] || ! grep -qxE "$functions" <<<atan2; then
  echo "$checked objects checked, $exact call exact functions of libm: the search does not see what it should"
  exit 1
fi
[ -z "$used" ] || { echo "$used"; exit 1; }
echo "$checked objects call none"
