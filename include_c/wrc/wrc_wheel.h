/** @file wrc_wheel.h
 * A wheel on a rail in one call, for multibody hosts: where both are and how they move in, the wrench between them out.
 * Part of wrc.h, which includes it; the conventions there (structs, statuses, classes) hold here.
 *
 * Nothing here chooses a contact point: every strip of the rail's surface has its own normal, overlap and slip, and
 * the strips' forces are summed in track axes. The wrench is therefore continuous in the whole pose; tread, gauge
 * corner and flange are one problem, and two-point contact is nothing special.
 *
 * @par Frames, origins, signs (SI: m, N, rad, s)
 *
 *        track axes (fixed): x forward, y right, z DOWN; origin on the track centre line, level with the undisplaced rails' tops
 *
 *              left wheel     O  axle            right wheel          seen from behind, x into the page
 *              ____   ________|________________________   ____
 *             |    |_|        |                        |_|    |       O        nominal place (0, 0, -r0)
 *             |    | |        +--> y                   | |    |       W        nominal place (0, +-s, -r0), right +, left -
 *             |  W-+-|--------O------------------------|-+-W  |                s = flange_back_distance / 2 + 0.070
 *             |    | |        |                        | |    |       r0       config.wheelset.wheel_radius, at the tape circle
 *              \__/\_|        v z                      |_/\__/        P        origin of the rail's profile
 *              --P---                                   ---P--                 (config.track.placement)
 *
 *  - Pose of a wheel: the reference point (O or W, wrc_wheel_state.reference) is displaced from its nominal place by
 *    (y, z): z > 0 is down, into the rail. Where it is along x does not matter.
 *  - Orientation: R = Rx(roll) Rz(yaw): first roll about the track's x axis, then yaw about the rolled z axis,
 *    right-hand rule: roll > 0 lowers the right wheel, yaw > 0 turns the nose to the right. Pitch does not matter. Or
 *    any rotation matrix of the host with track = R * body and the body's y along the axle, to the right, with or
 *    without the pitch in it.
 *  - Velocity: of the reference point, in track axes. Angular velocity: whole, the turning about the axle included
 *    (forward rolling: its y component is about -v / r0 < 0), in track axes or in those of R.
 *  - Pose of a rail: P displaced by (y, z) and the profile turned about P by roll, right-hand rule about x.
 *  - Wrench: force and moment ON THE WHEEL in track axes, the moment about the reference point: a wheel pressed down
 *    has force[2] < 0. rail_force, rail_moment: on the rail, the moment about the displaced P at the x of the reference
 *    point.
 *  - Both sides share these axes: nothing is mirrored for a left wheel. One model serves both sides; each wheel has its
 *    own contact, which knows its side.
 *
 * @par Recipe
 * @code
 *   wrc_config config = wrc_config_default();
 *   config.wheel.kind = WRC_PROFILE_S1002;
 *   config.rail.kind = WRC_PROFILE_60E1;
 *   config.track.rail_inclination = 1.0 / 40.0;
 *   wrc_model* model = NULL;
 *   wrc_contact* contact[2] = {NULL, NULL};
 *   if (wrc_model_create(&config, NULL, &model) < 0) ...                // wrc_config_check() says why
 *   for (side = 0; side < 2; ++side) wrc_contact_create(model, side, NULL, &contact[side]);
 *
 *   wrc_wheel_input input = wrc_wheel_input_default();
 *   wrc_wrench wrench = wrc_wrench_default();
 *   // in every evaluation of the right-hand side, from here on without allocation:
 *   wrc_wheel_state* wheel = &input.wheel;
 *   wheel->y = y;                      wheel->z = z;                    // of the wheelset's middle; z > 0 down
 *   wheel->roll = roll;                wheel->yaw = yaw;
 *   wheel->velocity[0] = v;            wheel->velocity[1] = dy_dt;            wheel->velocity[2] = dz_dt;
 *   wheel->angular_velocity[0] = wx;   wheel->angular_velocity[1] = wy;       wheel->angular_velocity[2] = wz;
 *   for (side = 0; side < 2; ++side) {
 *     int32_t status = wrc_contact_wrench(contact[side], &input, &wrench);  // < 0: wrc_contact_last_error() says why
 *     for (i = 0; i < 3; ++i) force[i] += wrench.force[i], moment[i] += wrench.moment[i];
 *   }
 * @endcode
 */
