/** @file wrc_profiles.h
 * Pairs of profiles, before and after they run on each other. Where a wheelset touches its track, rolling radius difference, contact
 * angles, equivalent conicity; profiles that wear; measured sections of a turnout, parted into the faces of its rails. Not for
 * real-time use.
 *
 * Conventions are those of wrc.h, which it includes. Everything allocates and is "@rt init". Arrays are the caller's.
 *
 * @par Stability
 * May change in a minor version, with WRC_EXPERIMENTAL_VERSION.
 */
#ifndef WRC_PROFILES_H
#define WRC_PROFILES_H

#include "wrc.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How a conicity is made of a rolling radius difference. Theory manual, "Contact functions and conicity". */
enum wrc_conicity_method {
  WRC_CONICITY_WAVELENGTH = 0, /**< of the cone with the same wavelength: integration of y'' + dr(y) / (e r0) = 0, the
                                    method of UIC 519 and EN 15302 */
  WRC_CONICITY_REGRESSION = 1  /**< half the slope of the straight line fitted to dr over the amplitude, all displacements
                                    weighing alike */
};

/** Lateral displacements and load for contact functions. */
typedef struct wrc_wheelset_geometry_problem {
  uint32_t struct_size;  /**< sizeof this struct, 24 or more */
  uint32_t count;        /**< lateral displacements, 1..100000 [0] */
  const double* lateral; /**< of the wheelset, to the right, `count` of them, -0.1..0.1 m [required] */
  double wheel_load;     /**< vertical, of each wheel, 0 or 1e3..1e6 N; 0: the undeformed bodies touch in one point on
                              either side, as EN 15302 has it, and the functions jump where that point does; a load:
                              elastic, without friction, all contacts weighted by what they carry, continuous; needs
                              WRC_NORMAL_STRIP_HALFSPACE [0] */
} wrc_wheelset_geometry_problem;

/** Contact functions over the lateral displacement: arrays of the caller, `count` elements each; NULL: not wanted; set
 * before the call. Coordinates of profiles are those of wrc_profile, right and left alike. */
typedef struct wrc_wheelset_geometry {
  uint32_t struct_size;      /**< sizeof this struct, 96 or more */
  uint32_t reserved0;        /**< 0 */
  double* vertical;          /**< displacement of the wheelset's middle downwards [m] */
  double* roll;              /**< of the wheelset about the track's x, right wheel down positive [rad] */
  double* radius_difference; /**< rolling radius of the right wheel less that of the left [m] */
  double* radius_right;      /**< rolling radius [m] */
  double* radius_left;       /**< see radius_right */
  double* angle_right;       /**< contact angle against the track's plane, the roll included; positive where the surface
                                  rises towards the flange of the rail's gauge side [rad] */
  double* angle_left;        /**< see angle_right */
  double* y_wheel_right;     /**< contact on the wheel's profile, flange side negative [m] */
  double* y_wheel_left;      /**< see y_wheel_right */
  double* y_rail_right;      /**< contact on the rail's profile, field side positive [m] */
  double* y_rail_left;       /**< see y_rail_right */
} wrc_wheelset_geometry;

/** A rolling radius difference over the lateral displacement, straight between its points, and what to make of it. */
typedef struct wrc_conicity_problem {
  uint32_t struct_size;             /**< sizeof this struct, 56 or more */
  int32_t method;                   /**< enum wrc_conicity_method [WRC_CONICITY_WAVELENGTH] */
  uint32_t count;                   /**< points, 3..100000 [0] */
  uint32_t amplitude_count;         /**< 1..100000 [0] */
  const double* lateral;            /**< of the wheelset, increasing, `count` of them, -0.1..0.1 m [required] */
  const double* radius_difference;  /**< right less left, `count` of them, -0.2..0.2 m [required] */
  const double* amplitudes;         /**< half the way from one side to the other, `amplitude_count` of them, 1e-6..0.1 m
                                         [required] */
  double contact_distance;          /**< e: between the contact points of both wheels, 0.3..3 m [1.5] */
  double radius;                    /**< r0: nominal, of the wheels, 0.05..3 m [0.46] */
} wrc_conicity_problem;

