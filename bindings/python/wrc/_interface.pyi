"""Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit."""
# fmt: off
from typing import Any, Callable, Dict, List, Literal, Optional, Sequence, Tuple, Type, TypedDict, Union
import ctypes as c
import enum

import numpy as np
from numpy.typing import NDArray

from . import _library as _l
from . import _struct as s

VERSION_MAJOR: int
VERSION_MINOR: int
VERSION_PATCH: int
ABI_VERSION: int
EXPERIMENTAL_VERSION: int
WRENCH_INPUTS: int
ALL_REGIONS: int
DAMAGE_SUMS: int
CREEP_PARAMETERS: int
SURFACE_QUANTITIES: int
MOST_FILM_ROWS: int
SURFACE_BOOKS: int
STATUS_TEXTS: Dict[int, str]
STRUCTS: Dict[str, Type[s.Struct]]
FUNCTIONS: Dict[str, Callable[..., Any]]
PRESETS: Tuple[str, ...]
PresetName = Literal['FASTSIM', 'FASTSIM-EQ.E', 'FASTSIM-EQ.L', 'FASTSIM-SDEC', 'strip FASTSIM', 'KBTNH-type table', 'modified FASTSIM', 'FaStrip', 'modified FaStrip', 'FaStrip-SDEC', 'Polach', 'default', 'real time', 'reference']
FRICTIONS: Dict[str, Tuple[str, str]]
FrictionName = Literal['Polach dry', 'Polach wet', 'magnetite', 'clay', 'sand', 'MoS2', 'locomotive']

class Status(s.Choice):
    OK = 0
    """done"""
    FLAG_NO_CONTACT = 1
    """the bodies do not touch: all forces are zero"""
    FLAG_ITERATION_CAP = 2
    """an iteration reached its cap: the last iterate is returned"""
    FLAG_PATCH_AT_EDGE = 3
    """the patch reaches the edge of the given gap, profile or surface"""
    FLAG_MORE_PATCHES = 4
    """more contact patches exist than the configuration has room for"""
    FLAG_TABLE_RANGE = 5
    """the patch is more slender than the coefficient tables: their end is used"""
    FLAG_CREEPAGES_LIMITED = 6
    """nearly at rest, or sliding far faster than rolling: creepages are limited"""
    FLAG_LOAD_JUMPS = 7
    """no approach of this normal method carries the load: its force jumps past it there"""
    FLAG_BEYOND_GAP = 8
    """beyond what the gap or the profiles carry: continued with the last stiffness"""
    FLAG_CLIMBING = 9
    """friction on a steep face lets no height carry the load, or several"""
    FLAG_BEYOND_SECTIONS = 10
    """the rail has no section that far along the track: the nearest is used"""
    FLAG_DISSIMILAR_MATERIALS = 11
    """different materials: of Kalker's K only the leading part is taken, or none: theory manual, section 4
    """
    FLAG_SUM_OVERFLOW = 12
    """a sum of bins passed its range: what they hold is worthless"""
    FLAG_FORCE_JUMPS = 13
    """a planar normal method on a patch of several lowest points: forces jump where the lowest changes"""
    FLAG_ROTATION_TRANSPOSED = 14
    """the angular velocity lies along the axle of the transposed rotation: was its transpose given?"""
    FLAG_MEMORY_DROPPED = 15
    """the wheel was put elsewhere since the committed step: it begins without tractions"""
    ERROR_NULL = -1
    """a required pointer is NULL"""
    ERROR_STRUCT_SIZE = -2
    """struct_size is wrong, or a member newer than the library is set"""
    ERROR_NOT_FINITE = -3
    """a value is NaN or infinite"""
    ERROR_RANGE = -4
    """a value lies outside its allowed range"""
    ERROR_PROFILE = -5
    """a profile cannot be used"""
    ERROR_GAP = -6
    """the undeformed gap cannot be used"""
    ERROR_LOAD = -7
    """gap or profiles cannot carry the prescribed load or approach"""
    ERROR_BUFFER = -8
    """the memory handed over is too small or misaligned"""
    ERROR_MEMORY = -9
    """memory could not be allocated"""
    ERROR_SEQUENCE = -10
    """a call came before the one whose result it needs"""
    ERROR_UNSUPPORTED = -11
    """the requested method, version or combination does not exist"""
    ERROR_FILE = -12
    """a file cannot be read or written"""
    ERROR_CANCELLED = -13
    """the caller cancelled the work"""
    ERROR_INTERNAL = -14
    """internal error: please report it"""
StatusLike = Union[Status, Literal['OK', 'FLAG_NO_CONTACT', 'FLAG_ITERATION_CAP', 'FLAG_PATCH_AT_EDGE', 'FLAG_MORE_PATCHES', 'FLAG_TABLE_RANGE', 'FLAG_CREEPAGES_LIMITED', 'FLAG_LOAD_JUMPS', 'FLAG_BEYOND_GAP', 'FLAG_CLIMBING', 'FLAG_BEYOND_SECTIONS', 'FLAG_DISSIMILAR_MATERIALS', 'FLAG_SUM_OVERFLOW', 'FLAG_FORCE_JUMPS', 'FLAG_ROTATION_TRANSPOSED', 'FLAG_MEMORY_DROPPED', 'ERROR_NULL', 'ERROR_STRUCT_SIZE', 'ERROR_NOT_FINITE', 'ERROR_RANGE', 'ERROR_PROFILE', 'ERROR_GAP', 'ERROR_LOAD', 'ERROR_BUFFER', 'ERROR_MEMORY', 'ERROR_SEQUENCE', 'ERROR_UNSUPPORTED', 'ERROR_FILE', 'ERROR_CANCELLED', 'ERROR_INTERNAL']]

class Flags(enum.IntFlag):
    NO_CONTACT = 2
    """the bodies do not touch: all forces are zero"""
    ITERATION_CAP = 4
    """an iteration reached its cap: the last iterate is returned"""
    PATCH_AT_EDGE = 8
    """the patch reaches the edge of the given gap, profile or surface"""
    MORE_PATCHES = 16
    """more contact patches exist than the configuration has room for"""
    TABLE_RANGE = 32
    """the patch is more slender than the coefficient tables: their end is used"""
    CREEPAGES_LIMITED = 64
    """nearly at rest, or sliding far faster than rolling: creepages are limited"""
    LOAD_JUMPS = 128
    """no approach of this normal method carries the load: its force jumps past it there"""
    BEYOND_GAP = 256
    """beyond what the gap or the profiles carry: continued with the last stiffness"""
    CLIMBING = 512
    """friction on a steep face lets no height carry the load, or several"""
    BEYOND_SECTIONS = 1024
    """the rail has no section that far along the track: the nearest is used"""
    DISSIMILAR_MATERIALS = 2048
    """different materials: of Kalker's K only the leading part is taken, or none: theory manual, section 4
    """
    SUM_OVERFLOW = 4096
    """a sum of bins passed its range: what they hold is worthless"""
    FORCE_JUMPS = 8192
    """a planar normal method on a patch of several lowest points: forces jump where the lowest changes"""
    ROTATION_TRANSPOSED = 16384
    """the angular velocity lies along the axle of the transposed rotation: was its transpose given?"""
    MEMORY_DROPPED = 32768
    """the wheel was put elsewhere since the committed step: it begins without tractions"""
FlagsLike = Union[Flags, int]

class NormalMethod(s.Choice):
    HERTZ = 0
    """one ellipse; lateral curvature from the chord of the gap at half the approach"""
    KIK_PIOTROWSKI = 1
    """Kik and Piotrowski, VSD 46 (2008)"""
    EKP = 2
    """extended Kik-Piotrowski, after VSD 54 (2016): yaw, lateral curvature"""
    EKP_ELLIPSE = 3
    """threshold varying over y, every region of overlap: CONTACT's KPEC, to 0.02 %"""
    ANALYN = 4
    """ANALYN in the modified form, after VSD 52 (2014); unconfirmed"""
    STRIPES = 5
    """STRIPES, semi-Hertzian, after VSD 43 (2005); unconfirmed"""
    STRIP_HALFSPACE = 6
    """strips of own peak and length in half-space equilibrium; several patches"""
NormalMethodLike = Union[NormalMethod, Literal['HERTZ', 'KIK_PIOTROWSKI', 'EKP', 'EKP_ELLIPSE', 'ANALYN', 'STRIPES', 'STRIP_HALFSPACE']]

class TangentialMethod(s.Choice):
    FASTSIM = 0
    """FASTSIM, Kalker 1982, marched in second order, with patch_model, bound and flexibility of
        config.tangential; modified FASTSIM where friction.slope_fall > 0
    """
    FASTRIP = 1
    """FaStrip, VSD 54 (2016), with config.tangential.patch_model: strip theory where it sticks, FASTSIM's
        directions where it slips
    """
    STRIP_FASTSIM = 2
    """FASTSIM in the shape of strip theory on the patch as it is, calibrated on exact solutions"""
    FORCE_TABLE = 3
    """total forces from config.tangential.force_table, exact solutions for double ellipses: no tractions, no
        slip, and no results that need them
    """
    POLACH = 4
    """Polach's force law on the equivalent ellipse, with friction.adhesion_reduction and slip_reduction: total
        forces, no tractions and no slip
    """
TangentialMethodLike = Union[TangentialMethod, Literal['FASTSIM', 'FASTRIP', 'STRIP_FASTSIM', 'FORCE_TABLE', 'POLACH']]

class PatchModel(s.Choice):
    PATCH_SDEC = 0
    """the patch; coefficients of its equivalent double ellipse"""
    PATCH_ELLIPSE = 1
    """the patch; coefficients of the equivalent ellipse"""
    ELLIPSE_AT_MIDDLE = 2
    """the equivalent ellipse about mid-width, creepage corrected for the shift"""
    ELLIPSE_AT_POINT = 3
    """the equivalent ellipse about the contact point: no psi"""
PatchModelLike = Union[PatchModel, Literal['PATCH_SDEC', 'PATCH_ELLIPSE', 'ELLIPSE_AT_MIDDLE', 'ELLIPSE_AT_POINT']]

class Regularisation(s.Choice):
    WIDTH = 0
    """criteria (1), (2b), (3): area and width kept; the paper's choice"""
    RATIO = 1
    """criteria (1), (2), (3): area and length/width ratio kept (KBTNH)"""
RegularisationLike = Union[Regularisation, Literal['WIDTH', 'RATIO']]

class TractionBound(s.Choice):
    PARABOLIC = 0
    """paper eq. 9: right slope at the leading edge"""
    ELLIPTIC = 1
    """friction * pressure: the actual pressure of each strip"""
    ELLIPSOIDAL = 2
    """friction * load spread as sqrt(x_l^2 - x^2): the pressure of a Kik-Piotrowski patch. On double ellipses
        the same as ELLIPTIC
    """
TractionBoundLike = Union[TractionBound, Literal['PARABOLIC', 'ELLIPTIC', 'ELLIPSOIDAL']]

class Flexibility(s.Choice):
    SEPARATE = 0
    """one for each force of linear theory: right for small creepage"""
    SINGLE = 1
    """Kalker's weighted sum for all: right traction directions at large creepage"""
    BLENDED = 2
    """from the first to the second as creepage grows; Vollebregt and Voltr, VSD 61 (2023)"""
FlexibilityLike = Union[Flexibility, Literal['SEPARATE', 'SINGLE', 'BLENDED']]

class Side(s.Choice):
    RIGHT = 0
    """flange at y < 0"""
    LEFT = 1
    """flange at y > 0; frames and signs stay those of the right wheel"""
SideLike = Union[Side, Literal['RIGHT', 'LEFT']]

class Body(s.Choice):
    WHEEL = 0
    """the wheel"""
    RAIL = 1
    """the rail"""
BodyLike = Union[Body, Literal['WHEEL', 'RAIL']]

class ProfileKind(s.Choice):
    NONE = 0
    """no profile. A model without both has planar gaps only"""
    POINTS = 1
    """points y, z of the caller, joined by a cubic spline"""
    S1002 = 2
    """wheel, EN 13715, from its analytic definition"""
    PROFILE_60E1 = 3
    """rail, nominal head (R300/R80/R13), not canted: set rail_inclination, e.g. 1/40"""
    UIC60_BENCHMARK = 4
    """rail of the Manchester benchmark, canted 1:40 already"""
ProfileKindLike = Union[ProfileKind, Literal['NONE', 'POINTS', 'S1002', 'PROFILE_60E1', 'UIC60_BENCHMARK', '60E1']]

class ProfilePlacement(s.Choice):
    GAUGE = 0
    """rails by track.gauge and track.gauge_depth, tops at z = 0: new profiles"""
    ORIGIN = 1
    """rails by the origin of their points, at y = track.rail_origin, z = 0. Inclination turns about it. A worn
        rail stays where the new one was
    """
ProfilePlacementLike = Union[ProfilePlacement, Literal['GAUGE', 'ORIGIN']]

class InstructionSet(s.Choice):
    BEST = 0
    """the widest that this processor has"""
    BASELINE = 1
    """what every processor of the architecture has: SSE2, NEON"""
    AVX2 = 2
    """x86-64 with AVX2"""
    AVX512 = 3
    """x86-64 with AVX-512 F, DQ, VL"""
InstructionSetLike = Union[InstructionSet, Literal['BEST', 'BASELINE', 'AVX2', 'AVX512']]

class FrictionSpeedLaw(s.Choice):
    NONE = 0
    """factor 1"""
    EXPONENTIAL = 1
    """factor (1 - kinetic_ratio) exp(-fall_rate w) + kinetic_ratio: Polach"""
    HYPERBOLIC = 2
    """factor kinetic_ratio + (1 - kinetic_ratio) / (1 + w / half_speed): static to kinetic"""
FrictionSpeedLawLike = Union[FrictionSpeedLaw, Literal['NONE', 'EXPONENTIAL', 'HYPERBOLIC']]

class FrictionTemperatureLaw(s.Choice):
    NONE = 0
    """factor 1"""
    LINEAR = 1
    """factor 1 up to cold_temperature, hot_ratio from hot_temperature on, linear between. A strip has the mean
        over its load. Not with a method that gives forces alone
    """
FrictionTemperatureLawLike = Union[FrictionTemperatureLaw, Literal['NONE', 'LINEAR']]

class ZoneFrame(s.Choice):
    CONTACT_FRAME = 0
    """contact frame, of wrc_planar.h alone: zones move with the contact point"""
    RAIL_PROFILE = 1
    """rail profile, field side > 0: zones stay on the rail"""
    WHEEL_PROFILE = 2
    """wheel profile, flange side < 0: zones stay on the wheel, as a lubricated flange"""
ZoneFrameLike = Union[ZoneFrame, Literal['CONTACT_FRAME', 'RAIL_PROFILE', 'WHEEL_PROFILE']]

class WheelReference(s.Choice):
    WHEELSET = 0
    """O, the middle of the axle"""
    WHEEL = 1
    """W, where the plane of the tape circle meets the axle: independent wheels, elastic axles"""
WheelReferenceLike = Union[WheelReference, Literal['WHEELSET', 'WHEEL']]

class Orientation(s.Choice):
    ANGLES = 0
    """by roll and yaw"""
    ROWS = 1
    """by rotation row by row, as C and numpy store a matrix: track = R body, y body is the axle"""
    COLUMNS = 2
    """by rotation column by column, as Fortran, MATLAB and Eigen store the same matrix"""
OrientationLike = Union[Orientation, Literal['ANGLES', 'ROWS', 'COLUMNS']]

class Axes(s.Choice):
    NONE = 0
    """by roll_rate, pitch_rate, yaw_rate; angular_velocity must be 0"""
    TRACK = 1
    """by angular_velocity along the track's axes: a yawed axle then has an x component, too"""
    BODY = 2
    """by angular_velocity along the axes of the body without its pitch: y is about the axle"""
AxesLike = Union[Axes, Literal['NONE', 'TRACK', 'BODY']]

class Prescribed(s.Choice):
    HEIGHT = 0
    """wheel: its z. The choice of a dynamic simulation"""
    VERTICAL_LOAD = 1
    """wheel: vertical_load; z of the reference point is found"""
    NORMAL_FORCE = 2
    """contact plane: normal_force along the contact normal"""
    APPROACH = 3
    """contact plane: approach of the bodies. The choice near lift-off"""
PrescribedLike = Union[Prescribed, Literal['HEIGHT', 'VERTICAL_LOAD', 'NORMAL_FORCE', 'APPROACH']]

class Start(s.Choice):
    COLD = 0
    """from nothing: results depend on the inputs of the call alone, to the last bit. Nothing needs saving"""
    WARM = 1
    """from the contact's last solution. Results depend on earlier calls, within the tolerance. For explicit
        integrators and fixed steps, not for implicit ones
    """
    MARK = 2
    """of Contact.wrench() alone: from the solution that Contact.mark() marked; cold before the first mark.
        Results depend on that mark and the inputs of the call alone, to the last bit. For every integrator
        that accepts its steps
    """
StartLike = Union[Start, Literal['COLD', 'WARM', 'MARK']]

class Available(enum.IntFlag):
    TRACTIONS = 1
    """results that need tractions and slip: not with a method that gives forces alone"""
    PLACE = 2
    """places in the track frame: not with a gap, strips or an ellipse of the caller"""
AvailableLike = Union[Available, int]

class Field(s.Choice):
    X = 0
    """cells: x of the middle. Wheel: from its reference point; plane: contact frame [m]"""
    PRESSURE = 1
    """cells: normal pressure in the middle [Pa]"""
    TRACTION_X = 2
    """cells: tangential traction on the wheel along x [Pa]"""
    TRACTION_Y = 3
    """cells: the same along the rail's arc, or along y of the contact plane [Pa]"""
    SLIP_X = 4
    """cells: sliding velocity of the wheel over the rail / rolling speed, along x [-]"""
    SLIP_Y = 5
    """cells: the same along the rail's arc, or along y of the contact plane [-]"""
    POWER_DENSITY = 6
    """cells: frictional power per area, paper eq. 10 [W/m^2]"""
    FATIGUE_INDEX = 7
    """cells: local surface fatigue index, paper eq. 12 [-]"""
    TEMPERATURE_RISE = 8
    """cells: temperature rise of both surfaces by friction, from that at first touch [K]"""
    STRIP_Y = 9
    """strips: middle. Wheel: arc length from the gauge end of the rail's profile; plane: y [m]"""
    STRIP_WIDTH = 10
    """strips: width [m]"""
    STRIP_CENTRE = 11
    """strips: x of the middle, as Field.X [m]"""
    STRIP_HALF_LENGTH = 12
    """strips: half length [m]"""
    STRIP_PEAK = 13
    """strips: peak pressure, damping included [Pa]"""
    STRIP_POWER = 14
    """strips: frictional power per width [W/m]"""
    STRIP_FRICTION = 15
    """strips: coefficient of friction that the law gave [-]"""
    STRIP_WEAR = 16
    """strips: volume lost per metre rolled and per width, Sheffield's law [m]"""
    STRIP_PROFILE_Y = 17
    """strips of a wheel: the middle in the coordinates of the rail's profile [m]"""
    STRIP_PROFILE_Z = 18
    """strips of a wheel: the same, down [m]"""
    STRIP_ANGLE = 19
    """strips of a wheel: of the rail's surface about x there; < 0 on the gauge side [rad]"""
    GAP_Y = 20
    """rows of a planar gap: y [m]"""
    GAP_HEIGHT = 21
    """rows of a planar gap: smallest gap of the row [m]"""
    GAP_CENTRE = 22
    """rows of a planar gap: x of that smallest gap [m]"""
    GAP_CURVATURE = 23
    """rows of a planar gap: d2h/dx2 [1/m]"""
FieldLike = Union[Field, Literal['X', 'PRESSURE', 'TRACTION_X', 'TRACTION_Y', 'SLIP_X', 'SLIP_Y', 'POWER_DENSITY', 'FATIGUE_INDEX', 'TEMPERATURE_RISE', 'STRIP_Y', 'STRIP_WIDTH', 'STRIP_CENTRE', 'STRIP_HALF_LENGTH', 'STRIP_PEAK', 'STRIP_POWER', 'STRIP_FRICTION', 'STRIP_WEAR', 'STRIP_PROFILE_Y', 'STRIP_PROFILE_Z', 'STRIP_ANGLE', 'GAP_Y', 'GAP_HEIGHT', 'GAP_CENTRE', 'GAP_CURVATURE']]

class WrenchInput(s.Choice):
    Y = 0
    """wheel.y [m]"""
    Z = 1
    """wheel.z [m], where the height is prescribed"""
    ROLL = 2
    """wheel.roll [rad]. With a matrix: turning of the body about the track's x"""
    YAW = 3
    """wheel.yaw [rad]. With a matrix: turning of the body about its z, which is rolled"""
    VELOCITY_X = 4
    """wheel.velocity[0] [m/s]"""
    VELOCITY_Y = 5
    """wheel.velocity[1] [m/s]"""
    VELOCITY_Z = 6
    """wheel.velocity[2] [m/s]"""
    ANGULAR_VELOCITY_X = 7
    """wheel.angular_velocity[0] in its axes; with Axes.NONE roll_rate [rad/s]"""
    ANGULAR_VELOCITY_Y = 8
    """wheel.angular_velocity[1]; with Axes.NONE pitch_rate [rad/s]"""
    ANGULAR_VELOCITY_Z = 9
    """wheel.angular_velocity[2]; with Axes.NONE yaw_rate [rad/s]"""
    RAIL_Y = 10
    """rail.y [m]"""
    RAIL_Z = 11
    """rail.z [m]"""
    RAIL_ROLL = 12
    """rail.roll [rad]"""
    RAIL_Y_VELOCITY = 13
    """rail.y_velocity [m/s]"""
    RAIL_Z_VELOCITY = 14
    """rail.z_velocity [m/s]"""
    RAIL_ROLL_RATE = 15
    """rail.roll_rate [rad/s]"""
    VERTICAL_LOAD = 16
    """vertical_load [N], where it is prescribed"""
    DISTANCE = 17
    """distance [m], without the change of the strips' width along the track"""
    ANGLE = 18
    """angle [rad]"""
    RAIL_Y_SLOPE = 19
    """rail.y_slope [-]; 0 of a roller"""
    RAIL_Z_SLOPE = 20
    """rail.z_slope [-]; 0 of a roller"""
    ROLLER_RATE = 21
    """roller_rate [rad/s]; 0 of a rail that is no roller"""
    FRICTION = 22
    """a factor, here 1, on all coefficients of friction [-]"""
    TIME_STEP = 23
    """time_step [s], of config.surface.memory; at time_step 0 towards larger times"""
WrenchInputLike = Union[WrenchInput, Literal['Y', 'Z', 'ROLL', 'YAW', 'VELOCITY_X', 'VELOCITY_Y', 'VELOCITY_Z', 'ANGULAR_VELOCITY_X', 'ANGULAR_VELOCITY_Y', 'ANGULAR_VELOCITY_Z', 'RAIL_Y', 'RAIL_Z', 'RAIL_ROLL', 'RAIL_Y_VELOCITY', 'RAIL_Z_VELOCITY', 'RAIL_ROLL_RATE', 'VERTICAL_LOAD', 'DISTANCE', 'ANGLE', 'RAIL_Y_SLOPE', 'RAIL_Z_SLOPE', 'ROLLER_RATE', 'FRICTION', 'TIME_STEP']]

class DamageQuantity(s.Choice):
    WORK = 0
    """frictional work [J], +-8e12; over the distance it is T-gamma"""
    WEAR_T_GAMMA = 1
    """volume worn by the T-gamma law [m^3], +-8e6; spread like the work. The law is of wheels: bins of a rail
        get the volume of the wheel
    """
    WEAR_SHEFFIELD = 2
    """the same by Sheffield's law, of each strip's T-gamma over its area"""
    WEAR_ARCHARD = 3
    """the same by Archard's, of each strip's work, peak pressure and sliding velocity"""
    WEAR_POWER = 4
    """the same by the power law, of each strip's power over its area"""
    WHOLE_LIFE = 5
    """Whole Life Rail Model: damage function of the patch's T-gamma, times distance and width [m^2], +-8e6; < 0
        where wear removes cracks
    """
    SURFACE_FATIGUE = 6
    """positive part of the strip's surface fatigue index |F| / N - k / p0, times distance and width [m^2], +-8e6
    """
    TIME = 7
    """contact time times width [s m], +-8e6"""
    LARGEST_PRESSURE = 1000
    """not a sum: largest pressure [Pa]"""
    LARGEST_TRACTION = 1001
    """not a sum: largest traction [Pa]: |F| / N of a strip times its peak pressure"""
