#include "abi/model_options.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "abi/structs.hpp"
#include "abi/temperature.hpp"
#include "base/checksum.hpp"
#include "contact/methods.hpp"
#include "contact/state.hpp"
#include "tangential/force_table/force_table_file.hpp"

namespace wrc::abi {
namespace {

Fault check_no_smoothing(const wrc_profile& profile, const char* name) {
  if (profile.smoothing == 0.0) return {};
  return Fault::unsupported({name, "smoothing"}, {profile.smoothing, "m"},
                            "only points are smoothed; standard profiles are exact");
}

/// `name`: its name in messages.
Fault read_profile(const wrc_profile& profile, const char* name, contact::ProfileSource& source) {
  switch (profile.kind) {
    case WRC_PROFILE_S1002:
      source.kind = contact::ProfileSource::Kind::s1002;
      return check_no_smoothing(profile, name);
    case WRC_PROFILE_60E1:
      source.kind = contact::ProfileSource::Kind::rail_60e1;
      return check_no_smoothing(profile, name);
    case WRC_PROFILE_UIC60_BENCHMARK:
      source.kind = contact::ProfileSource::Kind::rail_uic60_benchmark;
      return check_no_smoothing(profile, name);
    case WRC_PROFILE_NONE:
      return Fault::profile(name, "WRC_PROFILE_NONE beside the other body's profile: give both, or neither");
    default:  // WRC_PROFILE_POINTS
      break;
  }
  source = {contact::ProfileSource::Kind::points, static_cast<std::int32_t>(profile.count), profile.y,
            profile.z, profile.smoothing};
  return {};
}

/// Points without a kind would go unread.
Fault check_no_points(const wrc_profile& profile, const char* name) {
  if (profile.kind != WRC_PROFILE_NONE ||
      (profile.count == 0 && profile.y == nullptr && profile.z == nullptr))
    return {};
  return Fault::profile(name, "it has points, but its kind is not WRC_PROFILE_POINTS");
}

bool has_profiles(const wrc_config& config) {
  return config.wheel.kind != WRC_PROFILE_NONE || config.rail.kind != WRC_PROFILE_NONE;
}

bool is_wheel(contact::ProfileSource::Kind kind) {
  return kind == contact::ProfileSource::Kind::s1002 || kind == contact::ProfileSource::Kind::points;
}
bool is_rail(contact::ProfileSource::Kind kind) { return kind != contact::ProfileSource::Kind::s1002; }

// Enumerations of the interface that are those of the inside, value by value.
static_assert(same<WRC_REGULARISE_KEEP_WIDTH>(patch::SecondCriterion::width) &&
              same<WRC_REGULARISE_KEEP_RATIO>(patch::SecondCriterion::aspect_ratio));
static_assert(same<WRC_BOUND_PARABOLIC>(tangential::TractionBound::parabolic) &&
              same<WRC_BOUND_ELLIPTIC>(tangential::TractionBound::elliptic) &&
              same<WRC_BOUND_ELLIPSOIDAL>(tangential::TractionBound::ellipsoidal));
static_assert(same<WRC_FLEXIBILITY_SEPARATE>(tangential::FlexibilityForm::separate) &&
              same<WRC_FLEXIBILITY_SINGLE>(tangential::FlexibilityForm::single) &&
              same<WRC_FLEXIBILITY_BLENDED>(tangential::FlexibilityForm::blended));
static_assert(same<WRC_INSTRUCTIONS_BASELINE - 1>(InstructionSet::baseline) &&
              same<WRC_INSTRUCTIONS_AVX2 - 1>(InstructionSet::avx2) &&
              same<WRC_INSTRUCTIONS_AVX512 - 1>(InstructionSet::avx512));

/// In the order of enum wrc_patch_model.
constexpr tangential::PatchModel patch_models[] = {
    tangential::patch_with_sdec, tangential::patch_with_ellipse, tangential::ellipse_at_middle,
    tangential::ellipse_at_point};
static_assert(WRC_PATCH_MODEL_PATCH_SDEC == 0 && WRC_PATCH_MODEL_PATCH_ELLIPSE == 1 &&
              WRC_PATCH_MODEL_ELLIPSE_AT_MIDDLE == 2 && WRC_PATCH_MODEL_ELLIPSE_AT_POINT == 3);

Fault read_methods(const wrc_config& config, contact::ModelOptions& options) {
  options.normal_method = contact::normal_method(config.normal.method);
  options.tangential_method = contact::tangential_method(config.tangential.method);
  if (options.normal_method == nullptr || options.tangential_method == nullptr)
    return Fault::internal("config", "a method without a row in its table");
  options.patch_model = patch_models[config.tangential.patch_model];
  options.regularisation = static_cast<patch::SecondCriterion>(config.planar.regularisation);
  options.traction_bound = static_cast<tangential::TractionBound>(config.tangential.bound);
  options.flexibility = static_cast<tangential::FlexibilityForm>(config.tangential.flexibility);
  options.non_steady = config.planar.non_steady == 1;
  options.surface_memory = config.surface.memory == 1;
  const InstructionSet best = best_instruction_set();
  options.instruction_set = config.instruction_set == WRC_INSTRUCTIONS_BEST
                                ? best
                                : static_cast<InstructionSet>(config.instruction_set - 1);
  if (options.instruction_set <= best) return {};
  return Fault::unsupported("config.instruction_set", {config.instruction_set, ""},
                            "this processor or this build lacks that instruction set; WRC_INSTRUCTIONS_BEST "
                            "takes the widest there is");
}

/// Options of the configuration that some methods read and others do not.
constexpr struct {
  contact::Option option;
  const Member& member;
} options_of_methods[] = {
    {contact::Option::max_iterations, MEMBER(wrc_config, "normal.max_iterations")},
    {contact::Option::max_sweeps, MEMBER(wrc_config, "planar.max_sweeps")},
    {contact::Option::load_tolerance, MEMBER(wrc_config, "normal.load_tolerance")},
    {contact::Option::warm_start, MEMBER(wrc_config, "planar.start")},
    {contact::Option::surface_iteration, MEMBER(wrc_config, "surface.tolerance")},
    {contact::Option::surface_iteration, MEMBER(wrc_config, "surface.max_work")},
    {contact::Option::surface_iteration, MEMBER(wrc_config, "surface.max_iterations")},
    {contact::Option::patch_model, MEMBER(wrc_config, "tangential.patch_model")},
    {contact::Option::traction_bound, MEMBER(wrc_config, "tangential.bound")},
    {contact::Option::flexibility, MEMBER(wrc_config, "tangential.flexibility")},
    {contact::Option::non_steady, MEMBER(wrc_config, "planar.non_steady")},
    {contact::Option::surface_memory, MEMBER(wrc_config, "surface.memory")},
};

/// Members that place profiles or cut them, and are read with profiles only.
constexpr const Member* read_with_profiles[] = {&MEMBER(wrc_config, "wheelset.tape_circle_distance"),
                                                &MEMBER(wrc_config, "track.gauge"),
                                                &MEMBER(wrc_config, "track.gauge_depth"),
                                                &MEMBER(wrc_config, "track.rail_inclination"),
                                                &MEMBER(wrc_config, "track.placement"),
                                                &MEMBER(wrc_config, "surface.memory"),
                                                &MEMBER(wrc_config, "surface.tread_width"),
                                                &MEMBER(wrc_config, "surface.corner_width")};

/// Refuses options that are not at their defaults although nothing reads them: without effect they are
/// mistakes of the caller's.
Fault check_unread(const wrc_config& config, const contact::ModelOptions& options) {
  const auto changed = [&](const Member& member) {
    return number_in(config, member) != number_in(Description<wrc_config>::defaults, member);
  };
  const auto refused = [&](const Member& member, const char* cause) {
    return Fault::unsupported({"config", member.name}, {number_in(config, member), member.unit}, cause);
  };
  const auto read = [&](contact::Option option) {
    return options.normal_method->reads.has(option) || options.tangential_method->reads.has(option);
  };
  for (const auto& [option, member] : options_of_methods)
    if (changed(member) && !read(option)) return refused(member, contact::readers_of(option));
  if (config.tangential.force_table != nullptr && !read(contact::Option::force_table))
    return Fault::unsupported("config.tangential.force_table",
                              contact::readers_of(contact::Option::force_table));
  if (has_profiles(config)) return {};
  for (const Member* const member : read_with_profiles)
    if (changed(*member))
      return refused(*member,
                     "the model has no profiles to place or cut: gaps, strips and ellipses of the caller are "
                     "used unchanged");
  return {};
}

/// Widths of the rail's strips, and how far and how long their pressures are iterated.
Fault read_resolution(const wrc_config_surface& surface, contact::ModelOptions& options) {
  if (!(surface.corner_width <= surface.tread_width))
    return Fault::range(
        "config.surface.corner_width", {surface.corner_width, "m", 0.0, surface.tread_width},
        "strips are narrower where the rail is curved more: at most config.surface.tread_width");
  options.strip_widths.widest = options.strip_widths.guiding = surface.tread_width;
  options.strip_widths.narrowest = surface.corner_width;
  options.pressure.tolerance = surface.tolerance;
  options.pressure.max_work = surface.max_work;
  options.pressure.max_iterations = surface.max_iterations;
  return {};
}

/// Elastic constants of both bodies together, their coupling K, and the smaller yield limit.
void read_materials(const wrc_config& config, contact::ModelOptions& options) {
  const patch::Material wheel{config.wheel_material.shear_modulus, config.wheel_material.poisson},
      rail{config.rail_material.shear_modulus, config.rail_material.poisson};
  const bool alike = wheel.shear_modulus == rail.shear_modulus && wheel.poisson == rail.poisson;
  options.material = alike ? wheel : patch::combined(wheel, rail);
  options.coupling = alike ? 0.0 : patch::coupling(wheel, rail);
  options.wheel_poisson = wheel.poisson;
  options.rail_poisson = rail.poisson;
  options.shear_yield = std::min(config.wheel_material.shear_yield, config.rail_material.shear_yield);
}

/// The k-th of the caller's sections, whose size is that of the caller's header.
Fault section_at(const wrc_config& config, std::int32_t k, wrc_rail_section& ours) {
  const std::size_t size = config.rail_section_size;
  const auto* const first = reinterpret_cast<const char*>(config.rail_sections);
  return read_element(first + static_cast<std::size_t>(k) * size, size, "config.rail_sections", ours);
}

/// The k-th section, checked before. `given`: the caller's wrc_config.
contact::RailSectionSource read_section(const void* given, std::int32_t k) {
  wrc_rail_section theirs;
  (void)section_at(*static_cast<const wrc_config*>(given), k, theirs);
  contact::RailSectionSource ours;
  ours.section = {.distance = theirs.distance,
                  .y = theirs.y,
                  .z = theirs.z,
                  .face = theirs.surface,
                  .marks = static_cast<std::int32_t>(theirs.mark_count),
                  .mark = theirs.marks,
                  .profile = {}};
  (void)read_profile(theirs.profile, "config.rail_sections.profile", ours.profile);
  return ours;
}

/// `ours`: the section itself.
Fault check_section(const wrc_config& config, std::int32_t k, wrc_rail_section& ours) {
  constexpr const char* name = "config.rail_sections";
  constexpr const char* profile = "config.rail_sections.profile";
  contact::ProfileSource source;
  RETURN_IF_FAILED(section_at(config, k, ours));
  RETURN_IF_FAILED(check_no_points(ours.profile, profile));
  RETURN_IF_FAILED(read_profile(ours.profile, profile, source));
  if (!is_rail(source.kind)) return Fault::profile(profile, "this is a wheel profile");
  if (source.kind == contact::ProfileSource::Kind::rail_uic60_benchmark &&
      config.track.rail_inclination != 0.0)
    return Fault::unsupported("config.track.rail_inclination", {config.track.rail_inclination, ""},
                              "WRC_PROFILE_UIC60_BENCHMARK, of a section, is canted 1:40 already");

  // Beside the section before: surfaces one after the other, distances of each increasing.
  if (k == 0)
    return ours.surface == 0 ? Fault{}
                             : Fault::range({name, "surface"}, {ours.surface, ""}, "surfaces count from 0");
  wrc_rail_section before;
  (void)section_at(config, k - 1, before);
  constexpr double nearest = 1e-3;
  if (ours.surface == before.surface && !(ours.distance >= before.distance + nearest))
    return Fault::range(
        {name, "distance"},
        {ours.distance, "m", before.distance + nearest, MEMBER(wrc_rail_section, "distance").high},
        "sections of a surface must be in order, at least 1 mm apart");
  if (ours.surface == before.surface && ours.mark_count != before.mark_count)
    return Fault::profile(
        {name, "mark_count"}, {ours.mark_count, ""},
        "all sections of a surface need the same number of marks: marks of equal number belong together");
  if (ours.surface != before.surface && ours.surface != before.surface + 1)
    return Fault::range(
        {name, "surface"}, {ours.surface, "", before.surface, before.surface + 1.0},
        "sections must be in order of their surfaces, all sections of a surface side by side");
  return {};
}

/// `theirs`: the caller's struct, which is there while the model is made.
Fault read_sections(const wrc_config* theirs, const wrc_config& config, contact::ModelOptions& options) {
  const auto count = static_cast<std::int32_t>(config.rail_section_count);
  if (count > 0 && config.rail_section_size < Description<wrc_rail_section>::first)
    return Fault::struct_size(
        "config.rail_section_size",
        {config.rail_section_size, "bytes", Description<wrc_rail_section>::first,
         MEMBER(wrc_config, "rail_section_size").high},
        "it is the size of one of config.rail_sections: set it to sizeof(wrc_rail_section)");
  for (std::int32_t k = 0; k < count; ++k) {
    wrc_rail_section ours;
    Fault fault = check_section(config, k, ours);
    fault.index = k;
    fault.distance = ours.distance;
    if (fault.failed()) return fault;
  }
  options.sections = {count, theirs, read_section};
  return {};
}

Fault read_roundness(const wrc_config_roundness& theirs, surface::RadiusTable& table) {
  if (theirs.angle_count == 0) return {};
  const std::uint32_t angles = theirs.angle_count;
  constexpr double turn = 6.283185307179586, tolerance = 1e-6;
  const auto refuse_angle = [&](std::uint32_t i, double low, double high, const char* cause) {
    return Fault::range({"config.roundness.angles", i}, {theirs.angles[i], "rad", low, high}, cause);
  };
  if (!(std::abs(theirs.angles[0]) <= tolerance))
    return refuse_angle(0, 0.0, tolerance, "angles begin with 0");
  if (!(std::abs(theirs.angles[angles - 1] - turn) <= tolerance))
    return refuse_angle(angles - 1, turn - tolerance, turn + tolerance,
                        "the last angle must be 2 pi, where the wheel closes");
  for (std::uint32_t i = 1; i < angles; ++i)
    if (!(theirs.angles[i] >= theirs.angles[i - 1] + 1e-5))
      return refuse_angle(i, theirs.angles[i - 1] + 1e-5, turn, "angles must increase, by 1e-5 rad or more");
  const std::uint32_t rows = theirs.row_count;
  if (rows > 1 && theirs.y == nullptr)
    return Fault::null("config.roundness.y",
                       "more than one row needs the places of the rows across the tread");
  for (std::uint32_t r = 1; r < rows; ++r)
    if (!(theirs.y[r] >= theirs.y[r - 1] + 1e-4))
      return Fault::range({"config.roundness.y", r}, {theirs.y[r], "m", theirs.y[r - 1] + 1e-4, 0.5},
                          "places of rows must increase, by 0.1 mm or more");
  constexpr double most = 0.005;
  const Fault fault =
      check_all(theirs.deviations, static_cast<std::size_t>(rows) * angles, "config.roundness.deviations",
                "m", -most, most, "did you pass mm?", "did you pass mm?");
  if (fault.failed()) return fault;
  for (std::uint32_t r = 0; r < rows; ++r) {
    const double* const row = theirs.deviations + static_cast<std::size_t>(r) * angles;
    if (!(std::abs(row[angles - 1] - row[0]) <= tolerance))
      return Fault::range({"config.roundness.deviations", (r + 1) * angles - 1},
                          {row[angles - 1], "m", row[0] - tolerance, row[0] + tolerance},
                          "the radius does not close: the last value of a row must equal the first");
  }
  table = {static_cast<std::int32_t>(angles), static_cast<std::int32_t>(rows), theirs.angles, theirs.y,
           theirs.deviations};
  return {};
}

/// A check rail and its rail as the two faces of one that is the same everywhere. `given`: wrc_config.
contact::RailSectionSource read_guided_section(const void* given, std::int32_t k) {
  constexpr double everywhere = 1e6;  // [m]
  const auto& config = *static_cast<const wrc_config*>(given);
  contact::RailSectionSource ours;
  ours.section.distance = k % 2 == 0 ? -everywhere : everywhere;
  ours.section.face = k / 2;
  if (k >= 2) {
    (void)read_profile(config.rail, "config.rail", ours.profile);
    return ours;
  }
  ours.section.y = config.check_rail.y;
  ours.section.z = config.check_rail.z;
  (void)read_profile(config.check_rail.profile, "config.check_rail.profile", ours.profile);
  return ours;
}

/// `theirs`: the caller's struct, which is there while the model is made.
Fault read_check_rail(const wrc_config* theirs, const wrc_config& config, contact::ModelOptions& options) {
  constexpr const char* name = "config.check_rail.profile";
  const wrc_profile& profile = config.check_rail.profile;
  if (config.rail_section_count > 0)
    return Fault::unsupported("config.check_rail",
                              "with config.rail_sections give the check rail as one of their surfaces");
  if (config.roller_curvature != 0.0)
    return Fault::unsupported("config.check_rail",
                              "a roller has no check rail: leave config.roller_curvature 0");
  contact::ProfileSource source;
  RETURN_IF_FAILED(read_profile(profile, name, source));
  if (!is_rail(source.kind)) return Fault::profile(name, "this is a wheel profile");
  if (source.kind == contact::ProfileSource::Kind::rail_uic60_benchmark &&
      config.track.rail_inclination != 0.0)
    return Fault::unsupported(
        name, "WRC_PROFILE_UIC60_BENCHMARK is canted already, and check rails are canted as the rail");
  options.check_rail = true;
  options.sections = {4, theirs, read_guided_section};
  return {};
}

/// Rails and wheels that change along the track or round the wheel, which contact on the surface alone reads.
Fault read_varying(const wrc_config* theirs, const wrc_config& config, contact::ModelOptions& options) {
  const bool guided = config.check_rail.profile.kind != WRC_PROFILE_NONE;
  if (!guided && (config.check_rail.y != 0.0 || config.check_rail.z != 0.0))
    return Fault::unsupported("config.check_rail.y", {config.check_rail.y, "m"},
                              "there is no check rail: give config.check_rail.profile, or leave its place 0");
  if (config.rail_section_count == 0 && config.roundness.angle_count == 0 && config.roller_curvature == 0.0 &&
      !guided)
    return {};
  constexpr const char* reader =
      "it is read by wrc_contact_wrench alone, which needs profiles and config.normal.method = "
      "WRC_NORMAL_STRIP_HALFSPACE";
  const bool on_surface = has_profiles(config) && options.normal_method->half_space;
  if (guided) {
    if (!on_surface) return Fault::unsupported("config.check_rail", reader);
    const Fault fault = read_check_rail(theirs, config, options);
    if (fault.failed() || config.roundness.angle_count == 0) return fault;
    return read_roundness(config.roundness, options.radius);
  }
  if (config.roller_curvature != 0.0) {
    if (!on_surface)
      return Fault::unsupported("config.roller_curvature", {config.roller_curvature, "1/m"}, reader);
    if (config.rail_section_count > 0)
      return Fault::unsupported("config.roller_curvature", {config.roller_curvature, "1/m"},
                                "a roller has no sections along the track: leave config.rail_sections 0");
    options.roller_curvature = config.roller_curvature;
  }
  if (!on_surface)
    return config.rail_section_count > 0
               ? Fault::unsupported("config.rail_sections", {config.rail_section_count, ""}, reader)
               : Fault::unsupported("config.roundness.angle_count", {config.roundness.angle_count, ""},
                                    reader);
  return first_of({read_sections(theirs, config, options), read_roundness(config.roundness, options.radius)});
}

/// The header of the force table tells how much memory the model needs.
Fault read_table(const char* file, contact::ModelOptions& options) {
  if (file == nullptr) {
    return Fault::null("config.tangential.force_table",
                       "this tangential method needs the file of the force table");
  }
  options.force_table = file;
  return tangential::read_force_table_axes(file, options.force_table_axes);
}

/// Checksum of all numbers of a configuration but the instruction set, which results do not depend on, and
/// the size of the caller's struct. Arrays behind pointers are left to the model, which has them as they are
/// used.
template <std::size_t... i>
std::uint64_t checksum_of_numbers(const wrc_config& config, std::index_sequence<i...>) {
  Checksum sum;
  const auto* const bytes = reinterpret_cast<const char*>(&config);
  const auto add = [&](auto place) {
    constexpr const Member& member = Description<wrc_config>::members[decltype(place)::value];
    if (member.offset == offsetof(wrc_config, struct_size) ||
        member.offset == offsetof(wrc_config, instruction_set))
      return;
    for (std::int32_t element = 0; element < member.elements; ++element) {
      const auto at = static_cast<std::size_t>(element);
      if constexpr (member.type == Type::real)
        sum.add(detail::load<double>(bytes, member.offset + at * sizeof(double)));
      else if constexpr (member.type == Type::uint64)
        sum.add(detail::load<std::uint64_t>(bytes, member.offset + at * sizeof(std::uint64_t)));
      else if constexpr (member.type != Type::pointer)
        sum.add(
            std::uint64_t{detail::load<std::uint32_t>(bytes, member.offset + at * sizeof(std::uint32_t))});
    }
  };
  (add(std::integral_constant<std::size_t, i>{}), ...);
  return sum.value();
}

}  // namespace

static_assert(MEMBER(wrc_config, "planar.max_patches").high == contact::patch_capacity);

Fault read_options(const wrc_config* theirs, contact::ModelOptions& options) {
  wrc_config config;
  RETURN_IF_FAILED(read(theirs, "config", config));
  RETURN_IF_FAILED(read_methods(config, options));
  options.numbers =
      checksum_of_numbers(config, std::make_index_sequence<std::size(Description<wrc_config>::members)>());

  RETURN_IF_FAILED(check_unread(config, options));
  if (config.planar.start == WRC_START_MARK)
    return Fault::unsupported("config.planar.start", {config.planar.start, ""},
                              "marks are of wrc_contact_wrench alone: WRC_START_COLD or WRC_START_WARM");
  RETURN_IF_FAILED(check_no_points(config.wheel, "config.wheel"));
  RETURN_IF_FAILED(check_no_points(config.rail, "config.rail"));
  RETURN_IF_FAILED(check_no_points(config.check_rail.profile, "config.check_rail.profile"));

  // Members that need no more than a copy.
  options.sizes = {
      .strips = config.planar.strips, .cells = config.planar.cells, .gap_rows = config.planar.gap_rows};
  options.surface_cells = config.surface.cells;
  RETURN_IF_FAILED(read_resolution(config.surface, options));
  options.max_patches = config.planar.max_patches;
  options.gap_limit = config.planar.gap_limit;
  options.max_iterations = config.normal.max_iterations;
  options.max_sweeps = config.planar.max_sweeps;
  options.warm_start = config.planar.start != 0;
  options.load_tolerance = config.normal.load_tolerance;
  read_materials(config, options);
  options.effusivities = {effusivity_of(config.wheel_heat), effusivity_of(config.rail_heat)};
  options.wheelset.nominal_radius = config.wheelset.wheel_radius;
  options.wheelset.tape_circle_distance = config.wheelset.tape_circle_distance;
  options.track = {.gauge = config.track.gauge,
                   .gauge_depth = config.track.gauge_depth,
                   .rail_inclination = config.track.rail_inclination,
                   .by_origin = config.track.placement == WRC_PLACEMENT_ORIGIN,
                   .rail_origin = config.track.rail_origin};

  if (options.tangential_method->reads.has(contact::Option::force_table))
    RETURN_IF_FAILED(read_table(config.tangential.force_table, options));
  RETURN_IF_FAILED(read_varying(theirs, config, options));
  if (!has_profiles(config)) return {};  // the host hands over gaps
  RETURN_IF_FAILED(read_profile(config.wheel, "config.wheel", options.wheel));
  RETURN_IF_FAILED(read_profile(config.rail, "config.rail", options.rail));
  if (!is_wheel(options.wheel.kind)) {
    return Fault::profile("config.wheel", "this is a rail profile");
  }
  if (!is_rail(options.rail.kind)) {
    return Fault::profile("config.rail", "this is a wheel profile");
  }
  if (options.rail.kind == contact::ProfileSource::Kind::rail_uic60_benchmark &&
      config.track.rail_inclination != 0.0) {
    return Fault::unsupported(
        "config.track.rail_inclination", {config.track.rail_inclination, ""},
        "WRC_PROFILE_UIC60_BENCHMARK is canted 1:40 already: leave it 0, or take WRC_PROFILE_60E1");
  }
  return {};
}

}  // namespace wrc::abi
