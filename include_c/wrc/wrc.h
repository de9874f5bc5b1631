/** @file wrc.h
 * Wheel/rail contact for multibody and hardware-in-the-loop simulation: all that a vehicle code needs.
 *
 * A wheelset or wheel in a simulation: wrc_contact_wrench(). Where it is and how it moves go in, the wrench comes out.
 * Creepages that are prescribed, on one contact plane: the stages of wrc_planar.h, which take the slip at one point.
 *
 *     wrc_model    what stays fixed during a run: profiles, materials, methods. Immutable; any number of threads share one.
 *     wrc_contact  one wheel and its rail: the last results and work space. One thread at a time.
 *
 * @par Stability
 * wrc.h, wrc_methods.h, wrc_status.h and wrc_planar.h are frozen from 1.0 on: later versions add, and nothing that compiles or
 * runs today stops doing so. wrc_damage.h, wrc_surface.h, wrc_offline.h and wrc_profiles.h may change in a minor version.
 * docs/abi.md.
 *
 * @par Frames and signs
 *
 *        track axes (fixed): x forward, y right, z DOWN; origin on the track centre line, level with the undisplaced rails' tops
 *
 *              left wheel     O  axle            right wheel          seen from behind, x into the page
 *              ____   ________|________________________   ____
 *             |    |_|        |                        |_|    |       O        nominal place (0, 0, -r0)
 *             |    | |        +--> y                   | |    |       W        nominal place (0, +-s, -r0), right +, left -
 *             |  W-+-|--------O------------------------|-+-W  |                s = config.wheelset.tape_circle_distance / 2
 *             |    | |        |                        | |    |       r0       config.wheelset.wheel_radius, at the tape circle
 *              \__/\_|        v z                      |_/\__/        P        origin of the rail's profile
 *              --P---                                   ---P--                 (config.track.placement)
 *
 *  - Pose: the reference point (O or W, wrc_wheel_state.reference) is displaced by (y, z) from its nominal place. Its x does
 *    not matter.
 *  - Orientation: R = Rx(roll) Rz(yaw), right-hand rule: roll > 0 lowers the right wheel, yaw > 0 turns the nose to the right.
 *    The pitch about the axle does not matter. A rotation matrix of the host may take the place of both angles.
 *  - Velocities are those of the reference point, in track axes. Rolling forwards, the pitch rate is about -v / r0 < 0.
 *  - Rail: P is displaced by (y, z), and the profile turned about P by roll. A rail that runs aslant has slopes dy/dx, dz/dx.
 *  - Wrench: force and moment ON THE WHEEL in track axes. The moment is about the reference point. A wheel that is pressed
 *    down has force[2] < 0.
 *  - Both sides share these axes: nothing is mirrored for a left wheel. One model serves both sides; each wheel has a contact
 *    of its own, which knows its side.
 *  - Creepage: sliding velocity of the wheel over the rail, divided by the amount of the rolling speed.
 *
 * @par Recipe
 * @code
 *   wrc_config config = wrc_config_default();
 *   config.wheel.kind = WRC_PROFILE_S1002;
 *   config.rail.kind = WRC_PROFILE_60E1;
 *   config.track.rail_inclination = 1.0 / 40.0;
 *   char why[300];                                                      // a sentence, where a call fails
 *   wrc_model* model = NULL;
 *   wrc_contact* contact[2] = {NULL, NULL};
 *   if (wrc_model_create(&config, NULL, &model, why, sizeof why) < 0) ...
 *   for (side = 0; side < 2; ++side) wrc_contact_create(model, side, NULL, &contact[side], why, sizeof why);
 *
 *   // the height at which the wheelset stands: prescribe the load of a wheel once, without motion
 *   wrc_wheel_input input = wrc_wheel_input_default();
 *   wrc_wrench wrench = {sizeof wrench};
 *   input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
 *   input.vertical_load = 80e3;
 *   wrc_contact_wrench(contact[WRC_SIDE_RIGHT], &input, &wrench);       // wrench.z [m]
 *
 *   // in every evaluation of the right-hand side, from here on without allocation
 *   input.prescribed = WRC_PRESCRIBE_HEIGHT;
 *   input.vertical_load = 0.0;
 *   wrc_wheel_state* wheel = &input.wheel;
 *   wheel->y = y;                      wheel->z = z;                    // of the wheelset's middle; z > 0 is down
 *   wheel->roll = roll;                wheel->yaw = yaw;
 *   wheel->velocity[0] = v;            wheel->velocity[1] = dy_dt;            wheel->velocity[2] = dz_dt;
 *   wheel->roll_rate = droll_dt;       wheel->yaw_rate = dyaw_dt;             wheel->pitch_rate = -v / r0;
 *   for (side = 0; side < 2; ++side) {
 *     int32_t status = wrc_contact_wrench(contact[side], &input, &wrench);  // < 0: wrc_contact_last_error() says why
 *     for (i = 0; i < 3; ++i) force[i] += wrench.force[i], moment[i] += wrench.moment[i];
 *   }
 * @endcode
 *
 * @par Conventions
 *  - Units are SI throughout: m, N, Pa, rad, s, W. 80 kN is 80e3.
 *  - A status is 0 (done), > 0 (done, with a flag) or < 0 (failed). A failed call zeroes its outputs and leaves the handle
 *    usable. wrc_status.h lists them.
 *  - Results have `flags`: bit 1 << flag for each flag that was met, WRC_FLAG_BIT(). The status is the gravest of them.
 *  - wrc_contact_last_error() says in a sentence why: function, member, value, unit, allowed range, likely cause.
 *  - A member's comment says what it is, its range and unit, then [its default]. A result has its unit in brackets. A pointer
 *    that is [required] has no default. It may be NULL where it is not read, as with a count of 0.
 *  - A struct that is read has defaults: wrc_config config = wrc_config_default(). Hosts that load the library at run time, and
 *    other languages, set struct_size and call wrc_config_init(). Where neither exists, all defaults are zero.
 *  - Structs grow. Those that begin with struct_size want sizeof the struct there, results too: wrc_wrench w = {sizeof w}.
 *    The others have `reserved` numbers, which must be 0.
 *  - A struct of an older or newer header is honoured, as long as what the library does not know is 0.
 *  - 0 is the number 0, never a sign for a default. An input of two natural meanings has no default.
 *  - What a result does not have is 0. Its bit is missing in `available`, where there is one. Nothing is ever NaN.
 *  - NULL is never dereferenced: it is WRC_ERROR_NULL where a parameter's comment does not say what it means.
 *  - Nothing is kept of what a caller passes, but for memory handed to an init or create and the model of a contact.
 *  - Thread class: "thread free" any thread any time; "thread contact" one thread at a time per contact.
 *  - Real-time class: "rt hard" functions never allocate, lock, throw, print, read files, environment, locale or clock, and
 *    never call the system. All iterations are capped. "rt hard, long" is the same and may take a millisecond and more.
 *    "rt init" functions may allocate and take milliseconds.
 *  - "rt hard" functions use at most 80 kB of stack. A contact takes 0.20 MB, with profiles 0.46 MB,
 *    on a rail that changes along the track 0.51 MB; a saved state 0.08 MB.
 *  - The host's floating-point environment is set aside by every call that computes, and restored.
 *
 * @par On Windows
 * Link wrc-0.9.dll by its import library, or load it at run time (examples_c/load_at_run_time.c). Its name has the version, as the
 * SONAME: products with other versions live in one process. Memory handed to an init comes from
 * _aligned_malloc or the like, with the alignment asked for: malloc gives 16 bytes. Names of files are in the process's code page.
 *
 * Valid as C99 to C23 and C++98 to C++23. "Paper" is Liu and Bruni, Proc. IMechE Part F 238(4) (2024) 427-436.
 */
#ifndef WRC_H
#define WRC_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "wrc_methods.h"
#include "wrc_status.h"

/** @cond */
#if defined(WRC_STATIC) /* the static library, and the library's own sources: nothing is imported or exported */
#define WRC_API
#elif defined(_WIN32)
#define WRC_API __declspec(dllimport)
#elif defined(__GNUC__)
#define WRC_API __attribute__((visibility("default")))
#else
#define WRC_API
#endif
/** @endcond */

