/// A solution on strips of uneven width, cut again into strips of equal width fitted to its patches.
#pragma once

#include "patch/strips.hpp"

namespace wrc::normal {

/// Strips in contact, ordered by y; neighbours with the same `region` touch each other.
struct SolvedStrips {
  std::int32_t count = 0;
  const double* y = nullptr;
  const double* width = nullptr;
  const double* centre = nullptr;
  const double* half_length = nullptr;
  const double* peak = nullptr;
  const std::int32_t* region = nullptr;
};

/// Cuts every patch (run of one region) into strips of equal width. Between the solution's strips, and from
/// the last one to the border of the patch, where it vanishes, l^2 is linear; so is p / l. `count` strips are
/// shared out by the patches' width, at least four each while they last; pressures are scaled so that each
/// patch keeps its load. Returns the total [N].
double resample_strips(const SolvedStrips& solved, std::int32_t count, patch::Strips& strips) noexcept;

}  // namespace wrc::normal
