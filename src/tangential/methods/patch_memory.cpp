#include "tangential/methods/patch_memory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.hpp"
#include "base/number.hpp"
#include "kernels/kernels.hpp"

namespace wrc::tangential {
namespace {

constexpr std::int32_t cells = memory_cells;

// Lengths of the longest strip: a step that is none; parts of a step, from its end on.
constexpr double least_step = 1e-9;
constexpr std::int32_t most_parts = 3;
constexpr double usual_parts[most_parts] = {0.25, 0.5, all_forgotten};
constexpr double yields_whole = 0.6,
                 yields_none = 2.0;    // parts of which the end sees all and none of the yield
constexpr std::int32_t solutions = 2;  // Newton's steps for U in the last part, one in those before
constexpr double carried = 0.5;        // share of the rest of the equation that goes to the next part

/// Middles of the cells over the half length.
struct Places {
  double at[cells];
};
constexpr Places places = [] {
  Places p{};
  for (std::int32_t i = 0; i < cells; ++i) p.at[i] = 1.0 - (2.0 * i + 1.0) / cells;
  return p;
}();

/// Parts of the step that come after the k-th, of those counted from its end on.
double left_of_step(const double* share, std::int32_t k) {
  double left = 0.0;
  for (std::int32_t i = 0; i < k; ++i) left += share[i];
  return left;
}

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

/// Solves n equations, whose right-hand sides are the last column; the solution takes its place.
template <std::int32_t columns>
void solve(std::int32_t n, double (*m)[columns]) {
  for (std::int32_t p = 0; p < n; ++p) {
    std::int32_t largest = p;
    for (std::int32_t i = p + 1; i < n; ++i)
      if (std::abs(m[i][p]) > std::abs(m[largest][p])) largest = i;
    if (largest != p) std::swap_ranges(m[p], m[p] + n + 1, m[largest]);
    for (std::int32_t i = p + 1; i < n; ++i) {
      const double f = m[i][p] / m[p][p];
      for (std::int32_t j = p + 1; j <= n; ++j) m[i][j] -= f * m[p][j];
    }
  }
  for (std::int32_t i = n - 1; i >= 0; --i) {
    for (std::int32_t j = i + 1; j < n; ++j) m[i][n] -= m[i][j] * m[j][n];
    m[i][n] /= m[i][i];
  }
}

}  // namespace

PatchStep::PatchStep(const RollingContact& contact, const PatchStrips& strips, YieldingPatch* patches,
                     std::int32_t count)
    : contact_(contact),
      strips_(strips),
      patches_(patches),
      patch_count_(count),
      x_(patches->numbers.centre_x),
      y_(patches->numbers.centre_y) {
  set_strips();
  find_groups();
  for (std::int32_t l = 0; l < lobes_; ++l)
    for (std::int32_t k = 0; k < lobes_; ++k) std::fill_n(yield_[l][k][0], 9, 0.0);
  for (std::int32_t k = 0; k < count; ++k) add_yield(patches[k]);
  if (strips_.number) let_strips_leave();
}

void PatchStep::find_groups() {
  // The strips within each lobe, and the one across its border to the next. Lobes begin where the one before
  // ends: of a border between two strips, rounding may leave a hair of one on either side.
  std::int32_t within = 0;
  for (std::int32_t k = 0; k < patch_count_; ++k) {
    const YieldingPatch& p = patches_[k];
    lobes_ = std::max(lobes_, p.end_lobe);
    if (p.end_lobe - p.first_lobe > 1) continue;
    const std::int32_t end = p.end - strips_.first, border = end - (p.inside_last < 1.0 ? 1 : 0);
    if (within < border) groups_[group_count_++] = {within, border, p.first_lobe, 1.0};
    within = std::max(within, border);
    if (within < end) groups_[group_count_++] = {within, end, p.first_lobe, p.inside_last};
    within = std::max(within, end);
  }
}

void PatchStep::let_strips_leave() {
  // Strips whose bounds have fallen far below their force are among those that leave, the more the further.
  constexpr double far = 0.25;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    RememberingStrip& strip = strips_.strips[j];
    const PastStrip* const past = strips_.past_of[j];
    if (past == nullptr) continue;
    const double borne = strip.area * strip.bounds;
    const double had2 = far * far * (past->force[0] * past->force[0] + past->force[1] * past->force[1]);
    if (borne * borne >= had2) continue;
    strip.kept = borne / std::sqrt(had2);
    const double sign = contact_.memory.direction;
    const double force[3] = {sign * past->force[0], past->force[1], sign * past->force[2]};
    for (std::int32_t k = 0; k < patch_count_; ++k) {
      YieldingPatch& p = patches_[k];
      const std::int32_t number = strips_.first + j;
      if (number < p.first || number >= p.end) continue;
      const double leaves = (1.0 - strip.kept) * p.inside(number), x = sign * past->centre;
      p.add_force(-leaves, force, x, contact_.region.y[j], p.before);
      p.add_force(leaves, force, x, contact_.region.y[j], p.left);
    }
  }
}