#ifdef __cplusplus
extern "C" {
#endif

#define WRC_VERSION_MAJOR 0 /**< of this header; wrc_version() is that of the library */
#define WRC_VERSION_MINOR 9 /**< see WRC_VERSION_MAJOR */
#define WRC_VERSION_PATCH 0 /**< see WRC_VERSION_MAJOR */
/** Interface of wrc.h and wrc_planar.h. Raised when an existing caller would break; additions do not raise it. 1.0 has 1000. */
#define WRC_ABI_VERSION 900
/** Interface of wrc_damage.h, wrc_surface.h, wrc_offline.h and wrc_profiles.h. A minor version may raise it. */
#define WRC_EXPERIMENTAL_VERSION 1

/* ------------------------------------------------------------------------------------------------------ handles */

/** Profiles, materials, methods: immutable once made, shared by any number of contacts and threads. */
typedef struct wrc_model wrc_model;
/** One wheel and its rail: results of the last call and work space. One thread at a time. */
typedef struct wrc_contact wrc_contact;

/* ------------------------------------------------------------------------------------------------- enumerations */

/** Which wheel of the wheelset. */
enum wrc_side {
  WRC_SIDE_RIGHT = 0, /**< flange at y < 0 */
  WRC_SIDE_LEFT = 1   /**< flange at y > 0; frames and signs stay those of the right wheel */
};

/** Which of the two bodies. */
enum wrc_body {
  WRC_BODY_WHEEL = 0, /**< the wheel */
  WRC_BODY_RAIL = 1   /**< the rail */
};

/** Where a profile comes from. */
enum wrc_profile_kind {
  WRC_PROFILE_NONE = 0,            /**< no profile. A model without both has planar gaps only */
  WRC_PROFILE_POINTS = 1,          /**< points y, z of the caller, joined by a cubic spline */
  WRC_PROFILE_S1002 = 2,           /**< wheel, EN 13715, from its analytic definition */
  WRC_PROFILE_60E1 = 3,            /**< rail, nominal head (R300/R80/R13), not canted: set rail_inclination, e.g. 1/40 */
  WRC_PROFILE_UIC60_BENCHMARK = 4  /**< rail of the Manchester benchmark, canted 1:40 already */
};

/** Where profiles lie. */
enum wrc_profile_placement {
  WRC_PLACEMENT_GAUGE = 0, /**< rails by track.gauge and track.gauge_depth, tops at z = 0: new profiles */
  WRC_PLACEMENT_ORIGIN = 1 /**< rails by the origin of their points, at y = track.rail_origin, z = 0. Inclination turns about it.
                                A worn rail stays where the new one was */
};

/** Instruction set of the kernels. Results are the same bits with all of them. */
enum wrc_instruction_set {
  WRC_INSTRUCTIONS_BEST = 0,     /**< the widest that this processor has */
  WRC_INSTRUCTIONS_BASELINE = 1, /**< what every processor of the architecture has: SSE2, NEON */
  WRC_INSTRUCTIONS_AVX2 = 2,     /**< x86-64 with AVX2 */
  WRC_INSTRUCTIONS_AVX512 = 3    /**< x86-64 with AVX-512 F, DQ, VL */
};

/** How friction falls with the sliding speed w of a strip: the root mean square of its rigid slip times the rolling speed. */
enum wrc_friction_speed_law {
  WRC_SPEED_LAW_NONE = 0,        /**< factor 1 */
  WRC_SPEED_LAW_EXPONENTIAL = 1, /**< factor (1 - kinetic_ratio) exp(-fall_rate w) + kinetic_ratio: Polach */
  WRC_SPEED_LAW_HYPERBOLIC = 2   /**< factor kinetic_ratio + (1 - kinetic_ratio) / (1 + w / half_speed): static to kinetic */
};

/** How friction falls with the temperature of the surfaces. */
enum wrc_friction_temperature_law {
  WRC_TEMPERATURE_LAW_NONE = 0,  /**< factor 1 */
  WRC_TEMPERATURE_LAW_LINEAR = 1 /**< factor 1 up to cold_temperature, hot_ratio from hot_temperature on, linear between. A strip
                                      has the mean over its load. Not with a method that gives forces alone */
};

/** Where the y of friction zones counts from. */
enum wrc_zone_frame {
  WRC_ZONES_CONTACT_FRAME = 0, /**< contact frame, of wrc_planar.h alone: zones move with the contact point */
  WRC_ZONES_RAIL_PROFILE = 1,  /**< rail profile, field side > 0: zones stay on the rail */
  WRC_ZONES_WHEEL_PROFILE = 2  /**< wheel profile, flange side < 0: zones stay on the wheel, as a lubricated flange */
};

/** Which point of the rotating body the pose, the velocity and the moment refer to. */
enum wrc_wheel_reference {
  WRC_REFERENCE_WHEELSET = 0, /**< O, the middle of the axle */
  WRC_REFERENCE_WHEEL = 1     /**< W, where the plane of the tape circle meets the axle: independent wheels, elastic axles */
};

/** How an orientation is given. */
enum wrc_orientation {
  WRC_ORIENTATION_ANGLES = 0, /**< by roll and yaw */
  WRC_ORIENTATION_ROWS = 1,   /**< by `rotation` row by row, as C and numpy store a matrix: track = R body, y body is the axle */
  WRC_ORIENTATION_COLUMNS = 2 /**< by `rotation` column by column, as Fortran, MATLAB and Eigen store the same matrix */
};

/** How an angular velocity is given. */
enum wrc_axes {
  WRC_AXES_NONE = 0,  /**< by roll_rate, pitch_rate, yaw_rate; angular_velocity must be 0 */
  WRC_AXES_TRACK = 1, /**< by angular_velocity along the track's axes: a yawed axle then has an x component, too */
  WRC_AXES_BODY = 2   /**< by angular_velocity along the axes of the body without its pitch: y is about the axle */
};

/** Which of height, load and approach is given; the others are results. */
enum wrc_prescribed {
  WRC_PRESCRIBE_HEIGHT = 0,        /**< wheel: its z. The choice of a dynamic simulation */
  WRC_PRESCRIBE_VERTICAL_LOAD = 1, /**< wheel: vertical_load; z of the reference point is found */
  WRC_PRESCRIBE_NORMAL_FORCE = 2,  /**< contact plane: normal_force along the contact normal */
  WRC_PRESCRIBE_APPROACH = 3       /**< contact plane: approach of the bodies. The choice near lift-off */
};

/** Where iterations begin. */
enum wrc_start {
  WRC_START_COLD = 0, /**< from nothing: results depend on the inputs of the call alone, to the last bit. Nothing needs saving */
  WRC_START_WARM = 1, /**< from the contact's last solution. Results depend on earlier calls, within the tolerance. For explicit
                           integrators and fixed steps, not for implicit ones */
  WRC_START_MARK = 2  /**< of wrc_contact_wrench() alone: from the solution that wrc_contact_mark() marked; cold before the first
                           mark. Results depend on that mark and the inputs of the call alone, to the last bit. For every
                           integrator that accepts its steps */
};

/** Optional parts of a result. */
enum wrc_available {
  WRC_AVAILABLE_TRACTIONS = 1, /**< results that need tractions and slip: not with a method that gives forces alone */
  WRC_AVAILABLE_PLACE = 2      /**< places in the track frame: not with a gap, strips or an ellipse of the caller */
};

/** Fields of a region: one value per cell or per strip. A wheel's strips lie side by side along the rail's arc, from the gauge side
 * to the field side. Those of a contact plane lie by increasing y. Cells divide a strip; cell 0 is at its leading edge. */
enum wrc_field {
  WRC_FIELD_X = 0,                /**< cells: x of the middle. Wheel: from its reference point; plane: contact frame [m] */
  WRC_FIELD_PRESSURE = 1,         /**< cells: normal pressure in the middle [Pa] */
  WRC_FIELD_TRACTION_X = 2,       /**< cells: tangential traction on the wheel along x [Pa] */
  WRC_FIELD_TRACTION_Y = 3,       /**< cells: the same along the rail's arc, or along y of the contact plane [Pa] */
  WRC_FIELD_SLIP_X = 4,           /**< cells: sliding velocity of the wheel over the rail / rolling speed, along x [-] */
  WRC_FIELD_SLIP_Y = 5,           /**< cells: the same along the rail's arc, or along y of the contact plane [-] */
  WRC_FIELD_POWER_DENSITY = 6,    /**< cells: frictional power per area, paper eq. 10 [W/m^2] */
  WRC_FIELD_FATIGUE_INDEX = 7,    /**< cells: local surface fatigue index, paper eq. 12 [-] */
  WRC_FIELD_TEMPERATURE_RISE = 8, /**< cells: temperature rise of both surfaces by friction, from that at first touch [K] */
  WRC_FIELD_STRIP_Y = 9,          /**< strips: middle. Wheel: arc length from the gauge end of the rail's profile; plane: y [m] */
  WRC_FIELD_STRIP_WIDTH = 10,     /**< strips: width [m] */
  WRC_FIELD_STRIP_CENTRE = 11,    /**< strips: x of the middle, as WRC_FIELD_X [m] */
  WRC_FIELD_STRIP_HALF_LENGTH = 12, /**< strips: half length [m] */
  WRC_FIELD_STRIP_PEAK = 13,      /**< strips: peak pressure, damping included [Pa] */
  WRC_FIELD_STRIP_POWER = 14,     /**< strips: frictional power per width [W/m] */
  WRC_FIELD_STRIP_FRICTION = 15,  /**< strips: coefficient of friction that the law gave [-] */
  WRC_FIELD_STRIP_WEAR = 16,      /**< strips: volume lost per metre rolled and per width, Sheffield's law [m] */
  WRC_FIELD_STRIP_PROFILE_Y = 17, /**< strips of a wheel: the middle in the coordinates of the rail's profile [m] */
  WRC_FIELD_STRIP_PROFILE_Z = 18, /**< strips of a wheel: the same, down [m] */
  WRC_FIELD_STRIP_ANGLE = 19,     /**< strips of a wheel: of the rail's surface about x there; < 0 on the gauge side [rad] */
  WRC_FIELD_GAP_Y = 20,           /**< rows of a planar gap: y [m] */
  WRC_FIELD_GAP_HEIGHT = 21,      /**< rows of a planar gap: smallest gap of the row [m] */
  WRC_FIELD_GAP_CENTRE = 22,      /**< rows of a planar gap: x of that smallest gap [m] */
  WRC_FIELD_GAP_CURVATURE = 23    /**< rows of a planar gap: d2h/dx2 [1/m] */
};

/** Inputs of a wrench: the columns of wrc_wrench_derivatives. */
enum wrc_wrench_input {
  WRC_BY_Y = 0,                  /**< wheel.y [m] */
  WRC_BY_Z = 1,                  /**< wheel.z [m], where the height is prescribed */
  WRC_BY_ROLL = 2,               /**< wheel.roll [rad]. With a matrix: turning of the body about the track's x */
  WRC_BY_YAW = 3,                /**< wheel.yaw [rad]. With a matrix: turning of the body about its z, which is rolled */
  WRC_BY_VELOCITY_X = 4,         /**< wheel.velocity[0] [m/s] */
  WRC_BY_VELOCITY_Y = 5,         /**< wheel.velocity[1] [m/s] */
  WRC_BY_VELOCITY_Z = 6,         /**< wheel.velocity[2] [m/s] */
  WRC_BY_ANGULAR_VELOCITY_X = 7, /**< wheel.angular_velocity[0] in its axes; with WRC_AXES_NONE roll_rate [rad/s] */
  WRC_BY_ANGULAR_VELOCITY_Y = 8, /**< wheel.angular_velocity[1]; with WRC_AXES_NONE pitch_rate [rad/s] */
  WRC_BY_ANGULAR_VELOCITY_Z = 9, /**< wheel.angular_velocity[2]; with WRC_AXES_NONE yaw_rate [rad/s] */
  WRC_BY_RAIL_Y = 10,            /**< rail.y [m] */
  WRC_BY_RAIL_Z = 11,            /**< rail.z [m] */
  WRC_BY_RAIL_ROLL = 12,         /**< rail.roll [rad] */
  WRC_BY_RAIL_Y_VELOCITY = 13,   /**< rail.y_velocity [m/s] */
  WRC_BY_RAIL_Z_VELOCITY = 14,   /**< rail.z_velocity [m/s] */
  WRC_BY_RAIL_ROLL_RATE = 15,    /**< rail.roll_rate [rad/s] */
  WRC_BY_VERTICAL_LOAD = 16,     /**< vertical_load [N], where it is prescribed */
  WRC_BY_DISTANCE = 17,          /**< distance [m], without the change of the strips' width along the track */
  WRC_BY_ANGLE = 18,             /**< angle [rad] */
  WRC_BY_RAIL_Y_SLOPE = 19,      /**< rail.y_slope [-]; 0 of a roller */
  WRC_BY_RAIL_Z_SLOPE = 20,      /**< rail.z_slope [-]; 0 of a roller */
  WRC_BY_ROLLER_RATE = 21,       /**< roller_rate [rad/s]; 0 of a rail that is no roller */
  WRC_BY_FRICTION = 22,          /**< a factor, here 1, on all coefficients of `friction` [-] */
  WRC_BY_TIME_STEP = 23          /**< time_step [s], of config.surface.memory; at time_step 0 towards larger times */
};

#define WRC_WRENCH_INPUTS 24 /**< columns of wrc_wrench_derivatives that this version fills */
#define WRC_ALL_REGIONS (-1) /**< in place of an index: all patches of a contact plane together */

/* ------------------------------------------------------------------------------------------- structs: the model */

/** A wheel or rail profile: y increases strictly, z is down. 4 to 20000 points, 1e-12 m to 35 mm apart, over 20 to 500 mm, within
 * 1 m of the origin, without a step.
 *  - Wheel: y = 0 and z = 0 at the running circle, flange at y < 0, also for a left wheel.
 *  - Rail: y towards the field side, z = 0 at the top; gauge side at y < 0 (also for a left rail). Its points go down the gauge
 *    face by track.gauge_depth at least.
 *  - A step is refused: 1 mm and more from one point to the next at over 79 degrees, between parts below 45 degrees. For a rail's
 *    upper 40 mm 56 degrees hold. */
typedef struct wrc_profile {
  int32_t kind;       /**< enum wrc_profile_kind [WRC_PROFILE_NONE] */
  uint32_t count;     /**< number of points, 4..20000 [0] */
  const double* y;    /**< `count` of them [m] [required] */
  const double* z;    /**< `count` of them [m] [required] */
  double smoothing;   /**< wavelength along the curve that keeps half its height, 0..0.05 m; 0: points are interpolated.
                           Waves of half that length keep a seventeenth. Tested: 7e-3 [0] */
  double reserved[6]; /**< 0 */
} wrc_profile;

/** Elastic and yield properties of a body. Of two different bodies all methods take 1/G = (1/G_w + 1/G_r) / 2 and
 * nu/G = (nu_w/G_w + nu_r/G_r) / 2. Kalker's K couples pressure and traction. wrc_contact_wrench() includes its leading part with
 * WRC_TANGENTIAL_STRIP_FASTSIM and without memory; all other calls in real time leave K out. Where K is not 0,
 * WRC_FLAG_DISSIMILAR_MATERIALS is set when the model is made. Theory manual, section 4. */
typedef struct wrc_material {
  double shear_modulus; /**< G, 1e8..1e12 Pa [82e9] */
  double poisson;       /**< nu, 0..0.5 [0.28] */
  double shear_yield;   /**< k, yield limit in shear, 1e6..1e11 Pa. Fatigue indices take the smaller of both bodies [250e6] */
  double reserved[5];   /**< 0 */
} wrc_material;

/** How a body takes up heat. Read by temperatures and by friction over temperature. */
typedef struct wrc_heat_properties {
  double conductivity;  /**< lambda, 0.1..1000 W/(m K) [50] */
  double density;       /**< rho, 100..1e5 kg/m^3 [7850] */
  double specific_heat; /**< c, 10..1e5 J/(kg K) [450] */
  double reserved[5];   /**< 0 */
} wrc_heat_properties;

/** Where the wheels are on their axle. */
typedef struct wrc_config_wheelset {
  double wheel_radius;         /**< nominal rolling radius, at the tape circle, 0.1..1.5 m [0.46] */
  double tape_circle_distance; /**< between the tape circles of both wheels, 0.3..3 m; not read without profiles [1.5] */
  double reserved[6];          /**< 0 */
} wrc_config_wheelset;

/** Where the rails are. Not read without profiles. */
typedef struct wrc_config_track {
  int32_t placement;       /**< enum wrc_profile_placement [WRC_PLACEMENT_GAUGE] */
  uint32_t reserved0;      /**< 0 */
  double gauge;            /**< between the gauge faces of the rails, 0.3..2.5 m [1.435] */
  double gauge_depth;      /**< depth below the rail top at which the gauge is measured, 0.005..0.04 m [0.014] */
  double rail_inclination; /**< tangent of the cant towards the track centre, -0.2..0.2; 1:40 is 0.025. 0 for
                                WRC_PROFILE_UIC60_BENCHMARK [0] */
  double rail_origin;      /**< distance of the rail profile's origin from the track's centre line, 0.2..1.5 m [0] */
  double reserved[6];      /**< 0 */
} wrc_config_track;

/** One cross section of a rail that changes along the track. A surface is a stock rail, a blade, a wing rail, a
 * nose. Its sections are blended point by point of equal share of their length. The blend is twice continuously differentiable in
 * the distance. Marks divide that length: points of equal mark belong together. A surface is there from its first section to its last;
 * where the whole rail begins or ends its section goes on. An end is best where no wheel touches it. Else the wheel rolls over its
 * edge, up to 14 mm high, with WRC_FLAG_PATCH_AT_EDGE. Height and force are continuous there; the peak pressure is not solved. A hollow
 * that is curved more than the wheel is met on one of its sides: force and place jump where that changes. Theory manual, section 9. */
typedef struct wrc_rail_section {
  double distance;      /**< along the track, -1e7..1e7 m. Within a surface it increases by 1 mm at least [0] */
  double y;             /**< place of the profile's origin from that of config.rail, to the field side, -0.5..0.5 m [0] */
  double z;             /**< the same downwards, -0.5..0.5 m [0] */
  int32_t surface;      /**< number of its surface, counted from the gauge side, 0..7; sections of one surface stand side by side [0] */
  uint32_t mark_count;  /**< number of marks, 0..64; equal for all sections of a surface [0] */
  const double* marks;  /**< `mark_count` of them: y on this profile, -0.5..0.5 m, increasing by 1 mm at least, also from
                             the ends [required] */
  wrc_profile profile;  /**< its outline from its own origin, canted by config.track.rail_inclination */
  double reserved[6];   /**< 0 */
} wrc_rail_section;

/** A wheel that is not round: a flat, a polygon, a measurement. A periodic cubic spline goes through each row. Theory manual,
 * section 9. */
typedef struct wrc_config_roundness {
  uint32_t angle_count;     /**< places round the wheel in each row, 0 or 9..20000; the first comes again at the end [0] */
  uint32_t row_count;       /**< rows across the tread, 1..16 [0] */
  const double* angles;     /**< `angle_count` of them, 0..6.2831854 rad, increasing from 0 to 2 pi. At wrc_wheel_input.angle 0,
                                 0 is the lowest point and angles grow towards +x [required] */
  const double* y;          /**< `row_count` of them: y of each row on the wheel's profile, -0.5..0.5 m, increasing; NULL: one
                                 row [NULL] */
  const double* deviations; /**< row_count * angle_count of them, row by row: radius less that of the profile, -0.005..0.005 m
                                 [required] */
  double reserved[6];       /**< 0 */
} wrc_config_roundness;

/** A check rail beside each rail, which guides the back of the wheel's flange. It is the same all along the track and moves with
 * the rail. The wheel's profile must have points on the flange's back, beyond the tip. */
typedef struct wrc_config_check_rail {
  double y;            /**< place of its profile's origin from that of config.rail, to the field side: < 0, -0.5..0 m [0] */
  double z;            /**< the same downwards: < 0 where it stands above the rail's origin, -0.5..0.5 m [0] */
  wrc_profile profile; /**< its outline as that of a rail; its field side guides. WRC_PROFILE_NONE: there is no check rail */
  double reserved[6];  /**< 0 */
} wrc_config_check_rail;

/** The normal problem. */
typedef struct wrc_config_normal {
  int32_t method;         /**< enum wrc_normal_method [WRC_NORMAL_STRIP_HALFSPACE] */
  int32_t max_iterations; /**< cap of the steps of the load search, 4..1000; not of WRC_NORMAL_STRIP_HALFSPACE [60] */
  double load_tolerance;  /**< relative error of a prescribed load, 1e-14..1e-2; not of WRC_NORMAL_STRIP_HALFSPACE [1e-10] */
  double reserved[6];     /**< 0 */
} wrc_config_normal;

/** The tangential problem. wrc_config_use() sets a published method by its name. */
typedef struct wrc_config_tangential {
  int32_t method;          /**< enum wrc_tangential_method [WRC_TANGENTIAL_STRIP_FASTSIM] */
  int32_t patch_model;     /**< enum wrc_patch_model; of FASTSIM and FaStrip [WRC_PATCH_MODEL_PATCH_SDEC] */
  int32_t bound;           /**< enum wrc_traction_bound; of FASTSIM [WRC_BOUND_PARABOLIC] */
  int32_t flexibility;     /**< enum wrc_flexibility; of FASTSIM [WRC_FLEXIBILITY_SEPARATE] */
  const char* force_table; /**< file of the force table, read once by the model; of WRC_TANGENTIAL_FORCE_TABLE [NULL] */
  double reserved[6];      /**< 0 */
} wrc_config_tangential;

/** Options of wrc_contact_wrench() alone. wrc_config_use() sets resolution, tolerance and work by the name of a setting. Times and
 * errors of settings: docs/realtime.md. */
typedef struct wrc_config_surface {
  int32_t cells;       /**< cells along each strip, in which it rolls and fields are given, 4..512 [32] */
  uint32_t memory;     /**< 0..1; 1: contacts remember the tractions of the step that wrc_contact_commit() commits, at rest and
                            rolling either way. Of WRC_TANGENTIAL_STRIP_FASTSIM [0] */
  double tread_width;  /**< width of the rail's strips where its radius of curvature is 60 mm or more, 1e-4..2e-3 m [5e-4] */
  double corner_width; /**< the same where it is 20 mm or less, at most tread_width, 5e-5..1e-3 m; linear between. Faces that
                            guide, of a check rail, have 0.2e-3 m at most [2.5e-4] */
  double tolerance;    /**< part of the contact's area that the last iteration of the normal problem moves, 1e-10..1e-2; of
                            WRC_NORMAL_STRIP_HALFSPACE. Forces, and a prescribed load, are met to a tenth of it [1e-5] */
  double max_work;     /**< work that a call may take, all heights of a prescribed load included, 1e3..1e9; of
                            WRC_NORMAL_STRIP_HALFSPACE. Its unit is one strip displacing another: an iteration over n strips
                            takes 2 n^2, n at least 4. One that would exceed it is not begun: WRC_FLAG_ITERATION_CAP [2e7] */
  double max_iterations; /**< cap of the normal problem at one height, in iterations over all strips that overlap there; over
                            those in contact about twice as many, 2..1e6; of WRC_NORMAL_STRIP_HALFSPACE. The call then ends as
                            with max_work [1e6] */
  double reserved[9];    /**< 0 */
} wrc_config_surface;

/** Options of the stages of wrc_planar.h, and of their normal methods where wrc_contact_wrench() applies them. The ellipse of any
 * region follows `regularisation`. */
typedef struct wrc_config_planar {
  int32_t strips;         /**< strips across the patch, 4..512 [60] */
  int32_t cells;          /**< cells along each strip, 4..512 [32] */
  int32_t gap_rows;       /**< rows the gap is sampled at, and most that a caller's gap has, 8..4096 [256] */
  int32_t max_patches;    /**< patches reported; more are flagged, 1..16 [4] */
  int32_t max_sweeps;     /**< cap of the sweeps over the strips on each of two grids, 4..1000; of WRC_NORMAL_STRIP_HALFSPACE
                               [16] */
  int32_t start;          /**< enum wrc_start: of the sweeps of WRC_NORMAL_STRIP_HALFSPACE. Warm, the same approach again moves
                               the force by up to 0.1 % [WRC_START_COLD] */
  int32_t regularisation; /**< enum wrc_regularisation [WRC_REGULARISE_KEEP_WIDTH] */
  int32_t non_steady;     /**< 0..1; 1: contacts remember tractions over the distances told to wrc_planar_roll(), at
                               rest and rolling either way. Of WRC_TANGENTIAL_STRIP_FASTSIM [0] */
  double gap_limit;       /**< gap up to which rows of a pose reach, 1e-5..0.02 m. Deeper approaches are continued,
                               WRC_FLAG_BEYOND_GAP [1e-3] */
  double reserved[8];     /**< 0 */
} wrc_config_planar;

/** Everything a model is made of. Begin with wrc_config_default(). A member that the chosen methods do not read must keep its
 * default: anything else is WRC_ERROR_UNSUPPORTED, with a sentence. */
typedef struct wrc_config {
  uint32_t struct_size;             /**< sizeof this struct, 1184 or more */
  int32_t instruction_set;          /**< enum wrc_instruction_set [WRC_INSTRUCTIONS_BEST] */
  wrc_profile wheel;                /**< profile of the wheel */
  wrc_profile rail;                 /**< profile of the rail; both are WRC_PROFILE_NONE or neither is */
  wrc_material wheel_material;      /**< of the wheel */
  wrc_material rail_material;       /**< of the rail */
  wrc_heat_properties wheel_heat;   /**< how the wheel takes up heat */
  wrc_heat_properties rail_heat;    /**< how the rail takes up heat */
  wrc_config_wheelset wheelset;     /**< where the wheels are on their axle */
  wrc_config_track track;           /**< where the rails are */
  wrc_config_normal normal;         /**< method of the normal problem */
  wrc_config_tangential tangential; /**< method of the tangential problem */
  wrc_config_surface surface;       /**< options of wrc_contact_wrench() */
  wrc_config_planar planar;         /**< options of the stages of wrc_planar.h */
  wrc_config_roundness roundness;   /**< of a wheel that is not round; of wrc_contact_wrench() */
  double roller_curvature;          /**< 1 / radius of a roller at the origin of the rail's profile, 0 or 1e-12..10 1/m; 0: a
                                         straight rail; of wrc_contact_wrench() [0] */
  wrc_config_check_rail check_rail; /**< beside the rail; of wrc_contact_wrench() */
  uint32_t rail_section_count;      /**< sections of a rail that changes along the track, 0..1000; of wrc_contact_wrench() [0] */
  uint32_t rail_section_size;       /**< sizeof(wrc_rail_section), with sections, 0 or 168..4096 [0] */
  const wrc_rail_section* rail_sections; /**< `rail_section_count` of them. config.rail stays the rail of the stages, and its
                                              place is the sections' [required] */
} wrc_config;

/** Where memory comes from in wrc_model_create() and wrc_contact_create(). Both functions or neither. */
typedef struct wrc_allocator {
  void* user;           /**< handed to both [NULL] */
  void* (*allocate)(void* user, uint64_t bytes, uint64_t alignment); /**< alignment is a power of two; returns NULL where no
                                                                          memory is left [NULL] */
  void (*release)(void* user, void* memory); /**< called by the destroy functions, and when a create fails [NULL] */
  double reserved[2];   /**< 0 */
} wrc_allocator;

/** A read-only view: element i is data[i]. */
typedef struct wrc_view {
  const double* data; /**< in the model's memory; NULL on failure */
  uint64_t count;     /**< elements */
  double reserved[2]; /**< 0 */
} wrc_view;

/* ------------------------------------------------------------------------------------- structs: wheel on a rail */

/** Temperatures of the bodies away from the contact. */
typedef struct wrc_bulk_temperatures {
  double wheel;       /**< of the tread, -273..2000 degC [20] */
  double rail;        /**< of the running surface, -273..2000 degC [20] */
  double reserved[2]; /**< 0 */
} wrc_bulk_temperatures;

/** Friction between the bodies, and a layer between them. Each strip has one coefficient: that at rest (`coefficient`, or of the
 * zones) times the factor of speed_law times that of temperature_law. Members of laws that are not chosen are checked and not
 * read: a program may keep the parameters of all. Theory manual, section 5. */
typedef struct wrc_friction {
  double coefficient;      /**< Coulomb, at rest, 0 or 1e-4..2; 0, no friction, in wrc_contact_wrench() alone [0.3] */
  int32_t speed_law;       /**< enum wrc_friction_speed_law [WRC_SPEED_LAW_NONE] */
  int32_t temperature_law; /**< enum wrc_friction_temperature_law [WRC_TEMPERATURE_LAW_NONE] */
  double kinetic_ratio;    /**< friction at high sliding speed over that at rest (Polach's A), 0..1 [0.4] */
  double fall_rate;        /**< Polach's B, of the exponential law, 0..1000 s/m [0.6] */
  double half_speed;       /**< sliding speed at which half of the fall is done, of the hyperbolic law, 1e-6..100 m/s [1] */
  double hot_ratio;        /**< friction of hot surfaces over that of cold ones, 0..1 [0.5] */
  double cold_temperature; /**< up to which friction is whole, -273..2000 degC [0] */
  double hot_temperature;  /**< from which friction has hot_ratio, -273..3000 degC; 1 degC above cold_temperature at least [400] */
  wrc_bulk_temperatures bulk; /**< of the bodies; read by the temperature law */
  double slope_reduction;  /**< initial slope of the creep curve over that of clean bodies: a layer, 0.01..1 [1] */
  double slope_limit;      /**< share of that slope left at large slip, 0..1; of modified FASTSIM [0.02] */
  double slope_fall;       /**< how fast the slope falls with slip, 0..1000; of modified FASTSIM [0] */
  const double* zone_y;    /**< breakpoints, `zone_count` of them, -1..1 m, increasing; two at one y make a step [required] */
  const double* zone_coefficients; /**< friction at rest at the breakpoints, `zone_count` of them, 0..2, in place of
                                        `coefficient`. Linear between them, constant beyond. A strip has its mean [required] */
  uint32_t zone_count;     /**< breakpoints, 0..64 [0] */
  int32_t zone_frame;      /**< enum wrc_zone_frame [WRC_ZONES_CONTACT_FRAME] */
  double layer_thickness;  /**< of an elasto-plastic layer between the bodies, 0..0.01 m; 0: it does not shear elastically [0] */
  double layer_modulus;    /**< of that layer in shear, 0 or 1e3..1e12 Pa; goes with a thickness [0] */
  double layer_yield;      /**< traction at which fresh layer yields, 0 or 1e3..1e11 Pa; 0: it does not yield [0] */
  double layer_hardening;  /**< rise of that traction over the length of plastic flow, < 0: the layer softens, to a tenth of
                                layer_yield at least; goes with layer_yield, -1e13..1e14 Pa/m [0] */
  double adhesion_reduction; /**< Polach's k_A: factor on the gradient of traction where the patch sticks, 0 or 0.001..1; of
                                WRC_TANGENTIAL_POLACH, which refuses 0 [1] */
  double slip_reduction;   /**< Polach's k_S: that factor where the patch slips, at most adhesion_reduction, 0 or 0.001..1; of
                                WRC_TANGENTIAL_POLACH, which refuses 0 [1] */
  const double* film_rows; /**< films in rows across rail and wheel, `film_numbers` of them, as wrc_surface_friction() fills them,
                                -1e30..1e30; of wrc_contact_wrench() [NULL] */
  uint32_t film_numbers;   /**< numbers of film_rows, 0..1288; 0: no rows [0] */
  uint32_t reserved0;      /**< 0 */
  double reserved[4];      /**< 0 */
} wrc_friction;

/** Where a wheel or wheelset is and how it moves, against the ground. */
typedef struct wrc_wheel_state {
  int32_t reference;    /**< enum wrc_wheel_reference: of y, z, velocity and the wrench's moment [WRC_REFERENCE_WHEELSET] */
  int32_t orientation;  /**< enum wrc_orientation: by roll and yaw, or by rotation [WRC_ORIENTATION_ANGLES] */
  int32_t angular_axes; /**< enum wrc_axes: by roll_rate, pitch_rate, yaw_rate, or by angular_velocity [WRC_AXES_NONE] */
  uint32_t reserved0;   /**< 0 */
  double y;             /**< displacement of the reference point to the right, -0.2..0.2 m [0] */
  double z;             /**< the same downwards, -0.5..0.2 m; 0 is the nominal height [0] */
  double roll;          /**< about x, right wheel down, -0.5..0.5 rad; 0 with a matrix [0] */
  double yaw;           /**< about the rolled z, nose to the right, -0.5..0.5 rad; 0 with a matrix [0] */
  double velocity[3];   /**< of the reference point, track axes, -200..200, -50..50, -50..50 m/s [0] */
  double roll_rate;     /**< time derivative of roll, -200..200 rad/s [0] */
  double pitch_rate;    /**< about the axle, -v / r0 rolling forwards, -2000..2000 rad/s [0] */
  double yaw_rate;      /**< time derivative of yaw, -200..200 rad/s [0] */
  double angular_velocity[3]; /**< whole, in the axes that angular_axes says, -200..200, -2000..2000, -200..200 rad/s [0] */
  double rotation[9];   /**< R of track = R body, orthonormal to 1e-6, its axle within 0.5 rad of the track's y, -1.001..1.001
                             [0] */
  double reserved[6];   /**< 0 */
} wrc_wheel_state;

/** Displacement and motion of a rail, track axes. Velocities are those of its material: a bent rail at rest has none, and
 * speed * slope is never one. Its slopes say where it leads: it is turned about P, the shortest way, into (1, y_slope, z_slope).
 * Sections of a rail are turned with it. A roller has no slopes. */
typedef struct wrc_rail_state {
  double y;           /**< displacement of the origin of its profile to the right, at the wheel, -0.2..0.2 m [0] */
  double z;           /**< the same downwards, -0.2..0.2 m [0] */
  double roll;        /**< rotation about that origin and the x axis, -0.5..0.5 rad [0] */
  double y_slope;     /**< dy / dx of the rail at the wheel, -0.1..0.1 [0] */
  double z_slope;     /**< dz / dx of the rail at the wheel, -0.1..0.1 [0] */
  double y_velocity;  /**< of its material along y, -50..50 m/s [0] */
  double z_velocity;  /**< of its material along z, -50..50 m/s [0] */
  double roll_rate;   /**< of its material about x, -200..200 rad/s [0] */
  double reserved[6]; /**< 0 */
} wrc_rail_state;

/** How a frame moves that follows a curved track, for hosts whose velocities are those within it. Its origin is on the track
 * centre line, level with the rails' tops. It turns at speed * (twist, vertical_curvature, curvature) about its axes. That
 * motion is added to the wheel's. All zero: velocities are against the ground. Velocities of the rail always are. */
typedef struct wrc_frame_motion {
  double speed;              /**< of its origin along the track, -200..200 m/s [0] */
  double curvature;          /**< of the track in plan, to the right, -0.1..0.1 1/m [0] */
  double vertical_curvature; /**< of the track's height, upwards as in a dip, -0.1..0.1 1/m [0] */
  double twist;              /**< rate of the cant over the speed, right side down, -0.5..0.5 1/m [0] */
  double reserved[4];        /**< 0 */
} wrc_frame_motion;

/** Input of wrc_contact_wrench(). Data behind its pointers belong to the caller and are only read during the call. */
typedef struct wrc_wheel_input {
  uint32_t struct_size;  /**< sizeof this struct, 712 or more */
  int32_t prescribed;    /**< enum wrc_prescribed: WRC_PRESCRIBE_HEIGHT or _VERTICAL_LOAD [WRC_PRESCRIBE_HEIGHT] */
  int32_t start;         /**< enum wrc_start [WRC_START_COLD] */
  uint32_t reserved0;    /**< 0 */
  wrc_wheel_state wheel; /**< where the wheel is and how it moves */
  wrc_rail_state rail;   /**< where the rail is and how it moves */
  wrc_frame_motion frame; /**< motion of the axes that velocities are given in */
  wrc_friction friction; /**< of each strip at its own sliding speed; zones count from the origin of a profile */
  double vertical_load;  /**< vertical force on the wheel, creep forces included, upwards positive, 1e2..1e6 N [0] */
  double damping;        /**< factor of Hunt and Crossley: each strip's pressure is the elastic one times 1 + 3/2 damping
                              d(overlap)/dt, never below 0, 0..10 s/m [0] */
  double distance;       /**< of the reference point along the track, for a rail with sections, or from above the axle of a
                              roller, -1e7..1e7 m [0] */
  double angle;          /**< of the wheel about its axle, for one with config.roundness, right-hand rule about y, -1e9..1e9 rad
                              [0] */
  double roller_rate;    /**< angular velocity of a roller about its axle, right-hand rule about y, -2000..2000 rad/s [0] */
  double time_step;      /**< time since the step that wrc_contact_commit() committed, over which the velocities act, 0..1e6 s; of
                              config.surface.memory [0] */
} wrc_wheel_input;

/** Forces and moments between a wheel and its rail. All are zero but z and clearance where they do not touch. */
typedef struct wrc_wrench {
  uint32_t struct_size;  /**< sizeof this struct, 168 or more */
  uint32_t flags;        /**< bit 1 << flag for each WRC_FLAG_... met */
  int32_t region_count;  /**< separate regions in contact: wrc_contact_region() */
  int32_t iterations;    /**< of the normal problem, all of the call */
  double force[3];       /**< on the wheel, track axes [N] */
  double moment[3];      /**< on the wheel about its reference point, track axes [N m] */
  double rail_force[3];  /**< on the rail, track axes: -force [N] */
  double rail_moment[3]; /**< on the rail about the displaced origin of its profile, track axes [N m] */
  double z;              /**< displacement of the reference point, as given or as found [m] */
  double clearance;      /**< apart, at a given height: by how much the wheel must be lowered to touch. 50e-3: that or more.
                              wrc_exact_wrench() has 0 [m] */
  double normal_force;   /**< sum over the regions of the resultants of their pressures. It steps where regions join [N] */
  double area;           /**< [m^2] */
  double peak_pressure;  /**< [Pa] */
  double power;          /**< frictional power, >= 0 [W] */
  double steepest_angle; /**< largest angle of a rail strip in contact against the horizontal. It steps where strips enter [rad] */
  double residual;       /**< part of the area that the last iteration of the normal problem moved: within config.surface.tolerance
                              but for WRC_FLAG_ITERATION_CAP. Of WRC_NORMAL_STRIP_HALFSPACE [-] */
  double work;           /**< of the call, in the unit of config.surface.max_work [-] */
} wrc_wrench;

/** Derivatives of the wrench on the wheel about its reference point. What is prescribed is held: under a given load the height
 * follows all other inputs, and the column of z is zero. */
typedef struct wrc_wrench_derivatives {
  uint32_t struct_size;  /**< sizeof this struct, 1800 or more */
  uint32_t reserved0;    /**< 0 */
  double wrench[6][32];  /**< rows force x, y, z [N], moment x, y, z [N m]; columns enum wrc_wrench_input, the rest 0 */
  double z[32];          /**< of wrc_wrench.z; columns the same */
} wrc_wrench_derivatives;

/* ------------------------------------------------------------------------------------- structs: results by region */

/** Rigid slip of the wheel over the rail per rolled length. At (x, y) of the contact plane it is
 * (longitudinal - spin y, lateral + spin x). An amount below 1e-100 counts as 0. */
typedef struct wrc_creepage {
  double longitudinal;      /**< nu_x, -10..10 [0] */
  double lateral;           /**< nu_y, -10..10 [0] */
  double spin;              /**< phi, -1000..1000 1/m [0] */
  double speed;             /**< rolling speed V, -200..200 m/s. Its sign says which edge leads, its amount scales power [1] */
  double approach_velocity; /**< result of wrc_planar_creepages(): of the wheel into the rail along the normal [m/s] */
  double reverse_share;     /**< share of the solution that rolls the other way, 0..0.5: near standstill both are solved. A
                                 result of wrc_planar_creepages() [0] */
  double reserved[4];       /**< 0 */
} wrc_creepage;

/** An equivalent double ellipse and its load: two half ellipses of equal length that meet at the joint. */
typedef struct wrc_ellipse {
  double a;            /**< semi-axis along rolling, 1e-6..0.1 m [0] */
  double b;            /**< half its width, 1e-6..0.1 m. It reaches from y - b (1 - psi) to y + b (1 + psi) [0] */
  double psi;          /**< shape number, -0.95..0.95; 0 is an ellipse; paper eq. 2 [0] */
  double y;            /**< result: its joint, as WRC_FIELD_STRIP_Y [m] */
  double normal_force; /**< compressive positive, damping included, 1e-3..1e7 N [0] */
  double reserved[3];  /**< 0 */
} wrc_ellipse;

/** One region of a wheel in contact, a run of neighbouring strips, or one patch of a contact plane. The wrench does not depend on
 * where regions are divided. */
typedef struct wrc_region {
  uint32_t struct_size;  /**< sizeof this struct, 408 or more */
  uint32_t available;    /**< bits of enum wrc_available; members without their bit are 0 */
  int32_t strip_count;   /**< number of its strips */
  int32_t cell_count;    /**< cells along each of them */
  int32_t surface;       /**< of the rail, as wrc_rail_section.surface. With a check rail 0 is that and 1 the rail */
  uint32_t reserved0;    /**< 0 */
  double point[3];       /**< wheel: centre of pressure, x from the reference point; plane: the ellipse's joint; track axes [m] */
  double normal[3];      /**< unit vector into the rail, track axes [-] */
  double y_wheel;        /**< that point in the coordinates of the wheel's profile, flange side negative [m] */
  double z_wheel;        /**< the same, down from the tape circle [m] */
  double y_rail;         /**< that point in the coordinates of the rail's profile, field side positive [m] */
  double z_rail;         /**< the same, down from the profile's origin [m] */
  double angle;          /**< contact angle about x from the track's z to the normal; < 0 on the right rail's gauge side [rad] */
  double rolling_radius; /**< of the wheel at that point [m] */
  double force[3];       /**< on the wheel, track axes [N] */
  double moment[3];      /**< on the wheel about `point`, track axes [N m] */
  double normal_force;   /**< resultant of the pressure, compressive positive [N] */
  double longitudinal_force; /**< sum of the strips' tangential forces along x [N] */
  double lateral_force;  /**< sum of the strips' tangential forces across the rail, to the right [N] */
  double spin_moment;    /**< of tractions about the normal. Wheel: through `point`; plane: through the origin of its frame [N m] */
  wrc_creepage creepage; /**< wheel: means over the load; plane: as given */
  wrc_ellipse ellipse;   /**< its equivalent double ellipse, of a wheel laid flat along the rail's arc */
  double area;           /**< [m^2] */
  double length;         /**< extent along x: foremost to rearmost edge of all strips [m] */
  double width;          /**< extent across: y_max - y_min [m] */
  double y_min;          /**< border, as WRC_FIELD_STRIP_Y [m] */
  double y_max;          /**< see y_min */
  double peak_pressure;  /**< [Pa] */
  double power;          /**< frictional power [W] */
  double adhesion_fraction; /**< share of the area that sticks [-]; WRC_AVAILABLE_TRACTIONS */
} wrc_region;

/** Wear and fatigue numbers of a region. */
typedef struct wrc_damage {
  double power;               /**< frictional power [W] */
  double peak_power_density;  /**< [W/m^2]; WRC_AVAILABLE_TRACTIONS */
  double t_gamma;             /**< power / speed: energy dissipated per metre rolled, spin included [N] */
  double t_gamma_no_spin;     /**< |Fx nu_x + Fy nu_y|: the other definition in use [N] */
  double utilisation;         /**< mu_a = sqrt(Fx^2 + Fy^2) / N: abscissa of the shakedown map [-] */
  double load_factor;         /**< p0 / k: ordinate of the shakedown map [-] */
  double shakedown_limit;     /**< of load_factor at mu_a, line contact; ratcheting above [-] */
  double fatigue_index;       /**< FI = mu_a - k / p0, paper eq. 11; damage when positive [-] */
  double local_fatigue_index; /**< largest local index over the region, paper eq. 12 [-]; WRC_AVAILABLE_TRACTIONS */
  uint32_t available;         /**< bits of enum wrc_available; members without their bit are 0 */
  uint32_t reserved0;         /**< 0 */
  double reserved[6];         /**< 0 */
} wrc_damage;

/* ------------------------------------------------------------------------------------------------ about the library */

/** Version of the library. @return major * 65536 + minor * 256 + patch. @rt hard @thread free */
WRC_API uint32_t wrc_version(void);
/** ABI version of the library. @return WRC_ABI_VERSION of the header it was built with. @rt hard @thread free */
WRC_API uint32_t wrc_abi_version(void);
/** Whether the library serves an interface, and if not what to do: why wrc_get_api() returned NULL.
 * @param requested WRC_ABI_VERSION of the header the caller was compiled with
 * @return a sentence; static storage, never NULL. @rt hard @thread free */
WRC_API const char* wrc_version_text(uint32_t requested);
/** Text for a question to support: version, both interfaces, commit, compiler, flags, and the instruction set that this
 * processor gets by default. @return one line; static storage, never NULL. @rt init @thread free */
WRC_API const char* wrc_build_info(void);
/** Name of a status. @param status any number @return for example "WRC_ERROR_RANGE", or "unknown status"; static
 * storage, never NULL. @rt hard @thread free */
WRC_API const char* wrc_status_name(int32_t status);
/** Meaning of a status in one line. @param status any number @return the text, or "unknown status"; static storage,
 * never NULL. @rt hard @thread free */
WRC_API const char* wrc_status_text(int32_t status);

/* ------------------------------------------------------------------------------------------------------- defaults */

/** @name Defaults
 * wrc_X_default() gives a struct with its defaults. wrc_X_init() writes them into a struct of the caller. Where the struct has
 * struct_size, the caller sets it before, and that many bytes are written. WRC_OK; WRC_ERROR_NULL (no struct);
 * WRC_ERROR_STRUCT_SIZE (not set, or smaller than the first published version).
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_config_init(wrc_config* config); /**< Defaults: configuration. */
WRC_API int32_t wrc_material_init(wrc_material* material); /**< Defaults: material of a body. */
WRC_API int32_t wrc_friction_init(wrc_friction* friction); /**< Defaults: friction. */
WRC_API int32_t wrc_wheel_input_init(wrc_wheel_input* input); /**< Defaults: wheel's input. */
/** @cond */
#define WRC_DEFAULT(type)                   \
  static inline type type##_default(void) { \
    type value;                             \
    memset(&value, 0, sizeof value);        \
    type##_init(&value);                    \
    return value;                           \
  }