DamageQuantityLike = Union[DamageQuantity, Literal['WORK', 'WEAR_T_GAMMA', 'WEAR_SHEFFIELD', 'WEAR_ARCHARD', 'WEAR_POWER', 'WHOLE_LIFE', 'SURFACE_FATIGUE', 'TIME', 'LARGEST_PRESSURE', 'LARGEST_TRACTION']]

class Adhesion(s.Choice):
    COULOMB = 0
    """tractions up to friction * pressure, then slip"""
    FULL = 1
    """no slip anywhere: linear theory; friction is unused"""
AdhesionLike = Union[Adhesion, Literal['COULOMB', 'FULL']]

class Collocation(s.Choice):
    QUARTER_POINT = 0
    """converges fastest with the grid: the choice for answers"""
    REFERENCE = 1
    """reproduces the program CONTACT on its own grid: the choice for comparisons"""
CollocationLike = Union[Collocation, Literal['QUARTER_POINT', 'REFERENCE']]

class SurfaceInfluence(s.Choice):
    TURNED = 0
    """turned between the normals of the two cells: the choice for answers"""
    PLAIN = 1
    """a plane's over arc length, the plain conformal setting of CONTACT: for comparisons"""
SurfaceInfluenceLike = Union[SurfaceInfluence, Literal['TURNED', 'PLAIN']]

class CreepParameter(s.Choice):
    COEFFICIENT = 0
    """friction.coefficient [-]"""
    KINETIC_RATIO = 1
    """friction.kinetic_ratio, of a speed law [-]"""
    FALL_RATE = 2
    """friction.fall_rate, of the exponential law [s/m]"""
    HALF_SPEED = 3
    """friction.half_speed, of the hyperbolic law [m/s]"""
    SLOPE_REDUCTION = 4
    """friction.slope_reduction [-]"""
    ADHESION_REDUCTION = 5
    """friction.adhesion_reduction, of TangentialMethod.POLACH [-]"""
    SLIP_REDUCTION = 6
    """friction.slip_reduction, of the same [-]"""
    LAYER_THICKNESS = 7
    """friction.layer_thickness, at a given layer_modulus [m]"""
    LAYER_YIELD = 8
    """friction.layer_yield [Pa]"""
    LAYER_HARDENING = 9
    """friction.layer_hardening [Pa/m]"""
CreepParameterLike = Union[CreepParameter, Literal['COEFFICIENT', 'KINETIC_RATIO', 'FALL_RATE', 'HALF_SPEED', 'SLOPE_REDUCTION', 'ADHESION_REDUCTION', 'SLIP_REDUCTION', 'LAYER_THICKNESS', 'LAYER_YIELD', 'LAYER_HARDENING']]

class Scatter(s.Choice):
    RELATIVE = 0
    """in proportion to the adhesion, and at least to a hundredth of the largest"""
    ABSOLUTE = 1
    """by the same amount at every point"""
ScatterLike = Union[Scatter, Literal['RELATIVE', 'ABSOLUTE']]

class ConicityMethod(s.Choice):
    WAVELENGTH = 0
    """of the cone with the same wavelength: integration of y'' + dr(y) / (e r0) = 0, the method of UIC 519 and
        EN 15302
    """
    REGRESSION = 1
    """half the slope of the straight line fitted to dr over the amplitude, all displacements weighing alike
    """
ConicityMethodLike = Union[ConicityMethod, Literal['WAVELENGTH', 'REGRESSION']]

class FaceKind(s.Choice):
    RAIL = 0
    """nothing lies beside it"""
    STOCK = 1
    """stock rail: a blade lies beside it"""
    BLADE = 2
    """begins or ends against the face on its field side"""
    WING = 3
    """wing rail: a nose lies beside it"""
    NOSE = 4
    """begins or ends low, beside a flangeway"""
    CHECK = 5
    """check rail: as high as the face on its field side, all along"""
FaceKindLike = Union[FaceKind, Literal['RAIL', 'STOCK', 'BLADE', 'WING', 'NOSE', 'CHECK']]

class SurfaceQuantity(s.Choice):
    WATER = 0
    """[kg/m^2]"""
    OXIDE = 1
    """oxide and debris of wear [kg/m^2]"""
    FILM = 2
    """organic film: leaves [kg/m^2]"""
    SAND = 3
    """[kg/m^2]"""
    LUBRICANT = 4
    """grease, friction modifier [kg/m^2]"""
    HEAT = 5
    """above the ambient temperature [J/m^2]"""
SurfaceQuantityLike = Union[SurfaceQuantity, Literal['WATER', 'OXIDE', 'FILM', 'SAND', 'LUBRICANT', 'HEAT']]

class SurfaceBook(s.Choice):
    AMOUNT = 0
    """amount in the bin now"""
    PUT_ON = 1
    """put on by sources; heat also by friction"""
    REMOVED = 2
    """removed by frictional energy; heat lost to the air and into the depth"""
    SQUEEZED = 3
    """pressed out of the running band by passing wheels"""
    EVAPORATED = 4
    """water evaporated; heat that this took"""
    CARRIED = 5
    """carried to the other body, less the amount that came from it"""
SurfaceBookLike = Union[SurfaceBook, Literal['AMOUNT', 'PUT_ON', 'REMOVED', 'SQUEEZED', 'EVAPORATED', 'CARRIED']]

class Profile(s.Struct):
    """A wheel or rail profile: y increases strictly, z is down. 4 to 20000 points, 1e-12 m to 35 mm apart, over
        20 to 500 mm, within 1 m of the origin, without a step. - Wheel: y = 0 and z = 0 at the running
        circle, flange at y < 0, also for a left wheel. - Rail: y towards the field side, z = 0 at the top;
        gauge side at y < 0 (also for a left rail). Its points go down the gauge face by track.gauge_depth at
        least. - A step is refused: 1 mm and more from one point to the next at over 79 degrees, between parts
        below 45 degrees. For a rail's upper 40 mm 56 degrees hold.
    """
    @property
    def kind(self) -> ProfileKind:
        """kind: ProfileKind (default ProfileKind.NONE)"""
    @kind.setter
    def kind(self, value: ProfileKindLike) -> None: ...
    @property
    def count(self) -> int:
        """count: number of points (4 .. 20000; default 0)"""
    @property
    def y(self) -> Optional[NDArray[np.float64]]:
        """y [m]: count of them (required)"""
    @y.setter
    def y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def z(self) -> Optional[NDArray[np.float64]]:
        """z [m]: count of them (required)"""
    @z.setter
    def z(self, value: Optional[s.Floats]) -> None: ...
    smoothing: float
    """smoothing [m]: wavelength along the curve that keeps half its height; 0: points are interpolated. Waves of
        half that length keep a seventeenth. Tested: 7e-3 (0 .. 0.05; default 0)
    """
    def __init__(self, *, kind: ProfileKindLike = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ..., smoothing: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, kind: ProfileKindLike = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ..., smoothing: float = ...) -> Profile:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ProfileDict(TypedDict, total=False):
    """Members of wrc.Profile as a dict."""
    kind: ProfileKindLike
    y: Optional[s.Floats]
    z: Optional[s.Floats]
    smoothing: float

class Material(s.Struct):
    """Elastic and yield properties of a body. Of two different bodies all methods take 1/G = (1/G_w + 1/G_r) / 2
        and nu/G = (nu_w/G_w + nu_r/G_r) / 2. Kalker's K couples pressure and traction. Contact.wrench()
        includes its leading part with TangentialMethod.STRIP_FASTSIM and without memory; all other calls in
        real time leave K out. Where K is not 0, Status.FLAG_DISSIMILAR_MATERIALS is set when the model is
        made. Theory manual, section 4.
    """
    shear_modulus: float
    """shear_modulus [Pa]: G (1e8 .. 1e12; default 82e9)"""
    poisson: float
    """poisson: nu (0 .. 0.5; default 0.28)"""
    shear_yield: float
    """shear_yield [Pa]: k, yield limit in shear. Fatigue indices take the smaller of both bodies (1e6 .. 1e11;
        default 250e6)
    """
    def __init__(self, *, shear_modulus: float = ..., poisson: float = ..., shear_yield: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, shear_modulus: float = ..., poisson: float = ..., shear_yield: float = ...) -> Material:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class MaterialDict(TypedDict, total=False):
    """Members of wrc.Material as a dict."""
    shear_modulus: float
    poisson: float
    shear_yield: float

class HeatProperties(s.Struct):
    """How a body takes up heat. Read by temperatures and by friction over temperature."""
    conductivity: float
    """conductivity [W/(m K)]: lambda (0.1 .. 1000; default 50)"""
    density: float
    """density [kg/m^3]: rho (100 .. 1e5; default 7850)"""
    specific_heat: float
    """specific_heat [J/(kg K)]: c (10 .. 1e5; default 450)"""
    def __init__(self, *, conductivity: float = ..., density: float = ..., specific_heat: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, conductivity: float = ..., density: float = ..., specific_heat: float = ...) -> HeatProperties:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class HeatPropertiesDict(TypedDict, total=False):
    """Members of wrc.HeatProperties as a dict."""
    conductivity: float
    density: float
    specific_heat: float

class ConfigWheelset(s.Struct):
    """Where the wheels are on their axle."""
    wheel_radius: float
    """wheel_radius [m]: nominal rolling radius, at the tape circle (0.1 .. 1.5; default 0.46)"""
    tape_circle_distance: float
    """tape_circle_distance [m]: between the tape circles of both wheels; not read without profiles (0.3 .. 3;
        default 1.5)
    """
    def __init__(self, *, wheel_radius: float = ..., tape_circle_distance: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, wheel_radius: float = ..., tape_circle_distance: float = ...) -> ConfigWheelset:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigWheelsetDict(TypedDict, total=False):
    """Members of wrc.ConfigWheelset as a dict."""
    wheel_radius: float
    tape_circle_distance: float

class ConfigTrack(s.Struct):
    """Where the rails are. Not read without profiles."""
    @property
    def placement(self) -> ProfilePlacement:
        """placement: ProfilePlacement (default ProfilePlacement.GAUGE)"""
    @placement.setter
    def placement(self, value: ProfilePlacementLike) -> None: ...
    gauge: float
    """gauge [m]: between the gauge faces of the rails (0.3 .. 2.5; default 1.435)"""
    gauge_depth: float
    """gauge_depth [m]: depth below the rail top at which the gauge is measured (0.005 .. 0.04; default 0.014)
    """
    rail_inclination: float
    """rail_inclination: tangent of the cant towards the track centre; 1:40 is 0.025. 0 for
        ProfileKind.UIC60_BENCHMARK (-0.2 .. 0.2; default 0)
    """
    rail_origin: float
    """rail_origin [m]: distance of the rail profile's origin from the track's centre line (0.2 .. 1.5; default
        0)
    """
    def __init__(self, *, placement: ProfilePlacementLike = ..., gauge: float = ..., gauge_depth: float = ..., rail_inclination: float = ..., rail_origin: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, placement: ProfilePlacementLike = ..., gauge: float = ..., gauge_depth: float = ..., rail_inclination: float = ..., rail_origin: float = ...) -> ConfigTrack:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigTrackDict(TypedDict, total=False):
    """Members of wrc.ConfigTrack as a dict."""
    placement: ProfilePlacementLike
    gauge: float
    gauge_depth: float
    rail_inclination: float
    rail_origin: float

class RailSection(s.Struct):
    """One cross section of a rail that changes along the track. A surface is a stock rail, a blade, a wing rail,
        a nose. Its sections are blended point by point of equal share of their length. The blend is twice
        continuously differentiable in the distance. Marks divide that length: points of equal mark belong
        together. A surface is there from its first section to its last; where the whole rail begins or ends
        its section goes on. An end is best where no wheel touches it. Else the wheel rolls over its edge, up
        to 14 mm high, with Status.FLAG_PATCH_AT_EDGE. Height and force are continuous there; the peak
        pressure is not solved. A hollow that is curved more than the wheel is met on one of its sides: force
        and place jump where that changes. Theory manual, section 9.
    """
    distance: float
    """distance [m]: along the track. Within a surface it increases by 1 mm at least (-1e7 .. 1e7; default 0)
    """
    y: float
    """y [m]: place of the profile's origin from that of config.rail, to the field side (-0.5 .. 0.5; default 0)
    """
    z: float
    """z [m]: the same downwards (-0.5 .. 0.5; default 0)"""
    surface: int
    """surface: number of its surface, counted from the gauge side; sections of one surface stand side by side (0
        .. 7; default 0)
    """
    @property
    def mark_count(self) -> int:
        """mark_count: number of marks; equal for all sections of a surface (0 .. 64; default 0)"""
    @property
    def marks(self) -> Optional[NDArray[np.float64]]:
        """marks [m]: mark_count of them: y on this profile, increasing by 1 mm at least, also from the ends
            (-0.5 .. 0.5; required)
        """
    @marks.setter
    def marks(self, value: Optional[s.Floats]) -> None: ...
    profile: Profile
    """profile: its outline from its own origin, canted by config.track.rail_inclination"""
    def __init__(self, *, distance: float = ..., y: float = ..., z: float = ..., surface: int = ..., marks: Optional[s.Floats] = ..., profile: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, distance: float = ..., y: float = ..., z: float = ..., surface: int = ..., marks: Optional[s.Floats] = ..., profile: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct] = ...) -> RailSection:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class RailSectionDict(TypedDict, total=False):
    """Members of wrc.RailSection as a dict."""
    distance: float
    y: float
    z: float
    surface: int
    marks: Optional[s.Floats]
    profile: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct]

class ConfigRoundness(s.Struct):
    """A wheel that is not round: a flat, a polygon, a measurement. A periodic cubic spline goes through each
        row. Theory manual, section 9.
    """
    @property
    def angle_count(self) -> int:
        """angle_count: places round the wheel in each row; the first comes again at the end (0 or 9 .. 20000;
            default 0)
        """
    @property
    def row_count(self) -> int:
        """row_count: rows across the tread (1 .. 16; default 0)"""
    @property
    def angles(self) -> Optional[NDArray[np.float64]]:
        """angles [rad]: angle_count of them, increasing from 0 to 2 pi. At WheelInput.angle 0, 0 is the lowest
            point and angles grow towards +x (0 .. 6.2831854; required)
        """
    @angles.setter
    def angles(self, value: Optional[s.Floats]) -> None: ...
    @property
    def y(self) -> Optional[NDArray[np.float64]]:
        """y [m]: row_count of them: y of each row on the wheel's profile, increasing; None: one row (-0.5 ..
            0.5; default None)
        """
    @y.setter
    def y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def deviations(self) -> Optional[NDArray[np.float64]]:
        """deviations [m]: row_count * angle_count of them, row by row: radius less that of the profile (-0.005
            .. 0.005; required)
        """
    @deviations.setter
    def deviations(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, angles: Optional[s.Floats] = ..., y: Optional[s.Floats] = ..., deviations: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, angles: Optional[s.Floats] = ..., y: Optional[s.Floats] = ..., deviations: Optional[s.Floats] = ...) -> ConfigRoundness:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigRoundnessDict(TypedDict, total=False):
    """Members of wrc.ConfigRoundness as a dict."""
    angles: Optional[s.Floats]
    y: Optional[s.Floats]
    deviations: Optional[s.Floats]

class ConfigCheckRail(s.Struct):
    """A check rail beside each rail, which guides the back of the wheel's flange. It is the same all along the
        track and moves with the rail. The wheel's profile must have points on the flange's back, beyond the
        tip.
    """
    y: float
    """y [m]: place of its profile's origin from that of config.rail, to the field side: < 0 (-0.5 .. 0; default
        0)
    """
    z: float
    """z [m]: the same downwards: < 0 where it stands above the rail's origin (-0.5 .. 0.5; default 0)"""
    profile: Profile
    """profile: its outline as that of a rail; its field side guides. ProfileKind.NONE: there is no check rail
    """
    def __init__(self, *, y: float = ..., z: float = ..., profile: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, y: float = ..., z: float = ..., profile: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct] = ...) -> ConfigCheckRail:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigCheckRailDict(TypedDict, total=False):
    """Members of wrc.ConfigCheckRail as a dict."""
    y: float
    z: float
    profile: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct]

class ConfigNormal(s.Struct):
    """The normal problem."""
    @property
    def method(self) -> NormalMethod:
        """method: NormalMethod (default NormalMethod.STRIP_HALFSPACE)"""
    @method.setter
    def method(self, value: NormalMethodLike) -> None: ...
    max_iterations: int
    """max_iterations: cap of the steps of the load search; not of NormalMethod.STRIP_HALFSPACE (4 .. 1000;
        default 60)
    """
    load_tolerance: float
    """load_tolerance: relative error of a prescribed load; not of NormalMethod.STRIP_HALFSPACE (1e-14 .. 1e-2;
        default 1e-10)
    """
    def __init__(self, *, method: NormalMethodLike = ..., max_iterations: int = ..., load_tolerance: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, method: NormalMethodLike = ..., max_iterations: int = ..., load_tolerance: float = ...) -> ConfigNormal:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigNormalDict(TypedDict, total=False):
    """Members of wrc.ConfigNormal as a dict."""
    method: NormalMethodLike
    max_iterations: int
    load_tolerance: float

class ConfigTangential(s.Struct):
    """The tangential problem. use() sets a published method by its name."""
    @property
    def method(self) -> TangentialMethod:
        """method: TangentialMethod (default TangentialMethod.STRIP_FASTSIM)"""
    @method.setter
    def method(self, value: TangentialMethodLike) -> None: ...
    @property
    def patch_model(self) -> PatchModel:
        """patch_model: PatchModel; of FASTSIM and FaStrip (default PatchModel.PATCH_SDEC)"""
    @patch_model.setter
    def patch_model(self, value: PatchModelLike) -> None: ...
    @property
    def bound(self) -> TractionBound:
        """bound: TractionBound; of FASTSIM (default TractionBound.PARABOLIC)"""
    @bound.setter
    def bound(self, value: TractionBoundLike) -> None: ...
    @property
    def flexibility(self) -> Flexibility:
        """flexibility: Flexibility; of FASTSIM (default Flexibility.SEPARATE)"""
    @flexibility.setter
    def flexibility(self, value: FlexibilityLike) -> None: ...
    @property
    def force_table(self) -> Optional[str]:
        """force_table: file of the force table, read once by the model; of TangentialMethod.FORCE_TABLE (default
            None)
        """
    @force_table.setter
    def force_table(self, value: Optional[s.Path]) -> None: ...
    def __init__(self, *, method: TangentialMethodLike = ..., patch_model: PatchModelLike = ..., bound: TractionBoundLike = ..., flexibility: FlexibilityLike = ..., force_table: Optional[s.Path] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, method: TangentialMethodLike = ..., patch_model: PatchModelLike = ..., bound: TractionBoundLike = ..., flexibility: FlexibilityLike = ..., force_table: Optional[s.Path] = ...) -> ConfigTangential:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigTangentialDict(TypedDict, total=False):
    """Members of wrc.ConfigTangential as a dict."""
    method: TangentialMethodLike
    patch_model: PatchModelLike
    bound: TractionBoundLike
    flexibility: FlexibilityLike
    force_table: Optional[s.Path]

class ConfigSurface(s.Struct):
    """Options of Contact.wrench() alone. use() sets resolution, tolerance and work by the name of a setting.
        Times and errors of settings: docs/realtime.md.
    """
    cells: int
    """cells: cells along each strip, in which it rolls and fields are given (4 .. 512; default 32)"""
    memory: int
    """memory: 1: contacts remember the tractions of the step that Contact.commit() commits, at rest and rolling
        either way. Of TangentialMethod.STRIP_FASTSIM (0 .. 1; default 0)
    """
    tread_width: float
    """tread_width [m]: width of the rail's strips where its radius of curvature is 60 mm or more (1e-4 .. 2e-3;
        default 5e-4)
    """
    corner_width: float
    """corner_width [m]: the same where it is 20 mm or less, at most tread_width; linear between. Faces that
        guide, of a check rail, have 0.2e-3 m at most (5e-5 .. 1e-3; default 2.5e-4)
    """
    tolerance: float
    """tolerance: part of the contact's area that the last iteration of the normal problem moves; of
        NormalMethod.STRIP_HALFSPACE. Forces, and a prescribed load, are met to a tenth of it (1e-10 .. 1e-2;
        default 1e-5)
    """
    max_work: float
    """max_work: work that a call may take, all heights of a prescribed load included; of
        NormalMethod.STRIP_HALFSPACE. Its unit is one strip displacing another: an iteration over n strips
        takes 2 n^2, n at least 4. One that would exceed it is not begun: Status.FLAG_ITERATION_CAP (1e3 ..
        1e9; default 2e7)
    """
    max_iterations: float
    """max_iterations: cap of the normal problem at one height, in iterations over all strips that overlap there;
        over those in contact about twice as many; of NormalMethod.STRIP_HALFSPACE. The call then ends as with
        max_work (2 .. 1e6; default 1e6)
    """
    def __init__(self, *, cells: int = ..., memory: int = ..., tread_width: float = ..., corner_width: float = ..., tolerance: float = ..., max_work: float = ..., max_iterations: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, cells: int = ..., memory: int = ..., tread_width: float = ..., corner_width: float = ..., tolerance: float = ..., max_work: float = ..., max_iterations: float = ...) -> ConfigSurface:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigSurfaceDict(TypedDict, total=False):
    """Members of wrc.ConfigSurface as a dict."""
    cells: int
    memory: int
    tread_width: float
    corner_width: float
    tolerance: float
    max_work: float
    max_iterations: float

class ConfigPlanar(s.Struct):
    """Options of the stages of wrc_planar.h, and of their normal methods where Contact.wrench() applies them.
        The ellipse of any region follows regularisation.
    """
    strips: int
    """strips: strips across the patch (4 .. 512; default 60)"""
    cells: int
    """cells: cells along each strip (4 .. 512; default 32)"""
    gap_rows: int
    """gap_rows: rows the gap is sampled at, and most that a caller's gap has (8 .. 4096; default 256)"""
    max_patches: int
    """max_patches: patches reported; more are flagged (1 .. 16; default 4)"""
    max_sweeps: int
    """max_sweeps: cap of the sweeps over the strips on each of two grids; of NormalMethod.STRIP_HALFSPACE (4 ..
        1000; default 16)
    """
    @property
    def start(self) -> Start:
        """start: Start: of the sweeps of NormalMethod.STRIP_HALFSPACE. Warm, the same approach again moves the
            force by up to 0.1 % (default Start.COLD)
        """
    @start.setter
    def start(self, value: StartLike) -> None: ...
    @property
    def regularisation(self) -> Regularisation:
        """regularisation: Regularisation (default Regularisation.WIDTH)"""
    @regularisation.setter
    def regularisation(self, value: RegularisationLike) -> None: ...
    non_steady: int
    """non_steady: 1: contacts remember tractions over the distances told to Contact.planar_roll(), at rest and
        rolling either way. Of TangentialMethod.STRIP_FASTSIM (0 .. 1; default 0)
    """
    gap_limit: float
    """gap_limit [m]: gap up to which rows of a pose reach. Deeper approaches are continued,
        Status.FLAG_BEYOND_GAP (1e-5 .. 0.02; default 1e-3)
    """
    def __init__(self, *, strips: int = ..., cells: int = ..., gap_rows: int = ..., max_patches: int = ..., max_sweeps: int = ..., start: StartLike = ..., regularisation: RegularisationLike = ..., non_steady: int = ..., gap_limit: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, strips: int = ..., cells: int = ..., gap_rows: int = ..., max_patches: int = ..., max_sweeps: int = ..., start: StartLike = ..., regularisation: RegularisationLike = ..., non_steady: int = ..., gap_limit: float = ...) -> ConfigPlanar:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigPlanarDict(TypedDict, total=False):
    """Members of wrc.ConfigPlanar as a dict."""
    strips: int
    cells: int
    gap_rows: int
    max_patches: int
    max_sweeps: int
    start: StartLike
    regularisation: RegularisationLike
    non_steady: int
    gap_limit: float

