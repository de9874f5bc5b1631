#!/usr/bin/env bash
# Seconds to a first number and a first picture in a virtual environment; numpy and matplotlib come from PyPI.
#   first_minute.sh                        from a clone of this project's last commit, which is compiled
#   first_minute.sh WHEEL [PICTURE.png]    from a wheel that is there
set -euo pipefail
root=$(cd "$(dirname "$0")/../../.." && pwd)
source=
[ $# -eq 0 ] || source=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
start=$(date +%s.%N)
if [ -z "$source" ]; then
  git clone -q --depth 1 "file://$root" "$folder/wrc"
  source=$folder/wrc
fi
python3 -m venv "$folder/venv"
"$folder/venv/bin/python" -m pip install -q --disable-pip-version-check "$source"
cd "$folder"
./venv/bin/python - <<'PYTHON'
import wrc
right = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}).contact("RIGHT")
print(right.wrench(wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3)).z)
PYTHON
number=$(date +%s.%N)
times >"$folder/times"
./venv/bin/python -m pip install -q --disable-pip-version-check matplotlib
./venv/bin/python - <<'PYTHON'
import wrc
right = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}).contact("RIGHT")
right.wrench(wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3, wheel={"velocity": (20, 0, 0), "pitch_rate": -20 / 0.46}))
wrc.plot.regions(right, "contact.png")
PYTHON
end=$(date +%s.%N)
python3 - "$start" "$number" "$end" $(tail -1 "$folder/times") <<'PYTHON'
import os, sys
start, number, end = map(float, sys.argv[1:4])
used = sum(60 * float(minutes) + float(seconds) for minutes, seconds in (each.rstrip("s").split("m") for each in sys.argv[4:]))
print(f"processor time to the number {used:.1f} s")
print(f"first number {number - start:.1f} s, first picture {end - start:.1f} s; {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
PYTHON
cd - >/dev/null
[ $# -lt 2 ] || cp "$folder/contact.png" "$2"