#define WRC_DEFAULT_SIZED(type)                 \
  static inline type type##_default(void) {     \
    type value;                                 \
    memset(&value, 0, sizeof value);            \
    value.struct_size = (uint32_t)sizeof value; \
    type##_init(&value);                        \
    return value;                               \
  }
WRC_DEFAULT_SIZED(wrc_config)
WRC_DEFAULT(wrc_material)
WRC_DEFAULT(wrc_friction)
WRC_DEFAULT_SIZED(wrc_wheel_input)
/** @endcond */
/** @} */

/* ---------------------------------------------------------------------------------------------------------- model */

/** Sets members of a configuration by a name, and no others.
 *  - A published tangential method, of WRC_PRESET_LIST (wrc_methods.h), for example "FASTSIM-SDEC": method, patch_model, bound,
 *    flexibility of config.tangential and config.planar.regularisation. "modified FASTSIM" is FASTSIM-EQ.L until
 *    friction.slope_fall > 0. "KBTNH-type table" needs config.tangential.force_table.
 *  - A resolution of wrc_contact_wrench(), of WRC_RESOLUTION_LIST: "default", "real time" or "reference": tread_width,
 *    corner_width, tolerance, max_work, max_iterations of config.surface.
 * @param[in,out] config of wrc_config_default()
 * @param name one of both lists
 * @param[out] text the sentence behind the status, terminated, cut if need be; empty after WRC_OK; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _UNSUPPORTED (no such name; the sentence lists all). @rt init @thread free */
