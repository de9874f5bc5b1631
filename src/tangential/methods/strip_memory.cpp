#include "tangential/methods/strip_memory.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "tangential/methods/strip_fastsim.hpp"

namespace wrc::tangential {
namespace {

constexpr std::int32_t cells = 16;                           // along a strip
constexpr std::int32_t most_steps = 8;                       // that one is made in
constexpr double all_remembered = 2.0, all_forgotten = 6.0;  // steps, in lengths of the patch
constexpr double least_step = 1e-9;                          // the same: less is none
constexpr double least = 1e-290;                             // keeps divisions finite

// S G sqrt(ab) = compliance (a / b)^-slenderness_power [-], S the compliance of the half-spaces as a whole.
// By Mindlin the compliance of a circle that sticks is 0.43 / (G a) in all.
constexpr double compliance_x = 0.23, compliance_y = 0.205, slenderness_power = 0.2;

/// Tractions of the march [Pa].
struct Traction {
  double x = 0.0, y = 0.0;  ///< the part that grows evenly over the strip
  double spin = 0.0;        ///< lateral, the part k u v
};

Traction operator+(const Traction& p, const Traction& q) { return {p.x + q.x, p.y + q.y, p.spin + q.spin}; }
Traction operator*(double f, const Traction& p) { return {f * p.x, f * p.y, f * p.spin}; }

/// Memory of a strip.
struct PastStrip {
  double y, centre, half_length;  ///< [m]
  double fx, fy;                  ///< its force, by the memory's cells [N]
  double creep_x, creep_y;        ///< dU/dq of its patch [-]
  Traction traction[cells];       ///< at the middles of its cells, from the leading edge on
};

struct Memory {
  std::int64_t capacity;  ///< strips
  std::int64_t present;   ///< the list of the two behind that is remembered; the other is being written
  std::int64_t count;     ///< strips of the list that is remembered
  std::int64_t written;   ///< strips of the other list
  double mean[cells];     ///< mean of sqrt(1 - s^2) over each cell; zero before the first step

  PastStrip* list(std::int64_t which) { return reinterpret_cast<PastStrip*>(this + 1) + which * capacity; }
};
static_assert(sizeof(PastStrip) == (7 + 3 * cells) * sizeof(double), "no padding: its bytes are saved");

/// A strip in this step; y as remembered.
struct Strip {
  double y, centre, half_length, width;
  double limit;              ///< mu times the peak pressure [Pa]
  double gx, gy, curvature;  ///< even growth of adhesion tractions [Pa/m], k [Pa/m^2]
  double wx, wy, spin;       ///< slip at its middle [-], and its growth along y with x [1/m]
  double elastic, bound;     ///< StripMarch's, by the strip's share of friction
  double y_moment;           ///< y about the origin of the creepages [m]

  double cell() const { return 2.0 * half_length / cells; }
  double lead() const { return centre + half_length; }
  double trail() const { return centre - half_length; }
  double middle(std::int32_t i) const { return lead() - (i + 0.5) * cell(); }
  double tau(double x) const { return std::max(0.0, bound * (x - trail()) * (lead() - x)); }
};

/// Forces [N] and moment [N m], slopes of the forces against a creepage of the whole step [N], power of the
/// slip over the rolling speed [N].
struct Sum {
  double fx = 0.0, fy = 0.0, mz = 0.0, stiff_x = 0.0, stiff_y = 0.0, power = 0.0;

