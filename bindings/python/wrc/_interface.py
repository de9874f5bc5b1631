"""Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit.

The whole C interface: enumerations, structs, functions. Import from wrc, not from here.
"""
# fmt: off
from __future__ import annotations

import ctypes as c
import enum
from typing import Any, Callable, Optional, Sequence, Tuple

import numpy as np

from . import _library as _l
from . import _struct as s

VERSION_MAJOR = 0
VERSION_MINOR = 9
VERSION_PATCH = 0
ABI_VERSION = 900
EXPERIMENTAL_VERSION = 1
WRENCH_INPUTS = 24
ALL_REGIONS = -1
DAMAGE_SUMS = 8
CREEP_PARAMETERS = 10
SURFACE_QUANTITIES = 6
MOST_FILM_ROWS = 16
SURFACE_BOOKS = 6


class Status(s.Choice):
    """What a call returns: 0 done, > 0 done but flagged, < 0 failed."""

    OK = 0, 'done'
    FLAG_NO_CONTACT = 1, 'the bodies do not touch: all forces are zero'
    FLAG_ITERATION_CAP = 2, 'an iteration reached its cap: the last iterate is returned'
    FLAG_PATCH_AT_EDGE = 3, 'the patch reaches the edge of the given gap, profile or surface'
    FLAG_MORE_PATCHES = 4, 'more contact patches exist than the configuration has room for'
    FLAG_TABLE_RANGE = 5, 'the patch is more slender than the coefficient tables: their end is used'
    FLAG_CREEPAGES_LIMITED = 6, 'nearly at rest, or sliding far faster than rolling: creepages are limited'
    FLAG_LOAD_JUMPS = 7, 'no approach of this normal method carries the load: its force jumps past it there'
    FLAG_BEYOND_GAP = 8, 'beyond what the gap or the profiles carry: continued with the last stiffness'
    FLAG_CLIMBING = 9, 'friction on a steep face lets no height carry the load, or several'
    FLAG_BEYOND_SECTIONS = 10, 'the rail has no section that far along the track: the nearest is used'
    FLAG_DISSIMILAR_MATERIALS = 11, "different materials: of Kalker's K only the leading part is taken, or none: theory manual, section 4"
    FLAG_SUM_OVERFLOW = 12, 'a sum of bins passed its range: what they hold is worthless'
    FLAG_FORCE_JUMPS = 13, 'a planar normal method on a patch of several lowest points: forces jump where the lowest changes'
    FLAG_ROTATION_TRANSPOSED = 14, 'the angular velocity lies along the axle of the transposed rotation: was its transpose given?'
    FLAG_MEMORY_DROPPED = 15, 'the wheel was put elsewhere since the committed step: it begins without tractions'
    ERROR_NULL = -1, 'a required pointer is NULL'
    ERROR_STRUCT_SIZE = -2, 'struct_size is wrong, or a member newer than the library is set'
    ERROR_NOT_FINITE = -3, 'a value is NaN or infinite'
    ERROR_RANGE = -4, 'a value lies outside its allowed range'
    ERROR_PROFILE = -5, 'a profile cannot be used'
    ERROR_GAP = -6, 'the undeformed gap cannot be used'
    ERROR_LOAD = -7, 'gap or profiles cannot carry the prescribed load or approach'
    ERROR_BUFFER = -8, 'the memory handed over is too small or misaligned'
    ERROR_MEMORY = -9, 'memory could not be allocated'
    ERROR_SEQUENCE = -10, 'a call came before the one whose result it needs'
    ERROR_UNSUPPORTED = -11, 'the requested method, version or combination does not exist'
    ERROR_FILE = -12, 'a file cannot be read or written'
    ERROR_CANCELLED = -13, 'the caller cancelled the work'
    ERROR_INTERNAL = -14, 'internal error: please report it'


STATUS_TEXTS = {int(each): each.__doc__ for each in Status}
PRESETS = ('FASTSIM', 'FASTSIM-EQ.E', 'FASTSIM-EQ.L', 'FASTSIM-SDEC', 'strip FASTSIM', 'KBTNH-type table', 'modified FASTSIM', 'FaStrip', 'modified FaStrip', 'FaStrip-SDEC', 'Polach')
FRICTIONS = {'Polach dry': ('Polach, Wear 258 (2005)', 'quoted from memory, not read again; not compared with his measurements'), 'Polach wet': ('Polach, Wear 258 (2005)', 'quoted from memory, not read again; not compared with his measurements'), 'magnetite': ('Hou, Kalousek, Magel, Wear 211 (1997)', "numbers of CONTACT's example plastic_3bl, whose creep curves are met; unconfirmed of a rail in service"), 'clay': ('Hou, Kalousek, Magel, Wear 211 (1997)', "numbers of CONTACT's example plastic_3bl, whose creep curves are met; unconfirmed of a rail in service"), 'sand': ('Hou, Kalousek, Magel, Wear 211 (1997)', "numbers of CONTACT's example plastic_3bl, whose creep curves are met; unconfirmed of a rail in service"), 'MoS2': ('Hou, Kalousek, Magel, Wear 211 (1997)', "numbers of CONTACT's example plastic_3bl, whose creep curves are met; unconfirmed of a rail in service"), 'locomotive': ("CONTACT's example tractcurv, second series: a locomotive's measured curve", 'its creep curve in CONTACT at 10 m/s is met: 0.31 at 1.6 %, 0.19 at 25 % slip; the measurement was not seen')}


class Flags(enum.IntFlag):
    """The flags of a result, a bit for each that was met: wrc.Flags.NO_CONTACT in wrench.flags.

    NO_CONTACT: the bodies do not touch: all forces are zero
    ITERATION_CAP: an iteration reached its cap: the last iterate is returned
    PATCH_AT_EDGE: the patch reaches the edge of the given gap, profile or surface
    MORE_PATCHES: more contact patches exist than the configuration has room for
    TABLE_RANGE: the patch is more slender than the coefficient tables: their end is used
    CREEPAGES_LIMITED: nearly at rest, or sliding far faster than rolling: creepages are limited
    LOAD_JUMPS: no approach of this normal method carries the load: its force jumps past it there
    BEYOND_GAP: beyond what the gap or the profiles carry: continued with the last stiffness
    CLIMBING: friction on a steep face lets no height carry the load, or several
    BEYOND_SECTIONS: the rail has no section that far along the track: the nearest is used
    DISSIMILAR_MATERIALS: different materials: of Kalker's K only the leading part is taken, or none: theory
        manual, section 4
    SUM_OVERFLOW: a sum of bins passed its range: what they hold is worthless
    FORCE_JUMPS: a planar normal method on a patch of several lowest points: forces jump where the lowest
        changes
    ROTATION_TRANSPOSED: the angular velocity lies along the axle of the transposed rotation: was its
        transpose given?
    MEMORY_DROPPED: the wheel was put elsewhere since the committed step: it begins without tractions
    """

    NO_CONTACT = 1 << 1
    ITERATION_CAP = 1 << 2
    PATCH_AT_EDGE = 1 << 3
    MORE_PATCHES = 1 << 4
    TABLE_RANGE = 1 << 5
    CREEPAGES_LIMITED = 1 << 6
    LOAD_JUMPS = 1 << 7
    BEYOND_GAP = 1 << 8
    CLIMBING = 1 << 9
    BEYOND_SECTIONS = 1 << 10
    DISSIMILAR_MATERIALS = 1 << 11
    SUM_OVERFLOW = 1 << 12
    FORCE_JUMPS = 1 << 13
    ROTATION_TRANSPOSED = 1 << 14
    MEMORY_DROPPED = 1 << 15


class NormalMethod(s.Choice):
    """Method of the normal problem.

    HERTZ: one ellipse; lateral curvature from the chord of the gap at half the approach
    KIK_PIOTROWSKI: Kik and Piotrowski, VSD 46 (2008)
    EKP: extended Kik-Piotrowski, after VSD 54 (2016): yaw, lateral curvature
    EKP_ELLIPSE: threshold varying over y, every region of overlap: CONTACT's KPEC, to 0.02 %
    ANALYN: ANALYN in the modified form, after VSD 52 (2014); unconfirmed
    STRIPES: STRIPES, semi-Hertzian, after VSD 43 (2005); unconfirmed
    STRIP_HALFSPACE: strips of own peak and length in half-space equilibrium; several patches
    """

    HERTZ = 0, 'one ellipse; lateral curvature from the chord of the gap at half the approach'
    KIK_PIOTROWSKI = 1, 'Kik and Piotrowski, VSD 46 (2008)'
    EKP = 2, 'extended Kik-Piotrowski, after VSD 54 (2016): yaw, lateral curvature'
    EKP_ELLIPSE = 3, "threshold varying over y, every region of overlap: CONTACT's KPEC, to 0.02 %"
    ANALYN = 4, 'ANALYN in the modified form, after VSD 52 (2014); unconfirmed'
    STRIPES = 5, 'STRIPES, semi-Hertzian, after VSD 43 (2005); unconfirmed'
    STRIP_HALFSPACE = 6, 'strips of own peak and length in half-space equilibrium; several patches'


class TangentialMethod(s.Choice):
    """Method of the tangential problem. All but FASTSIM have the bound friction * pressure.

    FASTSIM: FASTSIM, Kalker 1982, marched in second order, with patch_model, bound and flexibility of
        config.tangential; modified FASTSIM where friction.slope_fall > 0
    FASTRIP: FaStrip, VSD 54 (2016), with config.tangential.patch_model: strip theory where it sticks,
        FASTSIM's directions where it slips
    STRIP_FASTSIM: FASTSIM in the shape of strip theory on the patch as it is, calibrated on exact solutions
    FORCE_TABLE: total forces from config.tangential.force_table, exact solutions for double ellipses: no
        tractions, no slip, and no results that need them
    POLACH: Polach's force law on the equivalent ellipse, with friction.adhesion_reduction and slip_reduction:
        total forces, no tractions and no slip
    """

    FASTSIM = 0, 'FASTSIM, Kalker 1982, marched in second order, with patch_model, bound and flexibility of config.tangential; modified FASTSIM where friction.slope_fall > 0'
    FASTRIP = 1, "FaStrip, VSD 54 (2016), with config.tangential.patch_model: strip theory where it sticks, FASTSIM's directions where it slips"
    STRIP_FASTSIM = 2, 'FASTSIM in the shape of strip theory on the patch as it is, calibrated on exact solutions'
    FORCE_TABLE = 3, 'total forces from config.tangential.force_table, exact solutions for double ellipses: no tractions, no slip, and no results that need them'
    POLACH = 4, "Polach's force law on the equivalent ellipse, with friction.adhesion_reduction and slip_reduction: total forces, no tractions and no slip"


class PatchModel(s.Choice):
    """Patch of FASTSIM and FaStrip: the strips that carry tractions, and the shape whose coefficients of linear
        theory they have. The ellipse has the semi-axes of the equivalent double ellipse, a and b of Ellipse.

    PATCH_SDEC: the patch; coefficients of its equivalent double ellipse
    PATCH_ELLIPSE: the patch; coefficients of the equivalent ellipse
    ELLIPSE_AT_MIDDLE: the equivalent ellipse about mid-width, creepage corrected for the shift
    ELLIPSE_AT_POINT: the equivalent ellipse about the contact point: no psi
    """

    PATCH_SDEC = 0, 'the patch; coefficients of its equivalent double ellipse'
    PATCH_ELLIPSE = 1, 'the patch; coefficients of the equivalent ellipse'
    ELLIPSE_AT_MIDDLE = 2, 'the equivalent ellipse about mid-width, creepage corrected for the shift'
    ELLIPSE_AT_POINT = 3, 'the equivalent ellipse about the contact point: no psi'


class Regularisation(s.Choice):
    """Criteria by which a patch gets its equivalent double ellipse.

    WIDTH: criteria (1), (2b), (3): area and width kept; the paper's choice
    RATIO: criteria (1), (2), (3): area and length/width ratio kept (KBTNH)
    """

    WIDTH = 0, "criteria (1), (2b), (3): area and width kept; the paper's choice"
    RATIO = 1, 'criteria (1), (2), (3): area and length/width ratio kept (KBTNH)'


class TractionBound(s.Choice):
    """Form of the traction bound along a strip. Over the patch each integrates to friction * load where friction
        is uniform.

    PARABOLIC: paper eq. 9: right slope at the leading edge
    ELLIPTIC: friction * pressure: the actual pressure of each strip
    ELLIPSOIDAL: friction * load spread as sqrt(x_l^2 - x^2): the pressure of a Kik-Piotrowski patch. On
        double ellipses the same as ELLIPTIC
    """

    PARABOLIC = 0, 'paper eq. 9: right slope at the leading edge'
    ELLIPTIC = 1, 'friction * pressure: the actual pressure of each strip'
    ELLIPSOIDAL = 2, 'friction * load spread as sqrt(x_l^2 - x^2): the pressure of a Kik-Piotrowski patch. On double ellipses the same as ELLIPTIC'


class Flexibility(s.Choice):
    """How the flexibilities of linear theory enter FASTSIM.

    SEPARATE: one for each force of linear theory: right for small creepage
    SINGLE: Kalker's weighted sum for all: right traction directions at large creepage
    BLENDED: from the first to the second as creepage grows; Vollebregt and Voltr, VSD 61 (2023)
    """

    SEPARATE = 0, 'one for each force of linear theory: right for small creepage'
    SINGLE = 1, "Kalker's weighted sum for all: right traction directions at large creepage"
    BLENDED = 2, 'from the first to the second as creepage grows; Vollebregt and Voltr, VSD 61 (2023)'


class Side(s.Choice):
    """Which wheel of the wheelset.

    RIGHT: flange at y < 0
    LEFT: flange at y > 0; frames and signs stay those of the right wheel
    """

    RIGHT = 0, 'flange at y < 0'
    LEFT = 1, 'flange at y > 0; frames and signs stay those of the right wheel'


class Body(s.Choice):
    """Which of the two bodies.

    WHEEL: the wheel
    RAIL: the rail
    """

    WHEEL = 0, 'the wheel'
    RAIL = 1, 'the rail'


class ProfileKind(s.Choice):
    """Where a profile comes from.

    NONE: no profile. A model without both has planar gaps only
    POINTS: points y, z of the caller, joined by a cubic spline
    S1002: wheel, EN 13715, from its analytic definition
    PROFILE_60E1: rail, nominal head (R300/R80/R13), not canted: set rail_inclination, e.g. 1/40
    UIC60_BENCHMARK: rail of the Manchester benchmark, canted 1:40 already
    """

    NONE = 0, 'no profile. A model without both has planar gaps only'
    POINTS = 1, 'points y, z of the caller, joined by a cubic spline'
    S1002 = 2, 'wheel, EN 13715, from its analytic definition'
    PROFILE_60E1 = 3, 'rail, nominal head (R300/R80/R13), not canted: set rail_inclination, e.g. 1/40'
    UIC60_BENCHMARK = 4, 'rail of the Manchester benchmark, canted 1:40 already'


class ProfilePlacement(s.Choice):
    """Where profiles lie.

    GAUGE: rails by track.gauge and track.gauge_depth, tops at z = 0: new profiles
    ORIGIN: rails by the origin of their points, at y = track.rail_origin, z = 0. Inclination turns about it.
        A worn rail stays where the new one was
    """

    GAUGE = 0, 'rails by track.gauge and track.gauge_depth, tops at z = 0: new profiles'
    ORIGIN = 1, 'rails by the origin of their points, at y = track.rail_origin, z = 0. Inclination turns about it. A worn rail stays where the new one was'


class InstructionSet(s.Choice):
    """Instruction set of the kernels. Results are the same bits with all of them.

    BEST: the widest that this processor has
    BASELINE: what every processor of the architecture has: SSE2, NEON
    AVX2: x86-64 with AVX2
    AVX512: x86-64 with AVX-512 F, DQ, VL
    """

    BEST = 0, 'the widest that this processor has'
    BASELINE = 1, 'what every processor of the architecture has: SSE2, NEON'
    AVX2 = 2, 'x86-64 with AVX2'
    AVX512 = 3, 'x86-64 with AVX-512 F, DQ, VL'


class FrictionSpeedLaw(s.Choice):
    """How friction falls with the sliding speed w of a strip: the root mean square of its rigid slip times the
        rolling speed.

    NONE: factor 1
    EXPONENTIAL: factor (1 - kinetic_ratio) exp(-fall_rate w) + kinetic_ratio: Polach
    HYPERBOLIC: factor kinetic_ratio + (1 - kinetic_ratio) / (1 + w / half_speed): static to kinetic
    """

    NONE = 0, 'factor 1'
    EXPONENTIAL = 1, 'factor (1 - kinetic_ratio) exp(-fall_rate w) + kinetic_ratio: Polach'
    HYPERBOLIC = 2, 'factor kinetic_ratio + (1 - kinetic_ratio) / (1 + w / half_speed): static to kinetic'


class FrictionTemperatureLaw(s.Choice):
    """How friction falls with the temperature of the surfaces.

    NONE: factor 1
    LINEAR: factor 1 up to cold_temperature, hot_ratio from hot_temperature on, linear between. A strip has
        the mean over its load. Not with a method that gives forces alone
    """

    NONE = 0, 'factor 1'
    LINEAR = 1, 'factor 1 up to cold_temperature, hot_ratio from hot_temperature on, linear between. A strip has the mean over its load. Not with a method that gives forces alone'


class ZoneFrame(s.Choice):
    """Where the y of friction zones counts from.

    CONTACT_FRAME: contact frame, of wrc_planar.h alone: zones move with the contact point
    RAIL_PROFILE: rail profile, field side > 0: zones stay on the rail
    WHEEL_PROFILE: wheel profile, flange side < 0: zones stay on the wheel, as a lubricated flange
    """

    CONTACT_FRAME = 0, 'contact frame, of wrc_planar.h alone: zones move with the contact point'
    RAIL_PROFILE = 1, 'rail profile, field side > 0: zones stay on the rail'
    WHEEL_PROFILE = 2, 'wheel profile, flange side < 0: zones stay on the wheel, as a lubricated flange'


class WheelReference(s.Choice):
    """Which point of the rotating body the pose, the velocity and the moment refer to.

    WHEELSET: O, the middle of the axle
    WHEEL: W, where the plane of the tape circle meets the axle: independent wheels, elastic axles
    """

    WHEELSET = 0, 'O, the middle of the axle'
    WHEEL = 1, 'W, where the plane of the tape circle meets the axle: independent wheels, elastic axles'


class Orientation(s.Choice):
    """How an orientation is given.

    ANGLES: by roll and yaw
    ROWS: by rotation row by row, as C and numpy store a matrix: track = R body, y body is the axle
    COLUMNS: by rotation column by column, as Fortran, MATLAB and Eigen store the same matrix
    """

    ANGLES = 0, 'by roll and yaw'
    ROWS = 1, 'by rotation row by row, as C and numpy store a matrix: track = R body, y body is the axle'
    COLUMNS = 2, 'by rotation column by column, as Fortran, MATLAB and Eigen store the same matrix'


class Axes(s.Choice):
    """How an angular velocity is given.

    NONE: by roll_rate, pitch_rate, yaw_rate; angular_velocity must be 0
    TRACK: by angular_velocity along the track's axes: a yawed axle then has an x component, too
    BODY: by angular_velocity along the axes of the body without its pitch: y is about the axle
    """

    NONE = 0, 'by roll_rate, pitch_rate, yaw_rate; angular_velocity must be 0'
    TRACK = 1, "by angular_velocity along the track's axes: a yawed axle then has an x component, too"
    BODY = 2, 'by angular_velocity along the axes of the body without its pitch: y is about the axle'


class Prescribed(s.Choice):
    """Which of height, load and approach is given; the others are results.

    HEIGHT: wheel: its z. The choice of a dynamic simulation
    VERTICAL_LOAD: wheel: vertical_load; z of the reference point is found
    NORMAL_FORCE: contact plane: normal_force along the contact normal
    APPROACH: contact plane: approach of the bodies. The choice near lift-off
    """

    HEIGHT = 0, 'wheel: its z. The choice of a dynamic simulation'
    VERTICAL_LOAD = 1, 'wheel: vertical_load; z of the reference point is found'
    NORMAL_FORCE = 2, 'contact plane: normal_force along the contact normal'
    APPROACH = 3, 'contact plane: approach of the bodies. The choice near lift-off'


class Start(s.Choice):
    """Where iterations begin.

    COLD: from nothing: results depend on the inputs of the call alone, to the last bit. Nothing needs saving
    WARM: from the contact's last solution. Results depend on earlier calls, within the tolerance. For
        explicit integrators and fixed steps, not for implicit ones
    MARK: of Contact.wrench() alone: from the solution that Contact.mark() marked; cold before the first mark.
        Results depend on that mark and the inputs of the call alone, to the last bit. For every integrator
        that accepts its steps
    """

    COLD = 0, 'from nothing: results depend on the inputs of the call alone, to the last bit. Nothing needs saving'
    WARM = 1, "from the contact's last solution. Results depend on earlier calls, within the tolerance. For explicit integrators and fixed steps, not for implicit ones"
    MARK = 2, 'of Contact.wrench() alone: from the solution that Contact.mark() marked; cold before the first mark. Results depend on that mark and the inputs of the call alone, to the last bit. For every integrator that accepts its steps'


class Available(enum.IntFlag):
    """Optional parts of a result.

    TRACTIONS: results that need tractions and slip: not with a method that gives forces alone
    PLACE: places in the track frame: not with a gap, strips or an ellipse of the caller
    """

    TRACTIONS = 1
    PLACE = 2


class Field(s.Choice):
    """Fields of a region: one value per cell or per strip. A wheel's strips lie side by side along the rail's
        arc, from the gauge side to the field side. Those of a contact plane lie by increasing y. Cells divide
        a strip; cell 0 is at its leading edge.

    X: cells: x of the middle. Wheel: from its reference point; plane: contact frame [m]
    PRESSURE: cells: normal pressure in the middle [Pa]
    TRACTION_X: cells: tangential traction on the wheel along x [Pa]
    TRACTION_Y: cells: the same along the rail's arc, or along y of the contact plane [Pa]
    SLIP_X: cells: sliding velocity of the wheel over the rail / rolling speed, along x [-]
    SLIP_Y: cells: the same along the rail's arc, or along y of the contact plane [-]
    POWER_DENSITY: cells: frictional power per area, paper eq. 10 [W/m^2]
    FATIGUE_INDEX: cells: local surface fatigue index, paper eq. 12 [-]
    TEMPERATURE_RISE: cells: temperature rise of both surfaces by friction, from that at first touch [K]
    STRIP_Y: strips: middle. Wheel: arc length from the gauge end of the rail's profile; plane: y [m]
    STRIP_WIDTH: strips: width [m]
    STRIP_CENTRE: strips: x of the middle, as Field.X [m]
    STRIP_HALF_LENGTH: strips: half length [m]
    STRIP_PEAK: strips: peak pressure, damping included [Pa]
    STRIP_POWER: strips: frictional power per width [W/m]
    STRIP_FRICTION: strips: coefficient of friction that the law gave [-]
    STRIP_WEAR: strips: volume lost per metre rolled and per width, Sheffield's law [m]
    STRIP_PROFILE_Y: strips of a wheel: the middle in the coordinates of the rail's profile [m]
    STRIP_PROFILE_Z: strips of a wheel: the same, down [m]
    STRIP_ANGLE: strips of a wheel: of the rail's surface about x there; < 0 on the gauge side [rad]
    GAP_Y: rows of a planar gap: y [m]
    GAP_HEIGHT: rows of a planar gap: smallest gap of the row [m]
    GAP_CENTRE: rows of a planar gap: x of that smallest gap [m]
    GAP_CURVATURE: rows of a planar gap: d2h/dx2 [1/m]
    """

    X = 0, 'cells: x of the middle. Wheel: from its reference point; plane: contact frame [m]'
    PRESSURE = 1, 'cells: normal pressure in the middle [Pa]'
    TRACTION_X = 2, 'cells: tangential traction on the wheel along x [Pa]'
    TRACTION_Y = 3, "cells: the same along the rail's arc, or along y of the contact plane [Pa]"
    SLIP_X = 4, 'cells: sliding velocity of the wheel over the rail / rolling speed, along x [-]'
    SLIP_Y = 5, "cells: the same along the rail's arc, or along y of the contact plane [-]"
    POWER_DENSITY = 6, 'cells: frictional power per area, paper eq. 10 [W/m^2]'
    FATIGUE_INDEX = 7, 'cells: local surface fatigue index, paper eq. 12 [-]'
    TEMPERATURE_RISE = 8, 'cells: temperature rise of both surfaces by friction, from that at first touch [K]'
    STRIP_Y = 9, "strips: middle. Wheel: arc length from the gauge end of the rail's profile; plane: y [m]"
    STRIP_WIDTH = 10, 'strips: width [m]'
    STRIP_CENTRE = 11, 'strips: x of the middle, as Field.X [m]'
    STRIP_HALF_LENGTH = 12, 'strips: half length [m]'
    STRIP_PEAK = 13, 'strips: peak pressure, damping included [Pa]'
    STRIP_POWER = 14, 'strips: frictional power per width [W/m]'
    STRIP_FRICTION = 15, 'strips: coefficient of friction that the law gave [-]'
    STRIP_WEAR = 16, "strips: volume lost per metre rolled and per width, Sheffield's law [m]"
    STRIP_PROFILE_Y = 17, "strips of a wheel: the middle in the coordinates of the rail's profile [m]"
    STRIP_PROFILE_Z = 18, 'strips of a wheel: the same, down [m]'
    STRIP_ANGLE = 19, "strips of a wheel: of the rail's surface about x there; < 0 on the gauge side [rad]"
    GAP_Y = 20, 'rows of a planar gap: y [m]'
    GAP_HEIGHT = 21, 'rows of a planar gap: smallest gap of the row [m]'
    GAP_CENTRE = 22, 'rows of a planar gap: x of that smallest gap [m]'
    GAP_CURVATURE = 23, 'rows of a planar gap: d2h/dx2 [1/m]'