#if !defined(WRC_H) && !defined(DOXYGEN)
#include "wrc.h" /* which includes this file in its place */
#elif !defined(WRC_WHEEL_H)
#define WRC_WHEEL_H

/** Which point of the rotating body the pose, the velocity and the moment refer to. */
enum wrc_wheel_reference {
  WRC_REFERENCE_WHEELSET = 0, /**< O, the middle of the axle */
  WRC_REFERENCE_WHEEL = 1     /**< W, where the plane of the tape circle meets the axle: independent wheels, elastic axles */
};

/** In which axes an angular velocity is given. */
enum wrc_axes {
  WRC_AXES_TRACK = 0, /**< track axes */
  WRC_AXES_BODY = 1   /**< the body's: those of roll and yaw, which do not turn with the pitch, or of `rotation` */
};

/** Which of height and load of a wheel is given; the other is a result. */
enum wrc_prescribed {
  WRC_PRESCRIBE_HEIGHT = 0,       /**< wheel.z is given: the choice of a dynamic simulation */
  WRC_PRESCRIBE_VERTICAL_LOAD = 1 /**< vertical_load is given, z of the reference point is found */
};

/** Where the sweeps over the strips, and the search for the height of a load, begin. */
enum wrc_start {
  WRC_START_COLD = 0,     /**< results depend on the inputs of the call alone, to the last bit */
  WRC_START_WARM = 1 /**< the contact's last solution: a third faster where poses follow each other. Results then depend
                               on the calls before, by at most 1e-7 of the normal force. For explicit integrators and fixed
                               steps: the iterations of an implicit one that are to end at 1e-8 see that */
};

/** Where a wheel or wheelset is and how it moves, against the ground. */
typedef struct wrc_wheel_state {
  int32_t reference;          /**< enum wrc_wheel_reference: of y, z, velocity and the wrench's moment
                                   [WRC_REFERENCE_WHEELSET] */
  int32_t angular_axes;       /**< enum wrc_axes: of angular_velocity [WRC_AXES_TRACK] */
  double y;                   /**< displacement of the reference point to the right, -0.2..0.2 m [0]. Did you pass mm? */
  double z;                   /**< the same downwards, -0.5..0.2 m with WRC_PRESCRIBE_HEIGHT [0]. Too small: did you pass
                                   mm? Too large: did you pass mm, or a height above the rail? 0 is the nominal height,
                                   down is positive */
  double roll;                /**< -0.5..0.5 rad, must be 0 with `rotation` [0]. Did you pass degrees or mrad? */
  double yaw;                 /**< -0.5..0.5 rad, must be 0 with `rotation` [0]. Did you pass degrees or mrad? */
  const double* rotation;     /**< 9 numbers row by row, track = R * body, orthonormal to 1e-6; the axle within 0.5 rad of
                                   the track's y axis in both directions; NULL: from roll and yaw [NULL] */
  double velocity[3];         /**< of the reference point, track axes, -200..200, -50..50, -50..50 m/s [0]. Did you pass
                                   km/h or mm/s, or other axes? */
  double angular_velocity[3]; /**< y is about the axle, -200..200, -2000..2000, -200..200 rad/s [0]. Did you pass rpm or
                                   degrees? the axle is the y axis */
} wrc_wheel_state;

/** Displacement and motion of a rail, track axes. The velocities are those of its material. Where a wheel runs along a
 * rail that is bent but at rest they are 0: what the rail's slope adds is there when the wheel's velocity, angular
 * velocity and orientation are given in axes turned into the rail's direction (docs/hosts.md), and the wrench is in
 * these axes then. */
