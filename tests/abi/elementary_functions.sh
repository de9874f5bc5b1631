#!/usr/bin/env bash
# No module calls the C library's transcendental functions: glibc picks their code by instruction set, and the last bit
# of a result with it. src/base/elementary.hpp has what they need.
#   elementary_functions.sh object...      the library's object files
set -euo pipefail
functions='(a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|[lt]gamma|erfc?|fma|fmod|remainder|j[01n]|y[01n])[fl]?'
status=0 checked=0 exact=0
for object in "$@"; do
  called=$(nm --undefined-only "$object" | awk '{print $2}' | sed 's/@.*//')
  used=$(grep -xE "$functions" <<<"$called" | sort -u || true)
  ! grep -qxE 'floor|ldexp|frexp' <<<"$called" || exact=$((exact + 1)) # exact, so they may be called
  checked=$((checked + 1))
  if [ -n "$used" ]; then
    echo "$object calls" $used
    status=1
  fi
done
if [ "$checked" -lt 20 ] || [ "$exact" -lt 3 ] || ! grep -qxE "$functions" <<<atan2; then
  echo "$checked objects checked, $exact call exact functions of libm: the search does not see what it should"
  exit 1
fi
echo "$checked objects call none"
exit $status