class WrenchInput(s.Choice):
    """Inputs of a wrench: the columns of WrenchDerivatives.

    Y: wheel.y [m]
    Z: wheel.z [m], where the height is prescribed
    ROLL: wheel.roll [rad]. With a matrix: turning of the body about the track's x
    YAW: wheel.yaw [rad]. With a matrix: turning of the body about its z, which is rolled
    VELOCITY_X: wheel.velocity[0] [m/s]
    VELOCITY_Y: wheel.velocity[1] [m/s]
    VELOCITY_Z: wheel.velocity[2] [m/s]
    ANGULAR_VELOCITY_X: wheel.angular_velocity[0] in its axes; with Axes.NONE roll_rate [rad/s]
    ANGULAR_VELOCITY_Y: wheel.angular_velocity[1]; with Axes.NONE pitch_rate [rad/s]
    ANGULAR_VELOCITY_Z: wheel.angular_velocity[2]; with Axes.NONE yaw_rate [rad/s]
    RAIL_Y: rail.y [m]
    RAIL_Z: rail.z [m]
    RAIL_ROLL: rail.roll [rad]
    RAIL_Y_VELOCITY: rail.y_velocity [m/s]
    RAIL_Z_VELOCITY: rail.z_velocity [m/s]
    RAIL_ROLL_RATE: rail.roll_rate [rad/s]
    VERTICAL_LOAD: vertical_load [N], where it is prescribed
    DISTANCE: distance [m], without the change of the strips' width along the track
    ANGLE: angle [rad]
    RAIL_Y_SLOPE: rail.y_slope [-]; 0 of a roller
    RAIL_Z_SLOPE: rail.z_slope [-]; 0 of a roller
    ROLLER_RATE: roller_rate [rad/s]; 0 of a rail that is no roller
    FRICTION: a factor, here 1, on all coefficients of friction [-]
    TIME_STEP: time_step [s], of config.surface.memory; at time_step 0 towards larger times
    """

    Y = 0, 'wheel.y [m]'
    Z = 1, 'wheel.z [m], where the height is prescribed'
    ROLL = 2, "wheel.roll [rad]. With a matrix: turning of the body about the track's x"
    YAW = 3, 'wheel.yaw [rad]. With a matrix: turning of the body about its z, which is rolled'
    VELOCITY_X = 4, 'wheel.velocity[0] [m/s]'
    VELOCITY_Y = 5, 'wheel.velocity[1] [m/s]'
    VELOCITY_Z = 6, 'wheel.velocity[2] [m/s]'
    ANGULAR_VELOCITY_X = 7, 'wheel.angular_velocity[0] in its axes; with Axes.NONE roll_rate [rad/s]'
    ANGULAR_VELOCITY_Y = 8, 'wheel.angular_velocity[1]; with Axes.NONE pitch_rate [rad/s]'
    ANGULAR_VELOCITY_Z = 9, 'wheel.angular_velocity[2]; with Axes.NONE yaw_rate [rad/s]'
    RAIL_Y = 10, 'rail.y [m]'
    RAIL_Z = 11, 'rail.z [m]'
    RAIL_ROLL = 12, 'rail.roll [rad]'
    RAIL_Y_VELOCITY = 13, 'rail.y_velocity [m/s]'
    RAIL_Z_VELOCITY = 14, 'rail.z_velocity [m/s]'
    RAIL_ROLL_RATE = 15, 'rail.roll_rate [rad/s]'
    VERTICAL_LOAD = 16, 'vertical_load [N], where it is prescribed'
    DISTANCE = 17, "distance [m], without the change of the strips' width along the track"
    ANGLE = 18, 'angle [rad]'
    RAIL_Y_SLOPE = 19, 'rail.y_slope [-]; 0 of a roller'
    RAIL_Z_SLOPE = 20, 'rail.z_slope [-]; 0 of a roller'
    ROLLER_RATE = 21, 'roller_rate [rad/s]; 0 of a rail that is no roller'
    FRICTION = 22, 'a factor, here 1, on all coefficients of friction [-]'
    TIME_STEP = 23, 'time_step [s], of config.surface.memory; at time_step 0 towards larger times'


class DamageQuantity(s.Choice):
    """Quantities of a bin. Sums: a bin's volume over its width (and over a wheel's circumference, or a rail's
        length) is a depth; a fatigue sum over its width and over the length rolled (or a rail's length) is
        the index of each passage, added up. Each range is that of a sum; single contributions may be half of
        it.

    WORK: frictional work [J], +-8e12; over the distance it is T-gamma
    WEAR_T_GAMMA: volume worn by the T-gamma law [m^3], +-8e6; spread like the work. The law is of wheels:
        bins of a rail get the volume of the wheel
    WEAR_SHEFFIELD: the same by Sheffield's law, of each strip's T-gamma over its area
    WEAR_ARCHARD: the same by Archard's, of each strip's work, peak pressure and sliding velocity
    WEAR_POWER: the same by the power law, of each strip's power over its area
    WHOLE_LIFE: Whole Life Rail Model: damage function of the patch's T-gamma, times distance and width [m^2],
        +-8e6; < 0 where wear removes cracks
    SURFACE_FATIGUE: positive part of the strip's surface fatigue index |F| / N - k / p0, times distance and
        width [m^2], +-8e6
    TIME: contact time times width [s m], +-8e6
    LARGEST_PRESSURE: not a sum: largest pressure [Pa]
    LARGEST_TRACTION: not a sum: largest traction [Pa]: |F| / N of a strip times its peak pressure
    """

    WORK = 0, 'frictional work [J], +-8e12; over the distance it is T-gamma'
    WEAR_T_GAMMA = 1, 'volume worn by the T-gamma law [m^3], +-8e6; spread like the work. The law is of wheels: bins of a rail get the volume of the wheel'
    WEAR_SHEFFIELD = 2, "the same by Sheffield's law, of each strip's T-gamma over its area"
    WEAR_ARCHARD = 3, "the same by Archard's, of each strip's work, peak pressure and sliding velocity"
    WEAR_POWER = 4, "the same by the power law, of each strip's power over its area"
    WHOLE_LIFE = 5, "Whole Life Rail Model: damage function of the patch's T-gamma, times distance and width [m^2], +-8e6; < 0 where wear removes cracks"
    SURFACE_FATIGUE = 6, "positive part of the strip's surface fatigue index |F| / N - k / p0, times distance and width [m^2], +-8e6"
    TIME = 7, 'contact time times width [s m], +-8e6'
    LARGEST_PRESSURE = 1000, 'not a sum: largest pressure [Pa]'
    LARGEST_TRACTION = 1001, 'not a sum: largest traction [Pa]: |F| / N of a strip times its peak pressure'


class Adhesion(s.Choice):
    """Definition of adhesion.

    COULOMB: tractions up to friction * pressure, then slip
    FULL: no slip anywhere: linear theory; friction is unused
    """

    COULOMB = 0, 'tractions up to friction * pressure, then slip'
    FULL = 1, 'no slip anywhere: linear theory; friction is unused'


class Collocation(s.Choice):
    """Where on a cell the discrete equations hold.

    QUARTER_POINT: converges fastest with the grid: the choice for answers
    REFERENCE: reproduces the program CONTACT on its own grid: the choice for comparisons
    """

    QUARTER_POINT = 0, 'converges fastest with the grid: the choice for answers'
    REFERENCE = 1, 'reproduces the program CONTACT on its own grid: the choice for comparisons'


class SurfaceInfluence(s.Choice):
    """Half-space coefficients on a curved surface.

    TURNED: turned between the normals of the two cells: the choice for answers
    PLAIN: a plane's over arc length, the plain conformal setting of CONTACT: for comparisons
    """

    TURNED = 0, 'turned between the normals of the two cells: the choice for answers'
    PLAIN = 1, "a plane's over arc length, the plain conformal setting of CONTACT: for comparisons"


class CreepParameter(s.Choice):
    """A parameter of friction or of a layer that wrc_fit_creep_curve() can find: places in the arrays of
        CreepFit.

    COEFFICIENT: friction.coefficient [-]
    KINETIC_RATIO: friction.kinetic_ratio, of a speed law [-]
    FALL_RATE: friction.fall_rate, of the exponential law [s/m]
    HALF_SPEED: friction.half_speed, of the hyperbolic law [m/s]
    SLOPE_REDUCTION: friction.slope_reduction [-]
    ADHESION_REDUCTION: friction.adhesion_reduction, of TangentialMethod.POLACH [-]
    SLIP_REDUCTION: friction.slip_reduction, of the same [-]
    LAYER_THICKNESS: friction.layer_thickness, at a given layer_modulus [m]
    LAYER_YIELD: friction.layer_yield [Pa]
    LAYER_HARDENING: friction.layer_hardening [Pa/m]
    """

    COEFFICIENT = 0, 'friction.coefficient [-]'
    KINETIC_RATIO = 1, 'friction.kinetic_ratio, of a speed law [-]'
    FALL_RATE = 2, 'friction.fall_rate, of the exponential law [s/m]'
    HALF_SPEED = 3, 'friction.half_speed, of the hyperbolic law [m/s]'
    SLOPE_REDUCTION = 4, 'friction.slope_reduction [-]'
    ADHESION_REDUCTION = 5, 'friction.adhesion_reduction, of TangentialMethod.POLACH [-]'
    SLIP_REDUCTION = 6, 'friction.slip_reduction, of the same [-]'
    LAYER_THICKNESS = 7, 'friction.layer_thickness, at a given layer_modulus [m]'
    LAYER_YIELD = 8, 'friction.layer_yield [Pa]'
    LAYER_HARDENING = 9, 'friction.layer_hardening [Pa/m]'


class Scatter(s.Choice):
    """Scatter of measured adhesion.

    RELATIVE: in proportion to the adhesion, and at least to a hundredth of the largest
    ABSOLUTE: by the same amount at every point
    """

    RELATIVE = 0, 'in proportion to the adhesion, and at least to a hundredth of the largest'
    ABSOLUTE = 1, 'by the same amount at every point'


class ConicityMethod(s.Choice):
    """How a conicity is made of a rolling radius difference. Theory manual, "Contact functions and conicity".

    WAVELENGTH: of the cone with the same wavelength: integration of y'' + dr(y) / (e r0) = 0, the method of
        UIC 519 and EN 15302
    REGRESSION: half the slope of the straight line fitted to dr over the amplitude, all displacements
        weighing alike
    """

    WAVELENGTH = 0, "of the cone with the same wavelength: integration of y'' + dr(y) / (e r0) = 0, the method of UIC 519 and EN 15302"
    REGRESSION = 1, 'half the slope of the straight line fitted to dr over the amplitude, all displacements weighing alike'


class FaceKind(s.Choice):
    """Kind of a face, by its place beside the others.

    RAIL: nothing lies beside it
    STOCK: stock rail: a blade lies beside it
    BLADE: begins or ends against the face on its field side
    WING: wing rail: a nose lies beside it
    NOSE: begins or ends low, beside a flangeway
    CHECK: check rail: as high as the face on its field side, all along
    """

    RAIL = 0, 'nothing lies beside it'
    STOCK = 1, 'stock rail: a blade lies beside it'
    BLADE = 2, 'begins or ends against the face on its field side'
    WING = 3, 'wing rail: a nose lies beside it'
    NOSE = 4, 'begins or ends low, beside a flangeway'
    CHECK = 5, 'check rail: as high as the face on its field side, all along'


class SurfaceQuantity(s.Choice):
    """Quantities of a bin: substances and heat.

    WATER: [kg/m^2]
    OXIDE: oxide and debris of wear [kg/m^2]
    FILM: organic film: leaves [kg/m^2]
    SAND: [kg/m^2]
    LUBRICANT: grease, friction modifier [kg/m^2]
    HEAT: above the ambient temperature [J/m^2]
    """

    WATER = 0, '[kg/m^2]'
    OXIDE = 1, 'oxide and debris of wear [kg/m^2]'
    FILM = 2, 'organic film: leaves [kg/m^2]'
    SAND = 3, '[kg/m^2]'
    LUBRICANT = 4, 'grease, friction modifier [kg/m^2]'
    HEAT = 5, 'above the ambient temperature [J/m^2]'


class SurfaceBook(s.Choice):
    """Columns of the books of a bin. Amount = put on - removed - squeezed - evaporated - carried, to the last
        bit.

    AMOUNT: amount in the bin now
    PUT_ON: put on by sources; heat also by friction
    REMOVED: removed by frictional energy; heat lost to the air and into the depth
    SQUEEZED: pressed out of the running band by passing wheels
    EVAPORATED: water evaporated; heat that this took
    CARRIED: carried to the other body, less the amount that came from it
    """

    AMOUNT = 0, 'amount in the bin now'
    PUT_ON = 1, 'put on by sources; heat also by friction'
    REMOVED = 2, 'removed by frictional energy; heat lost to the air and into the depth'
    SQUEEZED = 3, 'pressed out of the running band by passing wheels'
    EVAPORATED = 4, 'water evaporated; heat that this took'
    CARRIED = 5, 'carried to the other body, less the amount that came from it'


