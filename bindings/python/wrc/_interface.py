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
VERSION_MINOR = 2
VERSION_PATCH = 0
ABI_VERSION = 2
FLAT_INPUTS = 8
FLAT_OUTPUTS = 12
FLAT_WHEEL_INPUTS = 28
FLAT_WHEEL_OUTPUTS = 18


class Status(s.Choice):
    """What a call returns: 0 done, > 0 done but flagged, < 0 failed."""

    OK = 0
    FLAG_NO_CONTACT = 1
    FLAG_ITERATION_CAP = 2
    FLAG_PATCH_AT_EDGE = 3
    FLAG_MORE_PATCHES = 4
    FLAG_TABLE_RANGE = 5
    FLAG_CREEPAGES_LIMITED = 6
    FLAG_LOAD_LEAPS = 7
    FLAG_BEYOND_GAP = 8
    FLAG_CLIMBING = 9
    FLAG_BEYOND_SECTIONS = 10
    FLAG_UNLIKE_MATERIALS = 11
    FLAG_SUM_OVERFLOW = 12
    ERROR_NULL = -1
    ERROR_STRUCT_SIZE = -2
    ERROR_NOT_FINITE = -3
    ERROR_RANGE = -4
    ERROR_PROFILE = -5
    ERROR_GAP = -6
    ERROR_LOAD = -7
    ERROR_BUFFER = -8
    ERROR_MEMORY = -9
    ERROR_SEQUENCE = -10
    ERROR_UNSUPPORTED = -11
    ERROR_FILE = -12
    ERROR_CANCELLED = -13
    ERROR_INTERNAL = -14


STATUS_TEXTS = {
    0: 'done',
    1: 'the bodies do not touch: all forces are zero',
    2: 'an iteration reached its cap: the last iterate is returned',
    3: 'the patch reaches the edge of the given gap or profile',
    4: 'more contact patches exist than the configuration has room for',
    5: 'the patch is more slender than the coefficient tables: their end is used',
    6: 'nearly at rest, or sliding far faster than rolling: creepages are limited',
    7: 'no approach of this normal method carries the load: it leaps past it there',
    8: 'beyond what the gap or the profiles carry: continued with the last stiffness',
    9: 'friction on a steep face lets no height carry the load, or several',
    10: 'the rail has no section that far along the track: the nearest is used',
    11: "unlike bodies: what couples normal and tangential contact, Kalker's K, is left out",
    12: 'a sum of bins passed its range: what they hold is worthless',
    -1: 'a required pointer is NULL',
    -2: 'struct_size is not that of a known version of the struct',
    -3: 'a value is NaN or infinite',
    -4: 'a value lies outside its allowed range',
    -5: 'a profile cannot be used',
    -6: 'the undeformed gap cannot be used',
    -7: 'the gap cannot carry the prescribed load or approach',
    -8: 'the memory handed over is too small or misaligned',
    -9: 'memory could not be allocated',
    -10: 'a stage was called before the stage whose result it needs',
    -11: 'the requested method, version or combination does not exist',
    -12: 'a file cannot be read or written',
    -13: 'the caller cancelled the work',
    -14: 'internal error: please report it',
}


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

    HERTZ = 0
    KIK_PIOTROWSKI = 1
    EKP = 2
    EKP_ELLIPSE = 3
    ANALYN = 4
    STRIPES = 5
    STRIP_HALFSPACE = 6


class TangentialMethod(s.Choice):
    """Method of the tangential problem. All but the first have the bound friction * pressure.

    FASTSIM: FASTSIM, Kalker 1982, marched in second order, with patch_model, bound and flexibility of
        config.tangential; modified FASTSIM where friction.slope_fall > 0
    FASTRIP: FaStrip, VSD 54 (2016), with config.tangential.patch_model: strip theory where it sticks,
        FASTSIM's directions where it slips
    STRIP_FASTSIM: FASTSIM in the shape of strip theory on the patch as it is, calibrated on exact solutions
    COARSE_HALFSPACE: exact half-space theory on grids of 8 x 8 and 16 x 16 cells, extrapolated: forces within
        about 1 % of mu N, about a hundred times the time of FASTSIM
    FORCE_TABLE: total forces from config.tangential.force_table, exact solutions for double ellipses: no
        tractions, no slip, and nothing that is made of them
    """

    FASTSIM = 0
    FASTRIP = 1
    STRIP_FASTSIM = 2
    COARSE_HALFSPACE = 3
    FORCE_TABLE = 4


class PatchModel(s.Choice):
    """What FASTSIM and FaStrip take for the patch: the strips tractions live on, and the shape whose
        coefficients of linear theory they have. The ellipse has the semi-axes of the equivalent double
        ellipse, a and b of Ellipse.

    PATCH_SDEC: the patch; coefficients of its equivalent double ellipse
    PATCH_ELLIPSE: the patch; coefficients of the equivalent ellipse
    ELLIPSE_AT_MIDDLE: the equivalent ellipse about mid-width, creepage corrected for the shift
    ELLIPSE_AT_POINT: the equivalent ellipse about the contact point: no psi
    """

    PATCH_SDEC = 0
    PATCH_ELLIPSE = 1
    ELLIPSE_AT_MIDDLE = 2
    ELLIPSE_AT_POINT = 3


class Side(s.Choice):
    """Which wheel of the wheelset. The left wheel has its flange at y > 0; frames and signs stay those of the
        top.

    RIGHT: flange at y < 0
    LEFT: flange at y > 0
    """

    RIGHT = 0
    LEFT = 1


class ProfileKind(s.Choice):
    """Where a profile comes from.

    NONE: of both bodies: no geometry, the caller hands over gaps
    POINTS: points y, z of the caller, joined by a cubic spline
    S1002: wheel, EN 13715, from its analytic definition
    PROFILE_60E1: rail, nominal head (R300/R80/R13), uncanted: set rail_inclination, e.g. 1/40
    UIC60_BENCHMARK: rail of the Manchester benchmark; canted 1:40 already: rail_inclination = 0
    """

    NONE = 0
    POINTS = 1
    S1002 = 2
    PROFILE_60E1 = 3
    UIC60_BENCHMARK = 4


class Body(s.Choice):
    """Which of the two bodies.

    WHEEL: the wheel
    RAIL: the rail
    """

    WHEEL = 0
    RAIL = 1


class Regularisation(s.Choice):
    """Criteria by which a patch gets its equivalent double ellipse.

    WIDTH: criteria (1), (2b), (3): area and width kept; the paper's choice
    RATIO: criteria (1), (2), (3): area and length/width ratio kept (KBTNH)
    """

    WIDTH = 0
    RATIO = 1


class TractionBound(s.Choice):
    """Form of the traction bound along a strip. All integrate to friction * load over the patch where friction
        is the same everywhere.

    PARABOLIC: paper eq. 9: right slope at the leading edge; integrates to friction * load
    ELLIPTIC: friction * pressure: the actual pressure of each strip
    ELLIPSOIDAL: friction * load spread like sqrt(x_l^2 - x^2) over the patch, whatever its pressure: the
        pressure of a Kik-Piotrowski patch; on double ellipses the same as ELLIPTIC
    """

    PARABOLIC = 0
    ELLIPTIC = 1
    ELLIPSOIDAL = 2


class Flexibility(s.Choice):
    """How the flexibilities of linear theory enter FASTSIM; the other methods have their own way.

    SEPARATE: one for each force of linear theory: right for small creepage
    SINGLE: Kalker's weighted sum for all: right traction directions at large creepage
    BLENDED: from the first to the second as creepage grows; Vollebregt and Voltr, VSD 61 (2023)
    """

    SEPARATE = 0
    SINGLE = 1
    BLENDED = 2


class FrictionKind(s.Choice):
    """How friction depends on the sliding speed w: of a strip, the root mean square of its rigid slip times the
        rolling speed (with friction.slope_fall: of the patch, speed * |(nu_x, nu_y)|). Theory manual, section
        5.

    CONSTANT: not at all
    FALLING: times (1 - kinetic_ratio) exp(-fall_rate w) + kinetic_ratio: Polach
    STATIC_KINETIC: times kinetic_ratio + (1 - kinetic_ratio) / (1 + w / half_speed): from the static
        coefficient to the kinetic one
    TEMPERATURE: on the temperature of the surfaces, Contact.temperature(): whole up to cold_temperature,
        times hot_ratio from hot_temperature on, linear between, and of each strip the mean over its load;
        found together with the tractions. Not with a method that gives forces alone
    """

    CONSTANT = 0
    FALLING = 1
    STATIC_KINETIC = 2
    TEMPERATURE = 3


class ZoneFrame(s.Choice):
    """Where the y of friction zones counts from.

    CONTACT_FRAME: contact frame: zones move with the contact point
    RAIL_PROFILE: rail profile, as ContactPoint.y_rail: zones stay on the rail; field side > 0. Needs the
        contact point of a Contact.geometry
    WHEEL_PROFILE: wheel profile, as ContactPoint.y_wheel: zones stay on the wheel, as a lubricated flange;
        flange side < 0. Needs the same
    """

    CONTACT_FRAME = 0
    RAIL_PROFILE = 1
    WHEEL_PROFILE = 2


class ProfilePlacement(s.Choice):
    """Where profiles lie.

    GAUGE: rails by track_gauge and gauge_depth, their tops at z = 0: of new profiles
    ORIGIN: rails by the origin of their points: it lies at y = rail_origin, z = 0, so that a worn rail stays
        where the new one was; their inclination turns them about it
    """

    GAUGE = 0
    ORIGIN = 1


class InstructionSet(s.Choice):
    """Instruction set of the kernels. Results are the same bits with all of them.

    BEST: the widest this processor has
    BASELINE: what every processor of this architecture has: SSE2, NEON
    AVX2: x86-64 with AVX2
    AVX512: x86-64 with AVX-512 F, DQ, VL
    """

    BEST = 0
    BASELINE = 1
    AVX2 = 2
    AVX512 = 3


class Prescribed(s.Choice):
    """Which of load and approach is given; the other is a result.

    LOAD: normal_force is given
    APPROACH: approach is given: the choice near lift-off
    """

    LOAD = 0
    APPROACH = 1


class Available(enum.IntFlag):
    """What a result holds besides what it always has.

    TRACTIONS: what is made of tractions and slip: not with a method that gives forces alone
    PLACE: places in the track frame: not with a gap, strips or an ellipse of the caller
    """

    TRACTIONS = 1
    PLACE = 2


class FieldId(s.Choice):
    """Arrays of the last step that wrc_contact_field() shows without copying, in the contact frame. Fields over
        cells have count[0] = cells along the strip (0 is at the leading edge: at +x, rolling backwards at -x)
        and count[1] = strips (by increasing y); fields over strips have count[0] = strips. After
        Contact.tangential strips are those the tractions live on: of the ellipse, where the patch model has
        one.

    X: cells: x of the cell centre [m]
    PRESSURE: cells: normal pressure [Pa]
    TRACTION_X: cells: tangential traction on the wheel [Pa]
    TRACTION_Y: cells: see FieldId.TRACTION_X
    SLIP_X: cells: sliding velocity / rolling speed [-]
    SLIP_Y: cells: see FieldId.SLIP_X
    POWER_DENSITY: cells: power per area, paper eq. 10 [W/m^2]; needs Contact.damage
    FATIGUE_INDEX: cells: local surface fatigue index, paper eq. 12 [-]; needs Contact.damage
    STRIP_Y: strips: lateral middle [m]
    STRIP_WIDTH: strips: lateral width [m]
    STRIP_CENTRE: strips: x of the middle [m]
    STRIP_HALF: strips: half length [m]
    STRIP_PEAK: strips: peak pressure [Pa]
    STRIP_POWER: strips: frictional power per unit width [W/m]; needs Contact.damage
    GAP_Y: gap rows: y [m] (after Contact.geometry or a gap of your own)
    GAP_HEIGHT: gap rows: smallest gap of the row [m]
    GAP_CENTRE: gap rows: x of that smallest gap [m]
    GAP_CURVATURE: gap rows: d2h/dx2 [1/m]
    STRIP_WEAR: strips: volume lost per metre rolled and per width, Sheffield's law [m]; needs Contact.wear
    STRIP_FRICTION: strips: coefficient of friction the law gave [-]; needs Contact.tangential
    TEMPERATURE_RISE: cells: rise of both surfaces by friction over what they have at first touch [K]; needs
        Contact.temperature
    """

    X = 0
    PRESSURE = 1
    TRACTION_X = 2
    TRACTION_Y = 3
    SLIP_X = 4
    SLIP_Y = 5
    POWER_DENSITY = 6
    FATIGUE_INDEX = 7
    STRIP_Y = 8
    STRIP_WIDTH = 9
    STRIP_CENTRE = 10
    STRIP_HALF = 11
    STRIP_PEAK = 12
    STRIP_POWER = 13
    GAP_Y = 14
    GAP_HEIGHT = 15
    GAP_CENTRE = 16
    GAP_CURVATURE = 17
    STRIP_WEAR = 18
    STRIP_FRICTION = 19
    TEMPERATURE_RISE = 20


class WheelReference(s.Choice):
    """Which point of the rotating body the pose, the velocity and the moment refer to.

    WHEELSET: O, the middle of the axle
    WHEEL: W, where the plane of the tape circle meets the axle: independent wheels, elastic axles
    """

    WHEELSET = 0
    WHEEL = 1


class Axes(s.Choice):
    """In which axes an angular velocity is given.

    TRACK: track axes
    BODY: the body's: those of roll and yaw, which do not turn with the pitch, or of rotation
    """

    TRACK = 0
    BODY = 1


class WheelPrescribed(s.Choice):
    """Which of height and load of a wheel is given; the other is a result.

    HEIGHT: wheel.z is given: the choice of a dynamic simulation
    VERTICAL_LOAD: vertical_load is given, z of the reference point is found
    """

    HEIGHT = 0
    VERTICAL_LOAD = 1


class WheelStart(s.Choice):
    """Where the sweeps over the strips, and the search for the height of a load, begin.

    ANEW: results depend on the inputs of the call alone, to the last bit
    FROM_LAST: the contact's last solution: a third faster where poses follow each other. Results then depend
        on the calls before, by at most 1e-7 of the normal force. For explicit integrators and fixed steps:
        the iterations of an implicit one that are to end at 1e-8 see that
    """

    ANEW = 0
    FROM_LAST = 1


class RegionField(s.Choice):
    """What wrc_contact_region_field() writes of a region: one value per strip, by increasing arc length, or one
        per cell of its strips. Each strip has axes of its own on the rail's surface: x forward along the
        track, s along the rail's arc from its gauge side to its field side, on either side of the track.

    X: cells: x of the middle, as Region.point[0] [m]
    PRESSURE: cells: normal pressure in the middle [Pa]
    TRACTION_X: cells: tangential traction on the wheel along x [Pa]
    TRACTION_S: cells: the same along s [Pa]
    SLIP_X: cells: sliding velocity of the wheel over the rail / rolling speed along x [-]
    SLIP_S: cells: the same along s [-]
    POWER_DENSITY: cells: frictional power per area [W/m^2]
    FATIGUE_INDEX: cells: local surface fatigue index, as FieldId.FATIGUE_INDEX [-]
    STRIP_S: strips: arc length of the middle, from the gauge end of the rail's profile [m]
    STRIP_WIDTH: strips: width along the arc [m]
    STRIP_CENTRE: strips: x of the middle, as Region.point[0] [m]
    STRIP_HALF: strips: half length [m]
    STRIP_PEAK: strips: peak pressure, damping included [Pa]
    STRIP_POWER: strips: frictional power per unit width [W/m]
    STRIP_FRICTION: strips: coefficient of friction the law gave [-]
    STRIP_Y: strips: the middle in the coordinates of the rail's profile, as Region.y_rail [m]
    STRIP_Z: strips: the same, as Region.z_rail [m]
    STRIP_ANGLE: strips: of the rail's surface about x in the same coordinates; < 0 on the gauge side [rad]
    TEMPERATURE_RISE: cells: rise of both surfaces by friction over what they have at first touch [K]:
        Contact.region_temperature()
    """

    X = 0
    PRESSURE = 1
    TRACTION_X = 2
    TRACTION_S = 3
    SLIP_X = 4
    SLIP_S = 5
    POWER_DENSITY = 6
    FATIGUE_INDEX = 7
    STRIP_S = 8
    STRIP_WIDTH = 9
    STRIP_CENTRE = 10
    STRIP_HALF = 11
    STRIP_PEAK = 12
    STRIP_POWER = 13
    STRIP_FRICTION = 14
    STRIP_Y = 15
    STRIP_Z = 16
    STRIP_ANGLE = 17
    TEMPERATURE_RISE = 18


class WrenchInput(s.Choice):
    """What a wrench depends on: the columns of WrenchSensitivities.

    Y: wheel.y [m]
    Z: wheel.z [m], where the height is prescribed
    ROLL: wheel.roll; with rotation that of its axle [rad]
    YAW: wheel.yaw; with rotation that of its axle [rad]
    VELOCITY_X: wheel.velocity[0] [m/s]
    VELOCITY_Y: wheel.velocity[1] [m/s]
    VELOCITY_Z: wheel.velocity[2] [m/s]
    ANGULAR_VELOCITY_X: wheel.angular_velocity[0], in the axes it is given in [rad/s]
    ANGULAR_VELOCITY_Y: wheel.angular_velocity[1] [rad/s]
    ANGULAR_VELOCITY_Z: wheel.angular_velocity[2] [rad/s]
    RAIL_Y: rail.y [m]
    RAIL_Z: rail.z [m]
    RAIL_ROLL: rail.roll [rad]
    RAIL_Y_VELOCITY: rail.y_velocity [m/s]
    RAIL_Z_VELOCITY: rail.z_velocity [m/s]
    RAIL_ROLL_VELOCITY: rail.roll_velocity [rad/s]
    VERTICAL_LOAD: vertical_load [N], where it is prescribed
    DISTANCE: distance [m]; but for what strips grow wider or narrower along the track
    ANGLE: angle [rad]
    """

    Y = 0
    Z = 1
    ROLL = 2
    YAW = 3
    VELOCITY_X = 4
    VELOCITY_Y = 5
    VELOCITY_Z = 6
    ANGULAR_VELOCITY_X = 7
    ANGULAR_VELOCITY_Y = 8
    ANGULAR_VELOCITY_Z = 9
    RAIL_Y = 10
    RAIL_Z = 11
    RAIL_ROLL = 12
    RAIL_Y_VELOCITY = 13
    RAIL_Z_VELOCITY = 14
    RAIL_ROLL_VELOCITY = 15
    VERTICAL_LOAD = 16
    DISTANCE = 17
    ANGLE = 18