/** Equivalent conicity over the amplitude: arrays of the caller, `amplitude_count` elements each; NULL: not wanted; set before
 * the call. */
typedef struct wrc_conicity {
  uint32_t struct_size; /**< sizeof this struct, 32 or more */
  uint32_t reserved0;   /**< 0 */
  double* conicity;     /**< tan gamma_e [-]; 0 where a wheelset left to itself does not swing with this amplitude */
  double* wavelength;   /**< of the kinematic motion [m]: by Klingel's formula from the conicity of a regression; 0 where
                             there is none */
  double* centre;       /**< middle between the two ends of the motion [m] */
} wrc_conicity;

/** Wear of a profile, to be taken off. */
typedef struct wrc_profile_wear {
  uint32_t struct_size;  /**< sizeof this struct, 88 or more */
  int32_t body;          /**< enum wrc_body: which side of the curve is steel [WRC_BODY_WHEEL] */
  uint32_t count;        /**< points, 4..20000 [0] */
  uint32_t bin_count;    /**< bins of the depth, 1..1000000 [0] */
  const double* y;       /**< points as in wrc_profile, `count` of them, -1..1 m [required] */
  const double* z;       /**< see y */
  const double* depth;   /**< along the normal, of each bin for one passage, `bin_count` of them, 0..0.1 m [required] */
  double first;          /**< arc length at which the first bin begins, 0 at y = 0, -1..1 m [0] */
  double width;          /**< of a bin, 1e-5..1 m [1e-3] */
  double passages;       /**< wanted, 0..1e12 [1] */
  double largest_depth;  /**< most that is taken off in one step, 1e-9..1e-2 m [1e-4] */
  double smoothing;      /**< waves of the depth of this length along the curve keep half their height, 0..0.05 m; 0: as it
                              is [5e-3] */
  double spacing;        /**< of the new points along the curve, 5e-5..5e-3 m [5e-4] */
} wrc_profile_wear;

/** A worn profile: arrays of the caller, set before the call. */
typedef struct wrc_worn_profile {
  uint32_t struct_size; /**< sizeof this struct, 56 or more */
  uint32_t capacity;    /**< points there is room for; set before the call */
  uint32_t count;       /**< points */
  uint32_t reserved0;   /**< 0 */
  double* y;            /**< `capacity` of the caller [m]; set before the call */
  double* z;            /**< see y */
  double passages;      /**< that were taken off: those wanted, or as many as largest_depth allows [-] */
  double depth;         /**< largest that was taken off [m] */
  double area;          /**< taken off the section [m^2] */
} wrc_worn_profile;

/** Dimensions of a wheel's flange as gauges have them, EN 15313; datum: the tread at y = 0. */
typedef struct wrc_flange {
  double height;    /**< Sh: the tip below the datum [m] */
  double thickness; /**< Sd: from the flange back to the face 10 mm below the datum [m] */
  double slope;     /**< qR: along y from there to the point of the face 2 mm above the tip [m] */
  double reserved[3]; /**< 0 */
} wrc_flange;

/** Kind of a face, by its place beside the others. */
enum wrc_face_kind {
  WRC_FACE_RAIL = 0,  /**< nothing lies beside it */
  WRC_FACE_STOCK = 1, /**< stock rail: a blade lies beside it */
  WRC_FACE_BLADE = 2, /**< begins or ends against the face on its field side */
  WRC_FACE_WING = 3,  /**< wing rail: a nose lies beside it */
  WRC_FACE_NOSE = 4,  /**< begins or ends low, beside a flangeway */
  WRC_FACE_CHECK = 5  /**< check rail: as high as the face on its field side, all along */
};

/** One measured line across a rail, from the gauge side to the field side, with gaps. Its points need no equal distances. */
typedef struct wrc_section_line {
  double distance;    /**< along the track [m] */
  uint32_t count;     /**< points, 4 or more */
  uint32_t reserved0; /**< 0 */
  const double* y;    /**< `count` of them, to the field side [m]; NaN where nothing was measured [required] */
  const double* z;    /**< `count` of them, downwards, 0 at the rail's top [m]; NaN with y [required] */
  double reserved[4]; /**< 0 */
} wrc_section_line;

