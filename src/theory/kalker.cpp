#include "theory/kalker.hpp"

#include <cmath>

#include "base/elementary.hpp"
#include "patch/material.hpp"
#include "theory/node_values.hpp"

namespace wrc::theory {
namespace {

using Reciprocal = HermiteTable<tables::ratio_count>;

/// Divisor of a coefficient before its reciprocal is tabulated, and the derivative with respect to a/b: C23 ~
/// sqrt(a/b) for narrow ellipses, so sqrt(a/b) / C23 stays finite and smooth there as 1/C11 and 1/C22 do.
Interpolated scale(tables::Coefficient coefficient, double ratio) {
  if (coefficient != tables::c23s) return {1.0, 0.0};
  const double root = std::sqrt(ratio);
  return {root, 0.5 / root};
}

Reciprocal reciprocals(tables::Coefficient coefficient, double poisson) {
  tables::OverRatio flexibility{};
  for (std::size_t i = 0; i < tables::ratio_count; ++i) {
    flexibility[i] =
        scale(coefficient, tables::ratio_node(i)).value * tables::reciprocal(coefficient, i, 0, poisson);
  }
  return {tables::slenderness_nodes(), flexibility};
}

/// The coefficient and its derivative with respect to a/b inside the table.
Interpolated in_table(tables::Coefficient coefficient, const Reciprocal& table, double ratio) {
  // C = scale / f(u), u the slenderness, du / d(a/b) = 2 / (a/b + 1)^2
  const Interpolated s = scale(coefficient, ratio), f = table(slenderness(ratio));
  const double du = 2.0 / ((ratio + 1.0) * (ratio + 1.0));
  return {s.value / f.value, (s.slope - s.value * f.slope * du / f.value) / f.value};
}

/// Kalker's asymptotes; the derivative is with respect to g = min(a/b, b/a).
struct Asymptotes {
  Interpolated c11, c22, c23;
};

/// a << b, g = a/b.
Asymptotes narrow(double g, double nu) {
  // C11 = pi^2 / (4 (1 - nu)), C22 = pi^2 / 4, C23 = pi sqrt(g) / (3 (1 - nu)) (1 + nu (ln(16 / g) - 5))
  const double bracket = 1.0 + nu * (natural_log(16.0 / g) - 5.0);
  const double scale = pi * std::sqrt(g) / (3.0 * (1.0 - nu));
  return {{pi * pi / (4.0 * (1.0 - nu)), 0.0},
          {pi * pi / 4.0, 0.0},
          {scale * bracket, scale * (0.5 * bracket - nu) / g}};
}

/// f(L) = (2 pi / (g D)) (1 + k / D) with D = d0 L + d1 and L = ln(16 / g^2).
Interpolated slender_form(double g, double D, double d0, double k) {
  const double value = 2.0 * pi / (g * D) * (1.0 + k / D);
  const double dD = -2.0 * d0 / g;
  return {value, -value / g - 2.0 * pi / (g * D * D) * (1.0 + 2.0 * k / D) * dD};
}

/// a >> b, g = b/a.
Asymptotes wide(double g, double nu) {
  // C11 and C22 in slender_form(), C23 = 2 pi / (3 g sqrt(g) ((1 - nu) L - 2 + 4 nu))
  const double L = natural_log(16.0 / (g * g));
  const double k = 3.0 - natural_log(4.0);
  const double D23 = (1.0 - nu) * L - 2.0 + 4.0 * nu;
  const double c23 = 2.0 * pi / (3.0 * g * std::sqrt(g) * D23);
  return {slender_form(g, L - 2.0 * nu, 1.0, k),
          slender_form(g, (1.0 - nu) * L + 2.0 * nu, 1.0 - nu, (1.0 - nu) * k),
          {c23, c23 / g * (-1.5 + 2.0 * (1.0 - nu) / D23)}};
}

/// The asymptote times a factor 1 + d(g) that meets the table at its end g0 in value and slope (d0, d0') and
/// fades out linearly: d(g) = (g/g0) [d0 + (g/g0 - 1) (g0 d0' - d0)].
double continued(double g, double g0, const Interpolated& asymptote, const Interpolated& asymptote_at_end,
                 const Interpolated& table_at_end) {
  const double ratio = table_at_end.value / asymptote_at_end.value;
  const double ratio_slope = (table_at_end.slope - ratio * asymptote_at_end.slope) / asymptote_at_end.value;
  const double s = g / g0;
  const double d = s * (ratio - 1.0 + (s - 1.0) * (g0 * ratio_slope - (ratio - 1.0)));
  return asymptote.value * (1.0 + d);
}

}  // namespace

KalkerTable::KalkerTable(double poisson)
    : poisson_(poisson),
      c11_(reciprocals(tables::c11s, poisson)),
      c22_(reciprocals(tables::c22s, poisson)),
      c23_(reciprocals(tables::c23s, poisson)) {}

KalkerCoefficients KalkerTable::at(double ratio, Fault& fault) const {
  const double lowest = tables::lowest_ratio, highest = tables::highest_ratio;
  if (ratio >= lowest && ratio <= highest) {
    return {in_table(tables::c11s, c11_, ratio).value, in_table(tables::c22s, c22_, ratio).value,
            in_table(tables::c23s, c23_, ratio).value};
  }

  keep_worst(fault, Fault::table_range("patch axis ratio a/b", {ratio, "1", lowest, highest},
                                       "Kalker's asymptote for slender ellipses is used"));
  // Beyond the table: asymptotes in g, here and at the table's end, and the table's slope there by g.
  const bool is_narrow = ratio < lowest;
  const double end = is_narrow ? lowest : highest;
  const double g = is_narrow ? ratio : 1.0 / ratio;
  const double g0 = is_narrow ? end : 1.0 / end;
  const Asymptotes here = is_narrow ? narrow(g, poisson_) : wide(g, poisson_);
  const Asymptotes there = is_narrow ? narrow(g0, poisson_) : wide(g0, poisson_);
  const double dratio_dg = is_narrow ? 1.0 : -end * end;  // g is a/b or its reciprocal
  const auto at_end = [&](tables::Coefficient coefficient, const Reciprocal& table) {
    const Interpolated c = in_table(coefficient, table, end);
    return Interpolated{c.value, c.slope * dratio_dg};
  };
  return {continued(g, g0, here.c11, there.c11, at_end(tables::c11s, c11_)),
          continued(g, g0, here.c22, there.c22, at_end(tables::c22s, c22_)),
          continued(g, g0, here.c23, there.c23, at_end(tables::c23s, c23_))};
}

}  // namespace wrc::theory