class DamageQuantity(s.Choice):
    """What bins collect. Sums: a bin's volume over its width (and over a wheel's circumference, or a rail's
        length) is a depth; a fatigue sum over its width and over the length rolled (or a rail's length) is
        the index of each passage, added up. Each range is that of a sum; single contributions may be half of
        it.

    WORK: frictional work [J], +-8e12; over the distance it is T-gamma
    WEAR_T_GAMMA: volume worn by the T-gamma law [m^3], +-8e6; spread like the work
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

    WORK = 0
    WEAR_T_GAMMA = 1
    WEAR_SHEFFIELD = 2
    WEAR_ARCHARD = 3
    WEAR_POWER = 4
    WHOLE_LIFE = 5
    SURFACE_FATIGUE = 6
    TIME = 7
    LARGEST_PRESSURE = 8
    LARGEST_TRACTION = 9


class DamageSource(s.Choice):
    """Which results of a contact are added.

    WRENCH: the last Contact.wrench()
    STAGES: the last Contact.damage() or Contact.step(), of a pose
    """

    WRENCH = 0
    STAGES = 1


class Adhesion(s.Choice):
    """What adhesion means.

    COULOMB: tractions up to friction * pressure, then slip
    FULL: no slip anywhere: linear theory; friction is unused
    """

    COULOMB = 0
    FULL = 1


class Collocation(s.Choice):
    """Where on a cell the discrete equations hold.

    QUARTER_POINT: converges fastest with the grid: the choice for answers
    REFERENCE: reproduces the program CONTACT on its own grid: the choice for comparisons
    """

    QUARTER_POINT = 0
    REFERENCE = 1


class SurfaceInfluence(s.Choice):
    """What half-space coefficients on a curved surface are.

    TURNED: turned between the normals of the two cells: the choice for answers
    PLAIN: a plane's over arc length, the plain conformal setting of CONTACT: for comparisons
    """

    TURNED = 0
    PLAIN = 1


class ConicityMethod(s.Choice):
    """How a conicity is made of a rolling radius difference. Theory manual, "Contact functions and conicity".

    WAVELENGTH: of the cone with the same wavelength: integration of y'' + dr(y) / (e r0) = 0, the method of
        UIC 519 and EN 15302
    REGRESSION: half the slope of the straight line fitted to dr over the amplitude, all displacements
        weighing alike
    """

    WAVELENGTH = 0
    REGRESSION = 1


class Profile(s.Struct):
    """A wheel or rail profile. Points: y strictly increasing, z down, 4 to 20000 points from 1e-12 m to 35 mm
        apart (closer, slopes are made of rounding) over 20 to 500 mm, within 1 m of the origin, without a
        step: 1 mm or more from one point to the next at over 79 degrees (of a rail: 56 degrees, on its upper
        40 mm), between parts below 45 degrees and a fifth as steep. - wheel: y = 0 at the running circle,
        flange at y < 0 (also for a left wheel), z = 0 at y = 0. - rail: y towards the field side, z = 0 at
        the top; gauge side at y < 0 (also for a left rail), where the points reach down to
        config.track.gauge_depth at least, after canting.

    Members:
      kind: ProfileKind (default ProfileKind.NONE)
      count: number of points (4 .. 20000; default 0)
      y [m]: count of them with ProfileKind.POINTS (required)
      z [m]: count of them with ProfileKind.POINTS (required)
      smoothing [m]: of points only: waves of this length along the curve, keep half their height, shorter
          ones next to nothing (a seventeenth at half the length), longer ones nearly all; 0: the points are
          interpolated. Tested: 7e-3 on points every 0.5 mm with 5 um of noise on both bodies. See
          wrc_model_profile() (0 .. 0.05; default 0)
    """

    _c_name_ = 'wrc_profile'
    __slots__ = ()
    kind: ProfileKind = s.Chosen('kind', ProfileKind)  # type: ignore[assignment]
    count: int = s.Count('count')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', count='count', group=('y', 'z'))  # type: ignore[assignment]
    z: Optional[np.ndarray] = s.Pointer('z', count='count', group=('y', 'z'))  # type: ignore[assignment]
    smoothing: float
    _units_ = {'y': 'm', 'z': 'm', 'smoothing': 'm'}
    _hidden_ = ()
    _fields_ = [
        ('_kind', c.c_int32),
        ('_count', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_z', c.POINTER(c.c_double)),
        ('smoothing', c.c_double),
    ]
assert c.sizeof(Profile) == 32


class ConfigMaterial(s.Struct):
    """Elastic and yield properties. Of bodies that are not alike all methods take the combined 1/G = (1/G_w +
        1/G_r) / 2 and nu/G = (nu_w/G_w + nu_r/G_r) / 2, with which pressure alone and traction alone are as
        they should; what couples them, in the measure K/G = ((1 - 2 nu_w)/G_w - (1 - 2 nu_r)/G_r) / 4, is
        left out, and Status.FLAG_UNLIKE_MATERIALS says so when the model is made. Theory manual, section 4.

    Members:
      shear_modulus [Pa]: G, of both bodies or of the wheel (1e8 .. 1e12; default 80e9)
      poisson: nu, of both bodies or of the wheel (0 .. 0.5; default 0.25)
      shear_yield [Pa]: k, yield limit in shear for the fatigue indices (1e6 .. 1e11; default 250e6)
      rail_shear_modulus [Pa]: G of the rail; 0: as the wheel's (0 or 1e8 .. 1e12; default 0)
      rail_poisson: nu of the rail; must be 0 where rail_shear_modulus is (0 .. 0.5; default 0)
    """

    _c_name_ = 'wrc_config_material'
    __slots__ = ()
    shear_modulus: float
    poisson: float
    shear_yield: float
    rail_shear_modulus: float
    rail_poisson: float
    _units_ = {'shear_modulus': 'Pa', 'shear_yield': 'Pa', 'rail_shear_modulus': 'Pa'}
    _hidden_ = ()
    _fields_ = [
        ('shear_modulus', c.c_double),
        ('poisson', c.c_double),
        ('shear_yield', c.c_double),
        ('rail_shear_modulus', c.c_double),
        ('rail_poisson', c.c_double),
    ]
assert c.sizeof(ConfigMaterial) == 40


class HeatProperties(s.Struct):
    """How a body takes up heat. Read by Contact.temperature() and friction over temperature.

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
    _hidden_ = ()
    _fields_ = [
        ('conductivity', c.c_double),
        ('density', c.c_double),
        ('specific_heat', c.c_double),
    ]
assert c.sizeof(HeatProperties) == 24


class ConfigWheelset(s.Struct):
    """Where the wheels are on their axle.

    Members:
      wheel_radius [m]: nominal rolling radius, at the tape circle (0.1 .. 1.5; default 0.46)
      flange_back_distance [m]: between the inner faces of the wheelset; not read without profiles (0.3 ..
          2.5; default 1.360)
    """

    _c_name_ = 'wrc_config_wheelset'
    __slots__ = ()
    wheel_radius: float
    flange_back_distance: float
    _units_ = {'wheel_radius': 'm', 'flange_back_distance': 'm'}
    _hidden_ = ()
    _fields_ = [
        ('wheel_radius', c.c_double),
        ('flange_back_distance', c.c_double),
    ]
assert c.sizeof(ConfigWheelset) == 16


class ConfigTrack(s.Struct):
    """Where the rails are. Not read without profiles.

    Members:
      placement: ProfilePlacement (default ProfilePlacement.GAUGE)
      gauge [m]: between the gauge faces of the rails (0.3 .. 2.5; default 1.435)
      gauge_depth [m]: gauge is measured this far below the rail top (0.005 .. 0.04; default 0.014)
      rail_inclination: tangent of the cant towards the track centre; must be 0 for
          ProfileKind.UIC60_BENCHMARK, which is canted already (-0.2 .. 0.2; default 0)
      rail_origin [m]: distance of the rail profile's origin from the track's centre line (0.2 .. 1.5; default
          0)
    """

    _c_name_ = 'wrc_config_track'
    __slots__ = ()
    placement: ProfilePlacement = s.Chosen('placement', ProfilePlacement)  # type: ignore[assignment]
    reserved: int
    gauge: float
    gauge_depth: float
    rail_inclination: float
    rail_origin: float
    _units_ = {'gauge': 'm', 'gauge_depth': 'm', 'rail_origin': 'm'}
    _hidden_ = ('reserved',)
    _fields_ = [
        ('_placement', c.c_int32),
        ('reserved', c.c_uint32),
        ('gauge', c.c_double),
        ('gauge_depth', c.c_double),
        ('rail_inclination', c.c_double),
        ('rail_origin', c.c_double),
    ]
assert c.sizeof(ConfigTrack) == 40


class RailSection(s.Struct):
    """One cross section of a rail that changes along the track; Contact.wrench() alone reads them. Between two
        sections the rail is blended, twice continuously differentiable by the distance, point by point of
        equal length along both outlines: from end to end, or from mark to mark where marks are given. So
        outlines that are paired should end at the same places of the rail. A face is a surface of its own -
        stock rail, blade, wing rail, nose -, with sections of its own, and is there from the first of them to
        the last: one that begins or ends should do so where the wheel does not touch it. The rail itself
        reaches from the first section of all to the last. Theory manual, section 9.

    Members:
      distance [m]: along the track; of a face increasing, by 1 mm or more (-1e7 .. 1e7; default 0)
      y [m]: where the profile's origin lies, from that of config.rail: towards the field side (-0.5 .. 0.5;
          default 0)
      z [m]: the same downwards (-0.5 .. 0.5; default 0)
      face: which surface it is of: sections of one face stand side by side, faces counted from 0 on, best
          from the gauge side to the field side, as regions are listed (0 .. 3; default 0)
      marks: the same for all sections of a face (0 .. 64; default 0)
      mark [m]: marks of them, y on this profile: of points that belong together with those of equal number on
          the face's other sections; increasing, 1 mm or more from each other and from the ends (-0.5 .. 0.5;
          required)
      profile: its outline, from its own origin, canted as config.rail by config.track.rail_inclination; not
          ProfileKind.UIC60_BENCHMARK beside another
    """

    _c_name_ = 'wrc_rail_section'
    __slots__ = ()
    distance: float
    y: float
    z: float
    face: int
    marks: int = s.Count('marks')  # type: ignore[assignment]
    mark: Optional[np.ndarray] = s.Pointer('mark', count='marks', group=('mark',))  # type: ignore[assignment]
    profile: Profile
    _units_ = {'distance': 'm', 'y': 'm', 'z': 'm', 'mark': 'm'}
    _hidden_ = ()
    _fields_ = [
        ('distance', c.c_double),
        ('y', c.c_double),
        ('z', c.c_double),
        ('face', c.c_int32),
        ('_marks', c.c_uint32),
        ('_mark', c.POINTER(c.c_double)),
        ('profile', Profile),
    ]
assert c.sizeof(RailSection) == 72


class ConfigRoundness(s.Struct):
    """A wheel that is not round: a flat, a polygon, a measurement. Contact.wrench() alone reads it. A periodic
        cubic spline goes through each row. Theory manual, section 9.

    Members:
      angles: places round the wheel in each row, the first again at the end; 0: it is round (0 or 9 .. 20000;
          default 0)
      rows: places across the tread (1 .. 16; default 0)
      angle [rad]: angles of them, increasing, from 0 to 2 pi; 0 is the lowest point at WheelInput.angle 0,
          and angles grow from there towards +x (0 .. 6.2831854; required)
      y [m]: rows of them: where on the wheel's profile the rows are, increasing; between them is blended;
          None: of one row (-0.5 .. 0.5; default None)
      deviation [m]: rows * angles of them, row by row: what the radius has more than that of the profile; in
          each row the last as the first (-0.005 .. 0.005; required)
    """

    _c_name_ = 'wrc_config_roundness'
    __slots__ = ()
    angles: int = s.Count('angles')  # type: ignore[assignment]
    rows: int = s.Count('rows')  # type: ignore[assignment]
    angle: Optional[np.ndarray] = s.Pointer('angle', count='angles', group=('angle',))  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', count='rows', group=('y',))  # type: ignore[assignment]
    deviation: Optional[np.ndarray] = s.Pointer('deviation')  # type: ignore[assignment]
    _units_ = {'angle': 'rad', 'y': 'm', 'deviation': 'm'}
    _hidden_ = ()
    _fields_ = [
        ('_angles', c.c_uint32),
        ('_rows', c.c_uint32),
        ('_angle', c.POINTER(c.c_double)),
        ('_y', c.POINTER(c.c_double)),
        ('_deviation', c.POINTER(c.c_double)),
    ]
assert c.sizeof(ConfigRoundness) == 32


class ConfigGrid(s.Struct):
    """How finely contacts are divided.

    Members:
      strips: strips across the patch (4 .. 512; default 60)
      cells: cells along each strip; memory only with a method that gives forces alone (4 .. 512; default 32)
      gap_rows: rows the gap is sampled at, and most a caller's gap may have (8 .. 4096; default 256)
      max_patches: patches reported; more are flagged (1 .. 16; default 4)
      gap_limit [m]: rows of a pose reach to where the gap exceeds this; deeper approaches are not solved but
          continued, Status.FLAG_BEYOND_GAP (1e-5 .. 0.02; default 1e-3)
    """

    _c_name_ = 'wrc_config_grid'
    __slots__ = ()
    strips: int
    cells: int
    gap_rows: int
    max_patches: int
    gap_limit: float
    _units_ = {'gap_limit': 'm'}
    _hidden_ = ()
    _fields_ = [
        ('strips', c.c_int32),
        ('cells', c.c_int32),
        ('gap_rows', c.c_int32),
        ('max_patches', c.c_int32),
        ('gap_limit', c.c_double),
    ]
assert c.sizeof(ConfigGrid) == 24


class ConfigNormal(s.Struct):
    """The normal problem.

    Members:
      method: NormalMethod (default NormalMethod.STRIP_HALFSPACE)
      max_iterations: cap of the steps of the load search; not read by NormalMethod.STRIP_HALFSPACE (4 ..
          1000; default 60)
      max_sweeps: cap of the sweeps over the strips on each of two grids; read by NormalMethod.STRIP_HALFSPACE
          (4 .. 1000; default 16)
      warm_start: 1: NormalMethod.STRIP_HALFSPACE starts from the contact's last solution (not read by
          Contact.wrench: WheelInput.start); results then depend on the calls before: the same approach again
          moves the force by up to 0.1 %. Unfit for implicit integrators, whose iterations stall on that, and
          for differences between calls. 0: results depend on the inputs of the call alone (0 .. 1; default 0)
      load_tolerance: relative error of a prescribed load at the approach found for it (below 1e-12 as that);
          not read by NormalMethod.STRIP_HALFSPACE, which meets the load to rounding (1e-14 .. 1e-2; default
          1e-10)
    """

    _c_name_ = 'wrc_config_normal'
    __slots__ = ()
    method: NormalMethod = s.Chosen('method', NormalMethod)  # type: ignore[assignment]
    max_iterations: int
    max_sweeps: int
    warm_start: int
    load_tolerance: float
    _units_ = {}
    _hidden_ = ()
    _fields_ = [
        ('_method', c.c_int32),
        ('max_iterations', c.c_int32),
        ('max_sweeps', c.c_int32),
        ('warm_start', c.c_int32),
        ('load_tolerance', c.c_double),
    ]
assert c.sizeof(ConfigNormal) == 24


class ConfigTangential(s.Struct):
    """The tangential problem. wrc_config_use() sets a published method by its name.

    Members:
      method: TangentialMethod (default TangentialMethod.STRIP_FASTSIM)
      patch_model: PatchModel; read by TangentialMethod.FASTSIM and _FASTRIP (default PatchModel.PATCH_SDEC)
      bound: TractionBound; read by TangentialMethod.FASTSIM (default TractionBound.PARABOLIC)
      flexibility: Flexibility; read by TangentialMethod.FASTSIM (default Flexibility.SEPARATE)
      regularisation: Regularisation (default Regularisation.WIDTH)
      force_table: file of the force table, for TangentialMethod.FORCE_TABLE alone: share/wrc/force_table.bin
          of the installed library; read when the model is made, never after (default None)
    """

    _c_name_ = 'wrc_config_tangential'
    __slots__ = ()
    method: TangentialMethod = s.Chosen('method', TangentialMethod)  # type: ignore[assignment]
    patch_model: PatchModel = s.Chosen('patch_model', PatchModel)  # type: ignore[assignment]
    bound: TractionBound = s.Chosen('bound', TractionBound)  # type: ignore[assignment]
    flexibility: Flexibility = s.Chosen('flexibility', Flexibility)  # type: ignore[assignment]
    regularisation: Regularisation = s.Chosen('regularisation', Regularisation)  # type: ignore[assignment]
    reserved: int
    force_table: Optional[str] = s.Text('force_table')  # type: ignore[assignment]
    _units_ = {}
    _hidden_ = ('reserved',)
    _fields_ = [
        ('_method', c.c_int32),
        ('_patch_model', c.c_int32),
        ('_bound', c.c_int32),
        ('_flexibility', c.c_int32),
        ('_regularisation', c.c_int32),
        ('reserved', c.c_uint32),
        ('_force_table', c.c_char_p),
    ]
assert c.sizeof(ConfigTangential) == 32


class ConfigCheckRail(s.Struct):
    """A check rail beside each rail, which guides the back of the wheel's flange; Contact.wrench() alone reads
        it. It is the same all along the track and moves with the rail (RailState). The wheel's profile must
        have its flange's back: points beyond the tip, which z(y) can follow as steeply as points are allowed
        to be.

    Members:
      y [m]: where its profile's origin lies, from that of config.rail: towards the field side, so < 0 (-0.5
          .. 0; default 0)
      z [m]: the same downwards, so < 0 where it stands above the rail's origin (-0.5 .. 0.5; default 0)
      profile: its outline, y as that of the rail: the face that guides is on its field side. Canted as
          config.rail by config.track.rail_inclination; ProfileKind.NONE: there is none
    """

    _c_name_ = 'wrc_config_check_rail'
    __slots__ = ()
    y: float
    z: float
    profile: Profile
    _units_ = {'y': 'm', 'z': 'm'}
    _hidden_ = ()
    _fields_ = [
        ('y', c.c_double),
        ('z', c.c_double),
        ('profile', Profile),
    ]
assert c.sizeof(ConfigCheckRail) == 48


