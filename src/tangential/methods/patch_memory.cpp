#include "tangential/methods/patch_memory.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"
#include "kernels/kernels.hpp"
#include "tangential/methods/strip_fastsim.hpp"

namespace wrc::tangential {
namespace {

constexpr std::int32_t cells = memory_cells, half = cells / 2;

// Lengths of the longest strip: a step from which on steady rolling takes over, and one that is none; parts
// of a step, from its end on.
constexpr double forgets_from = 1.5, least_step = 1e-9;
constexpr std::int32_t most_parts = 3;
constexpr double usual_parts[most_parts] = {0.25, 0.5, all_forgotten};
constexpr double yields_whole = 0.6,
                 yields_none = 2.0;    // parts of which the end sees all and none of the yield
constexpr std::int32_t solutions = 2;  // Newton's steps for U in the last part, one in those before
constexpr double carried = 0.5;        // share of the rest of the equation that goes to the next part
constexpr double least = 1e-290;       // keeps divisions finite
constexpr double everywhere = 1e3;     // farther than any place [m]

constexpr double kept_back = 0.25;  // least part of the stored energy that can be given back

/// Middles of the cells over the half length, and 1 - their square.
struct Places {
  double at[cells], parabola[cells];
};
constexpr Places places = [] {
  Places p{};
  for (std::int32_t i = 0; i < cells; ++i) {
    p.at[i] = 1.0 - (2.0 * i + 1.0) / cells;
    p.parabola[i] = 1.0 - p.at[i] * p.at[i];
  }
  return p;
}();

/// Bins of the cells' pressures, and the roots of their numbers.
constexpr std::int32_t bins = 64;
struct Roots {
  double of[bins + 1];
};
constexpr Roots roots = [] {
  Roots r{};
  for (std::int32_t i = 1; i <= bins; ++i) {
    double root = 1.0 + i / 4.0;
    for (int step = 0; step < 8; ++step) root = 0.5 * (root + i / root);
    r.of[i] = root;
  }
  return r;
}();

/// Parts of the step that come after the k-th, of those counted from its end on.
double left_of_step(const double* share, std::int32_t k) {
  double left = 0.0;
  for (std::int32_t i = 0; i < k; ++i) left += share[i];
  return left;
}

/// Weight from 0 to 1 over the middle half of a way, with zero slope at its ends [-].
double beyond_half(double at, double way) { return smooth_step(2.0 * at / way - 0.5); }

/// The nearest strips on either side of a place on a plane, with their shares. Between two strips of a patch
/// shares change in a straight line. They vanish two widths beside the patch.
Neighbours neighbours(const PastStrip* past, std::int64_t count, double y) {
  Neighbours n;
  for (std::int64_t k = 0; k < count; ++k) {
    const PastStrip*& side = past[k].y <= y ? n.first : n.second;
    if (side == nullptr || std::abs(past[k].y - y) < std::abs(side->y - y)) side = &past[k];
  }
  const double gap = n.first && n.second ? n.second->y - n.first->y : everywhere;
  const auto share_of = [&](const PastStrip* strip) {
    if (strip == nullptr) return 0.0;
    double width = everywhere;
    if (strip != past) width = std::abs(strip->y - strip[-1].y);
    if (strip != past + count - 1) width = std::min(width, std::abs(strip->y - strip[1].y));
    return std::max(0.0, 1.0 - std::abs(strip->y - y) / std::min(gap, 2.0 * width));
  };
  n.of_first = share_of(n.first);
  n.of_second = share_of(n.second);
  return n;
}

/// Cells of a patch by their pressure: the share of the area where it is larger.
struct PressureRanks {
  double per_load;          ///< bins over the largest peak times half length
  double larger[bins + 1];  ///< at pressures whose square over the largest one's is bin / bins
  double cone;              ///< part of a cone in the pressures' form
};

PressureRanks rank_pressures(const patch::Strips& region, double largest_load) {
  // Area of the cells by the square of their pressure: cells between two bins are of both.
  PressureRanks ranks;
  ranks.per_load = (bins - 1e-9) / std::max(largest_load, least);
  double area[bins + 1] = {}, whole = 0.0;
  for (std::int32_t j = 0; j < region.count; ++j) {
    const double load = ranks.per_load * (region.peak[j] * region.half_length[j]);
    const double of_cell = region.width[j] * region.half_length[j];
    for (std::int32_t i = 0; i < half; ++i) {
      const double square = load * places.parabola[i];
      const std::int32_t bin = static_cast<std::int32_t>(square);
      const double next = (square - bin) * of_cell;
      area[bin] += of_cell - next;
      area[bin + 1] += next;
    }
    whole += half * of_cell;
  }
  // Mean share under the pressure: 0.4 under Hertz's, 1/3 under a cone's, as displacements d of cells that
  // begin to slide are 1 - x^2 and 1 - x. Between them it is linear in the parts of both.
  constexpr double more_by_cells = 0.0023;  // mean share of an ellipse on 8 to 60 strips, less 0.4
  const double per_area = 1.0 / std::max(whole, least);
  double sum = 0.0, pressed = 0.0, mean = 0.0;
  for (std::int32_t bin = 0; bin <= bins; ++bin) {
    sum += area[bin];
    ranks.larger[bin] = std::max(0.0, 1.0 - (sum - 0.5 * area[bin]) * per_area);
    const double own = area[bin] * roots.of[bin];
    pressed += own;
    mean += own * ranks.larger[bin];
  }
  mean = mean / std::max(pressed, least) - more_by_cells;
  ranks.cone = std::clamp(4.0 * (0.4 - mean) / (0.6 - mean), -0.5, 1.0);
  return ranks;
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

}  // namespace

/// A past strip as the bodies roll now: backwards it is the mirror image.
PastStrip turned(const PastStrip& strip, double direction) {
  PastStrip s = strip;
  if (direction > 0.0) return s;
  s.centre = -s.centre;
  s.way = -s.way;
  for (double* three : {s.force, s.added}) {
    three[0] = -three[0];
    three[2] = -three[2];
  }
  std::reverse(s.px, s.px + cells);
  std::reverse(s.py, s.py + cells);
  for (double& p : s.px) p = -p;
  return s;
}

PatchStep::PatchStep(const RollingContact& contact, const PatchStrips& strips, const PatchNumbers& numbers,
                     const MemoryFactors& factors)
    : contact_(contact), strips_(strips), factors_(factors), numbers_(numbers) {
  if (strips_.number)
    take_past_of_rail();
  else
    take_past_of_plane();
  set_strips();
}

void PatchStep::take_shared(const RememberingStrip* const* shared, const LeftStrips& left) {
  shared_ = shared;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    RememberingStrip& strip = strips_.scratch[j];
    const RememberingStrip& from = *shared_[j];
    strip.growth_x = from.growth_x;
    strip.growth_y = from.growth_y;
    strip.turns = from.turns;
    strip.bounds = from.bounds;
    std::copy_n(from.bound, cells, strip.bound);
  }
  left_[0] = left.fx;
  left_[1] = left.fy;
  left_[2] = numbers_.arm * (left.mz + left.turn - numbers_.centre_x * left.fy + numbers_.centre_y * left.fx);
  let_strips_leave();
}

void PatchStep::add_past_of_rail(std::int32_t j, double share, double to[3]) const {
  // the strip's width within the patch; moments about the patch's centre
  const PastStrip* const strip = strips_.past_of[j];
  if (strip == nullptr) return;
  const double sign = contact_.memory.direction, part = share * strips_.inside[j];
  const double fx = part * sign * strip->force[0], fy = part * strip->force[1];
  to[0] += fx;
  to[1] += fy;
  to[2] += numbers_.arm * (part * sign * strip->force[2] + (sign * strip->centre - numbers_.centre_x) * fy -
                           (contact_.region.y[j] - numbers_.centre_y) * fx);
}

void PatchStep::take_past_of_rail() {
  for (std::int32_t j = 0; j < contact_.region.count; ++j) add_past_of_rail(j, 1.0, before_);
}

void PatchStep::take_past_of_plane() {
  // the patch's borders on the plane
  const patch::Strips& region = contact_.region;
  const RollingMemory& memory = contact_.memory;
  const double sign = memory.direction, centre = memory.y(numbers_.centre_y);
  double low = everywhere, high = -everywhere;
  for (std::int32_t j = 0; j < region.count; ++j) {
    const double to_border = 0.5 * region.width[j];
    low = std::min(low, key(j) - to_border);
    high = std::max(high, key(j) + to_border);
  }
  // forces, energy and difference to strip FASTSIM of the remembered strips up to half way to other patches.
  // Strips beside the patch count less, as forces at a distance displace and turn a half-space less
  for (std::int64_t k = 0; k < strips_.past_count; ++k) {
    const PastStrip& strip = strips_.past[k];
    const double border = strip.y > high ? high : low, off = std::abs(strip.y - centre);
    double weight = 1.0, near = 1.0;
    if (strip.y > high || strip.y < low) {
      const double other = strip.y > high ? memory.above : memory.below;
      weight = 1.0 - beyond_half(std::abs(strip.y - border), std::abs(other - border));
      near = std::min(1.0, std::abs(border - centre) / off);
    }
    weight *= near;
    const double fx = weight * sign * strip.force[0], fy = weight * strip.force[1];
    const double y = (strip.y - memory.origin) / memory.slope;
    before_[0] += fx;
    before_[1] += fy;
    before_[2] += numbers_.arm *
                  (weight * sign * strip.force[2] +
                   near * ((sign * strip.centre - numbers_.centre_x) * fy - (y - numbers_.centre_y) * fx));
    for (int i = 0; i < 3; ++i) added_[i] += weight * (i == 1 ? 1.0 : sign) * strip.added[i];
    energy_ += weight * strip.energy;
  }
}

void PatchStep::let_strips_leave() {
  // Strips whose bounds have fallen far below their force are among those that leave, the more the further.
  constexpr double far = 0.25;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    RememberingStrip& strip = strips_.scratch[j];
    const PastStrip* const past = strips_.past_of[j];
    if (past == nullptr) continue;
    const double borne = strip.area * strip.bounds;
    const double had = std::sqrt(past->force[0] * past->force[0] + past->force[1] * past->force[1]);
    strip.kept = std::min(1.0, borne / std::max(far * strips_.inside[j] * had, least));
    if (strip.kept == 1.0) continue;
    add_past_of_rail(j, strip.kept - 1.0, before_);
    add_past_of_rail(j, 1.0 - strip.kept, left_);
  }
}

