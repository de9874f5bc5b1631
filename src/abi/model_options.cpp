#include "abi/model_options.hpp"

#include "abi/structs.hpp"
#include "contact/contact.hpp"
#include "tangential/force_table_file.hpp"

namespace wrc::abi {
namespace {

/// An integer of the configuration against its range.
Fault check_count(std::int32_t value, const char* field, std::int32_t low, std::int32_t high,
                  const char* cause) {
  return check(static_cast<double>(value), field, "", low, high, cause, cause);
}

Fault check_no_smoothing(const wrc_profile& profile) {
  if (profile.smoothing == 0.0) return {};
  return {.status = WRC_ERROR_UNSUPPORTED,
          .field = "profile.smoothing",
          .value = profile.smoothing,
          .unit = "m",
          .cause = "only points are smoothed; standard profiles are exact"};
}

Fault read_profile(const wrc_profile* theirs, const char* name, ProfileSource& source) {
  wrc_profile profile;
  Fault fault = read(theirs, name, profile);
  if (fault.failed()) return fault;
  switch (profile.kind) {
    case WRC_PROFILE_S1002:
      source.kind = ProfileSource::Kind::s1002;
      return check_no_smoothing(profile);
    case WRC_PROFILE_60E1:
      source.kind = ProfileSource::Kind::rail_60e1;
      return check_no_smoothing(profile);
    case WRC_PROFILE_UIC60_BENCHMARK:
      source.kind = ProfileSource::Kind::rail_uic60_benchmark;
      return check_no_smoothing(profile);
    case WRC_PROFILE_POINTS:
      break;
    default:
      return {.status = WRC_ERROR_UNSUPPORTED,
              .field = name,
              .value = static_cast<double>(profile.kind),
              .unit = "",
              .cause = "its kind is none of enum wrc_profile_kind"};
  }
  if (profile.y == nullptr || profile.z == nullptr) {
    return {
        .status = WRC_ERROR_NULL, .field = name, .cause = "points y and z are needed for WRC_PROFILE_POINTS"};
  }
  if (profile.count < 4 || profile.count > 20000) {
    return {.status = WRC_ERROR_PROFILE,
            .field = name,
            .value = static_cast<double>(profile.count),
            .unit = "points",
            .low = 4.0,
            .high = 20000.0,
            .cause = "a spline needs at least four points"};
  }
  fault = check(profile.smoothing, "profile.smoothing", "m", 0.0, 0.05, nullptr, "did you pass mm?");
  if (fault.failed()) return fault;
  source = {ProfileSource::Kind::points, static_cast<std::int32_t>(profile.count), profile.y, profile.z,
            profile.smoothing};
  return {};
}

bool is_wheel(ProfileSource::Kind kind) {
  return kind == ProfileSource::Kind::s1002 || kind == ProfileSource::Kind::points;
}
bool is_rail(ProfileSource::Kind kind) { return kind != ProfileSource::Kind::s1002; }

Fault unsupported(const char* field, double value, const char* cause, const char* unit = "") {
  return {.status = WRC_ERROR_UNSUPPORTED, .field = field, .value = value, .unit = unit, .cause = cause};
}

Fault read_methods(const wrc_config& config, ModelOptions& options) {
  switch (config.normal_method) {
    case WRC_NORMAL_HERTZ:
      options.normal_method = NormalMethod::hertz;
      break;
    case WRC_NORMAL_KIK_PIOTROWSKI:
      options.normal_method = NormalMethod::kik_piotrowski;
      break;
    case WRC_NORMAL_EKP:
      options.normal_method = NormalMethod::ekp;
      break;
    case WRC_NORMAL_EKP_ELLIPSE:
      options.normal_method = NormalMethod::ekp_ellipse;
      break;
    case WRC_NORMAL_ANALYN:
      options.normal_method = NormalMethod::analyn;
      break;
    case WRC_NORMAL_STRIPES:
      options.normal_method = NormalMethod::stripes;
      break;
    case WRC_NORMAL_STRIP_HALFSPACE:
      options.normal_method = NormalMethod::strip_halfspace;
      break;
    default:
      return unsupported("config.normal_method", config.normal_method, "see enum wrc_normal_method");
  }
  switch (config.regularisation) {
    case WRC_REGULARISE_KEEP_WIDTH:
      options.regularisation = SecondCriterion::width;
      break;
    case WRC_REGULARISE_KEEP_RATIO:
      options.regularisation = SecondCriterion::aspect_ratio;
      break;
    default:
      return unsupported("config.regularisation", config.regularisation, "see enum wrc_regularisation");
  }
  switch (config.tangential_method) {
    case WRC_TANGENTIAL_FASTSIM:
      options.tangential_method = TangentialMethod::fastsim;
      break;
    case WRC_TANGENTIAL_FASTSIM_EQE:
      options.tangential_method = TangentialMethod::fastsim_eqe;
      break;
    case WRC_TANGENTIAL_FASTSIM_EQL:
      options.tangential_method = TangentialMethod::fastsim_eql;
      break;
    case WRC_TANGENTIAL_FASTSIM_SDEC:
      options.tangential_method = TangentialMethod::fastsim_sdec;
      break;
    case WRC_TANGENTIAL_STRIP_FASTSIM:
      options.tangential_method = TangentialMethod::strip_fastsim;
      break;
    case WRC_TANGENTIAL_MODIFIED_FASTSIM:
      options.tangential_method = TangentialMethod::modified_fastsim;
      break;
    case WRC_TANGENTIAL_FASTRIP:
      options.tangential_method = TangentialMethod::fastrip;
      break;
    case WRC_TANGENTIAL_FASTRIP_MODIFIED:
      options.tangential_method = TangentialMethod::fastrip_modified;
      break;
    case WRC_TANGENTIAL_FASTRIP_SDEC:
      options.tangential_method = TangentialMethod::fastrip_sdec;
      break;
    case WRC_TANGENTIAL_COARSE_HALFSPACE:
      options.tangential_method = TangentialMethod::coarse_halfspace;
      break;
    case WRC_TANGENTIAL_TABLE:
      options.tangential_method = TangentialMethod::table;
      break;
    default:
      return unsupported("config.tangential_method", config.tangential_method,
                         "see enum wrc_tangential_method");
  }
  switch (config.flexibility) {
    case WRC_FLEXIBILITY_SEPARATE:
      options.flexibility = FlexibilityForm::separate;
      break;
    case WRC_FLEXIBILITY_SINGLE:
      options.flexibility = FlexibilityForm::single;
      break;
    case WRC_FLEXIBILITY_BLENDED:
      options.flexibility = FlexibilityForm::blended;
      break;
    default:
      return unsupported("config.flexibility", config.flexibility, "see enum wrc_flexibility");
  }
  const InstructionSet best = best_instruction_set();
  switch (config.instruction_set) {
    case WRC_INSTRUCTIONS_BEST:
      options.instruction_set = best;
      break;
    case WRC_INSTRUCTIONS_BASELINE:
      options.instruction_set = InstructionSet::baseline;
      break;
    case WRC_INSTRUCTIONS_AVX2:
      options.instruction_set = InstructionSet::avx2;
      break;
    case WRC_INSTRUCTIONS_AVX512:
      options.instruction_set = InstructionSet::avx512;
      break;
    default:
      return unsupported("config.instruction_set", config.instruction_set, "see enum wrc_instruction_set");
  }
  if (options.instruction_set > best) {
    return unsupported("config.instruction_set", config.instruction_set,
                       "this processor lacks that instruction set; WRC_INSTRUCTIONS_BEST takes what it has");
  }
  switch (config.traction_bound) {
    case WRC_BOUND_PARABOLIC:
      options.traction_bound = TractionBound::parabolic;
      break;
    case WRC_BOUND_ELLIPTIC:
      options.traction_bound = TractionBound::elliptic;
      break;
    case WRC_BOUND_ELLIPSOIDAL:
      options.traction_bound = TractionBound::ellipsoidal;
      break;
    default:
      return unsupported("config.traction_bound", config.traction_bound, "see enum wrc_traction_bound");
  }
  return {};
}

/// What the chosen methods do not read must stand as wrc_config_init() leaves it: an option without effect is
/// a mistake of the caller's.
Fault check_unread(const wrc_config& config) {
  const wrc_config untouched = defaults<wrc_config>();
  if (config.normal_method == WRC_NORMAL_STRIP_HALFSPACE) {
    if (config.load_tolerance != untouched.load_tolerance)
      return unsupported("config.load_tolerance", config.load_tolerance,
                         "WRC_NORMAL_STRIP_HALFSPACE does not read it: it meets every load to rounding");
  } else if (config.warm_start != untouched.warm_start) {
    return unsupported("config.warm_start", config.warm_start, "only WRC_NORMAL_STRIP_HALFSPACE reads it");
  }
  switch (config.tangential_method) {
    case WRC_TANGENTIAL_FASTSIM:
    case WRC_TANGENTIAL_FASTSIM_EQE:
    case WRC_TANGENTIAL_FASTSIM_EQL:
    case WRC_TANGENTIAL_FASTSIM_SDEC:
    case WRC_TANGENTIAL_MODIFIED_FASTSIM:
      break;
    default:
      if (config.traction_bound != untouched.traction_bound)
        return unsupported("config.traction_bound", config.traction_bound,
                           "only the FASTSIM variants read it: this method has a bound of its own");
      if (config.flexibility != untouched.flexibility)
        return unsupported("config.flexibility", config.flexibility,
                           "only the FASTSIM variants read it: this method has flexibilities of its own");
  }
  if (config.tangential_method != WRC_TANGENTIAL_TABLE && config.force_table != nullptr)
    return {.status = WRC_ERROR_UNSUPPORTED,
            .field = "config.force_table",
            .cause = "only WRC_TANGENTIAL_TABLE reads it"};
  if (config.wheel != nullptr || config.rail != nullptr) return {};
  constexpr const char* placed =
      "the model has no profiles to place: what the caller hands over is taken as it is";
  if (config.side != untouched.side) return unsupported("config.side", config.side, placed);
  if (config.flange_back_distance != untouched.flange_back_distance)
    return unsupported("config.flange_back_distance", config.flange_back_distance, placed, "m");
  if (config.track_gauge != untouched.track_gauge)
    return unsupported("config.track_gauge", config.track_gauge, placed, "m");
  if (config.gauge_depth != untouched.gauge_depth)
    return unsupported("config.gauge_depth", config.gauge_depth, placed, "m");
  if (config.rail_inclination != untouched.rail_inclination)
    return unsupported("config.rail_inclination", config.rail_inclination, placed);
  return {};
}

/// The method's own cap where the caller leaves it to the method.
std::int32_t iteration_cap(const wrc_config& config) {
  constexpr std::int32_t steps_of_load_search = 60;
  if (config.max_iterations > 0) return config.max_iterations;
  return config.normal_method == WRC_NORMAL_STRIP_HALFSPACE ? StripHalfspaceOptions{}.max_sweeps
                                                            : steps_of_load_search;
}

/// The header of the force table tells how much memory the model needs.
Fault read_table(const wrc_config& config, ModelOptions& options) {
  if (config.force_table == nullptr) {
    return {.status = WRC_ERROR_NULL,
            .field = "config.force_table",
            .cause = "WRC_TANGENTIAL_TABLE needs the file of the book of tables"};
  }
  options.force_table = config.force_table;
  return read_force_table_axes(config.force_table, options.force_table_axes);
}

}  // namespace

Fault read_options(const wrc_config* theirs, ModelOptions& options) {
  wrc_config config;
  Fault fault = read(theirs, "config", config);
  if (fault.failed()) return fault;

  if (config.side != WRC_SIDE_RIGHT && config.side != WRC_SIDE_LEFT) {
    return unsupported("config.side", config.side, "see enum wrc_side");
  }
  fault = read_methods(config, options);
  if (fault.failed()) return fault;

  switch (config.profile_placement) {
    case WRC_PLACEMENT_GAUGE:
      options.track.by_origin = false;
      break;
    case WRC_PLACEMENT_ORIGIN:
      options.track.by_origin = true;
      break;
    default:
      return unsupported("config.profile_placement", config.profile_placement,
                         "see enum wrc_profile_placement");
  }

  const Fault checks[] = {
      check_count(config.strips, "config.strips", 4, 512, "more strips cost time in proportion"),
      check_count(config.cells, "config.cells", 4, 512, "more cells cost time in proportion"),
      check_count(config.gap_rows, "config.gap_rows", 8, 4096, "the gap is interpolated between rows"),
      config.max_iterations == 0
          ? Fault{}
          : check_count(config.max_iterations, "config.max_iterations", 4, 1000, "0 is the method's own cap"),
      check_count(config.max_patches, "config.max_patches", 1, patch_capacity,
                  "a wheel touches its rail in one to three places"),
      check_count(config.warm_start, "config.warm_start", 0, 1, "0 or 1"),
      check(config.shear_modulus, "config.shear_modulus", "Pa", 1e8, 1e12, "did you pass MPa or GPa?",
            "steel has 80e9"),
      check(config.poisson, "config.poisson", "", 0.0, 0.5, "steel has 0.25 to 0.3", "steel has 0.25 to 0.3"),
      check(config.load_tolerance, "config.load_tolerance", "", 1e-14, 1e-2),
      check(config.gap_limit, "config.gap_limit", "m", 1e-5, 0.02, nullptr, "did you pass mm?"),
      check(config.shear_yield, "config.shear_yield", "Pa", 1e6, 1e11, "did you pass MPa?"),
      check(config.wheel_radius, "config.wheel_radius", "m", 0.1, 1.5, nullptr, "did you pass mm?"),
      check(config.flange_back_distance, "config.flange_back_distance", "m", 0.3, 2.5, nullptr,
            "did you pass mm?"),
      check(config.track_gauge, "config.track_gauge", "m", 0.3, 2.5, nullptr, "did you pass mm?"),
      check(config.gauge_depth, "config.gauge_depth", "m", 0.005, 0.04, nullptr, "did you pass mm?"),
      options.track.by_origin
          ? check(config.rail_origin, "config.rail_origin", "m", 0.2, 1.5,
                  "WRC_PLACEMENT_ORIGIN needs the distance from the track's centre line to the rail "
                  "profile's origin",
                  "did you pass mm, or the distance from rail to rail?")
          : check(config.rail_origin, "config.rail_origin", "m", 0.0, 0.0, "a distance is not negative",
                  "it is used by WRC_PLACEMENT_ORIGIN only: leave it 0"),
      check(config.rail_inclination, "config.rail_inclination", "", -0.2, 0.2, "1:40 is 0.025",
            "1:40 is 0.025, not 40"),
  };
  for (const Fault& each : checks) {
    if (each.failed()) return each;
  }
  fault = check_unread(config);
  if (fault.failed()) return fault;
  options.sizes = {.strips = config.strips, .cells = config.cells, .gap_rows = config.gap_rows};
  options.max_iterations = iteration_cap(config);
  options.max_patches = config.max_patches;
  options.warm_start = config.warm_start != 0;
  options.material = {config.shear_modulus, config.poisson};
  options.load_tolerance = config.load_tolerance;
  options.gap_limit = config.gap_limit;
  options.shear_yield = config.shear_yield;
  options.side = config.side == WRC_SIDE_LEFT ? Side::left : Side::right;
  options.wheelset.nominal_radius = config.wheel_radius;
  options.wheelset.flange_back_distance = config.flange_back_distance;
  options.track.gauge = config.track_gauge;
  options.track.gauge_depth = config.gauge_depth;
  options.track.rail_inclination = config.rail_inclination;
  options.track.rail_origin = config.rail_origin;

  if (options.tangential_method == TangentialMethod::table) {
    fault = read_table(config, options);
    if (fault.failed()) return fault;
  }
  if (config.wheel == nullptr && config.rail == nullptr) return {};  // the host hands over gaps
  fault = read_profile(config.wheel, "config.wheel", options.wheel);
  if (fault.failed()) return fault;
  fault = read_profile(config.rail, "config.rail", options.rail);
  if (fault.failed()) return fault;
  if (!is_wheel(options.wheel.kind)) {
    return {.status = WRC_ERROR_PROFILE, .field = "config.wheel", .cause = "this is a rail profile"};
  }
  if (!is_rail(options.rail.kind)) {
    return {.status = WRC_ERROR_PROFILE, .field = "config.rail", .cause = "this is a wheel profile"};
  }
  if (options.rail.kind == ProfileSource::Kind::rail_uic60_benchmark && config.rail_inclination != 0.0) {
    return {
        .status = WRC_ERROR_UNSUPPORTED,
        .field = "config.rail_inclination",
        .value = config.rail_inclination,
        .unit = "",
        .cause = "WRC_PROFILE_UIC60_BENCHMARK is canted 1:40 already: leave it 0, or take WRC_PROFILE_60E1"};
  }
  return {};
}

}  // namespace wrc::abi
