#!/usr/bin/env bash
# Everything there is to test: builds with both compilers, runs all suites and sanitizers. Debian packages that are
# missing are named and installed, as in run.sh; not with WRC_NO_INSTALL=1.
#   ./test.sh          all of it, under 15 minutes on two cores
#   ./test.sh quick    the release build and its tests only
# The last line counts; the exit status is 0 if something passed and nothing failed.
set -euo pipefail
cd "$(dirname "$0")"
. .ci/setup.sh
. .ci/counts.sh
need_packages g++ gcc gfortran clang libclang-rt-14-dev cmake ninja-build libeigen3-dev libgtest-dev clang-format \
  clang-tidy doxygen binutils pkg-config python3 python3-numpy python3-matplotlib python3-venv libbenchmark-dev \
  valgrind

# Builds a preset and runs its tests.
suite() {
  echo "== $1: build"
  if cmake --preset "$1" >"build/$1.log" 2>&1 && cmake --build --preset "$1" >>"build/$1.log" 2>&1; then
    echo "== $1: tests"
    count_ctest "build/$1/ctest.log" --preset "$1" -j 2
  else
    cat "build/$1.log"
    count_check "$1 does not build" false
  fi
}

formatted() { git ls-files '*.cpp' '*.hpp' '*.c' | grep -v wrc_status.h | xargs clang-format --dry-run --Werror; }
tidy() { git ls-files 'src/*.cpp' | xargs -P 2 -n 4 clang-tidy --quiet -p build/clang 2>/dev/null; }
documented() { doxygen docs/Doxyfile >build/doxygen.log 2>&1 && [ ! -s build/doxygen-warnings.log ] || { cat build/doxygen-warnings.log; false; }; }

# The other processor's compiler and emulator are worth having, but nothing else needs them.
golden() {
  (need_packages g++-aarch64-linux-gnu qemu-user) || echo "without them the aarch64 build is skipped"
  tests/realtime/golden_everywhere.sh shortly
}

mkdir -p build
tests/hosts/exudyn.sh install
suite release
if [ "${1:-}" != quick ]; then
  suite clang
  suite sanitize
  suite tsan  # threads that share a model
  # Nothing else needs the cross compiler and wine.
  if (need_packages g++-mingw-w64-x86-64-posix wine wine64 googletest); then
    suite mingw
  else
    count_check "mingw: skipped, wrc.dll cannot be built and run without these packages" sh -c 'exit 77'
  fi
  count_check "golden hashes of other builds" golden
  count_check "instruction counts" tests/bench/instruction_gate.py build/release/tests/bench/gate_cases
  count_check "clang-format" formatted
  count_check "clang-tidy" tidy
  count_check "manual" documented
  count_check "main job" ./run.sh
fi
say_counts
