/** @file wrc_damage.h
 * Stresses below the surface, temperatures, wear, damage along the line, and the numbers behind them. Conventions are those of wrc.h,
 * which it includes.
 *
 * @par Stability
 * May change in a minor version: functions and structs with WRC_EXPERIMENTAL_VERSION. Constants of the wear and fatigue laws are
 * quoted from memory and not confirmed: a version may correct them, and CHANGELOG.md says so.
 *
 * @par Damage along the line
 *
 * Bins of the caller collect what a journey does to profiles and rails. They lie over the arc length of a profile, of a rail also over
 * the distance along the track. Each strip of a contact gives each bin its share by overlap: sums are continuous in the pose. Sums
 * are integers of 128 bits. Contacts may add to one set of bins, or to sets that are merged afterwards. The order does not change
 * a bit.
 * @code
 *   wrc_damage_bin wheel_bin[281] = {0};                                // 280, and one for what lies beside them
 *   wrc_damage_bins wheel = wrc_damage_bins_default();
 *   wheel.count = 280;  wheel.first = -0.070;  wheel.width = 0.5e-3;    // along the profile, 0 at its origin
 *   wheel.bins = wheel_bin;  wheel.bin_size = sizeof wheel_bin[0];
 *   wrc_accumulation step = {sizeof step};
 *   // in every step, from here on without allocation:
 *   wrc_contact_wrench(contact, &input, &wrench);
 *   step.duration = dt;  step.distance = x;
 *   wrc_contact_accumulate(contact, &step, &wheel, NULL, NULL);
 *   // at the end:
 *   wrc_damage_values(&wheel, WRC_DAMAGE_WEAR_ARCHARD, values);         // m^3 in every bin
 * @endcode
 */
#ifndef WRC_DAMAGE_H
#define WRC_DAMAGE_H

#include "wrc.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Parameters of the wear laws. Defaults are the published values, in their published units; all are
 * unconfirmed (quoted from memory, not checked against the original texts) and depend on the pair of steels. Theory manual,
 * section 6.
 *  - T-gamma: area lost per metre rolled (Pearce and Sherratt, Wear 144 (1991)), over the wheel's diameter.
 *  - Sheffield: depth per metre rolled from T-gamma per area (R8T wheel on UIC60 900A; Braghin et al. 2006).
 *  - Archard: depth per second, k p v / hardness with the map of Jendel (Wear 253 (2002)).
 *  - Power law: depth per second, power_coefficient / density * q (q / power_reference)^(power_exponent - 1), q the
 *    frictional power density. With exponent 1 mass is worn in proportion to energy: the mild regime of Zobory
 *    (VSD 28 (1997)), which ends at 4 W/mm^2. */
typedef struct wrc_wear_laws {
  uint32_t struct_size;                /**< sizeof this struct, 184 or more */
  uint32_t reserved0;                  /**< 0 */
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
  double hardness; /**< of the softer body, 1e6..1e12 Pa [3e9] */
  double archard_slow; /**< coefficient below archard_severe_start, 0..1 [5e-4] */
  double archard_severe; /**< coefficient between the two speeds, 0..1 [35e-4] */
  double archard_fast; /**< coefficient above archard_severe_end, 0..1 [5e-4] */
  double archard_seizure; /**< coefficient where pressure exceeds seizure_pressure * hardness, 0..1 [350e-4] */
  double archard_severe_start; /**< sliding velocity from which wear is severe, 0..1000 m/s [0.2] */
  double archard_severe_end; /**< sliding velocity up to which it is severe, 0..1000 m/s, not below archard_severe_start
                                  [0.7] */
  double seizure_pressure; /**< share of the hardness, 0..1000 [0.8] */
  double power_coefficient; /**< mass worn per energy at power_reference, 0..1 kg/J [7e-10] */
  double power_exponent; /**< of the frictional power density, 0.25..4 [1] */
  double power_reference; /**< power density at which power_coefficient holds, 1..1e12 W/m^2 [4e6] */
} wrc_wear_laws;