class Config(s.Struct):
    """Everything a model is made of. Begin with wrc_config_default(), which fills the values in brackets. A
        member that the chosen methods do not read must keep that value: anything else is
        Status.ERROR_UNSUPPORTED, with a sentence.

    Members:
      instruction_set: InstructionSet; one this processor lacks is Status.ERROR_UNSUPPORTED (default
          InstructionSet.BEST)
      wheel: profile of the wheel
      rail: profile of the rail; both are ProfileKind.NONE or neither is
      material: of both bodies
      wheel_heat: how the wheel takes up heat
      rail_heat: how the rail does
      wheelset: where the wheels are on their axle
      track: where the rails are
      grid: strips, cells, rows of the gap
      normal: method and options of the normal problem
      tangential: method and options of the tangential problem
      rail_sections: of a rail that changes along the track; 0: it is config.rail everywhere (0 .. 1000;
          default 0)
      non_steady: 1: contacts remember their tractions, and forces follow what changes over the distances told
          to wrc_planar_roll(); one way of rolling, forwards, not with Contact.wrench; read by
          TangentialMethod.STRIP_FASTSIM (0 .. 1; default 0)
      rail_section: rail_sections of them with rail_sections; config.rail is beside them what the rail's place
          follows from and what the stages see (required)
      roundness: of the wheel
      roller_curvature [1/m]: of a rail that is a roller: 1 / its radius at the origin of the rail's profile;
          0: a straight rail (0 or 1e-12 .. 10; default 0)
      check_rail: beside the rail
    """

    _c_name_ = 'wrc_config'
    __slots__ = ()
    struct_size: int
    instruction_set: InstructionSet = s.Chosen('instruction_set', InstructionSet)  # type: ignore[assignment]
    wheel: Profile
    rail: Profile
    material: ConfigMaterial
    wheel_heat: HeatProperties
    rail_heat: HeatProperties
    wheelset: ConfigWheelset
    track: ConfigTrack
    grid: ConfigGrid
    normal: ConfigNormal
    tangential: ConfigTangential
    rail_sections: int = s.Count('rail_sections')  # type: ignore[assignment]
    non_steady: int
    rail_section: Sequence[RailSection] = s.References('rail_section', 'rail_sections')  # type: ignore[assignment]
    roundness: ConfigRoundness
    roller_curvature: float
    check_rail: ConfigCheckRail
    _units_ = {'roller_curvature': '1/m'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_instruction_set', c.c_int32),
        ('wheel', Profile),
        ('rail', Profile),
        ('material', ConfigMaterial),
        ('wheel_heat', HeatProperties),
        ('rail_heat', HeatProperties),
        ('wheelset', ConfigWheelset),
        ('track', ConfigTrack),
        ('grid', ConfigGrid),
        ('normal', ConfigNormal),
        ('tangential', ConfigTangential),
        ('_rail_sections', c.c_uint32),
        ('non_steady', c.c_int32),
        ('_rail_section', c.POINTER(RailSection)),
        ('roundness', ConfigRoundness),
        ('roller_curvature', c.c_double),
        ('check_rail', ConfigCheckRail),
    ]
assert c.sizeof(Config) == 400


class Pose(s.Struct):
    """Pose of the wheelset relative to the track, in the track frame. The vertical position follows from the
        load. What is smaller than 1e-100 counts as 0.

    Members:
      lateral [m]: shift of the wheelset to the right (-0.1 .. 0.1; default 0)
      roll [rad]: about x: right wheel down is positive (-0.2 .. 0.2; default 0)
      yaw [rad]: about z: nose to the right is positive (-0.2 .. 0.2; default 0)
    """

    _c_name_ = 'wrc_planar_pose'
    __slots__ = ()
    lateral: float
    roll: float
    yaw: float
    _units_ = {'lateral': 'm', 'roll': 'rad', 'yaw': 'rad'}
    _hidden_ = ()
    _fields_ = [
        ('lateral', c.c_double),
        ('roll', c.c_double),
        ('yaw', c.c_double),
    ]
assert c.sizeof(Pose) == 24


class ContactPoint(s.Struct):
    """Where wheel and rail first touch when the wheelset of that pose is lowered.

    Members:
      x [m]: on the rail, track frame; x is that of the wheel's point
      y [m]: see x
      z [m]: see x
      y_wheel [m]: in the coordinates of the wheel profile, flange side negative
      y_rail [m]: from the origin of the rail profile, after canting; field side positive
      angle [rad]: contact angle: rotation about x from the track to the contact frame
      vertical_gap [m]: the wheel must be lowered by this, from its running circle level with the rail top
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
    _hidden_ = ()
    _fields_ = [
        ('x', c.c_double),
        ('y', c.c_double),
        ('z', c.c_double),
        ('y_wheel', c.c_double),
        ('y_rail', c.c_double),
        ('angle', c.c_double),
        ('vertical_gap', c.c_double),
        ('rolling_radius', c.c_double),
    ]
assert c.sizeof(ContactPoint) == 64


class Gap(s.Struct):
    """The undeformed gap, when the caller owns the contact search: rows along x at increasing y in the contact
        frame, measured along the normal. Its minimum is first contact; a constant offset is irrelevant. -
        columns == 0: row j is height[j] + curvature[j]/2 (x - centre[j])^2 - columns > 0: element-wise, h[j *
        row_stride + i] at (x[i], y[j]); each row is represented by the parabola fitted to its lowest part,
        what lies less than config.grid.gap_limit / 4 above its minimum but at least three points.

    Members:
      rows: (4 .. config.grid.gap_rows; default 0)
      columns: (0 or 3 .. 100000; default 0)
      y [m]: rows of them, increasing, at least 1e-6 m apart: slopes are read off neighbours, and closer they
          are made of the errors of heights (-0.3 .. 0.3; required)
      height [m]: rows of them (-0.3 .. 0.3; required)
      centre [m]: rows of them; None: zero (-0.3 .. 0.3; default None)
      curvature [1/m]: rows of them (1 / rolling radius for a wheel on a straight rail) (1e-3 .. 1e6;
          required)
      x [m]: columns of them, increasing, at least 1e-6 m apart (-0.3 .. 0.3; required)
      h [m]: (-0.3 .. 0.3; required)
      row_stride: elements from one row of h to the next, >= columns (default 0)
    """

    _c_name_ = 'wrc_planar_gap'
    __slots__ = ()
    rows: int = s.Count('rows')  # type: ignore[assignment]
    columns: int = s.Count('columns')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', count='rows', group=('y', 'height', 'centre', 'curvature'))  # type: ignore[assignment]
    height: Optional[np.ndarray] = s.Pointer('height', count='rows', group=('y', 'height', 'centre', 'curvature'))  # type: ignore[assignment]
    centre: Optional[np.ndarray] = s.Pointer('centre', count='rows', group=('y', 'height', 'centre', 'curvature'))  # type: ignore[assignment]
    curvature: Optional[np.ndarray] = s.Pointer('curvature', count='rows', group=('y', 'height', 'centre', 'curvature'))  # type: ignore[assignment]
    x: Optional[np.ndarray] = s.Pointer('x', count='columns', group=('x',))  # type: ignore[assignment]
    h: Optional[np.ndarray] = s.Pointer('h', matrix=True)  # type: ignore[assignment]
    row_stride: int
    _units_ = {'y': 'm', 'height': 'm', 'centre': 'm', 'curvature': '1/m', 'x': 'm', 'h': 'm'}
    _hidden_ = ()
    _fields_ = [
        ('_rows', c.c_uint32),
        ('_columns', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_height', c.POINTER(c.c_double)),
        ('_centre', c.POINTER(c.c_double)),
        ('_curvature', c.POINTER(c.c_double)),
        ('_x', c.POINTER(c.c_double)),
        ('_h', c.POINTER(c.c_double)),
        ('row_stride', c.c_uint64),
    ]
assert c.sizeof(Gap) == 64


class Load(s.Struct):
    """What presses the bodies together, and damping of the approach if wanted (Hunt and Crossley, J. Appl. Mech.
        42 (1975) 440-445): every pressure is the elastic one times 1 + 3/2 damping * approach_velocity, never
        below 0, on the elastic patch. The force so grows from zero at first touch and never pulls. Everything
        downstream (traction bound, forces.fn, fields, damage) sees this pressure;
        NormalSolution.damping_force is its share of the normal force. An impact at v m/s rebounds with about
        (1 - damping * v) of its velocity while damping * v is small.

    Members:
      prescribed: Prescribed (default Prescribed.LOAD)
      normal_force [N]: along the contact normal; must be set (1e2 .. 1e6; default 0)
      approach [m]: beyond first touch; <= 0: no contact (-1 .. 0.01; default 0)
      approach_velocity [m/s]: d approach / dt; positive while the bodies near each other, as
          Creepage.approach_velocity (-20 .. 20; default 0)
      damping [s/m]: a prescribed load is the whole load; 0: none (0 .. 10; default 0)
    """

    _c_name_ = 'wrc_planar_load'
    __slots__ = ()
    prescribed: Prescribed = s.Chosen('prescribed', Prescribed)  # type: ignore[assignment]
    reserved: int
    normal_force: float
    approach: float
    approach_velocity: float
    damping: float
    _units_ = {'normal_force': 'N', 'approach': 'm', 'approach_velocity': 'm/s', 'damping': 's/m'}
    _hidden_ = ('reserved',)
    _fields_ = [
        ('_prescribed', c.c_int32),
        ('reserved', c.c_uint32),
        ('normal_force', c.c_double),
        ('approach', c.c_double),
        ('approach_velocity', c.c_double),
        ('damping', c.c_double),
    ]
assert c.sizeof(Load) == 40


class Creepage(s.Struct):
    """Rigid slip per unit rolled length and rolling speed: sliding velocities over |speed|. A creepage below
        1e-100 counts as none.

    Members:
      longitudinal: nu_x (-10 .. 10; default 0)
      lateral: nu_y (-10 .. 10; default 0)
      spin [1/m]: phi (-1000 .. 1000; default 0)
      speed [m/s]: rolling speed V: its sign says which edge leads (0: forward), its amount scales the power
          and the sliding speed of friction that falls (-200 .. 200; default 1)
      approach_velocity [m/s]: result of Contact.creepages(), not read: velocity of the wheel's point along
          the contact normal into the rail, for Load
      reverse_share: share of forces, power, adhesion and sensitivities that is of rolling the other way than
          speed says: near standstill Contact.creepages() sets it, and both ways are solved; fields, what
          damage and wear make of them are of the way of speed (0 .. 0.5; default 0)
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
    _hidden_ = ()
    _fields_ = [
        ('longitudinal', c.c_double),
        ('lateral', c.c_double),
        ('spin', c.c_double),
        ('speed', c.c_double),
        ('approach_velocity', c.c_double),
        ('reverse_share', c.c_double),
    ]
assert c.sizeof(Creepage) == 48


class BulkTemperatures(s.Struct):
    """Temperatures of the bodies away from the contact, which friction's heat does not reach while they pass.

    Members:
      wheel [degC]: of the tread (-273 .. 2000; default 20)
      rail [degC]: of the running surface (-273 .. 2000; default 20)
    """

    _c_name_ = 'wrc_bulk_temperatures'
    __slots__ = ()
    wheel: float
    rail: float
    _units_ = {'wheel': 'degC', 'rail': 'degC'}
    _hidden_ = ()
    _fields_ = [
        ('wheel', c.c_double),
        ('rail', c.c_double),
    ]
assert c.sizeof(BulkTemperatures) == 16


class Friction(s.Struct):
    """Friction between the bodies, and what a layer between them does. Each strip of the patch has one
        coefficient: that at rest (coefficient, or of the zones) times what is left of it at the strip's
        sliding speed or temperature. It may vanish: such strips carry no traction. A member that neither the
        kind nor the tangential method reads must be its default: anything else is Status.ERROR_UNSUPPORTED.
        Zones are read where zones > 0. Theory manual, section 5.

    Members:
      coefficient: Coulomb; at rest where it falls with the sliding speed; 0, none, of a wheel on a rail alone
          (wrc_wheel.h) (0 or 1e-4 .. 2; default 0.3)
      kind: FrictionKind (default FrictionKind.CONSTANT)
      zone_frame: ZoneFrame (default ZoneFrame.CONTACT_FRAME)
      kinetic_ratio: friction at high sliding speed over that at rest (Polach's A); not read by
          FrictionKind.CONSTANT (0 .. 1; default 0.4)
      fall_rate [s/m]: FrictionKind.FALLING: Polach's B (0 .. 1000; default 0.6)
      half_speed [m/s]: w at which half of the fall is done (1e-6 .. 100; default 1)
      hot_ratio: friction of hot surfaces over that of cold ones (0 .. 1; default 0.5)
      cold_temperature [degC]: up to which friction is whole (-273 .. 2000; default 0)
      hot_temperature [degC]: from which on friction is hot_ratio of that, at least 1 degC above
          cold_temperature (-273 .. 3000; default 400)
      bulk: of the bodies; read by FrictionKind.TEMPERATURE
      slope_reduction: a layer between the bodies: initial slope of the creep curve over that of clean bodies,
          for every method (0.01 .. 1; default 1)
      slope_limit: modified FASTSIM: share of that slope left at large slip; read by TangentialMethod.FASTSIM
          (0 .. 1; default 0.02)
      slope_fall: modified FASTSIM: how fast the slope falls as slip grows; 0: not; read by
          TangentialMethod.FASTSIM (0 .. 1000; default 0)
      zone_y [m]: breakpoints, zones of them, increasing; two at the same y make a step (-1 .. 1; required)
      zone_coefficient: friction at rest there, zones of them, in place of coefficient; linear between
          breakpoints, constant beyond; a strip has the mean over its width. 0: no friction (0 .. 2; required)
      zones: breakpoints; 0: coefficient everywhere (0 .. 64; default 0)
    """

    _c_name_ = 'wrc_friction'
    __slots__ = ()
    coefficient: float
    kind: FrictionKind = s.Chosen('kind', FrictionKind)  # type: ignore[assignment]
    zone_frame: ZoneFrame = s.Chosen('zone_frame', ZoneFrame)  # type: ignore[assignment]
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
    zone_y: Optional[np.ndarray] = s.Pointer('zone_y', count='zones', group=('zone_y', 'zone_coefficient'))  # type: ignore[assignment]
    zone_coefficient: Optional[np.ndarray] = s.Pointer('zone_coefficient', count='zones', group=('zone_y', 'zone_coefficient'))  # type: ignore[assignment]
    zones: int = s.Count('zones')  # type: ignore[assignment]
    reserved: int
    _units_ = {'fall_rate': 's/m', 'half_speed': 'm/s', 'cold_temperature': 'degC', 'hot_temperature': 'degC', 'zone_y': 'm'}
    _hidden_ = ('reserved',)
    _fields_ = [
        ('coefficient', c.c_double),
        ('_kind', c.c_int32),
        ('_zone_frame', c.c_int32),
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
        ('_zone_coefficient', c.POINTER(c.c_double)),
        ('_zones', c.c_uint32),
        ('reserved', c.c_uint32),
    ]
assert c.sizeof(Friction) == 128


class Ellipse(s.Struct):
    """An equivalent double ellipse and the load it carries: two half ellipses of equal length that meet at the
        joint. Found for every patch; or handed over as a patch, exactly (then pressure is semi-elliptic, p0 =
        1.5 N / (pi a b), and the joint lies at the origin of the contact frame).

    Members:
      a [m]: semi-axis along rolling (1e-6 .. 0.1; default 0)
      b [m]: half its width; it reaches from y - b (1 - psi) to y + b (1 + psi) (1e-6 .. 0.1; default 0)
      psi: shape number; 0 is an ellipse; paper eq. 2 (-0.95 .. 0.95; default 0)
      y [m]: its joint in the contact frame; not read
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
    _hidden_ = ()
    _fields_ = [
        ('a', c.c_double),
        ('b', c.c_double),
        ('psi', c.c_double),
        ('y', c.c_double),
        ('normal_force', c.c_double),
    ]
assert c.sizeof(Ellipse) == 40


class NormalSolution(s.Struct):
    """What the normal problem of a contact came to, all patches together.

    Members:
      patches: separate patches: Contact.patch() has each
      strips: strips under pressure
      iterations: of the root find, or sweeps
      ellipse: of the patch that carries most
      normal_force [N]: compressive positive, damping included
      damping_force [N]: share of normal_force that comes from load.damping; < 0 while the bodies part
      approach [m]: beyond first touch, along the normal; 0 for an ellipse or strips of the caller
      stiffness [N/m]: d normal_force / d approach; of STRIP_HALFSPACE and ANALYN within 6 %; d normal_force /
          d approach_velocity is 3/2 load.damping * (normal_force - damping_force), in N s/m
      peak_pressure [Pa]: largest pressure as solved, not of the equivalent ellipse
      area [m^2]:
      length [m]: extent along x: foremost to rearmost edge of all strips
      width [m]: extent along y: y_max - y_min
      y_min [m]: lateral borders
      y_max [m]: see y_min
    """

    _c_name_ = 'wrc_planar_normal_solution'
    __slots__ = ()
    patches: int
    strips: int
    iterations: int
    reserved: int
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
    _hidden_ = ('reserved',)
    _fields_ = [
        ('patches', c.c_int32),
        ('strips', c.c_int32),
        ('iterations', c.c_int32),
        ('reserved', c.c_uint32),
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
    ]
assert c.sizeof(NormalSolution) == 136


class Strips(s.Struct):
    """A pressure distribution of the caller, as strips along x with semi-elliptic pressure.

    Members:
      count: (1 .. config.grid.strips; default 0)
      y [m]: middle, count of them, increasing; strips must not overlap (-0.3 .. 0.3; required)
      width [m]: count of them (1e-9 .. 0.1; required)
      centre [m]: x of the middle, count of them; None: zero (-0.3 .. 0.3; default None)
      half_length [m]: count of them (1e-9 .. 0.1; required)
      peak [Pa]: count of them (0 .. 1e11; required)
    """

    _c_name_ = 'wrc_planar_strips'
    __slots__ = ()
    count: int = s.Count('count')  # type: ignore[assignment]
    reserved: int
    y: Optional[np.ndarray] = s.Pointer('y', count='count', group=('y', 'width', 'centre', 'half_length', 'peak'))  # type: ignore[assignment]
    width: Optional[np.ndarray] = s.Pointer('width', count='count', group=('y', 'width', 'centre', 'half_length', 'peak'))  # type: ignore[assignment]
    centre: Optional[np.ndarray] = s.Pointer('centre', count='count', group=('y', 'width', 'centre', 'half_length', 'peak'))  # type: ignore[assignment]
    half_length: Optional[np.ndarray] = s.Pointer('half_length', count='count', group=('y', 'width', 'centre', 'half_length', 'peak'))  # type: ignore[assignment]
    peak: Optional[np.ndarray] = s.Pointer('peak', count='count', group=('y', 'width', 'centre', 'half_length', 'peak'))  # type: ignore[assignment]
    _units_ = {'y': 'm', 'width': 'm', 'centre': 'm', 'half_length': 'm', 'peak': 'Pa'}
    _hidden_ = ('reserved',)
    _fields_ = [
        ('_count', c.c_uint32),
        ('reserved', c.c_uint32),
        ('_y', c.POINTER(c.c_double)),
        ('_width', c.POINTER(c.c_double)),
        ('_centre', c.POINTER(c.c_double)),
        ('_half_length', c.POINTER(c.c_double)),
        ('_peak', c.POINTER(c.c_double)),
    ]
assert c.sizeof(Strips) == 48


class Forces(s.Struct):
    """Forces on the wheel in the contact frame, moment about its origin.

    Members:
      fx [N]: creep forces
      fy [N]: see fx
      fn [N]: normal force, compressive positive, damping included
      mz [N m]: spin moment
      power [W]: frictional power at the given speed, >= 0
      adhesion_fraction: share of the patch's area that sticks; Available.TRACTIONS
      available: bits of Available: what else stands here; where one is missing, 0 does
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
    reserved: int
    _units_ = {'fx': 'N', 'fy': 'N', 'fn': 'N', 'mz': 'N m', 'power': 'W'}
    _hidden_ = ('reserved',)
    _fields_ = [
        ('fx', c.c_double),
        ('fy', c.c_double),
        ('fn', c.c_double),
        ('mz', c.c_double),
        ('power', c.c_double),
        ('adhesion_fraction', c.c_double),
        ('_available', c.c_uint32),
        ('reserved', c.c_uint32),
    ]
