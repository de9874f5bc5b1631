#include "tangential/methods/strip_memory.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "tangential/methods/strip_fastsim.hpp"

namespace wrc::tangential {
namespace {

constexpr std::int32_t cells = 16;  // along a strip

// Lengths of the longest strip: a part of the step, a step of which nothing before is seen, and one that is
// none.
constexpr double usual_part = 0.25, all_forgotten = 4.0, least_step = 1e-9;
constexpr std::int32_t most_parts = 8;
constexpr std::int32_t solutions = 3;  // Newton's steps for U in each part
constexpr double least = 1e-290;       // keeps divisions finite

/// Fitted factors and lengths (strip_memory.hpp); u2 is the square of (a - b) / (a + b).
namespace fitted {
constexpr double flexibility_x = 1.016, flexibility_y = 0.92;            // factors on L
constexpr double yield_x = 1.015, yield_y = 1.093;                       // factors on S
constexpr double arm(double u2) { return 1.19 + 0.07 * u2; }             // factor on the arms of spin
constexpr double twist(double u2) { return 0.102 * (1.0 - 1.39 * u2); }  // S of spin, of 1 / (G sqrt(ab)^3)
constexpr double exponent = 1.19, exponent_by_yield = 1.93, middle_yield = 0.54;  // m
constexpr double follows = 0.816;  // length over which the difference to strip FASTSIM is added, of a
constexpr double ahead = 2.1;      // yields by which it is taken ahead
}  // namespace fitted

constexpr double kept_back = 0.25;  // least part of the stored energy that can be given back

/// Memory of a strip, of the bodies rolling forwards.
struct PastStrip {
  double y, centre, half_length;  ///< [m]
  double force[3];                ///< its cells': Fx, Fy [N], Mz about the patch's centre [N m]
  double added[3];                ///< its part of the difference to strip FASTSIM, Mz about the origin
  double energy;                  ///< it could give back [J]
  double px[cells], py[cells];    ///< tractions of its cells, from the largest x on [Pa]
};

/// A strip's cells as a part of the step brings them, before they take their displacement.
struct Brought {
  double px[cells], py[cells];  ///< tractions [Pa]
  double share[cells];          ///< share of the part for which the cell was in contact
};

struct Memory {
  std::int64_t capacity;  ///< strips
  std::int64_t present;   ///< the list of the two behind that is remembered; the other is being written
  std::int64_t count;     ///< strips of the list that is remembered
  std::int64_t written;   ///< strips of the other list

  PastStrip* list(std::int64_t which) { return reinterpret_cast<PastStrip*>(this + 1) + which * capacity; }
  Brought* brought() { return reinterpret_cast<Brought*>(list(2)); }
};
static_assert(sizeof(PastStrip) == (10 + 2 * cells) * sizeof(double), "no padding: its bytes are saved");

/// Yield at rest of an ellipse whose surfaces stick, Cattaneo's and Mindlin's: displacement over force along
/// x and y [m/N]. Int R dt and Int R cos^2 t dt, R the radius, are complete elliptic integrals, by the
/// arithmetic-geometric mean.
struct Yield {
  double x, y;
};

Yield yield_at_rest(double a, double b, double shear_modulus, double poisson) {
  const double longer = std::max(a, b), shorter = std::min(a, b);
  // K and (K - E) / e^2 of the eccentricity e
  double mean = 1.0, root = shorter / longer, square = std::max(0.0, 1.0 - root * root);
  double weight = 0.5, sum = 0.5;
  const double e2 = std::max(square, least);
  for (int k = 0; k < 6; ++k) {
    const double next = 0.5 * (mean + root);
    root = std::sqrt(mean * root);
    mean = next;
    const double difference = square / (4.0 * next);
    square = difference * difference;
    weight *= 2.0;
    sum += weight * (square / e2);
  }
  const double K = 0.5 * pi / mean;
  const double all = 4.0 * shorter * K, along_longer = all * sum, along_shorter = all - along_longer;
  const double scale = 1.0 / (4.0 * shear_modulus * pi * a * b);
  const double along_x = a >= b ? along_longer : along_shorter;
  return {scale * ((1.0 - poisson) * all + poisson * along_x),
          scale * ((1.0 - poisson) * all + poisson * (all - along_x))};
}

/// Cells of a strip and their weights in the traction at a place: straight lines from cell to cell and to the
/// edges; none outside.
struct Interpolation {
  std::int32_t first = 0;
  double weight[2] = {};

