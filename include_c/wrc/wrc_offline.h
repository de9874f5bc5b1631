/**
 * @file wrc_offline.h
 * Kalker's exact half-space theory: the yardstick of the real-time methods. Not for real-time use.
 *
 * @par Stability
 * May change in a minor version, with WRC_EXPERIMENTAL_VERSION.
 *
 * Everything here allocates, may take milliseconds to minutes and is "@rt init". Frames, signs, units and conventions
 * are those of wrc.h. Fields are one double per cell of a rectangular grid, x fastest. Element (i, j) of nx * ny is at j * nx + i.
 * Its cell's centre is (x0 + i dx, y0 + j dy) in the contact frame. Particles enter a row at large i.
 *
 * Two elastic half-spaces are treated through combined constants:
 *  - 1/G = (1/G1 + 1/G2) / 2 and nu/G = (nu1/G1 + nu2/G2) / 2,
 *  - K = G/4 ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2), which couples normal and tangential problem and is 0 of equal materials.
 *
 * wrc_exact_normal() is without friction and needs no K. Rolling, steady or not, includes the tangential displacements that the given
 * pressure causes by K. power_by_balance of steady rolling counts them as slip. wrc_exact_wrench() has both couplings, except for
 * products of K and the turn of the normals.
 *
 * Memory during a call: 600 bytes per cell of the grid for the normal problem, 2.5 kB + 16 nx bytes for rolling. Measured: 7 MB at
 * 64 x 64 cells, 37 MB at 128 x 128, 225 MB at 256 x 256. At 1024 x 1024 the bound is 20 GB. A handle of non-steady rolling keeps
 * 850 bytes per cell.
 */
#ifndef WRC_OFFLINE_H
#define WRC_OFFLINE_H

#include "wrc_damage.h"
#include "wrc_planar.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Definition of adhesion. */
enum wrc_adhesion {
  WRC_ADHESION_COULOMB = 0, /**< tractions up to friction * pressure, then slip */
  WRC_ADHESION_FULL = 1     /**< no slip anywhere: linear theory; friction is unused */
};

/** Where on a cell the discrete equations hold. */
enum wrc_collocation {
  WRC_COLLOCATION_QUARTER_POINT = 0, /**< converges fastest with the grid: the choice for answers */
  WRC_COLLOCATION_REFERENCE = 1      /**< reproduces the program CONTACT on its own grid: the choice for comparisons */
};

/** Called now and then with the fraction done, 0..1, never falling. Return 0 to go on, anything else to cancel. */
typedef int32_t (*wrc_progress)(double fraction, void* user);

/** A rectangular grid in the contact frame. */
typedef struct wrc_grid {
  uint32_t nx;          /**< cells along x, 4..1024 [0] */
  uint32_t ny;          /**< cells along y, 4..1024 [0] */
  double dx;            /**< size of a cell, 1e-7..0.01 m [0] */
  double dy;            /**< see dx */
  double x0;            /**< centre of cell (0, 0), -1..1 m [0] */
  double y0;            /**< see x0 */
  double reserved[4];   /**< 0 */
} wrc_grid;

/** The normal problem: an undeformed gap and what presses the bodies together. */
typedef struct wrc_exact_normal_problem {
  uint32_t struct_size;            /**< sizeof this struct, 264 or more */
  int32_t prescribed;              /**< enum wrc_prescribed: WRC_PRESCRIBE_NORMAL_FORCE or _APPROACH [WRC_PRESCRIBE_NORMAL_FORCE] */
  int32_t max_iterations;          /**< 1..100000 [1000] */
  uint32_t reserved0;              /**< 0 */
  double normal_force;             /**< 1e-3..1e7 N with WRC_PRESCRIBE_NORMAL_FORCE; must be set [0] */
  double approach;                 /**< beyond the zero of the gap, -1..0.01 m with WRC_PRESCRIBE_APPROACH [0] */
  double tolerance;                /**< of overlap and separation, relative to the largest displacement, 1e-14..0.1
                                        [1e-6] */
  wrc_material wheel_material;         /**< elastic, of the wheel */
  wrc_material rail_material;          /**< elastic, of the rail */
  wrc_grid grid;                   /**< cells of gap and pressure */
  const double* gap;               /**< nx * ny, -1..1 m [required] */
  wrc_progress progress;           /**< NULL: none [NULL] */
  void* user;                      /**< handed to progress [NULL] */
} wrc_exact_normal_problem;