typedef struct wrc_rail_state {
  double y;             /**< displacement of the origin of its profile to the right, -0.2..0.2 m [0]. Did you pass mm? */
  double z;             /**< the same downwards, -0.2..0.2 m [0]. Did you pass mm? */
  double roll;          /**< rotation about that origin and the x axis, -0.5..0.5 rad [0]. Did you pass degrees or mrad? */
  double y_velocity;    /**< along y, -50..50 m/s [0]. Did you pass mm/s? */
  double z_velocity;    /**< along z, -50..50 m/s [0]. Did you pass mm/s? */
  double roll_velocity; /**< about x, -200..200 rad/s [0]. Did you pass degrees or mrad? */
} wrc_rail_state;

/** How a frame moves that follows a curved track, for hosts whose velocities are those within it. Its origin is on the track
 * centre line, level with the rails' tops, its axes are track axes there. It turns at speed * (twist, vertical_curvature,
 * curvature) about them, and what it does is added to the wheel's velocity and angular velocity, at the wheel's reference
 * point (where its height is not given, at its nominal height). All zero: velocities are against the ground. Velocities of
 * the rail are those of its material against the ground either way. */
typedef struct wrc_frame_motion {
  double speed;              /**< of its origin along the track, -200..200 m/s [0]. Did you pass km/h? */
  double curvature;          /**< of the track in plan, to the right, -0.1..0.1 1/m [0]. Did you pass a radius? */
  double vertical_curvature; /**< of the track's height, upwards as in a dip, -0.1..0.1 1/m [0]. Did you pass a radius? */
  double twist;              /**< roll of the track per distance, right side down, -0.5..0.5 1/m: rate of the cant over the
                                  speed [0]. Did you pass a rate, or mm? */
} wrc_frame_motion;

/** What wrc_contact_wrench() reads. What pointers within point to is the caller's and only
 * read during the call. */
typedef struct wrc_wheel_input {
  uint32_t struct_size;  /**< sizeof this struct, 304 or more */
  int32_t prescribed;    /**< enum wrc_prescribed [WRC_PRESCRIBE_HEIGHT] */
  int32_t start;         /**< enum wrc_start [WRC_START_COLD] */
  uint32_t reserved;     /**< 0 */
  wrc_wheel_state wheel; /**< where the wheel is and how it moves */
  wrc_rail_state rail;   /**< where the rail is and how it moves */
  wrc_friction friction; /**< of each strip at its own sliding speed; coefficient 0 without zones: none, and no creep
                              forces; zones count from the origin of the rail's profile (WRC_ZONES_RAIL_PROFILE) and lie on
                              the rail, or from that of the wheel's (WRC_ZONES_WHEEL_PROFILE) and lie on the wheel */
  double vertical_load;  /**< the whole vertical force on the wheel, creep forces included, upwards positive, 1e2..1e6 N
                              with WRC_PRESCRIBE_VERTICAL_LOAD, 0 else [0]. Negative: the load is positive where the rail
                              pushes the wheel upwards. Too small: did you pass kN? near lift-off prescribe the height
                              instead. Too large: did you pass a pressure, or grams? Else: the height is prescribed */
  double damping;        /**< of Hunt and Crossley as in wrc_planar_load, strip by strip, with the velocity at which the strip's
                              own overlap grows, 0..10 s/m with WRC_PRESCRIBE_HEIGHT, 0 else [0]. Negative: damping takes
                              energy out. Too large: it is not a viscous constant: that over 3/2 of the force it was
                              found at. Else: a prescribed load is the whole load */
  double distance;       /**< of the reference point along the track, for a rail with config.rail_sections, -1e7..1e7 m;
                              or from above the axle of a roller (config.roller_curvature), within 0.2 m of it; 0 else [0].
                              Did you pass mm? */
  double angle;          /**< of the wheel about its axle, for one with config.roundness, -1e9..1e9 rad; 0 else: right-hand
                              rule about y, so that its rate is the angular velocity about the axle and it falls rolling
                              forwards [0]. Did you pass degrees? */
  double roller_velocity; /**< angular velocity of a roller (config.roller_curvature) about its axle, right-hand rule about y,
                              -2000..2000 rad/s; 0 else: it is positive where a wheel at rest rolls forwards on it [0]. Did
                              you pass rpm or degrees? */
  wrc_frame_motion frame; /**< of the axes that velocities are given in */
} wrc_wheel_input;