Neighbours PatchStep::past_of(std::int32_t j) const {
  if (!strips_.number) return neighbours(strips_.past, strips_.past_count, key(j));
  return {strips_.past_of[j], nullptr};
}

void PatchStep::set_strips() {
  const patch::Strips& r = contact_.region;
  for (std::int32_t j = 0; j < r.count; ++j) {
    RememberingStrip& strip = strips_.scratch[j];
    strip.centre = r.centre[j];
    strip.half_length = r.half_length[j];
    strip.area = r.width[j] * r.half_length[j] * (2.0 / cells);
    strip.arm = numbers_.arm;
    strip.kept = 1.0;
    strip.y = numbers_.arm * (r.y[j] - numbers_.centre_y);
    strip.x = numbers_.arm * (r.centre[j] - numbers_.centre_x);
    strip.reach = numbers_.arm * r.half_length[j];
    strip.growth_x = numbers_.growth_x;
    strip.growth_y = numbers_.growth_y;
  }
}

void PatchStep::set_bounds() {
  // Cells turn the faster, the less of the patch slides.
  const double before2 = before_[0] * before_[0] + before_[1] * before_[1];
  const double used2 = before2 / std::max(numbers_.limit * numbers_.limit, least);
  const double turns = factors_.turns * std::max(0.0, 1.0 - used2 * used2 * used2);
  // Bounds over that of the middle: 1 - x^2 - (2/3) q (1 - x^3) of an ellipse, 1 - x - (1/2) q (1 - x^2) of a
  // cone, both over 1 - x. Then [Pa]: the whole is the friction limit.
  const patch::Strips& r = contact_.region;
  const double share = numbers_.share;
  const PressureRanks ranks = rank_pressures(r, numbers_.largest_load);
  const double curved = (2.0 / 3.0) * share, round = 1.0 - ranks.cone;
  const double at_middle = round * (1.0 - curved) + ranks.cone * (1.0 - 0.5 * share);
  const double by_x = round * (1.0 - curved) - ranks.cone * (0.5 * share), by_x2 = -(round * curved);
  const simd::MemoryBoundsTask task{places.parabola, ranks.larger, share, at_middle, by_x, by_x2};
  double whole = 0.0;
  for (std::int32_t j = 0; j < r.count; ++j) {
    RememberingStrip& strip = strips_.scratch[j];
    strip.turns = turns;
    const double load = ranks.per_load * (r.peak[j] * r.half_length[j]);
    contact_.grid->kernels->tangential.memory_bounds(task, load, contact_.friction.share(j), strip);
    whole += strip.bounds * strip.area;
  }
  const double per = numbers_.limit / std::max(whole, least);
  for (std::int32_t j = 0; j < r.count; ++j) {
    RememberingStrip& strip = strips_.scratch[j];
    for (std::int32_t i = 0; i < half; ++i) strip.bound[cells - 1 - i] = strip.bound[i] *= per;
    strip.bounds *= per;
  }
}

