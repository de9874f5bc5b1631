/* wrc_status.h - every status a wrc call can return: the one registry.
 *
 * The enum below, the texts of wrc_status_text(), the Fortran parameters and the table in the manual all come
 * from WRC_STATUS_LIST. Values are pinned: a value is never reused or renumbered.
 *
 *   0   done.
 *   >0  a flag: done and usable, with a remark.
 *   <0  not done: every output of the call is zeroed, and the object stays usable for the next call.
 */
#ifndef WRC_STATUS_H
#define WRC_STATUS_H

/* X(name, value, text) */
#define WRC_STATUS_LIST(X)                                                                              \
  X(WRC_OK, 0, "done")                                                                                  \
  X(WRC_FLAG_NO_CONTACT, 1, "the bodies do not touch: all forces are zero")                             \
  X(WRC_FLAG_ITERATION_CAP, 2, "an iteration reached its cap: the last iterate is returned")            \
  X(WRC_FLAG_PATCH_AT_EDGE, 3, "the patch reaches the edge of the given gap, profile or surface")                \
  X(WRC_FLAG_MORE_PATCHES, 4, "more contact patches than there is room for, or two along the track that are not resolved") \
  X(WRC_FLAG_TABLE_RANGE, 5, "the patch is more slender than the coefficient tables: their end is used") \
  X(WRC_FLAG_CREEPAGES_LIMITED, 6, "nearly at rest, or sliding far faster than rolling: creepages are limited") \
  X(WRC_FLAG_LOAD_JUMPS, 7, "no approach of this normal method carries the load: its force jumps past it there") \
  X(WRC_FLAG_BEYOND_GAP, 8, "beyond what the gap or the profiles carry: continued with the last stiffness") \
  X(WRC_FLAG_CLIMBING, 9, "friction on a steep face lets no height carry the load, or several")          \
  X(WRC_FLAG_BEYOND_SECTIONS, 10, "the rail has no section that far along the track: the nearest is used") \
  X(WRC_FLAG_DISSIMILAR_MATERIALS, 11, "different materials: of Kalker's K only the leading part is taken, or none: theory manual, section 4") \
  X(WRC_FLAG_SUM_OVERFLOW, 12, "a sum of bins passed its range: what they hold is worthless")              \
  X(WRC_FLAG_FORCE_JUMPS, 13, "a planar normal method on a patch of several lowest points: forces jump where the lowest changes") \
  X(WRC_FLAG_ROTATION_TRANSPOSED, 14, "the angular velocity lies along the axle of the transposed rotation: was its transpose given?") \
  X(WRC_FLAG_MEMORY_DROPPED, 15, "the wheel was put elsewhere since the committed step: it begins without tractions") \
  X(WRC_ERROR_NULL, -1, "a required pointer is NULL")                                                   \
  X(WRC_ERROR_STRUCT_SIZE, -2, "struct_size is wrong, or a member newer than the library is set")            \
  X(WRC_ERROR_NOT_FINITE, -3, "a value is NaN or infinite")                                             \
  X(WRC_ERROR_RANGE, -4, "a value lies outside its allowed range")                                      \
  X(WRC_ERROR_PROFILE, -5, "a profile cannot be used")                                                  \
  X(WRC_ERROR_GAP, -6, "the undeformed gap cannot be used")                                             \
  X(WRC_ERROR_LOAD, -7, "gap or profiles cannot carry the prescribed load or approach")                 \
  X(WRC_ERROR_BUFFER, -8, "the memory handed over is too small or misaligned")                          \
  X(WRC_ERROR_MEMORY, -9, "memory could not be allocated")                                              \
  X(WRC_ERROR_SEQUENCE, -10, "a call came before the one whose result it needs")                        \
  X(WRC_ERROR_UNSUPPORTED, -11, "the requested method, version or combination does not exist")          \
  X(WRC_ERROR_FILE, -12, "a file cannot be read or written")                                            \
  X(WRC_ERROR_CANCELLED, -13, "the caller cancelled the work")                                          \
  X(WRC_ERROR_INTERNAL, -14, "internal error: please report it")

#define WRC_STATUS_ENUM(name, value, text) name = value,
enum wrc_status {
  WRC_STATUS_LIST(WRC_STATUS_ENUM)
  WRC_STATUS_ENUM_END = -1000000 /* no status: ends the list */
};
#undef WRC_STATUS_ENUM

/** The bit of a flag in the `flags` of a result. */
#define WRC_FLAG_BIT(flag) ((uint32_t)1 << (flag))

#endif