/** What passes between a wheel and its rail. All zero, but for z, where they do not touch. Numbers are continuous functions of
 * the inputs but where they say otherwise. */
typedef struct wrc_wrench {
  uint32_t struct_size;  /**< sizeof this struct, 160 or more */
  int32_t regions;       /**< separate regions in contact: wrc_contact_region() */
  int32_t iterations;    /**< of the normal problem, all of the call */
  uint32_t leaps;        /**< 1: a normal method for planes has been applied to a patch with several lowest points, about as
                              deep as each other: forces leap where the lowest changes; 0: no such patch */
  double force[3];       /**< on the wheel, track axes [N] */
  double moment[3];      /**< on the wheel about its reference point, track axes [N m] */
  double rail_force[3];  /**< on the rail, track axes: -force [N] */
  double rail_moment[3]; /**< on the rail about the displaced origin of its profile, track axes [N m] */
  double z;              /**< displacement of the reference point, as given or as found [m] */
  double normal_force;   /**< sum over the regions of the resultants of their pressures [N]; steps where regions join or
                              part, as their resultants have different directions */
  double area;           /**< [m^2] */
  double peak_pressure;  /**< [Pa] */
  double power;          /**< frictional power, >= 0 [W] */
  double steepest_angle; /**< largest angle between z and the surface normal of a rail's strip in contact, >= 0; steps
                              where a strip enters or leaves [rad] */
} wrc_wrench;

/** One region of the last wrc_contact_wrench(): a run of neighbouring strips in contact. For people and for what comes after;
 * the wrench does not depend on where regions are divided. */
typedef struct wrc_region {
  uint32_t struct_size; /**< sizeof this struct, 176 or more */
  uint32_t reserved;    /**< 0 */
  double point[3];      /**< centre of pressure, track axes; x from the wheel's reference point [m] */
  double y_wheel;       /**< that point in the coordinates of the wheel's profile, flange side negative [m] */
  double z_wheel;       /**< the same, down from the tape circle [m] */
  double y_rail;        /**< that point in the coordinates of the rail's profile, field side positive [m] */
  double z_rail;        /**< the same, down from the profile's origin [m] */
  double angle;         /**< of the resultant of the pressure: about x from the track's z to the normal into the rail;
                             < 0 on the gauge side of the right rail, > 0 on that of the left [rad] */
  double normal_force;  /**< resultant of the pressure [N] */
  double force[3];      /**< on the wheel, track axes [N] */
  double moment[3];     /**< on the wheel about `point`, track axes [N m] */
  double area;          /**< [m^2] */
  double peak_pressure; /**< [Pa] */
  double power;         /**< frictional power [W] */
  double creepage[3];   /**< means over the load: longitudinal, lateral [-], spin [1/m], of the wheel over the rail */
  int32_t strips;       /**< strips it is made of: columns of wrc_contact_region_field() */
  int32_t cells;        /**< cells along each of them: its rows */
  int32_t face;         /**< of which surface of the rail: as wrc_rail_section.face; with config.check_rail 0 on that and 1 on
                             the rail; 0 else */
  uint32_t reserved2;   /**< 0 */
} wrc_region;

/** What wrc_contact_region_field() writes of a region: one value per strip, by increasing arc length, or one per cell of its
 * strips. Each strip has axes of its own on the rail's surface: x forward along the track, s along the rail's arc from its
 * gauge side to its field side, on either side of the track. */
