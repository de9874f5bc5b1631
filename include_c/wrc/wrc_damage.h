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

/** @name Defaults
 * As those of wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_stresses_init(wrc_stresses* stresses); /**< Defaults: stresses. */
/** @cond */
WRC_DEFAULT_SIZED(wrc_stresses)
/** @endcond */
/** @} */

#endif /* WRC_DAMAGE_H */
