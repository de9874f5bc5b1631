/** @file wrc_surface.h
 * Rail and wheel as a state that wheels change: water, oxide, organic film, sand, lubricant and heat, in bins of the caller.
 * Conventions are those of wrc.h, which it includes.
 *
 * @par Stability
 * May change in a minor version: functions and structs with WRC_EXPERIMENTAL_VERSION. Constants of the named sets are quoted from
 * memory and not confirmed: a version may correct them, and CHANGELOG.md says so.
 *
 * @par One step of a wheel
 *
 * Between the middles of bins amounts change in straight lines, so friction is continuous in the place. Friction is an input of the
 * wrench, held over the step. Each change of an amount is booked: nothing appears or vanishes but by a source or a sink. Sums are
 * integers of 128 bits. Theory manual, "Films on rail and wheel".
 * @code
 *   wrc_surface_bin rail_bin[2000] = {0}, wheel_bin[24] = {0};
 *   wrc_surface rail = wrc_surface_default(), wheel = wrc_surface_default();
 *   rail.count = 2000;  rail.length = 1.0;  rail.bins = rail_bin;  rail.bin_size = sizeof rail_bin[0];
 *   wheel.count = 24;  wheel.length = 2.89 / 24;  wheel.closed = 1;  wheel.bins = wheel_bin;  wheel.bin_size = sizeof wheel_bin[0];
 *   wrc_surface_laws laws = wrc_surface_laws_default();
 *   wrc_surface_laws_use(&laws, "low adhesion", why, sizeof why);
 *   wrc_surface_add(&rail, WRC_SURFACE_FILM, 0.01, 0.0, 2000.0, why, sizeof why);       // leaves
 *   // in every step, without allocation:
 *   const double rolled = -radius * input.wheel.pitch_rate * dt;                          // [m], forwards > 0
 *   wrc_surface_passage step = {sizeof step, 0, x, x + v * dt, arc, arc + rolled};
 *   wrc_surface_friction(&rail, &wheel, &laws, &step, &dry, &input.friction, why, sizeof why);
 *   wrc_contact_wrench(contact, &input, &wrench);
 *   step.energy = wrench.power * dt;
 *   wrc_surface_pass(&rail, &wheel, &laws, &step, NULL, why, sizeof why);
 * @endcode
 *
 * Bins are short enough where the wheel's slip hardly changes along one. A wheel that spins at a crawl cleans the length of its
 * contact, so bins of 5 mm are right there. At line speed 0.1 to 1 m are. Put a sander's sand on the rail before the wheel, not under it.
 *
 * @par Rows across
 *
 * With `rows` above 1 a body has rows of bins across, each of `width` in y of its profile. Each strip of the wrench then has friction
 * and layer of the rows that it touches. Each row has the energy of its own strips. Row k alone is a surface, for a source or to be
 * read. For it copy the struct, set rows to 0, and add k * count * bin_size bytes to bins.
 * @code
 *   double across[WRC_FILM_NUMBERS(8, 8)];
 *   step.film_rows = across;  step.film_numbers = WRC_FILM_NUMBERS(8, 8);  step.contact = contact;
 * @endcode
 *
 * @par Order and threads
 *
 * Call wrc_surface_pass() for the wheels of one rail in the order in which they pass. The first wheel cleans the rail for the second.
 * Rails, and stretches of a rail that share no bin, may have threads of their own. So may sources, each with bins of its own that are
 * merged afterwards; the order of merging does not change a bit. Bins may be copied and saved as bytes.
 */
#ifndef WRC_SURFACE_H
#define WRC_SURFACE_H

#include "wrc.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Quantities of a bin: substances and heat. */
enum wrc_surface_quantity {
  WRC_SURFACE_WATER = 0,     /**< [kg/m^2] */
  WRC_SURFACE_OXIDE = 1,     /**< oxide and debris of wear [kg/m^2] */
  WRC_SURFACE_FILM = 2,      /**< organic film: leaves [kg/m^2] */
  WRC_SURFACE_SAND = 3,      /**< [kg/m^2] */
  WRC_SURFACE_LUBRICANT = 4, /**< grease, friction modifier [kg/m^2] */
  WRC_SURFACE_HEAT = 5       /**< above the ambient temperature [J/m^2] */
};

