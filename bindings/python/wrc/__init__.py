"""Wheel/rail contact for simulation: the library wrc for Python.

    import wrc
    contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()
    result = contact.step(wrc.Input(load={"normal_force": 80e3}, creepage={"longitudinal": 1e-3}))
    print(result.forces)
    wrc.plot.contact(contact, "contact.png")

SI units throughout. Frames and signs: x forward, y to the right, z down; forces act on the wheel (help(wrc.Contact), wrc.h).
Model and Contact are the two things that own memory; all others are structs of the C interface: wrc.Input, wrc.Output, ...
Every member of a struct is told with its unit, range and default in the struct's docstring: help(wrc.Load).
"""
from . import _interface, _library
from ._interface import *  # noqa: F401,F403
from ._interface import ABI_VERSION, _wrc_build_info, _wrc_version
from ._library import Cancelled, Error
from .contact import Batch, Contact, Model, conicity, force_table, sweep, use
from .damage import Bins, flange_dimensions, flash_temperature, take_off, whole_life_damage
from . import damage, exact, plot, profiles, raw
from .profiles import ProfileError, ProfileFile, read_profile

_library.check_version(ABI_VERSION)
_version = _wrc_version()
__version__ = f"{_version >> 16}.{_version >> 8 & 255}.{_version & 255}"


def build_info() -> str:
    """Version, commit, compiler, flags, instruction set: for a question to support."""
    return str(_wrc_build_info().decode())


__all__ = [*_interface.__all__, "Batch", "Bins", "Cancelled", "Contact", "Error", "Model", "ProfileError", "ProfileFile", "build_info", "conicity", "damage",
           "exact", "flange_dimensions", "flash_temperature", "force_table", "plot", "profiles", "raw", "read_profile", "sweep", "take_off", "use",
           "whole_life_damage"]
