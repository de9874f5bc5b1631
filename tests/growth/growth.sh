#!/usr/bin/env bash
# What a new thing costs: each patch here adds one to the tree, and may touch so many files written by hand, its own new
# ones and its test counted, generated ones not.
#   growth.sh check [NAME...]    the patches apply, and their counts
#   growth.sh build [NAME...]    besides, each on a copy of the tree: generates, builds the library, runs the test
# And whether every struct can grow, in both directions: more is put into each of them on a copy of the tree (grow.py).
#   growth.sh structs LIBRARY          callers compiled before and after have the same bits from LIBRARY, which refuses each new
#                                      member that is set
#   growth.sh structs LIBRARY build    besides with the library built from the copy, which knows the new members
# Needs git; `build` and `structs` python3-clang-14 besides. Status 77 without.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
what=${1:-check}
shift || true
# name, most files, target of its test, which tests
patches='
tangential_method  5  unit_tests  ShenHedrickElkins.*
struct_member      3  abi_tests   WearFactor.*
field              4  abi_tests   Utilisation.*
status             1  abi_tests   Statuses.*
'
command -v git >/dev/null || { echo "skipped: no git"; exit 77; }
[ "$what" = check ] || python3 -c 'import sys; sys.path.append("/usr/lib/python3/dist-packages"); import clang.cindex' 2>/dev/null ||
  { echo "skipped: no libclang for Python"; exit 77; }

# Every file of a tree with its checksum.
sums() { (cd "$1" && find . -type f -not -path './build/*' -print0 | sort -z | xargs -0 sha256sum); }
differing() { diff "$1" "$2" | sed -nE 's/^[<>] [0-9a-f]+ +//p' | sort -u; }

# count NAME MOST FILES
count() {
  echo "$1: $3 files by hand, $2 at most"
  [ "$3" -ge 1 ] && [ "$3" -le "$2" ]
}

# make COPY TARGET OPTION...: with the compiler cache where there is one; what the copies share is then compiled once.
make() {
  local launcher=
  ! command -v ccache >/dev/null || launcher=-DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  (cd "$1" && export CCACHE_BASEDIR=$1 && cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DWRC_FORTRAN=OFF $launcher "${@:3}" &&
    cmake --build build -j 2 --target "$2") >"$scratch/log" 2>&1 || { cat "$scratch/log"; return 1; }
}

