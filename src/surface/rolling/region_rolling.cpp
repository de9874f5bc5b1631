#include "surface/rolling/region_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/arena.hpp"
#include "base/number.hpp"
#include "patch/material.hpp"
#include "patch/regularise.hpp"
#include "patch/sdec.hpp"
#include "surface/rolling/strip_parts.hpp"

namespace wrc::surface {
namespace {

constexpr double least_variance = 1e-12;        // [m^2]: of a load on one line
constexpr double pressure_centre_share = 0.75;  // mean place of an SDEC's load from its joint, over psi b

struct Scratch {
  double* line_load;          ///< half length times peak [N/m], all strips
  double *load, *shares;      ///< part: load [N], friction over its mean [-]
  double *cold, *heat_share;  ///< part: coefficient of cold surfaces, and its share with heat [-]
  double* hot;                ///< coefficient of friction with heat [-], all strips
  patch::Strips strips;       ///< part: as the method sees them
  void* method;               ///< the method's own
};

Scratch cut(Arena& arena, std::int32_t strips, const RegionRolling& method) {
  Scratch s{};
  arena.each(strips, s.line_load, s.load, s.shares, s.cold, s.heat_share, s.hot, s.strips.y, s.strips.width,
             s.strips.centre, s.strips.half_length, s.strips.peak);
  s.strips.capacity = strips;
  s.method = arena.take<std::byte>(method.workspace_bytes);
  return s;
}

Scratch cut(void* workspace, std::int32_t strips, const RegionRolling& method) {
  Arena arena(workspace);
  return cut(arena, strips, method);
}

class Roller {
 public:
  Roller(const RegionRollingInput& in, const RegionRolling& method, void* workspace,
         const tangential::TangentialFields& fields, const SurfaceRollingForces& forces)
      : in_(in),
        strips_(in.strips),
        method_(method),
        fields_(fields),
        forces_(forces),
        scratch_(cut(workspace, in.strips.count, method)),
        parts_{in.strips, in.along, scratch_.line_load, scratch_.load} {
    contact_.shear_modulus = strips_.shear_modulus;
    contact_.linear_theory = method.linear_theory;
    contact_.grid = strips_.grid;
    contact_.bound = method.bound;
    contact_.form = method.form;
    contact_.slope = in.slope;
    contact_.slope_reduction = in.slope_reduction;
    contact_.layer = strips_.layer;
    contact_.reduction = in.reduction;
    contact_.model = method.model;
    contact_.force_table = method.force_table;
    contact_.workspace = scratch_.method;
  }

  Fault roll() {
    for (double* const f : {forces_.fx, forces_.fy, forces_.mz, scratch_.hot})
      std::fill_n(f, strips_.count, 0.0);
    parts_.for_each([&](std::int32_t first, std::int32_t end, double share, const LobeCut* low,
                        const LobeCut* high) { roll_part(first, end, share, low, high); });
    if (in_.heat) std::copy_n(scratch_.hot, strips_.count, in_.hot);
    return fault_;
  }

 private:
  /// Shape of the part that `parts_` has taken.
  patch::Sdec shape_of(std::int32_t first, std::int32_t end, const PartMeans& m) const {
    // <l^2>, variance and third moment of the load give the double ellipse. A strip's load is spread over its
    // width h, which adds h^2 / 12 to the variance.
    double squares = 0.0, variance = 0.0, third = 0.0;
    for (std::int32_t j = first; j < end; ++j) {
      const double share = scratch_.load[j] / m.load, y = strips_.place[j] - m.place;
      squares += share * strips_.half_length[j] * strips_.half_length[j];
      variance += share * (y * y + strips_.width[j] * strips_.width[j] / 12.0);
      third += share * y * y * y;
    }
    return sdec_of_load(squares, variance, third);
  }

  /// Sets the strips that tractions live on, about y = `origin` from the mean place of the load, and the
  /// shares of the friction.
  void fill_strips(std::int32_t first, std::int32_t end, const PartMeans& m, const patch::Sdec& shape,
                   double origin) {
    // The part's own strips: a width inside that carries the strip's load there.
    patch::Strips& strips = scratch_.strips;
    strips.count = 0;
    for (std::int32_t j = first; j < end; ++j) {
      if (!(scratch_.load[j] > 0.0)) continue;
      const std::int32_t k = strips.count++;
      strips.y[k] = strips_.place[j] - m.place - origin;
      strips.width[k] = parts_.width_inside(j);
      strips.centre[k] = in_.along[j] - m.along;
      strips.half_length[k] = strips_.half_length[j];
      strips.peak[k] = strips_.peak[j];
      scratch_.shares[k] = strips_.friction[j] / m.friction;
    }
    contact_.friction = {m.friction, scratch_.shares};
    if (!method_.model.on_ellipse) return;
    // Methods on the equivalent ellipse get as many strips of that, with one coefficient of friction.
    patch::sdec_strips({shape.a, shape.b, 0.0}, 0.0, 0.0, m.load, strips.count, strips);
    contact_.friction = {m.friction};
  }

