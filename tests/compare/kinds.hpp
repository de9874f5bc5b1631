/// The kinds of comparison, one file each.
#pragma once

#include "csv.hpp"
#include "report.hpp"

namespace compare {

/// Exact double ellipses with prescribed pressure: forces and power of every tangential variant.
Report compare_sdec(const Csv& file);

/// Normal contact of S1002 on the benchmark UIC60, strip by strip: every normal method.
Report compare_normal(const Csv& file);

/// Wheel on rail end to end, from the pose to forces and power: normal and tangential methods together.
Report compare_wheelrail(const Csv& file);

/// The exact solver of wrc_offline.h on the same rows, on each row's own grid.
Report compare_halfspace_sdec(const Csv& file);
Report compare_halfspace_normal(const Csv& file);

/// The default tangential variant on grids of 16 to 128 strips and cells against 512 x 512: the
/// discretisation's share of the error.
Report compare_grid(const Csv& file);

}  // namespace compare
