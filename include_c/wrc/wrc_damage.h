/** @file wrc_damage.h
 * What contact does to the bodies: stresses below the surface, temperatures, damage along the line. Part of wrc.h, which
 * includes it; the conventions there (frames, signs, structs, statuses, classes) hold here.
 *
 * @par Damage along the line
 * What a journey does to profiles and rails is collected in bins of the caller over the arc length of a profile, of a rail
 * also over the distance along the track. Every strip of a contact gives each bin its share by overlap, so that sums are
 * continuous in the pose and the bins' sums are those of the step. Sums are whole numbers of 128 bits: any number of
 * contacts may add to one set of bins, or to sets that are merged afterwards, in any order, with the same bits.
 * @code
 *   wrc_damage_bin wheel_bin[281] = {0};                                // 280 and what lies beside them
 *   wrc_damage_bins wheel = wrc_damage_bins_default();
 *   wheel.count = 280;  wheel.first = -0.070;  wheel.width = 0.5e-3;    // along the profile, 0 at its origin
 *   wheel.bin = wheel_bin;
 *   wrc_accumulation step = wrc_accumulation_default();
 *   // in every step, from here on without allocation:
 *   wrc_contact_wrench(contact, &input, &wrench);
 *   step.duration = dt;  step.distance = x;
 *   wrc_contact_accumulate(contact, &step, &wheel, NULL, NULL);
 *   // at the end:
 *   wrc_damage_values(&wheel, WRC_DAMAGE_WEAR_ARCHARD, values);         // m^3 in every bin
 * @endcode
 */
#if !defined(WRC_H) && !defined(DOXYGEN)
#include "wrc.h" /* which includes this file in its place */
#elif !defined(WRC_DAMAGE_H)
#define WRC_DAMAGE_H

/** A stress that is the largest of its kind, and where in the body it is: contact frame, but for the depth. */
typedef struct wrc_stress_peak {
  double stress; /**< [Pa] */
  double x;      /**< contact frame [m] */
  double y;      /**< see x */
  double depth;  /**< below the body's surface [m] */
} wrc_stress_peak;

/** Largest stresses in a body, each at its own place. */
typedef struct wrc_stress_peaks {
  wrc_stress_peak von_mises; /**< sqrt(3 J2) */
  wrc_stress_peak shear;     /**< (s1 - s3) / 2: half of Tresca's stress */
  wrc_stress_peak tension;   /**< s1, the most tensile principal stress; below 0 where all is pressed together */
} wrc_stress_peaks;

/** Stresses in one of the bodies as a whole. */
typedef struct wrc_stresses {
  uint32_t struct_size;      /**< sizeof this struct, 296 or more */
  int32_t body;              /**< enum wrc_body: which */
  wrc_stress_peaks largest;  /**< of the two that follow */
  wrc_stress_peaks surface;  /**< at the surface */
  wrc_stress_peaks below;    /**< beneath it */
} wrc_stresses;

/** Temperatures in the contact. Wheel and rail have the same where they touch. */
typedef struct wrc_temperature {
  uint32_t struct_size; /**< sizeof this struct, 72 or more */
  uint32_t reserved;    /**< 0 */
  double at_entry;      /**< of both surfaces as soon as they touch, between those of the bodies [degC] */
  double rise;          /**< the largest by friction over that, of all cells [K] */
  double x;             /**< where: contact frame, the middle of the cell [m] */
  double y;             /**< see x */
  double largest;       /**< at_entry + rise [degC] */
  double mean_rise;     /**< over the contact's area [K] */
  double wheel_heat;    /**< that flows into the wheel, of friction and of the bodies' touching [W] */
  double rail_heat;     /**< the same of the rail; both together are the frictional power [W] */
} wrc_temperature;

/** What bins collect. Sums: a bin's volume over its width (and over a wheel's circumference, or a rail's length) is a depth;
 * a fatigue sum over its width and over the length rolled (or a rail's length) is the index of each passage, added up. Each
 * range is that of a sum; single contributions may be half of it. */
