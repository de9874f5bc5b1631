/// Inputs that a careless, unlucky or hostile vendor could hand over: most lie inside the documented ranges
/// at an extreme or with an unphysical shape, some outside.
#pragma once

#include <vector>

#include "choices.hpp"
#include "wrc/wrc_damage.h"
#include "wrc/wrc_planar.h"

namespace hostile {

struct ProfilePoints {
  std::vector<double> y, z;
  wrc_profile profile{};
};
struct GapArrays {
  std::vector<double> y, height, centre, curvature, x, h;
  wrc_planar_gap gap{};
};
struct StripArrays {
  std::vector<double> y, width, centre, half_length, peak;
  wrc_planar_strips strips{};
};
struct FrictionArrays {
  std::vector<double> y, coefficient;
  wrc_friction friction{};
  /// The largest coefficient anywhere: what no force may exceed times the load.
  double most() const;
};

void make_wheel(Choices& choices, ProfilePoints& made);
void make_rail(Choices& choices, ProfilePoints& made);
/// At most `finest` strips and cells, 512 being what the interface allows.
wrc_config make_config(Choices& choices, std::int32_t finest, const wrc_profile& wheel,
                       const wrc_profile& rail);
/// What changes along the track and round the wheel: the sections of a rail, a deviation from round.
struct AlongTrackArrays {
  std::vector<wrc_rail_section> sections;
  std::vector<unsigned char> of_another_header;  ///< the same, as larger structs
  std::vector<double> marks, angle, y, deviation;
};
/// Gives a configuration both, one or nothing.
void make_along_track(Choices& choices, wrc_config& config, AlongTrackArrays& made);
wrc_planar_pose make_pose(Choices& choices);
wrc_planar_load make_load(Choices& choices);
wrc_planar_motion make_motion(Choices& choices);
wrc_wear_laws make_wear_laws(Choices& choices);
wrc_creepage make_creepage(Choices& choices);
void make_friction(Choices& choices, FrictionArrays& made);
wrc_ellipse make_ellipse(Choices& choices);
/// A wheel on a rail of that configuration, anywhere between the usual and the ends of the ranges.
void make_wheel_on_rail(Choices& choices, const wrc_config& config, wrc_wheel_input& input);
/// At most `room` rows or strips, or one too many now and then.
void make_gap(Choices& choices, std::int32_t room, GapArrays& made);
void make_strips(Choices& choices, std::int32_t room, StripArrays& made);

}  // namespace hostile
