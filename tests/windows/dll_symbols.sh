#!/usr/bin/env bash
# The DLL exports the functions of its .def file, which is made of the headers, and nothing else, it bears its version in the
# name that import libraries ask for, it needs no DLL but those of every Windows, and no vector move in it asks for more
# alignment than the stack has.
#   dll_symbols.sh objdump wrc-0.9.dll wrc.def
set -euo pipefail
export LC_ALL=C
objdump=$1 library=$2 def=$3
exported=$("$objdump" -p "$library" | awk '/Ordinal\/Name Pointer/ {on = 1; next} on && /^\t\[/ {print $NF} on && !/^\t\[/ {on = 0}' | sort)
defined=$(awk '/^ / {print $1}' "$def" | sort)
if [ "$exported" != "$defined" ]; then
  echo "exported (<) and in $def (>) differ:"
  diff <(echo "$exported") <(echo "$defined") || true
  exit 1
fi
named=$("$objdump" -p "$library" | awk '/^Name[ \t]/ {name = $NF} END {print name}')
[ "$named" = "$(basename "$library")" ] && grep -qF "LIBRARY \"$named\"" "$def" ||
  { echo "$library calls itself '$named'; $def: $(grep LIBRARY "$def")"; exit 1; }
needed=$("$objdump" -p "$library" | awk '/DLL Name:/ {print $3}')
for each in $needed; do
  case $each in
    KERNEL32.dll|msvcrt.dll) ;;
    *) echo "$library needs $each: only KERNEL32 and msvcrt are allowed"; exit 1 ;;
  esac
done
[ -n "$needed" ] || { echo "no imports found: the search does not see what it should"; exit 1; }
aligned=$("$objdump" -d --no-show-raw-insn "$library" | grep -E 'vmov(ap|dqa|nt)[a-z0-9]* .*%[yz]mm' | grep -c '(' || true)
[ "$aligned" -eq 0 ] || { echo "$aligned moves of 32 or 64 bytes ask for alignment"; exit 1; }
echo "$(echo "$exported" | wc -l) symbols, needs: $(echo $needed)"
