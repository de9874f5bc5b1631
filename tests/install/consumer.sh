#!/usr/bin/env bash
# Builds and runs an example against the installed tree, the way one kind of user would.
#   consumer.sh build_directory source_directory tree|cmake|pkgconfig|plain|dlopen|fortran
# "tree" makes the tree first: installed to one place, then moved, so that nothing in it may name its own path.
set -euo pipefail
build=$1 source=$2 way=$3
prefix=$build/installed/moved
example=$source/examples_c/first_step.c
scratch=$build/installed/$way
# Nothing from outside, least of all the build directory, may help to find header or library.
unset LD_LIBRARY_PATH CPATH C_INCLUDE_PATH LIBRARY_PATH PKG_CONFIG_PATH CMAKE_PREFIX_PATH

need() { command -v "$1" >/dev/null || { echo "skipped: $1 is not installed"; exit 77; }; }
library_directory() { dirname "$(find "$prefix" -name libwrc.so)"; }
runs() { # the program says what it computed, and with the library of this tree
  local said
  said=$("$@")
  echo "$said"
  grep -q 'patch .* mm' <<<"$said" && grep -q 'forces .* N' <<<"$said"
}

rm -rf "$scratch"
mkdir -p "$scratch"
case $way in
  tree)
    rm -rf "$build/installed"
    cmake --install "$build" --prefix "$build/installed/first" >/dev/null
    mv "$build/installed/first" "$prefix"
    (cd "$prefix" && find . -type f -o -type l | sort)
    test -f "$prefix/include/wrc/wrc.h" && test -f "$prefix/include/wrc/wrc_status.h"
    test -L "$(library_directory)/libwrc.so" && test -L "$(library_directory)/libwrc.so.1"
    if grep -rlI -e "$build" -e "$source" "$prefix"; then echo "these files name a path of the build"; exit 1; fi
    ;;
  cmake)
    need cmake
    cmake -S "$source/tests/install" -B "$scratch" -DCMAKE_PREFIX_PATH="$prefix" -DFIRST_STEP="$example" >/dev/null
    cmake --build "$scratch" >/dev/null
    ldd "$scratch/first_step" | grep -F "$prefix"
    runs "$scratch/first_step"
    ;;
  pkgconfig)
    need pkg-config
    PKG_CONFIG_PATH=$(library_directory)/pkgconfig
    export PKG_CONFIG_PATH
    pkg-config --modversion wrc
    # shellcheck disable=SC2046 # the flags are words
    cc -std=c99 "$example" $(pkg-config --cflags --libs wrc) -o "$scratch/first_step"
    LD_LIBRARY_PATH=$(pkg-config --variable=libdir wrc) runs "$scratch/first_step"
    ;;
  plain)
    cc -std=c99 -I"$prefix/include" "$example" -L"$(library_directory)" -lwrc -o "$scratch/first_step"
    LD_LIBRARY_PATH=$(library_directory) runs "$scratch/first_step"
    ;;
  dlopen)
    cc -std=c99 -I"$prefix/include" "$source/examples_c/load_at_run_time.c" -ldl -o "$scratch/load_at_run_time"
    "$scratch/load_at_run_time" "$(library_directory)/libwrc.so.1"
    ;;
  fortran)
    need gfortran
    cd "$scratch"
    gfortran -c "$prefix/share/wrc/fortran/wrc.f90"
    gfortran "$source/bindings/fortran/main_case.f90" wrc.o -L"$(library_directory)" -lwrc -o main_case
    LD_LIBRARY_PATH=$(library_directory) ./main_case
    ;;
  *)
    echo "unknown way '$way'"
    exit 2
    ;;
esac
