/// Damage along the line: from the strips of a contact to the bins of its bodies.
#include <algorithm>
#include <cmath>

#include "contact/assessments.hpp"
#include "contact/plane_over.hpp"
#include "contact/stages.hpp"

namespace wrc::contact {
namespace {

constexpr int on_wheel = 0, on_rail = 1;

/// Adds the damage of strips to the bins of both bodies, patch by patch.
class Adder {
 public:
  Adder(const Contact& contact, const Accumulation& accumulation, double speed, double way,
        const damage::DamageBins* wheel, const damage::DamageBins* rail, DamageTotals& totals)
      : distance_(std::abs(speed) * accumulation.duration),
        from_(accumulation.distance - (way < 0.0 ? distance_ : 0.0)),
        wanted_{wheel != nullptr, rail != nullptr},
        bins_{{wheel ? *wheel : damage::DamageBins{}, from_, from_ + distance_},
              {rail ? *rail : damage::DamageBins{}, from_, from_ + distance_}},
        totals_(totals),
        laws_{.wear = accumulation.wear,
              .whole_life = accumulation.whole_life,
              .shear_yield = contact.model->options.shear_yield,
              .wheel_diameter = 2.0 * contact.model->options.wheelset.nominal_radius},
        patch_{.duration = accumulation.duration, .distance = distance_} {}

  /// Begins a patch: `speed` that slips refer to [m/s], and its frictional power [W].
  void begin_patch(double speed, double power) {
    patch_.speed = speed;
    patch_.power = power;
  }

  void take(const damage::DamagingStrip& strip) {
    // One contribution per strip, shared out over the bins that its width and its path cover.
    const damage::Contribution c = damage::contribution_of(strip, patch_, laws_);
    for (const int body : {on_wheel, on_rail})
      if (wanted_[body]) bins_[body].take(c, strip.place[body], strip.width);
    damage::add_share(1.0, c, totals_.sum);
    totals_.largest_pressure = std::max(totals_.largest_pressure, c.pressure);
    totals_.largest_traction = std::max(totals_.largest_traction, c.traction);
  }

  Fault finish() {
    // Both are finished whichever overflows first.
    const bool wheel_fits = bins_[on_wheel].finish(), rail_fits = bins_[on_rail].finish();
    return wheel_fits && rail_fits ? Fault{} : Fault::sum_overflow("accumulation");
  }

