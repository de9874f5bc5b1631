#!/usr/bin/env bash
# test.sh cannot fail quietly, and neither it nor run.sh installs what it should not: the functions they source, on made cases.
#   scripts_test.sh source_directory
set -euo pipefail
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
wrong=0

# --- counts: a project with tests that pass, fail, are skipped and cannot start, by preset.
cat >CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.21)
project(counted NONE)
enable_testing()
add_test(NAME good COMMAND true)
add_test(NAME good_too COMMAND true)
add_test(NAME bad COMMAND false)
add_test(NAME skip COMMAND sh -c "exit 77")
set_tests_properties(skip PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME no_program COMMAND /there/is/none)
CMAKE
cmake -S . -B build >/dev/null

# counts EXPECTED_LINE EXPECTED_STATUS COMMAND...
counts() {
  local said status=0
  said=$(set -euo pipefail; . "$source/.ci/parts.sh"; "${@:3}" >log 2>&1; say_counts) || status=$?
  [ "$said:$status" = "$1:$2" ] || { echo "WRONG: ${*:3}: '$said', status $status"; cat log; wrong=1; }
}
tests() { run_ctest ctest.log --test-dir build "$@"; }
counts "2 passed, 0 failed, 0 skipped" 0 tests -R good
counts "2 passed, 0 failed, 1 skipped" 0 tests -R 'good|skip'
counts "2 passed, 2 failed, 1 skipped" 1 tests
counts "0 passed, 1 failed, 0 skipped" 1 tests -R no_program
counts "0 passed, 1 failed, 0 skipped" 1 tests -R matches_nothing
counts "0 passed, 1 failed, 1 skipped" 1 tests -R skip
counts "0 passed, 1 failed, 0 skipped" 1 run_ctest ctest.log --test-dir no_such_folder
counts "0 passed, 1 failed, 0 skipped" 1 run_ctest ctest.log --preset no_such_preset
counts "0 passed, 1 failed, 0 skipped" 1 failure "it does not build"
counts "0 passed, 0 failed, 0 skipped" 1 true

# --- builds: how far they are is said, once for each tenth; a failed one fails and prints its log.
said=$(. "$source/.ci/parts.sh"; compile library made.log sh -c 'for i in 1 2 3 4; do echo "[$i/4] compiles"; done')
[ "$(grep -c 'library: step . of 4 of the build, . s' <<<"$said")" -eq 4 ] && grep -q '4/4' made.log || { echo "WRONG: a build says '$said'"; wrong=1; }
if said=$(. "$source/.ci/parts.sh"; compile library made.log sh -c 'echo "the error"; exit 3'); then echo "WRONG: a failed build passes"; wrong=1; fi
grep -q "the error" <<<"$said" || { echo "WRONG: a failed build says '$said'"; wrong=1; }

# Every preset that is for tests refuses to run none.
python3 - "$source/CMakePresets.json" <<'PYTHON' || wrong=1
import json, sys
presets = json.load(open(sys.argv[1], encoding="ascii"))["testPresets"]
base = {preset["name"]: preset for preset in presets}
for preset in presets:
    own = preset.get("execution") or base.get(preset.get("inherits"), {}).get("execution", {})
    if own.get("noTestsAction") != "error":
        sys.exit(f"WRONG: test preset {preset['name']} may run nothing")
PYTHON

# --- packages: a Debian of which only g++ and cmake are there.
mkdir bin
cat >bin/dpkg-query <<'SH'
#!/bin/sh
for package; do :; done
case $package in g++ | cmake) echo 'install ok installed' ;; *) exit 1 ;; esac
SH
printf '#!/bin/sh\necho "$*" >>"%s/installed"\n' "$folder" >bin/apt-get
printf '#!/bin/sh\n[ "$1" = -n ] && shift\n"$@"\n' >bin/sudo
chmod +x bin/*
PATH=$folder/bin:$PATH
# packages EXPECTED_WORDS EXPECTED_INSTALLED SETTING PACKAGE...
packages() {
  local said
  : >installed
  said=$(env "$3" bash -c '. "$0/.ci/setup.sh"; need_packages "$@"; echo " went on"' "$source" "${@:4}" 2>&1)
  case $said in *"$1"*" went on") ;; *) echo "WRONG: packages ${*:3}: '$said'"; wrong=1 ;; esac
  [ "$(grep -o 'recommends .*' installed || true)" = "$2" ] || { echo "WRONG: packages ${*:3}: $(cat installed)"; wrong=1; }
}
packages "" "" WRC_NO_INSTALL=0 g++ cmake
packages ": clang doxygen" "recommends clang doxygen" WRC_NO_INSTALL=0 g++ clang cmake doxygen
packages ": clang doxygen" "" WRC_NO_INSTALL=1 g++ clang cmake doxygen

# --- what examples print: a digit's rounding passes, more does not, nor does a line too many or a failed program.
prints() { # EXPECTED_STATUS FILE'S_TEXT PRINTED_TEXT
  local status=0
  printf '%b' "$2" >expected.txt
  "$source/tests/examples/check_output.py" expected.txt printf '%b' "$3" >log 2>&1 || status=$?
  [ "$status" -eq "$1" ] || { echo "WRONG: '$2' against '$3': status $status"; cat log; wrong=1; }
}
prints 0 'Fx = -7463 N, 1.20e-3\n' 'Fx =  -7464 N, 1.21e-3\n'
prints 1 'Fx = -7463 N\n' 'Fx = -7465 N\n'
prints 1 'Fx = -7463 N\n' 'Fx = 7463 N\n'
prints 1 'Fx = -7463 N\n' 'Fy = -7463 N\n'
prints 1 'Fx = -7463 N\n' 'Fx = nan N\n'
prints 1 'Fx = -7463 N\n' ''
prints 1 'Fx = -7463 N\n' 'Fx = -7463 N\nmore\n'
prints 0 '...\nspent * us\n' 'a\nb\nspent 3.5 us\n'
prints 1 '...\nspent * us\n' 'a\nb\n'
printf 'all is well\n' >expected.txt
if "$source/tests/examples/check_output.py" expected.txt sh -c 'echo all is well; exit 3' >/dev/null 2>&1; then
  echo "WRONG: a program that fails passes"
  wrong=1
fi
exit $wrong
