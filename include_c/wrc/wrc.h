/** @file wrc.h
 * Wheel/rail contact for real-time simulation: everything a real-time caller needs.
 *
 * @par What it does
 * In: two profiles and a wheelset pose (or the undeformed gap itself), a load or an approach, creepages, friction.
 * Out: contact patch, pressure, tractions, slip, forces, frictional power, wear and rolling contact fatigue numbers.
 *
 *     wrc_model    what does not change during a run: profiles, material, methods, grid. Immutable after creation;
 *                  any number of threads may use one model.
 *     wrc_contact  one wheel/rail pair: results of the last call and work space. One thread at a time.
 *
 * A step is five stages; call them together (wrc_planar_step) or one by one, or enter in the middle with your own
 * data:
 *
 *     wrc_planar_geometry        pose            -> initial contact point, contact angle, gap    (skip it: hand over a gap)
 *     wrc_planar_normal          gap, load       -> contact patch as strips, pressure, approach  (skip it: hand over strips)
 *     wrc_planar_regularise      strips          -> equivalent double ellipse (SDEC) a, b, psi   (skip it: hand over a patch)
 *     wrc_planar_tangential      patch, creepage -> tractions, slip, forces, frictional power
 *     wrc_contact_damage          fields          -> wear and fatigue numbers
 *
 * @par Frame, signs, units
 * SI throughout: m, N, Pa, rad, s, W. (80 kN is 80e3; S1002 points in mm must be scaled by 1e-3.)
 *  - Track frame: x forward along the track, y to the right, z down; origin between the rails, level with their tops.
 *  - Contact frame: origin at the initial contact point, x as that of the track, y lateral in the contact plane (to the
 *    right), z normal into the rail. Right-handed. For a right wheel y > 0 is the field side, y < 0 the flange side.
 *    Particles enter the patch at its +x end when rolling forward (speed > 0), at its -x end when rolling backwards.
 *  - Creepage: rigid slip of the wheel over the rail per unit rolled length at (x, y) is
 *    (longitudinal - spin * y, lateral + spin * x), referred to the origin of the contact frame. The unit is an amount:
 *    whichever way the wheel rolls, creepages have the signs of the sliding velocities.
 *  - Forces and tractions act ON THE WHEEL and oppose the slip: for small creepage F_x = -G a b C11 longitudinal.
 *
 * @par Conventions of the interface
 *  - Every function that can fail returns a status: 0 done, > 0 done but flagged, < 0 failed with every output zeroed
 *    and the objects usable for the next call. wrc_contact_last_error() turns that of a stage into a sentence with
 *    field, value, unit, allowed range and likely cause. wrc_status.h lists them all.
 *  - wrc_config config = wrc_config_default(); and so for every struct that is read: defaults by value. Hosts that
 *    load the library at run time, and other languages, call wrc_..._init instead. 0 is 0, never a sign for something
 *    else.
 *  - Structs that may grow begin with struct_size, set by wrc_..._default(); for wrc_..._init set it to sizeof the
 *    struct first. One of an older header (smaller struct_size) is honoured; from version 1.0 on, for ever. It is
 *    needed in those that are written, too. All other structs are as they are, for ever from 1.0 on.
 *  - What a result does not have is 0, and its bit is missing in `available`: never NaN, never a number that stands
 *    for it.
 *  - A member's comment says what it may be: its range and unit, then [its default], then likely mistakes, which
 *    messages name. The library's checks and defaults, the Fortran module and the manual's tables are made of these
 *    comments. A result has its unit in brackets and no default.
 *  - NULL is never dereferenced: each function says what NULL means; elsewhere it is WRC_ERROR_NULL.
 *  - Nothing is kept of what a caller passes, except the memory handed to an init or create and the model of a contact.
 *  - Real-time class: "rt hard" functions never allocate, lock, throw, print, read a file, the environment, the
 *    locale or a clock, never call the system, and have a hard bound on their iterations. "rt init" functions may
 *    allocate and take milliseconds.
 *  - Thread class: "thread free" any thread any time; "thread contact" one thread at a time per contact.
 *  - The floating-point environment of the host (rounding, traps, flush to zero) is set aside and restored by
 *    every call that computes: traps the host has enabled do not fire inside.
 *
 * @par On Windows
 * wrc.dll: link its import library, or load it at run time (examples_c/load_at_run_time.c). Memory handed to an init
 * comes from _aligned_malloc or the like, with the alignment asked for: malloc gives 16 bytes. Names of files are in
 * the process's code page.
 *
 * Valid as C99 to C23 and C++98 to C++23. "Paper" below is Liu and Bruni, Proc. IMechE Part F 238(4) (2024) 427-436.
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
#define WRC_VERSION_MINOR 2 /**< see WRC_VERSION_MAJOR */
#define WRC_VERSION_PATCH 0 /**< see WRC_VERSION_MAJOR */
/** Raised only when an existing caller would break; new functions and fields do not raise it. */
#define WRC_ABI_VERSION 2

/* ------------------------------------------------------------------------------------------------------ handles */

/** Profiles, material, methods, grid: immutable once made, shared by any number of contacts and threads. */
typedef struct wrc_model wrc_model;
/** One wheel/rail pair: results of the last call and work space. One thread at a time. */
typedef struct wrc_contact wrc_contact;

/* ------------------------------------------------------------------------------------------------- enumerations */

/** Which wheel of the wheelset. The left wheel has its flange at y > 0; frames and signs stay those of the top. */
enum wrc_side {
  WRC_SIDE_RIGHT = 0, /**< flange at y < 0 */
  WRC_SIDE_LEFT = 1   /**< flange at y > 0 */
};

/** Where a profile comes from. */
enum wrc_profile_kind {
  WRC_PROFILE_NONE = 0,            /**< of both bodies: no geometry, the caller hands over gaps */
  WRC_PROFILE_POINTS = 1,          /**< points y, z of the caller, joined by a cubic spline */
  WRC_PROFILE_S1002 = 2,           /**< wheel, EN 13715, from its analytic definition */
  WRC_PROFILE_60E1 = 3,            /**< rail, nominal head (R300/R80/R13), uncanted: set rail_inclination, e.g. 1/40 */
  WRC_PROFILE_UIC60_BENCHMARK = 4  /**< rail of the Manchester benchmark; canted 1:40 already: rail_inclination = 0 */
};

/** Which of the two bodies. */
enum wrc_body {
  WRC_BODY_WHEEL = 0, /**< the wheel */
  WRC_BODY_RAIL = 1   /**< the rail */
};

/** Criteria by which a patch gets its equivalent double ellipse. */
enum wrc_regularisation {
  WRC_REGULARISE_KEEP_WIDTH = 0, /**< criteria (1), (2b), (3): area and width kept; the paper's choice */
  WRC_REGULARISE_KEEP_RATIO = 1  /**< criteria (1), (2), (3): area and length/width ratio kept (KBTNH) */
};

/** Form of the traction bound along a strip. All integrate to friction * load over the patch where friction is the
 * same everywhere. */
enum wrc_traction_bound {
  WRC_BOUND_PARABOLIC = 0,  /**< paper eq. 9: right slope at the leading edge; integrates to friction * load */
  WRC_BOUND_ELLIPTIC = 1,   /**< friction * pressure: the actual pressure of each strip */
  WRC_BOUND_ELLIPSOIDAL = 2 /**< friction * load spread like sqrt(x_l^2 - x^2) over the patch, whatever its pressure:
                                 the pressure of a Kik-Piotrowski patch; on double ellipses the same as ELLIPTIC */
};

/** How the flexibilities of linear theory enter FASTSIM; the other methods have their own way. */
enum wrc_flexibility {
  WRC_FLEXIBILITY_SEPARATE = 0, /**< one for each force of linear theory: right for small creepage */
  WRC_FLEXIBILITY_SINGLE = 1,   /**< Kalker's weighted sum for all: right traction directions at large creepage */
  WRC_FLEXIBILITY_BLENDED = 2   /**< from the first to the second as creepage grows; Vollebregt and Voltr, VSD 61 (2023) */
};

/** How friction depends on the sliding speed w: of a strip, the root mean square of its rigid slip times the rolling
 * speed (with friction.slope_fall: of the patch, speed * |(nu_x, nu_y)|). Theory manual, section 5. */
enum wrc_friction_kind {
  WRC_FRICTION_CONSTANT = 0,      /**< not at all */
  WRC_FRICTION_FALLING = 1,       /**< times (1 - kinetic_ratio) exp(-fall_rate w) + kinetic_ratio: Polach */
  WRC_FRICTION_STATIC_KINETIC = 2, /**< times kinetic_ratio + (1 - kinetic_ratio) / (1 + w / half_speed): from the static
                                        coefficient to the kinetic one */
  WRC_FRICTION_TEMPERATURE = 3     /**< on the temperature of the surfaces, wrc_contact_temperature(): whole up to
                                        cold_temperature, times hot_ratio from hot_temperature on, linear between, and
                                        of each strip the mean over its load; found together with the tractions. Not
                                        with a method that gives forces alone */
};

/** Where the y of friction zones counts from. */
enum wrc_zone_frame {
  WRC_ZONES_CONTACT_FRAME = 0, /**< contact frame: zones move with the contact point */
  WRC_ZONES_RAIL_PROFILE = 1,  /**< rail profile, as wrc_planar_point.y_rail: zones stay on the rail; field side > 0.
                                    Needs the contact point of a wrc_planar_geometry */
  WRC_ZONES_WHEEL_PROFILE = 2  /**< wheel profile, as wrc_planar_point.y_wheel: zones stay on the wheel, as a lubricated
                                    flange; flange side < 0. Needs the same */
};

/** Where profiles lie. */
enum wrc_profile_placement {
  WRC_PLACEMENT_GAUGE = 0, /**< rails by track_gauge and gauge_depth, their tops at z = 0: of new profiles */
  WRC_PLACEMENT_ORIGIN = 1 /**< rails by the origin of their points: it lies at y = rail_origin, z = 0, so that a worn rail
                                stays where the new one was; their inclination turns them about it */
};