enum wrc_region_field {
  WRC_REGION_X = 0,               /**< cells: x of the middle, as wrc_region.point[0] [m] */
  WRC_REGION_PRESSURE = 1,        /**< cells: normal pressure in the middle [Pa] */
  WRC_REGION_TRACTION_X = 2,      /**< cells: tangential traction on the wheel along x [Pa] */
  WRC_REGION_TRACTION_S = 3,      /**< cells: the same along s [Pa] */
  WRC_REGION_SLIP_X = 4,          /**< cells: sliding velocity of the wheel over the rail / rolling speed along x [-] */
  WRC_REGION_SLIP_S = 5,          /**< cells: the same along s [-] */
  WRC_REGION_POWER_DENSITY = 6,   /**< cells: frictional power per area [W/m^2] */
  WRC_REGION_FATIGUE_INDEX = 7,   /**< cells: local surface fatigue index, as WRC_FIELD_FATIGUE_INDEX [-] */
  WRC_REGION_STRIP_S = 8,         /**< strips: arc length of the middle, from the gauge end of the rail's profile [m] */
  WRC_REGION_STRIP_WIDTH = 9,     /**< strips: width along the arc [m] */
  WRC_REGION_STRIP_CENTRE = 10,   /**< strips: x of the middle, as wrc_region.point[0] [m] */
  WRC_REGION_STRIP_HALF = 11,     /**< strips: half length [m] */
  WRC_REGION_STRIP_PEAK = 12,     /**< strips: peak pressure, damping included [Pa] */
  WRC_REGION_STRIP_POWER = 13,    /**< strips: frictional power per unit width [W/m] */
  WRC_REGION_STRIP_FRICTION = 14, /**< strips: coefficient of friction the law gave [-] */
  WRC_REGION_STRIP_Y = 15,        /**< strips: the middle in the coordinates of the rail's profile, as wrc_region.y_rail [m] */
  WRC_REGION_STRIP_Z = 16,        /**< strips: the same, as wrc_region.z_rail [m] */
  WRC_REGION_STRIP_ANGLE = 17,    /**< strips: of the rail's surface about x in the same coordinates; < 0 on the gauge side
                                       [rad] */
  WRC_REGION_TEMPERATURE_RISE = 18 /**< cells: rise of both surfaces by friction over what they have at first touch [K]:
                                       wrc_contact_region_temperature() */
};

/** What a wrench depends on: the columns of wrc_wrench_derivatives. */
enum wrc_wrench_input {
  WRC_BY_Y = 0,                   /**< wheel.y [m] */
  WRC_BY_Z = 1,                   /**< wheel.z [m], where the height is prescribed */
  WRC_BY_ROLL = 2,                /**< wheel.roll; with `rotation` that of its axle [rad] */
  WRC_BY_YAW = 3,                 /**< wheel.yaw; with `rotation` that of its axle [rad] */
  WRC_BY_VELOCITY_X = 4,          /**< wheel.velocity[0] [m/s] */
  WRC_BY_VELOCITY_Y = 5,          /**< wheel.velocity[1] [m/s] */
  WRC_BY_VELOCITY_Z = 6,          /**< wheel.velocity[2] [m/s] */
  WRC_BY_ANGULAR_VELOCITY_X = 7,  /**< wheel.angular_velocity[0], in the axes it is given in [rad/s] */
  WRC_BY_ANGULAR_VELOCITY_Y = 8,  /**< wheel.angular_velocity[1] [rad/s] */
  WRC_BY_ANGULAR_VELOCITY_Z = 9,  /**< wheel.angular_velocity[2] [rad/s] */
  WRC_BY_RAIL_Y = 10,             /**< rail.y [m] */
  WRC_BY_RAIL_Z = 11,             /**< rail.z [m] */
  WRC_BY_RAIL_ROLL = 12,          /**< rail.roll [rad] */
  WRC_BY_RAIL_Y_VELOCITY = 13,    /**< rail.y_velocity [m/s] */
  WRC_BY_RAIL_Z_VELOCITY = 14,    /**< rail.z_velocity [m/s] */
  WRC_BY_RAIL_ROLL_VELOCITY = 15, /**< rail.roll_velocity [rad/s] */
  WRC_BY_VERTICAL_LOAD = 16,      /**< vertical_load [N], where it is prescribed */
  WRC_BY_DISTANCE = 17,           /**< distance [m]; but for what strips grow wider or narrower along the track */
  WRC_BY_ANGLE = 18               /**< angle [rad] */
};

