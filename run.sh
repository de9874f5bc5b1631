#!/usr/bin/env bash
# The main job. Without arguments: the source paper's cases, printed and drawn into out/.
set -euo pipefail
called_from=$PWD
cd "$(dirname "$0")"

if [ "${1:-}" = "--help" ] || [ "${1:-}" = "-h" ]; then
  cat <<'HELP'
./run.sh
    Builds the library and runs the source paper's cases (S1002 on UIC60, and an exact double ellipse): prints tables 1 and 2
    beside CONTACT and the paper with both traction bounds, writes the fields as CSV and draws figures 1 to 9 as PNG and PDF,
    into out/. The figures are those of `python -m wrc.paper`.

./run.sh --wheel FILE --rail FILE [options]
    Your own profiles and load, through examples_c/own_case.c. A profile file has one point per line, y and z, separated
    by blanks, commas or semicolons; y increasing, z down; a heading, and what stands behind #, is skipped. Commas are
    decimal beside semicolons, blanks or tabs.
      wheel: y = 0 at the running circle, flange at y < 0.     rail: z = 0 at its top, gauge side at y < 0.
    FILE may also be a built-in shape: S1002, the default, for the wheel; 60E1, or UIC60 (canted 1:40 already), the default,
    for the rail.

      --unit mm|m           of the points                                       [mm]
      --smoothing L         of measured points: half of a wave of L m remains     [0]
      --inclination T       cant of the rail to apply, 0.025 for 1:40           [0]
      --radius R            nominal wheel radius in m                           [0.46]
      --gauge G             track gauge in m                                    [1.435]
      --tape-circles D      distance of the wheels' tape circles in m           [1.5]
      --lateral Y           lateral shift of the wheelset in m                  [0]
      --yaw A               yaw angle in rad                                    [0]
      --load N              normal force in N                                   [80000]
      --creepage X Y PHI    longitudinal, lateral [-] and spin [1/m]            [0.001 0 0]
      --friction MU                                                             [0.35]
      --speed V             in m/s                                              [1]
      --shear-modulus G --poisson NU                                            [82e9 0.28]
      --csv FILE            writes the fields over the patch

    Example:  ./run.sh --wheel S1002 --rail 60E1 --inclination 0.025 --lateral 0.003 --load 90000

Needs Debian's g++, gcc, cmake, ninja-build and, for the pictures, python3-matplotlib. As root or with
sudo the script names and installs those that are missing; with WRC_NO_INSTALL=1 it names them and goes on.
HELP
  exit 0
fi

. .ci/setup.sh
. .ci/parts.sh
need_packages g++ gcc cmake ninja-build
mkdir -p build
build=${WRC_BUILD:-build/run} # one that is there is taken as it was configured
[ -n "${WRC_BUILD:-}" ] ||
  cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DWRC_TESTS=OFF -DWRC_FORTRAN=OFF >build/run.log 2>&1 ||
  { cat build/run.log; exit 1; }
compile "library and examples" build/run.log cmake --build "$build" --target own_case paper_cases creep_curves >&2 || exit 1

if [ $# -gt 0 ]; then
  own_case=$PWD/$build/examples_c/own_case
  cd "$called_from" # file names are the caller's
  exec "$own_case" "$@"
fi

mkdir -p out
"$build/examples_c/paper_cases" out | tee out/paper_cases.txt
"$build/examples_c/creep_curves" out | tee out/creep_curves.txt
(need_packages python3 python3-matplotlib) || true
if /usr/bin/python3 -c 'import matplotlib' 2>build/matplotlib.log; then
  WRC_LIBRARY=$(cd "$build" && pwd)/libwrc.so PYTHONPATH=$PWD/bindings/python PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -m wrc.paper out |
    tee out/paper.txt
  /usr/bin/python3 examples_c/draw_creep_curves.py out
else
  echo "No pictures: /usr/bin/python3 has no matplotlib."
fi
