#!/usr/bin/env python3
"""The recipes of other package managers: one version everywhere, and each read by its own tool where that is installed (PyPI: conan,
py-rattler-build; Debian: dpkg-dev, lintian).

    tools/packages/recipes/check.py        prints what was read by what; exits with 1 where something is wrong"""
import importlib.util
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import xml.etree.ElementTree

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
VERSION = re.search(r"project\(wrc VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def versions():
    """{recipe: its version}"""
    text = {each: (HERE / each).read_text() for each in ("conda/recipe.yaml", "debian/changelog")}
    nuget = xml.etree.ElementTree.parse(HERE / "nuget/wrc.nuspec").getroot()
    return {"conda": re.search(r'version: "([^"]+)"', text["conda/recipe.yaml"])[1], "debian": re.match(r"wrc \(([0-9.]+)-", text["debian/changelog"])[1],
            "vcpkg": json.loads((HERE / "vcpkg/vcpkg.json").read_text())["version"], "nuget": nuget.find("{*}metadata/{*}version").text}


def files_of_nuget():
    """Files that the .nuspec names by name are those of make.py's .zip: its library and headers."""
    named = [each.get("src").replace("\\", "/") for each in xml.etree.ElementTree.parse(HERE / "nuget/wrc.nuspec").getroot().iter("{*}file")]
    return [each for each in named if "*" not in each and pathlib.Path(each).name not in
            ("wrc-" + ".".join(VERSION.split(".")[:2]) + ".dll", "wrc.def", "force_table.bin")]


def conan():
    program = shutil.which("conan", path=str(pathlib.Path(sys.executable).parent)) or shutil.which("conan")
    if not program:
        return None
    found = subprocess.run([program, "inspect", HERE / "conan", "--format=json"], capture_output=True, text=True)
    return "" if found.returncode == 0 and json.loads(found.stdout)["version"] == VERSION else found.stderr or "another version"


def conda():
    if importlib.util.find_spec("rattler_build") is None:
        return None
    import rattler_build
    try:
        rattler_build.Stage0Recipe.from_file(str(HERE / "conda/recipe.yaml"))
    except rattler_build.RattlerBuildError as why:
        return str(why)
    return ""


def debian():
    """The source package of what git has, by dpkg-source and lintian."""
    if not shutil.which("dpkg-source") or not shutil.which("lintian"):
        return None
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        archive = place / f"wrc_{VERSION}.orig.tar.gz"
        subprocess.run(["git", "-C", ROOT, "archive", f"--prefix=wrc-{VERSION}/", "-o", archive, "HEAD"], check=True)
        with tarfile.open(archive) as sources:
            sources.extractall(place)
        shutil.copytree(HERE / "debian", place / f"wrc-{VERSION}/debian")
        made = subprocess.run(["dpkg-source", "-b", f"wrc-{VERSION}"], cwd=place, capture_output=True, text=True)
        if made.returncode:
            return made.stderr
        found = subprocess.run(["lintian", "--allow-root", "--fail-on", "error", "--suppress-tags", "root-in-contact,bogus-mail-host", f"wrc_{VERSION}-1.dsc"], cwd=place,
                               capture_output=True, text=True)
        return found.stdout + found.stderr if found.returncode else ""


def main():
    wrong = [f"{name} has version {version}, the library {VERSION}" for name, version in versions().items() if version != VERSION]
    wrong += [f"nuget: {each} is not in the .zip" for each in files_of_nuget()]
    for name, check in (("conan", conan), ("conda", conda), ("debian", debian)):
        told = check()
        print(f"{name}: " + ("not read: its tool is not installed" if told is None else "read by its own tool" if not told else "refused"))
        wrong += [f"{name}: {told}"] if told else []
    print("\n".join(wrong))
    return bool(wrong)


if __name__ == "__main__":
    venv = ROOT / "build/venv/bin/python"  # where the tests have what is of PyPI
    if venv.exists() and pathlib.Path(sys.prefix) != venv.parents[1]:
        sys.exit(subprocess.run([venv, __file__]).returncode)
    sys.exit(main())
