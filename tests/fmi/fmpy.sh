#!/usr/bin/env bash
# fmpy (PyPI) in a virtual environment, build/venv; WRC_FMPY_PYTHON names another Python that has it.
#   fmpy.sh install                       makes it where it is missing, 150 MB with what it needs; not with WRC_NO_INSTALL=1
#   fmpy.sh run BUILD free_wheelset       fmu_test.py with the FMUs of the installed tree; status 77 without fmpy
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
venv=$root/build/venv
python=${WRC_FMPY_PYTHON:-$venv/bin/python}
there() { [ -x "$(command -v "$python")" ] && "$python" -c 'import fmpy' 2>/dev/null; }

case ${1:-} in
  install)
    there && exit 0
    if [ "${WRC_NO_INSTALL:-0}" = 1 ]; then
      echo "Missing: fmpy, not installed as WRC_NO_INSTALL=1 asks."
      exit 0
    fi
    echo "Installing fmpy from PyPI into build/venv (WRC_NO_INSTALL=1 prevents it)"
    if ! { python3 -m venv "$venv" && "$venv/bin/python" -m pip install -q --disable-pip-version-check fmpy==0.3.32; }; then
      echo "fmpy could not be installed from PyPI: its test is skipped."
    fi
    ;;
  run)
    if ! there; then
      echo "skipped: no fmpy. tests/fmi/fmpy.sh install puts it into build/venv; WRC_FMPY_PYTHON names another Python."
      exit 77
    fi
    fmus=$2/installed/moved/share/wrc/fmu
    profiles=$(mktemp -d)
    trap 'rm -rf "$profiles"' EXIT
    cp "$root/tests/data/profiles/s1002_benchmark.txt" "$profiles/wheel.txt"
    cp "$root/tests/data/profiles/uic60_benchmark.txt" "$profiles/rail.txt"
    "$python" "$here/fmu_test.py" "$fmus" "$3" "$profiles" "$fmus/make_fmu.py" | grep -v '^Warning: missing input'
    ;;
  *)
    sed -n '2,4s/^# *//p' "$0"
    exit 2
    ;;
esac
