#!/usr/bin/env bash
# The folders of bindings/hosts/ as their users build them, against the installed and moved tree (test install_tree).
#   installed.sh BUILD SOURCE simbody|simulink|modelica
# Status 77: the host is not there.
set -euo pipefail
build=$1 source=$2 host=$3
prefix=$build/installed/moved
scratch=$build/installed/$host
library=$(dirname "$(find "$prefix" -name libwrc.so)")
flags=(-I"$prefix/include" -L"$library")
unset CPATH C_INCLUDE_PATH LIBRARY_PATH
export LD_LIBRARY_PATH=$library LC_ALL=C
rm -rf "$scratch"
mkdir -p "$scratch"

# The numbers the others are held against: a right wheel, the C interface alone. Wrench, then its derivative by z.
cat >"$scratch/direct.c" <<'C'
#include <stdio.h>
#include "wrc/wrc.h"
int main(void) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  wrc_model* model;
  wrc_contact* contact;
  if (wrc_model_create(&config, NULL, &model, NULL, 0) < 0 || wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &contact, NULL, 0) < 0)
    return 1;
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = {sizeof wrench};
  static wrc_wrench_derivatives slopes = {sizeof slopes};
  input.wheel.y = 1e-3, input.wheel.z = 3e-4, input.wheel.yaw = 1e-3, input.rail.z = 1e-5;
  input.wheel.velocity[0] = 20.0, input.wheel.pitch_rate = -20.0 / 0.46;
  if (wrc_contact_wrench_derivatives(contact, &input, &wrench, &slopes) != WRC_OK) return 2;
  for (int i = 0; i < 6; ++i) printf("%.17g\n", i < 3 ? wrench.force[i] : wrench.moment[i - 3]);
  for (int i = 0; i < 6; ++i) printf("%.17g\n", slopes.wrench[i][WRC_BY_Z]);
  return 0;
}
C
cc -std=c99 "${flags[@]}" "$scratch/direct.c" -lwrc -o "$scratch/direct"
"$scratch/direct" >"$scratch/direct.txt"

case $host in
  simbody)
    cmake -S "$source/bindings/hosts/simbody" -B "$scratch/project" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" >"$scratch/log" 2>&1 ||
      { grep -q 'Could not find.*Simbody\|SimbodyConfig.cmake' "$scratch/log" &&
          { echo "skipped: no Simbody (Debian: libsimbody-dev)"; exit 77; }
        cat "$scratch/log"; exit 1; }
    cmake --build "$scratch/project" >>"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
    "$scratch/project/wheelset" 0.25 >"$scratch/rows.csv"
    lines=$(cat "$source"/bindings/hosts/simbody/{CMakeLists.txt,wheelset.cpp} | wc -l)
    [ "$lines" -le 100 ] || { echo "the example has $lines lines, more than 100"; exit 1; }
    ;;
  simulink)
    command -v mkoctfile >/dev/null || { echo "skipped: no Octave with mkoctfile (Debian: octave-dev)"; exit 77; }
    cd "$scratch"
    cp "$source/bindings/hosts/simulink/wrc_wheel.c" . # it leaves an object beside the source
    mkoctfile --mex -DMATLAB_MEX_FILE -Wall -Wextra wrc_wheel.c -I"$source/bindings/hosts" -I"$source/bindings/hosts/simulink/stub" "${flags[@]}" -lwrc
    octave --no-gui --no-init-file --eval '
      in = [1e-3; 3e-4; 0; 1e-3; 20; 0; 0; 0; -20/0.46; 0; 0; 1e-5; zeros(6, 1)];
      w = wrc_wheel([in, in], 0, 2, 4, 0, 0.3);
      assert(w(:, 1), w(:, 2));
      printf("%.17g\n", w(:, 1));
      wrong = "";
      try wrc_wheel(in + [0; 3; zeros(16, 1)], 0, 2, 4, 0, 0.3); catch e, wrong = e.message; end
      assert(! isempty(strfind(wrong, "did you pass mm")));
      try wrc_wheel(in, 2, 2, 4, 0, 0.3); wrong = "side 2 passed"; catch e, wrong = e.message; end
      assert(! isempty(strfind(wrong, "WRC_SIDE_RIGHT")));' 2>said >octave.txt || { cat said octave.txt; exit 1; }
    head -6 direct.txt | diff - octave.txt
    echo "the S-function in Octave: the bits of C"
    ;;
  modelica)
    cat >"$scratch/ModelicaUtilities.h" <<'C'
/* Stands for a Modelica tool's. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
static void ModelicaError(const char* text) { puts(text); exit(3); }
static void ModelicaFormatError(const char* format, ...) {
  va_list list;
  va_start(list, format);
  vprintf(format, list);
  va_end(list);
  exit(4);
}
C
    cat >"$scratch/driver.c" <<'C'
#include "wrc_modelica.h"
int main(int count, char** words) {
  double u[18] = {1e-3, 3e-4, 0, 1e-3, 20, 0, 0, 0, -20.0 / 0.46, 0, 0, 1e-5}, du[18] = {0, 1}, w[6], dw[6];
  void* wheel = wrc_modelica_open(0, 2, 4, 0.0, 0.3);
  (void)words;
  if (count > 1) u[1] = 3.0;
  wrc_modelica_wrench(wheel, u, w);
  wrc_modelica_wrench_der(wheel, u, du, dw);
  for (int i = 0; i < 6; ++i) printf("%.17g\n", w[i]);
  for (int i = 0; i < 6; ++i) printf("%.17g\n", dw[i]);
  wrc_modelica_close(wheel);
  return 0;
}
C
    cc -std=c99 -Wall -Wextra -I"$scratch" -I"$source/bindings/hosts" -I"$source/bindings/hosts/modelica" "${flags[@]}" "$scratch/driver.c" -lwrc -o "$scratch/driver"
    "$scratch/driver" | diff "$scratch/direct.txt" -
    status=0
    "$scratch/driver" wrong >"$scratch/said" || status=$?
    if [ $status -ne 4 ] || ! grep -q 'did you pass mm' "$scratch/said"; then echo "a mistake is not told"; exit 1; fi
    echo "Modelica's C side: the bits of C, wrench and derivatives"
    command -v omc >/dev/null || { echo "left out: no omc, so Wrc.mo itself is not compiled"; exit 0; }
    cd "$scratch"
    cat >run.mos <<MOS
loadFile("$source/bindings/hosts/modelica/Wrc.mo"); getErrorString();
simulate(Wrc.Drop, stopTime=0.05, cflags="-I$source/bindings/hosts -I$source/bindings/hosts/modelica -I$prefix/include -L$library"); getErrorString();
val(z, 0.05);
MOS
    omc run.mos | tee said
    grep -q 'record SimulationResult' said && ! grep -q 'Error' said
    ;;
  *) sed -n '2,4s/^# *//p' "$0"; exit 2 ;;
esac