/** Wear of one region. */
typedef struct wrc_wear {
  double worn_area_rate;         /**< T-gamma law: area lost from the wheel's section per metre rolled [m^2/m] */
  double largest_depth_rate;     /**< Sheffield: depth per metre rolled of the worst cell [m/m] */
  double largest_depth_velocity; /**< Archard: depth per second in contact of the worst cell [m/s] */
  double largest_power_depth_velocity; /**< power law: the same [m/s] */
  double reserved[6];            /**< 0 */
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
  double reserved[4]; /**< 0 */
} wrc_coefficients;

/** A stress that is the largest of its kind, and where in the body it is: contact frame, but for the depth. */
typedef struct wrc_stress_peak {
  double stress; /**< [Pa] */
  double x;      /**< contact frame [m] */
  double y;      /**< see x */
  double depth;  /**< below the body's surface [m] */
  double reserved[2]; /**< 0 */
} wrc_stress_peak;

/** Largest stresses in a body, each at its own place. */
typedef struct wrc_stress_peaks {
  wrc_stress_peak von_mises; /**< sqrt(3 J2) */
  wrc_stress_peak shear;     /**< (s1 - s3) / 2: half of Tresca's stress */
  wrc_stress_peak tension;   /**< s1, the most tensile principal stress; < 0 where all three are compressive */
  wrc_stress_peak reserved;  /**< room for one more of these */
} wrc_stress_peaks;

/** Stresses in one of the bodies as a whole. */
typedef struct wrc_stresses {
  uint32_t struct_size;      /**< sizeof this struct, 584 or more */
  int32_t body;              /**< enum wrc_body: which */
  wrc_stress_peaks largest;  /**< of the two that follow */
  wrc_stress_peaks surface;  /**< at the surface */
  wrc_stress_peaks below;    /**< beneath it */
} wrc_stresses;

/** Temperatures in the contact. Wheel and rail have the same where they touch. */
typedef struct wrc_temperature {
  uint32_t struct_size; /**< sizeof this struct, 72 or more */
  uint32_t reserved0;   /**< 0 */
  double at_entry;      /**< of both surfaces as soon as they touch, between those of the bodies [degC] */
  double rise;          /**< the largest by friction over that, of all cells [K] */
  double x;             /**< where: contact frame, the middle of the cell [m] */
  double y;             /**< see x */
  double largest;       /**< at_entry + rise [degC] */
  double mean_rise;     /**< over the contact's area [K] */
  double wheel_heat;    /**< that flows into the wheel, of friction and of the bodies' touching [W] */
  double rail_heat;     /**< the same of the rail; both together are the frictional power [W] */
} wrc_temperature;

/** Quantities of a bin. Sums: a bin's volume over its width (and over a wheel's circumference, or a rail's length) is a depth;
 * a fatigue sum over its width and over the length rolled (or a rail's length) is the index of each passage, added up. Each
 * range is that of a sum; single contributions may be half of it. */
enum wrc_damage_quantity {
  WRC_DAMAGE_WORK = 0,             /**< frictional work [J], +-8e12; over the distance it is T-gamma */
  WRC_DAMAGE_WEAR_T_GAMMA = 1,     /**< volume worn by the T-gamma law [m^3], +-8e6; spread like the work. The law is of wheels:
                                        bins of a rail get the volume of the wheel */
  WRC_DAMAGE_WEAR_SHEFFIELD = 2,   /**< the same by Sheffield's law, of each strip's T-gamma over its area */
  WRC_DAMAGE_WEAR_ARCHARD = 3,     /**< the same by Archard's, of each strip's work, peak pressure and sliding velocity */
  WRC_DAMAGE_WEAR_POWER = 4,       /**< the same by the power law, of each strip's power over its area */
  WRC_DAMAGE_WHOLE_LIFE = 5,       /**< Whole Life Rail Model: damage function of the patch's T-gamma, times distance and
                                        width [m^2], +-8e6; < 0 where wear removes cracks */
  WRC_DAMAGE_SURFACE_FATIGUE = 6,  /**< positive part of the strip's surface fatigue index |F| / N - k / p0, times distance
                                        and width [m^2], +-8e6 */
  WRC_DAMAGE_TIME = 7,             /**< contact time times width [s m], +-8e6 */
  WRC_DAMAGE_LARGEST_PRESSURE = 1000, /**< not a sum: largest pressure [Pa] */
  WRC_DAMAGE_LARGEST_TRACTION = 1001  /**< not a sum: largest traction [Pa]: |F| / N of a strip times its peak pressure */
};