class Config(s.Struct):
    """Everything a model is made of. Begin with wrc_config_default(). A member that the chosen methods do not
        read must keep its default: anything else is Status.ERROR_UNSUPPORTED, with a sentence.
    """
    @property
    def instruction_set(self) -> InstructionSet:
        """instruction_set: InstructionSet (default InstructionSet.BEST)"""
    @instruction_set.setter
    def instruction_set(self, value: InstructionSetLike) -> None: ...
    wheel: Profile
    """wheel: profile of the wheel"""
    rail: Profile
    """rail: profile of the rail; both are ProfileKind.NONE or neither is"""
    wheel_material: Material
    """wheel_material: of the wheel"""
    rail_material: Material
    """rail_material: of the rail"""
    wheel_heat: HeatProperties
    """wheel_heat: how the wheel takes up heat"""
    rail_heat: HeatProperties
    """rail_heat: how the rail takes up heat"""
    wheelset: ConfigWheelset
    """wheelset: where the wheels are on their axle"""
    track: ConfigTrack
    """track: where the rails are"""
    normal: ConfigNormal
    """normal: method of the normal problem"""
    tangential: ConfigTangential
    """tangential: method of the tangential problem"""
    surface: ConfigSurface
    """surface: options of Contact.wrench()"""
    planar: ConfigPlanar
    """planar: options of the stages of wrc_planar.h"""
    roundness: ConfigRoundness
    """roundness: of a wheel that is not round; of Contact.wrench()"""
    roller_curvature: float
    """roller_curvature [1/m]: 1 / radius of a roller at the origin of the rail's profile; 0: a straight rail; of
        Contact.wrench() (0 or 1e-12 .. 10; default 0)
    """
    check_rail: ConfigCheckRail
    """check_rail: beside the rail; of Contact.wrench()"""
    @property
    def rail_section_count(self) -> int:
        """rail_section_count: sections of a rail that changes along the track; of Contact.wrench() (0 .. 1000;
            default 0)
        """
    @property
    def rail_sections(self) -> List[RailSection]:
        """rail_sections: rail_section_count of them. config.rail stays the rail of the stages, and its place is
            the sections' (required)
        """
    @rail_sections.setter
    def rail_sections(self, value: Optional[Sequence[Union[RailSection, RailSectionDict]]]) -> None: ...
    def __init__(self, *, instruction_set: InstructionSetLike = ..., wheel: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct] = ..., rail: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct] = ..., wheel_material: Union[Material, MaterialDict] = ..., rail_material: Union[Material, MaterialDict] = ..., wheel_heat: Union[HeatProperties, HeatPropertiesDict] = ..., rail_heat: Union[HeatProperties, HeatPropertiesDict] = ..., wheelset: Union[ConfigWheelset, ConfigWheelsetDict] = ..., track: Union[ConfigTrack, ConfigTrackDict] = ..., normal: Union[ConfigNormal, ConfigNormalDict] = ..., tangential: Union[ConfigTangential, ConfigTangentialDict] = ..., surface: Union[ConfigSurface, ConfigSurfaceDict] = ..., planar: Union[ConfigPlanar, ConfigPlanarDict] = ..., roundness: Union[ConfigRoundness, ConfigRoundnessDict] = ..., roller_curvature: float = ..., check_rail: Union[ConfigCheckRail, ConfigCheckRailDict] = ..., rail_sections: Optional[Sequence[Union[RailSection, RailSectionDict]]] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, instruction_set: InstructionSetLike = ..., wheel: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct] = ..., rail: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct] = ..., wheel_material: Union[Material, MaterialDict] = ..., rail_material: Union[Material, MaterialDict] = ..., wheel_heat: Union[HeatProperties, HeatPropertiesDict] = ..., rail_heat: Union[HeatProperties, HeatPropertiesDict] = ..., wheelset: Union[ConfigWheelset, ConfigWheelsetDict] = ..., track: Union[ConfigTrack, ConfigTrackDict] = ..., normal: Union[ConfigNormal, ConfigNormalDict] = ..., tangential: Union[ConfigTangential, ConfigTangentialDict] = ..., surface: Union[ConfigSurface, ConfigSurfaceDict] = ..., planar: Union[ConfigPlanar, ConfigPlanarDict] = ..., roundness: Union[ConfigRoundness, ConfigRoundnessDict] = ..., roller_curvature: float = ..., check_rail: Union[ConfigCheckRail, ConfigCheckRailDict] = ..., rail_sections: Optional[Sequence[Union[RailSection, RailSectionDict]]] = ...) -> Config:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConfigDict(TypedDict, total=False):
    """Members of wrc.Config as a dict."""
    instruction_set: InstructionSetLike
    wheel: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct]
    rail: Union[Profile, ProfileDict, ProfileKindLike, s.AsStruct]
    wheel_material: Union[Material, MaterialDict]
    rail_material: Union[Material, MaterialDict]
    wheel_heat: Union[HeatProperties, HeatPropertiesDict]
    rail_heat: Union[HeatProperties, HeatPropertiesDict]
    wheelset: Union[ConfigWheelset, ConfigWheelsetDict]
    track: Union[ConfigTrack, ConfigTrackDict]
    normal: Union[ConfigNormal, ConfigNormalDict]
    tangential: Union[ConfigTangential, ConfigTangentialDict]
    surface: Union[ConfigSurface, ConfigSurfaceDict]
    planar: Union[ConfigPlanar, ConfigPlanarDict]
    roundness: Union[ConfigRoundness, ConfigRoundnessDict]
    roller_curvature: float
    check_rail: Union[ConfigCheckRail, ConfigCheckRailDict]
    rail_sections: Optional[Sequence[Union[RailSection, RailSectionDict]]]

class Allocator(s.Struct):
    """Where memory comes from in wrc_model_create() and wrc_contact_create(). Both functions or neither."""
    user: Any
    """user: handed to both (default None)"""
    allocate: Any
    """allocate: alignment is a power of two; returns None where no memory is left (default None)"""
    release: Any
    """release: called by the destroy functions, and when a create fails (default None)"""
    def __init__(self, *, user: Any = ..., allocate: Any = ..., release: Any = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, user: Any = ..., allocate: Any = ..., release: Any = ...) -> Allocator:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class AllocatorDict(TypedDict, total=False):
    """Members of wrc.Allocator as a dict."""
    user: Any
    allocate: Any
    release: Any

class View(s.Struct):
    """A read-only view: element i is data[i]."""
    @property
    def data(self) -> Optional[NDArray[np.float64]]:
        """data: in the model's memory; None on failure"""
    @data.setter
    def data(self, value: Optional[s.Floats]) -> None: ...
    count: int
    """count: elements"""
    def __init__(self, *, data: Optional[s.Floats] = ..., count: int = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, data: Optional[s.Floats] = ..., count: int = ...) -> View:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ViewDict(TypedDict, total=False):
    """Members of wrc.View as a dict."""
    data: Optional[s.Floats]
    count: int

class BulkTemperatures(s.Struct):
    """Temperatures of the bodies away from the contact."""
    wheel: float
    """wheel [degC]: of the tread (-273 .. 2000; default 20)"""
    rail: float
    """rail [degC]: of the running surface (-273 .. 2000; default 20)"""
    def __init__(self, *, wheel: float = ..., rail: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, wheel: float = ..., rail: float = ...) -> BulkTemperatures:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class BulkTemperaturesDict(TypedDict, total=False):
    """Members of wrc.BulkTemperatures as a dict."""
    wheel: float
    rail: float

class Friction(s.Struct):
    """Friction between the bodies, and a layer between them. Each strip has one coefficient: that at rest
        (coefficient, or of the zones) times the factor of speed_law times that of temperature_law. Members of
        laws that are not chosen are checked and not read: a program may keep the parameters of all. Theory
        manual, section 5.
    """
    coefficient: float
    """coefficient: Coulomb, at rest; 0, no friction, in Contact.wrench() alone (0 or 1e-4 .. 2; default 0.3)
    """
    @property
    def speed_law(self) -> FrictionSpeedLaw:
        """speed_law: FrictionSpeedLaw (default FrictionSpeedLaw.NONE)"""
    @speed_law.setter
    def speed_law(self, value: FrictionSpeedLawLike) -> None: ...
    @property
    def temperature_law(self) -> FrictionTemperatureLaw:
        """temperature_law: FrictionTemperatureLaw (default FrictionTemperatureLaw.NONE)"""
    @temperature_law.setter
    def temperature_law(self, value: FrictionTemperatureLawLike) -> None: ...
    kinetic_ratio: float
    """kinetic_ratio: friction at high sliding speed over that at rest (Polach's A) (0 .. 1; default 0.4)"""
    fall_rate: float
    """fall_rate [s/m]: Polach's B, of the exponential law (0 .. 1000; default 0.6)"""
    half_speed: float
    """half_speed [m/s]: sliding speed at which half of the fall is done, of the hyperbolic law (1e-6 .. 100;
        default 1)
    """
    hot_ratio: float
    """hot_ratio: friction of hot surfaces over that of cold ones (0 .. 1; default 0.5)"""
    cold_temperature: float
    """cold_temperature [degC]: up to which friction is whole (-273 .. 2000; default 0)"""
    hot_temperature: float
    """hot_temperature [degC]: from which friction has hot_ratio; 1 degC above cold_temperature at least (-273 ..
        3000; default 400)
    """
    bulk: BulkTemperatures
    """bulk: of the bodies; read by the temperature law"""
    slope_reduction: float
    """slope_reduction: initial slope of the creep curve over that of clean bodies: a layer (0.01 .. 1; default
        1)
    """
    slope_limit: float
    """slope_limit: share of that slope left at large slip; of modified FASTSIM (0 .. 1; default 0.02)"""
    slope_fall: float
    """slope_fall: how fast the slope falls with slip; of modified FASTSIM (0 .. 1000; default 0)"""
    @property
    def zone_y(self) -> Optional[NDArray[np.float64]]:
        """zone_y [m]: breakpoints, zone_count of them, increasing; two at one y make a step (-1 .. 1; required)
        """
    @zone_y.setter
    def zone_y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def zone_coefficients(self) -> Optional[NDArray[np.float64]]:
        """zone_coefficients: friction at rest at the breakpoints, zone_count of them, in place of coefficient.
            Linear between them, constant beyond. A strip has its mean (0 .. 2; required)
        """
    @zone_coefficients.setter
    def zone_coefficients(self, value: Optional[s.Floats]) -> None: ...
    @property
    def zone_count(self) -> int:
        """zone_count: breakpoints (0 .. 64; default 0)"""
    @property
    def zone_frame(self) -> ZoneFrame:
        """zone_frame: ZoneFrame (default ZoneFrame.CONTACT_FRAME)"""
    @zone_frame.setter
    def zone_frame(self, value: ZoneFrameLike) -> None: ...
    layer_thickness: float
    """layer_thickness [m]: of an elasto-plastic layer between the bodies; 0: it does not shear elastically (0 ..
        0.01; default 0)
    """
    layer_modulus: float
    """layer_modulus [Pa]: of that layer in shear; goes with a thickness (0 or 1e3 .. 1e12; default 0)"""
    layer_yield: float
    """layer_yield [Pa]: traction at which fresh layer yields; 0: it does not yield (0 or 1e3 .. 1e11; default 0)
    """
    layer_hardening: float
    """layer_hardening [Pa/m]: rise of that traction over the length of plastic flow, < 0: the layer softens, to
        a tenth of layer_yield at least; goes with layer_yield (-1e13 .. 1e14; default 0)
    """
    adhesion_reduction: float
    """adhesion_reduction: Polach's k_A: factor on the gradient of traction where the patch sticks; of
        TangentialMethod.POLACH, which refuses 0 (0 or 0.001 .. 1; default 1)
    """
    slip_reduction: float
    """slip_reduction: Polach's k_S: that factor where the patch slips, at most adhesion_reduction; of
        TangentialMethod.POLACH, which refuses 0 (0 or 0.001 .. 1; default 1)
    """
    @property
    def film_rows(self) -> Optional[NDArray[np.float64]]:
        """film_rows: films in rows across rail and wheel, film_numbers of them, as surface_friction() fills
            them; of Contact.wrench() (-1e30 .. 1e30; default None)
        """
    @film_rows.setter
    def film_rows(self, value: Optional[s.Floats]) -> None: ...
    @property
    def film_numbers(self) -> int:
        """film_numbers: numbers of film_rows; 0: no rows (0 .. 1288; default 0)"""
    def __init__(self, *, coefficient: float = ..., speed_law: FrictionSpeedLawLike = ..., temperature_law: FrictionTemperatureLawLike = ..., kinetic_ratio: float = ..., fall_rate: float = ..., half_speed: float = ..., hot_ratio: float = ..., cold_temperature: float = ..., hot_temperature: float = ..., bulk: Union[BulkTemperatures, BulkTemperaturesDict] = ..., slope_reduction: float = ..., slope_limit: float = ..., slope_fall: float = ..., zone_y: Optional[s.Floats] = ..., zone_coefficients: Optional[s.Floats] = ..., zone_frame: ZoneFrameLike = ..., layer_thickness: float = ..., layer_modulus: float = ..., layer_yield: float = ..., layer_hardening: float = ..., adhesion_reduction: float = ..., slip_reduction: float = ..., film_rows: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, coefficient: float = ..., speed_law: FrictionSpeedLawLike = ..., temperature_law: FrictionTemperatureLawLike = ..., kinetic_ratio: float = ..., fall_rate: float = ..., half_speed: float = ..., hot_ratio: float = ..., cold_temperature: float = ..., hot_temperature: float = ..., bulk: Union[BulkTemperatures, BulkTemperaturesDict] = ..., slope_reduction: float = ..., slope_limit: float = ..., slope_fall: float = ..., zone_y: Optional[s.Floats] = ..., zone_coefficients: Optional[s.Floats] = ..., zone_frame: ZoneFrameLike = ..., layer_thickness: float = ..., layer_modulus: float = ..., layer_yield: float = ..., layer_hardening: float = ..., adhesion_reduction: float = ..., slip_reduction: float = ..., film_rows: Optional[s.Floats] = ...) -> Friction:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class FrictionDict(TypedDict, total=False):
    """Members of wrc.Friction as a dict."""
    coefficient: float
    speed_law: FrictionSpeedLawLike
    temperature_law: FrictionTemperatureLawLike
    kinetic_ratio: float
    fall_rate: float
    half_speed: float
    hot_ratio: float
    cold_temperature: float
    hot_temperature: float
    bulk: Union[BulkTemperatures, BulkTemperaturesDict]
    slope_reduction: float
    slope_limit: float
    slope_fall: float
    zone_y: Optional[s.Floats]
    zone_coefficients: Optional[s.Floats]
    zone_frame: ZoneFrameLike
    layer_thickness: float
    layer_modulus: float
    layer_yield: float
    layer_hardening: float
    adhesion_reduction: float
    slip_reduction: float
    film_rows: Optional[s.Floats]

class WheelState(s.Struct):
    """Where a wheel or wheelset is and how it moves, against the ground."""
    @property
    def reference(self) -> WheelReference:
        """reference: WheelReference: of y, z, velocity and the wrench's moment (default WheelReference.WHEELSET)
        """
    @reference.setter
    def reference(self, value: WheelReferenceLike) -> None: ...
    @property
    def orientation(self) -> Orientation:
        """orientation: Orientation: by roll and yaw, or by rotation (default Orientation.ANGLES)"""
    @orientation.setter
    def orientation(self, value: OrientationLike) -> None: ...
    @property
    def angular_axes(self) -> Axes:
        """angular_axes: Axes: by roll_rate, pitch_rate, yaw_rate, or by angular_velocity (default Axes.NONE)"""
    @angular_axes.setter
    def angular_axes(self, value: AxesLike) -> None: ...
    y: float
    """y [m]: displacement of the reference point to the right (-0.2 .. 0.2; default 0)"""
    z: float
    """z [m]: the same downwards; 0 is the nominal height (-0.5 .. 0.2; default 0)"""
    roll: float
    """roll [rad]: about x, right wheel down; 0 with a matrix (-0.5 .. 0.5; default 0)"""
    yaw: float
    """yaw [rad]: about the rolled z, nose to the right; 0 with a matrix (-0.5 .. 0.5; default 0)"""
    @property
    def velocity(self) -> NDArray[Any]:
        """velocity [m/s]: of the reference point, track axes (-200 .. 200, -50 .. 50, -50 .. 50; default 0)"""
    @velocity.setter
    def velocity(self, value: s.Floats) -> None: ...
    roll_rate: float
    """roll_rate [rad/s]: time derivative of roll (-200 .. 200; default 0)"""
    pitch_rate: float
    """pitch_rate [rad/s]: about the axle, -v / r0 rolling forwards (-2000 .. 2000; default 0)"""
    yaw_rate: float
    """yaw_rate [rad/s]: time derivative of yaw (-200 .. 200; default 0)"""
    @property
    def angular_velocity(self) -> NDArray[Any]:
        """angular_velocity [rad/s]: whole, in the axes that angular_axes says (-200 .. 200, -2000 .. 2000, -200
            .. 200; default 0)
        """
    @angular_velocity.setter
    def angular_velocity(self, value: s.Floats) -> None: ...
    @property
    def rotation(self) -> NDArray[Any]:
        """rotation: R of track = R body, orthonormal to 1e-6, its axle within 0.5 rad of the track's y (-1.001
            .. 1.001; default 0)
        """
    @rotation.setter
    def rotation(self, value: s.Floats) -> None: ...
    def __init__(self, *, reference: WheelReferenceLike = ..., orientation: OrientationLike = ..., angular_axes: AxesLike = ..., y: float = ..., z: float = ..., roll: float = ..., yaw: float = ..., velocity: s.Floats = ..., roll_rate: float = ..., pitch_rate: float = ..., yaw_rate: float = ..., angular_velocity: s.Floats = ..., rotation: s.Floats = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, reference: WheelReferenceLike = ..., orientation: OrientationLike = ..., angular_axes: AxesLike = ..., y: float = ..., z: float = ..., roll: float = ..., yaw: float = ..., velocity: s.Floats = ..., roll_rate: float = ..., pitch_rate: float = ..., yaw_rate: float = ..., angular_velocity: s.Floats = ..., rotation: s.Floats = ...) -> WheelState:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WheelStateDict(TypedDict, total=False):
    """Members of wrc.WheelState as a dict."""
    reference: WheelReferenceLike
    orientation: OrientationLike
    angular_axes: AxesLike
    y: float
    z: float
    roll: float
    yaw: float
    velocity: s.Floats
    roll_rate: float
    pitch_rate: float
    yaw_rate: float
    angular_velocity: s.Floats
    rotation: s.Floats

class RailState(s.Struct):
    """Displacement and motion of a rail, track axes. Velocities are those of its material: a bent rail at rest
        has none, and speed * slope is never one. Its slopes say where it leads: it is turned about P, the
        shortest way, into (1, y_slope, z_slope). Sections of a rail are turned with it. A roller has no
        slopes.
    """
    y: float
    """y [m]: displacement of the origin of its profile to the right, at the wheel (-0.2 .. 0.2; default 0)
    """
    z: float
    """z [m]: the same downwards (-0.2 .. 0.2; default 0)"""
    roll: float
    """roll [rad]: rotation about that origin and the x axis (-0.5 .. 0.5; default 0)"""
    y_slope: float
    """y_slope: dy / dx of the rail at the wheel (-0.1 .. 0.1; default 0)"""
    z_slope: float
    """z_slope: dz / dx of the rail at the wheel (-0.1 .. 0.1; default 0)"""
    y_velocity: float
    """y_velocity [m/s]: of its material along y (-50 .. 50; default 0)"""
    z_velocity: float
    """z_velocity [m/s]: of its material along z (-50 .. 50; default 0)"""
    roll_rate: float
    """roll_rate [rad/s]: of its material about x (-200 .. 200; default 0)"""
    def __init__(self, *, y: float = ..., z: float = ..., roll: float = ..., y_slope: float = ..., z_slope: float = ..., y_velocity: float = ..., z_velocity: float = ..., roll_rate: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, y: float = ..., z: float = ..., roll: float = ..., y_slope: float = ..., z_slope: float = ..., y_velocity: float = ..., z_velocity: float = ..., roll_rate: float = ...) -> RailState:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class RailStateDict(TypedDict, total=False):
    """Members of wrc.RailState as a dict."""
    y: float
    z: float
    roll: float
    y_slope: float
    z_slope: float
    y_velocity: float
    z_velocity: float
    roll_rate: float

class FrameMotion(s.Struct):
    """How a frame moves that follows a curved track, for hosts whose velocities are those within it. Its origin
        is on the track centre line, level with the rails' tops. It turns at speed * (twist,
        vertical_curvature, curvature) about its axes. That motion is added to the wheel's. All zero:
        velocities are against the ground. Velocities of the rail always are.
    """
    speed: float
    """speed [m/s]: of its origin along the track (-200 .. 200; default 0)"""
    curvature: float
    """curvature [1/m]: of the track in plan, to the right (-0.1 .. 0.1; default 0)"""
    vertical_curvature: float
    """vertical_curvature [1/m]: of the track's height, upwards as in a dip (-0.1 .. 0.1; default 0)"""
    twist: float
    """twist [1/m]: rate of the cant over the speed, right side down (-0.5 .. 0.5; default 0)"""
    def __init__(self, *, speed: float = ..., curvature: float = ..., vertical_curvature: float = ..., twist: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, speed: float = ..., curvature: float = ..., vertical_curvature: float = ..., twist: float = ...) -> FrameMotion:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class FrameMotionDict(TypedDict, total=False):
    """Members of wrc.FrameMotion as a dict."""
    speed: float
    curvature: float
    vertical_curvature: float
    twist: float

class WheelInput(s.Struct):
    """Input of Contact.wrench(). Data behind its pointers belong to the caller and are only read during the
        call.
    """
    @property
    def prescribed(self) -> Prescribed:
        """prescribed: Prescribed: Prescribed.HEIGHT or _VERTICAL_LOAD (default Prescribed.HEIGHT)"""
    @prescribed.setter
    def prescribed(self, value: PrescribedLike) -> None: ...
    @property
    def start(self) -> Start:
        """start: Start (default Start.COLD)"""
    @start.setter
    def start(self, value: StartLike) -> None: ...
    wheel: WheelState
    """wheel: where the wheel is and how it moves"""
    rail: RailState
    """rail: where the rail is and how it moves"""
    frame: FrameMotion
    """frame: motion of the axes that velocities are given in"""
    friction: Friction
    """friction: of each strip at its own sliding speed; zones count from the origin of a profile"""
    vertical_load: float
    """vertical_load [N]: vertical force on the wheel, creep forces included, upwards positive (1e2 .. 1e6;
        default 0)
    """
    damping: float
    """damping [s/m]: factor of Hunt and Crossley: each strip's pressure is the elastic one times 1 + 3/2 damping
        d(overlap)/dt, never below 0 (0 .. 10; default 0)
    """
    distance: float
    """distance [m]: of the reference point along the track, for a rail with sections, or from above the axle of
        a roller (-1e7 .. 1e7; default 0)
    """
    angle: float
    """angle [rad]: of the wheel about its axle, for one with config.roundness, right-hand rule about y (-1e9 ..
        1e9; default 0)
    """
    roller_rate: float
    """roller_rate [rad/s]: angular velocity of a roller about its axle, right-hand rule about y (-2000 .. 2000;
        default 0)
    """
    time_step: float
    """time_step [s]: time since the step that Contact.commit() committed, over which the velocities act; of
        config.surface.memory (0 .. 1e6; default 0)
    """
    def __init__(self, *, prescribed: PrescribedLike = ..., start: StartLike = ..., wheel: Union[WheelState, WheelStateDict] = ..., rail: Union[RailState, RailStateDict] = ..., frame: Union[FrameMotion, FrameMotionDict] = ..., friction: Union[Friction, FrictionDict] = ..., vertical_load: float = ..., damping: float = ..., distance: float = ..., angle: float = ..., roller_rate: float = ..., time_step: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, prescribed: PrescribedLike = ..., start: StartLike = ..., wheel: Union[WheelState, WheelStateDict] = ..., rail: Union[RailState, RailStateDict] = ..., frame: Union[FrameMotion, FrameMotionDict] = ..., friction: Union[Friction, FrictionDict] = ..., vertical_load: float = ..., damping: float = ..., distance: float = ..., angle: float = ..., roller_rate: float = ..., time_step: float = ...) -> WheelInput:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WheelInputDict(TypedDict, total=False):
    """Members of wrc.WheelInput as a dict."""
    prescribed: PrescribedLike
    start: StartLike
    wheel: Union[WheelState, WheelStateDict]
    rail: Union[RailState, RailStateDict]
    frame: Union[FrameMotion, FrameMotionDict]
    friction: Union[Friction, FrictionDict]
    vertical_load: float
    damping: float
    distance: float
    angle: float
    roller_rate: float
    time_step: float

