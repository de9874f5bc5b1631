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

namespace wrc::contact {
namespace {

/// Nodes the profile of this source needs.
std::int32_t node_count(const ProfileSource& source) {
  switch (source.kind) {
    case ProfileSource::Kind::s1002:
      return geometry::s1002_nodes;
    case ProfileSource::Kind::rail_60e1:
      return geometry::rail_head_nodes;
    case ProfileSource::Kind::rail_uic60_benchmark:
      return geometry::uic60_benchmark_nodes;
    case ProfileSource::Kind::points:
      return source.count;
    case ProfileSource::Kind::none:
      break;
  }
  return 0;
}

/// Doubles of scratch to load this source.
std::size_t scratch_size(const ProfileSource& source) {
  return static_cast<std::size_t>(source.smoothing > 0.0 ? geometry::smoothing_scratch + 1 : 1) *
         static_cast<std::size_t>(node_count(source));
}

std::size_t doubles(const ProfileSource& source) { return geometry::profile_doubles(node_count(source)); }

/// Doubles of the arc lengths of both bodies.
std::size_t arcs(const ModelOptions& options) {
  return static_cast<std::size_t>(node_count(options.wheel)) +
         static_cast<std::size_t>(node_count(options.rail));
}

/// Cuts the nodes of one profile from the arrays behind the model.
geometry::ProfileMemory cut(double*& arrays, std::int32_t nodes) {
  const geometry::ProfileMemory memory = geometry::profile_memory(nodes, arrays);
  arrays += geometry::profile_doubles(nodes);
  return memory;
}

/// Points of the caller, smoothed if wanted.
Fault load_points(const ProfileSource& source, geometry::ProfileBody body, double* scratch,
                  const geometry::ProfileMemory& memory, geometry::Profile& profile, double& deviation) {
  // Points without smoothing must increase strictly; noise of a measurement is allowed where it is smoothed
  // away.
  if (!(source.smoothing > 0.0))
    return geometry::spline_through(body, source.count, source.y, source.z, scratch, memory, profile);
  RETURN_IF_FAILED(
      geometry::check_points(body, source.count, source.y, source.z, geometry::profile_noise_most));
  const geometry::SmoothedPoints smooth =
      geometry::smooth_points(source.count, source.y, source.z, source.smoothing, scratch + source.count);
  // Smoothing moves points in both directions: the curve must still be a height over y.
  for (std::int32_t i = 1; i < source.count; ++i) {
    if (!(smooth.y[i] > smooth.y[i - 1]))
      return Fault::profile({"profile.smoothing", i}, {source.smoothing, "m"},
                            "so long a smoothing folds the steep part of the profile at this point");
  }
  deviation = smooth.deviation;
  return geometry::spline_through(body, source.count, smooth.y, smooth.z, scratch, memory, profile);
}

/// The profile in its own coordinates. `scratch`: scratch_size(source) doubles.
Fault load_profile(const ProfileSource& source, geometry::ProfileBody body, double* scratch,
                   const geometry::ProfileMemory& memory, geometry::Profile& profile, double& deviation) {
  switch (source.kind) {
    case ProfileSource::Kind::s1002:
      return geometry::sample_s1002(memory, profile);
    case ProfileSource::Kind::rail_60e1:
      return geometry::sample_rail_head(geometry::rail_60e1, memory, profile);
    case ProfileSource::Kind::rail_uic60_benchmark:
      return geometry::sample_uic60_benchmark(memory, profile);
    case ProfileSource::Kind::points:
      return load_points(source, body, scratch, memory, profile, deviation);
    case ProfileSource::Kind::none:
      break;
  }
  return Fault::internal();
}

/// Bytes of the influence tables, of models with the strip half-space solver.
std::size_t influence_bytes(const ModelOptions& options) {
  return options.normal_method->half_space ? sizeof(normal::InfluenceTables) : 0;
}

/// Bytes of the force table, of models that use one; a multiple of the alignment of double.
std::size_t table_bytes(const ModelOptions& options) {
  return sizeof(float) * tangential::force_table_size(options.force_table_axes);
}

/// With profiles there is contact on the rail's surface.
bool has_surface(const ModelOptions& options) { return options.wheel.kind != ProfileSource::Kind::none; }

RailSectionSource section(const ModelOptions& options, std::int32_t k) {
  return options.sections.read(options.sections.given, k);
}

/// Bytes of the sections, their profiles and the scratch to load them; a multiple of the alignment of double.
std::size_t section_bytes(const ModelOptions& options) {
  // Profiles of all sections are kept, scratch is that of the longest.
  std::size_t profiles = 0, scratch = 0;
  for (std::int32_t k = 0; k < options.sections.count; ++k) {
    const ProfileSource source = section(options, k).profile;
    profiles += doubles(source);
    scratch = std::max(scratch, scratch_size(source));
  }
  return static_cast<std::size_t>(options.sections.count) * sizeof(surface::RailSection) +
         sizeof(double) * (profiles + scratch);
}

/// Faces of the rail: the last section is of the last.
std::int32_t face_count(const ModelOptions& options) {
  const std::int32_t sections = options.sections.count;
  return sections > 0 ? section(options, sections - 1).section.face + 1 : 1;
}

std::size_t surface_bytes(const ModelOptions& options) {
  if (!has_surface(options)) return 0;
  // Scratch of the surface model is that of the longest section.
  std::int32_t longest = 0;
  for (std::int32_t k = 0; k < options.sections.count; ++k)
    longest = std::max(longest, node_count(section(options, k).profile));
  return surface::surface_model_bytes(node_count(options.wheel), node_count(options.rail),
                                      options.sections.count, longest, face_count(options), options.radius);
}

/// Bytes that contacts carry for the methods and the surface.
void take_sizes(const ModelOptions& options, const surface::SurfaceModel* surface, ArraySizes& sizes) {
  // one after the other in the same memory
  if (const auto workspace = options.normal_method->workspace)
    sizes.stage_workspace_bytes = workspace(options.sizes.strips);
  if (const auto workspace = options.tangential_method->workspace)
    sizes.stage_workspace_bytes = std::max<std::int64_t>(
        sizes.stage_workspace_bytes, workspace(options.sizes.strips, options.sizes.cells));
  sizes.remembered_cells = options.non_steady;
  if (options.non_steady)
    sizes.rolling_memory_bytes =
        static_cast<std::int64_t>(tangential::strip_memory_bytes(options.sizes.strips));
  // two numbers per cell and one per strip that follow from the cells (RolledRegion)
  const std::int64_t numbers = std::int64_t{options.sizes.strips} * (2 * options.sizes.cells + 1);
  sizes.stage_workspace_bytes =
      std::max<std::int64_t>(sizes.stage_workspace_bytes, numbers * std::int64_t{sizeof(double)});
  // on the surface: state is saved with the contact, work space lies behind it
  if (surface == nullptr) return;
  Arena state;
  surface::cut_surface_state(state, surface->most_overlapping, remembered_strips(options));
  sizes.surface_state_bytes = state.bytes();
  sizes.surface_workspace_bytes = surface::surface_workspace_bytes(*surface);
}

/// Reads the force table into `memory`, for the model's Poisson ratio.
Fault take_force_table(const ModelOptions& options, void* memory, tangential::ForceTable& table) {
  // Coefficients in the file are for one Poisson ratio; the table is adapted to the model's.
  auto* coefficients = static_cast<float*>(memory);
  RETURN_IF_FAILED(tangential::read_force_table(options.force_table, options.force_table_axes, coefficients));
  table.axes = options.force_table_axes;
  table.coefficients = coefficients;
  tangential::adapt_to_poisson(options.material.poisson, table);
  return {};
}

/// Reads a profile and places it on both sides by `place` (profile, side, memory). Takes its memory from
/// `arrays`; memory behind it is scratch.
template <class Place>
Fault take_body(const ProfileSource& source, geometry::ProfileBody body, double*& arrays,
                geometry::Profile& given, double& deviation, Place&& place) {
  // Nodes as placed on the right and on the left, then as given.
  geometry::ProfileMemory placed[2];
  for (geometry::ProfileMemory& each : placed) each = cut(arrays, node_count(source));
  const geometry::ProfileMemory own = cut(arrays, node_count(source));
  Fault fault = load_profile(source, body, arrays, own, given, deviation);
  for (const geometry::Side side : {geometry::Side::right, geometry::Side::left}) {
    if (!fault.failed()) fault = place(given, side, placed[static_cast<int>(side)]);
  }
  // The fault goes under the caller's name of the profile.
  if (fault.failed() && fault.field == nullptr)
    fault.field = body == geometry::ProfileBody::wheel ? "config.wheel" : "config.rail";
  return fault;
}

/// The sections with their profiles, into memory of section_bytes().
Fault take_sections(const ModelOptions& options, void* memory, surface::RailSection*& sections) {
  // Sections are read from the caller's array once more: nothing of it is kept.
  const std::int32_t count = options.sections.count;
  sections = static_cast<surface::RailSection*>(memory);
  // Behind the sections the nodes of all profiles, behind these the scratch.
  auto* arrays = reinterpret_cast<double*>(sections + count);
  double* scratch = arrays;
  for (std::int32_t k = 0; k < count; ++k) scratch += doubles(section(options, k).profile);
  for (std::int32_t k = 0; k < count; ++k) {
    const RailSectionSource source = section(options, k);
    surface::RailSection& taken = *new (sections + k) surface::RailSection(source.section);
    double deviation = 0.0;
    Fault fault = load_profile(source.profile, geometry::ProfileBody::rail, scratch,
                               cut(arrays, node_count(source.profile)), taken.profile, deviation);
    if (!fault.failed()) continue;
    if (fault.field == nullptr) fault.field = "config.rail_section.profile";
    fault.index = k;
    if (!options.check_rail) fault.distance = source.section.distance;
    return fault;
  }
  return {};
}

/// Has a wheel the back of its flange, which a check rail touches? Its outline rises behind the tip.
Fault check_flange_back(const geometry::Profile& wheel) {
  constexpr double least_rise = 2e-3;  // [m]
  // Tip: lowest point of the flange, which lies at y < 0 (largest z); its back ends at the first node.
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
  // Profiles placed in track axes, right and left, for the planar stages.
  geometry::Profile wheel, rail;
  Fault fault = take_body(
      options.wheel, geometry::ProfileBody::wheel, arrays, wheel, model.wheel_deviation,
      [&](const geometry::Profile& profile, geometry::Side side, const geometry::ProfileMemory& memory) {
        geometry::Wheel& placed = model.bodies[static_cast<int>(side)].wheel;
        return geometry::place_wheel(profile, options.wheelset, side, memory, placed);
      });
  if (fault.failed()) return fault;
  fault = take_body(
      options.rail, geometry::ProfileBody::rail, arrays, rail, model.rail_deviation,
      [&](const geometry::Profile& profile, geometry::Side side, const geometry::ProfileMemory& memory) {
        geometry::Rail& placed = model.bodies[static_cast<int>(side)].rail;
        return geometry::place_rail(profile, options.track, side, memory, placed);
      });
  if (fault.failed()) return fault;

  // Right-hand outlines by arc length and everything that the surface solver tabulates.
  if (!has_surface(options)) return {};
  if (options.check_rail) fault = check_flange_back(wheel);
  if (fault.failed()) return fault;
  surface::RailSection* sections = nullptr;
  fault = take_sections(options, section_memory, sections);
  if (fault.failed()) return fault;
  surface::SurfaceMethods methods = surface_methods(options);
  methods.linear_theory = &model.linear_theory;
  methods.region.linear_theory = &model.linear_theory;
  methods.region.force_table = &model.force_table;
  fault = surface::make_surface_model({.wheel = wheel,
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
                                       .coupling = options.coupling,
                                       .effusivities = options.effusivities,
                                       .influence = model.influence,
                                       .kernels = model.kernels,
                                       .ellipse = &model.linear_theory.ellipse(),
                                       .grid = &model.surface_grid,
                                       .methods = methods,
                                       .widths = options.strip_widths,
                                       .pressure = options.pressure},
                                      surface, model.surface);
  // Planar methods need no surface: that a profile cannot be cut into strips is found when a wheel is solved.
  return options.normal_method->half_space ? fault : Fault{};
}

/// Checksum of all that results depend on, in any process and instruction set: numbers of the configuration,
/// profiles as placed, outlines of the sections, radius of the wheel round its axle, force table.
std::uint64_t fingerprint(const Model& model) {
  // The right-hand bodies stand for both sides, which are mirror images.
  Checksum sum;
  sum.add(model.options.numbers);
  if (model.has_geometry) {
    const Bodies& right = model.bodies[0];
    for (const geometry::Profile* profile : {&right.wheel.profile, &right.rail.profile}) {
      sum.add(static_cast<std::uint64_t>(profile->count));
      for (std::int32_t i = 0; i < profile->count; ++i) {
        sum.add(profile->y[i]);
        sum.add(profile->z[i]);
      }
    }
  }
  // Eight lists of outline per section, and the wheel's radius row by row.
  if (model.surface) {
    const surface::VaryingRail& rail = model.surface->varying;
    for (std::int32_t f = 0; f < rail.faces; ++f) {
      const surface::RailFace& face = rail.face[f];
      const std::size_t bytes = static_cast<std::size_t>(face.strips) * sizeof(double);
      for (std::int32_t k = face.first_section; k < face.first_section + face.sections; ++k) {
        sum.add(rail.distance[k]);
        for (std::int32_t list = 0; list < 8; ++list)
          sum.add(rail.outline + (static_cast<std::int64_t>(k) * 8 + list) * rail.stride + face.first, bytes);
      }
    }
    const surface::OutOfRound& wheel = model.surface->out_of_round;
    for (std::int32_t row = 0; row < wheel.rows; ++row) sum.add(wheel.y[row]);
    sum.add(wheel.value, static_cast<std::size_t>(wheel.rows) * surface::OutOfRound::nodes * sizeof(double));
  }
  if (const std::size_t floats = tangential::force_table_size(model.force_table.axes);
      model.force_table.coefficients)
    sum.add(model.force_table.coefficients, floats * sizeof(float));
  return sum.value();
}

}  // namespace

std::int32_t remembered_strips(const ModelOptions& options) {
  return options.surface_memory ? surface::overlapping_strips(options.strip_widths) : 0;
}

std::size_t model_bytes(const ModelOptions& options) {
  // Three copies of each profile: right, left, and as given; scratch while they are read.
  const std::size_t profiles = doubles(options.wheel) + doubles(options.rail);
  const std::size_t scratch = std::max(scratch_size(options.wheel), scratch_size(options.rail));
  return sizeof(Model) + influence_bytes(options) + surface_bytes(options) + section_bytes(options) +
         table_bytes(options) +
         sizeof(double) *
             (tangential::march_grid_size(options.sizes.cells) +
              tangential::march_grid_size(options.surface_cells) + 3 * profiles + scratch + arcs(options));
}

Fault make_model(const ModelOptions& options, void* memory, Model*& made) {
  // Options without the caller's pointers.
  auto* model = new (memory) Model;
  model->options = options;
  model->options.wheel = {};
  model->options.rail = {};
  model->options.sections = {};
  model->options.radius = {};
  model->options.force_table = nullptr;

  // Tables by the materials.
  model->linear_theory = theory::SdecTable(options.material.poisson);
  model->kernels = &kernels_for(options.instruction_set);

  // Blocks behind the model, in the order of model_bytes().
  auto* behind = reinterpret_cast<char*>(model + 1);
  if (influence_bytes(options) > 0) {
    auto* influence = new (behind) normal::InfluenceTables;
    normal::tabulate(*influence);
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

  // Grids of cells along a strip, of both kinds of contact.
  auto* arrays = reinterpret_cast<double*>(behind + table_bytes(options));
  model->march_grid = tangential::make_march_grid(options.sizes.cells, arrays, *model->kernels);
  arrays += tangential::march_grid_size(options.sizes.cells);
  model->surface_grid = tangential::make_march_grid(options.surface_cells, arrays, *model->kernels);
  arrays += tangential::march_grid_size(options.surface_cells);

  // Bodies, and the arc lengths of the right-hand ones, by which damage is binned.
  model->has_geometry = options.wheel.kind != ProfileSource::Kind::none;
  if (model->has_geometry) {
    double* const arc = arrays;
    arrays += arcs(options);
    RETURN_IF_FAILED(take_bodies(options, arrays, surface, sections, *model));
    const Bodies& right = model->bodies[static_cast<int>(geometry::Side::right)];
    model->arc[0] = geometry::measure(right.wheel.profile, right.wheel.origin_y, arc);
    model->arc[1] =
        geometry::measure(right.rail.profile, right.rail.origin_y, arc + node_count(options.wheel));
  }

  // Layout of the contacts.
  take_sizes(options, model->surface, model->options.sizes);
  model->layout = lay_out(model->options.sizes, sizeof(Contact));
  model->configuration = fingerprint(*model);
  made = model;
  return {};
}

}  // namespace wrc::contact