  void add(const Sum& s) {
    fx += s.fx;
    fy += s.fy;
    mz += s.mz;
    stiff_x += s.stiff_x;
    stiff_y += s.stiff_y;
    power += s.power;
  }
};

struct Direction {
  double x, y;
};

Direction unit(double x, double y) {
  const double size = std::sqrt(x * x + y * y);
  return size > 0.0 ? Direction{x / size, y / size} : Direction{0.0, 0.0};
}

/// Direction of a slipping traction that was along e at the beginning of a path over which the bound was
/// `tau`: the angle between it and minus the slip falls as in march.hpp.
Direction turned(const Strip& s, const StripMarch& m, double x, double path, double tau, Direction e) {
  // rigid and elastic slip w, z = path |w| / (flexibility tau), and tan(d/2) over 1 + z + z^2/2, d the angle
  // to -w
  const double from_middle = x - s.centre;
  const double wx = s.wx + s.elastic * from_middle * e.x;
  const double wy = s.wy + (s.spin - s.elastic * e.y) * from_middle;
  const double w = std::sqrt(wx * wx + wy * wy);
  if (!(w > 0.0)) return e;
  const double flexibility = m.turn_x * (1.0 - e.x * e.x) + m.turn_y * (1.0 - e.y * e.y);
  const double z = std::min(path * w / std::max(flexibility * tau, least), 1e6);
  const Direction against{-wx / w, -wy / w};
  const double along = e.x * against.x + e.y * against.y, across = against.x * e.y - against.y * e.x;
  constexpr double opposite = 1e-12;  // a direction straight along the slip stays where it is
  if (1.0 + along < opposite) return e;
  const double half = across / ((1.0 + along) * (1.0 + z + 0.5 * z * z));
  const double per = 1.0 / (1.0 + half * half);
  const double cosine = (1.0 - half * half) * per, sine = 2.0 * half * per;
  return {against.x * cosine - against.y * sine, against.y * cosine + against.x * sine};
}

/// Direction of the traction of a particle that slips at x, having come over `path` with (before_x, before_y)
/// and with (px, py) if it had stuck: that of the onset of slip, or the turned one if it has slipped on all
/// of the path, and between these in proportion to how near the bound the traction was before.
Direction slipping(const Strip& s, const StripMarch& m, double x, double path, double before_x,
                   double before_y, double px, double py) {
  const Direction onset = unit(px, py);
  const double tau_before = s.tau(x + path), held = std::sqrt(before_x * before_x + before_y * before_y);
  constexpr double nearly = 0.9;
  const double slipped = std::clamp((held / std::max(tau_before, least) - nearly) / (1.0 - nearly), 0.0, 1.0);
  if (!(slipped > 0.0 && held > 0.0)) return onset;
  const Direction last =
      turned(s, m, x + 0.5 * path, path, 0.5 * (s.tau(x) + tau_before), {before_x / held, before_y / held});
  return unit(onset.x + slipped * (last.x - onset.x), onset.y + slipped * (last.y - onset.y));
}

/// Share t at which slip set in: |c / t + (0, psi)| = 1, at most 1; 0: nowhere.
double onset_share(double cx, double cy, double psi) {
  const double c2 = cx * cx + cy * cy, across = cy * psi, rest = 1.0 - psi * psi;
  const double root = std::sqrt(std::max(0.0, across * across + rest * c2));
  const double numerator = across > 0.0 ? across + root : c2,
               denominator = across > 0.0 ? rest : root - across;
  if (!(denominator > 0.0)) return c2 > 0.0 ? 1.0 : 0.0;
  return std::min(1.0, numerator / denominator);
}

/// Brings a particle with tractions p over `path` to x; adds its cell, whose pressure is `pressure` times the
/// peak, to the sum.
Traction roll(const Strip& s, const StripMarch& m, double x, double pressure, double path, Traction p,
              Sum& sum) {
  // traction if it sticks: grown by g over the path, and by k u v of spin, whose growth changes along it
  const double before_x = p.x, before_y = p.y + p.spin;
  p.x -= s.gx * path;
  p.y -= s.gy * path;
  p.spin -= 2.0 * s.curvature * (x + 0.5 * path - s.centre) * path;
  const double px = p.x, py = p.y + p.spin, tau = s.tau(x);
  const double load = s.limit * pressure * s.width * s.cell();
  double x_share, y_share;
  if (px * px + py * py > tau * tau) {
    // Slip: on the bound B u v, spin's part as in steady rolling, the rest even growth.
    const Direction e = slipping(s, m, x, path, before_x, before_y, px, py);
    p.spin = -s.curvature * (x - s.trail()) * (s.lead() - x);
    p.x = tau * e.x;
    p.y = tau * e.y - p.spin;
    x_share = e.x;
    y_share = e.y;
    // The traction it lacks, (p if it had stuck) - tau e, over its growth with the creepage is the distance
    // slid; dissipated against the friction at the middle of the path.
    if (path > 0.0) {
      const double place = (x + 0.5 * path - s.centre) / s.half_length;
      const double half_way = s.limit * std::sqrt(std::max(0.0, 1.0 - place * place)) * s.width * s.cell();
      const double slid = e.x * (px - tau * e.x) / m.gx_by_nu_x + e.y * (py - tau * e.y) / m.gy_by_nu_y;
      sum.power += half_way * slid / path;
    }
  } else {
    // Stick: p / (mu p_n) = psi + c / (1 + sqrt(1 - t)), within the bound, and its slope against creepages.
    const double per_tau = 1.0 / std::max(tau, least);
    const double cx = p.x * per_tau, cy = p.y * per_tau, psi = p.spin * per_tau;
    const double share = 1.0 / (1.0 + std::sqrt(1.0 - onset_share(cx, cy, psi)));
    x_share = share * cx;
    y_share = share * cy + psi;
    const double size = std::sqrt(x_share * x_share + y_share * y_share);
    if (size > 1.0) {
      x_share /= size;
      y_share /= size;
    }
    const double stiffness = load * per_tau * share * path;
    sum.stiff_x += stiffness * m.gx_by_nu_x;
    sum.stiff_y += stiffness * m.gy_by_nu_y;
  }
  sum.fx += load * x_share;
  sum.fy += load * y_share;
  sum.mz += load * (x * y_share - s.y_moment * x_share);
  return p;
}

/// Tractions at a distance v behind the leading edge of a remembered strip, by the parabola through three
/// cells, or through two and zero at the edge; zero outside of it.
Traction remembered(const PastStrip& past, double v) {
  if (v <= 0.0 || v >= 2.0 * past.half_length) return {};
  const double at = std::min(v * cells / (2.0 * past.half_length) - 0.5, cells - 1.0);
  if (at < 1.0) {
    return (2.0 * (at + 0.5) * (1.0 - at)) * past.traction[0] + ((at + 0.5) * at / 1.5) * past.traction[1];
  }
  const std::int32_t i = std::min(static_cast<std::int32_t>(at), cells - 2);
  const double g = at - i;
  return (0.5 * g * (g - 1.0)) * past.traction[i - 1] + (1.0 - g * g) * past.traction[i] +
         (0.5 * g * (g + 1.0)) * past.traction[i + 1];
}

/// Origin of a particle: distance rolled in contact, and its traction at the beginning of it.
struct Departure {
  double path;
  Traction traction;
};

/// Origin of the particle that is at x now, over a step h; the leading edge moves evenly from where it was.
/// Without a strip it was beside the contact.
Departure departure(const PastStrip* past, const Strip& s, double x, double h) {
  // Behind the old leading edge: in contact all the time. Ahead of it: in contact since it met the edge,
  // which closes the distance -behind at the rate `closing` per step.
  if (past == nullptr) return {std::min(h, s.lead() - x), {}};
  const double lead = past->centre + past->half_length, behind = lead - (x + h);
  if (behind > 0.0) return {h, remembered(*past, behind)};
  const double closing = h + s.lead() - lead;
  return {closing > 0.0 ? h * (1.0 - std::clamp(-behind / closing, 0.0, 1.0)) : 0.0, {}};
}

/// The remembered strips beside a place, and the share of the second.
struct Neighbours {
  const PastStrip *first = nullptr, *second = nullptr;
  double share = 0.0;
};

Neighbours neighbours(const PastStrip* past, std::int64_t count, double y) {
  // the nearest on either side; beyond the last one that alone
  Neighbours n;
  for (std::int64_t k = 0; k < count; ++k) {
    const PastStrip*& side = past[k].y <= y ? n.first : n.second;
    if (side == nullptr || std::abs(past[k].y - y) < std::abs(side->y - y)) side = &past[k];
  }
  if (n.first && n.second) {
    n.share = (y - n.first->y) / (n.second->y - n.first->y);
  } else if (n.second) {
    n.first = n.second;
    n.second = nullptr;
  }
  return n;
}

Departure departure(const Neighbours& from, const Strip& s, double x, double h) {
  const Departure one = departure(from.first, s, x, h);
  if (from.second == nullptr) return one;
  const Departure other = departure(from.second, s, x, h);
  return {one.path + from.share * (other.path - one.path),
          (1.0 - from.share) * one.traction + from.share * other.traction};
}

/// A patch during a step.
class PatchStep {
 public:
  PatchStep(const RollingContact& contact, Memory& memory);