class Wrench(s.Struct):
    """Forces and moments between a wheel and its rail. All are zero but z and clearance where they do not touch.
    """
    @property
    def flags(self) -> Flags:
        """flags: bit 1 << flag for each WRC_FLAG_... met"""
    @flags.setter
    def flags(self, value: FlagsLike) -> None: ...
    region_count: int
    """region_count: separate regions in contact: Contact.region()"""
    iterations: int
    """iterations: of the normal problem, all of the call"""
    @property
    def force(self) -> NDArray[Any]:
        """force [N]: on the wheel, track axes"""
    @force.setter
    def force(self, value: s.Floats) -> None: ...
    @property
    def moment(self) -> NDArray[Any]:
        """moment [N m]: on the wheel about its reference point, track axes"""
    @moment.setter
    def moment(self, value: s.Floats) -> None: ...
    @property
    def rail_force(self) -> NDArray[Any]:
        """rail_force [N]: on the rail, track axes: -force"""
    @rail_force.setter
    def rail_force(self, value: s.Floats) -> None: ...
    @property
    def rail_moment(self) -> NDArray[Any]:
        """rail_moment [N m]: on the rail about the displaced origin of its profile, track axes"""
    @rail_moment.setter
    def rail_moment(self, value: s.Floats) -> None: ...
    z: float
    """z [m]: displacement of the reference point, as given or as found"""
    clearance: float
    """clearance [m]: apart, at a given height: by how much the wheel must be lowered to touch. 50e-3: that or
        more. Contact.exact_wrench() has 0
    """
    normal_force: float
    """normal_force [N]: sum over the regions of the resultants of their pressures. It steps where regions join
    """
    area: float
    """area [m^2]"""
    peak_pressure: float
    """peak_pressure [Pa]"""
    power: float
    """power [W]: frictional power, >= 0"""
    steepest_angle: float
    """steepest_angle [rad]: largest angle of a rail strip in contact against the horizontal. It steps where
        strips enter
    """
    residual: float
    """residual: part of the area that the last iteration of the normal problem moved: within
        config.surface.tolerance but for Status.FLAG_ITERATION_CAP. Of NormalMethod.STRIP_HALFSPACE
    """
    work: float
    """work: of the call, in the unit of config.surface.max_work"""
    def __init__(self, *, flags: FlagsLike = ..., region_count: int = ..., iterations: int = ..., force: s.Floats = ..., moment: s.Floats = ..., rail_force: s.Floats = ..., rail_moment: s.Floats = ..., z: float = ..., clearance: float = ..., normal_force: float = ..., area: float = ..., peak_pressure: float = ..., power: float = ..., steepest_angle: float = ..., residual: float = ..., work: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, flags: FlagsLike = ..., region_count: int = ..., iterations: int = ..., force: s.Floats = ..., moment: s.Floats = ..., rail_force: s.Floats = ..., rail_moment: s.Floats = ..., z: float = ..., clearance: float = ..., normal_force: float = ..., area: float = ..., peak_pressure: float = ..., power: float = ..., steepest_angle: float = ..., residual: float = ..., work: float = ...) -> Wrench:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WrenchDict(TypedDict, total=False):
    """Members of wrc.Wrench as a dict."""
    flags: FlagsLike
    region_count: int
    iterations: int
    force: s.Floats
    moment: s.Floats
    rail_force: s.Floats
    rail_moment: s.Floats
    z: float
    clearance: float
    normal_force: float
    area: float
    peak_pressure: float
    power: float
    steepest_angle: float
    residual: float
    work: float

class WrenchDerivatives(s.Struct):
    """Derivatives of the wrench on the wheel about its reference point. What is prescribed is held: under a
        given load the height follows all other inputs, and the column of z is zero.
    """
    @property
    def wrench(self) -> NDArray[Any]:
        """wrench: rows force x, y, z [N], moment x, y, z [N m]; columns WrenchInput, the rest 0"""
    @wrench.setter
    def wrench(self, value: s.Floats) -> None: ...
    @property
    def z(self) -> NDArray[Any]:
        """z: of Wrench.z; columns the same"""
    @z.setter
    def z(self, value: s.Floats) -> None: ...
    def __init__(self, *, wrench: s.Floats = ..., z: s.Floats = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, wrench: s.Floats = ..., z: s.Floats = ...) -> WrenchDerivatives:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WrenchDerivativesDict(TypedDict, total=False):
    """Members of wrc.WrenchDerivatives as a dict."""
    wrench: s.Floats
    z: s.Floats

class Creepage(s.Struct):
    """Rigid slip of the wheel over the rail per rolled length. At (x, y) of the contact plane it is
        (longitudinal - spin y, lateral + spin x). An amount below 1e-100 counts as 0.
    """
    longitudinal: float
    """longitudinal: nu_x (-10 .. 10; default 0)"""
    lateral: float
    """lateral: nu_y (-10 .. 10; default 0)"""
    spin: float
    """spin [1/m]: phi (-1000 .. 1000; default 0)"""
    speed: float
    """speed [m/s]: rolling speed V. Its sign says which edge leads, its amount scales power (-200 .. 200;
        default 1)
    """
    approach_velocity: float
    """approach_velocity [m/s]: result of Contact.planar_creepages(): of the wheel into the rail along the normal
    """
    reverse_share: float
    """reverse_share: share of the solution that rolls the other way: near standstill both are solved. A result
        of Contact.planar_creepages() (0 .. 0.5; default 0)
    """
    def __init__(self, *, longitudinal: float = ..., lateral: float = ..., spin: float = ..., speed: float = ..., approach_velocity: float = ..., reverse_share: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, longitudinal: float = ..., lateral: float = ..., spin: float = ..., speed: float = ..., approach_velocity: float = ..., reverse_share: float = ...) -> Creepage:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class CreepageDict(TypedDict, total=False):
    """Members of wrc.Creepage as a dict."""
    longitudinal: float
    lateral: float
    spin: float
    speed: float
    approach_velocity: float
    reverse_share: float

class Ellipse(s.Struct):
    """An equivalent double ellipse and its load: two half ellipses of equal length that meet at the joint.
    """
    a: float
    """a [m]: semi-axis along rolling (1e-6 .. 0.1; default 0)"""
    b: float
    """b [m]: half its width. It reaches from y - b (1 - psi) to y + b (1 + psi) (1e-6 .. 0.1; default 0)"""
    psi: float
    """psi: shape number; 0 is an ellipse; paper eq. 2 (-0.95 .. 0.95; default 0)"""
    y: float
    """y [m]: result: its joint, as Field.STRIP_Y"""
    normal_force: float
    """normal_force [N]: compressive positive, damping included (1e-3 .. 1e7; default 0)"""
    def __init__(self, *, a: float = ..., b: float = ..., psi: float = ..., y: float = ..., normal_force: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, a: float = ..., b: float = ..., psi: float = ..., y: float = ..., normal_force: float = ...) -> Ellipse:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class EllipseDict(TypedDict, total=False):
    """Members of wrc.Ellipse as a dict."""
    a: float
    b: float
    psi: float
    y: float
    normal_force: float

class Region(s.Struct):
    """One region of a wheel in contact, a run of neighbouring strips, or one patch of a contact plane. The
        wrench does not depend on where regions are divided.
    """
    @property
    def available(self) -> Available:
        """available: bits of Available; members without their bit are 0"""
    @available.setter
    def available(self, value: AvailableLike) -> None: ...
    strip_count: int
    """strip_count: number of its strips"""
    cell_count: int
    """cell_count: cells along each of them"""
    surface: int
    """surface: of the rail, as RailSection.surface. With a check rail 0 is that and 1 the rail"""
    @property
    def point(self) -> NDArray[Any]:
        """point [m]: wheel: centre of pressure, x from the reference point; plane: the ellipse's joint; track
            axes
        """
    @point.setter
    def point(self, value: s.Floats) -> None: ...
    @property
    def normal(self) -> NDArray[Any]:
        """normal: unit vector into the rail, track axes"""
    @normal.setter
    def normal(self, value: s.Floats) -> None: ...
    y_wheel: float
    """y_wheel [m]: that point in the coordinates of the wheel's profile, flange side negative"""
    z_wheel: float
    """z_wheel [m]: the same, down from the tape circle"""
    y_rail: float
    """y_rail [m]: that point in the coordinates of the rail's profile, field side positive"""
    z_rail: float
    """z_rail [m]: the same, down from the profile's origin"""
    angle: float
    """angle [rad]: contact angle about x from the track's z to the normal; < 0 on the right rail's gauge side
    """
    rolling_radius: float
    """rolling_radius [m]: of the wheel at that point"""
    @property
    def force(self) -> NDArray[Any]:
        """force [N]: on the wheel, track axes"""
    @force.setter
    def force(self, value: s.Floats) -> None: ...
    @property
    def moment(self) -> NDArray[Any]:
        """moment [N m]: on the wheel about point, track axes"""
    @moment.setter
    def moment(self, value: s.Floats) -> None: ...
    normal_force: float
    """normal_force [N]: resultant of the pressure, compressive positive"""
    longitudinal_force: float
    """longitudinal_force [N]: sum of the strips' tangential forces along x"""
    lateral_force: float
    """lateral_force [N]: sum of the strips' tangential forces across the rail, to the right"""
    spin_moment: float
    """spin_moment [N m]: of tractions about the normal. Wheel: through point; plane: through the origin of its
        frame
    """
    creepage: Creepage
    """creepage: wheel: means over the load; plane: as given"""
    ellipse: Ellipse
    """ellipse: its equivalent double ellipse, of a wheel laid flat along the rail's arc"""
    area: float
    """area [m^2]"""
    length: float
    """length [m]: extent along x: foremost to rearmost edge of all strips"""
    width: float
    """width [m]: extent across: y_max - y_min"""
    y_min: float
    """y_min [m]: border, as Field.STRIP_Y"""
    y_max: float
    """y_max [m]: see y_min"""
    peak_pressure: float
    """peak_pressure [Pa]"""
    power: float
    """power [W]: frictional power"""
    adhesion_fraction: float
    """adhesion_fraction: share of the area that sticks; Available.TRACTIONS"""
    def __init__(self, *, available: AvailableLike = ..., strip_count: int = ..., cell_count: int = ..., surface: int = ..., point: s.Floats = ..., normal: s.Floats = ..., y_wheel: float = ..., z_wheel: float = ..., y_rail: float = ..., z_rail: float = ..., angle: float = ..., rolling_radius: float = ..., force: s.Floats = ..., moment: s.Floats = ..., normal_force: float = ..., longitudinal_force: float = ..., lateral_force: float = ..., spin_moment: float = ..., creepage: Union[Creepage, CreepageDict] = ..., ellipse: Union[Ellipse, EllipseDict] = ..., area: float = ..., length: float = ..., width: float = ..., y_min: float = ..., y_max: float = ..., peak_pressure: float = ..., power: float = ..., adhesion_fraction: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, available: AvailableLike = ..., strip_count: int = ..., cell_count: int = ..., surface: int = ..., point: s.Floats = ..., normal: s.Floats = ..., y_wheel: float = ..., z_wheel: float = ..., y_rail: float = ..., z_rail: float = ..., angle: float = ..., rolling_radius: float = ..., force: s.Floats = ..., moment: s.Floats = ..., normal_force: float = ..., longitudinal_force: float = ..., lateral_force: float = ..., spin_moment: float = ..., creepage: Union[Creepage, CreepageDict] = ..., ellipse: Union[Ellipse, EllipseDict] = ..., area: float = ..., length: float = ..., width: float = ..., y_min: float = ..., y_max: float = ..., peak_pressure: float = ..., power: float = ..., adhesion_fraction: float = ...) -> Region:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class RegionDict(TypedDict, total=False):
    """Members of wrc.Region as a dict."""
    available: AvailableLike
    strip_count: int
    cell_count: int
    surface: int
    point: s.Floats
    normal: s.Floats
    y_wheel: float
    z_wheel: float
    y_rail: float
    z_rail: float
    angle: float
    rolling_radius: float
    force: s.Floats
    moment: s.Floats
    normal_force: float
    longitudinal_force: float
    lateral_force: float
    spin_moment: float
    creepage: Union[Creepage, CreepageDict]
    ellipse: Union[Ellipse, EllipseDict]
    area: float
    length: float
    width: float
    y_min: float
    y_max: float
    peak_pressure: float
    power: float
    adhesion_fraction: float

class Damage(s.Struct):
    """Wear and fatigue numbers of a region."""
    power: float
    """power [W]: frictional power"""
    peak_power_density: float
    """peak_power_density [W/m^2]: Available.TRACTIONS"""
    t_gamma: float
    """t_gamma [N]: power / speed: energy dissipated per metre rolled, spin included"""
    t_gamma_no_spin: float
    """t_gamma_no_spin [N]: |Fx nu_x + Fy nu_y|: the other definition in use"""
    utilisation: float
    """utilisation: mu_a = sqrt(Fx^2 + Fy^2) / N: abscissa of the shakedown map"""
    load_factor: float
    """load_factor: p0 / k: ordinate of the shakedown map"""
    shakedown_limit: float
    """shakedown_limit: of load_factor at mu_a, line contact; ratcheting above"""
    fatigue_index: float
    """fatigue_index: FI = mu_a - k / p0, paper eq. 11; damage when positive"""
    local_fatigue_index: float
    """local_fatigue_index: largest local index over the region, paper eq. 12; Available.TRACTIONS"""
    @property
    def available(self) -> Available:
        """available: bits of Available; members without their bit are 0"""
    @available.setter
    def available(self, value: AvailableLike) -> None: ...
    def __init__(self, *, power: float = ..., peak_power_density: float = ..., t_gamma: float = ..., t_gamma_no_spin: float = ..., utilisation: float = ..., load_factor: float = ..., shakedown_limit: float = ..., fatigue_index: float = ..., local_fatigue_index: float = ..., available: AvailableLike = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, power: float = ..., peak_power_density: float = ..., t_gamma: float = ..., t_gamma_no_spin: float = ..., utilisation: float = ..., load_factor: float = ..., shakedown_limit: float = ..., fatigue_index: float = ..., local_fatigue_index: float = ..., available: AvailableLike = ...) -> Damage:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class DamageDict(TypedDict, total=False):
    """Members of wrc.Damage as a dict."""
    power: float
    peak_power_density: float
    t_gamma: float
    t_gamma_no_spin: float
    utilisation: float
    load_factor: float
    shakedown_limit: float
    fatigue_index: float
    local_fatigue_index: float
    available: AvailableLike

class PlanarPose(s.Struct):
    """Pose of the wheelset, track frame. Its height follows from the load. An amount below 1e-100 counts as 0.
    """
    lateral: float
    """lateral [m]: shift of the wheelset to the right (-0.1 .. 0.1; default 0)"""
    roll: float
    """roll [rad]: about x, right wheel down (-0.2 .. 0.2; default 0)"""
    yaw: float
    """yaw [rad]: about the rolled z, nose to the right (-0.2 .. 0.2; default 0)"""
    def __init__(self, *, lateral: float = ..., roll: float = ..., yaw: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, lateral: float = ..., roll: float = ..., yaw: float = ...) -> PlanarPose:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarPoseDict(TypedDict, total=False):
    """Members of wrc.PlanarPose as a dict."""
    lateral: float
    roll: float
    yaw: float

class PlanarMotion(s.Struct):
    """Velocity of the wheelset relative to the track, track frame."""
    speed: float
    """speed [m/s]: of its middle along the track, backwards < 0 (-200 .. 200; default 0)"""
    lateral_velocity: float
    """lateral_velocity [m/s]: to the right (-20 .. 20; default 0)"""
    vertical_velocity: float
    """vertical_velocity [m/s]: down (-20 .. 20; default 0)"""
    roll_rate: float
    """roll_rate [rad/s]: about x (-100 .. 100; default 0)"""
    yaw_rate: float
    """yaw_rate [rad/s]: about z (-100 .. 100; default 0)"""
    pitch_rate: float
    """pitch_rate [rad/s]: about the axle, rolling forwards < 0 (-2000 .. 2000; default 0)"""
    def __init__(self, *, speed: float = ..., lateral_velocity: float = ..., vertical_velocity: float = ..., roll_rate: float = ..., yaw_rate: float = ..., pitch_rate: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, speed: float = ..., lateral_velocity: float = ..., vertical_velocity: float = ..., roll_rate: float = ..., yaw_rate: float = ..., pitch_rate: float = ...) -> PlanarMotion:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarMotionDict(TypedDict, total=False):
    """Members of wrc.PlanarMotion as a dict."""
    speed: float
    lateral_velocity: float
    vertical_velocity: float
    roll_rate: float
    yaw_rate: float
    pitch_rate: float

class PlanarPoint(s.Struct):
    """Where wheel and rail first touch when the wheelset of a pose is lowered."""
    x: float
    """x [m]: of the wheel's point, track frame"""
    y: float
    """y [m]: on the rail, track frame"""
    z: float
    """z [m]: see y"""
    y_wheel: float
    """y_wheel [m]: in the coordinates of the wheel profile, flange side negative"""
    y_rail: float
    """y_rail [m]: from the origin of the rail profile, after canting; field side positive"""
    angle: float
    """angle [rad]: contact angle: rotation about x from the track to the contact frame"""
    vertical_gap: float
    """vertical_gap [m]: height by which the wheel must be lowered, from its running circle level with the rail
        top
    """
    rolling_radius: float
    """rolling_radius [m]: of the wheel at the contact point"""
    def __init__(self, *, x: float = ..., y: float = ..., z: float = ..., y_wheel: float = ..., y_rail: float = ..., angle: float = ..., vertical_gap: float = ..., rolling_radius: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, x: float = ..., y: float = ..., z: float = ..., y_wheel: float = ..., y_rail: float = ..., angle: float = ..., vertical_gap: float = ..., rolling_radius: float = ...) -> PlanarPoint:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarPointDict(TypedDict, total=False):
    """Members of wrc.PlanarPoint as a dict."""
    x: float
    y: float
    z: float
    y_wheel: float
    y_rail: float
    angle: float
    vertical_gap: float
    rolling_radius: float

class PlanarGap(s.Struct):
    """The undeformed gap of a caller: rows along x at increasing y of the contact frame, along the normal. A
        constant offset does not matter. - column_count == 0: row j is height[j] + curvature[j]/2 (x -
        centre[j])^2 - column_count > 0: h[j * row_stride + i] at (x[i], y[j]). Each row is taken as the
        parabola fitted to its lowest part, up to config.planar.gap_limit / 4 above its minimum, with three
        points at least.
    """
    @property
    def row_count(self) -> int:
        """row_count: (4 .. config.planar.gap_rows; default 0)"""
    @property
    def column_count(self) -> int:
        """column_count: (0 or 3 .. 100000; default 0)"""
    @property
    def y(self) -> Optional[NDArray[np.float64]]:
        """y [m]: row_count of them, increasing by 1e-6 m at least (-0.3 .. 0.3; required)"""
    @y.setter
    def y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def height(self) -> Optional[NDArray[np.float64]]:
        """height [m]: row_count of them, smallest gap of the row (-0.3 .. 0.3; required)"""
    @height.setter
    def height(self, value: Optional[s.Floats]) -> None: ...
    @property
    def centre(self) -> Optional[NDArray[np.float64]]:
        """centre [m]: row_count of them, x of that smallest gap; None: zero (-0.3 .. 0.3; default None)"""
    @centre.setter
    def centre(self, value: Optional[s.Floats]) -> None: ...
    @property
    def curvature(self) -> Optional[NDArray[np.float64]]:
        """curvature [1/m]: row_count of them, d2h/dx2. 1 / rolling radius on a straight rail (1e-3 .. 1e6;
            required)
        """
    @curvature.setter
    def curvature(self, value: Optional[s.Floats]) -> None: ...
    @property
    def x(self) -> Optional[NDArray[np.float64]]:
        """x [m]: column_count of them, increasing by 1e-6 m at least (-0.3 .. 0.3; required)"""
    @x.setter
    def x(self, value: Optional[s.Floats]) -> None: ...
    @property
    def h(self) -> Optional[NDArray[np.float64]]:
        """h [m]: gap of each element (-0.3 .. 0.3; required)"""
    @h.setter
    def h(self, value: Optional[s.Floats]) -> None: ...
    row_stride: int
    """row_stride: elements from one row of h to the next, >= column_count (default 0)"""
    def __init__(self, *, y: Optional[s.Floats] = ..., height: Optional[s.Floats] = ..., centre: Optional[s.Floats] = ..., curvature: Optional[s.Floats] = ..., x: Optional[s.Floats] = ..., h: Optional[s.Floats] = ..., row_stride: int = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, y: Optional[s.Floats] = ..., height: Optional[s.Floats] = ..., centre: Optional[s.Floats] = ..., curvature: Optional[s.Floats] = ..., x: Optional[s.Floats] = ..., h: Optional[s.Floats] = ..., row_stride: int = ...) -> PlanarGap:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarGapDict(TypedDict, total=False):
    """Members of wrc.PlanarGap as a dict."""
    y: Optional[s.Floats]
    height: Optional[s.Floats]
    centre: Optional[s.Floats]
    curvature: Optional[s.Floats]
    x: Optional[s.Floats]
    h: Optional[s.Floats]
    row_stride: int

class PlanarLoad(s.Struct):
    """Load that presses the bodies together. Damping is that of Hunt and Crossley, J. Appl. Mech. 42 (1975)
        440-445: every pressure is the elastic one times 1 + 3/2 damping * approach_velocity, never below 0.
        An impact at v m/s rebounds with about (1 - damping v) of its velocity.
    """
    @property
    def prescribed(self) -> Prescribed:
        """prescribed: Prescribed: Prescribed.NORMAL_FORCE or _APPROACH (default Prescribed.NORMAL_FORCE)"""
    @prescribed.setter
    def prescribed(self, value: PrescribedLike) -> None: ...
    normal_force: float
    """normal_force [N]: along the contact normal (1e2 .. 1e6; default 0)"""
    approach: float
    """approach [m]: beyond first touch; <= 0: no contact (-1 .. 0.01; default 0)"""
    approach_velocity: float
    """approach_velocity [m/s]: d approach / dt; positive while the bodies near each other (-20 .. 20; default 0)
    """
    damping: float
    """damping [s/m]: factor of Hunt and Crossley; 0: none (0 .. 10; default 0)"""
    def __init__(self, *, prescribed: PrescribedLike = ..., normal_force: float = ..., approach: float = ..., approach_velocity: float = ..., damping: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, prescribed: PrescribedLike = ..., normal_force: float = ..., approach: float = ..., approach_velocity: float = ..., damping: float = ...) -> PlanarLoad:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarLoadDict(TypedDict, total=False):
    """Members of wrc.PlanarLoad as a dict."""
    prescribed: PrescribedLike
    normal_force: float
    approach: float
    approach_velocity: float
    damping: float

