#!/usr/bin/env python3
"""Packages of a built library, the same bytes from the same build whoever makes them, wherever.

    tools/packages/make.py BUILD OUT      Debian packages libwrc0.9, libwrc-dev, wrc-data, wrc-fmu, python3-wrc, wrc-doc,
                                          and a .tar.gz
    tools/packages/make.py BUILD OUT --windows  the .zip of a mingw build
                       --mingw BUILD      of the Debian packages and the .tar.gz: the FMUs are for Windows, too, by this build

Times in the packages are SOURCE_DATE_EPOCH, or that of the last commit. Each holds a list of its files and of the code of
others that is in it (SPDX 2.3), the notices on that code and the licence. Needs cmake, strip and, for .deb, dpkg-deb."""
import argparse
import gzip
import hashlib
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
VERSION = re.search(r"project\(wrc VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
SERIES = VERSION.rpartition(".")[0]  # of the SONAME
SUPPLIER = "NOASSERTION"
SUMMARY = "wheel/rail contact for real-time multibody simulation"
# What a library holds of others: name, licence, where its source is; docs/third_party.md is for people.
RUN_TIME = ("libstdc++ and libgcc", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org")


def run(*words, **more):
    return subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE, text=True, **more).stdout


def epoch():
    if "SOURCE_DATE_EPOCH" in os.environ:
        return int(os.environ["SOURCE_DATE_EPOCH"])
    try:
        return int(run("git", "-C", ROOT, "log", "-1", "--format=%ct"))
    except (OSError, subprocess.CalledProcessError):
        sys.exit("These sources have no history: set SOURCE_DATE_EPOCH to the time the packages are to bear")


def compiler_version(build):
    for file in build.glob("CMakeFiles/*/CMakeCXXCompiler.cmake"):
        found = re.search(r'set\(CMAKE_CXX_COMPILER_VERSION "([\d.]+)"', file.read_text())
        if found:
            return found[1]
    return "NOASSERTION"


def files_of(folder):
    return sorted((each for each in folder.rglob("*") if each.is_file() and not each.is_symlink()),
                  key=lambda each: str(each.relative_to(folder)))


def bill(folder, name, holds, when):
    """SPDX 2.3 of what lies in `folder`; holds: (name, version, licence, source) of others' code in it."""
    def package(identifier, name, version, licence, source, **more):
        return {"SPDXID": identifier, "name": name, "versionInfo": version, "downloadLocation": source,
                "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION", **more}
    listed, hashes = [], []
    for i, each in enumerate(files_of(folder)):
        data = each.read_bytes()
        hashes.append(hashlib.sha1(data).hexdigest())
        listed.append({"SPDXID": f"SPDXRef-File-{i}", "fileName": "./" + str(each.relative_to(folder)),
                       "checksums": [{"algorithm": "SHA1", "checksumValue": hashes[-1]},
                                     {"algorithm": "SHA256", "checksumValue": hashlib.sha256(data).hexdigest()}],
                       "licenseConcluded": "Apache-2.0", "licenseInfoInFiles": ["NOASSERTION"], "copyrightText": "NOASSERTION"})
    code = hashlib.sha1("".join(sorted(hashes)).encode()).hexdigest()
    main = package("SPDXRef-Package", name, VERSION, "Apache-2.0", "NOASSERTION", supplier=SUPPLIER, filesAnalyzed=True,
                   packageVerificationCode={"packageVerificationCodeValue": code}, licenseInfoFromFiles=["NOASSERTION"])
    others = [package(f"SPDXRef-Holds-{i}", each[0], each[1], each[2], each[3], filesAnalyzed=False)
              for i, each in enumerate(holds)]
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", "SPDXRef-Package")]
    relations += [("SPDXRef-Package", "CONTAINS", each["SPDXID"]) for each in listed + others]
    return json.dumps({
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"{name}-{VERSION}",
        "documentNamespace": f"https://spdx.org/spdxdocs/{name}-{VERSION}-{code}",
        "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(when)),
                         "creators": ["Tool: wrc-packages-make.py"]},
        "packages": [main] + others, "files": listed,
        "relationships": [dict(zip(("spdxElementId", "relationshipType", "relatedSpdxElement"), each)) for each in relations],
    }, indent=1) + "\n"