void PatchStep::place_strips(double done) {
  // between their places of before and those at the end of the step; new strips have had theirs
  const double sign = contact_.memory.direction;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    RememberingStrip& strip = strips_.scratch[j];
    double centre = contact_.region.centre[j], l = contact_.region.half_length[j];
    double move = 0.0, growth = 0.0;
    const auto add = [&](const PastStrip* past, double share) {
      if (past == nullptr) return;
      move += share * (centre - sign * past->centre);
      growth += share * (l - past->half_length);
    };
    if (done < 1.0) {
      const Neighbours before = past_of(j);
      add(before.first, before.of_first);
      add(before.second, before.of_second);
    }
    centre -= (1.0 - done) * move;
    l -= (1.0 - done) * growth;
    strip.centre = centre;
    strip.half_length = l;
    strip.area = contact_.region.width[j] * l * (2.0 / cells);
    strip.x = numbers_.arm * (centre - numbers_.centre_x);
    strip.reach = numbers_.arm * l;
  }
}

void PatchStep::set_own(double travel) {
  // displacements of a shared strip's own over this travel [m], its turn on this patch's arm
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    RememberingStrip& strip = strips_.scratch[j];
    strip.own_x = strip.own_y = strip.own_turn = 0.0;
    if (shared_ == nullptr) continue;
    const RememberingStrip& shared = *shared_[j];
    strip.own_x = travel * shared.own_x;
    strip.own_y = travel * shared.own_y;
    strip.own_turn = travel * shared.own_turn * (shared.arm / numbers_.arm);
  }
}

