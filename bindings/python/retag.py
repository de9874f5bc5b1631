#!/usr/bin/env python3
"""Puts a wheel into a folder under another platform tag: its name, and the line of its metadata. Without a tag as it is.

    retag.py WHEEL FOLDER [PLATFORM]"""
import base64
import hashlib
import pathlib
import re
import sys
import zipfile


def retag(wheel, folder, platform):
    name = "-".join([*wheel.stem.split("-")[:-1], platform]) + ".whl" if platform else wheel.name
    with zipfile.ZipFile(wheel) as source, zipfile.ZipFile(folder / name, "w") as target:
        records = []
        for each in source.infolist():
            content = source.read(each)
            if platform and each.filename.endswith(".dist-info/WHEEL"):
                content = re.sub(rb"^(Tag: [^-]+-[^-]+-).*$", rb"\g<1>" + platform.encode(), content, flags=re.M)
            if each.filename.endswith(".dist-info/RECORD"):
                record = each
                continue
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            records.append(f"{each.filename},sha256={digest},{len(content)}")
            target.writestr(each, content)
        target.writestr(record, "\n".join([*records, f"{record.filename},,", ""]))
    return folder / name


if __name__ == "__main__":
    print(retag(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3] if len(sys.argv) > 3 else ""), file=sys.stderr)