#define WRC_SURFACE_QUANTITIES 6 /**< quantities in use, of the 8 places there are */

#define WRC_MOST_FILM_ROWS 16    /**< most rows across a body */
#define WRC_FILM_NUMBERS(rail_rows, wheel_rows) (8 + 5 * (rail_rows) * (wheel_rows)) /**< numbers that film_rows needs */

/** Columns of the books of a bin. Amount = put on - removed - squeezed - evaporated - carried, to the last bit. */
enum wrc_surface_book {
  WRC_SURFACE_AMOUNT = 0,     /**< amount in the bin now */
  WRC_SURFACE_PUT_ON = 1,     /**< put on by sources; heat also by friction */
  WRC_SURFACE_REMOVED = 2,    /**< removed by frictional energy; heat lost to the air and into the depth */
  WRC_SURFACE_SQUEEZED = 3,   /**< pressed out of the running band by passing wheels */
  WRC_SURFACE_EVAPORATED = 4, /**< water evaporated; heat that this took */
  WRC_SURFACE_CARRIED = 5     /**< carried to the other body, less the amount that came from it */
};

#define WRC_SURFACE_BOOKS 6 /**< columns of the books */

/** One bin. With all members zero it is clean and at ambient temperature. */
typedef struct wrc_surface_bin {
  uint64_t sum[48][2]; /**< kg or J of the whole bin, at 8 * wrc_surface_book + wrc_surface_quantity: low and high half of an
                            integer of 128 bits, two's complement. wrc_surface_values() converts it */
  uint64_t overflow;   /**< bit i: sum i, or a contribution to it, passed its range and is invalid */
  double reserved[7];  /**< 0 */
} wrc_surface_bin;

/** Running band of a rail along the track, or of a wheel round its tread. Amounts belong to the middles of its bins, with straight
 * lines between. Beyond the ends of a band that is not closed the amounts of the end hold. Nothing is changed there. */
typedef struct wrc_surface {
  uint32_t struct_size;  /**< sizeof this struct, 48 or more */
  uint32_t count;        /**< bins, 1..10000000 [0] */
  double first;          /**< distance at which the first bin begins, -1e9..1e9 m [0] */
  double length;         /**< of a bin, 1e-3..1e4 m; of a wheel its circumference / count [0] */
  double width;          /**< of the running band, or of each row in y, 1e-3..0.5 m [0.02] */
  uint32_t closed;       /**< 0..1; 1: the last bin is beside the first: a wheel, a roller, a track that is a circle [0] */
  uint32_t bin_size;     /**< sizeof(wrc_surface_bin), 832..4096 [0] */
  wrc_surface_bin* bins; /**< of the caller, `count` for each row, row after row, zeroed before the first use */
  uint32_t rows;         /**< rows across, 0..16; 0 or 1: one band, on which the whole contact lies [0] */
  uint32_t reserved0;    /**< 0 */
  double row_first;      /**< y of the profile at which the first of several rows begins, -1..1 m [0] */
} wrc_surface;

