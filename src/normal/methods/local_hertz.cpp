#include "normal/methods/local_hertz.hpp"

#include <algorithm>

#include "normal/check.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/penetration/penetration.hpp"

namespace wrc::normal {
namespace {

constexpr double flat = 0.1;  // least B [1/m]

/// The curvatures of the gap at y, and Hertz's eps_y for them as the scale of the penetration.
class LocalCurvature {
 public:
  LocalCurvature(const patch::GapRows& rows, double reach)
      : here_(rows), below_(rows), above_(rows), reach_(reach), inverse_(1.0 / (reach * reach)) {}

  /// A, B of the gap there and its height.
  struct Place {
    double height, coefficient_x, coefficient_y, centre;
    HertzShape shape() const { return tabulated_hertz_shape(coefficient_x / coefficient_y); }
  };
  Place place(double y) {
    const patch::GapRow row = here_.at(y);
    // B = h''/2, h'' the second difference over the reach.
    const double second = below_.height(y - reach_) + above_.height(y + reach_) - 2.0 * row.height;
    return {row.height, 0.5 * row.curvature, std::max(0.5 * second * inverse_, flat), row.centre};
  }
  double at(double y) { return place(y).shape().eps_y; }

 private:
  patch::GapReader here_, below_, above_;
  double reach_, inverse_;
};

}  // namespace

Fault solve_local_hertz(const NormalProblem& problem, CurvatureReach reach, patch::Strips& strips,
                        NormalSolution& solution) noexcept {
  FirstTouch touch;
  const Fault fault = begin_solution(problem, strips, solution, touch);
  if (fault.status != WRC_OK) return fault;

  const patch::GapRows& rows = problem.gap;
  const double compliance = problem.material.normal_compliance();
  bool at_edge = false;
  const auto scale_at = [&](double approach) {
    // The reach follows from the half width at half the approach.
    const Span half_depth = penetration_span(rows, touch.lowest, PenetrationScale{}, approach);
    return LocalCurvature(rows, reach(std::max(0.5 * half_depth.width(), least_half_chord)));
  };
  const auto force = [&](double approach, LocalCurvature local, const Span& span) {
    // Strips of equal width; each is a Hertz contact of its own A, B under the local depth g / eps_y.
    at_edge = span.at_edge;
    strips.count = problem.strips;
    const double width = span.width() / strips.count;
    double load = 0.0;
    for (std::int32_t j = 0; j < strips.count; ++j) {
      strips.y[j] = span.y_from + (j + 0.5) * width;
      strips.width[j] = width;
      const LocalCurvature::Place place = local.place(strips.y[j]);
      const HertzShape shape = place.shape();
      // A dip of the overlap between two rows must not end in the root of a negative number.
      const double overlap =
          std::max(shape.eps_y * approach - (place.height - touch.lowest.height), 1e-12 * approach);
      const HertzEllipse ellipse =
          hertz_ellipse(shape, place.coefficient_x, overlap / shape.eps_y, compliance);
      strips.centre[j] = place.centre;
      strips.half_length[j] = ellipse.a;
      strips.peak[j] = ellipse.peak;
      load += 0.5 * pi * ellipse.a * ellipse.peak * width;
    }
    return load;
  };
  return solve_by_search(problem, touch.lowest, 0.5 * touch.row.curvature, scale_at, force, at_edge, strips,
                         solution);
}

}  // namespace wrc::normal
