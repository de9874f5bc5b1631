/// Patches on the rail's surface: parts of the runs of strips in contact between valleys of their loads
/// (lobes.hpp), for methods that need a patch. Where a valley is neither deep nor shallow the strips are of
/// both partitions, by shares.
#pragma once

#include <cstdint>

#include "base/number.hpp"
#include "patch/material.hpp"
#include "patch/sdec.hpp"
#include "surface/pressure/lobes.hpp"
#include "surface/rolling/surface_rolling.hpp"

namespace wrc::surface {

/// Means over the load of a part.
struct PartMeans {
  double load = 0.0;   ///< [N]
  double place = 0.0;  ///< arc length [m]
  double along = 0.0;  ///< x [m]
  tangential::Creepage creepage;
  double friction = 0.0;  ///< [-]
};

/// The strips, their x, and scratch: load per width l p [N/m], and the load of each within the part [N].
struct StripsInParts {
  const SurfaceRollingInput& strips;
  const double* along;
  double *line_load, *load;
  LobeLimits limits{};

  /// Calls take(first, end, cuts) for every run of strips first .. end - 1 side by side, with its valleys.
  template <class Take>
  void for_each_run(Take&& take) const {
    for (std::int32_t j = 0; j < strips.count; ++j) line_load[j] = strips.half_length[j] * strips.peak[j];
    for (std::int32_t first = 0, end = 0; first < strips.count; first = end) {
      // a run of strips side by side: middles less than 1.5 mean widths apart
      end = first + 1;
      while (end < strips.count &&
             strips.place[end] - strips.place[end - 1] < 0.75 * (strips.width[end] + strips.width[end - 1]))
        ++end;
      take(first, end, find_lobes(strips.place, line_load, first, end, limits));
    }
  }

  /// Calls take(first, end, share, low, high) for every part: strips first .. end - 1 between the cuts. The
  /// patches of a run are the parts between valleys of the line load. Where a valley is neither deep nor
  /// shallow both partitions roll, each by its share.
  template <class Take>
  void for_each(Take&& take) const {
    for_each_run([&](std::int32_t first, std::int32_t end, const LobeCuts& cuts) {
      for_each_part(cuts, [&](double share, const LobeCut* low, const LobeCut* high) {
        take(first, end, share, low, high);
      });
    });
  }

  /// Loads of the strips within a part (a strip across its border counts with its width inside), and means
  /// over them.
  PartMeans take_part(std::int32_t first, std::int32_t end, const LobeCut* low, const LobeCut* high) const {
    // First moments, weights N = pi/2 l p times the width inside the part.
    PartMeans m;
    for (std::int32_t j = first; j < end; ++j) {
      const double from = strips.place[j] - 0.5 * strips.width[j], to = from + strips.width[j];
      const double inside =
          larger((high ? smaller(to, high->place) : to) - (low ? larger(from, low->place) : from), 0.0);
      const double N = 0.5 * pi * inside * line_load[j];
      load[j] = N;
      m.load += N;
      m.place += N * strips.place[j];
      m.along += N * along[j];
      m.creepage.longitudinal += N * strips.slip_x[j];
      m.creepage.lateral += N * strips.slip_y[j];
      m.creepage.spin += N * strips.spin[j];
      m.friction += N * strips.friction[j];
    }
    if (!(m.load > 0.0)) return m;
    for (double* const mean :
         {&m.place, &m.along, &m.creepage.longitudinal, &m.creepage.lateral, &m.creepage.spin, &m.friction})
      *mean /= m.load;
    return m;
  }

  /// Width within the part taken that carries the strip's load there [m].
  double width_inside(std::int32_t j) const { return load[j] / (0.5 * pi * line_load[j]); }
};

}  // namespace wrc::surface
