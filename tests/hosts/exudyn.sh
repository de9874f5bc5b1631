#!/usr/bin/env bash
# Exudyn (PyPI) in a virtual environment of its own, build/venv; WRC_HOST_PYTHON names another Python that has it.
#   exudyn.sh install               makes it where it is missing, 100 MB; not with WRC_NO_INSTALL=1
#   exudyn.sh run libwrc.so ...     exudyn_wheelset.py with these arguments; status 77 without Exudyn
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
venv=$here/../../build/venv
python=${WRC_HOST_PYTHON:-$venv/bin/python}
there() { [ -x "$(command -v "$python")" ] && "$python" -c 'import exudyn, numpy' 2>/dev/null; }

case ${1:-} in
  install)
    there && exit 0
    if [ "${WRC_NO_INSTALL:-0}" = 1 ]; then
      echo "Missing: Exudyn, not installed as WRC_NO_INSTALL=1 asks."
      exit 0
    fi
    echo "Installing Exudyn from PyPI into build/venv (WRC_NO_INSTALL=1 prevents it)"
    if ! { python3 -m venv "$venv" &&
             "$venv/bin/python" -m pip install -q --disable-pip-version-check exudyn==1.13.6; }; then
      echo "Exudyn could not be installed from PyPI: its test is skipped."
    fi
    ;;
  run)
    if ! there; then
      echo "skipped: no Exudyn. tests/hosts/exudyn.sh install puts it into build/venv; WRC_HOST_PYTHON names another Python."
      exit 77
    fi
    exec "$python" "$here/exudyn_wheelset.py" "${@:2}"
    ;;
  *)
    sed -n '2,4s/^# *//p' "$0"
    exit 2
    ;;
esac
