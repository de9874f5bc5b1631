#include "surface/pressure/start.hpp"

#include "base/number.hpp"
#include "surface/pressure/smoothing.hpp"

namespace wrc::surface {
namespace {

constexpr double coarse_tolerance = 0.3;  ///< for the solution on pairs, part of the area
constexpr std::int32_t fewest_pairs = 12;
/// Part of a hill's overlap from which on few strips press at first. Others enter as soon as they are asked:
/// where all press at first, most leave again, and small contacts take half of their work in doing so.
constexpr double upper_part = 2.0 / 3.0;
constexpr std::int32_t most_by_hills = 64;  ///< strips of contacts that are like Hertz's
/// Parts of the growth of an overlap, in the mean and beside that, that L follows: fewest iterations on poses
/// a millisecond apart.
constexpr double follows_mean = 0.9, follows_rest = 1.4;
constexpr double farthest_extrapolated = 2.0;  ///< most times an earlier change in an extrapolation
/// Share of the earlier change, squared, that is added to its rest beside the later one in the division: a
/// rest below this share hardly counts [-].
constexpr double hardly_across = 3e-3;

/// Growth of a strip's L at a rim, by its way into contact [-]: with the square of the way at first, then in
/// proportion to it. Beside contact both are negative and in proportion (activate()).
struct RimGrowth {
  static constexpr double of_fall = 0.25;    ///< part of the difference of L between the strips beside
  static constexpr double least = 1e-12;     ///< [m^2]
  static constexpr double at_entry = 0.1;    ///< growth by the way at L = 0, over that far inside [-]
  static constexpr double far_inside = 8.0;  ///< in sizes, from where on L grows in proportion

  double size, per_size;  ///< L by which the way is measured [m^2], and its inverse

  RimGrowth(double before, double behind)
      : size(larger(of_fall * magnitude(behind - before), least)), per_size(1.0 / size) {}