/** Laws of one substance: friction, layer, removal. With all members zero it lies there and has no effect. */
typedef struct wrc_substance {
  double cover;        /**< on both bodies together: amount from which it covers the surface, 0 or 1e-6..100 kg/m^2; 0: no
                            effect on friction and layer [0] */
  double weight;       /**< weight of its friction among substances that cover together, 0 or 1e-3..1000; goes with cover [0] */
  double friction;     /**< coefficient of friction of a dry surface that it covers, 0 or 1e-3..2; goes with cover [0] */
  double wet_friction; /**< the same where water covers, too, 0 or 1e-3..2; goes with cover [0] */
  double removal;      /**< tau: frictional energy W over the band's area removes the share 1 - exp(-tau W), 0..1 m^2/J [0] */
  double kept;         /**< amount that a passing wheel leaves in the band, 0..100 kg/m^2 [0] */
  double squeeze;      /**< share of the amount above `kept` that one passage presses out of the band, 0..0.999 [0] */
  double carry;        /**< rate at which amounts on both bodies become equal, as a share in one passage, 0..1 [0] */
  double density;      /**< of its layer, 100..1e5 kg/m^3 [1000] */
  double layer_modulus;   /**< of its layer in shear, 0 or 1e3..1e12 Pa; 0: it does not shear elastically [0] */
  double layer_yield;     /**< traction at which its layer yields, 0 or 1e3..1e11 Pa; 0: it does not yield [0] */
  double layer_hardening; /**< as wrc_friction.layer_hardening, goes with layer_yield, -1e13..1e14 Pa/m [0] */
  double reserved[4];     /**< 0 */
} wrc_substance;

/** Constants of the mixing rule and of passages. wrc_surface_laws_use() sets them by a name. */
typedef struct wrc_surface_laws {
  uint32_t struct_size;      /**< sizeof this struct, 720 or more */
  uint32_t reserved0;        /**< 0 */
  wrc_substance water;       /**< it wets the others: wet_friction is that of wet steel; weight, friction, layer are 0 */
  wrc_substance oxide;       /**< oxide and debris */
  wrc_substance film;        /**< organic film */
  wrc_substance sand;        /**< sand */
  wrc_substance lubricant;   /**< lubricant */
  double rail_share;         /**< share of the frictional energy that heats the rail, 0..1; the wheel has the rest [0.5] */
  double rail_heat_capacity; /**< heat capacity of the rail per area of its band, 1e2..1e8 J/(m^2 K) [35e3] */
  double wheel_heat_capacity; /**< heat capacity of the wheel per area of its band, 1e2..1e8 J/(m^2 K) [35e3] */
  double cooling_time;       /**< time after which wrc_surface_rest() leaves 1/e of the heat, 1e-3..1e9 s [60] */
  double drying_time;        /**< time after which wrc_surface_rest() leaves 1/e of the water, 1e-3..1e9 s [1800] */
  double evaporation_share;  /**< share of frictional heat that evaporates water where there is plenty, 0..1 [0] */
  double evaporation_amount; /**< amount of water at which that share is halved, 1e-6..10 kg/m^2 [5e-3] */
  double latent_heat;        /**< latent heat of evaporation, 1e5..1e7 J/kg [2.4e6] */
  double ambient;            /**< temperature of bodies without heat, -100..200 degC [20] */
} wrc_surface_laws;

/** Sets of constants by name, X(identifier, "name"): wrc_surface_laws_use(). Theory manual, "Films on rail and wheel", has the
 * numbers and their sources. All are unconfirmed.
 *  - low adhesion: friction, removal and carrying; no layers.
 *  - low adhesion, layers: the same with the sheared layers of Hou, Kalousek and Magel (Wear 211 (1997)). */
#define WRC_SURFACE_LAWS_LIST(X)          \
  X(low_adhesion, "low adhesion")         \
  X(layers, "low adhesion, layers")

/** A step of a wheel on its rail: the stretches of both bodies that passed through the contact, and the frictional energy. */
typedef struct wrc_surface_passage {
  uint32_t struct_size; /**< sizeof this struct, 48 or more */
  uint32_t reserved0;   /**< 0 */
  double rail_from;     /**< distance along the rail at the beginning, growing forwards, -1e9..1e9 m [0] */
  double rail_to;       /**< the same at the end, -1e9..1e9 m [0] */
  double wheel_from;    /**< distance round the wheel at the beginning, growing as it rolls forwards, -1e9..1e9 m [0] */
  double wheel_to;      /**< the same at the end; wheel_from for a locked wheel, -1e9..1e9 m [0] */
  double energy;        /**< frictional energy: wrc_wrench.power times the duration, 0..1e9 J [0] */
  double* film_rows;    /**< memory of the caller for films in rows; NULL: with one row it is not needed [NULL] */
  uint32_t film_numbers; /**< numbers of film_rows, 0 or 13..1288 [0] */
  uint32_t reserved1;    /**< 0 */
  const wrc_contact* contact; /**< contact whose last wrench passes, for wrc_surface_pass() with rows; NULL: one row [NULL] */
} wrc_surface_passage;

