#!/usr/bin/env bash
# The interface against the last agreed one, baseline.h: additions pass, changes fail. docs/abi.md.
#   gate.sh check INCLUDE libwrc.so    headers and library; the host compiled against the baseline's headers still has the
#                                      bits of one compiled today; the sentence of the last change is in CHANGELOG.md
#   gate.sh headers INCLUDE            the headers alone
#   gate.sh sees INCLUDE               the gate refuses what it should and passes what it should, on changed copies of the
#                                      headers; libabigail's opinion of the same, where Debian's abigail-tools is
# Status 77: skipped.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../../..
include=$(cd "$2" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

layout() { # COMPILER INCLUDE
  "$1" -std=gnu11 -Wall -Wextra -Werror -DWRC_LAYOUT_ONLY -DWRC_STATIC -fsyntax-only -I"$2" "$here/baseline.c"
}
renew='where it is meant: tools/interface/describe.py --renew-baseline "what changed"'

case $1 in
  headers) layout cc "$include" ;;
  check)
    library=$(readlink -f "$3")
    [ -z "$(command -v clang)" ] || layout clang "$include" || { echo "$renew"; exit 1; }
    for compiler in x86_64-w64-mingw32-gcc aarch64-linux-gnu-gcc; do
      if command -v "$compiler" >/dev/null; then layout "$compiler" "$include"; else echo "left out: $compiler"; fi
    done
    run=("-Wl,-rpath,$(dirname "$library")" "$library")
    cc -std=gnu11 -Wall -Wextra -Werror -I"$include" "$here/baseline.c" "${run[@]}" -o "$scratch/baseline" || { echo "$renew"; exit 1; }
    "$scratch/baseline" || { echo "$renew"; exit 1; }
    if [ "$(uname -m)" = x86_64 ]; then
      cc "$here/caller_x86_64.s" "${run[@]}" -o "$scratch/then"
      cc -std=c99 -I"$include" "$here/caller.c" "${run[@]}" -o "$scratch/now"
      "$scratch/then" >"$scratch/then.txt" || { echo "the host of then ends with $?; $renew"; exit 1; }
      "$scratch/now" >"$scratch/now.txt"
      diff "$scratch/then.txt" "$scratch/now.txt" || { echo "the host of then (<) has other numbers; $renew"; exit 1; }
      echo "the host of then: $(wc -l <"$scratch/then.txt") lines as of today"
    fi
    because=$(sed -n 's|^   BECAUSE: \(.*\) \*/$|\1|p' "$here/baseline.h")
    tr -s ' \n' '  ' <"$root/CHANGELOG.md" | grep -qF -- "$because" ||
      { echo "the baseline changed because '$because', and CHANGELOG.md does not say so"; exit 1; }
    ;;
  sees)
    opinion=
    ! { command -v abidiff && /usr/bin/python3 -c 'import clang.cindex'; } >/dev/null 2>&1 || opinion=yes
    stub() { # INCLUDE NAME: the interface as a library with debug information and nothing in it
      /usr/bin/python3 "$here/stub.py" "$1" >"$scratch/$2.c"
      gcc -std=gnu2x -g -shared -fPIC -w -I"$1" "$scratch/$2.c" -o "$scratch/$2.so"
    }
    [ -z "$opinion" ] || stub "$include" today
    wrong=0
    # try VERDICT FILE SED WHAT [unseen]: passes or refused; unseen: by libabigail, as choices are int32_t in the interface
    try() {
      rm -rf "$scratch/changed"
      cp -r "$include" "$scratch/changed"
      sed -i "$3" "$scratch/changed/wrc/$2"
      ! cmp -s "$include/wrc/$2" "$scratch/changed/wrc/$2" || { echo "WRONG: no change: $4"; wrong=1; return; }
      local verdict=passes said=
      layout cc "$scratch/changed" 2>"$scratch/said" || verdict=refused
      if [ -n "$opinion" ]; then
        stub "$scratch/changed" changed
        said=", libabigail: the same"
        abidiff --no-added-syms "$scratch/today.so" "$scratch/changed.so" >"$scratch/abidiff" 2>&1 || said=", libabigail: a change"
        [ "$verdict" = passes ] || [ "$said" = ", libabigail: a change" ] || [ "${5:-}" = unseen ] || { echo "WRONG: libabigail sees no change: $4"; wrong=1; }
      fi
      echo "$verdict$said: $4"
      [ "$verdict" = "$1" ] || { echo "WRONG: $1 is right"; cat "$scratch/said"; wrong=1; }
    }
    layout cc "$include" || { echo "today's headers are refused: see abi_gate"; exit 1; }
    try passes wrc_wheel.h 's|^} wrc_wheel_input;|  double more; /**< more [N] */\n&|' "a member at the end of a struct that grows"
    try passes wrc.h 's|^WRC_API uint32_t wrc_abi_version|WRC_API int32_t wrc_new(double x);\n&|' "a new function"
    try passes wrc.h 's|^  WRC_SIDE_LEFT = 1 |  WRC_SIDE_LEFT = 1, WRC_SIDE_NEW = 2 |' "a new enumerator"
    try refused wrc_wheel.h 's|^  double vertical_load;|  double more; /**< more [N] */\n&|' "a member between others"
    try refused wrc.h 's|^} wrc_creepage;|  double more; /**< more [N] */\n&|' "a member of a struct that does not grow"
    try refused wrc.h 's|^  int32_t strips;       /|  uint32_t strips;       /|' "another type of the same size"
    try refused wrc.h 's|^  WRC_SIDE_LEFT = 1 |  WRC_SIDE_LEFT = 2 |' "another value of an enumerator" unseen
    try refused wrc_offline.h 's|(double fraction, void\* user);|(double fraction, int32_t step, void* user);|' "another callback"
    try refused wrc.h 's|wrc_shakedown_limit(double utilisation|wrc_shakedown_limit(float utilisation|' "another argument"
    try refused wrc.h 's|^WRC_API int32_t wrc_shakedown_limit(double utilisation, double\* load_factor);||' "a function less"
    [ -n "$opinion" ] || echo "libabigail not asked: Debian's abigail-tools or python3-clang-14 is not there"
    exit $wrong
    ;;
  *) sed -n '2,9s/^# *//p' "$0"; exit 2 ;;
esac