WRC_API int32_t wrc_config_use(wrc_config* config, const char* name, char* text, uint64_t size);

/** Sets the law and the layer of friction by a name of WRC_FRICTION_LIST (wrc_methods.h), which has their sources: "Polach dry",
 * "sand", "locomotive" ... It sets coefficient, speed_law, kinetic_ratio, fall_rate, slope_reduction (1), slope_fall (0),
 * adhesion_reduction, slip_reduction and the members of the layer. Other members keep their values. Theory manual, section 5.
 * @param[in,out] friction of wrc_friction_default()
 * @param name one of the list
 * @param[out] text the sentence behind the status, terminated, cut if need be; empty after WRC_OK; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _UNSUPPORTED (no such name; the sentence lists all). @rt init @thread free */
WRC_API int32_t wrc_friction_use(wrc_friction* friction, const char* name, char* text, uint64_t size);

/** Says whether a model can be made of a configuration, and if not why, as a sentence.
 * @param config configuration to check
 * @param[out] text the sentence, cut if need be and terminated when size > 0; empty when all is well; NULL: not wanted
 * @param size bytes of text
 * @return as wrc_model_create(). @rt init @thread free */
WRC_API int32_t wrc_config_check(const wrc_config* config, char* text, uint64_t size);

/** Memory a model needs. The shape of profile points is not looked at.
 * @param config configuration of the model
 * @param[out] bytes size, @param[out] alignment in bytes; both zero on failure
 * @return as wrc_model_init(). @rt init @thread free */
