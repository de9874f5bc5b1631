#include "surface/rolling/region_rolling.hpp"

#include <algorithm>
#include <cmath>

#include "base/cutter.hpp"
#include "base/number.hpp"
#include "patch/material.hpp"
#include "patch/regularise.hpp"
#include "patch/sdec.hpp"
#include "surface/pressure/lobes.hpp"

namespace wrc {
namespace {

constexpr double least_variance = 1e-12;  // [m^2]: of a load on one line

struct Memory {
  double *line_load, *load, *shares;
  double *cold, *heat_share, *hot;  ///< of friction over temperature: of a part, of a part, of all
  Strips strips;
  void* method;
};

Memory cut(double* memory, std::int32_t count) {
  Cutter cutter{memory};
  const auto take = [&] { return cutter(count); };
  Memory m{take(), take(), take(), take(), take(), take(), {}, nullptr};
  m.strips = {count, 0, take(), take(), take(), take(), take()};
  m.method = cutter.at;
  return m;
}

/// Sums over the load of a part.
struct Means {
  double load = 0.0;  ///< [N]
  double place = 0.0, along = 0.0;
  Creepage creepage;
  double friction = 0.0;
  Sdec shape;
};

class Roller {
 public:
  Roller(const SurfaceRollingInput& in, const double* along, const RegionRolling& method,
         const SlopeFall& slope, double slope_reduction, double* workspace, const TangentialFields& fields,
         const SurfaceRollingForces& forces, HeatedFriction* heat)
      : in_(in),
        along_(along),
        method_(method),
        fields_(fields),
        forces_(forces),
        heat_(heat),
        memory_(cut(workspace, in.count)) {
    contact_.shear_modulus = in.shear_modulus;
    contact_.linear_theory = method.linear_theory;
    contact_.grid = in.grid;
    contact_.bound = method.bound;
    contact_.form = method.form;
    contact_.slope = slope;
    contact_.slope_reduction = slope_reduction;
    contact_.model = method.model;
    contact_.force_table = method.force_table;
    contact_.workspace = memory_.method;
  }

  Fault roll() {
    for (double* const f : {forces_.fx, forces_.fy, forces_.mz, memory_.hot}) std::fill_n(f, in_.count, 0.0);
    for (std::int32_t j = 0; j < in_.count; ++j) memory_.line_load[j] = in_.half_length[j] * in_.peak[j];
    for (std::int32_t first = 0, end = 0; first < in_.count; first = end) {
      end = first + 1;
      while (end < in_.count &&
             in_.place[end] - in_.place[end - 1] < 0.75 * (in_.width[end] + in_.width[end - 1]))
        ++end;
      const LobeCuts cuts = find_lobes(in_.place, memory_.line_load, first, end);
      for_each_part(cuts, [&](double share, const LobeCut* low, const LobeCut* high) {
        roll_part(first, end, share, low, high);
      });
    }
    return fault_;
  }

  const double* hot() const { return memory_.hot; }

 private:
  /// Loads of the strips within the part; of one across its border, what lies inside.
  Means take_part(std::int32_t first, std::int32_t end, const LobeCut* low, const LobeCut* high) {
    Means m;
    for (std::int32_t j = first; j < end; ++j) {
      const double from = in_.place[j] - 0.5 * in_.width[j], to = from + in_.width[j];
      const double inside =
          larger((high ? smaller(to, high->place) : to) - (low ? larger(from, low->place) : from), 0.0);
      const double N = 0.5 * pi * inside * memory_.line_load[j];
      memory_.load[j] = N;
      m.load += N;
      m.place += N * in_.place[j];
      m.along += N * along_[j];
      m.creepage.longitudinal += N * in_.slip_x[j];
      m.creepage.lateral += N * in_.slip_y[j];
      m.creepage.spin += N * in_.spin[j];
      m.friction += N * in_.friction[j];
    }
    if (!(m.load > 0.0)) return m;
    for (double* const mean :
         {&m.place, &m.along, &m.creepage.longitudinal, &m.creepage.lateral, &m.creepage.spin, &m.friction})
      *mean /= m.load;
    double squares = 0.0, variance = 0.0, third = 0.0;
    for (std::int32_t j = first; j < end; ++j) {
      const double share = memory_.load[j] / m.load, y = in_.place[j] - m.place;
      squares += share * in_.half_length[j] * in_.half_length[j];
      variance += share * (y * y + in_.width[j] * in_.width[j] / 12.0);
      third += share * y * y * y;
    }
    m.shape = sdec_of_load(squares, variance, third);
    return m;
  }