/** Instruction set of the kernels. Results are the same bits with all of them. */
enum wrc_instruction_set {
  WRC_INSTRUCTIONS_BEST = 0,     /**< the widest this processor has */
  WRC_INSTRUCTIONS_BASELINE = 1, /**< what every processor of this architecture has: SSE2, NEON */
  WRC_INSTRUCTIONS_AVX2 = 2,     /**< x86-64 with AVX2 */
  WRC_INSTRUCTIONS_AVX512 = 3    /**< x86-64 with AVX-512 F, DQ, VL */
};

/** Which of load and approach is given; the other is a result. */
enum wrc_prescribed {
  WRC_PRESCRIBE_NORMAL_FORCE = 0,    /**< normal_force is given */
  WRC_PRESCRIBE_APPROACH = 1 /**< approach is given: the choice near lift-off */
};

/** What a result holds besides what it always has. */
enum wrc_available {
  WRC_AVAILABLE_TRACTIONS = 1, /**< what is made of tractions and slip: not with a method that gives forces alone */
  WRC_AVAILABLE_PLACE = 2      /**< places in the track frame: not with a gap, strips or an ellipse of the caller */
};

/** Arrays of the last step that wrc_contact_field() shows without copying, in the contact frame. Fields over cells have
 * count[0] = cells along the strip (0 is at the leading edge: at +x, rolling backwards at -x) and count[1] = strips
 * (by increasing y); fields over strips have count[0] = strips. After wrc_planar_tangential strips are those the
 * tractions live on: of the ellipse, where the patch model has one. */
enum wrc_field_id {
  WRC_FIELD_X = 0,               /**< cells: x of the cell centre [m] */
  WRC_FIELD_PRESSURE = 1,        /**< cells: normal pressure [Pa] */
  WRC_FIELD_TRACTION_X = 2,      /**< cells: tangential traction on the wheel [Pa] */
  WRC_FIELD_TRACTION_Y = 3,      /**< cells: see WRC_FIELD_TRACTION_X */
  WRC_FIELD_SLIP_X = 4,          /**< cells: sliding velocity / rolling speed [-] */
  WRC_FIELD_SLIP_Y = 5,          /**< cells: see WRC_FIELD_SLIP_X */
  WRC_FIELD_POWER_DENSITY = 6,   /**< cells: power per area, paper eq. 10 [W/m^2]; needs wrc_contact_damage */
  WRC_FIELD_FATIGUE_INDEX = 7,   /**< cells: local surface fatigue index, paper eq. 12 [-]; needs wrc_contact_damage */
  WRC_FIELD_STRIP_Y = 8,         /**< strips: lateral middle [m] */
  WRC_FIELD_STRIP_WIDTH = 9,     /**< strips: lateral width [m] */
  WRC_FIELD_STRIP_CENTRE = 10,   /**< strips: x of the middle [m] */
  WRC_FIELD_STRIP_HALF = 11,     /**< strips: half length [m] */
  WRC_FIELD_STRIP_PEAK = 12,     /**< strips: peak pressure [Pa] */
  WRC_FIELD_STRIP_POWER = 13,    /**< strips: frictional power per unit width [W/m]; needs wrc_contact_damage */
  WRC_FIELD_GAP_Y = 14,          /**< gap rows: y [m] (after wrc_planar_geometry or a gap of your own) */
  WRC_FIELD_GAP_HEIGHT = 15,     /**< gap rows: smallest gap of the row [m] */
  WRC_FIELD_GAP_CENTRE = 16,     /**< gap rows: x of that smallest gap [m] */
  WRC_FIELD_GAP_CURVATURE = 17,  /**< gap rows: d2h/dx2 [1/m] */
  WRC_FIELD_STRIP_WEAR = 18,     /**< strips: volume lost per metre rolled and per width, Sheffield's law [m];
                                    needs wrc_contact_wear */
  WRC_FIELD_STRIP_FRICTION = 19, /**< strips: coefficient of friction the law gave [-]; needs wrc_planar_tangential */
  WRC_FIELD_TEMPERATURE_RISE = 20 /**< cells: rise of both surfaces by friction over what they have at first touch [K];
                                     needs wrc_contact_temperature */
};

/* ------------------------------------------------------------------------------------------------------ structs */

/** A wheel or rail profile. Points: y strictly increasing, z down, 4 to 20000 points from 1e-12 m to 35 mm apart
 * (closer, slopes are made of rounding) over 20 to 500 mm, within 1 m of the origin, without a step: 1 mm or more from
 * one point to the next at over 79 degrees (of a rail: 56 degrees, on its upper 40 mm), between parts below 45 degrees
 * and a fifth as steep.
 *  - wheel: y = 0 at the running circle, flange at y < 0 (also for a left wheel), z = 0 at y = 0.
 *  - rail: y towards the field side, z = 0 at the top; gauge side at y < 0 (also for a left rail), where the points
 *    reach down to config.track.gauge_depth at least, after canting. */
typedef struct wrc_profile {
  int32_t kind;     /**< enum wrc_profile_kind [WRC_PROFILE_NONE] */
  uint32_t count;   /**< number of points, 4..20000 with WRC_PROFILE_POINTS [0]. Too small: a spline needs at least four
                         points */
  const double* y;  /**< `count` of them with WRC_PROFILE_POINTS [m] [required] */
  const double* z;  /**< `count` of them with WRC_PROFILE_POINTS [m] [required] */
  double smoothing; /**< of points only: waves of this length along the curve, 0..0.05 m, keep half their height, shorter
                         ones next to nothing (a seventeenth at half the length), longer ones nearly all; 0: the points
                         are interpolated. Tested: 7e-3 on points every 0.5 mm with 5 um of noise on both bodies. See
                         wrc_model_profile() [0]. Too large: did you pass mm? */
} wrc_profile;

/** Elastic and yield properties. Of bodies that are not alike all methods take the combined 1/G = (1/G_w + 1/G_r) / 2 and
 * nu/G = (nu_w/G_w + nu_r/G_r) / 2, with which pressure alone and traction alone are as they should; what couples them, in the
 * measure K/G = ((1 - 2 nu_w)/G_w - (1 - 2 nu_r)/G_r) / 4, is left out, and WRC_FLAG_DISSIMILAR_MATERIALS says so when the model is
 * made. Theory manual, section 4. */
typedef struct wrc_config_material {
  double shear_modulus; /**< G, of both bodies or of the wheel, 1e8..1e12 Pa [80e9]. Too small: did you pass MPa or GPa? Too large: steel has 80e9 */
  double poisson;       /**< nu, of both bodies or of the wheel, 0..0.5 [0.25]. Steel has 0.25 to 0.3 */
  double shear_yield;   /**< k, yield limit in shear for the fatigue indices, 1e6..1e11 Pa [250e6]. Too small: did you pass
                             MPa? */
  double rail_shear_modulus; /**< G of the rail, 0 or 1e8..1e12 Pa; 0: as the wheel's [0]. Too small: did you pass MPa or
                                  GPa? Too large: steel has 80e9 */
  double rail_poisson;       /**< nu of the rail, 0..0.5; must be 0 where rail_shear_modulus is [0]. Steel has 0.25 to 0.3 */
} wrc_config_material;

/** How a body takes up heat. Read by wrc_contact_temperature() and friction over temperature. */
typedef struct wrc_heat_properties {
  double conductivity;  /**< lambda, 0.1..1000 W/(m K) [50]. Steel has 40 to 55 */
  double density;       /**< rho, 100..1e5 kg/m^3 [7850]. Too small: did you pass g/cm^3? */
  double specific_heat; /**< c, 10..1e5 J/(kg K) [450]. Too small: did you pass kJ? */
} wrc_heat_properties;

/** Where the wheels are on their axle. */
typedef struct wrc_config_wheelset {
  double wheel_radius;         /**< nominal rolling radius, at the tape circle, 0.1..1.5 m [0.46]. Too large: did you pass
                                    mm? */
  double flange_back_distance; /**< between the inner faces of the wheelset, 0.3..2.5 m; not read without profiles [1.360].
                                    Too large: did you pass mm? */
} wrc_config_wheelset;

/** Where the rails are. Not read without profiles. */
typedef struct wrc_config_track {
  int32_t placement;       /**< enum wrc_profile_placement [WRC_PLACEMENT_GAUGE] */
  uint32_t reserved;       /**< 0 */
  double gauge;            /**< between the gauge faces of the rails, 0.3..2.5 m [1.435]. Too large: did you pass mm? */
  double gauge_depth;      /**< gauge is measured this far below the rail top, 0.005..0.04 m [0.014]. Too large: did you
                                pass mm? */
  double rail_inclination; /**< tangent of the cant towards the track centre, -0.2..0.2; must be 0 for
                                WRC_PROFILE_UIC60_BENCHMARK, which is canted already [0]. 1:40 is 0.025 */
  double rail_origin;      /**< distance of the rail profile's origin from the track's centre line, 0.2..1.5 m with
                                WRC_PLACEMENT_ORIGIN, 0 else [0]. Too large: did you pass mm, or the distance from rail to
                                rail? */
} wrc_config_track;

/** One cross section of a rail that changes along the track; wrc_contact_wrench() alone reads them. Between two sections the
 * rail is blended, twice continuously differentiable by the distance, point by point of equal length along both outlines:
 * from end to end, or from mark to mark where marks are given. So outlines that are paired should end at the same places of
 * the rail. A face is a surface of its own - stock rail, blade, wing rail, nose -, with sections of its own, and is there
 * from the first of them to the last: one that begins or ends should do so where the wheel does not touch it. The rail
 * itself reaches from the first section of all to the last. Theory manual, section 9. */