  /// `v`: distance behind the leading edge.
  Interpolation(double half_length, double v) {
    if (v <= 0.0 || v >= 2.0 * half_length) return;
    const double at = v * cells / (2.0 * half_length) - 0.5;
    if (at < 0.0) {
      weight[0] = 1.0 + 2.0 * at;
    } else if (at > cells - 1.0) {
      first = cells - 2;
      weight[1] = 1.0 - 2.0 * (at - (cells - 1.0));
    } else {
      first = std::min(static_cast<std::int32_t>(at), cells - 2);
      weight[1] = at - first;
      weight[0] = 1.0 - weight[1];
    }
  }
  double of(const double* p) const { return weight[0] * p[first] + weight[1] * p[first + 1]; }
};

/// A past strip as the bodies roll now: backwards it is the mirror image.
PastStrip turned(const PastStrip& strip, double direction) {
  PastStrip s = strip;
  if (direction > 0.0) return s;
  s.centre = -s.centre;
  for (double* three : {s.force, s.added}) {
    three[0] = -three[0];
    three[2] = -three[2];
  }
  std::reverse(s.px, s.px + cells);
  std::reverse(s.py, s.py + cells);
  for (double& p : s.px) p = -p;
  return s;
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

/// Solves (1 + diag(s) k) x = r; positive, as k is that of a stiffness.
void solve(const double s[3], const double k[3][3], const double r[3], double x[3]) {
  double m[3][4];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = (i == j ? 1.0 : 0.0) + s[i] * k[i][j];
    m[i][3] = r[i];
  }
  for (int p = 0; p < 2; ++p) {
    for (int i = p + 1; i < 3; ++i) {
      const double f = m[i][p] / m[p][p];
      for (int j = p; j < 4; ++j) m[i][j] -= f * m[p][j];
    }
  }
  for (int i = 2; i >= 0; --i) {
    x[i] = m[i][3];
    for (int j = i + 1; j < 3; ++j) x[i] -= m[i][j] * x[j];
    x[i] /= m[i][i];
  }
}

/// A patch during a step. Displacements are a translation of the patch's centre [m] and a rotation [rad].
class PatchStep {
 public:
  PatchStep(const RollingContact& contact, Memory& memory, Fault& fault);

  double length() const { return length_; }
  double limit() const { return limit_; }  ///< friction limit, sum of mu_j N_j [N]

  /// Displaces the wheel by `shift` and rolls it by h; `first`: from the memory, else from the strips this
  /// patch has written. The displacement of the cells is left in `local`.
  void part(const double shift[3], double h, bool first, double local[3]);

  /// Forces of the cells in steady rolling at displacements `per` length, brought over h at least; with
  /// `keep` they are written.
  void steady(const double per[3], double h, bool keep, double of[3]);

  /// Forces of the written cells.
  void forces(double of[3]) const;
  /// Brings forces from the centre, with its longer arms, to the origin.
  void refer_to_origin(double of[3]) const { of[2] += centre_x_ * of[1] - centre_y_ * of[0]; }

  /// The displacements of the patch's centre for creepages about the origin, and back.
  void about_centre(const Creepage& c, double length, double shift[3]) const;
  Creepage about_origin(const double shift[3], double length) const;

  /// The difference to strip FASTSIM: before the step, until it is set.
  const double* added() const { return added_; }
  void set_added(int i, double value) { added_[i] = value; }

  /// Counts the energy that can be given back after `work` has been put in. Where it needs lower forces, all
  /// that is written is multiplied by `scale`. Returns the dissipated work [J].
  double count_energy(double work, double& scale);
  double adhesion_fraction() const;
  void finish();