WRC_API int32_t wrc_model_size(const wrc_config* config, uint64_t* bytes, uint64_t* alignment);

/** Makes a model in the caller's memory. Profiles are copied: config and all it points to may go away afterwards. The
 * memory stays the caller's and must outlive every contact of the model. There is nothing to destroy.
 * @param config configuration of the model
 * @param memory aligned as wrc_model_size() says
 * @param bytes of memory, at least what wrc_model_size() says
 * @param[out] model the model; NULL on failure
 * @param[out] text the sentence of a failure, as wrc_config_check(); NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_DISSIMILAR_MATERIALS; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE, _PROFILE, _UNSUPPORTED,
 * _BUFFER, _FILE. @rt init @thread free */
WRC_API int32_t wrc_model_init(const wrc_config* config, void* memory, uint64_t bytes, wrc_model** model, char* text,
                               uint64_t size);

/** wrc_model_init() with memory the library gets itself. Takes about 20 ms with profiles.
 * @param config configuration of the model
 * @param allocator where memory comes from; NULL: malloc and free
 * @param[out] model the model, to be released with wrc_model_destroy(); NULL on failure
 * @param[out] text the sentence of a failure, as wrc_config_check(); NULL: not wanted
 * @param size bytes of text
 * @return as wrc_model_init(), and WRC_ERROR_MEMORY. @rt init @thread free */