 private:
  double distance_, from_;
  bool wanted_[2];
  damage::BinAdder bins_[2];
  DamageTotals& totals_;
  damage::DamageLaws laws_;
  damage::DamagingPatch patch_;
};

/// Resultants of the tractions of `count` strips, up to `chunk` of them, over the area of a cell [Pa];
/// element (cell i, strip j) at i * strips + j.
constexpr std::int32_t chunk = 8;  ///< whose sums stay in registers
void sum_cells(const double* tx, const double* ty, std::int32_t cells, std::int32_t strips,
               std::int32_t count, double (&sum)[chunk]) {
  // Row by row, as cells are stored; a full chunk has a loop of constant length, whose sums stay in
  // registers.
  double x[chunk] = {}, y[chunk] = {};
  const auto add_rows = [&](auto of_them) {
    for (std::int32_t i = 0; i < cells; ++i) {
      const double *const row_x = tx + i * strips, *const row_y = ty + i * strips;
      for (std::int32_t j = 0; j < of_them(); ++j) {
        x[j] += row_x[j];
        y[j] += row_y[j];
      }
    }
  };
  if (count == chunk) {
    add_rows([] { return chunk; });
  } else {
    add_rows([&] { return count; });
  }
  for (std::int32_t j = 0; j < count; ++j) sum[j] = std::sqrt(x[j] * x[j] + y[j] * y[j]);
}

Fault add_stages(Contact& contact, const Accumulation& accumulation, const damage::DamageBins* wheel,
                 const damage::DamageBins* rail, DamageTotals& totals) {
  const Fault fault = tractions_needed(contact, "this method has no tractions: choose another");
  if (fault.failed()) return fault;
  if (!contact.posed)
    return Fault::sequence("contact point",
                           "bins lie on profiles: the stages must begin with wrc_planar_geometry");
  if (fault.status != WRC_OK) return fault;
  if (contact.reached < Stage::damage) assess_damage(contact);
  find_cells(contact);

  // Places of strips by arc length on the right-hand profiles; the left contact plane runs against them.
  const Model& model = *contact.model;
  const Bodies& right = model.bodies[static_cast<int>(geometry::Side::right)];
  PlaneOver plane[2] = {{model.arc[on_wheel], right.wheel.origin_y + contact.point.y_wheel},
                        {model.arc[on_rail], right.rail.origin_y + contact.point.y_rail}};
  const double outward = contact.side == geometry::Side::right ? 1.0 : -1.0;
  const tangential::Creepage& creepage = contact.creepage;
  const std::int32_t cells = model.options.sizes.cells;
  Adder adder(contact, accumulation, contact.rolling.speed, contact.rolling.direction, wheel, rail, totals);
  for (std::int32_t p = 0; p < contact.patches; ++p) {
    // Views of the strips that rolled, and of their cells.
    const Patch& patch = contact.patch[p];
    const std::int32_t first = patch.region_first, count = patch.region_count;
    const auto strips = [&](Array which) { return array(contact, which) + first; };
    const auto fields = [&](Array which) {
      return array(contact, which) + static_cast<std::ptrdiff_t>(first) * cells;
    };
    const double *y = strips(Array::region_y), *width = strips(Array::region_width),
                 *centre = strips(Array::region_centre), *half = strips(Array::region_half_length),
                 *peak = strips(Array::region_peak), *power = strips(Array::strip_power),
                 *friction = strips(Array::strip_friction);
    const double *tx = fields(Array::traction_x), *ty = fields(Array::traction_y);
    // Power of the patch [W] from that of its strips per width.
    double whole_power = 0.0;
    for (std::int32_t j = 0; j < count; ++j) whole_power += power[j] * width[j];
    adder.begin_patch(contact.rolling.speed, whole_power);
    double traction[chunk];
    std::int32_t summed =
        0;  // first strip of the chunk in `traction`; the last chunk is whole, too, if it can be
    for (std::int32_t j = 0; j < count; ++j) {
      // Resultant tractions of the next chunk of strips, summed over their cells [Pa].
      if (j % chunk == 0) {
        summed = std::max(std::min(j, count - chunk), 0);
        sum_cells(tx + summed, ty + summed, cells, count, std::min(chunk, count), traction);
      }
      // Sliding speed: V times the rigid slip at the strip's centre, and the mean square of spin along its
      // length, (phi L)^2 / 3.
      const double sx = creepage.longitudinal - creepage.spin * y[j];
      const double sy = creepage.lateral + creepage.spin * centre[j], turning = creepage.spin * half[j];
      adder.take({.place = {plane[on_wheel].arc(outward * y[j]), plane[on_rail].arc(outward * y[j])},
                  .width = width[j],
                  .half_length = half[j],
                  .peak = peak[j],
                  .friction = friction[j],
                  .sliding = contact.rolling.speed * std::sqrt(sx * sx + sy * sy + turning * turning / 3.0),
                  .traction = traction[j - summed] * (2.0 * half[j] / cells * width[j]),
                  .power = power[j] * width[j]});
    }
  }
  return adder.finish();
}

Fault add_wheel_on_rail(const Contact& contact, const Accumulation& accumulation,
                        const damage::DamageBins* wheel, const damage::DamageBins* rail,
                        DamageTotals& totals) {
  if (!contact.wheel_solved) return Fault::sequence("wrench", "call wrc_contact_wrench first");
  const Model& model = *contact.model;
  const surface::StripResults kept = surface_state(contact).kept;
  const auto count = static_cast<std::int32_t>(kept.head->count);
  if (count == 0) return Fault::no_contact();
  const Bodies& right = model.bodies[static_cast<int>(geometry::Side::right)];
  const surface::Wrench& wrench = contact.wheel.wrench;
  Adder adder(contact, accumulation, kept.head->rolling_speed, kept.head->rolling_speed, wheel, rail, totals);
  // Strips come in the order of the rail; a region begins where the one before ends. Beyond the deepest
  // overlap that is solved, forces and power are `factor` times those solved.
  std::int32_t region = -1, end = 0;  // end of the region, in strips of the rail
  std::int32_t wheel_piece = 0, rail_piece = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    const auto j = static_cast<std::int32_t>(kept.strip[k]);
    if (j >= end && region + 1 < wrench.regions) {
      ++region;
      end = wrench.region[region].first + wrench.region[region].count;
      adder.begin_patch(kept.head->speed, wrench.region[region].power);
    }
    const double turning = kept.spin[k] * kept.half_length[k];
    adder.take(
        {.place = {geometry::arc_at(model.arc[on_wheel], right.wheel.origin_y + kept.y_wheel[k], wheel_piece),
                   geometry::arc_at(model.arc[on_rail], right.rail.origin_y + kept.y[k], rail_piece)},
         .width = kept.width[k],
         .half_length = kept.half_length[k],
         .peak = kept.peak[k],
         .friction = kept.friction[k],
         .sliding = kept.head->speed * std::sqrt(kept.slip_x[k] * kept.slip_x[k] +
                                                 kept.slip_y[k] * kept.slip_y[k] + turning * turning / 3.0),
         .traction = kept.head->factor * std::sqrt(kept.fx[k] * kept.fx[k] + kept.fy[k] * kept.fy[k]),
         .power = kept.head->factor * kept.power[k]});
  }
  return adder.finish();
}

}  // namespace

Fault accumulate(Contact& contact, const Accumulation& accumulation, const damage::DamageBins* wheel,
                 const damage::DamageBins* rail, DamageTotals& totals) {
  totals = {};
  return contact.newest == Solution::wheel ? add_wheel_on_rail(contact, accumulation, wheel, rail, totals)
                                           : add_stages(contact, accumulation, wheel, rail, totals);
}

}  // namespace wrc::contact