#define WRC_WRENCH_INPUTS 19 /**< columns of wrc_wrench_derivatives */

/** Derivatives of the wrench on the wheel about its reference point, at the pose and motion given. What is prescribed is
 * held: with WRC_PRESCRIBE_VERTICAL_LOAD the height follows all other inputs, and the column of z is zero; otherwise that
 * of the load. */
typedef struct wrc_wrench_derivatives {
  double wrench[6][19]; /**< rows force x, y, z [N], moment x, y, z [N m], track axes; columns enum wrc_wrench_input */
  double z[19];         /**< of wrc_wrench.z; columns the same */
} wrc_wrench_derivatives;

/** @name Defaults
 * As those of wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_wheel_state_init(wrc_wheel_state* state); /**< Defaults: wheel's state. */
WRC_API int32_t wrc_rail_state_init(wrc_rail_state* rail); /**< Defaults: rail's state. */
WRC_API int32_t wrc_frame_motion_init(wrc_frame_motion* frame); /**< Defaults: motion of the frame. */
WRC_API int32_t wrc_wheel_input_init(wrc_wheel_input* input); /**< Defaults: wheel's input. */
WRC_API int32_t wrc_wrench_init(wrc_wrench* wrench); /**< Defaults: wrench. */
WRC_API int32_t wrc_region_init(wrc_region* region); /**< Defaults: region. */
/** @cond */
WRC_DEFAULT(wrc_wheel_state)
WRC_DEFAULT(wrc_rail_state)
WRC_DEFAULT(wrc_frame_motion)
WRC_DEFAULT_SIZED(wrc_wheel_input)
WRC_DEFAULT_SIZED(wrc_wrench)
WRC_DEFAULT_SIZED(wrc_region)
/** @endcond */
/** @} */

/** The wrench between a wheel and a rail at this pose and motion, steady rolling. Does not touch the results of the
 * stages of wrc.h in the same contact, nor they its.
 * Any methods will do. The defaults, WRC_NORMAL_STRIP_HALFSPACE and WRC_TANGENTIAL_STRIP_FASTSIM, know no patch and are
 * what the accuracy and the smoothness of this call are stated for. The other normal methods are applied patch by patch
 * to the surface unrolled, patches that grow together being joined smoothly; their forces act along the strips' own
 * normals. FASTSIM and FaStrip roll strip by strip, each with its own slip and coefficients, with
 * WRC_PATCH_MODEL_PATCH_SDEC, WRC_FLEXIBILITY_SEPARATE and a bound other than WRC_BOUND_ELLIPSOIDAL, and without
 * friction.slope_fall; in every other form, as the coarse half-space and the force table, they roll patch by patch with
 * the means of the strips' slips over the load, on the ellipse or double ellipse with the moments of that load
 * (config.tangential.regularisation is not used). Theory manual, section 9.
 * Friction over temperature (WRC_FRICTION_TEMPERATURE) is found strip by strip as by the stages, in six solutions of the
 * tractions at each height; the call takes twice as long.
 * @param contact of a model with profiles
 * @param input what to solve
 * @param[out] wrench the result; NULL: not wanted
 * @par Rollers
 * With config.roller_curvature the rail is a roller whose axle lies along the profile's y, that far below its origin: its
 * surface falls away along x, and leans there, which a yawed wheel feels as a force along x; its material moves with
 * roller_velocity. wheel.velocity is that of a wheel that stays above it (0 on a roller rig). Along x the surfaces are
 * taken for parabolas.
 * @par Where the load is given and friction is high
 * Where friction on a steep face outweighs its slope, the vertical force may fall as the wheel goes down. The way down from
 * first touch to 2 mm of overlap, or to a normal force of 20 loads, is looked at then, at depths each twice the one before,
 * so that what is returned does not depend on earlier calls: the highest place (least z) that carries the load, with a force that grows downwards; where none
 * does, the one at which the force first ceases to grow, which is where the former ends as the load grows: without a
 * jump, and with less than the load in force[2]; zero at first touch, where it never grows. WRC_FLAG_CLIMBING says that
 * none or several carry the load, or that the force falls on the way to the one returned.
 * @return WRC_OK; WRC_FLAG_NO_CONTACT (apart: all zero; so is a flange 4 mm and more inside
 * the side of a rail, and its back, which the sentence says), _ITERATION_CAP, _CLIMBING (above), _BEYOND_GAP (deeper than 2 mm: where the height is given, continued with the
 * stiffness and the directions there), _PATCH_AT_EDGE (contact reaches the
 * end of a profile; what lies beyond carries nothing), _BEYOND_SECTIONS, _CREEPAGES_LIMITED (with friction, slower than 0.1 m/s: as
 * wrc_planar_creepages()), _MORE_PATCHES (more regions than can be told apart: the last takes the rest, the wrench is
 * whole; or, says the sentence, more strips overlap than there is room for: those on the field side carry nothing);
 * WRC_FLAG_TABLE_RANGE (of methods that know patches); WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE, _UNSUPPORTED (a
 * model without profiles, friction zones in a contact frame, or friction over temperature of a method without tractions),
 * _LOAD (the load cannot be carried at this pose).
 * @rt hard @thread contact */