/** Measured sections of a rail that changes along the track, and how they are parted into faces. */
typedef struct wrc_rail_faces_problem {
  uint32_t struct_size;   /**< sizeof this struct, 88 or more */
  uint32_t section_count; /**< 2..100000 [0] */
  const wrc_section_line* sections; /**< `section_count` of them, by increasing distance [required] */
  uint32_t interruption_count; /**< 0..1000 [0] */
  uint32_t reserved0;          /**< 0 */
  const double* interruptions; /**< `interruption_count` of them: places between two sections that no face passes, the gap of a
                                    joint, -1e7..1e7 m [required] */
  double first;       /**< beginning of the wanted part of the track; one section before it is kept, too, -1e7..1e7 m [-1e7] */
  double last;        /**< its end; one section beyond is kept, too, -1e7..1e7 m [1e7] */
  double depth;       /**< depth below z = 0 beyond which points belong to no face, as the bottom of a flangeway, 1e-3..0.2 m [0.03] */
  double gap;         /**< distance from one point to the next at which a line is parted, 1e-4..0.1 m [5e-3] */
  double kink;        /**< turn at a concave corner above which a line is parted: a blade at its stock rail, 0.1..3 rad [0.7] */
  double least_width; /**< least width of a face; narrower pieces are left out, 1e-3..0.05 m [3e-3] */
  double tolerance;   /**< distance of a section from the mean of its neighbours, above which `thin` names it, 1e-6..0.05 m [2e-4] */
} wrc_rail_faces_problem;

/** Faces of a rail. Data behind its pointers belong to the handle and end with it. */
typedef struct wrc_found_faces {
  uint32_t struct_size;        /**< sizeof this struct, 48 or more */
  uint32_t face_count;         /**< faces */
  uint32_t outline_count;      /**< outlines of all faces, for wrc_rail_faces_outline() */
  uint32_t rail_section_count; /**< for config.rail_section_count, which takes 1000 at most */
  uint32_t rail_section_size;  /**< sizeof(wrc_rail_section), for config.rail_section_size */
  uint32_t reserved0;          /**< 0 */
  const wrc_rail_section* rail_sections; /**< for config.rail_sections, without check rails */
  const char* notes;           /**< pieces that were left out or joined: sentences, each with its end of line */
  const char* thin;            /**< places where sections are too far apart, or more faces than a model holds; as notes */
} wrc_found_faces;

/** A face in one of the measured sections. Its arrays belong to the handle and end with it. */
typedef struct wrc_face_outline {
  uint32_t struct_size;  /**< sizeof this struct, 64 or more */
  int32_t kind;          /**< enum wrc_face_kind: of its face */
  uint32_t face;         /**< its face, counted from 0 from the gauge side; outlines of one stand side by side */
  uint32_t number;       /**< the measured section, counted from 0 */
  uint32_t count;        /**< points */
  uint32_t mark_count;   /**< number of marks, equal in all outlines of a face */
  double distance;       /**< along the track [m] */
  double spacing_error;  /**< distance from the mean of its neighbours, along the normal; 0 of the first and last [m] */
  const double* y;       /**< `count` of them [m] */
  const double* z;       /**< `count` of them [m] */
  const double* marks;   /**< `mark_count` of them: y of the corners that belong together [m] */
} wrc_face_outline;

/** Faces that wrc_rail_faces_create() found. */
typedef struct wrc_rail_faces wrc_rail_faces;

/** Sections that wrc_section_file_read() read. */
typedef struct wrc_section_file wrc_section_file;

/** @name Defaults
 * As in wrc.h.
 * @rt hard @thread free
 * @{ */