typedef struct wrc_rail_section {
  double distance;      /**< along the track, -1e7..1e7 m; of a face increasing, by 1 mm or more [0]. Did you pass mm? */
  double y;             /**< where the profile's origin lies, from that of config.rail: towards the field side, -0.5..0.5 m
                             [0]. Did you pass mm? */
  double z;             /**< the same downwards, -0.5..0.5 m [0]. Did you pass mm? */
  int32_t face;         /**< which surface it is of, 0..3: sections of one face stand side by side, faces counted from 0 on,
                             best from the gauge side to the field side, as regions are listed [0] */
  uint32_t marks;       /**< 0..64, the same for all sections of a face [0] */
  const double* mark;   /**< `marks` of them, y on this profile, -0.5..0.5 m with `marks`: of points that belong together
                             with those of equal number on the face's other sections; increasing, 1 mm or more from each
                             other and from the ends [required]. Did you pass mm? */
  wrc_profile profile;  /**< its outline, from its own origin, canted as config.rail by config.track.rail_inclination; not
                             WRC_PROFILE_UIC60_BENCHMARK beside another */
} wrc_rail_section;

/** A wheel that is not round: a flat, a polygon, a measurement. wrc_contact_wrench() alone reads it. A periodic cubic spline
 * goes through each row. Theory manual, section 9. */
typedef struct wrc_config_roundness {
  uint32_t angles;         /**< places round the wheel in each row, the first again at the end, 0 or 9..20000; 0: it is round
                                [0] */
  uint32_t rows;           /**< places across the tread, 1..16 with `angles`, 0 else [0] */
  const double* angle;     /**< `angles` of them, 0..6.2831854 rad with `angles`, increasing, from 0 to 2 pi; 0 is the lowest
                                point at wrc_wheel_input.angle 0, and angles grow from there towards +x [required]. Did you
                                pass degrees? */
  const double* y;         /**< `rows` of them: where on the wheel's profile the rows are, increasing, -0.5..0.5 m; between
                                them is blended; NULL: of one row [NULL] */
  const double* deviation; /**< rows * angles of them, row by row, -0.005..0.005 m with `angles`: what the radius has more
                                than that of the profile; in each row the last as the first [required] */
} wrc_config_roundness;

/** How finely contacts are divided. */
typedef struct wrc_config_grid {
  int32_t strips;      /**< strips across the patch, 4..512 [60]. Too large: more strips cost time in proportion */
  int32_t cells;       /**< cells along each strip, 4..512; memory only with a method that gives forces alone [32]. Too
                            large: more cells cost time in proportion */
  int32_t gap_rows;    /**< rows the gap is sampled at, and most a caller's gap may have, 8..4096 [256]. The gap is
                            interpolated between rows */
  int32_t max_patches; /**< patches reported; more are flagged, 1..16 [4]. A wheel touches its rail in one to three
                            places */
  double gap_limit;    /**< rows of a pose reach to where the gap exceeds this, 1e-5..0.02 m; deeper approaches are not
                            solved but continued, WRC_FLAG_BEYOND_GAP [1e-3]. Too large: did you pass mm? */
} wrc_config_grid;

/** The normal problem. */
typedef struct wrc_config_normal {
  int32_t method;         /**< enum wrc_normal_method [WRC_NORMAL_STRIP_HALFSPACE] */
  int32_t max_iterations; /**< cap of the steps of the load search, 4..1000; not read by WRC_NORMAL_STRIP_HALFSPACE [60] */
  int32_t max_sweeps;     /**< cap of the sweeps over the strips on each of two grids, 4..1000; read by
                               WRC_NORMAL_STRIP_HALFSPACE [16] */
  int32_t warm_start;     /**< 0..1; 1: WRC_NORMAL_STRIP_HALFSPACE starts from the contact's last solution (not read by
                               wrc_contact_wrench: wrc_wheel_input.start); results then depend on the calls before: the same approach again moves the force by up to 0.1 %. Unfit
                               for implicit integrators, whose iterations stall on that, and for differences between
                               calls. 0: results depend on the inputs of the call alone [0] */
  double load_tolerance;  /**< relative error of a prescribed load at the approach found for it, 1e-14..1e-2 (below 1e-12
                               as that); not read by WRC_NORMAL_STRIP_HALFSPACE, which meets the load to rounding [1e-10] */
} wrc_config_normal;

/** The tangential problem. wrc_config_use() sets a published method by its name. */
typedef struct wrc_config_tangential {
  int32_t method;          /**< enum wrc_tangential_method [WRC_TANGENTIAL_STRIP_FASTSIM] */
  int32_t patch_model;     /**< enum wrc_patch_model; read by WRC_TANGENTIAL_FASTSIM and _FASTRIP
                                [WRC_PATCH_MODEL_PATCH_SDEC] */
  int32_t bound;           /**< enum wrc_traction_bound; read by WRC_TANGENTIAL_FASTSIM [WRC_BOUND_PARABOLIC] */
  int32_t flexibility;     /**< enum wrc_flexibility; read by WRC_TANGENTIAL_FASTSIM [WRC_FLEXIBILITY_SEPARATE] */
  int32_t regularisation;  /**< enum wrc_regularisation [WRC_REGULARISE_KEEP_WIDTH] */
  uint32_t reserved;       /**< 0 */
  const char* force_table; /**< file of the force table, for WRC_TANGENTIAL_FORCE_TABLE alone: share/wrc/force_table.bin
                                of the installed library; read when the model is made, never after [NULL] */
} wrc_config_tangential;

/** A check rail beside each rail, which guides the back of the wheel's flange; wrc_contact_wrench() alone reads it. It is the
 * same all along the track and moves with the rail (wrc_rail_state). The wheel's profile must have its flange's back: points
 * beyond the tip, which z(y) can follow as steeply as points are allowed to be. */
typedef struct wrc_config_check_rail {
  double y;            /**< where its profile's origin lies, from that of config.rail: towards the field side, so < 0, -0.5..0 m
                            [0]. Did you pass mm, or count from the track's middle? */
  double z;            /**< the same downwards, so < 0 where it stands above the rail's origin, -0.5..0.5 m [0]. Did you pass
                            mm? */
  wrc_profile profile; /**< its outline, y as that of the rail: the face that guides is on its field side. Canted as
                            config.rail by config.track.rail_inclination; WRC_PROFILE_NONE: there is none */
} wrc_config_check_rail;

/** Everything a model is made of. Begin with wrc_config_default(), which fills the values in brackets. A member that the
 * chosen methods do not read must keep that value: anything else is WRC_ERROR_UNSUPPORTED, with a sentence. */
typedef struct wrc_config {
  uint32_t struct_size;             /**< sizeof this struct, 280 or more */
  int32_t instruction_set;          /**< enum wrc_instruction_set; one this processor lacks is WRC_ERROR_UNSUPPORTED
                                         [WRC_INSTRUCTIONS_BEST] */
  wrc_profile wheel;                /**< profile of the wheel */
  wrc_profile rail;                 /**< profile of the rail; both are WRC_PROFILE_NONE or neither is */
  wrc_config_material material;     /**< of both bodies */
  wrc_heat_properties wheel_heat;   /**< how the wheel takes up heat */
  wrc_heat_properties rail_heat;    /**< how the rail does */
  wrc_config_wheelset wheelset;     /**< where the wheels are on their axle */
  wrc_config_track track;           /**< where the rails are */
  wrc_config_grid grid;             /**< strips, cells, rows of the gap */
  wrc_config_normal normal;         /**< method and options of the normal problem */
  wrc_config_tangential tangential; /**< method and options of the tangential problem */
  uint32_t rail_sections;           /**< of a rail that changes along the track, 0..1000; 0: it is config.rail everywhere [0] */
  int32_t non_steady;               /**< 0..1; 1: contacts remember their tractions, and forces follow what changes over
                                         the distances told to wrc_planar_roll(); one way of rolling, forwards, not
                                         with wrc_contact_wrench; read by WRC_TANGENTIAL_STRIP_FASTSIM [0] */
  const wrc_rail_section* rail_section; /**< `rail_sections` of them with `rail_sections`; config.rail is beside them what
                                             the rail's place follows from and what the stages see [required] */
  wrc_config_roundness roundness;   /**< of the wheel */
  double roller_curvature;          /**< of a rail that is a roller: 1 / its radius at the origin of the rail's profile, 0 or
                                         1e-12..10 1/m; 0: a straight rail [0]. Too large: did you pass a radius? wrc_contact_wrench()
                                         alone reads it */
  wrc_config_check_rail check_rail; /**< beside the rail */
} wrc_config;

/** Pose of the wheelset relative to the track, in the track frame. The vertical position follows from the load. What is
 * smaller than 1e-100 counts as 0. */
typedef struct wrc_planar_pose {
  double lateral;       /**< shift of the wheelset to the right, -0.1..0.1 m [0]. Did you pass mm? */
  double roll;          /**< about x: right wheel down is positive, -0.2..0.2 rad [0]. Did you pass degrees or mrad? */
  double yaw;           /**< about z: nose to the right is positive, -0.2..0.2 rad [0]. Did you pass degrees or mrad? */
} wrc_planar_pose;

/** Where wheel and rail first touch when the wheelset of that pose is lowered. */
typedef struct wrc_planar_point {
  double x; /**< on the rail, track frame [m]; x is that of the wheel's point */
  double y; /**< see x */
  double z; /**< see x */
  double y_wheel;        /**< in the coordinates of the wheel profile, flange side negative [m] */
  double y_rail;         /**< from the origin of the rail profile, after canting; field side positive [m] */
  double angle;          /**< contact angle: rotation about x from the track to the contact frame [rad] */
  double vertical_gap;   /**< the wheel must be lowered by this, from its running circle level with the rail top [m] */
  double rolling_radius; /**< of the wheel at the contact point [m] */
} wrc_planar_point;

/** The undeformed gap, when the caller owns the contact search: rows along x at increasing y in the contact frame,
 * measured along the normal. Its minimum is first contact; a constant offset is irrelevant.
 *  - columns == 0: row j is height[j] + curvature[j]/2 (x - centre[j])^2
 *  - columns > 0: element-wise, h[j * row_stride + i] at (x[i], y[j]); each row is represented by the parabola fitted
 *    to its lowest part, what lies less than config.grid.gap_limit / 4 above its minimum but at least three points. */
