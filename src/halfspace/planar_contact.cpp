#include "halfspace/planar_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "contact/stages.hpp"
#include "halfspace/pressure.hpp"
#include "halfspace/tangential.hpp"

namespace wrc::halfspace {
namespace {

// Friction at y in the contact frame: that of the nearest strip.
double friction_at(contact::Contact& contact, double y) {
  double nearest = std::numeric_limits<double>::infinity(), friction = 0.0;
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    const contact::Patch& patch = contact.patch[k];
    // regions share no strips: the nearest of all counts
    const patch::Strips region = contact::region_strips(contact, patch);
    const double* each = contact::array(contact, contact::Array::strip_friction) + patch.region_first;
    for (std::int32_t j = 0; j < region.count; ++j) {
      const double distance = std::fabs(region.y[j] - y);
      if (distance >= nearest) continue;
      nearest = distance;
      friction = each[j];
    }
  }
  return friction;
}

}  // namespace

void sample_gap(const contact::Contact& contact, const Grid& grid, double* gap) {
  const patch::GapRows rows = contact::gap_rows(contact);
  std::optional<geometry::SurfaceGap> surfaces;
  if (contact.posed) surfaces = contact::surface_gap(contact);
  // h(x, y): the surfaces' separation, or the row's parabola h + kappa / 2 (x - c)^2
  const auto height_at = [&](const patch::GapRow& row, double x, double y) {
    if (surfaces) return surfaces->at(x, y);
    return row.height + 0.5 * row.curvature * (x - row.centre) * (x - row.centre);
  };
  // Zero at the minimum of the rows, where the real-time methods count approaches from.
  const double lowest_y = patch::minimum(rows).y;
  const patch::GapRow lowest_row = patch::interpolate(rows, lowest_y);
  const double lowest = height_at(lowest_row, lowest_row.centre, lowest_y);
  for (int j = 0; j < grid.ny; ++j) {
    const double y = grid.y(j), inside = std::clamp(y, rows.y[0], rows.y[rows.count - 1]);
    const patch::GapRow row = patch::interpolate(rows, inside);
    for (int i = 0; i < grid.nx; ++i) {
      gap[grid.index(i, j)] = height_at(row, grid.x(i), inside) + row.slope * (y - inside) - lowest;
    }
  }
}

Fault check_planar_contact(contact::Contact& contact, int nx, int ny, const ProgressCallback& progress,
                           PlanarCheck& result) {
  const contact::Rolling& rolling = contact.rolling;
  // The solver rolls along x: rolling backwards is the mirror image, x -> -x.
  patch::Strips strips = contact::all_strips(contact);
  std::vector<double> centre(strips.centre, strips.centre + strips.count);
  for (double& x : centre) x *= rolling.direction;
  strips.centre = centre.data();
  const Grid grid = grid_over(strips, nx, ny);
  RollingProblem problem;
  problem.pressure = strip_pressure(strips, grid);
  problem.friction.resize(grid.cells());
  for (int j = 0; j < grid.ny; ++j) {
    const double friction = friction_at(contact, grid.y(j));
    for (int i = 0; i < grid.nx; ++i) problem.friction[grid.index(i, j)] = friction;
  }
  problem.creepage = contact.creepage;
  problem.creepage.longitudinal *= rolling.direction;
  problem.creepage.spin *= rolling.direction;
  problem.progress = progress;
  problem.layer = contact.law.layer;
  // The slope reduction lets the bodies move further along each other, as a lower shear modulus would.
  patch::Material material = contact.model->options.material;
  const double layer = contact::friction_of(contact).slope_reduction;
  material.shear_modulus *= layer;
  const RollingSolution exact =
      RollingSolver(grid, material, {}, contact.model->options.coupling * layer).solve(problem);
  if (exact.fault.failed()) return exact.fault;
  // Out of the mirror; the power of the balance is the limit of fine grids.
  result.fx = rolling.direction * exact.forces.fx;
  result.fy = exact.forces.fy;
  result.mz = rolling.direction * exact.forces.mz;
  result.power = exact.power_by_balance * rolling.speed;
  result.adhesion_fraction = exact.forces.adhesion_fraction;
  const double limit = contact.friction * contact.extent.normal_force;
  const double dx = contact.forces.fx - result.fx, dy = contact.forces.fy - result.fy;
  result.force_error = limit > 0.0 ? std::sqrt(dx * dx + dy * dy) / limit : 0.0;
  result.power_error =
      exact.power_by_balance > 0.0 ? contact.forces.power_per_speed / exact.power_by_balance - 1.0 : 0.0;
  return exact.fault;
}

}  // namespace wrc::halfspace