WRC_API int32_t wrc_conicity_problem_init(wrc_conicity_problem* problem); /**< Defaults: problem. */
WRC_API int32_t wrc_profile_wear_init(wrc_profile_wear* wear); /**< Defaults: wear. */
WRC_API int32_t wrc_rail_faces_problem_init(wrc_rail_faces_problem* problem); /**< Defaults: problem. */
/** @cond */
WRC_DEFAULT_SIZED(wrc_conicity_problem)
WRC_DEFAULT_SIZED(wrc_profile_wear)
WRC_DEFAULT_SIZED(wrc_rail_faces_problem)
/** @endcond */
/** @} */

/** Where a wheelset without yaw touches both rails, over its lateral displacement: its roll and height follow from contact
 * on both sides. EN 15302. Theory manual, "Contact functions and conicity".
 * @param model with profiles
 * @param problem lateral displacements, and the load
 * @param[in,out] functions results; its arrays say which; left zero on failure
 * @param[out] text what went wrong, as wrc_contact_last_error writes it; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_FLAG_ITERATION_CAP; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _NOT_FINITE, _MEMORY; _SEQUENCE (model without
 * profiles); _UNSUPPORTED (a load, and a model of another normal method); _GAP (no rail below a wheel at one of the
 * displacements); _LOAD (the same under load).
 * @rt init @thread free */
WRC_API int32_t wrc_profile_wheelset_geometry(const wrc_model* model, const wrc_wheelset_geometry_problem* problem,
                                              wrc_wheelset_geometry* functions, char* text, uint64_t size);

/** Equivalent conicity of a rolling radius difference over amplitudes. UIC 519, EN 15302; Klingel's wavelength
 * 2 pi sqrt(e r0 / (2 tan gamma)). Theory manual, "Contact functions and conicity".
 * @param problem rolling radius difference and amplitudes
 * @param[in,out] conicity results; its arrays say which; left zero on failure
 * @param[out] text what went wrong, as wrc_contact_last_error writes it; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE (also: displacements that do not increase, an amplitude that the
 * displacements do not hold), _NOT_FINITE, _MEMORY.
 * @rt init @thread free */
WRC_API int32_t wrc_equivalent_conicity(const wrc_conicity_problem* problem, wrc_conicity* conicity, char* text,
                                        uint64_t size);

/** Takes wear off a profile along its normals: depth smoothed, points moved and laid anew at equal spacing. As many passages
 * as are wanted, or as `largest_depth` allows; the next step then begins with contacts of the worn profile. Its points go
 * straight into a wrc_profile; those of a rail into a model of WRC_PLACEMENT_ORIGIN, whose rails stay where they were. Theory
 * manual, "Profiles that wear".
 * @param wear profile and depths
 * @param[in,out] worn the worn profile; its arrays say where
 * @param[out] text what went wrong, as wrc_contact_last_error writes it; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _NOT_FINITE, _PROFILE (points that are no profile, a worn one that
 * crosses itself), _BUFFER (more points than there is room for), _MEMORY.
 * @rt init @thread free */
WRC_API int32_t wrc_profile_remove_wear(const wrc_profile_wear* wear, wrc_worn_profile* worn, char* text, uint64_t size);

/** Flange dimensions of a wheel's profile.
 * @param count points, 4..20000
 * @param y points as in wrc_profile, `count`
 * @param z see y
 * @param flange_back_to_origin along y from the flange's back to y = 0, 0.01..0.2 m; 0.07 of most wheels
 * @param[out] flange the dimensions; zero on failure
 * @param[out] text what went wrong, as wrc_contact_last_error writes it; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE, _PROFILE (no profile, or no flange of 12 mm), _MEMORY.
 * @rt init @thread free */
WRC_API int32_t wrc_flange_dimensions(uint32_t count, const double* y, const double* z, double flange_back_to_origin,
                                      wrc_flange* flange, char* text, uint64_t size);

/** @name Sections of a turnout
 *
 * A line is parted where it lies deep, over gaps without points, and at concave corners. A face goes on with the piece of the next
 * section that lies over it. Where a piece is a fifth wider, a rail joins or leaves: one face ends, another begins. Steep sides end
 * equally deep in all sections of a face, and its corners at 45 degrees are marks. docs/python.md, "Sections of a turnout".
 * @{ */

