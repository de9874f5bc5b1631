#include "cases.hpp"

#include <algorithm>
#include <cmath>

namespace compare {

std::vector<Case> find_cases(const Csv& file) {
  std::vector<Case> cases;
  for (std::size_t row = 0; row < file.rows(); ++row) {
    const bool same = !cases.empty() && [&] {
      const std::size_t head = cases.back().first;
      return file(row, "y_ws_mm") == file(head, "y_ws_mm") && file(row, "yaw_rad") == file(head, "yaw_rad") &&
             file(row, "fz_N") == file(head, "fz_N") && file(row, "patch") == file(head, "patch");
    }();
    if (same) {
      cases.back().last = row + 1;
    } else {
      cases.push_back({row, row + 1});
    }
  }
  return cases;
}

void LineLoad::add(double low, double high, double per_length) {
  low_.push_back(low);
  high_.push_back(high);
  per_length_.push_back(per_length);
}

double LineLoad::over(double from, double to) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < low_.size(); ++j) {
    sum += per_length_[j] * std::max(0.0, std::min(to, high_[j]) - std::max(from, low_[j]));
  }
  return sum;
}

double reference_shift(const Csv& file, const Case& rows, const wrc_planar_point& point) {
  return (1e-3 * file(rows.first, "ycp_rail_mm") - point.y_rail) / std::cos(point.angle);
}

double line_load_error(const Csv& file, const Case& rows, const LineLoad& ours, double shift) {
  double difference = 0.0, total = 0.0, covered = 0.0;
  // Rows lie on the reference's grid; one missing in between would be a separate patch.
  const double spacing = 1e-3 * 0.2;
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    const double y = 1e-3 * file(row, "row_y_mm") + shift;
    const double load = 1e3 * file(row, "line_load_N_per_mm") * spacing;
    const double mine = ours.over(y - 0.5 * spacing, y + 0.5 * spacing);
    difference += std::fabs(mine - load);
    total += load;
    covered += mine;
  }
  difference += std::fabs(ours.over(-1.0, 1.0) - covered);  // load of ours where the reference has none
  return difference / total;
}

}  // namespace compare