 private:
  void set_bounds(double exponent);
  void bring(double h, bool first);
  void march(const double per[3], double h, std::int32_t j, PastStrip& strip) const;
  void pass(const double local[3], double h, double force[3], double k[3][3]);
  double x(std::int32_t j, std::int32_t i) const {
    return contact_.region.centre[j] + contact_.region.half_length[j] * (1.0 - (2.0 * i + 1.0) / cells);
  }
  double area(std::int32_t j) const {
    return contact_.region.width[j] * contact_.region.half_length[j] * (2.0 / cells);
  }
  double bound(std::int32_t j, std::int32_t i) const {
    return bound_ * contact_.friction.share(j) * strip_form(j) * form_[i];
  }
  double strip_form(std::int32_t j) const {
    const double load = contact_.region.peak[j] * contact_.region.half_length[j];
    return load > 0.0 ? natural_exp(exponent_ * natural_log(load / largest_load_)) : 0.0;
  }

  const RollingContact& contact_;
  Memory& memory_;
  PastStrip* written_;
  double length_ = 0.0;       // the longest strip's [m]
  double limit_ = 0.0;        // friction limit [N]
  double a_ = 0.0, b_ = 0.0;  // semi-axes of the double ellipse that stands for the patch [m]
  double centre_x_ = 0.0, centre_y_ = 0.0;
  double growth_x_ = 0.0, growth_y_ = 0.0;  // 1 / L [Pa/m]
  double yield_[3] = {};                    // S
  double arm_ = 1.0;
  double exponent_ = 1.0, largest_load_ = 0.0, bound_ = 0.0, form_[cells] = {};
  double before_[3] = {}, added_[3] = {}, energy_ = 0.0;  // at the beginning of the part, and of the step
};

PatchStep::PatchStep(const RollingContact& contact, Memory& memory, Fault& fault)
    : contact_(contact), memory_(memory), written_(memory.list(1 - memory.present) + memory.written) {
  // the patch's width in the coordinate of the memory, its longest strip, and the centre of its load
  const patch::Strips& region = contact.region;
  double low = 0.0, high = 0.0, load = 0.0;
  for (std::int32_t j = 0; j < region.count; ++j) {
    length_ = std::max(length_, 2.0 * region.half_length[j]);
    const double y = contact.memory.y(region.y[j]), half = 0.5 * region.width[j];
    low = j == 0 ? y - half : std::min(low, y - half);
    high = j == 0 ? y + half : std::max(high, y + half);
    const double own = region.peak[j] * region.half_length[j] * region.width[j];
    load += own;
    centre_x_ += own * region.centre[j];
    centre_y_ += own * region.y[j];
    largest_load_ = std::max(largest_load_, region.peak[j] * region.half_length[j]);
  }
  centre_x_ /= std::max(load, least);
  centre_y_ /= std::max(load, least);
  // Forces, energy and difference to strip FASTSIM of the strips remembered within that width.
  const PastStrip* const past = memory.list(memory.present);
  for (std::int64_t k = 0; k < memory.count; ++k) {
    if (past[k].y < low || past[k].y > high) continue;
    const double sign = contact.memory.direction;
    for (int i = 0; i < 3; ++i) {
      before_[i] += (i == 1 ? 1.0 : sign) * past[k].force[i];
      added_[i] += (i == 1 ? 1.0 : sign) * past[k].added[i];
    }
    energy_ += past[k].energy;
  }

  // Local flexibilities, of linear rolling; the yield of the patch as a whole, of linear theory at rest less
  // theirs.
  const StripEllipse ellipse = strip_ellipse(contact);
  a_ = ellipse.a;
  b_ = ellipse.b;
  const double G = contact.shear_modulus;
  const theory::SdecCoefficients linear = contact.linear_theory->at(a_ / b_, ellipse.shape_number, fault);
  const double per_x = 3.0 * G * linear.c11 / (8.0 * a_), per_y = 3.0 * G * linear.c22 / (8.0 * a_);
  const double area = pi * a_ * b_, u = theory::slenderness(a_ / b_), u2 = std::min(u * u, 0.16);
  const Yield rest = yield_at_rest(a_, b_, G, contact.linear_theory->poisson());
  growth_x_ = per_x / fitted::flexibility_x;
  growth_y_ = per_y / fitted::flexibility_y;
  yield_[0] = fitted::yield_x * std::max(0.0, rest.x - 1.0 / (per_x * area));
  yield_[1] = fitted::yield_y * std::max(0.0, rest.y - 1.0 / (per_y * area));
  yield_[2] = fitted::twist(u2) / (G * a_ * b_ * std::sqrt(a_ * b_));
  arm_ = fitted::arm(u2);
  const double share = 1.0 - 0.5 * (1.0 / (per_x * area * rest.x) + 1.0 / (per_y * area * rest.y));
  set_bounds(
      std::clamp(fitted::exponent + fitted::exponent_by_yield * (share - fitted::middle_yield), 0.4, 2.0));
}

void PatchStep::set_bounds(double exponent) {
  exponent_ = exponent;
  // over the middles of cells (1 - s^2)^m
  for (std::int32_t i = 0; i < cells; ++i) {
    const double s = 1.0 - (2.0 * i + 1.0) / cells;
    form_[i] = natural_exp(exponent * natural_log(1.0 - s * s));
  }
  // the whole is the friction limit, sum of mu_j N_j, N_j = pi/2 peak half_length width
  double whole = 0.0;
  bound_ = 1.0;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const patch::Strips& r = contact_.region;
    limit_ += contact_.friction[j] * (0.5 * pi) * r.peak[j] * r.half_length[j] * r.width[j];
    double sum = 0.0;
    for (const double form : form_) sum += form;
    whole += contact_.friction.share(j) * strip_form(j) * sum * area(j);
  }
  bound_ = limit_ / std::max(whole, least);
}

void PatchStep::bring(double h, bool first) {
  Brought* const brought = memory_.brought();
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const double lead = contact_.region.centre[j] + contact_.region.half_length[j];
    Brought& to = brought[j];
    std::fill_n(to.px, cells, 0.0);
    std::fill_n(to.py, cells, 0.0);
    std::fill_n(to.share, cells, 0.0);
    // the strips it comes from, turned to the way of rolling, and their shares
    Neighbours from{&written_[j], nullptr, 0.0};
    if (first)
      from =
          neighbours(memory_.list(memory_.present), memory_.count, contact_.memory.y(contact_.region.y[j]));
    for (const bool of_second : {false, true}) {
      const PastStrip* const one = of_second ? from.second : from.first;
      if (of_second && one == nullptr) continue;
      const double weight = of_second ? from.share : 1.0 - from.share;
      const PastStrip past =
          one == nullptr ? PastStrip{} : turned(*one, first ? contact_.memory.direction : 1.0);
      const double old_lead = past.centre + past.half_length;
      for (std::int32_t i = 0; i < cells; ++i) {
        // Behind the old leading edge it was in contact all the time. Ahead of it since it met the edge,
        // which closes the distance -behind at the rate `closing`.
        const double at = x(j, i), behind = old_lead - (at + h);
        double share = 1.0;
        if (one == nullptr) {
          share = h > 0.0 ? std::min(1.0, (lead - at) / h) : 1.0;
        } else if (behind > 0.0) {
          const Interpolation before(past.half_length, behind);
          to.px[i] += weight * before.of(past.px);
          to.py[i] += weight * before.of(past.py);
        } else if (h > 0.0) {
          const double closing = h + lead - old_lead;
          share = closing > 0.0 ? 1.0 - std::clamp(-behind / closing, 0.0, 1.0) : 0.0;
        }
        to.share[i] += weight * share;
      }
    }
  }
}

