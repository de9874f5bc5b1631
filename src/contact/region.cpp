#include "contact/region.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "contact/plane_over.hpp"
#include "contact/rolled_region.hpp"

namespace wrc::contact {
namespace {

/// Direction that is y of the contact axes: along a right-hand rail's arc, against a left-hand one's.
double along_arc(const Contact& contact) { return contact.side == geometry::Side::right ? 1.0 : -1.0; }

/// Arc length where the strips are longest [m]: the vertex of the parabola through the squared half lengths
/// of the longest and of its neighbours, as half lengths of an ellipse have it.
double place_of_longest(const patch::Strips& strips) {
  const auto longest = static_cast<std::int32_t>(
      std::max_element(strips.half_length, strips.half_length + strips.count) - strips.half_length);
  // At an end of the region there is no neighbour to fit with.
  const double here = strips.y[longest];
  if (longest == 0 || longest == strips.count - 1) return here;
  const auto square = [&](std::int32_t k) { return strips.half_length[k] * strips.half_length[k]; };
  const double left = strips.y[longest - 1] - here, right = strips.y[longest + 1] - here;
  // L^2 over y about `here`: slopes of its two chords, and the parabola through all three points.
  const double to_left = (square(longest - 1) - square(longest)) / left,
               to_right = (square(longest + 1) - square(longest)) / right;
  const double bent = (to_right - to_left) / (right - left);  // half the second derivative
  if (!(bent < 0.0)) return here;
  const double slope = to_right - bent * right;
  return here + std::clamp(-0.5 * slope / bent, 0.5 * left, 0.5 * right);
}

/// Extent of a wheel's strips.
patch::StripTotals extent_of(const patch::Strips& strips) {
  // Each strip has a semi-ellipse of pressure: load (pi / 2) width L p0 [N].
  patch::StripTotals extent;
  double front = 0.0, rear = 0.0;
  for (std::int32_t k = 0; k < strips.count; ++k) {
    const double l = strips.half_length[k], width = strips.width[k], peak = strips.peak[k];
    const double leading = strips.centre[k] + l, trailing = strips.centre[k] - l;
    front = k == 0 ? leading : std::max(front, leading);
    rear = k == 0 ? trailing : std::min(rear, trailing);
    extent.area += 2.0 * l * width;
    extent.normal_force += 0.5 * pi * width * l * peak;
    extent.peak_pressure = std::max(extent.peak_pressure, peak);
    const double border = strips.y[k] - 0.5 * width;
    if (k == 0) extent.y_min = border;
    extent.y_max = border + width;
  }
  extent.length = front - rear;
  return extent;
}

/// Share of the area whose cells do not slip.
double adhesion_of(const RolledRegion& rolled) {
  // A cell adheres where its slip is exactly 0; cells of one strip have one area [m^2].
  const std::int32_t strips = rolled.strips.count;
  double sticks = 0.0, area = 0.0;
  for (std::int32_t j = 0; j < strips; ++j) {
    std::int32_t count = 0;
    for (std::int32_t at = j; at < strips * rolled.cells(); at += strips)
      if (rolled.fields.slip_x[at] == 0.0 && rolled.fields.slip_y[at] == 0.0) ++count;
    sticks += count * rolled.cell_area(j);
    area += rolled.cells() * rolled.cell_area(j);
  }
  return area > 0.0 ? sticks / area : 0.0;
}

/// Index of the rail's face that a region is on.
std::int32_t face_of(const Contact& contact, const surface::SurfaceRegion& region) {
  // Strips are numbered face by face.
  const surface::VaryingRail& rail = contact.model->surface->varying;
  std::int32_t face = 0;
  while (face + 1 < rail.faces && surface::on_rail(region.first) >= rail.face[face + 1].first) ++face;
  return face;
}

/// Normal into the rail at an angle about x.
void turn_normal(double sine, double cosine, double (&normal)[3]) {
  normal[0] = 0.0;
  normal[1] = -sine;
  normal[2] = cosine;
}

/// A region of the last solve_wheel().
Fault find_wheel_region(Contact& contact, std::int32_t index, RegionResult& result) {
  const Model& model = *contact.model;
  const surface::SurfaceRegion& region = contact.wheel.wrench.region[index];
  const WheelSums sums = wheel_sums(contact, index);
  const RolledRegion rolled(contact, region);

  // Place: point of the resultant and normal there, in track axes; the same point on both profiles.
  result.placed = result.rolled = true;
  result.strips = rolled.strips.count;
  result.face = face_of(contact, region);
  std::copy_n(region.point, 3, result.point);
  const auto [sine, cosine] = sine_cosine(region.angle);
  turn_normal(sine, cosine, result.normal);
  result.angle = region.angle;
  result.place = contact.wheel.place[index];
  result.rolling_radius = model.options.wheelset.nominal_radius + result.place.z_wheel;

  // Resultants in track axes, and sums of the strips' own in the plane of contact.
  std::copy_n(region.force, 3, result.force);
  std::copy_n(region.moment, 3, result.moment);
  result.extent = sums.extent;
  result.normal_force = region.normal_force;
  result.tangential = sums.forces;
  result.adhesion_known = rolled.fields.any();
  if (result.adhesion_known) result.tangential.adhesion_fraction = adhesion_of(rolled);
  result.creepage = sums.creepage;
  result.rolling_speed = rolled.direction * rolled.speed;
  result.power = region.power;

  // Equivalent double ellipse about the longest strip.
  result.ellipse.joint = place_of_longest(rolled.strips);
  result.ellipse.normal_force = sums.extent.normal_force;
  return patch::regularise(sums.extent, result.ellipse.joint, model.options.regularisation,
                           result.ellipse.sdec);
}

/// The place of a patch: its joint in the contact plane, and over that on both profiles.
void place_patch(const Contact& contact, const Patch& patch, RegionResult& result) {
  const Model& model = *contact.model;
  // The joint lies in the contact plane, y_contact from the contact point.
  const geometry::ContactPoint& origin = contact.point;
  const auto [sine, cosine] = sine_cosine(origin.angle);
  result.placed = true;
  result.point[0] = origin.x;
  result.point[1] = origin.y + cosine * patch.y_contact;
  result.point[2] = origin.z + sine * patch.y_contact;
  turn_normal(sine, cosine, result.normal);
  result.angle = origin.angle;
  // Profiles are kept for the right-hand side: y of a left contact plane counts against theirs.
  const Bodies& right = model.bodies[static_cast<int>(geometry::Side::right)];
  const double y = along_arc(contact) * patch.y_contact;
  PlaneOver on_wheel(model.arc[0], right.wheel.origin_y + origin.y_wheel);
  PlaneOver on_rail(model.arc[1], right.rail.origin_y + origin.y_rail);
  result.place.y_wheel = on_wheel.find(y) - right.wheel.origin_y;
  result.place.z_wheel = on_wheel.z();
  result.place.y_rail = on_rail.find(y) - right.rail.origin_y;
  result.place.z_rail = on_rail.z() - right.rail.origin_z;
  result.rolling_radius = model.options.wheelset.nominal_radius + result.place.z_wheel;
}

/// Force on the wheel and its moment about the joint, from the contact axes to track axes.
void turn_forces(Contact& contact, const Patch& patch, RegionResult& result) {
  // Moment about the joint in contact axes [N m]: pressure p at (x, y) gives -y p about x and x p about y;
  // that of the tractions comes from the origin of the frame to the joint.
  const patch::Strips strips = patch_strips(contact, patch);
  double about[3] = {0.0, 0.0, patch.forces.mz + patch.y_contact * patch.forces.fx};
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double load = 0.5 * pi * strips.width[j] * strips.half_length[j] * strips.peak[j];
    about[0] -= (strips.y[j] - patch.y_contact) * load;
    about[1] += strips.centre[j] * load;
  }
  const double force[3] = {patch.forces.fx, patch.forces.fy, -patch.extent.normal_force};
  // Contact axes are track axes turned about x by the contact angle.
  const double sine = -result.normal[1], cosine = result.normal[2];
  const auto turn = [&](const double(&of_contact)[3], double(&of_track)[3]) {
    of_track[0] = of_contact[0];
    of_track[1] = cosine * of_contact[1] - sine * of_contact[2];
    of_track[2] = sine * of_contact[1] + cosine * of_contact[2];
  };
  turn(force, result.force);
  turn(about, result.moment);
}

/// A patch of the stages, as far as they have gone.
void find_patch(Contact& contact, const Patch& patch, RegionResult& result) {
  // Known since the normal stage; place and track axes need a pose, tractions the tangential stage.
  result.strips = patch.count;
  result.extent = patch.extent;
  result.ellipse = {patch.sdec, patch.y_contact, patch.extent.normal_force};
  result.normal_force = patch.extent.normal_force;
  if (contact.posed && contact.pressed) place_patch(contact, patch, result);
  if (contact.reached < Stage::tangential) return;
  result.rolled = result.adhesion_known = true;
  result.tangential = patch.forces;
  result.creepage = contact.creepage;
  result.rolling_speed = contact.rolling.direction * contact.rolling.speed;
  result.power = patch.forces.power_per_speed * contact.rolling.speed;
  if (result.placed) turn_forces(contact, patch, result);
}

}  // namespace