assert c.sizeof(Forces) == 56


class Patch(s.Struct):
    """One patch of a contact with its forces. Moments are about the origin of the contact frame: the forces of
        all patches add up to those of the contact.

    Members:
      available: bits of Available; where one is missing, 0 stands
      strips: strips the patch is made of
      ellipse: its equivalent double ellipse, with the place of its joint and its load
      forces: on the wheel; zero before Contact.tangential()
      peak_pressure [Pa]:
      area [m^2]:
      length [m]: extent along x
      width [m]: extent along y
      y_min [m]: lateral borders
      y_max [m]: see y_min
      point [m]: the joint in the contact plane, track frame; Available.PLACE
      normal: unit vector into the rail, track frame; Available.PLACE. All patches of a contact plane share
          it; regions of a wheel on a rail have their own (Region)
    """

    _c_name_ = 'wrc_patch'
    __slots__ = ()
    struct_size: int
    available: Available = s.Chosen('available', Available)  # type: ignore[assignment]
    strips: int
    reserved: int
    ellipse: Ellipse
    forces: Forces
    peak_pressure: float
    area: float
    length: float
    width: float
    y_min: float
    y_max: float
    point: np.ndarray = s.Array('point', 160, (3,), c.c_double)  # type: ignore[assignment]
    normal: np.ndarray = s.Array('normal', 184, (3,), c.c_double)  # type: ignore[assignment]
    _units_ = {'peak_pressure': 'Pa', 'area': 'm^2', 'length': 'm', 'width': 'm', 'y_min': 'm', 'y_max': 'm', 'point': 'm'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_available', c.c_uint32),
        ('strips', c.c_int32),
        ('reserved', c.c_uint32),
        ('ellipse', Ellipse),
        ('forces', Forces),
        ('peak_pressure', c.c_double),
        ('area', c.c_double),
        ('length', c.c_double),
        ('width', c.c_double),
        ('y_min', c.c_double),
        ('y_max', c.c_double),
        ('_point', c.c_double * 3),
        ('_normal', c.c_double * 3),
    ]
assert c.sizeof(Patch) == 208


class Motion(s.Struct):
    """Velocity of the wheelset relative to the track, in the track frame.

    Members:
      speed [m/s]: of its middle along the track; backwards < 0 (-200 .. 200; default 0)
      lateral_velocity [m/s]: to the right (-20 .. 20; default 0)
      vertical_velocity [m/s]: down (-20 .. 20; default 0)
      roll_rate [rad/s]: about x (-100 .. 100; default 0)
      yaw_rate [rad/s]: about z (-100 .. 100; default 0)
      pitch_rate [rad/s]: about the axle (y): negative rolling forward (-2000 .. 2000; default 0)
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
    _hidden_ = ()
    _fields_ = [
        ('speed', c.c_double),
        ('lateral_velocity', c.c_double),
        ('vertical_velocity', c.c_double),
        ('roll_rate', c.c_double),
        ('yaw_rate', c.c_double),
        ('pitch_rate', c.c_double),
    ]
assert c.sizeof(Motion) == 48


class Damage(s.Struct):
    """Wear and rolling contact fatigue numbers of the last Contact.tangential.

    Members:
      power [W]: total frictional power, the integral of FieldId.POWER_DENSITY
      peak_power_density [W/m^2]: Available.TRACTIONS
      t_gamma [N]: power / speed: energy dissipated per metre rolled, spin included
      t_gamma_no_spin [N]: |Fx nu_x + Fy nu_y|: the other definition in use
      utilisation: mu_a = sqrt(Fx^2 + Fy^2) / N: abscissa of the shakedown map
      load_factor: p0 / k: ordinate of the shakedown map
      shakedown_limit: of load_factor at mu_a, line contact; ratcheting above
      fatigue_index: FI = mu_a - k / p0, paper eq. 11; damage when positive
      local_fatigue_index: largest local index over the patch, paper eq. 12; Available.TRACTIONS
      available: bits of Available; where one is missing, 0 stands
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
    reserved: int
    _units_ = {'power': 'W', 'peak_power_density': 'W/m^2', 't_gamma': 'N', 't_gamma_no_spin': 'N'}
    _hidden_ = ('reserved',)
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
        ('reserved', c.c_uint32),
    ]
assert c.sizeof(Damage) == 80


class WearLaws(s.Struct):
    """Parameters of the wear laws. wrc_wear_laws_init() fills the published values in brackets; all of them are
        unconfirmed (remembered, not checked against the original texts) and depend on the pair of steels.
        Theory manual, section 6. - T-gamma: area lost per metre rolled (Pearce and Sherratt, Wear 144
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
    struct_size: int
    reserved: int
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
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
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
    """Wear of the last Contact.tangential.

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
    _hidden_ = ()
    _fields_ = [
        ('worn_area_rate', c.c_double),
        ('largest_depth_rate', c.c_double),
        ('largest_depth_velocity', c.c_double),
        ('largest_power_depth_velocity', c.c_double),
    ]
assert c.sizeof(Wear) == 32


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
    _units_ = {}
    _hidden_ = ()
    _fields_ = [
        ('c11', c.c_double),
        ('c22', c.c_double),
        ('c23', c.c_double),
        ('c11s', c.c_double),
        ('c13s', c.c_double),
        ('c22s', c.c_double),
        ('c23s', c.c_double),
    ]
assert c.sizeof(Coefficients) == 56


class Sensitivity(s.Struct):
    """Derivatives of the forces of the last Contact.tangential at its patch.

    Members:
      forces: rows: fx, fy [N], mz [N m]; columns: longitudinal, lateral [-], spin [1/m], normal_force [N]
          (same patch, pressure growing in proportion), friction coefficient [-] (its factor on the whole law;
          with friction.zones, their mean over the load)
    """

    _c_name_ = 'wrc_planar_derivatives'
    __slots__ = ()
    forces: np.ndarray = s.Array('forces', 0, (3, 5), c.c_double)  # type: ignore[assignment]
    _units_ = {}
    _hidden_ = ()
    _fields_ = [
        ('_forces', (c.c_double * 5) * 3),
    ]
assert c.sizeof(Sensitivity) == 120


class StepSensitivity(s.Struct):
    """Derivatives of the last whole step, creepages and friction held.

    Members:
      by_load: of fx, fy, mz and the approach [m] with respect to the normal force [N]; where the approach is
          prescribed, of fx, fy, mz and the normal force with respect to the approach
      by_lateral [m]: of the same four with respect to the lateral shift of the wheelset; zero for a gap of
          the caller
    """

    _c_name_ = 'wrc_step_sensitivity'
    __slots__ = ()
    by_load: np.ndarray = s.Array('by_load', 0, (4,), c.c_double)  # type: ignore[assignment]
    by_lateral: np.ndarray = s.Array('by_lateral', 32, (4,), c.c_double)  # type: ignore[assignment]
    _units_ = {'by_lateral': 'm'}
    _hidden_ = ()
    _fields_ = [
        ('_by_load', c.c_double * 4),
        ('_by_lateral', c.c_double * 4),
    ]
assert c.sizeof(StepSensitivity) == 64


class Input(s.Struct):
    """What Contact.step() reads. What pointers within point to is the caller's and only read during the call.

    Members:
      pose: of the wheelset; not used with gap, but within its ranges all the same
      gap: a gap of the caller in place of the pose; None: the pose (default None)
      load: what presses the bodies together
      creepage: rigid slip at the origin of the contact frame
      friction: between the bodies
    """

    _c_name_ = 'wrc_planar_input'
    __slots__ = ()
    struct_size: int
    reserved: int
    pose: Pose
    gap: Optional[Gap] = s.Reference('gap')  # type: ignore[assignment]
    load: Load
    creepage: Creepage
    friction: Friction
    _units_ = {}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
        ('pose', Pose),
        ('_gap', c.POINTER(Gap)),
        ('load', Load),
        ('creepage', Creepage),
        ('friction', Friction),
    ]
assert c.sizeof(Input) == 256


class Output(s.Struct):
    """What Contact.step() fills.

    Members:
      point: zero when there was no pose
      normal: of the normal stage
      forces: of the tangential stage
      damage: of the damage stage
    """

    _c_name_ = 'wrc_planar_output'
    __slots__ = ()
    struct_size: int
    reserved: int
    point: ContactPoint
    normal: NormalSolution
    forces: Forces
    damage: Damage
    _units_ = {}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
        ('point', ContactPoint),
        ('normal', NormalSolution),
        ('forces', Forces),
        ('damage', Damage),
    ]
assert c.sizeof(Output) == 344


class View(s.Struct):
    """A read-only view of a field: element (i, j) is data[i * stride[0] + j * stride[1]]. Valid until the next
        call on the contact.

    Members:
      data: in the contact's memory; None: not computed
      count: elements along each dimension; count[1] = 1 for rank 1
      stride: in elements
      rank: 1 or 2
    """

    _c_name_ = 'wrc_view'
    __slots__ = ()
    data: Optional[np.ndarray] = s.Pointer('data')  # type: ignore[assignment]
    count: np.ndarray = s.Array('count', 8, (2,), c.c_uint64)  # type: ignore[assignment]
    stride: np.ndarray = s.Array('stride', 24, (2,), c.c_uint64)  # type: ignore[assignment]
    rank: int
    reserved: int
    _units_ = {}
    _hidden_ = ('reserved',)
    _fields_ = [
        ('_data', c.POINTER(c.c_double)),
        ('_count', c.c_uint64 * 2),
        ('_stride', c.c_uint64 * 2),
        ('rank', c.c_uint32),
        ('reserved', c.c_uint32),
    ]
assert c.sizeof(View) == 48


class Allocator(s.Struct):
    """Where memory comes from in wrc_model_create() and wrc_contact_create(). Both functions or neither.

    Members:
      user: handed to both (default None)
      allocate: alignment: a power of two; gives None where none is left (default None)
      release: called by the destroy functions, and when a create fails (default None)
    """

    _c_name_ = 'wrc_allocator'
    __slots__ = ()
    user: Any
    allocate: Any
    release: Any
    _units_ = {}
    _hidden_ = ()
    _fields_ = [
        ('user', c.c_void_p),
        ('allocate', c.c_void_p),
        ('release', c.c_void_p),
    ]
assert c.sizeof(Allocator) == 24


class WheelState(s.Struct):
    """Where a wheel or wheelset is and how it moves, against the ground.

    Members:
      reference: WheelReference: of y, z, velocity and the wrench's moment (default WheelReference.WHEELSET)
      angular_axes: Axes: of angular_velocity (default Axes.TRACK)
      y [m]: displacement of the reference point to the right (-0.2 .. 0.2; default 0)
      z [m]: the same downwards (-0.5 .. 0.2; default 0)
      roll [rad]: must be 0 with rotation (-0.5 .. 0.5; default 0)
      yaw [rad]: must be 0 with rotation (-0.5 .. 0.5; default 0)
      rotation: 9 numbers row by row, track = R * body, orthonormal to 1e-6; the axle within 0.5 rad of the
          track's y axis in both directions; None: from roll and yaw (default None)
      velocity [m/s]: of the reference point, track axes (-200 .. 200, -50 .. 50, -50 .. 50; default 0)
      angular_velocity [rad/s]: y is about the axle (-200 .. 200, -2000 .. 2000, -200 .. 200; default 0)
    """

    _c_name_ = 'wrc_wheel_state'
    __slots__ = ()
    reference: WheelReference = s.Chosen('reference', WheelReference)  # type: ignore[assignment]
    angular_axes: Axes = s.Chosen('angular_axes', Axes)  # type: ignore[assignment]
    y: float
    z: float
    roll: float
    yaw: float
    rotation: Optional[np.ndarray] = s.Pointer('rotation', fixed=9)  # type: ignore[assignment]
    velocity: np.ndarray = s.Array('velocity', 48, (3,), c.c_double)  # type: ignore[assignment]
    angular_velocity: np.ndarray = s.Array('angular_velocity', 72, (3,), c.c_double)  # type: ignore[assignment]
    _units_ = {'y': 'm', 'z': 'm', 'roll': 'rad', 'yaw': 'rad', 'velocity': 'm/s', 'angular_velocity': 'rad/s'}
    _hidden_ = ()
    _fields_ = [
        ('_reference', c.c_int32),
        ('_angular_axes', c.c_int32),
        ('y', c.c_double),
        ('z', c.c_double),
        ('roll', c.c_double),
        ('yaw', c.c_double),
        ('_rotation', c.POINTER(c.c_double)),
        ('_velocity', c.c_double * 3),
        ('_angular_velocity', c.c_double * 3),
    ]
assert c.sizeof(WheelState) == 96


class RailState(s.Struct):
    """Displacement and motion of a rail, track axes. The velocities are those of its material. Where a wheel
        runs along a rail that is bent but at rest they are 0: what the rail's slope adds is there when the
        wheel's velocity, angular velocity and orientation are given in axes turned into the rail's direction
        (docs/hosts.md), and the wrench is in these axes then.

    Members:
      y [m]: displacement of the origin of its profile to the right (-0.2 .. 0.2; default 0)
      z [m]: the same downwards (-0.2 .. 0.2; default 0)
      roll [rad]: rotation about that origin and the x axis (-0.5 .. 0.5; default 0)
      y_velocity [m/s]: along y (-50 .. 50; default 0)
      z_velocity [m/s]: along z (-50 .. 50; default 0)
      roll_velocity [rad/s]: about x (-200 .. 200; default 0)
    """

    _c_name_ = 'wrc_rail_state'
    __slots__ = ()
    y: float
    z: float
    roll: float
    y_velocity: float
    z_velocity: float
    roll_velocity: float
    _units_ = {'y': 'm', 'z': 'm', 'roll': 'rad', 'y_velocity': 'm/s', 'z_velocity': 'm/s', 'roll_velocity': 'rad/s'}
    _hidden_ = ()
    _fields_ = [
        ('y', c.c_double),
        ('z', c.c_double),
        ('roll', c.c_double),
        ('y_velocity', c.c_double),
        ('z_velocity', c.c_double),
        ('roll_velocity', c.c_double),
    ]
assert c.sizeof(RailState) == 48


class FrameMotion(s.Struct):
    """How a frame moves that follows a curved track, for hosts whose velocities are those within it. Its origin
        is on the track centre line, level with the rails' tops, its axes are track axes there. It turns at
        speed * (twist, vertical_curvature, curvature) about them, and what it does is added to the wheel's
        velocity and angular velocity, at the wheel's reference point (where its height is not given, at its
        nominal height). All zero: velocities are against the ground. Velocities of the rail are those of its
        material against the ground either way.

    Members:
      speed [m/s]: of its origin along the track (-200 .. 200; default 0)
      curvature [1/m]: of the track in plan, to the right (-0.1 .. 0.1; default 0)
      vertical_curvature [1/m]: of the track's height, upwards as in a dip (-0.1 .. 0.1; default 0)
      twist [1/m]: roll of the track per distance, right side down: rate of the cant over the speed (-0.5 ..
          0.5; default 0)
    """

    _c_name_ = 'wrc_frame_motion'
    __slots__ = ()
    speed: float
    curvature: float
    vertical_curvature: float
    twist: float
    _units_ = {'speed': 'm/s', 'curvature': '1/m', 'vertical_curvature': '1/m', 'twist': '1/m'}
    _hidden_ = ()
    _fields_ = [
        ('speed', c.c_double),
        ('curvature', c.c_double),
        ('vertical_curvature', c.c_double),
        ('twist', c.c_double),
    ]
assert c.sizeof(FrameMotion) == 32


class WheelInput(s.Struct):
    """What Contact.wrench() reads. What pointers within point to is the caller's and only read during the call.

    Members:
      prescribed: WheelPrescribed (default WheelPrescribed.HEIGHT)
      start: WheelStart (default WheelStart.ANEW)
      wheel: where the wheel is and how it moves
      rail: where the rail is and how it moves
      friction: of each strip at its own sliding speed; coefficient 0 without zones: none, and no creep
          forces; zones count from the origin of the rail's profile (ZoneFrame.RAIL_PROFILE) and lie on the
          rail, or from that of the wheel's (ZoneFrame.WHEEL_PROFILE) and lie on the wheel
      vertical_load [N]: the whole vertical force on the wheel, creep forces included, upwards positive (1e2
          .. 1e6; default 0)
      damping [s/m]: of Hunt and Crossley as in Load, strip by strip, with the velocity at which the strip's
          own overlap grows (0 .. 10; default 0)
      distance [m]: of the reference point along the track, for a rail with config.rail_sections; or from
          above the axle of a roller (config.roller_curvature), within 0.2 m of it; 0 else (-1e7 .. 1e7;
          default 0)
      angle [rad]: of the wheel about its axle, for one with config.roundness; 0 else: right-hand rule about
          y, so that its rate is the angular velocity about the axle and it falls rolling forwards (-1e9 ..
          1e9; default 0)
      roller_velocity [rad/s]: angular velocity of a roller (config.roller_curvature) about its axle,
          right-hand rule about y; 0 else: it is positive where a wheel at rest rolls forwards on it (-2000 ..
          2000; default 0)
      frame: of the axes that velocities are given in
    """

    _c_name_ = 'wrc_wheel_input'
    __slots__ = ()
    struct_size: int
    prescribed: WheelPrescribed = s.Chosen('prescribed', WheelPrescribed)  # type: ignore[assignment]
    start: WheelStart = s.Chosen('start', WheelStart)  # type: ignore[assignment]
    reserved: int
    wheel: WheelState
    rail: RailState
    friction: Friction
    vertical_load: float
    damping: float
    distance: float
    angle: float
    roller_velocity: float
    frame: FrameMotion
    _units_ = {'vertical_load': 'N', 'damping': 's/m', 'distance': 'm', 'angle': 'rad', 'roller_velocity': 'rad/s'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_prescribed', c.c_int32),
        ('_start', c.c_int32),
        ('reserved', c.c_uint32),
        ('wheel', WheelState),
        ('rail', RailState),
        ('friction', Friction),
        ('vertical_load', c.c_double),
        ('damping', c.c_double),
        ('distance', c.c_double),
        ('angle', c.c_double),
        ('roller_velocity', c.c_double),
        ('frame', FrameMotion),
    ]
assert c.sizeof(WheelInput) == 360


