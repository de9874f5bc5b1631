#!/usr/bin/env bash
# wheel_wear.c on a short journey: a run that ended half way and is gone on with, by another number of processes, leaves the
# same bytes as one in one go; the wheel is worn, no curve is left out, and the depth of a step is kept.
#   wheel_wear.sh PROGRAM FOLDER
set -euo pipefail
program=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder/whole" "$folder/resumed"
"$program" "$folder/whole" 20000 28 1 >/dev/null
"$program" "$folder/resumed" 10000 28 2 >/dev/null
said=$("$program" "$folder/resumed" 20000 28 2)
[[ $said == "going on from 10000 km"* ]] || { echo "did not go on: $said"; exit 1; }
diff -r "$folder/whole" "$folder/resumed"
awk -F, 'NR == 2 { height = $3 }
         NR > 2 { if ($7 != 0 || $2 <= 0 || $2 > 0.2001 || $3 <= height) bad = 1; height = $3; steps++ }
         END { if (bad || steps < 2 || $1 != 20000) { print "worn in " steps " steps to " $1 " km, flange " $3 " mm: not as expected"; exit 1 }
               print steps " steps, flange " height " mm" }' "$folder/whole/wheel_wear.csv"