class Profile(s.Struct):
    """A wheel or rail profile: y increases strictly, z is down. 4 to 20000 points, 1e-12 m to 35 mm apart, over
        20 to 500 mm, within 1 m of the origin, without a step. - Wheel: y = 0 and z = 0 at the running
        circle, flange at y < 0, also for a left wheel. - Rail: y towards the field side, z = 0 at the top;
        gauge side at y < 0 (also for a left rail). Its points go down the gauge face by track.gauge_depth at
        least. - A step is refused: 1 mm and more from one point to the next at over 79 degrees, between parts
        below 45 degrees. For a rail's upper 40 mm 56 degrees hold.

    Members:
      kind: ProfileKind (default ProfileKind.NONE)
      count: number of points (4 .. 20000; default 0)
      y [m]: count of them (required)
      z [m]: count of them (required)
      smoothing [m]: wavelength along the curve that keeps half its height; 0: points are interpolated. Waves
          of half that length keep a seventeenth. Tested: 7e-3 (0 .. 0.05; default 0)
    """

    _c_name_ = 'wrc_profile'
    __slots__ = ()
    kind: ProfileKind = s.Chosen('kind', ProfileKind)  # type: ignore[assignment]
    count: int = s.Count('count')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', 'count')  # type: ignore[assignment]
    z: Optional[np.ndarray] = s.Pointer('z', 'count')  # type: ignore[assignment]
    smoothing: float
    _units_ = {'y': 'm', 'z': 'm', 'smoothing': 'm'}
    _fields_ = [
        ('_kind', c.c_int32),
        ('_count', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_z', c.POINTER(c.c_double)),
        ('smoothing', c.c_double),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(Profile) == 80


class Material(s.Struct):
    """Elastic and yield properties of a body. Of two different bodies all methods take 1/G = (1/G_w + 1/G_r) / 2
        and nu/G = (nu_w/G_w + nu_r/G_r) / 2. Kalker's K couples pressure and traction. Contact.wrench()
        includes its leading part with TangentialMethod.STRIP_FASTSIM and without memory; all other calls in
        real time leave K out. Where K is not 0, Status.FLAG_DISSIMILAR_MATERIALS is set when the model is
        made. Theory manual, section 4.

    Members:
      shear_modulus [Pa]: G (1e8 .. 1e12; default 82e9)
      poisson: nu (0 .. 0.5; default 0.28)
      shear_yield [Pa]: k, yield limit in shear. Fatigue indices take the smaller of both bodies (1e6 .. 1e11;
          default 250e6)
    """

    _c_name_ = 'wrc_material'
    __slots__ = ()
    shear_modulus: float
    poisson: float
    shear_yield: float
    _units_ = {'shear_modulus': 'Pa', 'shear_yield': 'Pa'}
    _defaults_ = {'shear_modulus': 82000000000.0, 'poisson': 0.28, 'shear_yield': 250000000.0}
    _fields_ = [
        ('shear_modulus', c.c_double),
        ('poisson', c.c_double),
        ('shear_yield', c.c_double),
        ('_reserved', c.c_double * 5),
    ]
assert c.sizeof(Material) == 64


class HeatProperties(s.Struct):
    """How a body takes up heat. Read by temperatures and by friction over temperature.

    Members:
      conductivity [W/(m K)]: lambda (0.1 .. 1000; default 50)
      density [kg/m^3]: rho (100 .. 1e5; default 7850)
      specific_heat [J/(kg K)]: c (10 .. 1e5; default 450)
    """

    _c_name_ = 'wrc_heat_properties'
    __slots__ = ()
    conductivity: float
    density: float
    specific_heat: float
    _units_ = {'conductivity': 'W/(m K)', 'density': 'kg/m^3', 'specific_heat': 'J/(kg K)'}
    _defaults_ = {'conductivity': 50.0, 'density': 7850.0, 'specific_heat': 450.0}
    _fields_ = [
        ('conductivity', c.c_double),
        ('density', c.c_double),
        ('specific_heat', c.c_double),
        ('_reserved', c.c_double * 5),
    ]
assert c.sizeof(HeatProperties) == 64


class ConfigWheelset(s.Struct):
    """Where the wheels are on their axle.

    Members:
      wheel_radius [m]: nominal rolling radius, at the tape circle (0.1 .. 1.5; default 0.46)
      tape_circle_distance [m]: between the tape circles of both wheels; not read without profiles (0.3 .. 3;
          default 1.5)
    """

    _c_name_ = 'wrc_config_wheelset'
    __slots__ = ()
    wheel_radius: float
    tape_circle_distance: float
    _units_ = {'wheel_radius': 'm', 'tape_circle_distance': 'm'}
    _defaults_ = {'wheel_radius': 0.46, 'tape_circle_distance': 1.5}
    _fields_ = [
        ('wheel_radius', c.c_double),
        ('tape_circle_distance', c.c_double),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(ConfigWheelset) == 64


class ConfigTrack(s.Struct):
    """Where the rails are. Not read without profiles.

    Members:
      placement: ProfilePlacement (default ProfilePlacement.GAUGE)
      gauge [m]: between the gauge faces of the rails (0.3 .. 2.5; default 1.435)
      gauge_depth [m]: depth below the rail top at which the gauge is measured (0.005 .. 0.04; default 0.014)
      rail_inclination: tangent of the cant towards the track centre; 1:40 is 0.025. 0 for
          ProfileKind.UIC60_BENCHMARK (-0.2 .. 0.2; default 0)
      rail_origin [m]: distance of the rail profile's origin from the track's centre line (0.2 .. 1.5; default
          0)
    """

    _c_name_ = 'wrc_config_track'
    __slots__ = ()
    placement: ProfilePlacement = s.Chosen('placement', ProfilePlacement)  # type: ignore[assignment]
    gauge: float
    gauge_depth: float
    rail_inclination: float
    rail_origin: float
    _units_ = {'gauge': 'm', 'gauge_depth': 'm', 'rail_origin': 'm'}
    _defaults_ = {'gauge': 1.435, 'gauge_depth': 0.014}
    _fields_ = [
        ('_placement', c.c_int32),
        ('_reserved0', c.c_uint32),
        ('gauge', c.c_double),
        ('gauge_depth', c.c_double),
        ('rail_inclination', c.c_double),
        ('rail_origin', c.c_double),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(ConfigTrack) == 88


class RailSection(s.Struct):
    """One cross section of a rail that changes along the track. A surface is a stock rail, a blade, a wing rail,
        a nose. Its sections are blended point by point of equal share of their length. The blend is twice
        continuously differentiable in the distance. Marks divide that length: points of equal mark belong
        together. A surface is there from its first section to its last; where the whole rail begins or ends
        its section goes on. An end is best where no wheel touches it. Else the wheel rolls over its edge, up
        to 14 mm high, with Status.FLAG_PATCH_AT_EDGE. Height and force are continuous there; the peak
        pressure is not solved. A hollow that is curved more than the wheel is met on one of its sides: force
        and place jump where that changes. Theory manual, section 9.

    Members:
      distance [m]: along the track. Within a surface it increases by 1 mm at least (-1e7 .. 1e7; default 0)
      y [m]: place of the profile's origin from that of config.rail, to the field side (-0.5 .. 0.5; default
          0)
      z [m]: the same downwards (-0.5 .. 0.5; default 0)
      surface: number of its surface, counted from the gauge side; sections of one surface stand side by side
          (0 .. 7; default 0)
      mark_count: number of marks; equal for all sections of a surface (0 .. 64; default 0)
      marks [m]: mark_count of them: y on this profile, increasing by 1 mm at least, also from the ends (-0.5
          .. 0.5; required)
      profile: its outline from its own origin, canted by config.track.rail_inclination
    """

    _c_name_ = 'wrc_rail_section'
    __slots__ = ()
    distance: float
    y: float
    z: float
    surface: int
    mark_count: int = s.Count('mark_count')  # type: ignore[assignment]
    marks: Optional[np.ndarray] = s.Pointer('marks', 'mark_count')  # type: ignore[assignment]
    profile: Profile
    _units_ = {'distance': 'm', 'y': 'm', 'z': 'm', 'marks': 'm'}
    _fields_ = [
        ('distance', c.c_double),
        ('y', c.c_double),
        ('z', c.c_double),
        ('surface', c.c_int32),
        ('_mark_count', c.c_uint32),
        ('_marks', c.POINTER(c.c_double)),
        ('profile', Profile),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(RailSection) == 168


class ConfigRoundness(s.Struct):
    """A wheel that is not round: a flat, a polygon, a measurement. A periodic cubic spline goes through each
        row. Theory manual, section 9.

    Members:
      angle_count: places round the wheel in each row; the first comes again at the end (0 or 9 .. 20000;
          default 0)
      row_count: rows across the tread (1 .. 16; default 0)
      angles [rad]: angle_count of them, increasing from 0 to 2 pi. At WheelInput.angle 0, 0 is the lowest
          point and angles grow towards +x (0 .. 6.2831854; required)
      y [m]: row_count of them: y of each row on the wheel's profile, increasing; None: one row (-0.5 .. 0.5;
          default None)
      deviations [m]: row_count * angle_count of them, row by row: radius less that of the profile (-0.005 ..
          0.005; required)
    """

    _c_name_ = 'wrc_config_roundness'
    __slots__ = ()
    angle_count: int = s.Count('angle_count')  # type: ignore[assignment]
    row_count: int = s.Count('row_count')  # type: ignore[assignment]
    angles: Optional[np.ndarray] = s.Pointer('angles', 'angle_count')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', 'row_count')  # type: ignore[assignment]
    deviations: Optional[np.ndarray] = s.Pointer('deviations', 'row_count', 'angle_count')  # type: ignore[assignment]
    _units_ = {'angles': 'rad', 'y': 'm', 'deviations': 'm'}
    _fields_ = [
        ('_angle_count', c.c_uint32),
        ('_row_count', c.c_uint32),
        ('_angles', c.POINTER(c.c_double)),
        ('_y', c.POINTER(c.c_double)),
        ('_deviations', c.POINTER(c.c_double)),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(ConfigRoundness) == 80


class ConfigCheckRail(s.Struct):
    """A check rail beside each rail, which guides the back of the wheel's flange. It is the same all along the
        track and moves with the rail. The wheel's profile must have points on the flange's back, beyond the
        tip.

    Members:
      y [m]: place of its profile's origin from that of config.rail, to the field side: < 0 (-0.5 .. 0;
          default 0)
      z [m]: the same downwards: < 0 where it stands above the rail's origin (-0.5 .. 0.5; default 0)
      profile: its outline as that of a rail; its field side guides. ProfileKind.NONE: there is no check rail
    """

    _c_name_ = 'wrc_config_check_rail'
    __slots__ = ()
    y: float
    z: float
    profile: Profile
    _units_ = {'y': 'm', 'z': 'm'}
    _fields_ = [
        ('y', c.c_double),
        ('z', c.c_double),
        ('profile', Profile),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(ConfigCheckRail) == 144


class ConfigNormal(s.Struct):
    """The normal problem.

    Members:
      method: NormalMethod (default NormalMethod.STRIP_HALFSPACE)
      max_iterations: cap of the steps of the load search; not of NormalMethod.STRIP_HALFSPACE (4 .. 1000;
          default 60)
      load_tolerance: relative error of a prescribed load; not of NormalMethod.STRIP_HALFSPACE (1e-14 .. 1e-2;
          default 1e-10)
    """

    _c_name_ = 'wrc_config_normal'
    __slots__ = ()
    method: NormalMethod = s.Chosen('method', NormalMethod)  # type: ignore[assignment]
    max_iterations: int
    load_tolerance: float
    _defaults_ = {'_method': 6, 'max_iterations': 60, 'load_tolerance': 1e-10}
    _fields_ = [
        ('_method', c.c_int32),
        ('max_iterations', c.c_int32),
        ('load_tolerance', c.c_double),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(ConfigNormal) == 64


class ConfigTangential(s.Struct):
    """The tangential problem. use() sets a published method by its name.

    Members:
      method: TangentialMethod (default TangentialMethod.STRIP_FASTSIM)
      patch_model: PatchModel; of FASTSIM and FaStrip (default PatchModel.PATCH_SDEC)
      bound: TractionBound; of FASTSIM (default TractionBound.PARABOLIC)
      flexibility: Flexibility; of FASTSIM (default Flexibility.SEPARATE)
      force_table: file of the force table, read once by the model; of TangentialMethod.FORCE_TABLE (default
          None)
    """

    _c_name_ = 'wrc_config_tangential'
    __slots__ = ()
    method: TangentialMethod = s.Chosen('method', TangentialMethod)  # type: ignore[assignment]
    patch_model: PatchModel = s.Chosen('patch_model', PatchModel)  # type: ignore[assignment]
    bound: TractionBound = s.Chosen('bound', TractionBound)  # type: ignore[assignment]
    flexibility: Flexibility = s.Chosen('flexibility', Flexibility)  # type: ignore[assignment]
    force_table: Optional[str] = s.Text('force_table')  # type: ignore[assignment]
    _defaults_ = {'_method': 2}
    _fields_ = [
        ('_method', c.c_int32),
        ('_patch_model', c.c_int32),
        ('_bound', c.c_int32),
        ('_flexibility', c.c_int32),
        ('_force_table', c.c_char_p),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(ConfigTangential) == 72


class ConfigSurface(s.Struct):
    """Options of Contact.wrench() alone. use() sets resolution, tolerance and work by the name of a setting.
        Times and errors of settings: docs/realtime.md.

    Members:
      cells: cells along each strip, in which it rolls and fields are given (4 .. 512; default 32)
      memory: 1: contacts remember the tractions of the step that Contact.commit() commits, at rest and
          rolling either way. Of TangentialMethod.STRIP_FASTSIM (0 .. 1; default 0)
      tread_width [m]: width of the rail's strips where its radius of curvature is 60 mm or more (1e-4 ..
          2e-3; default 5e-4)
      corner_width [m]: the same where it is 20 mm or less, at most tread_width; linear between. Faces that
          guide, of a check rail, have 0.2e-3 m at most (5e-5 .. 1e-3; default 2.5e-4)
      tolerance: part of the contact's area that the last iteration of the normal problem moves; of
          NormalMethod.STRIP_HALFSPACE. Forces, and a prescribed load, are met to a tenth of it (1e-10 ..
          1e-2; default 1e-5)
      max_work: work that a call may take, all heights of a prescribed load included; of
          NormalMethod.STRIP_HALFSPACE. Its unit is one strip displacing another: an iteration over n strips
          takes 2 n^2, n at least 4. One that would exceed it is not begun: Status.FLAG_ITERATION_CAP (1e3 ..
          1e9; default 2e7)
      max_iterations: cap of the normal problem at one height, in iterations over all strips that overlap
          there; over those in contact about twice as many; of NormalMethod.STRIP_HALFSPACE. The call then
          ends as with max_work (2 .. 1e6; default 1e6)
    """

    _c_name_ = 'wrc_config_surface'
    __slots__ = ()
    cells: int
    memory: int
    tread_width: float
    corner_width: float
    tolerance: float
    max_work: float
    max_iterations: float
    _units_ = {'tread_width': 'm', 'corner_width': 'm'}
    _defaults_ = {'cells': 32, 'tread_width': 0.0005, 'corner_width': 0.00025, 'tolerance': 1e-05, 'max_work': 20000000.0, 'max_iterations': 1000000.0}
    _fields_ = [
        ('cells', c.c_int32),
        ('memory', c.c_uint32),
        ('tread_width', c.c_double),
        ('corner_width', c.c_double),
        ('tolerance', c.c_double),
        ('max_work', c.c_double),
        ('max_iterations', c.c_double),
        ('_reserved', c.c_double * 9),
    ]
assert c.sizeof(ConfigSurface) == 120


class ConfigPlanar(s.Struct):
    """Options of the stages of wrc_planar.h, and of their normal methods where Contact.wrench() applies them.
        The ellipse of any region follows regularisation.

    Members:
      strips: strips across the patch (4 .. 512; default 60)
      cells: cells along each strip (4 .. 512; default 32)
      gap_rows: rows the gap is sampled at, and most that a caller's gap has (8 .. 4096; default 256)
      max_patches: patches reported; more are flagged (1 .. 16; default 4)
      max_sweeps: cap of the sweeps over the strips on each of two grids; of NormalMethod.STRIP_HALFSPACE (4
          .. 1000; default 16)
      start: Start: of the sweeps of NormalMethod.STRIP_HALFSPACE. Warm, the same approach again moves the
          force by up to 0.1 % (default Start.COLD)
      regularisation: Regularisation (default Regularisation.WIDTH)
      non_steady: 1: contacts remember tractions over the distances told to Contact.planar_roll(), at rest and
          rolling either way. Of TangentialMethod.STRIP_FASTSIM (0 .. 1; default 0)
      gap_limit [m]: gap up to which rows of a pose reach. Deeper approaches are continued,
          Status.FLAG_BEYOND_GAP (1e-5 .. 0.02; default 1e-3)
    """

    _c_name_ = 'wrc_config_planar'
    __slots__ = ()
    strips: int
    cells: int
    gap_rows: int
    max_patches: int
    max_sweeps: int
    start: Start = s.Chosen('start', Start)  # type: ignore[assignment]
    regularisation: Regularisation = s.Chosen('regularisation', Regularisation)  # type: ignore[assignment]
    non_steady: int
    gap_limit: float
    _units_ = {'gap_limit': 'm'}
    _defaults_ = {'strips': 60, 'cells': 32, 'gap_rows': 256, 'max_patches': 4, 'max_sweeps': 16, 'gap_limit': 0.001}
    _fields_ = [
        ('strips', c.c_int32),
        ('cells', c.c_int32),
        ('gap_rows', c.c_int32),
        ('max_patches', c.c_int32),
        ('max_sweeps', c.c_int32),
        ('_start', c.c_int32),
        ('_regularisation', c.c_int32),
        ('non_steady', c.c_int32),
        ('gap_limit', c.c_double),
        ('_reserved', c.c_double * 8),
    ]
assert c.sizeof(ConfigPlanar) == 104


class Config(s.Struct):
    """Everything a model is made of. Begin with wrc_config_default(). A member that the chosen methods do not
        read must keep its default: anything else is Status.ERROR_UNSUPPORTED, with a sentence.

    Members:
      instruction_set: InstructionSet (default InstructionSet.BEST)
      wheel: profile of the wheel
      rail: profile of the rail; both are ProfileKind.NONE or neither is
      wheel_material: of the wheel
      rail_material: of the rail
      wheel_heat: how the wheel takes up heat
      rail_heat: how the rail takes up heat
      wheelset: where the wheels are on their axle
      track: where the rails are
      normal: method of the normal problem
      tangential: method of the tangential problem
      surface: options of Contact.wrench()
      planar: options of the stages of wrc_planar.h
      roundness: of a wheel that is not round; of Contact.wrench()
      roller_curvature [1/m]: 1 / radius of a roller at the origin of the rail's profile; 0: a straight rail;
          of Contact.wrench() (0 or 1e-12 .. 10; default 0)
      check_rail: beside the rail; of Contact.wrench()
      rail_section_count: sections of a rail that changes along the track; of Contact.wrench() (0 .. 1000;
          default 0)
      rail_sections: rail_section_count of them. config.rail stays the rail of the stages, and its place is
          the sections' (required)
    """

    _c_name_ = 'wrc_config'
    __slots__ = ()
    instruction_set: InstructionSet = s.Chosen('instruction_set', InstructionSet)  # type: ignore[assignment]
    wheel: Profile
    rail: Profile
    wheel_material: Material
    rail_material: Material
    wheel_heat: HeatProperties
    rail_heat: HeatProperties
    wheelset: ConfigWheelset
    track: ConfigTrack
    normal: ConfigNormal
    tangential: ConfigTangential
    surface: ConfigSurface
    planar: ConfigPlanar
    roundness: ConfigRoundness
    roller_curvature: float
    check_rail: ConfigCheckRail
    rail_section_count: int = s.Count('rail_section_count')  # type: ignore[assignment]
    rail_sections: Sequence[RailSection] = s.References('rail_sections', 'rail_section_count', size='rail_section_size')  # type: ignore[assignment]
    _units_ = {'roller_curvature': '1/m'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_instruction_set', c.c_int32),
        ('wheel', Profile),
        ('rail', Profile),
        ('wheel_material', Material),
        ('rail_material', Material),
        ('wheel_heat', HeatProperties),
        ('rail_heat', HeatProperties),
        ('wheelset', ConfigWheelset),
        ('track', ConfigTrack),
        ('normal', ConfigNormal),
        ('tangential', ConfigTangential),
        ('surface', ConfigSurface),
        ('planar', ConfigPlanar),
        ('roundness', ConfigRoundness),
        ('roller_curvature', c.c_double),
        ('check_rail', ConfigCheckRail),
        ('_rail_section_count', c.c_uint32),
        ('_rail_section_size', c.c_uint32),
        ('_rail_sections', c.POINTER(RailSection)),
    ]
assert c.sizeof(Config) == 1184


class Allocator(s.Struct):
    """Where memory comes from in wrc_model_create() and wrc_contact_create(). Both functions or neither.

    Members:
      user: handed to both (default None)
      allocate: alignment is a power of two; returns None where no memory is left (default None)
      release: called by the destroy functions, and when a create fails (default None)
    """

    _c_name_ = 'wrc_allocator'
    __slots__ = ()
    user: Any
    allocate: Any
    release: Any
    _fields_ = [
        ('user', c.c_void_p),
        ('allocate', c.c_void_p),
        ('release', c.c_void_p),
        ('_reserved', c.c_double * 2),
    ]
assert c.sizeof(Allocator) == 40


class View(s.Struct):
    """A read-only view: element i is data[i].

    Members:
      data: in the model's memory; None on failure
      count: elements
    """

    _c_name_ = 'wrc_view'
    __slots__ = ()
    data: Optional[np.ndarray] = s.Pointer('data')  # type: ignore[assignment]
    count: int
    _fields_ = [
        ('_data', c.POINTER(c.c_double)),
        ('count', c.c_uint64),
        ('_reserved', c.c_double * 2),
    ]
assert c.sizeof(View) == 32


class BulkTemperatures(s.Struct):
    """Temperatures of the bodies away from the contact.

    Members:
      wheel [degC]: of the tread (-273 .. 2000; default 20)
      rail [degC]: of the running surface (-273 .. 2000; default 20)
    """

    _c_name_ = 'wrc_bulk_temperatures'
    __slots__ = ()
    wheel: float
    rail: float
    _units_ = {'wheel': 'degC', 'rail': 'degC'}
    _defaults_ = {'wheel': 20.0, 'rail': 20.0}
    _fields_ = [
        ('wheel', c.c_double),
        ('rail', c.c_double),
        ('_reserved', c.c_double * 2),
    ]
assert c.sizeof(BulkTemperatures) == 32


class Friction(s.Struct):
    """Friction between the bodies, and a layer between them. Each strip has one coefficient: that at rest
        (coefficient, or of the zones) times the factor of speed_law times that of temperature_law. Members of
        laws that are not chosen are checked and not read: a program may keep the parameters of all. Theory
        manual, section 5.

    Members:
      coefficient: Coulomb, at rest; 0, no friction, in Contact.wrench() alone (0 or 1e-4 .. 2; default 0.3)
      speed_law: FrictionSpeedLaw (default FrictionSpeedLaw.NONE)
      temperature_law: FrictionTemperatureLaw (default FrictionTemperatureLaw.NONE)
      kinetic_ratio: friction at high sliding speed over that at rest (Polach's A) (0 .. 1; default 0.4)
      fall_rate [s/m]: Polach's B, of the exponential law (0 .. 1000; default 0.6)
      half_speed [m/s]: sliding speed at which half of the fall is done, of the hyperbolic law (1e-6 .. 100;
          default 1)
      hot_ratio: friction of hot surfaces over that of cold ones (0 .. 1; default 0.5)
      cold_temperature [degC]: up to which friction is whole (-273 .. 2000; default 0)
      hot_temperature [degC]: from which friction has hot_ratio; 1 degC above cold_temperature at least (-273
          .. 3000; default 400)
      bulk: of the bodies; read by the temperature law
      slope_reduction: initial slope of the creep curve over that of clean bodies: a layer (0.01 .. 1; default
          1)
      slope_limit: share of that slope left at large slip; of modified FASTSIM (0 .. 1; default 0.02)
      slope_fall: how fast the slope falls with slip; of modified FASTSIM (0 .. 1000; default 0)
      zone_y [m]: breakpoints, zone_count of them, increasing; two at one y make a step (-1 .. 1; required)
      zone_coefficients: friction at rest at the breakpoints, zone_count of them, in place of coefficient.
          Linear between them, constant beyond. A strip has its mean (0 .. 2; required)
      zone_count: breakpoints (0 .. 64; default 0)
      zone_frame: ZoneFrame (default ZoneFrame.CONTACT_FRAME)
      layer_thickness [m]: of an elasto-plastic layer between the bodies; 0: it does not shear elastically (0
          .. 0.01; default 0)
      layer_modulus [Pa]: of that layer in shear; goes with a thickness (0 or 1e3 .. 1e12; default 0)
      layer_yield [Pa]: traction at which fresh layer yields; 0: it does not yield (0 or 1e3 .. 1e11; default
          0)
      layer_hardening [Pa/m]: rise of that traction over the length of plastic flow, < 0: the layer softens,
          to a tenth of layer_yield at least; goes with layer_yield (-1e13 .. 1e14; default 0)
      adhesion_reduction: Polach's k_A: factor on the gradient of traction where the patch sticks; of
          TangentialMethod.POLACH, which refuses 0 (0 or 0.001 .. 1; default 1)
      slip_reduction: Polach's k_S: that factor where the patch slips, at most adhesion_reduction; of
          TangentialMethod.POLACH, which refuses 0 (0 or 0.001 .. 1; default 1)
      film_rows: films in rows across rail and wheel, film_numbers of them, as surface_friction() fills them;
          of Contact.wrench() (-1e30 .. 1e30; default None)
      film_numbers: numbers of film_rows; 0: no rows (0 .. 1288; default 0)
    """

    _c_name_ = 'wrc_friction'
    __slots__ = ()
    coefficient: float
    speed_law: FrictionSpeedLaw = s.Chosen('speed_law', FrictionSpeedLaw)  # type: ignore[assignment]
    temperature_law: FrictionTemperatureLaw = s.Chosen('temperature_law', FrictionTemperatureLaw)  # type: ignore[assignment]
    kinetic_ratio: float
    fall_rate: float
    half_speed: float
    hot_ratio: float
    cold_temperature: float
    hot_temperature: float
    bulk: BulkTemperatures
    slope_reduction: float
    slope_limit: float
    slope_fall: float
    zone_y: Optional[np.ndarray] = s.Pointer('zone_y', 'zone_count')  # type: ignore[assignment]
    zone_coefficients: Optional[np.ndarray] = s.Pointer('zone_coefficients', 'zone_count')  # type: ignore[assignment]
    zone_count: int = s.Count('zone_count')  # type: ignore[assignment]
    zone_frame: ZoneFrame = s.Chosen('zone_frame', ZoneFrame)  # type: ignore[assignment]
    layer_thickness: float
    layer_modulus: float
    layer_yield: float
    layer_hardening: float
    adhesion_reduction: float
    slip_reduction: float
    film_rows: Optional[np.ndarray] = s.Pointer('film_rows', 'film_numbers')  # type: ignore[assignment]
    film_numbers: int = s.Count('film_numbers')  # type: ignore[assignment]
    _units_ = {'fall_rate': 's/m', 'half_speed': 'm/s', 'cold_temperature': 'degC', 'hot_temperature': 'degC', 'zone_y': 'm', 'layer_thickness': 'm', 'layer_modulus': 'Pa', 'layer_yield': 'Pa', 'layer_hardening': 'Pa/m'}
    _defaults_ = {'coefficient': 0.3, 'kinetic_ratio': 0.4, 'fall_rate': 0.6, 'half_speed': 1.0, 'hot_ratio': 0.5, 'hot_temperature': 400.0, 'slope_reduction': 1.0, 'slope_limit': 0.02, 'adhesion_reduction': 1.0, 'slip_reduction': 1.0}
    _fields_ = [
        ('coefficient', c.c_double),
        ('_speed_law', c.c_int32),
        ('_temperature_law', c.c_int32),
        ('kinetic_ratio', c.c_double),
        ('fall_rate', c.c_double),
        ('half_speed', c.c_double),
        ('hot_ratio', c.c_double),
        ('cold_temperature', c.c_double),
        ('hot_temperature', c.c_double),
        ('bulk', BulkTemperatures),
        ('slope_reduction', c.c_double),
        ('slope_limit', c.c_double),
        ('slope_fall', c.c_double),
        ('_zone_y', c.POINTER(c.c_double)),
        ('_zone_coefficients', c.POINTER(c.c_double)),
        ('_zone_count', c.c_uint32),
        ('_zone_frame', c.c_int32),
        ('layer_thickness', c.c_double),
        ('layer_modulus', c.c_double),
        ('layer_yield', c.c_double),
        ('layer_hardening', c.c_double),
        ('adhesion_reduction', c.c_double),
        ('slip_reduction', c.c_double),
        ('_film_rows', c.POINTER(c.c_double)),
        ('_film_numbers', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(Friction) == 240


class WheelState(s.Struct):
    """Where a wheel or wheelset is and how it moves, against the ground.

    Members:
      reference: WheelReference: of y, z, velocity and the wrench's moment (default WheelReference.WHEELSET)
      orientation: Orientation: by roll and yaw, or by rotation (default Orientation.ANGLES)
      angular_axes: Axes: by roll_rate, pitch_rate, yaw_rate, or by angular_velocity (default Axes.NONE)
      y [m]: displacement of the reference point to the right (-0.2 .. 0.2; default 0)
      z [m]: the same downwards; 0 is the nominal height (-0.5 .. 0.2; default 0)
      roll [rad]: about x, right wheel down; 0 with a matrix (-0.5 .. 0.5; default 0)
      yaw [rad]: about the rolled z, nose to the right; 0 with a matrix (-0.5 .. 0.5; default 0)
      velocity [m/s]: of the reference point, track axes (-200 .. 200, -50 .. 50, -50 .. 50; default 0)
      roll_rate [rad/s]: time derivative of roll (-200 .. 200; default 0)
      pitch_rate [rad/s]: about the axle, -v / r0 rolling forwards (-2000 .. 2000; default 0)
      yaw_rate [rad/s]: time derivative of yaw (-200 .. 200; default 0)
      angular_velocity [rad/s]: whole, in the axes that angular_axes says (-200 .. 200, -2000 .. 2000, -200 ..
          200; default 0)
      rotation: R of track = R body, orthonormal to 1e-6, its axle within 0.5 rad of the track's y (-1.001 ..
          1.001; default 0)
    """

    _c_name_ = 'wrc_wheel_state'
    __slots__ = ()
    reference: WheelReference = s.Chosen('reference', WheelReference)  # type: ignore[assignment]
    orientation: Orientation = s.Chosen('orientation', Orientation)  # type: ignore[assignment]
    angular_axes: Axes = s.Chosen('angular_axes', Axes)  # type: ignore[assignment]
    y: float
    z: float
    roll: float
    yaw: float
    velocity: np.ndarray = s.Array('velocity', 48, (3,), c.c_double)  # type: ignore[assignment]
    roll_rate: float
    pitch_rate: float
    yaw_rate: float
    angular_velocity: np.ndarray = s.Array('angular_velocity', 96, (3,), c.c_double)  # type: ignore[assignment]
    rotation: np.ndarray = s.Array('rotation', 120, (9,), c.c_double)  # type: ignore[assignment]
    _units_ = {'y': 'm', 'z': 'm', 'roll': 'rad', 'yaw': 'rad', 'velocity': 'm/s', 'roll_rate': 'rad/s', 'pitch_rate': 'rad/s', 'yaw_rate': 'rad/s', 'angular_velocity': 'rad/s'}
    _fields_ = [
        ('_reference', c.c_int32),
        ('_orientation', c.c_int32),
        ('_angular_axes', c.c_int32),
        ('_reserved0', c.c_uint32),
        ('y', c.c_double),
        ('z', c.c_double),
        ('roll', c.c_double),
        ('yaw', c.c_double),
        ('_velocity', c.c_double * 3),
        ('roll_rate', c.c_double),
        ('pitch_rate', c.c_double),
        ('yaw_rate', c.c_double),
        ('_angular_velocity', c.c_double * 3),
        ('_rotation', c.c_double * 9),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(WheelState) == 240


class RailState(s.Struct):
    """Displacement and motion of a rail, track axes. Velocities are those of its material: a bent rail at rest
        has none, and speed * slope is never one. Its slopes say where it leads: it is turned about P, the
        shortest way, into (1, y_slope, z_slope). Sections of a rail are turned with it. A roller has no
        slopes.

    Members:
      y [m]: displacement of the origin of its profile to the right, at the wheel (-0.2 .. 0.2; default 0)
      z [m]: the same downwards (-0.2 .. 0.2; default 0)
      roll [rad]: rotation about that origin and the x axis (-0.5 .. 0.5; default 0)
      y_slope: dy / dx of the rail at the wheel (-0.1 .. 0.1; default 0)
      z_slope: dz / dx of the rail at the wheel (-0.1 .. 0.1; default 0)
      y_velocity [m/s]: of its material along y (-50 .. 50; default 0)
      z_velocity [m/s]: of its material along z (-50 .. 50; default 0)
      roll_rate [rad/s]: of its material about x (-200 .. 200; default 0)
    """

    _c_name_ = 'wrc_rail_state'
    __slots__ = ()
    y: float
    z: float
    roll: float
    y_slope: float
    z_slope: float
    y_velocity: float
    z_velocity: float
    roll_rate: float
    _units_ = {'y': 'm', 'z': 'm', 'roll': 'rad', 'y_velocity': 'm/s', 'z_velocity': 'm/s', 'roll_rate': 'rad/s'}
    _fields_ = [
        ('y', c.c_double),
        ('z', c.c_double),
        ('roll', c.c_double),
        ('y_slope', c.c_double),
        ('z_slope', c.c_double),
        ('y_velocity', c.c_double),
        ('z_velocity', c.c_double),
        ('roll_rate', c.c_double),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(RailState) == 112


class FrameMotion(s.Struct):
    """How a frame moves that follows a curved track, for hosts whose velocities are those within it. Its origin
        is on the track centre line, level with the rails' tops. It turns at speed * (twist,
        vertical_curvature, curvature) about its axes. That motion is added to the wheel's. All zero:
        velocities are against the ground. Velocities of the rail always are.

    Members:
      speed [m/s]: of its origin along the track (-200 .. 200; default 0)
      curvature [1/m]: of the track in plan, to the right (-0.1 .. 0.1; default 0)
      vertical_curvature [1/m]: of the track's height, upwards as in a dip (-0.1 .. 0.1; default 0)
      twist [1/m]: rate of the cant over the speed, right side down (-0.5 .. 0.5; default 0)
    """

    _c_name_ = 'wrc_frame_motion'
    __slots__ = ()
    speed: float
    curvature: float
    vertical_curvature: float
    twist: float
    _units_ = {'speed': 'm/s', 'curvature': '1/m', 'vertical_curvature': '1/m', 'twist': '1/m'}
    _fields_ = [
        ('speed', c.c_double),
        ('curvature', c.c_double),
        ('vertical_curvature', c.c_double),
        ('twist', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(FrameMotion) == 64


class WheelInput(s.Struct):
    """Input of Contact.wrench(). Data behind its pointers belong to the caller and are only read during the
        call.

    Members:
      prescribed: Prescribed: Prescribed.HEIGHT or _VERTICAL_LOAD (default Prescribed.HEIGHT)
      start: Start (default Start.COLD)
      wheel: where the wheel is and how it moves
      rail: where the rail is and how it moves
      frame: motion of the axes that velocities are given in
      friction: of each strip at its own sliding speed; zones count from the origin of a profile
      vertical_load [N]: vertical force on the wheel, creep forces included, upwards positive (1e2 .. 1e6;
          default 0)
      damping [s/m]: factor of Hunt and Crossley: each strip's pressure is the elastic one times 1 + 3/2
          damping d(overlap)/dt, never below 0 (0 .. 10; default 0)
      distance [m]: of the reference point along the track, for a rail with sections, or from above the axle
          of a roller (-1e7 .. 1e7; default 0)
      angle [rad]: of the wheel about its axle, for one with config.roundness, right-hand rule about y (-1e9
          .. 1e9; default 0)
      roller_rate [rad/s]: angular velocity of a roller about its axle, right-hand rule about y (-2000 ..
          2000; default 0)
      time_step [s]: time since the step that Contact.commit() committed, over which the velocities act; of
          config.surface.memory (0 .. 1e6; default 0)
    """

    _c_name_ = 'wrc_wheel_input'
    __slots__ = ()
    prescribed: Prescribed = s.Chosen('prescribed', Prescribed)  # type: ignore[assignment]
    start: Start = s.Chosen('start', Start)  # type: ignore[assignment]
    wheel: WheelState
    rail: RailState
    frame: FrameMotion
    friction: Friction
    vertical_load: float
    damping: float
    distance: float
    angle: float
    roller_rate: float
    time_step: float
    _units_ = {'vertical_load': 'N', 'damping': 's/m', 'distance': 'm', 'angle': 'rad', 'roller_rate': 'rad/s', 'time_step': 's'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_prescribed', c.c_int32),
        ('_start', c.c_int32),
        ('_reserved0', c.c_uint32),
        ('wheel', WheelState),
        ('rail', RailState),
        ('frame', FrameMotion),
        ('friction', Friction),
        ('vertical_load', c.c_double),
        ('damping', c.c_double),
        ('distance', c.c_double),
        ('angle', c.c_double),
        ('roller_rate', c.c_double),
        ('time_step', c.c_double),
    ]
assert c.sizeof(WheelInput) == 720


class Wrench(s.Struct):
    """Forces and moments between a wheel and its rail. All are zero but z and clearance where they do not touch.

    Members:
      flags: bit 1 << flag for each WRC_FLAG_... met
      region_count: separate regions in contact: Contact.region()
      iterations: of the normal problem, all of the call
      force [N]: on the wheel, track axes
      moment [N m]: on the wheel about its reference point, track axes
      rail_force [N]: on the rail, track axes: -force
      rail_moment [N m]: on the rail about the displaced origin of its profile, track axes
      z [m]: displacement of the reference point, as given or as found
      clearance [m]: apart, at a given height: by how much the wheel must be lowered to touch. 50e-3: that or
          more. Contact.exact_wrench() has 0
      normal_force [N]: sum over the regions of the resultants of their pressures. It steps where regions join
      area [m^2]:
      peak_pressure [Pa]:
      power [W]: frictional power, >= 0
      steepest_angle [rad]: largest angle of a rail strip in contact against the horizontal. It steps where
          strips enter
      residual: part of the area that the last iteration of the normal problem moved: within
          config.surface.tolerance but for Status.FLAG_ITERATION_CAP. Of NormalMethod.STRIP_HALFSPACE
      work: of the call, in the unit of config.surface.max_work
    """

    _c_name_ = 'wrc_wrench'
    __slots__ = ()
    flags: Flags = s.Chosen('flags', Flags)  # type: ignore[assignment]
    region_count: int
    iterations: int
    force: np.ndarray = s.Array('force', 16, (3,), c.c_double)  # type: ignore[assignment]
    moment: np.ndarray = s.Array('moment', 40, (3,), c.c_double)  # type: ignore[assignment]
    rail_force: np.ndarray = s.Array('rail_force', 64, (3,), c.c_double)  # type: ignore[assignment]
    rail_moment: np.ndarray = s.Array('rail_moment', 88, (3,), c.c_double)  # type: ignore[assignment]
    z: float
    clearance: float
    normal_force: float
    area: float
    peak_pressure: float
    power: float
    steepest_angle: float
    residual: float
    work: float
    _units_ = {'force': 'N', 'moment': 'N m', 'rail_force': 'N', 'rail_moment': 'N m', 'z': 'm', 'clearance': 'm', 'normal_force': 'N', 'area': 'm^2', 'peak_pressure': 'Pa', 'power': 'W', 'steepest_angle': 'rad'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_flags', c.c_uint32),
        ('region_count', c.c_int32),
        ('iterations', c.c_int32),
        ('_force', c.c_double * 3),
        ('_moment', c.c_double * 3),
        ('_rail_force', c.c_double * 3),
        ('_rail_moment', c.c_double * 3),
        ('z', c.c_double),
        ('clearance', c.c_double),
        ('normal_force', c.c_double),
        ('area', c.c_double),
        ('peak_pressure', c.c_double),
        ('power', c.c_double),
        ('steepest_angle', c.c_double),
        ('residual', c.c_double),
        ('work', c.c_double),
    ]
assert c.sizeof(Wrench) == 184


class WrenchDerivatives(s.Struct):
    """Derivatives of the wrench on the wheel about its reference point. What is prescribed is held: under a
        given load the height follows all other inputs, and the column of z is zero.

    Members:
      wrench: rows force x, y, z [N], moment x, y, z [N m]; columns WrenchInput, the rest 0
      z: of Wrench.z; columns the same
    """

    _c_name_ = 'wrc_wrench_derivatives'
    __slots__ = ()
    wrench: np.ndarray = s.Array('wrench', 8, (6, 32), c.c_double)  # type: ignore[assignment]
    z: np.ndarray = s.Array('z', 1544, (32,), c.c_double)  # type: ignore[assignment]
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_wrench', (c.c_double * 32) * 6),
        ('_z', c.c_double * 32),
    ]
assert c.sizeof(WrenchDerivatives) == 1800


class Creepage(s.Struct):
    """Rigid slip of the wheel over the rail per rolled length. At (x, y) of the contact plane it is
        (longitudinal - spin y, lateral + spin x). An amount below 1e-100 counts as 0.

    Members:
      longitudinal: nu_x (-10 .. 10; default 0)
      lateral: nu_y (-10 .. 10; default 0)
      spin [1/m]: phi (-1000 .. 1000; default 0)
      speed [m/s]: rolling speed V. Its sign says which edge leads, its amount scales power (-200 .. 200;
          default 1)
      approach_velocity [m/s]: result of Contact.planar_creepages(): of the wheel into the rail along the
          normal
      reverse_share: share of the solution that rolls the other way: near standstill both are solved. A result
          of Contact.planar_creepages() (0 .. 0.5; default 0)
    """

    _c_name_ = 'wrc_creepage'
    __slots__ = ()
    longitudinal: float
    lateral: float
    spin: float
    speed: float
    approach_velocity: float
    reverse_share: float
    _units_ = {'spin': '1/m', 'speed': 'm/s', 'approach_velocity': 'm/s'}
    _defaults_ = {'speed': 1.0}
    _fields_ = [
        ('longitudinal', c.c_double),
        ('lateral', c.c_double),
        ('spin', c.c_double),
        ('speed', c.c_double),
        ('approach_velocity', c.c_double),
        ('reverse_share', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(Creepage) == 80


class Ellipse(s.Struct):
    """An equivalent double ellipse and its load: two half ellipses of equal length that meet at the joint.

    Members:
      a [m]: semi-axis along rolling (1e-6 .. 0.1; default 0)
      b [m]: half its width. It reaches from y - b (1 - psi) to y + b (1 + psi) (1e-6 .. 0.1; default 0)
      psi: shape number; 0 is an ellipse; paper eq. 2 (-0.95 .. 0.95; default 0)
      y [m]: result: its joint, as Field.STRIP_Y
      normal_force [N]: compressive positive, damping included (1e-3 .. 1e7; default 0)
    """

    _c_name_ = 'wrc_ellipse'
    __slots__ = ()
    a: float
    b: float
    psi: float
    y: float
    normal_force: float
    _units_ = {'a': 'm', 'b': 'm', 'y': 'm', 'normal_force': 'N'}
    _fields_ = [
        ('a', c.c_double),
        ('b', c.c_double),
        ('psi', c.c_double),
        ('y', c.c_double),
        ('normal_force', c.c_double),
        ('_reserved', c.c_double * 3),
    ]
assert c.sizeof(Ellipse) == 64


class Region(s.Struct):
    """One region of a wheel in contact, a run of neighbouring strips, or one patch of a contact plane. The
        wrench does not depend on where regions are divided.

    Members:
      available: bits of Available; members without their bit are 0
      strip_count: number of its strips
      cell_count: cells along each of them
      surface: of the rail, as RailSection.surface. With a check rail 0 is that and 1 the rail
      point [m]: wheel: centre of pressure, x from the reference point; plane: the ellipse's joint; track axes
      normal: unit vector into the rail, track axes
      y_wheel [m]: that point in the coordinates of the wheel's profile, flange side negative
      z_wheel [m]: the same, down from the tape circle
      y_rail [m]: that point in the coordinates of the rail's profile, field side positive
      z_rail [m]: the same, down from the profile's origin
      angle [rad]: contact angle about x from the track's z to the normal; < 0 on the right rail's gauge side
      rolling_radius [m]: of the wheel at that point
      force [N]: on the wheel, track axes
      moment [N m]: on the wheel about point, track axes
      normal_force [N]: resultant of the pressure, compressive positive
      longitudinal_force [N]: sum of the strips' tangential forces along x
      lateral_force [N]: sum of the strips' tangential forces across the rail, to the right
      spin_moment [N m]: of tractions about the normal. Wheel: through point; plane: through the origin of its
          frame
      creepage: wheel: means over the load; plane: as given
      ellipse: its equivalent double ellipse, of a wheel laid flat along the rail's arc
      area [m^2]:
      length [m]: extent along x: foremost to rearmost edge of all strips
      width [m]: extent across: y_max - y_min
      y_min [m]: border, as Field.STRIP_Y
      y_max [m]: see y_min
      peak_pressure [Pa]:
      power [W]: frictional power
      adhesion_fraction: share of the area that sticks; Available.TRACTIONS
    """

    _c_name_ = 'wrc_region'
    __slots__ = ()
    available: Available = s.Chosen('available', Available)  # type: ignore[assignment]
    strip_count: int
    cell_count: int
    surface: int
    point: np.ndarray = s.Array('point', 24, (3,), c.c_double)  # type: ignore[assignment]
    normal: np.ndarray = s.Array('normal', 48, (3,), c.c_double)  # type: ignore[assignment]
    y_wheel: float
    z_wheel: float
    y_rail: float
    z_rail: float
    angle: float
    rolling_radius: float
    force: np.ndarray = s.Array('force', 120, (3,), c.c_double)  # type: ignore[assignment]
    moment: np.ndarray = s.Array('moment', 144, (3,), c.c_double)  # type: ignore[assignment]
    normal_force: float
    longitudinal_force: float
    lateral_force: float
    spin_moment: float
    creepage: Creepage
    ellipse: Ellipse
    area: float
    length: float
    width: float
    y_min: float
    y_max: float
    peak_pressure: float
    power: float
    adhesion_fraction: float
    _units_ = {'point': 'm', 'y_wheel': 'm', 'z_wheel': 'm', 'y_rail': 'm', 'z_rail': 'm', 'angle': 'rad', 'rolling_radius': 'm', 'force': 'N', 'moment': 'N m', 'normal_force': 'N', 'longitudinal_force': 'N', 'lateral_force': 'N', 'spin_moment': 'N m', 'area': 'm^2', 'length': 'm', 'width': 'm', 'y_min': 'm', 'y_max': 'm', 'peak_pressure': 'Pa', 'power': 'W'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_available', c.c_uint32),
        ('strip_count', c.c_int32),
        ('cell_count', c.c_int32),
        ('surface', c.c_int32),
        ('_reserved0', c.c_uint32),
        ('_point', c.c_double * 3),
        ('_normal', c.c_double * 3),
        ('y_wheel', c.c_double),
        ('z_wheel', c.c_double),
        ('y_rail', c.c_double),
        ('z_rail', c.c_double),
        ('angle', c.c_double),
        ('rolling_radius', c.c_double),
        ('_force', c.c_double * 3),
        ('_moment', c.c_double * 3),
        ('normal_force', c.c_double),
        ('longitudinal_force', c.c_double),
        ('lateral_force', c.c_double),
        ('spin_moment', c.c_double),
        ('creepage', Creepage),
        ('ellipse', Ellipse),
        ('area', c.c_double),
        ('length', c.c_double),
        ('width', c.c_double),
        ('y_min', c.c_double),
        ('y_max', c.c_double),
        ('peak_pressure', c.c_double),
        ('power', c.c_double),
        ('adhesion_fraction', c.c_double),
    ]
assert c.sizeof(Region) == 408


class Damage(s.Struct):
    """Wear and fatigue numbers of a region.

    Members:
      power [W]: frictional power
      peak_power_density [W/m^2]: Available.TRACTIONS
      t_gamma [N]: power / speed: energy dissipated per metre rolled, spin included
      t_gamma_no_spin [N]: |Fx nu_x + Fy nu_y|: the other definition in use
      utilisation: mu_a = sqrt(Fx^2 + Fy^2) / N: abscissa of the shakedown map
      load_factor: p0 / k: ordinate of the shakedown map
      shakedown_limit: of load_factor at mu_a, line contact; ratcheting above
      fatigue_index: FI = mu_a - k / p0, paper eq. 11; damage when positive
      local_fatigue_index: largest local index over the region, paper eq. 12; Available.TRACTIONS
      available: bits of Available; members without their bit are 0
    """

    _c_name_ = 'wrc_damage'
    __slots__ = ()
    power: float
    peak_power_density: float
    t_gamma: float
    t_gamma_no_spin: float
    utilisation: float
    load_factor: float
    shakedown_limit: float
    fatigue_index: float
    local_fatigue_index: float
    available: Available = s.Chosen('available', Available)  # type: ignore[assignment]
    _units_ = {'power': 'W', 'peak_power_density': 'W/m^2', 't_gamma': 'N', 't_gamma_no_spin': 'N'}
    _fields_ = [
        ('power', c.c_double),
        ('peak_power_density', c.c_double),
        ('t_gamma', c.c_double),
        ('t_gamma_no_spin', c.c_double),
        ('utilisation', c.c_double),
        ('load_factor', c.c_double),
        ('shakedown_limit', c.c_double),
        ('fatigue_index', c.c_double),
        ('local_fatigue_index', c.c_double),
        ('_available', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(Damage) == 128


class PlanarPose(s.Struct):
    """Pose of the wheelset, track frame. Its height follows from the load. An amount below 1e-100 counts as 0.

    Members:
      lateral [m]: shift of the wheelset to the right (-0.1 .. 0.1; default 0)
      roll [rad]: about x, right wheel down (-0.2 .. 0.2; default 0)
      yaw [rad]: about the rolled z, nose to the right (-0.2 .. 0.2; default 0)
    """

    _c_name_ = 'wrc_planar_pose'
    __slots__ = ()
    lateral: float
    roll: float
    yaw: float
    _units_ = {'lateral': 'm', 'roll': 'rad', 'yaw': 'rad'}
    _fields_ = [
        ('lateral', c.c_double),
        ('roll', c.c_double),
        ('yaw', c.c_double),
        ('_reserved', c.c_double * 3),
    ]
assert c.sizeof(PlanarPose) == 48


class PlanarMotion(s.Struct):
    """Velocity of the wheelset relative to the track, track frame.

    Members:
      speed [m/s]: of its middle along the track, backwards < 0 (-200 .. 200; default 0)
      lateral_velocity [m/s]: to the right (-20 .. 20; default 0)
      vertical_velocity [m/s]: down (-20 .. 20; default 0)
      roll_rate [rad/s]: about x (-100 .. 100; default 0)
      yaw_rate [rad/s]: about z (-100 .. 100; default 0)
      pitch_rate [rad/s]: about the axle, rolling forwards < 0 (-2000 .. 2000; default 0)
    """

    _c_name_ = 'wrc_planar_motion'
    __slots__ = ()
    speed: float
    lateral_velocity: float
    vertical_velocity: float
    roll_rate: float
    yaw_rate: float
    pitch_rate: float
    _units_ = {'speed': 'm/s', 'lateral_velocity': 'm/s', 'vertical_velocity': 'm/s', 'roll_rate': 'rad/s', 'yaw_rate': 'rad/s', 'pitch_rate': 'rad/s'}
    _fields_ = [
        ('speed', c.c_double),
        ('lateral_velocity', c.c_double),
        ('vertical_velocity', c.c_double),
        ('roll_rate', c.c_double),
        ('yaw_rate', c.c_double),
        ('pitch_rate', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(PlanarMotion) == 80


class PlanarPoint(s.Struct):
    """Where wheel and rail first touch when the wheelset of a pose is lowered.

    Members:
      x [m]: of the wheel's point, track frame
      y [m]: on the rail, track frame
      z [m]: see y
      y_wheel [m]: in the coordinates of the wheel profile, flange side negative
      y_rail [m]: from the origin of the rail profile, after canting; field side positive
      angle [rad]: contact angle: rotation about x from the track to the contact frame
      vertical_gap [m]: height by which the wheel must be lowered, from its running circle level with the rail
          top
      rolling_radius [m]: of the wheel at the contact point
    """

    _c_name_ = 'wrc_planar_point'
    __slots__ = ()
    x: float
    y: float
    z: float
    y_wheel: float
    y_rail: float
    angle: float
    vertical_gap: float
    rolling_radius: float
    _units_ = {'x': 'm', 'y': 'm', 'z': 'm', 'y_wheel': 'm', 'y_rail': 'm', 'angle': 'rad', 'vertical_gap': 'm', 'rolling_radius': 'm'}
    _fields_ = [
        ('x', c.c_double),
        ('y', c.c_double),
        ('z', c.c_double),
        ('y_wheel', c.c_double),
        ('y_rail', c.c_double),
        ('angle', c.c_double),
        ('vertical_gap', c.c_double),
        ('rolling_radius', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(PlanarPoint) == 96


class PlanarGap(s.Struct):
    """The undeformed gap of a caller: rows along x at increasing y of the contact frame, along the normal. A
        constant offset does not matter. - column_count == 0: row j is height[j] + curvature[j]/2 (x -
        centre[j])^2 - column_count > 0: h[j * row_stride + i] at (x[i], y[j]). Each row is taken as the
        parabola fitted to its lowest part, up to config.planar.gap_limit / 4 above its minimum, with three
        points at least.

    Members:
      row_count: (4 .. config.planar.gap_rows; default 0)
      column_count: (0 or 3 .. 100000; default 0)
      y [m]: row_count of them, increasing by 1e-6 m at least (-0.3 .. 0.3; required)
      height [m]: row_count of them, smallest gap of the row (-0.3 .. 0.3; required)
      centre [m]: row_count of them, x of that smallest gap; None: zero (-0.3 .. 0.3; default None)
      curvature [1/m]: row_count of them, d2h/dx2. 1 / rolling radius on a straight rail (1e-3 .. 1e6;
          required)
      x [m]: column_count of them, increasing by 1e-6 m at least (-0.3 .. 0.3; required)
      h [m]: gap of each element (-0.3 .. 0.3; required)
      row_stride: elements from one row of h to the next, >= column_count (default 0)
    """

    _c_name_ = 'wrc_planar_gap'
    __slots__ = ()
    row_count: int = s.Count('row_count')  # type: ignore[assignment]
    column_count: int = s.Count('column_count')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', 'row_count')  # type: ignore[assignment]
    height: Optional[np.ndarray] = s.Pointer('height', 'row_count')  # type: ignore[assignment]
    centre: Optional[np.ndarray] = s.Pointer('centre', 'row_count')  # type: ignore[assignment]
    curvature: Optional[np.ndarray] = s.Pointer('curvature', 'row_count')  # type: ignore[assignment]
    x: Optional[np.ndarray] = s.Pointer('x', 'column_count')  # type: ignore[assignment]
    h: Optional[np.ndarray] = s.Pointer('h', 'row_count', 'column_count', stride='row_stride')  # type: ignore[assignment]
    row_stride: int
    _units_ = {'y': 'm', 'height': 'm', 'centre': 'm', 'curvature': '1/m', 'x': 'm', 'h': 'm'}
    _fields_ = [
        ('_row_count', c.c_uint32),
        ('_column_count', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_height', c.POINTER(c.c_double)),
        ('_centre', c.POINTER(c.c_double)),
        ('_curvature', c.POINTER(c.c_double)),
        ('_x', c.POINTER(c.c_double)),
        ('_h', c.POINTER(c.c_double)),
        ('row_stride', c.c_uint64),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(PlanarGap) == 96


class PlanarLoad(s.Struct):
    """Load that presses the bodies together. Damping is that of Hunt and Crossley, J. Appl. Mech. 42 (1975)
        440-445: every pressure is the elastic one times 1 + 3/2 damping * approach_velocity, never below 0.
        An impact at v m/s rebounds with about (1 - damping v) of its velocity.

    Members:
      prescribed: Prescribed: Prescribed.NORMAL_FORCE or _APPROACH (default Prescribed.NORMAL_FORCE)
      normal_force [N]: along the contact normal (1e2 .. 1e6; default 0)
      approach [m]: beyond first touch; <= 0: no contact (-1 .. 0.01; default 0)
      approach_velocity [m/s]: d approach / dt; positive while the bodies near each other (-20 .. 20; default
          0)
      damping [s/m]: factor of Hunt and Crossley; 0: none (0 .. 10; default 0)
    """

    _c_name_ = 'wrc_planar_load'
    __slots__ = ()
    prescribed: Prescribed = s.Chosen('prescribed', Prescribed)  # type: ignore[assignment]
    normal_force: float
    approach: float
    approach_velocity: float
    damping: float
    _units_ = {'normal_force': 'N', 'approach': 'm', 'approach_velocity': 'm/s', 'damping': 's/m'}
    _defaults_ = {'_prescribed': 2}
    _fields_ = [
        ('_prescribed', c.c_int32),
        ('_reserved0', c.c_uint32),
        ('normal_force', c.c_double),
        ('approach', c.c_double),
        ('approach_velocity', c.c_double),
        ('damping', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(PlanarLoad) == 72


class PlanarStrips(s.Struct):
    """A pressure distribution of the caller: strips along x with semi-elliptic pressure.

    Members:
      count: number of strips (1 .. config.planar.strips; default 0)
      y [m]: middle, count of them, increasing; strips do not overlap (-0.3 .. 0.3; required)
      width [m]: count of them (1e-9 .. 0.1; required)
      centre [m]: x of the middle, count of them; None: zero (-0.3 .. 0.3; default None)
      half_length [m]: count of them (1e-9 .. 0.1; required)
      peak [Pa]: peak pressure, count of them (0 .. 1e11; required)
    """

    _c_name_ = 'wrc_planar_strips'
    __slots__ = ()
    count: int = s.Count('count')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', 'count')  # type: ignore[assignment]
    width: Optional[np.ndarray] = s.Pointer('width', 'count')  # type: ignore[assignment]
    centre: Optional[np.ndarray] = s.Pointer('centre', 'count')  # type: ignore[assignment]
    half_length: Optional[np.ndarray] = s.Pointer('half_length', 'count')  # type: ignore[assignment]
    peak: Optional[np.ndarray] = s.Pointer('peak', 'count')  # type: ignore[assignment]
    _units_ = {'y': 'm', 'width': 'm', 'centre': 'm', 'half_length': 'm', 'peak': 'Pa'}
    _fields_ = [
        ('_count', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_width', c.POINTER(c.c_double)),
        ('_centre', c.POINTER(c.c_double)),
        ('_half_length', c.POINTER(c.c_double)),
        ('_peak', c.POINTER(c.c_double)),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(PlanarStrips) == 80


class PlanarNormalSolution(s.Struct):
    """Solution of the normal problem, all patches together.

    Members:
      patch_count: separate patches: Contact.region() has each
      strip_count: strips under pressure
      iterations: of the load search, or sweeps
      flags: bit 1 << flag for each WRC_FLAG_... met
      ellipse: of the patch that carries most
      normal_force [N]: compressive positive, damping included
      damping_force [N]: share of normal_force that is damping; < 0 while the bodies part
      approach [m]: beyond first touch, along the normal; 0 for an ellipse or strips of the caller
      stiffness [N/m]: d normal_force / d approach; of STRIP_HALFSPACE and ANALYN within 6 %
      peak_pressure [Pa]: largest pressure as solved, not of the equivalent ellipse
      area [m^2]:
      length [m]: extent along x: foremost to rearmost edge of all strips
      width [m]: extent along y: y_max - y_min
      y_min [m]: lateral border
      y_max [m]: see y_min
    """

    _c_name_ = 'wrc_planar_normal_solution'
    __slots__ = ()
    patch_count: int
    strip_count: int
    iterations: int
    flags: Flags = s.Chosen('flags', Flags)  # type: ignore[assignment]
    ellipse: Ellipse
    normal_force: float
    damping_force: float
    approach: float
    stiffness: float
    peak_pressure: float
    area: float
    length: float
    width: float
    y_min: float
    y_max: float
    _units_ = {'normal_force': 'N', 'damping_force': 'N', 'approach': 'm', 'stiffness': 'N/m', 'peak_pressure': 'Pa', 'area': 'm^2', 'length': 'm', 'width': 'm', 'y_min': 'm', 'y_max': 'm'}
    _fields_ = [
        ('patch_count', c.c_int32),
        ('strip_count', c.c_int32),
        ('iterations', c.c_int32),
        ('_flags', c.c_uint32),
        ('ellipse', Ellipse),
        ('normal_force', c.c_double),
        ('damping_force', c.c_double),
        ('approach', c.c_double),
        ('stiffness', c.c_double),
        ('peak_pressure', c.c_double),
        ('area', c.c_double),
        ('length', c.c_double),
        ('width', c.c_double),
        ('y_min', c.c_double),
        ('y_max', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(PlanarNormalSolution) == 192


class PlanarForces(s.Struct):
    """Forces on the wheel in the contact frame, moment about its origin.

    Members:
      fx [N]: longitudinal creep force
      fy [N]: lateral creep force
      fn [N]: normal force, compressive positive, damping included
      mz [N m]: spin moment
      power [W]: frictional power at the given speed, >= 0
      adhesion_fraction: share of the patch's area that sticks; Available.TRACTIONS
      available: bits of Available; members without their bit are 0
      flags: bit 1 << flag for each WRC_FLAG_... met
    """

    _c_name_ = 'wrc_planar_forces'
    __slots__ = ()
    fx: float
    fy: float
    fn: float
    mz: float
    power: float
    adhesion_fraction: float
    available: Available = s.Chosen('available', Available)  # type: ignore[assignment]
    flags: Flags = s.Chosen('flags', Flags)  # type: ignore[assignment]
    _units_ = {'fx': 'N', 'fy': 'N', 'fn': 'N', 'mz': 'N m', 'power': 'W'}
    _fields_ = [
        ('fx', c.c_double),
        ('fy', c.c_double),
        ('fn', c.c_double),
        ('mz', c.c_double),
        ('power', c.c_double),
        ('adhesion_fraction', c.c_double),
        ('_available', c.c_uint32),
        ('_flags', c.c_uint32),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(PlanarForces) == 88


class PlanarDerivatives(s.Struct):
    """Derivatives of the forces of the last Contact.planar_tangential() at its patch.

    Members:
      forces: rows fx, fy [N], mz [N m]; columns longitudinal, lateral [-], spin [1/m], normal_force [N] of
          the same patch, factor on friction [-], the rest 0
    """

    _c_name_ = 'wrc_planar_derivatives'
    __slots__ = ()
    forces: np.ndarray = s.Array('forces', 8, (3, 8), c.c_double)  # type: ignore[assignment]
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_forces', (c.c_double * 8) * 3),
    ]
assert c.sizeof(PlanarDerivatives) == 200


class PlanarInput(s.Struct):
    """Input of Contact.planar_step(). Data behind its pointers belong to the caller and are only read during the
        call.

    Members:
      pose: of the wheelset; not used with gap, but within its ranges
      gap: a gap of the caller in place of the pose; None: the pose (default None)
      load: load that presses the bodies together
      creepage: rigid slip at the origin of the contact frame
      friction: between the bodies
    """

    _c_name_ = 'wrc_planar_input'
    __slots__ = ()
    pose: PlanarPose
    gap: Optional[PlanarGap] = s.Reference('gap')  # type: ignore[assignment]
    load: PlanarLoad
    creepage: Creepage
    friction: Friction
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('pose', PlanarPose),
        ('_gap', c.POINTER(PlanarGap)),
        ('load', PlanarLoad),
        ('creepage', Creepage),
        ('friction', Friction),
    ]
assert c.sizeof(PlanarInput) == 456


class PlanarOutput(s.Struct):
    """Results of Contact.planar_step().

    Members:
      flags: bit 1 << flag for each WRC_FLAG_... met, of all stages
      point: zero when there was no pose
      normal: of the normal stage
      forces: of the tangential stage
      damage: of all patches together
    """

    _c_name_ = 'wrc_planar_output'
    __slots__ = ()
    flags: Flags = s.Chosen('flags', Flags)  # type: ignore[assignment]
    point: PlanarPoint
    normal: PlanarNormalSolution
    forces: PlanarForces
    damage: Damage
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_flags', c.c_uint32),
        ('point', PlanarPoint),
        ('normal', PlanarNormalSolution),
        ('forces', PlanarForces),
        ('damage', Damage),
    ]
assert c.sizeof(PlanarOutput) == 512


class WearLaws(s.Struct):
    """Parameters of the wear laws. Defaults are the published values, in their published units; all are
        unconfirmed (quoted from memory, not checked against the original texts) and depend on the pair of
        steels. Theory manual, section 6. - T-gamma: area lost per metre rolled (Pearce and Sherratt, Wear 144
        (1991)), over the wheel's diameter. - Sheffield: depth per metre rolled from T-gamma per area (R8T
        wheel on UIC60 900A; Braghin et al. 2006). - Archard: depth per second, k p v / hardness with the map
        of Jendel (Wear 253 (2002)). - Power law: depth per second, power_coefficient / density * q (q /
        power_reference)^(power_exponent - 1), q the frictional power density. With exponent 1 mass is worn in
        proportion to energy: the mild regime of Zobory (VSD 28 (1997)), which ends at 4 W/mm^2.

    Members:
      t_gamma_mild_end [N]: T-gamma up to which wear is mild (1e-3 .. 1e9; default 100)
      t_gamma_severe_start [N]: T-gamma from which it is severe, not below t_gamma_mild_end (1e-3 .. 1e9;
          default 200)
      t_gamma_mild_slope [mm^3/(km N)]: area * diameter per T-gamma, mild (0 .. 1e6; default 0.25)
      t_gamma_plateau [mm^3/km]: area * diameter between the two (0 .. 1e9; default 25)
      t_gamma_severe_slope [mm^3/(km N)]: as t_gamma_mild_slope, severe (0 .. 1e6; default 1.19)
      t_gamma_severe_offset [mm^3/km]: subtracted in the severe regime; the law must not turn negative (0 ..
          1e15; default 154)
      sheffield_mild_end [N/mm^2]: T-gamma per area up to which wear is mild (1e-6 .. 1e9; default 10.4)
      sheffield_severe_end [N/mm^2]: T-gamma per area from which it is catastrophic, not below
          sheffield_mild_end (1e-6 .. 1e9; default 77.2)
      sheffield_mild_slope [microgram/(m N)]: rate per T-gamma per area, mild (0 .. 1e6; default 5.3)
      sheffield_catastrophic_slope [microgram/(m N)]: the same, catastrophic (0 .. 1e6; default 61.9)
      density [kg/m^3]: of the worn material (100 .. 1e5; default 7850)
      hardness [Pa]: of the softer body (1e6 .. 1e12; default 3e9)
      archard_slow: coefficient below archard_severe_start (0 .. 1; default 5e-4)
      archard_severe: coefficient between the two speeds (0 .. 1; default 35e-4)
      archard_fast: coefficient above archard_severe_end (0 .. 1; default 5e-4)
      archard_seizure: coefficient where pressure exceeds seizure_pressure * hardness (0 .. 1; default 350e-4)
      archard_severe_start [m/s]: sliding velocity from which wear is severe (0 .. 1000; default 0.2)
      archard_severe_end [m/s]: sliding velocity up to which it is severe, not below archard_severe_start (0
          .. 1000; default 0.7)
      seizure_pressure: share of the hardness (0 .. 1000; default 0.8)
      power_coefficient [kg/J]: mass worn per energy at power_reference (0 .. 1; default 7e-10)
      power_exponent: of the frictional power density (0.25 .. 4; default 1)
      power_reference [W/m^2]: power density at which power_coefficient holds (1 .. 1e12; default 4e6)
    """

    _c_name_ = 'wrc_wear_laws'
    __slots__ = ()
    t_gamma_mild_end: float
    t_gamma_severe_start: float
    t_gamma_mild_slope: float
    t_gamma_plateau: float
    t_gamma_severe_slope: float
    t_gamma_severe_offset: float
    sheffield_mild_end: float
    sheffield_severe_end: float
    sheffield_mild_slope: float
    sheffield_catastrophic_slope: float
    density: float
    hardness: float
    archard_slow: float
    archard_severe: float
    archard_fast: float
    archard_seizure: float
    archard_severe_start: float
    archard_severe_end: float
    seizure_pressure: float
    power_coefficient: float
    power_exponent: float
    power_reference: float
    _units_ = {'t_gamma_mild_end': 'N', 't_gamma_severe_start': 'N', 't_gamma_mild_slope': 'mm^3/(km N)', 't_gamma_plateau': 'mm^3/km', 't_gamma_severe_slope': 'mm^3/(km N)', 't_gamma_severe_offset': 'mm^3/km', 'sheffield_mild_end': 'N/mm^2', 'sheffield_severe_end': 'N/mm^2', 'sheffield_mild_slope': 'microgram/(m N)', 'sheffield_catastrophic_slope': 'microgram/(m N)', 'density': 'kg/m^3', 'hardness': 'Pa', 'archard_severe_start': 'm/s', 'archard_severe_end': 'm/s', 'power_coefficient': 'kg/J', 'power_reference': 'W/m^2'}
    _defaults_ = {'t_gamma_mild_end': 100.0, 't_gamma_severe_start': 200.0, 't_gamma_mild_slope': 0.25, 't_gamma_plateau': 25.0, 't_gamma_severe_slope': 1.19, 't_gamma_severe_offset': 154.0, 'sheffield_mild_end': 10.4, 'sheffield_severe_end': 77.2, 'sheffield_mild_slope': 5.3, 'sheffield_catastrophic_slope': 61.9, 'density': 7850.0, 'hardness': 3000000000.0, 'archard_slow': 0.0005, 'archard_severe': 0.0035, 'archard_fast': 0.0005, 'archard_seizure': 0.035, 'archard_severe_start': 0.2, 'archard_severe_end': 0.7, 'seizure_pressure': 0.8, 'power_coefficient': 7e-10, 'power_exponent': 1.0, 'power_reference': 4000000.0}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('t_gamma_mild_end', c.c_double),
        ('t_gamma_severe_start', c.c_double),
        ('t_gamma_mild_slope', c.c_double),
        ('t_gamma_plateau', c.c_double),
        ('t_gamma_severe_slope', c.c_double),
        ('t_gamma_severe_offset', c.c_double),
        ('sheffield_mild_end', c.c_double),
        ('sheffield_severe_end', c.c_double),
        ('sheffield_mild_slope', c.c_double),
        ('sheffield_catastrophic_slope', c.c_double),
        ('density', c.c_double),
        ('hardness', c.c_double),
        ('archard_slow', c.c_double),
        ('archard_severe', c.c_double),
        ('archard_fast', c.c_double),
        ('archard_seizure', c.c_double),
        ('archard_severe_start', c.c_double),
        ('archard_severe_end', c.c_double),
        ('seizure_pressure', c.c_double),
        ('power_coefficient', c.c_double),
        ('power_exponent', c.c_double),
        ('power_reference', c.c_double),
    ]
assert c.sizeof(WearLaws) == 184


class Wear(s.Struct):
    """Wear of one region.

    Members:
      worn_area_rate [m^2/m]: T-gamma law: area lost from the wheel's section per metre rolled
      largest_depth_rate [m/m]: Sheffield: depth per metre rolled of the worst cell
      largest_depth_velocity [m/s]: Archard: depth per second in contact of the worst cell
      largest_power_depth_velocity [m/s]: power law: the same
    """

    _c_name_ = 'wrc_wear'
    __slots__ = ()
    worn_area_rate: float
    largest_depth_rate: float
    largest_depth_velocity: float
    largest_power_depth_velocity: float
    _units_ = {'worn_area_rate': 'm^2/m', 'largest_depth_rate': 'm/m', 'largest_depth_velocity': 'm/s', 'largest_power_depth_velocity': 'm/s'}
    _fields_ = [
        ('worn_area_rate', c.c_double),
        ('largest_depth_rate', c.c_double),
        ('largest_depth_velocity', c.c_double),
        ('largest_power_depth_velocity', c.c_double),
        ('_reserved', c.c_double * 6),
    ]
assert c.sizeof(Wear) == 80


class Coefficients(s.Struct):
    """Coefficients of the linear theory for one patch shape (theory manual, section 4).

    Members:
      c11: Kalker's, for the ellipse a, b
      c22: see c11
      c23: see c11
      c11s: of the double ellipse, about its joint; paper eq. 5
      c13s: see c11s
      c22s: see c11s
      c23s: see c11s
    """

    _c_name_ = 'wrc_coefficients'
    __slots__ = ()
    c11: float
    c22: float
    c23: float
    c11s: float
    c13s: float
    c22s: float
    c23s: float
    _fields_ = [
        ('c11', c.c_double),
        ('c22', c.c_double),
        ('c23', c.c_double),
        ('c11s', c.c_double),
        ('c13s', c.c_double),
        ('c22s', c.c_double),
        ('c23s', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(Coefficients) == 88


class StressPeak(s.Struct):
    """A stress that is the largest of its kind, and where in the body it is: contact frame, but for the depth.

    Members:
      stress [Pa]:
      x [m]: contact frame
      y [m]: see x
      depth [m]: below the body's surface
    """

    _c_name_ = 'wrc_stress_peak'
    __slots__ = ()
    stress: float
    x: float
    y: float
    depth: float
    _units_ = {'stress': 'Pa', 'x': 'm', 'y': 'm', 'depth': 'm'}
    _fields_ = [
        ('stress', c.c_double),
        ('x', c.c_double),
        ('y', c.c_double),
        ('depth', c.c_double),
        ('_reserved', c.c_double * 2),
    ]
assert c.sizeof(StressPeak) == 48


class StressPeaks(s.Struct):
    """Largest stresses in a body, each at its own place.

    Members:
      von_mises: sqrt(3 J2)
      shear: (s1 - s3) / 2: half of Tresca's stress
      tension: s1, the most tensile principal stress; < 0 where all three are compressive
    """

    _c_name_ = 'wrc_stress_peaks'
    __slots__ = ()
    von_mises: StressPeak
    shear: StressPeak
    tension: StressPeak
    _fields_ = [
        ('von_mises', StressPeak),
        ('shear', StressPeak),
        ('tension', StressPeak),
        ('_reserved', StressPeak),
    ]
assert c.sizeof(StressPeaks) == 192


class Stresses(s.Struct):
    """Stresses in one of the bodies as a whole.

    Members:
      body: Body: which
      largest: of the two that follow
      surface: at the surface
      below: beneath it
    """

    _c_name_ = 'wrc_stresses'
    __slots__ = ()
    body: Body = s.Chosen('body', Body)  # type: ignore[assignment]
    largest: StressPeaks
    surface: StressPeaks
    below: StressPeaks
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_body', c.c_int32),
        ('largest', StressPeaks),
        ('surface', StressPeaks),
        ('below', StressPeaks),
    ]
assert c.sizeof(Stresses) == 584


class Temperature(s.Struct):
    """Temperatures in the contact. Wheel and rail have the same where they touch.

    Members:
      at_entry [degC]: of both surfaces as soon as they touch, between those of the bodies
      rise [K]: the largest by friction over that, of all cells
      x [m]: where: contact frame, the middle of the cell
      y [m]: see x
      largest [degC]: at_entry + rise
      mean_rise [K]: over the contact's area
      wheel_heat [W]: that flows into the wheel, of friction and of the bodies' touching
      rail_heat [W]: the same of the rail; both together are the frictional power
    """

    _c_name_ = 'wrc_temperature'
    __slots__ = ()
    at_entry: float
    rise: float
    x: float
    y: float
    largest: float
    mean_rise: float
    wheel_heat: float
    rail_heat: float
    _units_ = {'at_entry': 'degC', 'rise': 'K', 'x': 'm', 'y': 'm', 'largest': 'degC', 'mean_rise': 'K', 'wheel_heat': 'W', 'rail_heat': 'W'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('at_entry', c.c_double),
        ('rise', c.c_double),
        ('x', c.c_double),
        ('y', c.c_double),
        ('largest', c.c_double),
        ('mean_rise', c.c_double),
        ('wheel_heat', c.c_double),
        ('rail_heat', c.c_double),
    ]
assert c.sizeof(Temperature) == 72


class DamageBin(s.Struct):
    """One bin: all zero, nothing was added. Bits are the same whatever the order of additions and merges.

    Members:
      sum: by DamageQuantity: low and high half of an integer of 128 bits, two's complement. Bins.values()
          converts it
      largest_pressure [Pa]:
      largest_traction [Pa]:
      overflow: bit i: sum i, or a contribution to it, passed its range and is worthless
    """

    _c_name_ = 'wrc_damage_bin'
    __slots__ = ()
    sum: np.ndarray = s.Array('sum', 0, (16, 2), c.c_uint64)  # type: ignore[assignment]
    largest_pressure: float
    largest_traction: float
    overflow: int
    _units_ = {'largest_pressure': 'Pa', 'largest_traction': 'Pa'}
    _fields_ = [
        ('_sum', (c.c_uint64 * 2) * 16),
        ('largest_pressure', c.c_double),
        ('largest_traction', c.c_double),
        ('overflow', c.c_uint64),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(DamageBin) == 312


class DamageBins(s.Struct):
    """Bins over the arc length of a profile, 0 at its origin, flange or gauge side negative; of a rail also in
        rows along the track.

    Members:
      count: bins of a row (1 .. 1000000; default 0)
      first [m]: arc length at which the first begins (-1 .. 1; default 0)
      width [m]: of a bin (1e-5 .. 1; default 1e-3)
      row_count: rows along the track; row_count * count 100000000 at most (1 .. 1000000; default 1)
      row_first [m]: distance at which the first row begins (-1e9 .. 1e9; default 0)
      row_length [m]: of a row; 0: one row takes all, whatever the distance (0 or 1e-3 .. 1e9; default 0)
      bins: row_count * count + 1 of the caller, row by row, zeroed before the first use. The last has what
          lies beside all others. They may be copied and saved as bytes
    """

    _c_name_ = 'wrc_damage_bins'
    __slots__ = ()
    count: int
    first: float
    width: float
    row_count: int
    row_first: float
    row_length: float
    bins: Optional[DamageBin] = s.Reference('bins', size='bin_size')  # type: ignore[assignment]
    _units_ = {'first': 'm', 'width': 'm', 'row_first': 'm', 'row_length': 'm'}
    _defaults_ = {'width': 0.001, 'row_count': 1}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('count', c.c_uint32),
        ('first', c.c_double),
        ('width', c.c_double),
        ('row_count', c.c_uint32),
        ('_bin_size', c.c_uint32),
        ('row_first', c.c_double),
        ('row_length', c.c_double),
        ('_bins', c.POINTER(DamageBin)),
    ]
assert c.sizeof(DamageBins) == 56


class FatigueLaws(s.Struct):
    """Damage of rolling contact fatigue by T-gamma: the Whole Life Rail Model. Zero up to start, rising straight
        to peak at peak_at, falling straight through zero at end and on below it, where wear wins. For R220
        and R260 steel; Burstow, RSSB T115 (2004); quoted from memory, unconfirmed. The direction of the creep
        force, by which the model tells cracks that open, is left to the caller.

    Members:
      whole_life_start [N]: T-gamma from which cracks start (0 .. 1e6; default 15)
      whole_life_peak_at [N]: T-gamma of the largest damage, above whole_life_start (1e-3 .. 1e6; default 65)
      whole_life_end [N]: T-gamma at which wear takes as much as cracks grow, above whole_life_peak_at (1e-3
          .. 1e6; default 175)
      whole_life_peak: damage of a passage at whole_life_peak_at; 1 is a crack (0 .. 1; default 1e-5)
    """

    _c_name_ = 'wrc_fatigue_laws'
    __slots__ = ()
    whole_life_start: float
    whole_life_peak_at: float
    whole_life_end: float
    whole_life_peak: float
    _units_ = {'whole_life_start': 'N', 'whole_life_peak_at': 'N', 'whole_life_end': 'N'}
    _defaults_ = {'whole_life_start': 15.0, 'whole_life_peak_at': 65.0, 'whole_life_end': 175.0, 'whole_life_peak': 1e-05}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('whole_life_start', c.c_double),
        ('whole_life_peak_at', c.c_double),
        ('whole_life_end', c.c_double),
        ('whole_life_peak', c.c_double),
    ]
assert c.sizeof(FatigueLaws) == 40


class Accumulation(s.Struct):
    """Input of Contact.accumulate().

    Members:
      duration [s]: for which the results hold (0 .. 1e6; default 0)
      distance [m]: along the track where that begins; read where a row of bins has a length (-1e9 .. 1e9;
          default 0)
      wear: None: the published ones (default None)
      fatigue: None: the published ones (default None)
    """

    _c_name_ = 'wrc_accumulation'
    __slots__ = ()
    duration: float
    distance: float
    wear: Optional[WearLaws] = s.Reference('wear')  # type: ignore[assignment]
    fatigue: Optional[FatigueLaws] = s.Reference('fatigue')  # type: ignore[assignment]
    _units_ = {'duration': 's', 'distance': 'm'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('duration', c.c_double),
        ('distance', c.c_double),
        ('_wear', c.POINTER(WearLaws)),
        ('_fatigue', c.POINTER(FatigueLaws)),
    ]
assert c.sizeof(Accumulation) == 40


class DamageTotals(s.Struct):
    """Amounts that one Contact.accumulate() added to each of its sets of bins.

    Members:
      sum: by DamageQuantity, units there
      largest_pressure [Pa]:
      largest_traction [Pa]:
    """

    _c_name_ = 'wrc_damage_totals'
    __slots__ = ()
    sum: np.ndarray = s.Array('sum', 0, (16,), c.c_double)  # type: ignore[assignment]
    largest_pressure: float
    largest_traction: float
    _units_ = {'largest_pressure': 'Pa', 'largest_traction': 'Pa'}
    _fields_ = [
        ('_sum', c.c_double * 16),
        ('largest_pressure', c.c_double),
        ('largest_traction', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(DamageTotals) == 176


class Grid(s.Struct):
    """A rectangular grid in the contact frame.

    Members:
      nx: cells along x (4 .. 1024; default 0)
      ny: cells along y (4 .. 1024; default 0)
      dx [m]: size of a cell (1e-7 .. 0.01; default 0)
      dy [m]: see dx (1e-7 .. 0.01; default 0)
      x0 [m]: centre of cell (0, 0) (-1 .. 1; default 0)
      y0 [m]: see x0 (-1 .. 1; default 0)
    """

    _c_name_ = 'wrc_grid'
    __slots__ = ()
    nx: int
    ny: int
    dx: float
    dy: float
    x0: float
    y0: float
    _units_ = {'dx': 'm', 'dy': 'm', 'x0': 'm', 'y0': 'm'}
    _fields_ = [
        ('nx', c.c_uint32),
        ('ny', c.c_uint32),
        ('dx', c.c_double),
        ('dy', c.c_double),
        ('x0', c.c_double),
        ('y0', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(Grid) == 72


class ExactNormalProblem(s.Struct):
    """The normal problem: an undeformed gap and what presses the bodies together.

    Members:
      prescribed: Prescribed: Prescribed.NORMAL_FORCE or _APPROACH (default Prescribed.NORMAL_FORCE)
      max_iterations: (1 .. 100000; default 1000)
      normal_force [N]: with Prescribed.NORMAL_FORCE; must be set (1e-3 .. 1e7; default 0)
      approach [m]: beyond the zero of the gap with Prescribed.APPROACH (-1 .. 0.01; default 0)
      tolerance: of overlap and separation, relative to the largest displacement (1e-14 .. 0.1; default 1e-6)
      wheel_material: elastic, of the wheel
      rail_material: elastic, of the rail
      grid: cells of gap and pressure
      gap [m]: nx * ny (-1 .. 1; required)
      progress: None: none (default None)
      user: handed to progress (default None)
    """

    _c_name_ = 'wrc_exact_normal_problem'
    __slots__ = ()
    prescribed: Prescribed = s.Chosen('prescribed', Prescribed)  # type: ignore[assignment]
    max_iterations: int
    normal_force: float
    approach: float
    tolerance: float
    wheel_material: Material
    rail_material: Material
    grid: Grid
    gap: Optional[np.ndarray] = s.Pointer('gap')  # type: ignore[assignment]
    progress: Any
    user: Any
    _units_ = {'normal_force': 'N', 'approach': 'm', 'gap': 'm'}
    _defaults_ = {'_prescribed': 2, 'max_iterations': 1000, 'tolerance': 1e-06}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_prescribed', c.c_int32),
        ('max_iterations', c.c_int32),
        ('_reserved0', c.c_uint32),
        ('normal_force', c.c_double),
        ('approach', c.c_double),
        ('tolerance', c.c_double),
        ('wheel_material', Material),
        ('rail_material', Material),
        ('grid', Grid),
        ('_gap', c.POINTER(c.c_double)),
        ('progress', s.Progress),
        ('user', c.c_void_p),
    ]
assert c.sizeof(ExactNormalProblem) == 264


class ExactNormalSolution(s.Struct):
    """Solution of the normal problem.

    Members:
      iterations: of the conjugate gradients
      flags: bit 1 << flag for each WRC_FLAG_... met
      approach [m]: beyond the zero of the gap
      normal_force [N]:
      peak_pressure [Pa]:
      area [m^2]: of the cells under pressure
      residual: of the convergence test
      pressure [Pa]: the caller's nx * ny; None: not wanted; set before the call
    """

    _c_name_ = 'wrc_exact_normal_solution'
    __slots__ = ()
    iterations: int
    flags: Flags = s.Chosen('flags', Flags)  # type: ignore[assignment]
    approach: float
    normal_force: float
    peak_pressure: float
    area: float
    residual: float
    pressure: Optional[np.ndarray] = s.Pointer('pressure')  # type: ignore[assignment]
    _units_ = {'approach': 'm', 'normal_force': 'N', 'peak_pressure': 'Pa', 'area': 'm^2', 'pressure': 'Pa'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('iterations', c.c_int32),
        ('_flags', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('approach', c.c_double),
        ('normal_force', c.c_double),
        ('peak_pressure', c.c_double),
        ('area', c.c_double),
        ('residual', c.c_double),
        ('_pressure', c.POINTER(c.c_double)),
    ]
assert c.sizeof(ExactNormalSolution) == 64


class ExactRollingProblem(s.Struct):
    """Steady rolling under a given normal pressure.

    Members:
      adhesion: Adhesion (default Adhesion.COULOMB)
      collocation: Collocation (default Collocation.QUARTER_POINT)
      max_iterations: of Newton's method (1 .. 1000; default 60)
      tolerance: of the traction law (1e-12 .. 0.1; default 1e-4)
      wheel_material: elastic, of the wheel
      rail_material: elastic, of the rail
      grid: cells of pressure, friction and tractions
      pressure [Pa]: nx * ny; cells above zero are the contact, all others are not (-1e11 .. 1e11; required)
      friction: nx * ny; None: coefficient everywhere (1e-4 .. 2; default None)
      coefficient: Coulomb with Adhesion.COULOMB and friction None (1e-4 .. 2; default 0.3)
      creepage: about the origin of the contact frame
      progress: called between grids and iterations; None: none (default None)
      user: handed to progress (default None)
      layer_thickness [m]: of an elasto-plastic layer, as in Friction; steady rolling alone (0 .. 0.01;
          default 0)
      layer_modulus [Pa]: of that layer in shear; goes with a thickness (0 or 1e3 .. 1e12; default 0)
      layer_yield [Pa]: traction at which fresh layer yields; Adhesion.COULOMB alone (0 or 1e3 .. 1e11;
          default 0)
      layer_hardening [Pa/m]: rise of that traction over the length of plastic flow (-1e13 .. 1e14; default 0)
    """

    _c_name_ = 'wrc_exact_rolling_problem'
    __slots__ = ()
    adhesion: Adhesion = s.Chosen('adhesion', Adhesion)  # type: ignore[assignment]
    collocation: Collocation = s.Chosen('collocation', Collocation)  # type: ignore[assignment]
    max_iterations: int
    tolerance: float
    wheel_material: Material
    rail_material: Material
    grid: Grid
    pressure: Optional[np.ndarray] = s.Pointer('pressure')  # type: ignore[assignment]
    friction: Optional[np.ndarray] = s.Pointer('friction')  # type: ignore[assignment]
    coefficient: float
    creepage: Creepage
    progress: Any
    user: Any
    layer_thickness: float
    layer_modulus: float
    layer_yield: float
    layer_hardening: float
    _units_ = {'pressure': 'Pa', 'layer_thickness': 'm', 'layer_modulus': 'Pa', 'layer_yield': 'Pa', 'layer_hardening': 'Pa/m'}
    _defaults_ = {'max_iterations': 60, 'tolerance': 0.0001, 'coefficient': 0.3}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_adhesion', c.c_int32),
        ('_collocation', c.c_int32),
        ('max_iterations', c.c_int32),
        ('tolerance', c.c_double),
        ('wheel_material', Material),
        ('rail_material', Material),
        ('grid', Grid),
        ('_pressure', c.POINTER(c.c_double)),
        ('_friction', c.POINTER(c.c_double)),
        ('coefficient', c.c_double),
        ('creepage', Creepage),
        ('progress', s.Progress),
        ('user', c.c_void_p),
        ('layer_thickness', c.c_double),
        ('layer_modulus', c.c_double),
        ('layer_yield', c.c_double),
        ('layer_hardening', c.c_double),
    ]
assert c.sizeof(ExactRollingProblem) == 376


class ExactRollingSolution(s.Struct):
    """Solution of steady rolling: forces and tractions on the wheel.

    Members:
      iterations: of Newton's method on the given grid
      flags: bit 1 << flag for each WRC_FLAG_... met
      fx [N]:
      fy [N]: see fx
      mz [N m]: about the origin of the contact frame
      power [W]: sum of slip times traction over the cells, times the speed
      power_by_balance [W]: -(Fx nu_x + Fy nu_y + Mz phi) V: the limit of power on fine grids
      adhesion_fraction: share of the contact's area that sticks
      residual: of the convergence test
      traction_x [Pa]: the caller's nx * ny; None: not wanted; so are those below
      traction_y [Pa]:
      slip_x: sliding velocity / rolling speed
      slip_y:
    """

    _c_name_ = 'wrc_exact_rolling_solution'
    __slots__ = ()
    iterations: int
    flags: Flags = s.Chosen('flags', Flags)  # type: ignore[assignment]
    fx: float
    fy: float
    mz: float
    power: float
    power_by_balance: float
    adhesion_fraction: float
    residual: float
    traction_x: Optional[np.ndarray] = s.Pointer('traction_x')  # type: ignore[assignment]
    traction_y: Optional[np.ndarray] = s.Pointer('traction_y')  # type: ignore[assignment]
    slip_x: Optional[np.ndarray] = s.Pointer('slip_x')  # type: ignore[assignment]
    slip_y: Optional[np.ndarray] = s.Pointer('slip_y')  # type: ignore[assignment]
    _units_ = {'fx': 'N', 'fy': 'N', 'mz': 'N m', 'power': 'W', 'power_by_balance': 'W', 'traction_x': 'Pa', 'traction_y': 'Pa'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('iterations', c.c_int32),
        ('_flags', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('fx', c.c_double),
        ('fy', c.c_double),
        ('mz', c.c_double),
        ('power', c.c_double),
        ('power_by_balance', c.c_double),
        ('adhesion_fraction', c.c_double),
        ('residual', c.c_double),
        ('_traction_x', c.POINTER(c.c_double)),
        ('_traction_y', c.POINTER(c.c_double)),
        ('_slip_x', c.POINTER(c.c_double)),
        ('_slip_y', c.POINTER(c.c_double)),
    ]
assert c.sizeof(ExactRollingSolution) == 104


class ExactLoads(s.Struct):
    """Pressure and tractions on one of the bodies, constant on each cell of a grid.

    Members:
      body: Body: in which the stresses are wanted (default Body.RAIL)
      poisson: nu of that body (0 .. 0.5; default 0.28)
      grid: cells of pressure and tractions
      pressure [Pa]: nx * ny (-1e11 .. 1e11; required)
      traction_x [Pa]: nx * ny, on the wheel as solutions have it, whichever the body; None: none (-1e11 ..
          1e11; default None)
      traction_y [Pa]: nx * ny, the same along y; None: none (-1e11 .. 1e11; default None)
    """

    _c_name_ = 'wrc_exact_loads'
    __slots__ = ()
    body: Body = s.Chosen('body', Body)  # type: ignore[assignment]
    poisson: float
    grid: Grid
    pressure: Optional[np.ndarray] = s.Pointer('pressure')  # type: ignore[assignment]
    traction_x: Optional[np.ndarray] = s.Pointer('traction_x')  # type: ignore[assignment]
    traction_y: Optional[np.ndarray] = s.Pointer('traction_y')  # type: ignore[assignment]
    _units_ = {'pressure': 'Pa', 'traction_x': 'Pa', 'traction_y': 'Pa'}
    _defaults_ = {'_body': 1, 'poisson': 0.28}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_body', c.c_int32),
        ('poisson', c.c_double),
        ('grid', Grid),
        ('_pressure', c.POINTER(c.c_double)),
        ('_traction_x', c.POINTER(c.c_double)),
        ('_traction_y', c.POINTER(c.c_double)),
    ]
assert c.sizeof(ExactLoads) == 112


class ExactWrenchOptions(s.Struct):
    """How finely a wheel on a rail is solved exactly.

    Members:
      collocation: Collocation (default Collocation.QUARTER_POINT)
      influence: SurfaceInfluence (default SurfaceInfluence.TURNED)
      cell_x [m]: length of a cell along x (2e-5 .. 2e-3; default 2e-4)
      cell_s [m]: the same along the rail's arc length (2e-5 .. 2e-3; default 2e-4)
      progress: called while heights are tried and both problems solved in turn; None: none (default None)
      user: handed to progress (default None)
    """

    _c_name_ = 'wrc_exact_wrench_options'
    __slots__ = ()
    collocation: Collocation = s.Chosen('collocation', Collocation)  # type: ignore[assignment]
    influence: SurfaceInfluence = s.Chosen('influence', SurfaceInfluence)  # type: ignore[assignment]
    cell_x: float
    cell_s: float
    progress: Any
    user: Any
    _units_ = {'cell_x': 'm', 'cell_s': 'm'}
    _defaults_ = {'cell_x': 0.0002, 'cell_s': 0.0002}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_collocation', c.c_int32),
        ('_influence', c.c_int32),
        ('_reserved0', c.c_uint32),
        ('cell_x', c.c_double),
        ('cell_s', c.c_double),
        ('progress', s.Progress),
        ('user', c.c_void_p),
    ]
assert c.sizeof(ExactWrenchOptions) == 48


class ExactCheckOptions(s.Struct):
    """How finely a contact is checked.

    Members:
      nx: cells along x (8 .. 512; default 64)
      ny: cells along y (8 .. 512; default 64)
      progress: None: none (default None)
      user: handed to progress (default None)
    """

    _c_name_ = 'wrc_exact_check_options'
    __slots__ = ()
    nx: int
    ny: int
    progress: Any
    user: Any
    _defaults_ = {'nx': 64, 'ny': 64}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('nx', c.c_uint32),
        ('ny', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('progress', s.Progress),
        ('user', c.c_void_p),
    ]
assert c.sizeof(ExactCheckOptions) == 32


class ExactCheckResult(s.Struct):
    """A real-time result against the exact one.

    Members:
      flags: bit 1 << flag for each WRC_FLAG_... met
      fx [N]: exact, on the contact's own pressure and creepages
      fy [N]: see fx
      mz [N m]: the same
      power [W]: exact, by the energy balance
      adhesion_fraction: exact
      force_error: |F - F_exact| / (friction * N)
      power_error: P / P_exact - 1; 0 when nothing is dissipated
    """

    _c_name_ = 'wrc_exact_check_result'
    __slots__ = ()
    flags: Flags = s.Chosen('flags', Flags)  # type: ignore[assignment]
    fx: float
    fy: float
    mz: float
    power: float
    adhesion_fraction: float
    force_error: float
    power_error: float
    _units_ = {'fx': 'N', 'fy': 'N', 'mz': 'N m', 'power': 'W'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_flags', c.c_uint32),
        ('fx', c.c_double),
        ('fy', c.c_double),
        ('mz', c.c_double),
        ('power', c.c_double),
        ('adhesion_fraction', c.c_double),
        ('force_error', c.c_double),
        ('power_error', c.c_double),
    ]
assert c.sizeof(ExactCheckResult) == 64


class CreepCurve(s.Struct):
    """A measured curve of adhesion over slip, and the law to be fitted to it.

    Members:
      count: number of points, at least three more than parameters (4 .. 100000; default 0)
      slip: count of them: amount of the longitudinal creepage (1e-7 .. 1; required)
      adhesion: count of them: longitudinal force over load, against the slip positive (-0.2 .. 2; required)
      speed [m/s]: count of them: rolling speed (1e-3 .. 200; required)
      load [N]: count of them: load of the wheel (1 .. 1e7; required)
      ellipse: the patch under ellipse.normal_force. Its axes grow with the cube root of the load (Hertz)
      friction: the law, without zones and temperatures. The fit begins with its values and keeps those of
          other parameters
      parameters: bit 1 << parameter for each CreepParameter to be found (1 .. 1023; default 1)
      scatter: Scatter (default Scatter.RELATIVE)
      max_iterations: cap on the iterations of the fit (1 .. 1000; default 100)
      progress: called between iterations; None: none (default None)
      user: handed to progress (default None)
    """

    _c_name_ = 'wrc_creep_curve'
    __slots__ = ()
    count: int = s.Count('count')  # type: ignore[assignment]
    slip: Optional[np.ndarray] = s.Pointer('slip', 'count')  # type: ignore[assignment]
    adhesion: Optional[np.ndarray] = s.Pointer('adhesion', 'count')  # type: ignore[assignment]
    speed: Optional[np.ndarray] = s.Pointer('speed', 'count')  # type: ignore[assignment]
    load: Optional[np.ndarray] = s.Pointer('load', 'count')  # type: ignore[assignment]
    ellipse: Ellipse
    friction: Friction
    parameters: int
    scatter: Scatter = s.Chosen('scatter', Scatter)  # type: ignore[assignment]
    max_iterations: int
    progress: Any
    user: Any
    _units_ = {'speed': 'm/s', 'load': 'N'}
    _defaults_ = {'parameters': 1, 'max_iterations': 100}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_count', c.c_uint32),
        ('_slip', c.POINTER(c.c_double)),
        ('_adhesion', c.POINTER(c.c_double)),
        ('_speed', c.POINTER(c.c_double)),
        ('_load', c.POINTER(c.c_double)),
        ('ellipse', Ellipse),
        ('friction', Friction),
        ('parameters', c.c_uint32),
        ('_scatter', c.c_int32),
        ('max_iterations', c.c_int32),
        ('_reserved0', c.c_uint32),
        ('progress', s.Progress),
        ('user', c.c_void_p),
    ]
assert c.sizeof(CreepCurve) == 376


class CreepFit(s.Struct):
    """The law that fits best, and how far the curve determines it. Arrays are over CreepParameter, with 0 for
        parameters that were not to be found.

    Members:
      flags: bit 1 << flag for each WRC_FLAG_... met
      iterations: of the fit
      undetermined: bits of parameters that the curve does not determine: any value fits, or only a
          combination of several is determined. Their deviation is infinite, their interval the whole range
      at_limit: bits of parameters that ended at the end of their range
      scatter: standard deviation of the measured points from the law: relative, or of the adhesion
      friction: the law that fits best
      value: value that fits best, in the unit of the parameter
      deviation: standard deviation of that value, in the same unit
      low: lower end of the interval that holds the true value with 95 %
      high: its upper end
      covariance: of the values; 0 of undetermined ones
    """

    _c_name_ = 'wrc_creep_fit'
    __slots__ = ()
    flags: Flags = s.Chosen('flags', Flags)  # type: ignore[assignment]
    iterations: int
    undetermined: int
    at_limit: int
    scatter: float
    friction: Friction
    value: np.ndarray = s.Array('value', 272, (16,), c.c_double)  # type: ignore[assignment]
    deviation: np.ndarray = s.Array('deviation', 400, (16,), c.c_double)  # type: ignore[assignment]
    low: np.ndarray = s.Array('low', 528, (16,), c.c_double)  # type: ignore[assignment]
    high: np.ndarray = s.Array('high', 656, (16,), c.c_double)  # type: ignore[assignment]
    covariance: np.ndarray = s.Array('covariance', 784, (16, 16), c.c_double)  # type: ignore[assignment]
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_flags', c.c_uint32),
        ('iterations', c.c_int32),
        ('undetermined', c.c_uint32),
        ('at_limit', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('scatter', c.c_double),
        ('friction', Friction),
        ('_value', c.c_double * 16),
        ('_deviation', c.c_double * 16),
        ('_low', c.c_double * 16),
        ('_high', c.c_double * 16),
        ('_covariance', (c.c_double * 16) * 16),
    ]
assert c.sizeof(CreepFit) == 2832


class WheelsetGeometryProblem(s.Struct):
    """Lateral displacements and load for contact functions.

    Members:
      count: lateral displacements (1 .. 100000; default 0)
      lateral [m]: of the wheelset, to the right, count of them (-0.1 .. 0.1; required)
      wheel_load [N]: vertical, of each wheel; 0: the undeformed bodies touch in one point on either side, as
          EN 15302 has it, and the functions jump where that point does; a load: elastic, without friction,
          all contacts weighted by what they carry, continuous; needs NormalMethod.STRIP_HALFSPACE (0 or 1e3
          .. 1e6; default 0)
    """

    _c_name_ = 'wrc_wheelset_geometry_problem'
    __slots__ = ()
    count: int = s.Count('count')  # type: ignore[assignment]
    lateral: Optional[np.ndarray] = s.Pointer('lateral', 'count')  # type: ignore[assignment]
    wheel_load: float
    _units_ = {'lateral': 'm', 'wheel_load': 'N'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_count', c.c_uint32),
        ('_lateral', c.POINTER(c.c_double)),
        ('wheel_load', c.c_double),
    ]
assert c.sizeof(WheelsetGeometryProblem) == 24


class WheelsetGeometry(s.Struct):
    """Contact functions over the lateral displacement: arrays of the caller, count elements each; None: not
        wanted; set before the call. Coordinates of profiles are those of Profile, right and left alike.

    Members:
      vertical [m]: displacement of the wheelset's middle downwards
      roll [rad]: of the wheelset about the track's x, right wheel down positive
      radius_difference [m]: rolling radius of the right wheel less that of the left
      radius_right [m]: rolling radius
      radius_left [m]: see radius_right
      angle_right [rad]: contact angle against the track's plane, the roll included; positive where the
          surface rises towards the flange of the rail's gauge side
      angle_left [rad]: see angle_right
      y_wheel_right [m]: contact on the wheel's profile, flange side negative
      y_wheel_left [m]: see y_wheel_right
      y_rail_right [m]: contact on the rail's profile, field side positive
      y_rail_left [m]: see y_rail_right
    """

    _c_name_ = 'wrc_wheelset_geometry'
    __slots__ = ()
    vertical: Optional[np.ndarray] = s.Pointer('vertical')  # type: ignore[assignment]
    roll: Optional[np.ndarray] = s.Pointer('roll')  # type: ignore[assignment]
    radius_difference: Optional[np.ndarray] = s.Pointer('radius_difference')  # type: ignore[assignment]
    radius_right: Optional[np.ndarray] = s.Pointer('radius_right')  # type: ignore[assignment]
    radius_left: Optional[np.ndarray] = s.Pointer('radius_left')  # type: ignore[assignment]
    angle_right: Optional[np.ndarray] = s.Pointer('angle_right')  # type: ignore[assignment]
    angle_left: Optional[np.ndarray] = s.Pointer('angle_left')  # type: ignore[assignment]
    y_wheel_right: Optional[np.ndarray] = s.Pointer('y_wheel_right')  # type: ignore[assignment]
    y_wheel_left: Optional[np.ndarray] = s.Pointer('y_wheel_left')  # type: ignore[assignment]
    y_rail_right: Optional[np.ndarray] = s.Pointer('y_rail_right')  # type: ignore[assignment]
    y_rail_left: Optional[np.ndarray] = s.Pointer('y_rail_left')  # type: ignore[assignment]
    _units_ = {'vertical': 'm', 'roll': 'rad', 'radius_difference': 'm', 'radius_right': 'm', 'radius_left': 'm', 'angle_right': 'rad', 'angle_left': 'rad', 'y_wheel_right': 'm', 'y_wheel_left': 'm', 'y_rail_right': 'm', 'y_rail_left': 'm'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_vertical', c.POINTER(c.c_double)),
        ('_roll', c.POINTER(c.c_double)),
        ('_radius_difference', c.POINTER(c.c_double)),
        ('_radius_right', c.POINTER(c.c_double)),
        ('_radius_left', c.POINTER(c.c_double)),
        ('_angle_right', c.POINTER(c.c_double)),
        ('_angle_left', c.POINTER(c.c_double)),
        ('_y_wheel_right', c.POINTER(c.c_double)),
        ('_y_wheel_left', c.POINTER(c.c_double)),
        ('_y_rail_right', c.POINTER(c.c_double)),
        ('_y_rail_left', c.POINTER(c.c_double)),
    ]
assert c.sizeof(WheelsetGeometry) == 96


class ConicityProblem(s.Struct):
    """A rolling radius difference over the lateral displacement, straight between its points, and what to make
        of it.

    Members:
      method: ConicityMethod (default ConicityMethod.WAVELENGTH)
      count: points (3 .. 100000; default 0)
      amplitude_count: (1 .. 100000; default 0)
      lateral [m]: of the wheelset, increasing, count of them (-0.1 .. 0.1; required)
      radius_difference [m]: right less left, count of them (-0.2 .. 0.2; required)
      amplitudes [m]: half the way from one side to the other, amplitude_count of them (1e-6 .. 0.1; required)
      contact_distance [m]: e: between the contact points of both wheels (0.3 .. 3; default 1.5)
      radius [m]: r0: nominal, of the wheels (0.05 .. 3; default 0.46)
    """

    _c_name_ = 'wrc_conicity_problem'
    __slots__ = ()
    method: ConicityMethod = s.Chosen('method', ConicityMethod)  # type: ignore[assignment]
    count: int = s.Count('count')  # type: ignore[assignment]
    amplitude_count: int = s.Count('amplitude_count')  # type: ignore[assignment]
    lateral: Optional[np.ndarray] = s.Pointer('lateral', 'count')  # type: ignore[assignment]
    radius_difference: Optional[np.ndarray] = s.Pointer('radius_difference', 'count')  # type: ignore[assignment]
    amplitudes: Optional[np.ndarray] = s.Pointer('amplitudes', 'amplitude_count')  # type: ignore[assignment]
    contact_distance: float
    radius: float
    _units_ = {'lateral': 'm', 'radius_difference': 'm', 'amplitudes': 'm', 'contact_distance': 'm', 'radius': 'm'}
    _defaults_ = {'contact_distance': 1.5, 'radius': 0.46}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_method', c.c_int32),
        ('_count', c.c_uint32),
        ('_amplitude_count', c.c_uint32),
        ('_lateral', c.POINTER(c.c_double)),
        ('_radius_difference', c.POINTER(c.c_double)),
        ('_amplitudes', c.POINTER(c.c_double)),
        ('contact_distance', c.c_double),
        ('radius', c.c_double),
    ]
assert c.sizeof(ConicityProblem) == 56


class Conicity(s.Struct):
    """Equivalent conicity over the amplitude: arrays of the caller, amplitude_count elements each; None: not
        wanted; set before the call.

    Members:
      conicity: tan gamma_e; 0 where a wheelset left to itself does not swing with this amplitude
      wavelength [m]: of the kinematic motion: by Klingel's formula from the conicity of a regression; 0 where
          there is none
      centre [m]: middle between the two ends of the motion
    """

    _c_name_ = 'wrc_conicity'
    __slots__ = ()
    conicity: Optional[np.ndarray] = s.Pointer('conicity')  # type: ignore[assignment]
    wavelength: Optional[np.ndarray] = s.Pointer('wavelength')  # type: ignore[assignment]
    centre: Optional[np.ndarray] = s.Pointer('centre')  # type: ignore[assignment]
    _units_ = {'wavelength': 'm', 'centre': 'm'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_conicity', c.POINTER(c.c_double)),
        ('_wavelength', c.POINTER(c.c_double)),
        ('_centre', c.POINTER(c.c_double)),
    ]
assert c.sizeof(Conicity) == 32


class ProfileWear(s.Struct):
    """Wear of a profile, to be taken off.

    Members:
      body: Body: which side of the curve is steel (default Body.WHEEL)
      count: points (4 .. 20000; default 0)
      bin_count: bins of the depth (1 .. 1000000; default 0)
      y [m]: points as in Profile, count of them (-1 .. 1; required)
      z [m]: see y (-1 .. 1; required)
      depth [m]: along the normal, of each bin for one passage, bin_count of them (0 .. 0.1; required)
      first [m]: arc length at which the first bin begins, 0 at y = 0 (-1 .. 1; default 0)
      width [m]: of a bin (1e-5 .. 1; default 1e-3)
      passages: wanted (0 .. 1e12; default 1)
      largest_depth [m]: most that is taken off in one step (1e-9 .. 1e-2; default 1e-4)
      smoothing [m]: waves of the depth of this length along the curve keep half their height; 0: as it is (0
          .. 0.05; default 5e-3)
      spacing [m]: of the new points along the curve (5e-5 .. 5e-3; default 5e-4)
    """

    _c_name_ = 'wrc_profile_wear'
    __slots__ = ()
    body: Body = s.Chosen('body', Body)  # type: ignore[assignment]
    count: int = s.Count('count')  # type: ignore[assignment]
    bin_count: int = s.Count('bin_count')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', 'count')  # type: ignore[assignment]
    z: Optional[np.ndarray] = s.Pointer('z', 'count')  # type: ignore[assignment]
    depth: Optional[np.ndarray] = s.Pointer('depth', 'bin_count')  # type: ignore[assignment]
    first: float
    width: float
    passages: float
    largest_depth: float
    smoothing: float
    spacing: float
    _units_ = {'y': 'm', 'z': 'm', 'depth': 'm', 'first': 'm', 'width': 'm', 'largest_depth': 'm', 'smoothing': 'm', 'spacing': 'm'}
    _defaults_ = {'width': 0.001, 'passages': 1.0, 'largest_depth': 0.0001, 'smoothing': 0.005, 'spacing': 0.0005}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_body', c.c_int32),
        ('_count', c.c_uint32),
        ('_bin_count', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_z', c.POINTER(c.c_double)),
        ('_depth', c.POINTER(c.c_double)),
        ('first', c.c_double),
        ('width', c.c_double),
        ('passages', c.c_double),
        ('largest_depth', c.c_double),
        ('smoothing', c.c_double),
        ('spacing', c.c_double),
    ]
assert c.sizeof(ProfileWear) == 88


class WornProfile(s.Struct):
    """A worn profile: arrays of the caller, set before the call.

    Members:
      capacity: points there is room for; set before the call
      count: points
      y [m]: capacity of the caller; set before the call
      z [m]: see y
      passages: that were taken off: those wanted, or as many as largest_depth allows
      depth [m]: largest that was taken off
      area [m^2]: taken off the section
    """

    _c_name_ = 'wrc_worn_profile'
    __slots__ = ()
    capacity: int
    count: int
    y: Optional[np.ndarray] = s.Pointer('y')  # type: ignore[assignment]
    z: Optional[np.ndarray] = s.Pointer('z')  # type: ignore[assignment]
    passages: float
    depth: float
    area: float
    _units_ = {'y': 'm', 'z': 'm', 'depth': 'm', 'area': 'm^2'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('capacity', c.c_uint32),
        ('count', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_z', c.POINTER(c.c_double)),
        ('passages', c.c_double),
        ('depth', c.c_double),
        ('area', c.c_double),
    ]
assert c.sizeof(WornProfile) == 56


class Flange(s.Struct):
    """Dimensions of a wheel's flange as gauges have them, EN 15313; datum: the tread at y = 0.

    Members:
      height [m]: Sh: the tip below the datum
      thickness [m]: Sd: from the flange back to the face 10 mm below the datum
      slope [m]: qR: along y from there to the point of the face 2 mm above the tip
    """

    _c_name_ = 'wrc_flange'
    __slots__ = ()
    height: float
    thickness: float
    slope: float
    _units_ = {'height': 'm', 'thickness': 'm', 'slope': 'm'}
    _fields_ = [
        ('height', c.c_double),
        ('thickness', c.c_double),
        ('slope', c.c_double),
        ('_reserved', c.c_double * 3),
    ]
assert c.sizeof(Flange) == 48


class SectionLine(s.Struct):
    """One measured line across a rail, from the gauge side to the field side, with gaps. Its points need no
        equal distances.

    Members:
      distance [m]: along the track
      count: points, 4 or more
      y [m]: count of them, to the field side; NaN where nothing was measured (required)
      z [m]: count of them, downwards, 0 at the rail's top; NaN with y (required)
    """

    _c_name_ = 'wrc_section_line'
    __slots__ = ()
    distance: float
    count: int = s.Count('count')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', 'count')  # type: ignore[assignment]
    z: Optional[np.ndarray] = s.Pointer('z', 'count')  # type: ignore[assignment]
    _units_ = {'distance': 'm', 'y': 'm', 'z': 'm'}
    _fields_ = [
        ('distance', c.c_double),
        ('_count', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_z', c.POINTER(c.c_double)),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(SectionLine) == 64


class RailFacesProblem(s.Struct):
    """Measured sections of a rail that changes along the track, and how they are parted into faces.

    Members:
      section_count: (2 .. 100000; default 0)
      sections: section_count of them, by increasing distance (required)
      interruption_count: (0 .. 1000; default 0)
      interruptions [m]: interruption_count of them: places between two sections that no face passes, the gap
          of a joint (-1e7 .. 1e7; required)
      first [m]: beginning of the wanted part of the track; one section before it is kept, too (-1e7 .. 1e7;
          default -1e7)
      last [m]: its end; one section beyond is kept, too (-1e7 .. 1e7; default 1e7)
      depth [m]: depth below z = 0 beyond which points belong to no face, as the bottom of a flangeway (1e-3
          .. 0.2; default 0.03)
      gap [m]: distance from one point to the next at which a line is parted (1e-4 .. 0.1; default 5e-3)
      kink [rad]: turn at a concave corner above which a line is parted: a blade at its stock rail (0.1 .. 3;
          default 0.7)
      least_width [m]: least width of a face; narrower pieces are left out (1e-3 .. 0.05; default 3e-3)
      tolerance [m]: distance of a section from the mean of its neighbours, above which thin names it (1e-6 ..
          0.05; default 2e-4)
    """

    _c_name_ = 'wrc_rail_faces_problem'
    __slots__ = ()
    section_count: int = s.Count('section_count')  # type: ignore[assignment]
    sections: Sequence[SectionLine] = s.References('sections', 'section_count')  # type: ignore[assignment]
    interruption_count: int = s.Count('interruption_count')  # type: ignore[assignment]
    interruptions: Optional[np.ndarray] = s.Pointer('interruptions', 'interruption_count')  # type: ignore[assignment]
    first: float
    last: float
    depth: float
    gap: float
    kink: float
    least_width: float
    tolerance: float
    _units_ = {'interruptions': 'm', 'first': 'm', 'last': 'm', 'depth': 'm', 'gap': 'm', 'kink': 'rad', 'least_width': 'm', 'tolerance': 'm'}
    _defaults_ = {'first': -10000000.0, 'last': 10000000.0, 'depth': 0.03, 'gap': 0.005, 'kink': 0.7, 'least_width': 0.003, 'tolerance': 0.0002}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_section_count', c.c_uint32),
        ('_sections', c.POINTER(SectionLine)),
        ('_interruption_count', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_interruptions', c.POINTER(c.c_double)),
        ('first', c.c_double),
        ('last', c.c_double),
        ('depth', c.c_double),
        ('gap', c.c_double),
        ('kink', c.c_double),
        ('least_width', c.c_double),
        ('tolerance', c.c_double),
    ]
assert c.sizeof(RailFacesProblem) == 88


class FoundFaces(s.Struct):
    """Faces of a rail. Data behind its pointers belong to the handle and end with it.

    Members:
      face_count: faces
      outline_count: outlines of all faces, for rail_faces()
      rail_section_count: for config.rail_section_count, which takes 1000 at most
      rail_sections: for config.rail_sections, without check rails
      notes: pieces that were left out or joined: sentences, each with its end of line
      thin: places where sections are too far apart, or more faces than a model holds; as notes
    """

    _c_name_ = 'wrc_found_faces'
    __slots__ = ()
    face_count: int
    outline_count: int
    rail_section_count: int
    rail_sections: Optional[RailSection] = s.Reference('rail_sections', size='rail_section_size')  # type: ignore[assignment]
    notes: Optional[str] = s.Text('notes')  # type: ignore[assignment]
    thin: Optional[str] = s.Text('thin')  # type: ignore[assignment]
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('face_count', c.c_uint32),
        ('outline_count', c.c_uint32),
        ('rail_section_count', c.c_uint32),
        ('_rail_section_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_rail_sections', c.POINTER(RailSection)),
        ('_notes', c.c_char_p),
        ('_thin', c.c_char_p),
    ]
assert c.sizeof(FoundFaces) == 48


class FaceOutline(s.Struct):
    """A face in one of the measured sections. Its arrays belong to the handle and end with it.

    Members:
      kind: FaceKind: of its face
      face: its face, counted from 0 from the gauge side; outlines of one stand side by side
      number: the measured section, counted from 0
      count: points
      mark_count: number of marks, equal in all outlines of a face
      distance [m]: along the track
      spacing_error [m]: distance from the mean of its neighbours, along the normal; 0 of the first and last
      y [m]: count of them
      z [m]: count of them
      marks [m]: mark_count of them: y of the corners that belong together
    """

    _c_name_ = 'wrc_face_outline'
    __slots__ = ()
    kind: FaceKind = s.Chosen('kind', FaceKind)  # type: ignore[assignment]
    face: int
    number: int
    count: int = s.Count('count')  # type: ignore[assignment]
    mark_count: int = s.Count('mark_count')  # type: ignore[assignment]
    distance: float
    spacing_error: float
    y: Optional[np.ndarray] = s.Pointer('y', 'count')  # type: ignore[assignment]
    z: Optional[np.ndarray] = s.Pointer('z', 'count')  # type: ignore[assignment]
    marks: Optional[np.ndarray] = s.Pointer('marks', 'mark_count')  # type: ignore[assignment]
    _units_ = {'distance': 'm', 'spacing_error': 'm', 'y': 'm', 'z': 'm', 'marks': 'm'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_kind', c.c_int32),
        ('face', c.c_uint32),
        ('number', c.c_uint32),
        ('_count', c.c_uint32),
        ('_mark_count', c.c_uint32),
        ('distance', c.c_double),
        ('spacing_error', c.c_double),
        ('_y', c.POINTER(c.c_double)),
        ('_z', c.POINTER(c.c_double)),
        ('_marks', c.POINTER(c.c_double)),
    ]
assert c.sizeof(FaceOutline) == 64


class SurfaceBin(s.Struct):
    """One bin. With all members zero it is clean and at ambient temperature.

    Members:
      sum: kg or J of the whole bin, at 8 * SurfaceBook + SurfaceQuantity: low and high half of an integer of
          128 bits, two's complement. Band.values() converts it
      overflow: bit i: sum i, or a contribution to it, passed its range and is invalid
    """

    _c_name_ = 'wrc_surface_bin'
    __slots__ = ()
    sum: np.ndarray = s.Array('sum', 0, (48, 2), c.c_uint64)  # type: ignore[assignment]
    overflow: int
    _fields_ = [
        ('_sum', (c.c_uint64 * 2) * 48),
        ('overflow', c.c_uint64),
        ('_reserved', c.c_double * 7),
    ]
assert c.sizeof(SurfaceBin) == 832


class Surface(s.Struct):
    """Running band of a rail along the track, or of a wheel round its tread. Amounts belong to the middles of
        its bins, with straight lines between. Beyond the ends of a band that is not closed the amounts of the
        end hold. Nothing is changed there.

    Members:
      count: bins (1 .. 10000000; default 0)
      first [m]: distance at which the first bin begins (-1e9 .. 1e9; default 0)
      length [m]: of a bin; of a wheel its circumference / count (1e-3 .. 1e4; default 0)
      width [m]: of the running band, or of each row in y (1e-3 .. 0.5; default 0.02)
      closed: 1: the last bin is beside the first: a wheel, a roller, a track that is a circle (0 .. 1;
          default 0)
      bins: of the caller, count for each row, row after row, zeroed before the first use
      rows: rows across; 0 or 1: one band, on which the whole contact lies (0 .. 16; default 0)
      row_first [m]: y of the profile at which the first of several rows begins (-1 .. 1; default 0)
    """

    _c_name_ = 'wrc_surface'
    __slots__ = ()
    count: int
    first: float
    length: float
    width: float
    closed: int
    bins: Optional[SurfaceBin] = s.Reference('bins', size='bin_size')  # type: ignore[assignment]
    rows: int
    row_first: float
    _units_ = {'first': 'm', 'length': 'm', 'width': 'm', 'row_first': 'm'}
    _defaults_ = {'width': 0.02}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('count', c.c_uint32),
        ('first', c.c_double),
        ('length', c.c_double),
        ('width', c.c_double),
        ('closed', c.c_uint32),
        ('_bin_size', c.c_uint32),
        ('_bins', c.POINTER(SurfaceBin)),
        ('rows', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('row_first', c.c_double),
    ]
assert c.sizeof(Surface) == 64


class Substance(s.Struct):
    """Laws of one substance: friction, layer, removal. With all members zero it lies there and has no effect.

    Members:
      cover [kg/m^2]: on both bodies together: amount from which it covers the surface; 0: no effect on
          friction and layer (0 or 1e-6 .. 100; default 0)
      weight: weight of its friction among substances that cover together; goes with cover (0 or 1e-3 .. 1000;
          default 0)
      friction: coefficient of friction of a dry surface that it covers; goes with cover (0 or 1e-3 .. 2;
          default 0)
      wet_friction: the same where water covers, too; goes with cover (0 or 1e-3 .. 2; default 0)
      removal [m^2/J]: tau: frictional energy W over the band's area removes the share 1 - exp(-tau W) (0 ..
          1; default 0)
      kept [kg/m^2]: amount that a passing wheel leaves in the band (0 .. 100; default 0)
      squeeze: share of the amount above kept that one passage presses out of the band (0 .. 0.999; default 0)
      carry: rate at which amounts on both bodies become equal, as a share in one passage (0 .. 1; default 0)
      density [kg/m^3]: of its layer (100 .. 1e5; default 1000)
      layer_modulus [Pa]: of its layer in shear; 0: it does not shear elastically (0 or 1e3 .. 1e12; default
          0)
      layer_yield [Pa]: traction at which its layer yields; 0: it does not yield (0 or 1e3 .. 1e11; default 0)
      layer_hardening [Pa/m]: as Friction.layer_hardening, goes with layer_yield (-1e13 .. 1e14; default 0)
    """

    _c_name_ = 'wrc_substance'
    __slots__ = ()
    cover: float
    weight: float
    friction: float
    wet_friction: float
    removal: float
    kept: float
    squeeze: float
    carry: float
    density: float
    layer_modulus: float
    layer_yield: float
    layer_hardening: float
    _units_ = {'cover': 'kg/m^2', 'removal': 'm^2/J', 'kept': 'kg/m^2', 'density': 'kg/m^3', 'layer_modulus': 'Pa', 'layer_yield': 'Pa', 'layer_hardening': 'Pa/m'}
    _defaults_ = {'density': 1000.0}
    _fields_ = [
        ('cover', c.c_double),
        ('weight', c.c_double),
        ('friction', c.c_double),
        ('wet_friction', c.c_double),
        ('removal', c.c_double),
        ('kept', c.c_double),
        ('squeeze', c.c_double),
        ('carry', c.c_double),
        ('density', c.c_double),
        ('layer_modulus', c.c_double),
        ('layer_yield', c.c_double),
        ('layer_hardening', c.c_double),
        ('_reserved', c.c_double * 4),
    ]
assert c.sizeof(Substance) == 128


class SurfaceLaws(s.Struct):
    """Constants of the mixing rule and of passages. surface_laws() sets them by a name.

    Members:
      water: it wets the others: wet_friction is that of wet steel; weight, friction, layer are 0
      oxide: oxide and debris
      film: organic film
      sand: sand
      lubricant: lubricant
      rail_share: share of the frictional energy that heats the rail; the wheel has the rest (0 .. 1; default
          0.5)
      rail_heat_capacity [J/(m^2 K)]: heat capacity of the rail per area of its band (1e2 .. 1e8; default
          35e3)
      wheel_heat_capacity [J/(m^2 K)]: heat capacity of the wheel per area of its band (1e2 .. 1e8; default
          35e3)
      cooling_time [s]: time after which Band.rest() leaves 1/e of the heat (1e-3 .. 1e9; default 60)
      drying_time [s]: time after which Band.rest() leaves 1/e of the water (1e-3 .. 1e9; default 1800)
      evaporation_share: share of frictional heat that evaporates water where there is plenty (0 .. 1; default
          0)
      evaporation_amount [kg/m^2]: amount of water at which that share is halved (1e-6 .. 10; default 5e-3)
      latent_heat [J/kg]: latent heat of evaporation (1e5 .. 1e7; default 2.4e6)
      ambient [degC]: temperature of bodies without heat (-100 .. 200; default 20)
    """

    _c_name_ = 'wrc_surface_laws'
    __slots__ = ()
    water: Substance
    oxide: Substance
    film: Substance
    sand: Substance
    lubricant: Substance
    rail_share: float
    rail_heat_capacity: float
    wheel_heat_capacity: float
    cooling_time: float
    drying_time: float
    evaporation_share: float
    evaporation_amount: float
    latent_heat: float
    ambient: float
    _units_ = {'rail_heat_capacity': 'J/(m^2 K)', 'wheel_heat_capacity': 'J/(m^2 K)', 'cooling_time': 's', 'drying_time': 's', 'evaporation_amount': 'kg/m^2', 'latent_heat': 'J/kg', 'ambient': 'degC'}
    _defaults_ = {'rail_share': 0.5, 'rail_heat_capacity': 35000.0, 'wheel_heat_capacity': 35000.0, 'cooling_time': 60.0, 'drying_time': 1800.0, 'evaporation_amount': 0.005, 'latent_heat': 2400000.0, 'ambient': 20.0}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('water', Substance),
        ('oxide', Substance),
        ('film', Substance),
        ('sand', Substance),
        ('lubricant', Substance),
        ('rail_share', c.c_double),
        ('rail_heat_capacity', c.c_double),
        ('wheel_heat_capacity', c.c_double),
        ('cooling_time', c.c_double),
        ('drying_time', c.c_double),
        ('evaporation_share', c.c_double),
        ('evaporation_amount', c.c_double),
        ('latent_heat', c.c_double),
        ('ambient', c.c_double),
    ]
assert c.sizeof(SurfaceLaws) == 720


class SurfacePassage(s.Struct):
    """A step of a wheel on its rail: the stretches of both bodies that passed through the contact, and the
        frictional energy.

    Members:
      rail_from [m]: distance along the rail at the beginning, growing forwards (-1e9 .. 1e9; default 0)
      rail_to [m]: the same at the end (-1e9 .. 1e9; default 0)
      wheel_from [m]: distance round the wheel at the beginning, growing as it rolls forwards (-1e9 .. 1e9;
          default 0)
      wheel_to [m]: the same at the end; wheel_from for a locked wheel (-1e9 .. 1e9; default 0)
      energy [J]: frictional energy: Wrench.power times the duration (0 .. 1e9; default 0)
      film_rows: memory of the caller for films in rows; None: with one row it is not needed (default None)
      film_numbers: numbers of film_rows (0 or 13 .. 1288; default 0)
      contact: contact whose last wrench passes, for surface_pass() with rows; None: one row (default None)
    """

    _c_name_ = 'wrc_surface_passage'
    __slots__ = ()
    rail_from: float
    rail_to: float
    wheel_from: float
    wheel_to: float
    energy: float
    film_rows: Optional[np.ndarray] = s.Pointer('film_rows')  # type: ignore[assignment]
    film_numbers: int
    contact: Any
    _units_ = {'rail_from': 'm', 'rail_to': 'm', 'wheel_from': 'm', 'wheel_to': 'm', 'energy': 'J'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('rail_from', c.c_double),
        ('rail_to', c.c_double),
        ('wheel_from', c.c_double),
        ('wheel_to', c.c_double),
        ('energy', c.c_double),
        ('_film_rows', c.POINTER(c.c_double)),
        ('film_numbers', c.c_uint32),
        ('_reserved1', c.c_uint32),
        ('contact', c.c_void_p),
    ]
assert c.sizeof(SurfacePassage) == 72


class SurfaceExchange(s.Struct):
    """Amounts and energies that a passage moved.

    Members:
      carried [kg]: by SurfaceQuantity: from rail to wheel, less that from wheel to rail
      rail_energy [J]: frictional energy booked in the rail's bins
      wheel_energy [J]: the same in the wheel's bins
      beside_energy [J]: the remaining energy: beyond a rail's ends, of a wheel that is None, of a wrench
          without work
    """

    _c_name_ = 'wrc_surface_exchange'
    __slots__ = ()
    carried: np.ndarray = s.Array('carried', 8, (8,), c.c_double)  # type: ignore[assignment]
    rail_energy: float
    wheel_energy: float
    beside_energy: float
    _units_ = {'carried': 'kg', 'rail_energy': 'J', 'wheel_energy': 'J', 'beside_energy': 'J'}
    _fields_ = [
        ('_struct_size', c.c_uint32),
        ('_reserved0', c.c_uint32),
        ('_carried', c.c_double * 8),
        ('rail_energy', c.c_double),
        ('wheel_energy', c.c_double),
        ('beside_energy', c.c_double),
    ]
assert c.sizeof(SurfaceExchange) == 96


# The C functions, as ctypes calls them: without the GIL.
FUNCTIONS: dict = {}
_wrc_version = _l.function(FUNCTIONS, 'wrc_version', c.c_uint32, [])
_wrc_abi_version = _l.function(FUNCTIONS, 'wrc_abi_version', c.c_uint32, [])
_wrc_version_text = _l.function(FUNCTIONS, 'wrc_version_text', c.c_char_p, [c.c_uint32])
_wrc_build_info = _l.function(FUNCTIONS, 'wrc_build_info', c.c_char_p, [])
_wrc_status_name = _l.function(FUNCTIONS, 'wrc_status_name', c.c_char_p, [c.c_int32])
_wrc_status_text = _l.function(FUNCTIONS, 'wrc_status_text', c.c_char_p, [c.c_int32])
_wrc_config_init = _l.function(FUNCTIONS, 'wrc_config_init', c.c_int32, [c.POINTER(Config)])
_wrc_material_init = _l.function(FUNCTIONS, 'wrc_material_init', c.c_int32, [c.POINTER(Material)])
_wrc_friction_init = _l.function(FUNCTIONS, 'wrc_friction_init', c.c_int32, [c.POINTER(Friction)])
_wrc_wheel_input_init = _l.function(FUNCTIONS, 'wrc_wheel_input_init', c.c_int32, [c.POINTER(WheelInput)])
_wrc_config_use = _l.function(FUNCTIONS, 'wrc_config_use', c.c_int32, [c.POINTER(Config), c.c_char_p, c.c_char_p, c.c_uint64])
_wrc_friction_use = _l.function(FUNCTIONS, 'wrc_friction_use', c.c_int32, [c.POINTER(Friction), c.c_char_p, c.c_char_p, c.c_uint64])
_wrc_config_check = _l.function(FUNCTIONS, 'wrc_config_check', c.c_int32, [c.POINTER(Config), c.c_char_p, c.c_uint64])
_wrc_model_size = _l.function(FUNCTIONS, 'wrc_model_size', c.c_int32, [c.POINTER(Config), s.Numbers(c.c_uint64), s.Numbers(c.c_uint64)])
_wrc_model_init = _l.function(FUNCTIONS, 'wrc_model_init', c.c_int32, [c.POINTER(Config), c.c_void_p, c.c_uint64, c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_model_create = _l.function(FUNCTIONS, 'wrc_model_create', c.c_int32, [c.POINTER(Config), c.POINTER(Allocator), c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_model_profile = _l.function(FUNCTIONS, 'wrc_model_profile', c.c_int32, [c.c_void_p, c.c_int32, c.c_int32, c.POINTER(View), c.POINTER(View), s.Numbers(c.c_double)])
_wrc_model_destroy = _l.function(FUNCTIONS, 'wrc_model_destroy', None, [c.c_void_p])
_wrc_contact_size = _l.function(FUNCTIONS, 'wrc_contact_size', c.c_int32, [c.c_void_p, s.Numbers(c.c_uint64), s.Numbers(c.c_uint64)])
_wrc_contact_init = _l.function(FUNCTIONS, 'wrc_contact_init', c.c_int32, [c.c_void_p, c.c_int32, c.c_void_p, c.c_uint64, c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_contact_create = _l.function(FUNCTIONS, 'wrc_contact_create', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(Allocator), c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_contact_destroy = _l.function(FUNCTIONS, 'wrc_contact_destroy', None, [c.c_void_p])
_wrc_contact_state_size = _l.function(FUNCTIONS, 'wrc_contact_state_size', c.c_int32, [c.c_void_p, s.Numbers(c.c_uint64)])
_wrc_contact_save = _l.function(FUNCTIONS, 'wrc_contact_save', c.c_int32, [c.c_void_p, c.c_void_p, c.c_uint64])
_wrc_contact_restore = _l.function(FUNCTIONS, 'wrc_contact_restore', c.c_int32, [c.c_void_p, c.c_void_p, c.c_uint64])
_wrc_contact_portable_size = _l.function(FUNCTIONS, 'wrc_contact_portable_size', c.c_int32, [c.c_void_p, s.Numbers(c.c_uint64)])
_wrc_contact_save_portable = _l.function(FUNCTIONS, 'wrc_contact_save_portable', c.c_int32, [c.c_void_p, c.c_void_p, c.c_uint64])
_wrc_contact_restore_portable = _l.function(FUNCTIONS, 'wrc_contact_restore_portable', c.c_int32, [c.c_void_p, c.c_void_p, c.c_uint64])
_wrc_contact_last_error = _l.function(FUNCTIONS, 'wrc_contact_last_error', c.c_int32, [c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_contact_wrench = _l.function(FUNCTIONS, 'wrc_contact_wrench', c.c_int32, [c.c_void_p, c.POINTER(WheelInput), c.POINTER(Wrench)])
_wrc_contact_mark = _l.function(FUNCTIONS, 'wrc_contact_mark', c.c_int32, [c.c_void_p])
_wrc_contact_commit = _l.function(FUNCTIONS, 'wrc_contact_commit', c.c_int32, [c.c_void_p])
_wrc_contact_wrench_derivatives = _l.function(FUNCTIONS, 'wrc_contact_wrench_derivatives', c.c_int32, [c.c_void_p, c.POINTER(WheelInput), c.POINTER(Wrench), c.POINTER(WrenchDerivatives)])
_wrc_contact_wrench_batch = _l.function(FUNCTIONS, 'wrc_contact_wrench_batch', c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(WheelInput), c.c_uint64, c.POINTER(Wrench), c.c_uint64, s.Numbers(c.c_int32)])
_wrc_contact_region = _l.function(FUNCTIONS, 'wrc_contact_region', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(Region)])
_wrc_contact_field = _l.function(FUNCTIONS, 'wrc_contact_field', c.c_int32, [c.c_void_p, c.c_int32, c.c_int32, s.Numbers(c.c_double), c.c_uint64, s.Numbers(c.c_uint64)])
_wrc_contact_damage = _l.function(FUNCTIONS, 'wrc_contact_damage', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(Damage)])
_wrc_get_api = _l.function(FUNCTIONS, 'wrc_get_api', c.c_void_p, [c.c_uint32])
_wrc_get_experimental_api = _l.function(FUNCTIONS, 'wrc_get_experimental_api', c.c_void_p, [c.c_uint32])
_wrc_planar_load_init = _l.function(FUNCTIONS, 'wrc_planar_load_init', c.c_int32, [c.POINTER(PlanarLoad)])
_wrc_creepage_init = _l.function(FUNCTIONS, 'wrc_creepage_init', c.c_int32, [c.POINTER(Creepage)])
_wrc_planar_input_init = _l.function(FUNCTIONS, 'wrc_planar_input_init', c.c_int32, [c.POINTER(PlanarInput)])
_wrc_planar_step = _l.function(FUNCTIONS, 'wrc_planar_step', c.c_int32, [c.c_void_p, c.POINTER(PlanarInput), c.POINTER(PlanarOutput)])
_wrc_planar_geometry = _l.function(FUNCTIONS, 'wrc_planar_geometry', c.c_int32, [c.c_void_p, c.POINTER(PlanarPose), c.POINTER(PlanarPoint)])
_wrc_planar_creepages = _l.function(FUNCTIONS, 'wrc_planar_creepages', c.c_int32, [c.c_void_p, c.POINTER(PlanarMotion), c.POINTER(Creepage)])
_wrc_planar_normal = _l.function(FUNCTIONS, 'wrc_planar_normal', c.c_int32, [c.c_void_p, c.POINTER(PlanarGap), c.POINTER(PlanarLoad), c.POINTER(PlanarNormalSolution)])
_wrc_planar_regularise = _l.function(FUNCTIONS, 'wrc_planar_regularise', c.c_int32, [c.c_void_p, c.POINTER(PlanarStrips), c.POINTER(PlanarNormalSolution)])
_wrc_planar_roll = _l.function(FUNCTIONS, 'wrc_planar_roll', c.c_int32, [c.c_void_p, c.c_double])
_wrc_planar_tangential = _l.function(FUNCTIONS, 'wrc_planar_tangential', c.c_int32, [c.c_void_p, c.POINTER(Ellipse), c.POINTER(Creepage), c.POINTER(Friction), c.POINTER(PlanarForces)])
_wrc_planar_tangential_derivatives = _l.function(FUNCTIONS, 'wrc_planar_tangential_derivatives', c.c_int32, [c.c_void_p, c.POINTER(PlanarDerivatives)])
_wrc_bulk_temperatures_init = _l.function(FUNCTIONS, 'wrc_bulk_temperatures_init', c.c_int32, [c.POINTER(BulkTemperatures)])
_wrc_wear_laws_init = _l.function(FUNCTIONS, 'wrc_wear_laws_init', c.c_int32, [c.POINTER(WearLaws)])
_wrc_damage_bins_init = _l.function(FUNCTIONS, 'wrc_damage_bins_init', c.c_int32, [c.POINTER(DamageBins)])
_wrc_fatigue_laws_init = _l.function(FUNCTIONS, 'wrc_fatigue_laws_init', c.c_int32, [c.POINTER(FatigueLaws)])
_wrc_contact_wear = _l.function(FUNCTIONS, 'wrc_contact_wear', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(WearLaws), c.POINTER(Wear)])
_wrc_contact_temperature = _l.function(FUNCTIONS, 'wrc_contact_temperature', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(BulkTemperatures), c.POINTER(Temperature)])
_wrc_contact_stresses = _l.function(FUNCTIONS, 'wrc_contact_stresses', c.c_int32, [c.c_void_p, c.c_int32, c.c_int32, s.Numbers(c.c_double), c.c_uint32, c.POINTER(StressPeaks), c.POINTER(Stresses)])
_wrc_flash_temperature = _l.function(FUNCTIONS, 'wrc_flash_temperature', c.c_int32, [c.c_uint32, c.c_double, s.Numbers(c.c_double), c.c_double, c.POINTER(HeatProperties), c.POINTER(HeatProperties), s.Numbers(c.c_double)])
_wrc_contact_accumulate = _l.function(FUNCTIONS, 'wrc_contact_accumulate', c.c_int32, [c.c_void_p, c.POINTER(Accumulation), c.POINTER(DamageBins), c.POINTER(DamageBins), c.POINTER(DamageTotals)])
_wrc_damage_merge = _l.function(FUNCTIONS, 'wrc_damage_merge', c.c_int32, [c.POINTER(DamageBins), c.POINTER(DamageBins)])
_wrc_damage_values = _l.function(FUNCTIONS, 'wrc_damage_values', c.c_int32, [c.POINTER(DamageBins), c.c_int32, s.Numbers(c.c_double)])
_wrc_whole_life_damage = _l.function(FUNCTIONS, 'wrc_whole_life_damage', c.c_int32, [c.POINTER(FatigueLaws), c.c_double, s.Numbers(c.c_double)])
_wrc_model_arc_places = _l.function(FUNCTIONS, 'wrc_model_arc_places', c.c_int32, [c.c_void_p, c.c_int32, c.c_uint32, s.Numbers(c.c_double), s.Numbers(c.c_double), s.Numbers(c.c_double)])
_wrc_linear_coefficients = _l.function(FUNCTIONS, 'wrc_linear_coefficients', c.c_int32, [c.c_double, c.c_double, c.c_double, c.POINTER(Coefficients)])
_wrc_shakedown_limit = _l.function(FUNCTIONS, 'wrc_shakedown_limit', c.c_int32, [c.c_double, s.Numbers(c.c_double)])
_wrc_shakedown_limit_point = _l.function(FUNCTIONS, 'wrc_shakedown_limit_point', c.c_int32, [c.c_double, s.Numbers(c.c_double)])
_wrc_exact_normal_problem_init = _l.function(FUNCTIONS, 'wrc_exact_normal_problem_init', c.c_int32, [c.POINTER(ExactNormalProblem)])
_wrc_exact_rolling_problem_init = _l.function(FUNCTIONS, 'wrc_exact_rolling_problem_init', c.c_int32, [c.POINTER(ExactRollingProblem)])
_wrc_exact_loads_init = _l.function(FUNCTIONS, 'wrc_exact_loads_init', c.c_int32, [c.POINTER(ExactLoads)])
_wrc_exact_check_options_init = _l.function(FUNCTIONS, 'wrc_exact_check_options_init', c.c_int32, [c.POINTER(ExactCheckOptions)])
_wrc_exact_wrench_options_init = _l.function(FUNCTIONS, 'wrc_exact_wrench_options_init', c.c_int32, [c.POINTER(ExactWrenchOptions)])
_wrc_creep_curve_init = _l.function(FUNCTIONS, 'wrc_creep_curve_init', c.c_int32, [c.POINTER(CreepCurve)])
_wrc_exact_gap = _l.function(FUNCTIONS, 'wrc_exact_gap', c.c_int32, [c.c_void_p, c.POINTER(Grid), s.Numbers(c.c_double)])
_wrc_exact_normal = _l.function(FUNCTIONS, 'wrc_exact_normal', c.c_int32, [c.POINTER(ExactNormalProblem), c.POINTER(ExactNormalSolution), c.c_char_p, c.c_uint64])
_wrc_exact_rolling = _l.function(FUNCTIONS, 'wrc_exact_rolling', c.c_int32, [c.POINTER(ExactRollingProblem), c.POINTER(ExactRollingSolution), c.c_char_p, c.c_uint64])
_wrc_exact_stress = _l.function(FUNCTIONS, 'wrc_exact_stress', c.c_int32, [c.POINTER(ExactLoads), s.Numbers(c.c_double), c.c_uint32, s.Numbers(c.c_double), c.c_char_p, c.c_uint64])
_wrc_exact_largest_stresses = _l.function(FUNCTIONS, 'wrc_exact_largest_stresses', c.c_int32, [c.POINTER(ExactLoads), s.Numbers(c.c_double), c.c_uint32, c.POINTER(StressPeaks), c.POINTER(Stresses), s.Progress, c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_exact_transient_create = _l.function(FUNCTIONS, 'wrc_exact_transient_create', c.c_int32, [c.POINTER(Grid), c.POINTER(Material), c.POINTER(Material), c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_exact_transient_step = _l.function(FUNCTIONS, 'wrc_exact_transient_step', c.c_int32, [c.c_void_p, c.POINTER(ExactRollingProblem), c.POINTER(ExactRollingSolution), c.c_char_p, c.c_uint64])
_wrc_exact_transient_destroy = _l.function(FUNCTIONS, 'wrc_exact_transient_destroy', None, [c.c_void_p])
_wrc_exact_check = _l.function(FUNCTIONS, 'wrc_exact_check', c.c_int32, [c.c_void_p, c.POINTER(ExactCheckOptions), c.POINTER(ExactCheckResult)])
_wrc_exact_wrench = _l.function(FUNCTIONS, 'wrc_exact_wrench', c.c_int32, [c.c_void_p, c.POINTER(WheelInput), c.POINTER(ExactWrenchOptions), c.POINTER(Wrench)])
_wrc_fit_creep_curve = _l.function(FUNCTIONS, 'wrc_fit_creep_curve', c.c_int32, [c.c_void_p, c.POINTER(CreepCurve), c.POINTER(CreepFit), s.Numbers(c.c_double)])
_wrc_conicity_problem_init = _l.function(FUNCTIONS, 'wrc_conicity_problem_init', c.c_int32, [c.POINTER(ConicityProblem)])
_wrc_profile_wear_init = _l.function(FUNCTIONS, 'wrc_profile_wear_init', c.c_int32, [c.POINTER(ProfileWear)])
_wrc_rail_faces_problem_init = _l.function(FUNCTIONS, 'wrc_rail_faces_problem_init', c.c_int32, [c.POINTER(RailFacesProblem)])
_wrc_profile_wheelset_geometry = _l.function(FUNCTIONS, 'wrc_profile_wheelset_geometry', c.c_int32, [c.c_void_p, c.POINTER(WheelsetGeometryProblem), c.POINTER(WheelsetGeometry), c.c_char_p, c.c_uint64])
_wrc_equivalent_conicity = _l.function(FUNCTIONS, 'wrc_equivalent_conicity', c.c_int32, [c.POINTER(ConicityProblem), c.POINTER(Conicity), c.c_char_p, c.c_uint64])
_wrc_profile_remove_wear = _l.function(FUNCTIONS, 'wrc_profile_remove_wear', c.c_int32, [c.POINTER(ProfileWear), c.POINTER(WornProfile), c.c_char_p, c.c_uint64])
_wrc_flange_dimensions = _l.function(FUNCTIONS, 'wrc_flange_dimensions', c.c_int32, [c.c_uint32, s.Numbers(c.c_double), s.Numbers(c.c_double), c.c_double, c.POINTER(Flange), c.c_char_p, c.c_uint64])
_wrc_rail_faces_create = _l.function(FUNCTIONS, 'wrc_rail_faces_create', c.c_int32, [c.POINTER(RailFacesProblem), c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_rail_faces_found = _l.function(FUNCTIONS, 'wrc_rail_faces_found', c.c_int32, [c.c_void_p, c.POINTER(FoundFaces)])
_wrc_rail_faces_outline = _l.function(FUNCTIONS, 'wrc_rail_faces_outline', c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(FaceOutline)])
_wrc_rail_faces_destroy = _l.function(FUNCTIONS, 'wrc_rail_faces_destroy', None, [c.c_void_p])
_wrc_section_file_read = _l.function(FUNCTIONS, 'wrc_section_file_read', c.c_int32, [c.c_char_p, c.c_double, c.c_int32, c.c_int32, c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_section_file_line = _l.function(FUNCTIONS, 'wrc_section_file_line', c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(SectionLine)])
_wrc_section_file_destroy = _l.function(FUNCTIONS, 'wrc_section_file_destroy', None, [c.c_void_p])
_wrc_section_file_write = _l.function(FUNCTIONS, 'wrc_section_file_write', c.c_int32, [c.c_char_p, c.POINTER(SectionLine), c.c_uint32, c.c_char_p, c.c_uint64])
_wrc_surface_init = _l.function(FUNCTIONS, 'wrc_surface_init', c.c_int32, [c.POINTER(Surface)])
_wrc_surface_laws_init = _l.function(FUNCTIONS, 'wrc_surface_laws_init', c.c_int32, [c.POINTER(SurfaceLaws)])
_wrc_surface_laws_use = _l.function(FUNCTIONS, 'wrc_surface_laws_use', c.c_int32, [c.POINTER(SurfaceLaws), c.c_char_p, c.c_char_p, c.c_uint64])
_wrc_surface_add = _l.function(FUNCTIONS, 'wrc_surface_add', c.c_int32, [c.POINTER(Surface), c.c_int32, c.c_double, c.c_double, c.c_double, c.c_char_p, c.c_uint64])
_wrc_surface_friction = _l.function(FUNCTIONS, 'wrc_surface_friction', c.c_int32, [c.POINTER(Surface), c.POINTER(Surface), c.POINTER(SurfaceLaws), c.POINTER(SurfacePassage), c.POINTER(Friction), c.POINTER(Friction), c.c_char_p, c.c_uint64])
_wrc_surface_pass = _l.function(FUNCTIONS, 'wrc_surface_pass', c.c_int32, [c.POINTER(Surface), c.POINTER(Surface), c.POINTER(SurfaceLaws), c.POINTER(SurfacePassage), c.POINTER(SurfaceExchange), c.c_char_p, c.c_uint64])
_wrc_surface_rest = _l.function(FUNCTIONS, 'wrc_surface_rest', c.c_int32, [c.POINTER(Surface), c.POINTER(SurfaceLaws), c.c_double, c.c_char_p, c.c_uint64])
_wrc_surface_merge = _l.function(FUNCTIONS, 'wrc_surface_merge', c.c_int32, [c.POINTER(Surface), c.POINTER(Surface), c.c_char_p, c.c_uint64])
_wrc_surface_values = _l.function(FUNCTIONS, 'wrc_surface_values', c.c_int32, [c.POINTER(Surface), c.c_int32, c.c_int32, s.Numbers(c.c_double), s.Numbers(c.c_double), c.c_char_p, c.c_uint64])


class ModelCalls(_l.Handle):
    """What Model has of the C interface as it is."""

    __slots__ = ()


class ContactCalls(_l.Handle):
    """What Contact has of the C interface as it is."""

    __slots__ = ()

    def wrench(self, input: WheelInput, *, out: Optional[Wrench] = None) -> Wrench:
        """The wrench between a wheel and a rail at this pose and motion, steady rolling. Tread, gauge corner and
            flange are one problem. No contact point is chosen: each strip of the rail's surface has its own
            normal, overlap and slip. The wrench is a continuous function of all inputs, but where a flag says
            otherwise. Theory manual, section 9.

        input: what to solve
        out: the result; None: a new one

        C status: Status.OK, or the gravest flag:
          - Status.FLAG_NO_CONTACT: apart. Also a wheel too deep in its rail for contact to be looked for, as
              a flange 4 mm inside the rail's side. The sentence then says so.
          - _ITERATION_CAP; _CLIMBING; _BEYOND_SECTIONS; _TABLE_RANGE; _ROTATION_TRANSPOSED.
          - _PATCH_AT_EDGE: contact reaches the end of a profile, or of a surface along the track. Or it lies
              more than 160 mm ahead or behind, where it is not looked for. _MORE_PATCHES: more regions or
              strips than there is room for. Or a round wheel touches a rail at three places along the track,
              of which two carry the load.
          - _CREEPAGES_LIMITED: slower than 0.1 m/s, as Contact.planar_creepages(). Or the wheel turns against
              its travel and slides at more than 10 times its speed of rolling. The sentence then asks for the
              sign of pitch_rate. Neither with config.surface.memory.
          - _MEMORY_DROPPED: with config.surface.memory the wheel moved, since the committed step, 1 mm
              further than its velocities take it.
          - _BEYOND_GAP: deeper than 2 mm, continued with the stiffness there.
          - _FORCE_JUMPS: a planar normal method on a patch of several lowest points. Or Status.ERROR_NULL,
              _STRUCT_SIZE, _NOT_FINITE, _RANGE, _LOAD (no height carries the load). _UNSUPPORTED: a model
              without profiles; zones in a contact frame; friction over temperature of a method without
              tractions; with config.surface.memory friction over temperature and a layer.
        """
        if out is None:
            out = Wrench._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_wrench(self._handle, input, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, input=(input, WheelInput), out=(out, Wrench)) from None
        return out

    def mark(self) -> None:
        """Marks the contact's last solution of a wheel as accepted. Calls with Start.MARK start from it until
            the next mark, whatever was called in between: trial steps, Jacobians by differences, steps taken
            back. The mark is saved and restored with the state.

        C status: Status.OK; Status.ERROR_NULL; _SEQUENCE (the last call left no solution of a wheel).
        """
        with self._lock:
            status = self._status = _wrc_contact_mark(self._handle)
            if status < 0:
                raise self._error(status)

    def commit(self) -> None:
        """Commits the contact's last solution of a wheel, of a model with config.surface.memory. Later calls
            begin with its tractions. It is marked as by Contact.mark(). Until the next commit results depend
            on this step and the input of the call alone, to the last bit. Trial steps, rejected ones and
            differences leave no trace. A contact begins without tractions. The committed step is saved and
            restored with the state. Theory manual, section 5.

        C status: Status.OK; Status.ERROR_NULL; _UNSUPPORTED (a model without config.surface.memory);
            _SEQUENCE (the last call left no solution of a wheel, or it is committed already).
        """
        with self._lock:
            status = self._status = _wrc_contact_commit(self._handle)
            if status < 0:
                raise self._error(status)

    def wrench_derivatives(self, input: WheelInput, *, wrench: Optional[Wrench] = None, derivatives: Optional[WrenchDerivatives] = None) -> Tuple[Wrench, WrenchDerivatives]:
        """Contact.wrench() with the derivatives of its wrench, for implicit integrators: those of the discrete
            equations, not differences. Over temperature and with config.surface.memory the part of the
            tractions is a difference. The call takes two to three times the time of the wrench, over
            temperature four to five times. With memory it takes ten times, with a load given four times.
            Theory manual, section 9.

        input: as for Contact.wrench()
        wrench: as for Contact.wrench(), the same bits; None: a new one
        derivatives: zero without contact; with Status.FLAG_BEYOND_GAP those at 2 mm overlap; None: a new one

        C status: as Contact.wrench(); Status.FLAG_MORE_PATCHES and zero derivatives with more strips in
            contact than there is room for: 76 of the default widths, 56 at "real time".
        """
        if wrench is None:
            wrench = Wrench._new()
        if derivatives is None:
            derivatives = WrenchDerivatives._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_wrench_derivatives(self._handle, input, wrench, derivatives)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, input=(input, WheelInput), wrench=(wrench, Wrench), derivatives=(derivatives, WrenchDerivatives)) from None
        return wrench, derivatives

    def region(self, index: int, *, out: Optional[Region] = None) -> Region:
        """One region of the contact's last solution: of Contact.wrench() or of the stages of wrc_planar.h,
            whichever came later. The results stay. After a restored state or derivatives the first call here
            or below solves Contact.planar_tangential() again, at its cost.

        index: 0 .. number of regions - 1, from the gauge side to the field side of a rail, on a contact plane
            by increasing y
        out: the region; None: a new one

        C status: Status.OK; Status.FLAG_TABLE_RANGE (|psi| cut to 0.95); Status.ERROR_NULL, _STRUCT_SIZE,
            _SEQUENCE (no solution), _RANGE (no such region).
        """
        if out is None:
            out = Region._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_region(self._handle, index, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, Region)) from None
        return out

    def damage(self, index: int, *, out: Optional[Damage] = None) -> Damage:
        """Wear and fatigue numbers of one region of the contact's last solution. Theory manual, section 6; paper
            eq. 10 to 12.

        index: as for Contact.region(); ALL_REGIONS: all patches of a contact plane together
        out: the numbers; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT; Status.ERROR_NULL; _SEQUENCE (no solution); _RANGE (no
            such region, or ALL_REGIONS of a wheel).
        """
        if out is None:
            out = Damage._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_damage(self._handle, index, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, Damage)) from None
        return out

    def planar_step(self, input: PlanarInput, *, out: Optional[PlanarOutput] = None) -> PlanarOutput:
        """All stages at once: geometry (without input->gap) or the given gap, normal, regularise, tangential,
            damage.

        input: what to solve
        out: the results; None: a new one

        C status: Status.OK or the gravest flag of the stages; the failure of the first stage that fails,
            which ends the step.
        """
        if out is None:
            out = PlanarOutput._new()
        try:
            with self._lock:
                status = self._status = _wrc_planar_step(self._handle, input, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, input=(input, PlanarInput), out=(out, PlanarOutput)) from None
        return out

    def planar_geometry(self, pose: PlanarPose, *, out: Optional[PlanarPoint] = None) -> PlanarPoint:
        """Finds the initial contact point of a pose, the lowest one, and samples the gap around it. Rows reach
            up to 30 mm to either side. Theory manual, section 7.

        pose: of the wheelset, track frame
        out: where the bodies touch first; None: a new one

        C status: Status.OK; Status.FLAG_ITERATION_CAP; Status.ERROR_NULL, _SEQUENCE (model without profiles),
            _NOT_FINITE, _RANGE, _GAP (no rail below the wheel at this pose).
        """
        if out is None:
            out = PlanarPoint._new()
        try:
            with self._lock:
                status = self._status = _wrc_planar_geometry(self._handle, pose, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, pose=(pose, PlanarPose), out=(out, PlanarPoint)) from None
        return out

    def planar_creepages(self, motion: PlanarMotion, *, out: Optional[Creepage] = None) -> Creepage:
        """Creepages at the origin of the contact frame of the last Contact.planar_geometry(), from the rigid
            motion of the wheelset. The velocity of the wheel's point is divided by the amount of the rolling
            speed V. That is the mean of the speeds of wheel and rail material through the contact. A locked
            wheel has half its speed and creepage 2.
          - Below |V| = 0.1 m/s the divisor is 0.1 m/s (3 + 6 u^2 - u^4) / 8, u = |V| / 0.1 m/s. speed has its
              amount and the sign of V. reverse_share goes to 0.5 at V = 0. Forces are twice differentiable in
              the motion through V = 0.
          - Where a creepage would pass its range, all are divided by more, and speed grows by it.
          - |speed| ends at 200 m/s. Theory manual, section 7.

        motion: of the wheelset, track frame
        out: for Contact.planar_tangential(), as it stands; None: a new one

        C status: Status.OK; Status.FLAG_CREEPAGES_LIMITED (any of these three); Status.ERROR_NULL, _SEQUENCE
            (no Contact.planar_geometry before), _NOT_FINITE, _RANGE.
        """
        if out is None:
            out = Creepage._new()
        try:
            with self._lock:
                status = self._status = _wrc_planar_creepages(self._handle, motion, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, motion=(motion, PlanarMotion), out=(out, Creepage)) from None
        return out

    def planar_normal(self, load: PlanarLoad, gap: Optional[PlanarGap] = None, *, out: Optional[PlanarNormalSolution] = None) -> PlanarNormalSolution:
        """Solves the normal problem and regularises the patch. Strips stay in the contact. Theory manual,
            sections 2 and 3.

        gap: contact frame; copied; None: the gap already in the contact, of Contact.planar_geometry() or of
            an earlier call
        load: along the contact normal
        out: the solution; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT (approach <= 0, or damping takes all of the force);
            _ITERATION_CAP, _PATCH_AT_EDGE, _MORE_PATCHES, _TABLE_RANGE (|psi| cut to 0.95); _LOAD_JUMPS
            (HERTZ to STRIPES: no approach carries the load; the one of the next larger load is returned),
            _BEYOND_GAP (deeper than config.planar.gap_limit: continued with the last stiffness, the patch
            stays); Status.ERROR_NULL, _SEQUENCE (gap is None and the contact has none), _GAP, _LOAD,
            _NOT_FINITE, _RANGE, _UNSUPPORTED.
        """
        if out is None:
            out = PlanarNormalSolution._new()
        try:
            with self._lock:
                status = self._status = _wrc_planar_normal(self._handle, gap, load, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, gap=(gap, PlanarGap), load=(load, PlanarLoad), out=(out, PlanarNormalSolution)) from None
        return out

    def planar_regularise(self, strips: Optional[PlanarStrips] = None, *, out: Optional[PlanarNormalSolution] = None) -> PlanarNormalSolution:
        """Takes a pressure distribution of the caller as the contact's patch and finds its equivalent double
            ellipse. Theory manual, section 3; paper section 2.

        strips: contact frame, whose origin must be the initial contact point; copied; None: the strips in the
            contact
        out: sums over the strips, with their double ellipse; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT (no pressure), _TABLE_RANGE (|psi| cut to 0.95);
            Status.ERROR_NULL, _SEQUENCE (strips is None and the contact has none), _RANGE, _NOT_FINITE.
        """
        if out is None:
            out = PlanarNormalSolution._new()
        try:
            with self._lock:
                status = self._status = _wrc_planar_regularise(self._handle, strips, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, strips=(strips, PlanarStrips), out=(out, PlanarNormalSolution)) from None
        return out

    def planar_roll(self, distance: float) -> None:
        """Tells a contact of a model with config.planar.non_steady how far it has rolled since its last
            tangential stage. Distances add up. The next Contact.planar_tangential() takes them: every
            particle brings along its traction, and pressure is that of the end. Creepages times the distance
            are the rigid displacement of the wheel over the rail. The sign of creepage.speed is the way of
            rolling. With speed 0 the wheel rests, and the displacement is a shift. Over two lengths of the
            patch rolling is steady. A contact begins without tractions, also after the bodies have been
            apart. Save and restore hold them. Theory manual, "Contact with memory".

        distance: rolled either way, or at rest the length that creepages are per, 0..1e6 m

        C status: Status.OK; Status.ERROR_NULL, _RANGE, _NOT_FINITE, _UNSUPPORTED (a model without
            config.planar.non_steady).
        """
        with self._lock:
            status = self._status = _wrc_planar_roll(self._handle, distance)
            if status < 0:
                raise self._error(status)

    def planar_tangential(self, creepage: Creepage, friction: Friction, ellipse: Optional[Ellipse] = None, *, out: Optional[PlanarForces] = None) -> PlanarForces:
        """Solves the tangential problem of rolling, steady but for config.planar.non_steady. Theory manual,
            sections 4 and 5; paper eq. 5 to 9.

        ellipse: exact double ellipse with its joint at the origin, which replaces the contact's patches; its
            pressure is semi-elliptic, p0 = 1.5 N / (pi a b); None: the patches in the contact
        creepage: at the origin of the contact frame
        friction: between the bodies
        out: on the wheel, contact frame; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT, _TABLE_RANGE, _ITERATION_CAP, _CREEPAGES_LIMITED
            (creepage.reverse_share is not 0); Status.ERROR_NULL, _SEQUENCE (no patch, or friction zones over
            a profile without a Contact.planar_geometry()), _RANGE, _NOT_FINITE, _UNSUPPORTED.
        """
        if out is None:
            out = PlanarForces._new()
        try:
            with self._lock:
                status = self._status = _wrc_planar_tangential(self._handle, ellipse, creepage, friction, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, ellipse=(ellipse, Ellipse), creepage=(creepage, Creepage), friction=(friction, Friction), out=(out, PlanarForces)) from None
        return out

    def planar_tangential_derivatives(self, *, out: Optional[PlanarDerivatives] = None) -> PlanarDerivatives:
        """Derivatives of the forces of the last Contact.planar_tangential() or Contact.planar_step() by
            creepages, load and friction. FASTSIM with separate flexibilities and strip FASTSIM have those of
            the discrete equations, for two to three times the cost of the forces. Methods of which friction
            or slope falls, and all others, have central differences with steps of a thousandth, for eight
            times the cost. The creep force has kinks where a cell changes between stick and slip: there it is
            one side's. The contact stays as it is.

        out: of the forces; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT, _TABLE_RANGE, _ITERATION_CAP, _CREEPAGES_LIMITED (as
            Contact.planar_tangential()); Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no
            Contact.planar_tangential()).
        """
        if out is None:
            out = PlanarDerivatives._new()
        try:
            with self._lock:
                status = self._status = _wrc_planar_tangential_derivatives(self._handle, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, PlanarDerivatives)) from None
        return out

    def wear(self, index: int, laws: Optional[WearLaws] = None, *, out: Optional[Wear] = None) -> Wear:
        """Wear of one region of the contact's last solution, by all four laws. Theory manual, section 6.

        index: as for Contact.damage()
        laws: parameters; None: the published ones
        out: the numbers; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no solution),
            _NOT_FINITE, _RANGE (no such region, or ALL_REGIONS of a wheel), _UNSUPPORTED (no tractions).
        """
        if out is None:
            out = Wear._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_wear(self._handle, index, laws, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, laws=(laws, WearLaws), out=(out, Wear)) from None
        return out

    def temperature(self, index: int, bulk: Optional[BulkTemperatures] = None, *, out: Optional[Temperature] = None) -> Temperature:
        """Temperatures in one region of the contact's last solution, from its frictional power. They are flash
            temperatures of points that pass through the contact (Ertz and Knothe, Wear 253 (2002) 498), T(s)
            = (beta_w T_w + beta_r T_r) / (beta_w + beta_r) + 1 / ((beta_w + beta_r) sqrt(pi V)) Int_0^s q /
            sqrt(s - s') ds', s from the leading edge along each strip, q the power density, beta =
            sqrt(conductivity density specific_heat). Heat flows into the depth alone, which holds from some
            0.1 m/s on. Below, temperatures are too high and go to zero with the speed. Near standstill they
            are those of the way that the wheel rolls. Cost grows with strips * cells^2. Theory manual,
            section 6.

        index: as for Contact.damage()
        bulk: temperatures of the bodies; None: the defaults
        out: the numbers: x as Field.X, y as Field.STRIP_Y; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no solution),
            _NOT_FINITE, _RANGE (no such region, or ALL_REGIONS of a wheel), _UNSUPPORTED (no tractions).
        """
        if out is None:
            out = Temperature._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_temperature(self._handle, index, bulk, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, bulk=(bulk, BulkTemperatures), out=(out, Temperature)) from None
        return out

    def exact_check(self, options: Optional[ExactCheckOptions] = None, progress: s.ProgressArgument = None, *, out: Optional[ExactCheckResult] = None) -> ExactCheckResult:
        """Solves the tangential problem of the contact's last stages exactly, and reports the errors of the
            real-time method. Pressure is that of the contact's strips, on nx x ny cells over its patches.
            Creepages, friction and friction.slope_reduction are its own. The contact is not changed.

        options: None: the defaults
        progress: called with the fraction done; give something true to stop; None: none
        out: exact forces and the errors; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT, _ITERATION_CAP; Status.ERROR_NULL, _STRUCT_SIZE, _RANGE,
            _SEQUENCE, _UNSUPPORTED (both ways of rolling blended: creepage.reverse_share is not 0), _MEMORY,
            _CANCELLED.
        """
        if out is None:
            out = ExactCheckResult._new()
        _watch = s.Watch(progress)
        if progress:
            options = options.copy() if options else ExactCheckOptions()
            options.progress = _watch.c
        try:
            with self._lock:
                status = self._status = _wrc_exact_check(self._handle, options, out)
                _watch.end()
                if status < 0:
                    raise self._error(status, _watch)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, options=(options, ExactCheckOptions), out=(out, ExactCheckResult)) from None
        return out

    def exact_wrench(self, input: WheelInput, options: Optional[ExactWrenchOptions] = None, progress: s.ProgressArgument = None, *, out: Optional[Wrench] = None) -> Wrench:
        """Exact counterpart of Contact.wrench(): normal contact and steady rolling over cells on the rail's
            curved surface. Every cell has its gap along its own normal and the sliding of its own surface
            points. Half-space coefficients are those over arc length between frames turned against each
            other, so that pressure and tractions act on one another.
          - Friction zones and falling friction are each row of cells'. Both ways of rolling near standstill
              are as in Contact.wrench().
          - Damping goes by the speed at which a row's surfaces near each other at its middle.
          - friction.slope_reduction divides what tractions move the surfaces along each other: theory manual,
              sections 5, 7 and 9.
          - Takes from a tenth of a second to minutes, growing with the second to fourth power of 1 / cell.
          - The contact keeps its last Contact.wrench(). On a rail that changes along the track every cell has
              its gap to the rail as it is there, and its sliding along it. Normals turn with the section, and
              forces lean along the track, row by row as they do where the wheel is nearest. Surfaces (a check
              rail, a blade) are solved each alone, with its own rolling speed, and added up. A wheel that is
              not round has its radius at every cell. Its hollows are bridged as by a rail that is level along
              the track. A row of cells looks for the wheel up to 120 mm ahead and behind and starts where
              that is nearest; it has cells up to 100 mm from there, on the level and on a ramp at once.

        input: as for Contact.wrench(); without FrictionTemperatureLaw.LINEAR: there are no temperatures
        options: None: the defaults
        progress: called with the fraction done; give something true to stop; None: none
        out: the result; iterations are heights and turns of normal and tangential problem tried; regions are
            counted, Contact.region() does not have them; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT, _ITERATION_CAP, _PATCH_AT_EDGE (the contact reaches the
            end of a profile or surface), _CREEPAGES_LIMITED, _BEYOND_SECTIONS; Status.ERROR_NULL,
            _STRUCT_SIZE, _NOT_FINITE, _RANGE (also: more than a million cells), _UNSUPPORTED, _LOAD, _MEMORY,
            _CANCELLED.
        """
        if out is None:
            out = Wrench._new()
        _watch = s.Watch(progress)
        if progress:
            options = options.copy() if options else ExactWrenchOptions()
            options.progress = _watch.c
        try:
            with self._lock:
                status = self._status = _wrc_exact_wrench(self._handle, input, options, out)
                _watch.end()
                if status < 0:
                    raise self._error(status, _watch)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, input=(input, WheelInput), options=(options, ExactWrenchOptions), out=(out, Wrench)) from None
        return out


def linear_coefficients(a_over_b: float, psi: float, poisson: float, *, out: Optional[Coefficients] = None) -> Coefficients:
    """Coefficients of the linear theory. Theory manual, section 4; paper eq. 5.

    a_over_b: axis ratio, 1e-3..1e3
    psi: shape number, -0.95..0.95
    poisson: 0..0.5
    out: the coefficients; None: a new one

    C status: Status.OK; Status.FLAG_TABLE_RANGE beyond the tables; Status.ERROR_NULL, _RANGE, _NOT_FINITE.
    """
    if out is None:
        out = Coefficients._new()
    try:
        _l.check(_wrc_linear_coefficients(a_over_b, psi, poisson, out))
    except c.ArgumentError as _why:
        raise _l.misfit(_why, out=(out, Coefficients)) from None
    return out


def shakedown_limit(utilisation: float) -> float:
    """Shakedown curve of the line contact: load factor p0/k above which the surface ratchets. Theory manual,
        section 6.

    utilisation: mu_a, 0..10
    load_factor: p0/k; 0 on failure

    C status: Status.OK; Status.ERROR_NULL, _RANGE, _NOT_FINITE.
    """
    load_factor = c.c_double()
    _l.check(_wrc_shakedown_limit(utilisation, c.byref(load_factor)))
    return load_factor.value


def shakedown_limit_point(utilisation: float) -> float:
    """The same of a circular point contact, for material that hardens kinematically: below the surface up to
        mu_a = 0.22, 1 / mu_a beyond. Theory manual, section 6.

    utilisation: mu_a, 0..10
    load_factor: p0/k; 0 on failure

    C status: Status.OK; Status.ERROR_NULL, _RANGE, _NOT_FINITE.
    """
    load_factor = c.c_double()
    _l.check(_wrc_shakedown_limit_point(utilisation, c.byref(load_factor)))
    return load_factor.value


STRUCTS = {
    'wrc_profile': Profile,
    'wrc_material': Material,
    'wrc_heat_properties': HeatProperties,
    'wrc_config_wheelset': ConfigWheelset,
    'wrc_config_track': ConfigTrack,
    'wrc_rail_section': RailSection,
    'wrc_config_roundness': ConfigRoundness,
    'wrc_config_check_rail': ConfigCheckRail,
    'wrc_config_normal': ConfigNormal,
    'wrc_config_tangential': ConfigTangential,
    'wrc_config_surface': ConfigSurface,
    'wrc_config_planar': ConfigPlanar,
    'wrc_config': Config,
    'wrc_allocator': Allocator,
    'wrc_view': View,
    'wrc_bulk_temperatures': BulkTemperatures,
    'wrc_friction': Friction,
    'wrc_wheel_state': WheelState,
    'wrc_rail_state': RailState,
    'wrc_frame_motion': FrameMotion,
    'wrc_wheel_input': WheelInput,
    'wrc_wrench': Wrench,
    'wrc_wrench_derivatives': WrenchDerivatives,
    'wrc_creepage': Creepage,
    'wrc_ellipse': Ellipse,
    'wrc_region': Region,
    'wrc_damage': Damage,
    'wrc_planar_pose': PlanarPose,
    'wrc_planar_motion': PlanarMotion,
    'wrc_planar_point': PlanarPoint,
    'wrc_planar_gap': PlanarGap,
    'wrc_planar_load': PlanarLoad,
    'wrc_planar_strips': PlanarStrips,
    'wrc_planar_normal_solution': PlanarNormalSolution,
    'wrc_planar_forces': PlanarForces,
    'wrc_planar_derivatives': PlanarDerivatives,
    'wrc_planar_input': PlanarInput,
    'wrc_planar_output': PlanarOutput,
    'wrc_wear_laws': WearLaws,
    'wrc_wear': Wear,
    'wrc_coefficients': Coefficients,
    'wrc_stress_peak': StressPeak,
    'wrc_stress_peaks': StressPeaks,
    'wrc_stresses': Stresses,
    'wrc_temperature': Temperature,
    'wrc_damage_bin': DamageBin,
    'wrc_damage_bins': DamageBins,
    'wrc_fatigue_laws': FatigueLaws,
    'wrc_accumulation': Accumulation,
    'wrc_damage_totals': DamageTotals,
    'wrc_grid': Grid,
    'wrc_exact_normal_problem': ExactNormalProblem,
    'wrc_exact_normal_solution': ExactNormalSolution,
    'wrc_exact_rolling_problem': ExactRollingProblem,
    'wrc_exact_rolling_solution': ExactRollingSolution,
    'wrc_exact_loads': ExactLoads,
    'wrc_exact_wrench_options': ExactWrenchOptions,
    'wrc_exact_check_options': ExactCheckOptions,
    'wrc_exact_check_result': ExactCheckResult,
    'wrc_creep_curve': CreepCurve,
    'wrc_creep_fit': CreepFit,
    'wrc_wheelset_geometry_problem': WheelsetGeometryProblem,
    'wrc_wheelset_geometry': WheelsetGeometry,
    'wrc_conicity_problem': ConicityProblem,
    'wrc_conicity': Conicity,
    'wrc_profile_wear': ProfileWear,
    'wrc_worn_profile': WornProfile,
    'wrc_flange': Flange,
    'wrc_section_line': SectionLine,
    'wrc_rail_faces_problem': RailFacesProblem,
    'wrc_found_faces': FoundFaces,
    'wrc_face_outline': FaceOutline,
    'wrc_surface_bin': SurfaceBin,
    'wrc_surface': Surface,
    'wrc_substance': Substance,
    'wrc_surface_laws': SurfaceLaws,
    'wrc_surface_passage': SurfacePassage,
    'wrc_surface_exchange': SurfaceExchange,
}
__all__ = [
    'Status',
    'Flags',
    'NormalMethod',
    'TangentialMethod',
    'PatchModel',
    'Regularisation',
    'TractionBound',
    'Flexibility',
    'Side',
    'Body',
    'ProfileKind',
    'ProfilePlacement',
    'InstructionSet',
    'FrictionSpeedLaw',
    'FrictionTemperatureLaw',
    'ZoneFrame',
    'WheelReference',
    'Orientation',
    'Axes',
    'Prescribed',
    'Start',
    'Available',
    'Field',
    'WrenchInput',
    'DamageQuantity',
    'Adhesion',
    'Collocation',
    'SurfaceInfluence',
    'CreepParameter',
    'Scatter',
    'ConicityMethod',
    'FaceKind',
    'SurfaceQuantity',
    'SurfaceBook',
    'Profile',
    'Material',
    'HeatProperties',
    'ConfigWheelset',
    'ConfigTrack',
    'RailSection',
    'ConfigRoundness',
    'ConfigCheckRail',
    'ConfigNormal',
    'ConfigTangential',
    'ConfigSurface',
    'ConfigPlanar',
    'Config',
    'Allocator',
    'View',
    'BulkTemperatures',
    'Friction',
    'WheelState',
    'RailState',
    'FrameMotion',
    'WheelInput',
    'Wrench',
    'WrenchDerivatives',
    'Creepage',
    'Ellipse',
    'Region',
    'Damage',
    'PlanarPose',
    'PlanarMotion',
    'PlanarPoint',
    'PlanarGap',
    'PlanarLoad',
    'PlanarStrips',
    'PlanarNormalSolution',
    'PlanarForces',
    'PlanarDerivatives',
    'PlanarInput',
    'PlanarOutput',
    'WearLaws',
    'Wear',
    'Coefficients',
    'StressPeak',
    'StressPeaks',
    'Stresses',
    'Temperature',
    'DamageBin',
    'DamageBins',
    'FatigueLaws',
    'Accumulation',
    'DamageTotals',
    'Grid',
    'ExactNormalProblem',
    'ExactNormalSolution',
    'ExactRollingProblem',
    'ExactRollingSolution',
    'ExactLoads',
    'ExactWrenchOptions',
    'ExactCheckOptions',
    'ExactCheckResult',
    'CreepCurve',
    'CreepFit',
    'WheelsetGeometryProblem',
    'WheelsetGeometry',
    'ConicityProblem',
    'Conicity',
    'ProfileWear',
    'WornProfile',
    'Flange',
    'SectionLine',
    'RailFacesProblem',
    'FoundFaces',
    'FaceOutline',
    'SurfaceBin',
    'Surface',
    'Substance',
    'SurfaceLaws',
    'SurfacePassage',
    'SurfaceExchange',
    'WRENCH_INPUTS',
    'ALL_REGIONS',
    'DAMAGE_SUMS',
    'CREEP_PARAMETERS',
    'SURFACE_QUANTITIES',
    'MOST_FILM_ROWS',
    'SURFACE_BOOKS',
    'linear_coefficients',
    'shakedown_limit',
    'shakedown_limit_point',
]