WRC_API int32_t wrc_model_create(const wrc_config* config, const wrc_allocator* allocator, wrc_model** model, char* text,
                                 uint64_t size);

/** Shows a profile as the model uses it, smoothed and placed, without copying it. Views are valid as long as the model.
 * @param model a model with profiles
 * @param side enum wrc_side: where it is placed
 * @param body enum wrc_body
 * @param[out] y nodes of the curve [m]. Wheel: from the middle of the wheelset; rail: track frame; NULL: not wanted
 * @param[out] z their heights [m]. Wheel: below its running circle; rail: below its top; NULL: not wanted
 * @param[out] deviation largest distance between a given point and the smoothed curve [m]; NULL: not wanted
 * @return WRC_OK; WRC_ERROR_NULL, _SEQUENCE (model without profiles), _UNSUPPORTED (no such side or body).
 * @rt hard @thread free */
WRC_API int32_t wrc_model_profile(const wrc_model* model, int32_t side, int32_t body, wrc_view* y, wrc_view* z,
                                  double* deviation);

/** Releases a model made by wrc_model_create(). Destroy its contacts first.
 * @param model NULL is fine @rt init @thread free */
WRC_API void wrc_model_destroy(wrc_model* model);

/* -------------------------------------------------------------------------------------------------------- contact */