  // L / size = sqrt(1 + (way + b)^2) - sqrt(1 + b^2), b = at_entry
  double way(double L) const {
    const double sizes = L * per_size, up = sizes + root(1.0 + at_entry * at_entry);
    return L > 0.0 ? root(up * up - 1.0) - at_entry : sizes;
  }
  double length_squared(double way) const {
    const double from = way + at_entry;
    return size * (way > 0.0 ? root(1.0 + from * from) - root(1.0 + at_entry * at_entry) : way);
  }
};

/// Joins neighbouring strips to pairs in w.coarse, a lone one where its neighbour is missing: means by width.
void pair_up(const Overlaps& o, PressureScratch& w) {
  const StripSet& s = w.fine;
  StripSet& c = w.coarse;
  c.count = c.behind = 0;
  for (std::int32_t i = 0; i < s.count;) {
    // Neighbours on the rail; at a gap between two faces or the end of the candidates a strip stays alone.
    const bool two = i + 1 < s.count && o.strip[i + 1] == o.strip[i] + 1;
    const std::int32_t j = two ? i + 1 : i, k = c.count++;
    const double a = s.width[i], b = two ? s.width[j] : 0.0, per = 1.0 / (a + b);
    const auto mean = [&](const double* v) { return (a * v[i] + b * v[j]) * per; };
    c.place[k] = mean(s.place);
    c.width[k] = a + b;
    c.depth[k] = mean(s.depth);
    c.curvature[k] = mean(s.curvature);
    c.deepest_x[k] = mean(s.deepest_x);
    c.ny[k] = mean(s.ny);
    c.nz[k] = mean(s.nz);
    c.L[k] = mean(s.L);
    c.shift[k] = mean(s.shift);
    w.pair_of[i] = w.pair_of[j] = k;
    c.behind += i < s.behind ? 1 : 0;
    i = j + 1;
  }
}

/// Gives pairs beside contact the L that goes on from the two inside on a line, at most 0: contact ends where
/// L vanishes, not in the middle of a pair.
void continue_outside(StripSet& c) {
  const auto inside = [&](std::int32_t k) { return k >= 0 && k < c.count && c.q[k] > 0.0; };
  const auto same_row = [&](std::int32_t j, std::int32_t k) { return (j < c.behind) == (k < c.behind); };
  for (std::int32_t k = 0; k < c.count; ++k) {
    if (inside(k)) continue;
    double L = -any_change;
    for (const std::int32_t way : {-1, 1}) {
      const std::int32_t near = k + way, next = near + way;
      if (!inside(near) || !inside(next) || !same_row(next, k)) continue;
      const double part = (c.place[k] - c.place[near]) / (c.place[near] - c.place[next]);
      L = larger(L, c.L[near] + part * (c.L[near] - c.L[next]));
    }
    c.L[k] = L > -any_change ? smaller(L, 0.0) : 0.0;
  }
}

/// L of the strips on parabolas through three of the solved pairs, shifts on lines through two.
void interpolate_pairs(PressureScratch& w) {
  const StripSet& s = w.fine;
  StripSet& c = w.coarse;
  continue_outside(c);
  const auto adjoins = [&](std::int32_t j, std::int32_t k) {
    return j >= 0 && j < c.count && (j < c.behind) == (k < c.behind) &&
           magnitude(c.place[j] - c.place[k]) <= 1.5 * c.width[k];
  };
  for (std::int32_t i = 0; i < s.count; ++i) {
    const std::int32_t k = w.pair_of[i];
    const double off = s.place[i] - c.place[k];
    double L = c.L[k];
    s.shift[i] = c.shift[k];
    // The line to the next pair on the strip's side, if that is next to it.
    const std::int32_t side = off > 0.0 ? 1 : -1, ahead = k + side, behind = k - side;
    if (off != 0.0 && adjoins(ahead, k)) {
      const double apart = c.place[ahead] - c.place[k], slope = (c.L[ahead] - c.L[k]) / apart;
      L += off * slope;
      s.shift[i] += off / apart * (c.shift[ahead] - c.shift[k]);
      // Its bend, by the pair on the other side. Beside contact there is none.
      if (c.q[k] > 0.0 && adjoins(behind, k)) {
        const double before = c.place[k] - c.place[behind], slope_before = (c.L[k] - c.L[behind]) / before;
        L += off * (off - apart) * (slope - slope_before) / (apart + before);
      }
    }
    s.L[i] = larger(L, 0.0);
  }
}

/// A change of L and the share of it that is to come.
struct ShareOfChange {
  double change, share;
};

/// L with shares of its changes, of which the second ended where the first began; 0: not known.
double extrapolated(const RimGrowth& rim, double L, ShareOfChange first, ShareOfChange second) {
  if (magnitude(L) > RimGrowth::far_inside * rim.size)
    return L + first.share * first.change + second.share * second.change;
  // The way into contact of the three solutions, as far as they are known.
  const double earlier = L - first.change, now = rim.way(L), then = rim.way(earlier);
  double way = now + first.share * (now - then);
  if (second.change != 0.0) way += second.share * (then - rim.way(earlier - second.change));
  return rim.length_squared(way);
}

/// A hill of overlap as D - A x^2 - 2 C x y - B y^2, y across from the line where strips are deepest.
struct Hill {
  std::int32_t top;   ///< the strip where it is deepest
  double D, A, turn;  ///< there [m], [1/m]; slope of the deepest places by y [-]
  double own_B;       ///< B - C^2 / A: curvature along the line of the deepest places [1/m]
};

/// The hill over strips of one row, from `first` up to `end`: by its top, its volume 4/3 D b, b its half
/// width, and the line of least squares through the deepest places.
Hill hill_over(const StripSet& s, std::int32_t first, std::int32_t end) {
  // moments over the strips' places of the overlap, and of where it is deepest
  std::int32_t top = first;
  double volume = 0.0, y1 = 0.0, y2 = 0.0, x1 = 0.0, xy = 0.0;
  for (std::int32_t i = first; i < end; ++i) {
    if (s.depth[i] > s.depth[top]) top = i;
    const double weight = s.width[i] * s.depth[i], y = s.place[i] - s.place[first];
    volume += weight;
    y1 += weight * y;
    y2 += weight * y * y;
    x1 += weight * s.deepest_x[i];
    xy += weight * y * s.deepest_x[i];
  }
  // least squares for the line; a parabola's half width b follows from the volume
  const double D = s.depth[top], spread = y2 - y1 * y1 / volume;
  const double b = 0.75 * volume / D;
  return {top, D, 0.5 * s.curvature[top], spread > 0.0 ? (xy - x1 * y1 / volume) / spread : 0.0, D / (b * b)};
}

/// Lengths and shifts of a hill's strips by Hertz's theory.
///
/// The contact is P x^2 + 2 R x y + Q y^2 < D, of the same axes as the overlap. On the axes its curvatures
/// are those of the overlap over rho on the longer one, over 1 - rho on the other, rho = (K - E) / (e^2 K).
/// The fit rho / (1 - rho) = (shorter / longer)^(5/16) is right to 0.005 for axes up to 5 to 1.
void touch_hill(const StripSet& s, std::int32_t first, std::int32_t end) {
  constexpr double least = 1e-3;      // curvature of the longer axis over the mean
  constexpr double of_round = 2.625;  // limit of f for equal axes
  // the form A, B, C of the overlap [1/m], and its curvatures mean -+ h on the axes
  const Hill hill = hill_over(s, first, end);
  const double A = hill.A, C = -A * hill.turn, B = hill.own_B - C * hill.turn;
  const double mean = 0.5 * (A + B), differ = 0.5 * (A - B), h = root(differ * differ + C * C);
  const double longer = larger(mean - h, least * mean), shorter = mean + h;
  // curvatures of the contact on the same axes, and its form P, Q, R [1/m]
  const double quotient = root(shorter / longer), odds = root(quotient) * root(root(root(quotient)));
  const double on_longer = longer * (1.0 + odds) / odds, on_shorter = shorter * (1.0 + odds);
  const double middle = 0.5 * (on_longer + on_shorter);
  const double f = h > 1e-4 * mean ? 0.5 * (on_shorter - on_longer) / h : of_round;
  const double P = middle + f * differ, Q = middle - f * differ, R = f * C;
  // on strips by their own overlaps and curvatures: L = (D - (Q - R^2 / P) y^2) / P, and the centre's slope
  // -R / P
  const double along = A / P, across = hill.own_B / (Q - R * R / P);
  for (std::int32_t i = first; i < end; ++i) {
    const double rest = s.depth[i] - (1.0 - across) * hill.D;
    s.L[i] = larger(2.0 * along / across * rest, 0.0) / s.curvature[i];
    const double shift = (s.deepest_x[i] - s.deepest_x[hill.top]) * (f * along - 1.0);
    s.shift[i] = smaller(larger(shift, -longest_shift), longest_shift);
  }
}

/// Lengths and shifts of hills of overlap: runs of one row, parted at valleys.
void touch_hills(const StripSet& s) {
  constexpr double parted = 0.8;  // depth of a valley over the tops
  const auto goes_on = [&](std::int32_t i) {
    return i + 1 < s.count && i + 1 != s.behind && s.depth[i + 1] > 0.0 &&
           s.place[i + 1] - s.place[i] < 0.75 * (s.width[i] + s.width[i + 1]);
  };
  for (std::int32_t i = 0; i < s.count;) {
    s.L[i] = s.shift[i] = 0.0;
    if (!(s.depth[i] > 0.0)) {
      ++i;
      continue;
    }
    // a run: a valley below both tops beside it ends one hill and begins the next
    std::int32_t first = i, low = i;
    double top = s.depth[i];
    for (;; ++i) {
      const double depth = s.depth[i];
      if (depth < s.depth[low]) low = i;
      if (s.depth[low] < parted * top && s.depth[low] < parted * depth) {
        touch_hill(s, first, low);
        first = low;
        low = i;
        top = depth;
      }
      if (depth > top) {
        top = depth;
        low = i;
      }
      if (!goes_on(i)) break;
    }
    touch_hill(s, first, ++i);
  }
}

}  // namespace

std::int32_t start_from_overlaps(const PressureProblem& problem, const Overlaps& o, double max_work,
                                 PressureScratch& w, std::int32_t most) {
  if (problem.along_track && w.fine.count <= most_by_hills) {
    touch_hills(w.fine);
    return 0;
  }
  const StripSet& s = w.fine;
  const bool few = s.count < 2 * fewest_pairs;
  // D, the overlap on top of the hill that a strip lies on: on the way up to the left, then to the right.
  double* const top = w.next;  // no iteration has begun
  for (std::int32_t i = 0; i < s.count; ++i)
    top[i] = i > 0 && s.depth[i - 1] > s.depth[i] ? top[i - 1] : s.depth[i];
  double to_right = 0.0;
  for (std::int32_t i = s.count - 1; i >= 0; --i) {
    const double d = s.depth[i];
    if (!(i + 1 < s.count && s.depth[i + 1] > d)) to_right = d;
    const double D = larger(top[i], to_right);
    // Few strips: half of the overlap's own squared half length, 2 d / kappa, on the upper part of a hill.
    // Hertz's a^2 = R d between spheres. Many: (2 d - D) / kappa, as contact of spheres ends where d = D / 2.
    s.L[i] = larger(few ? (d < upper_part * D ? 0.0 : d) : 2.0 * d - D, 0.0) / s.curvature[i];
    s.shift[i] = 0.0;
  }
  if (few) return 0;
  pair_up(o, w);
  // An iteration over all strips must be left.
  const IterationLimits on_pairs{coarse_tolerance, any_change, max_work - 2.0 * work_of_pass(s.count),
                                 any_change, most};
  const std::int32_t spent = iterate(problem, w.coarse, on_pairs, w).iterations;
  interpolate_pairs(w);
  return spent;
}

void extrapolate_start(const RailStrips& rail, const Overlaps& o, PressureStart& start) {
  const SolutionChange first = start.change;
  // One that is not known counts as the later one, of which nothing is left beside that.
  const SolutionChange second = start.earlier.depth ? start.earlier : first;
  start.change = start.earlier = {};
  if (!first.depth) return;
  // Products of the overlaps' growth by areas: in the later change (1), in the earlier one (2), and since
  // (no number).
  double a11 = 0.0, a12 = 0.0, a22 = 0.0, a1 = 0.0, a2 = 0.0;
  for_shared_strips(o.count, o.strip, start.count, start.strip, [&](std::int32_t i, std::int32_t b) {
    const double weight = rail.width[on_rail(o.strip[i])] * larger(start.length_squared[b], 0.0);
    const double along = weight * first.depth[b], across = weight * second.depth[b];
    const double grown = o.depth[i] - start.depth[b];
    a11 += along * first.depth[b];
    a12 += along * second.depth[b];
    a22 += across * second.depth[b];
    a1 += along * grown;
    a2 += across * grown;
  });
  if (!(a11 > 0.0)) return;
  const auto limited = [](double share) {
    return smaller(larger(share, -farthest_extrapolated), farthest_extrapolated);
  };
  // The growth since, projected on that of the later change, then on the rest of the earlier one, which is
  // not along the later one.
  const double part = a12 / a11, rest = a22 - part * a12;
  const double later = limited(a1 / a11);
  const double earlier = rest > 0.0 ? limited((a2 - part * a1) / (rest + hardly_across * a22)) : 0.0;
  const double share = later - part * earlier;
  double before = 0.0;  // L of the strip before, not extrapolated [m^2]
  for (std::int32_t b = 0; b < start.count; ++b) {
    // Strips beside, if they are next to it on the rail; the fall of L between them measures the way at a
    // rim.
    const double L = start.length_squared[b];
    const bool follows = b > 0 && start.strip[b - 1] == start.strip[b] - 1.0;
    const bool leads = b + 1 < start.count && start.strip[b + 1] == start.strip[b] + 1.0;
    const RimGrowth rim(follows ? before : L, leads ? start.length_squared[b + 1] : L);
    before = L;
    if (L == 0.0) continue;
    start.length_squared[b] =
        extrapolated(rim, L, {first.length_squared[b], share}, {second.length_squared[b], earlier});
    start.shift[b] += share * first.shift[b] + earlier * second.shift[b];
    start.depth[b] += share * first.depth[b] + earlier * second.depth[b];
  }
}

bool follow_overlaps(double farthest, PressureScratch& w) {
  const StripSet& s = w.fine;
  // Mean growth of the overlaps in contact [m], by the areas of their strips.
  double longest = 0.0, deepest = 0.0, weights = 0.0, mean = 0.0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (!(s.L[i] > 0.0)) continue;
    const double before = w.depth_before[i], weight = s.width[i] * s.L[i];
    longest = larger(longest, s.L[i]);
    deepest = larger(deepest, before);
    weights += weight;
    mean += weight * (s.depth[i] - before);
  }
  if (!(deepest > 0.0)) return true;
  mean = mean / weights;

  // In Hertz's contact of equal curvatures L grows by L / d times a growth of d that is the same everywhere,
  // and twice as much with overlap that moves sideways: overlaps of a near pose tell how much of either there
  // is.
  const double per = longest / deepest;
  double moved = 0.0, area = 0.0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (!(s.L[i] > 0.0)) continue;
    // Within a factor of four, so that strips at the rim stay in contact.
    const double grown = s.depth[i] - w.depth_before[i];
    const double next = s.L[i] + per * (follows_mean * mean + follows_rest * (grown - mean));
    const double limited = smaller(larger(next, 0.25 * s.L[i]), 4.0 * s.L[i]);
    moved += s.width[i] * magnitude(limited - s.L[i]);
    area += s.width[i] * limited;
    s.L[i] = limited;
  }
  return moved <= farthest * area;
}

}  // namespace wrc::surface
