#!/usr/bin/env bash
# The runs of docs/hosts.md at full length, ten minutes of one core; rows and pictures go to out/hosts.
#   run.sh [BUILD]      a tree with the target long_tests built [build/release]; hosts that are missing are named and left out
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
out=out/hosts
mkdir -p $out
draw() { /usr/bin/python3 tests/hosts/draw_wheelset.py "$@" || echo "No picture: see above."; }

echo "== free wheelset, 1 mm"
"$build/tests/hosts/kinematic_wave" exact
simbody=$build/tests/hosts/simbody_wheelset
if [ -x "$simbody" ]; then
  echo "== Simbody"
  "$simbody" wrc --free --rms 0 --lateral 1e-3 --speed 5 --seconds 4 --every 0.005 --accuracy 1e-6
  "$simbody" ratio --seconds 8
  "$simbody" wrc --seconds 8 --every 0.002 --rows $out/simbody.csv
  "$simbody" wrc --seconds 8 --every 0.002 --rms 0.008 --rows $out/simbody_flange.csv
else
  echo "No Simbody (Debian: libsimbody-dev) when $build was configured: left out."
fi
environment=bindings/python/tests/environment.sh
$environment install
python() { $environment run "$build/libwrc.so" "$build/python_hosts" "$PWD/$1" "${@:2}" || [ $? -eq 77 ]; }
run() { # run FOLDER ROWS [RMS]: an example, and what the rails did
  python "bindings/python/examples/$1/wheelset_$1.py" --rows "$PWD/$2" ${3:+--rms "$3"}
  [ ! -f "$2" ] || python tests/hosts/wheelset_rows.py "$PWD/$2" ${3:+"$3"}
}
echo "== Exudyn"
rm -f $out/exudyn*.csv $out/scipy.csv
run exudyn $out/exudyn.csv
run exudyn $out/exudyn_flange.csv 0.008
echo "== scipy"
run scipy $out/scipy.csv
python bindings/python/examples/scipy/wheelset_scipy.py --differences
python bindings/python/examples/scipy/wheelset_scipy.py --method BDF
for case in "" _flange; do
  rows=()
  for host in exudyn simbody; do [ ! -f $out/$host$case.csv ] || rows+=($out/$host$case.csv); done
  [ ${#rows[@]} -eq 0 ] || draw $out/wheelset$case.png "${rows[@]}"
done
[ ! -f $out/scipy.csv ] || draw $out/wheelset_scipy.png $out/scipy.csv $out/exudyn.csv