/** Memory a contact of this model needs.
 * @param model the model
 * @param[out] bytes size, @param[out] alignment in bytes; both zero on failure
 * @return WRC_OK, WRC_ERROR_NULL. @rt hard @thread free */
WRC_API int32_t wrc_contact_size(const wrc_model* model, uint64_t* bytes, uint64_t* alignment);

/** Makes a contact in the caller's memory, every page of which it touches. The model must outlive the contact. The memory stays
 * the caller's. There is nothing to destroy.
 * @param model its model, which serves both sides
 * @param side enum wrc_side: which wheel of the wheelset, and the rail it is on
 * @param memory aligned as wrc_contact_size() says
 * @param bytes of memory, at least what wrc_contact_size() says
 * @param[out] contact the contact; NULL on failure
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK, WRC_ERROR_NULL, _UNSUPPORTED (no such side), _BUFFER. @rt hard, long @thread free */
WRC_API int32_t wrc_contact_init(const wrc_model* model, int32_t side, void* memory, uint64_t bytes, wrc_contact** contact,
                                 char* text, uint64_t size);

/** wrc_contact_init() with memory the library gets itself.
 * @param model its model, which serves both sides
 * @param side enum wrc_side: which wheel of the wheelset, and the rail it is on
 * @param allocator where memory comes from; NULL: malloc and free
 * @param[out] contact the contact, to be released with wrc_contact_destroy(); NULL on failure
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return as wrc_contact_init(), and WRC_ERROR_MEMORY. @rt init @thread free */
WRC_API int32_t wrc_contact_create(const wrc_model* model, int32_t side, const wrc_allocator* allocator, wrc_contact** contact,
                                   char* text, uint64_t size);

/** Releases a contact made by wrc_contact_create().
 * @param contact NULL is fine @rt init @thread contact */
WRC_API void wrc_contact_destroy(wrc_contact* contact);

/** Length of a saved state, some 0.08 MB.
 * @param model the model
 * @param[out] bytes size; zero on failure
 * @return WRC_OK, WRC_ERROR_NULL. @rt hard @thread free */
WRC_API int32_t wrc_contact_state_size(const wrc_model* model, uint64_t* bytes);

/** Copies the state of a contact out of it, for a rejected step of an integrator or a rollback. The copy is good for any contact of
 * the same model and side in this process. With cold starts results do not depend on it, and nothing needs saving.
 * @param contact the contact
 * @param[out] buffer the copy; no alignment needed
 * @param bytes of buffer, at least what wrc_contact_state_size() says
 * @return WRC_OK, WRC_ERROR_NULL, _BUFFER. @rt hard @thread contact */
WRC_API int32_t wrc_contact_save(wrc_contact* contact, void* buffer, uint64_t bytes);

/** Puts a saved state back, bit for bit, the sentence of wrc_contact_last_error() included. A call that fails changes that
 * sentence alone.
 * @param contact a contact of the model and side the state was saved from
 * @param buffer from wrc_contact_save()
 * @param bytes of buffer, at least what wrc_contact_state_size() says
 * @return WRC_OK, WRC_ERROR_NULL, _BUFFER, _SEQUENCE (not a saved state of this model and side). @rt hard @thread
 * contact */
WRC_API int32_t wrc_contact_restore(wrc_contact* contact, const void* buffer, uint64_t bytes);

/** Length of a portable state: that of a saved state and 64 bytes.
 * @param model the model
 * @param[out] bytes size; zero on failure
 * @return WRC_OK, WRC_ERROR_NULL. @rt hard @thread free */
WRC_API int32_t wrc_contact_portable_size(const wrc_model* model, uint64_t* bytes);

/** wrc_contact_save() for another process or machine: checkpoints, a simulation that is moved. It begins with the eight letters
 * wrcstate and has a version, the byte order, a fingerprint of the configuration with its profiles, and a checksum.
 * @param contact the contact
 * @param[out] buffer the state; no alignment needed
 * @param bytes of buffer, at least what wrc_contact_portable_size() says
 * @return WRC_OK, WRC_ERROR_NULL, _BUFFER. @rt hard, long @thread contact */
WRC_API int32_t wrc_contact_save_portable(wrc_contact* contact, void* buffer, uint64_t bytes);

/** Puts a portable state into a contact of an equal configuration and side: the same numbers, profiles and force table. The
 * instruction set may differ. What follows has the bits it would have had where the state was saved. A call that fails changes
 * the sentence alone.
 * @param contact the contact
 * @param buffer from wrc_contact_save_portable()
 * @param bytes of buffer
 * @return WRC_OK; WRC_ERROR_NULL; _FILE (no such state, cut short, or changed since it was written); _UNSUPPORTED (of another
 * version of the library, or another byte order); _SEQUENCE (of another configuration or side). @rt hard, long @thread contact */
WRC_API int32_t wrc_contact_restore_portable(wrc_contact* contact, const void* buffer, uint64_t bytes);

/** The sentence behind the last status of this contact. It begins with the function's name, for example
 *   "wrc_contact_wrench: input.vertical_load = 80 N is outside 100 .. 1e+06 N: did you pass kN?"
 * and is empty after WRC_OK.
 * @param contact the contact
 * @param[out] buffer the sentence, terminated, cut if need be
 * @param size bytes of buffer
 * @return WRC_OK, WRC_ERROR_NULL, _BUFFER (size is 0). @rt hard @thread contact */
WRC_API int32_t wrc_contact_last_error(const wrc_contact* contact, char* buffer, uint64_t size);

/* -------------------------------------------------------------------------------------------------- wheel on a rail */

