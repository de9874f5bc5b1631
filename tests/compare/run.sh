#!/usr/bin/env bash
# wrc_compare run --keep: a run that was ended goes on to the same result, and a file of another rail's run is refused.
#   run.sh wrc_compare track.csv
set -euo pipefail
compare=$1
track=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# without reasons of flagged places, which are printed only where a place is solved
run() { "$compare" run "$track" --y 0 --step 10 --list "$@" 2>"$folder/progress" | sed '/^     at /d'; }

run --case 4 >"$folder/whole"
run --case 4 --keep "$folder/kept" >"$folder/first"
cmp "$folder/whole" "$folder/first"
# the file as it is where the run was ended: the last piece is cut off, the others are not solved again
head -n -1 "$folder/kept" >"$folder/ended"
cp "$folder/ended" "$folder/continued"
run --case 4 --keep "$folder/continued" >"$folder/second"
cmp "$folder/whole" "$folder/second"
cmp "$folder/kept" "$folder/continued"

# forces of another rail
sed 's/^case 4, default=.*/case 4, default= 0 0 -1/' "$folder/kept" >"$folder/other"
status=0
run --case 4 --keep "$folder/other" >/dev/null || status=$?
[ "$status" -eq 1 ] && grep -q "another force than this rail, wheel and library" "$folder/progress" ||
  { echo "kept of another rail: status $status"; cat "$folder/progress"; exit 1; }
