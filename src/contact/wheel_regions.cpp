/// What is asked of a region of the last solve_wheel() afterwards: ellipse, damage, fields over its strips
/// and cells.
#include <algorithm>
#include <cmath>

#include "contact/contact.hpp"
#include "contact/temperature_sums.hpp"
#include "damage/cells.hpp"
#include "damage/fatigue.hpp"
#include "damage/frictional_power.hpp"

namespace wrc {
namespace {

const KeptStrips& kept_strips(const Contact& contact) {
  return reinterpret_cast<const SurfaceState*>(array(contact, Array::surface_state))->kept;
}

/// The kept strips of a region.
struct Run {
  std::int32_t first = 0, count = 0;
};

Run strips_of(const KeptStrips& kept, const SurfaceRegion& region) {
  const auto all = static_cast<std::int32_t>(kept.count);
  Run run;
  while (run.first < all && kept.strip[run.first] < region.first) ++run.first;
  while (run.first + run.count < all && kept.strip[run.first + run.count] < region.first + region.count)
    ++run.count;
  return run;
}

/// What stands in KeptStrips of a strip, over arc length.
struct StripOnRail {
  double s, width, half_length, peak, load;  ///< [m], [m], [m], [Pa], [N]
};

StripOnRail strip_at(const KeptStrips& kept, std::int32_t k) {
  const double l = kept.half_length[k], peak = kept.factor * kept.peak[k], width = kept.width[k];
  return {kept.place[k], width, l, peak, 0.5 * pi * width * l * peak};
}

/// Where the strips are longest [m]: the vertex of the parabola through the squared half lengths of the
/// longest and of its neighbours, as half lengths of an ellipse have it.
double place_of_longest(const KeptStrips& kept, const Run& run) {
  std::int32_t longest = run.first;
  for (std::int32_t k = run.first; k < run.first + run.count; ++k)
    if (kept.half_length[k] > kept.half_length[longest]) longest = k;
  const double here = strip_at(kept, longest).s;
  if (longest == run.first || longest == run.first + run.count - 1) return here;
  const auto square = [&](std::int32_t k) { return kept.half_length[k] * kept.half_length[k]; };
  const double left = strip_at(kept, longest - 1).s - here, right = strip_at(kept, longest + 1).s - here;
  const double to_left = (square(longest - 1) - square(longest)) / left,
               to_right = (square(longest + 1) - square(longest)) / right;
  const double bent = (to_right - to_left) / (right - left);  // half the second derivative
  if (!(bent < 0.0)) return here;
  const double slope = to_right - bent * right;
  return here + std::clamp(-0.5 * slope / bent, 0.5 * left, 0.5 * right);
}

/// Cells assessed: where the numbers of each cell lie afterwards, and of each strip.
struct AssessedCells {
  std::int32_t strips = 0, cells = 0;
  const double *power_density = nullptr, *fatigue_index = nullptr;  ///< over cells
  double strip_power[most_overlapping_strips] = {};                 ///< [W/m]
  CellDamage worst;
};

KeptFields fields_of(Contact& contact, const Run& run) {
  const KeptStrips& kept = kept_strips(contact);
  const KeptFields f = roll_kept(*contact.model->surface, kept, run.first, run.count,
                                 array(contact, Array::surface_workspace));
  for (double* const a : {f.traction_x, f.traction_y})
    for (std::int32_t at = 0; at < f.strips * f.cells; ++at) a[at] *= kept.factor;
  return f;
}

/// The places and lengths of kept strips that are asked for.
struct StripNumbers {
  double place[most_overlapping_strips], width[most_overlapping_strips], half_length[most_overlapping_strips],
      peak[most_overlapping_strips];
  Strips strips;