class PlanarStrips(s.Struct):
    """A pressure distribution of the caller: strips along x with semi-elliptic pressure."""
    @property
    def count(self) -> int:
        """count: number of strips (1 .. config.planar.strips; default 0)"""
    @property
    def y(self) -> Optional[NDArray[np.float64]]:
        """y [m]: middle, count of them, increasing; strips do not overlap (-0.3 .. 0.3; required)"""
    @y.setter
    def y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def width(self) -> Optional[NDArray[np.float64]]:
        """width [m]: count of them (1e-9 .. 0.1; required)"""
    @width.setter
    def width(self, value: Optional[s.Floats]) -> None: ...
    @property
    def centre(self) -> Optional[NDArray[np.float64]]:
        """centre [m]: x of the middle, count of them; None: zero (-0.3 .. 0.3; default None)"""
    @centre.setter
    def centre(self, value: Optional[s.Floats]) -> None: ...
    @property
    def half_length(self) -> Optional[NDArray[np.float64]]:
        """half_length [m]: count of them (1e-9 .. 0.1; required)"""
    @half_length.setter
    def half_length(self, value: Optional[s.Floats]) -> None: ...
    @property
    def peak(self) -> Optional[NDArray[np.float64]]:
        """peak [Pa]: peak pressure, count of them (0 .. 1e11; required)"""
    @peak.setter
    def peak(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, y: Optional[s.Floats] = ..., width: Optional[s.Floats] = ..., centre: Optional[s.Floats] = ..., half_length: Optional[s.Floats] = ..., peak: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, y: Optional[s.Floats] = ..., width: Optional[s.Floats] = ..., centre: Optional[s.Floats] = ..., half_length: Optional[s.Floats] = ..., peak: Optional[s.Floats] = ...) -> PlanarStrips:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarStripsDict(TypedDict, total=False):
    """Members of wrc.PlanarStrips as a dict."""
    y: Optional[s.Floats]
    width: Optional[s.Floats]
    centre: Optional[s.Floats]
    half_length: Optional[s.Floats]
    peak: Optional[s.Floats]

class PlanarNormalSolution(s.Struct):
    """Solution of the normal problem, all patches together."""
    patch_count: int
    """patch_count: separate patches: Contact.region() has each"""
    strip_count: int
    """strip_count: strips under pressure"""
    iterations: int
    """iterations: of the load search, or sweeps"""
    @property
    def flags(self) -> Flags:
        """flags: bit 1 << flag for each WRC_FLAG_... met"""
    @flags.setter
    def flags(self, value: FlagsLike) -> None: ...
    ellipse: Ellipse
    """ellipse: of the patch that carries most"""
    normal_force: float
    """normal_force [N]: compressive positive, damping included"""
    damping_force: float
    """damping_force [N]: share of normal_force that is damping; < 0 while the bodies part"""
    approach: float
    """approach [m]: beyond first touch, along the normal; 0 for an ellipse or strips of the caller"""
    stiffness: float
    """stiffness [N/m]: d normal_force / d approach; of STRIP_HALFSPACE and ANALYN within 6 %"""
    peak_pressure: float
    """peak_pressure [Pa]: largest pressure as solved, not of the equivalent ellipse"""
    area: float
    """area [m^2]"""
    length: float
    """length [m]: extent along x: foremost to rearmost edge of all strips"""
    width: float
    """width [m]: extent along y: y_max - y_min"""
    y_min: float
    """y_min [m]: lateral border"""
    y_max: float
    """y_max [m]: see y_min"""
    def __init__(self, *, patch_count: int = ..., strip_count: int = ..., iterations: int = ..., flags: FlagsLike = ..., ellipse: Union[Ellipse, EllipseDict] = ..., normal_force: float = ..., damping_force: float = ..., approach: float = ..., stiffness: float = ..., peak_pressure: float = ..., area: float = ..., length: float = ..., width: float = ..., y_min: float = ..., y_max: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, patch_count: int = ..., strip_count: int = ..., iterations: int = ..., flags: FlagsLike = ..., ellipse: Union[Ellipse, EllipseDict] = ..., normal_force: float = ..., damping_force: float = ..., approach: float = ..., stiffness: float = ..., peak_pressure: float = ..., area: float = ..., length: float = ..., width: float = ..., y_min: float = ..., y_max: float = ...) -> PlanarNormalSolution:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarNormalSolutionDict(TypedDict, total=False):
    """Members of wrc.PlanarNormalSolution as a dict."""
    patch_count: int
    strip_count: int
    iterations: int
    flags: FlagsLike
    ellipse: Union[Ellipse, EllipseDict]
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

class PlanarForces(s.Struct):
    """Forces on the wheel in the contact frame, moment about its origin."""
    fx: float
    """fx [N]: longitudinal creep force"""
    fy: float
    """fy [N]: lateral creep force"""
    fn: float
    """fn [N]: normal force, compressive positive, damping included"""
    mz: float
    """mz [N m]: spin moment"""
    power: float
    """power [W]: frictional power at the given speed, >= 0"""
    adhesion_fraction: float
    """adhesion_fraction: share of the patch's area that sticks; Available.TRACTIONS"""
    @property
    def available(self) -> Available:
        """available: bits of Available; members without their bit are 0"""
    @available.setter
    def available(self, value: AvailableLike) -> None: ...
    @property
    def flags(self) -> Flags:
        """flags: bit 1 << flag for each WRC_FLAG_... met"""
    @flags.setter
    def flags(self, value: FlagsLike) -> None: ...
    def __init__(self, *, fx: float = ..., fy: float = ..., fn: float = ..., mz: float = ..., power: float = ..., adhesion_fraction: float = ..., available: AvailableLike = ..., flags: FlagsLike = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, fx: float = ..., fy: float = ..., fn: float = ..., mz: float = ..., power: float = ..., adhesion_fraction: float = ..., available: AvailableLike = ..., flags: FlagsLike = ...) -> PlanarForces:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarForcesDict(TypedDict, total=False):
    """Members of wrc.PlanarForces as a dict."""
    fx: float
    fy: float
    fn: float
    mz: float
    power: float
    adhesion_fraction: float
    available: AvailableLike
    flags: FlagsLike

class PlanarDerivatives(s.Struct):
    """Derivatives of the forces of the last Contact.planar_tangential() at its patch."""
    @property
    def forces(self) -> NDArray[Any]:
        """forces: rows fx, fy [N], mz [N m]; columns longitudinal, lateral [-], spin [1/m], normal_force [N] of
            the same patch, factor on friction [-], the rest 0
        """
    @forces.setter
    def forces(self, value: s.Floats) -> None: ...
    def __init__(self, *, forces: s.Floats = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, forces: s.Floats = ...) -> PlanarDerivatives:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarDerivativesDict(TypedDict, total=False):
    """Members of wrc.PlanarDerivatives as a dict."""
    forces: s.Floats

class PlanarInput(s.Struct):
    """Input of Contact.planar_step(). Data behind its pointers belong to the caller and are only read during the
        call.
    """
    pose: PlanarPose
    """pose: of the wheelset; not used with gap, but within its ranges"""
    gap: Optional[PlanarGap]
    """gap: a gap of the caller in place of the pose; None: the pose (default None)"""
    load: PlanarLoad
    """load: load that presses the bodies together"""
    creepage: Creepage
    """creepage: rigid slip at the origin of the contact frame"""
    friction: Friction
    """friction: between the bodies"""
    def __init__(self, *, pose: Union[PlanarPose, PlanarPoseDict] = ..., gap: Optional[PlanarGap] = ..., load: Union[PlanarLoad, PlanarLoadDict] = ..., creepage: Union[Creepage, CreepageDict] = ..., friction: Union[Friction, FrictionDict] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, pose: Union[PlanarPose, PlanarPoseDict] = ..., gap: Optional[PlanarGap] = ..., load: Union[PlanarLoad, PlanarLoadDict] = ..., creepage: Union[Creepage, CreepageDict] = ..., friction: Union[Friction, FrictionDict] = ...) -> PlanarInput:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarInputDict(TypedDict, total=False):
    """Members of wrc.PlanarInput as a dict."""
    pose: Union[PlanarPose, PlanarPoseDict]
    gap: Optional[PlanarGap]
    load: Union[PlanarLoad, PlanarLoadDict]
    creepage: Union[Creepage, CreepageDict]
    friction: Union[Friction, FrictionDict]

class PlanarOutput(s.Struct):
    """Results of Contact.planar_step()."""
    @property
    def flags(self) -> Flags:
        """flags: bit 1 << flag for each WRC_FLAG_... met, of all stages"""
    @flags.setter
    def flags(self, value: FlagsLike) -> None: ...
    point: PlanarPoint
    """point: zero when there was no pose"""
    normal: PlanarNormalSolution
    """normal: of the normal stage"""
    forces: PlanarForces
    """forces: of the tangential stage"""
    damage: Damage
    """damage: of all patches together"""
    def __init__(self, *, flags: FlagsLike = ..., point: Union[PlanarPoint, PlanarPointDict] = ..., normal: Union[PlanarNormalSolution, PlanarNormalSolutionDict] = ..., forces: Union[PlanarForces, PlanarForcesDict] = ..., damage: Union[Damage, DamageDict] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, flags: FlagsLike = ..., point: Union[PlanarPoint, PlanarPointDict] = ..., normal: Union[PlanarNormalSolution, PlanarNormalSolutionDict] = ..., forces: Union[PlanarForces, PlanarForcesDict] = ..., damage: Union[Damage, DamageDict] = ...) -> PlanarOutput:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class PlanarOutputDict(TypedDict, total=False):
    """Members of wrc.PlanarOutput as a dict."""
    flags: FlagsLike
    point: Union[PlanarPoint, PlanarPointDict]
    normal: Union[PlanarNormalSolution, PlanarNormalSolutionDict]
    forces: Union[PlanarForces, PlanarForcesDict]
    damage: Union[Damage, DamageDict]

class WearLaws(s.Struct):
    """Parameters of the wear laws. Defaults are the published values, in their published units; all are
        unconfirmed (quoted from memory, not checked against the original texts) and depend on the pair of
        steels. Theory manual, section 6. - T-gamma: area lost per metre rolled (Pearce and Sherratt, Wear 144
        (1991)), over the wheel's diameter. - Sheffield: depth per metre rolled from T-gamma per area (R8T
        wheel on UIC60 900A; Braghin et al. 2006). - Archard: depth per second, k p v / hardness with the map
        of Jendel (Wear 253 (2002)). - Power law: depth per second, power_coefficient / density * q (q /
        power_reference)^(power_exponent - 1), q the frictional power density. With exponent 1 mass is worn in
        proportion to energy: the mild regime of Zobory (VSD 28 (1997)), which ends at 4 W/mm^2.
    """
    t_gamma_mild_end: float
    """t_gamma_mild_end [N]: T-gamma up to which wear is mild (1e-3 .. 1e9; default 100)"""
    t_gamma_severe_start: float
    """t_gamma_severe_start [N]: T-gamma from which it is severe, not below t_gamma_mild_end (1e-3 .. 1e9;
        default 200)
    """
    t_gamma_mild_slope: float
    """t_gamma_mild_slope [mm^3/(km N)]: area * diameter per T-gamma, mild (0 .. 1e6; default 0.25)"""
    t_gamma_plateau: float
    """t_gamma_plateau [mm^3/km]: area * diameter between the two (0 .. 1e9; default 25)"""
    t_gamma_severe_slope: float
    """t_gamma_severe_slope [mm^3/(km N)]: as t_gamma_mild_slope, severe (0 .. 1e6; default 1.19)"""
    t_gamma_severe_offset: float
    """t_gamma_severe_offset [mm^3/km]: subtracted in the severe regime; the law must not turn negative (0 ..
        1e15; default 154)
    """
    sheffield_mild_end: float
    """sheffield_mild_end [N/mm^2]: T-gamma per area up to which wear is mild (1e-6 .. 1e9; default 10.4)"""
    sheffield_severe_end: float
    """sheffield_severe_end [N/mm^2]: T-gamma per area from which it is catastrophic, not below
        sheffield_mild_end (1e-6 .. 1e9; default 77.2)
    """
    sheffield_mild_slope: float
    """sheffield_mild_slope [microgram/(m N)]: rate per T-gamma per area, mild (0 .. 1e6; default 5.3)"""
    sheffield_catastrophic_slope: float
    """sheffield_catastrophic_slope [microgram/(m N)]: the same, catastrophic (0 .. 1e6; default 61.9)"""
    density: float
    """density [kg/m^3]: of the worn material (100 .. 1e5; default 7850)"""
    hardness: float
    """hardness [Pa]: of the softer body (1e6 .. 1e12; default 3e9)"""
    archard_slow: float
    """archard_slow: coefficient below archard_severe_start (0 .. 1; default 5e-4)"""
    archard_severe: float
    """archard_severe: coefficient between the two speeds (0 .. 1; default 35e-4)"""
    archard_fast: float
    """archard_fast: coefficient above archard_severe_end (0 .. 1; default 5e-4)"""
    archard_seizure: float
    """archard_seizure: coefficient where pressure exceeds seizure_pressure * hardness (0 .. 1; default 350e-4)
    """
    archard_severe_start: float
    """archard_severe_start [m/s]: sliding velocity from which wear is severe (0 .. 1000; default 0.2)"""
    archard_severe_end: float
    """archard_severe_end [m/s]: sliding velocity up to which it is severe, not below archard_severe_start (0 ..
        1000; default 0.7)
    """
    seizure_pressure: float
    """seizure_pressure: share of the hardness (0 .. 1000; default 0.8)"""
    power_coefficient: float
    """power_coefficient [kg/J]: mass worn per energy at power_reference (0 .. 1; default 7e-10)"""
    power_exponent: float
    """power_exponent: of the frictional power density (0.25 .. 4; default 1)"""
    power_reference: float
    """power_reference [W/m^2]: power density at which power_coefficient holds (1 .. 1e12; default 4e6)"""
    def __init__(self, *, t_gamma_mild_end: float = ..., t_gamma_severe_start: float = ..., t_gamma_mild_slope: float = ..., t_gamma_plateau: float = ..., t_gamma_severe_slope: float = ..., t_gamma_severe_offset: float = ..., sheffield_mild_end: float = ..., sheffield_severe_end: float = ..., sheffield_mild_slope: float = ..., sheffield_catastrophic_slope: float = ..., density: float = ..., hardness: float = ..., archard_slow: float = ..., archard_severe: float = ..., archard_fast: float = ..., archard_seizure: float = ..., archard_severe_start: float = ..., archard_severe_end: float = ..., seizure_pressure: float = ..., power_coefficient: float = ..., power_exponent: float = ..., power_reference: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, t_gamma_mild_end: float = ..., t_gamma_severe_start: float = ..., t_gamma_mild_slope: float = ..., t_gamma_plateau: float = ..., t_gamma_severe_slope: float = ..., t_gamma_severe_offset: float = ..., sheffield_mild_end: float = ..., sheffield_severe_end: float = ..., sheffield_mild_slope: float = ..., sheffield_catastrophic_slope: float = ..., density: float = ..., hardness: float = ..., archard_slow: float = ..., archard_severe: float = ..., archard_fast: float = ..., archard_seizure: float = ..., archard_severe_start: float = ..., archard_severe_end: float = ..., seizure_pressure: float = ..., power_coefficient: float = ..., power_exponent: float = ..., power_reference: float = ...) -> WearLaws:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WearLawsDict(TypedDict, total=False):
    """Members of wrc.WearLaws as a dict."""
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

class Wear(s.Struct):
    """Wear of one region."""
    worn_area_rate: float
    """worn_area_rate [m^2/m]: T-gamma law: area lost from the wheel's section per metre rolled"""
    largest_depth_rate: float
    """largest_depth_rate [m/m]: Sheffield: depth per metre rolled of the worst cell"""
    largest_depth_velocity: float
    """largest_depth_velocity [m/s]: Archard: depth per second in contact of the worst cell"""
    largest_power_depth_velocity: float
    """largest_power_depth_velocity [m/s]: power law: the same"""
    def __init__(self, *, worn_area_rate: float = ..., largest_depth_rate: float = ..., largest_depth_velocity: float = ..., largest_power_depth_velocity: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, worn_area_rate: float = ..., largest_depth_rate: float = ..., largest_depth_velocity: float = ..., largest_power_depth_velocity: float = ...) -> Wear:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WearDict(TypedDict, total=False):
    """Members of wrc.Wear as a dict."""
    worn_area_rate: float
    largest_depth_rate: float
    largest_depth_velocity: float
    largest_power_depth_velocity: float

class Coefficients(s.Struct):
    """Coefficients of the linear theory for one patch shape (theory manual, section 4)."""
    c11: float
    """c11: Kalker's, for the ellipse a, b"""
    c22: float
    """c22: see c11"""
    c23: float
    """c23: see c11"""
    c11s: float
    """c11s: of the double ellipse, about its joint; paper eq. 5"""
    c13s: float
    """c13s: see c11s"""
    c22s: float
    """c22s: see c11s"""
    c23s: float
    """c23s: see c11s"""
    def __init__(self, *, c11: float = ..., c22: float = ..., c23: float = ..., c11s: float = ..., c13s: float = ..., c22s: float = ..., c23s: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, c11: float = ..., c22: float = ..., c23: float = ..., c11s: float = ..., c13s: float = ..., c22s: float = ..., c23s: float = ...) -> Coefficients:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class CoefficientsDict(TypedDict, total=False):
    """Members of wrc.Coefficients as a dict."""
    c11: float
    c22: float
    c23: float
    c11s: float
    c13s: float
    c22s: float
    c23s: float

class StressPeak(s.Struct):
    """A stress that is the largest of its kind, and where in the body it is: contact frame, but for the depth.
    """
    stress: float
    """stress [Pa]"""
    x: float
    """x [m]: contact frame"""
    y: float
    """y [m]: see x"""
    depth: float
    """depth [m]: below the body's surface"""
    def __init__(self, *, stress: float = ..., x: float = ..., y: float = ..., depth: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, stress: float = ..., x: float = ..., y: float = ..., depth: float = ...) -> StressPeak:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class StressPeakDict(TypedDict, total=False):
    """Members of wrc.StressPeak as a dict."""
    stress: float
    x: float
    y: float
    depth: float

class StressPeaks(s.Struct):
    """Largest stresses in a body, each at its own place."""
    von_mises: StressPeak
    """von_mises: sqrt(3 J2)"""
    shear: StressPeak
    """shear: (s1 - s3) / 2: half of Tresca's stress"""
    tension: StressPeak
    """tension: s1, the most tensile principal stress; < 0 where all three are compressive"""
    def __init__(self, *, von_mises: Union[StressPeak, StressPeakDict] = ..., shear: Union[StressPeak, StressPeakDict] = ..., tension: Union[StressPeak, StressPeakDict] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, von_mises: Union[StressPeak, StressPeakDict] = ..., shear: Union[StressPeak, StressPeakDict] = ..., tension: Union[StressPeak, StressPeakDict] = ...) -> StressPeaks:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class StressPeaksDict(TypedDict, total=False):
    """Members of wrc.StressPeaks as a dict."""
    von_mises: Union[StressPeak, StressPeakDict]
    shear: Union[StressPeak, StressPeakDict]
    tension: Union[StressPeak, StressPeakDict]

class Stresses(s.Struct):
    """Stresses in one of the bodies as a whole."""
    @property
    def body(self) -> Body:
        """body: Body: which"""
    @body.setter
    def body(self, value: BodyLike) -> None: ...
    largest: StressPeaks
    """largest: of the two that follow"""
    surface: StressPeaks
    """surface: at the surface"""
    below: StressPeaks
    """below: beneath it"""
    def __init__(self, *, body: BodyLike = ..., largest: Union[StressPeaks, StressPeaksDict] = ..., surface: Union[StressPeaks, StressPeaksDict] = ..., below: Union[StressPeaks, StressPeaksDict] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, body: BodyLike = ..., largest: Union[StressPeaks, StressPeaksDict] = ..., surface: Union[StressPeaks, StressPeaksDict] = ..., below: Union[StressPeaks, StressPeaksDict] = ...) -> Stresses:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class StressesDict(TypedDict, total=False):
    """Members of wrc.Stresses as a dict."""
    body: BodyLike
    largest: Union[StressPeaks, StressPeaksDict]
    surface: Union[StressPeaks, StressPeaksDict]
    below: Union[StressPeaks, StressPeaksDict]

class Temperature(s.Struct):
    """Temperatures in the contact. Wheel and rail have the same where they touch."""
    at_entry: float
    """at_entry [degC]: of both surfaces as soon as they touch, between those of the bodies"""
    rise: float
    """rise [K]: the largest by friction over that, of all cells"""
    x: float
    """x [m]: where: contact frame, the middle of the cell"""
    y: float
    """y [m]: see x"""
    largest: float
    """largest [degC]: at_entry + rise"""
    mean_rise: float
    """mean_rise [K]: over the contact's area"""
    wheel_heat: float
    """wheel_heat [W]: that flows into the wheel, of friction and of the bodies' touching"""
    rail_heat: float
    """rail_heat [W]: the same of the rail; both together are the frictional power"""
    def __init__(self, *, at_entry: float = ..., rise: float = ..., x: float = ..., y: float = ..., largest: float = ..., mean_rise: float = ..., wheel_heat: float = ..., rail_heat: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, at_entry: float = ..., rise: float = ..., x: float = ..., y: float = ..., largest: float = ..., mean_rise: float = ..., wheel_heat: float = ..., rail_heat: float = ...) -> Temperature:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class TemperatureDict(TypedDict, total=False):
    """Members of wrc.Temperature as a dict."""
    at_entry: float
    rise: float
    x: float
    y: float
    largest: float
    mean_rise: float
    wheel_heat: float
    rail_heat: float

class DamageBin(s.Struct):
    """One bin: all zero, nothing was added. Bits are the same whatever the order of additions and merges."""
    @property
    def sum(self) -> NDArray[Any]:
        """sum: by DamageQuantity: low and high half of an integer of 128 bits, two's complement. Bins.values()
            converts it
        """
    @sum.setter
    def sum(self, value: s.Floats) -> None: ...
    largest_pressure: float
    """largest_pressure [Pa]"""
    largest_traction: float
    """largest_traction [Pa]"""
    overflow: int
    """overflow: bit i: sum i, or a contribution to it, passed its range and is worthless"""
    def __init__(self, *, sum: s.Floats = ..., largest_pressure: float = ..., largest_traction: float = ..., overflow: int = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, sum: s.Floats = ..., largest_pressure: float = ..., largest_traction: float = ..., overflow: int = ...) -> DamageBin:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class DamageBinDict(TypedDict, total=False):
    """Members of wrc.DamageBin as a dict."""
    sum: s.Floats
    largest_pressure: float
    largest_traction: float
    overflow: int

class DamageBins(s.Struct):
    """Bins over the arc length of a profile, 0 at its origin, flange or gauge side negative; of a rail also in
        rows along the track.
    """
    count: int
    """count: bins of a row (1 .. 1000000; default 0)"""
    first: float
    """first [m]: arc length at which the first begins (-1 .. 1; default 0)"""
    width: float
    """width [m]: of a bin (1e-5 .. 1; default 1e-3)"""
    row_count: int
    """row_count: rows along the track; row_count * count 100000000 at most (1 .. 1000000; default 1)"""
    row_first: float
    """row_first [m]: distance at which the first row begins (-1e9 .. 1e9; default 0)"""
    row_length: float
    """row_length [m]: of a row; 0: one row takes all, whatever the distance (0 or 1e-3 .. 1e9; default 0)"""
    bins: Optional[DamageBin]
    """bins: row_count * count + 1 of the caller, row by row, zeroed before the first use. The last has what lies
        beside all others. They may be copied and saved as bytes
    """
    def __init__(self, *, count: int = ..., first: float = ..., width: float = ..., row_count: int = ..., row_first: float = ..., row_length: float = ..., bins: Optional[DamageBin] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, count: int = ..., first: float = ..., width: float = ..., row_count: int = ..., row_first: float = ..., row_length: float = ..., bins: Optional[DamageBin] = ...) -> DamageBins:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class DamageBinsDict(TypedDict, total=False):
    """Members of wrc.DamageBins as a dict."""
    count: int
    first: float
    width: float
    row_count: int
    row_first: float
    row_length: float
    bins: Optional[DamageBin]

