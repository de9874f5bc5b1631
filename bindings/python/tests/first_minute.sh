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
contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()
result = contact.step(wrc.Input(load={"normal_force": 80e3}, creepage={"longitudinal": 1e-3}))
print(result.forces)
wrc.plot.contact(contact, "contact.png")
PYTHON
end=$(date +%s.%N)
python3 -c "print(f'pip install {$installed - $start:.1f} s, first contact and its picture {$end - $installed:.1f} s')"
cd - >/dev/null
[ $# -lt 2 ] || cp "$folder/contact.png" "$2"