  /// The strips the tractions live on, y from `origin`; shares of the friction.
  void fill_strips(std::int32_t first, std::int32_t end, const Means& m, double origin) {
    Strips& strips = memory_.strips;
    strips.count = 0;
    for (std::int32_t j = first; j < end; ++j) {
      if (!(memory_.load[j] > 0.0)) continue;
      const std::int32_t k = strips.count++;
      strips.y[k] = in_.place[j] - m.place - origin;
      strips.width[k] = memory_.load[j] / (0.5 * pi * memory_.line_load[j]);
      strips.centre[k] = along_[j] - m.along;
      strips.half_length[k] = in_.half_length[j];
      strips.peak[k] = in_.peak[j];
      memory_.shares[k] = in_.friction[j] / m.friction;
    }
    contact_.friction = {m.friction, memory_.shares};
    if (!method_.model.on_ellipse) return;
    sdec_strips({m.shape.a, m.shape.b, 0.0}, 0.0, 0.0, m.load, strips.count, strips);
    contact_.friction = {m.friction};
  }

  TangentialForces solve() {
    Fault fault;
    const auto once = [&] { return method_.solve(contact_, fields_, fault, nullptr); };
    TangentialForces found;
    if (heat_) {
      const Strips& region = contact_.region;
      for (std::int32_t k = 0; k < region.count; ++k) memory_.cold[k] = contact_.friction[k];
      const Fault unsettled = solve_heated(*heat_, region, fields_, fields_.slip_x, memory_.heat_share, [&] {
        for (std::int32_t k = 0; k < region.count; ++k)
          memory_.shares[k] = memory_.cold[k] * memory_.heat_share[k];
        contact_.friction = shared_out(region, memory_.shares);
        found = once();
      });
      keep_worst(fault, unsettled);
    } else {
      found = once();
    }
    keep_worst(fault_, fault);
    return found;
  }

  void roll_part(std::int32_t first, std::int32_t end, double share, const LobeCut* low,
                 const LobeCut* high) {
    const Means m = take_part(first, end, low, high);
    if (!(m.load > 0.0 && m.friction > 0.0)) return;
    const double joint = -pressure_centre_share * m.shape.psi * m.shape.b;
    const double origin = joint + (method_.model.at_middle ? m.shape.psi * m.shape.b : 0.0);
    fill_strips(first, end, m, origin);
    contact_.region = memory_.strips;
    contact_.a = m.shape.a;
    contact_.b = m.shape.b;
    contact_.shape_number = m.shape.psi;
    contact_.creepage = seen_from(origin, m.creepage);
    contact_.normal_force = m.load;
    TangentialForces found = solve();
    refer_back(origin, found, nullptr);
    std::int32_t k = 0;
    for (std::int32_t j = first; j < end; ++j) {
      const double part = share * memory_.load[j] / m.load;
      forces_.fx[j] += part * found.fx;
      forces_.fy[j] += part * found.fy;
      forces_.mz[j] += part * found.mz;
      if (!(heat_ && memory_.load[j] > 0.0)) continue;
      const double whole = 0.5 * pi * in_.width[j] * memory_.line_load[j];
      const double coefficient = method_.model.on_ellipse ? contact_.friction.mean : contact_.friction[k++];
      memory_.hot[j] += share * memory_.load[j] / whole * coefficient;
    }
  }

  static constexpr double pressure_centre_share = 0.75;  // of psi b: mean place of the load from the joint

  const SurfaceRollingInput& in_;
  const double* along_;
  const RegionRolling& method_;
  const TangentialFields& fields_;
  const SurfaceRollingForces& forces_;
  HeatedFriction* heat_;
  Memory memory_;
  RollingContact contact_;
  Fault fault_;
};

}  // namespace

std::int64_t region_rolling_doubles(std::int32_t most, const RegionRolling& method) {
  return 11 * static_cast<std::int64_t>(most) +
         (method.workspace_bytes + static_cast<std::int64_t>(sizeof(double)) - 1) /
             static_cast<std::int64_t>(sizeof(double));
}

Sdec sdec_of_load(double mean_length_squared, double variance, double third_moment) noexcept {
  Sdec shape;
  const double spread = larger(variance, least_variance);
  const double skewness = third_moment / (spread * std::sqrt(spread));
  double psi = 0.0;
  for (int i = 0; i < 8; ++i) {  // Newton's rule; the skewness of |psi| = 0.95 is 0.365
    const double square = psi * psi, width = std::sqrt(0.2 + 0.0375 * square);
    const double off = psi * (0.05 - 0.00625 * square) - skewness * width * width * width;
    const double slope = 0.05 - 0.01875 * square - 0.1125 * skewness * width * psi;
    psi = smaller(larger(psi - off / larger(slope, 0.01), -largest_psi), largest_psi);
  }
  shape.psi = psi;
  shape.a = std::sqrt(larger(1.25 * mean_length_squared, least_variance));
  shape.b = std::sqrt(spread / (0.2 + 0.0375 * psi * psi));
  return shape;
}

Fault roll_by_region(const SurfaceRollingInput& in, const double* along, const RegionRolling& method,
                     const SlopeFall& slope, double slope_reduction, double* workspace,
                     const TangentialFields& fields, const SurfaceRollingForces& forces, HeatedFriction* heat,
                     double* hot) noexcept {
  Roller roller(in, along, method, slope, slope_reduction, workspace, fields, forces, heat);
  const Fault fault = roller.roll();
  if (heat) std::copy_n(roller.hot(), in.count, hot);
  return fault;
}

}  // namespace wrc