class FatigueLaws(s.Struct):
    """Damage of rolling contact fatigue by T-gamma: the Whole Life Rail Model. Zero up to start, rising straight
        to peak at peak_at, falling straight through zero at end and on below it, where wear wins. For R220
        and R260 steel; Burstow, RSSB T115 (2004); quoted from memory, unconfirmed. The direction of the creep
        force, by which the model tells cracks that open, is left to the caller.
    """
    whole_life_start: float
    """whole_life_start [N]: T-gamma from which cracks start (0 .. 1e6; default 15)"""
    whole_life_peak_at: float
    """whole_life_peak_at [N]: T-gamma of the largest damage, above whole_life_start (1e-3 .. 1e6; default 65)
    """
    whole_life_end: float
    """whole_life_end [N]: T-gamma at which wear takes as much as cracks grow, above whole_life_peak_at (1e-3 ..
        1e6; default 175)
    """
    whole_life_peak: float
    """whole_life_peak: damage of a passage at whole_life_peak_at; 1 is a crack (0 .. 1; default 1e-5)"""
    def __init__(self, *, whole_life_start: float = ..., whole_life_peak_at: float = ..., whole_life_end: float = ..., whole_life_peak: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, whole_life_start: float = ..., whole_life_peak_at: float = ..., whole_life_end: float = ..., whole_life_peak: float = ...) -> FatigueLaws:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class FatigueLawsDict(TypedDict, total=False):
    """Members of wrc.FatigueLaws as a dict."""
    whole_life_start: float
    whole_life_peak_at: float
    whole_life_end: float
    whole_life_peak: float

class Accumulation(s.Struct):
    """Input of Contact.accumulate()."""
    duration: float
    """duration [s]: for which the results hold (0 .. 1e6; default 0)"""
    distance: float
    """distance [m]: along the track where that begins; read where a row of bins has a length (-1e9 .. 1e9;
        default 0)
    """
    wear: Optional[WearLaws]
    """wear: None: the published ones (default None)"""
    fatigue: Optional[FatigueLaws]
    """fatigue: None: the published ones (default None)"""
    def __init__(self, *, duration: float = ..., distance: float = ..., wear: Optional[WearLaws] = ..., fatigue: Optional[FatigueLaws] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, duration: float = ..., distance: float = ..., wear: Optional[WearLaws] = ..., fatigue: Optional[FatigueLaws] = ...) -> Accumulation:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class AccumulationDict(TypedDict, total=False):
    """Members of wrc.Accumulation as a dict."""
    duration: float
    distance: float
    wear: Optional[WearLaws]
    fatigue: Optional[FatigueLaws]

class DamageTotals(s.Struct):
    """Amounts that one Contact.accumulate() added to each of its sets of bins."""
    @property
    def sum(self) -> NDArray[Any]:
        """sum: by DamageQuantity, units there"""
    @sum.setter
    def sum(self, value: s.Floats) -> None: ...
    largest_pressure: float
    """largest_pressure [Pa]"""
    largest_traction: float
    """largest_traction [Pa]"""
    def __init__(self, *, sum: s.Floats = ..., largest_pressure: float = ..., largest_traction: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, sum: s.Floats = ..., largest_pressure: float = ..., largest_traction: float = ...) -> DamageTotals:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class DamageTotalsDict(TypedDict, total=False):
    """Members of wrc.DamageTotals as a dict."""
    sum: s.Floats
    largest_pressure: float
    largest_traction: float

class Grid(s.Struct):
    """A rectangular grid in the contact frame."""
    nx: int
    """nx: cells along x (4 .. 1024; default 0)"""
    ny: int
    """ny: cells along y (4 .. 1024; default 0)"""
    dx: float
    """dx [m]: size of a cell (1e-7 .. 0.01; default 0)"""
    dy: float
    """dy [m]: see dx (1e-7 .. 0.01; default 0)"""
    x0: float
    """x0 [m]: centre of cell (0, 0) (-1 .. 1; default 0)"""
    y0: float
    """y0 [m]: see x0 (-1 .. 1; default 0)"""
    def __init__(self, *, nx: int = ..., ny: int = ..., dx: float = ..., dy: float = ..., x0: float = ..., y0: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, nx: int = ..., ny: int = ..., dx: float = ..., dy: float = ..., x0: float = ..., y0: float = ...) -> Grid:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class GridDict(TypedDict, total=False):
    """Members of wrc.Grid as a dict."""
    nx: int
    ny: int
    dx: float
    dy: float
    x0: float
    y0: float

class ExactNormalProblem(s.Struct):
    """The normal problem: an undeformed gap and what presses the bodies together."""
    @property
    def prescribed(self) -> Prescribed:
        """prescribed: Prescribed: Prescribed.NORMAL_FORCE or _APPROACH (default Prescribed.NORMAL_FORCE)"""
    @prescribed.setter
    def prescribed(self, value: PrescribedLike) -> None: ...
    max_iterations: int
    """max_iterations: (1 .. 100000; default 1000)"""
    normal_force: float
    """normal_force [N]: with Prescribed.NORMAL_FORCE; must be set (1e-3 .. 1e7; default 0)"""
    approach: float
    """approach [m]: beyond the zero of the gap with Prescribed.APPROACH (-1 .. 0.01; default 0)"""
    tolerance: float
    """tolerance: of overlap and separation, relative to the largest displacement (1e-14 .. 0.1; default 1e-6)
    """
    wheel_material: Material
    """wheel_material: elastic, of the wheel"""
    rail_material: Material
    """rail_material: elastic, of the rail"""
    grid: Grid
    """grid: cells of gap and pressure"""
    @property
    def gap(self) -> Optional[NDArray[np.float64]]:
        """gap [m]: nx * ny (-1 .. 1; required)"""
    @gap.setter
    def gap(self, value: Optional[s.Floats]) -> None: ...
    progress: Any
    """progress: None: none (default None)"""
    user: Any
    """user: handed to progress (default None)"""
    def __init__(self, *, prescribed: PrescribedLike = ..., max_iterations: int = ..., normal_force: float = ..., approach: float = ..., tolerance: float = ..., wheel_material: Union[Material, MaterialDict] = ..., rail_material: Union[Material, MaterialDict] = ..., grid: Union[Grid, GridDict] = ..., gap: Optional[s.Floats] = ..., progress: Any = ..., user: Any = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, prescribed: PrescribedLike = ..., max_iterations: int = ..., normal_force: float = ..., approach: float = ..., tolerance: float = ..., wheel_material: Union[Material, MaterialDict] = ..., rail_material: Union[Material, MaterialDict] = ..., grid: Union[Grid, GridDict] = ..., gap: Optional[s.Floats] = ..., progress: Any = ..., user: Any = ...) -> ExactNormalProblem:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ExactNormalProblemDict(TypedDict, total=False):
    """Members of wrc.ExactNormalProblem as a dict."""
    prescribed: PrescribedLike
    max_iterations: int
    normal_force: float
    approach: float
    tolerance: float
    wheel_material: Union[Material, MaterialDict]
    rail_material: Union[Material, MaterialDict]
    grid: Union[Grid, GridDict]
    gap: Optional[s.Floats]
    progress: Any
    user: Any

class ExactNormalSolution(s.Struct):
    """Solution of the normal problem."""
    iterations: int
    """iterations: of the conjugate gradients"""
    @property
    def flags(self) -> Flags:
        """flags: bit 1 << flag for each WRC_FLAG_... met"""
    @flags.setter
    def flags(self, value: FlagsLike) -> None: ...
    approach: float
    """approach [m]: beyond the zero of the gap"""
    normal_force: float
    """normal_force [N]"""
    peak_pressure: float
    """peak_pressure [Pa]"""
    area: float
    """area [m^2]: of the cells under pressure"""
    residual: float
    """residual: of the convergence test"""
    @property
    def pressure(self) -> Optional[NDArray[np.float64]]:
        """pressure [Pa]: the caller's nx * ny; None: not wanted; set before the call"""
    @pressure.setter
    def pressure(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, iterations: int = ..., flags: FlagsLike = ..., approach: float = ..., normal_force: float = ..., peak_pressure: float = ..., area: float = ..., residual: float = ..., pressure: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, iterations: int = ..., flags: FlagsLike = ..., approach: float = ..., normal_force: float = ..., peak_pressure: float = ..., area: float = ..., residual: float = ..., pressure: Optional[s.Floats] = ...) -> ExactNormalSolution:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ExactNormalSolutionDict(TypedDict, total=False):
    """Members of wrc.ExactNormalSolution as a dict."""
    iterations: int
    flags: FlagsLike
    approach: float
    normal_force: float
    peak_pressure: float
    area: float
    residual: float
    pressure: Optional[s.Floats]

class ExactRollingProblem(s.Struct):
    """Steady rolling under a given normal pressure."""
    @property
    def adhesion(self) -> Adhesion:
        """adhesion: Adhesion (default Adhesion.COULOMB)"""
    @adhesion.setter
    def adhesion(self, value: AdhesionLike) -> None: ...
    @property
    def collocation(self) -> Collocation:
        """collocation: Collocation (default Collocation.QUARTER_POINT)"""
    @collocation.setter
    def collocation(self, value: CollocationLike) -> None: ...
    max_iterations: int
    """max_iterations: of Newton's method (1 .. 1000; default 60)"""
    tolerance: float
    """tolerance: of the traction law (1e-12 .. 0.1; default 1e-4)"""
    wheel_material: Material
    """wheel_material: elastic, of the wheel"""
    rail_material: Material
    """rail_material: elastic, of the rail"""
    grid: Grid
    """grid: cells of pressure, friction and tractions"""
    @property
    def pressure(self) -> Optional[NDArray[np.float64]]:
        """pressure [Pa]: nx * ny; cells above zero are the contact, all others are not (-1e11 .. 1e11; required)
        """
    @pressure.setter
    def pressure(self, value: Optional[s.Floats]) -> None: ...
    @property
    def friction(self) -> Optional[NDArray[np.float64]]:
        """friction: nx * ny; None: coefficient everywhere (1e-4 .. 2; default None)"""
    @friction.setter
    def friction(self, value: Optional[s.Floats]) -> None: ...
    coefficient: float
    """coefficient: Coulomb with Adhesion.COULOMB and friction None (1e-4 .. 2; default 0.3)"""
    creepage: Creepage
    """creepage: about the origin of the contact frame"""
    progress: Any
    """progress: called between grids and iterations; None: none (default None)"""
    user: Any
    """user: handed to progress (default None)"""
    layer_thickness: float
    """layer_thickness [m]: of an elasto-plastic layer, as in Friction; steady rolling alone (0 .. 0.01; default
        0)
    """
    layer_modulus: float
    """layer_modulus [Pa]: of that layer in shear; goes with a thickness (0 or 1e3 .. 1e12; default 0)"""
    layer_yield: float
    """layer_yield [Pa]: traction at which fresh layer yields; Adhesion.COULOMB alone (0 or 1e3 .. 1e11; default
        0)
    """
    layer_hardening: float
    """layer_hardening [Pa/m]: rise of that traction over the length of plastic flow (-1e13 .. 1e14; default 0)
    """
    def __init__(self, *, adhesion: AdhesionLike = ..., collocation: CollocationLike = ..., max_iterations: int = ..., tolerance: float = ..., wheel_material: Union[Material, MaterialDict] = ..., rail_material: Union[Material, MaterialDict] = ..., grid: Union[Grid, GridDict] = ..., pressure: Optional[s.Floats] = ..., friction: Optional[s.Floats] = ..., coefficient: float = ..., creepage: Union[Creepage, CreepageDict] = ..., progress: Any = ..., user: Any = ..., layer_thickness: float = ..., layer_modulus: float = ..., layer_yield: float = ..., layer_hardening: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, adhesion: AdhesionLike = ..., collocation: CollocationLike = ..., max_iterations: int = ..., tolerance: float = ..., wheel_material: Union[Material, MaterialDict] = ..., rail_material: Union[Material, MaterialDict] = ..., grid: Union[Grid, GridDict] = ..., pressure: Optional[s.Floats] = ..., friction: Optional[s.Floats] = ..., coefficient: float = ..., creepage: Union[Creepage, CreepageDict] = ..., progress: Any = ..., user: Any = ..., layer_thickness: float = ..., layer_modulus: float = ..., layer_yield: float = ..., layer_hardening: float = ...) -> ExactRollingProblem:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ExactRollingProblemDict(TypedDict, total=False):
    """Members of wrc.ExactRollingProblem as a dict."""
    adhesion: AdhesionLike
    collocation: CollocationLike
    max_iterations: int
    tolerance: float
    wheel_material: Union[Material, MaterialDict]
    rail_material: Union[Material, MaterialDict]
    grid: Union[Grid, GridDict]
    pressure: Optional[s.Floats]
    friction: Optional[s.Floats]
    coefficient: float
    creepage: Union[Creepage, CreepageDict]
    progress: Any
    user: Any
    layer_thickness: float
    layer_modulus: float
    layer_yield: float
    layer_hardening: float

class ExactRollingSolution(s.Struct):
    """Solution of steady rolling: forces and tractions on the wheel."""
    iterations: int
    """iterations: of Newton's method on the given grid"""
    @property
    def flags(self) -> Flags:
        """flags: bit 1 << flag for each WRC_FLAG_... met"""
    @flags.setter
    def flags(self, value: FlagsLike) -> None: ...
    fx: float
    """fx [N]"""
    fy: float
    """fy [N]: see fx"""
    mz: float
    """mz [N m]: about the origin of the contact frame"""
    power: float
    """power [W]: sum of slip times traction over the cells, times the speed"""
    power_by_balance: float
    """power_by_balance [W]: -(Fx nu_x + Fy nu_y + Mz phi) V: the limit of power on fine grids"""
    adhesion_fraction: float
    """adhesion_fraction: share of the contact's area that sticks"""
    residual: float
    """residual: of the convergence test"""
    @property
    def traction_x(self) -> Optional[NDArray[np.float64]]:
        """traction_x [Pa]: the caller's nx * ny; None: not wanted; so are those below"""
    @traction_x.setter
    def traction_x(self, value: Optional[s.Floats]) -> None: ...
    @property
    def traction_y(self) -> Optional[NDArray[np.float64]]:
        """traction_y [Pa]"""
    @traction_y.setter
    def traction_y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def slip_x(self) -> Optional[NDArray[np.float64]]:
        """slip_x: sliding velocity / rolling speed"""
    @slip_x.setter
    def slip_x(self, value: Optional[s.Floats]) -> None: ...
    @property
    def slip_y(self) -> Optional[NDArray[np.float64]]:
        """slip_y"""
    @slip_y.setter
    def slip_y(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, iterations: int = ..., flags: FlagsLike = ..., fx: float = ..., fy: float = ..., mz: float = ..., power: float = ..., power_by_balance: float = ..., adhesion_fraction: float = ..., residual: float = ..., traction_x: Optional[s.Floats] = ..., traction_y: Optional[s.Floats] = ..., slip_x: Optional[s.Floats] = ..., slip_y: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, iterations: int = ..., flags: FlagsLike = ..., fx: float = ..., fy: float = ..., mz: float = ..., power: float = ..., power_by_balance: float = ..., adhesion_fraction: float = ..., residual: float = ..., traction_x: Optional[s.Floats] = ..., traction_y: Optional[s.Floats] = ..., slip_x: Optional[s.Floats] = ..., slip_y: Optional[s.Floats] = ...) -> ExactRollingSolution:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ExactRollingSolutionDict(TypedDict, total=False):
    """Members of wrc.ExactRollingSolution as a dict."""
    iterations: int
    flags: FlagsLike
    fx: float
    fy: float
    mz: float
    power: float
    power_by_balance: float
    adhesion_fraction: float
    residual: float
    traction_x: Optional[s.Floats]
    traction_y: Optional[s.Floats]
    slip_x: Optional[s.Floats]
    slip_y: Optional[s.Floats]

class ExactLoads(s.Struct):
    """Pressure and tractions on one of the bodies, constant on each cell of a grid."""
    @property
    def body(self) -> Body:
        """body: Body: in which the stresses are wanted (default Body.RAIL)"""
    @body.setter
    def body(self, value: BodyLike) -> None: ...
    poisson: float
    """poisson: nu of that body (0 .. 0.5; default 0.28)"""
    grid: Grid
    """grid: cells of pressure and tractions"""
    @property
    def pressure(self) -> Optional[NDArray[np.float64]]:
        """pressure [Pa]: nx * ny (-1e11 .. 1e11; required)"""
    @pressure.setter
    def pressure(self, value: Optional[s.Floats]) -> None: ...
    @property
    def traction_x(self) -> Optional[NDArray[np.float64]]:
        """traction_x [Pa]: nx * ny, on the wheel as solutions have it, whichever the body; None: none (-1e11 ..
            1e11; default None)
        """
    @traction_x.setter
    def traction_x(self, value: Optional[s.Floats]) -> None: ...
    @property
    def traction_y(self) -> Optional[NDArray[np.float64]]:
        """traction_y [Pa]: nx * ny, the same along y; None: none (-1e11 .. 1e11; default None)"""
    @traction_y.setter
    def traction_y(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, body: BodyLike = ..., poisson: float = ..., grid: Union[Grid, GridDict] = ..., pressure: Optional[s.Floats] = ..., traction_x: Optional[s.Floats] = ..., traction_y: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, body: BodyLike = ..., poisson: float = ..., grid: Union[Grid, GridDict] = ..., pressure: Optional[s.Floats] = ..., traction_x: Optional[s.Floats] = ..., traction_y: Optional[s.Floats] = ...) -> ExactLoads:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ExactLoadsDict(TypedDict, total=False):
    """Members of wrc.ExactLoads as a dict."""
    body: BodyLike
    poisson: float
    grid: Union[Grid, GridDict]
    pressure: Optional[s.Floats]
    traction_x: Optional[s.Floats]
    traction_y: Optional[s.Floats]

class ExactWrenchOptions(s.Struct):
    """How finely a wheel on a rail is solved exactly."""
    @property
    def collocation(self) -> Collocation:
        """collocation: Collocation (default Collocation.QUARTER_POINT)"""
    @collocation.setter
    def collocation(self, value: CollocationLike) -> None: ...
    @property
    def influence(self) -> SurfaceInfluence:
        """influence: SurfaceInfluence (default SurfaceInfluence.TURNED)"""
    @influence.setter
    def influence(self, value: SurfaceInfluenceLike) -> None: ...
    cell_x: float
    """cell_x [m]: length of a cell along x (2e-5 .. 2e-3; default 2e-4)"""
    cell_s: float
    """cell_s [m]: the same along the rail's arc length (2e-5 .. 2e-3; default 2e-4)"""
    progress: Any
    """progress: called while heights are tried and both problems solved in turn; None: none (default None)
    """
    user: Any
    """user: handed to progress (default None)"""
    def __init__(self, *, collocation: CollocationLike = ..., influence: SurfaceInfluenceLike = ..., cell_x: float = ..., cell_s: float = ..., progress: Any = ..., user: Any = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, collocation: CollocationLike = ..., influence: SurfaceInfluenceLike = ..., cell_x: float = ..., cell_s: float = ..., progress: Any = ..., user: Any = ...) -> ExactWrenchOptions:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ExactWrenchOptionsDict(TypedDict, total=False):
    """Members of wrc.ExactWrenchOptions as a dict."""
    collocation: CollocationLike
    influence: SurfaceInfluenceLike
    cell_x: float
    cell_s: float
    progress: Any
    user: Any

class ExactCheckOptions(s.Struct):
    """How finely a contact is checked."""
    nx: int
    """nx: cells along x (8 .. 512; default 64)"""
    ny: int
    """ny: cells along y (8 .. 512; default 64)"""
    progress: Any
    """progress: None: none (default None)"""
    user: Any
    """user: handed to progress (default None)"""
    def __init__(self, *, nx: int = ..., ny: int = ..., progress: Any = ..., user: Any = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, nx: int = ..., ny: int = ..., progress: Any = ..., user: Any = ...) -> ExactCheckOptions:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ExactCheckOptionsDict(TypedDict, total=False):
    """Members of wrc.ExactCheckOptions as a dict."""
    nx: int
    ny: int
    progress: Any
    user: Any

class ExactCheckResult(s.Struct):
    """A real-time result against the exact one."""
    @property
    def flags(self) -> Flags:
        """flags: bit 1 << flag for each WRC_FLAG_... met"""
    @flags.setter
    def flags(self, value: FlagsLike) -> None: ...
    fx: float
    """fx [N]: exact, on the contact's own pressure and creepages"""
    fy: float
    """fy [N]: see fx"""
    mz: float
    """mz [N m]: the same"""
    power: float
    """power [W]: exact, by the energy balance"""
    adhesion_fraction: float
    """adhesion_fraction: exact"""
    force_error: float
    """force_error: |F - F_exact| / (friction * N)"""
    power_error: float
    """power_error: P / P_exact - 1; 0 when nothing is dissipated"""
    def __init__(self, *, flags: FlagsLike = ..., fx: float = ..., fy: float = ..., mz: float = ..., power: float = ..., adhesion_fraction: float = ..., force_error: float = ..., power_error: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, flags: FlagsLike = ..., fx: float = ..., fy: float = ..., mz: float = ..., power: float = ..., adhesion_fraction: float = ..., force_error: float = ..., power_error: float = ...) -> ExactCheckResult:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ExactCheckResultDict(TypedDict, total=False):
    """Members of wrc.ExactCheckResult as a dict."""
    flags: FlagsLike
    fx: float
    fy: float
    mz: float
    power: float
    adhesion_fraction: float
    force_error: float
    power_error: float

class CreepCurve(s.Struct):
    """A measured curve of adhesion over slip, and the law to be fitted to it."""
    @property
    def count(self) -> int:
        """count: number of points, at least three more than parameters (4 .. 100000; default 0)"""
    @property
    def slip(self) -> Optional[NDArray[np.float64]]:
        """slip: count of them: amount of the longitudinal creepage (1e-7 .. 1; required)"""
    @slip.setter
    def slip(self, value: Optional[s.Floats]) -> None: ...
    @property
    def adhesion(self) -> Optional[NDArray[np.float64]]:
        """adhesion: count of them: longitudinal force over load, against the slip positive (-0.2 .. 2; required)
        """
    @adhesion.setter
    def adhesion(self, value: Optional[s.Floats]) -> None: ...
    @property
    def speed(self) -> Optional[NDArray[np.float64]]:
        """speed [m/s]: count of them: rolling speed (1e-3 .. 200; required)"""
    @speed.setter
    def speed(self, value: Optional[s.Floats]) -> None: ...
    @property
    def load(self) -> Optional[NDArray[np.float64]]:
        """load [N]: count of them: load of the wheel (1 .. 1e7; required)"""
    @load.setter
    def load(self, value: Optional[s.Floats]) -> None: ...
    ellipse: Ellipse
    """ellipse: the patch under ellipse.normal_force. Its axes grow with the cube root of the load (Hertz)"""
    friction: Friction
    """friction: the law, without zones and temperatures. The fit begins with its values and keeps those of other
        parameters
    """
    parameters: int
    """parameters: bit 1 << parameter for each CreepParameter to be found (1 .. 1023; default 1)"""
    @property
    def scatter(self) -> Scatter:
        """scatter: Scatter (default Scatter.RELATIVE)"""
    @scatter.setter
    def scatter(self, value: ScatterLike) -> None: ...
    max_iterations: int
    """max_iterations: cap on the iterations of the fit (1 .. 1000; default 100)"""
    progress: Any
    """progress: called between iterations; None: none (default None)"""
    user: Any
    """user: handed to progress (default None)"""
    def __init__(self, *, slip: Optional[s.Floats] = ..., adhesion: Optional[s.Floats] = ..., speed: Optional[s.Floats] = ..., load: Optional[s.Floats] = ..., ellipse: Union[Ellipse, EllipseDict] = ..., friction: Union[Friction, FrictionDict] = ..., parameters: int = ..., scatter: ScatterLike = ..., max_iterations: int = ..., progress: Any = ..., user: Any = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, slip: Optional[s.Floats] = ..., adhesion: Optional[s.Floats] = ..., speed: Optional[s.Floats] = ..., load: Optional[s.Floats] = ..., ellipse: Union[Ellipse, EllipseDict] = ..., friction: Union[Friction, FrictionDict] = ..., parameters: int = ..., scatter: ScatterLike = ..., max_iterations: int = ..., progress: Any = ..., user: Any = ...) -> CreepCurve:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class CreepCurveDict(TypedDict, total=False):
    """Members of wrc.CreepCurve as a dict."""
    slip: Optional[s.Floats]
    adhesion: Optional[s.Floats]
    speed: Optional[s.Floats]
    load: Optional[s.Floats]
    ellipse: Union[Ellipse, EllipseDict]
    friction: Union[Friction, FrictionDict]
    parameters: int
    scatter: ScatterLike
    max_iterations: int
    progress: Any
    user: Any