  /// Rolls the memory on by h; `first`: from the list remembered, else from the strips this patch has
  /// written.
  void step(double h, bool first, Fault& fault);

  /// The same cells in steady rolling; with `keep`, they are written.
  Sum steady(const StripMarch& march, bool keep);

  void set_creep(double share);  ///< the contact's creepages, with a share of dU/dq
  void forget_creep() { creep_x_ = creep_y_ = 0.0; }
  void finish();

  const RollingContact& contact() const { return contact_; }
  const Sum& sum() const { return sum_; }
  double length() const { return length_; }

 private:
  Strip strip(const StripMarch& m, std::int32_t j) const;
  Sum pass(const StripMarch& m, double h, bool first, bool keep);
  void describe(const Strip& s, const Sum& own, PastStrip& to) const;

  RollingContact contact_;
  Creepage rigid_;
  Memory& memory_;
  PastStrip* written_;
  double length_ = 0.0;                   // length of the longest strip [m]
  double creep_x_ = 0.0, creep_y_ = 0.0;  // dU/dq
  Sum sum_;                               // at the end of the last step
};

PatchStep::PatchStep(const RollingContact& contact, Memory& memory)
    : contact_(contact),
      rigid_(contact.creepage),
      memory_(memory),
      written_(memory.list(1 - memory.present) + memory.written) {
  // the patch's width in the coordinate of the memory, and its longest strip
  const patch::Strips& region = contact.region;
  double low = 0.0, high = 0.0;
  for (std::int32_t j = 0; j < region.count; ++j) {
    length_ = std::max(length_, 2.0 * region.half_length[j]);
    const double y = contact.memory.y(region.y[j]), half = 0.5 * region.width[j];
    low = j == 0 ? y - half : std::min(low, y - half);
    high = j == 0 ? y + half : std::max(high, y + half);
  }
  // Forces before, and dU/dq as mean, of the strips remembered within that width: the patch's past.
  const PastStrip* const past = memory.list(memory.present);
  double strips = 0.0;
  for (std::int64_t k = 0; k < memory.count; ++k) {
    if (past[k].y < low || past[k].y > high) continue;
    sum_.fx += past[k].fx;
    sum_.fy += past[k].fy;
    creep_x_ += past[k].creep_x;
    creep_y_ += past[k].creep_y;
    strips += 1.0;
  }
  if (strips > 0.0) {
    creep_x_ /= strips;
    creep_y_ /= strips;
  }
}

Strip PatchStep::strip(const StripMarch& m, std::int32_t j) const {
  const patch::Strips& region = contact_.region;
  const Creepage& c = contact_.creepage;
  const double y = region.y[j], centre = region.centre[j], share = contact_.friction.share(j);
  return {.y = contact_.memory.y(y),
          .centre = centre,
          .half_length = region.half_length[j],
          .width = region.width[j],
          .limit = contact_.friction[j] * region.peak[j],
          .gx = m.gx_constant - m.gx_by_y * y,
          .gy = m.gy_constant + m.gy_by_x * centre,
          .curvature = 0.5 * m.gy_by_x,
          .wx = c.longitudinal - c.spin * y,
          .wy = c.lateral + c.spin * centre + m.torsion,
          .spin = c.spin,
          .elastic = m.elastic * share,
          .bound = m.bound * share,
          .y_moment = y};
}

void PatchStep::describe(const Strip& s, const Sum& own, PastStrip& to) const {
  to.y = s.y;
  to.centre = s.centre;
  to.half_length = s.half_length;
  to.fx = own.fx;
  to.fy = own.fy;
}

Sum PatchStep::pass(const StripMarch& m, double h, bool first, bool keep) {
  Sum sum;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const Strip s = strip(m, j);
    PastStrip& to = written_[j];
    const Neighbours from =
        first ? neighbours(memory_.list(memory_.present), memory_.count, s.y) : Neighbours{&to, nullptr, 0.0};
    Sum own;
    // From the trailing edge on: a particle comes from cells ahead of its own.
    for (std::int32_t i = cells; i-- > 0;) {
      const double x = s.middle(i);
      const Departure d = departure(from, s, x, h);
      const Traction p = roll(s, m, x, memory_.mean[i], d.path, d.traction, own);
      if (keep) to.traction[i] = p;
    }
    if (keep) describe(s, own, to);
    sum.add(own);
  }
  return sum;
}

void PatchStep::set_creep(double share) {
  contact_.creepage.longitudinal = rigid_.longitudinal + share * creep_x_;
  contact_.creepage.lateral = rigid_.lateral + share * creep_y_;
}

// dU/dq = S (F - F_before) / h is solved with the forces' own slope, in one step from the dU/dq before: exact
// where all sticks.
void PatchStep::step(double h, bool first, Fault& fault) {
  // One pass at the dU/dq before gives forces and their slopes; then the pass that counts.
  set_creep(1.0);
  StripMarch m = strip_march(contact_, contact_.creepage, fault);
  if (h > 0.0) {
    const Sum tried = pass(m, h, first, false);
    const double scale = natural_exp(-slenderness_power * natural_log(m.a / m.b)) /
                         (contact_.shear_modulus * std::sqrt(m.a * m.b) * h);
    const auto solve = [&](double compliance, double force, double before, double stiffness, double& creep) {
      creep = (compliance * scale * (force - before + stiffness * creep)) /
              (1.0 + compliance * scale * stiffness);
    };
    solve(compliance_x, tried.fx, sum_.fx, tried.stiff_x, creep_x_);
    solve(compliance_y, tried.fy, sum_.fy, tried.stiff_y, creep_y_);
    set_creep(1.0);
    m = strip_march(contact_, contact_.creepage, fault);
  }
  sum_ = pass(m, h, first, true);
}

Sum PatchStep::steady(const StripMarch& m, bool keep) {
  // from the leading edge on, half a cell to the first middle; a particle's past is the cell ahead
  Sum sum;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const Strip s = strip(m, j);
    Sum own;
    Traction p;
    for (std::int32_t i = 0; i < cells; ++i) {
      p = roll(s, m, s.middle(i), memory_.mean[i], (i == 0 ? 0.5 : 1.0) * s.cell(), p, own);
      if (keep) written_[j].traction[i] = p;
    }
    if (keep) describe(s, own, written_[j]);
    sum.add(own);
  }
  return sum;
}

