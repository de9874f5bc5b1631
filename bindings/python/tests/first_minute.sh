#!/usr/bin/env bash
# From pip install of the wheel, with numpy and matplotlib from PyPI, to a plotted contact: seconds.
#   first_minute.sh WHEEL [PICTURE.png]
set -euo pipefail
wheel=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
start=$(date +%s.%N)
"$folder/venv/bin/python" -m pip install -q --disable-pip-version-check "$wheel[plot]"
installed=$(date +%s.%N)
cd "$folder"
./venv/bin/python - <<'PYTHON'
import wrc
model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40})
right = model.contact("RIGHT")
standing = right.wrench(wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3)).z
print(right.wrench(wrc.WheelInput(wheel={"z": standing, "velocity": (20, 0, 0), "pitch_rate": -20 / 0.46})))
wrc.plot.regions(right, "contact.png")
PYTHON
end=$(date +%s.%N)
python3 -c "print(f'pip install {$installed - $start:.1f} s, first contact and its picture {$end - $installed:.1f} s')"
cd - >/dev/null
[ $# -lt 2 ] || cp "$folder/contact.png" "$2"