class CreepFit(s.Struct):
    """The law that fits best, and how far the curve determines it. Arrays are over CreepParameter, with 0 for
        parameters that were not to be found.
    """
    @property
    def flags(self) -> Flags:
        """flags: bit 1 << flag for each WRC_FLAG_... met"""
    @flags.setter
    def flags(self, value: FlagsLike) -> None: ...
    iterations: int
    """iterations: of the fit"""
    undetermined: int
    """undetermined: bits of parameters that the curve does not determine: any value fits, or only a combination
        of several is determined. Their deviation is infinite, their interval the whole range
    """
    at_limit: int
    """at_limit: bits of parameters that ended at the end of their range"""
    scatter: float
    """scatter: standard deviation of the measured points from the law: relative, or of the adhesion"""
    friction: Friction
    """friction: the law that fits best"""
    @property
    def value(self) -> NDArray[Any]:
        """value: value that fits best, in the unit of the parameter"""
    @value.setter
    def value(self, value: s.Floats) -> None: ...
    @property
    def deviation(self) -> NDArray[Any]:
        """deviation: standard deviation of that value, in the same unit"""
    @deviation.setter
    def deviation(self, value: s.Floats) -> None: ...
    @property
    def low(self) -> NDArray[Any]:
        """low: lower end of the interval that holds the true value with 95 %"""
    @low.setter
    def low(self, value: s.Floats) -> None: ...
    @property
    def high(self) -> NDArray[Any]:
        """high: its upper end"""
    @high.setter
    def high(self, value: s.Floats) -> None: ...
    @property
    def covariance(self) -> NDArray[Any]:
        """covariance: of the values; 0 of undetermined ones"""
    @covariance.setter
    def covariance(self, value: s.Floats) -> None: ...
    def __init__(self, *, flags: FlagsLike = ..., iterations: int = ..., undetermined: int = ..., at_limit: int = ..., scatter: float = ..., friction: Union[Friction, FrictionDict] = ..., value: s.Floats = ..., deviation: s.Floats = ..., low: s.Floats = ..., high: s.Floats = ..., covariance: s.Floats = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, flags: FlagsLike = ..., iterations: int = ..., undetermined: int = ..., at_limit: int = ..., scatter: float = ..., friction: Union[Friction, FrictionDict] = ..., value: s.Floats = ..., deviation: s.Floats = ..., low: s.Floats = ..., high: s.Floats = ..., covariance: s.Floats = ...) -> CreepFit:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class CreepFitDict(TypedDict, total=False):
    """Members of wrc.CreepFit as a dict."""
    flags: FlagsLike
    iterations: int
    undetermined: int
    at_limit: int
    scatter: float
    friction: Union[Friction, FrictionDict]
    value: s.Floats
    deviation: s.Floats
    low: s.Floats
    high: s.Floats
    covariance: s.Floats

class WheelsetGeometryProblem(s.Struct):
    """Lateral displacements and load for contact functions."""
    @property
    def count(self) -> int:
        """count: lateral displacements (1 .. 100000; default 0)"""
    @property
    def lateral(self) -> Optional[NDArray[np.float64]]:
        """lateral [m]: of the wheelset, to the right, count of them (-0.1 .. 0.1; required)"""
    @lateral.setter
    def lateral(self, value: Optional[s.Floats]) -> None: ...
    wheel_load: float
    """wheel_load [N]: vertical, of each wheel; 0: the undeformed bodies touch in one point on either side, as EN
        15302 has it, and the functions jump where that point does; a load: elastic, without friction, all
        contacts weighted by what they carry, continuous; needs NormalMethod.STRIP_HALFSPACE (0 or 1e3 .. 1e6;
        default 0)
    """
    def __init__(self, *, lateral: Optional[s.Floats] = ..., wheel_load: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, lateral: Optional[s.Floats] = ..., wheel_load: float = ...) -> WheelsetGeometryProblem:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WheelsetGeometryProblemDict(TypedDict, total=False):
    """Members of wrc.WheelsetGeometryProblem as a dict."""
    lateral: Optional[s.Floats]
    wheel_load: float

class WheelsetGeometry(s.Struct):
    """Contact functions over the lateral displacement: arrays of the caller, count elements each; None: not
        wanted; set before the call. Coordinates of profiles are those of Profile, right and left alike.
    """
    @property
    def vertical(self) -> Optional[NDArray[np.float64]]:
        """vertical [m]: displacement of the wheelset's middle downwards"""
    @vertical.setter
    def vertical(self, value: Optional[s.Floats]) -> None: ...
    @property
    def roll(self) -> Optional[NDArray[np.float64]]:
        """roll [rad]: of the wheelset about the track's x, right wheel down positive"""
    @roll.setter
    def roll(self, value: Optional[s.Floats]) -> None: ...
    @property
    def radius_difference(self) -> Optional[NDArray[np.float64]]:
        """radius_difference [m]: rolling radius of the right wheel less that of the left"""
    @radius_difference.setter
    def radius_difference(self, value: Optional[s.Floats]) -> None: ...
    @property
    def radius_right(self) -> Optional[NDArray[np.float64]]:
        """radius_right [m]: rolling radius"""
    @radius_right.setter
    def radius_right(self, value: Optional[s.Floats]) -> None: ...
    @property
    def radius_left(self) -> Optional[NDArray[np.float64]]:
        """radius_left [m]: see radius_right"""
    @radius_left.setter
    def radius_left(self, value: Optional[s.Floats]) -> None: ...
    @property
    def angle_right(self) -> Optional[NDArray[np.float64]]:
        """angle_right [rad]: contact angle against the track's plane, the roll included; positive where the
            surface rises towards the flange of the rail's gauge side
        """
    @angle_right.setter
    def angle_right(self, value: Optional[s.Floats]) -> None: ...
    @property
    def angle_left(self) -> Optional[NDArray[np.float64]]:
        """angle_left [rad]: see angle_right"""
    @angle_left.setter
    def angle_left(self, value: Optional[s.Floats]) -> None: ...
    @property
    def y_wheel_right(self) -> Optional[NDArray[np.float64]]:
        """y_wheel_right [m]: contact on the wheel's profile, flange side negative"""
    @y_wheel_right.setter
    def y_wheel_right(self, value: Optional[s.Floats]) -> None: ...
    @property
    def y_wheel_left(self) -> Optional[NDArray[np.float64]]:
        """y_wheel_left [m]: see y_wheel_right"""
    @y_wheel_left.setter
    def y_wheel_left(self, value: Optional[s.Floats]) -> None: ...
    @property
    def y_rail_right(self) -> Optional[NDArray[np.float64]]:
        """y_rail_right [m]: contact on the rail's profile, field side positive"""
    @y_rail_right.setter
    def y_rail_right(self, value: Optional[s.Floats]) -> None: ...
    @property
    def y_rail_left(self) -> Optional[NDArray[np.float64]]:
        """y_rail_left [m]: see y_rail_right"""
    @y_rail_left.setter
    def y_rail_left(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, vertical: Optional[s.Floats] = ..., roll: Optional[s.Floats] = ..., radius_difference: Optional[s.Floats] = ..., radius_right: Optional[s.Floats] = ..., radius_left: Optional[s.Floats] = ..., angle_right: Optional[s.Floats] = ..., angle_left: Optional[s.Floats] = ..., y_wheel_right: Optional[s.Floats] = ..., y_wheel_left: Optional[s.Floats] = ..., y_rail_right: Optional[s.Floats] = ..., y_rail_left: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, vertical: Optional[s.Floats] = ..., roll: Optional[s.Floats] = ..., radius_difference: Optional[s.Floats] = ..., radius_right: Optional[s.Floats] = ..., radius_left: Optional[s.Floats] = ..., angle_right: Optional[s.Floats] = ..., angle_left: Optional[s.Floats] = ..., y_wheel_right: Optional[s.Floats] = ..., y_wheel_left: Optional[s.Floats] = ..., y_rail_right: Optional[s.Floats] = ..., y_rail_left: Optional[s.Floats] = ...) -> WheelsetGeometry:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WheelsetGeometryDict(TypedDict, total=False):
    """Members of wrc.WheelsetGeometry as a dict."""
    vertical: Optional[s.Floats]
    roll: Optional[s.Floats]
    radius_difference: Optional[s.Floats]
    radius_right: Optional[s.Floats]
    radius_left: Optional[s.Floats]
    angle_right: Optional[s.Floats]
    angle_left: Optional[s.Floats]
    y_wheel_right: Optional[s.Floats]
    y_wheel_left: Optional[s.Floats]
    y_rail_right: Optional[s.Floats]
    y_rail_left: Optional[s.Floats]

class ConicityProblem(s.Struct):
    """A rolling radius difference over the lateral displacement, straight between its points, and what to make
        of it.
    """
    @property
    def method(self) -> ConicityMethod:
        """method: ConicityMethod (default ConicityMethod.WAVELENGTH)"""
    @method.setter
    def method(self, value: ConicityMethodLike) -> None: ...
    @property
    def count(self) -> int:
        """count: points (3 .. 100000; default 0)"""
    @property
    def amplitude_count(self) -> int:
        """amplitude_count: (1 .. 100000; default 0)"""
    @property
    def lateral(self) -> Optional[NDArray[np.float64]]:
        """lateral [m]: of the wheelset, increasing, count of them (-0.1 .. 0.1; required)"""
    @lateral.setter
    def lateral(self, value: Optional[s.Floats]) -> None: ...
    @property
    def radius_difference(self) -> Optional[NDArray[np.float64]]:
        """radius_difference [m]: right less left, count of them (-0.2 .. 0.2; required)"""
    @radius_difference.setter
    def radius_difference(self, value: Optional[s.Floats]) -> None: ...
    @property
    def amplitudes(self) -> Optional[NDArray[np.float64]]:
        """amplitudes [m]: half the way from one side to the other, amplitude_count of them (1e-6 .. 0.1;
            required)
        """
    @amplitudes.setter
    def amplitudes(self, value: Optional[s.Floats]) -> None: ...
    contact_distance: float
    """contact_distance [m]: e: between the contact points of both wheels (0.3 .. 3; default 1.5)"""
    radius: float
    """radius [m]: r0: nominal, of the wheels (0.05 .. 3; default 0.46)"""
    def __init__(self, *, method: ConicityMethodLike = ..., lateral: Optional[s.Floats] = ..., radius_difference: Optional[s.Floats] = ..., amplitudes: Optional[s.Floats] = ..., contact_distance: float = ..., radius: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, method: ConicityMethodLike = ..., lateral: Optional[s.Floats] = ..., radius_difference: Optional[s.Floats] = ..., amplitudes: Optional[s.Floats] = ..., contact_distance: float = ..., radius: float = ...) -> ConicityProblem:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConicityProblemDict(TypedDict, total=False):
    """Members of wrc.ConicityProblem as a dict."""
    method: ConicityMethodLike
    lateral: Optional[s.Floats]
    radius_difference: Optional[s.Floats]
    amplitudes: Optional[s.Floats]
    contact_distance: float
    radius: float

class Conicity(s.Struct):
    """Equivalent conicity over the amplitude: arrays of the caller, amplitude_count elements each; None: not
        wanted; set before the call.
    """
    @property
    def conicity(self) -> Optional[NDArray[np.float64]]:
        """conicity: tan gamma_e; 0 where a wheelset left to itself does not swing with this amplitude"""
    @conicity.setter
    def conicity(self, value: Optional[s.Floats]) -> None: ...
    @property
    def wavelength(self) -> Optional[NDArray[np.float64]]:
        """wavelength [m]: of the kinematic motion: by Klingel's formula from the conicity of a regression; 0
            where there is none
        """
    @wavelength.setter
    def wavelength(self, value: Optional[s.Floats]) -> None: ...
    @property
    def centre(self) -> Optional[NDArray[np.float64]]:
        """centre [m]: middle between the two ends of the motion"""
    @centre.setter
    def centre(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, conicity: Optional[s.Floats] = ..., wavelength: Optional[s.Floats] = ..., centre: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, conicity: Optional[s.Floats] = ..., wavelength: Optional[s.Floats] = ..., centre: Optional[s.Floats] = ...) -> Conicity:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ConicityDict(TypedDict, total=False):
    """Members of wrc.Conicity as a dict."""
    conicity: Optional[s.Floats]
    wavelength: Optional[s.Floats]
    centre: Optional[s.Floats]

class ProfileWear(s.Struct):
    """Wear of a profile, to be taken off."""
    @property
    def body(self) -> Body:
        """body: Body: which side of the curve is steel (default Body.WHEEL)"""
    @body.setter
    def body(self, value: BodyLike) -> None: ...
    @property
    def count(self) -> int:
        """count: points (4 .. 20000; default 0)"""
    @property
    def bin_count(self) -> int:
        """bin_count: bins of the depth (1 .. 1000000; default 0)"""
    @property
    def y(self) -> Optional[NDArray[np.float64]]:
        """y [m]: points as in Profile, count of them (-1 .. 1; required)"""
    @y.setter
    def y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def z(self) -> Optional[NDArray[np.float64]]:
        """z [m]: see y (-1 .. 1; required)"""
    @z.setter
    def z(self, value: Optional[s.Floats]) -> None: ...
    @property
    def depth(self) -> Optional[NDArray[np.float64]]:
        """depth [m]: along the normal, of each bin for one passage, bin_count of them (0 .. 0.1; required)"""
    @depth.setter
    def depth(self, value: Optional[s.Floats]) -> None: ...
    first: float
    """first [m]: arc length at which the first bin begins, 0 at y = 0 (-1 .. 1; default 0)"""
    width: float
    """width [m]: of a bin (1e-5 .. 1; default 1e-3)"""
    passages: float
    """passages: wanted (0 .. 1e12; default 1)"""
    largest_depth: float
    """largest_depth [m]: most that is taken off in one step (1e-9 .. 1e-2; default 1e-4)"""
    smoothing: float
    """smoothing [m]: waves of the depth of this length along the curve keep half their height; 0: as it is (0 ..
        0.05; default 5e-3)
    """
    spacing: float
    """spacing [m]: of the new points along the curve (5e-5 .. 5e-3; default 5e-4)"""
    def __init__(self, *, body: BodyLike = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ..., depth: Optional[s.Floats] = ..., first: float = ..., width: float = ..., passages: float = ..., largest_depth: float = ..., smoothing: float = ..., spacing: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, body: BodyLike = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ..., depth: Optional[s.Floats] = ..., first: float = ..., width: float = ..., passages: float = ..., largest_depth: float = ..., smoothing: float = ..., spacing: float = ...) -> ProfileWear:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class ProfileWearDict(TypedDict, total=False):
    """Members of wrc.ProfileWear as a dict."""
    body: BodyLike
    y: Optional[s.Floats]
    z: Optional[s.Floats]
    depth: Optional[s.Floats]
    first: float
    width: float
    passages: float
    largest_depth: float
    smoothing: float
    spacing: float

class WornProfile(s.Struct):
    """A worn profile: arrays of the caller, set before the call."""
    capacity: int
    """capacity: points there is room for; set before the call"""
    count: int
    """count: points"""
    @property
    def y(self) -> Optional[NDArray[np.float64]]:
        """y [m]: capacity of the caller; set before the call"""
    @y.setter
    def y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def z(self) -> Optional[NDArray[np.float64]]:
        """z [m]: see y"""
    @z.setter
    def z(self, value: Optional[s.Floats]) -> None: ...
    passages: float
    """passages: that were taken off: those wanted, or as many as largest_depth allows"""
    depth: float
    """depth [m]: largest that was taken off"""
    area: float
    """area [m^2]: taken off the section"""
    def __init__(self, *, capacity: int = ..., count: int = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ..., passages: float = ..., depth: float = ..., area: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, capacity: int = ..., count: int = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ..., passages: float = ..., depth: float = ..., area: float = ...) -> WornProfile:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class WornProfileDict(TypedDict, total=False):
    """Members of wrc.WornProfile as a dict."""
    capacity: int
    count: int
    y: Optional[s.Floats]
    z: Optional[s.Floats]
    passages: float
    depth: float
    area: float

class Flange(s.Struct):
    """Dimensions of a wheel's flange as gauges have them, EN 15313; datum: the tread at y = 0."""
    height: float
    """height [m]: Sh: the tip below the datum"""
    thickness: float
    """thickness [m]: Sd: from the flange back to the face 10 mm below the datum"""
    slope: float
    """slope [m]: qR: along y from there to the point of the face 2 mm above the tip"""
    def __init__(self, *, height: float = ..., thickness: float = ..., slope: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, height: float = ..., thickness: float = ..., slope: float = ...) -> Flange:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class FlangeDict(TypedDict, total=False):
    """Members of wrc.Flange as a dict."""
    height: float
    thickness: float
    slope: float

class SectionLine(s.Struct):
    """One measured line across a rail, from the gauge side to the field side, with gaps. Its points need no
        equal distances.
    """
    distance: float
    """distance [m]: along the track"""
    @property
    def count(self) -> int:
        """count: points, 4 or more"""
    @property
    def y(self) -> Optional[NDArray[np.float64]]:
        """y [m]: count of them, to the field side; NaN where nothing was measured (required)"""
    @y.setter
    def y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def z(self) -> Optional[NDArray[np.float64]]:
        """z [m]: count of them, downwards, 0 at the rail's top; NaN with y (required)"""
    @z.setter
    def z(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, distance: float = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, distance: float = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ...) -> SectionLine:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class SectionLineDict(TypedDict, total=False):
    """Members of wrc.SectionLine as a dict."""
    distance: float
    y: Optional[s.Floats]
    z: Optional[s.Floats]

class RailFacesProblem(s.Struct):
    """Measured sections of a rail that changes along the track, and how they are parted into faces."""
    @property
    def section_count(self) -> int:
        """section_count: (2 .. 100000; default 0)"""
    @property
    def sections(self) -> List[SectionLine]:
        """sections: section_count of them, by increasing distance (required)"""
    @sections.setter
    def sections(self, value: Optional[Sequence[Union[SectionLine, SectionLineDict]]]) -> None: ...
    @property
    def interruption_count(self) -> int:
        """interruption_count: (0 .. 1000; default 0)"""
    @property
    def interruptions(self) -> Optional[NDArray[np.float64]]:
        """interruptions [m]: interruption_count of them: places between two sections that no face passes, the
            gap of a joint (-1e7 .. 1e7; required)
        """
    @interruptions.setter
    def interruptions(self, value: Optional[s.Floats]) -> None: ...
    first: float
    """first [m]: beginning of the wanted part of the track; one section before it is kept, too (-1e7 .. 1e7;
        default -1e7)
    """
    last: float
    """last [m]: its end; one section beyond is kept, too (-1e7 .. 1e7; default 1e7)"""
    depth: float
    """depth [m]: depth below z = 0 beyond which points belong to no face, as the bottom of a flangeway (1e-3 ..
        0.2; default 0.03)
    """
    gap: float
    """gap [m]: distance from one point to the next at which a line is parted (1e-4 .. 0.1; default 5e-3)"""
    kink: float
    """kink [rad]: turn at a concave corner above which a line is parted: a blade at its stock rail (0.1 .. 3;
        default 0.7)
    """
    least_width: float
    """least_width [m]: least width of a face; narrower pieces are left out (1e-3 .. 0.05; default 3e-3)"""
    tolerance: float
    """tolerance [m]: distance of a section from the mean of its neighbours, above which thin names it (1e-6 ..
        0.05; default 2e-4)
    """
    def __init__(self, *, sections: Optional[Sequence[Union[SectionLine, SectionLineDict]]] = ..., interruptions: Optional[s.Floats] = ..., first: float = ..., last: float = ..., depth: float = ..., gap: float = ..., kink: float = ..., least_width: float = ..., tolerance: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, sections: Optional[Sequence[Union[SectionLine, SectionLineDict]]] = ..., interruptions: Optional[s.Floats] = ..., first: float = ..., last: float = ..., depth: float = ..., gap: float = ..., kink: float = ..., least_width: float = ..., tolerance: float = ...) -> RailFacesProblem:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class RailFacesProblemDict(TypedDict, total=False):
    """Members of wrc.RailFacesProblem as a dict."""
    sections: Optional[Sequence[Union[SectionLine, SectionLineDict]]]
    interruptions: Optional[s.Floats]
    first: float
    last: float
    depth: float
    gap: float
    kink: float
    least_width: float
    tolerance: float

class FoundFaces(s.Struct):
    """Faces of a rail. Data behind its pointers belong to the handle and end with it."""
    face_count: int
    """face_count: faces"""
    outline_count: int
    """outline_count: outlines of all faces, for rail_faces()"""
    rail_section_count: int
    """rail_section_count: for config.rail_section_count, which takes 1000 at most"""
    rail_sections: Optional[RailSection]
    """rail_sections: for config.rail_sections, without check rails"""
    @property
    def notes(self) -> Optional[str]:
        """notes: pieces that were left out or joined: sentences, each with its end of line"""
    @notes.setter
    def notes(self, value: Optional[s.Path]) -> None: ...
    @property
    def thin(self) -> Optional[str]:
        """thin: places where sections are too far apart, or more faces than a model holds; as notes"""
    @thin.setter
    def thin(self, value: Optional[s.Path]) -> None: ...
    def __init__(self, *, face_count: int = ..., outline_count: int = ..., rail_section_count: int = ..., rail_sections: Optional[RailSection] = ..., notes: Optional[s.Path] = ..., thin: Optional[s.Path] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, face_count: int = ..., outline_count: int = ..., rail_section_count: int = ..., rail_sections: Optional[RailSection] = ..., notes: Optional[s.Path] = ..., thin: Optional[s.Path] = ...) -> FoundFaces:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class FoundFacesDict(TypedDict, total=False):
    """Members of wrc.FoundFaces as a dict."""
    face_count: int
    outline_count: int
    rail_section_count: int
    rail_sections: Optional[RailSection]
    notes: Optional[s.Path]
    thin: Optional[s.Path]

