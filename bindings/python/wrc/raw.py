"""The C functions under their C names, as ctypes calls them: what the rest of the package is made of.

wrc.raw.wrc_contact_wrench(contact._handle, input, wrench) takes the package's structs, numpy arrays for pointers to numbers,
and gives the status. The headers' comments hold; nothing is checked here that C does not check.
"""
from __future__ import annotations

from ._interface import FUNCTIONS as _functions

globals().update(_functions)
__all__ = sorted(_functions)