class Wrench(s.Struct):
    """What passes between a wheel and its rail. All zero, but for z, where they do not touch. Numbers are
        continuous functions of the inputs but where they say otherwise.

    Members:
      regions: separate regions in contact: Contact.region()
      iterations: of the normal problem, all of the call
      leaps: 1: a normal method for planes has been applied to a patch with several lowest points, about as
          deep as each other: forces leap where the lowest changes; 0: no such patch
      force [N]: on the wheel, track axes
      moment [N m]: on the wheel about its reference point, track axes
      rail_force [N]: on the rail, track axes: -force
      rail_moment [N m]: on the rail about the displaced origin of its profile, track axes
      z [m]: displacement of the reference point, as given or as found
      normal_force [N]: sum over the regions of the resultants of their pressures; steps where regions join or
          part, as their resultants have different directions
      area [m^2]:
      peak_pressure [Pa]:
      power [W]: frictional power, >= 0
      steepest_angle [rad]: largest angle between z and the surface normal of a rail's strip in contact, >= 0;
          steps where a strip enters or leaves
    """

    _c_name_ = 'wrc_wrench'
    __slots__ = ()
    struct_size: int
    regions: int
    iterations: int
    leaps: int
    force: np.ndarray = s.Array('force', 16, (3,), c.c_double)  # type: ignore[assignment]
    moment: np.ndarray = s.Array('moment', 40, (3,), c.c_double)  # type: ignore[assignment]
    rail_force: np.ndarray = s.Array('rail_force', 64, (3,), c.c_double)  # type: ignore[assignment]
    rail_moment: np.ndarray = s.Array('rail_moment', 88, (3,), c.c_double)  # type: ignore[assignment]
    z: float
    normal_force: float
    area: float
    peak_pressure: float
    power: float
    steepest_angle: float
    _units_ = {'force': 'N', 'moment': 'N m', 'rail_force': 'N', 'rail_moment': 'N m', 'z': 'm', 'normal_force': 'N', 'area': 'm^2', 'peak_pressure': 'Pa', 'power': 'W', 'steepest_angle': 'rad'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('regions', c.c_int32),
        ('iterations', c.c_int32),
        ('leaps', c.c_uint32),
        ('_force', c.c_double * 3),
        ('_moment', c.c_double * 3),
        ('_rail_force', c.c_double * 3),
        ('_rail_moment', c.c_double * 3),
        ('z', c.c_double),
        ('normal_force', c.c_double),
        ('area', c.c_double),
        ('peak_pressure', c.c_double),
        ('power', c.c_double),
        ('steepest_angle', c.c_double),
    ]
assert c.sizeof(Wrench) == 160


class Region(s.Struct):
    """One region of the last Contact.wrench(): a run of neighbouring strips in contact. For people and for what
        comes after; the wrench does not depend on where regions are divided.

    Members:
      point [m]: centre of pressure, track axes; x from the wheel's reference point
      y_wheel [m]: that point in the coordinates of the wheel's profile, flange side negative
      z_wheel [m]: the same, down from the tape circle
      y_rail [m]: that point in the coordinates of the rail's profile, field side positive
      z_rail [m]: the same, down from the profile's origin
      angle [rad]: of the resultant of the pressure: about x from the track's z to the normal into the rail; <
          0 on the gauge side of the right rail, > 0 on that of the left
      normal_force [N]: resultant of the pressure
      force [N]: on the wheel, track axes
      moment [N m]: on the wheel about point, track axes
      area [m^2]:
      peak_pressure [Pa]:
      power [W]: frictional power
      creepage: means over the load: longitudinal, lateral [-], spin [1/m], of the wheel over the rail
      strips: strips it is made of: columns of wrc_contact_region_field()
      cells: cells along each of them: its rows
      face: of which surface of the rail: as RailSection.face; with config.check_rail 0 on that and 1 on the
          rail; 0 else
    """

    _c_name_ = 'wrc_region'
    __slots__ = ()
    struct_size: int
    reserved: int
    point: np.ndarray = s.Array('point', 8, (3,), c.c_double)  # type: ignore[assignment]
    y_wheel: float
    z_wheel: float
    y_rail: float
    z_rail: float
    angle: float
    normal_force: float
    force: np.ndarray = s.Array('force', 80, (3,), c.c_double)  # type: ignore[assignment]
    moment: np.ndarray = s.Array('moment', 104, (3,), c.c_double)  # type: ignore[assignment]
    area: float
    peak_pressure: float
    power: float
    creepage: np.ndarray = s.Array('creepage', 152, (3,), c.c_double)  # type: ignore[assignment]
    strips: int
    cells: int
    face: int
    reserved2: int
    _units_ = {'point': 'm', 'y_wheel': 'm', 'z_wheel': 'm', 'y_rail': 'm', 'z_rail': 'm', 'angle': 'rad', 'normal_force': 'N', 'force': 'N', 'moment': 'N m', 'area': 'm^2', 'peak_pressure': 'Pa', 'power': 'W'}
    _hidden_ = ('struct_size', 'reserved', 'reserved2')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
        ('_point', c.c_double * 3),
        ('y_wheel', c.c_double),
        ('z_wheel', c.c_double),
        ('y_rail', c.c_double),
        ('z_rail', c.c_double),
        ('angle', c.c_double),
        ('normal_force', c.c_double),
        ('_force', c.c_double * 3),
        ('_moment', c.c_double * 3),
        ('area', c.c_double),
        ('peak_pressure', c.c_double),
        ('power', c.c_double),
        ('_creepage', c.c_double * 3),
        ('strips', c.c_int32),
        ('cells', c.c_int32),
        ('face', c.c_int32),
        ('reserved2', c.c_uint32),
    ]
assert c.sizeof(Region) == 192


class WrenchSensitivities(s.Struct):
    """Derivatives of the wrench on the wheel about its reference point, at the pose and motion given. What is
        prescribed is held: with WheelPrescribed.VERTICAL_LOAD the height follows all other inputs, and the
        column of z is zero; otherwise that of the load.

    Members:
      wrench: rows force x, y, z [N], moment x, y, z [N m], track axes; columns WrenchInput
      z: of Wrench.z; columns the same
    """

    _c_name_ = 'wrc_wrench_derivatives'
    __slots__ = ()
    wrench: np.ndarray = s.Array('wrench', 0, (6, 19), c.c_double)  # type: ignore[assignment]
    z: np.ndarray = s.Array('z', 912, (19,), c.c_double)  # type: ignore[assignment]
    _units_ = {}
    _hidden_ = ()
    _fields_ = [
        ('_wrench', (c.c_double * 19) * 6),
        ('_z', c.c_double * 19),
    ]
assert c.sizeof(WrenchSensitivities) == 1064


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
    _hidden_ = ()
    _fields_ = [
        ('stress', c.c_double),
        ('x', c.c_double),
        ('y', c.c_double),
        ('depth', c.c_double),
    ]
assert c.sizeof(StressPeak) == 32


class StressPeaks(s.Struct):
    """Largest stresses in a body, each at its own place.

    Members:
      von_mises: sqrt(3 J2)
      shear: (s1 - s3) / 2: half of Tresca's stress
      tension: s1, the most tensile principal stress; below 0 where all is pressed together
    """

    _c_name_ = 'wrc_stress_peaks'
    __slots__ = ()
    von_mises: StressPeak
    shear: StressPeak
    tension: StressPeak
    _units_ = {}
    _hidden_ = ()
    _fields_ = [
        ('von_mises', StressPeak),
        ('shear', StressPeak),
        ('tension', StressPeak),
    ]
assert c.sizeof(StressPeaks) == 96


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
    struct_size: int
    body: Body = s.Chosen('body', Body)  # type: ignore[assignment]
    largest: StressPeaks
    surface: StressPeaks
    below: StressPeaks
    _units_ = {}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_body', c.c_int32),
        ('largest', StressPeaks),
        ('surface', StressPeaks),
        ('below', StressPeaks),
    ]
