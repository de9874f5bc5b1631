#!/usr/bin/env bash
# The library as one source file (tools/amalgamate), from other compilers and for other systems: it compiles, and has the golden bits.
#   amalgamate.sh BUILD one        gcc -O2, golden bits
#   amalgamate.sh BUILD all        clang and gcc with flags that would move bits; by zig's clang (PyPI) for macOS, Windows and
#                                  32-bit ARM Linux; bits where qemu-user or wine runs them, objects elsewhere
# Files lie in BUILD/amalgamated. Status 77: nothing was wrong, but a compiler or an emulator is missing.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
out=$1/amalgamated
mode=${2:-one}
failed=0 missing=0
mkdir -p "$out"
"$root/tools/amalgamate/amalgamate.py" "$out"
cd "$root"

# build NAME COMPILER... -- [PROGRAM THAT RUNS IT...]: the object alone where nothing runs it, else its golden hashes.
build() {
  local name=$1 compiler=() file objects=()
  shift
  while [ "$1" != -- ]; do compiler+=("$1"); shift; done
  shift
  if ! "${compiler[@]}" -std=c++17 -O2 -c "$out/wrc.cpp" -o "$out/$name.o" >"$out/$name.log" 2>&1; then
    echo "$name: does not compile"
    head -20 "$out/$name.log"
    failed=$((failed + 1))
    return
  fi
  if [ $# = 0 ]; then
    echo "$name: compiles; nothing here runs it"
    return
  fi
  if [ "$1" != native ] && ! command -v "$1" >/dev/null; then
    echo "$name: compiles; skipped, there is no $1"
    missing=$((missing + 1))
    return
  fi
  for file in tests/realtime/golden/*.cpp; do
    objects+=("$out/$name-$(basename "$file").o")
    "${compiler[@]}" -std=c++20 -O1 -ffp-contract=off -DWRC_STATIC -Iinclude_c -Itests -Itests/realtime \
      "-DWRC_FORCE_TABLE=\"$root/data/force_table.bin\"" -c "$file" -o "${objects[-1]}"
  done
  "${compiler[@]}" "${objects[@]}" "$out/$name.o" -pthread -o "$out/$name.exe"
  [ "$1" != native ] || shift
  if "$@" "$out/$name.exe" check tests/realtime/golden_hashes.txt once >"$out/$name.txt"; then
    echo "$name: same bits"
  else
    echo "$name: DIFFERENT"
    cat "$out/$name.txt"
    failed=$((failed + 1))
  fi
}

build gcc g++ -- native
if [ "$mode" = all ]; then
  if command -v clang++ >/dev/null; then
    build clang clang++ -- native
  else
    missing=$((missing + 1))
  fi
  # Fused products and vectors wherever the compiler likes.
  if grep -q fma /proc/cpuinfo 2>/dev/null; then
    build gcc_fused g++ -march=native -ffp-contract=fast -- native
    ! command -v clang++ >/dev/null || build clang_fused clang++ -march=native -ffp-contract=on -- native
  fi
  # Other systems. zig is a clang with the libraries of all of them.
  zig=$root/build/venv/bin/python
  [ -x "$zig" ] || python3 -m venv "$root/build/venv"
  if "$zig" -m ziglang version >/dev/null 2>&1 ||
    { [ "${WRC_NO_INSTALL:-0}" != 1 ] && "$zig" -m pip install -q --disable-pip-version-check ziglang; }; then
    export ZIG_GLOBAL_CACHE_DIR=$out/zig ZIG_LOCAL_CACHE_DIR=$out/zig WINEDEBUG=-all WINEPREFIX=$out/wine
    for target in aarch64-macos x86_64-macos aarch64-windows-gnu; do
      build "$target" "$zig" -m ziglang c++ -target "$target" --
    done
    build x86_64-windows-gnu "$zig" -m ziglang c++ -target x86_64-windows-gnu -- wine
    build arm-linux "$zig" -m ziglang c++ -target arm-linux-musleabihf -static -- qemu-arm
    build aarch64-linux "$zig" -m ziglang c++ -target aarch64-linux-musl -static -- qemu-aarch64
  else
    echo "skipped: ziglang cannot be installed from PyPI"
    missing=$((missing + 1))
  fi
fi
[ "$failed" = 0 ] || exit 1
[ "$missing" = 0 ] || exit 77
