#!/usr/bin/env bash
# The shared library exports the functions of the public headers and nothing else, and needs only libc and libm.
#   exported_symbols.sh libwrc.so wrc.def
set -euo pipefail
library=$1 list=$2
declared=$(sed '1,/^EXPORTS/d' "$list" | tr -d ' ' | sort -u)
exported=$(nm -D --defined-only "$library" | awk '$2 != "A" {print $3}' | sed 's/@.*//' | sort -u)
if [ "$declared" != "$exported" ]; then
  echo "declared (<) and exported (>) differ:"
  diff <(echo "$declared") <(echo "$exported") || true
  exit 1
fi
needed=$(readelf -d "$library" | awk '/NEEDED/ {gsub(/[][]/, "", $5); print $5}')
for each in $needed; do
  case $each in
    libc.so.*|libm.so.*|ld-linux*) ;;
    *) echo "$library needs $each: only libc and libm are allowed"; exit 1 ;;
  esac
done
echo "$(echo "$exported" | wc -l) symbols, needs: $(echo $needed)"