enum wrc_damage_quantity {
  WRC_DAMAGE_WORK = 0,             /**< frictional work [J], +-8e12; over the distance it is T-gamma */
  WRC_DAMAGE_WEAR_T_GAMMA = 1,     /**< volume worn by the T-gamma law [m^3], +-8e6; spread like the work */
  WRC_DAMAGE_WEAR_SHEFFIELD = 2,   /**< the same by Sheffield's law, of each strip's T-gamma over its area */
  WRC_DAMAGE_WEAR_ARCHARD = 3,     /**< the same by Archard's, of each strip's work, peak pressure and sliding velocity */
  WRC_DAMAGE_WEAR_POWER = 4,       /**< the same by the power law, of each strip's power over its area */
  WRC_DAMAGE_WHOLE_LIFE = 5,       /**< Whole Life Rail Model: damage function of the patch's T-gamma, times distance and
                                        width [m^2], +-8e6; < 0 where wear removes cracks */
  WRC_DAMAGE_SURFACE_FATIGUE = 6,  /**< positive part of the strip's surface fatigue index |F| / N - k / p0, times distance
                                        and width [m^2], +-8e6 */
  WRC_DAMAGE_TIME = 7,             /**< contact time times width [s m], +-8e6 */
  WRC_DAMAGE_LARGEST_PRESSURE = 8, /**< not a sum: largest pressure [Pa] */
  WRC_DAMAGE_LARGEST_TRACTION = 9  /**< not a sum: largest traction [Pa]: |F| / N of a strip times its peak pressure */
};

#define WRC_DAMAGE_SUMS 8 /**< quantities that are sums */

/** Which results of a contact are added. */
enum wrc_damage_source {
  WRC_DAMAGE_OF_WRENCH = 0, /**< the last wrc_contact_wrench() */
  WRC_DAMAGE_OF_STAGES = 1  /**< the last wrc_contact_damage() or wrc_planar_step(), of a pose */
};

/** One bin: all zero, nothing was added. Bits are the same whatever the order of additions and merges. */
typedef struct wrc_damage_bin {
  uint64_t sum[8][2];      /**< by enum wrc_damage_quantity: low and high half of a whole number of 128 bits, two's
                                complement; wrc_damage_values() makes numbers of it */
  double largest_pressure; /**< [Pa] */
  double largest_traction; /**< [Pa] */
  uint64_t overflow;       /**< bit i: a contribution to sum i, or the sum, passed its range; what it holds is worthless */
} wrc_damage_bin;

/** Bins over the arc length of a profile, 0 at its origin, flange or gauge side negative; of a rail also in rows along the
 * track. */
typedef struct wrc_damage_bins {
  uint32_t struct_size; /**< sizeof this struct, 56 or more */
  uint32_t count;       /**< bins of a row, 1..1000000 [0]. Too small: say how many bins there are */
  double first;         /**< arc length at which the first begins, -1..1 m [0]. Did you pass mm? */
  double width;         /**< of a bin, 1e-5..1 m [1e-3]. Did you pass mm? */
  uint32_t rows;        /**< along the track, 1..1000000; rows * count 100000000 at most [1] */
  uint32_t reserved;    /**< 0 */
  double row_first;     /**< distance at which the first row begins, -1e9..1e9 m [0] */
  double row_length;    /**< of a row, 0 or 1e-3..1e9 m; 0: one row takes all, whatever the distance [0]. Negative: rows
                             follow the track */
  wrc_damage_bin* bin;  /**< rows * count + 1 of the caller, row by row; the last has what lies beside all others. Zeroed
                             before the first use, copied and saved as bytes */
} wrc_damage_bins;

/** Damage of rolling contact fatigue by T-gamma: the Whole Life Rail Model. Zero up to `start`, rising straight to `peak` at
 * `peak_at`, falling straight through zero at `end` and on below it, where wear wins. For R220 and R260 steel; Burstow, RSSB
 * T115 (2004); remembered, unconfirmed. The direction of the creep force, by which the model tells cracks that open, is
 * left to the caller. */
typedef struct wrc_fatigue_laws {
  uint32_t struct_size;      /**< sizeof this struct, 40 or more */
  uint32_t reserved;         /**< 0 */
  double whole_life_start;   /**< T-gamma from which cracks start, 0..1e6 N [15] */
  double whole_life_peak_at; /**< T-gamma of the largest damage, 1e-3..1e6 N, above whole_life_start [65] */
  double whole_life_end;     /**< T-gamma at which wear takes as much as cracks grow, 1e-3..1e6 N, above whole_life_peak_at
                                  [175] */
  double whole_life_peak;    /**< damage of a passage at whole_life_peak_at, 0..1; 1 is a crack [1e-5]. Did you pass
                                  millionths? */
} wrc_fatigue_laws;

/** What wrc_contact_accumulate() adds. */
typedef struct wrc_accumulation {
  uint32_t struct_size;            /**< sizeof this struct, 40 or more */
  int32_t source;                  /**< enum wrc_damage_source [WRC_DAMAGE_OF_WRENCH] */
  double duration;                 /**< for which the results hold, 0..1e6 s [0]. Negative: damage is not undone. Too large:
                                        did you pass a distance? */
  double distance;                 /**< along the track where that begins, -1e9..1e9 m; read where a row of bins has a
                                        length [0] */
  const wrc_wear_laws* wear;       /**< NULL: the published ones [NULL] */
  const wrc_fatigue_laws* fatigue; /**< NULL: the published ones [NULL] */
} wrc_accumulation;

