#!/usr/bin/env bash
# The packages of tools/packages/make.py as their users meet them.
#   packages.sh BUILD SOURCE WAY
#     make      twice from one build, in other places, time zones and with other rights: the same bytes
#     debian    installed by dpkg into an empty root, the smallest program built and run against that, and purged
#     archive   the same with the .tar.gz
#     zip       the same with the .zip of a mingw build, under wine
#     bill      each has its list of files and of others' code, with right sums, and the notices
#     again     the library built anew from a clone elsewhere: the same bytes
# Status 77: skipped.
set -euo pipefail
build=$1 source=$2 way=$3
packages=$build/packages scratch=$build/packages_$way
windows=()
[ "$way" != zip ] || windows=(--windows)
unset LD_LIBRARY_PATH CPATH C_INCLUDE_PATH LIBRARY_PATH PKG_CONFIG_PATH CMAKE_PREFIX_PATH
export LC_ALL=C
need() { command -v "$1" >/dev/null || { echo "skipped: $1 is not installed"; exit 77; }; }
runs() { "$@" | tr -d '\r' | diff "$source/tests/examples/first_step.txt" -; }
rm -rf "$scratch"
mkdir -p "$scratch"

case $way in
  make)
    need dpkg-deb
    rm -rf "$packages"
    "$source/tools/packages/make.py" "$build" "$packages"
    (cd / && umask 077 && TZ=Asia/Tokyo "$source/tools/packages/make.py" "$build" "$scratch/again" >"$scratch/log")
    diff -r "$packages" "$scratch/again"
    ;;
  debian)
    root=$scratch/root
    mkdir -p "$root/var/lib/dpkg/updates" "$root/var/lib/dpkg/info"
    touch "$root/var/lib/dpkg/status"
    as=(dpkg --root="$root" --log="$scratch/log" --force-not-root --force-bad-path --force-depends)
    "${as[@]}" --install "$packages"/*.deb >"$scratch/said" 2>&1 || { cat "$scratch/said"; exit 1; }
    "${as[@]}" --verify
    export PKG_CONFIG_LIBDIR=$root/usr/lib/pkgconfig
    # shellcheck disable=SC2046 # the flags are words
    cc -std=c99 "$root/usr/share/doc/wrc-doc/examples/first_step.c" $(pkg-config --cflags --libs wrc) -o "$scratch/c"
    # shellcheck disable=SC2046
    c++ -std=c++17 "$root/usr/share/doc/wrc-doc/examples/first_step.cpp" $(pkg-config --cflags --libs wrc) -o "$scratch/cpp"
    for program in c cpp; do LD_LIBRARY_PATH=$root/usr/lib runs "$scratch/$program"; done
    needed=$(readelf -d "$scratch/c" | sed -n 's/.*NEEDED.*\[\(libwrc.*\)\]/\1/p')
    [ "$needed" = libwrc.so.0.9 ] || { echo "the program asks for $needed"; exit 1; }
    if /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
      (cd / && env -u WRC_LIBRARY PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$root/usr/lib/python3/dist-packages" /usr/bin/python3 -c '
import os, wrc
print("python3-wrc:", os.path.realpath(wrc._library.FOLDER / "libwrc.so"))
contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()
wrench = contact.wrench(wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3))
assert abs(wrench.force[2] + 80e3) < 1.0 and os.path.exists(wrc.force_table()), wrench')
    fi
    # the runtime package alone carries the program
    "${as[@]}" --purge libwrc-dev wrc-doc wrc-data wrc-fmu python3-wrc >>"$scratch/said" 2>&1
    LD_LIBRARY_PATH=$root/usr/lib runs "$scratch/c"
    "${as[@]}" --purge libwrc0.9 >>"$scratch/said" 2>&1
    left=$(find "$root" -not -path '*/var*' -not -type d)
    [ -z "$left" ] || { echo "left behind: $left"; exit 1; }
    ;;
  archive)
    tar -xzf "$packages"/wrc-*.tar.gz -C "$scratch"
    root=$(echo "$scratch"/wrc-*)
    cc -std=c99 -I"$root/include" "$root/examples/first_step.c" -L"$root/lib" -lwrc -o "$scratch/first_step"
    LD_LIBRARY_PATH=$root/lib runs "$scratch/first_step"
    ;;
  zip)
    need unzip
    "$source/tools/packages/make.py" --windows "$build" "$scratch/one"
    (umask 077 && TZ=Asia/Tokyo "$source/tools/packages/make.py" --windows "$build" "$scratch/other" >"$scratch/log")
    diff -r "$scratch/one" "$scratch/other"
    unzip -q "$scratch"/one/*.zip -d "$scratch"
    root=$(echo "$scratch"/wrc-*)
    x86_64-w64-mingw32-gcc -std=c99 -I"$root/include" "$root/examples/first_step.c" "$root/lib/libwrc.dll.a" -o "$scratch/first_step.exe"
    WINEPATH=$root/bin WINEDEBUG=-all runs wine "$scratch/first_step.exe"
    exec "$source/tests/packages/bill.py" "$scratch"/one/*.zip
    ;;
  bill) "$source/tests/packages/bill.py" "$packages"/* ;;
  again)
    git clone -q "$source" "$scratch/a_clone" 2>/dev/null || { echo "skipped: no history to clone"; exit 77; }
    if [ -n "$(git -C "$source" status --porcelain)" ]; then echo "skipped: changes that are not committed"; exit 77; fi
    for each in one two; do # neither the clone's place nor the build's may show
      mkdir "$scratch/$each"
      mv "$scratch/a_clone" "$scratch/$each/clone"
      CCACHE_DISABLE=1 cmake -S "$scratch/$each/clone" -B "$scratch/$each/build" -DWRC_TESTS=OFF -DWRC_EXAMPLES=OFF \
        -DWRC_FORTRAN=OFF -DCMAKE_BUILD_TYPE=Release >"$scratch/log"
      CCACHE_DISABLE=1 cmake --build "$scratch/$each/build" -j 2 >>"$scratch/log"
      "$scratch/$each/clone/tools/packages/make.py" "$scratch/$each/build" "$scratch/$each/packages" >>"$scratch/log"
      mv "$scratch/$each/clone" "$scratch/a_clone"
    done
    diff -r "$scratch/one/packages" "$scratch/two/packages"
    ;;
  *) sed -n '2,11s/^# *//p' "$0"; exit 2 ;;
esac