assert c.sizeof(Stresses) == 296


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
    struct_size: int
    reserved: int
    at_entry: float
    rise: float
    x: float
    y: float
    largest: float
    mean_rise: float
    wheel_heat: float
    rail_heat: float
    _units_ = {'at_entry': 'degC', 'rise': 'K', 'x': 'm', 'y': 'm', 'largest': 'degC', 'mean_rise': 'K', 'wheel_heat': 'W', 'rail_heat': 'W'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
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
      sum: by DamageQuantity: low and high half of a whole number of 128 bits, two's complement;
          wrc_damage_values() makes numbers of it
      largest_pressure [Pa]:
      largest_traction [Pa]:
      overflow: bit i: a contribution to sum i, or the sum, passed its range; what it holds is worthless
    """

    _c_name_ = 'wrc_damage_bin'
    __slots__ = ()
    sum: np.ndarray = s.Array('sum', 0, (8, 2), c.c_uint64)  # type: ignore[assignment]
    largest_pressure: float
    largest_traction: float
    overflow: int
    _units_ = {'largest_pressure': 'Pa', 'largest_traction': 'Pa'}
    _hidden_ = ()
    _fields_ = [
        ('_sum', (c.c_uint64 * 2) * 8),
        ('largest_pressure', c.c_double),
        ('largest_traction', c.c_double),
        ('overflow', c.c_uint64),
    ]
assert c.sizeof(DamageBin) == 152


class DamageBins(s.Struct):
    """Bins over the arc length of a profile, 0 at its origin, flange or gauge side negative; of a rail also in
        rows along the track.

    Members:
      count: bins of a row (1 .. 1000000; default 0)
      first [m]: arc length at which the first begins (-1 .. 1; default 0)
      width [m]: of a bin (1e-5 .. 1; default 1e-3)
      rows: along the track; rows * count 100000000 at most (1 .. 1000000; default 1)
      row_first [m]: distance at which the first row begins (-1e9 .. 1e9; default 0)
      row_length [m]: of a row; 0: one row takes all, whatever the distance (0 or 1e-3 .. 1e9; default 0)
      bin: rows * count + 1 of the caller, row by row; the last has what lies beside all others. Zeroed before
          the first use, copied and saved as bytes
    """

    _c_name_ = 'wrc_damage_bins'
    __slots__ = ()
    struct_size: int
    count: int
    first: float
    width: float
    rows: int
    reserved: int
    row_first: float
    row_length: float
    bin: Optional[DamageBin] = s.Reference('bin')  # type: ignore[assignment]
    _units_ = {'first': 'm', 'width': 'm', 'row_first': 'm', 'row_length': 'm'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('count', c.c_uint32),
        ('first', c.c_double),
        ('width', c.c_double),
        ('rows', c.c_uint32),
        ('reserved', c.c_uint32),
        ('row_first', c.c_double),
        ('row_length', c.c_double),
        ('_bin', c.POINTER(DamageBin)),
    ]
assert c.sizeof(DamageBins) == 56


class FatigueLaws(s.Struct):
    """Damage of rolling contact fatigue by T-gamma: the Whole Life Rail Model. Zero up to start, rising straight
        to peak at peak_at, falling straight through zero at end and on below it, where wear wins. For R220
        and R260 steel; Burstow, RSSB T115 (2004); remembered, unconfirmed. The direction of the creep force,
        by which the model tells cracks that open, is left to the caller.

    Members:
      whole_life_start [N]: T-gamma from which cracks start (0 .. 1e6; default 15)
      whole_life_peak_at [N]: T-gamma of the largest damage, above whole_life_start (1e-3 .. 1e6; default 65)
      whole_life_end [N]: T-gamma at which wear takes as much as cracks grow, above whole_life_peak_at (1e-3
          .. 1e6; default 175)
      whole_life_peak: damage of a passage at whole_life_peak_at; 1 is a crack (0 .. 1; default 1e-5)
    """

    _c_name_ = 'wrc_fatigue_laws'
    __slots__ = ()
    struct_size: int
    reserved: int
    whole_life_start: float
    whole_life_peak_at: float
    whole_life_end: float
    whole_life_peak: float
    _units_ = {'whole_life_start': 'N', 'whole_life_peak_at': 'N', 'whole_life_end': 'N'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
        ('whole_life_start', c.c_double),
        ('whole_life_peak_at', c.c_double),
        ('whole_life_end', c.c_double),
        ('whole_life_peak', c.c_double),
    ]
assert c.sizeof(FatigueLaws) == 40


class Accumulation(s.Struct):
    """What wrc_contact_accumulate() adds.

    Members:
      source: DamageSource (default DamageSource.WRENCH)
      duration [s]: for which the results hold (0 .. 1e6; default 0)
      distance [m]: along the track where that begins; read where a row of bins has a length (-1e9 .. 1e9;
          default 0)
      wear: None: the published ones (default None)
      fatigue: None: the published ones (default None)
    """

    _c_name_ = 'wrc_accumulation'
    __slots__ = ()
    struct_size: int
    source: DamageSource = s.Chosen('source', DamageSource)  # type: ignore[assignment]
    duration: float
    distance: float
    wear: Optional[WearLaws] = s.Reference('wear')  # type: ignore[assignment]
    fatigue: Optional[FatigueLaws] = s.Reference('fatigue')  # type: ignore[assignment]
    _units_ = {'duration': 's', 'distance': 'm'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_source', c.c_int32),
        ('duration', c.c_double),
        ('distance', c.c_double),
        ('_wear', c.POINTER(WearLaws)),
        ('_fatigue', c.POINTER(FatigueLaws)),
    ]
assert c.sizeof(Accumulation) == 40


class DamageTotals(s.Struct):
    """What one wrc_contact_accumulate() added to each of its sets of bins.

    Members:
      sum: by DamageQuantity, units there
      largest_pressure [Pa]:
      largest_traction [Pa]:
    """

    _c_name_ = 'wrc_damage_totals'
    __slots__ = ()
    sum: np.ndarray = s.Array('sum', 0, (8,), c.c_double)  # type: ignore[assignment]
    largest_pressure: float
    largest_traction: float
    _units_ = {'largest_pressure': 'Pa', 'largest_traction': 'Pa'}
    _hidden_ = ()
    _fields_ = [
        ('_sum', c.c_double * 8),
        ('largest_pressure', c.c_double),
        ('largest_traction', c.c_double),
    ]
assert c.sizeof(DamageTotals) == 80


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
    _hidden_ = ()
    _fields_ = [
        ('nx', c.c_uint32),
        ('ny', c.c_uint32),
        ('dx', c.c_double),
        ('dy', c.c_double),
        ('x0', c.c_double),
        ('y0', c.c_double),
    ]
assert c.sizeof(Grid) == 40


class Materials(s.Struct):
    """The two bodies.

    Members:
      shear_modulus_1 [Pa]: G of the wheel (1e8 .. 1e12; default 80e9)
      poisson_1: nu of the wheel (0 .. 0.5; default 0.25)
      shear_modulus_2 [Pa]: G of the rail (1e8 .. 1e12; default 80e9)
      poisson_2: nu of the rail (0 .. 0.5; default 0.25)
    """

    _c_name_ = 'wrc_materials'
    __slots__ = ()
    shear_modulus_1: float
    poisson_1: float
    shear_modulus_2: float
    poisson_2: float
    _units_ = {'shear_modulus_1': 'Pa', 'shear_modulus_2': 'Pa'}
    _hidden_ = ()
    _fields_ = [
        ('shear_modulus_1', c.c_double),
        ('poisson_1', c.c_double),
        ('shear_modulus_2', c.c_double),
        ('poisson_2', c.c_double),
    ]
assert c.sizeof(Materials) == 32


class ExactNormalProblem(s.Struct):
    """The normal problem: an undeformed gap and what presses the bodies together.

    Members:
      prescribed: Prescribed (default Prescribed.LOAD)
      max_iterations: (1 .. 100000; default 1000)
      normal_force [N]: must be set (1e-3 .. 1e7; default 0)
      approach [m]: beyond the zero of the gap (-1 .. 0.01; default 0)
      tolerance: of overlap and separation, relative to the largest displacement (1e-14 .. 0.1; default 1e-6)
      materials: of the two bodies
      grid: cells of gap and pressure
      gap [m]: nx * ny (-1 .. 1; required)
      progress: None: none (default None)
      user: handed to progress (default None)
    """

    _c_name_ = 'wrc_exact_normal_problem'
    __slots__ = ()
    struct_size: int
    prescribed: Prescribed = s.Chosen('prescribed', Prescribed)  # type: ignore[assignment]
    max_iterations: int
    reserved: int
    normal_force: float
    approach: float
    tolerance: float
    materials: Materials
    grid: Grid
    gap: Optional[np.ndarray] = s.Pointer('gap')  # type: ignore[assignment]
    progress: Any
    user: Any
    _units_ = {'normal_force': 'N', 'approach': 'm', 'gap': 'm'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_prescribed', c.c_int32),
        ('max_iterations', c.c_int32),
        ('reserved', c.c_int32),
        ('normal_force', c.c_double),
        ('approach', c.c_double),
        ('tolerance', c.c_double),
        ('materials', Materials),
        ('grid', Grid),
        ('_gap', c.POINTER(c.c_double)),
        ('progress', s.Progress),
        ('user', c.c_void_p),
    ]
assert c.sizeof(ExactNormalProblem) == 136


class ExactNormalSolution(s.Struct):
    """Solution of the normal problem.

    Members:
      iterations: of the conjugate gradients
      approach [m]: beyond the zero of the gap
      normal_force [N]:
      peak_pressure [Pa]:
      area [m^2]: of the cells under pressure
      residual: of the convergence test
      pressure [Pa]: the caller's nx * ny; None: not wanted; set before the call
    """

    _c_name_ = 'wrc_exact_normal_solution'
    __slots__ = ()
    struct_size: int
    iterations: int
    approach: float
    normal_force: float
    peak_pressure: float
    area: float
    residual: float
    pressure: Optional[np.ndarray] = s.Pointer('pressure')  # type: ignore[assignment]
    _units_ = {'approach': 'm', 'normal_force': 'N', 'peak_pressure': 'Pa', 'area': 'm^2', 'pressure': 'Pa'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('iterations', c.c_int32),
        ('approach', c.c_double),
        ('normal_force', c.c_double),
        ('peak_pressure', c.c_double),
        ('area', c.c_double),
        ('residual', c.c_double),
        ('_pressure', c.POINTER(c.c_double)),
    ]
assert c.sizeof(ExactNormalSolution) == 56


class ExactRollingProblem(s.Struct):
    """Steady rolling under a given normal pressure.

    Members:
      adhesion: Adhesion (default Adhesion.COULOMB)
      collocation: Collocation (default Collocation.QUARTER_POINT)
      max_iterations: of Newton's method (1 .. 1000; default 60)
      tolerance: of the traction law (1e-12 .. 0.1; default 1e-4)
      materials: of the two bodies
      grid: cells of pressure, friction and tractions
      pressure [Pa]: nx * ny; cells above zero are the contact, all others are not (-1e11 .. 1e11; required)
      friction: nx * ny; None: coefficient everywhere (1e-4 .. 2; default None)
      coefficient: Coulomb (1e-4 .. 2; default 0.3)
      creepage: about the origin of the contact frame
      progress: called between grids and iterations; None: none (default None)
      user: handed to progress (default None)
    """

    _c_name_ = 'wrc_exact_rolling_problem'
    __slots__ = ()
    struct_size: int
    adhesion: Adhesion = s.Chosen('adhesion', Adhesion)  # type: ignore[assignment]
    collocation: Collocation = s.Chosen('collocation', Collocation)  # type: ignore[assignment]
    max_iterations: int
    tolerance: float
    materials: Materials
    grid: Grid
    pressure: Optional[np.ndarray] = s.Pointer('pressure')  # type: ignore[assignment]
    friction: Optional[np.ndarray] = s.Pointer('friction')  # type: ignore[assignment]
    coefficient: float
    creepage: Creepage
    progress: Any
    user: Any
    _units_ = {'pressure': 'Pa'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_adhesion', c.c_int32),
        ('_collocation', c.c_int32),
        ('max_iterations', c.c_int32),
        ('tolerance', c.c_double),
        ('materials', Materials),
        ('grid', Grid),
        ('_pressure', c.POINTER(c.c_double)),
        ('_friction', c.POINTER(c.c_double)),
        ('coefficient', c.c_double),
        ('creepage', Creepage),
        ('progress', s.Progress),
        ('user', c.c_void_p),
    ]
assert c.sizeof(ExactRollingProblem) == 184


class ExactRollingSolution(s.Struct):
    """Solution of steady rolling: forces and tractions on the wheel.

    Members:
      iterations: of Newton's method on the given grid
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
    struct_size: int
    iterations: int
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
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('iterations', c.c_int32),
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
assert c.sizeof(ExactRollingSolution) == 96


class ExactLoads(s.Struct):
    """What presses and rubs on one of the bodies, constant on each cell of a grid.

    Members:
      body: Body: in which the stresses are wanted (default Body.RAIL)
      poisson: nu of that body (0 .. 0.5; default 0.25)
      grid: cells of pressure and tractions
      pressure [Pa]: nx * ny (-1e11 .. 1e11; required)
      traction_x [Pa]: nx * ny, on the wheel as solutions have it, whichever the body; None: none (-1e11 ..
          1e11; default None)
      traction_y [Pa]: nx * ny, the same along y; None: none (-1e11 .. 1e11; default None)
    """

    _c_name_ = 'wrc_exact_loads'
    __slots__ = ()
    struct_size: int
    body: Body = s.Chosen('body', Body)  # type: ignore[assignment]
    poisson: float
    grid: Grid
    pressure: Optional[np.ndarray] = s.Pointer('pressure')  # type: ignore[assignment]
    traction_x: Optional[np.ndarray] = s.Pointer('traction_x')  # type: ignore[assignment]
    traction_y: Optional[np.ndarray] = s.Pointer('traction_y')  # type: ignore[assignment]
    _units_ = {'pressure': 'Pa', 'traction_x': 'Pa', 'traction_y': 'Pa'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_body', c.c_int32),
        ('poisson', c.c_double),
        ('grid', Grid),
        ('_pressure', c.POINTER(c.c_double)),
        ('_traction_x', c.POINTER(c.c_double)),
        ('_traction_y', c.POINTER(c.c_double)),
    ]
assert c.sizeof(ExactLoads) == 80


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
    struct_size: int
    collocation: Collocation = s.Chosen('collocation', Collocation)  # type: ignore[assignment]
    influence: SurfaceInfluence = s.Chosen('influence', SurfaceInfluence)  # type: ignore[assignment]
    reserved: int
    cell_x: float
    cell_s: float
    progress: Any
    user: Any
    _units_ = {'cell_x': 'm', 'cell_s': 'm'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_collocation', c.c_int32),
        ('_influence', c.c_int32),
        ('reserved', c.c_uint32),
        ('cell_x', c.c_double),
        ('cell_s', c.c_double),
        ('progress', s.Progress),
        ('user', c.c_void_p),
    ]
assert c.sizeof(ExactWrenchOptions) == 48


class ExactCheckResult(s.Struct):
    """A real-time result against the exact one.

    Members:
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
    struct_size: int
    reserved: int
    fx: float
    fy: float
    mz: float
    power: float
    adhesion_fraction: float
    force_error: float
    power_error: float
    _units_ = {'fx': 'N', 'fy': 'N', 'mz': 'N m', 'power': 'W'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
        ('fx', c.c_double),
        ('fy', c.c_double),
        ('mz', c.c_double),
        ('power', c.c_double),
        ('adhesion_fraction', c.c_double),
        ('force_error', c.c_double),
        ('power_error', c.c_double),
    ]
assert c.sizeof(ExactCheckResult) == 64


class ContactFunctionsProblem(s.Struct):
    """Where contact functions are asked for.

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
    struct_size: int
    count: int = s.Count('count')  # type: ignore[assignment]
    lateral: Optional[np.ndarray] = s.Pointer('lateral', count='count', group=('lateral',))  # type: ignore[assignment]
    wheel_load: float
    _units_ = {'lateral': 'm', 'wheel_load': 'N'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_count', c.c_uint32),
        ('_lateral', c.POINTER(c.c_double)),
        ('wheel_load', c.c_double),
    ]
assert c.sizeof(ContactFunctionsProblem) == 24


class ContactFunctions(s.Struct):
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
    struct_size: int
    reserved: int
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
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
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
assert c.sizeof(ContactFunctions) == 96


class ConicityProblem(s.Struct):
    """A rolling radius difference over the lateral displacement, straight between its points, and what to make
        of it.

    Members:
      method: ConicityMethod (default ConicityMethod.WAVELENGTH)
      count: points (3 .. 100000; default 0)
      amplitudes: (1 .. 100000; default 0)
      lateral [m]: of the wheelset, increasing, count of them (-0.1 .. 0.1; required)
      radius_difference [m]: right less left, count of them (-0.2 .. 0.2; required)
      amplitude [m]: half the way from one side to the other, amplitudes of them (1e-6 .. 0.1; required)
      contact_distance [m]: e: between the contact points of both wheels (0.3 .. 3; default 1.5)
      radius [m]: r0: nominal, of the wheels (0.05 .. 3; default 0.46)
    """

    _c_name_ = 'wrc_conicity_problem'
    __slots__ = ()
    struct_size: int
    method: ConicityMethod = s.Chosen('method', ConicityMethod)  # type: ignore[assignment]
    count: int = s.Count('count')  # type: ignore[assignment]
    amplitudes: int = s.Count('amplitudes')  # type: ignore[assignment]
    lateral: Optional[np.ndarray] = s.Pointer('lateral', count='count', group=('lateral', 'radius_difference'))  # type: ignore[assignment]
    radius_difference: Optional[np.ndarray] = s.Pointer('radius_difference', count='count', group=('lateral', 'radius_difference'))  # type: ignore[assignment]
    amplitude: Optional[np.ndarray] = s.Pointer('amplitude', count='amplitudes', group=('amplitude',))  # type: ignore[assignment]
    contact_distance: float
    radius: float
    _units_ = {'lateral': 'm', 'radius_difference': 'm', 'amplitude': 'm', 'contact_distance': 'm', 'radius': 'm'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_method', c.c_int32),
        ('_count', c.c_uint32),
        ('_amplitudes', c.c_uint32),
        ('_lateral', c.POINTER(c.c_double)),
        ('_radius_difference', c.POINTER(c.c_double)),
        ('_amplitude', c.POINTER(c.c_double)),
        ('contact_distance', c.c_double),
        ('radius', c.c_double),
    ]
assert c.sizeof(ConicityProblem) == 56


class Conicity(s.Struct):
    """Equivalent conicity over the amplitude: arrays of the caller, amplitudes elements each; None: not wanted;
        set before the call.

    Members:
      conicity: tan gamma_e; 0 where a wheelset left to itself does not swing with this amplitude
      wavelength [m]: of the kinematic motion: by Klingel's formula from the conicity of a regression; 0 where
          there is none
      centre [m]: middle between the two ends of the motion
    """

    _c_name_ = 'wrc_conicity'
    __slots__ = ()
    struct_size: int
    reserved: int
    conicity: Optional[np.ndarray] = s.Pointer('conicity')  # type: ignore[assignment]
    wavelength: Optional[np.ndarray] = s.Pointer('wavelength')  # type: ignore[assignment]
    centre: Optional[np.ndarray] = s.Pointer('centre')  # type: ignore[assignment]
    _units_ = {'wavelength': 'm', 'centre': 'm'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('reserved', c.c_uint32),
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
      bins: of the depth (1 .. 1000000; default 0)
      y [m]: points as in Profile, count of them (-1 .. 1; required)
      z [m]: see y (-1 .. 1; required)
      depth [m]: along the normal, of each bin for one passage, bins of them (0 .. 0.1; required)
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
    struct_size: int
    body: Body = s.Chosen('body', Body)  # type: ignore[assignment]
    count: int = s.Count('count')  # type: ignore[assignment]
    bins: int = s.Count('bins')  # type: ignore[assignment]
    y: Optional[np.ndarray] = s.Pointer('y', count='count', group=('y', 'z'))  # type: ignore[assignment]
    z: Optional[np.ndarray] = s.Pointer('z', count='count', group=('y', 'z'))  # type: ignore[assignment]
    depth: Optional[np.ndarray] = s.Pointer('depth', count='bins', group=('depth',))  # type: ignore[assignment]
    first: float
    width: float
    passages: float
    largest_depth: float
    smoothing: float
    spacing: float
    _units_ = {'y': 'm', 'z': 'm', 'depth': 'm', 'first': 'm', 'width': 'm', 'largest_depth': 'm', 'smoothing': 'm', 'spacing': 'm'}
    _hidden_ = ('struct_size',)
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('_body', c.c_int32),
        ('_count', c.c_uint32),
        ('_bins', c.c_uint32),
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
    struct_size: int
    capacity: int
    count: int
    reserved: int
    y: Optional[np.ndarray] = s.Pointer('y')  # type: ignore[assignment]
    z: Optional[np.ndarray] = s.Pointer('z')  # type: ignore[assignment]
    passages: float
    depth: float
    area: float
    _units_ = {'y': 'm', 'z': 'm', 'depth': 'm', 'area': 'm^2'}
    _hidden_ = ('struct_size', 'reserved')
    _fields_ = [
        ('struct_size', c.c_uint32),
        ('capacity', c.c_uint32),
        ('count', c.c_uint32),
        ('reserved', c.c_uint32),
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
    _hidden_ = ()
    _fields_ = [
        ('height', c.c_double),
        ('thickness', c.c_double),
        ('slope', c.c_double),
    ]
assert c.sizeof(Flange) == 24


# The C functions, as ctypes calls them: without the GIL.
FUNCTIONS: dict = {}
_wrc_version = _l.function(FUNCTIONS, 'wrc_version', c.c_uint32, [])
_wrc_abi_version = _l.function(FUNCTIONS, 'wrc_abi_version', c.c_uint32, [])
_wrc_version_text = _l.function(FUNCTIONS, 'wrc_version_text', c.c_char_p, [c.c_uint32])
_wrc_build_info = _l.function(FUNCTIONS, 'wrc_build_info', c.c_char_p, [])
_wrc_status_name = _l.function(FUNCTIONS, 'wrc_status_name', c.c_char_p, [c.c_int32])
_wrc_status_text = _l.function(FUNCTIONS, 'wrc_status_text', c.c_char_p, [c.c_int32])
_wrc_profile_init = _l.function(FUNCTIONS, 'wrc_profile_init', c.c_int32, [c.POINTER(Profile)])
_wrc_config_init = _l.function(FUNCTIONS, 'wrc_config_init', c.c_int32, [c.POINTER(Config)])
_wrc_heat_properties_init = _l.function(FUNCTIONS, 'wrc_heat_properties_init', c.c_int32, [c.POINTER(HeatProperties)])
_wrc_pose_init = _l.function(FUNCTIONS, 'wrc_planar_pose_init', c.c_int32, [c.POINTER(Pose)])
_wrc_gap_init = _l.function(FUNCTIONS, 'wrc_planar_gap_init', c.c_int32, [c.POINTER(Gap)])
_wrc_load_init = _l.function(FUNCTIONS, 'wrc_planar_load_init', c.c_int32, [c.POINTER(Load)])
_wrc_creepage_init = _l.function(FUNCTIONS, 'wrc_creepage_init', c.c_int32, [c.POINTER(Creepage)])
_wrc_bulk_temperatures_init = _l.function(FUNCTIONS, 'wrc_bulk_temperatures_init', c.c_int32, [c.POINTER(BulkTemperatures)])
_wrc_friction_init = _l.function(FUNCTIONS, 'wrc_friction_init', c.c_int32, [c.POINTER(Friction)])
_wrc_ellipse_init = _l.function(FUNCTIONS, 'wrc_ellipse_init', c.c_int32, [c.POINTER(Ellipse)])
_wrc_strips_init = _l.function(FUNCTIONS, 'wrc_planar_strips_init', c.c_int32, [c.POINTER(Strips)])
_wrc_motion_init = _l.function(FUNCTIONS, 'wrc_planar_motion_init', c.c_int32, [c.POINTER(Motion)])
_wrc_wear_laws_init = _l.function(FUNCTIONS, 'wrc_wear_laws_init', c.c_int32, [c.POINTER(WearLaws)])
_wrc_allocator_init = _l.function(FUNCTIONS, 'wrc_allocator_init', c.c_int32, [c.POINTER(Allocator)])
_wrc_input_init = _l.function(FUNCTIONS, 'wrc_planar_input_init', c.c_int32, [c.POINTER(Input)])
_wrc_output_init = _l.function(FUNCTIONS, 'wrc_planar_output_init', c.c_int32, [c.POINTER(Output)])
_wrc_patch_init = _l.function(FUNCTIONS, 'wrc_patch_init', c.c_int32, [c.POINTER(Patch)])
_wrc_config_use = _l.function(FUNCTIONS, 'wrc_config_use', c.c_int32, [c.POINTER(Config), c.c_char_p, c.c_char_p, c.c_uint64])
_wrc_config_check = _l.function(FUNCTIONS, 'wrc_config_check', c.c_int32, [c.POINTER(Config), c.c_char_p, c.c_uint64])
_wrc_model_size = _l.function(FUNCTIONS, 'wrc_model_size', c.c_int32, [c.POINTER(Config), s.Numbers(c.c_uint64), s.Numbers(c.c_uint64)])
_wrc_model_init = _l.function(FUNCTIONS, 'wrc_model_init', c.c_int32, [c.POINTER(Config), c.c_void_p, c.c_uint64, c.c_void_p])
_wrc_model_create = _l.function(FUNCTIONS, 'wrc_model_create', c.c_int32, [c.POINTER(Config), c.POINTER(Allocator), c.c_void_p])
_wrc_model_profile = _l.function(FUNCTIONS, 'wrc_model_profile', c.c_int32, [c.c_void_p, c.c_int32, c.c_int32, c.POINTER(View), c.POINTER(View), s.Numbers(c.c_double)])
_wrc_model_destroy = _l.function(FUNCTIONS, 'wrc_model_destroy', None, [c.c_void_p])
_wrc_contact_size = _l.function(FUNCTIONS, 'wrc_contact_size', c.c_int32, [c.c_void_p, s.Numbers(c.c_uint64), s.Numbers(c.c_uint64)])
_wrc_contact_init = _l.function(FUNCTIONS, 'wrc_contact_init', c.c_int32, [c.c_void_p, c.c_int32, c.c_void_p, c.c_uint64, c.c_void_p])
_wrc_contact_create = _l.function(FUNCTIONS, 'wrc_contact_create', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(Allocator), c.c_void_p])
_wrc_contact_destroy = _l.function(FUNCTIONS, 'wrc_contact_destroy', None, [c.c_void_p])
_wrc_contact_state_size = _l.function(FUNCTIONS, 'wrc_contact_state_size', c.c_int32, [c.c_void_p, s.Numbers(c.c_uint64)])
_wrc_contact_save = _l.function(FUNCTIONS, 'wrc_contact_save', c.c_int32, [c.c_void_p, c.c_void_p, c.c_uint64])
_wrc_contact_restore = _l.function(FUNCTIONS, 'wrc_contact_restore', c.c_int32, [c.c_void_p, c.c_void_p, c.c_uint64])
_wrc_contact_portable_size = _l.function(FUNCTIONS, 'wrc_contact_portable_size', c.c_int32, [c.c_void_p, s.Numbers(c.c_uint64)])
_wrc_contact_save_portable = _l.function(FUNCTIONS, 'wrc_contact_save_portable', c.c_int32, [c.c_void_p, c.c_void_p, c.c_uint64])
_wrc_contact_restore_portable = _l.function(FUNCTIONS, 'wrc_contact_restore_portable', c.c_int32, [c.c_void_p, c.c_void_p, c.c_uint64])
_wrc_contact_last_error = _l.function(FUNCTIONS, 'wrc_contact_last_error', c.c_int32, [c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_contact_geometry = _l.function(FUNCTIONS, 'wrc_planar_geometry', c.c_int32, [c.c_void_p, c.POINTER(Pose), c.POINTER(ContactPoint)])
_wrc_contact_creepages = _l.function(FUNCTIONS, 'wrc_planar_creepages', c.c_int32, [c.c_void_p, c.POINTER(Motion), c.POINTER(Creepage)])
_wrc_contact_normal = _l.function(FUNCTIONS, 'wrc_planar_normal', c.c_int32, [c.c_void_p, c.POINTER(Gap), c.POINTER(Load), c.POINTER(NormalSolution)])
_wrc_contact_regularise = _l.function(FUNCTIONS, 'wrc_planar_regularise', c.c_int32, [c.c_void_p, c.POINTER(Strips), c.POINTER(NormalSolution)])
_wrc_contact_roll = _l.function(FUNCTIONS, 'wrc_planar_roll', c.c_int32, [c.c_void_p, c.c_double])
_wrc_contact_tangential = _l.function(FUNCTIONS, 'wrc_planar_tangential', c.c_int32, [c.c_void_p, c.POINTER(Ellipse), c.POINTER(Creepage), c.POINTER(Friction), c.POINTER(Forces)])
_wrc_contact_damage = _l.function(FUNCTIONS, 'wrc_contact_damage', c.c_int32, [c.c_void_p, c.POINTER(Damage)])
_wrc_contact_wear = _l.function(FUNCTIONS, 'wrc_contact_wear', c.c_int32, [c.c_void_p, c.POINTER(WearLaws), c.POINTER(Wear)])
_wrc_contact_sensitivities = _l.function(FUNCTIONS, 'wrc_planar_tangential_derivatives', c.c_int32, [c.c_void_p, c.POINTER(Sensitivity)])
_wrc_contact_step_sensitivities = _l.function(FUNCTIONS, 'wrc_contact_step_sensitivities', c.c_int32, [c.c_void_p, c.POINTER(StepSensitivity)])
_wrc_contact_step = _l.function(FUNCTIONS, 'wrc_planar_step', c.c_int32, [c.c_void_p, c.POINTER(Input), c.POINTER(Output)])
_wrc_contact_step_batch = _l.function(FUNCTIONS, 'wrc_contact_step_batch', c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(Input), c.c_uint64, c.POINTER(Output), c.c_uint64, s.Numbers(c.c_int32)])
_wrc_contact_step_flat = _l.function(FUNCTIONS, 'wrc_contact_step_flat', c.c_int32, [c.c_void_p, s.Numbers(c.c_double), s.Numbers(c.c_double)])
_wrc_contact_patch = _l.function(FUNCTIONS, 'wrc_contact_patch', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(Patch)])
_wrc_contact_field = _l.function(FUNCTIONS, 'wrc_contact_field', c.c_int32, [c.c_void_p, c.c_int32, c.c_int32, c.POINTER(View)])
_wrc_linear_coefficients = _l.function(FUNCTIONS, 'wrc_linear_coefficients', c.c_int32, [c.c_double, c.c_double, c.c_double, c.POINTER(Coefficients)])
_wrc_shakedown_limit = _l.function(FUNCTIONS, 'wrc_shakedown_limit', c.c_int32, [c.c_double, s.Numbers(c.c_double)])
_wrc_shakedown_limit_point = _l.function(FUNCTIONS, 'wrc_shakedown_limit_point', c.c_int32, [c.c_double, s.Numbers(c.c_double)])
_wrc_wheel_state_init = _l.function(FUNCTIONS, 'wrc_wheel_state_init', c.c_int32, [c.POINTER(WheelState)])
_wrc_rail_state_init = _l.function(FUNCTIONS, 'wrc_rail_state_init', c.c_int32, [c.POINTER(RailState)])
_wrc_frame_motion_init = _l.function(FUNCTIONS, 'wrc_frame_motion_init', c.c_int32, [c.POINTER(FrameMotion)])
_wrc_wheel_input_init = _l.function(FUNCTIONS, 'wrc_wheel_input_init', c.c_int32, [c.POINTER(WheelInput)])
_wrc_wrench_init = _l.function(FUNCTIONS, 'wrc_wrench_init', c.c_int32, [c.POINTER(Wrench)])
_wrc_region_init = _l.function(FUNCTIONS, 'wrc_region_init', c.c_int32, [c.POINTER(Region)])
_wrc_contact_wrench = _l.function(FUNCTIONS, 'wrc_contact_wrench', c.c_int32, [c.c_void_p, c.POINTER(WheelInput), c.POINTER(Wrench)])
_wrc_contact_wrench_sensitivities = _l.function(FUNCTIONS, 'wrc_contact_wrench_derivatives', c.c_int32, [c.c_void_p, c.POINTER(WheelInput), c.POINTER(Wrench), c.POINTER(WrenchSensitivities)])
_wrc_contact_region = _l.function(FUNCTIONS, 'wrc_contact_region', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(Region)])
_wrc_contact_region_ellipse = _l.function(FUNCTIONS, 'wrc_contact_region_ellipse', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(Ellipse)])
_wrc_contact_region_damage = _l.function(FUNCTIONS, 'wrc_contact_region_damage', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(Damage)])
_wrc_contact_region_field = _l.function(FUNCTIONS, 'wrc_contact_region_field', c.c_int32, [c.c_void_p, c.c_int32, c.c_int32, s.Numbers(c.c_double), c.c_uint64])
_wrc_contact_wrench_batch = _l.function(FUNCTIONS, 'wrc_contact_wrench_batch', c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(WheelInput), c.c_uint64, c.POINTER(Wrench), c.c_uint64, s.Numbers(c.c_int32)])
_wrc_contact_wrench_flat = _l.function(FUNCTIONS, 'wrc_contact_wrench_flat', c.c_int32, [c.c_void_p, s.Numbers(c.c_double), s.Numbers(c.c_double)])
_wrc_stresses_init = _l.function(FUNCTIONS, 'wrc_stresses_init', c.c_int32, [c.POINTER(Stresses)])
_wrc_temperature_init = _l.function(FUNCTIONS, 'wrc_temperature_init', c.c_int32, [c.POINTER(Temperature)])
_wrc_damage_bins_init = _l.function(FUNCTIONS, 'wrc_damage_bins_init', c.c_int32, [c.POINTER(DamageBins)])
_wrc_fatigue_laws_init = _l.function(FUNCTIONS, 'wrc_fatigue_laws_init', c.c_int32, [c.POINTER(FatigueLaws)])
_wrc_accumulation_init = _l.function(FUNCTIONS, 'wrc_accumulation_init', c.c_int32, [c.POINTER(Accumulation)])
_wrc_contact_temperature = _l.function(FUNCTIONS, 'wrc_contact_temperature', c.c_int32, [c.c_void_p, c.POINTER(BulkTemperatures), c.POINTER(Temperature)])
_wrc_contact_region_temperature = _l.function(FUNCTIONS, 'wrc_contact_region_temperature', c.c_int32, [c.c_void_p, c.c_int32, c.POINTER(BulkTemperatures), c.POINTER(Temperature)])
_wrc_contact_stresses = _l.function(FUNCTIONS, 'wrc_contact_stresses', c.c_int32, [c.c_void_p, c.c_int32, s.Numbers(c.c_double), c.c_uint32, c.POINTER(StressPeaks), c.POINTER(Stresses)])
_wrc_flash_temperature = _l.function(FUNCTIONS, 'wrc_flash_temperature', c.c_int32, [c.c_uint32, c.c_double, s.Numbers(c.c_double), c.c_double, c.POINTER(HeatProperties), c.POINTER(HeatProperties), s.Numbers(c.c_double)])
_wrc_contact_accumulate = _l.function(FUNCTIONS, 'wrc_contact_accumulate', c.c_int32, [c.c_void_p, c.POINTER(Accumulation), c.POINTER(DamageBins), c.POINTER(DamageBins), c.POINTER(DamageTotals)])
_wrc_damage_merge = _l.function(FUNCTIONS, 'wrc_damage_merge', c.c_int32, [c.POINTER(DamageBins), c.POINTER(DamageBins)])
_wrc_damage_values = _l.function(FUNCTIONS, 'wrc_damage_values', c.c_int32, [c.POINTER(DamageBins), c.c_int32, s.Numbers(c.c_double)])
_wrc_whole_life_damage = _l.function(FUNCTIONS, 'wrc_whole_life_damage', c.c_int32, [c.POINTER(FatigueLaws), c.c_double, s.Numbers(c.c_double)])
_wrc_model_arc_places = _l.function(FUNCTIONS, 'wrc_model_arc_places', c.c_int32, [c.c_void_p, c.c_int32, c.c_uint32, s.Numbers(c.c_double), s.Numbers(c.c_double), s.Numbers(c.c_double)])
_wrc_get_api = _l.function(FUNCTIONS, 'wrc_get_api', c.c_void_p, [c.c_uint32])
_wrc_grid_init = _l.function(FUNCTIONS, 'wrc_grid_init', c.c_int32, [c.POINTER(Grid)])
_wrc_materials_init = _l.function(FUNCTIONS, 'wrc_materials_init', c.c_int32, [c.POINTER(Materials)])
_wrc_exact_normal_problem_init = _l.function(FUNCTIONS, 'wrc_exact_normal_problem_init', c.c_int32, [c.POINTER(ExactNormalProblem)])
_wrc_exact_normal_solution_init = _l.function(FUNCTIONS, 'wrc_exact_normal_solution_init', c.c_int32, [c.POINTER(ExactNormalSolution)])
_wrc_exact_rolling_problem_init = _l.function(FUNCTIONS, 'wrc_exact_rolling_problem_init', c.c_int32, [c.POINTER(ExactRollingProblem)])
_wrc_exact_rolling_solution_init = _l.function(FUNCTIONS, 'wrc_exact_rolling_solution_init', c.c_int32, [c.POINTER(ExactRollingSolution)])
_wrc_exact_loads_init = _l.function(FUNCTIONS, 'wrc_exact_loads_init', c.c_int32, [c.POINTER(ExactLoads)])
_wrc_exact_wrench_options_init = _l.function(FUNCTIONS, 'wrc_exact_wrench_options_init', c.c_int32, [c.POINTER(ExactWrenchOptions)])
_wrc_exact_check_result_init = _l.function(FUNCTIONS, 'wrc_exact_check_result_init', c.c_int32, [c.POINTER(ExactCheckResult)])
_wrc_exact_gap = _l.function(FUNCTIONS, 'wrc_exact_gap', c.c_int32, [c.c_void_p, c.POINTER(Grid), s.Numbers(c.c_double)])
_wrc_exact_normal = _l.function(FUNCTIONS, 'wrc_exact_normal', c.c_int32, [c.POINTER(ExactNormalProblem), c.POINTER(ExactNormalSolution), c.c_char_p, c.c_uint64])
_wrc_exact_rolling = _l.function(FUNCTIONS, 'wrc_exact_rolling', c.c_int32, [c.POINTER(ExactRollingProblem), c.POINTER(ExactRollingSolution), c.c_char_p, c.c_uint64])
_wrc_exact_stress = _l.function(FUNCTIONS, 'wrc_exact_stress', c.c_int32, [c.POINTER(ExactLoads), s.Numbers(c.c_double), c.c_uint32, s.Numbers(c.c_double), c.c_char_p, c.c_uint64])
_wrc_exact_largest_stresses = _l.function(FUNCTIONS, 'wrc_exact_largest_stresses', c.c_int32, [c.POINTER(ExactLoads), s.Numbers(c.c_double), c.c_uint32, c.POINTER(StressPeaks), c.POINTER(Stresses), s.Progress, c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_exact_transient_create = _l.function(FUNCTIONS, 'wrc_exact_transient_create', c.c_int32, [c.POINTER(Grid), c.POINTER(Materials), c.c_void_p, c.c_char_p, c.c_uint64])
_wrc_exact_transient_step = _l.function(FUNCTIONS, 'wrc_exact_transient_step', c.c_int32, [c.c_void_p, c.POINTER(ExactRollingProblem), c.POINTER(ExactRollingSolution), c.c_char_p, c.c_uint64])
_wrc_exact_transient_destroy = _l.function(FUNCTIONS, 'wrc_exact_transient_destroy', None, [c.c_void_p])
_wrc_exact_check = _l.function(FUNCTIONS, 'wrc_exact_check', c.c_int32, [c.c_void_p, c.c_uint32, c.c_uint32, s.Progress, c.c_void_p, c.POINTER(ExactCheckResult)])
_wrc_exact_wrench = _l.function(FUNCTIONS, 'wrc_exact_wrench', c.c_int32, [c.c_void_p, c.POINTER(WheelInput), c.POINTER(ExactWrenchOptions), c.POINTER(Wrench)])
_wrc_contact_functions_problem_init = _l.function(FUNCTIONS, 'wrc_wheelset_geometry_problem_init', c.c_int32, [c.POINTER(ContactFunctionsProblem)])
_wrc_contact_functions_init = _l.function(FUNCTIONS, 'wrc_wheelset_geometry_init', c.c_int32, [c.POINTER(ContactFunctions)])
_wrc_conicity_problem_init = _l.function(FUNCTIONS, 'wrc_conicity_problem_init', c.c_int32, [c.POINTER(ConicityProblem)])
_wrc_conicity_init = _l.function(FUNCTIONS, 'wrc_conicity_init', c.c_int32, [c.POINTER(Conicity)])
_wrc_profile_wear_init = _l.function(FUNCTIONS, 'wrc_profile_wear_init', c.c_int32, [c.POINTER(ProfileWear)])
_wrc_worn_profile_init = _l.function(FUNCTIONS, 'wrc_worn_profile_init', c.c_int32, [c.POINTER(WornProfile)])
_wrc_profile_contact_functions = _l.function(FUNCTIONS, 'wrc_profile_wheelset_geometry', c.c_int32, [c.c_void_p, c.POINTER(ContactFunctionsProblem), c.POINTER(ContactFunctions), c.c_char_p, c.c_uint64])
_wrc_equivalent_conicity = _l.function(FUNCTIONS, 'wrc_equivalent_conicity', c.c_int32, [c.POINTER(ConicityProblem), c.POINTER(Conicity), c.c_char_p, c.c_uint64])
_wrc_profile_take_off = _l.function(FUNCTIONS, 'wrc_profile_remove_wear', c.c_int32, [c.POINTER(ProfileWear), c.POINTER(WornProfile), c.c_char_p, c.c_uint64])
_wrc_flange_dimensions = _l.function(FUNCTIONS, 'wrc_flange_dimensions', c.c_int32, [c.c_uint32, s.Numbers(c.c_double), s.Numbers(c.c_double), c.c_double, c.POINTER(Flange), c.c_char_p, c.c_uint64])


class ModelCalls(_l.Handle):
    """What Model has of the C interface as it is."""

    __slots__ = ()


class ContactCalls(_l.Handle):
    """What Contact has of the C interface as it is."""

    __slots__ = ()

    def geometry(self, pose: Pose, *, out: Optional[ContactPoint] = None) -> ContactPoint:
        """Finds the initial contact point of a pose and samples the gap around it into the contact: one contact
            point, the lowest; the rows reach up to 30 mm to either side. Theory manual, section 7.

        pose: of the wheelset, track frame
        out: where the bodies touch first; None: a new one

        C status: Status.OK; Status.FLAG_ITERATION_CAP; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (model
            without profiles), _NOT_FINITE, _RANGE, _GAP (no rail below the wheel at this pose).
        """
        if out is None:
            out = ContactPoint._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_geometry(self._handle, pose, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, pose=(pose, Pose), out=(out, ContactPoint)) from None
        return out

    def creepages(self, motion: Motion, *, out: Optional[Creepage] = None) -> Creepage:
        """Creepages at the origin of the contact frame of the last Contact.geometry, from the rigid motion of
            the wheelset: the velocity of the wheel's material point there over the amount of the rolling
            speed V, the mean of the speeds at which wheel and rail material pass through the contact (a
            locked wheel: half its speed and creepage 2; one that spins at standstill: -2). What it gives
            Contact.tangential takes, as it stands: - Below |V| = 0.1 m/s, where creepages would grow without
            end, velocities are divided by 0.1 m/s (3 + 6 u^2 - u^4) / 8, u = |V| / 0.1 m/s, instead: 0.0375
            m/s at V = 0. speed has the amount of that divisor, so that it scales power right, and the sign of
            V; reverse_share goes from 0 to 0.5 at V = 0. Forces are so twice differentiable in the motion through
            V = 0, as far as the tangential method is, and a wheel that slides at rest is braked by friction x
            load. - Where a creepage would pass its range (sliding far faster than rolling), all are divided
            by more; speed grows by it. - |speed| ends at 200 m/s. Theory manual, section 7.

        motion: of the wheelset, track frame
        out: the creepages with speed, approach_velocity and reverse_share, ready to be passed on; None: a new one

        C status: Status.OK; Status.FLAG_CREEPAGES_LIMITED (any of these three); Status.ERROR_NULL,
            _STRUCT_SIZE, _SEQUENCE (no Contact.geometry before), _NOT_FINITE, _RANGE.
        """
        if out is None:
            out = Creepage._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_creepages(self._handle, motion, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, motion=(motion, Motion), out=(out, Creepage)) from None
        return out

    def normal(self, load: Load, gap: Optional[Gap] = None, *, out: Optional[NormalSolution] = None) -> NormalSolution:
        """Solves the normal problem and regularises the patch (Contact.regularise). Strips stay in the contact.
            Pressures are those of two bodies of equal material; theory manual, sections 2 and 3.

        gap: contact frame; copied; None: the gap already in the contact, of Contact.geometry or of an earlier
            call
        load: along the contact normal
        out: the solution; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT (approach <= 0, or damping takes all of the force),
            _ITERATION_CAP, _PATCH_AT_EDGE, _MORE_PATCHES, _TABLE_RANGE (|psi| cut to 0.95), _LOAD_LEAPS
            (HERTZ to STRIPES: between two loads the method has no solution; the approach is that of the
            larger, and prescribed gives that one), _BEYOND_GAP (load or approach is more than the gap
            carries, at most config.grid.gap_limit of a pose's: load and pressures go on in a straight line
            with the last stiffness, the patch stays); Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (gap is None
            and the contact has none), _GAP, _LOAD, _NOT_FINITE, _RANGE, _UNSUPPORTED.
        """
        if out is None:
            out = NormalSolution._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_normal(self._handle, gap, load, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, gap=(gap, Gap), load=(load, Load), out=(out, NormalSolution)) from None
        return out

    def regularise(self, strips: Optional[Strips] = None, *, out: Optional[NormalSolution] = None) -> NormalSolution:
        """Takes a pressure distribution of the caller as the contact's patch and finds its equivalent double
            ellipse. Theory manual, section 3; paper section 2.

        strips: contact frame, whose origin must be the initial contact point; copied; None: the strips in the
            contact
        out: what the strips add up to, with their double ellipse; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT (no pressure), _TABLE_RANGE (|psi| cut to 0.95);
            Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (strips is None and the contact has none), _RANGE,
            _NOT_FINITE.
        """
        if out is None:
            out = NormalSolution._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_regularise(self._handle, strips, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, strips=(strips, Strips), out=(out, NormalSolution)) from None
        return out

    def tangential(self, creepage: Creepage, friction: Friction, ellipse: Optional[Ellipse] = None, *, out: Optional[Forces] = None) -> Forces:
        """Solves the tangential problem of rolling, steady but for config.non_steady. Theory manual, sections 4
            and 5; paper eq. 5 to 9.

        ellipse: exact double ellipse with its joint at the origin of the contact frame, which replaces the
            contact's patches; None: the patches in the contact
        creepage: at the origin of the contact frame
        friction: between the bodies
        out: on the wheel, contact frame; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT, _TABLE_RANGE, _ITERATION_CAP (COARSE_HALFSPACE, at high
            adhesion often: forces are usable), _CREEPAGES_LIMITED (creepage.reverse_share is not 0);
            Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no patch, or friction zones over a profile without a
            Contact.geometry), _RANGE, _NOT_FINITE, _UNSUPPORTED.
        """
        if out is None:
            out = Forces._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_tangential(self._handle, ellipse, creepage, friction, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, ellipse=(ellipse, Ellipse), creepage=(creepage, Creepage), friction=(friction, Friction), out=(out, Forces)) from None
        return out

    def damage(self, *, out: Optional[Damage] = None) -> Damage:
        """Wear and fatigue numbers of the last Contact.tangential, and the fields POWER_DENSITY, FATIGUE_INDEX,
            STRIP_POWER. Theory manual, section 6; paper eq. 10 to 12.

        out: the numbers; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE.
        """
        if out is None:
            out = Damage._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_damage(self._handle, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, Damage)) from None
        return out

    def wear(self, laws: Optional[WearLaws] = None, *, out: Optional[Wear] = None) -> Wear:
        """Wear of the last Contact.tangential by three laws, and the field STRIP_WEAR. May be called again with
            other laws. Theory manual, section 6.

        laws: parameters; None: the published ones
        out: the numbers; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no
            Contact.tangential before), _NOT_FINITE, _RANGE, _UNSUPPORTED (a method that gives forces alone:
            no tractions to wear by).
        """
        if out is None:
            out = Wear._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_wear(self._handle, laws, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, laws=(laws, WearLaws), out=(out, Wear)) from None
        return out

    def sensitivities(self, *, out: Optional[Sensitivity] = None) -> Sensitivity:
        """Derivatives of the forces of the last Contact.tangential or Contact.step by creepages, load and
            friction, for implicit integrators and linearisation: those of the discrete model itself, carried
            along with the forces (forward mode), two to three times the cost of the forces. The creep force
            has kinks where a cell changes between stick and slip; there it is the derivative from one side.
            Where strips stick a second time, which takes large spin, it jumps there by up to 0.5 % of
            friction x load of one strip. So it is for FASTSIM with separate flexibilities and strip FASTSIM,
            where neither friction nor the slope (modified FASTSIM) falls; all else has central differences
            instead, with steps of a thousandth, for eight times the cost of the forces. Nothing in the
            contact changes, fields included.

        out: the derivatives; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT, _TABLE_RANGE, _ITERATION_CAP, _CREEPAGES_LIMITED (as
            Contact.tangential()); Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no Contact.tangential).
        """
        if out is None:
            out = Sensitivity._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_sensitivities(self._handle, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, Sensitivity)) from None
        return out

    def step_sensitivities(self, *, out: Optional[StepSensitivity] = None) -> StepSensitivity:
        """Derivatives of the whole last step, patch included, with respect to the load (or approach) and, after
            a pose, to the lateral shift of the wheelset: central differences of four steps, with a hundredth
            of the load or approach and with 0.1 mm: wide enough for the strips' being cut anew in every patch
            not to show. Creepages and friction are held. Nothing in the contact changes, fields included.

        out: the derivatives; None: a new one

        C status: Status.OK; the flags of Contact.step(); Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no
            Contact.tangential, or on strips or a patch of the caller), and those of Contact.step() where a
            neighbouring step fails.
        """
        if out is None:
            out = StepSensitivity._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_step_sensitivities(self._handle, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, StepSensitivity)) from None
        return out

    def step(self, input: Input, *, out: Optional[Output] = None) -> Output:
        """All stages at once: geometry (without input->gap) or the given gap, normal, regularise, tangential,
            damage.

        input: what to solve
        out: the results; None: a new one

        C status: Status.OK or the first flag of the stages; the failure of the first stage that fails, which
            ends the step with all outputs zeroed.
        """
        if out is None:
            out = Output._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_step(self._handle, input, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, input=(input, Input), out=(out, Output)) from None
        return out

    def patch(self, index: int, *, out: Optional[Patch] = None) -> Patch:
        """One of the contact's patches with its forces.

        index: 0 .. NormalSolution.patches - 1, by increasing y
        out: the patch; None: a new one

        C status: Status.OK; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no patch yet), _RANGE (no such
            patch).
        """
        if out is None:
            out = Patch._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_patch(self._handle, index, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, Patch)) from None
        return out

    def wrench(self, input: WheelInput, *, out: Optional[Wrench] = None) -> Wrench:
        """The wrench between a wheel and a rail at this pose and motion, steady rolling. Does not touch the
            results of the stages of wrc.h in the same contact, nor they its. Any methods will do. The
            defaults, NormalMethod.STRIP_HALFSPACE and TangentialMethod.STRIP_FASTSIM, know no patch and are
            what the accuracy and the smoothness of this call are stated for. The other normal methods are
            applied patch by patch to the surface unrolled, patches that grow together being joined smoothly;
            their forces act along the strips' own normals. FASTSIM and FaStrip roll strip by strip, each with
            its own slip and coefficients, with PatchModel.PATCH_SDEC, Flexibility.SEPARATE and a bound other
            than TractionBound.ELLIPSOIDAL, and without friction.slope_fall; in every other form, as the
            coarse half-space and the force table, they roll patch by patch with the means of the strips'
            slips over the load, on the ellipse or double ellipse with the moments of that load
            (config.tangential.regularisation is not used). Theory manual, section 9. Friction over
            temperature (FrictionKind.TEMPERATURE) is found strip by strip as by the stages, in six solutions
            of the tractions at each height; the call takes twice as long.

        input: what to solve
        out: the result; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT (apart: all zero; so is a flange 4 mm and more inside the
            side of a rail, and its back, which the sentence says), _ITERATION_CAP, _CLIMBING (above),
            _BEYOND_GAP (deeper than 2 mm: where the height is given, continued with the stiffness and the
            directions there), _PATCH_AT_EDGE (contact reaches the end of a profile; what lies beyond carries
            nothing), _BEYOND_SECTIONS, _CREEPAGES_LIMITED (with friction, slower than 0.1 m/s: as
            Contact.creepages()), _MORE_PATCHES (more regions than can be told apart: the last takes the rest,
            the wrench is whole; or, says the sentence, more strips overlap than there is room for: those on
            the field side carry nothing); Status.FLAG_TABLE_RANGE (of methods that know patches);
            Status.ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE, _UNSUPPORTED (a model without profiles,
            friction zones in a contact frame, or friction over temperature of a method without tractions),
            _LOAD (the load cannot be carried at this pose).
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

    def wrench_sensitivities(self, input: WheelInput, *, wrench: Optional[Wrench] = None, sensitivities: Optional[WrenchSensitivities] = None) -> Tuple[Wrench, WrenchSensitivities]:
        """Contact.wrench() with the derivatives of its wrench: of the discrete model, strip by strip through the
            equations of its solution, not by differences; but with FrictionKind.TEMPERATURE the tractions'
            part by a difference of their solution for each of ten numbers. For implicit integrators; it takes
            two to three times as long as the wrench alone, over temperature four to five times. Theory
            manual, section 9.

        input: as for Contact.wrench()
        wrench: as for Contact.wrench(), the same bits; None: a new one
        sensitivities: the derivatives; None: a new one

        C status: as Contact.wrench(). Derivatives are zero without contact; with Status.FLAG_BEYOND_GAP they
            are those where the overlap is 2 mm deep; zero and Status.FLAG_MORE_PATCHES with more than 160
            strips in contact.
        """
        if wrench is None:
            wrench = Wrench._new()
        if sensitivities is None:
            sensitivities = WrenchSensitivities._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_wrench_sensitivities(self._handle, input, wrench, sensitivities)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, input=(input, WheelInput), wrench=(wrench, Wrench), sensitivities=(sensitivities, WrenchSensitivities)) from None
        return wrench, sensitivities

    def region(self, index: int, *, out: Optional[Region] = None) -> Region:
        """One region of the last Contact.wrench().

        index: 0 .. Wrench.regions - 1, from the gauge side to the field side
        out: the region; None: a new one

        C status: Status.OK; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no Contact.wrench), _RANGE (no such
            region).
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

    def region_ellipse(self, index: int, *, out: Optional[Ellipse] = None) -> Ellipse:
        """The equivalent double ellipse of a region of the last Contact.wrench(), its strips laid flat along the
            rail's arc: as Contact.regularise() with the strips' extent, the joint where they are longest. The
            results stay as they are. Theory manual, section 3.

        index: as for Contact.region()
        out: with the arc length of its joint as y (RegionField.STRIP_S) and the sum of the strips' loads as
            normal_force; None: a new one

        C status: Status.OK; Status.FLAG_TABLE_RANGE (|psi| cut to 0.95); Status.ERROR_NULL, _SEQUENCE (no
            Contact.wrench), _RANGE (no such region).
        """
        if out is None:
            out = Ellipse._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_region_ellipse(self._handle, index, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, Ellipse)) from None
        return out

    def region_damage(self, index: int, *, out: Optional[Damage] = None) -> Damage:
        """Wear and fatigue numbers of a region of the last Contact.wrench(), as Contact.damage() gives them of a
            patch. Forces are the sums of the strips' own along x and s, the load that of the strips' loads,
            creepages the region's means; near standstill what is made of cells is of the way the wheel rolls.
            The results stay as they are.

        index: as for Contact.region()
        out: the numbers; None: a new one

        C status: Status.OK; Status.ERROR_NULL, _SEQUENCE (no Contact.wrench), _RANGE (no such region).
        """
        if out is None:
            out = Damage._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_region_damage(self._handle, index, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, Damage)) from None
        return out

    def temperature(self, bulk: Optional[BulkTemperatures] = None, *, out: Optional[Temperature] = None) -> Temperature:
        """Temperatures in the contact from the frictional power of the last Contact.tangential or Contact.step,
            and the field TEMPERATURE_RISE: flash temperatures of points that pass through the contact (Ertz
            and Knothe, Wear 253 (2002) 498), T(s) = (beta_w T_w + beta_r T_r) / (beta_w + beta_r) + 1 /
            ((beta_w + beta_r) sqrt(pi V)) Int_0^s q / sqrt(s - s') ds', s from the leading edge along each
            strip, q the power density, beta = sqrt(conductivity density specific_heat) of config.wheel_heat
            and config.rail_heat. Heat flows into the depth alone, which holds from some 0.1 m/s on (Peclet
            number V a density specific_heat / (2 conductivity) > 10); below, temperatures are too high and go
            to zero with the speed. Near standstill (creepage.reverse_share) it is of the way of creepage.speed.
            Cost grows with strips * cells^2. May be called again with other bulk temperatures. Theory manual,
            section 6.

        bulk: temperatures of the bodies; None: the defaults
        out: the numbers; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no
            Contact.tangential before), _NOT_FINITE, _RANGE, _UNSUPPORTED (a method that gives forces alone:
            there is no power over the patch).
        """
        if out is None:
            out = Temperature._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_temperature(self._handle, bulk, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, bulk=(bulk, BulkTemperatures), out=(out, Temperature)) from None
        return out

    def region_temperature(self, index: int, bulk: Optional[BulkTemperatures] = None, *, out: Optional[Temperature] = None) -> Temperature:
        """Contact.temperature() of a region of the last Contact.wrench(), and of its field
            RegionField.TEMPERATURE_RISE, which is there without this call. The results stay as they are.

        index: as for Contact.region()
        bulk: temperatures of the bodies; None: the defaults
        out: the numbers: x as Region.point[0], y the arc length (RegionField.STRIP_S); heat is that of the
            cells' power density; None: a new one

        C status: Status.OK; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no Contact.wrench), _RANGE (no such
            region, or bulk), _NOT_FINITE, _UNSUPPORTED (a method that rolled whole patches).
        """
        if out is None:
            out = Temperature._new()
        try:
            with self._lock:
                status = self._status = _wrc_contact_region_temperature(self._handle, index, bulk, out)
                if status < 0:
                    raise self._error(status)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, bulk=(bulk, BulkTemperatures), out=(out, Temperature)) from None
        return out

    def exact_check(self, nx: int, ny: int, progress: s.ProgressArgument = None, *, out: Optional[ExactCheckResult] = None) -> ExactCheckResult:
        """Solves the tangential problem a contact has just solved (its strips and their pressure, its creepages
            and friction) exactly on nx x ny cells over its patches, friction.slope_reduction included, and
            reports the errors of the real-time method. The contact is not changed.

        nx: cells along x, 8..512
        ny: cells along y, 8..512
        progress: None: none
        out: exact forces and the errors; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT, _ITERATION_CAP; Status.ERROR_NULL, _STRUCT_SIZE, _RANGE,
            _SEQUENCE, _UNSUPPORTED (both ways of rolling blended: creepage.reverse_share is not 0), _MEMORY,
            _CANCELLED.
        """
        if out is None:
            out = ExactCheckResult._new()
        _watch = s.Watch(progress)
        try:
            with self._lock:
                status = self._status = _wrc_exact_check(self._handle, nx, ny, _watch.c, None, out)
                _watch.end()
                if status < 0:
                    raise self._error(status, _watch)
        except c.ArgumentError as _why:
            raise _l.misfit(_why, out=(out, ExactCheckResult)) from None
        return out

    def exact_wrench(self, input: WheelInput, options: Optional[ExactWrenchOptions] = None, progress: s.ProgressArgument = None, *, out: Optional[Wrench] = None) -> Wrench:
        """What Contact.wrench() finds, exactly: normal contact and steady rolling over cells on the rail's
            curved surface, with the gap of every cell along its own normal, the sliding of its own surface
            points, and half-space coefficients over arc length between frames turned against each other, so
            that pressure and tractions act on one another. Friction zones and friction that falls with the
            speed are each row of cells', both ways of rolling and what becomes of them near standstill
            (Status.FLAG_CREEPAGES_LIMITED) as in Contact.wrench(), damping by the speed at which a row's
            surfaces near each other at its middle; friction.slope_reduction divides what tractions move the
            surfaces along each other: theory manual, sections 5, 7 and 9. Takes from a tenth of a second to
            minutes, growing with the second to fourth power of 1 / cell. The contact keeps its last
            Contact.wrench(). On a rail that changes along the track every cell has its gap to the rail as it
            is there, between the strips that Contact.wrench() has cut, and its sliding along it; normals turn
            with the section, and forces lean along the track, row by row as they do where the wheel is
            nearest. Faces - a check rail, a blade - are solved each alone, with its own rolling speed, and
            added up. A wheel that is not round has its radius at every cell, but hollows are bridged as by a
            rail that is level along the track. Each row of cells has one patch along the track.

        input: as for Contact.wrench(); without FrictionKind.TEMPERATURE: there are no temperatures
        options: None: the defaults
        progress: called with the fraction done; give something true to stop; None: none
        out: the result; iterations are heights and turns of normal and tangential problem tried; regions are
            counted, Contact.region() does not have them; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT, _ITERATION_CAP, _PATCH_AT_EDGE (the contact reaches the
            end of a profile), _CREEPAGES_LIMITED, _BEYOND_SECTIONS; Status.ERROR_NULL, _STRUCT_SIZE,
            _NOT_FINITE, _RANGE (also: more than a million cells), _UNSUPPORTED, _LOAD, _MEMORY, _CANCELLED.
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

    C status: Status.OK; Status.FLAG_TABLE_RANGE beyond the tables; Status.ERROR_NULL, _STRUCT_SIZE, _RANGE,
        _NOT_FINITE.
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
    'wrc_config_material': ConfigMaterial,
    'wrc_heat_properties': HeatProperties,
    'wrc_config_wheelset': ConfigWheelset,
    'wrc_config_track': ConfigTrack,
    'wrc_rail_section': RailSection,
    'wrc_config_roundness': ConfigRoundness,
    'wrc_config_grid': ConfigGrid,
    'wrc_config_normal': ConfigNormal,
    'wrc_config_tangential': ConfigTangential,
    'wrc_config_check_rail': ConfigCheckRail,
    'wrc_config': Config,
    'wrc_planar_pose': Pose,
    'wrc_planar_point': ContactPoint,
    'wrc_planar_gap': Gap,
    'wrc_planar_load': Load,
    'wrc_creepage': Creepage,
    'wrc_bulk_temperatures': BulkTemperatures,
    'wrc_friction': Friction,
    'wrc_ellipse': Ellipse,
    'wrc_planar_normal_solution': NormalSolution,
    'wrc_planar_strips': Strips,
    'wrc_planar_forces': Forces,
    'wrc_patch': Patch,
    'wrc_planar_motion': Motion,
    'wrc_damage': Damage,
    'wrc_wear_laws': WearLaws,
    'wrc_wear': Wear,
    'wrc_coefficients': Coefficients,
    'wrc_planar_derivatives': Sensitivity,
    'wrc_step_sensitivity': StepSensitivity,
    'wrc_planar_input': Input,
    'wrc_planar_output': Output,
    'wrc_view': View,
    'wrc_allocator': Allocator,
    'wrc_wheel_state': WheelState,
    'wrc_rail_state': RailState,
    'wrc_frame_motion': FrameMotion,
    'wrc_wheel_input': WheelInput,
    'wrc_wrench': Wrench,
    'wrc_region': Region,
    'wrc_wrench_derivatives': WrenchSensitivities,
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
    'wrc_materials': Materials,
    'wrc_exact_normal_problem': ExactNormalProblem,
    'wrc_exact_normal_solution': ExactNormalSolution,
    'wrc_exact_rolling_problem': ExactRollingProblem,
    'wrc_exact_rolling_solution': ExactRollingSolution,
    'wrc_exact_loads': ExactLoads,
    'wrc_exact_wrench_options': ExactWrenchOptions,
    'wrc_exact_check_result': ExactCheckResult,
    'wrc_wheelset_geometry_problem': ContactFunctionsProblem,
    'wrc_wheelset_geometry': ContactFunctions,
    'wrc_conicity_problem': ConicityProblem,
    'wrc_conicity': Conicity,
    'wrc_profile_wear': ProfileWear,
    'wrc_worn_profile': WornProfile,
    'wrc_flange': Flange,
}
__all__ = [
    'Status',
    'NormalMethod',
    'TangentialMethod',
    'PatchModel',
    'Side',
    'ProfileKind',
    'Body',
    'Regularisation',
    'TractionBound',
    'Flexibility',
    'FrictionKind',
    'ZoneFrame',
    'ProfilePlacement',
    'InstructionSet',
    'Prescribed',
    'Available',
    'FieldId',
    'WheelReference',
    'Axes',
    'WheelPrescribed',
    'WheelStart',
    'RegionField',
    'WrenchInput',
    'DamageQuantity',
    'DamageSource',
    'Adhesion',
    'Collocation',
    'SurfaceInfluence',
    'ConicityMethod',
    'Profile',
    'ConfigMaterial',
    'HeatProperties',
    'ConfigWheelset',
    'ConfigTrack',
    'RailSection',
    'ConfigRoundness',
    'ConfigGrid',
    'ConfigNormal',
    'ConfigTangential',
    'ConfigCheckRail',
    'Config',
    'Pose',
    'ContactPoint',
    'Gap',
    'Load',
    'Creepage',
    'BulkTemperatures',
    'Friction',
    'Ellipse',
    'NormalSolution',
    'Strips',
    'Forces',
    'Patch',
    'Motion',
    'Damage',
    'WearLaws',
    'Wear',
    'Coefficients',
    'Sensitivity',
    'StepSensitivity',
    'Input',
    'Output',
    'View',
    'Allocator',
    'WheelState',
    'RailState',
    'FrameMotion',
    'WheelInput',
    'Wrench',
    'Region',
    'WrenchSensitivities',
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
    'Materials',
    'ExactNormalProblem',
    'ExactNormalSolution',
    'ExactRollingProblem',
    'ExactRollingSolution',
    'ExactLoads',
    'ExactWrenchOptions',
    'ExactCheckResult',
    'ContactFunctionsProblem',
    'ContactFunctions',
    'ConicityProblem',
    'Conicity',
    'ProfileWear',
    'WornProfile',
    'Flange',
    'linear_coefficients',
    'shakedown_limit',
    'shakedown_limit_point',
]
