#!/usr/bin/env bash
# The tests, under 15 minutes on two cores. Debian packages that are missing are named and installed, as in run.sh; not
# with WRC_NO_INSTALL=1.
#   ./test.sh          the release build with all its tests, the C interface under wine, the bits from clang and
#                      mingw-w64; address and undefined sanitizer; instruction counts; format, code written twice,
#                      clang-tidy over what changed lately, manual, main job
#   ./test.sh quick    the release build and its tests only
#   ./test.sh all      besides: all tests of the clang and mingw builds, thread sanitizer, the golden hashes from every
#                      compiler and optimisation and on aarch64 under qemu, kernel symbols at every optimisation,
#                      clang-tidy over everything, run.sh's own build, a method, member, field and status added to a copy, every
#                      struct made larger in a copy
# Before the last line stands what each part took; the last line counts. The exit status is 0 if something passed and
# nothing failed.
set -euo pipefail
cd "$(dirname "$0")"
. .ci/setup.sh
. .ci/counts.sh
case ${1:-} in
  "" | quick) ;;
  all) export WRC_TEST_ALL=1 ;;
  *) sed -n '2,14s/^# *//p' "$0"; exit 2 ;;
esac
all() { [ -n "${WRC_TEST_ALL:-}" ]; }
need_packages g++ gcc gfortran clang libclang-rt-14-dev cmake ninja-build libeigen3-dev libgtest-dev clang-format \
  clang-tidy doxygen binutils pkg-config python3 python3-numpy python3-matplotlib python3-venv libbenchmark-dev \
  valgrind similarity-tester python3-clang-14 abigail-tools unzip octave octave-dev

# suite PRESET [TESTS TARGET...]: builds a preset, or these targets of it, and runs its tests, or those that match TESTS.
suite() {
  local build=() tests=()
  [ $# -lt 2 ] || { tests=(-R "$2"); build=(--target "${@:3}"); }
  echo "== $1: build"
  if cmake --preset "$1" >"build/$1.log" 2>&1 && cmake --build --preset "$1" "${build[@]}" >>"build/$1.log" 2>&1; then
    echo "== $1: tests"
    count_ctest "build/$1/ctest.log" --preset "$1" -j 2 "${tests[@]}"
  else
    cat "build/$1.log"
    count_check "$1 does not build" false
  fi
}

# Another compiler: its warnings, tests and bits are those of the sanitized build, which it compiles too.
clang_suite() { if all; then suite clang; else count_check "clang, configured for clang-tidy" cmake --preset clang; fi; }

# Nothing else needs the cross compiler and wine.
mingw_suite() {
  if ! (need_packages g++-mingw-w64-x86-64-posix wine wine64 googletest); then
    count_check "mingw: skipped, the DLL cannot be built and run without these packages" sh -c 'exit 77'
  elif all; then
    suite mingw
  else
    suite mingw '^(abi.*|golden_hash|example_.*|dll_symbols|package_zip|fmi_importer)$' abi_tests golden_hash first_step exact_check load_at_run_time \
      fmi_importer wrc_fmu wine_folder
  fi
}

# The other processor's compiler and emulator are worth having, but nothing else needs them.
golden() {
  if all; then
    (need_packages g++-aarch64-linux-gnu qemu-user) || echo "without them the aarch64 build is skipped"
    tests/realtime/golden_everywhere.sh
  else
    tests/realtime/golden_everywhere.sh shortly
  fi
}

formatted() { git ls-files '*.cpp' '*.hpp' '*.c' | grep -v wrc_status.h | xargs clang-format --dry-run --Werror; }

# Sources of the library: all, or those that the last commits touched or that are not committed.
sources() {
  if all || ! git rev-parse -q --verify HEAD~3 >/dev/null; then
    git ls-files 'src/*.cpp'
  else
    git diff --name-only --diff-filter=d HEAD~3 -- 'src/*.cpp'
  fi
}
tidy() { sources | xargs -r -P 2 -n 2 clang-tidy --quiet -p build/clang 2>/dev/null; }
documented() { tools/site/site.py; }
main_job() { if all; then ./run.sh; else WRC_BUILD=build/release ./run.sh; fi; }

mkdir -p build
bindings/python/tests/environment.sh install
tests/fmi/fmpy.sh install
# What keeps one processor busy, and takes no times.
single_parts() {
  part counts count_check "instruction counts" tests/bench/instruction_gate.py build/release/tests/bench/gate_cases
  part format count_check "clang-format" formatted
  part duplicates count_check "code written twice" tests/duplicates.sh
  part tidy count_check "clang-tidy" tidy
  part manual count_check "manual" documented
  part run count_check "main job" main_job
}

part release suite release
if [ "${1:-}" != quick ]; then
  part clang clang_suite
  part sanitize suite sanitize
  ! all || part tsan suite tsan # threads that share a model
  beside build/single_parts.log single_parts # mingw's tests leave a processor idle
  part mingw mingw_suite
  gather
  part golden count_check "golden hashes of other builds" golden
  ! all || part growth count_check "what a new thing costs" tests/growth/growth.sh build
  ! all || part structs count_check "every struct can grow" tests/growth/growth.sh structs build/release/libwrc.so build
fi
say_counts