Neighbours PatchStep::past_of(std::int32_t j) const {
  if (!strips_.number) return neighbours(strips_.past, strips_.past_count, key(j));
  return {strips_.past_of[j], nullptr};
}

void PatchStep::set_strips() {
  const patch::Strips& r = contact_.region;
  for (std::int32_t j = 0; j < r.count; ++j) {
    RememberingStrip& strip = strips_.strips[j];
    strip.centre = r.centre[j];
    strip.half_length = r.half_length[j];
    strip.area = r.width[j] * r.half_length[j] * (2.0 / cells);
    strip.kept = 1.0;
    strip.y = r.y[j] - y_;
    strip.x = r.centre[j] - x_;
    complete_bounds(strip);
  }
}

void PatchStep::place_strips(double done) {
  // between their places of before and those at the end of the step; new strips have had theirs
  const double sign = contact_.memory.direction;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    RememberingStrip& strip = strips_.strips[j];
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
    strip.x = centre - x_;
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
    RememberingStrip& to = strips_.strips[j];
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
    std::fill_n(to.had, half_cells, 0.0);
    const auto add = [&](const PastStrip* one, double share) {
      if (one == nullptr) return;
      for (std::int32_t i = 0; i < half_cells; ++i) to.had[i] += share * one->bound[i];
      task.weight = share;
      if (contact_.memory.direction > 0.0)
        brought(*one, to);
      else
        brought(turned(*one, -1.0), to);
      task.adds = true;
    };
    add(from.first, from.of_first);
    add(from.second, from.of_second);
    for (std::int32_t i = 0; i < half_cells; ++i) to.had[cells - 1 - i] = to.had[i];
    // tractions that leave with their strip; the cells are displaced all the same
    if (to.kept == 1.0) continue;
    for (double* const numbers : {to.px, to.py, to.had})
      for (std::int32_t i = 0; i < cells; ++i) numbers[i] *= to.kept;
  }
}

void PatchStep::motion_by(const YieldingPatch& patch, const double displaced[3], double motion[3]) const {
  // motion about x_, y_ by a displacement of the patch: as its cells see it, with the factor on arms
  const double turn = patch.numbers.arm * displaced[2];
  motion[0] = displaced[0] + turn * (patch.numbers.centre_y - y_);
  motion[1] = displaced[1] - turn * (patch.numbers.centre_x - x_);
  motion[2] = turn;
}

void PatchStep::force_of_patch(const YieldingPatch& patch, const double (*of_lobes)[3], double of[3]) const {
  of[0] = of[1] = of[2] = 0.0;
  for (std::int32_t l = patch.first_lobe; l < patch.end_lobe; ++l)
    patch.add_force(1.0, of_lobes[l], x_, y_, of);
}