void PatchStep::pass(const double local[3], double h, double force[3], double k[3][3]) {
  const Brought* const brought = memory_.brought();
  for (int i = 0; i < 3; ++i) {
    force[i] = 0.0;
    for (int m = 0; m < 3; ++m) k[i][m] = 0.0;
  }
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const Brought& from = brought[j];
    PastStrip& to = written_[j];
    const double dA = area(j), y = arm_ * (contact_.region.y[j] - centre_y_), middle = bound(j, 0) / form_[0];
    double fx = 0.0, fy = 0.0, mz = 0.0;
    for (std::int32_t i = 0; i < cells; ++i) {
      // traction if it sticks; the arm of the displacement is that of the middle of its way
      const double share = from.share[i], at = arm_ * (x(j, i) - centre_x_);
      const double on_way = at + arm_ * 0.5 * share * h;
      double px = from.px[i] - growth_x_ * share * (local[0] - local[2] * y);
      double py = from.py[i] - growth_y_ * share * (local[1] + local[2] * on_way);
      // onto the disk; the slopes of that
      const double tau = middle * form_[i], size = std::sqrt(px * px + py * py);
      double xx = 1.0, xy = 0.0, yy = 1.0;
      if (size > tau) {
        const double ex = px / size, ey = py / size, ratio = tau / size;
        xx = ratio * ey * ey;
        xy = -ratio * ex * ey;
        yy = ratio * ex * ex;
        px *= ratio;
        py *= ratio;
      }
      to.px[i] = px;
      to.py[i] = py;
      fx += px;
      fy += py;
      mz += at * py - y * px;
      // -d(force)/d(local)
      const double gx = growth_x_ * share * dA, gy = growth_y_ * share * dA;
      const double of_x[3] = {gx * xx, gy * xy, gy * xy * on_way - gx * xx * y};
      const double of_y[3] = {gx * xy, gy * yy, gy * yy * on_way - gx * xy * y};
      for (int m = 0; m < 3; ++m) {
        k[0][m] += of_x[m];
        k[1][m] += of_y[m];
        k[2][m] += at * of_y[m] - y * of_x[m];
      }
    }
    to.force[0] = fx * dA;
    to.force[1] = fy * dA;
    to.force[2] = mz * dA;
    for (int i = 0; i < 3; ++i) force[i] += to.force[i];
  }
}

