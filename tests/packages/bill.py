#!/usr/bin/env python3
"""Does each package have its SPDX list, does that name every file with the right sum, the code of others where the library
is, and are licence and notices there?     bill.py PACKAGE..."""
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

wrong = 0


def check(holds, what):
    global wrong
    if not holds:
        print(f"WRONG: {what}")
        wrong += 1


for package in map(pathlib.Path, sys.argv[1:]):
    with tempfile.TemporaryDirectory() as folder:
        unpack = {".deb": ["dpkg-deb", "-x", package, folder], ".gz": ["tar", "-xzf", package, "-C", folder],
                  ".zip": ["unzip", "-q", package, "-d", folder], ".fmu": ["unzip", "-q", package, "-d", folder]}[package.suffix]
        subprocess.run(unpack, check=True)
        folder = pathlib.Path(folder)
        every = {each for each in folder.rglob("*") if each.is_file() and not each.is_symlink()}
        bills = [each for each in every if each.name.endswith(".spdx.json")]
        check(len(bills) == 1, f"{package.name}: {len(bills)} lists")
        for name in ("LICENSE", "third_party.md"):
            name = "license.txt" if package.suffix == ".fmu" and name == "LICENSE" else name
            check(any(each.name == name for each in every), f"{package.name}: no {name}")
        bill = json.loads(bills[0].read_text())
        check(bill["spdxVersion"] == "SPDX-2.3", package.name)
        root = folder if package.suffix in (".deb", ".fmu") else next(folder.iterdir())
        listed = {root / each["fileName"]: {sum["algorithm"]: sum["checksumValue"] for sum in each["checksums"]}
                  for each in bill["files"]}
        check(set(listed) == every - set(bills), f"{package.name}: {set(listed) ^ (every - set(bills))}")
        for file, sums in listed.items():
            check(sums["SHA256"] == hashlib.sha256(file.read_bytes()).hexdigest(), f"{package.name}: sum of {file.name}")
        library = any(".so." in each.name or each.suffix in (".dll", ".fmu") or package.suffix == ".fmu" for each in every)
        others = [each["name"] for each in bill["packages"][1:]]
        check(others == (["libstdc++ and libgcc"] if library else []), f"{package.name}: holds {others}")
        check(all(each["versionInfo"] != "NOASSERTION" for each in bill["packages"]), f"{package.name}: a version is missing")
        print(f"{package.name}: {len(listed)} files, others' code: {others or 'none'}")
sys.exit(wrong > 0)
