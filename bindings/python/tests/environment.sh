#!/usr/bin/env bash
# What the Python tests need from PyPI, in build/venv: numpy, matplotlib, pytest, scikit-build-core, scipy, dask, pyarrow,
# Exudyn, scikit-sundae (CVODE), pandas with its types, mypy, basedpyright; for checks of the house codespell, proselint, conan,
# py-rattler-build; 800 MB. WRC_HOST_PYTHON names
# another Python that has them.
#   environment.sh install                    makes it where something is missing; not with WRC_NO_INSTALL=1
#   environment.sh test LIBRARY FOLDER [...]  builds the wheel of that libwrc.so, installs it in an empty virtual environment
#                                             in FOLDER, and runs the tests with it, pytest's arguments behind; status 77
#                                             without what is needed
#   environment.sh run LIBRARY FOLDER PROGRAM ...    the same with a Python program in place of the tests
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
venv=$here/../../../build/venv
python=${WRC_HOST_PYTHON:-$venv/bin/python}
needed="numpy matplotlib pytest scikit_build_core scipy dask distributed pyarrow exudyn pandas pandas-stubs mypy basedpyright"
there() { [ -x "$(command -v "$python")" ] && "$python" -c "import importlib.util as u, sys; sys.exit(any(u.find_spec(n) is None for n in sys.argv[1:]))" $needed 2>/dev/null; }

# The wheel in an environment of its own: third-party packages come from build/venv, wrc from the wheel alone.
installed() {
  local library=$1 folder=$2 wheel
  mkdir -p "$folder"
  folder=$(cd "$folder" && pwd)
  rm -rf "$folder/wheel" "$folder/venv"
  PYTHON=$python "$here/../build_wheel.sh" "$folder/wheel" "$library" >&2
  wheel=$(echo "$folder"/wheel/wrc-*.whl)
  "$python" -m venv --without-pip "$folder/venv"
  "$python" -m pip --python "$folder/venv/bin/python" install -q --disable-pip-version-check --no-index --no-deps "$wheel" >&2
  "$python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))' \
    >"$("$folder/venv/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')/third_party.pth"
  echo "wheel $(stat -Lc %s "$wheel") bytes, its library $(stat -Lc %s "$library") bytes" >&2
  echo "$folder/venv/bin/python"
}

case ${1:-} in
  install)
    there && { [ -n "${WRC_HOST_PYTHON:-}" ] || [ -x "$venv/bin/proselint" ]; } && exit 0
    if [ "${WRC_NO_INSTALL:-0}" = 1 ]; then
      echo "Missing: Python packages, not installed as WRC_NO_INSTALL=1 asks."
      exit 0
    fi
    echo "Installing Python packages from PyPI into build/venv (WRC_NO_INSTALL=1 prevents it)"
    if ! { python3 -m venv "$venv" && "$venv/bin/python" -m pip install -q --disable-pip-version-check numpy matplotlib pytest \
             scikit-build-core scipy dask distributed pyarrow exudyn==1.13.6 scikit-sundae pandas pandas-stubs mypy basedpyright codespell proselint \
             conan py-rattler-build; }; then
      echo "Python packages could not be installed from PyPI: the tests of the Python package are skipped."
    fi
    ;;
  test | run)
    if ! there; then
      echo "skipped: Python packages are missing. bindings/python/tests/environment.sh install puts them into build/venv;"
      echo "WRC_HOST_PYTHON names another Python."
      exit 77
    fi
    fresh=$(installed "$2" "$3")
    cd "$3" # not where the sources are
    if [ "$1" = test ]; then
      exec "$fresh" -m pytest -q -p no:cacheprovider -rs "$here" "${@:4}"
    fi
    exec "$fresh" "${@:4}"
    ;;
  *)
    sed -n '2,10s/^# *//p' "$0"
    exit 2
    ;;
esac
