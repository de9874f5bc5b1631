/// The kinds of comparison, one file each. Each runs the variants named in `only`, or all of its own when
/// that is empty; a name it does not know is an error that lists those it does (see chosen()).
#pragma once

#include "csv.hpp"
#include "report.hpp"

namespace compare {

using Names = std::vector<std::string>;

/// Exact double ellipses with prescribed pressure: forces and power of every tangential variant.
Report compare_sdec(const Csv& file, const Names& only);

/// Normal contact of S1002 on the benchmark UIC60, strip by strip: every normal method.
Report compare_normal(const Csv& file, const Names& only);

/// Wheel on rail end to end, from the pose to forces and power: normal and tangential methods together.
Report compare_wheelrail(const Csv& file, const Names& only);

/// The exact solver of wrc_offline.h on the same rows, on each row's own grid.
Report compare_halfspace_sdec(const Csv& file, const Names& only);
Report compare_halfspace_normal(const Csv& file, const Names& only);

/// The default tangential variant on grids of 16 to 128 strips and cells against 512 x 512: the
/// discretisation's share of the error.
Report compare_grid(const Csv& file, const Names& only);

}  // namespace compare