  StripNumbers(const KeptStrips& kept, const Run& run) {
    for (std::int32_t k = 0; k < run.count; ++k) {
      const StripOnRail strip = strip_at(kept, run.first + k);
      place[k] = strip.s;
      width[k] = strip.width;
      half_length[k] = strip.half_length;
      peak[k] = strip.peak;
    }
    strips.count = run.count;
    strips.y = place;
    strips.width = width;
    strips.half_length = half_length;
    strips.peak = peak;
  }
  StripNumbers(const StripNumbers&) = delete;
  StripNumbers& operator=(const StripNumbers&) = delete;
};

/// x of the middle of a cell [m].
double cell_x(const Contact& contact, const KeptStrips& kept, std::int32_t i, std::int32_t k) {
  const double way = kept.backwards > 0.0 ? -1.0 : 1.0;
  return kept.x + kept.centre[k] + way * kept.half_length[k] * contact.model->march_grid.middles.place[i];
}

/// Returns the rises over the cells, in the workspace, over the slips.
const double* heat(Contact& contact, const Run& run, const BulkTemperatures& bulk,
                   TemperatureNumbers& temperature) {
  const KeptStrips& kept = kept_strips(contact);
  const KeptFields cells = fields_of(contact, run);
  const StripNumbers numbers(kept, run);
  TemperatureSums sums(contact.model->options.effusivities, bulk, cells.cells, kept.speed);
  sums.add(numbers.strips, {cells.traction_x, cells.traction_y, cells.slip_x, cells.slip_y}, cells.slip_x,
           [&](std::int32_t i, std::int32_t k) { return cell_x(contact, kept, i, run.first + k); });
  temperature = sums.numbers();
  return cells.slip_x;
}

/// In the workspace, over the slips.
void assess(Contact& contact, const Run& run, AssessedCells& assessed) {
  const Model& model = *contact.model;
  const KeptStrips& kept = kept_strips(contact);
  const KeptFields cells = fields_of(contact, run);
  const StripNumbers numbers(kept, run);
  const TangentialFields fields{cells.traction_x, cells.traction_y, cells.slip_x, cells.slip_y};
  simd::CellTask task{};
  task.region = &numbers.strips;
  task.fields = &fields;
  task.middles = &model.march_grid.middles;
  task.cells = cells.cells;
  task.speed = kept.speed;
  task.shear_yield = model.options.shear_yield;
  task.power_density = cells.slip_x;  // a cell is read before it is written
  task.fatigue_index = cells.slip_y;
  task.strip_power = assessed.strip_power;
  assessed.strips = cells.strips;
  assessed.cells = cells.cells;
  assessed.power_density = cells.slip_x;
  assessed.fatigue_index = cells.slip_y;
  assessed.worst = assess_cells(task, *model.kernels);
}

}  // namespace

Fault region_ellipse(const Contact& contact, std::int32_t index, RegionEllipse& ellipse) {
  const Model& model = *contact.model;
  const KeptStrips& kept = kept_strips(contact);
  const Run run = strips_of(kept, contact.wheel.wrench.region[index]);
  StripTotals extent;
  double front = 0.0, rear = 0.0;
  for (std::int32_t k = run.first; k < run.first + run.count; ++k) {
    const StripOnRail strip = strip_at(kept, k);
    const double leading = kept.centre[k] + strip.half_length, trailing = kept.centre[k] - strip.half_length;
    front = k == run.first ? leading : std::max(front, leading);
    rear = k == run.first ? trailing : std::min(rear, trailing);
    extent.area += 2.0 * strip.half_length * strip.width;
    extent.normal_force += strip.load;
    const double border = strip.s - 0.5 * strip.width;
    if (k == run.first) extent.y_min = border;
    extent.y_max = border + strip.width;
  }
  extent.length = front - rear;
  ellipse.normal_force = extent.normal_force;
  ellipse.joint = run.count > 0 ? place_of_longest(kept, run) : 0.0;
  return regularise(extent, ellipse.joint, model.options.regularisation, ellipse.sdec);
}

void region_damage(Contact& contact, std::int32_t index, DamageNumbers& damage) {
  const Model& model = *contact.model;
  const KeptStrips& kept = kept_strips(contact);
  const SurfaceRegion& region = contact.wheel.wrench.region[index];
  const Run run = strips_of(kept, region);
  damage = {};
  TangentialForces forces;
  double load = 0.0, peak = 0.0;
  for (std::int32_t k = 0; k < run.count; ++k) {
    const StripOnRail strip = strip_at(kept, run.first + k);
    forces.fx += kept.factor * kept.fx[run.first + k];
    forces.fy += kept.factor * kept.fy[run.first + k];
    load += strip.load;
    peak = std::max(peak, strip.peak);
  }
  damage.power = region.power;
  damage.t_gamma = kept.speed > 0.0 ? region.power / kept.speed : 0.0;
  damage.t_gamma_no_spin =
      t_gamma_without_spin(forces, {region.creepage[0], region.creepage[1], region.creepage[2]});
  const ShakedownPoint point = shakedown_point(forces, load, peak, model.options.shear_yield);
  damage.utilisation = point.utilised_friction;
  damage.load_factor = point.load_factor;
  damage.shakedown_limit = shakedown_limit(point.utilised_friction);
  damage.fatigue_index = fatigue_index(point);

  if (!wheel_gives_fields(contact)) return;
  AssessedCells cells;
  assess(contact, run, cells);
  damage.peak_power_density = cells.worst.peak_power_density;
  damage.local_fatigue_index = cells.worst.fatigue_index;
}

Fault region_temperature(Contact& contact, std::int32_t index, const BulkTemperatures& bulk,
                         TemperatureNumbers& temperature) {
  if (!wheel_gives_fields(contact))
    return {.status = WRC_ERROR_UNSUPPORTED,
            .field = "index",
            .cause = "whole patches rolled: their strips have no power"};
  heat(contact, strips_of(kept_strips(contact), contact.wheel.wrench.region[index]), bulk, temperature);
  return {};
}

bool wheel_gives_fields(const Contact& contact) { return kept_strips(contact).by_region == 0.0; }

std::int32_t region_strip_count(const Contact& contact, std::int32_t index) {
  return strips_of(kept_strips(contact), contact.wheel.wrench.region[index]).count;
}

std::int32_t region_face(const Contact& contact, std::int32_t index) {
  const VaryingRail& rail = contact.model->surface->varying;
  const std::int32_t strip = contact.wheel.wrench.region[index].first;
  std::int32_t face = 0;
  while (face + 1 < rail.faces && strip >= rail.face[face + 1].first) ++face;
  return face;
}

void region_field(Contact& contact, std::int32_t index, RegionField field, double* values) {
  const Model& model = *contact.model;
  const KeptStrips& kept = kept_strips(contact);
  const Run run = strips_of(kept, contact.wheel.wrench.region[index]);
  const MarchGrid& grid = model.march_grid;
  const auto of_strips = [&](auto&& value) {
    for (std::int32_t k = 0; k < run.count; ++k) values[k] = value(run.first + k);
  };
  const auto of_cells = [&](auto&& value) {
    for (std::int32_t i = 0; i < grid.cells; ++i)
      for (std::int32_t k = 0; k < run.count; ++k) values[i * run.count + k] = value(i, run.first + k);
  };
  switch (field) {
    case RegionField::x:
      return of_cells([&](std::int32_t i, std::int32_t k) { return cell_x(contact, kept, i, k); });
    case RegionField::pressure:
      return of_cells([&](std::int32_t i, std::int32_t k) {
        return kept.factor * kept.peak[k] * grid.middles.pressure[i];
      });
    case RegionField::strip_s:
      return of_strips([&](std::int32_t k) { return kept.place[k]; });
    case RegionField::strip_width:
      return of_strips([&](std::int32_t k) { return kept.width[k]; });
    case RegionField::strip_centre:
      return of_strips([&](std::int32_t k) { return kept.x + kept.centre[k]; });
    case RegionField::strip_half:
      return of_strips([&](std::int32_t k) { return kept.half_length[k]; });
    case RegionField::strip_peak:
      return of_strips([&](std::int32_t k) { return kept.factor * kept.peak[k]; });
    case RegionField::strip_friction:
      return of_strips([&](std::int32_t k) { return kept.friction[k]; });
    case RegionField::strip_y:
      return of_strips([&](std::int32_t k) { return kept.y[k]; });
    case RegionField::strip_z:
      return of_strips([&](std::int32_t k) { return kept.z[k]; });
    case RegionField::strip_angle:
      return of_strips([&](std::int32_t k) { return kept.angle[k]; });
    default:
      break;
  }

  const std::int32_t all = run.count * grid.cells;
  if (field <= RegionField::slip_y) {
    const KeptFields cells = fields_of(contact, run);
    const double* const each[] = {cells.traction_x, cells.traction_y, cells.slip_x, cells.slip_y};
    std::copy_n(each[static_cast<int>(field) - static_cast<int>(RegionField::traction_x)], all, values);
    return;
  }
  if (field == RegionField::temperature_rise) {
    TemperatureNumbers beside;
    std::copy_n(heat(contact, run, {}, beside), all, values);
    return;
  }
  AssessedCells cells;
  assess(contact, run, cells);
  if (field == RegionField::strip_power) {
    std::copy_n(cells.strip_power, run.count, values);
  } else {
    std::copy_n(field == RegionField::power_density ? cells.power_density : cells.fatigue_index, all, values);
  }
}

}  // namespace wrc
