/** @file wrc_planar.h
 * Contact on one plane, in stages: the system of the source paper. Conventions are those of wrc.h, which it includes.
 *
 * For prescribed creepages, single patches, published methods side by side. A wheelset in a simulation is wrc_contact_wrench().
 * The stages take the slip at one point, and forces jump where the lowest point of a pose does.
 *
 * A step is five stages. Call them together (wrc_planar_step), one by one, or enter in the middle with your own data:
 *
 *     wrc_planar_geometry     pose            -> initial contact point, contact angle, gap   (skip it: hand over a gap)
 *     wrc_planar_normal       gap, load       -> contact patch as strips, pressure, approach (skip it: hand over strips)
 *     wrc_planar_regularise   strips          -> equivalent double ellipse (SDEC) a, b, psi  (skip it: hand over an ellipse)
 *     wrc_planar_tangential   patch, creepage -> tractions, slip, forces, frictional power
 *     wrc_contact_damage      tractions       -> wear and fatigue numbers
 *
 * Results by patch: wrc_contact_region(), wrc_contact_field(), wrc_contact_damage() of wrc.h.
 *
 * @par Contact frame
 * Its origin is the initial contact point; x as that of the track, y lateral in the contact plane to the right, z normal into the
 * rail. Right-handed. For a right wheel y > 0 is the field side. Particles enter the patch at its +x end when rolling forwards
 * (speed > 0), at its -x end when rolling backwards. Forces and tractions act ON THE WHEEL and oppose the slip: for small creepage
 * F_x = -G a b C11 longitudinal.
 *
 * @par Stability
 * Frozen from 1.0 on, as wrc.h.
 */
#ifndef WRC_PLANAR_H
#define WRC_PLANAR_H

#include "wrc.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pose of the wheelset, track frame. Its height follows from the load. An amount below 1e-100 counts as 0. */
typedef struct wrc_planar_pose {
  double lateral;     /**< shift of the wheelset to the right, -0.1..0.1 m [0] */
  double roll;        /**< about x, right wheel down, -0.2..0.2 rad [0] */
  double yaw;         /**< about the rolled z, nose to the right, -0.2..0.2 rad [0] */
  double reserved[3]; /**< 0 */
} wrc_planar_pose;

/** Velocity of the wheelset relative to the track, track frame. */
typedef struct wrc_planar_motion {
  double speed;             /**< of its middle along the track, backwards < 0, -200..200 m/s [0] */
  double lateral_velocity;  /**< to the right, -20..20 m/s [0] */
  double vertical_velocity; /**< down, -20..20 m/s [0] */
  double roll_rate;         /**< about x, -100..100 rad/s [0] */
  double yaw_rate;          /**< about z, -100..100 rad/s [0] */
  double pitch_rate;        /**< about the axle, rolling forwards < 0, -2000..2000 rad/s [0] */
  double reserved[4];       /**< 0 */
} wrc_planar_motion;

/** Where wheel and rail first touch when the wheelset of a pose is lowered. */
typedef struct wrc_planar_point {
  double x;              /**< of the wheel's point, track frame [m] */
  double y;              /**< on the rail, track frame [m] */
  double z;              /**< see y */
  double y_wheel;        /**< in the coordinates of the wheel profile, flange side negative [m] */
  double y_rail;         /**< from the origin of the rail profile, after canting; field side positive [m] */
  double angle;          /**< contact angle: rotation about x from the track to the contact frame [rad] */
  double vertical_gap;   /**< height by which the wheel must be lowered, from its running circle level with the rail top [m] */
  double rolling_radius; /**< of the wheel at the contact point [m] */
  double reserved[4];    /**< 0 */
} wrc_planar_point;

/** The undeformed gap of a caller: rows along x at increasing y of the contact frame, along the normal. A constant offset does not
 * matter.
 *  - column_count == 0: row j is height[j] + curvature[j]/2 (x - centre[j])^2
 *  - column_count > 0: h[j * row_stride + i] at (x[i], y[j]). Each row is taken as the parabola fitted to its lowest part, up to
 *    config.planar.gap_limit / 4 above its minimum, with three points at least. */
typedef struct wrc_planar_gap {
  uint32_t row_count;      /**< 4..config.planar.gap_rows [0] */
  uint32_t column_count;   /**< 0 or 3..100000 [0] */
  const double* y;         /**< `row_count` of them, -0.3..0.3 m, increasing by 1e-6 m at least [required] */
  const double* height;    /**< `row_count` of them, smallest gap of the row, -0.3..0.3 m [required] */
  const double* centre;    /**< `row_count` of them, x of that smallest gap, -0.3..0.3 m; NULL: zero [NULL] */
  const double* curvature; /**< `row_count` of them, d2h/dx2, 1e-3..1e6 1/m. 1 / rolling radius on a straight rail [required] */
  const double* x;         /**< `column_count` of them, -0.3..0.3 m, increasing by 1e-6 m at least [required] */
  const double* h;         /**< gap of each element, -0.3..0.3 m [required] */
  uint64_t row_stride;     /**< elements from one row of h to the next, >= column_count [0] */
  double reserved[4];      /**< 0 */
} wrc_planar_gap;