#define WRC_DAMAGE_SUMS 8 /**< quantities that are sums, in use of the 16 places there are */

/** One bin: all zero, nothing was added. Bits are the same whatever the order of additions and merges. */
typedef struct wrc_damage_bin {
  uint64_t sum[16][2];     /**< by enum wrc_damage_quantity: low and high half of an integer of 128 bits, two's complement.
                                wrc_damage_values() converts it */
  double largest_pressure; /**< [Pa] */
  double largest_traction; /**< [Pa] */
  uint64_t overflow;       /**< bit i: sum i, or a contribution to it, passed its range and is worthless */
  double reserved[4];      /**< 0 */
} wrc_damage_bin;

/** Bins over the arc length of a profile, 0 at its origin, flange or gauge side negative; of a rail also in rows along the
 * track. */
typedef struct wrc_damage_bins {
  uint32_t struct_size; /**< sizeof this struct, 56 or more */
  uint32_t count;       /**< bins of a row, 1..1000000 [0] */
  double first;         /**< arc length at which the first begins, -1..1 m [0] */
  double width;         /**< of a bin, 1e-5..1 m [1e-3] */
  uint32_t row_count;   /**< rows along the track, 1..1000000; row_count * count 100000000 at most [1] */
  uint32_t bin_size;    /**< sizeof(wrc_damage_bin), 312..4096 [0] */
  double row_first;     /**< distance at which the first row begins, -1e9..1e9 m [0] */
  double row_length;    /**< of a row, 0 or 1e-3..1e9 m; 0: one row takes all, whatever the distance [0] */
  wrc_damage_bin* bins; /**< row_count * count + 1 of the caller, row by row, zeroed before the first use. The last has what lies
                             beside all others. They may be copied and saved as bytes */
} wrc_damage_bins;

/** Damage of rolling contact fatigue by T-gamma: the Whole Life Rail Model. Zero up to `start`, rising straight to `peak` at
 * `peak_at`, falling straight through zero at `end` and on below it, where wear wins. For R220 and R260 steel; Burstow, RSSB
 * T115 (2004); quoted from memory, unconfirmed. The direction of the creep force, by which the model tells cracks that open, is
 * left to the caller. */
typedef struct wrc_fatigue_laws {
  uint32_t struct_size;      /**< sizeof this struct, 40 or more */
  uint32_t reserved0;        /**< 0 */
  double whole_life_start;   /**< T-gamma from which cracks start, 0..1e6 N [15] */
  double whole_life_peak_at; /**< T-gamma of the largest damage, 1e-3..1e6 N, above whole_life_start [65] */
  double whole_life_end;     /**< T-gamma at which wear takes as much as cracks grow, 1e-3..1e6 N, above whole_life_peak_at
                                  [175] */
  double whole_life_peak;    /**< damage of a passage at whole_life_peak_at, 0..1; 1 is a crack [1e-5] */
} wrc_fatigue_laws;

/** Input of wrc_contact_accumulate(). */
typedef struct wrc_accumulation {
  uint32_t struct_size;            /**< sizeof this struct, 40 or more */
  uint32_t reserved0;              /**< 0 */
  double duration;                 /**< for which the results hold, 0..1e6 s [0] */
  double distance;                 /**< along the track where that begins, -1e9..1e9 m; read where a row of bins has a
                                        length [0] */
  const wrc_wear_laws* wear;       /**< NULL: the published ones [NULL] */
  const wrc_fatigue_laws* fatigue; /**< NULL: the published ones [NULL] */
} wrc_accumulation;