typedef struct wrc_planar_gap {
  uint32_t rows;           /**< 4..config.grid.gap_rows [0]. Too small: a gap needs at least four rows. Too large: raise
                                config.grid.gap_rows */
  uint32_t columns;        /**< 0 or 3..100000 [0] */
  const double* y;         /**< `rows` of them, -0.3..0.3 m, increasing, at least 1e-6 m apart: slopes are read off
                                neighbours, and closer they are made of the errors of heights [required]. Did you pass
                                mm? */
  const double* height;    /**< `rows` of them, -0.3..0.3 m with `columns` 0 [required]. Did you pass mm? */
  const double* centre;    /**< `rows` of them, -0.3..0.3 m with `columns` 0; NULL: zero [NULL]. Did you pass mm? */
  const double* curvature; /**< `rows` of them, 1e-3..1e6 1/m with `columns` 0 (1 / rolling radius for a wheel on a
                                straight rail) [required]. Too small: rows must be convex; did you pass 1/mm, or a
                                radius? Too large: did you pass 1/um? */
  const double* x;         /**< `columns` of them, -0.3..0.3 m with `columns`, increasing, at least 1e-6 m apart
                                [required]. Did you pass mm? */
  const double* h;         /**< -0.3..0.3 m with `columns` [required]. Did you pass mm? */
  uint64_t row_stride;     /**< elements from one row of h to the next, >= columns [0] */
} wrc_planar_gap;

/** What presses the bodies together, and damping of the approach if wanted (Hunt and Crossley, J. Appl. Mech. 42
 * (1975) 440-445): every pressure is the elastic one times
 *     1 + 3/2 damping * approach_velocity,   never below 0,
 * on the elastic patch. The force so grows from zero at first touch and never pulls. Everything downstream (traction
 * bound, forces.fn, fields, damage) sees this pressure; wrc_planar_normal_solution.damping_force is its share of the normal
 * force. An impact at v m/s rebounds with about (1 - damping * v) of its velocity while damping * v is small. */
typedef struct wrc_planar_load {
  int32_t prescribed;   /**< enum wrc_prescribed [WRC_PRESCRIBE_NORMAL_FORCE] */
  uint32_t reserved;    /**< 0 */
  double normal_force;  /**< along the contact normal, 1e2..1e6 N with WRC_PRESCRIBE_NORMAL_FORCE; must be set [0]. Negative: the
                             normal force is compressive positive; prescribe the approach near lift-off. Too small: did
                             you pass kN? near lift-off prescribe the approach instead. Too large: did you pass a
                             pressure, or grams? */
  double approach;      /**< beyond first touch, -1..0.01 m with WRC_PRESCRIBE_APPROACH; <= 0: no contact [0]. Too large:
                             did you pass mm or um? */
  double approach_velocity; /**< d approach / dt, -20..20 m/s with WRC_PRESCRIBE_APPROACH; positive while the bodies near
                                 each other, as wrc_creepage.approach_velocity [0]. Did you pass mm/s? */
  double damping;       /**< 0..10 s/m with WRC_PRESCRIBE_APPROACH: a prescribed load is the whole load; 0: none [0].
                             Negative: damping takes energy out. Too large: it is not a viscous constant: that over 3/2
                             of the force it was found at */
} wrc_planar_load;

/** Rigid slip per unit rolled length and rolling speed: sliding velocities over |speed|. A creepage below 1e-100 counts
 * as none. */
typedef struct wrc_creepage {
  double longitudinal;  /**< nu_x, -10..10 [0]. Did you pass per mille? */
  double lateral;       /**< nu_y, -10..10 [0]. Did you pass per mille? */
  double spin;          /**< phi, -1000..1000 1/m [0] */
  double speed;         /**< rolling speed V, -200..200 m/s: its sign says which edge leads (0: forward), its amount
                             scales the power and the sliding speed of friction that falls [1]. Did you pass km/h? */
  double approach_velocity; /**< result of wrc_planar_creepages(), not read: velocity of the wheel's point along the contact
                                 normal into the rail [m/s], for wrc_planar_load */
  double reverse_share;     /**< share of forces, power, adhesion and sensitivities that is of rolling the other way than
                             speed says, 0..0.5: near standstill wrc_planar_creepages() sets it, and both ways are solved;
                             fields, what damage and wear make of them are of the way of speed [0]. Too small: it is a
                             result of wrc_planar_creepages. Too large: the way of creepage.speed has the larger share */
} wrc_creepage;

/** Temperatures of the bodies away from the contact, which friction's heat does not reach while they pass. */
typedef struct wrc_bulk_temperatures {
  double wheel; /**< of the tread, -273..2000 degC [20]. Too large: did you pass kelvin, or Fahrenheit? */
  double rail;  /**< of the running surface, -273..2000 degC [20]. Too large: did you pass kelvin, or Fahrenheit? */
} wrc_bulk_temperatures;

/** Friction between the bodies, and what a layer between them does. Each strip of the patch has one coefficient: that
 * at rest (`coefficient`, or of the zones) times what is left of it at the strip's sliding speed or temperature. It may
 * vanish: such strips carry no traction. A member that neither the kind nor the tangential
 * method reads must be its default: anything else is WRC_ERROR_UNSUPPORTED. Zones are read where zones > 0. Theory
 * manual, section 5. */
typedef struct wrc_friction {
  double coefficient;   /**< Coulomb; at rest where it falls with the sliding speed, 0 or 1e-4..2; 0, none, of a wheel on a
                             rail alone (wrc_wheel.h) [0.3]. Too small: friction must be positive. Too large: did you pass
                             per cent? */
  int32_t kind;         /**< enum wrc_friction_kind [WRC_FRICTION_CONSTANT] */
  int32_t zone_frame;   /**< enum wrc_zone_frame [WRC_ZONES_CONTACT_FRAME] */
  double kinetic_ratio; /**< friction at high sliding speed over that at rest (Polach's A), 0..1; not read by
                             WRC_FRICTION_CONSTANT [0.4]. Too large: it is a share of the coefficient at rest */
  double fall_rate;     /**< WRC_FRICTION_FALLING: Polach's B, 0..1000 s/m [0.6]. Too small: friction falls with
                             positive rates */
  double half_speed;    /**< w at which half of the fall is done, 1e-6..100 m/s with WRC_FRICTION_STATIC_KINETIC [1] */
  double hot_ratio;     /**< friction of hot surfaces over that of cold ones, 0..1 with WRC_FRICTION_TEMPERATURE [0.5]. Too
                             large: it is a share of the coefficient of cold surfaces */
  double cold_temperature; /**< up to which friction is whole, -273..2000 degC with WRC_FRICTION_TEMPERATURE [0] */
  double hot_temperature;  /**< from which on friction is hot_ratio of that, -273..3000 degC with WRC_FRICTION_TEMPERATURE,
                                at least 1 degC above cold_temperature [400] */
  wrc_bulk_temperatures bulk; /**< of the bodies; read by WRC_FRICTION_TEMPERATURE */
  double slope_reduction; /**< a layer between the bodies: initial slope of the creep curve over that of clean bodies,
                               for every method, 0.01..1 [1]. Too small: clean bodies have 1. Too
                               large: clean bodies have 1; did you pass per cent? */
  double slope_limit;   /**< modified FASTSIM: share of that slope left at large slip, 0..1; read by
                             WRC_TANGENTIAL_FASTSIM [0.02] */
  double slope_fall;    /**< modified FASTSIM: how fast the slope falls as slip grows, 0..1000; 0: not; read by
                             WRC_TANGENTIAL_FASTSIM [0] */
  const double* zone_y; /**< breakpoints, `zones` of them, -1..1 m with `zones`, increasing; two at the same y make a
                             step [required]. Did you pass mm? */
  const double* zone_coefficient; /**< friction at rest there, `zones` of them, 0..2 with `zones`, in place of
                                       `coefficient`; linear between breakpoints, constant beyond; a strip has the mean
                                       over its width. 0: no friction [required]. Too small: friction is not negative.
                                       Too large: did you pass per cent? */
  uint32_t zones;       /**< breakpoints, 0..64; 0: `coefficient` everywhere [0] */
  uint32_t reserved;    /**< 0 */
} wrc_friction;

/** An equivalent double ellipse and the load it carries: two half ellipses of equal length that meet at the joint.
 * Found for every patch; or handed over as a patch, exactly (then pressure is semi-elliptic, p0 = 1.5 N / (pi a b),
 * and the joint lies at the origin of the contact frame). */
typedef struct wrc_ellipse {
  double a;            /**< semi-axis along rolling, 1e-6..0.1 m [0]. Too large: did you pass mm? */
  double b;            /**< half its width, 1e-6..0.1 m; it reaches from y - b (1 - psi) to y + b (1 + psi) [0]. Too large:
                            did you pass mm? */
  double psi;          /**< shape number, -0.95..0.95; 0 is an ellipse; paper eq. 2 [0] */
  double y;            /**< its joint in the contact frame [m]; not read */
  double normal_force; /**< compressive positive, damping included, 1e-3..1e7 N [0]. Negative: the normal force is
                            compressive positive. Too large: did you pass mN? */
} wrc_ellipse;

/** What the normal problem of a contact came to, all patches together. */
typedef struct wrc_planar_normal_solution {
  int32_t patches;      /**< separate patches: wrc_contact_patch() has each */
  int32_t strips;       /**< strips under pressure */
  int32_t iterations;   /**< of the root find, or sweeps */
  uint32_t reserved;    /**< 0 */
  wrc_ellipse ellipse;  /**< of the patch that carries most */
  double normal_force;  /**< compressive positive, damping included [N] */
  double damping_force; /**< share of normal_force that comes from load.damping; < 0 while the bodies part [N] */
  double approach;      /**< beyond first touch, along the normal [m]; 0 for an ellipse or strips of the caller */
  double stiffness;     /**< d normal_force / d approach [N/m]; of STRIP_HALFSPACE and ANALYN within 6 %; d normal_force
                             / d approach_velocity is 3/2 load.damping * (normal_force - damping_force), in N s/m */
  double peak_pressure; /**< largest pressure as solved, not of the equivalent ellipse [Pa] */
  double area;          /**< [m^2] */
  double length;        /**< extent along x: foremost to rearmost edge of all strips [m] */
  double width;         /**< extent along y: y_max - y_min [m] */
  double y_min;         /**< lateral borders [m] */
  double y_max;         /**< see y_min */
} wrc_planar_normal_solution;