/** Solution of the normal problem. */
typedef struct wrc_exact_normal_solution {
  uint32_t struct_size; /**< sizeof this struct, 64 or more */
  int32_t iterations;   /**< of the conjugate gradients */
  uint32_t flags;       /**< bit 1 << flag for each WRC_FLAG_... met */
  uint32_t reserved0;   /**< 0 */
  double approach;      /**< beyond the zero of the gap [m] */
  double normal_force;  /**< [N] */
  double peak_pressure; /**< [Pa] */
  double area;          /**< of the cells under pressure [m^2] */
  double residual;      /**< of the convergence test [-] */
  double* pressure;     /**< the caller's nx * ny [Pa]; NULL: not wanted; set before the call */
} wrc_exact_normal_solution;

/** Steady rolling under a given normal pressure. */
typedef struct wrc_exact_rolling_problem {
  uint32_t struct_size;           /**< sizeof this struct, 344 or more */
  int32_t adhesion;               /**< enum wrc_adhesion [WRC_ADHESION_COULOMB] */
  int32_t collocation;            /**< enum wrc_collocation [WRC_COLLOCATION_QUARTER_POINT] */
  int32_t max_iterations;         /**< of Newton's method, 1..1000 [60] */
  double tolerance;               /**< of the traction law, 1e-12..0.1 [1e-4] */
  wrc_material wheel_material;        /**< elastic, of the wheel */
  wrc_material rail_material;         /**< elastic, of the rail */
  wrc_grid grid;                  /**< cells of pressure, friction and tractions */
  const double* pressure;         /**< nx * ny, -1e11..1e11 Pa; cells above zero are the contact, all others are not
                                       [required] */
  const double* friction;         /**< nx * ny, 1e-4..2; NULL: `coefficient` everywhere [NULL] */
  double coefficient;             /**< Coulomb, 1e-4..2 with WRC_ADHESION_COULOMB and `friction` NULL [0.3] */
  wrc_creepage creepage;          /**< about the origin of the contact frame */
  wrc_progress progress;          /**< called between grids and iterations; NULL: none [NULL] */
  void* user;                     /**< handed to progress [NULL] */
  double layer_thickness;         /**< of an elasto-plastic layer, as in wrc_friction, 0..0.01 m; steady rolling alone [0] */
  double layer_modulus;           /**< of that layer in shear, 0 or 1e3..1e12 Pa; goes with a thickness [0] */
  double layer_yield;             /**< traction at which fresh layer yields, 0 or 1e3..1e11 Pa; WRC_ADHESION_COULOMB alone [0] */
  double layer_hardening;         /**< rise of that traction over the length of plastic flow, -1e13..1e14 Pa/m [0] */
} wrc_exact_rolling_problem;

/** Solution of steady rolling: forces and tractions on the wheel. */
typedef struct wrc_exact_rolling_solution {
  uint32_t struct_size;       /**< sizeof this struct, 104 or more */
  int32_t iterations;         /**< of Newton's method on the given grid */
  uint32_t flags;             /**< bit 1 << flag for each WRC_FLAG_... met */
  uint32_t reserved0;         /**< 0 */
  double fx;                  /**< [N] */
  double fy;                  /**< see fx */
  double mz;                  /**< about the origin of the contact frame [N m] */
  double power;               /**< sum of slip times traction over the cells, times the speed [W] */
  double power_by_balance;    /**< -(Fx nu_x + Fy nu_y + Mz phi) V: the limit of `power` on fine grids [W] */
  double adhesion_fraction;   /**< share of the contact's area that sticks [-] */
  double residual;            /**< of the convergence test [-] */
  double* traction_x;         /**< the caller's nx * ny [Pa]; NULL: not wanted; so are those below */
  double* traction_y;         /**< [Pa] */
  double* slip_x;             /**< sliding velocity / rolling speed [-] */
  double* slip_y;             /**< [-] */
} wrc_exact_rolling_solution;

