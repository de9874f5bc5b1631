#!/usr/bin/env python3
"""FMUs of wrc: puts them together, or puts your profiles into one.

    make_fmu.py build OUT [--linux wrc_fmu.so] [--windows wrc_fmu.dll]
        wrc_wheel and wrc_wheelset, for FMI 2.0 and 3.0: OUT/wrc_wheel_fmi2.fmu and so on
    make_fmu.py profiles FROM.fmu TO.fmu [--wheel FILE] [--rail FILE]
        the same FMU with these points (y and z in mm in each line) as resources and chosen by default; files as ./run.sh reads
        them: commas or semicolons may part the numbers, commas are decimal beside semicolons, blanks or tabs

Times in the files are SOURCE_DATE_EPOCH, or 1980: the same parts make the same bytes."""
import argparse
import os
import pathlib
import re
import sys
import time
import zipfile
from xml.sax.saxutils import quoteattr

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
MODELS = {
    "wrc_wheel": ("wheel.def", "ModelExchange", "One wheel on its rail: pose and velocities in, wrench on the wheel out. wrc.h of "
                  "the C library has frames and signs."),
    "wrc_wheelset": ("wheelset.def", "CoSimulation", "A wheelset with its mass on straight rails at a given forward speed. wrc.h of "
                     "the C library has frames and signs."),
}
UNITS = {"1": "", "m": 'm="1"', "rad": 'rad="1"', "s": 's="1"', "kg": 'kg="1"', "kg.m2": 'kg="1" m="2"', "m/s": 'm="1" s="-1"',
         "rad/s": 'rad="1" s="-1"', "s/m": 's="1" m="-1"', "m2": 'm="2"', "N": 'kg="1" m="1" s="-2"', "N.m": 'kg="1" m="2" s="-2"',
         "Pa": 'kg="1" m="-1" s="-2"', "W": 'kg="1" m="2" s="-3"', "kg/m2": 'kg="1" m="-2"', "J/m2": 'kg="1" s="-2"'}
FIRST_INTEGER, TIME = 1000, 999
ROW = re.compile(r'^(REAL|INTEGER)\((\w+), (?:"([^"]*)", )?(\w+), (\w+), ([^,]+), (?:ANY|RANGE\(([^,]+), ([^,]+)\)), "(.*)"\)$')


def lines_of(name):
    for line in (HERE / name).read_text().splitlines():
        included = re.fullmatch(r'#include "(.*)"', line)
        if included:
            yield from lines_of(included[1])
        else:
            yield line


class Variable:
    def __init__(self, found, number):
        self.kind, self.name, self.unit, self.causality, self.variability, self.start, least, most, self.text = found.groups()
        self.number = number
        self.given = self.causality in ("input", "parameter")  # has a start value
        self.range = f' min="{least}" max="{most}"' if least else ""


def variables(name):
    """(token, variables)"""
    found, counts, token = [], {"REAL": 0, "INTEGER": FIRST_INTEGER}, None
    for line in lines_of(name):
        row = ROW.match(line)
        if row:
            found.append(Variable(row, counts[row[1]]))
            counts[row[1]] += 1
        elif line.startswith("TOKEN"):
            token = line.split('"')[1]
        elif line.startswith(("REAL", "INTEGER")):
            raise SystemExit(f"{name}: not understood: {line}")
    return token, found