/** Amounts that one wrc_contact_accumulate() added to each of its sets of bins. */
typedef struct wrc_damage_totals {
  double sum[16];          /**< by enum wrc_damage_quantity, units there */
  double largest_pressure; /**< [Pa] */
  double largest_traction; /**< [Pa] */
  double reserved[4];      /**< 0 */
} wrc_damage_totals;

/** @name Defaults
 * As those of wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_bulk_temperatures_init(wrc_bulk_temperatures* bulk); /**< Defaults: temperatures of the bodies. */
WRC_API int32_t wrc_wear_laws_init(wrc_wear_laws* laws); /**< Defaults: wear laws. */
WRC_API int32_t wrc_damage_bins_init(wrc_damage_bins* bins); /**< Defaults: bins. */
WRC_API int32_t wrc_fatigue_laws_init(wrc_fatigue_laws* laws); /**< Defaults: fatigue laws. */
/** @cond */
WRC_DEFAULT(wrc_bulk_temperatures)
WRC_DEFAULT_SIZED(wrc_wear_laws)
WRC_DEFAULT_SIZED(wrc_damage_bins)
WRC_DEFAULT_SIZED(wrc_fatigue_laws)
/** @endcond */
/** @} */

/** Wear of one region of the contact's last solution, by all four laws. Theory manual, section 6.
 * @param contact the contact; its work space is used
 * @param index as for wrc_contact_damage()
 * @param laws parameters; NULL: the published ones
 * @param[out] wear the numbers
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no solution), _NOT_FINITE, _RANGE (no such region, or WRC_ALL_REGIONS of
 * a wheel), _UNSUPPORTED (no tractions). @rt hard @thread contact */
WRC_API int32_t wrc_contact_wear(wrc_contact* contact, int32_t index, const wrc_wear_laws* laws, wrc_wear* wear);

/** Temperatures in one region of the contact's last solution, from its frictional power. They are flash temperatures of points that
 * pass through the contact (Ertz and Knothe, Wear 253 (2002) 498),
 *     T(s) = (beta_w T_w + beta_r T_r) / (beta_w + beta_r) + 1 / ((beta_w + beta_r) sqrt(pi V)) Int_0^s q / sqrt(s - s') ds',
 * s from the leading edge along each strip, q the power density, beta = sqrt(conductivity density specific_heat). Heat flows into
 * the depth alone, which holds from some 0.1 m/s on. Below, temperatures are too high and go to zero with the speed. Near standstill
 * they are those of the way that the wheel rolls. Cost grows with strips * cells^2. Theory manual, section 6.
 * @param contact the contact; its work space is used
 * @param index as for wrc_contact_damage()
 * @param bulk temperatures of the bodies; NULL: the defaults
 * @param[out] temperature the numbers: x as WRC_FIELD_X, y as WRC_FIELD_STRIP_Y
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no solution), _NOT_FINITE, _RANGE (no such region, or WRC_ALL_REGIONS of
 * a wheel), _UNSUPPORTED (no tractions). @rt hard @thread contact */
WRC_API int32_t wrc_contact_temperature(wrc_contact* contact, int32_t index, const wrc_bulk_temperatures* bulk,
                                        wrc_temperature* temperature);

/** Largest stresses in one of the bodies under one region of the contact's last solution. They are looked for at the surface, at
 * depths of the caller, and around the largest of these. A region of a wheel is laid flat along the rail's arc. Depths a fifth of
 * the patch's smaller half extent apart are close enough. Elastic half-space: strips are joined to 36 lanes of 48 cells at most, near
 * cells are rectangles, others forces at points (Boussinesq, Love, Cerruti; Johnson 1985, 3.2). 0.6 ms for the surface, 2.4 ms with
 * eight depths, on slender patches two to four times that. wrc_exact_largest_stresses() is the exact counterpart. Theory manual,
 * section 6.
 * @param contact the contact; its work space is used
 * @param index as for wrc_contact_damage()
 * @param body enum wrc_body: the one whose stresses are wanted
 * @param depths count of them, increasing, 0..0.1 m
 * @param count of depths, 1..64
 * @param[out] levels the largest at each of these depths, count of them; NULL: not wanted; zero on failure
 * @param[out] stresses at the surface, below it and of both; NULL: not wanted. Places: x as WRC_FIELD_X, y as WRC_FIELD_STRIP_Y
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no solution), _NOT_FINITE, _RANGE (also WRC_ALL_REGIONS of a wheel),
 * _UNSUPPORTED (no such body, no tractions). @rt hard, long @thread contact */