/** Amounts and energies that a passage moved. */
typedef struct wrc_surface_exchange {
  uint32_t struct_size;  /**< sizeof this struct, 96 or more */
  uint32_t reserved0;    /**< 0 */
  double carried[8];     /**< by enum wrc_surface_quantity: from rail to wheel, less that from wheel to rail [kg] */
  double rail_energy;    /**< frictional energy booked in the rail's bins [J] */
  double wheel_energy;   /**< the same in the wheel's bins [J] */
  double beside_energy;  /**< the remaining energy: beyond a rail's ends, of a wheel that is NULL, of a wrench without work [J] */
} wrc_surface_exchange;

/** @name Defaults
 * As those of wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_surface_init(wrc_surface* surface); /**< Defaults: surface. */
WRC_API int32_t wrc_surface_laws_init(wrc_surface_laws* laws); /**< Defaults: laws; no substance has an effect. */
/** @cond */
WRC_DEFAULT_SIZED(wrc_surface)
WRC_DEFAULT_SIZED(wrc_surface_laws)
/** @endcond */
/** @} */

/** Sets all constants but the ambient temperature by a name of WRC_SURFACE_LAWS_LIST.
 * @param[in,out] laws after wrc_surface_laws_default()
 * @param name "low adhesion" or "low adhesion, layers"
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _UNSUPPORTED (no such name: the sentence lists all). @rt hard @thread free */
WRC_API int32_t wrc_surface_laws_use(wrc_surface_laws* laws, const char* name, char* text, uint64_t size);

/** A source: puts an amount onto a stretch. Rain, sander, lubricator and leaves are calls of this function.
 * @param[in,out] surface rail or wheel
 * @param quantity enum wrc_surface_quantity
 * @param amount per area of the band, 0..100 kg/m^2; of heat 0..1e9 J/m^2
 * @param from distance at which the stretch begins, -1e9..1e9 m
 * @param to distance at which it ends, not below `from`; over 100000 bins at most
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_BEYOND_SECTIONS (part lies beyond the ends, and is not put on); WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL,
 * _STRUCT_SIZE, _NOT_FINITE, _RANGE, _UNSUPPORTED (no such quantity). On failure nothing is changed.
 * @rt hard @thread free, one at a time per surface */
WRC_API int32_t wrc_surface_add(wrc_surface* surface, int32_t quantity, double amount, double from, double to, char* text,
                                uint64_t size);

/** Friction and layer where a wheel is on its rail, for wrc_contact_wrench(), at the beginning of a passage. Each substance covers
 * the share theta = min(1, amount of both bodies / cover). Water wets: each friction goes from dry to wet by water's theta. The share
 * of bare steel is the product of 1 - theta of all other substances. Covered steel has the mean friction of these, weighted by theta
 * times weight. So one substance alone, dry or wet, changes friction in proportion to its amount. Under frictional energy W friction
 * then recovers as 1 - exp(-tau W): Allotta, Meli, Ridolfi and Rindi, Tribology International 69 (2014).
 * Layers lie in series. Where the passage has film_rows, a strip's friction is a mu + b, with mu of the base. Its a and b are means over
 * the rows that it touches. Zones of the base are then kept. Friction and layer are continuous in amounts, heat and places. They are
 * inputs of the wrench: hold them over the step and over trial steps of an integrator. Derivatives of the wrench hold at this friction.
 * @param rail the rail
 * @param wheel the wheel; NULL: it carries nothing
 * @param laws constants
 * @param passage only rail_from, wheel_from and film_rows are used; film_rows must live as long as `friction`
 * @param base friction of clean, dry bodies; its zones need film_rows; NULL: the defaults. Its laws of speed and temperature are kept.
 * Its layer lies in series with those of the substances
 * @param[out] friction base with coefficient, layer_... and bulk of the surfaces; base itself is not changed; defaults on failure
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_BEYOND_SECTIONS (beyond an end, where the end's amounts hold); WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL,
 * _STRUCT_SIZE, _NOT_FINITE, _RANGE (also: fewer film_numbers than the rows need), _UNSUPPORTED (zones without film_rows).
 * @rt hard @thread free, one at a time per surface */
