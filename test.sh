#!/usr/bin/env bash
# The tests. Debian packages that are missing are named and installed, as in run.sh; not with WRC_NO_INSTALL=1.
#   ./test.sh quick    3 minutes on two idle cores. The library by gcc with its unit tests and tests of the interface but for long
#                      ones; golden hashes of every instruction set, two ways of calling; format, code written twice,
#                      references in comments, figures of the house, one definition a name.
#                      Leaves out: what the next ones add
#   ./test.sh          7 minutes. Besides: tests of a minute each; golden hashes of all ways of calling; the interface, but for long
#                      tests and kernels for AVX-512, under the address and undefined-behaviour sanitizers; proofs of real time,
#                      accuracy, examples, installed tree, instruction counts, growth of structs, manual, main job.
#                      Leaves out: clang's and mingw's builds, report programs, tests of generators and calibrations, the Python
#                      package, FMUs, hosts, packages, the library inside another project, headers under all compilers, symbols of
#                      unoptimised kernels, clang-tidy, hostile input and the fuzzer; under the sanitizers slow tests, unit tests,
#                      golden hashes and examples
#   ./test.sh ci       half an hour; what .ci/run runs. Besides: all of these but clang's build, of mingw's tests the interface,
#                      bits, examples, FMUs and package, under wine.
#                      Leaves out: what compiles the library again to compare its results
#   ./test.sh all      about an hour. Besides: all tests of the clang and mingw builds, thread sanitizer, four of the longest tests
#                      under sanitizers, golden hashes from every compiler and optimisation and on aarch64 under qemu, kernel
#                      symbols at every optimisation, run.sh's own build, static and fetched library, packages from two clones,
#                      a method, member, field, status added to a copy, every struct made larger in a copy
# Every check is a test of ctest: `ctest --test-dir build/release -L surface` runs what is about src/surface, and
# `--print-labels` names the labels. Before the last line stand what was left out and what each part took; the last line
# counts. The exit status is 0 if something passed and nothing failed.
set -euo pipefail
cd "$(dirname "$0")"
. .ci/setup.sh
. .ci/parts.sh
tier=${1:-default}
case $tier in
  default | quick | ci) ;;
  all) export WRC_TEST_ALL=1 ;; # kernel_symbols: more optimisations
  *) sed -n '2,24s/^# *//p' "$0"; exit 2 ;;
esac
need_packages g++ gcc cmake ninja-build libeigen3-dev libgtest-dev clang-format binutils python3 similarity-tester \
  python3-clang-14
[ "$tier" = quick ] || need_packages gfortran clang libclang-rt-14-dev clang-tidy doxygen pkg-config python3-numpy \
  python3-matplotlib libbenchmark-dev valgrind abigail-tools
case $tier in
  ci | all)
    need_packages python3-venv unzip octave octave-dev
    bindings/python/tests/environment.sh install
    tests/fmi/fmpy.sh install
    ;;
esac

# tree PRESET [-DNAME=VALUE...] OPTIONS... [-- TARGET...]: builds a preset, or these targets of it, and runs its tests, or those that
# ctest's options pick.
tree() {
  local preset=$1 settings=() options=() targets=()
  shift
  while [[ ${1:-} = -D* ]]; do settings+=("$1"); shift; done
  while [ $# -gt 0 ] && [ "$1" != -- ]; do options+=("$1"); shift; done
  [ $# -eq 0 ] || targets=(--target "${@:2}")
  if cmake --preset "$preset" "${settings[@]}" >"build/$preset.log" 2>&1 || { cat "build/$preset.log"; false; } &&
    compile "$preset" "build/$preset.log" cmake --build --preset "$preset" "${targets[@]}"; then
    run_ctest "build/$preset/ctest.log" --preset "$preset" -j 2 "${options[@]}"
  else
    failure "$preset does not build"
  fi
}

# Nothing else needs the cross compiler and wine.
mingw() {
  if ! (need_packages g++-mingw-w64-x86-64-posix wine wine64 googletest); then
    echo "mingw: skipped, the DLL cannot be built and run without these packages"
    skipped=$((skipped + 1))
  elif [ "$tier" = all ]; then
    tree mingw
  else
    tree mingw -E '^(hostile_input|fmi_mistakes|fmi_wheelset_motion|fmi_stop|fmi_traction|fmi_start)$' -- abi_tests golden_hash first_step exact_check load_at_run_time fmi_importer fmi_films wrc_fmu wine_folder
  fi
}

mkdir -p build
case $tier in
  quick)
    left="long tests, other ways of calling, tests of generators, sanitizers, proofs of real time, accuracy, examples, installed tree, instruction counts, manual, main job (./test.sh), \
and what that leaves out"
    part release tree release -L '^quick$' -- wrc unit_tests reference_tests abi_tests golden_hash
    ;;
  default)
    left="builds of clang and mingw, report programs, tests of generators and calibrations, unit tests under sanitizers, kernels for AVX-512 under sanitizers, Python package, FMUs, hosts, packages, embedding, headers under all compilers, symbols of unoptimised kernels, clang-tidy, hostile input, fuzzer \
(./test.sh ci), and what that leaves out"
    part release tree release -LE '^(long|rebuild)$'
    part sanitize tree sanitize -DWRC_AVX512=OFF -R '^abi_' -LE '^long$' -- abi_tests
    ;;
  ci)
    left="clang's build, most of mingw's tests, thread sanitizer, four of the longest tests under sanitizers, other compilers and processors, static and \
fetched library, packages from two clones, growth built on a copy (./test.sh all)"
    part release tree release -LE '^rebuild$' -- all tools/all long_tests
    part sanitize tree sanitize -DWRC_AVX512=ON -LE '^rebuild$' -- all long_tests
    part mingw mingw
    ;;
  all)
    left=nothing
    (need_packages g++-aarch64-linux-gnu qemu-user) || echo "without them the aarch64 build is skipped"
    part release tree release -- all tools/all long_tests
    part sanitize tree sanitize -DWRC_AVX512=ON -- all long_tests
    part clang tree clang -- all tools/all long_tests
    part tsan tree tsan # threads that share a model
    part mingw mingw
    ;;
esac
echo "./test.sh $tier leaves out: $left"
say_counts
