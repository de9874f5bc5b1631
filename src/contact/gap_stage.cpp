/// Geometry stage: from a pose, or from a gap of the host, to the rows of the undeformed gap.
#include <algorithm>
#include <cmath>

#include "base/flush_subnormals.hpp"
#include "contact/stages.hpp"
#include "geometry/gap_rows.hpp"

namespace wrc::contact {
namespace {

/// Half width of the gap about the contact point: the widest patch of two rails' heads, tread and flange
/// root.
constexpr double gap_half_width = 0.030;  // [m]

/// Depth of the wheel in the rail when the gap is taken [m]: a usual approach. Pressed down
/// vertically, a wheel slides along an inclined contact plane by approach * tan(angle); near the flange a gap
/// taken at first touch is tilted by that, which costs 1 % of the approach. Half of the effect remains where
/// the approach is half of this, or twice.
constexpr double pressed_depth = 80e-6;

/// The wheel where its gap is taken, lowered to first touch and pressed_depth further, and the contact point
/// as the origin of that gap: the wheel is down already.
struct PressedWheel {
  geometry::PosedWheel wheel;
  geometry::ContactPoint origin;

  PressedWheel(const geometry::Wheel& placed, geometry::Pose pose, const geometry::ContactPoint& first_touch)
      : origin(first_touch) {
    // pressed_depth is along the contact normal: pose.vertical moves along z, hence the cosine.
    pose.vertical += first_touch.vertical_gap + pressed_depth / first_touch.cosine;
    wheel = geometry::posed(placed, pose);
    origin.vertical_gap = 0.0;
  }
};

/// Where the first touch jumps across the tread or to the flange, the patch stays behind: its last solution,
/// from which the next normal solve may start, is taken over from the frame of the contact point `before`
/// into the present one. The angle between the two frames does not matter for a start. A contact
/// point that merely moves takes its patch along.
void carry_start_over_jump(Contact& contact, const geometry::ContactPoint& before) {
  if (contact.start_strips == 0) return;
  constexpr double jump = 0.25;  // over the patch's width
  const geometry::ContactPoint& now = contact.point;
  // Movement of the origin along y of the present contact plane [m].
  const double moved = now.cosine * (now.y - before.y) + now.sine * (now.z - before.z);
  double* const y = array(contact, Array::start_y);
  if (std::abs(moved) < jump * (y[contact.start_strips - 1] - y[0])) return;
  for (std::int32_t j = 0; j < contact.start_strips; ++j) y[j] -= moved;
}

}  // namespace

Fault find_gap(Contact& contact, const geometry::Pose& pose) {
  back_to(contact, Stage::none);
  contact.gap_rows = 0;
  const bool was_posed = contact.posed;
  const geometry::ContactPoint before = contact.point;
  contact.posed = false;
  const Model& model = *contact.model;
  if (!model.has_geometry) {
    return Fault::sequence(
        "pose", "the model was made without profiles: hand over a gap, or give config.wheel and config.rail");
  }

  // First touch: the one point where the wheel, lowered, meets the rail.
  std::int32_t found = 0;
  const auto& [placed, rail] = bodies(contact);
  Fault fault = geometry::find_contact(rail, geometry::posed(placed, pose), 1, &contact.point, found);
  if (fault.failed()) return fault;
  if (was_posed && model.options.warm_start) carry_start_over_jump(contact, before);

  // Rows of the gap of the wheel pressed_depth inside the rail, in the plane of first touch.
  const auto [wheel, origin] = PressedWheel(placed, pose, contact.point);
  const geometry::GapWindow window =
      geometry::gap_window(rail, wheel, origin, {model.options.gap_limit, gap_half_width});
  patch::GapRows rows;
  const geometry::GapRowMemory memory{model.options.sizes.gap_rows, array(contact, Array::gap_y),
                                      array(contact, Array::gap_height), array(contact, Array::gap_centre),
                                      array(contact, Array::gap_curvature)};
  keep_worst(fault, geometry::fill_gap_rows(rail, wheel, origin, window, memory.capacity, memory,
                                            *model.kernels, rows));
  if (fault.failed()) return fault;
  // Heights count from first touch again, so that the approach does.
  for (std::int32_t j = 0; j < rows.count; ++j) memory.height[j] += pressed_depth;
  contact.gap_rows = rows.count;
  contact.pose = pose;
  contact.posed = true;
  contact.reached = Stage::gap;
  return fault;
}

geometry::SurfaceGap surface_gap(const Contact& contact) {
  const auto [wheel, origin] = PressedWheel(bodies(contact).wheel, contact.pose, contact.point);
  return {bodies(contact).rail, wheel, origin};
}

Fault find_creepages(const Contact& contact, const geometry::WheelsetMotion& motion,
                     geometry::RigidCreepage& rigid) {
  if (!contact.posed)
    return Fault::sequence("pose", "call wrc_planar_geometry first: creepages belong to its contact point");
  rigid = geometry::creepage(geometry::posed(bodies(contact).wheel, contact.pose), contact.point, motion);
  if (rigid.limited) return Fault::creepages_limited("motion");
  return {};
}

void take_gap(Contact& contact, const patch::GapRows& rows) {
  back_to(contact, Stage::gap);
  contact.posed = false;
  contact.gap_rows = rows.count;
  std::copy_n(rows.y, rows.count, array(contact, Array::gap_y));
  std::copy_n(rows.height, rows.count, array(contact, Array::gap_height));
  // Without centres the parabolas of all rows stand at x = 0.
  if (rows.centre != nullptr) {
    std::transform(rows.centre, rows.centre + rows.count, array(contact, Array::gap_centre),
                   flush_subnormals);
  } else {
    std::fill_n(array(contact, Array::gap_centre), rows.count, 0.0);
  }
  std::copy_n(rows.curvature, rows.count, array(contact, Array::gap_curvature));
}

Fault take_gap(Contact& contact, const patch::GapGrid& grid) {
  // A failure leaves the contact without a gap.
  back_to(contact, Stage::none);
  contact.posed = false;
  contact.gap_rows = 0;
  // Rows are needed accurately where they may touch; a quarter of the depth that matters leaves the rest out
  // of the fit.
  const Fault fault =
      patch::rows_from_grid(grid, 0.25 * contact.model->options.gap_limit, array(contact, Array::gap_height),
                            array(contact, Array::gap_centre), array(contact, Array::gap_curvature));
  if (fault.failed()) return fault;
  std::copy_n(grid.y, grid.rows, array(contact, Array::gap_y));
  contact.gap_rows = grid.rows;
  contact.reached = Stage::gap;
  return fault;
}

}  // namespace wrc::contact