/** What one wrc_contact_accumulate() added to each of its sets of bins. */
typedef struct wrc_damage_totals {
  double sum[8];           /**< by enum wrc_damage_quantity, units there */
  double largest_pressure; /**< [Pa] */
  double largest_traction; /**< [Pa] */
} wrc_damage_totals;

/** @name Defaults
 * As those of wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_stresses_init(wrc_stresses* stresses); /**< Defaults: stresses. */
WRC_API int32_t wrc_temperature_init(wrc_temperature* temperature); /**< Defaults: temperatures in the contact. */
WRC_API int32_t wrc_damage_bins_init(wrc_damage_bins* bins); /**< Defaults: bins. */
WRC_API int32_t wrc_fatigue_laws_init(wrc_fatigue_laws* laws); /**< Defaults: fatigue laws. */
WRC_API int32_t wrc_accumulation_init(wrc_accumulation* accumulation); /**< Defaults: accumulation. */
/** @cond */
WRC_DEFAULT_SIZED(wrc_stresses)
WRC_DEFAULT_SIZED(wrc_temperature)
WRC_DEFAULT_SIZED(wrc_damage_bins)
WRC_DEFAULT_SIZED(wrc_fatigue_laws)
WRC_DEFAULT_SIZED(wrc_accumulation)
/** @endcond */
/** @} */

/** Temperatures in the contact from the frictional power of the last wrc_planar_tangential or wrc_planar_step, and the field
 * TEMPERATURE_RISE: flash temperatures of points that pass through the contact (Ertz and Knothe, Wear 253 (2002) 498),
 *     T(s) = (beta_w T_w + beta_r T_r) / (beta_w + beta_r) + 1 / ((beta_w + beta_r) sqrt(pi V)) Int_0^s q / sqrt(s - s') ds',
 * s from the leading edge along each strip, q the power density, beta = sqrt(conductivity density specific_heat) of
 * config.wheel_heat and config.rail_heat. Heat flows into the depth alone, which holds from some 0.1 m/s on (Peclet
 * number V a density specific_heat / (2 conductivity) > 10); below, temperatures are too high and go to zero with the speed.
 * Near standstill (creepage.reverse_share) it is of the way of creepage.speed. Cost grows with strips * cells^2. May be
 * called again with other bulk temperatures. Theory manual, section 6.
 * @param contact the contact
 * @param bulk temperatures of the bodies; NULL: the defaults
 * @param[out] temperature the numbers; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_planar_tangential before),
 * _NOT_FINITE, _RANGE, _UNSUPPORTED (a method that gives forces alone: there is no power over the patch). @rt hard @thread
 * contact */
WRC_API int32_t wrc_contact_temperature(wrc_contact* contact, const wrc_bulk_temperatures* bulk,
                                        wrc_temperature* temperature);

/** wrc_contact_temperature() of a region of the last wrc_contact_wrench(), and of its field WRC_REGION_TEMPERATURE_RISE, which is
 * there without this call. The results stay as they are.
 * @param contact the contact; its work space is used
 * @param index as for wrc_contact_region()
 * @param bulk temperatures of the bodies; NULL: the defaults
 * @param[out] temperature the numbers: x as wrc_region.point[0], y the arc length (WRC_REGION_STRIP_S); heat is that of
 * the cells' power density
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_contact_wrench), _RANGE (no such region, or bulk), _NOT_FINITE,
 * _UNSUPPORTED (a method that rolled whole patches). @rt hard @thread contact */
WRC_API int32_t wrc_contact_region_temperature(wrc_contact* contact, int32_t index, const wrc_bulk_temperatures* bulk,
                                               wrc_temperature* temperature);

/** Largest stresses in one of the bodies under pressure and tractions of the last wrc_planar_tangential or
 * wrc_planar_step: at the surface, at depths of the caller's, and around the largest of these (golden sections between
 * its neighbours: depths a fifth of the patch's smaller half extent apart are close enough). Elastic half-space; strips
 * are joined to at most 36 lanes of 48 cells, near cells are rectangles, others forces at points (Boussinesq, Love, Cerruti;
 * Johnson 1985, 3.2). Bounded: at most 312 places a depth, the surface included, and 24 more, some 3 us each with AVX-512, 12
 * with SSE2, less deep below: 0.6 ms for the surface, 2.4 ms with eight depths; of patches six times as wide as long and
 * more two to four times that. wrc_exact_largest_stresses()
 * (wrc_offline.h) is the exact counterpart. Theory manual, section 6.
 * @param contact the contact
 * @param body enum wrc_body: the one whose stresses are wanted
 * @param depths count of them, increasing, 0..0.1 m
 * @param count of depths, 1..64
 * @param[out] levels the largest at each of these depths, count of them; NULL: not wanted; zero on failure
 * @param[out] stresses at the surface, below it and of both; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_planar_tangential before),
 * _NOT_FINITE, _RANGE, _UNSUPPORTED (no such body; a method that gives forces alone). @rt hard @thread contact */
