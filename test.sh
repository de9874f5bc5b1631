#!/usr/bin/env bash
# Everything there is to test: installs what is missing, builds with both compilers, runs all suites and sanitizers.
#   ./test.sh          all of it, under 15 minutes on two cores
#   ./test.sh quick    the release build and its tests only
set -euo pipefail
cd "$(dirname "$0")"
. .ci/setup.sh
need_packages g++ gcc gfortran clang libclang-rt-14-dev cmake ninja-build libeigen3-dev libgtest-dev clang-format \
  clang-tidy doxygen binutils python3 python3-numpy python3-matplotlib libbenchmark-dev valgrind

total_passed=0 total_failed=0 total_skipped=0
# Runs a preset's tests and adds up what ctest counts.
suite() {
  local preset=$1 log
  log=build/$preset/ctest.log
  echo "== $preset: build"
  cmake --preset "$preset" >"build/$preset.log" 2>&1 || { cat "build/$preset.log"; return 1; }
  cmake --build --preset "$preset" >>"build/$preset.log" 2>&1 || { cat "build/$preset.log"; return 1; }
  echo "== $preset: tests"
  ctest --preset "$preset" -j 2 >"$log" 2>&1 || true
  grep -vE '^(Test project|    Start|Total Test time)' "$log" || true
  total_passed=$((total_passed + $(grep -cE '  Passed  ' "$log" || true)))
  total_failed=$((total_failed + $(grep -cE '\*\*\*(Failed|Timeout|Exception|Not Run)' "$log" || true)))
  total_skipped=$((total_skipped + $(grep -cE '\*\*\*Skipped' "$log" || true)))
}

# Status 77: could not be checked here.
check() {
  echo "== $1"
  local status=0
  "${@:2}" || status=$?
  case $status in
    0) total_passed=$((total_passed + 1)) ;;
    77) total_skipped=$((total_skipped + 1)) ;;
    *) total_failed=$((total_failed + 1)) ;;
  esac
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
suite release
if [ "${1:-}" != quick ]; then
  suite clang
  suite sanitize
  suite tsan  # threads that share a model
  check "golden hashes of other builds" golden
  check "instruction counts" tests/bench/instruction_gate.py build/release/tests/bench/gate_cases
  check "clang-format" formatted
  check "clang-tidy" tidy
  check "manual" documented
  check "main job" ./run.sh
fi
echo "$total_passed passed, $total_failed failed, $total_skipped skipped"
[ "$total_failed" -eq 0 ]
