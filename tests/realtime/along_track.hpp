/// A rail that changes along the track and a wheel with a flat, of numbers that are the same bits everywhere:
/// + - * / alone.
#pragma once

#include "structs.hpp"

/// A ramp down and aside over four metres, a second face beside it, and a wheel with a flat of 0.4 mm.
struct AlongTrackBodies {
  static constexpr int angles = 721;
  wrc_rail_section section[7];
  double angle[angles], deviation[angles];

  AlongTrackBodies() {
    const double z[] = {0.0, 0.0, 0.004, 0.008, 0.008}, y[] = {0.0, 0.0, -0.002, -0.004, -0.004};
    for (int k = 0; k < 7; ++k) {
      section[k] = {};
      section[k].profile.kind = WRC_PROFILE_60E1;
      section[k].distance = k < 5 ? k : 1.5 + (k - 5);
      section[k].surface = k < 5 ? 0 : 1;
      section[k].y = k < 5 ? y[k] : -0.09;
      section[k].z = k < 5 ? z[k] : 0.001;
    }
    constexpr double turn = 6.283185307179586;
    for (int i = 0; i < angles; ++i) {
      angle[i] = turn * i / (angles - 1);
      const double t = 8.0 * (i < angles / 2 ? angle[i] : turn - angle[i]), left = 1.0 - t * t;
      deviation[i] = t < 1.0 ? -0.4e-3 * left * left : 0.0;
    }
  }
  void give(wrc_config& config) const {
    config.rail_section_count = 7;
    config.rail_section_size = sizeof section[0];
    config.rail_sections = section;
    config.roundness = {angles, 1, angle, nullptr, deviation, {}};
  }
};