def put(source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    if source.is_symlink():
        target.symlink_to(os.readlink(source))
    elif source.is_dir():
        shutil.copytree(source, target, symlinks=True, dirs_exist_ok=True)
    else:
        shutil.copyfile(source, target)
        target.chmod(0o755 if ".so." in target.name or target.suffix == ".dll" else 0o644)


def tidy(folder, when):
    """The same rights and times whatever the umask."""
    for each in [folder, *folder.rglob("*")]:
        if not each.is_symlink():
            each.chmod(0o755 if each.is_dir() or os.access(each, os.X_OK) else 0o644)
        os.utime(each, (when, when), follow_symlinks=False)


def tree(build, folder, windows, when):
    """The installed tree, its library without names that only a linker of static libraries wants."""
    run("cmake", "--install", build, "--prefix", folder)
    for library in (folder / f"bin/wrc-{SERIES}.dll", folder / f"lib/libwrc.so.{VERSION}"):
        if library.exists():
            run("x86_64-w64-mingw32-strip" if windows else "strip", "--strip-unneeded", library,
                env={**os.environ, "SOURCE_DATE_EPOCH": str(when)})  # of which a DLL bears a stamp
    return folder


def papers(folder, name, holds, when):
    """Licence, notices and the bill of materials."""
    put(ROOT / "LICENSE", folder / "LICENSE")
    put(ROOT / "docs/third_party.md", folder / "third_party.md")
    return lambda root: (folder / f"{name}.spdx.json").write_text(bill(root, name, holds, when))


def fmus(folder, build, mingw, scratch, out, holds, when):
    """The FMUs of the installed tree with Windows' library, where there is one, and the bill of materials; in `out`, too."""
    if not list(folder.glob("*.fmu")):
        return
    sys.path.insert(0, str(ROOT / "bindings/fmi"))
    import make_fmu
    make_fmu.build(argparse.Namespace(out=folder, linux=build / "bindings/fmi/wrc_fmu.so",
                                      windows=mingw and mingw / "bindings/fmi/wrc_fmu.dll"))
    os.environ["SOURCE_DATE_EPOCH"] = str(when)
    for file in sorted(folder.glob("*.fmu")):
        unpacked = scratch / file.stem
        with zipfile.ZipFile(file) as packed:
            packed.extractall(unpacked)
        (unpacked / "documentation" / f"{file.stem}.spdx.json").write_text(bill(unpacked, file.stem, holds, when))
        make_fmu.write(file, {str(each.relative_to(unpacked)): each.read_bytes() for each in files_of(unpacked)})
        put(file, out / file.name)


def debian(made, scratch, out, holds, when):
    """The Debian packages of an installed tree."""
    architecture = run("dpkg", "--print-architecture").strip()
    usr, fortran = pathlib.Path("usr"), "share/wrc/fortran"
    library, development, data, documents = f"libwrc{SERIES}", "libwrc-dev", "wrc-data", "wrc-doc"
    packages = {
        library: dict(architecture=architecture, section="libs", depends="libc6 (>= 2.17)", recommends=data,
                      tells=f"The shared library, interface {SERIES}. It needs libc and libm alone.",
                      files=[f"lib/libwrc.so.{SERIES}", f"lib/libwrc.so.{VERSION}"]),
        development: dict(architecture=architecture, section="libdevel", depends=f"{library} (= {VERSION}-1)", suggests=documents,
                          tells="Headers for C and C++, CMake package, pkg-config file, sources of the Fortran module.",
                          files=["include", "lib/libwrc.so", "lib/cmake", "lib/pkgconfig", fortran]),
        data: dict(architecture="all", section="science", tells="The force table, for WRC_TANGENTIAL_FORCE_TABLE.",
                   files=["share/wrc/force_table.bin"]),
        "wrc-fmu": dict(architecture=architecture, section="science", depends="python3",
                        tells="FMUs (FMI 2.0, 3.0) of a wheel and of a wheelset, and the program that puts profiles into them.",
                        files=["share/wrc/fmu"]),
        "python3-wrc": dict(architecture="all", section="python", depends=f"{library} (= {VERSION}-1), {data}, python3 (>= 3.9), python3-numpy",
                            recommends="python3-matplotlib", tells="The Python package, on the library of its own package.", files=[],
                            python=True),
        documents: dict(architecture="all", section="doc", tells="Manuals and examples.", files=["share/doc/wrc/docs", "share/doc/wrc/hosts"],
                        examples=True),
    }
    for name, package in packages.items():
        if not all((made / file).exists() for file in package["files"]):
            continue  # FMUs that were not built
        root = scratch / name
        for file in package["files"]:
            put(made / file, root / usr / file)
        if package.get("python"):
            put_python(root / usr / "lib/python3/dist-packages/wrc")
        place = root / usr / "share/doc" / name
        write_bill = papers(place, name, holds if name in (library, "wrc-fmu") else [], when)
        (place / "copyright").write_text(copyright())
        with gzip.GzipFile(place / "changelog.gz", "wb", 9, mtime=0) as changelog:
            changelog.write((ROOT / "CHANGELOG.md").read_bytes())
        if package.get("examples"):
            put_examples(place / "examples")
        write_bill(root)
        control(root, name, package, library)
        tidy(root, when)
        run("dpkg-deb", "--root-owner-group", "-Zxz", "-z3", "--build", root, out / f"{name}_{VERSION}-1_{package['architecture']}.deb",
            env={**os.environ, "SOURCE_DATE_EPOCH": str(when)})


def put_python(folder):
    """The Python package without the library, which it finds by a link."""
    for each in [*ROOT.glob("bindings/python/wrc/*.py"), ROOT / "bindings/python/wrc/py.typed"]:
        put(each, folder / each.name)
    (folder / "libwrc.so").symlink_to(f"../../../libwrc.so.{SERIES}")
    (folder / "force_table.bin").symlink_to("../../../../share/wrc/force_table.bin")


def put_examples(folder):
    for each in [*ROOT.glob("examples_c/*.c"), ROOT / "bindings/cpp/first_step.cpp", ROOT / "bindings/fortran/main_case.f90"]:
        put(each, folder / each.name)


def copyright():
    return ("Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: wrc\n\n"
            "Files: *\nCopyright: the authors of wrc\nLicense: Apache-2.0\n"
            " On Debian systems the text is in /usr/share/common-licenses/Apache-2.0.\n"
            "Comment: code of others in the library: third_party.md.\n")


def control(root, name, package, library):
    folder = root / "DEBIAN"
    folder.mkdir()
    size = sum((each.stat().st_size + 1023) // 1024 for each in files_of(root / "usr"))
    fields = {"Package": name, "Version": f"{VERSION}-1", "Architecture": package["architecture"], "Section": package["section"],
              "Priority": "optional", "Maintainer": os.environ.get("WRC_MAINTAINER", "wrc <wrc@localhost>"), "Installed-Size": size,
              **{field: package[field.lower()] for field in ("Depends", "Recommends", "Suggests") if field.lower() in package},
              "Description": f"{SUMMARY}\n {package['tells']}"}
    if package["architecture"] != "all":
        fields["Multi-Arch"] = "no"
    (folder / "control").write_text("".join(f"{field}: {value}\n" for field, value in fields.items()))
    sums = [f"{hashlib.md5(each.read_bytes()).hexdigest()}  {each.relative_to(root)}\n" for each in files_of(root / "usr")]
    (folder / "md5sums").write_text("".join(sums))
    if name == library:
        (folder / "shlibs").write_text(f"libwrc {SERIES} {library} (>= {VERSION})\n")
        (folder / "triggers").write_text("activate-noawait ldconfig\n")


def archive(folder, file, when):
    """A .tar.gz or .zip of one folder."""
    every = sorted([folder, *folder.rglob("*")], key=str)
    if file.name.endswith(".zip"):
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=6) as packed:
            for each in every:
                if each.is_file():
                    info = zipfile.ZipInfo(str(each.relative_to(folder.parent)), time.gmtime(when)[:6])
                    info.compress_type, info.external_attr = zipfile.ZIP_DEFLATED, 0o100644 << 16
                    packed.writestr(info, each.read_bytes())
        return
    held = io.BytesIO()
    with tarfile.open(fileobj=held, mode="w", format=tarfile.GNU_FORMAT) as packed:
        for each in every:
            info = packed.gettarinfo(each, str(each.relative_to(folder.parent)))
            info.uid = info.gid = 0
            info.uname = info.gname = "root"
            info.mtime = when
            with open(each, "rb") if info.isreg() else io.BytesIO() as data:
                packed.addfile(info, data if info.isreg() else None)
    with open(file, "wb") as bare, gzip.GzipFile("", "wb", 6, bare, mtime=0) as packed:
        packed.write(held.getvalue())


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("build", type=pathlib.Path)
    arguments.add_argument("out", type=pathlib.Path)
    arguments.add_argument("--mingw", type=pathlib.Path)
    arguments.add_argument("--windows", action="store_true")
    asked = arguments.parse_args()
    build, out, when = asked.build.resolve(), asked.out.resolve(), epoch()
    out.mkdir(parents=True, exist_ok=True)
    holds = [(RUN_TIME[0], compiler_version(build), *RUN_TIME[1:])]
    system = "windows-x86_64" if asked.windows else f"linux-{os.uname().machine}"
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        made = tree(build, scratch / f"wrc-{VERSION}-{system}", asked.windows, when)
        fmus(made / "share/wrc/fmu", build, asked.mingw, scratch, out, holds, when)
        if not asked.windows and shutil.which("dpkg-deb"):
            debian(made, scratch, out, holds, when)
        put_examples(made / "examples")
        papers(made, "wrc", holds, when)(made)
        tidy(made, when)
        archive(made, out / (made.name + (".zip" if asked.windows else ".tar.gz")), when)
    for each in sorted(out.iterdir()):
        print(f"{each.stat().st_size:9} bytes  {hashlib.sha256(each.read_bytes()).hexdigest()}  {each.name}")


if __name__ == "__main__":
    main()