void PatchStep::finish() {
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    written_[j].creep_x = creep_x_;
    written_[j].creep_y = creep_y_;
  }
  memory_.written += contact_.region.count;
}

Memory& memory_at(void* memory) { return *static_cast<Memory*>(memory); }

}  // namespace

std::size_t strip_memory_bytes(std::int32_t strips) {
  return sizeof(Memory) + 2 * static_cast<std::size_t>(strips) * sizeof(PastStrip);
}

void make_strip_memory(std::int32_t strips, void* at) {
  memory_at(at) = {};
  memory_at(at).capacity = strips;
}

void begin_step(void* at) {
  Memory& memory = memory_at(at);
  memory.written = 0;
  if (memory.mean[0] > 0.0) return;
  // means of sqrt(1 - s^2) over the cells, by its integral
  const auto integral = [](double s) {
    return 0.5 * (s * std::sqrt(std::max(0.0, 1.0 - s * s)) + arcsine(std::clamp(s, -1.0, 1.0)));
  };
  for (std::int32_t i = 0; i < cells; ++i) {
    const double size = 2.0 / cells;
    memory.mean[i] = (integral(-1.0 + (i + 1) * size) - integral(-1.0 + i * size)) / size;
  }
}

void end_step(void* at) {
  Memory& memory = memory_at(at);
  memory.present = 1 - memory.present;
  memory.count = memory.written;
}