void PatchStep::part(const double shift[3], double h, bool first, double local[3]) {
  // local = shift + S (F - F'), by Newton's method, from no yield; the last pass counts
  bring(h, first);
  for (int i = 0; i < 3; ++i) local[i] = shift[i];
  double force[3], k[3][3];
  for (int solution = 0; solution < solutions; ++solution) {
    pass(local, h, force, k);
    double rest[3], change[3];
    for (int i = 0; i < 3; ++i) rest[i] = shift[i] + yield_[i] * (force[i] - before_[i]) - local[i];
    solve(yield_, k, rest, change);
    for (int i = 0; i < 3; ++i) local[i] += change[i];
  }
  pass(local, h, force, k);
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    written_[j].y = contact_.memory.y(contact_.region.y[j]);
    written_[j].centre = contact_.region.centre[j];
    written_[j].half_length = contact_.region.half_length[j];
  }
  for (int i = 0; i < 3; ++i) before_[i] = force[i];
}

void PatchStep::march(const double per[3], double h, std::int32_t j, PastStrip& strip) const {
  // From the leading edge on, brought as in a part of a step. Over less than a cell a cell's own share w is
  // solved for: p nearest to q + w p in the disk is p nearest to q / (1 - w), that of a whole cell with the
  // part's arms.
  const double half = contact_.region.half_length[j], lead = contact_.region.centre[j] + half;
  const double path = std::max(h, 2.0 * half / cells), y = arm_ * (contact_.region.y[j] - centre_y_);
  const double middle = bound(j, 0) / form_[0];
  for (std::int32_t i = 0; i < cells; ++i) {
    const double at = x(j, i), behind = lead - (at + path), way = std::min(path, lead - at);
    const Interpolation before(half, behind);
    const double px = before.of(strip.px) - growth_x_ * way * (per[0] - per[2] * y);
    const double py = before.of(strip.py) -
                      growth_y_ * way * (per[1] + per[2] * arm_ * (at + 0.5 * std::min(h, way) - centre_x_));
    const double tau = middle * form_[i], size = std::sqrt(px * px + py * py);
    const double ratio = size > tau ? tau / size : 1.0;
    strip.px[i] = px * ratio;
    strip.py[i] = py * ratio;
  }
}

void PatchStep::steady(const double per[3], double h, bool keep, double of[3]) {
  for (int i = 0; i < 3; ++i) of[i] = 0.0;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    PastStrip strip{};
    strip.y = contact_.memory.y(contact_.region.y[j]);
    strip.centre = contact_.region.centre[j];
    strip.half_length = contact_.region.half_length[j];
    march(per, h, j, strip);
    const double dA = area(j), y = arm_ * (contact_.region.y[j] - centre_y_);
    for (std::int32_t i = 0; i < cells; ++i) {
      strip.force[0] += strip.px[i] * dA;
      strip.force[1] += strip.py[i] * dA;
      strip.force[2] += (arm_ * (x(j, i) - centre_x_) * strip.py[i] - y * strip.px[i]) * dA;
    }
    for (int i = 0; i < 3; ++i) of[i] += strip.force[i];
    if (keep) written_[j] = strip;
  }
}

