/// Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit.
/// What every member of every struct may be, and what it is by default.
#pragma once

// clang-format off
#include "abi/member.hpp"
#include "wrc/wrc_offline.h"
#include "wrc/wrc_profiles.h"
#include "wrc/wrc_surface.h"

namespace wrc::abi {

namespace enumerations {

inline constexpr Enumerator wrc_normal_method_values[] = {
    {"WRC_NORMAL_HERTZ", WRC_NORMAL_HERTZ},
    {"WRC_NORMAL_KIK_PIOTROWSKI", WRC_NORMAL_KIK_PIOTROWSKI},
    {"WRC_NORMAL_EKP", WRC_NORMAL_EKP},
    {"WRC_NORMAL_EKP_ELLIPSE", WRC_NORMAL_EKP_ELLIPSE},
    {"WRC_NORMAL_ANALYN", WRC_NORMAL_ANALYN},
    {"WRC_NORMAL_STRIPES", WRC_NORMAL_STRIPES},
    {"WRC_NORMAL_STRIP_HALFSPACE", WRC_NORMAL_STRIP_HALFSPACE},
};
inline constexpr Enumeration wrc_normal_method{wrc_normal_method_values, 7,
    "see enum wrc_normal_method: WRC_NORMAL_HERTZ (0), _KIK_PIOTROWSKI (1), _EKP (2), _EKP_ELLIPSE (3), _ANALYN (4), _STRIPES (5), _STRIP_HALFSPACE (6)"};

inline constexpr Enumerator wrc_tangential_method_values[] = {
    {"WRC_TANGENTIAL_FASTSIM", WRC_TANGENTIAL_FASTSIM},
    {"WRC_TANGENTIAL_FASTRIP", WRC_TANGENTIAL_FASTRIP},
    {"WRC_TANGENTIAL_STRIP_FASTSIM", WRC_TANGENTIAL_STRIP_FASTSIM},
    {"WRC_TANGENTIAL_FORCE_TABLE", WRC_TANGENTIAL_FORCE_TABLE},
    {"WRC_TANGENTIAL_POLACH", WRC_TANGENTIAL_POLACH},
};
inline constexpr Enumeration wrc_tangential_method{wrc_tangential_method_values, 5,
    "see enum wrc_tangential_method: WRC_TANGENTIAL_FASTSIM (0), _FASTRIP (1), _STRIP_FASTSIM (2), _FORCE_TABLE (3), _POLACH (4)"};

inline constexpr Enumerator wrc_patch_model_values[] = {
    {"WRC_PATCH_MODEL_PATCH_SDEC", WRC_PATCH_MODEL_PATCH_SDEC},
    {"WRC_PATCH_MODEL_PATCH_ELLIPSE", WRC_PATCH_MODEL_PATCH_ELLIPSE},
    {"WRC_PATCH_MODEL_ELLIPSE_AT_MIDDLE", WRC_PATCH_MODEL_ELLIPSE_AT_MIDDLE},
    {"WRC_PATCH_MODEL_ELLIPSE_AT_POINT", WRC_PATCH_MODEL_ELLIPSE_AT_POINT},
};
inline constexpr Enumeration wrc_patch_model{wrc_patch_model_values, 4,
    "see enum wrc_patch_model: WRC_PATCH_MODEL_PATCH_SDEC (0), _PATCH_ELLIPSE (1), _ELLIPSE_AT_MIDDLE (2), _ELLIPSE_AT_POINT (3)"};

inline constexpr Enumerator wrc_regularisation_values[] = {
    {"WRC_REGULARISE_KEEP_WIDTH", WRC_REGULARISE_KEEP_WIDTH},
    {"WRC_REGULARISE_KEEP_RATIO", WRC_REGULARISE_KEEP_RATIO},
};
inline constexpr Enumeration wrc_regularisation{wrc_regularisation_values, 2,
    "see enum wrc_regularisation: WRC_REGULARISE_KEEP_WIDTH (0), _RATIO (1)"};

inline constexpr Enumerator wrc_traction_bound_values[] = {
    {"WRC_BOUND_PARABOLIC", WRC_BOUND_PARABOLIC},
    {"WRC_BOUND_ELLIPTIC", WRC_BOUND_ELLIPTIC},
    {"WRC_BOUND_ELLIPSOIDAL", WRC_BOUND_ELLIPSOIDAL},
};
inline constexpr Enumeration wrc_traction_bound{wrc_traction_bound_values, 3,
    "see enum wrc_traction_bound: WRC_BOUND_PARABOLIC (0), _ELLIPTIC (1), _ELLIPSOIDAL (2)"};

inline constexpr Enumerator wrc_flexibility_values[] = {
    {"WRC_FLEXIBILITY_SEPARATE", WRC_FLEXIBILITY_SEPARATE},
    {"WRC_FLEXIBILITY_SINGLE", WRC_FLEXIBILITY_SINGLE},
    {"WRC_FLEXIBILITY_BLENDED", WRC_FLEXIBILITY_BLENDED},
};
inline constexpr Enumeration wrc_flexibility{wrc_flexibility_values, 3,
    "see enum wrc_flexibility: WRC_FLEXIBILITY_SEPARATE (0), _SINGLE (1), _BLENDED (2)"};

inline constexpr Enumerator wrc_side_values[] = {
    {"WRC_SIDE_RIGHT", WRC_SIDE_RIGHT},
    {"WRC_SIDE_LEFT", WRC_SIDE_LEFT},
};
inline constexpr Enumeration wrc_side{wrc_side_values, 2,
    "see enum wrc_side: WRC_SIDE_RIGHT (0), _LEFT (1)"};

inline constexpr Enumerator wrc_body_values[] = {
    {"WRC_BODY_WHEEL", WRC_BODY_WHEEL},
    {"WRC_BODY_RAIL", WRC_BODY_RAIL},
};
inline constexpr Enumeration wrc_body{wrc_body_values, 2,
    "see enum wrc_body: WRC_BODY_WHEEL (0), _RAIL (1)"};

inline constexpr Enumerator wrc_profile_kind_values[] = {
    {"WRC_PROFILE_NONE", WRC_PROFILE_NONE},
    {"WRC_PROFILE_POINTS", WRC_PROFILE_POINTS},
    {"WRC_PROFILE_S1002", WRC_PROFILE_S1002},
    {"WRC_PROFILE_60E1", WRC_PROFILE_60E1},
    {"WRC_PROFILE_UIC60_BENCHMARK", WRC_PROFILE_UIC60_BENCHMARK},
};
inline constexpr Enumeration wrc_profile_kind{wrc_profile_kind_values, 5,
    "see enum wrc_profile_kind: WRC_PROFILE_NONE (0), _POINTS (1), _S1002 (2), _60E1 (3), _UIC60_BENCHMARK (4)"};

inline constexpr Enumerator wrc_profile_placement_values[] = {
    {"WRC_PLACEMENT_GAUGE", WRC_PLACEMENT_GAUGE},
    {"WRC_PLACEMENT_ORIGIN", WRC_PLACEMENT_ORIGIN},
};
inline constexpr Enumeration wrc_profile_placement{wrc_profile_placement_values, 2,
    "see enum wrc_profile_placement: WRC_PLACEMENT_GAUGE (0), _ORIGIN (1)"};

inline constexpr Enumerator wrc_instruction_set_values[] = {
    {"WRC_INSTRUCTIONS_BEST", WRC_INSTRUCTIONS_BEST},
    {"WRC_INSTRUCTIONS_BASELINE", WRC_INSTRUCTIONS_BASELINE},
    {"WRC_INSTRUCTIONS_AVX2", WRC_INSTRUCTIONS_AVX2},
    {"WRC_INSTRUCTIONS_AVX512", WRC_INSTRUCTIONS_AVX512},
};
inline constexpr Enumeration wrc_instruction_set{wrc_instruction_set_values, 4,
    "see enum wrc_instruction_set: WRC_INSTRUCTIONS_BEST (0), _BASELINE (1), _AVX2 (2), _AVX512 (3)"};

inline constexpr Enumerator wrc_friction_speed_law_values[] = {
    {"WRC_SPEED_LAW_NONE", WRC_SPEED_LAW_NONE},
    {"WRC_SPEED_LAW_EXPONENTIAL", WRC_SPEED_LAW_EXPONENTIAL},
    {"WRC_SPEED_LAW_HYPERBOLIC", WRC_SPEED_LAW_HYPERBOLIC},
};
inline constexpr Enumeration wrc_friction_speed_law{wrc_friction_speed_law_values, 3,
    "see enum wrc_friction_speed_law: WRC_SPEED_LAW_NONE (0), _EXPONENTIAL (1), _HYPERBOLIC (2)"};

inline constexpr Enumerator wrc_friction_temperature_law_values[] = {
    {"WRC_TEMPERATURE_LAW_NONE", WRC_TEMPERATURE_LAW_NONE},
    {"WRC_TEMPERATURE_LAW_LINEAR", WRC_TEMPERATURE_LAW_LINEAR},
};
inline constexpr Enumeration wrc_friction_temperature_law{wrc_friction_temperature_law_values, 2,
    "see enum wrc_friction_temperature_law: WRC_TEMPERATURE_LAW_NONE (0), _LINEAR (1)"};

inline constexpr Enumerator wrc_zone_frame_values[] = {
    {"WRC_ZONES_CONTACT_FRAME", WRC_ZONES_CONTACT_FRAME},
    {"WRC_ZONES_RAIL_PROFILE", WRC_ZONES_RAIL_PROFILE},
    {"WRC_ZONES_WHEEL_PROFILE", WRC_ZONES_WHEEL_PROFILE},
};
inline constexpr Enumeration wrc_zone_frame{wrc_zone_frame_values, 3,
    "see enum wrc_zone_frame: WRC_ZONES_CONTACT_FRAME (0), _RAIL_PROFILE (1), _WHEEL_PROFILE (2)"};

inline constexpr Enumerator wrc_wheel_reference_values[] = {
    {"WRC_REFERENCE_WHEELSET", WRC_REFERENCE_WHEELSET},
    {"WRC_REFERENCE_WHEEL", WRC_REFERENCE_WHEEL},
};
inline constexpr Enumeration wrc_wheel_reference{wrc_wheel_reference_values, 2,
    "see enum wrc_wheel_reference: WRC_REFERENCE_WHEELSET (0), _WHEEL (1)"};

inline constexpr Enumerator wrc_orientation_values[] = {
    {"WRC_ORIENTATION_ANGLES", WRC_ORIENTATION_ANGLES},
    {"WRC_ORIENTATION_ROWS", WRC_ORIENTATION_ROWS},
    {"WRC_ORIENTATION_COLUMNS", WRC_ORIENTATION_COLUMNS},
};
inline constexpr Enumeration wrc_orientation{wrc_orientation_values, 3,
    "see enum wrc_orientation: WRC_ORIENTATION_ANGLES (0), _ROWS (1), _COLUMNS (2)"};

inline constexpr Enumerator wrc_axes_values[] = {
    {"WRC_AXES_NONE", WRC_AXES_NONE},
    {"WRC_AXES_TRACK", WRC_AXES_TRACK},
    {"WRC_AXES_BODY", WRC_AXES_BODY},
};
inline constexpr Enumeration wrc_axes{wrc_axes_values, 3,
    "see enum wrc_axes: WRC_AXES_NONE (0), _TRACK (1), _BODY (2)"};

inline constexpr Enumerator wrc_prescribed_values[] = {
    {"WRC_PRESCRIBE_HEIGHT", WRC_PRESCRIBE_HEIGHT},
    {"WRC_PRESCRIBE_VERTICAL_LOAD", WRC_PRESCRIBE_VERTICAL_LOAD},
    {"WRC_PRESCRIBE_NORMAL_FORCE", WRC_PRESCRIBE_NORMAL_FORCE},
    {"WRC_PRESCRIBE_APPROACH", WRC_PRESCRIBE_APPROACH},
};
inline constexpr Enumeration wrc_prescribed{wrc_prescribed_values, 4,
    "see enum wrc_prescribed: WRC_PRESCRIBE_HEIGHT (0), _VERTICAL_LOAD (1), _NORMAL_FORCE (2), _APPROACH (3)"};

inline constexpr Enumerator wrc_start_values[] = {
    {"WRC_START_COLD", WRC_START_COLD},
    {"WRC_START_WARM", WRC_START_WARM},
    {"WRC_START_MARK", WRC_START_MARK},
};
inline constexpr Enumeration wrc_start{wrc_start_values, 3,
    "see enum wrc_start: WRC_START_COLD (0), _WARM (1), _MARK (2)"};

inline constexpr Enumerator wrc_available_values[] = {
    {"WRC_AVAILABLE_TRACTIONS", WRC_AVAILABLE_TRACTIONS},
    {"WRC_AVAILABLE_PLACE", WRC_AVAILABLE_PLACE},
};
inline constexpr Enumeration wrc_available{wrc_available_values, 2,
    "see enum wrc_available: WRC_AVAILABLE_TRACTIONS (1), _PLACE (2)"};

inline constexpr Enumerator wrc_field_values[] = {
    {"WRC_FIELD_X", WRC_FIELD_X},
    {"WRC_FIELD_PRESSURE", WRC_FIELD_PRESSURE},
    {"WRC_FIELD_TRACTION_X", WRC_FIELD_TRACTION_X},
    {"WRC_FIELD_TRACTION_Y", WRC_FIELD_TRACTION_Y},
    {"WRC_FIELD_SLIP_X", WRC_FIELD_SLIP_X},
    {"WRC_FIELD_SLIP_Y", WRC_FIELD_SLIP_Y},
    {"WRC_FIELD_POWER_DENSITY", WRC_FIELD_POWER_DENSITY},
    {"WRC_FIELD_FATIGUE_INDEX", WRC_FIELD_FATIGUE_INDEX},
    {"WRC_FIELD_TEMPERATURE_RISE", WRC_FIELD_TEMPERATURE_RISE},
    {"WRC_FIELD_STRIP_Y", WRC_FIELD_STRIP_Y},
    {"WRC_FIELD_STRIP_WIDTH", WRC_FIELD_STRIP_WIDTH},
    {"WRC_FIELD_STRIP_CENTRE", WRC_FIELD_STRIP_CENTRE},
    {"WRC_FIELD_STRIP_HALF_LENGTH", WRC_FIELD_STRIP_HALF_LENGTH},
    {"WRC_FIELD_STRIP_PEAK", WRC_FIELD_STRIP_PEAK},
    {"WRC_FIELD_STRIP_POWER", WRC_FIELD_STRIP_POWER},
    {"WRC_FIELD_STRIP_FRICTION", WRC_FIELD_STRIP_FRICTION},
    {"WRC_FIELD_STRIP_WEAR", WRC_FIELD_STRIP_WEAR},
    {"WRC_FIELD_STRIP_PROFILE_Y", WRC_FIELD_STRIP_PROFILE_Y},
    {"WRC_FIELD_STRIP_PROFILE_Z", WRC_FIELD_STRIP_PROFILE_Z},
    {"WRC_FIELD_STRIP_ANGLE", WRC_FIELD_STRIP_ANGLE},
    {"WRC_FIELD_GAP_Y", WRC_FIELD_GAP_Y},
    {"WRC_FIELD_GAP_HEIGHT", WRC_FIELD_GAP_HEIGHT},
    {"WRC_FIELD_GAP_CENTRE", WRC_FIELD_GAP_CENTRE},
    {"WRC_FIELD_GAP_CURVATURE", WRC_FIELD_GAP_CURVATURE},
};
inline constexpr Enumeration wrc_field{wrc_field_values, 24,
    "see enum wrc_field: WRC_FIELD_X (0), _PRESSURE (1), _TRACTION_X (2), _TRACTION_Y (3), _SLIP_X (4), _SLIP_Y (5), _POWER_DENSITY (6), _FATIGUE_INDEX (7), _TEMPERATURE_RISE (8), _STRIP_Y (9), _STRIP_WIDTH (10), _STRIP_CENTRE (11), _STRIP_HALF_LENGTH (12), _STRIP_PEAK (13), _STRIP_POWER (14), _STRIP_FRICTION (15), _STRIP_WEAR (16), _STRIP_PROFILE_Y (17), _STRIP_PROFILE_Z (18), _STRIP_ANGLE (19), _GAP_Y (20), _GAP_HEIGHT (21), _GAP_CENTRE (22), _GAP_CURVATURE (23)"};

inline constexpr Enumerator wrc_wrench_input_values[] = {
    {"WRC_BY_Y", WRC_BY_Y},
    {"WRC_BY_Z", WRC_BY_Z},
    {"WRC_BY_ROLL", WRC_BY_ROLL},
    {"WRC_BY_YAW", WRC_BY_YAW},
    {"WRC_BY_VELOCITY_X", WRC_BY_VELOCITY_X},
    {"WRC_BY_VELOCITY_Y", WRC_BY_VELOCITY_Y},
    {"WRC_BY_VELOCITY_Z", WRC_BY_VELOCITY_Z},
    {"WRC_BY_ANGULAR_VELOCITY_X", WRC_BY_ANGULAR_VELOCITY_X},
    {"WRC_BY_ANGULAR_VELOCITY_Y", WRC_BY_ANGULAR_VELOCITY_Y},
    {"WRC_BY_ANGULAR_VELOCITY_Z", WRC_BY_ANGULAR_VELOCITY_Z},
    {"WRC_BY_RAIL_Y", WRC_BY_RAIL_Y},
    {"WRC_BY_RAIL_Z", WRC_BY_RAIL_Z},
    {"WRC_BY_RAIL_ROLL", WRC_BY_RAIL_ROLL},
    {"WRC_BY_RAIL_Y_VELOCITY", WRC_BY_RAIL_Y_VELOCITY},
    {"WRC_BY_RAIL_Z_VELOCITY", WRC_BY_RAIL_Z_VELOCITY},
    {"WRC_BY_RAIL_ROLL_RATE", WRC_BY_RAIL_ROLL_RATE},
    {"WRC_BY_VERTICAL_LOAD", WRC_BY_VERTICAL_LOAD},
    {"WRC_BY_DISTANCE", WRC_BY_DISTANCE},
    {"WRC_BY_ANGLE", WRC_BY_ANGLE},
    {"WRC_BY_RAIL_Y_SLOPE", WRC_BY_RAIL_Y_SLOPE},
    {"WRC_BY_RAIL_Z_SLOPE", WRC_BY_RAIL_Z_SLOPE},
    {"WRC_BY_ROLLER_RATE", WRC_BY_ROLLER_RATE},
    {"WRC_BY_FRICTION", WRC_BY_FRICTION},
    {"WRC_BY_TIME_STEP", WRC_BY_TIME_STEP},
};
inline constexpr Enumeration wrc_wrench_input{wrc_wrench_input_values, 24,
    "see enum wrc_wrench_input: WRC_BY_Y (0), _Z (1), _ROLL (2), _YAW (3), _VELOCITY_X (4), _VELOCITY_Y (5), _VELOCITY_Z (6), _ANGULAR_VELOCITY_X (7), _ANGULAR_VELOCITY_Y (8), _ANGULAR_VELOCITY_Z (9), _RAIL_Y (10), _RAIL_Z (11), _RAIL_ROLL (12), _RAIL_Y_VELOCITY (13), _RAIL_Z_VELOCITY (14), _RAIL_ROLL_RATE (15), _VERTICAL_LOAD (16), _DISTANCE (17), _ANGLE (18), _RAIL_Y_SLOPE (19), _RAIL_Z_SLOPE (20), _ROLLER_RATE (21), _FRICTION (22), _TIME_STEP (23)"};

inline constexpr Enumerator wrc_damage_quantity_values[] = {
    {"WRC_DAMAGE_WORK", WRC_DAMAGE_WORK},
    {"WRC_DAMAGE_WEAR_T_GAMMA", WRC_DAMAGE_WEAR_T_GAMMA},
    {"WRC_DAMAGE_WEAR_SHEFFIELD", WRC_DAMAGE_WEAR_SHEFFIELD},
    {"WRC_DAMAGE_WEAR_ARCHARD", WRC_DAMAGE_WEAR_ARCHARD},
    {"WRC_DAMAGE_WEAR_POWER", WRC_DAMAGE_WEAR_POWER},
    {"WRC_DAMAGE_WHOLE_LIFE", WRC_DAMAGE_WHOLE_LIFE},
    {"WRC_DAMAGE_SURFACE_FATIGUE", WRC_DAMAGE_SURFACE_FATIGUE},
    {"WRC_DAMAGE_TIME", WRC_DAMAGE_TIME},
    {"WRC_DAMAGE_LARGEST_PRESSURE", WRC_DAMAGE_LARGEST_PRESSURE},
    {"WRC_DAMAGE_LARGEST_TRACTION", WRC_DAMAGE_LARGEST_TRACTION},
};
inline constexpr Enumeration wrc_damage_quantity{wrc_damage_quantity_values, 10,
    "see enum wrc_damage_quantity: WRC_DAMAGE_WORK (0), _WEAR_T_GAMMA (1), _WEAR_SHEFFIELD (2), _WEAR_ARCHARD (3), _WEAR_POWER (4), _WHOLE_LIFE (5), _SURFACE_FATIGUE (6), _TIME (7), _LARGEST_PRESSURE (1000), _LARGEST_TRACTION (1001)"};

inline constexpr Enumerator wrc_adhesion_values[] = {
    {"WRC_ADHESION_COULOMB", WRC_ADHESION_COULOMB},
    {"WRC_ADHESION_FULL", WRC_ADHESION_FULL},
};
inline constexpr Enumeration wrc_adhesion{wrc_adhesion_values, 2,
    "see enum wrc_adhesion: WRC_ADHESION_COULOMB (0), _FULL (1)"};

inline constexpr Enumerator wrc_collocation_values[] = {
    {"WRC_COLLOCATION_QUARTER_POINT", WRC_COLLOCATION_QUARTER_POINT},
    {"WRC_COLLOCATION_REFERENCE", WRC_COLLOCATION_REFERENCE},
};
inline constexpr Enumeration wrc_collocation{wrc_collocation_values, 2,
    "see enum wrc_collocation: WRC_COLLOCATION_QUARTER_POINT (0), _REFERENCE (1)"};

inline constexpr Enumerator wrc_surface_influence_values[] = {
    {"WRC_INFLUENCE_TURNED", WRC_INFLUENCE_TURNED},
    {"WRC_INFLUENCE_PLAIN", WRC_INFLUENCE_PLAIN},
};
inline constexpr Enumeration wrc_surface_influence{wrc_surface_influence_values, 2,
    "see enum wrc_surface_influence: WRC_INFLUENCE_TURNED (0), _PLAIN (1)"};

inline constexpr Enumerator wrc_creep_parameter_values[] = {
    {"WRC_CREEP_COEFFICIENT", WRC_CREEP_COEFFICIENT},
    {"WRC_CREEP_KINETIC_RATIO", WRC_CREEP_KINETIC_RATIO},
    {"WRC_CREEP_FALL_RATE", WRC_CREEP_FALL_RATE},
    {"WRC_CREEP_HALF_SPEED", WRC_CREEP_HALF_SPEED},
    {"WRC_CREEP_SLOPE_REDUCTION", WRC_CREEP_SLOPE_REDUCTION},
    {"WRC_CREEP_ADHESION_REDUCTION", WRC_CREEP_ADHESION_REDUCTION},
    {"WRC_CREEP_SLIP_REDUCTION", WRC_CREEP_SLIP_REDUCTION},
    {"WRC_CREEP_LAYER_THICKNESS", WRC_CREEP_LAYER_THICKNESS},
    {"WRC_CREEP_LAYER_YIELD", WRC_CREEP_LAYER_YIELD},
    {"WRC_CREEP_LAYER_HARDENING", WRC_CREEP_LAYER_HARDENING},
};
inline constexpr Enumeration wrc_creep_parameter{wrc_creep_parameter_values, 10,
    "see enum wrc_creep_parameter: WRC_CREEP_COEFFICIENT (0), _KINETIC_RATIO (1), _FALL_RATE (2), _HALF_SPEED (3), _SLOPE_REDUCTION (4), _ADHESION_REDUCTION (5), _SLIP_REDUCTION (6), _LAYER_THICKNESS (7), _LAYER_YIELD (8), _LAYER_HARDENING (9)"};

inline constexpr Enumerator wrc_scatter_values[] = {
    {"WRC_SCATTER_RELATIVE", WRC_SCATTER_RELATIVE},
    {"WRC_SCATTER_ABSOLUTE", WRC_SCATTER_ABSOLUTE},
};
inline constexpr Enumeration wrc_scatter{wrc_scatter_values, 2,
    "see enum wrc_scatter: WRC_SCATTER_RELATIVE (0), _ABSOLUTE (1)"};

inline constexpr Enumerator wrc_conicity_method_values[] = {
    {"WRC_CONICITY_WAVELENGTH", WRC_CONICITY_WAVELENGTH},
    {"WRC_CONICITY_REGRESSION", WRC_CONICITY_REGRESSION},
};
inline constexpr Enumeration wrc_conicity_method{wrc_conicity_method_values, 2,
    "see enum wrc_conicity_method: WRC_CONICITY_WAVELENGTH (0), _REGRESSION (1)"};

inline constexpr Enumerator wrc_face_kind_values[] = {
    {"WRC_FACE_RAIL", WRC_FACE_RAIL},
    {"WRC_FACE_STOCK", WRC_FACE_STOCK},
    {"WRC_FACE_BLADE", WRC_FACE_BLADE},
    {"WRC_FACE_WING", WRC_FACE_WING},
    {"WRC_FACE_NOSE", WRC_FACE_NOSE},
    {"WRC_FACE_CHECK", WRC_FACE_CHECK},
};
inline constexpr Enumeration wrc_face_kind{wrc_face_kind_values, 6,
    "see enum wrc_face_kind: WRC_FACE_RAIL (0), _STOCK (1), _BLADE (2), _WING (3), _NOSE (4), _CHECK (5)"};

inline constexpr Enumerator wrc_surface_quantity_values[] = {
    {"WRC_SURFACE_WATER", WRC_SURFACE_WATER},
    {"WRC_SURFACE_OXIDE", WRC_SURFACE_OXIDE},
    {"WRC_SURFACE_FILM", WRC_SURFACE_FILM},
    {"WRC_SURFACE_SAND", WRC_SURFACE_SAND},
    {"WRC_SURFACE_LUBRICANT", WRC_SURFACE_LUBRICANT},
    {"WRC_SURFACE_HEAT", WRC_SURFACE_HEAT},
};
inline constexpr Enumeration wrc_surface_quantity{wrc_surface_quantity_values, 6,
    "see enum wrc_surface_quantity: WRC_SURFACE_WATER (0), _OXIDE (1), _FILM (2), _SAND (3), _LUBRICANT (4), _HEAT (5)"};

inline constexpr Enumerator wrc_surface_book_values[] = {
    {"WRC_SURFACE_AMOUNT", WRC_SURFACE_AMOUNT},
    {"WRC_SURFACE_PUT_ON", WRC_SURFACE_PUT_ON},
    {"WRC_SURFACE_REMOVED", WRC_SURFACE_REMOVED},
    {"WRC_SURFACE_SQUEEZED", WRC_SURFACE_SQUEEZED},
    {"WRC_SURFACE_EVAPORATED", WRC_SURFACE_EVAPORATED},
    {"WRC_SURFACE_CARRIED", WRC_SURFACE_CARRIED},
};
inline constexpr Enumeration wrc_surface_book{wrc_surface_book_values, 6,
    "see enum wrc_surface_book: WRC_SURFACE_AMOUNT (0), _PUT_ON (1), _REMOVED (2), _SQUEEZED (3), _EVAPORATED (4), _CARRIED (5)"};

}  // namespace enumerations

template <>
struct Description<wrc_profile> {
  static constexpr const char* name = "wrc_profile";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_profile>(80);
  static constexpr wrc_profile defaults = [] {
    wrc_profile value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "kind", .offset = offsetof(wrc_profile, kind), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_profile_kind},
      {.name = "count", .offset = offsetof(wrc_profile, count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 20000, .too_small = "a spline needs at least four points", .not_set = "was it set? WRC_PROFILE_POINTS needs it, and its default is 0", .asked = offsetof(wrc_profile, kind), .asked_for = WRC_PROFILE_POINTS},
      {.name = "y", .offset = offsetof(wrc_profile, y), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_profile, kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_profile, count)},
      {.name = "z", .offset = offsetof(wrc_profile, z), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_profile, kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_profile, count)},
      {.name = "smoothing", .offset = offsetof(wrc_profile, smoothing), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.05, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "reserved", .offset = offsetof(wrc_profile, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_profile) == 80, "run tools/interface/describe.py");

template <>
struct Description<wrc_material> {
  static constexpr const char* name = "wrc_material";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_material>(64);
  static constexpr wrc_material defaults = [] {
    wrc_material value{};
    value.shear_modulus = 82e9;
    value.poisson = 0.28;
    value.shear_yield = 250e6;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "shear_modulus", .offset = offsetof(wrc_material, shear_modulus), .type = Type::real, .rule = Rule::range, .low = 1e8, .high = 1e12, .unit = "Pa", .too_small = "did you pass MPa or GPa?", .too_large = "steel has 82e9"},
      {.name = "poisson", .offset = offsetof(wrc_material, poisson), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "steel has 0.25 to 0.3", .too_large = "steel has 0.25 to 0.3"},
      {.name = "shear_yield", .offset = offsetof(wrc_material, shear_yield), .type = Type::real, .rule = Rule::range, .low = 1e6, .high = 1e11, .unit = "Pa", .too_small = "did you pass MPa?"},
      {.name = "reserved", .offset = offsetof(wrc_material, reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_material) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_heat_properties> {
  static constexpr const char* name = "wrc_heat_properties";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_heat_properties>(64);
  static constexpr wrc_heat_properties defaults = [] {
    wrc_heat_properties value{};
    value.conductivity = 50;
    value.density = 7850;
    value.specific_heat = 450;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "conductivity", .offset = offsetof(wrc_heat_properties, conductivity), .type = Type::real, .rule = Rule::range, .low = 0.1, .high = 1000, .unit = "W/(m K)", .too_small = "steel has 40 to 55", .too_large = "steel has 40 to 55"},
      {.name = "density", .offset = offsetof(wrc_heat_properties, density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3", .too_small = "did you pass g/cm^3?"},
      {.name = "specific_heat", .offset = offsetof(wrc_heat_properties, specific_heat), .type = Type::real, .rule = Rule::range, .low = 10, .high = 1e5, .unit = "J/(kg K)", .too_small = "did you pass kJ?"},
      {.name = "reserved", .offset = offsetof(wrc_heat_properties, reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_heat_properties) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_config_wheelset> {
  static constexpr const char* name = "wrc_config_wheelset";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_config_wheelset>(64);
  static constexpr wrc_config_wheelset defaults = [] {
    wrc_config_wheelset value{};
    value.wheel_radius = 0.46;
    value.tape_circle_distance = 1.5;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "wheel_radius", .offset = offsetof(wrc_config_wheelset, wheel_radius), .type = Type::real, .rule = Rule::range, .low = 0.1, .high = 1.5, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "tape_circle_distance", .offset = offsetof(wrc_config_wheelset, tape_circle_distance), .type = Type::real, .rule = Rule::range, .low = 0.3, .high = 3, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "reserved", .offset = offsetof(wrc_config_wheelset, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config_wheelset) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_config_track> {
  static constexpr const char* name = "wrc_config_track";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_config_track>(88);
  static constexpr wrc_config_track defaults = [] {
    wrc_config_track value{};
    value.gauge = 1.435;
    value.gauge_depth = 0.014;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "placement", .offset = offsetof(wrc_config_track, placement), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_profile_placement},
      {.name = "reserved0", .offset = offsetof(wrc_config_track, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "gauge", .offset = offsetof(wrc_config_track, gauge), .type = Type::real, .rule = Rule::range, .low = 0.3, .high = 2.5, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "gauge_depth", .offset = offsetof(wrc_config_track, gauge_depth), .type = Type::real, .rule = Rule::range, .low = 0.005, .high = 0.04, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "rail_inclination", .offset = offsetof(wrc_config_track, rail_inclination), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .too_small = "1:40 is 0.025", .too_large = "1:40 is 0.025"},
      {.name = "rail_origin", .offset = offsetof(wrc_config_track, rail_origin), .type = Type::real, .rule = Rule::range, .low = 0.2, .high = 1.5, .unit = "m", .too_large = "did you pass mm, or the distance from rail to rail?", .not_set = "was it set? WRC_PLACEMENT_ORIGIN needs it, and its default is 0", .asked = offsetof(wrc_config_track, placement), .asked_for = WRC_PLACEMENT_ORIGIN, .otherwise = "it is read with WRC_PLACEMENT_ORIGIN only: leave it 0"},
      {.name = "reserved", .offset = offsetof(wrc_config_track, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config_track) == 88, "run tools/interface/describe.py");

template <>
struct Description<wrc_rail_section> {
  static constexpr const char* name = "wrc_rail_section";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_rail_section>(168);
  static constexpr wrc_rail_section defaults = [] {
    wrc_rail_section value{};
    value.profile = Description<wrc_profile>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "distance", .offset = offsetof(wrc_rail_section, distance), .type = Type::real, .rule = Rule::range, .low = -1e7, .high = 1e7, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "y", .offset = offsetof(wrc_rail_section, y), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "z", .offset = offsetof(wrc_rail_section, z), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "surface", .offset = offsetof(wrc_rail_section, surface), .type = Type::int32, .rule = Rule::range, .low = 0, .high = 7},
      {.name = "mark_count", .offset = offsetof(wrc_rail_section, mark_count), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 64},
      {.name = "marks", .offset = offsetof(wrc_rail_section, marks), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.5, .high = 0.5, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_rail_section, mark_count), .state = State::not_zero, .counted_by = offsetof(wrc_rail_section, mark_count)},
      {.name = "profile.kind", .offset = offsetof(wrc_rail_section, profile.kind), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_profile_kind},
      {.name = "profile.count", .offset = offsetof(wrc_rail_section, profile.count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 20000, .too_small = "a spline needs at least four points", .not_set = "was it set? WRC_PROFILE_POINTS needs it, and its default is 0", .asked = offsetof(wrc_rail_section, profile.kind), .asked_for = WRC_PROFILE_POINTS},
      {.name = "profile.y", .offset = offsetof(wrc_rail_section, profile.y), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_rail_section, profile.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_rail_section, profile.count)},
      {.name = "profile.z", .offset = offsetof(wrc_rail_section, profile.z), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_rail_section, profile.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_rail_section, profile.count)},
      {.name = "profile.smoothing", .offset = offsetof(wrc_rail_section, profile.smoothing), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.05, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "profile.reserved", .offset = offsetof(wrc_rail_section, profile.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "reserved", .offset = offsetof(wrc_rail_section, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_rail_section) == 168, "run tools/interface/describe.py");

template <>
struct Description<wrc_config_roundness> {
  static constexpr const char* name = "wrc_config_roundness";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_config_roundness>(80);
  static constexpr wrc_config_roundness defaults = [] {
    wrc_config_roundness value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "angle_count", .offset = offsetof(wrc_config_roundness, angle_count), .type = Type::uint32, .rule = Rule::range, .low = 9, .high = 20000, .or_zero = true},
      {.name = "row_count", .offset = offsetof(wrc_config_roundness, row_count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 16, .not_set = "was it set? angle_count needs it, and its default is 0", .asked = offsetof(wrc_config_roundness, angle_count), .state = State::not_zero, .otherwise = "it is read with angle_count only: leave it 0"},
      {.name = "angles", .offset = offsetof(wrc_config_roundness, angles), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 6.2831854, .unit = "rad", .too_small = "did you pass degrees?", .too_large = "did you pass degrees?", .asked = offsetof(wrc_config_roundness, angle_count), .state = State::not_zero, .counted_by = offsetof(wrc_config_roundness, angle_count)},
      {.name = "y", .offset = offsetof(wrc_config_roundness, y), .type = Type::pointer, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "m", .counted_by = offsetof(wrc_config_roundness, row_count)},
      {.name = "deviations", .offset = offsetof(wrc_config_roundness, deviations), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.005, .high = 0.005, .unit = "m", .asked = offsetof(wrc_config_roundness, angle_count), .state = State::not_zero, .by_caller = true},
      {.name = "reserved", .offset = offsetof(wrc_config_roundness, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config_roundness) == 80, "run tools/interface/describe.py");

template <>
struct Description<wrc_config_check_rail> {
  static constexpr const char* name = "wrc_config_check_rail";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_config_check_rail>(144);
  static constexpr wrc_config_check_rail defaults = [] {
    wrc_config_check_rail value{};
    value.profile = Description<wrc_profile>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "y", .offset = offsetof(wrc_config_check_rail, y), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0, .unit = "m", .too_small = "did you pass mm, or count from the track's middle?", .too_large = "did you pass mm, or count from the track's middle?"},
      {.name = "z", .offset = offsetof(wrc_config_check_rail, z), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "profile.kind", .offset = offsetof(wrc_config_check_rail, profile.kind), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_profile_kind},
      {.name = "profile.count", .offset = offsetof(wrc_config_check_rail, profile.count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 20000, .too_small = "a spline needs at least four points", .not_set = "was it set? WRC_PROFILE_POINTS needs it, and its default is 0", .asked = offsetof(wrc_config_check_rail, profile.kind), .asked_for = WRC_PROFILE_POINTS},
      {.name = "profile.y", .offset = offsetof(wrc_config_check_rail, profile.y), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_config_check_rail, profile.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_config_check_rail, profile.count)},
      {.name = "profile.z", .offset = offsetof(wrc_config_check_rail, profile.z), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_config_check_rail, profile.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_config_check_rail, profile.count)},
      {.name = "profile.smoothing", .offset = offsetof(wrc_config_check_rail, profile.smoothing), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.05, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "profile.reserved", .offset = offsetof(wrc_config_check_rail, profile.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "reserved", .offset = offsetof(wrc_config_check_rail, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config_check_rail) == 144, "run tools/interface/describe.py");

template <>
struct Description<wrc_config_normal> {
  static constexpr const char* name = "wrc_config_normal";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_config_normal>(64);
  static constexpr wrc_config_normal defaults = [] {
    wrc_config_normal value{};
    value.method = WRC_NORMAL_STRIP_HALFSPACE;
    value.max_iterations = 60;
    value.load_tolerance = 1e-10;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "method", .offset = offsetof(wrc_config_normal, method), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_normal_method},
      {.name = "max_iterations", .offset = offsetof(wrc_config_normal, max_iterations), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 1000},
      {.name = "load_tolerance", .offset = offsetof(wrc_config_normal, load_tolerance), .type = Type::real, .rule = Rule::range, .low = 1e-14, .high = 1e-2},
      {.name = "reserved", .offset = offsetof(wrc_config_normal, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config_normal) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_config_tangential> {
  static constexpr const char* name = "wrc_config_tangential";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_config_tangential>(72);
  static constexpr wrc_config_tangential defaults = [] {
    wrc_config_tangential value{};
    value.method = WRC_TANGENTIAL_STRIP_FASTSIM;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "method", .offset = offsetof(wrc_config_tangential, method), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_tangential_method},
      {.name = "patch_model", .offset = offsetof(wrc_config_tangential, patch_model), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_patch_model},
      {.name = "bound", .offset = offsetof(wrc_config_tangential, bound), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_traction_bound},
      {.name = "flexibility", .offset = offsetof(wrc_config_tangential, flexibility), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_flexibility},
      {.name = "force_table", .offset = offsetof(wrc_config_tangential, force_table), .type = Type::pointer, .rule = Rule::none},
      {.name = "reserved", .offset = offsetof(wrc_config_tangential, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config_tangential) == 72, "run tools/interface/describe.py");

template <>
struct Description<wrc_config_surface> {
  static constexpr const char* name = "wrc_config_surface";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_config_surface>(120);
  static constexpr wrc_config_surface defaults = [] {
    wrc_config_surface value{};
    value.cells = 32;
    value.tread_width = 5e-4;
    value.corner_width = 2.5e-4;
    value.tolerance = 1e-5;
    value.max_work = 2e7;
    value.max_iterations = 1e6;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "cells", .offset = offsetof(wrc_config_surface, cells), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 512},
      {.name = "memory", .offset = offsetof(wrc_config_surface, memory), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "tread_width", .offset = offsetof(wrc_config_surface, tread_width), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 2e-3, .unit = "m"},
      {.name = "corner_width", .offset = offsetof(wrc_config_surface, corner_width), .type = Type::real, .rule = Rule::range, .low = 5e-5, .high = 1e-3, .unit = "m"},
      {.name = "tolerance", .offset = offsetof(wrc_config_surface, tolerance), .type = Type::real, .rule = Rule::range, .low = 1e-10, .high = 1e-2},
      {.name = "max_work", .offset = offsetof(wrc_config_surface, max_work), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e9},
      {.name = "max_iterations", .offset = offsetof(wrc_config_surface, max_iterations), .type = Type::real, .rule = Rule::range, .low = 2, .high = 1e6},
      {.name = "reserved", .offset = offsetof(wrc_config_surface, reserved), .type = Type::real, .elements = 9, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config_surface) == 120, "run tools/interface/describe.py");

template <>
struct Description<wrc_config_planar> {
  static constexpr const char* name = "wrc_config_planar";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_config_planar>(104);
  static constexpr wrc_config_planar defaults = [] {
    wrc_config_planar value{};
    value.strips = 60;
    value.cells = 32;
    value.gap_rows = 256;
    value.max_patches = 4;
    value.max_sweeps = 16;
    value.gap_limit = 1e-3;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "strips", .offset = offsetof(wrc_config_planar, strips), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 512, .too_large = "more strips cost time in proportion"},
      {.name = "cells", .offset = offsetof(wrc_config_planar, cells), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 512, .too_large = "more cells cost time in proportion"},
      {.name = "gap_rows", .offset = offsetof(wrc_config_planar, gap_rows), .type = Type::int32, .rule = Rule::range, .low = 8, .high = 4096, .too_small = "the gap is interpolated between rows", .too_large = "the gap is interpolated between rows"},
      {.name = "max_patches", .offset = offsetof(wrc_config_planar, max_patches), .type = Type::int32, .rule = Rule::range, .low = 1, .high = 16, .too_small = "a wheel touches its rail in one to three places", .too_large = "a wheel touches its rail in one to three places"},
      {.name = "max_sweeps", .offset = offsetof(wrc_config_planar, max_sweeps), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 1000},
      {.name = "start", .offset = offsetof(wrc_config_planar, start), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_start},
      {.name = "regularisation", .offset = offsetof(wrc_config_planar, regularisation), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_regularisation},
      {.name = "non_steady", .offset = offsetof(wrc_config_planar, non_steady), .type = Type::int32, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "gap_limit", .offset = offsetof(wrc_config_planar, gap_limit), .type = Type::real, .rule = Rule::range, .low = 1e-5, .high = 0.02, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "reserved", .offset = offsetof(wrc_config_planar, reserved), .type = Type::real, .elements = 8, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config_planar) == 104, "run tools/interface/describe.py");

template <>
struct Description<wrc_config> {
  static constexpr const char* name = "wrc_config";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_config>(1184);
  static constexpr wrc_config defaults = [] {
    wrc_config value{};
    value.struct_size = sizeof value;
    value.wheel = Description<wrc_profile>::defaults;
    value.rail = Description<wrc_profile>::defaults;
    value.wheel_material = Description<wrc_material>::defaults;
    value.rail_material = Description<wrc_material>::defaults;
    value.wheel_heat = Description<wrc_heat_properties>::defaults;
    value.rail_heat = Description<wrc_heat_properties>::defaults;
    value.wheelset = Description<wrc_config_wheelset>::defaults;
    value.track = Description<wrc_config_track>::defaults;
    value.normal = Description<wrc_config_normal>::defaults;
    value.tangential = Description<wrc_config_tangential>::defaults;
    value.surface = Description<wrc_config_surface>::defaults;
    value.planar = Description<wrc_config_planar>::defaults;
    value.roundness = Description<wrc_config_roundness>::defaults;
    value.check_rail = Description<wrc_config_check_rail>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_config, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "instruction_set", .offset = offsetof(wrc_config, instruction_set), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_instruction_set},
      {.name = "wheel.kind", .offset = offsetof(wrc_config, wheel.kind), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_profile_kind},
      {.name = "wheel.count", .offset = offsetof(wrc_config, wheel.count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 20000, .too_small = "a spline needs at least four points", .not_set = "was it set? WRC_PROFILE_POINTS needs it, and its default is 0", .asked = offsetof(wrc_config, wheel.kind), .asked_for = WRC_PROFILE_POINTS},
      {.name = "wheel.y", .offset = offsetof(wrc_config, wheel.y), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_config, wheel.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_config, wheel.count)},
      {.name = "wheel.z", .offset = offsetof(wrc_config, wheel.z), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_config, wheel.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_config, wheel.count)},
      {.name = "wheel.smoothing", .offset = offsetof(wrc_config, wheel.smoothing), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.05, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "wheel.reserved", .offset = offsetof(wrc_config, wheel.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "rail.kind", .offset = offsetof(wrc_config, rail.kind), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_profile_kind},
      {.name = "rail.count", .offset = offsetof(wrc_config, rail.count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 20000, .too_small = "a spline needs at least four points", .not_set = "was it set? WRC_PROFILE_POINTS needs it, and its default is 0", .asked = offsetof(wrc_config, rail.kind), .asked_for = WRC_PROFILE_POINTS},
      {.name = "rail.y", .offset = offsetof(wrc_config, rail.y), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_config, rail.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_config, rail.count)},
      {.name = "rail.z", .offset = offsetof(wrc_config, rail.z), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_config, rail.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_config, rail.count)},
      {.name = "rail.smoothing", .offset = offsetof(wrc_config, rail.smoothing), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.05, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "rail.reserved", .offset = offsetof(wrc_config, rail.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "wheel_material.shear_modulus", .offset = offsetof(wrc_config, wheel_material.shear_modulus), .type = Type::real, .rule = Rule::range, .low = 1e8, .high = 1e12, .unit = "Pa", .too_small = "did you pass MPa or GPa?", .too_large = "steel has 82e9"},
      {.name = "wheel_material.poisson", .offset = offsetof(wrc_config, wheel_material.poisson), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "steel has 0.25 to 0.3", .too_large = "steel has 0.25 to 0.3"},
      {.name = "wheel_material.shear_yield", .offset = offsetof(wrc_config, wheel_material.shear_yield), .type = Type::real, .rule = Rule::range, .low = 1e6, .high = 1e11, .unit = "Pa", .too_small = "did you pass MPa?"},
      {.name = "wheel_material.reserved", .offset = offsetof(wrc_config, wheel_material.reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
      {.name = "rail_material.shear_modulus", .offset = offsetof(wrc_config, rail_material.shear_modulus), .type = Type::real, .rule = Rule::range, .low = 1e8, .high = 1e12, .unit = "Pa", .too_small = "did you pass MPa or GPa?", .too_large = "steel has 82e9"},
      {.name = "rail_material.poisson", .offset = offsetof(wrc_config, rail_material.poisson), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "steel has 0.25 to 0.3", .too_large = "steel has 0.25 to 0.3"},
      {.name = "rail_material.shear_yield", .offset = offsetof(wrc_config, rail_material.shear_yield), .type = Type::real, .rule = Rule::range, .low = 1e6, .high = 1e11, .unit = "Pa", .too_small = "did you pass MPa?"},
      {.name = "rail_material.reserved", .offset = offsetof(wrc_config, rail_material.reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
      {.name = "wheel_heat.conductivity", .offset = offsetof(wrc_config, wheel_heat.conductivity), .type = Type::real, .rule = Rule::range, .low = 0.1, .high = 1000, .unit = "W/(m K)", .too_small = "steel has 40 to 55", .too_large = "steel has 40 to 55"},
      {.name = "wheel_heat.density", .offset = offsetof(wrc_config, wheel_heat.density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3", .too_small = "did you pass g/cm^3?"},
      {.name = "wheel_heat.specific_heat", .offset = offsetof(wrc_config, wheel_heat.specific_heat), .type = Type::real, .rule = Rule::range, .low = 10, .high = 1e5, .unit = "J/(kg K)", .too_small = "did you pass kJ?"},
      {.name = "wheel_heat.reserved", .offset = offsetof(wrc_config, wheel_heat.reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
      {.name = "rail_heat.conductivity", .offset = offsetof(wrc_config, rail_heat.conductivity), .type = Type::real, .rule = Rule::range, .low = 0.1, .high = 1000, .unit = "W/(m K)", .too_small = "steel has 40 to 55", .too_large = "steel has 40 to 55"},
      {.name = "rail_heat.density", .offset = offsetof(wrc_config, rail_heat.density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3", .too_small = "did you pass g/cm^3?"},
      {.name = "rail_heat.specific_heat", .offset = offsetof(wrc_config, rail_heat.specific_heat), .type = Type::real, .rule = Rule::range, .low = 10, .high = 1e5, .unit = "J/(kg K)", .too_small = "did you pass kJ?"},
      {.name = "rail_heat.reserved", .offset = offsetof(wrc_config, rail_heat.reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
      {.name = "wheelset.wheel_radius", .offset = offsetof(wrc_config, wheelset.wheel_radius), .type = Type::real, .rule = Rule::range, .low = 0.1, .high = 1.5, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "wheelset.tape_circle_distance", .offset = offsetof(wrc_config, wheelset.tape_circle_distance), .type = Type::real, .rule = Rule::range, .low = 0.3, .high = 3, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "wheelset.reserved", .offset = offsetof(wrc_config, wheelset.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "track.placement", .offset = offsetof(wrc_config, track.placement), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_profile_placement},
      {.name = "track.reserved0", .offset = offsetof(wrc_config, track.reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "track.gauge", .offset = offsetof(wrc_config, track.gauge), .type = Type::real, .rule = Rule::range, .low = 0.3, .high = 2.5, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "track.gauge_depth", .offset = offsetof(wrc_config, track.gauge_depth), .type = Type::real, .rule = Rule::range, .low = 0.005, .high = 0.04, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "track.rail_inclination", .offset = offsetof(wrc_config, track.rail_inclination), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .too_small = "1:40 is 0.025", .too_large = "1:40 is 0.025"},
      {.name = "track.rail_origin", .offset = offsetof(wrc_config, track.rail_origin), .type = Type::real, .rule = Rule::range, .low = 0.2, .high = 1.5, .unit = "m", .too_large = "did you pass mm, or the distance from rail to rail?", .not_set = "was it set? WRC_PLACEMENT_ORIGIN needs it, and its default is 0", .asked = offsetof(wrc_config, track.placement), .asked_for = WRC_PLACEMENT_ORIGIN, .otherwise = "it is read with WRC_PLACEMENT_ORIGIN only: leave it 0"},
      {.name = "track.reserved", .offset = offsetof(wrc_config, track.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "normal.method", .offset = offsetof(wrc_config, normal.method), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_normal_method},
      {.name = "normal.max_iterations", .offset = offsetof(wrc_config, normal.max_iterations), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 1000},
      {.name = "normal.load_tolerance", .offset = offsetof(wrc_config, normal.load_tolerance), .type = Type::real, .rule = Rule::range, .low = 1e-14, .high = 1e-2},
      {.name = "normal.reserved", .offset = offsetof(wrc_config, normal.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "tangential.method", .offset = offsetof(wrc_config, tangential.method), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_tangential_method},
      {.name = "tangential.patch_model", .offset = offsetof(wrc_config, tangential.patch_model), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_patch_model},
      {.name = "tangential.bound", .offset = offsetof(wrc_config, tangential.bound), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_traction_bound},
      {.name = "tangential.flexibility", .offset = offsetof(wrc_config, tangential.flexibility), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_flexibility},
      {.name = "tangential.force_table", .offset = offsetof(wrc_config, tangential.force_table), .type = Type::pointer, .rule = Rule::none},
      {.name = "tangential.reserved", .offset = offsetof(wrc_config, tangential.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "surface.cells", .offset = offsetof(wrc_config, surface.cells), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 512},
      {.name = "surface.memory", .offset = offsetof(wrc_config, surface.memory), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "surface.tread_width", .offset = offsetof(wrc_config, surface.tread_width), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 2e-3, .unit = "m"},
      {.name = "surface.corner_width", .offset = offsetof(wrc_config, surface.corner_width), .type = Type::real, .rule = Rule::range, .low = 5e-5, .high = 1e-3, .unit = "m"},
      {.name = "surface.tolerance", .offset = offsetof(wrc_config, surface.tolerance), .type = Type::real, .rule = Rule::range, .low = 1e-10, .high = 1e-2},
      {.name = "surface.max_work", .offset = offsetof(wrc_config, surface.max_work), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e9},
      {.name = "surface.max_iterations", .offset = offsetof(wrc_config, surface.max_iterations), .type = Type::real, .rule = Rule::range, .low = 2, .high = 1e6},
      {.name = "surface.reserved", .offset = offsetof(wrc_config, surface.reserved), .type = Type::real, .elements = 9, .rule = Rule::zero},
      {.name = "planar.strips", .offset = offsetof(wrc_config, planar.strips), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 512, .too_large = "more strips cost time in proportion"},
      {.name = "planar.cells", .offset = offsetof(wrc_config, planar.cells), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 512, .too_large = "more cells cost time in proportion"},
      {.name = "planar.gap_rows", .offset = offsetof(wrc_config, planar.gap_rows), .type = Type::int32, .rule = Rule::range, .low = 8, .high = 4096, .too_small = "the gap is interpolated between rows", .too_large = "the gap is interpolated between rows"},
      {.name = "planar.max_patches", .offset = offsetof(wrc_config, planar.max_patches), .type = Type::int32, .rule = Rule::range, .low = 1, .high = 16, .too_small = "a wheel touches its rail in one to three places", .too_large = "a wheel touches its rail in one to three places"},
      {.name = "planar.max_sweeps", .offset = offsetof(wrc_config, planar.max_sweeps), .type = Type::int32, .rule = Rule::range, .low = 4, .high = 1000},
      {.name = "planar.start", .offset = offsetof(wrc_config, planar.start), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_start},
      {.name = "planar.regularisation", .offset = offsetof(wrc_config, planar.regularisation), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_regularisation},
      {.name = "planar.non_steady", .offset = offsetof(wrc_config, planar.non_steady), .type = Type::int32, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "planar.gap_limit", .offset = offsetof(wrc_config, planar.gap_limit), .type = Type::real, .rule = Rule::range, .low = 1e-5, .high = 0.02, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "planar.reserved", .offset = offsetof(wrc_config, planar.reserved), .type = Type::real, .elements = 8, .rule = Rule::zero},
      {.name = "roundness.angle_count", .offset = offsetof(wrc_config, roundness.angle_count), .type = Type::uint32, .rule = Rule::range, .low = 9, .high = 20000, .or_zero = true},
      {.name = "roundness.row_count", .offset = offsetof(wrc_config, roundness.row_count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 16, .not_set = "was it set? angle_count needs it, and its default is 0", .asked = offsetof(wrc_config, roundness.angle_count), .state = State::not_zero, .otherwise = "it is read with angle_count only: leave it 0"},
      {.name = "roundness.angles", .offset = offsetof(wrc_config, roundness.angles), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 6.2831854, .unit = "rad", .too_small = "did you pass degrees?", .too_large = "did you pass degrees?", .asked = offsetof(wrc_config, roundness.angle_count), .state = State::not_zero, .counted_by = offsetof(wrc_config, roundness.angle_count)},
      {.name = "roundness.y", .offset = offsetof(wrc_config, roundness.y), .type = Type::pointer, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "m", .counted_by = offsetof(wrc_config, roundness.row_count)},
      {.name = "roundness.deviations", .offset = offsetof(wrc_config, roundness.deviations), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.005, .high = 0.005, .unit = "m", .asked = offsetof(wrc_config, roundness.angle_count), .state = State::not_zero, .by_caller = true},
      {.name = "roundness.reserved", .offset = offsetof(wrc_config, roundness.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "roller_curvature", .offset = offsetof(wrc_config, roller_curvature), .type = Type::real, .rule = Rule::range, .low = 1e-12, .high = 10, .or_zero = true, .unit = "1/m", .too_large = "did you pass a radius? wrc_contact_wrench() alone reads it"},
      {.name = "check_rail.y", .offset = offsetof(wrc_config, check_rail.y), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0, .unit = "m", .too_small = "did you pass mm, or count from the track's middle?", .too_large = "did you pass mm, or count from the track's middle?"},
      {.name = "check_rail.z", .offset = offsetof(wrc_config, check_rail.z), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "check_rail.profile.kind", .offset = offsetof(wrc_config, check_rail.profile.kind), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_profile_kind},
      {.name = "check_rail.profile.count", .offset = offsetof(wrc_config, check_rail.profile.count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 20000, .too_small = "a spline needs at least four points", .not_set = "was it set? WRC_PROFILE_POINTS needs it, and its default is 0", .asked = offsetof(wrc_config, check_rail.profile.kind), .asked_for = WRC_PROFILE_POINTS},
      {.name = "check_rail.profile.y", .offset = offsetof(wrc_config, check_rail.profile.y), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_config, check_rail.profile.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_config, check_rail.profile.count)},
      {.name = "check_rail.profile.z", .offset = offsetof(wrc_config, check_rail.profile.z), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .not_set = "WRC_PROFILE_POINTS needs it", .asked = offsetof(wrc_config, check_rail.profile.kind), .asked_for = WRC_PROFILE_POINTS, .counted_by = offsetof(wrc_config, check_rail.profile.count)},
      {.name = "check_rail.profile.smoothing", .offset = offsetof(wrc_config, check_rail.profile.smoothing), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.05, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "check_rail.profile.reserved", .offset = offsetof(wrc_config, check_rail.profile.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "check_rail.reserved", .offset = offsetof(wrc_config, check_rail.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "rail_section_count", .offset = offsetof(wrc_config, rail_section_count), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1000},
      {.name = "rail_section_size", .offset = offsetof(wrc_config, rail_section_size), .type = Type::uint32, .rule = Rule::range, .low = first_size<wrc_rail_section>(168), .high = 4096, .or_zero = true, .too_small = "say sizeof(wrc_rail_section)", .too_large = "say sizeof(wrc_rail_section)"},
      {.name = "rail_sections", .offset = offsetof(wrc_config, rail_sections), .type = Type::pointer, .rule = Rule::none, .required = true, .asked = offsetof(wrc_config, rail_section_count), .state = State::not_zero, .counted_by = offsetof(wrc_config, rail_section_count)},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_config) == 1184, "run tools/interface/describe.py");

template <>
struct Description<wrc_allocator> {
  static constexpr const char* name = "wrc_allocator";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_allocator>(40);
  static constexpr wrc_allocator defaults = [] {
    wrc_allocator value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "user", .offset = offsetof(wrc_allocator, user), .type = Type::pointer, .rule = Rule::none},
      {.name = "allocate", .offset = offsetof(wrc_allocator, allocate), .type = Type::pointer, .rule = Rule::none},
      {.name = "release", .offset = offsetof(wrc_allocator, release), .type = Type::pointer, .rule = Rule::none},
      {.name = "reserved", .offset = offsetof(wrc_allocator, reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_allocator) == 40, "run tools/interface/describe.py");

template <>
struct Description<wrc_view> {
  static constexpr const char* name = "wrc_view";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_view>(32);
  static constexpr wrc_view defaults = [] {
    wrc_view value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "data", .offset = offsetof(wrc_view, data), .type = Type::pointer, .rule = Rule::none},
      {.name = "count", .offset = offsetof(wrc_view, count), .type = Type::uint64, .rule = Rule::none},
      {.name = "reserved", .offset = offsetof(wrc_view, reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_view) == 32, "run tools/interface/describe.py");

template <>
struct Description<wrc_bulk_temperatures> {
  static constexpr const char* name = "wrc_bulk_temperatures";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_bulk_temperatures>(32);
  static constexpr wrc_bulk_temperatures defaults = [] {
    wrc_bulk_temperatures value{};
    value.wheel = 20;
    value.rail = 20;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "wheel", .offset = offsetof(wrc_bulk_temperatures, wheel), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "rail", .offset = offsetof(wrc_bulk_temperatures, rail), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "reserved", .offset = offsetof(wrc_bulk_temperatures, reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_bulk_temperatures) == 32, "run tools/interface/describe.py");

template <>
struct Description<wrc_friction> {
  static constexpr const char* name = "wrc_friction";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_friction>(240);
  static constexpr wrc_friction defaults = [] {
    wrc_friction value{};
    value.coefficient = 0.3;
    value.kinetic_ratio = 0.4;
    value.fall_rate = 0.6;
    value.half_speed = 1;
    value.hot_ratio = 0.5;
    value.hot_temperature = 400;
    value.bulk = Description<wrc_bulk_temperatures>::defaults;
    value.slope_reduction = 1;
    value.slope_limit = 0.02;
    value.adhesion_reduction = 1;
    value.slip_reduction = 1;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "coefficient", .offset = offsetof(wrc_friction, coefficient), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 2, .or_zero = true, .too_small = "friction must be positive", .too_large = "did you pass per cent?"},
      {.name = "speed_law", .offset = offsetof(wrc_friction, speed_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_speed_law},
      {.name = "temperature_law", .offset = offsetof(wrc_friction, temperature_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_temperature_law},
      {.name = "kinetic_ratio", .offset = offsetof(wrc_friction, kinetic_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient at rest"},
      {.name = "fall_rate", .offset = offsetof(wrc_friction, fall_rate), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000, .unit = "s/m", .too_small = "friction falls with positive rates"},
      {.name = "half_speed", .offset = offsetof(wrc_friction, half_speed), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .unit = "m/s"},
      {.name = "hot_ratio", .offset = offsetof(wrc_friction, hot_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient of cold surfaces"},
      {.name = "cold_temperature", .offset = offsetof(wrc_friction, cold_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC"},
      {.name = "hot_temperature", .offset = offsetof(wrc_friction, hot_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 3000, .unit = "degC"},
      {.name = "bulk.wheel", .offset = offsetof(wrc_friction, bulk.wheel), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "bulk.rail", .offset = offsetof(wrc_friction, bulk.rail), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "bulk.reserved", .offset = offsetof(wrc_friction, bulk.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "slope_reduction", .offset = offsetof(wrc_friction, slope_reduction), .type = Type::real, .rule = Rule::range, .low = 0.01, .high = 1, .too_small = "clean bodies have 1", .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "slope_limit", .offset = offsetof(wrc_friction, slope_limit), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "slope_fall", .offset = offsetof(wrc_friction, slope_fall), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000},
      {.name = "zone_y", .offset = offsetof(wrc_friction, zone_y), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_friction, zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_friction, zone_count)},
      {.name = "zone_coefficients", .offset = offsetof(wrc_friction, zone_coefficients), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 2, .too_small = "friction is not negative", .too_large = "did you pass per cent?", .asked = offsetof(wrc_friction, zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_friction, zone_count)},
      {.name = "zone_count", .offset = offsetof(wrc_friction, zone_count), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 64},
      {.name = "zone_frame", .offset = offsetof(wrc_friction, zone_frame), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_zone_frame},
      {.name = "layer_thickness", .offset = offsetof(wrc_friction, layer_thickness), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.01, .unit = "m"},
      {.name = "layer_modulus", .offset = offsetof(wrc_friction, layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "layer_yield", .offset = offsetof(wrc_friction, layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "layer_hardening", .offset = offsetof(wrc_friction, layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "adhesion_reduction", .offset = offsetof(wrc_friction, adhesion_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "slip_reduction", .offset = offsetof(wrc_friction, slip_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "film_rows", .offset = offsetof(wrc_friction, film_rows), .type = Type::pointer, .rule = Rule::range, .low = -1e30, .high = 1e30, .counted_by = offsetof(wrc_friction, film_numbers), .by_caller = true},
      {.name = "film_numbers", .offset = offsetof(wrc_friction, film_numbers), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1288},
      {.name = "reserved0", .offset = offsetof(wrc_friction, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "reserved", .offset = offsetof(wrc_friction, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_friction) == 240, "run tools/interface/describe.py");

template <>
struct Description<wrc_wheel_state> {
  static constexpr const char* name = "wrc_wheel_state";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_wheel_state>(240);
  static constexpr wrc_wheel_state defaults = [] {
    wrc_wheel_state value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "reference", .offset = offsetof(wrc_wheel_state, reference), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_wheel_reference},
      {.name = "orientation", .offset = offsetof(wrc_wheel_state, orientation), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_orientation},
      {.name = "angular_axes", .offset = offsetof(wrc_wheel_state, angular_axes), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_axes},
      {.name = "reserved0", .offset = offsetof(wrc_wheel_state, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "y", .offset = offsetof(wrc_wheel_state, y), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "z", .offset = offsetof(wrc_wheel_state, z), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm, or a height above the rail? 0 is the nominal height, down is positive", .by_caller = true},
      {.name = "roll", .offset = offsetof(wrc_wheel_state, roll), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?", .asked = offsetof(wrc_wheel_state, orientation), .asked_for = WRC_ORIENTATION_ANGLES, .otherwise = "give roll and yaw or a rotation, not both; it is read with WRC_ORIENTATION_ANGLES only: leave it 0"},
      {.name = "yaw", .offset = offsetof(wrc_wheel_state, yaw), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?", .asked = offsetof(wrc_wheel_state, orientation), .asked_for = WRC_ORIENTATION_ANGLES, .otherwise = "give roll and yaw or a rotation, not both; it is read with WRC_ORIENTATION_ANGLES only: leave it 0"},
      {.name = "velocity[0]", .offset = offsetof(wrc_wheel_state, velocity[0]), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h or mm/s, or other axes?", .too_large = "did you pass km/h or mm/s, or other axes?"},
      {.name = "velocity[1]", .offset = offsetof(wrc_wheel_state, velocity[1]), .type = Type::real, .rule = Rule::range, .low = -50, .high = 50, .unit = "m/s", .too_small = "did you pass km/h or mm/s, or other axes?", .too_large = "did you pass km/h or mm/s, or other axes?"},
      {.name = "velocity[2]", .offset = offsetof(wrc_wheel_state, velocity[2]), .type = Type::real, .rule = Rule::range, .low = -50, .high = 50, .unit = "m/s", .too_small = "did you pass km/h or mm/s, or other axes?", .too_large = "did you pass km/h or mm/s, or other axes?"},
      {.name = "roll_rate", .offset = offsetof(wrc_wheel_state, roll_rate), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass rpm or degrees?", .too_large = "did you pass rpm or degrees?", .asked = offsetof(wrc_wheel_state, angular_axes), .asked_for = WRC_AXES_NONE, .otherwise = "give rates or angular_velocity, not both; it is read with WRC_AXES_NONE only: leave it 0"},
      {.name = "pitch_rate", .offset = offsetof(wrc_wheel_state, pitch_rate), .type = Type::real, .rule = Rule::range, .low = -2000, .high = 2000, .unit = "rad/s", .too_small = "did you pass rpm or degrees? rolling forwards it is -speed / wheel radius", .too_large = "did you pass rpm or degrees? rolling forwards it is -speed / wheel radius", .asked = offsetof(wrc_wheel_state, angular_axes), .asked_for = WRC_AXES_NONE, .otherwise = "give rates or angular_velocity, not both; it is read with WRC_AXES_NONE only: leave it 0"},
      {.name = "yaw_rate", .offset = offsetof(wrc_wheel_state, yaw_rate), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass rpm or degrees?", .too_large = "did you pass rpm or degrees?", .asked = offsetof(wrc_wheel_state, angular_axes), .asked_for = WRC_AXES_NONE, .otherwise = "give rates or angular_velocity, not both; it is read with WRC_AXES_NONE only: leave it 0"},
      {.name = "angular_velocity[0]", .offset = offsetof(wrc_wheel_state, angular_velocity[0]), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass rpm or degrees? the axle is the y axis", .too_large = "did you pass rpm or degrees? the axle is the y axis", .asked = offsetof(wrc_wheel_state, angular_axes), .state = State::not_zero, .otherwise = "say WRC_AXES_TRACK (components along x, y, z of the track) or WRC_AXES_BODY (y along the axle), or give pitch_rate = -v / r0, roll_rate, yaw_rate"},
      {.name = "angular_velocity[1]", .offset = offsetof(wrc_wheel_state, angular_velocity[1]), .type = Type::real, .rule = Rule::range, .low = -2000, .high = 2000, .unit = "rad/s", .too_small = "did you pass rpm or degrees? the axle is the y axis", .too_large = "did you pass rpm or degrees? the axle is the y axis", .asked = offsetof(wrc_wheel_state, angular_axes), .state = State::not_zero, .otherwise = "say WRC_AXES_TRACK (components along x, y, z of the track) or WRC_AXES_BODY (y along the axle), or give pitch_rate = -v / r0, roll_rate, yaw_rate"},
      {.name = "angular_velocity[2]", .offset = offsetof(wrc_wheel_state, angular_velocity[2]), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass rpm or degrees? the axle is the y axis", .too_large = "did you pass rpm or degrees? the axle is the y axis", .asked = offsetof(wrc_wheel_state, angular_axes), .state = State::not_zero, .otherwise = "say WRC_AXES_TRACK (components along x, y, z of the track) or WRC_AXES_BODY (y along the axle), or give pitch_rate = -v / r0, roll_rate, yaw_rate"},
      {.name = "rotation", .offset = offsetof(wrc_wheel_state, rotation), .type = Type::real, .elements = 9, .rule = Rule::range, .low = -1.001, .high = 1.001, .too_small = "these are not cosines between axes", .too_large = "these are not cosines between axes", .asked = offsetof(wrc_wheel_state, orientation), .state = State::not_zero, .otherwise = "say WRC_ORIENTATION_ROWS (as C and numpy store a matrix) or WRC_ORIENTATION_COLUMNS (as Fortran and Eigen do)"},
      {.name = "reserved", .offset = offsetof(wrc_wheel_state, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_wheel_state) == 240, "run tools/interface/describe.py");

template <>
struct Description<wrc_rail_state> {
  static constexpr const char* name = "wrc_rail_state";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_rail_state>(112);
  static constexpr wrc_rail_state defaults = [] {
    wrc_rail_state value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "y", .offset = offsetof(wrc_rail_state, y), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "z", .offset = offsetof(wrc_rail_state, z), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "roll", .offset = offsetof(wrc_rail_state, roll), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?"},
      {.name = "y_slope", .offset = offsetof(wrc_rail_state, y_slope), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .too_small = "did you pass mm/m, or a velocity?", .too_large = "did you pass mm/m, or a velocity?"},
      {.name = "z_slope", .offset = offsetof(wrc_rail_state, z_slope), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .too_small = "did you pass mm/m, or a velocity?", .too_large = "did you pass mm/m, or a velocity?"},
      {.name = "y_velocity", .offset = offsetof(wrc_rail_state, y_velocity), .type = Type::real, .rule = Rule::range, .low = -50, .high = 50, .unit = "m/s", .too_small = "did you pass mm/s?", .too_large = "did you pass mm/s?"},
      {.name = "z_velocity", .offset = offsetof(wrc_rail_state, z_velocity), .type = Type::real, .rule = Rule::range, .low = -50, .high = 50, .unit = "m/s", .too_small = "did you pass mm/s?", .too_large = "did you pass mm/s?"},
      {.name = "roll_rate", .offset = offsetof(wrc_rail_state, roll_rate), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?"},
      {.name = "reserved", .offset = offsetof(wrc_rail_state, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_rail_state) == 112, "run tools/interface/describe.py");

template <>
struct Description<wrc_frame_motion> {
  static constexpr const char* name = "wrc_frame_motion";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_frame_motion>(64);
  static constexpr wrc_frame_motion defaults = [] {
    wrc_frame_motion value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "speed", .offset = offsetof(wrc_frame_motion, speed), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h?", .too_large = "did you pass km/h?"},
      {.name = "curvature", .offset = offsetof(wrc_frame_motion, curvature), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .unit = "1/m", .too_small = "did you pass a radius?", .too_large = "did you pass a radius?"},
      {.name = "vertical_curvature", .offset = offsetof(wrc_frame_motion, vertical_curvature), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .unit = "1/m", .too_small = "did you pass a radius?", .too_large = "did you pass a radius?"},
      {.name = "twist", .offset = offsetof(wrc_frame_motion, twist), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "1/m", .too_small = "did you pass a rate, or mm?", .too_large = "did you pass a rate, or mm?"},
      {.name = "reserved", .offset = offsetof(wrc_frame_motion, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_frame_motion) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_wheel_input> {
  static constexpr const char* name = "wrc_wheel_input";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_wheel_input>(712);
  static constexpr wrc_wheel_input defaults = [] {
    wrc_wheel_input value{};
    value.struct_size = sizeof value;
    value.wheel = Description<wrc_wheel_state>::defaults;
    value.rail = Description<wrc_rail_state>::defaults;
    value.frame = Description<wrc_frame_motion>::defaults;
    value.friction = Description<wrc_friction>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_wheel_input, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "prescribed", .offset = offsetof(wrc_wheel_input, prescribed), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_prescribed},
      {.name = "start", .offset = offsetof(wrc_wheel_input, start), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_start},
      {.name = "reserved0", .offset = offsetof(wrc_wheel_input, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "wheel.reference", .offset = offsetof(wrc_wheel_input, wheel.reference), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_wheel_reference},
      {.name = "wheel.orientation", .offset = offsetof(wrc_wheel_input, wheel.orientation), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_orientation},
      {.name = "wheel.angular_axes", .offset = offsetof(wrc_wheel_input, wheel.angular_axes), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_axes},
      {.name = "wheel.reserved0", .offset = offsetof(wrc_wheel_input, wheel.reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "wheel.y", .offset = offsetof(wrc_wheel_input, wheel.y), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "wheel.z", .offset = offsetof(wrc_wheel_input, wheel.z), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm, or a height above the rail? 0 is the nominal height, down is positive", .by_caller = true},
      {.name = "wheel.roll", .offset = offsetof(wrc_wheel_input, wheel.roll), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?", .asked = offsetof(wrc_wheel_input, wheel.orientation), .asked_for = WRC_ORIENTATION_ANGLES, .otherwise = "give roll and yaw or a rotation, not both; it is read with WRC_ORIENTATION_ANGLES only: leave it 0"},
      {.name = "wheel.yaw", .offset = offsetof(wrc_wheel_input, wheel.yaw), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?", .asked = offsetof(wrc_wheel_input, wheel.orientation), .asked_for = WRC_ORIENTATION_ANGLES, .otherwise = "give roll and yaw or a rotation, not both; it is read with WRC_ORIENTATION_ANGLES only: leave it 0"},
      {.name = "wheel.velocity[0]", .offset = offsetof(wrc_wheel_input, wheel.velocity[0]), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h or mm/s, or other axes?", .too_large = "did you pass km/h or mm/s, or other axes?"},
      {.name = "wheel.velocity[1]", .offset = offsetof(wrc_wheel_input, wheel.velocity[1]), .type = Type::real, .rule = Rule::range, .low = -50, .high = 50, .unit = "m/s", .too_small = "did you pass km/h or mm/s, or other axes?", .too_large = "did you pass km/h or mm/s, or other axes?"},
      {.name = "wheel.velocity[2]", .offset = offsetof(wrc_wheel_input, wheel.velocity[2]), .type = Type::real, .rule = Rule::range, .low = -50, .high = 50, .unit = "m/s", .too_small = "did you pass km/h or mm/s, or other axes?", .too_large = "did you pass km/h or mm/s, or other axes?"},
      {.name = "wheel.roll_rate", .offset = offsetof(wrc_wheel_input, wheel.roll_rate), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass rpm or degrees?", .too_large = "did you pass rpm or degrees?", .asked = offsetof(wrc_wheel_input, wheel.angular_axes), .asked_for = WRC_AXES_NONE, .otherwise = "give rates or angular_velocity, not both; it is read with WRC_AXES_NONE only: leave it 0"},
      {.name = "wheel.pitch_rate", .offset = offsetof(wrc_wheel_input, wheel.pitch_rate), .type = Type::real, .rule = Rule::range, .low = -2000, .high = 2000, .unit = "rad/s", .too_small = "did you pass rpm or degrees? rolling forwards it is -speed / wheel radius", .too_large = "did you pass rpm or degrees? rolling forwards it is -speed / wheel radius", .asked = offsetof(wrc_wheel_input, wheel.angular_axes), .asked_for = WRC_AXES_NONE, .otherwise = "give rates or angular_velocity, not both; it is read with WRC_AXES_NONE only: leave it 0"},
      {.name = "wheel.yaw_rate", .offset = offsetof(wrc_wheel_input, wheel.yaw_rate), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass rpm or degrees?", .too_large = "did you pass rpm or degrees?", .asked = offsetof(wrc_wheel_input, wheel.angular_axes), .asked_for = WRC_AXES_NONE, .otherwise = "give rates or angular_velocity, not both; it is read with WRC_AXES_NONE only: leave it 0"},
      {.name = "wheel.angular_velocity[0]", .offset = offsetof(wrc_wheel_input, wheel.angular_velocity[0]), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass rpm or degrees? the axle is the y axis", .too_large = "did you pass rpm or degrees? the axle is the y axis", .asked = offsetof(wrc_wheel_input, wheel.angular_axes), .state = State::not_zero, .otherwise = "say WRC_AXES_TRACK (components along x, y, z of the track) or WRC_AXES_BODY (y along the axle), or give pitch_rate = -v / r0, roll_rate, yaw_rate"},
      {.name = "wheel.angular_velocity[1]", .offset = offsetof(wrc_wheel_input, wheel.angular_velocity[1]), .type = Type::real, .rule = Rule::range, .low = -2000, .high = 2000, .unit = "rad/s", .too_small = "did you pass rpm or degrees? the axle is the y axis", .too_large = "did you pass rpm or degrees? the axle is the y axis", .asked = offsetof(wrc_wheel_input, wheel.angular_axes), .state = State::not_zero, .otherwise = "say WRC_AXES_TRACK (components along x, y, z of the track) or WRC_AXES_BODY (y along the axle), or give pitch_rate = -v / r0, roll_rate, yaw_rate"},
      {.name = "wheel.angular_velocity[2]", .offset = offsetof(wrc_wheel_input, wheel.angular_velocity[2]), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass rpm or degrees? the axle is the y axis", .too_large = "did you pass rpm or degrees? the axle is the y axis", .asked = offsetof(wrc_wheel_input, wheel.angular_axes), .state = State::not_zero, .otherwise = "say WRC_AXES_TRACK (components along x, y, z of the track) or WRC_AXES_BODY (y along the axle), or give pitch_rate = -v / r0, roll_rate, yaw_rate"},
      {.name = "wheel.rotation", .offset = offsetof(wrc_wheel_input, wheel.rotation), .type = Type::real, .elements = 9, .rule = Rule::range, .low = -1.001, .high = 1.001, .too_small = "these are not cosines between axes", .too_large = "these are not cosines between axes", .asked = offsetof(wrc_wheel_input, wheel.orientation), .state = State::not_zero, .otherwise = "say WRC_ORIENTATION_ROWS (as C and numpy store a matrix) or WRC_ORIENTATION_COLUMNS (as Fortran and Eigen do)"},
      {.name = "wheel.reserved", .offset = offsetof(wrc_wheel_input, wheel.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "rail.y", .offset = offsetof(wrc_wheel_input, rail.y), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "rail.z", .offset = offsetof(wrc_wheel_input, rail.z), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "rail.roll", .offset = offsetof(wrc_wheel_input, rail.roll), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?"},
      {.name = "rail.y_slope", .offset = offsetof(wrc_wheel_input, rail.y_slope), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .too_small = "did you pass mm/m, or a velocity?", .too_large = "did you pass mm/m, or a velocity?"},
      {.name = "rail.z_slope", .offset = offsetof(wrc_wheel_input, rail.z_slope), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .too_small = "did you pass mm/m, or a velocity?", .too_large = "did you pass mm/m, or a velocity?"},
      {.name = "rail.y_velocity", .offset = offsetof(wrc_wheel_input, rail.y_velocity), .type = Type::real, .rule = Rule::range, .low = -50, .high = 50, .unit = "m/s", .too_small = "did you pass mm/s?", .too_large = "did you pass mm/s?"},
      {.name = "rail.z_velocity", .offset = offsetof(wrc_wheel_input, rail.z_velocity), .type = Type::real, .rule = Rule::range, .low = -50, .high = 50, .unit = "m/s", .too_small = "did you pass mm/s?", .too_large = "did you pass mm/s?"},
      {.name = "rail.roll_rate", .offset = offsetof(wrc_wheel_input, rail.roll_rate), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "rad/s", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?"},
      {.name = "rail.reserved", .offset = offsetof(wrc_wheel_input, rail.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
      {.name = "frame.speed", .offset = offsetof(wrc_wheel_input, frame.speed), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h?", .too_large = "did you pass km/h?"},
      {.name = "frame.curvature", .offset = offsetof(wrc_wheel_input, frame.curvature), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .unit = "1/m", .too_small = "did you pass a radius?", .too_large = "did you pass a radius?"},
      {.name = "frame.vertical_curvature", .offset = offsetof(wrc_wheel_input, frame.vertical_curvature), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .unit = "1/m", .too_small = "did you pass a radius?", .too_large = "did you pass a radius?"},
      {.name = "frame.twist", .offset = offsetof(wrc_wheel_input, frame.twist), .type = Type::real, .rule = Rule::range, .low = -0.5, .high = 0.5, .unit = "1/m", .too_small = "did you pass a rate, or mm?", .too_large = "did you pass a rate, or mm?"},
      {.name = "frame.reserved", .offset = offsetof(wrc_wheel_input, frame.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "friction.coefficient", .offset = offsetof(wrc_wheel_input, friction.coefficient), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 2, .or_zero = true, .too_small = "friction must be positive", .too_large = "did you pass per cent?"},
      {.name = "friction.speed_law", .offset = offsetof(wrc_wheel_input, friction.speed_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_speed_law},
      {.name = "friction.temperature_law", .offset = offsetof(wrc_wheel_input, friction.temperature_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_temperature_law},
      {.name = "friction.kinetic_ratio", .offset = offsetof(wrc_wheel_input, friction.kinetic_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient at rest"},
      {.name = "friction.fall_rate", .offset = offsetof(wrc_wheel_input, friction.fall_rate), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000, .unit = "s/m", .too_small = "friction falls with positive rates"},
      {.name = "friction.half_speed", .offset = offsetof(wrc_wheel_input, friction.half_speed), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .unit = "m/s"},
      {.name = "friction.hot_ratio", .offset = offsetof(wrc_wheel_input, friction.hot_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient of cold surfaces"},
      {.name = "friction.cold_temperature", .offset = offsetof(wrc_wheel_input, friction.cold_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC"},
      {.name = "friction.hot_temperature", .offset = offsetof(wrc_wheel_input, friction.hot_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 3000, .unit = "degC"},
      {.name = "friction.bulk.wheel", .offset = offsetof(wrc_wheel_input, friction.bulk.wheel), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "friction.bulk.rail", .offset = offsetof(wrc_wheel_input, friction.bulk.rail), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "friction.bulk.reserved", .offset = offsetof(wrc_wheel_input, friction.bulk.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "friction.slope_reduction", .offset = offsetof(wrc_wheel_input, friction.slope_reduction), .type = Type::real, .rule = Rule::range, .low = 0.01, .high = 1, .too_small = "clean bodies have 1", .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.slope_limit", .offset = offsetof(wrc_wheel_input, friction.slope_limit), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "friction.slope_fall", .offset = offsetof(wrc_wheel_input, friction.slope_fall), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000},
      {.name = "friction.zone_y", .offset = offsetof(wrc_wheel_input, friction.zone_y), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_wheel_input, friction.zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_wheel_input, friction.zone_count)},
      {.name = "friction.zone_coefficients", .offset = offsetof(wrc_wheel_input, friction.zone_coefficients), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 2, .too_small = "friction is not negative", .too_large = "did you pass per cent?", .asked = offsetof(wrc_wheel_input, friction.zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_wheel_input, friction.zone_count)},
      {.name = "friction.zone_count", .offset = offsetof(wrc_wheel_input, friction.zone_count), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 64},
      {.name = "friction.zone_frame", .offset = offsetof(wrc_wheel_input, friction.zone_frame), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_zone_frame},
      {.name = "friction.layer_thickness", .offset = offsetof(wrc_wheel_input, friction.layer_thickness), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.01, .unit = "m"},
      {.name = "friction.layer_modulus", .offset = offsetof(wrc_wheel_input, friction.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "friction.layer_yield", .offset = offsetof(wrc_wheel_input, friction.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "friction.layer_hardening", .offset = offsetof(wrc_wheel_input, friction.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "friction.adhesion_reduction", .offset = offsetof(wrc_wheel_input, friction.adhesion_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.slip_reduction", .offset = offsetof(wrc_wheel_input, friction.slip_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.film_rows", .offset = offsetof(wrc_wheel_input, friction.film_rows), .type = Type::pointer, .rule = Rule::range, .low = -1e30, .high = 1e30, .counted_by = offsetof(wrc_wheel_input, friction.film_numbers), .by_caller = true},
      {.name = "friction.film_numbers", .offset = offsetof(wrc_wheel_input, friction.film_numbers), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1288},
      {.name = "friction.reserved0", .offset = offsetof(wrc_wheel_input, friction.reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "friction.reserved", .offset = offsetof(wrc_wheel_input, friction.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "vertical_load", .offset = offsetof(wrc_wheel_input, vertical_load), .type = Type::real, .rule = Rule::range, .low = 1e2, .high = 1e6, .unit = "N", .negative = "the load is positive where the rail pushes the wheel upwards", .too_small = "did you pass kN? near lift-off prescribe the height instead", .too_large = "did you pass a pressure, or grams?", .not_set = "was it set? WRC_PRESCRIBE_VERTICAL_LOAD needs it, and its default is 0", .asked = offsetof(wrc_wheel_input, prescribed), .asked_for = WRC_PRESCRIBE_VERTICAL_LOAD, .otherwise = "no vertical load is prescribed, but the height or another quantity (set prescribed to use it); it is read with WRC_PRESCRIBE_VERTICAL_LOAD only: leave it 0"},
      {.name = "damping", .offset = offsetof(wrc_wheel_input, damping), .type = Type::real, .rule = Rule::range, .low = 0, .high = 10, .unit = "s/m", .negative = "damping takes energy out", .too_large = "it is not a viscous constant: that over 3/2 of the force it was found at", .asked = offsetof(wrc_wheel_input, prescribed), .asked_for = WRC_PRESCRIBE_HEIGHT, .otherwise = "a prescribed load is the whole load; it is read with WRC_PRESCRIBE_HEIGHT only: leave it 0"},
      {.name = "distance", .offset = offsetof(wrc_wheel_input, distance), .type = Type::real, .rule = Rule::range, .low = -1e7, .high = 1e7, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "angle", .offset = offsetof(wrc_wheel_input, angle), .type = Type::real, .rule = Rule::range, .low = -1e9, .high = 1e9, .unit = "rad", .too_small = "did you pass degrees?", .too_large = "did you pass degrees?"},
      {.name = "roller_rate", .offset = offsetof(wrc_wheel_input, roller_rate), .type = Type::real, .rule = Rule::range, .low = -2000, .high = 2000, .unit = "rad/s", .too_small = "did you pass rpm or degrees?", .too_large = "did you pass rpm or degrees?"},
      {.name = "time_step", .offset = offsetof(wrc_wheel_input, time_step), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e6, .unit = "s"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_wheel_input) == 720, "run tools/interface/describe.py");

template <>
struct Description<wrc_wrench> {
  static constexpr const char* name = "wrc_wrench";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_wrench>(168);
  static constexpr wrc_wrench defaults = [] {
    wrc_wrench value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_wrench, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "flags", .offset = offsetof(wrc_wrench, flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "region_count", .offset = offsetof(wrc_wrench, region_count), .type = Type::int32, .rule = Rule::none},
      {.name = "iterations", .offset = offsetof(wrc_wrench, iterations), .type = Type::int32, .rule = Rule::none},
      {.name = "force", .offset = offsetof(wrc_wrench, force), .type = Type::real, .elements = 3, .rule = Rule::none, .unit = "N"},
      {.name = "moment", .offset = offsetof(wrc_wrench, moment), .type = Type::real, .elements = 3, .rule = Rule::none, .unit = "N m"},
      {.name = "rail_force", .offset = offsetof(wrc_wrench, rail_force), .type = Type::real, .elements = 3, .rule = Rule::none, .unit = "N"},
      {.name = "rail_moment", .offset = offsetof(wrc_wrench, rail_moment), .type = Type::real, .elements = 3, .rule = Rule::none, .unit = "N m"},
      {.name = "z", .offset = offsetof(wrc_wrench, z), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "clearance", .offset = offsetof(wrc_wrench, clearance), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal_force", .offset = offsetof(wrc_wrench, normal_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "area", .offset = offsetof(wrc_wrench, area), .type = Type::real, .rule = Rule::none, .unit = "m^2"},
      {.name = "peak_pressure", .offset = offsetof(wrc_wrench, peak_pressure), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "power", .offset = offsetof(wrc_wrench, power), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "steepest_angle", .offset = offsetof(wrc_wrench, steepest_angle), .type = Type::real, .rule = Rule::none, .unit = "rad"},
      {.name = "residual", .offset = offsetof(wrc_wrench, residual), .type = Type::real, .rule = Rule::none},
      {.name = "work", .offset = offsetof(wrc_wrench, work), .type = Type::real, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_wrench) == 184, "run tools/interface/describe.py");

template <>
struct Description<wrc_wrench_derivatives> {
  static constexpr const char* name = "wrc_wrench_derivatives";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_wrench_derivatives>(1800);
  static constexpr wrc_wrench_derivatives defaults = [] {
    wrc_wrench_derivatives value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_wrench_derivatives, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_wrench_derivatives, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "wrench", .offset = offsetof(wrc_wrench_derivatives, wrench), .type = Type::real, .elements = 192, .rule = Rule::none},
      {.name = "z", .offset = offsetof(wrc_wrench_derivatives, z), .type = Type::real, .elements = 32, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_wrench_derivatives) == 1800, "run tools/interface/describe.py");

template <>
struct Description<wrc_creepage> {
  static constexpr const char* name = "wrc_creepage";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_creepage>(80);
  static constexpr wrc_creepage defaults = [] {
    wrc_creepage value{};
    value.speed = 1;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "longitudinal", .offset = offsetof(wrc_creepage, longitudinal), .type = Type::real, .rule = Rule::range, .low = -10, .high = 10, .too_small = "did you pass per mille?", .too_large = "did you pass per mille?"},
      {.name = "lateral", .offset = offsetof(wrc_creepage, lateral), .type = Type::real, .rule = Rule::range, .low = -10, .high = 10, .too_small = "did you pass per mille?", .too_large = "did you pass per mille?"},
      {.name = "spin", .offset = offsetof(wrc_creepage, spin), .type = Type::real, .rule = Rule::range, .low = -1000, .high = 1000, .unit = "1/m"},
      {.name = "speed", .offset = offsetof(wrc_creepage, speed), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h?", .too_large = "did you pass km/h?"},
      {.name = "approach_velocity", .offset = offsetof(wrc_creepage, approach_velocity), .type = Type::real, .rule = Rule::none, .unit = "m/s"},
      {.name = "reverse_share", .offset = offsetof(wrc_creepage, reverse_share), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "it is a result of wrc_planar_creepages", .too_large = "the way of creepage.speed has the larger share"},
      {.name = "reserved", .offset = offsetof(wrc_creepage, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_creepage) == 80, "run tools/interface/describe.py");

template <>
struct Description<wrc_ellipse> {
  static constexpr const char* name = "wrc_ellipse";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_ellipse>(64);
  static constexpr wrc_ellipse defaults = [] {
    wrc_ellipse value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "a", .offset = offsetof(wrc_ellipse, a), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "b", .offset = offsetof(wrc_ellipse, b), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "psi", .offset = offsetof(wrc_ellipse, psi), .type = Type::real, .rule = Rule::range, .low = -0.95, .high = 0.95},
      {.name = "y", .offset = offsetof(wrc_ellipse, y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal_force", .offset = offsetof(wrc_ellipse, normal_force), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e7, .unit = "N", .negative = "the normal force is compressive positive", .too_large = "did you pass mN?", .not_set = "was it set? its default is 0"},
      {.name = "reserved", .offset = offsetof(wrc_ellipse, reserved), .type = Type::real, .elements = 3, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_ellipse) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_region> {
  static constexpr const char* name = "wrc_region";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_region>(408);
  static constexpr wrc_region defaults = [] {
    wrc_region value{};
    value.struct_size = sizeof value;
    value.creepage = Description<wrc_creepage>::defaults;
    value.ellipse = Description<wrc_ellipse>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_region, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "available", .offset = offsetof(wrc_region, available), .type = Type::uint32, .rule = Rule::none},
      {.name = "strip_count", .offset = offsetof(wrc_region, strip_count), .type = Type::int32, .rule = Rule::none},
      {.name = "cell_count", .offset = offsetof(wrc_region, cell_count), .type = Type::int32, .rule = Rule::none},
      {.name = "surface", .offset = offsetof(wrc_region, surface), .type = Type::int32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_region, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "point", .offset = offsetof(wrc_region, point), .type = Type::real, .elements = 3, .rule = Rule::none, .unit = "m"},
      {.name = "normal", .offset = offsetof(wrc_region, normal), .type = Type::real, .elements = 3, .rule = Rule::none},
      {.name = "y_wheel", .offset = offsetof(wrc_region, y_wheel), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "z_wheel", .offset = offsetof(wrc_region, z_wheel), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y_rail", .offset = offsetof(wrc_region, y_rail), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "z_rail", .offset = offsetof(wrc_region, z_rail), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "angle", .offset = offsetof(wrc_region, angle), .type = Type::real, .rule = Rule::none, .unit = "rad"},
      {.name = "rolling_radius", .offset = offsetof(wrc_region, rolling_radius), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "force", .offset = offsetof(wrc_region, force), .type = Type::real, .elements = 3, .rule = Rule::none, .unit = "N"},
      {.name = "moment", .offset = offsetof(wrc_region, moment), .type = Type::real, .elements = 3, .rule = Rule::none, .unit = "N m"},
      {.name = "normal_force", .offset = offsetof(wrc_region, normal_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "longitudinal_force", .offset = offsetof(wrc_region, longitudinal_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "lateral_force", .offset = offsetof(wrc_region, lateral_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "spin_moment", .offset = offsetof(wrc_region, spin_moment), .type = Type::real, .rule = Rule::none, .unit = "N m"},
      {.name = "creepage.longitudinal", .offset = offsetof(wrc_region, creepage.longitudinal), .type = Type::real, .rule = Rule::range, .low = -10, .high = 10, .too_small = "did you pass per mille?", .too_large = "did you pass per mille?"},
      {.name = "creepage.lateral", .offset = offsetof(wrc_region, creepage.lateral), .type = Type::real, .rule = Rule::range, .low = -10, .high = 10, .too_small = "did you pass per mille?", .too_large = "did you pass per mille?"},
      {.name = "creepage.spin", .offset = offsetof(wrc_region, creepage.spin), .type = Type::real, .rule = Rule::range, .low = -1000, .high = 1000, .unit = "1/m"},
      {.name = "creepage.speed", .offset = offsetof(wrc_region, creepage.speed), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h?", .too_large = "did you pass km/h?"},
      {.name = "creepage.approach_velocity", .offset = offsetof(wrc_region, creepage.approach_velocity), .type = Type::real, .rule = Rule::none, .unit = "m/s"},
      {.name = "creepage.reverse_share", .offset = offsetof(wrc_region, creepage.reverse_share), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "it is a result of wrc_planar_creepages", .too_large = "the way of creepage.speed has the larger share"},
      {.name = "creepage.reserved", .offset = offsetof(wrc_region, creepage.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "ellipse.a", .offset = offsetof(wrc_region, ellipse.a), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.b", .offset = offsetof(wrc_region, ellipse.b), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.psi", .offset = offsetof(wrc_region, ellipse.psi), .type = Type::real, .rule = Rule::range, .low = -0.95, .high = 0.95},
      {.name = "ellipse.y", .offset = offsetof(wrc_region, ellipse.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "ellipse.normal_force", .offset = offsetof(wrc_region, ellipse.normal_force), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e7, .unit = "N", .negative = "the normal force is compressive positive", .too_large = "did you pass mN?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.reserved", .offset = offsetof(wrc_region, ellipse.reserved), .type = Type::real, .elements = 3, .rule = Rule::zero},
      {.name = "area", .offset = offsetof(wrc_region, area), .type = Type::real, .rule = Rule::none, .unit = "m^2"},
      {.name = "length", .offset = offsetof(wrc_region, length), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "width", .offset = offsetof(wrc_region, width), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y_min", .offset = offsetof(wrc_region, y_min), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y_max", .offset = offsetof(wrc_region, y_max), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "peak_pressure", .offset = offsetof(wrc_region, peak_pressure), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "power", .offset = offsetof(wrc_region, power), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "adhesion_fraction", .offset = offsetof(wrc_region, adhesion_fraction), .type = Type::real, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_region) == 408, "run tools/interface/describe.py");

template <>
struct Description<wrc_damage> {
  static constexpr const char* name = "wrc_damage";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_damage>(128);
  static constexpr wrc_damage defaults = [] {
    wrc_damage value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "power", .offset = offsetof(wrc_damage, power), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "peak_power_density", .offset = offsetof(wrc_damage, peak_power_density), .type = Type::real, .rule = Rule::none, .unit = "W/m^2"},
      {.name = "t_gamma", .offset = offsetof(wrc_damage, t_gamma), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "t_gamma_no_spin", .offset = offsetof(wrc_damage, t_gamma_no_spin), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "utilisation", .offset = offsetof(wrc_damage, utilisation), .type = Type::real, .rule = Rule::none},
      {.name = "load_factor", .offset = offsetof(wrc_damage, load_factor), .type = Type::real, .rule = Rule::none},
      {.name = "shakedown_limit", .offset = offsetof(wrc_damage, shakedown_limit), .type = Type::real, .rule = Rule::none},
      {.name = "fatigue_index", .offset = offsetof(wrc_damage, fatigue_index), .type = Type::real, .rule = Rule::none},
      {.name = "local_fatigue_index", .offset = offsetof(wrc_damage, local_fatigue_index), .type = Type::real, .rule = Rule::none},
      {.name = "available", .offset = offsetof(wrc_damage, available), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_damage, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "reserved", .offset = offsetof(wrc_damage, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_damage) == 128, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_pose> {
  static constexpr const char* name = "wrc_planar_pose";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_planar_pose>(48);
  static constexpr wrc_planar_pose defaults = [] {
    wrc_planar_pose value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "lateral", .offset = offsetof(wrc_planar_pose, lateral), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "roll", .offset = offsetof(wrc_planar_pose, roll), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?"},
      {.name = "yaw", .offset = offsetof(wrc_planar_pose, yaw), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?"},
      {.name = "reserved", .offset = offsetof(wrc_planar_pose, reserved), .type = Type::real, .elements = 3, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_pose) == 48, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_motion> {
  static constexpr const char* name = "wrc_planar_motion";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_planar_motion>(80);
  static constexpr wrc_planar_motion defaults = [] {
    wrc_planar_motion value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "speed", .offset = offsetof(wrc_planar_motion, speed), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h?", .too_large = "did you pass km/h?"},
      {.name = "lateral_velocity", .offset = offsetof(wrc_planar_motion, lateral_velocity), .type = Type::real, .rule = Rule::range, .low = -20, .high = 20, .unit = "m/s"},
      {.name = "vertical_velocity", .offset = offsetof(wrc_planar_motion, vertical_velocity), .type = Type::real, .rule = Rule::range, .low = -20, .high = 20, .unit = "m/s"},
      {.name = "roll_rate", .offset = offsetof(wrc_planar_motion, roll_rate), .type = Type::real, .rule = Rule::range, .low = -100, .high = 100, .unit = "rad/s", .too_small = "did you pass degrees?", .too_large = "did you pass degrees?"},
      {.name = "yaw_rate", .offset = offsetof(wrc_planar_motion, yaw_rate), .type = Type::real, .rule = Rule::range, .low = -100, .high = 100, .unit = "rad/s", .too_small = "did you pass degrees?", .too_large = "did you pass degrees?"},
      {.name = "pitch_rate", .offset = offsetof(wrc_planar_motion, pitch_rate), .type = Type::real, .rule = Rule::range, .low = -2000, .high = 2000, .unit = "rad/s", .too_small = "did you pass rpm?", .too_large = "did you pass rpm?"},
      {.name = "reserved", .offset = offsetof(wrc_planar_motion, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_motion) == 80, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_point> {
  static constexpr const char* name = "wrc_planar_point";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_planar_point>(96);
  static constexpr wrc_planar_point defaults = [] {
    wrc_planar_point value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "x", .offset = offsetof(wrc_planar_point, x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y", .offset = offsetof(wrc_planar_point, y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "z", .offset = offsetof(wrc_planar_point, z), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y_wheel", .offset = offsetof(wrc_planar_point, y_wheel), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y_rail", .offset = offsetof(wrc_planar_point, y_rail), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "angle", .offset = offsetof(wrc_planar_point, angle), .type = Type::real, .rule = Rule::none, .unit = "rad"},
      {.name = "vertical_gap", .offset = offsetof(wrc_planar_point, vertical_gap), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "rolling_radius", .offset = offsetof(wrc_planar_point, rolling_radius), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "reserved", .offset = offsetof(wrc_planar_point, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_point) == 96, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_gap> {
  static constexpr const char* name = "wrc_planar_gap";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_planar_gap>(96);
  static constexpr wrc_planar_gap defaults = [] {
    wrc_planar_gap value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "row_count", .offset = offsetof(wrc_planar_gap, row_count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 4096, .too_small = "a gap needs at least four rows", .too_large = "raise config.planar.gap_rows", .not_set = "was it set? its default is 0"},
      {.name = "column_count", .offset = offsetof(wrc_planar_gap, column_count), .type = Type::uint32, .rule = Rule::range, .low = 3, .high = 100000, .or_zero = true},
      {.name = "y", .offset = offsetof(wrc_planar_gap, y), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.3, .high = 0.3, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_planar_gap, row_count)},
      {.name = "height", .offset = offsetof(wrc_planar_gap, height), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.3, .high = 0.3, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_planar_gap, column_count), .state = State::zero, .counted_by = offsetof(wrc_planar_gap, row_count)},
      {.name = "centre", .offset = offsetof(wrc_planar_gap, centre), .type = Type::pointer, .rule = Rule::range, .low = -0.3, .high = 0.3, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_planar_gap, column_count), .state = State::zero, .counted_by = offsetof(wrc_planar_gap, row_count)},
      {.name = "curvature", .offset = offsetof(wrc_planar_gap, curvature), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 1e-3, .high = 1e6, .unit = "1/m", .too_small = "rows must be convex; did you pass 1/mm, or a radius?", .too_large = "did you pass 1/um?", .asked = offsetof(wrc_planar_gap, column_count), .state = State::zero, .counted_by = offsetof(wrc_planar_gap, row_count)},
      {.name = "x", .offset = offsetof(wrc_planar_gap, x), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.3, .high = 0.3, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_planar_gap, column_count), .state = State::not_zero, .counted_by = offsetof(wrc_planar_gap, column_count)},
      {.name = "h", .offset = offsetof(wrc_planar_gap, h), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.3, .high = 0.3, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_planar_gap, column_count), .state = State::not_zero, .by_caller = true},
      {.name = "row_stride", .offset = offsetof(wrc_planar_gap, row_stride), .type = Type::uint64, .rule = Rule::none},
      {.name = "reserved", .offset = offsetof(wrc_planar_gap, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_gap) == 96, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_load> {
  static constexpr const char* name = "wrc_planar_load";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_planar_load>(72);
  static constexpr wrc_planar_load defaults = [] {
    wrc_planar_load value{};
    value.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "prescribed", .offset = offsetof(wrc_planar_load, prescribed), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_prescribed},
      {.name = "reserved0", .offset = offsetof(wrc_planar_load, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "normal_force", .offset = offsetof(wrc_planar_load, normal_force), .type = Type::real, .rule = Rule::range, .low = 1e2, .high = 1e6, .unit = "N", .negative = "the normal force is compressive positive; prescribe the approach near lift-off", .too_small = "did you pass kN? near lift-off prescribe the approach instead", .too_large = "did you pass a pressure, or grams?", .not_set = "was it set? WRC_PRESCRIBE_NORMAL_FORCE needs it, and its default is 0", .asked = offsetof(wrc_planar_load, prescribed), .asked_for = WRC_PRESCRIBE_NORMAL_FORCE},
      {.name = "approach", .offset = offsetof(wrc_planar_load, approach), .type = Type::real, .rule = Rule::range, .low = -1, .high = 0.01, .unit = "m", .too_large = "did you pass mm or um?", .asked = offsetof(wrc_planar_load, prescribed), .asked_for = WRC_PRESCRIBE_APPROACH},
      {.name = "approach_velocity", .offset = offsetof(wrc_planar_load, approach_velocity), .type = Type::real, .rule = Rule::range, .low = -20, .high = 20, .unit = "m/s", .too_small = "did you pass mm/s?", .too_large = "did you pass mm/s?", .asked = offsetof(wrc_planar_load, prescribed), .asked_for = WRC_PRESCRIBE_APPROACH},
      {.name = "damping", .offset = offsetof(wrc_planar_load, damping), .type = Type::real, .rule = Rule::range, .low = 0, .high = 10, .unit = "s/m", .negative = "damping takes energy out", .too_large = "it is not a viscous constant: that over 3/2 of the force it was found at", .asked = offsetof(wrc_planar_load, prescribed), .asked_for = WRC_PRESCRIBE_APPROACH},
      {.name = "reserved", .offset = offsetof(wrc_planar_load, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_load) == 72, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_strips> {
  static constexpr const char* name = "wrc_planar_strips";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_planar_strips>(80);
  static constexpr wrc_planar_strips defaults = [] {
    wrc_planar_strips value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "count", .offset = offsetof(wrc_planar_strips, count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 512, .too_large = "raise config.planar.strips", .not_set = "was it set? its default is 0"},
      {.name = "reserved0", .offset = offsetof(wrc_planar_strips, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "y", .offset = offsetof(wrc_planar_strips, y), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.3, .high = 0.3, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_planar_strips, count)},
      {.name = "width", .offset = offsetof(wrc_planar_strips, width), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 1e-9, .high = 0.1, .unit = "m", .too_small = "leave out strips without width", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_planar_strips, count)},
      {.name = "centre", .offset = offsetof(wrc_planar_strips, centre), .type = Type::pointer, .rule = Rule::range, .low = -0.3, .high = 0.3, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_planar_strips, count)},
      {.name = "half_length", .offset = offsetof(wrc_planar_strips, half_length), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 1e-9, .high = 0.1, .unit = "m", .too_small = "leave out strips without length", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_planar_strips, count)},
      {.name = "peak", .offset = offsetof(wrc_planar_strips, peak), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 1e11, .unit = "Pa", .too_small = "pressure is compressive positive", .too_large = "steel yields at a tenth of that", .counted_by = offsetof(wrc_planar_strips, count)},
      {.name = "reserved", .offset = offsetof(wrc_planar_strips, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_strips) == 80, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_normal_solution> {
  static constexpr const char* name = "wrc_planar_normal_solution";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_planar_normal_solution>(192);
  static constexpr wrc_planar_normal_solution defaults = [] {
    wrc_planar_normal_solution value{};
    value.ellipse = Description<wrc_ellipse>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "patch_count", .offset = offsetof(wrc_planar_normal_solution, patch_count), .type = Type::int32, .rule = Rule::none},
      {.name = "strip_count", .offset = offsetof(wrc_planar_normal_solution, strip_count), .type = Type::int32, .rule = Rule::none},
      {.name = "iterations", .offset = offsetof(wrc_planar_normal_solution, iterations), .type = Type::int32, .rule = Rule::none},
      {.name = "flags", .offset = offsetof(wrc_planar_normal_solution, flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "ellipse.a", .offset = offsetof(wrc_planar_normal_solution, ellipse.a), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.b", .offset = offsetof(wrc_planar_normal_solution, ellipse.b), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.psi", .offset = offsetof(wrc_planar_normal_solution, ellipse.psi), .type = Type::real, .rule = Rule::range, .low = -0.95, .high = 0.95},
      {.name = "ellipse.y", .offset = offsetof(wrc_planar_normal_solution, ellipse.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "ellipse.normal_force", .offset = offsetof(wrc_planar_normal_solution, ellipse.normal_force), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e7, .unit = "N", .negative = "the normal force is compressive positive", .too_large = "did you pass mN?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.reserved", .offset = offsetof(wrc_planar_normal_solution, ellipse.reserved), .type = Type::real, .elements = 3, .rule = Rule::zero},
      {.name = "normal_force", .offset = offsetof(wrc_planar_normal_solution, normal_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "damping_force", .offset = offsetof(wrc_planar_normal_solution, damping_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "approach", .offset = offsetof(wrc_planar_normal_solution, approach), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "stiffness", .offset = offsetof(wrc_planar_normal_solution, stiffness), .type = Type::real, .rule = Rule::none, .unit = "N/m"},
      {.name = "peak_pressure", .offset = offsetof(wrc_planar_normal_solution, peak_pressure), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "area", .offset = offsetof(wrc_planar_normal_solution, area), .type = Type::real, .rule = Rule::none, .unit = "m^2"},
      {.name = "length", .offset = offsetof(wrc_planar_normal_solution, length), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "width", .offset = offsetof(wrc_planar_normal_solution, width), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y_min", .offset = offsetof(wrc_planar_normal_solution, y_min), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y_max", .offset = offsetof(wrc_planar_normal_solution, y_max), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "reserved", .offset = offsetof(wrc_planar_normal_solution, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_normal_solution) == 192, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_forces> {
  static constexpr const char* name = "wrc_planar_forces";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_planar_forces>(88);
  static constexpr wrc_planar_forces defaults = [] {
    wrc_planar_forces value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "fx", .offset = offsetof(wrc_planar_forces, fx), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "fy", .offset = offsetof(wrc_planar_forces, fy), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "fn", .offset = offsetof(wrc_planar_forces, fn), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "mz", .offset = offsetof(wrc_planar_forces, mz), .type = Type::real, .rule = Rule::none, .unit = "N m"},
      {.name = "power", .offset = offsetof(wrc_planar_forces, power), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "adhesion_fraction", .offset = offsetof(wrc_planar_forces, adhesion_fraction), .type = Type::real, .rule = Rule::none},
      {.name = "available", .offset = offsetof(wrc_planar_forces, available), .type = Type::uint32, .rule = Rule::none},
      {.name = "flags", .offset = offsetof(wrc_planar_forces, flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved", .offset = offsetof(wrc_planar_forces, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_forces) == 88, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_derivatives> {
  static constexpr const char* name = "wrc_planar_derivatives";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_planar_derivatives>(200);
  static constexpr wrc_planar_derivatives defaults = [] {
    wrc_planar_derivatives value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_planar_derivatives, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_planar_derivatives, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "forces", .offset = offsetof(wrc_planar_derivatives, forces), .type = Type::real, .elements = 24, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_derivatives) == 200, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_input> {
  static constexpr const char* name = "wrc_planar_input";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_planar_input>(456);
  static constexpr wrc_planar_input defaults = [] {
    wrc_planar_input value{};
    value.struct_size = sizeof value;
    value.pose = Description<wrc_planar_pose>::defaults;
    value.load = Description<wrc_planar_load>::defaults;
    value.creepage = Description<wrc_creepage>::defaults;
    value.friction = Description<wrc_friction>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_planar_input, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_planar_input, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "pose.lateral", .offset = offsetof(wrc_planar_input, pose.lateral), .type = Type::real, .rule = Rule::range, .low = -0.1, .high = 0.1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "pose.roll", .offset = offsetof(wrc_planar_input, pose.roll), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?"},
      {.name = "pose.yaw", .offset = offsetof(wrc_planar_input, pose.yaw), .type = Type::real, .rule = Rule::range, .low = -0.2, .high = 0.2, .unit = "rad", .too_small = "did you pass degrees or mrad?", .too_large = "did you pass degrees or mrad?"},
      {.name = "pose.reserved", .offset = offsetof(wrc_planar_input, pose.reserved), .type = Type::real, .elements = 3, .rule = Rule::zero},
      {.name = "gap", .offset = offsetof(wrc_planar_input, gap), .type = Type::pointer, .rule = Rule::none},
      {.name = "load.prescribed", .offset = offsetof(wrc_planar_input, load.prescribed), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_prescribed},
      {.name = "load.reserved0", .offset = offsetof(wrc_planar_input, load.reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "load.normal_force", .offset = offsetof(wrc_planar_input, load.normal_force), .type = Type::real, .rule = Rule::range, .low = 1e2, .high = 1e6, .unit = "N", .negative = "the normal force is compressive positive; prescribe the approach near lift-off", .too_small = "did you pass kN? near lift-off prescribe the approach instead", .too_large = "did you pass a pressure, or grams?", .not_set = "was it set? WRC_PRESCRIBE_NORMAL_FORCE needs it, and its default is 0", .asked = offsetof(wrc_planar_input, load.prescribed), .asked_for = WRC_PRESCRIBE_NORMAL_FORCE},
      {.name = "load.approach", .offset = offsetof(wrc_planar_input, load.approach), .type = Type::real, .rule = Rule::range, .low = -1, .high = 0.01, .unit = "m", .too_large = "did you pass mm or um?", .asked = offsetof(wrc_planar_input, load.prescribed), .asked_for = WRC_PRESCRIBE_APPROACH},
      {.name = "load.approach_velocity", .offset = offsetof(wrc_planar_input, load.approach_velocity), .type = Type::real, .rule = Rule::range, .low = -20, .high = 20, .unit = "m/s", .too_small = "did you pass mm/s?", .too_large = "did you pass mm/s?", .asked = offsetof(wrc_planar_input, load.prescribed), .asked_for = WRC_PRESCRIBE_APPROACH},
      {.name = "load.damping", .offset = offsetof(wrc_planar_input, load.damping), .type = Type::real, .rule = Rule::range, .low = 0, .high = 10, .unit = "s/m", .negative = "damping takes energy out", .too_large = "it is not a viscous constant: that over 3/2 of the force it was found at", .asked = offsetof(wrc_planar_input, load.prescribed), .asked_for = WRC_PRESCRIBE_APPROACH},
      {.name = "load.reserved", .offset = offsetof(wrc_planar_input, load.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "creepage.longitudinal", .offset = offsetof(wrc_planar_input, creepage.longitudinal), .type = Type::real, .rule = Rule::range, .low = -10, .high = 10, .too_small = "did you pass per mille?", .too_large = "did you pass per mille?"},
      {.name = "creepage.lateral", .offset = offsetof(wrc_planar_input, creepage.lateral), .type = Type::real, .rule = Rule::range, .low = -10, .high = 10, .too_small = "did you pass per mille?", .too_large = "did you pass per mille?"},
      {.name = "creepage.spin", .offset = offsetof(wrc_planar_input, creepage.spin), .type = Type::real, .rule = Rule::range, .low = -1000, .high = 1000, .unit = "1/m"},
      {.name = "creepage.speed", .offset = offsetof(wrc_planar_input, creepage.speed), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h?", .too_large = "did you pass km/h?"},
      {.name = "creepage.approach_velocity", .offset = offsetof(wrc_planar_input, creepage.approach_velocity), .type = Type::real, .rule = Rule::none, .unit = "m/s"},
      {.name = "creepage.reverse_share", .offset = offsetof(wrc_planar_input, creepage.reverse_share), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "it is a result of wrc_planar_creepages", .too_large = "the way of creepage.speed has the larger share"},
      {.name = "creepage.reserved", .offset = offsetof(wrc_planar_input, creepage.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "friction.coefficient", .offset = offsetof(wrc_planar_input, friction.coefficient), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 2, .or_zero = true, .too_small = "friction must be positive", .too_large = "did you pass per cent?"},
      {.name = "friction.speed_law", .offset = offsetof(wrc_planar_input, friction.speed_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_speed_law},
      {.name = "friction.temperature_law", .offset = offsetof(wrc_planar_input, friction.temperature_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_temperature_law},
      {.name = "friction.kinetic_ratio", .offset = offsetof(wrc_planar_input, friction.kinetic_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient at rest"},
      {.name = "friction.fall_rate", .offset = offsetof(wrc_planar_input, friction.fall_rate), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000, .unit = "s/m", .too_small = "friction falls with positive rates"},
      {.name = "friction.half_speed", .offset = offsetof(wrc_planar_input, friction.half_speed), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .unit = "m/s"},
      {.name = "friction.hot_ratio", .offset = offsetof(wrc_planar_input, friction.hot_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient of cold surfaces"},
      {.name = "friction.cold_temperature", .offset = offsetof(wrc_planar_input, friction.cold_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC"},
      {.name = "friction.hot_temperature", .offset = offsetof(wrc_planar_input, friction.hot_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 3000, .unit = "degC"},
      {.name = "friction.bulk.wheel", .offset = offsetof(wrc_planar_input, friction.bulk.wheel), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "friction.bulk.rail", .offset = offsetof(wrc_planar_input, friction.bulk.rail), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "friction.bulk.reserved", .offset = offsetof(wrc_planar_input, friction.bulk.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "friction.slope_reduction", .offset = offsetof(wrc_planar_input, friction.slope_reduction), .type = Type::real, .rule = Rule::range, .low = 0.01, .high = 1, .too_small = "clean bodies have 1", .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.slope_limit", .offset = offsetof(wrc_planar_input, friction.slope_limit), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "friction.slope_fall", .offset = offsetof(wrc_planar_input, friction.slope_fall), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000},
      {.name = "friction.zone_y", .offset = offsetof(wrc_planar_input, friction.zone_y), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_planar_input, friction.zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_planar_input, friction.zone_count)},
      {.name = "friction.zone_coefficients", .offset = offsetof(wrc_planar_input, friction.zone_coefficients), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 2, .too_small = "friction is not negative", .too_large = "did you pass per cent?", .asked = offsetof(wrc_planar_input, friction.zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_planar_input, friction.zone_count)},
      {.name = "friction.zone_count", .offset = offsetof(wrc_planar_input, friction.zone_count), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 64},
      {.name = "friction.zone_frame", .offset = offsetof(wrc_planar_input, friction.zone_frame), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_zone_frame},
      {.name = "friction.layer_thickness", .offset = offsetof(wrc_planar_input, friction.layer_thickness), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.01, .unit = "m"},
      {.name = "friction.layer_modulus", .offset = offsetof(wrc_planar_input, friction.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "friction.layer_yield", .offset = offsetof(wrc_planar_input, friction.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "friction.layer_hardening", .offset = offsetof(wrc_planar_input, friction.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "friction.adhesion_reduction", .offset = offsetof(wrc_planar_input, friction.adhesion_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.slip_reduction", .offset = offsetof(wrc_planar_input, friction.slip_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.film_rows", .offset = offsetof(wrc_planar_input, friction.film_rows), .type = Type::pointer, .rule = Rule::range, .low = -1e30, .high = 1e30, .counted_by = offsetof(wrc_planar_input, friction.film_numbers), .by_caller = true},
      {.name = "friction.film_numbers", .offset = offsetof(wrc_planar_input, friction.film_numbers), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1288},
      {.name = "friction.reserved0", .offset = offsetof(wrc_planar_input, friction.reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "friction.reserved", .offset = offsetof(wrc_planar_input, friction.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_input) == 456, "run tools/interface/describe.py");

template <>
struct Description<wrc_planar_output> {
  static constexpr const char* name = "wrc_planar_output";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_planar_output>(512);
  static constexpr wrc_planar_output defaults = [] {
    wrc_planar_output value{};
    value.struct_size = sizeof value;
    value.point = Description<wrc_planar_point>::defaults;
    value.normal = Description<wrc_planar_normal_solution>::defaults;
    value.forces = Description<wrc_planar_forces>::defaults;
    value.damage = Description<wrc_damage>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_planar_output, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "flags", .offset = offsetof(wrc_planar_output, flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "point.x", .offset = offsetof(wrc_planar_output, point.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "point.y", .offset = offsetof(wrc_planar_output, point.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "point.z", .offset = offsetof(wrc_planar_output, point.z), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "point.y_wheel", .offset = offsetof(wrc_planar_output, point.y_wheel), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "point.y_rail", .offset = offsetof(wrc_planar_output, point.y_rail), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "point.angle", .offset = offsetof(wrc_planar_output, point.angle), .type = Type::real, .rule = Rule::none, .unit = "rad"},
      {.name = "point.vertical_gap", .offset = offsetof(wrc_planar_output, point.vertical_gap), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "point.rolling_radius", .offset = offsetof(wrc_planar_output, point.rolling_radius), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "point.reserved", .offset = offsetof(wrc_planar_output, point.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "normal.patch_count", .offset = offsetof(wrc_planar_output, normal.patch_count), .type = Type::int32, .rule = Rule::none},
      {.name = "normal.strip_count", .offset = offsetof(wrc_planar_output, normal.strip_count), .type = Type::int32, .rule = Rule::none},
      {.name = "normal.iterations", .offset = offsetof(wrc_planar_output, normal.iterations), .type = Type::int32, .rule = Rule::none},
      {.name = "normal.flags", .offset = offsetof(wrc_planar_output, normal.flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "normal.ellipse.a", .offset = offsetof(wrc_planar_output, normal.ellipse.a), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "normal.ellipse.b", .offset = offsetof(wrc_planar_output, normal.ellipse.b), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "normal.ellipse.psi", .offset = offsetof(wrc_planar_output, normal.ellipse.psi), .type = Type::real, .rule = Rule::range, .low = -0.95, .high = 0.95},
      {.name = "normal.ellipse.y", .offset = offsetof(wrc_planar_output, normal.ellipse.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal.ellipse.normal_force", .offset = offsetof(wrc_planar_output, normal.ellipse.normal_force), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e7, .unit = "N", .negative = "the normal force is compressive positive", .too_large = "did you pass mN?", .not_set = "was it set? its default is 0"},
      {.name = "normal.ellipse.reserved", .offset = offsetof(wrc_planar_output, normal.ellipse.reserved), .type = Type::real, .elements = 3, .rule = Rule::zero},
      {.name = "normal.normal_force", .offset = offsetof(wrc_planar_output, normal.normal_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "normal.damping_force", .offset = offsetof(wrc_planar_output, normal.damping_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "normal.approach", .offset = offsetof(wrc_planar_output, normal.approach), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal.stiffness", .offset = offsetof(wrc_planar_output, normal.stiffness), .type = Type::real, .rule = Rule::none, .unit = "N/m"},
      {.name = "normal.peak_pressure", .offset = offsetof(wrc_planar_output, normal.peak_pressure), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "normal.area", .offset = offsetof(wrc_planar_output, normal.area), .type = Type::real, .rule = Rule::none, .unit = "m^2"},
      {.name = "normal.length", .offset = offsetof(wrc_planar_output, normal.length), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal.width", .offset = offsetof(wrc_planar_output, normal.width), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal.y_min", .offset = offsetof(wrc_planar_output, normal.y_min), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal.y_max", .offset = offsetof(wrc_planar_output, normal.y_max), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal.reserved", .offset = offsetof(wrc_planar_output, normal.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "forces.fx", .offset = offsetof(wrc_planar_output, forces.fx), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "forces.fy", .offset = offsetof(wrc_planar_output, forces.fy), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "forces.fn", .offset = offsetof(wrc_planar_output, forces.fn), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "forces.mz", .offset = offsetof(wrc_planar_output, forces.mz), .type = Type::real, .rule = Rule::none, .unit = "N m"},
      {.name = "forces.power", .offset = offsetof(wrc_planar_output, forces.power), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "forces.adhesion_fraction", .offset = offsetof(wrc_planar_output, forces.adhesion_fraction), .type = Type::real, .rule = Rule::none},
      {.name = "forces.available", .offset = offsetof(wrc_planar_output, forces.available), .type = Type::uint32, .rule = Rule::none},
      {.name = "forces.flags", .offset = offsetof(wrc_planar_output, forces.flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "forces.reserved", .offset = offsetof(wrc_planar_output, forces.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "damage.power", .offset = offsetof(wrc_planar_output, damage.power), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "damage.peak_power_density", .offset = offsetof(wrc_planar_output, damage.peak_power_density), .type = Type::real, .rule = Rule::none, .unit = "W/m^2"},
      {.name = "damage.t_gamma", .offset = offsetof(wrc_planar_output, damage.t_gamma), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "damage.t_gamma_no_spin", .offset = offsetof(wrc_planar_output, damage.t_gamma_no_spin), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "damage.utilisation", .offset = offsetof(wrc_planar_output, damage.utilisation), .type = Type::real, .rule = Rule::none},
      {.name = "damage.load_factor", .offset = offsetof(wrc_planar_output, damage.load_factor), .type = Type::real, .rule = Rule::none},
      {.name = "damage.shakedown_limit", .offset = offsetof(wrc_planar_output, damage.shakedown_limit), .type = Type::real, .rule = Rule::none},
      {.name = "damage.fatigue_index", .offset = offsetof(wrc_planar_output, damage.fatigue_index), .type = Type::real, .rule = Rule::none},
      {.name = "damage.local_fatigue_index", .offset = offsetof(wrc_planar_output, damage.local_fatigue_index), .type = Type::real, .rule = Rule::none},
      {.name = "damage.available", .offset = offsetof(wrc_planar_output, damage.available), .type = Type::uint32, .rule = Rule::none},
      {.name = "damage.reserved0", .offset = offsetof(wrc_planar_output, damage.reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "damage.reserved", .offset = offsetof(wrc_planar_output, damage.reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_planar_output) == 512, "run tools/interface/describe.py");

template <>
struct Description<wrc_wear_laws> {
  static constexpr const char* name = "wrc_wear_laws";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_wear_laws>(184);
  static constexpr wrc_wear_laws defaults = [] {
    wrc_wear_laws value{};
    value.struct_size = sizeof value;
    value.t_gamma_mild_end = 100;
    value.t_gamma_severe_start = 200;
    value.t_gamma_mild_slope = 0.25;
    value.t_gamma_plateau = 25;
    value.t_gamma_severe_slope = 1.19;
    value.t_gamma_severe_offset = 154;
    value.sheffield_mild_end = 10.4;
    value.sheffield_severe_end = 77.2;
    value.sheffield_mild_slope = 5.3;
    value.sheffield_catastrophic_slope = 61.9;
    value.density = 7850;
    value.hardness = 3e9;
    value.archard_slow = 5e-4;
    value.archard_severe = 35e-4;
    value.archard_fast = 5e-4;
    value.archard_seizure = 350e-4;
    value.archard_severe_start = 0.2;
    value.archard_severe_end = 0.7;
    value.seizure_pressure = 0.8;
    value.power_coefficient = 7e-10;
    value.power_exponent = 1;
    value.power_reference = 4e6;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_wear_laws, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_wear_laws, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "t_gamma_mild_end", .offset = offsetof(wrc_wear_laws, t_gamma_mild_end), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e9, .unit = "N"},
      {.name = "t_gamma_severe_start", .offset = offsetof(wrc_wear_laws, t_gamma_severe_start), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e9, .unit = "N"},
      {.name = "t_gamma_mild_slope", .offset = offsetof(wrc_wear_laws, t_gamma_mild_slope), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e6, .unit = "mm^3/(km N)"},
      {.name = "t_gamma_plateau", .offset = offsetof(wrc_wear_laws, t_gamma_plateau), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e9, .unit = "mm^3/km"},
      {.name = "t_gamma_severe_slope", .offset = offsetof(wrc_wear_laws, t_gamma_severe_slope), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e6, .unit = "mm^3/(km N)"},
      {.name = "t_gamma_severe_offset", .offset = offsetof(wrc_wear_laws, t_gamma_severe_offset), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e15, .unit = "mm^3/km"},
      {.name = "sheffield_mild_end", .offset = offsetof(wrc_wear_laws, sheffield_mild_end), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 1e9, .unit = "N/mm^2"},
      {.name = "sheffield_severe_end", .offset = offsetof(wrc_wear_laws, sheffield_severe_end), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 1e9, .unit = "N/mm^2"},
      {.name = "sheffield_mild_slope", .offset = offsetof(wrc_wear_laws, sheffield_mild_slope), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e6, .unit = "microgram/(m N)"},
      {.name = "sheffield_catastrophic_slope", .offset = offsetof(wrc_wear_laws, sheffield_catastrophic_slope), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e6, .unit = "microgram/(m N)"},
      {.name = "density", .offset = offsetof(wrc_wear_laws, density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3"},
      {.name = "hardness", .offset = offsetof(wrc_wear_laws, hardness), .type = Type::real, .rule = Rule::range, .low = 1e6, .high = 1e12, .unit = "Pa", .too_small = "did you pass MPa, or a Vickers number?"},
      {.name = "archard_slow", .offset = offsetof(wrc_wear_laws, archard_slow), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "archard_severe", .offset = offsetof(wrc_wear_laws, archard_severe), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "archard_fast", .offset = offsetof(wrc_wear_laws, archard_fast), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "archard_seizure", .offset = offsetof(wrc_wear_laws, archard_seizure), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "archard_severe_start", .offset = offsetof(wrc_wear_laws, archard_severe_start), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000, .unit = "m/s"},
      {.name = "archard_severe_end", .offset = offsetof(wrc_wear_laws, archard_severe_end), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000, .unit = "m/s"},
      {.name = "seizure_pressure", .offset = offsetof(wrc_wear_laws, seizure_pressure), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000},
      {.name = "power_coefficient", .offset = offsetof(wrc_wear_laws, power_coefficient), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .unit = "kg/J", .too_small = "did you pass microgram/J?", .too_large = "did you pass microgram/J?"},
      {.name = "power_exponent", .offset = offsetof(wrc_wear_laws, power_exponent), .type = Type::real, .rule = Rule::range, .low = 0.25, .high = 4},
      {.name = "power_reference", .offset = offsetof(wrc_wear_laws, power_reference), .type = Type::real, .rule = Rule::range, .low = 1, .high = 1e12, .unit = "W/m^2", .too_small = "did you pass W/mm^2?"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_wear_laws) == 184, "run tools/interface/describe.py");

template <>
struct Description<wrc_wear> {
  static constexpr const char* name = "wrc_wear";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_wear>(80);
  static constexpr wrc_wear defaults = [] {
    wrc_wear value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "worn_area_rate", .offset = offsetof(wrc_wear, worn_area_rate), .type = Type::real, .rule = Rule::none, .unit = "m^2/m"},
      {.name = "largest_depth_rate", .offset = offsetof(wrc_wear, largest_depth_rate), .type = Type::real, .rule = Rule::none, .unit = "m/m"},
      {.name = "largest_depth_velocity", .offset = offsetof(wrc_wear, largest_depth_velocity), .type = Type::real, .rule = Rule::none, .unit = "m/s"},
      {.name = "largest_power_depth_velocity", .offset = offsetof(wrc_wear, largest_power_depth_velocity), .type = Type::real, .rule = Rule::none, .unit = "m/s"},
      {.name = "reserved", .offset = offsetof(wrc_wear, reserved), .type = Type::real, .elements = 6, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_wear) == 80, "run tools/interface/describe.py");

template <>
struct Description<wrc_coefficients> {
  static constexpr const char* name = "wrc_coefficients";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_coefficients>(88);
  static constexpr wrc_coefficients defaults = [] {
    wrc_coefficients value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "c11", .offset = offsetof(wrc_coefficients, c11), .type = Type::real, .rule = Rule::none},
      {.name = "c22", .offset = offsetof(wrc_coefficients, c22), .type = Type::real, .rule = Rule::none},
      {.name = "c23", .offset = offsetof(wrc_coefficients, c23), .type = Type::real, .rule = Rule::none},
      {.name = "c11s", .offset = offsetof(wrc_coefficients, c11s), .type = Type::real, .rule = Rule::none},
      {.name = "c13s", .offset = offsetof(wrc_coefficients, c13s), .type = Type::real, .rule = Rule::none},
      {.name = "c22s", .offset = offsetof(wrc_coefficients, c22s), .type = Type::real, .rule = Rule::none},
      {.name = "c23s", .offset = offsetof(wrc_coefficients, c23s), .type = Type::real, .rule = Rule::none},
      {.name = "reserved", .offset = offsetof(wrc_coefficients, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_coefficients) == 88, "run tools/interface/describe.py");

template <>
struct Description<wrc_stress_peak> {
  static constexpr const char* name = "wrc_stress_peak";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_stress_peak>(48);
  static constexpr wrc_stress_peak defaults = [] {
    wrc_stress_peak value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "stress", .offset = offsetof(wrc_stress_peak, stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "x", .offset = offsetof(wrc_stress_peak, x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y", .offset = offsetof(wrc_stress_peak, y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "depth", .offset = offsetof(wrc_stress_peak, depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "reserved", .offset = offsetof(wrc_stress_peak, reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_stress_peak) == 48, "run tools/interface/describe.py");

template <>
struct Description<wrc_stress_peaks> {
  static constexpr const char* name = "wrc_stress_peaks";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_stress_peaks>(192);
  static constexpr wrc_stress_peaks defaults = [] {
    wrc_stress_peaks value{};
    value.von_mises = Description<wrc_stress_peak>::defaults;
    value.shear = Description<wrc_stress_peak>::defaults;
    value.tension = Description<wrc_stress_peak>::defaults;
    value.reserved = Description<wrc_stress_peak>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "von_mises.stress", .offset = offsetof(wrc_stress_peaks, von_mises.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "von_mises.x", .offset = offsetof(wrc_stress_peaks, von_mises.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "von_mises.y", .offset = offsetof(wrc_stress_peaks, von_mises.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "von_mises.depth", .offset = offsetof(wrc_stress_peaks, von_mises.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "von_mises.reserved", .offset = offsetof(wrc_stress_peaks, von_mises.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "shear.stress", .offset = offsetof(wrc_stress_peaks, shear.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "shear.x", .offset = offsetof(wrc_stress_peaks, shear.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "shear.y", .offset = offsetof(wrc_stress_peaks, shear.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "shear.depth", .offset = offsetof(wrc_stress_peaks, shear.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "shear.reserved", .offset = offsetof(wrc_stress_peaks, shear.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "tension.stress", .offset = offsetof(wrc_stress_peaks, tension.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "tension.x", .offset = offsetof(wrc_stress_peaks, tension.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "tension.y", .offset = offsetof(wrc_stress_peaks, tension.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "tension.depth", .offset = offsetof(wrc_stress_peaks, tension.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "tension.reserved", .offset = offsetof(wrc_stress_peaks, tension.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "reserved.stress", .offset = offsetof(wrc_stress_peaks, reserved.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "reserved.x", .offset = offsetof(wrc_stress_peaks, reserved.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "reserved.y", .offset = offsetof(wrc_stress_peaks, reserved.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "reserved.depth", .offset = offsetof(wrc_stress_peaks, reserved.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "reserved.reserved", .offset = offsetof(wrc_stress_peaks, reserved.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_stress_peaks) == 192, "run tools/interface/describe.py");

template <>
struct Description<wrc_stresses> {
  static constexpr const char* name = "wrc_stresses";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_stresses>(584);
  static constexpr wrc_stresses defaults = [] {
    wrc_stresses value{};
    value.struct_size = sizeof value;
    value.largest = Description<wrc_stress_peaks>::defaults;
    value.surface = Description<wrc_stress_peaks>::defaults;
    value.below = Description<wrc_stress_peaks>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_stresses, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "body", .offset = offsetof(wrc_stresses, body), .type = Type::int32, .rule = Rule::none, .enumeration = &enumerations::wrc_body},
      {.name = "largest.von_mises.stress", .offset = offsetof(wrc_stresses, largest.von_mises.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "largest.von_mises.x", .offset = offsetof(wrc_stresses, largest.von_mises.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.von_mises.y", .offset = offsetof(wrc_stresses, largest.von_mises.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.von_mises.depth", .offset = offsetof(wrc_stresses, largest.von_mises.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.von_mises.reserved", .offset = offsetof(wrc_stresses, largest.von_mises.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "largest.shear.stress", .offset = offsetof(wrc_stresses, largest.shear.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "largest.shear.x", .offset = offsetof(wrc_stresses, largest.shear.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.shear.y", .offset = offsetof(wrc_stresses, largest.shear.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.shear.depth", .offset = offsetof(wrc_stresses, largest.shear.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.shear.reserved", .offset = offsetof(wrc_stresses, largest.shear.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "largest.tension.stress", .offset = offsetof(wrc_stresses, largest.tension.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "largest.tension.x", .offset = offsetof(wrc_stresses, largest.tension.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.tension.y", .offset = offsetof(wrc_stresses, largest.tension.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.tension.depth", .offset = offsetof(wrc_stresses, largest.tension.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.tension.reserved", .offset = offsetof(wrc_stresses, largest.tension.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "largest.reserved.stress", .offset = offsetof(wrc_stresses, largest.reserved.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "largest.reserved.x", .offset = offsetof(wrc_stresses, largest.reserved.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.reserved.y", .offset = offsetof(wrc_stresses, largest.reserved.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.reserved.depth", .offset = offsetof(wrc_stresses, largest.reserved.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest.reserved.reserved", .offset = offsetof(wrc_stresses, largest.reserved.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "surface.von_mises.stress", .offset = offsetof(wrc_stresses, surface.von_mises.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "surface.von_mises.x", .offset = offsetof(wrc_stresses, surface.von_mises.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.von_mises.y", .offset = offsetof(wrc_stresses, surface.von_mises.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.von_mises.depth", .offset = offsetof(wrc_stresses, surface.von_mises.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.von_mises.reserved", .offset = offsetof(wrc_stresses, surface.von_mises.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "surface.shear.stress", .offset = offsetof(wrc_stresses, surface.shear.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "surface.shear.x", .offset = offsetof(wrc_stresses, surface.shear.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.shear.y", .offset = offsetof(wrc_stresses, surface.shear.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.shear.depth", .offset = offsetof(wrc_stresses, surface.shear.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.shear.reserved", .offset = offsetof(wrc_stresses, surface.shear.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "surface.tension.stress", .offset = offsetof(wrc_stresses, surface.tension.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "surface.tension.x", .offset = offsetof(wrc_stresses, surface.tension.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.tension.y", .offset = offsetof(wrc_stresses, surface.tension.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.tension.depth", .offset = offsetof(wrc_stresses, surface.tension.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.tension.reserved", .offset = offsetof(wrc_stresses, surface.tension.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "surface.reserved.stress", .offset = offsetof(wrc_stresses, surface.reserved.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "surface.reserved.x", .offset = offsetof(wrc_stresses, surface.reserved.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.reserved.y", .offset = offsetof(wrc_stresses, surface.reserved.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.reserved.depth", .offset = offsetof(wrc_stresses, surface.reserved.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "surface.reserved.reserved", .offset = offsetof(wrc_stresses, surface.reserved.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "below.von_mises.stress", .offset = offsetof(wrc_stresses, below.von_mises.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "below.von_mises.x", .offset = offsetof(wrc_stresses, below.von_mises.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.von_mises.y", .offset = offsetof(wrc_stresses, below.von_mises.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.von_mises.depth", .offset = offsetof(wrc_stresses, below.von_mises.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.von_mises.reserved", .offset = offsetof(wrc_stresses, below.von_mises.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "below.shear.stress", .offset = offsetof(wrc_stresses, below.shear.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "below.shear.x", .offset = offsetof(wrc_stresses, below.shear.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.shear.y", .offset = offsetof(wrc_stresses, below.shear.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.shear.depth", .offset = offsetof(wrc_stresses, below.shear.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.shear.reserved", .offset = offsetof(wrc_stresses, below.shear.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "below.tension.stress", .offset = offsetof(wrc_stresses, below.tension.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "below.tension.x", .offset = offsetof(wrc_stresses, below.tension.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.tension.y", .offset = offsetof(wrc_stresses, below.tension.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.tension.depth", .offset = offsetof(wrc_stresses, below.tension.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.tension.reserved", .offset = offsetof(wrc_stresses, below.tension.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "below.reserved.stress", .offset = offsetof(wrc_stresses, below.reserved.stress), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "below.reserved.x", .offset = offsetof(wrc_stresses, below.reserved.x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.reserved.y", .offset = offsetof(wrc_stresses, below.reserved.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.reserved.depth", .offset = offsetof(wrc_stresses, below.reserved.depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "below.reserved.reserved", .offset = offsetof(wrc_stresses, below.reserved.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_stresses) == 584, "run tools/interface/describe.py");

template <>
struct Description<wrc_temperature> {
  static constexpr const char* name = "wrc_temperature";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_temperature>(72);
  static constexpr wrc_temperature defaults = [] {
    wrc_temperature value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_temperature, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_temperature, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "at_entry", .offset = offsetof(wrc_temperature, at_entry), .type = Type::real, .rule = Rule::none, .unit = "degC"},
      {.name = "rise", .offset = offsetof(wrc_temperature, rise), .type = Type::real, .rule = Rule::none, .unit = "K"},
      {.name = "x", .offset = offsetof(wrc_temperature, x), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y", .offset = offsetof(wrc_temperature, y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "largest", .offset = offsetof(wrc_temperature, largest), .type = Type::real, .rule = Rule::none, .unit = "degC"},
      {.name = "mean_rise", .offset = offsetof(wrc_temperature, mean_rise), .type = Type::real, .rule = Rule::none, .unit = "K"},
      {.name = "wheel_heat", .offset = offsetof(wrc_temperature, wheel_heat), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "rail_heat", .offset = offsetof(wrc_temperature, rail_heat), .type = Type::real, .rule = Rule::none, .unit = "W"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_temperature) == 72, "run tools/interface/describe.py");

template <>
struct Description<wrc_damage_bin> {
  static constexpr const char* name = "wrc_damage_bin";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_damage_bin>(312);
  static constexpr wrc_damage_bin defaults = [] {
    wrc_damage_bin value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "sum", .offset = offsetof(wrc_damage_bin, sum), .type = Type::uint64, .elements = 32, .rule = Rule::none},
      {.name = "largest_pressure", .offset = offsetof(wrc_damage_bin, largest_pressure), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "largest_traction", .offset = offsetof(wrc_damage_bin, largest_traction), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "overflow", .offset = offsetof(wrc_damage_bin, overflow), .type = Type::uint64, .rule = Rule::none},
      {.name = "reserved", .offset = offsetof(wrc_damage_bin, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_damage_bin) == 312, "run tools/interface/describe.py");

template <>
struct Description<wrc_damage_bins> {
  static constexpr const char* name = "wrc_damage_bins";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_damage_bins>(56);
  static constexpr wrc_damage_bins defaults = [] {
    wrc_damage_bins value{};
    value.struct_size = sizeof value;
    value.width = 1e-3;
    value.row_count = 1;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_damage_bins, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "count", .offset = offsetof(wrc_damage_bins, count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 1000000, .too_small = "say how many bins there are", .not_set = "was it set? its default is 0"},
      {.name = "first", .offset = offsetof(wrc_damage_bins, first), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "width", .offset = offsetof(wrc_damage_bins, width), .type = Type::real, .rule = Rule::range, .low = 1e-5, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "row_count", .offset = offsetof(wrc_damage_bins, row_count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 1000000},
      {.name = "bin_size", .offset = offsetof(wrc_damage_bins, bin_size), .type = Type::uint32, .rule = Rule::range, .low = first_size<wrc_damage_bin>(312), .high = 4096, .too_small = "say sizeof(wrc_damage_bin)", .too_large = "say sizeof(wrc_damage_bin)", .not_set = "was it set? its default is 0"},
      {.name = "row_first", .offset = offsetof(wrc_damage_bins, row_first), .type = Type::real, .rule = Rule::range, .low = -1e9, .high = 1e9, .unit = "m"},
      {.name = "row_length", .offset = offsetof(wrc_damage_bins, row_length), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e9, .or_zero = true, .unit = "m", .negative = "rows follow the track"},
      {.name = "bins", .offset = offsetof(wrc_damage_bins, bins), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_damage_bins) == 56, "run tools/interface/describe.py");

template <>
struct Description<wrc_fatigue_laws> {
  static constexpr const char* name = "wrc_fatigue_laws";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_fatigue_laws>(40);
  static constexpr wrc_fatigue_laws defaults = [] {
    wrc_fatigue_laws value{};
    value.struct_size = sizeof value;
    value.whole_life_start = 15;
    value.whole_life_peak_at = 65;
    value.whole_life_end = 175;
    value.whole_life_peak = 1e-5;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_fatigue_laws, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_fatigue_laws, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "whole_life_start", .offset = offsetof(wrc_fatigue_laws, whole_life_start), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e6, .unit = "N"},
      {.name = "whole_life_peak_at", .offset = offsetof(wrc_fatigue_laws, whole_life_peak_at), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e6, .unit = "N"},
      {.name = "whole_life_end", .offset = offsetof(wrc_fatigue_laws, whole_life_end), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e6, .unit = "N"},
      {.name = "whole_life_peak", .offset = offsetof(wrc_fatigue_laws, whole_life_peak), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_small = "did you pass millionths?", .too_large = "did you pass millionths?"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_fatigue_laws) == 40, "run tools/interface/describe.py");

template <>
struct Description<wrc_accumulation> {
  static constexpr const char* name = "wrc_accumulation";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_accumulation>(40);
  static constexpr wrc_accumulation defaults = [] {
    wrc_accumulation value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_accumulation, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_accumulation, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "duration", .offset = offsetof(wrc_accumulation, duration), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e6, .unit = "s", .negative = "damage is not undone", .too_large = "did you pass a distance?"},
      {.name = "distance", .offset = offsetof(wrc_accumulation, distance), .type = Type::real, .rule = Rule::range, .low = -1e9, .high = 1e9, .unit = "m"},
      {.name = "wear", .offset = offsetof(wrc_accumulation, wear), .type = Type::pointer, .rule = Rule::none},
      {.name = "fatigue", .offset = offsetof(wrc_accumulation, fatigue), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_accumulation) == 40, "run tools/interface/describe.py");

template <>
struct Description<wrc_damage_totals> {
  static constexpr const char* name = "wrc_damage_totals";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_damage_totals>(176);
  static constexpr wrc_damage_totals defaults = [] {
    wrc_damage_totals value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "sum", .offset = offsetof(wrc_damage_totals, sum), .type = Type::real, .elements = 16, .rule = Rule::none},
      {.name = "largest_pressure", .offset = offsetof(wrc_damage_totals, largest_pressure), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "largest_traction", .offset = offsetof(wrc_damage_totals, largest_traction), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "reserved", .offset = offsetof(wrc_damage_totals, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_damage_totals) == 176, "run tools/interface/describe.py");

template <>
struct Description<wrc_grid> {
  static constexpr const char* name = "wrc_grid";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_grid>(72);
  static constexpr wrc_grid defaults = [] {
    wrc_grid value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "nx", .offset = offsetof(wrc_grid, nx), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 1024, .not_set = "was it set? its default is 0"},
      {.name = "ny", .offset = offsetof(wrc_grid, ny), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 1024, .not_set = "was it set? its default is 0"},
      {.name = "dx", .offset = offsetof(wrc_grid, dx), .type = Type::real, .rule = Rule::range, .low = 1e-7, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "dy", .offset = offsetof(wrc_grid, dy), .type = Type::real, .rule = Rule::range, .low = 1e-7, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "x0", .offset = offsetof(wrc_grid, x0), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "y0", .offset = offsetof(wrc_grid, y0), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "reserved", .offset = offsetof(wrc_grid, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_grid) == 72, "run tools/interface/describe.py");

template <>
struct Description<wrc_exact_normal_problem> {
  static constexpr const char* name = "wrc_exact_normal_problem";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_exact_normal_problem>(264);
  static constexpr wrc_exact_normal_problem defaults = [] {
    wrc_exact_normal_problem value{};
    value.struct_size = sizeof value;
    value.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
    value.max_iterations = 1000;
    value.tolerance = 1e-6;
    value.wheel_material = Description<wrc_material>::defaults;
    value.rail_material = Description<wrc_material>::defaults;
    value.grid = Description<wrc_grid>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_exact_normal_problem, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "prescribed", .offset = offsetof(wrc_exact_normal_problem, prescribed), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_prescribed},
      {.name = "max_iterations", .offset = offsetof(wrc_exact_normal_problem, max_iterations), .type = Type::int32, .rule = Rule::range, .low = 1, .high = 100000},
      {.name = "reserved0", .offset = offsetof(wrc_exact_normal_problem, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "normal_force", .offset = offsetof(wrc_exact_normal_problem, normal_force), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e7, .unit = "N", .negative = "compressive positive", .too_large = "did you pass mN?", .not_set = "was it set? WRC_PRESCRIBE_NORMAL_FORCE needs it, and its default is 0", .asked = offsetof(wrc_exact_normal_problem, prescribed), .asked_for = WRC_PRESCRIBE_NORMAL_FORCE},
      {.name = "approach", .offset = offsetof(wrc_exact_normal_problem, approach), .type = Type::real, .rule = Rule::range, .low = -1, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .asked = offsetof(wrc_exact_normal_problem, prescribed), .asked_for = WRC_PRESCRIBE_APPROACH},
      {.name = "tolerance", .offset = offsetof(wrc_exact_normal_problem, tolerance), .type = Type::real, .rule = Rule::range, .low = 1e-14, .high = 0.1},
      {.name = "wheel_material.shear_modulus", .offset = offsetof(wrc_exact_normal_problem, wheel_material.shear_modulus), .type = Type::real, .rule = Rule::range, .low = 1e8, .high = 1e12, .unit = "Pa", .too_small = "did you pass MPa or GPa?", .too_large = "steel has 82e9"},
      {.name = "wheel_material.poisson", .offset = offsetof(wrc_exact_normal_problem, wheel_material.poisson), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "steel has 0.25 to 0.3", .too_large = "steel has 0.25 to 0.3"},
      {.name = "wheel_material.shear_yield", .offset = offsetof(wrc_exact_normal_problem, wheel_material.shear_yield), .type = Type::real, .rule = Rule::range, .low = 1e6, .high = 1e11, .unit = "Pa", .too_small = "did you pass MPa?"},
      {.name = "wheel_material.reserved", .offset = offsetof(wrc_exact_normal_problem, wheel_material.reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
      {.name = "rail_material.shear_modulus", .offset = offsetof(wrc_exact_normal_problem, rail_material.shear_modulus), .type = Type::real, .rule = Rule::range, .low = 1e8, .high = 1e12, .unit = "Pa", .too_small = "did you pass MPa or GPa?", .too_large = "steel has 82e9"},
      {.name = "rail_material.poisson", .offset = offsetof(wrc_exact_normal_problem, rail_material.poisson), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "steel has 0.25 to 0.3", .too_large = "steel has 0.25 to 0.3"},
      {.name = "rail_material.shear_yield", .offset = offsetof(wrc_exact_normal_problem, rail_material.shear_yield), .type = Type::real, .rule = Rule::range, .low = 1e6, .high = 1e11, .unit = "Pa", .too_small = "did you pass MPa?"},
      {.name = "rail_material.reserved", .offset = offsetof(wrc_exact_normal_problem, rail_material.reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
      {.name = "grid.nx", .offset = offsetof(wrc_exact_normal_problem, grid.nx), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 1024, .not_set = "was it set? its default is 0"},
      {.name = "grid.ny", .offset = offsetof(wrc_exact_normal_problem, grid.ny), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 1024, .not_set = "was it set? its default is 0"},
      {.name = "grid.dx", .offset = offsetof(wrc_exact_normal_problem, grid.dx), .type = Type::real, .rule = Rule::range, .low = 1e-7, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "grid.dy", .offset = offsetof(wrc_exact_normal_problem, grid.dy), .type = Type::real, .rule = Rule::range, .low = 1e-7, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "grid.x0", .offset = offsetof(wrc_exact_normal_problem, grid.x0), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "grid.y0", .offset = offsetof(wrc_exact_normal_problem, grid.y0), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "grid.reserved", .offset = offsetof(wrc_exact_normal_problem, grid.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "gap", .offset = offsetof(wrc_exact_normal_problem, gap), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .by_caller = true},
      {.name = "progress", .offset = offsetof(wrc_exact_normal_problem, progress), .type = Type::pointer, .rule = Rule::none},
      {.name = "user", .offset = offsetof(wrc_exact_normal_problem, user), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_exact_normal_problem) == 264, "run tools/interface/describe.py");

template <>
struct Description<wrc_exact_normal_solution> {
  static constexpr const char* name = "wrc_exact_normal_solution";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_exact_normal_solution>(64);
  static constexpr wrc_exact_normal_solution defaults = [] {
    wrc_exact_normal_solution value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_exact_normal_solution, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "iterations", .offset = offsetof(wrc_exact_normal_solution, iterations), .type = Type::int32, .rule = Rule::none},
      {.name = "flags", .offset = offsetof(wrc_exact_normal_solution, flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_exact_normal_solution, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "approach", .offset = offsetof(wrc_exact_normal_solution, approach), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "normal_force", .offset = offsetof(wrc_exact_normal_solution, normal_force), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "peak_pressure", .offset = offsetof(wrc_exact_normal_solution, peak_pressure), .type = Type::real, .rule = Rule::none, .unit = "Pa"},
      {.name = "area", .offset = offsetof(wrc_exact_normal_solution, area), .type = Type::real, .rule = Rule::none, .unit = "m^2"},
      {.name = "residual", .offset = offsetof(wrc_exact_normal_solution, residual), .type = Type::real, .rule = Rule::none},
      {.name = "pressure", .offset = offsetof(wrc_exact_normal_solution, pressure), .type = Type::pointer, .rule = Rule::none, .unit = "Pa"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_exact_normal_solution) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_exact_rolling_problem> {
  static constexpr const char* name = "wrc_exact_rolling_problem";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_exact_rolling_problem>(344);
  static constexpr wrc_exact_rolling_problem defaults = [] {
    wrc_exact_rolling_problem value{};
    value.struct_size = sizeof value;
    value.max_iterations = 60;
    value.tolerance = 1e-4;
    value.wheel_material = Description<wrc_material>::defaults;
    value.rail_material = Description<wrc_material>::defaults;
    value.grid = Description<wrc_grid>::defaults;
    value.coefficient = 0.3;
    value.creepage = Description<wrc_creepage>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_exact_rolling_problem, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "adhesion", .offset = offsetof(wrc_exact_rolling_problem, adhesion), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_adhesion},
      {.name = "collocation", .offset = offsetof(wrc_exact_rolling_problem, collocation), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_collocation},
      {.name = "max_iterations", .offset = offsetof(wrc_exact_rolling_problem, max_iterations), .type = Type::int32, .rule = Rule::range, .low = 1, .high = 1000},
      {.name = "tolerance", .offset = offsetof(wrc_exact_rolling_problem, tolerance), .type = Type::real, .rule = Rule::range, .low = 1e-12, .high = 0.1},
      {.name = "wheel_material.shear_modulus", .offset = offsetof(wrc_exact_rolling_problem, wheel_material.shear_modulus), .type = Type::real, .rule = Rule::range, .low = 1e8, .high = 1e12, .unit = "Pa", .too_small = "did you pass MPa or GPa?", .too_large = "steel has 82e9"},
      {.name = "wheel_material.poisson", .offset = offsetof(wrc_exact_rolling_problem, wheel_material.poisson), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "steel has 0.25 to 0.3", .too_large = "steel has 0.25 to 0.3"},
      {.name = "wheel_material.shear_yield", .offset = offsetof(wrc_exact_rolling_problem, wheel_material.shear_yield), .type = Type::real, .rule = Rule::range, .low = 1e6, .high = 1e11, .unit = "Pa", .too_small = "did you pass MPa?"},
      {.name = "wheel_material.reserved", .offset = offsetof(wrc_exact_rolling_problem, wheel_material.reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
      {.name = "rail_material.shear_modulus", .offset = offsetof(wrc_exact_rolling_problem, rail_material.shear_modulus), .type = Type::real, .rule = Rule::range, .low = 1e8, .high = 1e12, .unit = "Pa", .too_small = "did you pass MPa or GPa?", .too_large = "steel has 82e9"},
      {.name = "rail_material.poisson", .offset = offsetof(wrc_exact_rolling_problem, rail_material.poisson), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "steel has 0.25 to 0.3", .too_large = "steel has 0.25 to 0.3"},
      {.name = "rail_material.shear_yield", .offset = offsetof(wrc_exact_rolling_problem, rail_material.shear_yield), .type = Type::real, .rule = Rule::range, .low = 1e6, .high = 1e11, .unit = "Pa", .too_small = "did you pass MPa?"},
      {.name = "rail_material.reserved", .offset = offsetof(wrc_exact_rolling_problem, rail_material.reserved), .type = Type::real, .elements = 5, .rule = Rule::zero},
      {.name = "grid.nx", .offset = offsetof(wrc_exact_rolling_problem, grid.nx), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 1024, .not_set = "was it set? its default is 0"},
      {.name = "grid.ny", .offset = offsetof(wrc_exact_rolling_problem, grid.ny), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 1024, .not_set = "was it set? its default is 0"},
      {.name = "grid.dx", .offset = offsetof(wrc_exact_rolling_problem, grid.dx), .type = Type::real, .rule = Rule::range, .low = 1e-7, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "grid.dy", .offset = offsetof(wrc_exact_rolling_problem, grid.dy), .type = Type::real, .rule = Rule::range, .low = 1e-7, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "grid.x0", .offset = offsetof(wrc_exact_rolling_problem, grid.x0), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "grid.y0", .offset = offsetof(wrc_exact_rolling_problem, grid.y0), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "grid.reserved", .offset = offsetof(wrc_exact_rolling_problem, grid.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "pressure", .offset = offsetof(wrc_exact_rolling_problem, pressure), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1e11, .high = 1e11, .unit = "Pa", .too_small = "pressure is compressive positive", .too_large = "steel yields at a tenth of that", .by_caller = true},
      {.name = "friction", .offset = offsetof(wrc_exact_rolling_problem, friction), .type = Type::pointer, .rule = Rule::range, .low = 1e-4, .high = 2, .too_small = "friction must be positive", .too_large = "did you pass per cent?", .by_caller = true},
      {.name = "coefficient", .offset = offsetof(wrc_exact_rolling_problem, coefficient), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 2, .too_small = "friction must be positive", .too_large = "did you pass per cent?", .by_caller = true},
      {.name = "creepage.longitudinal", .offset = offsetof(wrc_exact_rolling_problem, creepage.longitudinal), .type = Type::real, .rule = Rule::range, .low = -10, .high = 10, .too_small = "did you pass per mille?", .too_large = "did you pass per mille?"},
      {.name = "creepage.lateral", .offset = offsetof(wrc_exact_rolling_problem, creepage.lateral), .type = Type::real, .rule = Rule::range, .low = -10, .high = 10, .too_small = "did you pass per mille?", .too_large = "did you pass per mille?"},
      {.name = "creepage.spin", .offset = offsetof(wrc_exact_rolling_problem, creepage.spin), .type = Type::real, .rule = Rule::range, .low = -1000, .high = 1000, .unit = "1/m"},
      {.name = "creepage.speed", .offset = offsetof(wrc_exact_rolling_problem, creepage.speed), .type = Type::real, .rule = Rule::range, .low = -200, .high = 200, .unit = "m/s", .too_small = "did you pass km/h?", .too_large = "did you pass km/h?"},
      {.name = "creepage.approach_velocity", .offset = offsetof(wrc_exact_rolling_problem, creepage.approach_velocity), .type = Type::real, .rule = Rule::none, .unit = "m/s"},
      {.name = "creepage.reverse_share", .offset = offsetof(wrc_exact_rolling_problem, creepage.reverse_share), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "it is a result of wrc_planar_creepages", .too_large = "the way of creepage.speed has the larger share"},
      {.name = "creepage.reserved", .offset = offsetof(wrc_exact_rolling_problem, creepage.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "progress", .offset = offsetof(wrc_exact_rolling_problem, progress), .type = Type::pointer, .rule = Rule::none},
      {.name = "user", .offset = offsetof(wrc_exact_rolling_problem, user), .type = Type::pointer, .rule = Rule::none},
      {.name = "layer_thickness", .offset = offsetof(wrc_exact_rolling_problem, layer_thickness), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.01, .unit = "m"},
      {.name = "layer_modulus", .offset = offsetof(wrc_exact_rolling_problem, layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "layer_yield", .offset = offsetof(wrc_exact_rolling_problem, layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "layer_hardening", .offset = offsetof(wrc_exact_rolling_problem, layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_exact_rolling_problem) == 376, "run tools/interface/describe.py");

template <>
struct Description<wrc_exact_rolling_solution> {
  static constexpr const char* name = "wrc_exact_rolling_solution";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_exact_rolling_solution>(104);
  static constexpr wrc_exact_rolling_solution defaults = [] {
    wrc_exact_rolling_solution value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_exact_rolling_solution, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "iterations", .offset = offsetof(wrc_exact_rolling_solution, iterations), .type = Type::int32, .rule = Rule::none},
      {.name = "flags", .offset = offsetof(wrc_exact_rolling_solution, flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_exact_rolling_solution, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "fx", .offset = offsetof(wrc_exact_rolling_solution, fx), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "fy", .offset = offsetof(wrc_exact_rolling_solution, fy), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "mz", .offset = offsetof(wrc_exact_rolling_solution, mz), .type = Type::real, .rule = Rule::none, .unit = "N m"},
      {.name = "power", .offset = offsetof(wrc_exact_rolling_solution, power), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "power_by_balance", .offset = offsetof(wrc_exact_rolling_solution, power_by_balance), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "adhesion_fraction", .offset = offsetof(wrc_exact_rolling_solution, adhesion_fraction), .type = Type::real, .rule = Rule::none},
      {.name = "residual", .offset = offsetof(wrc_exact_rolling_solution, residual), .type = Type::real, .rule = Rule::none},
      {.name = "traction_x", .offset = offsetof(wrc_exact_rolling_solution, traction_x), .type = Type::pointer, .rule = Rule::none, .unit = "Pa"},
      {.name = "traction_y", .offset = offsetof(wrc_exact_rolling_solution, traction_y), .type = Type::pointer, .rule = Rule::none, .unit = "Pa"},
      {.name = "slip_x", .offset = offsetof(wrc_exact_rolling_solution, slip_x), .type = Type::pointer, .rule = Rule::none},
      {.name = "slip_y", .offset = offsetof(wrc_exact_rolling_solution, slip_y), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_exact_rolling_solution) == 104, "run tools/interface/describe.py");

template <>
struct Description<wrc_exact_loads> {
  static constexpr const char* name = "wrc_exact_loads";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_exact_loads>(112);
  static constexpr wrc_exact_loads defaults = [] {
    wrc_exact_loads value{};
    value.struct_size = sizeof value;
    value.body = WRC_BODY_RAIL;
    value.poisson = 0.28;
    value.grid = Description<wrc_grid>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_exact_loads, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "body", .offset = offsetof(wrc_exact_loads, body), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_body},
      {.name = "poisson", .offset = offsetof(wrc_exact_loads, poisson), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.5, .too_small = "steel has 0.25 to 0.3", .too_large = "steel has 0.25 to 0.3"},
      {.name = "grid.nx", .offset = offsetof(wrc_exact_loads, grid.nx), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 1024, .not_set = "was it set? its default is 0"},
      {.name = "grid.ny", .offset = offsetof(wrc_exact_loads, grid.ny), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 1024, .not_set = "was it set? its default is 0"},
      {.name = "grid.dx", .offset = offsetof(wrc_exact_loads, grid.dx), .type = Type::real, .rule = Rule::range, .low = 1e-7, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "grid.dy", .offset = offsetof(wrc_exact_loads, grid.dy), .type = Type::real, .rule = Rule::range, .low = 1e-7, .high = 0.01, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "grid.x0", .offset = offsetof(wrc_exact_loads, grid.x0), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "grid.y0", .offset = offsetof(wrc_exact_loads, grid.y0), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "grid.reserved", .offset = offsetof(wrc_exact_loads, grid.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "pressure", .offset = offsetof(wrc_exact_loads, pressure), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1e11, .high = 1e11, .unit = "Pa", .too_small = "pressure is compressive positive", .too_large = "steel yields at a tenth of that", .by_caller = true},
      {.name = "traction_x", .offset = offsetof(wrc_exact_loads, traction_x), .type = Type::pointer, .rule = Rule::range, .low = -1e11, .high = 1e11, .unit = "Pa", .too_small = "steel yields at a tenth of that", .too_large = "steel yields at a tenth of that", .by_caller = true},
      {.name = "traction_y", .offset = offsetof(wrc_exact_loads, traction_y), .type = Type::pointer, .rule = Rule::range, .low = -1e11, .high = 1e11, .unit = "Pa", .too_small = "steel yields at a tenth of that", .too_large = "steel yields at a tenth of that", .by_caller = true},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_exact_loads) == 112, "run tools/interface/describe.py");

template <>
struct Description<wrc_exact_wrench_options> {
  static constexpr const char* name = "wrc_exact_wrench_options";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_exact_wrench_options>(48);
  static constexpr wrc_exact_wrench_options defaults = [] {
    wrc_exact_wrench_options value{};
    value.struct_size = sizeof value;
    value.cell_x = 2e-4;
    value.cell_s = 2e-4;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_exact_wrench_options, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "collocation", .offset = offsetof(wrc_exact_wrench_options, collocation), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_collocation},
      {.name = "influence", .offset = offsetof(wrc_exact_wrench_options, influence), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_surface_influence},
      {.name = "reserved0", .offset = offsetof(wrc_exact_wrench_options, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "cell_x", .offset = offsetof(wrc_exact_wrench_options, cell_x), .type = Type::real, .rule = Rule::range, .low = 2e-5, .high = 2e-3, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "cell_s", .offset = offsetof(wrc_exact_wrench_options, cell_s), .type = Type::real, .rule = Rule::range, .low = 2e-5, .high = 2e-3, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "progress", .offset = offsetof(wrc_exact_wrench_options, progress), .type = Type::pointer, .rule = Rule::none},
      {.name = "user", .offset = offsetof(wrc_exact_wrench_options, user), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_exact_wrench_options) == 48, "run tools/interface/describe.py");

template <>
struct Description<wrc_exact_check_options> {
  static constexpr const char* name = "wrc_exact_check_options";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_exact_check_options>(32);
  static constexpr wrc_exact_check_options defaults = [] {
    wrc_exact_check_options value{};
    value.struct_size = sizeof value;
    value.nx = 64;
    value.ny = 64;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_exact_check_options, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "nx", .offset = offsetof(wrc_exact_check_options, nx), .type = Type::uint32, .rule = Rule::range, .low = 8, .high = 512},
      {.name = "ny", .offset = offsetof(wrc_exact_check_options, ny), .type = Type::uint32, .rule = Rule::range, .low = 8, .high = 512},
      {.name = "reserved0", .offset = offsetof(wrc_exact_check_options, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "progress", .offset = offsetof(wrc_exact_check_options, progress), .type = Type::pointer, .rule = Rule::none},
      {.name = "user", .offset = offsetof(wrc_exact_check_options, user), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_exact_check_options) == 32, "run tools/interface/describe.py");

template <>
struct Description<wrc_exact_check_result> {
  static constexpr const char* name = "wrc_exact_check_result";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_exact_check_result>(64);
  static constexpr wrc_exact_check_result defaults = [] {
    wrc_exact_check_result value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_exact_check_result, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "flags", .offset = offsetof(wrc_exact_check_result, flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "fx", .offset = offsetof(wrc_exact_check_result, fx), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "fy", .offset = offsetof(wrc_exact_check_result, fy), .type = Type::real, .rule = Rule::none, .unit = "N"},
      {.name = "mz", .offset = offsetof(wrc_exact_check_result, mz), .type = Type::real, .rule = Rule::none, .unit = "N m"},
      {.name = "power", .offset = offsetof(wrc_exact_check_result, power), .type = Type::real, .rule = Rule::none, .unit = "W"},
      {.name = "adhesion_fraction", .offset = offsetof(wrc_exact_check_result, adhesion_fraction), .type = Type::real, .rule = Rule::none},
      {.name = "force_error", .offset = offsetof(wrc_exact_check_result, force_error), .type = Type::real, .rule = Rule::none},
      {.name = "power_error", .offset = offsetof(wrc_exact_check_result, power_error), .type = Type::real, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_exact_check_result) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_creep_curve> {
  static constexpr const char* name = "wrc_creep_curve";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_creep_curve>(376);
  static constexpr wrc_creep_curve defaults = [] {
    wrc_creep_curve value{};
    value.struct_size = sizeof value;
    value.ellipse = Description<wrc_ellipse>::defaults;
    value.friction = Description<wrc_friction>::defaults;
    value.parameters = 1;
    value.max_iterations = 100;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_creep_curve, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "count", .offset = offsetof(wrc_creep_curve, count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 100000, .too_small = "a fit needs three points more than parameters", .not_set = "was it set? its default is 0"},
      {.name = "slip", .offset = offsetof(wrc_creep_curve, slip), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 1e-7, .high = 1, .too_small = "take amounts: slip of braking and of traction counts positive, and a point without slip has no place", .too_large = "did you pass per cent?", .counted_by = offsetof(wrc_creep_curve, count)},
      {.name = "adhesion", .offset = offsetof(wrc_creep_curve, adhesion), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.2, .high = 2, .too_small = "take amounts: adhesion counts positive where it opposes the slip", .too_large = "did you pass per cent?", .counted_by = offsetof(wrc_creep_curve, count)},
      {.name = "speed", .offset = offsetof(wrc_creep_curve, speed), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 1e-3, .high = 200, .unit = "m/s", .too_small = "take amounts: a curve of rolling backwards is the same", .counted_by = offsetof(wrc_creep_curve, count)},
      {.name = "load", .offset = offsetof(wrc_creep_curve, load), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 1, .high = 1e7, .unit = "N", .too_small = "compressive loads count positive; did you pass kN?", .counted_by = offsetof(wrc_creep_curve, count)},
      {.name = "ellipse.a", .offset = offsetof(wrc_creep_curve, ellipse.a), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.b", .offset = offsetof(wrc_creep_curve, ellipse.b), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.1, .unit = "m", .too_large = "did you pass mm?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.psi", .offset = offsetof(wrc_creep_curve, ellipse.psi), .type = Type::real, .rule = Rule::range, .low = -0.95, .high = 0.95},
      {.name = "ellipse.y", .offset = offsetof(wrc_creep_curve, ellipse.y), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "ellipse.normal_force", .offset = offsetof(wrc_creep_curve, ellipse.normal_force), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e7, .unit = "N", .negative = "the normal force is compressive positive", .too_large = "did you pass mN?", .not_set = "was it set? its default is 0"},
      {.name = "ellipse.reserved", .offset = offsetof(wrc_creep_curve, ellipse.reserved), .type = Type::real, .elements = 3, .rule = Rule::zero},
      {.name = "friction.coefficient", .offset = offsetof(wrc_creep_curve, friction.coefficient), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 2, .or_zero = true, .too_small = "friction must be positive", .too_large = "did you pass per cent?"},
      {.name = "friction.speed_law", .offset = offsetof(wrc_creep_curve, friction.speed_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_speed_law},
      {.name = "friction.temperature_law", .offset = offsetof(wrc_creep_curve, friction.temperature_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_temperature_law},
      {.name = "friction.kinetic_ratio", .offset = offsetof(wrc_creep_curve, friction.kinetic_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient at rest"},
      {.name = "friction.fall_rate", .offset = offsetof(wrc_creep_curve, friction.fall_rate), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000, .unit = "s/m", .too_small = "friction falls with positive rates"},
      {.name = "friction.half_speed", .offset = offsetof(wrc_creep_curve, friction.half_speed), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .unit = "m/s"},
      {.name = "friction.hot_ratio", .offset = offsetof(wrc_creep_curve, friction.hot_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient of cold surfaces"},
      {.name = "friction.cold_temperature", .offset = offsetof(wrc_creep_curve, friction.cold_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC"},
      {.name = "friction.hot_temperature", .offset = offsetof(wrc_creep_curve, friction.hot_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 3000, .unit = "degC"},
      {.name = "friction.bulk.wheel", .offset = offsetof(wrc_creep_curve, friction.bulk.wheel), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "friction.bulk.rail", .offset = offsetof(wrc_creep_curve, friction.bulk.rail), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "friction.bulk.reserved", .offset = offsetof(wrc_creep_curve, friction.bulk.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "friction.slope_reduction", .offset = offsetof(wrc_creep_curve, friction.slope_reduction), .type = Type::real, .rule = Rule::range, .low = 0.01, .high = 1, .too_small = "clean bodies have 1", .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.slope_limit", .offset = offsetof(wrc_creep_curve, friction.slope_limit), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "friction.slope_fall", .offset = offsetof(wrc_creep_curve, friction.slope_fall), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000},
      {.name = "friction.zone_y", .offset = offsetof(wrc_creep_curve, friction.zone_y), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_creep_curve, friction.zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_creep_curve, friction.zone_count)},
      {.name = "friction.zone_coefficients", .offset = offsetof(wrc_creep_curve, friction.zone_coefficients), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 2, .too_small = "friction is not negative", .too_large = "did you pass per cent?", .asked = offsetof(wrc_creep_curve, friction.zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_creep_curve, friction.zone_count)},
      {.name = "friction.zone_count", .offset = offsetof(wrc_creep_curve, friction.zone_count), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 64},
      {.name = "friction.zone_frame", .offset = offsetof(wrc_creep_curve, friction.zone_frame), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_zone_frame},
      {.name = "friction.layer_thickness", .offset = offsetof(wrc_creep_curve, friction.layer_thickness), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.01, .unit = "m"},
      {.name = "friction.layer_modulus", .offset = offsetof(wrc_creep_curve, friction.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "friction.layer_yield", .offset = offsetof(wrc_creep_curve, friction.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "friction.layer_hardening", .offset = offsetof(wrc_creep_curve, friction.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "friction.adhesion_reduction", .offset = offsetof(wrc_creep_curve, friction.adhesion_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.slip_reduction", .offset = offsetof(wrc_creep_curve, friction.slip_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.film_rows", .offset = offsetof(wrc_creep_curve, friction.film_rows), .type = Type::pointer, .rule = Rule::range, .low = -1e30, .high = 1e30, .counted_by = offsetof(wrc_creep_curve, friction.film_numbers), .by_caller = true},
      {.name = "friction.film_numbers", .offset = offsetof(wrc_creep_curve, friction.film_numbers), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1288},
      {.name = "friction.reserved0", .offset = offsetof(wrc_creep_curve, friction.reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "friction.reserved", .offset = offsetof(wrc_creep_curve, friction.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "parameters", .offset = offsetof(wrc_creep_curve, parameters), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 1023},
      {.name = "scatter", .offset = offsetof(wrc_creep_curve, scatter), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_scatter},
      {.name = "max_iterations", .offset = offsetof(wrc_creep_curve, max_iterations), .type = Type::int32, .rule = Rule::range, .low = 1, .high = 1000},
      {.name = "reserved0", .offset = offsetof(wrc_creep_curve, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "progress", .offset = offsetof(wrc_creep_curve, progress), .type = Type::pointer, .rule = Rule::none},
      {.name = "user", .offset = offsetof(wrc_creep_curve, user), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_creep_curve) == 376, "run tools/interface/describe.py");

template <>
struct Description<wrc_creep_fit> {
  static constexpr const char* name = "wrc_creep_fit";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_creep_fit>(2832);
  static constexpr wrc_creep_fit defaults = [] {
    wrc_creep_fit value{};
    value.struct_size = sizeof value;
    value.friction = Description<wrc_friction>::defaults;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_creep_fit, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "flags", .offset = offsetof(wrc_creep_fit, flags), .type = Type::uint32, .rule = Rule::none},
      {.name = "iterations", .offset = offsetof(wrc_creep_fit, iterations), .type = Type::int32, .rule = Rule::none},
      {.name = "undetermined", .offset = offsetof(wrc_creep_fit, undetermined), .type = Type::uint32, .rule = Rule::none},
      {.name = "at_limit", .offset = offsetof(wrc_creep_fit, at_limit), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_creep_fit, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "scatter", .offset = offsetof(wrc_creep_fit, scatter), .type = Type::real, .rule = Rule::none},
      {.name = "friction.coefficient", .offset = offsetof(wrc_creep_fit, friction.coefficient), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 2, .or_zero = true, .too_small = "friction must be positive", .too_large = "did you pass per cent?"},
      {.name = "friction.speed_law", .offset = offsetof(wrc_creep_fit, friction.speed_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_speed_law},
      {.name = "friction.temperature_law", .offset = offsetof(wrc_creep_fit, friction.temperature_law), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_friction_temperature_law},
      {.name = "friction.kinetic_ratio", .offset = offsetof(wrc_creep_fit, friction.kinetic_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient at rest"},
      {.name = "friction.fall_rate", .offset = offsetof(wrc_creep_fit, friction.fall_rate), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000, .unit = "s/m", .too_small = "friction falls with positive rates"},
      {.name = "friction.half_speed", .offset = offsetof(wrc_creep_fit, friction.half_speed), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .unit = "m/s"},
      {.name = "friction.hot_ratio", .offset = offsetof(wrc_creep_fit, friction.hot_ratio), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .too_large = "it is a share of the coefficient of cold surfaces"},
      {.name = "friction.cold_temperature", .offset = offsetof(wrc_creep_fit, friction.cold_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC"},
      {.name = "friction.hot_temperature", .offset = offsetof(wrc_creep_fit, friction.hot_temperature), .type = Type::real, .rule = Rule::range, .low = -273, .high = 3000, .unit = "degC"},
      {.name = "friction.bulk.wheel", .offset = offsetof(wrc_creep_fit, friction.bulk.wheel), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "friction.bulk.rail", .offset = offsetof(wrc_creep_fit, friction.bulk.rail), .type = Type::real, .rule = Rule::range, .low = -273, .high = 2000, .unit = "degC", .too_large = "did you pass kelvin, or Fahrenheit?"},
      {.name = "friction.bulk.reserved", .offset = offsetof(wrc_creep_fit, friction.bulk.reserved), .type = Type::real, .elements = 2, .rule = Rule::zero},
      {.name = "friction.slope_reduction", .offset = offsetof(wrc_creep_fit, friction.slope_reduction), .type = Type::real, .rule = Rule::range, .low = 0.01, .high = 1, .too_small = "clean bodies have 1", .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.slope_limit", .offset = offsetof(wrc_creep_fit, friction.slope_limit), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "friction.slope_fall", .offset = offsetof(wrc_creep_fit, friction.slope_fall), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1000},
      {.name = "friction.zone_y", .offset = offsetof(wrc_creep_fit, friction.zone_y), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .asked = offsetof(wrc_creep_fit, friction.zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_creep_fit, friction.zone_count)},
      {.name = "friction.zone_coefficients", .offset = offsetof(wrc_creep_fit, friction.zone_coefficients), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 2, .too_small = "friction is not negative", .too_large = "did you pass per cent?", .asked = offsetof(wrc_creep_fit, friction.zone_count), .state = State::not_zero, .counted_by = offsetof(wrc_creep_fit, friction.zone_count)},
      {.name = "friction.zone_count", .offset = offsetof(wrc_creep_fit, friction.zone_count), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 64},
      {.name = "friction.zone_frame", .offset = offsetof(wrc_creep_fit, friction.zone_frame), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_zone_frame},
      {.name = "friction.layer_thickness", .offset = offsetof(wrc_creep_fit, friction.layer_thickness), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.01, .unit = "m"},
      {.name = "friction.layer_modulus", .offset = offsetof(wrc_creep_fit, friction.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "friction.layer_yield", .offset = offsetof(wrc_creep_fit, friction.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "friction.layer_hardening", .offset = offsetof(wrc_creep_fit, friction.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "friction.adhesion_reduction", .offset = offsetof(wrc_creep_fit, friction.adhesion_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.slip_reduction", .offset = offsetof(wrc_creep_fit, friction.slip_reduction), .type = Type::real, .rule = Rule::range, .low = 0.001, .high = 1, .or_zero = true, .too_large = "clean bodies have 1; did you pass per cent?"},
      {.name = "friction.film_rows", .offset = offsetof(wrc_creep_fit, friction.film_rows), .type = Type::pointer, .rule = Rule::range, .low = -1e30, .high = 1e30, .counted_by = offsetof(wrc_creep_fit, friction.film_numbers), .by_caller = true},
      {.name = "friction.film_numbers", .offset = offsetof(wrc_creep_fit, friction.film_numbers), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1288},
      {.name = "friction.reserved0", .offset = offsetof(wrc_creep_fit, friction.reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "friction.reserved", .offset = offsetof(wrc_creep_fit, friction.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "value", .offset = offsetof(wrc_creep_fit, value), .type = Type::real, .elements = 16, .rule = Rule::none},
      {.name = "deviation", .offset = offsetof(wrc_creep_fit, deviation), .type = Type::real, .elements = 16, .rule = Rule::none},
      {.name = "low", .offset = offsetof(wrc_creep_fit, low), .type = Type::real, .elements = 16, .rule = Rule::none},
      {.name = "high", .offset = offsetof(wrc_creep_fit, high), .type = Type::real, .elements = 16, .rule = Rule::none},
      {.name = "covariance", .offset = offsetof(wrc_creep_fit, covariance), .type = Type::real, .elements = 256, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_creep_fit) == 2832, "run tools/interface/describe.py");

template <>
struct Description<wrc_wheelset_geometry_problem> {
  static constexpr const char* name = "wrc_wheelset_geometry_problem";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_wheelset_geometry_problem>(24);
  static constexpr wrc_wheelset_geometry_problem defaults = [] {
    wrc_wheelset_geometry_problem value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_wheelset_geometry_problem, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "count", .offset = offsetof(wrc_wheelset_geometry_problem, count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 100000, .too_small = "say how many displacements there are", .not_set = "was it set? its default is 0"},
      {.name = "lateral", .offset = offsetof(wrc_wheelset_geometry_problem, lateral), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.1, .high = 0.1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_wheelset_geometry_problem, count)},
      {.name = "wheel_load", .offset = offsetof(wrc_wheelset_geometry_problem, wheel_load), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e6, .or_zero = true, .unit = "N", .negative = "the load is positive where the rail pushes the wheel upwards", .too_small = "did you pass kN?", .too_large = "did you pass a pressure, or grams?"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_wheelset_geometry_problem) == 24, "run tools/interface/describe.py");

template <>
struct Description<wrc_wheelset_geometry> {
  static constexpr const char* name = "wrc_wheelset_geometry";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_wheelset_geometry>(96);
  static constexpr wrc_wheelset_geometry defaults = [] {
    wrc_wheelset_geometry value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_wheelset_geometry, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_wheelset_geometry, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "vertical", .offset = offsetof(wrc_wheelset_geometry, vertical), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "roll", .offset = offsetof(wrc_wheelset_geometry, roll), .type = Type::pointer, .rule = Rule::none, .unit = "rad"},
      {.name = "radius_difference", .offset = offsetof(wrc_wheelset_geometry, radius_difference), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "radius_right", .offset = offsetof(wrc_wheelset_geometry, radius_right), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "radius_left", .offset = offsetof(wrc_wheelset_geometry, radius_left), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "angle_right", .offset = offsetof(wrc_wheelset_geometry, angle_right), .type = Type::pointer, .rule = Rule::none, .unit = "rad"},
      {.name = "angle_left", .offset = offsetof(wrc_wheelset_geometry, angle_left), .type = Type::pointer, .rule = Rule::none, .unit = "rad"},
      {.name = "y_wheel_right", .offset = offsetof(wrc_wheelset_geometry, y_wheel_right), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "y_wheel_left", .offset = offsetof(wrc_wheelset_geometry, y_wheel_left), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "y_rail_right", .offset = offsetof(wrc_wheelset_geometry, y_rail_right), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "y_rail_left", .offset = offsetof(wrc_wheelset_geometry, y_rail_left), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_wheelset_geometry) == 96, "run tools/interface/describe.py");

template <>
struct Description<wrc_conicity_problem> {
  static constexpr const char* name = "wrc_conicity_problem";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_conicity_problem>(56);
  static constexpr wrc_conicity_problem defaults = [] {
    wrc_conicity_problem value{};
    value.struct_size = sizeof value;
    value.contact_distance = 1.5;
    value.radius = 0.46;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_conicity_problem, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "method", .offset = offsetof(wrc_conicity_problem, method), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_conicity_method},
      {.name = "count", .offset = offsetof(wrc_conicity_problem, count), .type = Type::uint32, .rule = Rule::range, .low = 3, .high = 100000, .too_small = "say how many points there are", .not_set = "was it set? its default is 0"},
      {.name = "amplitude_count", .offset = offsetof(wrc_conicity_problem, amplitude_count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 100000, .too_small = "say how many amplitudes there are", .not_set = "was it set? its default is 0"},
      {.name = "lateral", .offset = offsetof(wrc_conicity_problem, lateral), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.1, .high = 0.1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_conicity_problem, count)},
      {.name = "radius_difference", .offset = offsetof(wrc_conicity_problem, radius_difference), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -0.2, .high = 0.2, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_conicity_problem, count)},
      {.name = "amplitudes", .offset = offsetof(wrc_conicity_problem, amplitudes), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 1e-6, .high = 0.1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_conicity_problem, amplitude_count)},
      {.name = "contact_distance", .offset = offsetof(wrc_conicity_problem, contact_distance), .type = Type::real, .rule = Rule::range, .low = 0.3, .high = 3, .unit = "m", .too_small = "did you pass mm, or half of it?", .too_large = "did you pass mm, or half of it?"},
      {.name = "radius", .offset = offsetof(wrc_conicity_problem, radius), .type = Type::real, .rule = Rule::range, .low = 0.05, .high = 3, .unit = "m", .too_small = "did you pass mm, or the diameter?", .too_large = "did you pass mm, or the diameter?"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_conicity_problem) == 56, "run tools/interface/describe.py");

template <>
struct Description<wrc_conicity> {
  static constexpr const char* name = "wrc_conicity";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_conicity>(32);
  static constexpr wrc_conicity defaults = [] {
    wrc_conicity value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_conicity, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_conicity, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "conicity", .offset = offsetof(wrc_conicity, conicity), .type = Type::pointer, .rule = Rule::none},
      {.name = "wavelength", .offset = offsetof(wrc_conicity, wavelength), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "centre", .offset = offsetof(wrc_conicity, centre), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_conicity) == 32, "run tools/interface/describe.py");

template <>
struct Description<wrc_profile_wear> {
  static constexpr const char* name = "wrc_profile_wear";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_profile_wear>(88);
  static constexpr wrc_profile_wear defaults = [] {
    wrc_profile_wear value{};
    value.struct_size = sizeof value;
    value.width = 1e-3;
    value.passages = 1;
    value.largest_depth = 1e-4;
    value.smoothing = 5e-3;
    value.spacing = 5e-4;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_profile_wear, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "body", .offset = offsetof(wrc_profile_wear, body), .type = Type::int32, .rule = Rule::one_of, .enumeration = &enumerations::wrc_body},
      {.name = "count", .offset = offsetof(wrc_profile_wear, count), .type = Type::uint32, .rule = Rule::range, .low = 4, .high = 20000, .too_small = "a spline needs at least four points", .not_set = "was it set? its default is 0"},
      {.name = "bin_count", .offset = offsetof(wrc_profile_wear, bin_count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 1000000, .too_small = "say how many bins there are", .not_set = "was it set? its default is 0"},
      {.name = "y", .offset = offsetof(wrc_profile_wear, y), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_profile_wear, count)},
      {.name = "z", .offset = offsetof(wrc_profile_wear, z), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?", .counted_by = offsetof(wrc_profile_wear, count)},
      {.name = "depth", .offset = offsetof(wrc_profile_wear, depth), .type = Type::pointer, .rule = Rule::range, .required = true, .low = 0, .high = 0.1, .unit = "m", .too_small = "did you pass a volume?", .too_large = "did you pass a volume?", .counted_by = offsetof(wrc_profile_wear, bin_count)},
      {.name = "first", .offset = offsetof(wrc_profile_wear, first), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "width", .offset = offsetof(wrc_profile_wear, width), .type = Type::real, .rule = Rule::range, .low = 1e-5, .high = 1, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "passages", .offset = offsetof(wrc_profile_wear, passages), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e12},
      {.name = "largest_depth", .offset = offsetof(wrc_profile_wear, largest_depth), .type = Type::real, .rule = Rule::range, .low = 1e-9, .high = 1e-2, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "smoothing", .offset = offsetof(wrc_profile_wear, smoothing), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.05, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
      {.name = "spacing", .offset = offsetof(wrc_profile_wear, spacing), .type = Type::real, .rule = Rule::range, .low = 5e-5, .high = 5e-3, .unit = "m", .too_small = "did you pass mm?", .too_large = "did you pass mm?"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_profile_wear) == 88, "run tools/interface/describe.py");

template <>
struct Description<wrc_worn_profile> {
  static constexpr const char* name = "wrc_worn_profile";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_worn_profile>(56);
  static constexpr wrc_worn_profile defaults = [] {
    wrc_worn_profile value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_worn_profile, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "capacity", .offset = offsetof(wrc_worn_profile, capacity), .type = Type::uint32, .rule = Rule::none},
      {.name = "count", .offset = offsetof(wrc_worn_profile, count), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_worn_profile, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "y", .offset = offsetof(wrc_worn_profile, y), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "z", .offset = offsetof(wrc_worn_profile, z), .type = Type::pointer, .rule = Rule::none, .unit = "m"},
      {.name = "passages", .offset = offsetof(wrc_worn_profile, passages), .type = Type::real, .rule = Rule::none},
      {.name = "depth", .offset = offsetof(wrc_worn_profile, depth), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "area", .offset = offsetof(wrc_worn_profile, area), .type = Type::real, .rule = Rule::none, .unit = "m^2"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_worn_profile) == 56, "run tools/interface/describe.py");

template <>
struct Description<wrc_flange> {
  static constexpr const char* name = "wrc_flange";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_flange>(48);
  static constexpr wrc_flange defaults = [] {
    wrc_flange value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "height", .offset = offsetof(wrc_flange, height), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "thickness", .offset = offsetof(wrc_flange, thickness), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "slope", .offset = offsetof(wrc_flange, slope), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "reserved", .offset = offsetof(wrc_flange, reserved), .type = Type::real, .elements = 3, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_flange) == 48, "run tools/interface/describe.py");

template <>
struct Description<wrc_section_line> {
  static constexpr const char* name = "wrc_section_line";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_section_line>(64);
  static constexpr wrc_section_line defaults = [] {
    wrc_section_line value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "distance", .offset = offsetof(wrc_section_line, distance), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "count", .offset = offsetof(wrc_section_line, count), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_section_line, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "y", .offset = offsetof(wrc_section_line, y), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .counted_by = offsetof(wrc_section_line, count)},
      {.name = "z", .offset = offsetof(wrc_section_line, z), .type = Type::pointer, .rule = Rule::none, .required = true, .unit = "m", .counted_by = offsetof(wrc_section_line, count)},
      {.name = "reserved", .offset = offsetof(wrc_section_line, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_section_line) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_rail_faces_problem> {
  static constexpr const char* name = "wrc_rail_faces_problem";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_rail_faces_problem>(88);
  static constexpr wrc_rail_faces_problem defaults = [] {
    wrc_rail_faces_problem value{};
    value.struct_size = sizeof value;
    value.first = -1e7;
    value.last = 1e7;
    value.depth = 0.03;
    value.gap = 5e-3;
    value.kink = 0.7;
    value.least_width = 3e-3;
    value.tolerance = 2e-4;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_rail_faces_problem, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "section_count", .offset = offsetof(wrc_rail_faces_problem, section_count), .type = Type::uint32, .rule = Rule::range, .low = 2, .high = 100000, .not_set = "was it set? its default is 0"},
      {.name = "sections", .offset = offsetof(wrc_rail_faces_problem, sections), .type = Type::pointer, .rule = Rule::none, .required = true, .counted_by = offsetof(wrc_rail_faces_problem, section_count)},
      {.name = "interruption_count", .offset = offsetof(wrc_rail_faces_problem, interruption_count), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1000},
      {.name = "reserved0", .offset = offsetof(wrc_rail_faces_problem, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "interruptions", .offset = offsetof(wrc_rail_faces_problem, interruptions), .type = Type::pointer, .rule = Rule::range, .required = true, .low = -1e7, .high = 1e7, .unit = "m", .asked = offsetof(wrc_rail_faces_problem, interruption_count), .state = State::not_zero, .counted_by = offsetof(wrc_rail_faces_problem, interruption_count)},
      {.name = "first", .offset = offsetof(wrc_rail_faces_problem, first), .type = Type::real, .rule = Rule::range, .low = -1e7, .high = 1e7, .unit = "m"},
      {.name = "last", .offset = offsetof(wrc_rail_faces_problem, last), .type = Type::real, .rule = Rule::range, .low = -1e7, .high = 1e7, .unit = "m"},
      {.name = "depth", .offset = offsetof(wrc_rail_faces_problem, depth), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 0.2, .unit = "m", .too_small = "a flangeway is deeper than 40 mm: did you pass mm?", .too_large = "a flangeway is deeper than 40 mm: did you pass mm?"},
      {.name = "gap", .offset = offsetof(wrc_rail_faces_problem, gap), .type = Type::real, .rule = Rule::range, .low = 1e-4, .high = 0.1, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "kink", .offset = offsetof(wrc_rail_faces_problem, kink), .type = Type::real, .rule = Rule::range, .low = 0.1, .high = 3, .unit = "rad"},
      {.name = "least_width", .offset = offsetof(wrc_rail_faces_problem, least_width), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 0.05, .unit = "m", .too_large = "did you pass mm?"},
      {.name = "tolerance", .offset = offsetof(wrc_rail_faces_problem, tolerance), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 0.05, .unit = "m", .too_large = "did you pass mm?"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_rail_faces_problem) == 88, "run tools/interface/describe.py");

template <>
struct Description<wrc_found_faces> {
  static constexpr const char* name = "wrc_found_faces";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_found_faces>(48);
  static constexpr wrc_found_faces defaults = [] {
    wrc_found_faces value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_found_faces, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "face_count", .offset = offsetof(wrc_found_faces, face_count), .type = Type::uint32, .rule = Rule::none},
      {.name = "outline_count", .offset = offsetof(wrc_found_faces, outline_count), .type = Type::uint32, .rule = Rule::none},
      {.name = "rail_section_count", .offset = offsetof(wrc_found_faces, rail_section_count), .type = Type::uint32, .rule = Rule::none},
      {.name = "rail_section_size", .offset = offsetof(wrc_found_faces, rail_section_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_found_faces, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "rail_sections", .offset = offsetof(wrc_found_faces, rail_sections), .type = Type::pointer, .rule = Rule::none},
      {.name = "notes", .offset = offsetof(wrc_found_faces, notes), .type = Type::pointer, .rule = Rule::none},
      {.name = "thin", .offset = offsetof(wrc_found_faces, thin), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_found_faces) == 48, "run tools/interface/describe.py");

template <>
struct Description<wrc_face_outline> {
  static constexpr const char* name = "wrc_face_outline";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_face_outline>(64);
  static constexpr wrc_face_outline defaults = [] {
    wrc_face_outline value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_face_outline, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "kind", .offset = offsetof(wrc_face_outline, kind), .type = Type::int32, .rule = Rule::none, .enumeration = &enumerations::wrc_face_kind},
      {.name = "face", .offset = offsetof(wrc_face_outline, face), .type = Type::uint32, .rule = Rule::none},
      {.name = "number", .offset = offsetof(wrc_face_outline, number), .type = Type::uint32, .rule = Rule::none},
      {.name = "count", .offset = offsetof(wrc_face_outline, count), .type = Type::uint32, .rule = Rule::none},
      {.name = "mark_count", .offset = offsetof(wrc_face_outline, mark_count), .type = Type::uint32, .rule = Rule::none},
      {.name = "distance", .offset = offsetof(wrc_face_outline, distance), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "spacing_error", .offset = offsetof(wrc_face_outline, spacing_error), .type = Type::real, .rule = Rule::none, .unit = "m"},
      {.name = "y", .offset = offsetof(wrc_face_outline, y), .type = Type::pointer, .rule = Rule::none, .unit = "m", .counted_by = offsetof(wrc_face_outline, count)},
      {.name = "z", .offset = offsetof(wrc_face_outline, z), .type = Type::pointer, .rule = Rule::none, .unit = "m", .counted_by = offsetof(wrc_face_outline, count)},
      {.name = "marks", .offset = offsetof(wrc_face_outline, marks), .type = Type::pointer, .rule = Rule::none, .unit = "m", .counted_by = offsetof(wrc_face_outline, mark_count)},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_face_outline) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_surface_bin> {
  static constexpr const char* name = "wrc_surface_bin";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_surface_bin>(832);
  static constexpr wrc_surface_bin defaults = [] {
    wrc_surface_bin value{};
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "sum", .offset = offsetof(wrc_surface_bin, sum), .type = Type::uint64, .elements = 96, .rule = Rule::none},
      {.name = "overflow", .offset = offsetof(wrc_surface_bin, overflow), .type = Type::uint64, .rule = Rule::none},
      {.name = "reserved", .offset = offsetof(wrc_surface_bin, reserved), .type = Type::real, .elements = 7, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_surface_bin) == 832, "run tools/interface/describe.py");

template <>
struct Description<wrc_surface> {
  static constexpr const char* name = "wrc_surface";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_surface>(48);
  static constexpr wrc_surface defaults = [] {
    wrc_surface value{};
    value.struct_size = sizeof value;
    value.width = 0.02;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_surface, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "count", .offset = offsetof(wrc_surface, count), .type = Type::uint32, .rule = Rule::range, .low = 1, .high = 10000000, .not_set = "was it set? its default is 0"},
      {.name = "first", .offset = offsetof(wrc_surface, first), .type = Type::real, .rule = Rule::range, .low = -1e9, .high = 1e9, .unit = "m"},
      {.name = "length", .offset = offsetof(wrc_surface, length), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e4, .unit = "m", .too_small = "it is the length of one bin", .too_large = "did you pass the length of all bins?", .not_set = "was it set? its default is 0"},
      {.name = "width", .offset = offsetof(wrc_surface, width), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 0.5, .unit = "m", .too_small = "the band has no area: a contact is 5 to 20 mm wide", .too_large = "did you pass mm?"},
      {.name = "closed", .offset = offsetof(wrc_surface, closed), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "bin_size", .offset = offsetof(wrc_surface, bin_size), .type = Type::uint32, .rule = Rule::range, .low = first_size<wrc_surface_bin>(832), .high = 4096, .too_small = "say sizeof(wrc_surface_bin)", .too_large = "say sizeof(wrc_surface_bin)", .not_set = "was it set? its default is 0"},
      {.name = "bins", .offset = offsetof(wrc_surface, bins), .type = Type::pointer, .rule = Rule::none},
      {.name = "rows", .offset = offsetof(wrc_surface, rows), .type = Type::uint32, .rule = Rule::range, .low = 0, .high = 16},
      {.name = "reserved0", .offset = offsetof(wrc_surface, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "row_first", .offset = offsetof(wrc_surface, row_first), .type = Type::real, .rule = Rule::range, .low = -1, .high = 1, .unit = "m"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_surface) == 64, "run tools/interface/describe.py");

template <>
struct Description<wrc_substance> {
  static constexpr const char* name = "wrc_substance";
  static constexpr bool versioned = false;
  static constexpr std::size_t first = first_size<wrc_substance>(128);
  static constexpr wrc_substance defaults = [] {
    wrc_substance value{};
    value.density = 1000;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "cover", .offset = offsetof(wrc_substance, cover), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .or_zero = true, .unit = "kg/m^2", .too_large = "did you pass g/m^2?"},
      {.name = "weight", .offset = offsetof(wrc_substance, weight), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1000, .or_zero = true},
      {.name = "friction", .offset = offsetof(wrc_substance, friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "wet_friction", .offset = offsetof(wrc_substance, wet_friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "removal", .offset = offsetof(wrc_substance, removal), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .unit = "m^2/J"},
      {.name = "kept", .offset = offsetof(wrc_substance, kept), .type = Type::real, .rule = Rule::range, .low = 0, .high = 100, .unit = "kg/m^2"},
      {.name = "squeeze", .offset = offsetof(wrc_substance, squeeze), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.999},
      {.name = "carry", .offset = offsetof(wrc_substance, carry), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "density", .offset = offsetof(wrc_substance, density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3"},
      {.name = "layer_modulus", .offset = offsetof(wrc_substance, layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "layer_yield", .offset = offsetof(wrc_substance, layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "layer_hardening", .offset = offsetof(wrc_substance, layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "reserved", .offset = offsetof(wrc_substance, reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_substance) == 128, "run tools/interface/describe.py");

template <>
struct Description<wrc_surface_laws> {
  static constexpr const char* name = "wrc_surface_laws";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_surface_laws>(720);
  static constexpr wrc_surface_laws defaults = [] {
    wrc_surface_laws value{};
    value.struct_size = sizeof value;
    value.water = Description<wrc_substance>::defaults;
    value.oxide = Description<wrc_substance>::defaults;
    value.film = Description<wrc_substance>::defaults;
    value.sand = Description<wrc_substance>::defaults;
    value.lubricant = Description<wrc_substance>::defaults;
    value.rail_share = 0.5;
    value.rail_heat_capacity = 35e3;
    value.wheel_heat_capacity = 35e3;
    value.cooling_time = 60;
    value.drying_time = 1800;
    value.evaporation_amount = 5e-3;
    value.latent_heat = 2.4e6;
    value.ambient = 20;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_surface_laws, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_surface_laws, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "water.cover", .offset = offsetof(wrc_surface_laws, water.cover), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .or_zero = true, .unit = "kg/m^2", .too_large = "did you pass g/m^2?"},
      {.name = "water.weight", .offset = offsetof(wrc_surface_laws, water.weight), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1000, .or_zero = true},
      {.name = "water.friction", .offset = offsetof(wrc_surface_laws, water.friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "water.wet_friction", .offset = offsetof(wrc_surface_laws, water.wet_friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "water.removal", .offset = offsetof(wrc_surface_laws, water.removal), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .unit = "m^2/J"},
      {.name = "water.kept", .offset = offsetof(wrc_surface_laws, water.kept), .type = Type::real, .rule = Rule::range, .low = 0, .high = 100, .unit = "kg/m^2"},
      {.name = "water.squeeze", .offset = offsetof(wrc_surface_laws, water.squeeze), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.999},
      {.name = "water.carry", .offset = offsetof(wrc_surface_laws, water.carry), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "water.density", .offset = offsetof(wrc_surface_laws, water.density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3"},
      {.name = "water.layer_modulus", .offset = offsetof(wrc_surface_laws, water.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "water.layer_yield", .offset = offsetof(wrc_surface_laws, water.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "water.layer_hardening", .offset = offsetof(wrc_surface_laws, water.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "water.reserved", .offset = offsetof(wrc_surface_laws, water.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "oxide.cover", .offset = offsetof(wrc_surface_laws, oxide.cover), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .or_zero = true, .unit = "kg/m^2", .too_large = "did you pass g/m^2?"},
      {.name = "oxide.weight", .offset = offsetof(wrc_surface_laws, oxide.weight), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1000, .or_zero = true},
      {.name = "oxide.friction", .offset = offsetof(wrc_surface_laws, oxide.friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "oxide.wet_friction", .offset = offsetof(wrc_surface_laws, oxide.wet_friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "oxide.removal", .offset = offsetof(wrc_surface_laws, oxide.removal), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .unit = "m^2/J"},
      {.name = "oxide.kept", .offset = offsetof(wrc_surface_laws, oxide.kept), .type = Type::real, .rule = Rule::range, .low = 0, .high = 100, .unit = "kg/m^2"},
      {.name = "oxide.squeeze", .offset = offsetof(wrc_surface_laws, oxide.squeeze), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.999},
      {.name = "oxide.carry", .offset = offsetof(wrc_surface_laws, oxide.carry), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "oxide.density", .offset = offsetof(wrc_surface_laws, oxide.density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3"},
      {.name = "oxide.layer_modulus", .offset = offsetof(wrc_surface_laws, oxide.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "oxide.layer_yield", .offset = offsetof(wrc_surface_laws, oxide.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "oxide.layer_hardening", .offset = offsetof(wrc_surface_laws, oxide.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "oxide.reserved", .offset = offsetof(wrc_surface_laws, oxide.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "film.cover", .offset = offsetof(wrc_surface_laws, film.cover), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .or_zero = true, .unit = "kg/m^2", .too_large = "did you pass g/m^2?"},
      {.name = "film.weight", .offset = offsetof(wrc_surface_laws, film.weight), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1000, .or_zero = true},
      {.name = "film.friction", .offset = offsetof(wrc_surface_laws, film.friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "film.wet_friction", .offset = offsetof(wrc_surface_laws, film.wet_friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "film.removal", .offset = offsetof(wrc_surface_laws, film.removal), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .unit = "m^2/J"},
      {.name = "film.kept", .offset = offsetof(wrc_surface_laws, film.kept), .type = Type::real, .rule = Rule::range, .low = 0, .high = 100, .unit = "kg/m^2"},
      {.name = "film.squeeze", .offset = offsetof(wrc_surface_laws, film.squeeze), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.999},
      {.name = "film.carry", .offset = offsetof(wrc_surface_laws, film.carry), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "film.density", .offset = offsetof(wrc_surface_laws, film.density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3"},
      {.name = "film.layer_modulus", .offset = offsetof(wrc_surface_laws, film.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "film.layer_yield", .offset = offsetof(wrc_surface_laws, film.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "film.layer_hardening", .offset = offsetof(wrc_surface_laws, film.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "film.reserved", .offset = offsetof(wrc_surface_laws, film.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "sand.cover", .offset = offsetof(wrc_surface_laws, sand.cover), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .or_zero = true, .unit = "kg/m^2", .too_large = "did you pass g/m^2?"},
      {.name = "sand.weight", .offset = offsetof(wrc_surface_laws, sand.weight), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1000, .or_zero = true},
      {.name = "sand.friction", .offset = offsetof(wrc_surface_laws, sand.friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "sand.wet_friction", .offset = offsetof(wrc_surface_laws, sand.wet_friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "sand.removal", .offset = offsetof(wrc_surface_laws, sand.removal), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .unit = "m^2/J"},
      {.name = "sand.kept", .offset = offsetof(wrc_surface_laws, sand.kept), .type = Type::real, .rule = Rule::range, .low = 0, .high = 100, .unit = "kg/m^2"},
      {.name = "sand.squeeze", .offset = offsetof(wrc_surface_laws, sand.squeeze), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.999},
      {.name = "sand.carry", .offset = offsetof(wrc_surface_laws, sand.carry), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "sand.density", .offset = offsetof(wrc_surface_laws, sand.density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3"},
      {.name = "sand.layer_modulus", .offset = offsetof(wrc_surface_laws, sand.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "sand.layer_yield", .offset = offsetof(wrc_surface_laws, sand.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "sand.layer_hardening", .offset = offsetof(wrc_surface_laws, sand.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "sand.reserved", .offset = offsetof(wrc_surface_laws, sand.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "lubricant.cover", .offset = offsetof(wrc_surface_laws, lubricant.cover), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 100, .or_zero = true, .unit = "kg/m^2", .too_large = "did you pass g/m^2?"},
      {.name = "lubricant.weight", .offset = offsetof(wrc_surface_laws, lubricant.weight), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1000, .or_zero = true},
      {.name = "lubricant.friction", .offset = offsetof(wrc_surface_laws, lubricant.friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "lubricant.wet_friction", .offset = offsetof(wrc_surface_laws, lubricant.wet_friction), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 2, .or_zero = true},
      {.name = "lubricant.removal", .offset = offsetof(wrc_surface_laws, lubricant.removal), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1, .unit = "m^2/J"},
      {.name = "lubricant.kept", .offset = offsetof(wrc_surface_laws, lubricant.kept), .type = Type::real, .rule = Rule::range, .low = 0, .high = 100, .unit = "kg/m^2"},
      {.name = "lubricant.squeeze", .offset = offsetof(wrc_surface_laws, lubricant.squeeze), .type = Type::real, .rule = Rule::range, .low = 0, .high = 0.999},
      {.name = "lubricant.carry", .offset = offsetof(wrc_surface_laws, lubricant.carry), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "lubricant.density", .offset = offsetof(wrc_surface_laws, lubricant.density), .type = Type::real, .rule = Rule::range, .low = 100, .high = 1e5, .unit = "kg/m^3"},
      {.name = "lubricant.layer_modulus", .offset = offsetof(wrc_surface_laws, lubricant.layer_modulus), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e12, .or_zero = true, .unit = "Pa"},
      {.name = "lubricant.layer_yield", .offset = offsetof(wrc_surface_laws, lubricant.layer_yield), .type = Type::real, .rule = Rule::range, .low = 1e3, .high = 1e11, .or_zero = true, .unit = "Pa"},
      {.name = "lubricant.layer_hardening", .offset = offsetof(wrc_surface_laws, lubricant.layer_hardening), .type = Type::real, .rule = Rule::range, .low = -1e13, .high = 1e14, .unit = "Pa/m"},
      {.name = "lubricant.reserved", .offset = offsetof(wrc_surface_laws, lubricant.reserved), .type = Type::real, .elements = 4, .rule = Rule::zero},
      {.name = "rail_share", .offset = offsetof(wrc_surface_laws, rail_share), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "rail_heat_capacity", .offset = offsetof(wrc_surface_laws, rail_heat_capacity), .type = Type::real, .rule = Rule::range, .low = 1e2, .high = 1e8, .unit = "J/(m^2 K)"},
      {.name = "wheel_heat_capacity", .offset = offsetof(wrc_surface_laws, wheel_heat_capacity), .type = Type::real, .rule = Rule::range, .low = 1e2, .high = 1e8, .unit = "J/(m^2 K)"},
      {.name = "cooling_time", .offset = offsetof(wrc_surface_laws, cooling_time), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e9, .unit = "s"},
      {.name = "drying_time", .offset = offsetof(wrc_surface_laws, drying_time), .type = Type::real, .rule = Rule::range, .low = 1e-3, .high = 1e9, .unit = "s"},
      {.name = "evaporation_share", .offset = offsetof(wrc_surface_laws, evaporation_share), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1},
      {.name = "evaporation_amount", .offset = offsetof(wrc_surface_laws, evaporation_amount), .type = Type::real, .rule = Rule::range, .low = 1e-6, .high = 10, .unit = "kg/m^2"},
      {.name = "latent_heat", .offset = offsetof(wrc_surface_laws, latent_heat), .type = Type::real, .rule = Rule::range, .low = 1e5, .high = 1e7, .unit = "J/kg"},
      {.name = "ambient", .offset = offsetof(wrc_surface_laws, ambient), .type = Type::real, .rule = Rule::range, .low = -100, .high = 200, .unit = "degC"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_surface_laws) == 720, "run tools/interface/describe.py");

template <>
struct Description<wrc_surface_passage> {
  static constexpr const char* name = "wrc_surface_passage";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_surface_passage>(48);
  static constexpr wrc_surface_passage defaults = [] {
    wrc_surface_passage value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_surface_passage, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_surface_passage, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "rail_from", .offset = offsetof(wrc_surface_passage, rail_from), .type = Type::real, .rule = Rule::range, .low = -1e9, .high = 1e9, .unit = "m"},
      {.name = "rail_to", .offset = offsetof(wrc_surface_passage, rail_to), .type = Type::real, .rule = Rule::range, .low = -1e9, .high = 1e9, .unit = "m"},
      {.name = "wheel_from", .offset = offsetof(wrc_surface_passage, wheel_from), .type = Type::real, .rule = Rule::range, .low = -1e9, .high = 1e9, .unit = "m"},
      {.name = "wheel_to", .offset = offsetof(wrc_surface_passage, wheel_to), .type = Type::real, .rule = Rule::range, .low = -1e9, .high = 1e9, .unit = "m"},
      {.name = "energy", .offset = offsetof(wrc_surface_passage, energy), .type = Type::real, .rule = Rule::range, .low = 0, .high = 1e9, .unit = "J", .negative = "frictional energy is wrc_wrench.power times the duration"},
      {.name = "film_rows", .offset = offsetof(wrc_surface_passage, film_rows), .type = Type::pointer, .rule = Rule::none},
      {.name = "film_numbers", .offset = offsetof(wrc_surface_passage, film_numbers), .type = Type::uint32, .rule = Rule::range, .low = 13, .high = 1288, .or_zero = true},
      {.name = "reserved1", .offset = offsetof(wrc_surface_passage, reserved1), .type = Type::uint32, .rule = Rule::zero},
      {.name = "contact", .offset = offsetof(wrc_surface_passage, contact), .type = Type::pointer, .rule = Rule::none},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_surface_passage) == 72, "run tools/interface/describe.py");

template <>
struct Description<wrc_surface_exchange> {
  static constexpr const char* name = "wrc_surface_exchange";
  static constexpr bool versioned = true;
  static constexpr std::size_t first = first_size<wrc_surface_exchange>(96);
  static constexpr wrc_surface_exchange defaults = [] {
    wrc_surface_exchange value{};
    value.struct_size = sizeof value;
    return value;
  }();
  static constexpr Member members[] = {
      {.name = "struct_size", .offset = offsetof(wrc_surface_exchange, struct_size), .type = Type::uint32, .rule = Rule::none},
      {.name = "reserved0", .offset = offsetof(wrc_surface_exchange, reserved0), .type = Type::uint32, .rule = Rule::zero},
      {.name = "carried", .offset = offsetof(wrc_surface_exchange, carried), .type = Type::real, .elements = 8, .rule = Rule::none, .unit = "kg"},
      {.name = "rail_energy", .offset = offsetof(wrc_surface_exchange, rail_energy), .type = Type::real, .rule = Rule::none, .unit = "J"},
      {.name = "wheel_energy", .offset = offsetof(wrc_surface_exchange, wheel_energy), .type = Type::real, .rule = Rule::none, .unit = "J"},
      {.name = "beside_energy", .offset = offsetof(wrc_surface_exchange, beside_energy), .type = Type::real, .rule = Rule::none, .unit = "J"},
  };
};
static_assert(!pointers_of_64_bits || sizeof(wrc_surface_exchange) == 96, "run tools/interface/describe.py");

}  // namespace wrc::abi
