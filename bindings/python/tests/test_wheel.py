"""The source distribution has what a build needs; a wheel can be put under another platform's tag."""
import base64
import hashlib
import pathlib
import subprocess
import sys
import tarfile
import zipfile

import pytest

ROOT = pathlib.Path(__file__).parents[3]


def test_the_source_distribution_is_whole(tmp_path):
    """It configures by itself, outside the sources."""
    pytest.importorskip("scikit_build_core")
    code = f"import os; os.chdir({str(ROOT)!r}); from scikit_build_core import build; print(build.build_sdist({str(tmp_path)!r}))"
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True)
    with tarfile.open(next(tmp_path.glob("wrc-*.tar.gz"))) as archive:
        archive.extractall(tmp_path)
    folder = next(each for each in tmp_path.iterdir() if each.is_dir())
    names = {str(each.relative_to(folder)) for each in folder.rglob("*") if each.is_file()}
    sources = subprocess.run(["git", "-C", ROOT, "ls-files", "src", "include_c"], capture_output=True, text=True).stdout.split()
    assert set(sources) <= names and {"pyproject.toml", "bindings/python/wrc/py.typed", "bindings/python/wrc/_interface.pyi"} <= names
    assert not any(each.startswith(("tests/", "build/", "tools/")) for each in names)
    made = subprocess.run(["cmake", "-S", folder / "bindings/python", "-B", tmp_path / "build", "-DCMAKE_BUILD_TYPE=Release", "-DSKBUILD_METADATA_DIR=x"],
                          capture_output=True, text=True)
    assert made.returncode == 0, made.stderr


def test_a_wheel_under_another_tag(tmp_path):
    wheel = tmp_path / "wrc-0.9.0-py3-none-linux_x86_64.whl"
    with zipfile.ZipFile(wheel, "w") as file:
        file.writestr("wrc/a.py", "a = 1\n")
        file.writestr("wrc-0.9.0.dist-info/WHEEL", "Wheel-Version: 1.0\nTag: py3-none-linux_x86_64\n")
        file.writestr("wrc-0.9.0.dist-info/RECORD", "")
    subprocess.run([sys.executable, ROOT / "bindings/python/retag.py", wheel, tmp_path, "win_amd64"], check=True, capture_output=True)
    with zipfile.ZipFile(tmp_path / "wrc-0.9.0-py3-none-win_amd64.whl") as file:
        assert b"Tag: py3-none-win_amd64\n" in file.read("wrc-0.9.0.dist-info/WHEEL")
        for line in file.read("wrc-0.9.0.dist-info/RECORD").decode().split()[:2]:
            name, digest, size = line.split(",")
            content = file.read(name)
            assert digest == "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode() and int(size) == len(content)