/** Pressure and tractions on one of the bodies, constant on each cell of a grid. */
typedef struct wrc_exact_loads {
  uint32_t struct_size;     /**< sizeof this struct, 112 or more */
  int32_t body;             /**< enum wrc_body: in which the stresses are wanted [WRC_BODY_RAIL] */
  double poisson;           /**< nu of that body, 0..0.5 [0.28] */
  wrc_grid grid;            /**< cells of pressure and tractions */
  const double* pressure;   /**< nx * ny, -1e11..1e11 Pa [required] */
  const double* traction_x; /**< nx * ny, on the wheel as solutions have it, whichever the body, -1e11..1e11 Pa; NULL:
                                 none [NULL] */
  const double* traction_y; /**< nx * ny, the same along y, -1e11..1e11 Pa; NULL: none [NULL] */
} wrc_exact_loads;

/** Half-space coefficients on a curved surface. */
enum wrc_surface_influence {
  WRC_INFLUENCE_TURNED = 0, /**< turned between the normals of the two cells: the choice for answers */
  WRC_INFLUENCE_PLAIN = 1   /**< a plane's over arc length, the plain conformal setting of CONTACT: for comparisons */
};

/** How finely a wheel on a rail is solved exactly. */
typedef struct wrc_exact_wrench_options {
  uint32_t struct_size;  /**< sizeof this struct, 48 or more */
  int32_t collocation;   /**< enum wrc_collocation [WRC_COLLOCATION_QUARTER_POINT] */
  int32_t influence;     /**< enum wrc_surface_influence [WRC_INFLUENCE_TURNED] */
  uint32_t reserved0;    /**< 0 */
  double cell_x;         /**< length of a cell along x, 2e-5..2e-3 m [2e-4] */
  double cell_s;         /**< the same along the rail's arc length, 2e-5..2e-3 m [2e-4] */
  wrc_progress progress; /**< called while heights are tried and both problems solved in turn; NULL: none [NULL] */
  void* user;            /**< handed to progress [NULL] */
} wrc_exact_wrench_options;

/** How finely a contact is checked. */
typedef struct wrc_exact_check_options {
  uint32_t struct_size;  /**< sizeof this struct, 32 or more */
  uint32_t nx;           /**< cells along x, 8..512 [64] */
  uint32_t ny;           /**< cells along y, 8..512 [64] */
  uint32_t reserved0;    /**< 0 */
  wrc_progress progress; /**< NULL: none [NULL] */
  void* user;            /**< handed to progress [NULL] */
} wrc_exact_check_options;

/** A real-time result against the exact one. */
typedef struct wrc_exact_check_result {
  uint32_t struct_size;     /**< sizeof this struct, 64 or more */
  uint32_t flags;           /**< bit 1 << flag for each WRC_FLAG_... met */
  double fx;                /**< exact, on the contact's own pressure and creepages [N] */
  double fy;                /**< see fx */
  double mz;                /**< the same [N m] */
  double power;             /**< exact, by the energy balance [W] */
  double adhesion_fraction; /**< exact [-] */
  double force_error;       /**< |F - F_exact| / (friction * N) [-] */
  double power_error;       /**< P / P_exact - 1 [-]; 0 when nothing is dissipated */
} wrc_exact_check_result;

/** A parameter of friction or of a layer that wrc_fit_creep_curve() can find: places in the arrays of wrc_creep_fit. */
enum wrc_creep_parameter {
  WRC_CREEP_COEFFICIENT = 0,        /**< friction.coefficient [-] */
  WRC_CREEP_KINETIC_RATIO = 1,      /**< friction.kinetic_ratio, of a speed law [-] */
  WRC_CREEP_FALL_RATE = 2,          /**< friction.fall_rate, of the exponential law [s/m] */
  WRC_CREEP_HALF_SPEED = 3,         /**< friction.half_speed, of the hyperbolic law [m/s] */
  WRC_CREEP_SLOPE_REDUCTION = 4,    /**< friction.slope_reduction [-] */
  WRC_CREEP_ADHESION_REDUCTION = 5, /**< friction.adhesion_reduction, of WRC_TANGENTIAL_POLACH [-] */
  WRC_CREEP_SLIP_REDUCTION = 6,     /**< friction.slip_reduction, of the same [-] */
  WRC_CREEP_LAYER_THICKNESS = 7,    /**< friction.layer_thickness, at a given layer_modulus [m] */
  WRC_CREEP_LAYER_YIELD = 8,        /**< friction.layer_yield [Pa] */
  WRC_CREEP_LAYER_HARDENING = 9     /**< friction.layer_hardening [Pa/m] */
};

