"""A library with the interface of some headers and nothing in it, in C: for libabigail, which reads types from debug
information.     stub.py INCLUDE"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tools/interface"))
import headers  # noqa: E402  (found there)

print('#include "wrc/wrc_api.h"\n#include "wrc/wrc_experimental_api.h"')
for each in headers.parse(headers.libclang(), sys.argv[1]).functions.values():
    if each.exported:
        arguments = ", ".join(type.spelling for _, type in each.arguments) or "void"
        print(f"{each.returned.spelling} {each.name}({arguments}) {{ __builtin_unreachable(); }}")