def version():
    return re.search(r"project\(wrc VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def units(version):
    return "".join(f'    <Unit name="{name}"><BaseUnit {base}/></Unit>\n' for name, base in UNITS.items())


def describe(model, fmi):
    """modelDescription.xml"""
    file, kind, text = MODELS[model]
    token, every = variables(file)
    outputs = [each for each in every if each.causality == "output"]
    inputs = [each for each in every if each.causality == "input"]
    step = '  <DefaultExperiment startTime="0" stopTime="1" stepSize="1e-3"/>\n'
    three = fmi == 3
    derivatives = ""
    if model == "wrc_wheel":
        derivatives = 'providesDirectionalDerivatives="true" providesAdjointDerivatives="true"' if three else 'providesDirectionalDerivative="true"'
    state = "State" if three else "state"
    more = {"ModelExchange": 'needsCompletedIntegratorStep="false"' if three else 'completedIntegratorStepNotNeeded="true"',
            "CoSimulation": 'canHandleVariableCommunicationStepSize="true"'}[kind]
    if not three:
        more += ' canNotUseMemoryManagementFunctions="true"'
    head = (f'<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="{fmi}.0" modelName="{model}" '
            f'{"instantiationToken" if three else "guid"}={quoteattr(token)} description={quoteattr(text)} version="{version()}" '
            f'license="Apache-2.0" generationTool="wrc {version()}" variableNamingConvention="flat"'
            + ("" if three else ' numberOfEventIndicators="0"') + ">\n"
            f'  <{kind} modelIdentifier="{model}" canGetAndSetFMU{state}="true" canSerializeFMU{state}="true" {derivatives} {more}'
            + ("/>\n" if three else f">\n    <SourceFiles>\n{files_of_sources(2)}    </SourceFiles>\n  </{kind}>\n")
            + f"  <UnitDefinitions>\n{units(fmi)}  </UnitDefinitions>\n" + step)
    return head + (structure3 if three else structure2)(every, inputs, outputs) + "</fmiModelDescription>\n"


def structure2(every, inputs, outputs):
    rows, place = [], {each: i + 1 for i, each in enumerate(every)}
    for each in every:
        kind = "Real" if each.kind == "REAL" else "Integer"
        start = f' start="{each.start}"' if each.given else ""
        unit = f' unit="{each.unit}"' if each.unit else ""
        initial = {"parameter": ' initial="exact"', "calculatedParameter": ' initial="calculated"'}.get(each.causality, "")
        rows.append(f'    <ScalarVariable name="{each.name}" valueReference="{each.number}" causality="{each.causality}" '
                    f'variability="{each.variability}"{initial} description={quoteattr(each.text)}><{kind}{unit}{each.range}{start}/></ScalarVariable>\n')
    depend = " ".join(str(place[each]) for each in inputs)
    unknown = "".join(f'      <Unknown index="{place[each]}" dependencies="{depend}"/>\n' for each in outputs)
    first = "".join(f'      <Unknown index="{place[each]}"/>\n' for each in every if each in outputs or each.causality == "calculatedParameter")
    return (f"  <ModelVariables>\n{''.join(rows)}  </ModelVariables>\n  <ModelStructure>\n    <Outputs>\n{unknown}    </Outputs>\n"
            f"    <InitialUnknowns>\n{first}    </InitialUnknowns>\n  </ModelStructure>\n")


def structure3(every, inputs, outputs):
    rows = [f'    <Float64 name="time" valueReference="{TIME}" causality="independent" variability="continuous" unit="s"/>\n']
    for each in every:
        kind = "Float64" if each.kind == "REAL" else "Int32"
        start = f' start="{each.start}"' if each.given else ""
        unit = f' unit="{each.unit}"' if each.unit else ""
        rows.append(f'    <{kind} name="{each.name}" valueReference="{each.number}" causality="{each.causality}" '
                    f'variability="{each.variability}"{unit}{each.range}{start} description={quoteattr(each.text)}/>\n')
    depend = " ".join(str(each.number) for each in inputs)
    out = "".join(f'    <Output valueReference="{each.number}" dependencies="{depend}"/>\n' for each in outputs)
    first = "".join(f'    <InitialUnknown valueReference="{each.number}"/>\n' for each in every
                    if each in outputs or each.causality == "calculatedParameter")
    return f"  <ModelVariables>\n{''.join(rows)}  </ModelVariables>\n  <ModelStructure>\n{out}{first}  </ModelStructure>\n"


def unit_names(fmi):
    """The C files of a version; wrc.cpp is the library."""
    return ["model.c", "wheelset.c", f"fmi{fmi}.c"]


def files_of_sources(fmi):
    """FMI 2: the list in the model description."""
    return "".join(f'      <File name="{name}"/>\n' for name in unit_names(fmi) + ["wrc.cpp"])


def build_description(model):
    """FMI 3: sources/buildDescription.xml"""
    define = '      <PreprocessorDefinition name="WRC_STATIC"/>\n'

    def file_set(language, names):
        rows = "".join(f'      <SourceFile name="{name}"/>\n' for name in names)
        return f'    <SourceFileSet language="{language}">\n{rows}{define}      <IncludeDirectory name="."/>\n    </SourceFileSet>\n'

    return ('<?xml version="1.0" encoding="UTF-8"?>\n<fmiBuildDescription fmiVersion="3.0">\n'
            f'  <BuildConfiguration modelIdentifier="{model}">\n{file_set("C99", unit_names(3))}{file_set("C++17", ["wrc.cpp"])}'
            "  </BuildConfiguration>\n</fmiBuildDescription>\n")


def sources(model, fmi):
    """What an importer builds the FMU from, {name: bytes}: all of it in one folder."""
    files = {name: (HERE / name).read_bytes() for name in ["model.h", "bodies.def", "wheel.def", "wheelset.def"] + unit_names(fmi)}
    files |= {each.name: each.read_bytes() for each in (HERE / "headers").glob(f"fmi{fmi}*.h")}
    files |= {f"wrc/{each.name}": each.read_bytes() for each in (ROOT / "include_c/wrc").glob("*.h")}
    sys.path.insert(0, str(ROOT / "tools/amalgamate"))
    import amalgamate
    files["wrc.cpp"] = amalgamate.source().encode()
    if fmi == 3:
        files["buildDescription.xml"] = build_description(model).encode()
    return {f"sources/{name}": data for name, data in files.items()}


def write(path, files):
    """A .fmu of {name: bytes}."""
    when = time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", 315532800)))[:6]
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=6) as packed:
        for name in sorted(files, key=lambda name: (name != "modelDescription.xml", name)):
            info = zipfile.ZipInfo(name, when)
            info.compress_type, info.external_attr = zipfile.ZIP_DEFLATED, 0o100755 << 16 if "binaries" in name else 0o100644 << 16
            packed.writestr(info, files[name])