void PatchStep::bring(double h, bool first) {
  const simd::TangentialKernels& kernels = contact_.grid->kernels->tangential;
  simd::MemoryBringTask task{places.at, nullptr, nullptr, 0.0, 0.0, h, 1.0, false};
  const auto brought = [&](const PastStrip& past, RememberingStrip& to) {
    task.px = past.px;
    task.py = past.py;
    task.old_lead = past.centre + past.half_length;
    task.half_length = past.half_length;
    kernels.memory_bring(task, to);
  };
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    RememberingStrip& to = strips_.scratch[j];
    if (!first) {
      brought(strips_.written[j], to);
      continue;
    }
    // strips of the past, turned to the way of rolling; cells without a past enter without tractions
    Neighbours from = past_of(j);
    if (from.first == nullptr) from.of_first = 0.0;
    const double enters = std::max(0.0, 1.0 - from.of_first - from.of_second);
    task.adds = enters > 0.0 || from.of_first == 0.0;
    // zeros, and the share of each cell that enters without tractions
    if (task.adds) {
      std::fill_n(to.px, cells, 0.0);
      std::fill_n(to.py, cells, 0.0);
      for (std::int32_t i = 0; i < cells; ++i)
        to.share[i] = enters * (h > 0.0 ? std::min(1.0, to.half_length * (1.0 - places.at[i]) / h) : 1.0);
    }
    std::fill_n(to.had, half, 0.0);
    const auto add = [&](const PastStrip* one, double share) {
      if (one == nullptr) return;
      for (std::int32_t i = 0; i < half; ++i) to.had[i] += share * one->bound[i];
      task.weight = share;
      if (contact_.memory.direction > 0.0)
        brought(*one, to);
      else
        brought(turned(*one, -1.0), to);
      task.adds = true;
    };
    add(from.first, from.of_first);
    add(from.second, from.of_second);
    for (std::int32_t i = 0; i < half; ++i) to.had[cells - 1 - i] = to.had[i];
    // tractions that leave with their strip; the cells are displaced all the same
    if (to.kept == 1.0) continue;
    for (double* const numbers : {to.px, to.py, to.had})
      for (std::int32_t i = 0; i < cells; ++i) numbers[i] *= to.kept;
  }
}

