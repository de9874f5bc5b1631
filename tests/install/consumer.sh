#!/usr/bin/env bash
# Builds and runs an example the way one kind of user would.
#   consumer.sh build_directory source_directory WAY
#     tree                                     installs to one place and moves all to another: no file may name its own path
#     cmake pkgconfig plain cpp dlopen fortran against that tree
#     subdirectory                             the sources in a CMake project with settings that would harm the library
#     fetchcontent                             the sources by FetchContent, as static library
#     static                                   against a tree installed and moved by that project
set -euo pipefail
build=$1 source=$2 way=$3
prefix=$build/installed/moved
example=$source/examples_c/first_step.c
case $way in
  subdirectory | fetchcontent | static) scratch=$build/embedded/$way ;;
  *) scratch=$build/installed/$way ;;
esac
# Nothing from outside, least of all the build directory, may help to find header or library.
unset LD_LIBRARY_PATH CPATH C_INCLUDE_PATH LIBRARY_PATH PKG_CONFIG_PATH CMAKE_PREFIX_PATH

need() { command -v "$1" >/dev/null || { echo "skipped: $1 is not installed"; exit 77; }; }
library_directory() { dirname "$(find "$prefix" -name libwrc.so)"; }
runs() { # the program prints what first_step prints everywhere
  "$@" | tee "$scratch/printed"
  diff "$source/tests/examples/first_step.txt" "$scratch/printed"
}
consumer_project() { # WAY options: a CMake project that uses the library, built in $scratch/project
  cmake -S "$source/tests/install" -B "$scratch/project" -DWAY="$1" -DWRC_CHECKOUT="$source" -DFIRST_STEP="$example" \
    "${@:2}" >"$scratch/project.log" 2>&1 && cmake --build "$scratch/project" -j 2 >>"$scratch/project.log" 2>&1 ||
    { cat "$scratch/project.log"; return 1; }
}
names_no_path() { # of the trees they were made in
  if grep -rlI -e "$build" -e "$source" "$1"; then echo "these files name a path of the build"; return 1; fi
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
    test -L "$(library_directory)/libwrc.so" && test -L "$(library_directory)/libwrc.so.0.9"
    for file in LICENSE CHANGELOG.md README.md docs/third_party.md docs/embedding.md; do
      test -f "$prefix/share/doc/wrc/$file" || { echo "$file is missing"; exit 1; }
    done
    names_no_path "$prefix"
    if readelf -d "$(library_directory)/libwrc.so" | grep -E 'R(UN)?PATH'; then echo "the library has a path"; exit 1; fi
    ;;
  cmake)
    need cmake
    consumer_project installed -DCMAKE_PREFIX_PATH="$prefix"
    ldd "$scratch/project/first_step" | grep -F "$prefix"
    runs "$scratch/project/first_step"
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
    # A program of interface 0.2 asks for libwrc.so.0.2, which this library neither is nor stands for.
    mkdir -p "$scratch/old"
    echo 'unsigned wrc_version(void) { return 1; }' >"$scratch/old.c"
    cc -shared -fPIC -Wl,-soname,libwrc.so.0.2 "$scratch/old.c" -o "$scratch/old/libwrc.so.0.2"
    echo 'unsigned wrc_version(void); int main(void) { return wrc_version() == 0; }' >"$scratch/old_program.c"
    cc "$scratch/old_program.c" "$scratch/old/libwrc.so.0.2" -o "$scratch/old_program"
    LD_LIBRARY_PATH=$scratch/old "$scratch/old_program"
    if LD_LIBRARY_PATH=$(library_directory) "$scratch/old_program" 2>"$scratch/refusal"; then
      echo "a program linked with libwrc.so.0.2 runs"
      exit 1
    fi
    grep -F libwrc.so.0.2 "$scratch/refusal"
    ;;
  cpp)
    # The C++ header: both compilers, every standard, with exceptions and without; a warning is a failure.
    flags=(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -I"$prefix/include" -L"$(library_directory)")
    export LD_LIBRARY_PATH=$(library_directory)
    for compiler in g++ clang++; do
      command -v "$compiler" >/dev/null || { echo "left out: $compiler is not installed"; continue; }
      for standard in c++17 c++20 c++2b; do
        for exceptions in -fexceptions -fno-exceptions; do
          "$compiler" -std=$standard $exceptions "${flags[@]}" "$source/bindings/cpp/header_test.cpp" -lwrc -o "$scratch/header_test"
          "$scratch/header_test" | sed "s/^/$compiler: /" # with pipefail
        done
      done
      "$compiler" -std=c++17 "${flags[@]}" "$source/bindings/cpp/first_step.cpp" -lwrc -o "$scratch/first_step"
      runs "$scratch/first_step"
    done
    ;;
  dlopen)
    cc -std=c99 -I"$prefix/include" "$source/examples_c/load_at_run_time.c" -ldl -o "$scratch/load_at_run_time"
    "$scratch/load_at_run_time" "$(library_directory)/libwrc.so.0.9"
    ;;
  fortran)
    # The module, its calls with optional arguments, the subroutines for Fortran 77: gfortran, and flang where it is.
    need gfortran
    modules=$prefix/share/wrc/fortran
    flang=$(compgen -c flang | grep -E '^flang(-new)?(-[0-9]+)?$' | sort -V | tail -1 || true)
    export LD_LIBRARY_PATH=$(library_directory)
    for compiler in gfortran $flang; do
      mkdir "$scratch/$compiler"
      cd "$scratch/$compiler"
      objects=(wrc.o wrc_optional.o wrc_f77.o)
      for object in "${objects[@]}"; do "$compiler" -c "$modules/${object%.o}.f90"; done
      for case in main_case.f90 wheel_case.f90 optional_case.f90 flat_case.f; do
        "$compiler" "$source/bindings/fortran/$case" "${objects[@]}" -L"$(library_directory)" -lwrc -o "${case%.*}"
        echo "$compiler: $case"
        "./${case%.*}"
      done
    done
    [ -n "$flang" ] || echo "left out: flang is not installed"
    ;;
  subdirectory)
    need cmake
    # Its flags, standard and warnings are the parent's own affair: the library builds, and has the same bits.
    consumer_project subdirectory -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_STANDARD=14 \
      -DCMAKE_C_FLAGS=-O1 \
      -DCMAKE_CXX_FLAGS='-O1 -march=native -ffast-math -flto -Werror -Wold-style-cast -Wuseless-cast'
    runs "$scratch/project/first_step"
    export LD_LIBRARY_PATH=$scratch/project/wrc
    ldd "$build/tests/realtime/golden_hash" | grep -F "$scratch/project/wrc"
    "$build/tests/realtime/golden_hash" check "$source/tests/realtime/golden_hashes.txt" shortly
    ;;
  fetchcontent)
    need cmake
    consumer_project fetchcontent -DFETCHCONTENT_SOURCE_DIR_WRC="$source" -DBUILD_SHARED_LIBS=OFF -DWRC_INSTALL=ON \
      -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0
    runs "$scratch/project/first_step"
    if ldd "$scratch/project/first_step" | grep libwrc; then echo "not the static library"; exit 1; fi
    ;;
  static)
    need pkg-config
    cmake --install "$build/embedded/fetchcontent/project" --prefix "$scratch/first" >/dev/null
    prefix=$scratch/moved
    mv "$scratch/first" "$prefix"
    names_no_path "$prefix"
    library=$(find "$prefix" -name libwrc.a)
    foreign=$(nm -g --defined-only "$library" | awk 'NF == 3 && $3 !~ /^wrc_/')
    test -z "$foreign" || { echo "global names beside wrc_: $foreign"; exit 1; }
    consumer_project installed -DCMAKE_PREFIX_PATH="$prefix"
    runs "$scratch/project/first_step"
    PKG_CONFIG_PATH=$(dirname "$library")/pkgconfig
    export PKG_CONFIG_PATH
    # shellcheck disable=SC2046 # the flags are words
    cc -std=c99 "$example" $(pkg-config --cflags --libs --static wrc) -o "$scratch/first_step"
    runs "$scratch/first_step"
    # In a shared library of a vendor's, it exports nothing.
    echo 'const void* wrc_get_api(unsigned); const void* of_vendor(void) { return wrc_get_api(900); }' >"$scratch/vendor.c"
    cc -shared -fPIC "$scratch/vendor.c" "$library" -lstdc++ -lm -o "$scratch/libvendor.so"
    test "$(nm -D --defined-only "$scratch/libvendor.so" | awk '$2 == "T" { print $3 }')" = of_vendor
    ;;
  *)
    echo "unknown way '$way'"
    exit 2
    ;;
esac