/** Load that presses the bodies together. Damping is that of Hunt and Crossley, J. Appl. Mech. 42 (1975) 440-445: every pressure is the
 * elastic one times 1 + 3/2 damping * approach_velocity, never below 0. An impact at v m/s rebounds with about (1 - damping v) of
 * its velocity. */
typedef struct wrc_planar_load {
  int32_t prescribed;       /**< enum wrc_prescribed: WRC_PRESCRIBE_NORMAL_FORCE or _APPROACH [WRC_PRESCRIBE_NORMAL_FORCE] */
  uint32_t reserved0;       /**< 0 */
  double normal_force;      /**< along the contact normal, 1e2..1e6 N [0] */
  double approach;          /**< beyond first touch, -1..0.01 m; <= 0: no contact [0] */
  double approach_velocity; /**< d approach / dt, -20..20 m/s; positive while the bodies near each other [0] */
  double damping;           /**< factor of Hunt and Crossley, 0..10 s/m; 0: none [0] */
  double reserved[4];       /**< 0 */
} wrc_planar_load;

/** A pressure distribution of the caller: strips along x with semi-elliptic pressure. */
typedef struct wrc_planar_strips {
  uint32_t count;            /**< number of strips, 1..config.planar.strips [0] */
  uint32_t reserved0;        /**< 0 */
  const double* y;           /**< middle, `count` of them, -0.3..0.3 m, increasing; strips do not overlap [required] */
  const double* width;       /**< `count` of them, 1e-9..0.1 m [required] */
  const double* centre;      /**< x of the middle, `count` of them, -0.3..0.3 m; NULL: zero [NULL] */
  const double* half_length; /**< `count` of them, 1e-9..0.1 m [required] */
  const double* peak;        /**< peak pressure, `count` of them, 0..1e11 Pa [required] */
  double reserved[4];        /**< 0 */
} wrc_planar_strips;

/** Solution of the normal problem, all patches together. */
typedef struct wrc_planar_normal_solution {
  int32_t patch_count;  /**< separate patches: wrc_contact_region() has each */
  int32_t strip_count;  /**< strips under pressure */
  int32_t iterations;   /**< of the load search, or sweeps */
  uint32_t flags;       /**< bit 1 << flag for each WRC_FLAG_... met */
  wrc_ellipse ellipse;  /**< of the patch that carries most */
  double normal_force;  /**< compressive positive, damping included [N] */
  double damping_force; /**< share of normal_force that is damping; < 0 while the bodies part [N] */
  double approach;      /**< beyond first touch, along the normal; 0 for an ellipse or strips of the caller [m] */
  double stiffness;     /**< d normal_force / d approach; of STRIP_HALFSPACE and ANALYN within 6 % [N/m] */
  double peak_pressure; /**< largest pressure as solved, not of the equivalent ellipse [Pa] */
  double area;          /**< [m^2] */
  double length;        /**< extent along x: foremost to rearmost edge of all strips [m] */
  double width;         /**< extent along y: y_max - y_min [m] */
  double y_min;         /**< lateral border [m] */
  double y_max;         /**< see y_min */
  double reserved[4];   /**< 0 */
} wrc_planar_normal_solution;

/** Forces on the wheel in the contact frame, moment about its origin. */
typedef struct wrc_planar_forces {
  double fx;                /**< longitudinal creep force [N] */
  double fy;                /**< lateral creep force [N] */
  double fn;                /**< normal force, compressive positive, damping included [N] */
  double mz;                /**< spin moment [N m] */
  double power;             /**< frictional power at the given speed, >= 0 [W] */
  double adhesion_fraction; /**< share of the patch's area that sticks [-]; WRC_AVAILABLE_TRACTIONS */
  uint32_t available;       /**< bits of enum wrc_available; members without their bit are 0 */
  uint32_t flags;           /**< bit 1 << flag for each WRC_FLAG_... met */
  double reserved[4];       /**< 0 */
} wrc_planar_forces;

