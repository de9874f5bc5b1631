"""Wheel/rail contact for simulation: the library wrc for Python.

    import wrc
    model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40})
    right, left = model.contact("RIGHT"), model.contact("LEFT")
    standing = right.wrench(wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=80e3)).z
    data = wrc.WheelInput(wheel={"z": standing, "velocity": (20, 0, 0), "pitch_rate": -20 / 0.46})
    for wheel in (right, left):
        print(wheel.wrench(data))
    wrc.plot.regions(right, "contact.png")

SI units throughout. Frames and signs: x forward, y to the right, z down; forces act on the wheel (help(wrc.Contact), wrc.h).
Model and Contact are the two things that own memory; all others are structs of the C interface: wrc.WheelInput, wrc.Wrench, ...
Every member of a struct has its unit, range and default in the struct's docstring: help(wrc.WheelState).
"""
from typing import Any as _Any

from . import _interface, _library, _renamed
from ._interface import *  # noqa: F401,F403
from ._interface import ABI_VERSION, EXPERIMENTAL_VERSION, _wrc_build_info, _wrc_version
from ._library import Cancelled, Error
from .contact import Batch, Contact, Model, force_table, frictions, methods, presets, sweep, use
from .creep import CreepCurveFit, fit_creep_curve
from .damage import Bins, flash_temperature, whole_life_damage
from . import damage, exact, plot, profiles, raw, sections, shapes
from .profiles import ProfileError, ProfileFile, ProfileWarning, cone, conicity, flange_dimensions, read_profile, remove_wear
from .shapes import shape
from .sections import Face, MeasuredSection, RailFaces, SectionError, rail_faces, read_sections, write_sections
from .surface import Band, surface_friction, surface_laws, surface_pass
from .tables import to_frame

_library.check_version(ABI_VERSION, EXPERIMENTAL_VERSION)
_version = _wrc_version()
__version__ = f"{_version >> 16}.{_version >> 8 & 255}.{_version & 255}"
_renamed.mark(globals())


def build_info() -> str:
    """Version, commit, compiler, flags, instruction set: for a question to support."""
    return str(_wrc_build_info().decode())


def __getattr__(name: str) -> _Any:
    now = _renamed.since("", name)
    raise AttributeError(f"wrc has no {name}" + (f": {now}" if now else ""))


__all__ = [*_interface.__all__, "Band", "Batch", "Bins", "Cancelled", "Contact", "CreepCurveFit", "Error", "Face", "MeasuredSection", "Model", "ProfileError",
           "ProfileFile", "ProfileWarning", "RailFaces", "SectionError", "build_info", "cone", "conicity", "damage", "exact", "fit_creep_curve", "flange_dimensions",
           "flash_temperature", "force_table", "frictions", "methods", "plot", "presets", "profiles", "rail_faces", "raw", "read_profile",
           "read_sections", "remove_wear", "sections", "shape", "shapes", "surface_friction", "surface_laws",
           "surface_pass", "sweep", "to_frame", "use", "whole_life_damage", "write_sections"]