WRC_API int32_t wrc_contact_stresses(wrc_contact* contact, int32_t body, const double* depths, uint32_t count,
                                     wrc_stress_peaks* levels, wrc_stresses* stresses);

/** The rise of wrc_contact_temperature() along one strip of the caller's power densities: of a solution of wrc_exact_rolling()
 * for one, row by row.
 * @param count cells, 1..512
 * @param cell their length, 1e-7..0.01 m
 * @param power_density count of them from the leading edge on, at the cells' middles, -1e18..1e18 W/m^2; below 0
 * counts as 0
 * @param speed rolling speed, 1e-6..200 m/s
 * @param wheel how the wheel takes up heat; NULL: the defaults
 * @param rail the same of the rail
 * @param[out] rise count of them [K]; may be power_density
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE. @rt hard @thread free */
WRC_API int32_t wrc_flash_temperature(uint32_t count, double cell, const double* power_density, double speed,
                                      const wrc_heat_properties* wheel, const wrc_heat_properties* rail, double* rise);

/** Adds what the last results of a contact do in a duration to bins of its wheel and of its rail. Work grows with the strips
 * in contact and the bins they cover. Theory manual, "Damage along the line".
 * @param contact with the results; stays as it is
 * @param accumulation what to add
 * @param[in,out] wheel bins of the wheel's profile; NULL: not wanted
 * @param[in,out] rail bins of the rail's profile; NULL: not wanted
 * @param[out] totals what was added to each; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT (nothing is added); WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE,
 * _RANGE, _SEQUENCE (no such results, or stages without a pose), _UNSUPPORTED (a method that gives forces alone). On failure
 * nothing is added.
 * @rt hard @thread contact */
WRC_API int32_t wrc_contact_accumulate(wrc_contact* contact, const wrc_accumulation* accumulation, wrc_damage_bins* wheel,
                                       wrc_damage_bins* rail, wrc_damage_totals* totals);

/** Adds bins to others of the same count, places and rows.
 * @param[in,out] into what is added to
 * @param from what is added
 * @return WRC_OK; WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE (also: bins of other places).
 * @rt hard @thread free */
WRC_API int32_t wrc_damage_merge(wrc_damage_bins* into, const wrc_damage_bins* from);

/** What bins hold, as numbers.
 * @param bins the bins
 * @param quantity enum wrc_damage_quantity
 * @param[out] values rows * count + 1 of them, in the bins' order
 * @return WRC_OK; WRC_FLAG_SUM_OVERFLOW (in one of them at least); WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE,
 * _UNSUPPORTED (no such quantity). @rt hard @thread free */
WRC_API int32_t wrc_damage_values(const wrc_damage_bins* bins, int32_t quantity, double* values);

/** Damage of one passage by the Whole Life Rail Model.
 * @param laws parameters; NULL: the published ones
 * @param t_gamma energy dissipated per metre by a patch, 0..1e9 N
 * @param[out] damage per passage; 1 is a crack; 0 on failure
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _NOT_FINITE. @rt hard @thread free */
WRC_API int32_t wrc_whole_life_damage(const wrc_fatigue_laws* laws, double t_gamma, double* damage);

/** Places on a profile by arc length, 0 at its origin, as bins have them.
 * @param model a model with profiles
 * @param body enum wrc_body
 * @param count places
 * @param arc `count` arc lengths, flange or gauge side negative [m]; beyond an end: the end
 * @param[out] y coordinate of the profile, `count`; of a rail canted about its origin [m]; NULL: not wanted
 * @param[out] z the same, down [m]; NULL: not wanted
 * @return WRC_OK; WRC_ERROR_NULL, _SEQUENCE (model without profiles), _UNSUPPORTED (no such body), _NOT_FINITE.
 * @rt hard @thread free */
WRC_API int32_t wrc_model_arc_places(const wrc_model* model, int32_t body, uint32_t count, const double* arc, double* y,
                                     double* z);

#endif /* WRC_DAMAGE_H */
