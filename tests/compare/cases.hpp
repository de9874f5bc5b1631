/// The contacts in a file with the columns of normal_rows.csv, and how a load over the width is compared.
#pragma once

#include <vector>

#include "csv.hpp"
#include "wrc/wrc_planar.h"

namespace compare {

/// Consecutive lines of the file that belong to one contact: [first, last).
struct Case {
  std::size_t first, last;
};
std::vector<Case> find_cases(const Csv& file);

/// Load over y as piecewise constant line load.
class LineLoad {
 public:
  /// Adds an interval [m] with a constant load per width [N/m].
  void add(double low, double high, double per_length);
  /// Load between two y [N].
  double over(double from, double to) const;

 private:
  std::vector<double> low_, high_, per_length_;
};

/// What to add to the reference's lateral coordinate (origin at its contact reference location) to get ours
/// (initial contact point) [m].
double reference_shift(const Csv& file, const Case& rows, const wrc_planar_point& point);

/// Sum of |difference| over the reference's rows and what lies outside them, by the total load.
double line_load_error(const Csv& file, const Case& rows, const LineLoad& ours, double shift);

}  // namespace compare