std::int32_t region_count(const Contact& contact) {
  if (contact.newest == Solution::wheel) return !contact.wheel_solved ? 0 : contact.wheel.wrench.regions;
  return contact.patches;
}

bool has_tractions(const Contact& contact) {
  return contact.newest == Solution::wheel ? surface_state(contact).kept.head->by_region == 0.0
                                           : gives_fields(contact);
}

std::int32_t cells_of_newest(const Contact& contact) {
  const ModelOptions& options = contact.model->options;
  return contact.newest == Solution::wheel ? options.surface_cells : options.sizes.cells;
}

Fault check_region(const Contact& contact, std::int32_t index, bool or_all) {
  const bool wheel = contact.newest == Solution::wheel;
  if (wheel && !contact.wheel_solved) return Fault::sequence("contact", "the last wrc_contact_wrench failed");
  if (!wheel && contact.reached < Stage::patch)
    return Fault::sequence("contact",
                           "nothing has been solved yet: call wrc_contact_wrench or wrc_planar_normal first");
  if (index == all_regions && or_all && !wheel) return {};
  const std::int32_t count = region_count(contact);
  if (index >= 0 && index < count) return {};
  return Fault::range("index", {index, "", 0.0, count - 1.0},
                      count == 0   ? "wheel and rail do not touch: there are no regions"
                      : count == 1 ? "there is one region: its index is 0"
                                   : nullptr);
}