# built NAME MOST TARGET TESTS: the patch on a copy.
built() {
  local copy=$scratch/$1 test
  mkdir "$copy"
  (cd "$root" && git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$copy")
  sums "$copy" >"$scratch/before"
  (cd "$copy" && git apply --whitespace=nowarn "$here/$1.patch") || return 1
  sums "$copy" >"$scratch/patched"
  python3 "$copy/tools/interface/describe.py" >"$scratch/log" || { cat "$scratch/log"; return 1; }
  sums "$copy" >"$scratch/generated"
  differing "$scratch/before" "$scratch/patched" >"$scratch/by_hand"
  differing "$scratch/patched" "$scratch/generated" >"$scratch/by_generator"
  if comm -12 "$scratch/by_hand" "$scratch/by_generator" | grep .; then
    echo "$1: these are generated and patched too"
    return 1
  fi
  echo "$1: $(wc -l <"$scratch/by_generator") files generated"
  count "$1" "$2" "$(wc -l <"$scratch/by_hand")" || { cat "$scratch/by_hand"; return 1; }
  # Its own test alone: files without one of these names are left out.
  for test in "$copy/tests/${3%_tests}"/*_test.cpp; do
    grep -q "(${4%%.*}," "$test" || rm "$test"
  done
  make "$copy" "$3" -DWRC_EXAMPLES=ON || return 1
  "$copy/build/tests/$3" --gtest_filter="$4" >"$scratch/log" 2>&1 || { cat "$scratch/log"; return 1; }
  grep '^\[  PASSED  \]' "$scratch/log"
  ! grep -q 'PASSED  \] 0 tests' "$scratch/log"
  rm -rf "$copy"
}

# numbers CALLER LIBRARY: what a caller prints with a library, kept as CALLER.LIBRARY
numbers() {
  (cd "$scratch" && LD_LIBRARY_PATH=$scratch/$2 "./$1") >"$scratch/$1.$2" || { echo "WRONG: the caller $1 ends with $? on the library $2"; return 1; }
  diff "$scratch/then.today" "$scratch/$1.$2" || { echo "WRONG: the caller $1 has other numbers (>) from the library $2"; return 1; }
  echo "caller $1, library $2: $(wc -l <"$scratch/$1.$2") lines, the same"
}

# structs LIBRARY [build]: callers compiled then and now, libraries of today and later.
structs() {
  local library copy=$scratch/copy wrong=0
  library=$(readlink -f "$1")
  mkdir "$copy" "$scratch/today"
  cp "$library" "$scratch/today/$(objdump -p "$library" | awk '/SONAME/ {print $2}')"
  (cd "$root" && git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$copy")
  "$here/grow.py" headers "$copy" || return 1
  mkdir -p "$scratch/full/src/abi" # a struct without room is seen
  cp -r "$root/include_c" "$root/tools" "$scratch/full"
  sed -i '/^typedef struct wrc_planar_pose {/,/^}/ {/ reserved\[/d}' "$scratch/full/include_c/wrc/wrc_planar.h"
  ! "$here/grow.py" headers "$scratch/full" >"$scratch/log" || { echo "WRONG: a struct that cannot grow passes"; wrong=1; }
  grep -q 'wrc_planar_pose: CANNOT GROW' "$scratch/log" || { cat "$scratch/log"; wrong=1; }
  python3 "$copy/tools/interface/describe.py" >"$scratch/log" || { cat "$scratch/log"; return 1; }
  "$here/grow.py" probes "$root/include_c" "$copy/include_c" >"$scratch/probes.h" || return 1
  local caller=$root/tests/abi/gate/caller.c function
  for function in $(sed '1,/^EXPORTS/d' "$root/src/abi/generated/wrc.def"); do
    grep -qwE "$function|${function%_init}_default" "$caller" || { echo "WRONG: the caller never calls $function"; wrong=1; }
  done
  cc -std=c99 -I"$root/include_c" "$caller" "$library" -o "$scratch/then"
  cc -std=c99 -I"$copy/include_c" "$caller" "$library" -o "$scratch/now"
  cc -std=gnu99 -include "$scratch/probes.h" -I"$copy/include_c" "$caller" "$library" -o "$scratch/probing"
  (cd "$scratch" && LD_LIBRARY_PATH=$scratch/today ./then) >"$scratch/then.today" || return 1
  numbers now today || wrong=1
  numbers probing today || wrong=1
  if [ "${2:-}" = build ]; then
    make "$copy" wrc -DWRC_TESTS=OFF -DWRC_EXAMPLES=OFF -DWRC_FMI=OFF -DWRC_WERROR=OFF || return 1
    mkdir "$scratch/later"
    cp "$copy"/build/libwrc.so.* "$scratch/later"
    numbers then later || wrong=1
    numbers now later || wrong=1
    numbers probing later || wrong=1
  fi
  return $wrong
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [ "$what" = structs ]; then
  structs "$@"
  exit
fi
wrong=0
while read -r name most target tests; do
  [ -n "$name" ] || continue
  [ $# -eq 0 ] || [[ " $* " == *" $name "* ]] || continue
  if ! (cd "$root" && git apply --check --whitespace=nowarn "$here/$name.patch"); then
    echo "$name: does not apply"
    wrong=1
  elif [ "$what" = build ]; then
    built "$name" "$most" "$target" "$tests" || wrong=1
  else
    count "$name" "$most" "$(grep -c '^diff --git' "$here/$name.patch")" || wrong=1
  fi
done <<<"$patches"
exit $wrong