/** Derivatives of the forces of the last wrc_planar_tangential() at its patch. */
typedef struct wrc_planar_derivatives {
  uint32_t struct_size; /**< sizeof this struct, 200 or more */
  uint32_t reserved0;   /**< 0 */
  double forces[3][8];  /**< rows fx, fy [N], mz [N m]; columns longitudinal, lateral [-], spin [1/m], normal_force [N] of the same
                             patch, factor on friction [-], the rest 0 */
} wrc_planar_derivatives;

/** Input of wrc_planar_step(). Data behind its pointers belong to the caller and are only read during the call. */
typedef struct wrc_planar_input {
  uint32_t struct_size;      /**< sizeof this struct, 456 or more */
  uint32_t reserved0;        /**< 0 */
  wrc_planar_pose pose;      /**< of the wheelset; not used with `gap`, but within its ranges */
  const wrc_planar_gap* gap; /**< a gap of the caller in place of the pose; NULL: the pose [NULL] */
  wrc_planar_load load;      /**< load that presses the bodies together */
  wrc_creepage creepage;     /**< rigid slip at the origin of the contact frame */
  wrc_friction friction;     /**< between the bodies */
} wrc_planar_input;

/** Results of wrc_planar_step(). */
typedef struct wrc_planar_output {
  uint32_t struct_size;              /**< sizeof this struct, 512 or more */
  uint32_t flags;                    /**< bit 1 << flag for each WRC_FLAG_... met, of all stages */
  wrc_planar_point point;            /**< zero when there was no pose */
  wrc_planar_normal_solution normal; /**< of the normal stage */
  wrc_planar_forces forces;          /**< of the tangential stage */
  wrc_damage damage;                 /**< of all patches together */
} wrc_planar_output;

/** @name Defaults
 * As those of wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_planar_load_init(wrc_planar_load* load); /**< Defaults: load. */
WRC_API int32_t wrc_creepage_init(wrc_creepage* creepage); /**< Defaults: creepages. */
WRC_API int32_t wrc_planar_input_init(wrc_planar_input* input); /**< Defaults: input of a step. */
/** @cond */
WRC_DEFAULT(wrc_planar_load)
WRC_DEFAULT(wrc_creepage)
WRC_DEFAULT_SIZED(wrc_planar_input)
/** @endcond */
/** @} */

/** All stages at once: geometry (without input->gap) or the given gap, normal, regularise, tangential, damage.
 * @param contact the contact
 * @param input what to solve
 * @param[out] output the results; NULL: not wanted
 * @return WRC_OK or the gravest flag of the stages; the failure of the first stage that fails, which ends the step.
 * @rt hard @thread contact */
WRC_API int32_t wrc_planar_step(wrc_contact* contact, const wrc_planar_input* input, wrc_planar_output* output);

/** Finds the initial contact point of a pose, the lowest one, and samples the gap around it. Rows reach up to 30 mm to either side.
 * Theory manual, section 7.
 * @param contact of a model with profiles
 * @param pose of the wheelset, track frame
 * @param[out] point where the bodies touch first; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_ITERATION_CAP; WRC_ERROR_NULL, _SEQUENCE (model without profiles), _NOT_FINITE, _RANGE, _GAP (no rail
 * below the wheel at this pose). @rt hard @thread contact */
WRC_API int32_t wrc_planar_geometry(wrc_contact* contact, const wrc_planar_pose* pose, wrc_planar_point* point);

/** Creepages at the origin of the contact frame of the last wrc_planar_geometry(), from the rigid motion of the wheelset. The velocity
 * of the wheel's point is divided by the amount of the rolling speed V. That is the mean of the speeds of wheel and rail material
 * through the contact. A locked wheel has half its speed and creepage 2.
 *  - Below |V| = 0.1 m/s the divisor is 0.1 m/s (3 + 6 u^2 - u^4) / 8, u = |V| / 0.1 m/s. `speed` has its amount and the sign of V.
 *    reverse_share goes to 0.5 at V = 0. Forces are twice differentiable in the motion through V = 0.
 *  - Where a creepage would pass its range, all are divided by more, and speed grows by it.
 *  - |speed| ends at 200 m/s.
 *
 * Theory manual, section 7.
 * @param contact the contact
 * @param motion of the wheelset, track frame
 * @param[out] creepage for wrc_planar_tangential(), as it stands; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_CREEPAGES_LIMITED (any of these three); WRC_ERROR_NULL, _SEQUENCE (no wrc_planar_geometry before),
 * _NOT_FINITE, _RANGE. @rt hard @thread contact */
WRC_API int32_t wrc_planar_creepages(wrc_contact* contact, const wrc_planar_motion* motion, wrc_creepage* creepage);