void PatchStep::add_yield(const YieldingPatch& patch) {
  // T S T' of the patch, T its motion by a displacement, to that of its lobes by forces on them
  const double arm = patch.numbers.arm, x = patch.numbers.centre_x - x_, y = patch.numbers.centre_y - y_;
  const double* const of = patch.numbers.yield;
  const double turn = of[2] * arm * arm;
  const double s[3][3] = {{of[0] + turn * y * y, -(turn * x * y), turn * y},
                          {-(turn * x * y), of[1] + turn * x * x, -(turn * x)},
                          {turn * y, -(turn * x), turn}};
  for (std::int32_t l = patch.first_lobe; l < patch.end_lobe; ++l)
    for (std::int32_t k = patch.first_lobe; k < patch.end_lobe; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) yield_[l][k][i][j] += patch.share * s[i][j];
}

void PatchStep::find_motions() {
  // those of the lobes: means of the patches' by their shares
  for (std::int32_t l = 0; l < lobes_; ++l) std::fill_n(motion_[l], 3, 0.0);
  for (std::int32_t k = 0; k < patch_count_; ++k) {
    const YieldingPatch& p = patches_[k];
    double motion[3];
    motion_by(p, p.local, motion);
    for (std::int32_t l = p.first_lobe; l < p.end_lobe; ++l)
      for (int i = 0; i < 3; ++i) motion_[l][i] += p.share * motion[i];
  }
}

void PatchStep::aim(simd::MemoryPassTask& task, const Group& group) const {
  task.strips = group.end - group.first;
  task.from = strips_.strips + group.first;
  task.px = strips_.written[group.first].px;
  task.force = strips_.written[group.first].force;
  std::copy_n(motion_[group.lobe], 3, task.local);
  if (group.share == 1.0) return;
  const double* const next = motion_[group.lobe + 1];
  for (int i = 0; i < 3; ++i) task.local[i] += (1.0 - group.share) * (next[i] - task.local[i]);
}

void PatchStep::sum_lobes(simd::MemoryPassTask& task, LobeSums& sums) const {
  for (std::int32_t l = 0; l < lobes_; ++l) {
    std::fill_n(sums.force[l], 3, 0.0);
    for (std::int32_t k = 0; k < lobes_; ++k) std::fill_n(sums.slope[l][k][0], 9, 0.0);
  }
  // a strip across a border has its shares in both lobes
  for (std::int32_t g = 0; g < group_count_; ++g) {
    const Group& group = groups_[g];
    aim(task, group);
    simd::MemoryPassSums of;
    contact_.grid->kernels->tangential.memory_pass_sums(task, of);
    const double share[2] = {group.share, 1.0 - group.share};
    const int lobes = group.share < 1.0 ? 2 : 1;
    for (int a = 0; a < lobes; ++a) {
      for (int i = 0; i < 3; ++i) sums.force[group.lobe + a][i] += share[a] * of.force[i];
      for (int b = 0; b < lobes; ++b)
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k)
            sums.slope[group.lobe + a][group.lobe + b][i][k] += share[a] * share[b] * of.slope[i][k];
    }
  }
}