/** Parts measured sections into the faces that a wheel may roll on, and follows these along the track.
 * @param problem sections, and the limits by which they are parted; only read during the call
 * @param[out] faces to be released with wrc_rail_faces_destroy(); NULL on failure
 * @param[out] text the sentence of a failure, with the section's number and distance; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _NOT_FINITE, _MEMORY; _PROFILE (a section that is out of order,
 * in another unit or upside down, crosses itself or overhangs).
 * @rt init @thread free */
WRC_API int32_t wrc_rail_faces_create(const wrc_rail_faces_problem* problem, wrc_rail_faces** faces, char* text, uint64_t size);

/** Number of faces and outlines, sections for a model, notes.
 * @param faces of wrc_rail_faces_create()
 * @param[out] found results
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE.
 * @rt init @thread free */
WRC_API int32_t wrc_rail_faces_found(const wrc_rail_faces* faces, wrc_found_faces* found);

/** Outline of a face in one of the measured sections.
 * @param faces of wrc_rail_faces_create()
 * @param index 0..outline_count - 1
 * @param[out] outline results
 * @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE.
 * @rt init @thread free */
WRC_API int32_t wrc_rail_faces_outline(const wrc_rail_faces* faces, uint32_t index, wrc_face_outline* outline);

/** Frees what wrc_rail_faces_create() made; NULL is ignored. Models made of its sections go on. @param faces the faces
 * @rt init @thread free */
WRC_API void wrc_rail_faces_destroy(wrc_rail_faces* faces);

/** Reads measured sections. The file's ending and content tell its format:
 *  - .slcs, slices of CONTACT: distances, each with a file of points: .prr of Simpack, .ban of MiniProf, or columns y, z;
 *  - columns x, y, z: one point in a line, the points of a section together;
 *  - columns number, distance, in a table named SectionPositionNAME.txt: the points of section 7 are in NAME_7.txt, beside it or in a
 *    folder NAME.
 * Distances are in the unit that .slcs states, in that of the points for columns x, y, z, and in m in the table.
 * @param path the file
 * @param unit of the points, 1e-6..1 m; 0: mm or m, whichever fits
 * @param mirror_y 1: change the sign of y, as the gauge side must be at y < 0; 0: keep it
 * @param mirror_z 1: change the sign of z, as it must point down; 0: keep it
 * @param[out] file to be released with wrc_section_file_destroy(); NULL on failure
 * @param[out] text the sentence of a failure, with the line; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _NOT_FINITE, _FILE, _MEMORY.
 * @rt init @thread free */
WRC_API int32_t wrc_section_file_read(const char* path, double unit, int32_t mirror_y, int32_t mirror_z, wrc_section_file** file,
                                      char* text, uint64_t size);

/** One of the sections. Its arrays belong to the handle and end with it.
 * @param file of wrc_section_file_read()
 * @param index from 0
 * @param[out] line the section; zero on failure
 * @return WRC_OK; WRC_ERROR_NULL; _RANGE (there are no more).
 * @rt init @thread free */
WRC_API int32_t wrc_section_file_line(const wrc_section_file* file, uint32_t index, wrc_section_line* line);

/** Frees what wrc_section_file_read() made; NULL is ignored. @param file the sections
 * @rt init @thread free */
WRC_API void wrc_section_file_destroy(wrc_section_file* file);

/** Writes sections. A path that ends in .slcs gets slices of CONTACT, with their points [mm] in NAME_1.txt and so on beside it,
 * without gaps. Any other path gets columns x, y, z [m].
 * @param path the file
 * @param lines the sections, count of them
 * @param count number of sections, 1..100000
 * @param[out] text the sentence of a failure; NULL: not wanted
 * @param size bytes of text
 * @return WRC_OK; WRC_ERROR_NULL, _RANGE, _FILE, _MEMORY.
 * @rt init @thread free */
WRC_API int32_t wrc_section_file_write(const char* path, const wrc_section_line* lines, uint32_t count, char* text, uint64_t size);
/** @} */

#ifdef __cplusplus
}
#endif

#endif /* WRC_PROFILES_H */
