#!/usr/bin/env bash
# Builds the wheel of the Python package:  build_wheel.sh FOLDER [LIBRARY]
#   LIBRARY  a libwrc.so that is built already; without it the sources are compiled (needs what the library needs)
# $PYTHON [python3] has scikit-build-core, or pip gets it from PyPI. The wheel's platform is that of the library: on Linux glibc
# 2.17, which it asks for, whatever machine built it; Windows for a DLL, aarch64 for a library of a cross compiler.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
python=${PYTHON:-python3}
options=(--config-settings=cmake.define.WRC_PYTHON_QUICK=OFF)
[ $# -lt 2 ] || options+=(--config-settings="cmake.define.WRC_PYTHON_LIBRARY=$(realpath "$2")")
if "$python" -c 'import scikit_build_core' 2>/dev/null; then options+=(--no-build-isolation); fi
# the same bytes from the same sources
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$here" log -1 --format=%ct 2>/dev/null || echo 1700000000)}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The platform of the wheel, by what the library was built for, or of this machine.
built_for=$(uname -s)-$(uname -m)
[ $# -lt 2 ] || built_for=$("$python" - "$2" <<'PYTHON'
import sys
head = open(sys.argv[1], "rb").read(4096)
machine = {62: "Linux-x86_64", 183: "Linux-aarch64"}.get(int.from_bytes(head[18:20], "little")) if head[:4] == b"\x7fELF" else None
print("Windows-AMD64" if head[:2] == b"MZ" else machine or "unknown")
PYTHON
)
platform=
case $built_for in
  Linux-x86_64 | Linux-aarch64) platform=manylinux_2_17_${built_for#Linux-} ;;
  Windows-AMD64) platform=win_amd64 ;;
esac
mkdir "$work/wheel"
ARCHFLAGS='' "$python" -m pip wheel -q --disable-pip-version-check --no-deps --wheel-dir "$work/wheel" "${options[@]}" \
  --config-settings="build-dir=$work/build" "$here"
"$python" "$here/bindings/python/retag.py" "$work"/wheel/wrc-*.whl "$folder" $platform
