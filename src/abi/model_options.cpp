#include "abi/model_options.hpp"

#include "abi/structs.hpp"
#include "contact/contact.hpp"
#include "contact/methods.hpp"
#include "tangential/force_table/force_table_file.hpp"

namespace wrc::abi {
namespace {

Fault check_no_smoothing(const wrc_profile& profile, const char* name) {
  if (profile.smoothing == 0.0) return {};
  return {.status = WRC_ERROR_UNSUPPORTED,
          .of = name,
          .field = "smoothing",
          .value = profile.smoothing,
          .unit = "m",
          .cause = "only points are smoothed; standard profiles are exact"};
}

Fault read_profile(const wrc_profile* theirs, const char* name, ProfileSource& source) {
  wrc_profile profile;
  const Fault fault = read(theirs, name, profile);
  if (fault.failed()) return fault;
  switch (profile.kind) {
    case WRC_PROFILE_S1002:
      source.kind = ProfileSource::Kind::s1002;
      return check_no_smoothing(profile, name);
    case WRC_PROFILE_60E1:
      source.kind = ProfileSource::Kind::rail_60e1;
      return check_no_smoothing(profile, name);
    case WRC_PROFILE_UIC60_BENCHMARK:
      source.kind = ProfileSource::Kind::rail_uic60_benchmark;
      return check_no_smoothing(profile, name);
    default:  // WRC_PROFILE_POINTS
      break;
  }
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

// Enumerations of the interface that are those of the inside, value by value.
static_assert(same<WRC_REGULARISE_KEEP_WIDTH>(SecondCriterion::width) &&
              same<WRC_REGULARISE_KEEP_RATIO>(SecondCriterion::aspect_ratio));
static_assert(same<WRC_BOUND_PARABOLIC>(TractionBound::parabolic) &&
              same<WRC_BOUND_ELLIPTIC>(TractionBound::elliptic) &&
              same<WRC_BOUND_ELLIPSOIDAL>(TractionBound::ellipsoidal));
static_assert(same<WRC_FLEXIBILITY_SEPARATE>(FlexibilityForm::separate) &&
              same<WRC_FLEXIBILITY_SINGLE>(FlexibilityForm::single) &&
              same<WRC_FLEXIBILITY_BLENDED>(FlexibilityForm::blended));
static_assert(same<WRC_INSTRUCTIONS_BASELINE - 1>(InstructionSet::baseline) &&
              same<WRC_INSTRUCTIONS_AVX2 - 1>(InstructionSet::avx2) &&
              same<WRC_INSTRUCTIONS_AVX512 - 1>(InstructionSet::avx512));

/// In the order of enum wrc_patch_model.
constexpr PatchModel patch_models[] = {patch_with_sdec, patch_with_ellipse, ellipse_at_middle,
                                       ellipse_at_point};
static_assert(WRC_PATCH_MODEL_PATCH_SDEC == 0 && WRC_PATCH_MODEL_PATCH_ELLIPSE == 1 &&
              WRC_PATCH_MODEL_ELLIPSE_AT_MIDDLE == 2 && WRC_PATCH_MODEL_ELLIPSE_AT_POINT == 3);

Fault read_methods(const wrc_config& config, ModelOptions& options) {
  options.normal_method = normal_method(config.normal_method);
  options.tangential_method = tangential_method(config.tangential_method);
  if (options.normal_method == nullptr || options.tangential_method == nullptr)
    return {.status = WRC_ERROR_INTERNAL, .field = "config", .cause = "a method without a row in its table"};
  options.patch_model = patch_models[config.patch_model];
  options.regularisation = static_cast<SecondCriterion>(config.regularisation);
  options.traction_bound = static_cast<TractionBound>(config.traction_bound);
  options.flexibility = static_cast<FlexibilityForm>(config.flexibility);
  const InstructionSet best = best_instruction_set();
  options.instruction_set = config.instruction_set == WRC_INSTRUCTIONS_BEST
                                ? best
                                : static_cast<InstructionSet>(config.instruction_set - 1);
  if (options.instruction_set <= best) return {};
  return unsupported("config.instruction_set", config.instruction_set,
                     "this processor lacks that instruction set; WRC_INSTRUCTIONS_BEST takes what it has");
}

/// What the chosen methods do not read must stand as wrc_config_init() leaves it: an option without effect is
/// a mistake of the caller's.
Fault check_unread(const wrc_config& config, const ModelOptions& options) {
  const wrc_config untouched = defaults<wrc_config>();
  const struct {
    Option option;
    const char* field;
    double value, untouched;
  } each[] = {
      {Option::load_tolerance, "config.load_tolerance", config.load_tolerance, untouched.load_tolerance},
      {Option::warm_start, "config.warm_start", static_cast<double>(config.warm_start),
       static_cast<double>(untouched.warm_start)},
      {Option::patch_model, "config.patch_model", static_cast<double>(config.patch_model),
       static_cast<double>(untouched.patch_model)},
      {Option::traction_bound, "config.traction_bound", static_cast<double>(config.traction_bound),
       static_cast<double>(untouched.traction_bound)},
      {Option::flexibility, "config.flexibility", static_cast<double>(config.flexibility),
       static_cast<double>(untouched.flexibility)},
  };
  const auto read = [&](Option option) {
    return options.normal_method->reads.has(option) || options.tangential_method->reads.has(option);
  };
  for (const auto& [option, field, value, default_value] : each)
    if (value != default_value && !read(option)) return unsupported(field, value, readers_of(option));
  if (config.force_table != nullptr && !read(Option::force_table))
    return {.status = WRC_ERROR_UNSUPPORTED,
            .field = "config.force_table",
            .cause = readers_of(Option::force_table)};
  if (config.wheel != nullptr || config.rail != nullptr) return {};
  constexpr const char* placed =
      "the model has no profiles to place: what the caller hands over is taken as it is";
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

/// The header of the force table tells how much memory the model needs.
Fault read_table(const wrc_config& config, ModelOptions& options) {
  if (config.force_table == nullptr) {
    return {.status = WRC_ERROR_NULL,
            .field = "config.force_table",
            .cause = "this tangential method needs the file of the force table"};
  }
  options.force_table = config.force_table;
  return read_force_table_axes(config.force_table, options.force_table_axes);
}

}  // namespace

static_assert(member<wrc_config>("max_patches").high == patch_capacity);

Fault read_options(const wrc_config* theirs, ModelOptions& options) {
  wrc_config config;
  Fault fault = read(theirs, "config", config);
  if (fault.failed()) return fault;

  fault = read_methods(config, options);
  if (fault.failed()) return fault;

  fault = check_unread(config, options);
  if (fault.failed()) return fault;
  options.track.by_origin = config.profile_placement == WRC_PLACEMENT_ORIGIN;
  options.sizes = {.strips = config.strips, .cells = config.cells, .gap_rows = config.gap_rows};
  options.max_iterations =
      config.max_iterations > 0 ? config.max_iterations : options.normal_method->iterations;
  options.max_patches = config.max_patches;
  options.warm_start = config.warm_start != 0;
  options.material = {config.shear_modulus, config.poisson};
  options.load_tolerance = config.load_tolerance;
  options.gap_limit = config.gap_limit;
  options.shear_yield = config.shear_yield;
  options.wheelset.nominal_radius = config.wheel_radius;
  options.wheelset.flange_back_distance = config.flange_back_distance;
  options.track.gauge = config.track_gauge;
  options.track.gauge_depth = config.gauge_depth;
  options.track.rail_inclination = config.rail_inclination;
  options.track.rail_origin = config.rail_origin;

  if (options.tangential_method->reads.has(Option::force_table)) {
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