  /// Solves the part by the method; with heat, as often as friction over temperature takes to settle.
  tangential::TangentialForces solve() {
    Fault fault;
    tangential::TangentialForces found;
    const auto once = [&] { found = method_.solve(contact_, fields_, fault, nullptr); };
    if (in_.heat) {
      const patch::Strips& region = contact_.region;
      for (std::int32_t k = 0; k < region.count; ++k) scratch_.cold[k] = contact_.friction[k];
      const Fault unsettled =
          tangential::solve_heated(*in_.heat, region, fields_, fields_.slip_x, scratch_.heat_share, [&] {
            for (std::int32_t k = 0; k < region.count; ++k)
              scratch_.shares[k] = scratch_.cold[k] * scratch_.heat_share[k];
            contact_.friction = tangential::shared_out(region, scratch_.shares);
            once();
          });
      keep_worst(fault, unsettled);
    } else {
      once();
    }
    keep_worst(fault_, fault);
    return found;
  }

  /// Rolls one part and adds its forces, times its share, to those of its strips.
  void roll_part(std::int32_t first, std::int32_t end, double share, const LobeCut* low,
                 const LobeCut* high) {
    const PartMeans m = parts_.take_part(first, end, low, high);
    if (!(m.load > 0.0 && m.friction > 0.0)) return;
    const patch::Sdec shape = shape_of(first, end, m);
    // Methods count y from the joint of the double ellipse, or from the middle of its width, psi b further.
    // Creepages at the mean place of the load become those at that origin, forces come back from there.
    const double joint = -pressure_centre_share * shape.psi * shape.b;
    const double origin = joint + (method_.model.at_middle ? shape.psi * shape.b : 0.0);
    fill_strips(first, end, m, shape, origin);
    contact_.region = scratch_.strips;
    contact_.a = shape.a;
    contact_.b = shape.b;
    contact_.shape_number = shape.psi;
    contact_.creepage = tangential::seen_from(origin, m.creepage);
    contact_.normal_force = m.load;
    tangential::TangentialForces found = solve();
    tangential::refer_back(origin, found, nullptr);
    // Strips share force and moment by load. With heat a strip has the mean over its parts of their
    // coefficients; on the ellipse, whose strips are others, that of the whole part.
    std::int32_t k = 0;
    for (std::int32_t j = first; j < end; ++j) {
      const double part = share * scratch_.load[j] / m.load;
      forces_.fx[j] += part * found.fx;
      forces_.fy[j] += part * found.fy;
      forces_.mz[j] += part * found.mz;
      if (!(in_.heat && scratch_.load[j] > 0.0)) continue;
      const double whole = 0.5 * pi * strips_.width[j] * scratch_.line_load[j];
      const double coefficient = method_.model.on_ellipse ? contact_.friction.mean : contact_.friction[k++];
      scratch_.hot[j] += share * scratch_.load[j] / whole * coefficient;
    }
  }

  const RegionRollingInput& in_;
  const SurfaceRollingInput& strips_;
  const RegionRolling& method_;
  const tangential::TangentialFields& fields_;
  const SurfaceRollingForces& forces_;
  Scratch scratch_;
  StripsInParts parts_;
  tangential::RollingContact contact_;
  Fault fault_;
};

}  // namespace

std::int64_t region_rolling_doubles(std::int32_t most, const RegionRolling& method) {
  Arena arena;
  cut(arena, most, method);
  return arena.doubles();
}

patch::Sdec sdec_of_load(double mean_length_squared, double variance, double third_moment) noexcept {
  // Skewness = psi (0.05 - psi^2 / 160) / (0.2 + 3/80 psi^2)^(3/2) grows with psi: Newton's method, whose
  // eight steps settle |psi| <= 0.95, of skewness up to 0.365.
  patch::Sdec shape;
  const double spread = larger(variance, least_variance);
  const double skewness = third_moment / (spread * std::sqrt(spread));
  double psi = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double square = psi * psi, width = std::sqrt(0.2 + 0.0375 * square);
    const double off = psi * (0.05 - 0.00625 * square) - skewness * width * width * width;
    const double slope = 0.05 - 0.01875 * square - 0.1125 * skewness * width * psi;
    psi = smaller(larger(psi - off / larger(slope, 0.01), -patch::largest_psi), patch::largest_psi);
  }
  shape.psi = psi;
  // a^2 = 5/4 <l^2>, b^2 = variance / (1/5 + 3/80 psi^2)
  shape.a = std::sqrt(larger(1.25 * mean_length_squared, least_variance));
  shape.b = std::sqrt(spread / (0.2 + 0.0375 * psi * psi));
  return shape;
}

Fault roll_by_region(const RegionRollingInput& in, const RegionRolling& method, void* workspace,
                     const tangential::TangentialFields& fields,
                     const SurfaceRollingForces& forces) noexcept {
  return Roller(in, method, workspace, fields, forces).roll();
}

}  // namespace wrc::surface
