/// The rows of a gap (geometry/gap_rows.hpp) for the instruction set of the unit: one row per lane.
///
/// Both curves are followed outwards from the contact point by blocks of rows. All rows of a block start from
/// the parabola that the end of the block before continues with; Newton's method then moves each on its own.
/// The block is the same for every instruction set, so the bits are too.
#pragma once

#include "base/pack.hpp"
#include "geometry/gap_rows.hpp"
#include "geometry/simd/tasks.hpp"

namespace wrc::simd {
namespace {

constexpr std::int32_t block = 16;  ///< rows
static_assert(block % lanes == 0);

constexpr std::int32_t newton_cap = 12;    ///< two or three steps are typical
constexpr double newton_tolerance = 1e-8;  ///< last step [m]; the error is below 1e-12 m then
constexpr double newton_step = 1e-3;       ///< longest step [m]
constexpr double least_advance = 0.05;     ///< dy per parameter, see gap_rows.cpp

/// Points of a curve in the contact frame.
struct FramePoints {
  Pack y, z;   ///< [m]
  Pack dz_dy;  ///< [-]
  Pack rate;   ///< derivative of y by the curve's own parameter [-]
};

/// y, z relative to the contact point in track axes; (ty, tz) the tangent; dy_dt of the curve's parameter.
inline FramePoints turned(const geometry::ContactPoint& contact, Pack y, Pack z, Pack ty, Pack tz,
                          Pack dy_dt) {
  const Pack c = contact.cosine, s = contact.sine;
  const Pack run = c * ty + s * tz;
  return {c * y + s * z, c * z - s * y, (c * tz - s * ty) / run, run / ty * dy_dt};
}

/// A profile at one place per lane; outside the nodes the end tangent continues. `piece` as in evaluate().
inline geometry::ProfilePointOf<Pack> evaluate_lanes(const geometry::Profile& profile, Pack y,
                                                     std::int32_t& piece) {
  double at[lanes], from[lanes], z[lanes], slope[lanes], square[lanes], cube[lanes];
  store_pack(at, y);
  const std::int32_t last = profile.count - 1;
  for (std::int32_t k = 0; k < lanes; ++k) {
    while (piece > 0 && at[k] < profile.y[piece]) --piece;
    while (piece < last - 1 && at[k] >= profile.y[piece + 1]) ++piece;
    const bool beyond = at[k] > profile.y[last], outside = beyond || at[k] < profile.y[0];
    const std::int32_t node = beyond ? last : piece;
    from[k] = profile.y[node];
    z[k] = profile.z[node];
    slope[k] = profile.slope[node];
    square[k] = outside ? 0.0 : profile.square[node];
    cube[k] = outside ? 0.0 : profile.cube[node];
  }
  return geometry::evaluate_cubic(load_pack(z), load_pack(slope), load_pack(square), load_pack(cube),
                                  y - load_pack(from));
}

/// The rail's profile as a curve; its parameter is y of the track.
struct RailOutline {
  const RowsTask* task;
  std::int32_t piece;

  const geometry::Profile& profile() const { return task->rail->profile; }
  FramePoints at(Pack y) {
    const geometry::ContactPoint& contact = *task->contact;
    const geometry::ProfilePointOf<Pack> p = evaluate_lanes(profile(), y, piece);
    return turned(contact, y - contact.y, p.z - contact.z, 1.0, p.slope, 1.0);
  }
};

/// The wheel's outline as a curve; its parameter is y of the wheelset.
struct WheelOutline {
  const RowsTask* task;
  std::int32_t piece;
  geometry::OutlinePointOf<Pack> point;  ///< where at() was last

  const geometry::Profile& profile() const { return task->wheel->wheel->profile; }
  FramePoints at(Pack s) {
    const geometry::ContactPoint& contact = *task->contact;
    point = geometry::outline_at(*task->wheel, s, evaluate_lanes(profile(), s, piece));
    return turned(contact, point.y - contact.y, point.z + contact.vertical_gap - contact.z, point.normal_z,
                  -point.normal_y, point.dy_ds);
  }
};

/// A curve on its way outwards.
template <class Curve>
struct Outwards {
  Curve curve;
  double t, y, rate;                       ///< at the last row: parameter, y [m], dy/dt
  double bend;                             ///< how dy/dt changes with y there [1/m]
  double rows_t[block], rows_rate[block];  ///< present block