#define WRC_CREEP_PARAMETERS 10 /**< places of the arrays of wrc_creep_fit that this version fills */

/** Scatter of measured adhesion. */
enum wrc_scatter {
  WRC_SCATTER_RELATIVE = 0, /**< in proportion to the adhesion, and at least to a hundredth of the largest */
  WRC_SCATTER_ABSOLUTE = 1  /**< by the same amount at every point */
};

/** A measured curve of adhesion over slip, and the law to be fitted to it. */
typedef struct wrc_creep_curve {
  uint32_t struct_size;   /**< sizeof this struct, 376 or more */
  uint32_t count;         /**< number of points, at least three more than parameters, 4..100000 [0] */
  const double* slip;     /**< `count` of them: amount of the longitudinal creepage, 1e-7..1 [required] */
  const double* adhesion; /**< `count` of them: longitudinal force over load, against the slip positive, -0.2..2 [required] */
  const double* speed;    /**< `count` of them: rolling speed, 1e-3..200 m/s [required] */
  const double* load;     /**< `count` of them: load of the wheel, 1..1e7 N [required] */
  wrc_ellipse ellipse;    /**< the patch under ellipse.normal_force. Its axes grow with the cube root of the load (Hertz) */
  wrc_friction friction;  /**< the law, without zones and temperatures. The fit begins with its values and keeps those of
                               other parameters */
  uint32_t parameters;    /**< bit 1 << parameter for each enum wrc_creep_parameter to be found, 1..1023 [1] */
  int32_t scatter;        /**< enum wrc_scatter [WRC_SCATTER_RELATIVE] */
  int32_t max_iterations; /**< cap on the iterations of the fit, 1..1000 [100] */
  uint32_t reserved0;     /**< 0 */
  wrc_progress progress;  /**< called between iterations; NULL: none [NULL] */
  void* user;             /**< handed to progress [NULL] */
} wrc_creep_curve;

/** The law that fits best, and how far the curve determines it. Arrays are over enum wrc_creep_parameter, with 0 for parameters that
 * were not to be found. */
typedef struct wrc_creep_fit {
  uint32_t struct_size;   /**< sizeof this struct, 2832 or more */
  uint32_t flags;         /**< bit 1 << flag for each WRC_FLAG_... met */
  int32_t iterations;     /**< of the fit */
  uint32_t undetermined;  /**< bits of parameters that the curve does not determine: any value fits, or only a combination of
                               several is determined. Their deviation is infinite, their interval the whole range */
  uint32_t at_limit;      /**< bits of parameters that ended at the end of their range */
  uint32_t reserved0;     /**< 0 */
  double scatter;         /**< standard deviation of the measured points from the law: relative, or of the adhesion [-] */
  wrc_friction friction;  /**< the law that fits best */
  double value[16];       /**< value that fits best, in the unit of the parameter */
  double deviation[16];   /**< standard deviation of that value, in the same unit */
  double low[16];         /**< lower end of the interval that holds the true value with 95 % */
  double high[16];        /**< its upper end */
  double covariance[16][16]; /**< of the values; 0 of undetermined ones */
} wrc_creep_fit;

/** @name Defaults
 * As in wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_exact_normal_problem_init(wrc_exact_normal_problem* problem); /**< Defaults: problem. */
