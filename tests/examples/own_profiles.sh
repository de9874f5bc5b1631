#!/usr/bin/env bash
# own_case reads a profile in each form that run.sh promises, with the same results, and says what is wrong with others.
#   own_profiles.sh source_directory own_case
set -euo pipefail
source=$1 own_case=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
grep -v '^#' "$source/tests/data/profiles/uic60_benchmark.txt" | awk '{ print $1, $2 }' >blanks
{ printf '\xef\xbb\xbfy [mm],z [mm]\r\n'; sed 's/ /,/; s/$/\r/' blanks; } >commas
{ echo 'y;z'; sed 's/ /;/; s/\./,/g' blanks; } >decimal
sed 's/\./,/g; s/ /\t/; s/$/  # behind, a comment/' blanks >tabs
awk '{ printf "%.9f, %.9f\n", 1e-3 * $1, 1e-3 * $2 }' blanks >metres
"$own_case" --rail blanks >expected
for form in commas decimal tabs; do "$own_case" --rail $form 2>&1 | diff expected - || { echo "WRONG: $form"; exit 1; }; done
"$own_case" --rail metres --unit m 2>&1 | diff expected - || { echo "WRONG: metres"; exit 1; }

# says SENTENCE OPTIONS...: fails, and says that.
says() {
  local said
  if said=$("$own_case" "${@:2}" 2>&1) || ! grep -q -- "$1" <<<"$said"; then echo "WRONG: ${*:2} says '$said'"; exit 1; fi
}
says "mm wide.*pass --unit m" --rail metres
awk '{ print 1e3 * $1, 1e3 * $2 }' blanks >micrometres
says "in which unit" --rail micrometres
tac blanks >reversed
says "reverse their order" --rail reversed
awk '{ print 0.0, $0 }' blanks >three
says "line 1: more than two numbers" --rail three
awk 'NR == 5 { print "x"; next } { print }' blanks >word
says "line 5: not a point" --rail word
says "cannot open profile file 'none'" --rail none
says "did you pass kN" --load 80