void PatchStep::solve_part(const double shift[3], double h, const Part& part, double local[3],
                           double rest[3]) {
  // local = shift + S (F - F'), by Newton's method, from no yield; F' of strips that leave in proportion
  bring(h, part.first);
  const std::int32_t count = contact_.region.count;
  simd::MemoryPassTask task{count,
                            strips_.scratch,
                            places.at,
                            {shift[0], shift[1], shift[2]},
                            h,
                            0.5 * numbers_.arm * h,
                            part.to_come,
                            strips_.written->px,
                            strips_.written->force,
                            sizeof(PastStrip) / sizeof(double)};
  const simd::TangentialKernels& kernels = contact_.grid->kernels->tangential;
  // cells at the end of a long part have seen less of the yield than those that have left
  const double yields =
      1.0 - smooth_step((h / std::max(length(), least) - yields_whole) / (yields_none - yields_whole));
  double yield[3];
  for (int i = 0; i < 3; ++i) {
    yield[i] = yields * numbers_.yield[i];
    before_[i] += part.share * left_[i];
  }
  const auto left_over = [&](const double force[3]) {
    for (int i = 0; i < 3; ++i) rest[i] = shift[i] + yield[i] * (force[i] - before_[i]) - task.local[i];
  };
  for (int solution = part.to_come > 0.0 ? 1 : 0; solution < solutions; ++solution) {
    simd::MemoryPassSums sums;
    kernels.memory_pass_sums(task, sums);
    left_over(sums.force);
    double change[3];
    solve(yield, sums.slope, rest, change);
    for (int i = 0; i < 3; ++i) task.local[i] += change[i];
  }
  // tractions, and the forces of the strips
  kernels.memory_pass(task);
  for (std::int32_t j = 0; j < count; ++j) {
    const RememberingStrip& at = strips_.scratch[j];
    PastStrip& strip = strips_.written[j];
    strip.centre = at.centre;
    strip.half_length = at.half_length;
  }
  double force[3];
  forces(force);
  left_over(force);
  std::copy_n(force, 3, before_);
  std::copy_n(task.local, 3, local);
}

void march_steadily(const RollingContact& contact, const RememberingStrip* strips, std::int32_t count,
                    const double per[3], double h, PastStrip* into) {
  contact.grid->kernels->tangential.memory_march({count,
                                                  strips,
                                                  places.at,
                                                  {per[0], per[1], per[2]},
                                                  h,
                                                  into->px,
                                                  into->force,
                                                  sizeof(PastStrip) / sizeof(double)});
}

void PatchStep::steady(const double per[3], double h, PastStrip* into, double of[3]) {
  set_own(0.0);
  march_steadily(contact_, strips_.scratch, contact_.region.count, per, h, into);
  for (int i = 0; i < 3; ++i) of[i] = 0.0;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    into[j].y = key(j);
    into[j].centre = contact_.region.centre[j];
    into[j].half_length = contact_.region.half_length[j];
    for (int i = 0; i < 3; ++i) of[i] += into[j].force[i];
  }
}

void PatchStep::forces(double of[3]) const {
  for (int i = 0; i < 3; ++i) of[i] = 0.0;
  for (std::int32_t j = 0; j < contact_.region.count; ++j)
    for (int i = 0; i < 3; ++i) of[i] += strips_.written[j].force[i];
}

void PatchStep::about_centre(const Creepage& c, double length, double shift[3]) const {
  shift[0] = length * (c.longitudinal - c.spin * numbers_.centre_y);
  shift[1] = length * (c.lateral + c.spin * numbers_.centre_x);
  shift[2] = length * c.spin;
}

Creepage PatchStep::about_origin(const double shift[3], double length) const {
  const double per =
      per_length(std::max({std::abs(shift[0]), std::abs(shift[1]), std::abs(shift[2]) * numbers_.a}), length);
  return {per * (shift[0] + shift[2] * numbers_.centre_y), per * (shift[1] - shift[2] * numbers_.centre_x),
          per * shift[2]};
}

double PatchStep::stored() const {
  double force[3];
  forces(force);
  double sum = stored_by(numbers_.yield, force);
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const RememberingStrip& at = strips_.scratch[j];
    sum += stored_in(strips_.written[j], at.area, at.growth_x, at.growth_y);
  }
  return sum;
}

void PatchStep::lower(double scale) {
  for (std::int32_t j = 0; j < contact_.region.count; ++j) tangential::lower(scale, strips_.written[j]);
}

double PatchStep::adhesion_fraction() const {
  double sticks = 0.0, whole = 0.0;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const RememberingStrip& at = strips_.scratch[j];
    std::int32_t stuck = 0;
    for (std::int32_t i = 0; i < cells; ++i) {
      const double px = strips_.written[j].px[i], py = strips_.written[j].py[i];
      const double tau = (1.0 - 1e-9) * at.bound[i];
      stuck += px * px + py * py < tau * tau ? 1 : 0;
    }
    sticks += at.area * stuck;
    whole += at.area * cells;
  }
  return whole > 0.0 ? sticks / whole : 0.0;
}