WheelSums wheel_sums(Contact& contact, std::int32_t index) {
  const surface::SurfaceRegion& region = contact.wheel.wrench.region[index];
  const surface::StripResults kept = surface_state(contact).kept;
  const std::int32_t first = strip_run(kept, region).first;
  const RolledRegion rolled(contact, region, false);
  const patch::Strips& strips = rolled.strips;
  WheelSums sums;
  sums.extent = extent_of(strips);
  // Point of the region on the surface laid flat: load-weighted mean of the strips' centres (x, s) [m].
  double x = 0.0, s = 0.0;
  for (std::int32_t k = 0; k < strips.count; ++k) {
    const double share =
        0.5 * pi * strips.width[k] * strips.half_length[k] * strips.peak[k] / sums.extent.normal_force;
    x += share * strips.centre[k];
    s += share * strips.y[k];
  }

  // Forces of the strips, and their moment about that point; on the left the arc runs against y.
  tangential::TangentialForces& forces = sums.forces;
  for (std::int32_t k = 0; k < strips.count; ++k) {
    const double fx = kept.head->factor * kept.fx[first + k], fy = kept.head->factor * kept.fy[first + k];
    forces.fx += fx;
    forces.fy += fy;
    forces.mz +=
        kept.head->factor * kept.mz[first + k] + (strips.centre[k] - x) * fy - (strips.y[k] - s) * fx;
  }
  forces.fy *= along_arc(contact);
  forces.mz *= along_arc(contact);
  forces.power_per_speed = kept.head->speed > 0.0 ? region.power / kept.head->speed : 0.0;
  sums.creepage = {region.creepage[0], region.creepage[1], region.creepage[2]};
  return sums;
}

Fault find_region(Contact& contact, std::int32_t index, RegionResult& region) {
  region = {};
  const Fault fault = check_region(contact, index, false);
  if (fault.status != WRC_OK) return fault;
  region.cells = cells_of_newest(contact);
  if (contact.newest == Solution::wheel) return find_wheel_region(contact, index, region);
  find_patch(contact, contact.patch[index], region);
  return {};
}

}  // namespace wrc::contact
