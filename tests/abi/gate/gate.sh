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
      # Experimental functions of then may be gone: the host calls them only where the library has their version.
      comm -23 <(grep -oE '\bwrc_\w+@PLT' "$here/caller_x86_64.s" | sed 's/@PLT//' | sort -u) \
        <(nm -D --defined-only "$library" | awk '{print $3}' | sed 's/@.*//' | sort -u) |
        sed 's/.*/void &(void) {}/' >"$scratch/gone.c"
      cc "$here/caller_x86_64.s" "$scratch/gone.c" "${run[@]}" -o "$scratch/then"
      cc -std=c99 -I"$include" "$here/caller.c" "${run[@]}" -o "$scratch/now"
      (cd "$scratch" && ./then) >"$scratch/then.txt" || { echo "the host of then ends with $?; $renew"; exit 1; }
      (cd "$scratch" && ./now) >"$scratch/now.txt"
      then=$(sed -n 's|^#if WRC_EXPERIMENTAL_VERSION == ||p' "$here/baseline.h")
      if ! grep -q "^#define WRC_EXPERIMENTAL_VERSION $then\$" "$include/wrc/wrc.h"; then
        echo "experimental interface $then is no longer there: held is the other"
        sed -i "$(wc -l <"$scratch/then.txt")q" "$scratch/now.txt"
      fi
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
    mkdir -p "$scratch/tools/interface" # beside the changed copies: the parser reads it
    cp "$root/tools/interface/members.toml" "$scratch/tools/interface"
    [ -z "$opinion" ] || stub "$include" today
    wrong=0
    # try VERDICT FILES SED WHAT [unseen]: passes or refused; unseen: by libabigail, as choices are int32_t in the interface
    try() {
      rm -rf "$scratch/changed"
      cp -r "$include" "$scratch/changed"
      (cd "$scratch/changed/wrc" && sed -i "$3" $2)
      ! diff -rq "$include" "$scratch/changed" >/dev/null || { echo "WRONG: no change: $4"; wrong=1; return; }
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
    # in_struct NAME SED: within that struct alone
    in_struct() { echo "/^typedef struct $1 {/,/^} $1;/ { $2 }"; }
    layout cc "$include" || { echo "today's headers are refused: see abi_gate"; exit 1; }
    more='double more; /**< more [N] */'
    raised='s|\(define WRC_EXPERIMENTAL_VERSION\) .*|\1 1000|'
    try passes wrc.h "s|^} wrc_wheel_input;|$more\n&|" "a member at the end of a struct that begins with its size"
    try passes wrc.h "s|^} wrc_rail_section;|$more\n&|" "a member at the end of a struct whose size another one has"
    try passes wrc.h "$(in_struct wrc_material "s|double reserved\[5\];|$more double reserved[4];|")" "a member in place of one of the numbers kept for later"
    try passes wrc.h "$(in_struct wrc_view "s|double reserved\[2\];|double more[2];|")" "a member in place of all of them"
    try passes wrc_planar.h "$(in_struct wrc_planar_load "s|uint32_t reserved0;|uint32_t more;|")" "a member in place of a whole number kept for later"
    try passes wrc_damage.h "$(in_struct wrc_stress_peaks "s|peak reserved;|peak more;|")" "a member in place of a struct kept for later"
    try passes wrc.h 's|^WRC_API uint32_t wrc_abi_version|WRC_API int32_t wrc_new(double x);\n&|' "a new function"
    try passes wrc_api.h 's|^};|  int32_t (*more)(double);\n&|' "a new function at the end of the table"
    try passes wrc.h 's|^  WRC_SIDE_LEFT = 1 |  WRC_SIDE_LEFT = 1, WRC_SIDE_NEW = 2 |' "a new enumerator"
    try passes wrc.h 's|^#define WRC_WRENCH_INPUTS .*|#define WRC_WRENCH_INPUTS 31|' "more columns in use"
    try passes "wrc.h wrc_damage.h" "$raised; s|^  double largest_traction;|  $more\n&|" "another experimental struct, and the number of that interface raised"
    try refused wrc_damage.h "s|^  double largest_traction;|  $more\n&|" "the same, and not raised"
    try refused wrc.h "$raised; s|^  double vertical_load;|  $more\n&|" "a member between others, and the number of the other interface raised"
    try refused wrc.h "s|^} wrc_creepage;|$more\n&|" "a member at the end of a struct that does not grow there"
    try refused wrc.h "$(in_struct wrc_creepage "s|double reserved\[4\];|double reserved[3];|")" "a struct that has shrunk"
    try refused wrc.h "$(in_struct wrc_material "s|^  double poisson;|  double more; double poisson;|; s|double reserved\[5\];|double reserved[4];|")" "a member between others, and a number kept for later less"
    try refused wrc.h "$(in_struct wrc_wrench "/steepest_angle/ d;")" "a member less at the end of a struct that begins with its size"
    try refused wrc.h 's|^  int32_t strips;  |  uint32_t strips; |' "another type of the same size"
    try refused wrc.h 's|^  WRC_SIDE_LEFT = 1 |  WRC_SIDE_LEFT = 2 |' "another value of an enumerator" unseen
    try refused wrc_offline.h 's|(double fraction, void\* user);|(double fraction, int32_t step, void* user);|' "another callback"
    try refused wrc.h 's|wrc_contact_last_error(const wrc_contact\* contact, char\* buffer, uint64_t|wrc_contact_last_error(const wrc_contact* contact, char* buffer, uint32_t|' "another argument"
    try refused wrc_planar.h 's|^WRC_API int32_t wrc_planar_roll(wrc_contact\* contact, double distance);||' "a function less"
    try refused wrc_api.h '/(\*planar_roll)/ {h; d}; /^};/ {x; G}' "a table in another order"
    try refused wrc_experimental_api.h '/(\*flange_dimensions)/ {N; d}' "a table that has shrunk"
    [ -n "$opinion" ] || echo "libabigail not asked: Debian's abigail-tools or python3-clang-14 is not there"
    exit $wrong
    ;;
  *) sed -n '2,9s/^# *//p' "$0"; exit 2 ;;
esac