TangentialForces roll_with_memory(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault) {
  // Share of the memory: 1 up to all_remembered lengths rolled, 0 from all_forgotten on.
  PatchStep patch(contact, memory_at(contact.memory.at));
  const double lengths = contact.memory.rolled / std::max(patch.length(), least);
  const double t = std::clamp((lengths - all_remembered) / (all_forgotten - all_remembered), 0.0, 1.0);
  const double share = 1.0 - t * t * (3.0 - 2.0 * t);
  // A long step: the steady method, and cells in steady rolling to be remembered.
  if (!(share > 0.0)) {
    patch.forget_creep();
    patch.steady(strip_march(contact, contact.creepage, fault), true);
    patch.finish();
    return strip_fastsim(contact, fields, fault);
  }
  // The memory rolls on in parts of at most a cell, as far as the number of parts allows.
  const double rolled = lengths < least_step ? 0.0 : contact.memory.rolled;
  const std::int32_t steps = std::clamp(static_cast<std::int32_t>(std::ceil(lengths * cells)), 1, most_steps);
  for (std::int32_t k = 0; k < steps; ++k) patch.step(rolled / steps, k == 0, fault);
  patch.finish();
  // Steady strip FASTSIM at the creepages with dU/dq, plus the memory's cells less the same cells in steady
  // rolling.
  patch.set_creep(share);
  const Sum steady = patch.steady(strip_march(patch.contact(), patch.contact().creepage, fault), false);
  TangentialForces forces = strip_fastsim(patch.contact(), fields, fault);
  forces.fx += share * (patch.sum().fx - steady.fx);
  forces.fy += share * (patch.sum().fy - steady.fy);
  forces.mz += share * (patch.sum().mz - steady.mz);
  if (!(rolled > 0.0)) return forces;  // nothing has slid: the steady rate
  const double before = forces.power_per_speed;
  forces.power_per_speed = std::max(0.0, before + share * (patch.sum().power - steady.power));
  const double scale = before > 0.0 ? forces.power_per_speed / before : 1.0;
  scale_slips(scale, static_cast<std::ptrdiff_t>(contact.grid->cells) * contact.region.count, fields);
  return forces;
}

}  // namespace wrc::tangential