template <std::int32_t known>
void PatchStep::take_newton_step(double yields, LobeSums& sums) {
  // Motions m of the lobes, their forces f - K dm: dm is the sum of T (shift + S (F - F') - local) over the
  // patches, by shares, less the yield by K dm.
  constexpr std::int32_t most = 3 * most_lobes;
  const std::int32_t lobes = known > 0 ? known : lobes_, n = 3 * lobes;
  double m[most][most + 1];
  // 1 + S K
  for (std::int32_t l = 0; l < lobes; ++l)
    for (int i = 0; i < 3; ++i) {
      double* const row = m[3 * l + i];
      std::fill_n(row, n + 1, 0.0);
      for (std::int32_t q = 0; q < lobes; ++q)
        for (int p = 0; p < 3; ++p) {
          const double yield = yields * yield_[l][q][i][p];
          for (std::int32_t k = 0; k < lobes; ++k)
            for (int j = 0; j < 3; ++j) row[3 * k + j] += yield * sums.slope[q][k][p][j];
        }
      row[3 * l + i] += 1.0;
    }
  for (std::int32_t at = 0; at < patch_count_; ++at) {
    const YieldingPatch& p = patches_[at];
    double force[3], rest[3], motion[3];
    force_of_patch(p, sums.force, force);
    // by how much the displacement is too small
    for (int i = 0; i < 3; ++i) rest[i] = p.shift[i] + p.yield[i] * (force[i] - p.before[i]) - p.local[i];
    motion_by(p, rest, motion);
    for (std::int32_t l = p.first_lobe; l < p.end_lobe; ++l)
      for (int i = 0; i < 3; ++i) m[3 * l + i][n] += p.share * motion[i];
  }
  solve(n, m);
  // the displacements of the patches by those forces
  for (std::int32_t l = 0; l < lobes; ++l)
    for (std::int32_t k = 0; k < lobes; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sums.force[l][i] -= sums.slope[l][k][i][j] * m[3 * k + j][n];
  for (std::int32_t at = 0; at < patch_count_; ++at) {
    YieldingPatch& p = patches_[at];
    double force[3];
    force_of_patch(p, sums.force, force);
    for (int i = 0; i < 3; ++i) p.local[i] = p.shift[i] + p.yield[i] * (force[i] - p.before[i]);
  }
  find_motions();
}

void PatchStep::solve_part(const double of_part[3], double h, double travel, const Part& part) {
  // local = shift + S (F - F'), by Newton's method, from no yield; F' of strips that leave in proportion
  bring(h, part.first);
  simd::MemoryPassTask task{0,      nullptr,      places.at, {},      h,
                            travel, part.to_come, nullptr,   nullptr, sizeof(PastStrip) / sizeof(double)};
  // cells at the end of a long part have seen less of the yield than those that have left
  const double yields = 1.0 - smooth_step((h / std::max(length(), least_divisor) - yields_whole) /
                                          (yields_none - yields_whole));
  // each part begins from no yield, with the rest of the equation that the part before has left
  for (std::int32_t k = 0; k < patch_count_; ++k) {
    YieldingPatch& p = patches_[k];
    for (int i = 0; i < 3; ++i) {
      p.yield[i] = yields * p.numbers.yield[i];
      p.before[i] += part.share * p.left[i];
      p.local[i] = p.shift[i] = of_part[i] + carried * p.rest[i];
    }
  }
  find_motions();
  for (int solution = part.to_come > 0.0 ? 1 : 0; solution < solutions; ++solution) {
    LobeSums sums;
    sum_lobes(task, sums);
    if (lobes_ == 1)
      take_newton_step<1>(yields, sums);
    else if (lobes_ == 2)
      take_newton_step<2>(yields, sums);
    else
      take_newton_step<0>(yields, sums);
  }
  // tractions, and the forces of the strips
  for (std::int32_t g = 0; g < group_count_; ++g) {
    aim(task, groups_[g]);
    contact_.grid->kernels->tangential.memory_pass(task);
  }
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    strips_.written[j].centre = strips_.strips[j].centre;
    strips_.written[j].half_length = strips_.strips[j].half_length;
  }
  // forces before the next part, and the rest of the equation
  double force[most_lobes][3];
  written_forces(force);
  for (std::int32_t k = 0; k < patch_count_; ++k) {
    YieldingPatch& p = patches_[k];
    double of[3];
    force_of_patch(p, force, of);
    for (int i = 0; i < 3; ++i) {
      p.rest[i] = p.shift[i] + p.yield[i] * (of[i] - p.before[i]) - p.local[i];
      p.before[i] = of[i];
    }
  }
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
  double motion[3], force[3] = {};
  motion_by(*patches_, per, motion);
  march_steadily(contact_, strips_.strips, contact_.region.count, motion, h, into);
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    into[j].y = key(j);
    into[j].centre = contact_.region.centre[j];
    into[j].half_length = contact_.region.half_length[j];
    for (int i = 0; i < 3; ++i) force[i] += into[j].force[i];
  }
  force_of_patch(*patches_, &force, of);
}

