"""The library's table of fields: what wrc_contact_field() shows, from the comments of enum wrc_field_id."""
import re

import headers

GRIDS = {"cells": "cells", "strips": "strips", "gap rows": "gap_rows"}
WITHOUT_CALL = {"cells": "tangential", "strips": "patch", "gap_rows": "gap"}  # the stage, where no call is named


def written(interface, mark):
    """{path in the tree: text}"""
    rows = [row(i, each) for i, each in enumerate(interface.enumerations["wrc_field_id"].values)]
    return {"src/contact/generated/fields.inc": "\n".join([f"// {mark}", "// clang-format off"] + rows) + "\n"}


def row(i, each):
    told = re.match(r"(?P<grid>[a-z ]+): [^;]+(; needs wrc_contact_(?P<call>tangential|damage|wear|temperature))?$", each.comment)
    if told is None or told["grid"] not in GRIDS:
        raise headers.Refused(f"{each.name}: a field's comment is 'cells: ...', 'strips: ...' or 'gap rows: ...', "
                              "then perhaps '; needs wrc_planar_tangential', '_damage', '_wear' or '_temperature'")
    if each.value != i:
        raise headers.Refused(f"{each.name}: fields are numbered from 0 in their order")
    grid = GRIDS[told["grid"]]
    return f"WRC_FIELD_ROW({each.name[len('WRC_FIELD_'):].lower()}, {grid}, {told['call'] or WITHOUT_CALL[grid]})"