WRC_API int32_t wrc_exact_rolling_problem_init(wrc_exact_rolling_problem* problem); /**< Defaults: problem. */
WRC_API int32_t wrc_exact_loads_init(wrc_exact_loads* loads); /**< Defaults: loads. */
WRC_API int32_t wrc_exact_check_options_init(wrc_exact_check_options* options); /**< Defaults: options. */
WRC_API int32_t wrc_exact_wrench_options_init(wrc_exact_wrench_options* options); /**< Defaults: options. */
WRC_API int32_t wrc_creep_curve_init(wrc_creep_curve* curve); /**< Defaults: curve. */
/** @cond */
WRC_DEFAULT_SIZED(wrc_exact_normal_problem)
WRC_DEFAULT_SIZED(wrc_exact_rolling_problem)
WRC_DEFAULT_SIZED(wrc_exact_loads)
WRC_DEFAULT_SIZED(wrc_exact_check_options)
WRC_DEFAULT_SIZED(wrc_exact_wrench_options)
WRC_DEFAULT_SIZED(wrc_creep_curve)
/** @endcond */
/** @} */

/** Samples the gap in a contact at the cell centres of a grid, its minimum at zero. Of wrc_planar_geometry: the
 * separation of the true surfaces, wheel (a surface of revolution, with its yaw and roll) and rail, along the contact
 * normal. The rows the real-time methods read are its expansion along x; beside steps of the profile's curvature they
 * leave it under yaw (theory manual, section 7). Of the caller: the rows handed over, each a parabola. Outside the
 * rows' range of y the gap continues with the last row's slope.
 * @param contact with a gap
 * @param grid where to sample
 * @param[out] gap nx * ny [m]; zero on failure, once the grid is known to be one
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE, _MEMORY, _SEQUENCE (no gap in the contact).
 * @rt init @thread contact */
WRC_API int32_t wrc_exact_gap(wrc_contact* contact, const wrc_grid* grid, double* gap);

/** Pressure and contact area of two half-spaces pressed together. Conjugate gradients with bounds (Polonsky and Keer
 * 1999) and FFT products. Kalker 1990; Johnson 1985.
 * @param problem what to solve
 * @param[in,out] solution results; its `pressure` says where the field goes
 * @param[out] text what went wrong, as wrc_contact_last_error writes it; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_NO_CONTACT, _ITERATION_CAP, _PATCH_AT_EDGE; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE,
 * _NOT_FINITE, _UNSUPPORTED, _MEMORY, _CANCELLED. @rt init @thread free */
WRC_API int32_t wrc_exact_normal(const wrc_exact_normal_problem* problem, wrc_exact_normal_solution* solution,
                                 char* text, uint64_t size);

/** Tractions of steady rolling under a given pressure. Kalker 1990; Newton's method with a moving adhesion area, GMRES
 * and FFT products. Parameters and statuses as wrc_exact_normal. @param problem what to solve
 * @param[in,out] solution results @param[out] text sentence; NULL: not wanted @param size bytes of text
 * @return as wrc_exact_normal(), but for _PATCH_AT_EDGE; without a cell under pressure WRC_FLAG_NO_CONTACT.
 * @rt init @thread free */
WRC_API int32_t wrc_exact_rolling(const wrc_exact_rolling_problem* problem, wrc_exact_rolling_solution* solution,
                                  char* text, uint64_t size);

/** Stresses at given points of a body under loads on its surface, by closed forms for loads constant on each cell
 * (Boussinesq, Love 1929, Cerruti; Johnson 1985, 3.2), theory manual, section 6. Loads are those of any solution, of
 * wrc_exact_rolling() for one.
 * @param loads what acts
 * @param points count times x, y of the contact frame and the depth below the body's surface, -1..1, -1..1, 0..1 m;
 * at depth 0 not on the border between cells, where the stress beside a step of a traction is infinite
 * @param count of points, 1..1e6
 * @param[out] stresses count times xx, yy, zz, xy, yz, zx [Pa], tension positive, z along the body's own depth; zero on
 * failure
 * @param[out] text what went wrong, as wrc_contact_last_error writes it; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _NOT_FINITE, _MEMORY. @rt init @thread free */
WRC_API int32_t wrc_exact_stress(const wrc_exact_loads* loads, const double* points, uint32_t count, double* stresses,
                                 char* text, uint64_t size);