WRC_API int32_t wrc_contact_wrench(wrc_contact* contact, const wrc_wheel_input* input, wrc_wrench* wrench);

/** wrc_contact_wrench() with the derivatives of its wrench: of the discrete model, strip by strip through the equations of
 * its solution, not by differences; but with WRC_FRICTION_TEMPERATURE the tractions' part by a difference of their solution
 * for each of ten numbers. For implicit integrators; it takes two to three times as long as the wrench alone, over temperature
 * four to five times. Theory manual, section 9.
 * @param contact as for wrc_contact_wrench(), of a model of WRC_NORMAL_STRIP_HALFSPACE and WRC_TANGENTIAL_STRIP_FASTSIM;
 * others are refused (WRC_ERROR_UNSUPPORTED)
 * @param input as for wrc_contact_wrench()
 * @param[out] wrench as for wrc_contact_wrench(), the same bits; NULL: not wanted
 * @param[out] sensitivities the derivatives; NULL: not wanted
 * @return as wrc_contact_wrench(). Derivatives are zero without contact; with WRC_FLAG_BEYOND_GAP they are those where the
 * overlap is 2 mm deep; zero and WRC_FLAG_MORE_PATCHES with more than 160 strips in contact.
 * @rt hard @thread contact */
WRC_API int32_t wrc_contact_wrench_derivatives(wrc_contact* contact, const wrc_wheel_input* input, wrc_wrench* wrench,
                                             wrc_wrench_derivatives* sensitivities);

/** One region of the last wrc_contact_wrench().
 * @param contact the contact
 * @param index 0 .. wrc_wrench.regions - 1, from the gauge side to the field side
 * @param[out] region the region
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_contact_wrench), _RANGE (no such region).
 * @rt hard @thread contact */
WRC_API int32_t wrc_contact_region(const wrc_contact* contact, int32_t index, wrc_region* region);

/** The equivalent double ellipse of a region of the last wrc_contact_wrench(), its strips laid flat along the rail's arc: as
 * wrc_planar_regularise() with the strips' extent, the joint where they are longest. The results stay as they are.
 * Theory manual, section 3.
 * @param contact the contact
 * @param index as for wrc_contact_region()
 * @param[out] ellipse with the arc length of its joint as y (WRC_REGION_STRIP_S) and the sum of the strips' loads as
 * normal_force
 * @return WRC_OK; WRC_FLAG_TABLE_RANGE (|psi| cut to 0.95); WRC_ERROR_NULL, _SEQUENCE (no wrc_contact_wrench), _RANGE (no
 * such region). @rt hard @thread contact */
WRC_API int32_t wrc_contact_region_ellipse(const wrc_contact* contact, int32_t index, wrc_ellipse* ellipse);

