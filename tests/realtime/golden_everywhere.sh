#!/usr/bin/env bash
# The golden hashes from builds with other compilers, other optimisation and for another processor.
#   golden_everywhere.sh           all of them: gcc and clang, -O0 to -O3, -march=native, aarch64 under qemu
#   golden_everywhere.sh print     all of them, hashes per group beside each other where they differ
# Builds lie in build/golden. Exit status 77: nothing was wrong, but a build is missing its compiler or emulator.
set -euo pipefail
cd "$(dirname "$0")/../.."
expected=tests/realtime/golden_hashes.txt
mode=${1:-all}
passed=0 failed=0 missing=0
mkdir -p build/golden

# compare NAME PROGRAM...: what `golden_hash check` says, called as PROGRAM...
compare() {
  local name=$1
  if "${@:2}" check "$expected" once >"build/golden/$name.txt"; then
    echo "$name: same bits"
    passed=$((passed + 1))
  else
    echo "$name: DIFFERENT"
    cat "build/golden/$name.txt"
    failed=$((failed + 1))
  fi
  [ "$mode" != print ] || "${@:2}" print | diff - "$expected" | grep '^[<>] [a-z]' || true
}

# flavour NAME CXX FLAGS [program that runs it]: builds the library and golden_hash, compares.
flavour() {
  local name=$1 compiler=$2 flags=$3 emulator=${4:-} folder=build/golden/$1
  local tool c_compiler=${compiler%g++}gcc
  case $compiler in *clang++) c_compiler=${compiler%++} ;; esac
  for tool in "$compiler" ${emulator%% *}; do
    command -v "$tool" >/dev/null && continue
    echo "$name: skipped, there is no $tool"
    missing=$((missing + 1))
    return 0
  done
  mkdir -p "$folder"
  local system=()
  # Cross compilation: CMake must not run what it builds, and must not take this machine's libraries for the other's.
  [ -z "$emulator" ] || system=(-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64)
  if ! { cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$compiler" \
           -DCMAKE_C_COMPILER="$c_compiler" \
           -DCMAKE_CXX_FLAGS="$flags" -DWRC_TESTS=OFF -DWRC_FORTRAN=OFF -DWRC_WERROR=OFF "${system[@]}" &&
         cmake --build "$folder" --target wrc &&
         "$compiler" -std=c++20 -O1 -ffp-contract=off -Iinclude_c -Itests -Itests/realtime \
           -DWRC_FORCE_TABLE="\"$PWD/data/force_table.bin\"" tests/realtime/golden/*.cpp \
           -L"$folder" -lwrc -pthread -Wl,-rpath,"$PWD/$folder" -o "$folder/golden_hash"; } >"$folder.log" 2>&1; then
    cat "$folder.log"
    failed=$((failed + 1))
    return 0
  fi
  compare "$name" $emulator "$folder/golden_hash"
}

for optimisation in -O0 -O1 -O2 -O3; do
  flavour "gcc$optimisation" g++ "$optimisation"
  flavour "clang$optimisation" clang++ "$optimisation"
done
flavour clang-native clang++ "-O3 -march=native"
flavour gcc-native g++ "-O2 -march=native"
flavour aarch64 aarch64-linux-gnu-g++ -O2 "qemu-aarch64 -L /usr/aarch64-linux-gnu"
echo "golden hashes: $passed builds passed, $failed failed, $missing skipped"
[ "$failed" -eq 0 ] || exit 1
[ "$missing" -eq 0 ] || exit 77