/** Largest stresses in a body under loads on its surface, for all depths and for those of the caller. At every depth they are the
 * largest of wrc_exact_stress() at the centres of all cells and of some more around the grid, by FFT. Depths looked at: 0; eleven to
 * 1.5 times the smaller half extent of the loads; golden sections around the largest of each, to a thousandth of that extent. Takes
 * about a second for 80 x 60 cells. At the surface the stress beside the end of a traction that ends in a step has no bound as cells
 * shrink. Under tractions that go to zero it has one (theory manual, section 6).
 * @param loads what acts
 * @param depths count of them, 0..1 m; NULL with count 0
 * @param count of depths, 0..1000
 * @param[out] levels the largest at each of these depths, count of them; NULL: not wanted
 * @param[out] stresses the largest of all; NULL: not wanted
 * @param progress NULL: none @param user handed to progress
 * @param[out] text as wrc_exact_stress(); NULL: not wanted @param size bytes of text
 * @return WRC_OK; WRC_FLAG_NO_CONTACT (no loads); WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _NOT_FINITE, _MEMORY,
 * _CANCELLED. @rt init @thread free */
WRC_API int32_t wrc_exact_largest_stresses(const wrc_exact_loads* loads, const double* depths, uint32_t count,
                                           wrc_stress_peaks* levels, wrc_stresses* stresses, wrc_progress progress,
                                           void* user, char* text, uint64_t size);

/** @name Non-steady rolling
 *
 * In each step the bodies roll on by r = 1 cells, back by one (r = -1), or rest (r = 0). Pressure, friction and creepages are those
 * of the step. Displacements of before stay with them: s(x) = w + (u(x) - u_before(x + r dx)) / dx (Kalker 1990; CONTACT's T = 2 with
 * dq = dx, at rest its T = 1). Creepages times grid.dx are the rigid displacement of the wheel over the rail in the step, rolling
 * either way or at rest. Conditions that stay the same end in wrc_exact_rolling(), or in its mirror image. Loads and shifts at rest
 * are those of Cattaneo and Mindlin.
 * @{ */

/** Two bodies that roll, with their history. One thread at a time. */
typedef struct wrc_exact_transient wrc_exact_transient;

/** Makes two bodies that have not rolled yet, without tractions.
 * @param grid cells of every step
 * @param wheel elastic, of the wheel; NULL: the defaults
 * @param rail the same of the rail; NULL: the defaults
 * @param[out] transient the caller's, for wrc_exact_transient_destroy(); NULL on failure
 * @param[out] text what went wrong; NULL: not wanted @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE, _MEMORY. @rt init @thread free */
WRC_API int32_t wrc_exact_transient_create(const wrc_grid* grid, const wrc_material* wheel, const wrc_material* rail,
                                           wrc_exact_transient** transient, char* text, uint64_t size);

/** One step. A failed or cancelled step leaves the bodies where they were; one without a cell under pressure
 * leaves them without tractions.
 * @param transient the bodies
 * @param problem pressure and friction at the end of the step, creepages of its middle, grid and materials of the handle. The sign of
 * creepage.speed is that of r: 0 is a step at rest
 * @param[in,out] solution at the end of the step; power is what slip dissipates, power_by_balance the work of the
 * creepages, which the elastic energy of the bodies takes its part of; both are 0 at rest, where no speed scales them
 * @param[out] text what went wrong; NULL: not wanted @param size bytes of text
 * @return as wrc_exact_rolling(); _RANGE: grid or materials are not the handle's. @rt init @thread contact */
WRC_API int32_t wrc_exact_transient_step(wrc_exact_transient* transient, const wrc_exact_rolling_problem* problem,
                                         wrc_exact_rolling_solution* solution, char* text, uint64_t size);

/** Frees what wrc_exact_transient_create() made; NULL is ignored. @param transient the bodies
 * @rt init @thread contact */
WRC_API void wrc_exact_transient_destroy(wrc_exact_transient* transient);
/** @} */