void PatchStep::go(const double per[3], double travel, double rolled, double local[3], double of_part[3],
                   double& last) {
  // Parts from the end of the step on; those before the last are seen less.
  double left = rolled / std::max(length(), least), share[most_parts];
  std::int32_t parts = 0;
  for (const double usual : usual_parts) {
    if (parts > 0 && !(left > 0.0)) break;
    share[parts++] = std::min(left, usual);
    left -= usual;
  }
  const double whole = std::max(rolled / std::max(length(), least), least);
  double rest[3] = {};
  for (std::int32_t k = parts - 1; k >= 0; --k) {
    const double part_of_step = parts == 1 ? 1.0 : share[k] / whole;
    last = part_of_step * rolled;
    const double to_come = left_of_step(share, k) / whole;
    if (parts > 1) place_strips(1.0 - to_come);
    set_own(part_of_step * travel);
    double shift[3];
    for (int i = 0; i < 3; ++i) {
      of_part[i] = part_of_step * travel * per[i];
      shift[i] = of_part[i] + carried * rest[i];
    }
    solve_part(shift, last, {k == parts - 1, part_of_step, to_come}, local, rest);
  }
  for (std::int32_t j = 0; j < contact_.region.count; ++j) strips_.written[j].y = key(j);
}

double last_part(double length) { return usual_parts[0] * std::max(length, least); }

double PatchStep::follows(double rolled) const {
  const double length = std::max(numbers_.length, least);
  return 1.0 - (1.0 - forgotten(rolled, length)) * natural_exp(-rolled / (factors_.follows * 0.5 * length));
}

double PatchStep::per_length(double size, double length) {
  // no more than slides everywhere: creepages of 10
  constexpr double most = 10.0;
  return std::min(1.0 / std::max(length, least), most / std::max(size, least));
}

bool hardly_rolls(double rolled, double length) { return rolled <= least_step * std::max(length, least); }
double forgotten(double rolled, double length) {
  return smooth_step((rolled / std::max(length, least) - forgets_from) / (all_forgotten - forgets_from));
}
void tend_to(const PastStrip& __restrict steady, double share, PastStrip& __restrict strip) {
  const double own = 1.0 - share;
  for (std::int32_t i = 0; i < cells; ++i) strip.px[i] = own * strip.px[i] + share * steady.px[i];
  for (std::int32_t i = 0; i < cells; ++i) strip.py[i] = own * strip.py[i] + share * steady.py[i];
  for (int i = 0; i < 3; ++i) strip.force[i] = own * strip.force[i] + share * steady.force[i];
}

double stored_in(const PastStrip& strip, double area, double growth_x, double growth_y) {
  // 1/2 L p^2; the sums of both halves do not wait for one another
  double x2[2] = {}, y2[2] = {};
  for (std::int32_t i = 0; i < half; ++i) {
    x2[0] += strip.px[i] * strip.px[i];
    y2[0] += strip.py[i] * strip.py[i];
    x2[1] += strip.px[half + i] * strip.px[half + i];
    y2[1] += strip.py[half + i] * strip.py[half + i];
  }
  return 0.5 * area * ((x2[0] + x2[1]) / growth_x + (y2[0] + y2[1]) / growth_y);
}

double stored_by(const double yield[3], const double force[3]) {
  // 1/2 S F^2
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) sum += 0.5 * yield[i] * force[i] * force[i];
  return sum;
}

void add_cells(double weight, const double* __restrict from, double* __restrict to) {
  for (std::int32_t i = 0; i < cells; ++i) to[i] += weight * from[i];
}

void lower(double scale, PastStrip& strip) {
  for (std::int32_t i = 0; i < cells; ++i) {
    strip.px[i] *= scale;
    strip.py[i] *= scale;
  }
  for (double& part : strip.force) part *= scale;
}

EnergyLeft count_energy(double before, double work, double stored) {
  // before + scale work >= kept_back scale^2 stored
  EnergyLeft e;
  const double least_kept = kept_back * stored;
  if (before + work < least_kept) {
    e.scale = least_kept > 0.0
                  ? (work + std::sqrt(work * work + 4.0 * least_kept * before)) / (2.0 * least_kept)
                  : (work < 0.0 ? before / -work : 1.0);
    e.scale = std::clamp(e.scale, 0.0, 1.0);
  }
  const double there = std::max(0.0, before + e.scale * work);
  e.left = std::min(e.scale * e.scale * stored, there);
  e.dissipated = there - e.left;
  return e;
}

const double* memory_places() { return places.at; }

}  // namespace wrc::tangential