/** Solves the normal problem and regularises the patch. Strips stay in the contact. Theory manual, sections 2 and 3.
 * @param contact the contact
 * @param gap contact frame; copied; NULL: the gap already in the contact, of wrc_planar_geometry() or of an earlier call
 * @param load along the contact normal
 * @param[out] normal the solution; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT (approach <= 0, or damping takes all of the force); _ITERATION_CAP, _PATCH_AT_EDGE,
 * _MORE_PATCHES, _TABLE_RANGE (|psi| cut to 0.95); _LOAD_JUMPS (HERTZ to STRIPES: no approach carries the load; the one of the next
 * larger load is returned), _BEYOND_GAP (deeper than config.planar.gap_limit: continued with the last stiffness, the patch stays);
 * WRC_ERROR_NULL, _SEQUENCE (gap is NULL and the contact has none), _GAP, _LOAD, _NOT_FINITE, _RANGE, _UNSUPPORTED.
 * @rt hard @thread contact */
WRC_API int32_t wrc_planar_normal(wrc_contact* contact, const wrc_planar_gap* gap, const wrc_planar_load* load,
                                  wrc_planar_normal_solution* normal);

/** Takes a pressure distribution of the caller as the contact's patch and finds its equivalent double ellipse. Theory manual,
 * section 3; paper section 2.
 * @param contact the contact
 * @param strips contact frame, whose origin must be the initial contact point; copied; NULL: the strips in the contact
 * @param[out] normal sums over the strips, with their double ellipse; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT (no pressure), _TABLE_RANGE (|psi| cut to 0.95); WRC_ERROR_NULL, _SEQUENCE (strips is NULL and
 * the contact has none), _RANGE, _NOT_FINITE. @rt hard @thread contact */
WRC_API int32_t wrc_planar_regularise(wrc_contact* contact, const wrc_planar_strips* strips, wrc_planar_normal_solution* normal);

/** Tells a contact of a model with config.planar.non_steady how far it has rolled since its last tangential stage. Distances add up.
 * The next wrc_planar_tangential() takes them: every particle brings along its traction, and pressure is that of the end. Creepages
 * times the distance are the rigid displacement of the wheel over the rail. The sign of creepage.speed is the way of rolling. With
 * speed 0 the wheel rests, and the displacement is a shift. Over two lengths of the patch rolling is steady. A contact begins without
 * tractions, also after the bodies have been apart. Save and restore hold them. Theory manual, "Contact with memory".
 * @param contact the contact
 * @param distance rolled either way, or at rest the length that creepages are per, 0..1e6 m
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE, _UNSUPPORTED (a model without config.planar.non_steady).
 * @rt hard @thread contact */
WRC_API int32_t wrc_planar_roll(wrc_contact* contact, double distance);

/** Solves the tangential problem of rolling, steady but for config.planar.non_steady. Theory manual, sections 4 and 5; paper eq. 5
 * to 9.
 * @param contact the contact
 * @param ellipse exact double ellipse with its joint at the origin, which replaces the contact's patches; its pressure is
 * semi-elliptic, p0 = 1.5 N / (pi a b); NULL: the patches in the contact
 * @param creepage at the origin of the contact frame
 * @param friction between the bodies
 * @param[out] forces on the wheel, contact frame; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT, _TABLE_RANGE, _ITERATION_CAP, _CREEPAGES_LIMITED (creepage.reverse_share is not 0);
 * WRC_ERROR_NULL, _SEQUENCE (no patch, or friction zones over a profile without a wrc_planar_geometry()), _RANGE, _NOT_FINITE,
 * _UNSUPPORTED. @rt hard @thread contact */
WRC_API int32_t wrc_planar_tangential(wrc_contact* contact, const wrc_ellipse* ellipse, const wrc_creepage* creepage,
                                      const wrc_friction* friction, wrc_planar_forces* forces);

/** Derivatives of the forces of the last wrc_planar_tangential() or wrc_planar_step() by creepages, load and friction. FASTSIM with
 * separate flexibilities and strip FASTSIM have those of the discrete equations, for two to three times the cost of the forces.
 * Methods of which friction or slope falls, and all others, have central differences with steps of a thousandth, for eight times
 * the cost. The creep force has kinks where a cell changes between stick and slip: there it is one side's. The contact stays as it
 * is.
 * @param contact the contact
 * @param[out] derivatives of the forces; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT, _TABLE_RANGE, _ITERATION_CAP, _CREEPAGES_LIMITED (as wrc_planar_tangential());
 * WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_planar_tangential()). @rt hard @thread contact */
WRC_API int32_t wrc_planar_tangential_derivatives(wrc_contact* contact, wrc_planar_derivatives* derivatives);

#ifdef __cplusplus
}
#endif

#endif /* WRC_PLANAR_H */
