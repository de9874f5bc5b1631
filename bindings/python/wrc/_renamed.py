"""Names of 0.2, and what took their place in 0.9: what an AttributeError says. docs/interface_0_9.md has the reasons."""
from __future__ import annotations

from typing import Any, Dict, List

# "Owner.name"; names of the package itself have no owner, enumerators stand behind their new enumeration.
NAMES = {
    "Input": "wrc.PlanarInput", "Output": "wrc.PlanarOutput", "Pose": "wrc.PlanarPose", "Motion": "wrc.PlanarMotion",
    "Load": "wrc.PlanarLoad", "Gap": "wrc.PlanarGap", "Strips": "wrc.PlanarStrips", "Forces": "wrc.PlanarForces",
    "NormalSolution": "wrc.PlanarNormalSolution", "ContactPoint": "wrc.PlanarPoint", "Sensitivity": "wrc.PlanarDerivatives",
    "StepSensitivity": "gone: take differences of Contact.planar_step()", "WrenchSensitivities": "wrc.WrenchDerivatives",
    "Patch": "wrc.Region", "ConfigMaterial": "wrc.Material, one for each body", "Materials": "wrc.Material, one for each body",
    "ConfigGrid": "wrc.ConfigPlanar, and wrc.ConfigSurface of a wheel", "FieldId": "wrc.Field", "RegionField": "wrc.Field",
    "FrictionKind": "wrc.FrictionSpeedLaw and wrc.FrictionTemperatureLaw", "WheelPrescribed": "wrc.Prescribed", "WheelStart": "wrc.Start",
    "DamageSource": "gone: the contact's last solution counts", "ContactFunctions": "wrc.WheelsetGeometry",
    "ContactFunctionsProblem": "wrc.WheelsetGeometryProblem", "take_off": "wrc.remove_wear",
    "Contact.step": "planar_step", "Contact.geometry": "planar_geometry", "Contact.creepages": "planar_creepages",
    "Contact.normal": "planar_normal", "Contact.regularise": "planar_regularise", "Contact.tangential": "planar_tangential",
    "Contact.roll": "planar_roll", "Contact.sensitivities": "planar_tangential_derivatives",
    "Contact.step_sensitivities": "gone: take differences of planar_step()", "Contact.wrench_sensitivities": "wrench_derivatives",
    "Contact.patch": "region", "Contact.patches": "regions", "Contact.region_field": "field", "Contact.region_fields": "fields",
    "Contact.region_ellipse": "region(index).ellipse", "Contact.region_damage": "damage(index)",
    "Contact.region_temperature": "temperature(index)", "Model.contact_functions": "wheelset_geometry",
    "Batch.step": "gone: call Contact.planar_step() of each, or wrc.sweep()",
    "Config.material": "wheel_material and rail_material", "Config.grid": "planar, and surface of a wheel",
    "Config.non_steady": "planar.non_steady", "Config.rail_section": "rail_sections",
    "ConfigWheelset.flange_back_distance": "tape_circle_distance, which is 0.14 m more",
    "ConfigNormal.max_sweeps": "config.planar.max_sweeps", "ConfigNormal.warm_start": "config.planar.start",
    "ConfigTangential.regularisation": "config.planar.regularisation", "ConfigRoundness.rows": "row_count",
    "ConfigRoundness.angle": "angles", "ConfigRoundness.deviation": "deviations", "RailSection.face": "surface", "RailSection.mark": "marks",
    "Creepage.other_way": "reverse_share", "Friction.kind": "speed_law and temperature_law, which may be combined",
    "Friction.zone_coefficient": "zone_coefficients", "Friction.zones": "zone_count", "PlanarGap.rows": "row_count",
    "PlanarGap.columns": "column_count", "PlanarNormalSolution.patches": "patch_count", "PlanarNormalSolution.strips": "strip_count",
    "RailState.roll_velocity": "roll_rate", "WheelInput.roller_velocity": "roller_rate", "Wrench.regions": "region_count",
    "Wrench.leaps": "wrc.Flags.FORCE_JUMPS in flags", "Region.strips": "strip_count", "Region.cells": "cell_count", "Region.face": "surface",
    "Region.forces": "longitudinal_force, lateral_force, normal_force, spin_moment", "DamageBins.rows": "row_count",
    "DamageBins.bin": "bins", "Accumulation.source": "gone: the contact's last solution counts",
    "ExactNormalProblem.materials": "wheel_material and rail_material", "ExactRollingProblem.materials": "wheel_material and rail_material",
    "ConicityProblem.amplitude": "amplitudes", "ProfileWear.bins": "bin_count",
    "Prescribed.LOAD": "NORMAL_FORCE, of a wheel VERTICAL_LOAD", "Start.ANEW": "COLD", "Start.FROM_LAST": "WARM", "Field.TRACTION_S": "TRACTION_Y",
    "Field.SLIP_S": "SLIP_Y", "Field.STRIP_S": "STRIP_Y", "Field.STRIP_Z": "STRIP_PROFILE_Z", "Field.STRIP_HALF": "STRIP_HALF_LENGTH",
    "FrictionSpeedLaw.FALLING": "EXPONENTIAL", "FrictionSpeedLaw.STATIC_KINETIC": "HYPERBOLIC",
    "WrenchInput.RAIL_ROLL_VELOCITY": "RAIL_ROLL_RATE", "TangentialMethod.COARSE_HALFSPACE": "gone",
}


def since(owner: str, name: str) -> str:
    """What became of a name: "since 0.9 it is ...", or nothing."""
    now = NAMES.get(f"{owner}.{name}" if owner else name)
    return "" if now is None else f"since 0.9 it is {now}"


class Renamed:
    """Stands for an old name on a class."""

    def __init__(self, owner: str, name: str):
        self.text = f"{owner} has no {name}: {since(owner, name)}"

    def __get__(self, owner: Any, _: Any = None) -> Any:
        if owner is None:
            return self
        raise AttributeError(self.text)

    def __set__(self, owner: Any, value: Any) -> None:
        raise AttributeError(self.text)


def current(owner: Any) -> List[str]:
    """dir() without old names."""
    return [each for each in object.__dir__(owner) if not isinstance(getattr(type(owner), each, None), Renamed)]


def mark(namespace: Dict[str, Any]) -> None:
    """Puts the old names onto the classes of a namespace; enumerations are told by _struct.Choice."""
    for each in NAMES:
        owner, _, name = each.rpartition(".")
        if owner and not name.isupper():
            setattr(namespace[owner], name, Renamed(owner, name))