WRC_API int32_t wrc_surface_friction(const wrc_surface* rail, const wrc_surface* wheel, const wrc_surface_laws* laws,
                                     const wrc_surface_passage* passage, const wrc_friction* base, wrc_friction* friction,
                                     char* text, uint64_t size);

/** A wheel passes: it exchanges substances with the rail. Frictional energy removes them and heats both bodies. Water evaporates, and
 * substances above `kept` are pressed out of the band. With rows, each strip of passage.contact acts on the rows that it touches, with
 * its share of the energy. A passage in shorter pieces has nearly the same outcome. Either body may go backwards or stand still: a
 * wheel that is locked, or one that spins on the spot.
 * @param[in,out] rail the rail
 * @param[in,out] wheel the wheel; NULL: it carries nothing
 * @param laws constants
 * @param passage the step; over at most 100000 bins of each body
 * @param[out] exchange amounts and energies moved; NULL: not wanted
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_BEYOND_SECTIONS (part lies beyond the ends: no exchange there); WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL,
 * _STRUCT_SIZE, _NOT_FINITE, _RANGE, _SEQUENCE (rows, and no wrench of a contact). On failure nothing is changed. Work grows with the
 * bins that are passed.
 * @rt hard @thread free, one at a time per surface */
WRC_API int32_t wrc_surface_pass(wrc_surface* rail, wrc_surface* wheel, const wrc_surface_laws* laws,
                                 const wrc_surface_passage* passage, wrc_surface_exchange* exchange, char* text, uint64_t size);

/** Lets all bins cool and dry for a time. Call it for a rail once in a while, for a wheel in every step.
 * @param[in,out] surface rail or wheel
 * @param laws constants
 * @param duration the time, 0..1e9 s
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE. Work grows with the bins.
 * @rt hard @thread free, one at a time per surface */
WRC_API int32_t wrc_surface_rest(wrc_surface* surface, const wrc_surface_laws* laws, double duration, char* text, uint64_t size);

/** Adds amounts and books of bins to others of the same count, rows, place, length and width.
 * @param[in,out] into bins that receive the sums
 * @param from bins to add; not changed
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_SUM_OVERFLOW; WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE (also: bins of other places).
 * @rt hard @thread free, one at a time per surface */
WRC_API int32_t wrc_surface_merge(wrc_surface* into, const wrc_surface* from, char* text, uint64_t size);

/** One column of the books of all bins, as numbers.
 * @param surface rail or wheel
 * @param quantity enum wrc_surface_quantity
 * @param book enum wrc_surface_book
 * @param[out] values surface->count numbers for each row, row after row, per area [kg/m^2], of heat [J/m^2]; NULL: not wanted
 * @param[out] total sum over all bins [kg], of heat [J]; 0 on failure; NULL: not wanted
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_SUM_OVERFLOW (in at least one bin); WRC_ERROR_NULL, _STRUCT_SIZE, _NOT_FINITE, _RANGE,
 * _UNSUPPORTED (no such quantity or book). @rt hard @thread free, one at a time per surface */
WRC_API int32_t wrc_surface_values(const wrc_surface* surface, int32_t quantity, int32_t book, double* values, double* total,
                                   char* text, uint64_t size);

#ifdef __cplusplus
}
#endif

#endif /* WRC_SURFACE_H */