def build(asked):
    binaries = {name: path.read_bytes() for name, path in (("linux", asked.linux), ("windows", asked.windows)) if path}
    folder = {(2, "linux"): ("linux64", "so"), (2, "windows"): ("win64", "dll"), (3, "linux"): ("x86_64-linux", "so"),
              (3, "windows"): ("x86_64-windows", "dll")}
    asked.out.mkdir(parents=True, exist_ok=True)
    papers = {"license.txt": (ROOT / "LICENSE").read_bytes(), "third_party.md": (ROOT / "docs/third_party.md").read_bytes(),
              "README.md": (HERE / "README.md").read_bytes()}
    for model in MODELS:
        for fmi in (2, 3):
            files = {"modelDescription.xml": describe(model, fmi).encode(),
                     "resources/README.txt": b"wheel.txt, rail.txt: points of your profiles, y and z in mm in each line "
                                             b"(make_fmu.py profiles).\n"}
            files |= sources(model, fmi)
            for system, data in binaries.items():
                place, ending = folder[fmi, system]
                files[f"binaries/{place}/{model}.{ending}"] = data
            files |= {f"documentation/{'licenses/' if name != 'README.md' else ''}{name}": data for name, data in papers.items()}
            write(asked.out / f"{model}_fmi{fmi}.fmu", files)


def points(path):
    """The points of a file, as an FMU reads them: two numbers in each line, without a heading."""
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as why:
        sys.exit(f"{path} cannot be read: {why}")
    rows = []
    for number, line in enumerate(lines, 1):
        text = re.split("[#!%]", line)[0].strip()
        if re.search(r"[;\s]", text):
            text = re.sub(r"(?<=\d),(?=\d)", ".", text)
        cells = [each for each in re.split(r"[;,\s]+", text) if each]
        if all(re.fullmatch(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", each) for each in cells):
            if cells and len(cells) != 2:
                sys.exit(f"{path}, line {number}: {len(cells)} numbers, where y and z are asked for")
            rows += [cells] if cells else []
        elif rows:
            sys.exit(f"{path}, line {number}: '{text}' is no point: y and z are asked for")
    width = float(rows[-1][0]) - float(rows[0][0]) if rows else 0.0
    if not 20.0 <= width <= 500.0:
        sys.exit(f"{path} has {len(rows)} points over {width:g} mm, a profile has 20 to 500 mm: are they y and z in mm, y increasing?")
    return "".join(f"{y} {z}\n" for y, z in rows).encode()


def with_profiles(asked):
    with zipfile.ZipFile(asked.base) as packed:
        files = {name: packed.read(name) for name in packed.namelist() if not name.endswith("/")}
    text = files["modelDescription.xml"].decode()
    for body, path in (("wheel", asked.wheel), ("rail", asked.rail)):
        if path:
            files[f"resources/{body}.txt"] = points(path)
            text, changed = re.subn(rf'(name="{body}_profile" .*?start=")\d', r"\g<1>1", text)
            assert changed == 1
    files["modelDescription.xml"] = text.encode()
    write(asked.out, files)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ways = arguments.add_subparsers(required=True)
    way = ways.add_parser("build")
    way.add_argument("out", type=pathlib.Path)
    way.add_argument("--linux", type=pathlib.Path)
    way.add_argument("--windows", type=pathlib.Path)
    way.set_defaults(work=build)
    way = ways.add_parser("profiles")
    way.add_argument("base", type=pathlib.Path)
    way.add_argument("out", type=pathlib.Path)
    way.add_argument("--wheel", type=pathlib.Path)
    way.add_argument("--rail", type=pathlib.Path)
    way.set_defaults(work=with_profiles)
    asked = arguments.parse_args()
    asked.work(asked)


if __name__ == "__main__":
    main()