/** Solves the tangential problem of the contact's last stages exactly, and reports the errors of the real-time method. Pressure is that
 * of the contact's strips, on nx x ny cells over its patches. Creepages, friction and friction.slope_reduction are its own. The
 * contact is not changed.
 * @param contact after wrc_planar_tangential or wrc_planar_step
 * @param options NULL: the defaults
 * @param[out] result exact forces and the errors
 * @return WRC_OK; WRC_FLAG_NO_CONTACT, _ITERATION_CAP; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _SEQUENCE, _UNSUPPORTED
 * (both ways of rolling blended: creepage.reverse_share is not 0), _MEMORY, _CANCELLED. @rt init @thread contact */
WRC_API int32_t wrc_exact_check(wrc_contact* contact, const wrc_exact_check_options* options,
                                wrc_exact_check_result* result);

/** Exact counterpart of wrc_contact_wrench(): normal contact and steady rolling over cells on the rail's curved surface. Every cell has
 * its gap along its own normal and the sliding of its own surface points. Half-space coefficients are those over arc length between
 * frames turned against each other, so that pressure and tractions act on one another.
 *  - Friction zones and falling friction are each row of cells'. Both ways of rolling near standstill are as in wrc_contact_wrench().
 *  - Damping goes by the speed at which a row's surfaces near each other at its middle.
 *  - friction.slope_reduction divides what tractions move the surfaces along each other: theory manual, sections 5, 7 and 9.
 *  - Takes from a tenth of a second to minutes, growing with the second to fourth power of 1 / cell.
 *  - The contact keeps its last wrc_contact_wrench().
 *
 * On a rail that changes along the track every cell has its gap to the rail as it is there, and its sliding along it. Normals turn with
 * the section, and forces lean along the track, row by row as they do where the wheel is nearest. Surfaces (a check rail, a blade)
 * are solved each alone, with its own rolling speed, and added up. A wheel that is not round has its radius at every cell. Its
 * hollows are bridged as by a rail that is level along the track. A row of cells looks for the wheel up to 120 mm ahead and behind
 * and starts where that is nearest; it has cells up to 100 mm from there, on the level and on a ramp at once.
 * @param contact of a model with profiles and WRC_NORMAL_STRIP_HALFSPACE, which gives the bodies alone
 * @param input as for wrc_contact_wrench(); without WRC_TEMPERATURE_LAW_LINEAR: there are no temperatures
 * @param options NULL: the defaults
 * @param[out] wrench the result; `iterations` are heights and turns of normal and tangential problem tried; regions are
 * counted, wrc_contact_region() does not have them
 * @return WRC_OK; WRC_FLAG_NO_CONTACT, _ITERATION_CAP, _PATCH_AT_EDGE (the contact reaches the end of a profile or surface),
 * _CREEPAGES_LIMITED, _BEYOND_SECTIONS; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE (also: more than a million cells), _UNSUPPORTED,
 * _LOAD, _MEMORY, _CANCELLED.
 * @rt init @thread contact */
WRC_API int32_t wrc_exact_wrench(wrc_contact* contact, const wrc_wheel_input* input,
                                const wrc_exact_wrench_options* options, wrc_wrench* wrench);

/** Fits parameters of friction and of a layer to a measured creep curve, by the tangential method of a contact. Weighted least squares
 * by Levenberg and Marquardt, within the ranges of the members. Positive parameters and their intervals are found by the logarithm.
 * The scatter of the points is found with the parameters, and gives their spread. Theory manual, section 5.
 * @param contact of any model; it is not changed
 * @param curve points and law; only read during the call
 * @param[out] fit the law and its spread
 * @param[out] adhesion curve->count numbers: adhesion of the fitted law at the points [-]; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_ITERATION_CAP, _TABLE_RANGE; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE, _UNSUPPORTED (a parameter
 * that neither law nor method reads; zones, temperatures; config.planar.non_steady), _MEMORY, _CANCELLED. @rt init @thread contact */
WRC_API int32_t wrc_fit_creep_curve(wrc_contact* contact, const wrc_creep_curve* curve, wrc_creep_fit* fit, double* adhesion);

#ifdef __cplusplus
}
#endif

#endif /* WRC_OFFLINE_H */