WRC_API int32_t wrc_contact_stresses(wrc_contact* contact, int32_t index, int32_t body, const double* depths, uint32_t count,
                                     wrc_stress_peaks* levels, wrc_stresses* stresses);

/** The rise of wrc_contact_temperature() along one strip of the caller's power densities: of a solution of wrc_exact_rolling()
 * for one, row by row.
 * @param count cells, 1..512
 * @param cell their length, 1e-7..0.01 m
 * @param power_density count of them from the leading edge on, at the cells' middles, -1e18..1e18 W/m^2; below 0
 * counts as 0
 * @param speed rolling speed, 1e-6..200 m/s
 * @param wheel how the wheel takes up heat; NULL: the defaults
 * @param rail the same of the rail; NULL: the defaults
 * @param[out] rise count of them [K]; may be power_density
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE. @rt hard @thread free */
WRC_API int32_t wrc_flash_temperature(uint32_t count, double cell, const double* power_density, double speed,
                                      const wrc_heat_properties* wheel, const wrc_heat_properties* rail, double* rise);

/** Adds what the contact's last solution does in a duration to bins of its wheel and of its rail. Work grows with the strips
 * in contact and the bins they cover. Theory manual, "Damage along the line".
 * @param contact with the results; stays as it is
 * @param accumulation what to add
 * @param[in,out] wheel bins of the wheel's profile; NULL: not wanted
 * @param[in,out] rail bins of the rail's profile; NULL: not wanted
 * @param[out] totals what was added to each; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT (nothing is added); WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE,
 * _RANGE, _SEQUENCE (no solution, or stages without a pose), _UNSUPPORTED (a method that gives forces alone). On failure
 * nothing is added.
 * @rt hard @thread contact, one at a time per set of bins */
WRC_API int32_t wrc_contact_accumulate(wrc_contact* contact, const wrc_accumulation* accumulation, wrc_damage_bins* wheel,
                                       wrc_damage_bins* rail, wrc_damage_totals* totals);

/** Adds bins to others of the same count, places and rows.
 * @param[in,out] into what is added to
 * @param from what is added
 * @return WRC_OK; WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE (also: bins of other places). Work grows
 * with the bins. @rt hard @thread free, one at a time per set of bins */
WRC_API int32_t wrc_damage_merge(wrc_damage_bins* into, const wrc_damage_bins* from);

/** Contents of bins as numbers.
 * @param bins the bins
 * @param quantity enum wrc_damage_quantity
 * @param[out] values row_count * count + 1 of them, in the bins' order
 * @return WRC_OK; WRC_FLAG_SUM_OVERFLOW (in one of them at least); WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE,
 * _UNSUPPORTED (no such quantity). @rt hard @thread free, one at a time per set of bins */
WRC_API int32_t wrc_damage_values(const wrc_damage_bins* bins, int32_t quantity, double* values);

/** Damage of one passage by the Whole Life Rail Model: see wrc_fatigue_laws. Theory manual, section 6.
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

/** Coefficients of the linear theory. Theory manual, section 4; paper eq. 5.
 * @param a_over_b axis ratio, 1e-3..1e3 @param psi shape number, -0.95..0.95 @param poisson 0..0.5
 * @param[out] coefficients the coefficients
 * @return WRC_OK; WRC_FLAG_TABLE_RANGE beyond the tables; WRC_ERROR_NULL, _RANGE, _NOT_FINITE.
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

#ifdef __cplusplus
}
#endif

#endif /* WRC_DAMAGE_H */
