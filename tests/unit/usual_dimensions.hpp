/// Dimensions of the interface's defaults, as the inside has them.
#pragma once

#include "abi/structs.hpp"
#include "geometry/placement.hpp"

namespace wrc {

inline geometry::TrackDimensions usual_track(double rail_inclination = 0.0) {
  constexpr wrc_config_track track = abi::defaults<wrc_config_track>();
  return {.gauge = track.gauge, .gauge_depth = track.gauge_depth, .rail_inclination = rail_inclination};
}

inline geometry::WheelsetDimensions usual_wheelset() {
  constexpr wrc_config_wheelset wheelset = abi::defaults<wrc_config_wheelset>();
  return {.tape_circle_distance = wheelset.tape_circle_distance, .nominal_radius = wheelset.wheel_radius};
}

}  // namespace wrc