void PatchStep::written_forces(double (*of_lobes)[3]) const {
  for (std::int32_t l = 0; l < lobes_; ++l) std::fill_n(of_lobes[l], 3, 0.0);
  for (std::int32_t g = 0; g < group_count_; ++g) {
    const Group& group = groups_[g];
    double sum[3] = {};
    for (std::int32_t j = group.first; j < group.end; ++j)
      for (int i = 0; i < 3; ++i) sum[i] += strips_.written[j].force[i];
    for (int i = 0; i < 3; ++i) of_lobes[group.lobe][i] += group.share * sum[i];
    if (group.share < 1.0)
      for (int i = 0; i < 3; ++i) of_lobes[group.lobe + 1][i] += (1.0 - group.share) * sum[i];
  }
}

void PatchStep::forces(double of[3]) const {
  double force[most_lobes][3];
  written_forces(force);
  force_of_patch(*patches_, force, of);
}

double PatchStep::stored() const {
  double force[most_lobes][3], sum = 0.0;
  written_forces(force);
  for (std::int32_t k = 0; k < patch_count_; ++k) {
    double of[3];
    force_of_patch(patches_[k], force, of);
    sum += patches_[k].share * stored_by(patches_[k].numbers.yield, of);
  }
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const RememberingStrip& at = strips_.strips[j];
    sum +=
        stored_in(contact_.grid->kernels->tangential, strips_.written[j], at.area, at.growth_x, at.growth_y);
  }
  return sum;
}

void PatchStep::lower(double scale) {
  for (std::int32_t j = 0; j < contact_.region.count; ++j) tangential::lower(scale, strips_.written[j]);
}

double PatchStep::adhesion_fraction() const {
  double sticks = 0.0, whole = 0.0;
  for (std::int32_t j = 0; j < contact_.region.count; ++j) {
    const RememberingStrip& at = strips_.strips[j];
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

void PatchStep::go(const double per[3], double travel, double rolled, double of_part[3], double& last) {
  // Parts from the end of the step on; those before the last are seen less.
  double left = rolled / std::max(length(), least_divisor), share[most_parts];
  std::int32_t parts = 0;
  for (const double usual : usual_parts) {
    if (parts > 0 && !(left > 0.0)) break;
    share[parts++] = std::min(left, usual);
    left -= usual;
  }
  const double whole = std::max(rolled / std::max(length(), least_divisor), least_divisor);
  for (std::int32_t k = parts - 1; k >= 0; --k) {
    const double part_of_step = parts == 1 ? 1.0 : share[k] / whole;
    last = part_of_step * rolled;
    const double to_come = left_of_step(share, k) / whole;
    if (parts > 1) place_strips(1.0 - to_come);
    for (int i = 0; i < 3; ++i) of_part[i] = part_of_step * travel * per[i];
    solve_part(of_part, last, part_of_step * travel, {k == parts - 1, part_of_step, to_come});
  }
  for (std::int32_t j = 0; j < contact_.region.count; ++j) strips_.written[j].y = key(j);
}

double last_part(double length) { return usual_parts[0] * std::max(length, least_divisor); }

double follows(const PatchNumbers& numbers, double rolled, const MemoryFactors& factors) {
  const double length = std::max(numbers.length, least_divisor);
  return 1.0 - (1.0 - forgotten(rolled / length)) * natural_exp(-rolled / (factors.follows * 0.5 * length));
}

double per_length(double size, double length) {
  // no more than slides everywhere: creepages of 10
  constexpr double most = 10.0;
  return std::min(1.0 / std::max(length, least_divisor), most / std::max(size, least_divisor));
}

bool hardly_rolls(double rolled, double length) {
  return rolled <= least_step * std::max(length, least_divisor);
}

}  // namespace wrc::tangential