/** A pressure distribution of the caller, as strips along x with semi-elliptic pressure. */
typedef struct wrc_planar_strips {
  uint32_t count;            /**< 1..config.grid.strips [0]. Too large: raise config.grid.strips */
  uint32_t reserved;         /**< 0 */
  const double* y;           /**< middle, `count` of them, -0.3..0.3 m, increasing; strips must not overlap [required].
                                  Did you pass mm? */
  const double* width;       /**< `count` of them, 1e-9..0.1 m [required]. Too small: leave out strips without width. Too
                                  large: did you pass mm? */
  const double* centre;      /**< x of the middle, `count` of them, -0.3..0.3 m; NULL: zero [NULL]. Did you pass mm? */
  const double* half_length; /**< `count` of them, 1e-9..0.1 m [required]. Too small: leave out strips without length.
                                  Too large: did you pass mm? */
  const double* peak;        /**< `count` of them, 0..1e11 Pa [required]. Too small: pressure is compressive positive.
                                  Too large: steel yields at a tenth of that */
} wrc_planar_strips;

/** Forces on the wheel in the contact frame, moment about its origin. */
typedef struct wrc_planar_forces {
  double fx;                /**< creep forces [N] */
  double fy;                /**< see fx */
  double fn;                /**< normal force, compressive positive, damping included [N] */
  double mz;                /**< spin moment [N m] */
  double power;             /**< frictional power at the given speed [W], >= 0 */
  double adhesion_fraction; /**< share of the patch's area that sticks [-]; WRC_AVAILABLE_TRACTIONS */
  uint32_t available;       /**< bits of enum wrc_available: what else stands here; where one is missing, 0 does */
  uint32_t reserved;        /**< 0 */
} wrc_planar_forces;

/** One patch of a contact with its forces. Moments are about the origin of the contact frame: the forces of all patches add
 * up to those of the contact. */
typedef struct wrc_patch {
  uint32_t struct_size; /**< sizeof this struct, 208 or more */
  uint32_t available;   /**< bits of enum wrc_available; where one is missing, 0 stands */
  int32_t strips;       /**< strips the patch is made of */
  uint32_t reserved;    /**< 0 */
  wrc_ellipse ellipse;  /**< its equivalent double ellipse, with the place of its joint and its load */
  wrc_planar_forces forces;    /**< on the wheel; zero before wrc_planar_tangential() */
  double peak_pressure; /**< [Pa] */
  double area;          /**< [m^2] */
  double length;        /**< extent along x [m] */
  double width;         /**< extent along y [m] */
  double y_min;         /**< lateral borders [m] */
  double y_max;         /**< see y_min */
  double point[3];      /**< the joint in the contact plane, track frame [m]; WRC_AVAILABLE_PLACE */
  double normal[3];     /**< unit vector into the rail, track frame [-]; WRC_AVAILABLE_PLACE. All patches of a contact
                             plane share it; regions of a wheel on a rail have their own (wrc_region) */
} wrc_patch;

/** Velocity of the wheelset relative to the track, in the track frame. */
typedef struct wrc_planar_motion {
  double speed;             /**< of its middle along the track, -200..200 m/s; backwards < 0 [0]. Did you pass km/h? */
  double lateral_velocity;  /**< to the right, -20..20 m/s [0] */
  double vertical_velocity; /**< down, -20..20 m/s [0] */
  double roll_rate;         /**< about x, -100..100 rad/s [0]. Did you pass degrees? */
  double yaw_rate;          /**< about z, -100..100 rad/s [0]. Did you pass degrees? */
  double pitch_rate;        /**< about the axle (y): negative rolling forward, -2000..2000 rad/s [0]. Did you pass rpm? */
} wrc_planar_motion;

/** Wear and rolling contact fatigue numbers of the last wrc_planar_tangential. */
typedef struct wrc_damage {
  double power;               /**< total frictional power, the integral of WRC_FIELD_POWER_DENSITY [W] */
  double peak_power_density;  /**< [W/m^2]; WRC_AVAILABLE_TRACTIONS */
  double t_gamma;             /**< power / speed: energy dissipated per metre rolled, spin included [N] */
  double t_gamma_no_spin;     /**< |Fx nu_x + Fy nu_y|: the other definition in use [N] */
  double utilisation;         /**< mu_a = sqrt(Fx^2 + Fy^2) / N: abscissa of the shakedown map [-] */
  double load_factor;         /**< p0 / k: ordinate of the shakedown map [-] */
  double shakedown_limit;     /**< of load_factor at mu_a, line contact [-]; ratcheting above */
  double fatigue_index;       /**< FI = mu_a - k / p0, paper eq. 11 [-]; damage when positive */
  double local_fatigue_index; /**< largest local index over the patch, paper eq. 12 [-]; WRC_AVAILABLE_TRACTIONS */
  uint32_t available;         /**< bits of enum wrc_available; where one is missing, 0 stands */
  uint32_t reserved;          /**< 0 */
} wrc_damage;

/** Parameters of the wear laws. wrc_wear_laws_init() fills the published values in brackets; all of them are
 * unconfirmed (remembered, not checked against the original texts) and depend on the pair of steels. Theory manual,
 * section 6.
 *  - T-gamma: area lost per metre rolled (Pearce and Sherratt, Wear 144 (1991)), over the wheel's diameter.
 *  - Sheffield: depth per metre rolled from T-gamma per area (R8T wheel on UIC60 900A; Braghin et al. 2006).
 *  - Archard: depth per second, k p v / hardness with the map of Jendel (Wear 253 (2002)).
 *  - Power law: depth per second, power_coefficient / density * q (q / power_reference)^(power_exponent - 1), q the
 *    frictional power density. With exponent 1 mass is worn in proportion to energy: the mild regime of Zobory
 *    (VSD 28 (1997)), which ends at 4 W/mm^2. */
typedef struct wrc_wear_laws {
  uint32_t struct_size;                /**< sizeof this struct, 184 or more */
  uint32_t reserved;                   /**< 0 */
  double t_gamma_mild_end; /**< T-gamma up to which wear is mild, 1e-3..1e9 N [100] */
  double t_gamma_severe_start; /**< T-gamma from which it is severe, 1e-3..1e9 N, not below t_gamma_mild_end [200] */
  double t_gamma_mild_slope; /**< area * diameter per T-gamma, mild, 0..1e6 mm^3/(km N) [0.25] */
  double t_gamma_plateau; /**< area * diameter between the two, 0..1e9 mm^3/km [25] */
  double t_gamma_severe_slope; /**< as t_gamma_mild_slope, severe, 0..1e6 mm^3/(km N) [1.19] */
  double t_gamma_severe_offset; /**< subtracted in the severe regime, 0..1e15 mm^3/km; the law must not turn negative
                                     [154] */
  double sheffield_mild_end; /**< T-gamma per area up to which wear is mild, 1e-6..1e9 N/mm^2 [10.4] */
  double sheffield_severe_end; /**< T-gamma per area from which it is catastrophic, 1e-6..1e9 N/mm^2, not below
                                    sheffield_mild_end [77.2] */
  double sheffield_mild_slope; /**< rate per T-gamma per area, mild, 0..1e6 microgram/(m N) [5.3] */
  double sheffield_catastrophic_slope; /**< the same, catastrophic, 0..1e6 microgram/(m N) [61.9] */
  double density; /**< of the worn material, 100..1e5 kg/m^3 [7850] */
  double hardness; /**< of the softer body, 1e6..1e12 Pa [3e9]. Too small: did you pass MPa, or a Vickers number? */
  double archard_slow; /**< coefficient below archard_severe_start, 0..1 [5e-4] */
  double archard_severe; /**< coefficient between the two speeds, 0..1 [35e-4] */
  double archard_fast; /**< coefficient above archard_severe_end, 0..1 [5e-4] */
  double archard_seizure; /**< coefficient where pressure exceeds seizure_pressure * hardness, 0..1 [350e-4] */
  double archard_severe_start; /**< sliding velocity from which wear is severe, 0..1000 m/s [0.2] */
  double archard_severe_end; /**< sliding velocity up to which it is severe, 0..1000 m/s, not below archard_severe_start
                                  [0.7] */
  double seizure_pressure; /**< share of the hardness, 0..1000 [0.8] */
  double power_coefficient; /**< mass worn per energy at power_reference, 0..1 kg/J [7e-10]. Did you pass microgram/J? */
  double power_exponent; /**< of the frictional power density, 0.25..4 [1] */
  double power_reference; /**< power density at which power_coefficient holds, 1..1e12 W/m^2 [4e6]. Too small: did you pass
                               W/mm^2? */
} wrc_wear_laws;

/** Wear of the last wrc_planar_tangential. */
typedef struct wrc_wear {
  double worn_area_rate;         /**< T-gamma law: area lost from the wheel's section per metre rolled [m^2/m] */
  double largest_depth_rate;     /**< Sheffield: depth per metre rolled of the worst cell [m/m] */
  double largest_depth_velocity; /**< Archard: depth per second in contact of the worst cell [m/s] */
  double largest_power_depth_velocity; /**< power law: the same [m/s] */
} wrc_wear;

/** Coefficients of the linear theory for one patch shape (theory manual, section 4). */
typedef struct wrc_coefficients {
  double c11; /**< Kalker's, for the ellipse a, b [-] */
  double c22; /**< see c11 */
  double c23; /**< see c11 */
  double c11s; /**< of the double ellipse, about its joint; paper eq. 5 [-] */
  double c13s; /**< see c11s */
  double c22s; /**< see c11s */
  double c23s; /**< see c11s */
} wrc_coefficients;

/** Derivatives of the forces of the last wrc_planar_tangential at its patch. */
typedef struct wrc_planar_derivatives {
  double forces[3][5];  /**< rows: fx, fy [N], mz [N m]; columns: longitudinal, lateral [-], spin [1/m], normal_force [N]
                             (same patch, pressure growing in proportion), friction coefficient [-] (its factor on the
                             whole law; with friction.zones, their mean over the load) */
} wrc_planar_derivatives;