/** The wrench between a wheel and a rail at this pose and motion, steady rolling. Tread, gauge corner and flange are one problem. No
 * contact point is chosen: each strip of the rail's surface has its own normal, overlap and slip. The wrench is a continuous
 * function of all inputs, but where a flag says otherwise. Theory manual, section 9.
 * @par Methods
 * The defaults, WRC_NORMAL_STRIP_HALFSPACE and WRC_TANGENTIAL_STRIP_FASTSIM, are what accuracy and smoothness are stated for.
 * Other normal methods are applied patch by patch to the surface unrolled. FASTSIM with WRC_PATCH_MODEL_PATCH_SDEC and FaStrip
 * roll strip by strip. All other forms roll patch by patch, with the strips' mean slips, on the ellipse of the same moments.
 * @par Time
 * 0.02 to 0.2 ms with the default methods. A prescribed load takes about four heights, on a flange up to ten. Friction over
 * temperature doubles the time.
 * @par A given load under high friction
 * Friction on a steep face may outweigh its slope. The vertical force then falls as the wheel goes down. The highest place that
 * carries the load with a force growing downwards is returned. Where there is none, it is the place at which the force first
 * ceases to grow: then force[2] is less than the load. WRC_FLAG_CLIMBING says that none or several places carry the load.
 * @param contact of a model with profiles
 * @param input what to solve
 * @param[out] wrench the result; NULL: not wanted
 * @return WRC_OK, or the gravest flag:
 *  - WRC_FLAG_NO_CONTACT: apart. Also a wheel too deep in its rail for contact to be looked for, as a flange 4 mm inside the rail's
 *    side. The sentence then says so.
 *  - _ITERATION_CAP; _CLIMBING; _BEYOND_SECTIONS; _TABLE_RANGE; _ROTATION_TRANSPOSED.
 *  - _PATCH_AT_EDGE: contact reaches the end of a profile, or of a surface along the track. Or it lies more than 160 mm ahead
 *    or behind, where it is not looked for. _MORE_PATCHES: more regions or strips than there is room for. Or a
 *    round wheel touches a rail at three places along the track, of which two carry the load.
 *  - _CREEPAGES_LIMITED: slower than 0.1 m/s, as wrc_planar_creepages(). Or the wheel turns against its travel and slides at more
 *    than 10 times its speed of rolling. The sentence then asks for the sign of pitch_rate. Neither with config.surface.memory.
 *  - _MEMORY_DROPPED: with config.surface.memory the wheel moved, since the committed step, 1 mm further than its velocities take it.
 *  - _BEYOND_GAP: deeper than 2 mm, continued with the stiffness there.
 *  - _FORCE_JUMPS: a planar normal method on a patch of several lowest points.
 *
 * Or WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE, _LOAD (no height carries the load). _UNSUPPORTED: a model without profiles;
 * zones in a contact frame; friction over temperature of a method without tractions; with config.surface.memory friction over
 * temperature and a layer. @rt hard @thread contact */
WRC_API int32_t wrc_contact_wrench(wrc_contact* contact, const wrc_wheel_input* input, wrc_wrench* wrench);

/** Marks the contact's last solution of a wheel as accepted. Calls with WRC_START_MARK start from it until the next mark, whatever
 * was called in between: trial steps, Jacobians by differences, steps taken back. The mark is saved and restored with the state.
 * @param contact after a successful wrc_contact_wrench()
 * @return WRC_OK; WRC_ERROR_NULL; _SEQUENCE (the last call left no solution of a wheel). @rt hard @thread contact */
WRC_API int32_t wrc_contact_mark(wrc_contact* contact);

/** Commits the contact's last solution of a wheel, of a model with config.surface.memory. Later calls begin with its tractions. It is
 * marked as by wrc_contact_mark(). Until the next commit results depend on this step and the input of the call alone, to the last
 * bit. Trial steps, rejected ones and differences leave no trace. A contact begins without tractions. The committed
 * step is saved and restored with the state. Theory manual, section 5.
 * @param contact after a successful wrc_contact_wrench()
 * @return WRC_OK; WRC_ERROR_NULL; _UNSUPPORTED (a model without config.surface.memory); _SEQUENCE (the last call left no solution of
 * a wheel, or it is committed already). @rt hard @thread contact */
WRC_API int32_t wrc_contact_commit(wrc_contact* contact);

/** wrc_contact_wrench() with the derivatives of its wrench, for implicit integrators: those of the discrete equations, not
 * differences. Over temperature and with config.surface.memory the part of the tractions is a difference. The call takes two to
 * three times the time of the wrench, over temperature four to five times. With memory it takes ten times, with a load given four
 * times. Theory manual, section 9.
 * @param contact of a model of WRC_NORMAL_STRIP_HALFSPACE and WRC_TANGENTIAL_STRIP_FASTSIM; others are WRC_ERROR_UNSUPPORTED
 * @param input as for wrc_contact_wrench()
 * @param[out] wrench as for wrc_contact_wrench(), the same bits; NULL: not wanted
 * @param[out] derivatives zero without contact; with WRC_FLAG_BEYOND_GAP those at 2 mm overlap; NULL: not wanted
 * @return as wrc_contact_wrench(); WRC_FLAG_MORE_PATCHES and zero derivatives with more strips in contact than there is room for:
 * 76 of the default widths, 56 at "real time".
 * @rt hard @thread contact */
WRC_API int32_t wrc_contact_wrench_derivatives(wrc_contact* contact, const wrc_wheel_input* input, wrc_wrench* wrench,
                                               wrc_wrench_derivatives* derivatives);

/** wrc_contact_wrench() for many contacts, in order, on the calling thread. A host with threads gives each its own range of contacts,
 * with the same results. A contact that fails has zeros in its result and a sentence of its own; the others are solved.
 * @param contacts count of them, each once
 * @param count how many; 0: nothing is done
 * @param inputs the first input; element i lies i * input_stride bytes behind it
 * @param input_stride [bytes]; 0: the same input for all
 * @param[out] wrenches the first result; element i lies i * wrench_stride bytes behind it
 * @param wrench_stride [bytes]
 * @param[out] statuses count of them, one for each contact, as wrc_contact_wrench() returns it; NULL: not wanted
 * @return the gravest status of all; WRC_ERROR_NULL (contacts, inputs or wrenches). @rt hard @thread contact, all of them */
WRC_API int32_t wrc_contact_wrench_batch(wrc_contact* const* contacts, uint32_t count, const wrc_wheel_input* inputs,
                                         uint64_t input_stride, wrc_wrench* wrenches, uint64_t wrench_stride,
                                         int32_t* statuses);

/* ------------------------------------------------------------------------------------------------ results by region */

/** One region of the contact's last solution: of wrc_contact_wrench() or of the stages of wrc_planar.h, whichever came later. The
 * results stay. After a restored state or derivatives the first call here or below solves wrc_planar_tangential() again, at its cost.
 * @param contact the contact; its work space is used
 * @param index 0 .. number of regions - 1, from the gauge side to the field side of a rail, on a contact plane by increasing y
 * @param[out] region the region
 * @return WRC_OK; WRC_FLAG_TABLE_RANGE (|psi| cut to 0.95); WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no solution), _RANGE (no such
 * region). @rt hard @thread contact */
WRC_API int32_t wrc_contact_region(wrc_contact* contact, int32_t index, wrc_region* region);

/** A field of one region of the contact's last solution, written into memory of the caller.
 * @param contact the contact; its work space is used
 * @param index as for wrc_contact_region(); rows of a gap ignore it
 * @param field enum wrc_field
 * @param[out] values element (cell i, strip j) at j * counts[0] + i; NULL: not wanted, only counts are
 * @param room numbers that values has room for
 * @param[out] counts two of them: cells of each strip (1 of a field over strips or rows), and strips or rows; NULL: not wanted
 * @return WRC_OK; WRC_ERROR_NULL (values and counts); _SEQUENCE (no solution, or no gap); _RANGE (no such region); _UNSUPPORTED (no
 * such field, or the solution has no tractions); _BUFFER (too little room: nothing is written). @rt hard @thread contact */
WRC_API int32_t wrc_contact_field(wrc_contact* contact, int32_t index, int32_t field, double* values, uint64_t room,
                                  uint64_t* counts);

/** Wear and fatigue numbers of one region of the contact's last solution. Theory manual, section 6; paper eq. 10 to 12.
 * @param contact the contact; its work space is used
 * @param index as for wrc_contact_region(); WRC_ALL_REGIONS: all patches of a contact plane together
 * @param[out] damage the numbers
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL; _SEQUENCE (no solution); _RANGE (no such region, or
 * WRC_ALL_REGIONS of a wheel). @rt hard @thread contact */
WRC_API int32_t wrc_contact_damage(wrc_contact* contact, int32_t index, wrc_damage* damage);

/* ---------------------------------------------------------------------------------------------------- for dlopen */

/** Every function of wrc.h and wrc_planar.h as a table: wrc_api.h. */
typedef struct wrc_api wrc_api;

/** The function table of this library. Members are only ever added at its end: ask WRC_API_HAS() for those of a later version.
 * @param abi_version WRC_ABI_VERSION of the header you compiled with
 * @return the table, in static storage; NULL when the library does not serve that version: wrc_version_text() says
 * why. @rt hard @thread free */
WRC_API const wrc_api* wrc_get_api(uint32_t abi_version);

/** Every function of wrc_damage.h, wrc_surface.h, wrc_offline.h and wrc_profiles.h as a table: wrc_experimental_api.h. */
typedef struct wrc_experimental_api wrc_experimental_api;

/** The function table of what may change in a minor version.
 * @param experimental_version WRC_EXPERIMENTAL_VERSION of the header you compiled with
 * @return the table, in static storage; NULL when the library has another version of it. @rt hard @thread free */
WRC_API const wrc_experimental_api* wrc_get_experimental_api(uint32_t experimental_version);

#ifdef __cplusplus
}
#endif

#endif /* WRC_H */
