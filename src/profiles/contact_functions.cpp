#include "profiles/contact_functions.hpp"

#include <cmath>
#include <new>

#include "base/elementary.hpp"
#include "base/number.hpp"
#include "contact/wheel.hpp"
#include "geometry/contact_search.hpp"
#include "geometry/silhouette.hpp"

namespace wrc::profiles {
namespace {

/// Undeformed bodies: each wheel touches in its one lowest point. Fills places and the height of the
/// wheelset's middle at which each side touches.
struct Rigid {
  const contact::Model& model;
  double close = 1e-13;  ///< tolerance of the heights' difference [m]

  Fault touch(geometry::Side side, double lateral, double roll, RollingPlace& place, double& height) const {
    // the one lowest point; z down, so that its vertical gap is the height at which the wheel touches
    const contact::Bodies& bodies = model.bodies[static_cast<int>(side)];
    geometry::ContactPoint point;
    std::int32_t found = 0;
    const Fault fault = geometry::find_contact(
        bodies.rail, geometry::posed(bodies.wheel, {.lateral = lateral, .roll = roll}), 1, &point, found);
    if (fault.failed()) return fault;
    place = {.radius = point.rolling_radius,
             .angle = -bodies.rail.outward * point.angle,
             .y_wheel = point.y_wheel,
             .y_rail = point.y_rail};
    height = point.vertical_gap;
    return fault;
  }
};

/// A contact's memory, given back.
class HeapContact {
 public:
  HeapContact(const contact::Model& model, geometry::Side side)
      : memory_(::operator new(contact::contact_bytes(model), alignment)),
        contact_(&contact::make_contact(model, side, memory_)) {}
  HeapContact(const HeapContact&) = delete;
  HeapContact& operator=(const HeapContact&) = delete;
  ~HeapContact() { ::operator delete(memory_, alignment); }
  contact::Contact& operator*() { return *contact_; }

 private:
  static constexpr std::align_val_t alignment{contact::block_alignment};
  void* memory_;
  contact::Contact* contact_;
};

/// Elastic bodies under a load on each wheel, without friction.
struct Elastic {
  const contact::Model& model;
  double load;
  double close = 4e-12;  ///< loads are met to 1e-8
  HeapContact contacts[2] = {{model, geometry::Side::right}, {model, geometry::Side::left}};

  Fault touch(geometry::Side side, double lateral, double roll, RollingPlace& place, double& height) {
    // the wheelset's middle displaced and rolled, at the height that carries the load
    contact::HostWheel hosted;
    hosted.y = lateral;
    const SineCosine turned = sine_cosine(roll);
    const double rotation[3][3] = {
        {1, 0, 0}, {0, turned.cosine, -turned.sine}, {0, turned.sine, turned.cosine}};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) hosted.rotation[i][k] = rotation[i][k];
    hosted.load_prescribed = true;
    hosted.vertical_load = load;
    contact::Contact& contact = *contacts[static_cast<int>(side)];
    const Fault fault = contact::solve_wheel(contact, hosted);
    if (fault.failed()) return fault;
    const contact::HostWrench& result = contact.wheel;
    // means over the regions, weighted by the normal forces they carry
    place = {};
    double carried = 0.0;
    for (std::int32_t i = 0; i < result.wrench.regions; ++i) {
      const double weight = result.wrench.region[i].normal_force;
      carried += weight;
      place.radius += weight * (model.options.wheelset.nominal_radius + result.place[i].z_wheel);
      place.y_wheel += weight * result.place[i].y_wheel;
      place.y_rail += weight * result.place[i].y_rail;
    }
    for (double* const mean : {&place.radius, &place.y_wheel, &place.y_rail}) *mean /= carried;
    // contact angle: that of the force across the track, frictionless
    const double outward = side == geometry::Side::right ? 1.0 : -1.0;
    place.angle = -outward * arctangent(result.wrench.force[1] / -result.wrench.force[2]);
    height = result.wrench.height;
    return fault;
  }
};

/// Search of the roll at which both sides give one height of the wheelset's middle. The height of the right
/// side less that of the left falls with the roll: on the treads by `base` per radian, on a flange slowly, as
/// the roll also moves the wheel sideways. Doubled steps until the difference changes its sign, then secants
/// that keep both ends (Illinois).
class RollSearch {
 public:
  explicit RollSearch(double base) : base_(base) {}

  /// Where to look after `roll`, at which the heights are `apart`.
  double next(double roll, double apart) {
    // Illinois: an end that stays twice in a row counts half
    const bool too_low = apart > 0.0;
    End& here = too_low ? low_ : high_;
    End& there = too_low ? high_ : low_;
    if (here.known && there.known && here.last) there.value *= 0.5;
    here = {roll, apart, true, true};
    there.last = false;
    // no sign change yet: as far as the treads say, and further each time
    if (!there.known) {
      step_ = 2.0 * larger(step_, std::abs(apart) / base_);
      return roll + std::copysign(smaller(0.6 * step_, 0.01), apart);
    }
    return here.roll + here.value * (there.roll - here.roll) / (here.value - there.value);
  }

  /// Nothing is left between the rolls.
  bool exhausted() const { return low_.known && high_.known && high_.roll - low_.roll < 1e-15; }

 private:
  struct End {
    double roll = 0.0, value = 0.0;
    bool known = false, last = false;
  };
  double base_, step_ = 0.0;
  End low_, high_;
};

template <class Bodies>
Fault settle(Bodies& bodies, double base, double lateral, SettledWheelset& settled) {
  constexpr int most_steps = 60;
  constexpr double most_roll = 0.1;  // [rad]
  RollSearch search(base);
  double roll = settled.roll;
  for (int n = 0; n < most_steps; ++n) {
    // height at which each wheel touches, at this roll
    double height[2] = {};
    for (const geometry::Side side : {geometry::Side::right, geometry::Side::left}) {
      const int k = static_cast<int>(side);
      const Fault fault = bodies.touch(side, lateral, roll, settled.side[k], height[k]);
      if (fault.failed()) return fault;
    }
    settled.roll = roll;
    settled.vertical = 0.5 * (height[0] + height[1]);
    const double apart = height[0] - height[1];
    if (std::abs(apart) < bodies.close || search.exhausted()) return {};
    roll = search.next(roll, apart);
    if (!(std::abs(roll) < most_roll))
      return Fault::gap("problem.lateral", {lateral, "m"},
                        "no roll of the wheelset brings both wheels onto their rails");
  }
  return Fault::iteration_cap("roll");
}

template <class Bodies>
Fault settle_all(Bodies&& bodies, const contact::Model& model, std::uint32_t count, const double* lateral,
                 SettledWheelset* settled) {
  // each displacement begins with the roll of the one before
  const double base = 2.0 * model.bodies[static_cast<int>(geometry::Side::right)].wheel.origin_y;
  Fault worst;
  for (std::uint32_t i = 0; i < count; ++i) {
    settled[i] = {};
    settled[i].roll = i > 0 ? settled[i - 1].roll : 0.0;
    Fault fault = settle(bodies, base, lateral[i], settled[i]);
    if (fault.status != WRC_OK) fault.index = static_cast<std::int32_t>(i);
    keep_worst(worst, fault);
    if (worst.failed()) break;
  }
  return worst;
}

}  // namespace

Fault settle_wheelset(const contact::Model& model, double load, std::uint32_t count, const double* lateral,
                      SettledWheelset* settled) {
  return load > 0.0 ? settle_all(Elastic{model, load}, model, count, lateral, settled)
                    : settle_all(Rigid{model}, model, count, lateral, settled);
}

}  // namespace wrc::profiles