/** Derivatives of the last whole step, creepages and friction held. */
typedef struct wrc_step_sensitivity {
  double by_load[4];    /**< of fx, fy, mz and the approach [m] with respect to the normal force [N]; where the approach
                             is prescribed, of fx, fy, mz and the normal force with respect to the approach */
  double by_lateral[4]; /**< of the same four with respect to the lateral shift of the wheelset [m]; zero for a gap of the
                             caller */
} wrc_step_sensitivity;

/** What wrc_planar_step() reads. What pointers within point to is the caller's and only read during the call. */
typedef struct wrc_planar_input {
  uint32_t struct_size;  /**< sizeof this struct, 256 or more */
  uint32_t reserved;     /**< 0 */
  wrc_planar_pose pose;         /**< of the wheelset; not used with `gap`, but within its ranges all the same */
  const wrc_planar_gap* gap;    /**< a gap of the caller in place of the pose; NULL: the pose [NULL] */
  wrc_planar_load load;         /**< what presses the bodies together */
  wrc_creepage creepage; /**< rigid slip at the origin of the contact frame */
  wrc_friction friction; /**< between the bodies */
} wrc_planar_input;

/** What wrc_planar_step() fills. */
typedef struct wrc_planar_output {
  uint32_t struct_size;       /**< sizeof this struct, 344 or more */
  uint32_t reserved;          /**< 0 */
  wrc_planar_point point;    /**< zero when there was no pose */
  wrc_planar_normal_solution normal; /**< of the normal stage */
  wrc_planar_forces forces;          /**< of the tangential stage */
  wrc_damage damage;          /**< of the damage stage */
} wrc_planar_output;

/** A read-only view of a field: element (i, j) is data[i * stride[0] + j * stride[1]]. Valid until the next call on
 * the contact. */
typedef struct wrc_view {
  const double* data; /**< in the contact's memory; NULL: not computed */
  uint64_t count[2];  /**< elements along each dimension; count[1] = 1 for rank 1 */
  uint64_t stride[2]; /**< in elements */
  uint32_t rank;      /**< 1 or 2 */
  uint32_t reserved;  /**< 0 */
} wrc_view;

/** Where memory comes from in wrc_model_create() and wrc_contact_create(). Both functions or neither. */
typedef struct wrc_allocator {
  void* user;           /**< handed to both [NULL] */
  void* (*allocate)(void* user, uint64_t bytes, uint64_t alignment); /**< alignment: a power of two; gives NULL where
                                                                          none is left [NULL] */
  void (*release)(void* user, void* memory); /**< called by the destroy functions, and when a create fails [NULL] */
} wrc_allocator;

/* ------------------------------------------------------------------------------------------------ about the library */

/** Version of the library. @return major * 65536 + minor * 256 + patch. @rt hard @thread free */
WRC_API uint32_t wrc_version(void);
/** ABI version of the library. @return WRC_ABI_VERSION of the header it was built with. @rt hard @thread free */
WRC_API uint32_t wrc_abi_version(void);
/** Whether the library serves an interface, and if not what to do: why wrc_get_api() returned NULL.
 * @param requested WRC_ABI_VERSION of the header the caller was compiled with
 * @return a sentence; static storage, never NULL. @rt hard @thread free */
WRC_API const char* wrc_version_text(uint32_t requested);
/** What to put into a question to support: version, commit, compiler, flags, and the instruction set this processor gets
 * by default. @return one line; static storage, never NULL. Asks the processor. @rt init @thread free */
WRC_API const char* wrc_build_info(void);
/** Name of a status. @param status any number @return for example "WRC_ERROR_RANGE", or "unknown status"; static
 * storage, never NULL. @rt hard @thread free */
WRC_API const char* wrc_status_name(int32_t status);
/** Meaning of a status in one line. @param status any number @return the text, or "unknown status"; static storage,
 * never NULL. @rt hard @thread free */
WRC_API const char* wrc_status_text(int32_t status);

/* ------------------------------------------------------------------------------------------------------- defaults */

/** @name Defaults
 * wrc_X_default() gives a struct with its defaults (the values in brackets above; zero and NULL where none are given),
 * of the size the caller was compiled with. wrc_X_init() does the same to a struct of the caller; of one that has
 * struct_size, which must be set before, it writes that many bytes. Returns WRC_OK, WRC_ERROR_NULL (the pointer is
 * NULL), WRC_ERROR_STRUCT_SIZE (smaller than the first published version, or larger than the library knows: the
 * library is older than the header; wrc_X_default() gives zeros then, and every call refuses them).
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_profile_init(wrc_profile* profile); /**< Defaults: profile. */
WRC_API int32_t wrc_config_init(wrc_config* config); /**< Defaults: configuration. */
WRC_API int32_t wrc_heat_properties_init(wrc_heat_properties* heat); /**< Defaults: how a body takes up heat. */
WRC_API int32_t wrc_planar_pose_init(wrc_planar_pose* pose); /**< Defaults: pose. */
WRC_API int32_t wrc_planar_gap_init(wrc_planar_gap* gap); /**< Defaults: gap. */
WRC_API int32_t wrc_planar_load_init(wrc_planar_load* load); /**< Defaults: load. */
WRC_API int32_t wrc_creepage_init(wrc_creepage* creepage); /**< Defaults: creepages. */
WRC_API int32_t wrc_bulk_temperatures_init(wrc_bulk_temperatures* bulk); /**< Defaults: temperatures of the bodies. */
WRC_API int32_t wrc_friction_init(wrc_friction* friction); /**< Defaults: friction. */
WRC_API int32_t wrc_ellipse_init(wrc_ellipse* ellipse); /**< Defaults: ellipse. */
WRC_API int32_t wrc_planar_strips_init(wrc_planar_strips* strips); /**< Defaults: strips. */
WRC_API int32_t wrc_planar_motion_init(wrc_planar_motion* motion); /**< Defaults: wheelset's motion. */
WRC_API int32_t wrc_wear_laws_init(wrc_wear_laws* laws); /**< Defaults: wear laws. */
WRC_API int32_t wrc_allocator_init(wrc_allocator* allocator); /**< Defaults: allocator. */
WRC_API int32_t wrc_planar_input_init(wrc_planar_input* input); /**< Defaults: input of a step. */
WRC_API int32_t wrc_planar_output_init(wrc_planar_output* output); /**< Defaults: output of a step. */
WRC_API int32_t wrc_patch_init(wrc_patch* patch); /**< Defaults: patch. */
/** @cond */
#define WRC_DEFAULT(type)                \
  static inline type type##_default(void) { \
    type value;                          \
    memset(&value, 0, sizeof value);     \
    type##_init(&value);                 \
    return value;                        \
  }
#define WRC_DEFAULT_SIZED(type)                   \
  static inline type type##_default(void) {       \
    type value;                                   \
    memset(&value, 0, sizeof value);              \
    value.struct_size = (uint32_t)sizeof value;   \
    type##_init(&value);                          \
    return value;                                 \
  }
WRC_DEFAULT(wrc_profile)
WRC_DEFAULT_SIZED(wrc_config)
WRC_DEFAULT(wrc_heat_properties)
WRC_DEFAULT(wrc_planar_pose)
WRC_DEFAULT(wrc_planar_gap)
WRC_DEFAULT(wrc_planar_load)
WRC_DEFAULT(wrc_creepage)
WRC_DEFAULT(wrc_bulk_temperatures)
WRC_DEFAULT(wrc_friction)
WRC_DEFAULT(wrc_ellipse)
WRC_DEFAULT(wrc_planar_strips)
WRC_DEFAULT(wrc_planar_motion)
WRC_DEFAULT_SIZED(wrc_wear_laws)
WRC_DEFAULT(wrc_allocator)
WRC_DEFAULT_SIZED(wrc_planar_input)
WRC_DEFAULT_SIZED(wrc_planar_output)
WRC_DEFAULT_SIZED(wrc_patch)
/** @endcond */
/** @} */

/* ---------------------------------------------------------------------------------------------------------- model */

/** Makes a configuration that of a published tangential method: sets method, patch_model, bound, flexibility and
 * regularisation of config.tangential, and nothing else. "modified FASTSIM" is FASTSIM-EQ.L until
 * friction.slope_fall > 0; "KBTNH-type table" needs config.tangential.force_table.
 * @param[in,out] config of wrc_config_default()
 * @param name one of WRC_PRESET_LIST (wrc_methods.h), as written there, for example "FASTSIM-SDEC"
 * @param[out] text the sentence behind the status, terminated, cut if need be; empty after WRC_OK; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _UNSUPPORTED (no such name: the sentence has those there are; config is
 * left as it is). @rt init @thread free */
WRC_API int32_t wrc_config_use(wrc_config* config, const char* name, char* text, uint64_t size);

/** Says whether a model can be made of a configuration, and if not why, as a sentence.
 * @param config configuration to check; NULL: WRC_ERROR_NULL
 * @param[out] text the sentence, cut if need be and terminated when size > 0; empty when all is well; NULL: not wanted
 * @param size bytes of text
 * @return as wrc_model_create(). @rt init @thread free */
WRC_API int32_t wrc_config_check(const wrc_config* config, char* text, uint64_t size);

/** Memory a model needs.
 * @param config configuration of the model
 * @param[out] bytes size, @param[out] alignment in bytes; both zero on failure
 * @return as wrc_model_init(), except that the shape of profile points is not looked at. @rt init @thread free */
WRC_API int32_t wrc_model_size(const wrc_config* config, uint64_t* bytes, uint64_t* alignment);

/** Makes a model in the caller's memory. Profiles are copied: config and all it points to may go away afterwards. The
 * memory stays the caller's and must outlive every contact of the model; there is nothing to destroy.
 * @param config configuration of the model
 * @param memory aligned as wrc_model_size() says
 * @param bytes of memory, at least what wrc_model_size() says
 * @param[out] model the model; NULL on failure
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE, _PROFILE, _UNSUPPORTED, _BUFFER: ask
 * wrc_config_check() why. @rt init @thread free */
WRC_API int32_t wrc_model_init(const wrc_config* config, void* memory, uint64_t bytes, wrc_model** model);

