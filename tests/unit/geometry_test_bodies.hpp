/// The pair of bodies of the reference case, with their memory: S1002 on the benchmark UIC60, gauge 1435 mm.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/placement.hpp"
#include "geometry/standard_profiles.hpp"

namespace wrc {

/// Owns the memory of one profile.
struct ProfileStore {
  static constexpr std::int32_t capacity = 512;
  std::array<double, profile_doubles(capacity)> doubles;
  ProfileMemory memory() { return profile_memory(capacity, doubles.data()); }
};

/// Not copyable: rail and wheel point into the stores.
struct ReferenceBodies {
  ProfileStore rail_nodes, wheel_nodes, rail_placed, wheel_placed;
  Rail rail;
  Wheel wheel;

  explicit ReferenceBodies(Side side = Side::right) {
    Profile profile;
    sample_uic60_benchmark(rail_nodes.memory(), profile);
    place_rail(profile, TrackDimensions{}, side, rail_placed.memory(), rail);
    sample_s1002(wheel_nodes.memory(), profile);
    place_wheel(profile, WheelsetDimensions{}, side, wheel_placed.memory(), wheel);
  }
  ReferenceBodies(const ReferenceBodies&) = delete;
  ReferenceBodies& operator=(const ReferenceBodies&) = delete;
};

}  // namespace wrc