void PatchStep::forces(double of[3]) const {
  for (int i = 0; i < 3; ++i) {
    of[i] = 0.0;
    for (std::int32_t j = 0; j < contact_.region.count; ++j) of[i] += written_[j].force[i];
  }
}

void PatchStep::about_centre(const Creepage& c, double length, double shift[3]) const {
  shift[0] = length * (c.longitudinal - c.spin * centre_y_);
  shift[1] = length * (c.lateral + c.spin * centre_x_);
  shift[2] = length * c.spin;
}

Creepage PatchStep::about_origin(const double shift[3], double length) const {
  // no more than slides everywhere: creepages of 10
  constexpr double most = 10.0;
  const double size = std::max({std::abs(shift[0]), std::abs(shift[1]), std::abs(shift[2]) * a_, least});
  const double per = std::min(1.0 / std::max(length, least), most / size);
  return {per * (shift[0] + shift[2] * centre_y_), per * (shift[1] - shift[2] * centre_x_), per * shift[2]};
}

double PatchStep::count_energy(double work, double& scale) {
  // stored: 1/2 L p^2 of the cells, and 1/2 S F^2
  double stored = 0.0, force[3];
  forces(force);
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    double x2 = 0.0, y2 = 0.0;
    for (std::int32_t i = 0; i < cells; ++i) {
      x2 += written_[j].px[i] * written_[j].px[i];
      y2 += written_[j].py[i] * written_[j].py[i];
    }
    stored += 0.5 * area(j) * (x2 / growth_x_ + y2 / growth_y_);
  }
  for (int i = 0; i < 3; ++i) stored += 0.5 * yield_[i] * force[i] * force[i];
  // energy + scale work >= kept_back scale^2 stored
  const double least_kept = kept_back * stored;
  scale = 1.0;
  if (energy_ + work < least_kept) {
    scale = least_kept > 0.0
                ? (work + std::sqrt(work * work + 4.0 * least_kept * energy_)) / (2.0 * least_kept)
                : (work < 0.0 ? energy_ / -work : 1.0);
    scale = std::clamp(scale, 0.0, 1.0);
  }
  const double there = std::max(0.0, energy_ + scale * work), left = std::min(scale * scale * stored, there);
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    PastStrip& strip = written_[j];
    strip.energy = left * (1.0 / contact_.region.count);
    for (std::int32_t i = 0; i < cells; ++i) {
      strip.px[i] *= scale;
      strip.py[i] *= scale;
    }
    for (int i = 0; i < 3; ++i) {
      strip.force[i] *= scale;
      strip.added[i] = scale * added_[i] * (1.0 / contact_.region.count);
    }
  }
  for (double& part : added_) part *= scale;
  return there - left;
}

double PatchStep::adhesion_fraction() const {
  double sticks = 0.0, whole = 0.0;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const double middle = bound(j, 0) / form_[0];
    std::int32_t stuck = 0;
    for (std::int32_t i = 0; i < cells; ++i) {
      const double px = written_[j].px[i], py = written_[j].py[i], tau = (1.0 - 1e-9) * middle * form_[i];
      stuck += px * px + py * py < tau * tau ? 1 : 0;
    }
    sticks += area(j) * stuck;
    whole += area(j) * cells;
  }
  return whole > 0.0 ? sticks / whole : 0.0;
}

void PatchStep::finish() {
  for (std::int32_t j = 0; j < contact_.region.count; ++j)
    written_[j] = turned(written_[j], contact_.memory.direction);
  memory_.written += contact_.region.count;
}

Memory& memory_at(void* memory) { return *static_cast<Memory*>(memory); }

/// Goes through the step in parts; the displacements of the cells and of the patch over the last part.
void go(PatchStep& patch, const RollingContact& contact, double rolled, double local[3], double shift[3],
        double& last) {
  const double length = std::max(patch.length(), least);
  const bool rests = rolled <= least_step * length;
  const double path = rests ? 0.0 : rolled;
  const std::int32_t parts =
      std::clamp(static_cast<std::int32_t>(std::ceil(path / (usual_part * length))), 1, most_parts);
  patch.about_centre(contact.creepage, (rests ? contact.memory.rolled : path) / parts, shift);
  last = path / parts;
  for (std::int32_t k = 0; k < parts; ++k) patch.part(shift, last, k == 0, local);
}

}  // namespace