/** wrc_model_init() with memory the library gets itself.
 * @param config configuration of the model
 * @param allocator where memory comes from; NULL: malloc and free
 * @param[out] model the model, to be released with wrc_model_destroy(); NULL on failure
 * @return as wrc_model_init(), and WRC_ERROR_MEMORY. @rt init @thread free */
WRC_API int32_t wrc_model_create(const wrc_config* config, const wrc_allocator* allocator, wrc_model** model);

/** Shows a profile as the model uses it, smoothed and placed, without copying it. Views are valid as long as the model.
 * @param model a model with profiles
 * @param side enum wrc_side: where it is placed
 * @param body enum wrc_body
 * @param[out] y nodes of the curve: of a wheel from the middle of the wheelset, of a rail in the track frame [m]; NULL:
 * not wanted
 * @param[out] z their heights: of a wheel below its running circle, of a rail below its top [m]; NULL: not wanted
 * @param[out] deviation largest distance between a given point and the smoothed curve, 0 without smoothing [m]; NULL:
 * not wanted
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (model without profiles), _UNSUPPORTED (no such side or
 * body).
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

/** Makes a contact in the caller's memory, every page of which it touches. The model must outlive the contact; the
 * memory stays the caller's; there is nothing to destroy.
 * @param model its model, which serves both sides
 * @param side enum wrc_side: which wheel of the wheelset, and the rail it is on
 * @param memory aligned as wrc_contact_size() says
 * @param bytes of memory, at least what wrc_contact_size() says
 * @param[out] contact the contact; NULL on failure
 * @return WRC_OK, WRC_ERROR_NULL, _UNSUPPORTED (no such side), _BUFFER. @rt hard @thread free */
WRC_API int32_t wrc_contact_init(const wrc_model* model, int32_t side, void* memory, uint64_t bytes,
                                 wrc_contact** contact);

/** wrc_contact_init() with memory the library gets itself.
 * @param model its model, which serves both sides
 * @param side enum wrc_side: which wheel of the wheelset, and the rail it is on
 * @param allocator where memory comes from; NULL: malloc and free
 * @param[out] contact the contact, to be released with wrc_contact_destroy(); NULL on failure
 * @return as wrc_contact_init(), and WRC_ERROR_MEMORY. @rt init @thread free */
WRC_API int32_t wrc_contact_create(const wrc_model* model, int32_t side, const wrc_allocator* allocator,
                                   wrc_contact** contact);

/** Releases a contact made by wrc_contact_create().
 * @param contact NULL is fine @rt init @thread contact */
WRC_API void wrc_contact_destroy(wrc_contact* contact);

/** Length of a saved state, about half of the memory a contact takes.
 * @param model the model
 * @param[out] bytes size; zero on failure
 * @return WRC_OK, WRC_ERROR_NULL. @rt hard @thread free */
WRC_API int32_t wrc_contact_state_size(const wrc_model* model, uint64_t* bytes);

/** Copies the whole state of a contact out of it, for a rejected integrator step or an FMU rollback. The copy is good
 * for any contact of the same model and side, in this process. After the same calls it has the same bytes.
 * @param contact the contact
 * @param[out] buffer the copy; no alignment needed
 * @param bytes of buffer, at least what wrc_contact_state_size() says
 * @return WRC_OK, WRC_ERROR_NULL, _BUFFER. @rt hard @thread contact */
WRC_API int32_t wrc_contact_save(const wrc_contact* contact, void* buffer, uint64_t bytes);

/** Puts a saved state back, bit for bit; what wrc_contact_last_error() says is part of it. A call that fails changes nothing
 * but that sentence.
 * @param contact a contact of the model the state was saved from
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

/** wrc_contact_save() for another process or another machine: for files, checkpoints, a simulation that is moved. It begins
 * with the eight letters wrcstate, says its version, its byte order (that of the machine that wrote it: low byte first
 * on x86-64 and aarch64) and a fingerprint of the configuration with its profiles, and has a checksum.
 * @param contact the contact
 * @param[out] buffer the state; no alignment needed
 * @param bytes of buffer, at least what wrc_contact_portable_size() says
 * @return WRC_OK, WRC_ERROR_NULL, _BUFFER. @rt hard @thread contact */
WRC_API int32_t wrc_contact_save_portable(const wrc_contact* contact, void* buffer, uint64_t bytes);

/** Puts a portable state into a contact of an equal configuration: one with the same numbers, profiles and force table,
 * and of the same side. instruction_set may differ, and the process, and the machine if its byte order is the same. What follows
 * has the bits it would have had where the state was saved. Of the last status the sentence is lost, but for what
 * wrc_status_text() says. A call that fails changes nothing but the sentence.
 * @param contact the contact
 * @param buffer from wrc_contact_save_portable()
 * @param bytes of buffer
 * @return WRC_OK; WRC_ERROR_NULL, _FILE (no such state, cut short, or changed since it was written), _UNSUPPORTED (of
 * another version of the library, or another byte order), _SEQUENCE (of another configuration or side). @rt hard
 * @thread contact */
WRC_API int32_t wrc_contact_restore_portable(wrc_contact* contact, const void* buffer, uint64_t bytes);

/** The sentence behind the status of the last stage or step on this contact, for example
 *   "input.load.normal_force = 80 N is outside 100 .. 1e+06 N: did you pass kN? near lift-off prescribe the approach
 *   instead"
 * and empty after WRC_OK. A wrc_contact_restore that fails leaves its sentence too, one that succeeds brings back the
 * sentence of the saved state. Calls that take a const contact (wrc_contact_patch, _field, _region,
 * _save) do not change it.
 * @param contact the contact
 * @param[out] buffer the sentence, terminated, cut if need be
 * @param size bytes of buffer
 * @return WRC_OK, WRC_ERROR_NULL, _BUFFER (size is 0). @rt hard @thread contact */
WRC_API int32_t wrc_contact_last_error(const wrc_contact* contact, char* buffer, uint64_t size);

/* --------------------------------------------------------------------------------------------------------- stages */

/** Finds the initial contact point of a pose and samples the gap around it into the contact: one contact point, the
 * lowest; the rows reach up to 30 mm to either side. Theory manual, section 7.
 * @param contact of a model with profiles
 * @param pose of the wheelset, track frame
 * @param[out] point where the bodies touch first; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_ITERATION_CAP; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (model without profiles),
 * _NOT_FINITE, _RANGE, _GAP (no rail below the wheel at this pose). @rt hard @thread contact */
WRC_API int32_t wrc_planar_geometry(wrc_contact* contact, const wrc_planar_pose* pose, wrc_planar_point* point);

/** Creepages at the origin of the contact frame of the last wrc_planar_geometry, from the rigid motion of the wheelset: the
 * velocity of the wheel's material point there over the amount of the rolling speed V, the mean of the speeds at which
 * wheel and rail material pass through the contact (a locked wheel: half its speed and creepage 2; one that spins at
 * standstill: -2). What it gives wrc_planar_tangential takes, as it stands:
 *  - Below |V| = 0.1 m/s, where creepages would grow without end, velocities are divided by 0.1 m/s (3 + 6 u^2 - u^4) /
 *    8, u = |V| / 0.1 m/s, instead: 0.0375 m/s at V = 0. speed has the amount of that divisor, so that it scales power
 *    right, and the sign of V; reverse_share goes from 0 to 0.5 at V = 0. Forces are so twice differentiable in the motion
 *    through V = 0, as far as the tangential method is, and a wheel that slides at rest is braked by friction x load.
 *  - Where a creepage would pass its range (sliding far faster than rolling), all are divided by more; speed grows by
 *    it.
 *  - |speed| ends at 200 m/s.
 * Theory manual, section 7.
 * @param contact the contact
 * @param motion of the wheelset, track frame
 * @param[out] creepage the creepages with speed, approach_velocity and reverse_share, ready to be passed on; NULL: not
 * wanted
 * @return WRC_OK; WRC_FLAG_CREEPAGES_LIMITED (any of these three); WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no
 * wrc_planar_geometry before), _NOT_FINITE, _RANGE.
 * @rt hard @thread contact */
WRC_API int32_t wrc_planar_creepages(wrc_contact* contact, const wrc_planar_motion* motion, wrc_creepage* creepage);

/** Solves the normal problem and regularises the patch (wrc_planar_regularise). Strips stay in the contact. Pressures are
 * those of two bodies of equal material; theory manual, sections 2 and 3.
 * @param contact the contact
 * @param gap contact frame; copied; NULL: the gap already in the contact, of wrc_planar_geometry or of an earlier call
 * @param load along the contact normal
 * @param[out] normal the solution; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT (approach <= 0, or damping takes all of the force), _ITERATION_CAP,
 * _PATCH_AT_EDGE, _MORE_PATCHES, _TABLE_RANGE (|psi| cut to 0.95), _LOAD_LEAPS (HERTZ to STRIPES: between two loads
 * the method has no solution; the approach is that of the larger, and prescribed gives that one), _BEYOND_GAP (load
 * or approach is more than the gap carries, at most config.grid.gap_limit of a pose's: load and pressures go on in a
 * straight line with the last stiffness, the patch stays); WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (gap is NULL and
 * the contact has none), _GAP, _LOAD, _NOT_FINITE, _RANGE, _UNSUPPORTED. @rt hard @thread contact */
WRC_API int32_t wrc_planar_normal(wrc_contact* contact, const wrc_planar_gap* gap, const wrc_planar_load* load,
                                   wrc_planar_normal_solution* normal);

/** Takes a pressure distribution of the caller as the contact's patch and finds its equivalent double ellipse.
 * Theory manual, section 3; paper section 2.
 * @param contact the contact
 * @param strips contact frame, whose origin must be the initial contact point; copied; NULL: the strips in the contact
 * @param[out] normal what the strips add up to, with their double ellipse; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT (no pressure), _TABLE_RANGE (|psi| cut to 0.95); WRC_ERROR_NULL, _STRUCT_SIZE,
 * _SEQUENCE (strips is NULL and the contact has none), _RANGE, _NOT_FINITE. @rt hard @thread contact */
WRC_API int32_t wrc_planar_regularise(wrc_contact* contact, const wrc_planar_strips* strips,
                                       wrc_planar_normal_solution* normal);

