#include "linear_theory/sdec.hpp"

#include <cmath>

namespace wrc {
namespace {

constexpr std::size_t rows = tables::sdec.size();
constexpr std::size_t nodes = rows + 2;
using Column = std::array<double, 3>;
using Nodes = std::array<double, nodes>;

Nodes slenderness_of_nodes() {
  Nodes u{};
  u.front() = -1.0;
  for (std::size_t i = 0; i < rows; ++i) u[i + 1] = slenderness(tables::sdec[i].ratio);
  u.back() = 1.0;
  return u;
}

/// Least-squares line in the Poisson ratio through a row's three columns. They are so close together (0.25 to
/// 0.30) and so nearly straight that a parabola would only carry their last digit out to 0 and 0.5.
double line(const Column& column, double poisson) {
  const auto& nu = tables::sdec_poisson;
  const double mean_nu = (nu[0] + nu[1] + nu[2]) / 3.0;
  const double mean = (column[0] + column[1] + column[2]) / 3.0;
  double sxx = 0.0, sxy = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    sxx += (nu[k] - mean_nu) * (nu[k] - mean_nu);
    sxy += (nu[k] - mean_nu) * column[k];
  }
  return mean + sxy / sxx * (poisson - mean_nu);
}

HermiteTable<nodes> fading(Column tables::SdecRow::*coefficient, double poisson) {
  Nodes values{};  // zero at both limits
  for (std::size_t i = 0; i < rows; ++i) values[i + 1] = line(tables::sdec[i].*coefficient, poisson);
  return {slenderness_of_nodes(), values};
}

HermiteTable<nodes> relative_k13(double poisson) {
  std::array<KalkerTable, 3> ellipse;
  for (std::size_t k = 0; k < 3; ++k) ellipse[k] = KalkerTable(tables::sdec_poisson[k]);
  const Nodes u = slenderness_of_nodes();
  Nodes values{};
  for (std::size_t i = 0; i < rows; ++i) {
    const tables::SdecRow& row = tables::sdec[i];
    Column relative;
    for (std::size_t k = 0; k < 3; ++k) {
      Fault inside;
      relative[k] = row.k13[k] * std::sqrt(row.ratio) / (0.75 * ellipse[k].at(row.ratio, inside).c11);
    }
    values[i + 1] = line(relative, poisson);
  }
  const auto extended = [&](std::size_t end, std::size_t first, std::size_t second) {
    return values[first] + (values[second] - values[first]) / (u[second] - u[first]) * (u[end] - u[first]);
  };
  values.front() = extended(0, 1, 2);
  values.back() = extended(nodes - 1, rows, rows - 1);
  return {u, values};
}

void check_range(const char* field, double value, double low, double high, Fault& fault) {
  if (value >= low && value <= high) return;
  worsen(fault, Fault{.status = WRC_FLAG_TABLE_RANGE,
                      .field = field,
                      .value = value,
                      .unit = "1",
                      .low = low,
                      .high = high,
                      .cause = "the shape's influence is extrapolated"});
}

}  // namespace

SdecTable::SdecTable(double poisson)
    : poisson_(poisson),
      ellipse_(poisson),
      b11_(fading(&tables::SdecRow::b11, poisson)),
      b22_(fading(&tables::SdecRow::b22, poisson)),
      b23_(fading(&tables::SdecRow::b23, poisson)),
      relative_k13_(relative_k13(poisson)) {}

SdecCoefficients SdecTable::at(double ratio, double shape_number, Fault& fault) const {
  check_range("patch axis ratio a/b", ratio, tables::sdec.front().ratio, tables::sdec.back().ratio, fault);
  check_range("Poisson ratio", poisson_, tables::sdec_poisson.front(), tables::sdec_poisson.back(), fault);

  const KalkerCoefficients ellipse = ellipse_.at(ratio, fault);
  const double u = slenderness(ratio);
  const double psi2 = shape_number * shape_number;
  SdecCoefficients c;
  c.c11 = ellipse.c11 + b11_(u).value * psi2;
  c.c22 = ellipse.c22 + b22_(u).value * psi2;
  c.c23 = ellipse.c23 + b23_(u).value * psi2;
  c.k13 = relative_k13_(u).value * 0.75 * ellipse.c11 / std::sqrt(ratio);
  c.c13 = -c.k13 * shape_number;
  return c;
}

}  // namespace wrc