std::size_t strip_memory_bytes(std::int32_t strips) {
  return sizeof(Memory) + static_cast<std::size_t>(strips) * (2 * sizeof(PastStrip) + sizeof(Brought));
}

void make_strip_memory(std::int32_t strips, void* at) {
  memory_at(at) = {};
  memory_at(at).capacity = strips;
}

void begin_step(void* at) { memory_at(at).written = 0; }

void end_step(void* at) {
  Memory& memory = memory_at(at);
  memory.present = 1 - memory.present;
  memory.count = memory.written;
}

TangentialForces roll_with_memory(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault) {
  PatchStep patch(contact, memory_at(contact.memory.at), fault);
  const double length = std::max(patch.length(), least);
  const double rolled = contact.memory.at_rest ? 0.0 : contact.memory.rolled;
  const bool rests = rolled <= least_step * length, forgets = rolled > all_forgotten * length;
  // Cells at the end of the step, and the displacements per length at which strip FASTSIM is asked
  double local[3] = {}, shift[3] = {}, last = 0.0, cells_force[3] = {};
  Creepage asked = contact.creepage;
  if (forgets) {
    patch.about_centre(contact.creepage, 1.0, shift);
    patch.steady(shift, usual_part * length, true, cells_force);
  } else {
    go(patch, contact, rolled, local, shift, last);
    for (int i = 0; i < 3; ++i) shift[i] += fitted::ahead * (local[i] - shift[i]);
    if (!rests) asked = patch.about_origin(shift, last);
  }
  // The difference to strip FASTSIM follows over the length that is rolled.
  TangentialForces forces;
  RollingContact steady = contact;
  steady.creepage = asked;
  if (!rests || fields.any()) forces = strip_fastsim(steady, fields, fault);
  const double steady_power = forces.power_per_speed;
  if (!rests) {
    double per[3], of_cells[3];
    patch.about_centre(asked, 1.0, per);
    patch.steady(per, last, false, of_cells);
    if (forgets) std::copy_n(cells_force, 3, of_cells);
    patch.refer_to_origin(of_cells);
    const double share = forgets ? 1.0 : 1.0 - natural_exp(-rolled / (fitted::follows * 0.5 * length));
    const double of_strips[3] = {forces.fx, forces.fy, forces.mz};
    for (int i = 0; i < 3; ++i)
      patch.set_added(i, patch.added()[i] + share * (of_strips[i] - of_cells[i] - patch.added()[i]));
  }
  // Forces, within friction
  double force[3];
  patch.forces(force);
  patch.refer_to_origin(force);
  const double fx = force[0] + patch.added()[0], fy = force[1] + patch.added()[1];
  const double within = std::min(1.0, patch.limit() / std::max(std::sqrt(fx * fx + fy * fy), least));
  patch.set_added(0, within * fx - force[0]);
  patch.set_added(1, within * fy - force[1]);
  for (int i = 0; i < 3; ++i) force[i] += patch.added()[i];
  // Work of the step, -F.D, and the energy it leaves.
  const Creepage& c = contact.creepage;
  const double work =
      -contact.memory.rolled * (force[0] * c.longitudinal + force[1] * c.lateral + force[2] * c.spin);
  double scale = 1.0;
  const double dissipated = patch.count_energy(work, scale);
  forces.adhesion_fraction = forgets ? forces.adhesion_fraction : patch.adhesion_fraction();
  patch.finish();
  if (forgets && scale == 1.0) return forces;
  forces.fx = scale * force[0];
  forces.fy = scale * force[1];
  forces.mz = scale * force[2];
  forces.power_per_speed = rests ? 0.0 : dissipated / rolled;
  scale_slips(steady_power > 0.0 ? forces.power_per_speed / steady_power : 0.0,
              static_cast<std::ptrdiff_t>(contact.grid->cells) * contact.region.count, fields);
  return forces;
}

}  // namespace wrc::tangential