  Outwards(const Curve& from, double start) : curve(from), t(start), y(0.0), bend(0.0) {
    double rates[lanes];
    store_pack(rates, curve.at(start).rate);
    rate = rates[0];
  }

  /// z at the places `row` of frame y, which are rows `first`.. of the block.
  Pack height(std::int32_t first, Pack row, bool& converged) {
    const geometry::Profile& profile = curve.profile();
    const Pack least = least_advance;
    Pack low = profile.y[0],
         high = profile.y[profile.count - 1];  // the row lies between; y rises with the parameter
    const Pack way = row - y;
    const Pack slowest = larger(0.5 * rate, least);  // a bend seen where the curvature jumps does not go on
    Pack parameter = t + way / larger(rate + 0.5 * bend * way, slowest);
    parameter = smaller(larger(parameter, low), high);
    FramePoints p;
    Pack ahead;
    for (std::int32_t i = 0;; ++i) {
      p = curve.at(parameter);
      ahead = row - p.y;
      const Pack step = smaller(larger(ahead / larger(p.rate, least), -newton_step), newton_step);
      const Mask far = Pack(newton_tolerance) < magnitude(step);
      if (!any(far)) break;
      if (i + 1 == newton_cap) {
        converged = false;
        break;
      }
      low = select(ahead < Pack(0.0), low, parameter);
      high = select(ahead < Pack(0.0), parameter, high);
      // A step that leaves the interval of the row (steep flanks: Newton's method may go in circles).
      const Pack next = parameter + step;
      const Pack inside = select((low <= next) & (next <= high), next, 0.5 * (low + high));
      parameter = select(far, inside, parameter);
    }
    store_pack(rows_t + first, parameter);
    store_pack(rows_rate + first, p.rate);
    return p.z + p.dz_dy * ahead;
  }

  /// The next block starts from the end of this one, whose last two rows lie at `before` and `last`.
  void leave(double before, double last) {
    t = rows_t[block - 1];
    y = last;
    rate = rows_rate[block - 1];
    bend = (rate - rows_rate[block - 2]) / (last - before);
  }
};

/// Rows from, from + direction, .. , `count` of them.
inline bool fill_outwards(const RowsTask& task, std::int32_t from, std::int32_t direction,
                          std::int32_t count) {
  const geometry::ContactPoint& contact = *task.contact;
  Outwards<RailOutline> rail({&task, task.rail_piece}, contact.y);
  Outwards<WheelOutline> wheel({&task, task.wheel_piece, {}}, contact.wheel_s);
  bool converged = true;
  for (std::int32_t first = 0; first < count; first += block) {
    double y[block], height[block], centre[block], curvature[block];
    const std::int32_t rows = count - first < block ? count - first : block;
    for (std::int32_t k = 0; k < block; ++k) {
      const std::int32_t row = k < rows ? k : rows - 1;  // lanes too many repeat the last row
      y[k] = task.low + (from + direction * (first + row)) * task.step;
    }
    for (std::int32_t k = 0; k < rows; k += lanes) {
      const Pack row = load_pack(y + k);
      store_pack(height + k, rail.height(k, row, converged) - wheel.height(k, row, converged));
      const geometry::OutlinePointOf<Pack>& point = wheel.curve.point;
      store_pack(centre + k, point.x - contact.x);
      store_pack(curvature + k,
                 geometry::longitudinal_curvature(*task.wheel, point, contact.cosine, contact.sine));
    }
    for (std::int32_t k = 0; k < rows; ++k) {
      const std::int32_t j = from + direction * (first + k);
      task.memory->y[j] = y[k];
      task.memory->height[j] = height[k];
      task.memory->centre[j] = centre[k];
      task.memory->curvature[j] = curvature[k];
    }
    if (rows < block) break;
    rail.leave(y[block - 2], y[block - 1]);
    wheel.leave(y[block - 2], y[block - 1]);
  }
  return converged;
}

/// The contact point lies at y = 0 of the frame; rows from there to both sides.
inline bool fill_rows_kernel(const RowsTask& task) {
  const double behind = -task.low / task.step + 1.0;
  const std::int32_t middle = behind < 0.0          ? 0
                              : behind > task.count ? task.count
                                                    : static_cast<std::int32_t>(behind);
  const bool up = fill_outwards(task, middle, +1, task.count - middle);
  const bool down = fill_outwards(task, middle - 1, -1, middle);
  return up && down;
}

}  // namespace
}  // namespace wrc::simd
