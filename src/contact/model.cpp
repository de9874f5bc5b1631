#include "contact/model.hpp"

#include <memory>
#include <new>

#include "contact/contact.hpp"
#include "geometry/profile_points.hpp"
#include "geometry/standard_profiles.hpp"

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

std::size_t doubles(const ProfileSource& source) { return 3 * static_cast<std::size_t>(node_count(source)); }

/// Cuts the nodes of one profile from the arrays behind the model.
ProfileMemory cut(double*& arrays, std::int32_t nodes) {
  const auto n = static_cast<std::size_t>(nodes);
  const ProfileMemory memory{nodes, arrays, arrays + n, arrays + 2 * n};
  arrays += 3 * n;
  return memory;
}

/// The profile in its own coordinates.
Fault load_profile(const ProfileSource& source, ProfileRole role, const ProfileMemory& memory,
                   Profile& profile) {
  switch (source.kind) {
    case ProfileSource::Kind::s1002:
      return sample_s1002(memory, profile);
    case ProfileSource::Kind::rail_60e1:
      return sample_rail_head(rail_60e1, memory, profile);
    case ProfileSource::Kind::rail_uic60_benchmark:
      return sample_uic60_benchmark(memory, profile);
    case ProfileSource::Kind::points:
      return profile_from_points(source.count, source.y, source.z, role, memory, profile);
    case ProfileSource::Kind::none:
      break;
  }
  return {.status = WRC_ERROR_INTERNAL};
}

bool has_profiles(const ModelOptions& options) { return options.wheel.kind != ProfileSource::Kind::none; }

}  // namespace

std::size_t model_bytes(const ModelOptions& options) {
  // The profiles as given are needed while they are placed: the larger of the two as scratch.
  const std::size_t wheel = doubles(options.wheel), rail = doubles(options.rail);
  return sizeof(Model) + sizeof(double) * (wheel + rail + (wheel > rail ? wheel : rail));
}

Fault make_model(const ModelOptions& options, void* memory, Model*& made) {
  auto* model = new (memory) Model;
  model->options = options;
  model->options.wheel = {};
  model->options.rail = {};
  model->layout = lay_out(options.sizes, sizeof(Contact));

  model->has_geometry = has_profiles(options);
  if (model->has_geometry) {
    auto* arrays = reinterpret_cast<double*>(model + 1);
    const ProfileMemory wheel_memory = cut(arrays, node_count(options.wheel));
    const ProfileMemory rail_memory = cut(arrays, node_count(options.rail));
    Profile given;
    double* scratch = arrays;
    Fault fault =
        load_profile(options.wheel, ProfileRole::wheel, cut(scratch, node_count(options.wheel)), given);
    if (!fault.failed())
      fault = place_wheel(given, options.wheelset, options.side, wheel_memory, model->wheel);
    if (fault.failed()) return fault;
    scratch = arrays;
    fault = load_profile(options.rail, ProfileRole::rail, cut(scratch, node_count(options.rail)), given);
    if (!fault.failed()) fault = place_rail(given, options.track, options.side, rail_memory, model->rail);
    if (fault.failed()) return fault;
  }
  made = model;
  return {};
}

}  // namespace wrc