class FaceOutline(s.Struct):
    """A face in one of the measured sections. Its arrays belong to the handle and end with it."""
    @property
    def kind(self) -> FaceKind:
        """kind: FaceKind: of its face"""
    @kind.setter
    def kind(self, value: FaceKindLike) -> None: ...
    face: int
    """face: its face, counted from 0 from the gauge side; outlines of one stand side by side"""
    number: int
    """number: the measured section, counted from 0"""
    @property
    def count(self) -> int:
        """count: points"""
    @property
    def mark_count(self) -> int:
        """mark_count: number of marks, equal in all outlines of a face"""
    distance: float
    """distance [m]: along the track"""
    spacing_error: float
    """spacing_error [m]: distance from the mean of its neighbours, along the normal; 0 of the first and last
    """
    @property
    def y(self) -> Optional[NDArray[np.float64]]:
        """y [m]: count of them"""
    @y.setter
    def y(self, value: Optional[s.Floats]) -> None: ...
    @property
    def z(self) -> Optional[NDArray[np.float64]]:
        """z [m]: count of them"""
    @z.setter
    def z(self, value: Optional[s.Floats]) -> None: ...
    @property
    def marks(self) -> Optional[NDArray[np.float64]]:
        """marks [m]: mark_count of them: y of the corners that belong together"""
    @marks.setter
    def marks(self, value: Optional[s.Floats]) -> None: ...
    def __init__(self, *, kind: FaceKindLike = ..., face: int = ..., number: int = ..., distance: float = ..., spacing_error: float = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ..., marks: Optional[s.Floats] = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, kind: FaceKindLike = ..., face: int = ..., number: int = ..., distance: float = ..., spacing_error: float = ..., y: Optional[s.Floats] = ..., z: Optional[s.Floats] = ..., marks: Optional[s.Floats] = ...) -> FaceOutline:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class FaceOutlineDict(TypedDict, total=False):
    """Members of wrc.FaceOutline as a dict."""
    kind: FaceKindLike
    face: int
    number: int
    distance: float
    spacing_error: float
    y: Optional[s.Floats]
    z: Optional[s.Floats]
    marks: Optional[s.Floats]

class SurfaceBin(s.Struct):
    """One bin. With all members zero it is clean and at ambient temperature."""
    @property
    def sum(self) -> NDArray[Any]:
        """sum: kg or J of the whole bin, at 8 * SurfaceBook + SurfaceQuantity: low and high half of an integer
            of 128 bits, two's complement. Band.values() converts it
        """
    @sum.setter
    def sum(self, value: s.Floats) -> None: ...
    overflow: int
    """overflow: bit i: sum i, or a contribution to it, passed its range and is invalid"""
    def __init__(self, *, sum: s.Floats = ..., overflow: int = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, sum: s.Floats = ..., overflow: int = ...) -> SurfaceBin:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class SurfaceBinDict(TypedDict, total=False):
    """Members of wrc.SurfaceBin as a dict."""
    sum: s.Floats
    overflow: int

class Surface(s.Struct):
    """Running band of a rail along the track, or of a wheel round its tread. Amounts belong to the middles of
        its bins, with straight lines between. Beyond the ends of a band that is not closed the amounts of the
        end hold. Nothing is changed there.
    """
    count: int
    """count: bins (1 .. 10000000; default 0)"""
    first: float
    """first [m]: distance at which the first bin begins (-1e9 .. 1e9; default 0)"""
    length: float
    """length [m]: of a bin; of a wheel its circumference / count (1e-3 .. 1e4; default 0)"""
    width: float
    """width [m]: of the running band, or of each row in y (1e-3 .. 0.5; default 0.02)"""
    closed: int
    """closed: 1: the last bin is beside the first: a wheel, a roller, a track that is a circle (0 .. 1; default
        0)
    """
    bins: Optional[SurfaceBin]
    """bins: of the caller, count for each row, row after row, zeroed before the first use"""
    rows: int
    """rows: rows across; 0 or 1: one band, on which the whole contact lies (0 .. 16; default 0)"""
    row_first: float
    """row_first [m]: y of the profile at which the first of several rows begins (-1 .. 1; default 0)"""
    def __init__(self, *, count: int = ..., first: float = ..., length: float = ..., width: float = ..., closed: int = ..., bins: Optional[SurfaceBin] = ..., rows: int = ..., row_first: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, count: int = ..., first: float = ..., length: float = ..., width: float = ..., closed: int = ..., bins: Optional[SurfaceBin] = ..., rows: int = ..., row_first: float = ...) -> Surface:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class SurfaceDict(TypedDict, total=False):
    """Members of wrc.Surface as a dict."""
    count: int
    first: float
    length: float
    width: float
    closed: int
    bins: Optional[SurfaceBin]
    rows: int
    row_first: float

class Substance(s.Struct):
    """Laws of one substance: friction, layer, removal. With all members zero it lies there and has no effect.
    """
    cover: float
    """cover [kg/m^2]: on both bodies together: amount from which it covers the surface; 0: no effect on friction
        and layer (0 or 1e-6 .. 100; default 0)
    """
    weight: float
    """weight: weight of its friction among substances that cover together; goes with cover (0 or 1e-3 .. 1000;
        default 0)
    """
    friction: float
    """friction: coefficient of friction of a dry surface that it covers; goes with cover (0 or 1e-3 .. 2;
        default 0)
    """
    wet_friction: float
    """wet_friction: the same where water covers, too; goes with cover (0 or 1e-3 .. 2; default 0)"""
    removal: float
    """removal [m^2/J]: tau: frictional energy W over the band's area removes the share 1 - exp(-tau W) (0 .. 1;
        default 0)
    """
    kept: float
    """kept [kg/m^2]: amount that a passing wheel leaves in the band (0 .. 100; default 0)"""
    squeeze: float
    """squeeze: share of the amount above kept that one passage presses out of the band (0 .. 0.999; default 0)
    """
    carry: float
    """carry: rate at which amounts on both bodies become equal, as a share in one passage (0 .. 1; default 0)
    """
    density: float
    """density [kg/m^3]: of its layer (100 .. 1e5; default 1000)"""
    layer_modulus: float
    """layer_modulus [Pa]: of its layer in shear; 0: it does not shear elastically (0 or 1e3 .. 1e12; default 0)
    """
    layer_yield: float
    """layer_yield [Pa]: traction at which its layer yields; 0: it does not yield (0 or 1e3 .. 1e11; default 0)
    """
    layer_hardening: float
    """layer_hardening [Pa/m]: as Friction.layer_hardening, goes with layer_yield (-1e13 .. 1e14; default 0)
    """
    def __init__(self, *, cover: float = ..., weight: float = ..., friction: float = ..., wet_friction: float = ..., removal: float = ..., kept: float = ..., squeeze: float = ..., carry: float = ..., density: float = ..., layer_modulus: float = ..., layer_yield: float = ..., layer_hardening: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, cover: float = ..., weight: float = ..., friction: float = ..., wet_friction: float = ..., removal: float = ..., kept: float = ..., squeeze: float = ..., carry: float = ..., density: float = ..., layer_modulus: float = ..., layer_yield: float = ..., layer_hardening: float = ...) -> Substance:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class SubstanceDict(TypedDict, total=False):
    """Members of wrc.Substance as a dict."""
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

class SurfaceLaws(s.Struct):
    """Constants of the mixing rule and of passages. surface_laws() sets them by a name."""
    water: Substance
    """water: it wets the others: wet_friction is that of wet steel; weight, friction, layer are 0"""
    oxide: Substance
    """oxide: oxide and debris"""
    film: Substance
    """film: organic film"""
    sand: Substance
    """sand: sand"""
    lubricant: Substance
    """lubricant: lubricant"""
    rail_share: float
    """rail_share: share of the frictional energy that heats the rail; the wheel has the rest (0 .. 1; default
        0.5)
    """
    rail_heat_capacity: float
    """rail_heat_capacity [J/(m^2 K)]: heat capacity of the rail per area of its band (1e2 .. 1e8; default 35e3)
    """
    wheel_heat_capacity: float
    """wheel_heat_capacity [J/(m^2 K)]: heat capacity of the wheel per area of its band (1e2 .. 1e8; default
        35e3)
    """
    cooling_time: float
    """cooling_time [s]: time after which Band.rest() leaves 1/e of the heat (1e-3 .. 1e9; default 60)"""
    drying_time: float
    """drying_time [s]: time after which Band.rest() leaves 1/e of the water (1e-3 .. 1e9; default 1800)"""
    evaporation_share: float
    """evaporation_share: share of frictional heat that evaporates water where there is plenty (0 .. 1; default
        0)
    """
    evaporation_amount: float
    """evaporation_amount [kg/m^2]: amount of water at which that share is halved (1e-6 .. 10; default 5e-3)
    """
    latent_heat: float
    """latent_heat [J/kg]: latent heat of evaporation (1e5 .. 1e7; default 2.4e6)"""
    ambient: float
    """ambient [degC]: temperature of bodies without heat (-100 .. 200; default 20)"""
    def __init__(self, *, water: Union[Substance, SubstanceDict] = ..., oxide: Union[Substance, SubstanceDict] = ..., film: Union[Substance, SubstanceDict] = ..., sand: Union[Substance, SubstanceDict] = ..., lubricant: Union[Substance, SubstanceDict] = ..., rail_share: float = ..., rail_heat_capacity: float = ..., wheel_heat_capacity: float = ..., cooling_time: float = ..., drying_time: float = ..., evaporation_share: float = ..., evaporation_amount: float = ..., latent_heat: float = ..., ambient: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, water: Union[Substance, SubstanceDict] = ..., oxide: Union[Substance, SubstanceDict] = ..., film: Union[Substance, SubstanceDict] = ..., sand: Union[Substance, SubstanceDict] = ..., lubricant: Union[Substance, SubstanceDict] = ..., rail_share: float = ..., rail_heat_capacity: float = ..., wheel_heat_capacity: float = ..., cooling_time: float = ..., drying_time: float = ..., evaporation_share: float = ..., evaporation_amount: float = ..., latent_heat: float = ..., ambient: float = ...) -> SurfaceLaws:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class SurfaceLawsDict(TypedDict, total=False):
    """Members of wrc.SurfaceLaws as a dict."""
    water: Union[Substance, SubstanceDict]
    oxide: Union[Substance, SubstanceDict]
    film: Union[Substance, SubstanceDict]
    sand: Union[Substance, SubstanceDict]
    lubricant: Union[Substance, SubstanceDict]
    rail_share: float
    rail_heat_capacity: float
    wheel_heat_capacity: float
    cooling_time: float
    drying_time: float
    evaporation_share: float
    evaporation_amount: float
    latent_heat: float
    ambient: float

class SurfacePassage(s.Struct):
    """A step of a wheel on its rail: the stretches of both bodies that passed through the contact, and the
        frictional energy.
    """
    rail_from: float
    """rail_from [m]: distance along the rail at the beginning, growing forwards (-1e9 .. 1e9; default 0)"""
    rail_to: float
    """rail_to [m]: the same at the end (-1e9 .. 1e9; default 0)"""
    wheel_from: float
    """wheel_from [m]: distance round the wheel at the beginning, growing as it rolls forwards (-1e9 .. 1e9;
        default 0)
    """
    wheel_to: float
    """wheel_to [m]: the same at the end; wheel_from for a locked wheel (-1e9 .. 1e9; default 0)"""
    energy: float
    """energy [J]: frictional energy: Wrench.power times the duration (0 .. 1e9; default 0)"""
    @property
    def film_rows(self) -> Optional[NDArray[np.float64]]:
        """film_rows: memory of the caller for films in rows; None: with one row it is not needed (default None)
        """
    @film_rows.setter
    def film_rows(self, value: Optional[s.Floats]) -> None: ...
    film_numbers: int
    """film_numbers: numbers of film_rows (0 or 13 .. 1288; default 0)"""
    contact: Any
    """contact: contact whose last wrench passes, for surface_pass() with rows; None: one row (default None)
    """
    def __init__(self, *, rail_from: float = ..., rail_to: float = ..., wheel_from: float = ..., wheel_to: float = ..., energy: float = ..., film_rows: Optional[s.Floats] = ..., film_numbers: int = ..., contact: Any = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, rail_from: float = ..., rail_to: float = ..., wheel_from: float = ..., wheel_to: float = ..., energy: float = ..., film_rows: Optional[s.Floats] = ..., film_numbers: int = ..., contact: Any = ...) -> SurfacePassage:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class SurfacePassageDict(TypedDict, total=False):
    """Members of wrc.SurfacePassage as a dict."""
    rail_from: float
    rail_to: float
    wheel_from: float
    wheel_to: float
    energy: float
    film_rows: Optional[s.Floats]
    film_numbers: int
    contact: Any

class SurfaceExchange(s.Struct):
    """Amounts and energies that a passage moved."""
    @property
    def carried(self) -> NDArray[Any]:
        """carried [kg]: by SurfaceQuantity: from rail to wheel, less that from wheel to rail"""
    @carried.setter
    def carried(self, value: s.Floats) -> None: ...
    rail_energy: float
    """rail_energy [J]: frictional energy booked in the rail's bins"""
    wheel_energy: float
    """wheel_energy [J]: the same in the wheel's bins"""
    beside_energy: float
    """beside_energy [J]: the remaining energy: beyond a rail's ends, of a wheel that is None, of a wrench
        without work
    """
    def __init__(self, *, carried: s.Floats = ..., rail_energy: float = ..., wheel_energy: float = ..., beside_energy: float = ...) -> None:
        """The defaults, and what is given."""
    def set(self, *, carried: s.Floats = ..., rail_energy: float = ..., wheel_energy: float = ..., beside_energy: float = ...) -> SurfaceExchange:  # type: ignore[override]
        """Sets members by name, nested structs by dicts of theirs, and gives the struct itself."""

class SurfaceExchangeDict(TypedDict, total=False):
    """Members of wrc.SurfaceExchange as a dict."""
    carried: s.Floats
    rail_energy: float
    wheel_energy: float
    beside_energy: float

_wrc_version: Callable[..., Any]
_wrc_abi_version: Callable[..., Any]
_wrc_version_text: Callable[..., Any]
_wrc_build_info: Callable[..., Any]
_wrc_status_name: Callable[..., Any]
_wrc_status_text: Callable[..., Any]
_wrc_config_init: Callable[..., Any]
_wrc_material_init: Callable[..., Any]
_wrc_friction_init: Callable[..., Any]
_wrc_wheel_input_init: Callable[..., Any]
_wrc_config_use: Callable[..., Any]
_wrc_friction_use: Callable[..., Any]
_wrc_config_check: Callable[..., Any]
_wrc_model_size: Callable[..., Any]
_wrc_model_init: Callable[..., Any]
_wrc_model_create: Callable[..., Any]
_wrc_model_profile: Callable[..., Any]
_wrc_model_destroy: Callable[..., Any]
_wrc_contact_size: Callable[..., Any]
_wrc_contact_init: Callable[..., Any]
_wrc_contact_create: Callable[..., Any]
_wrc_contact_destroy: Callable[..., Any]
_wrc_contact_state_size: Callable[..., Any]
_wrc_contact_save: Callable[..., Any]
_wrc_contact_restore: Callable[..., Any]
_wrc_contact_portable_size: Callable[..., Any]
_wrc_contact_save_portable: Callable[..., Any]
_wrc_contact_restore_portable: Callable[..., Any]
_wrc_contact_last_error: Callable[..., Any]
_wrc_contact_wrench: Callable[..., Any]
_wrc_contact_mark: Callable[..., Any]
_wrc_contact_commit: Callable[..., Any]
_wrc_contact_wrench_derivatives: Callable[..., Any]
_wrc_contact_wrench_batch: Callable[..., Any]
_wrc_contact_region: Callable[..., Any]
_wrc_contact_field: Callable[..., Any]
_wrc_contact_damage: Callable[..., Any]
_wrc_get_api: Callable[..., Any]
_wrc_get_experimental_api: Callable[..., Any]
_wrc_planar_load_init: Callable[..., Any]
_wrc_creepage_init: Callable[..., Any]
_wrc_planar_input_init: Callable[..., Any]
_wrc_planar_step: Callable[..., Any]
_wrc_planar_geometry: Callable[..., Any]
_wrc_planar_creepages: Callable[..., Any]
_wrc_planar_normal: Callable[..., Any]
_wrc_planar_regularise: Callable[..., Any]
_wrc_planar_roll: Callable[..., Any]
_wrc_planar_tangential: Callable[..., Any]
_wrc_planar_tangential_derivatives: Callable[..., Any]
_wrc_bulk_temperatures_init: Callable[..., Any]
_wrc_wear_laws_init: Callable[..., Any]
_wrc_damage_bins_init: Callable[..., Any]
_wrc_fatigue_laws_init: Callable[..., Any]
_wrc_contact_wear: Callable[..., Any]
_wrc_contact_temperature: Callable[..., Any]
_wrc_contact_stresses: Callable[..., Any]
_wrc_flash_temperature: Callable[..., Any]
_wrc_contact_accumulate: Callable[..., Any]
_wrc_damage_merge: Callable[..., Any]
_wrc_damage_values: Callable[..., Any]
_wrc_whole_life_damage: Callable[..., Any]
_wrc_model_arc_places: Callable[..., Any]
_wrc_linear_coefficients: Callable[..., Any]
_wrc_shakedown_limit: Callable[..., Any]
_wrc_shakedown_limit_point: Callable[..., Any]
_wrc_exact_normal_problem_init: Callable[..., Any]
_wrc_exact_rolling_problem_init: Callable[..., Any]
_wrc_exact_loads_init: Callable[..., Any]
_wrc_exact_check_options_init: Callable[..., Any]
_wrc_exact_wrench_options_init: Callable[..., Any]
_wrc_creep_curve_init: Callable[..., Any]
_wrc_exact_gap: Callable[..., Any]
_wrc_exact_normal: Callable[..., Any]
_wrc_exact_rolling: Callable[..., Any]
_wrc_exact_stress: Callable[..., Any]
_wrc_exact_largest_stresses: Callable[..., Any]
_wrc_exact_transient_create: Callable[..., Any]
_wrc_exact_transient_step: Callable[..., Any]
_wrc_exact_transient_destroy: Callable[..., Any]
_wrc_exact_check: Callable[..., Any]
_wrc_exact_wrench: Callable[..., Any]
_wrc_fit_creep_curve: Callable[..., Any]
_wrc_conicity_problem_init: Callable[..., Any]
_wrc_profile_wear_init: Callable[..., Any]
_wrc_rail_faces_problem_init: Callable[..., Any]
_wrc_profile_wheelset_geometry: Callable[..., Any]
_wrc_equivalent_conicity: Callable[..., Any]
_wrc_profile_remove_wear: Callable[..., Any]
_wrc_flange_dimensions: Callable[..., Any]
_wrc_rail_faces_create: Callable[..., Any]
_wrc_rail_faces_found: Callable[..., Any]
_wrc_rail_faces_outline: Callable[..., Any]
_wrc_rail_faces_destroy: Callable[..., Any]
_wrc_section_file_read: Callable[..., Any]
_wrc_section_file_line: Callable[..., Any]
_wrc_section_file_destroy: Callable[..., Any]
_wrc_section_file_write: Callable[..., Any]
_wrc_surface_init: Callable[..., Any]
_wrc_surface_laws_init: Callable[..., Any]
_wrc_surface_laws_use: Callable[..., Any]
_wrc_surface_add: Callable[..., Any]
_wrc_surface_friction: Callable[..., Any]
_wrc_surface_pass: Callable[..., Any]
_wrc_surface_rest: Callable[..., Any]
_wrc_surface_merge: Callable[..., Any]
_wrc_surface_values: Callable[..., Any]

class ModelCalls(_l.Handle):
    """What Model has of the C interface as it is."""

class ContactCalls(_l.Handle):
    """What Contact has of the C interface as it is."""
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
    def mark(self) -> None:
        """Marks the contact's last solution of a wheel as accepted. Calls with Start.MARK start from it until
            the next mark, whatever was called in between: trial steps, Jacobians by differences, steps taken
            back. The mark is saved and restored with the state.

        C status: Status.OK; Status.ERROR_NULL; _SEQUENCE (the last call left no solution of a wheel).
        """
    def commit(self) -> None:
        """Commits the contact's last solution of a wheel, of a model with config.surface.memory. Later calls
            begin with its tractions. It is marked as by Contact.mark(). Until the next commit results depend
            on this step and the input of the call alone, to the last bit. Trial steps, rejected ones and
            differences leave no trace. A contact begins without tractions. The committed step is saved and
            restored with the state. Theory manual, section 5.

        C status: Status.OK; Status.ERROR_NULL; _UNSUPPORTED (a model without config.surface.memory);
            _SEQUENCE (the last call left no solution of a wheel, or it is committed already).
        """
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
    def damage(self, index: int, *, out: Optional[Damage] = None) -> Damage:
        """Wear and fatigue numbers of one region of the contact's last solution. Theory manual, section 6; paper
            eq. 10 to 12.

        index: as for Contact.region(); ALL_REGIONS: all patches of a contact plane together
        out: the numbers; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT; Status.ERROR_NULL; _SEQUENCE (no solution); _RANGE (no
            such region, or ALL_REGIONS of a wheel).
        """
    def planar_step(self, input: PlanarInput, *, out: Optional[PlanarOutput] = None) -> PlanarOutput:
        """All stages at once: geometry (without input->gap) or the given gap, normal, regularise, tangential,
            damage.

        input: what to solve
        out: the results; None: a new one

        C status: Status.OK or the gravest flag of the stages; the failure of the first stage that fails,
            which ends the step.
        """
    def planar_geometry(self, pose: PlanarPose, *, out: Optional[PlanarPoint] = None) -> PlanarPoint:
        """Finds the initial contact point of a pose, the lowest one, and samples the gap around it. Rows reach
            up to 30 mm to either side. Theory manual, section 7.

        pose: of the wheelset, track frame
        out: where the bodies touch first; None: a new one

        C status: Status.OK; Status.FLAG_ITERATION_CAP; Status.ERROR_NULL, _SEQUENCE (model without profiles),
            _NOT_FINITE, _RANGE, _GAP (no rail below the wheel at this pose).
        """
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
    def planar_regularise(self, strips: Optional[PlanarStrips] = None, *, out: Optional[PlanarNormalSolution] = None) -> PlanarNormalSolution:
        """Takes a pressure distribution of the caller as the contact's patch and finds its equivalent double
            ellipse. Theory manual, section 3; paper section 2.

        strips: contact frame, whose origin must be the initial contact point; copied; None: the strips in the
            contact
        out: sums over the strips, with their double ellipse; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT (no pressure), _TABLE_RANGE (|psi| cut to 0.95);
            Status.ERROR_NULL, _SEQUENCE (strips is None and the contact has none), _RANGE, _NOT_FINITE.
        """
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
    def wear(self, index: int, laws: Optional[WearLaws] = None, *, out: Optional[Wear] = None) -> Wear:
        """Wear of one region of the contact's last solution, by all four laws. Theory manual, section 6.

        index: as for Contact.damage()
        laws: parameters; None: the published ones
        out: the numbers; None: a new one

        C status: Status.OK; Status.FLAG_NO_CONTACT; Status.ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no solution),
            _NOT_FINITE, _RANGE (no such region, or ALL_REGIONS of a wheel), _UNSUPPORTED (no tractions).
        """
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
def linear_coefficients(a_over_b: float, psi: float, poisson: float, *, out: Optional[Coefficients] = None) -> Coefficients:
    """Coefficients of the linear theory. Theory manual, section 4; paper eq. 5.

    a_over_b: axis ratio, 1e-3..1e3
    psi: shape number, -0.95..0.95
    poisson: 0..0.5
    out: the coefficients; None: a new one

    C status: Status.OK; Status.FLAG_TABLE_RANGE beyond the tables; Status.ERROR_NULL, _RANGE, _NOT_FINITE.
    """
def shakedown_limit(utilisation: float) -> float:
    """Shakedown curve of the line contact: load factor p0/k above which the surface ratchets. Theory manual,
        section 6.

    utilisation: mu_a, 0..10
    load_factor: p0/k; 0 on failure

    C status: Status.OK; Status.ERROR_NULL, _RANGE, _NOT_FINITE.
    """
def shakedown_limit_point(utilisation: float) -> float:
    """The same of a circular point contact, for material that hardens kinematically: below the surface up to
        mu_a = 0.22, 1 / mu_a beyond. Theory manual, section 6.

    utilisation: mu_a, 0..10
    load_factor: p0/k; 0 on failure

    C status: Status.OK; Status.ERROR_NULL, _RANGE, _NOT_FINITE.
    """

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
