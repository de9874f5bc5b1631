#!/usr/bin/env bash
# An FMU built from the sources it holds, as an importer does that has no binary for its system.
#   from_sources.sh FMU_FOLDER fmi_mistakes     exit status 1 if it does not build, or answers otherwise
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
python3 -m zipfile -e "$1/wrc_wheelset_fmi3.fmu" "$scratch"
cd "$scratch/sources"
cc -std=c99 -O2 -fPIC -DWRC_STATIC -I. -c model.c wheelset.c fmi3.c
c++ -std=c++17 -O1 -fPIC -DWRC_STATIC -I. -c wrc.cpp
c++ -shared model.o wheelset.o fmi3.o wrc.o -lm -o "$scratch/wrc_wheelset.so"
"$2" "$scratch/wrc_wheelset.so"
# FMI 2.0 lists them in the model description.
mkdir "$scratch/two"
python3 -m zipfile -e "$1/wrc_wheel_fmi2.fmu" "$scratch/two"
cd "$scratch/two/sources"
for file in $(sed -n 's/.*<File name="\(.*\)".*/\1/p' ../modelDescription.xml); do
  [ -f "$file" ] || { echo "sources/$file is not there"; exit 1; }
done
cc -std=c99 -O1 -DWRC_STATIC -I. -fsyntax-only model.c wheelset.c fmi2.c