/** Wear and fatigue numbers of a region of the last wrc_contact_wrench(), as wrc_contact_damage() gives them of a patch. Forces
 * are the sums of the strips' own along x and s, the load that of the strips' loads, creepages the region's means; near
 * standstill what is made of cells is of the way the wheel rolls. The results stay as they are.
 * @param contact the contact; its work space is used
 * @param index as for wrc_contact_region()
 * @param[out] damage the numbers
 * @return WRC_OK; WRC_ERROR_NULL, _SEQUENCE (no wrc_contact_wrench), _RANGE (no such region). @rt hard @thread contact */
WRC_API int32_t wrc_contact_region_damage(wrc_contact* contact, int32_t index, wrc_damage* damage);

/** A field of a region of the last wrc_contact_wrench(), written into memory of the caller. The results stay as they are.
 * @param contact the contact; its work space is used
 * @param index as for wrc_contact_region()
 * @param field enum wrc_region_field
 * @param[out] values over strips: wrc_region.strips of them; over cells: wrc_region.cells * wrc_region.strips, cell i of
 * strip j at i * strips + j, cell 0 at the leading edge (at +x, rolling backwards at -x); the rest stays as it is
 * @param count room in values
 * @return WRC_OK; WRC_ERROR_NULL, _SEQUENCE (no wrc_contact_wrench), _RANGE (no such region), _UNSUPPORTED (no such
 * field; or one of tractions, slips and what is made of them where a method rolled whole patches), _BUFFER (too little room: nothing is written). @rt hard @thread contact */
WRC_API int32_t wrc_contact_region_field(wrc_contact* contact, int32_t index, int32_t field, double* values,
                                         uint64_t count);

/** wrc_contact_wrench() for many contacts, in order; as wrc_contact_step_batch().
 * @param contacts count of them, each once
 * @param count how many
 * @param inputs the first input; element i lies i * input_stride bytes behind it
 * @param input_stride [bytes]; 0: the same input for all
 * @param[out] wrenches the first result; element i lies i * wrench_stride bytes behind it
 * @param wrench_stride [bytes]
 * @param[out] statuses count of them; NULL: not wanted
 * @return the gravest status: the first failure, else the first flag, else WRC_OK. @rt hard
 * @thread contact, all of them */
WRC_API int32_t wrc_contact_wrench_batch(wrc_contact* const* contacts, uint32_t count, const wrc_wheel_input* inputs,
                                     uint64_t input_stride, wrc_wrench* wrenches, uint64_t wrench_stride,
                                     int32_t* statuses);

#define WRC_FLAT_WHEEL_INPUTS 28  /**< numbers wrc_contact_wrench_flat() reads */
#define WRC_FLAT_WHEEL_OUTPUTS 18 /**< numbers wrc_contact_wrench_flat() writes */

/** wrc_contact_wrench() with plain arrays, for Fortran 77 and S-functions. Numbers that stand for one of an enumeration are
 * its value.
 * @param contact as for wrc_contact_wrench()
 * @param in WRC_FLAT_WHEEL_INPUTS numbers: reference, y, z [m], roll, yaw [rad], velocity x, y, z [m/s], angular
 * velocity x, y, z in track axes [rad/s]; of the rail y, z [m], roll [rad], their rates [m/s, rad/s]; friction (0:
 * none), prescribed, vertical load [N], damping [s/m]; distance [m], angle [rad], roller_velocity [rad/s]; of the frame
 * speed [m/s], curvature, vertical curvature, twist [1/m]
 * @param[out] out WRC_FLAT_WHEEL_OUTPUTS numbers: force x, y, z [N], moment x, y, z [N m], on the rail force x, y, z,
 * moment x, y, z, then z [m], normal force [N], area [m^2], peak pressure [Pa], power [W], regions
 * @return as wrc_contact_wrench(). @rt hard @thread contact */
WRC_API int32_t wrc_contact_wrench_flat(wrc_contact* contact, const double* in, double* out);

#endif /* WRC_WHEEL_H */
