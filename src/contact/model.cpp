#include "contact/model.hpp"

#include <algorithm>
#include <new>

#include "base/checksum.hpp"
#include "contact/methods.hpp"
#include "contact/state.hpp"
#include "geometry/profile_points.hpp"
#include "geometry/smoothing.hpp"
#include "geometry/standard_profiles.hpp"
#include "tangential/force_table/force_table_file.hpp"
#include "tangential/methods/strip_memory.hpp"

namespace wrc {
namespace {

/// Nodes the profile of this source needs.
std::int32_t node_count(const ProfileSource& source) {
  switch (source.kind) {
    case ProfileSource::Kind::s1002:
      return s1002_nodes;
    case ProfileSource::Kind::rail_60e1:
      return rail_head_nodes;
    case ProfileSource::Kind::rail_uic60_benchmark:
      return uic60_benchmark_nodes;
    case ProfileSource::Kind::points:
      return source.count;
    case ProfileSource::Kind::none:
      break;
  }
  return 0;
}

/// Doubles of scratch to load this source.
std::size_t scratch_size(const ProfileSource& source) {
  return static_cast<std::size_t>(source.smoothing > 0.0 ? smoothing_scratch + 1 : 1) *
         static_cast<std::size_t>(node_count(source));
}

std::size_t doubles(const ProfileSource& source) { return profile_doubles(node_count(source)); }

/// Doubles of the arc lengths of both bodies.
std::size_t arcs(const ModelOptions& options) {
  return static_cast<std::size_t>(node_count(options.wheel)) +
         static_cast<std::size_t>(node_count(options.rail));
}

/// Cuts the nodes of one profile from the arrays behind the model.
ProfileMemory cut(double*& arrays, std::int32_t nodes) {
  const ProfileMemory memory = profile_memory(nodes, arrays);
  arrays += profile_doubles(nodes);
  return memory;
}

/// Points of the caller, smoothed if wanted.
Fault load_points(const ProfileSource& source, ProfileBody body, double* scratch, const ProfileMemory& memory,
                  Profile& profile, double& deviation) {
  if (!(source.smoothing > 0.0))
    return spline_through(body, source.count, source.y, source.z, scratch, memory, profile);
  RETURN_IF_FAILED(check_points(body, source.count, source.y, source.z, profile_noise_most));
  const SmoothedPoints smooth =
      smooth_points(source.count, source.y, source.z, source.smoothing, scratch + source.count);
  for (std::int32_t i = 1; i < source.count; ++i) {
    if (!(smooth.y[i] > smooth.y[i - 1]))
      return Fault::profile({"profile.smoothing", i}, {source.smoothing, "m"},
                            "so long a smoothing folds the steep part of the profile at this point");
  }
  deviation = smooth.deviation;
  return spline_through(body, source.count, smooth.y, smooth.z, scratch, memory, profile);
}

/// The profile in its own coordinates. `scratch`: scratch_size(source) doubles.
Fault load_profile(const ProfileSource& source, ProfileBody body, double* scratch,
                   const ProfileMemory& memory, Profile& profile, double& deviation) {
  switch (source.kind) {
    case ProfileSource::Kind::s1002:
      return sample_s1002(memory, profile);
    case ProfileSource::Kind::rail_60e1:
      return sample_rail_head(rail_60e1, memory, profile);
    case ProfileSource::Kind::rail_uic60_benchmark:
      return sample_uic60_benchmark(memory, profile);
    case ProfileSource::Kind::points:
      return load_points(source, body, scratch, memory, profile, deviation);
    case ProfileSource::Kind::none:
      break;
  }
  return Fault::internal();
}

/// The influence tables of the strip half-space solver, for the models that use it.
std::size_t influence_bytes(const ModelOptions& options) {
  return options.normal_method->half_space ? sizeof(InfluenceTables) : 0;
}

/// The table of forces, for the models that use one; a multiple of what doubles are aligned to.
std::size_t table_bytes(const ModelOptions& options) {
  return sizeof(float) * force_table_size(options.force_table_axes);
}

/// With profiles there is contact on the rail's surface.
bool has_surface(const ModelOptions& options) { return options.wheel.kind != ProfileSource::Kind::none; }

RailSectionSource section(const ModelOptions& options, std::int32_t k) {
  return options.sections.read(options.sections.given, k);
}

/// Memory for the sections' profiles, with what is needed to load them; a multiple of what doubles are
/// aligned to.
std::size_t section_bytes(const ModelOptions& options) {
  std::size_t profiles = 0, scratch = 0;
  for (std::int32_t k = 0; k < options.sections.count; ++k) {
    const ProfileSource source = section(options, k).profile;
    profiles += doubles(source);
    scratch = std::max(scratch, scratch_size(source));
  }
  return static_cast<std::size_t>(options.sections.count) * sizeof(RailSection) +
         sizeof(double) * (profiles + scratch);
}

std::size_t surface_bytes(const ModelOptions& options) {
  if (!has_surface(options)) return 0;
  std::int32_t longest = 0;
  for (std::int32_t k = 0; k < options.sections.count; ++k)
    longest = std::max(longest, node_count(section(options, k).profile));
  return surface_model_bytes(node_count(options.wheel), node_count(options.rail), options.sections.count,
                             longest, options.radius);
}

/// Sizes of what contacts carry for the methods and the surface.
void take_sizes(const ModelOptions& options, ArraySizes& sizes) {
  if (const auto workspace = options.normal_method->workspace)
    sizes.normal_workspace_bytes = workspace(options.sizes.strips);
  if (const auto workspace = options.tangential_method->workspace)
    sizes.tangential_workspace_bytes = workspace(options.sizes.strips, options.sizes.cells);
  if (options.non_steady)
    sizes.rolling_memory_bytes = static_cast<std::int64_t>(strip_memory_bytes(options.sizes.strips));
  if (!has_surface(options)) return;
  sizes.surface_state_bytes = surface_state_bytes();
  sizes.surface_workspace_bytes = surface_workspace_bytes(
      node_count(options.wheel), surface_methods(options), options.surface_cells,
      options.sections.count > 0 || options.radius.rows > 0 || options.roller_curvature != 0.0);
}

/// Reads the force table into `memory`, for the model's Poisson ratio.
Fault take_force_table(const ModelOptions& options, void* memory, ForceTable& table) {
  auto* coefficients = static_cast<float*>(memory);
  RETURN_IF_FAILED(read_force_table(options.force_table, options.force_table_axes, coefficients));
  table.axes = options.force_table_axes;
  table.coefficients = coefficients;
  adapt_to_poisson(options.material.poisson, table);
  return {};
}

/// Reads a profile and places it on both sides by `place` (profile, side, memory). Takes its memory from
/// `arrays`; what lies behind is scratch.
template <class Place>
Fault take_body(const ProfileSource& source, ProfileBody body, double*& arrays, Profile& given,
                double& deviation, Place&& place) {
  ProfileMemory placed[2];
  for (ProfileMemory& each : placed) each = cut(arrays, node_count(source));
  const ProfileMemory own = cut(arrays, node_count(source));
  Fault fault = load_profile(source, body, arrays, own, given, deviation);
  for (const Side side : {Side::right, Side::left}) {
    if (!fault.failed()) fault = place(given, side, placed[static_cast<int>(side)]);
  }
  // Under the name the caller knows the profile by.
  if (fault.failed() && fault.field == nullptr)
    fault.field = body == ProfileBody::wheel ? "config.wheel" : "config.rail";
  return fault;
}

/// The sections with their profiles, into memory of section_bytes().
Fault take_sections(const ModelOptions& options, void* memory, RailSection*& sections) {
  const std::int32_t count = options.sections.count;
  sections = static_cast<RailSection*>(memory);
  auto* arrays = reinterpret_cast<double*>(sections + count);
  double* scratch = arrays;
  for (std::int32_t k = 0; k < count; ++k) scratch += doubles(section(options, k).profile);
  for (std::int32_t k = 0; k < count; ++k) {
    const RailSectionSource source = section(options, k);
    RailSection& taken = *new (sections + k) RailSection(source.section);
    double deviation = 0.0;
    Fault fault = load_profile(source.profile, ProfileBody::rail, scratch,
                               cut(arrays, node_count(source.profile)), taken.profile, deviation);
    if (!fault.failed()) continue;
    if (fault.field == nullptr) fault.field = "config.rail_section.profile";
    fault.index = k;
    return fault;
  }
  return {};
}

/// Has a wheel the back of its flange, which a check rail touches? Its outline rises behind the tip.
Fault check_flange_back(const Profile& wheel) {
  constexpr double least_rise = 2e-3;  // [m]
  std::int32_t tip = 0;
  for (std::int32_t i = 1; i < wheel.count && wheel.y[i] < 0.0; ++i)
    if (wheel.z[i] > wheel.z[tip]) tip = i;
  const double rise = wheel.z[tip] - wheel.z[0];
  if (rise >= least_rise) return {};
  return Fault::profile("config.wheel: rise behind the flange's tip", {rise, "m", least_rise, 1.0},
                        "a check rail touches the flange's back, which this profile does not have");
}

/// Both bodies on both sides, and the surface if the model has one, from `arrays` on.
Fault take_bodies(const ModelOptions& options, double* arrays, void* surface, void* section_memory,
                  Model& model) {
  Profile wheel, rail;
  Fault fault = take_body(options.wheel, ProfileBody::wheel, arrays, wheel, model.wheel_deviation,
                          [&](const Profile& profile, Side side, const ProfileMemory& memory) {
                            Wheel& placed = model.bodies[static_cast<int>(side)].wheel;
                            return place_wheel(profile, options.wheelset, side, memory, placed);
                          });
  if (fault.failed()) return fault;
  fault = take_body(options.rail, ProfileBody::rail, arrays, rail, model.rail_deviation,
                    [&](const Profile& profile, Side side, const ProfileMemory& memory) {
                      Rail& placed = model.bodies[static_cast<int>(side)].rail;
                      return place_rail(profile, options.track, side, memory, placed);
                    });
  if (fault.failed()) return fault;
  if (!has_surface(options)) return {};
  if (options.check_rail) fault = check_flange_back(wheel);
  if (fault.failed()) return fault;
  RailSection* sections = nullptr;
  fault = take_sections(options, section_memory, sections);
  if (fault.failed()) return fault;
  SurfaceMethods methods = surface_methods(options);
  methods.region.linear_theory = &model.linear_theory;
  methods.region.force_table = &model.force_table;
  fault = make_surface_model({.wheel = wheel,
                              .rail = rail,
                              .rail_inclination = options.track.rail_inclination,
                              .rail_origin_y = model.bodies[0].rail.origin_y,
                              .rail_origin_z = model.bodies[0].rail.origin_z,
                              .nominal_radius = options.wheelset.nominal_radius,
                              .sections = options.sections.count,
                              .section = sections,
                              .radius = options.radius,
                              .roller_curvature = options.roller_curvature,
                              .material = options.material,
                              .effusivities = options.effusivities,
                              .influence = model.influence,
                              .kernels = model.kernels,
                              .ellipse = &model.linear_theory.ellipse(),
                              .grid = &model.surface_grid,
                              .methods = methods},
                             surface, model.surface);
  // planar stages do without what has no surface
  return options.normal_method->half_space ? fault : Fault{};
}

/// Of the numbers of the configuration, of the profiles as they were placed and of the force table: what the
/// results of a contact depend on, whatever process or instruction set it is in.
std::uint64_t fingerprint(const Model& model) {
  Checksum sum;
  sum.add(model.options.numbers);
  if (model.has_geometry) {
    const Bodies& right = model.bodies[0];
    for (const Profile* profile : {&right.wheel.profile, &right.rail.profile}) {
      sum.add(static_cast<std::uint64_t>(profile->count));
      for (std::int32_t i = 0; i < profile->count; ++i) {
        sum.add(profile->y[i]);
        sum.add(profile->z[i]);
      }
    }
  }
  if (model.surface) {
    const VaryingRail& rail = model.surface->varying;
    for (std::int32_t f = 0; f < rail.faces; ++f) {
      const RailFace& face = rail.face[f];
      const std::size_t bytes = static_cast<std::size_t>(face.strips) * sizeof(double);
      for (std::int32_t k = face.first_section; k < face.first_section + face.sections; ++k) {
        sum.add(rail.distance[k]);
        for (std::int32_t list = 0; list < 8; ++list)
          sum.add(rail.outline + (static_cast<std::int64_t>(k) * 8 + list) * rail.room + face.first, bytes);
      }
    }
    const OutOfRound& wheel = model.surface->out_of_round;
    for (std::int32_t row = 0; row < wheel.rows; ++row) sum.add(wheel.y[row]);
    sum.add(wheel.value, static_cast<std::size_t>(wheel.rows) * OutOfRound::nodes * sizeof(double));
  }
  if (const std::size_t floats = force_table_size(model.force_table.axes); model.force_table.coefficients)
    sum.add(model.force_table.coefficients, floats * sizeof(float));
  return sum.value();
}

}  // namespace

std::size_t model_bytes(const ModelOptions& options) {
  // Besides the placed profiles, room for those given and for scratch while they are read.
  const std::size_t profiles = doubles(options.wheel) + doubles(options.rail);
  const std::size_t scratch = std::max(scratch_size(options.wheel), scratch_size(options.rail));
  return sizeof(Model) + influence_bytes(options) + surface_bytes(options) + section_bytes(options) +
         table_bytes(options) +
         sizeof(double) * (march_grid_size(options.sizes.cells) + march_grid_size(options.surface_cells) +
                           3 * profiles + scratch + arcs(options));
}

Fault make_model(const ModelOptions& options, void* memory, Model*& made) {
  auto* model = new (memory) Model;
  model->options = options;
  model->options.wheel = {};
  model->options.rail = {};
  model->options.sections = {};
  model->options.radius = {};
  model->options.force_table = nullptr;
  take_sizes(options, model->options.sizes);
  model->layout = lay_out(model->options.sizes, sizeof(Contact));
  model->linear_theory = SdecTable(options.material.poisson);
  model->kernels = &kernels_for(options.instruction_set);

  auto* behind = reinterpret_cast<char*>(model + 1);
  if (influence_bytes(options) > 0) {
    auto* influence = new (behind) InfluenceTables;
    tabulate(*influence);
    model->influence = influence;
  }
  behind += influence_bytes(options);
  void* const surface = behind;
  behind += surface_bytes(options);
  void* const sections = behind;
  behind += section_bytes(options);
  if (table_bytes(options) > 0) {
    RETURN_IF_FAILED(take_force_table(options, behind, model->force_table));
  }
  auto* arrays = reinterpret_cast<double*>(behind + table_bytes(options));
  model->march_grid = make_march_grid(options.sizes.cells, arrays, *model->kernels);
  arrays += march_grid_size(options.sizes.cells);
  model->surface_grid = make_march_grid(options.surface_cells, arrays, *model->kernels);
  arrays += march_grid_size(options.surface_cells);

  model->has_geometry = options.wheel.kind != ProfileSource::Kind::none;
  if (model->has_geometry) {
    double* const arc = arrays;
    arrays += arcs(options);
    RETURN_IF_FAILED(take_bodies(options, arrays, surface, sections, *model));
    const Bodies& right = model->bodies[static_cast<int>(Side::right)];
    model->arc[0] = measure(right.wheel.profile, right.wheel.origin_y, arc);
    model->arc[1] = measure(right.rail.profile, right.rail.origin_y, arc + node_count(options.wheel));
  }
  model->configuration = fingerprint(*model);
  made = model;
  return {};
}

}  // namespace wrc
