/// A layer between the bodies against closed solutions, against the methods without one, and against itself:
/// derivatives, power, smoothness.
#include <gtest/gtest.h>

#include "published_methods.hpp"
#include "tangential/methods/strip_fastsim.hpp"
#include "tangential_patches.hpp"

namespace wrc::tangential {
namespace {

using test::fastsim_eql;
using test::OwnedGrid;
using test::OwnedStrips;

constexpr double a = 5e-3, b = 6e-3, load = 80e3, friction = 0.4, G = 82e9;

/// An ellipse of many strips and cells.
class Ellipse {
 public:
  explicit Ellipse(int cells = 64) : grid_(cells), strips_(test::sdec_strips(a, b, 0.0, load, cells)) {}

  RollingContact contact(const Creepage& creepage, const Layer& layer) const {
    RollingContact c{strips_.get(),          a, b, 0.0, G, &table_, &grid_.get(), creepage, friction,
                     TractionBound::elliptic};
    c.layer = layer;
    return c;
  }
  TangentialForces forces(const Creepage& creepage, const Layer& layer) const {
    Fault fault;
    return strip_fastsim(contact(creepage, layer), {}, fault);
  }
  const OwnedGrid& grid() const { return grid_; }

 private:
  OwnedGrid grid_;
  OwnedStrips strips_;
  theory::SdecTable table_{0.28};
};

constexpr double limit = friction * load;                      // mu N [N]
constexpr double peak = friction * 1.5 * load / (pi * a * b);  // mu p_0 [Pa]
constexpr double flexibility = 3e-14;                          // about that of the bodies [m/Pa]
constexpr Creepage mixed{1.1e-3, -0.7e-3, 0.1};

TEST(Layer, ThatHardlyGivesWayIsNone) {
  const Ellipse ellipse;
  for (const Creepage& creepage : {Creepage{6e-4, 0.0, 0.0}, mixed, Creepage{0.0, 3e-4, 0.6}}) {
    const TangentialForces none = ellipse.forces(creepage, {}), thin = ellipse.forces(creepage, {1e-20}),
                           strong = ellipse.forces(creepage, {0.0, 1e12});
    for (const TangentialForces& f : {thin, strong}) {
      EXPECT_NEAR(f.fx, none.fx, 0.01 * limit);
      EXPECT_NEAR(f.fy, none.fy, 0.015 * limit);
      EXPECT_NEAR(f.mz, none.mz, 0.01 * limit * std::sqrt(a * b));
    }
  }
}

TEST(Layer, FarSofterThanTheBodiesIsAFoundationOfSprings) {
  // F a traction per displacement: 8 a^2 b nu / (3 F) without slip, slip where F p = nu v exceeds F mu p
  const Ellipse ellipse;
  const double F = 3e-11, nu = 0.02 * F * peak / a;
  EXPECT_NEAR(ellipse.forces({nu, 0.0, 0.0}, {F}).fx, -8.0 * a * a * b * nu / (3.0 * F), 2e-3 * limit);
  EXPECT_NEAR(ellipse.forces({0.0, nu, 0.0}, {F}).fy, -8.0 * a * a * b * nu / (3.0 * F), 2e-3 * limit);
}

TEST(Layer, OfLowYieldCarriesItsYieldWhereverPressureAllows) {
  // Int min(mu p, tau) dA = mu N (3 t - t^3) / 2, t = tau / mu p_0
  const Ellipse ellipse;
  for (const double t : {0.1, 0.4, 0.8}) {
    const TangentialForces f = ellipse.forces({0.2, 0.0, 0.0}, {0.0, t * peak});
    EXPECT_NEAR(f.fx, -0.5 * limit * (3.0 * t - t * t * t), 4e-3 * limit) << t;
  }
}

TEST(Layer, HardensOrSoftensWithTheLengthItFlows) {
  // A soft spring at large creepage flows by nu v along a strip: tau = tau_0 + k (nu v - F tau). Far from the
  // edges, and with a bound that is never reached, the force follows from its integral.
  const Ellipse ellipse(128);
  const double F = 1e-12, tau = 0.02 * peak, nu = 0.05;
  for (const double k : {2e9, -2e8, 0.0}) {
    const TangentialForces f = ellipse.forces({nu, 0.0, 0.0}, {F, tau, k});
    // over a strip of half length l: 2 l tau + k nu (2 l)^2 / 2
    double expected = 0.0;
    for (int j = 0; j < 1000; ++j) {
      const double eta = -1.0 + (2.0 * j + 1.0) / 1000.0, l = a * std::sqrt(1.0 - eta * eta);
      expected += 2e-3 * b * (2.0 * l * tau + 2.0 * k * nu * l * l);
    }
    EXPECT_NEAR(f.fx, -expected, 0.04 * expected) << k;
  }
}

TEST(Layer, SoftensToATenth) {
  const Ellipse ellipse;
  const double tau = 0.3 * peak;
  const TangentialForces f = ellipse.forces({0.5, 0.0, 0.0}, {0.0, tau, -1e12});
  const TangentialForces tenth = ellipse.forces({0.5, 0.0, 0.0}, {0.0, 0.1 * tau});
  EXPECT_NEAR(f.fx, tenth.fx, 0.02 * limit);
}

TEST(Layer, DissipatesTheWorkOfForcesAndFieldsDoSo) {
  const Ellipse ellipse(24);
  const Layer layer{flexibility, 0.3 * peak, 1e12};
  std::vector<double> px(24 * 24), py(px), sx(px), sy(px);
  Fault fault;
  const RollingContact contact = ellipse.contact(mixed, layer);
  const TangentialForces f = strip_fastsim(contact, {px.data(), py.data(), sx.data(), sy.data()}, fault);
  const TangentialForces plain = strip_fastsim(contact, {}, fault);
  EXPECT_EQ(f.fx, plain.fx);
  EXPECT_EQ(f.mz, plain.mz);
  EXPECT_NEAR(f.power_per_speed, -(f.fx * mixed.longitudinal + f.fy * mixed.lateral + f.mz * mixed.spin),
              1e-9 * limit);
  double power = 0.0, fx = 0.0, largest = 0.0;
  const patch::Strips& s = contact.region;
  for (std::size_t i = 0; i < 24; ++i) {
    for (std::size_t j = 0; j < 24; ++j) {
      const std::size_t at = i * 24 + j;
      const double cell = s.width[j] * 2.0 * s.half_length[j] / 24.0;
      power -= (px[at] * sx[at] + py[at] * sy[at]) * cell;
      fx += px[at] * cell;
      largest = std::max(largest, std::hypot(px[at], py[at]));
    }
  }
  EXPECT_NEAR(power, f.power_per_speed, 1e-9 * limit);
  EXPECT_NEAR(fx, f.fx, 1e-9 * limit);
  EXPECT_GT(largest, 0.3 * peak);  // it hardened
}

/// Derivatives against differences where those of two steps agree.
template <class Method>
void compare_derivatives(const Method& method, TractionBound bound) {
  const Ellipse ellipse(16);
  int compared = 0;
  for (int n = 0; n < 24; ++n) {
    const double size = 2e-4 * std::pow(1.4, n % 12);
    const Creepage creepage{size * std::cos(0.7 * n), size * std::sin(0.7 * n),
                            60.0 * size * std::cos(1.3 * n)};
    const Layer layer{n % 3 == 0 ? 0.0 : flexibility, (0.15 + 0.04 * n) * peak, n % 2 == 0 ? 3e12 : -3e11};
    RollingContact contact = ellipse.contact(creepage, layer);
    contact.bound = bound;
    TangentialSensitivities s;
    Fault fault;
    method(contact, TangentialFields{}, fault, &s);
    const double scale[4] = {1e-3, 1e-3, 0.2, friction};
    for (int k = 0; k < 4; ++k) {
      const auto slope = [&](double step) {
        double d[3] = {};
        for (const double sign : {1.0, -1.0}) {
          RollingContact moved = contact;
          double* const input[] = {&moved.creepage.longitudinal, &moved.creepage.lateral,
                                   &moved.creepage.spin, &moved.friction.mean};
          *input[k] += sign * step * scale[k];
          const TangentialForces f = method(moved, TangentialFields{}, fault, nullptr);
          d[0] += sign * f.fx / (2.0 * step);
          d[1] += sign * f.fy / (2.0 * step);
          d[2] += sign * f.mz / (2.0 * step);
        }
        return std::vector<double>(d, d + 3);
      };
      const std::vector<double> coarse = slope(2e-6), fine = slope(1e-6);
      for (std::size_t r = 0; r < 3; ++r) {
        const double unit = limit * (r == 2 ? std::sqrt(a * b) : 1.0);
        if (std::fabs(coarse[r] - fine[r]) > 1e-7 * unit) continue;  // a kink between them
        ++compared;
        EXPECT_NEAR(s.d[r][k == 3 ? 4 : k] * scale[k], fine[r], 2e-6 * unit) << n << " " << r << " " << k;
      }
    }
  }
  EXPECT_GT(compared, 230);  // of 288
}

TEST(Layer, HasTheDerivativesOfItsForces) {
  compare_derivatives([](const RollingContact& c, const TangentialFields& fields, Fault& fault,
                         TangentialSensitivities* s) { return strip_fastsim(c, fields, fault, s); },
                      TractionBound::elliptic);
}

TEST(Layer, HasThemInFastsim) {
  for (const TractionBound bound : {TractionBound::elliptic, TractionBound::parabolic})
    compare_derivatives([](const RollingContact& c, const TangentialFields& fields, Fault& fault,
                           TangentialSensitivities* s) { return fastsim_eql(c, fields, fault, s); },
                        bound);
}

/// Second differences along a scan bound a jump in it from above.
template <class ForcesAt>
double largest_jump(const ForcesAt& forces_at) {
  constexpr int points = 1200;
  std::vector<TangentialForces> f;
  for (int i = 0; i < points; ++i) f.push_back(forces_at(i / (points - 1.0)));
  double largest = 0.0;
  for (std::size_t i = 2; i < f.size(); ++i) {
    const auto bend = [&](double TangentialForces::*of) {
      return std::fabs(f[i].*of - 2.0 * f[i - 1].*of + f[i - 2].*of);
    };
    largest = std::max({largest, bend(&TangentialForces::fx) / limit, bend(&TangentialForces::fy) / limit,
                        bend(&TangentialForces::mz) / (limit * std::sqrt(a * b))});
  }
  return largest;
}

TEST(Layer, ForcesDoNotJumpAlongSlipOrAlongItsNumbers) {
  const Ellipse ellipse(24);
  for (const double k : {0.0, 2e12, -4e11}) {
    const Layer layer{flexibility, 0.45 * peak, k};
    const auto along = [&](const Creepage& from, const Creepage& to) {
      return largest_jump([&](double t) {
        const auto between = [t](double x, double y) { return x + t * (y - x); };
        return ellipse.forces({between(from.longitudinal, to.longitudinal), between(from.lateral, to.lateral),
                               between(from.spin, to.spin)},
                              layer);
      });
    };
    EXPECT_LT(along({-3e-3, 2e-4, 0.1}, {3e-3, 2e-4, 0.1}), 6e-4) << k;
    EXPECT_LT(along({5e-4, -3e-3, 0.1}, {5e-4, 3e-3, 0.1}), 6e-4) << k;
    EXPECT_LT(along({5e-4, 3e-4, -0.8}, {5e-4, 3e-4, 0.8}), 6e-4) << k;
    EXPECT_LT(largest_jump([&](double t) {
                return ellipse.forces(mixed, {flexibility, (0.02 + 1.2 * t) * peak, k});
              }),
              6e-4)
        << k;
    EXPECT_LT(largest_jump([&](double t) {
                return ellipse.forces(mixed, {5.0 * flexibility * t * t, 0.3 * peak, k});
              }),
              6e-4)
        << k;
  }
}

TEST(Layer, EverySetOfInstructionsGivesTheSameBits) {
  const Layer layer{flexibility, 0.3 * peak, -2e11};
  const OwnedStrips strips = test::sdec_strips(a, b, 0.3, load, 37);
  const theory::SdecTable table(0.28);
  const auto forces = [&](InstructionSet set) {
    const OwnedGrid grid(29, set);
    RollingContact contact{strips.get(), a,           b,     0.3,      G,
                           &table,       &grid.get(), mixed, friction, TractionBound::elliptic};
    contact.layer = layer;
    Fault fault;
    std::vector<double> px(37 * 29), sy(px);
    const TangentialForces f = strip_fastsim(contact, {px.data(), nullptr, nullptr, sy.data()}, fault);
    return std::vector<double>{f.fx, f.fy, f.mz, f.power_per_speed, px[500], sy[600]};
  };
  const std::vector<double> baseline = forces(InstructionSet::baseline);
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    EXPECT_EQ(forces(set), baseline);
  }
}

}  // namespace
}  // namespace wrc::tangential
