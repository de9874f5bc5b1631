/** @file wrc_damage.h
 * What contact does to the bodies: stresses below the surface, temperatures. Part of wrc.h, which includes it; the
 * conventions there (frames, signs, structs, statuses, classes) hold here. */
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

/** Temperatures of the bodies away from the contact, which friction's heat does not reach while they pass. */
typedef struct wrc_bulk_temperatures {
  double wheel; /**< of the tread, -273..2000 degC [20]. Too large: did you pass kelvin, or Fahrenheit? */
  double rail;  /**< of the running surface, -273..2000 degC [20]. Too large: did you pass kelvin, or Fahrenheit? */
} wrc_bulk_temperatures;

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

/** @name Defaults
 * As those of wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_stresses_init(wrc_stresses* stresses); /**< Defaults: stresses. */
WRC_API int32_t wrc_bulk_temperatures_init(wrc_bulk_temperatures* bulk); /**< Defaults: temperatures of the bodies. */
WRC_API int32_t wrc_temperature_init(wrc_temperature* temperature); /**< Defaults: temperatures in the contact. */
/** @cond */
WRC_DEFAULT_SIZED(wrc_stresses)
WRC_DEFAULT(wrc_bulk_temperatures)
WRC_DEFAULT_SIZED(wrc_temperature)
/** @endcond */
/** @} */

/** Temperatures in the contact from the frictional power of the last wrc_contact_tangential or wrc_contact_step, and the field
 * TEMPERATURE_RISE: flash temperatures of points that pass through the contact (Ertz and Knothe, Wear 253 (2002) 498),
 *     T(s) = (beta_w T_w + beta_r T_r) / (beta_w + beta_r) + 1 / ((beta_w + beta_r) sqrt(pi V)) Int_0^s q / sqrt(s - s') ds',
 * s from the leading edge along each strip, q the power density, beta = sqrt(conductivity density specific_heat) of
 * config.wheel_heat and config.rail_heat. Heat flows into the depth alone, which holds from some 0.1 m/s on (Peclet
 * number V a density specific_heat / (2 conductivity) > 10); below, temperatures are too high and go to zero with the speed.
 * Near standstill (creepage.other_way) it is of the way of creepage.speed. Cost grows with strips * cells^2. May be
 * called again with other bulk temperatures. Theory manual, section 6.
 * @param contact the contact
 * @param bulk temperatures of the bodies; NULL: the defaults
 * @param[out] temperature the numbers; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_contact_tangential before),
 * _NOT_FINITE, _RANGE, _UNSUPPORTED (a method that gives forces alone: there is no power over the patch). @rt hard @thread
 * contact */
WRC_API int32_t wrc_contact_temperature(wrc_contact* contact, const wrc_bulk_temperatures* bulk,
                                        wrc_temperature* temperature);

/** Largest stresses in one of the bodies under pressure and tractions of the last wrc_contact_tangential or
 * wrc_contact_step: at the surface, at depths of the caller's, and around the largest of these (golden sections between
 * its neighbours: depths a fifth of the patch's smaller half extent apart are close enough). Elastic half-space; strips
 * are joined to at most 36 lanes of 56 cells, near cells are rectangles, others forces at points (Boussinesq, Love, Cerruti;
 * Johnson 1985, 3.2). Bounded, but no call for every millisecond: at most 250 places a depth, the surface included, and 24
 * more, some 25 us each: 8 ms for the surface and one depth, 22 ms with ten. wrc_exact_largest_stresses()
 * (wrc_offline.h) is the exact counterpart. Theory manual, section 6.
 * @param contact the contact
 * @param body enum wrc_body: the one whose stresses are wanted
 * @param depths count of them, increasing, 0..0.1 m
 * @param count of depths, 1..64
 * @param[out] levels the largest at each of these depths, count of them; NULL: not wanted; zero on failure
 * @param[out] stresses at the surface, below it and of both; NULL: not wanted
 * @return WRC_OK; WRC_FLAG_NO_CONTACT; WRC_ERROR_NULL, _STRUCT_SIZE, _SEQUENCE (no wrc_contact_tangential before),
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

#endif /* WRC_DAMAGE_H */
