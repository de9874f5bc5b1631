#!/usr/bin/env bash
# Builds the wheel of the Python package:  build_wheel.sh FOLDER [LIBRARY]
#   LIBRARY  a libwrc.so that is built already; without it the sources are compiled (needs what the library needs)
# $PYTHON [python3] has scikit-build-core, or pip gets it from PyPI. On x86-64 and aarch64 Linux the wheel's platform is what
# the library asks for, glibc 2.17, whatever machine built it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
python=${PYTHON:-python3}
options=()
[ $# -lt 2 ] || options+=(--config-settings="cmake.define.WRC_PYTHON_LIBRARY=$(realpath "$2")")
if "$python" -c 'import scikit_build_core' 2>/dev/null; then options+=(--no-build-isolation); fi
# the same bytes from the same sources
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$here" log -1 --format=%ct 2>/dev/null || echo 1700000000)}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
case $(uname -s)-$(uname -m) in
  Linux-x86_64 | Linux-aarch64) export ARCHFLAGS= _PYTHON_HOST_PLATFORM=manylinux_2_17_$(uname -m) ;;
esac
"$python" -m pip wheel -q --disable-pip-version-check --no-deps --wheel-dir "$folder" "${options[@]}" \
  --config-settings="build-dir=$work" "$here"