/** Tells a contact of a model with config.non_steady = 1 how far it has rolled since its last tangential stage; calls add
 * up. The next wrc_planar_tangential() or wrc_planar_step() takes that distance: pressure and creepages are those of
 * its end (creepages better of its middle), and every particle brings along the traction it had. Steps may be as long
 * as one likes: over six lengths of the patch they are steady rolling; with 0, the default, tractions stay where they
 * are. A contact begins, and begins again when the bodies have been apart, without tractions; save and restore take
 * all of that along, which a repeated step of an implicit integrator needs. Theory manual, Rolling that is not steady.
 * @param contact the contact
 * @param distance 0..1e6 m
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE, _UNSUPPORTED (a model without config.non_steady). @rt hard
 * @thread contact */
WRC_API int32_t wrc_planar_roll(wrc_contact* contact, double distance);

/** Solves the tangential problem of rolling, steady but for config.non_steady. Theory manual, sections 4 and 5; paper eq. 5 to 9.
 * @param contact the contact
 * @param ellipse exact double ellipse with its joint at the origin of the contact frame, which replaces the contact's
 * patches; NULL: the patches in the contact
 * @param creepage at the origin of the contact frame
 * @param friction between the bodies
 * @param[out] forces on the wheel, contact frame; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT, _TABLE_RANGE, _ITERATION_CAP (COARSE_HALFSPACE, at high adhesion often: forces
 * are usable), _CREEPAGES_LIMITED (creepage.reverse_share is not 0); WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no patch, or
 * friction zones over a profile without a wrc_planar_geometry), _RANGE, _NOT_FINITE, _UNSUPPORTED. @rt hard @thread
 * contact */
WRC_API int32_t wrc_planar_tangential(wrc_contact* contact, const wrc_ellipse* ellipse, const wrc_creepage* creepage,
                               const wrc_friction* friction, wrc_planar_forces* forces);

/** Wear and fatigue numbers of the last wrc_planar_tangential, and the fields POWER_DENSITY, FATIGUE_INDEX, STRIP_POWER.
 * Theory manual, section 6; paper eq. 10 to 12.
 * @param contact the contact
 * @param[out] damage the numbers; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE. @rt hard @thread contact */
WRC_API int32_t wrc_contact_damage(wrc_contact* contact, wrc_damage* damage);

/** Wear of the last wrc_planar_tangential by three laws, and the field STRIP_WEAR. May be called again with other laws.
 * Theory manual, section 6.
 * @param contact the contact
 * @param laws parameters; NULL: the published ones
 * @param[out] wear the numbers; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_planar_tangential before),
 * _NOT_FINITE, _RANGE, _UNSUPPORTED (a method that gives forces alone: no tractions to wear by). @rt hard @thread
 * contact */
WRC_API int32_t wrc_contact_wear(wrc_contact* contact, const wrc_wear_laws* laws, wrc_wear* wear);

/** Derivatives of the forces of the last wrc_planar_tangential or wrc_planar_step by creepages, load and friction,
 * for implicit integrators and linearisation: those of the discrete model itself, carried along with the forces
 * (forward mode), two to three times the cost of the forces. The creep force has kinks where a cell changes between
 * stick and slip; there it is the derivative from one side. Where strips stick a second time, which takes large spin,
 * it jumps there by up to 0.5 % of friction x load of one strip. So it is for FASTSIM with separate flexibilities and
 * strip FASTSIM, where neither friction nor the slope (modified FASTSIM) falls; all else has central differences
 * instead, with steps of a thousandth, for eight times the cost of the forces. Nothing in the contact changes, fields
 * included.
 * @param contact the contact
 * @param[out] sensitivity the derivatives; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT, _TABLE_RANGE, _ITERATION_CAP, _CREEPAGES_LIMITED (as wrc_planar_tangential());
 * WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_planar_tangential). @rt hard @thread contact */
WRC_API int32_t wrc_planar_tangential_derivatives(wrc_contact* contact, wrc_planar_derivatives* sensitivity);

/** Derivatives of the whole last step, patch included, with respect to the load (or approach) and, after a pose, to the
 * lateral shift of the wheelset: central differences of four steps, with a hundredth of the load or approach and with
 * 0.1 mm: wide enough for the strips' being cut anew in every patch not to show. Creepages and friction are held.
 * Nothing in the contact changes, fields included.
 * @param contact the contact
 * @param[out] sensitivity the derivatives; NULL: not wanted
 * @return WRC_OK; the flags of wrc_planar_step(); WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_planar_tangential,
 * or on strips or a patch of the caller), and those of wrc_planar_step() where a neighbouring step fails. @rt hard
 * @thread contact */
WRC_API int32_t wrc_contact_step_sensitivities(wrc_contact* contact, wrc_step_sensitivity* sensitivity);

/** All stages at once: geometry (without input->gap) or the given gap, normal, regularise, tangential, damage.
 * @param contact the contact
 * @param input what to solve
 * @param[out] output the results; NULL: not wanted
 * @return WRC_OK or the first flag of the stages; the failure of the first stage that fails, which ends the step with
 * all outputs zeroed. @rt hard @thread contact */
WRC_API int32_t wrc_planar_step(wrc_contact* contact, const wrc_planar_input* input, wrc_planar_output* output);

/** wrc_planar_step() for many contacts, in order. Contacts are independent: a host with threads gives each thread its own
 * range of contacts, with identical results.
 * @param contacts count of them, each once
 * @param count how many
 * @param inputs the first input; element i lies i * input_stride bytes behind it
 * @param input_stride [bytes]; 0: the same input for all
 * @param outputs the first output; element i lies i * output_stride bytes behind it
 * @param output_stride [bytes]
 * @param[out] statuses count of them; NULL: not wanted
 * @return the gravest status: the first failure, else the first flag, else WRC_OK. @rt hard
 * @thread contact, all of them */
WRC_API int32_t wrc_contact_step_batch(wrc_contact* const* contacts, uint32_t count, const wrc_planar_input* inputs,
                               uint64_t input_stride, wrc_planar_output* outputs, uint64_t output_stride,
                               int32_t* statuses);

#define WRC_FLAT_INPUTS 8   /**< numbers wrc_contact_step_flat() reads */
#define WRC_FLAT_OUTPUTS 12 /**< numbers wrc_contact_step_flat() writes */

/** wrc_planar_step() with plain arrays at a speed of 1 m/s, for Fortran 77 and S-functions.
 * @param contact of a model with profiles
 * @param in WRC_FLAT_INPUTS numbers: lateral [m], roll [rad], yaw [rad], normal force [N], nu_x, nu_y, phi [1/m],
 * friction
 * @param[out] out WRC_FLAT_OUTPUTS numbers: fx, fy, fn [N], mz [N m], power / speed [N], approach [m],
 * peak pressure [Pa], area [m^2], a [m], b [m], psi, fatigue index
 * @return as wrc_planar_step(). @rt hard @thread contact */
WRC_API int32_t wrc_contact_step_flat(wrc_contact* contact, const double* in, double* out);

/** One of the contact's patches with its forces.
 * @param contact the contact
 * @param index 0 .. wrc_planar_normal_solution.patches - 1, by increasing y
 * @param[out] patch the patch
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no patch yet), _RANGE (no such patch).
 * @rt hard @thread contact */
WRC_API int32_t wrc_contact_patch(const wrc_contact* contact, int32_t index, wrc_patch* patch);

/** Shows a field of one patch after the last call without copying it.
 * @param contact the contact
 * @param patch 0 .. wrc_planar_normal_solution.patches - 1, by increasing y; the fields of the gap ignore it
 * @param field enum wrc_field_id
 * @param[out] view where the numbers lie; data is NULL when the field has not been computed
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (not computed, or no contact), _RANGE (no such patch),
 * _UNSUPPORTED (no such field; tractions, slip, what is made of them and the friction of a strip of a method that gives
 * forces alone).
 * @rt hard @thread contact */
WRC_API int32_t wrc_contact_field(const wrc_contact* contact, int32_t patch, int32_t field, wrc_view* view);

/* -------------------------------------------------------------------------------------------------- plain numbers */

/** Coefficients of the linear theory. Theory manual, section 4; paper eq. 5.
 * @param a_over_b axis ratio, 1e-3..1e3 @param psi shape number, -0.95..0.95 @param poisson 0..0.5
 * @param[out] coefficients the coefficients
 * @return WRC_OK; WRC_FLAG_TABLE_RANGE beyond the tables; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _NOT_FINITE.
 * @rt hard @thread free */
WRC_API int32_t wrc_linear_coefficients(double a_over_b, double psi, double poisson, wrc_coefficients* coefficients);

/** Shakedown curve of the line contact: load factor p0/k above which the surface ratchets. Theory manual, section 6.
 * @param utilisation mu_a, 0..10
 * @param[out] load_factor p0/k; 0 on failure
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE. @rt hard @thread free */
WRC_API int32_t wrc_shakedown_limit(double utilisation, double* load_factor);

/** The same of a circular point contact, for material that hardens kinematically: below the surface up to mu_a = 0.22,
 * 1 / mu_a beyond. Theory manual, section 6.
 * @param utilisation mu_a, 0..10
 * @param[out] load_factor p0/k; 0 on failure
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE. @rt hard @thread free */
WRC_API int32_t wrc_shakedown_limit_point(double utilisation, double* load_factor);

/* ------------------------------------------------------------------------------------------------ wheel on rail */

#include "wrc_wheel.h"

/* ------------------------------------------------------------------------------- what contact does to the bodies */

#include "wrc_damage.h"

/* ---------------------------------------------------------------------------------------------------- for dlopen */

/** Every function as a table, for hosts that load the library at run time: wrc_api.h. */
typedef struct wrc_api wrc_api;

/** The function table of this library.
 * @param abi_version WRC_ABI_VERSION of the header you compiled with
 * @return the table, in static storage; NULL when the library does not serve that version: wrc_version_text() says
 * why. @rt hard @thread free */
WRC_API const wrc_api* wrc_get_api(uint32_t abi_version);

#ifdef __cplusplus
}
#endif

#endif /* WRC_H */
