/// memory_report - contact with memory, in numbers: S1002 on the benchmark UIC60 with
/// config.surface.memory, beside the same wheel without.
///
///     memory_report steady [CASES [SEED]]   from rest under conditions that stay: difference to the steady force over mu N,
///                                           after so many lengths of the patch
///     memory_report passive [STEPS [SEED]]  random steps: largest gain over the energy exchanged; exit status 1 above 1e-9
///     memory_report scans                   largest jumps along places, time and speed, in steps of 1 um and 0.1 um; exit status 1
///                                           above 2e-3 of mu N
///     memory_report loops                   closed loops at rest: work on a plane over that of the exact solver; shifts of wheels
///                                           beside the load that it has over its approach
///     memory_report cost [STEPS]            time over that without memory, in one run
///
/// Work of friction: that of the wrench less the wrench without friction, whose pressures are the same.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "library.hpp"
#include "realtime/proof/processor_time.hpp"
#include "test_config.hpp"
#include "transient_cells.hpp"
#include "wrc/wrc.h"

namespace {

using namespace compare;

constexpr double radius = 0.46;

class Random {
 public:
  explicit Random(unsigned long seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  double power(double low, double high) { return std::pow(10.0, between(low, high)); }
  bool one_in(unsigned n) { return engine_() % n == 0; }

 private:
  std::mt19937_64 engine_;
};

wrc_config config_of(bool remembers, const char* resolution) {
  wrc_config config = test_config();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  char text[256];
  if (wrc_config_use(&config, resolution, text, sizeof text) < 0) throw std::runtime_error(text);
  config.surface.memory = remembers;
  return config;
}

/// A wheel on its rail, at a height that is given.
class Wheel {
 public:
  explicit Wheel(bool remembers, const char* resolution = "default")
      : solver_(config_of(remembers, resolution)), remembers_(remembers) {
    uint64_t bytes = 0;
    wrc_contact_state_size(solver_.model(), &bytes);
    unused_.resize(bytes);
    wrc_contact_save(solver_.contact(), unused_.data(), bytes);
    input.wheel.angular_axes = WRC_AXES_TRACK;
    input.wheel.reference = WRC_REFERENCE_WHEEL;
  }

  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = sized<wrc_wrench>();

  wrc_contact* contact() const { return solver_.contact(); }
  double limit() const { return input.friction.coefficient * wrench.normal_force; }

  /// Back to a contact without tractions.
  void forget() { wrc_contact_restore(contact(), unused_.data(), unused_.size()); }
  void rest() {
    std::fill_n(input.wheel.velocity, 3, 0.0);
    std::fill_n(input.wheel.angular_velocity, 3, 0.0);
  }
  /// Rolls at this speed, with velocities of slip along and across over it.
  void roll(double speed, double along, double across) {
    rest();
    input.wheel.velocity[0] = speed;
    input.wheel.velocity[1] = across * speed;
    input.wheel.angular_velocity[1] = -speed / radius * (1.0 - along);
  }
  /// A step of this time; without it, as of a contact without memory.
  const wrc_wrench& solve(double time = 0.0) {
    input.time_step = remembers_ ? time : 0.0;
    const int32_t status = wrc_contact_wrench(contact(), &input, &wrench);
    if (status < 0) throw std::runtime_error(solver_.reason(status));
    return wrench;
  }
  const wrc_wrench& go(double time) {
    solve(time);
    if (wrc_contact_commit(contact()) < 0) throw std::runtime_error("no commit");
    return wrench;
  }
  /// At rest here under this load, without tractions.
  void stand(double y, double load) {
    forget();
    rest();
    input.wheel.y = y;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = load;
    const double friction = input.friction.coefficient;
    input.friction.coefficient = 0.0;
    solve();
    input.friction.coefficient = friction;
    input.wheel.z = wrench.z;
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    forget();
    solve();
    if (remembers_) wrc_contact_commit(contact());
  }
  /// Length of the longest strip [m].
  double length() const {
    double longest = 0.0;
    for (int32_t i = 0; i < wrench.region_count; ++i) {
      wrc_region region = sized<wrc_region>();
      wrc_contact_region(contact(), i, &region);
      std::vector<double> half(static_cast<std::size_t>(region.strip_count));
      wrc_contact_field(contact(), i, WRC_FIELD_STRIP_HALF_LENGTH, half.data(), half.size(), nullptr);
      for (const double l : half) longest = std::max(longest, 2.0 * l);
    }
    return longest;
  }

 private:
  Solver solver_;
  bool remembers_;
  std::vector<unsigned char> unused_;
};

double apart(const wrc_wrench& a, const wrc_wrench& b) {
  return std::hypot(a.force[0] - b.force[0], a.force[1] - b.force[1]);
}

double at_share(std::vector<double> all, double share) {
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), all.begin() + k, all.end());
  return all[static_cast<std::size_t>(k)];
}

int steady(long cases, unsigned long seed) {
  constexpr double at[] = {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0};
  constexpr int steps_per_length = 16;
  Wheel wheel(true), forgets(false);
  Random random(seed);
  std::vector<std::vector<double>> left(std::size(at));
  for (long k = 0; k < cases; ++k) {
    wheel.input.friction.coefficient = random.between(0.15, 0.5);
    wheel.input.wheel.yaw = random.between(-5e-3, 5e-3);
    wheel.stand(random.between(-7e-3, 7e-3), 1e3 * random.between(30.0, 120.0));
    const double size = random.power(-4.0, -2.0), angle = random.between(0.0, 2.0 * pi);
    wheel.roll(random.one_in(5) ? -2.0 : 2.0, size * std::cos(angle), size * std::sin(angle));
    forgets.input = wheel.input;
    const double limit = wheel.limit(), length = wheel.length();
    const wrc_wrench end = forgets.solve();
    long done = 0;
    for (std::size_t i = 0; i < std::size(at); ++i) {
      for (; done < std::lround(at[i] * steps_per_length); ++done) wheel.go(length / steps_per_length / 2.0);
      left[i].push_back(apart(wheel.wrench, end) / limit);
    }
  }
  std::printf("lengths rolled   left of the way to the steady force, over mu N: median, 95 %%, largest\n");
  for (std::size_t i = 0; i < std::size(at); ++i)
    std::printf("%14.1f   %.1e  %.1e  %.1e\n", at[i], at_share(left[i], 0.5), at_share(left[i], 0.95),
                at_share(left[i], 1.0));
  return 0;
}

/// Paths of random steps, each from a contact without tractions.
class Paths {
 public:
  explicit Paths(unsigned long seed) : random_(seed) {
    for (int k = 0; k <= places; ++k) {
      slippery_.stand(place(k), 80e3);
      height_[k] = slippery_.input.wheel.z;
    }
  }

  void go(long steps) {
    for (long done = 0; done < steps; done += steps_of_a_path) go_path();
  }
  double gain() const { return gain_; }            ///< largest work given back over that exchanged
  double exchanged() const { return exchanged_; }  ///< [J]

 private:
  static constexpr int places = 60, steps_of_a_path = 40;
  static double place(int k) { return -7e-3 + 15e-3 * k / places; }

  void go_path() {
    wheel_.forget();
    wrc_wheel_input& input = wheel_.input;
    input.friction = wrc_friction_default();
    input.friction.coefficient = random_.between(0.1, 0.5);
    if (random_.one_in(4)) {
      input.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
      input.friction.kinetic_ratio = 0.4;
      input.friction.fall_rate = 0.6;
    }
    input.wheel.y = random_.between(-6.8e-3, 7.8e-3);
    double balance = 0.0, exchanged = 0.0, time = 0.0;
    for (int k = 0; k < steps_of_a_path; ++k) {
      // half of the steps repeat the one before: tractions settle to steady rolling
      if (k == 0 || random_.one_in(2)) {
        vary();
        time = random_.power(-5.0, -1.0);
        move(time);
      }
      const wrc_wrench& held = wheel_.solve(k == 0 ? 0.0 : time);
      if (random_.one_in(4)) continue;  // a trial
      if (k > 0) {
        const double work = work_of(held, time);
        balance += work;
        exchanged += std::abs(work);
      }
      wrc_contact_commit(wheel_.contact());
      if (exchanged > 0.0) gain_ = std::max(gain_, -balance / exchanged);
    }
    exchanged_ += exchanged;
  }

  /// Another place, load and yaw.
  void vary() {
    wrc_wheel_state& wheel = wheel_.input.wheel;
    if (!random_.one_in(3)) wheel.y += random_.between(-3e-4, 3e-4);
    wheel.y = std::clamp(wheel.y, -6.8e-3, 7.8e-3);
    if (!random_.one_in(3)) sunk_ = std::clamp(sunk_ + random_.between(-2e-5, 2e-5), -4e-5, 3e-5);
    wheel.yaw = std::clamp(wheel.yaw + random_.between(-1e-3, 1e-3), -5e-3, 5e-3);
    const double at = (wheel.y - place(0)) / (15e-3 / places);
    const auto k = static_cast<int>(at);
    wheel.z = height_[k] + (at - k) * (height_[k + 1] - height_[k]) + sunk_;
  }

  /// Velocities: at rest, shifted, rolling, in any of these with spin.
  void move(double time) {
    const double shift = random_.power(-6.5, -4.0) / time;
    wheel_.roll(random_.one_in(3) ? 0.0 : random_.between(-1.0, 1.0) * std::min(20.0, 0.02 / time), 0.0, 0.0);
    double* const v = wheel_.input.wheel.velocity;
    v[0] += random_.between(-shift, shift);
    v[1] += random_.between(-shift, shift);
    if (random_.one_in(2))
      wheel_.input.wheel.angular_velocity[2] =
          std::clamp(100.0 * random_.between(-shift, shift), -150.0, 150.0);
    if (random_.one_in(8)) wheel_.rest();
  }

  /// Work of the step put into friction [J].
  double work_of(const wrc_wrench& held, double time) {
    slippery_.input = wheel_.input;
    slippery_.input.friction = wrc_friction_default();
    slippery_.input.friction.coefficient = 0.0;
    const wrc_wrench& free = slippery_.solve();
    double power = 0.0;
    for (int i = 0; i < 3; ++i)
      power += (held.force[i] - free.force[i]) * wheel_.input.wheel.velocity[i] +
               (held.moment[i] - free.moment[i]) * wheel_.input.wheel.angular_velocity[i];
    return -power * time;
  }

  Wheel wheel_{true}, slippery_{false};
  Random random_;
  double height_[places + 2] = {};
  double sunk_ = 0.0;  ///< below the height of 80 kN [m]
  double gain_ = 0.0, exchanged_ = 0.0;
};

int passive(long steps, unsigned long seed) {
  Paths paths(seed);
  paths.go(steps);
  std::printf("%ld random steps, %.3g J exchanged, largest gain %.1e of that of its path\n", steps,
              paths.exchanged(), paths.gain());
  return paths.gain() <= 1e-9 ? 0 : 1;
}

/// A line of trial steps.
struct Scan {
  const char* name;
  long points;
  double step;  ///< from point to point [um]
  std::function<double(double)>
      set;  ///< sets the input of a point, or between two; returns the time of the step
};

/// The largest second difference of the force in a number of steps, over mu N.
double largest_bend(Wheel& wheel, const Scan& scan, double from, double step, long points, double* where) {
  double most = 0.0;
  wrc_wrench before{}, last{};
  for (long k = 0; k < points; ++k) {
    const double at = from + step * static_cast<double>(k);
    const wrc_wrench& now = wheel.solve(scan.set(at));
    const double bend = std::hypot(now.force[0] - 2.0 * last.force[0] + before.force[0],
                                   now.force[1] - 2.0 * last.force[1] + before.force[1]) /
                        wheel.limit();
    if (k > 1 && bend > most) {
      most = bend;
      *where = at;
    }
    before = last;
    last = now;
  }
  return most;
}

int scans() {
  constexpr double um = 1e-6, speed = 1.0;
  constexpr struct {
    const char* name;
    double along, across, shift;
  } motions[] = {
      {"little slip", 2e-4, 3e-4, 5e-6}, {"half slip", 1e-3, -1.5e-3, 12e-6}, {"slides", 6e-3, 4e-3, 5e-5}};
  Wheel wheel(true);
  double worst = 0.0;
  std::printf(
      "largest second difference over mu N, in steps, and in steps a 64th as long there: a jump stays\n");
  constexpr struct {
    double y, roll;
    double aside = 500.0;  ///< along y [um]; the last place loses its load further on
  } places[] = {{4e-3, 0.0}, {0.0, 0.0}, {-1.2e-3, 0.0}, {-6.2e-3, 0.0}, {3e-3, -4e-3, 400.0}};
  for (const auto& place : places)
    for (const auto& motion : motions) {
      wrc_wheel_input& input = wheel.input;
      input.wheel.yaw = 1e-3;
      input.wheel.roll = place.roll;
      wheel.stand(place.y, 80e3 / 12.0);
      const double light = input.wheel.z;
      wheel.stand(place.y, 80e3);
      wheel.roll(speed, motion.along, motion.across);
      for (int k = 0; k < 8; ++k) wheel.go(1e-3);
      const wrc_wheel_input start = input;
      const auto from_start = [&](double time) {
        input = start;
        return time;
      };
      // a step of 4 mm for places; times from none on, here, elsewhere and to a twelfth of the load; speed
      // through zero under a shift;
      // shifts at rest
      const Scan all[] = {{"y", 1000, 1.0,
                           [&](double at) {
                             from_start(0.0);
                             input.wheel.y += um * (at - place.aside);
                             return 4e-3;
                           }},
                          {"z", 300, 0.1,
                           [&](double at) {
                             from_start(0.0);
                             input.wheel.z += 0.1 * um * (at - 150.0);
                             return 4e-3;
                           }},
                          {"roll", 2000, 1.0,
                           [&](double at) {
                             from_start(0.0);
                             input.wheel.roll += um * (at - 1000.0) / radius;
                             input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
                             input.vertical_load = 80e3;
                             return 4e-3;
                           }},
                          {"time", 50000, 1.0, [&](double at) { return from_start(um * at / speed); }},
                          {"time, elsewhere", 12000, 4.0,
                           [&](double at) {
                             from_start(0.0);
                             input.wheel.y += 3e-4;
                             input.wheel.z -= 1e-5;
                             return 4.0 * um * (1.0 + at) / speed;
                           }},
                          {"time, light", 12000, 4.0,
                           [&](double at) {
                             from_start(0.0);
                             input.wheel.z = light;
                             return 4.0 * um * (1.0 + at) / speed;
                           }},
                          {"speed through 0", 4000, 1.0,
                           [&](double at) {
                             from_start(0.0);
                             wheel.roll(um * (at - 2000.0) / 1e-3, 0.0, 0.0);
                             input.wheel.velocity[0] += motion.shift / 1e-3;
                             return 1e-3;
                           }},
                          {"shift at rest", 400, 0.1, [&](double at) {
                             from_start(0.0);
                             wheel.rest();
                             input.wheel.velocity[1] = 0.1 * um * (at - 200.0) / 1e-3;
                             return 1e-3;
                           }}};
      for (const Scan& scan : all) {
        double at = 0.0, fine = 0.0;
        const double coarse = largest_bend(wheel, scan, 0.0, 1.0, scan.points, &at);
        const double jump = largest_bend(wheel, scan, std::max(0.0, at - 2.0), 1.0 / 64.0, 130, &fine);
        std::printf("y %5.1f mm, %-11s  %-15s  steps of %.1f um  %.1e  %.1e  at %.2f um\n", 1e3 * place.y,
                    motion.name, scan.name, scan.step, coarse, jump, scan.step * fine);
        worst = std::max(worst, jump);
      }
    }
  std::printf("largest jump %.1e\n", worst);
  return worst <= 2e-3 ? 0 : 1;
}

/// Shift of full slip of an ellipse over friction, along x, or y (`across`), of bodies of this steel; or,
/// with `approach`, what the bodies approach [m].
double full_shift(const wrc_ellipse& e, const wrc_material& steel, bool across, bool approach = false) {
  constexpr int angles = 720;
  double sum = 0.0;
  for (int i = 0; i < angles; ++i) {
    const double t = 2.0 * pi * i / angles, c = std::cos(t), s = std::sin(t), along = across ? s : c;
    sum += ((1.0 - steel.poisson) + (approach ? 0.0 : steel.poisson * along * along)) /
           std::sqrt(c * c / (e.a * e.a) + s * s / (e.b * e.b));
  }
  const double peak = 1.5 * e.normal_force / (pi * e.a * e.b);
  return peak / (4.0 * steel.shear_modulus) * sum * 2.0 * pi / angles;
}

/// Amplitudes of a closed path at rest.
struct Loop {
  const char* name;
  double x, y, turn;  ///< over full slip; turn: times that of beta_ref
  bool circle;
};

/// An ellipse that is displaced along a loop.
struct Displaced {
  wrc_ellipse ellipse;
  wrc_material steel;
  double friction;
  Loop loop;

  /// Work of the second of two loops by `force_of`, which displaces by creepages over `cell`.
  template <class ForceOf>
  double work(double cell, ForceOf force_of) const {
    constexpr int steps = 120;
    const double ab = ellipse.a * ellipse.b,
                 turn = 9.0 * pi / 128.0 * friction * ellipse.normal_force / (steel.shear_modulus * ab);
    const double size[3] = {friction * loop.x * full_shift(ellipse, steel, false),
                            friction * loop.y * full_shift(ellipse, steel, true), loop.turn * turn};
    double last[3] = {}, place[3] = {}, sum = 0.0;
    for (int k = 1; k <= 5 * steps / 2; ++k) {
      const double phase = 2.0 * pi * k / steps;
      const double next[3] = {size[0] * std::sin(phase),
                              size[1] * (loop.circle ? 1.0 - std::cos(phase) : std::sin(phase)),
                              size[2] * std::sin(phase)};
      wrc_creepage creepage = wrc_creepage_default();
      creepage.speed = 0.0;
      creepage.longitudinal = (next[0] - place[0]) / cell;
      creepage.lateral = (next[1] - place[1]) / cell;
      creepage.spin = (next[2] - place[2]) / cell;
      const auto found = force_of(creepage);
      const double now[3] = {found.fx, found.fy, found.mz};
      // from when the loop repeats itself
      for (int i = 0; i < 3 && k > 3 * steps / 2; ++i) sum -= 0.5 * (now[i] + last[i]) * (next[i] - place[i]);
      std::copy_n(now, 3, last);
      std::copy_n(next, 3, place);
    }
    return sum;
  }

  double by_strips() const {
    constexpr double length = 1e-3;
    Solver strips(non_steady_config(steel));
    wrc_friction law = wrc_friction_default();
    law.coefficient = friction;
    return work(length, [&](const wrc_creepage& creepage) {
      wrc_planar_forces forces{};
      wrc_planar_roll(strips.contact(), length);
      if (wrc_planar_tangential(strips.contact(), &ellipse, &creepage, &law, &forces) < 0)
        throw std::runtime_error("a step of the strips failed");
      return forces;
    });
  }

  /// By the exact solver on cells a / n.
  double by_cells(std::uint32_t n) const {
    TransientCells exact(compare::grid_about(ellipse.a, ellipse.b, n, n), steel, friction);
    exact.press_ellipse(ellipse.a, ellipse.b, ellipse.normal_force);
    return work(exact.grid().dx, [&](const wrc_creepage& creepage) { return exact.step(creepage); });
  }

  /// Exact: the error is of second order in the cell, as the border is a staircase. Little spin slides at
  /// that border alone: there a / 16 and a / 32 are within 0.1 % of the closed form on a circle, a / 8 and a
  /// / 16 0.7 % low.
  double exactly() const {
    const std::uint32_t coarse = loop.x == 0.0 && loop.y == 0.0 ? 16 : 8;
    return (4.0 * by_cells(2 * coarse) - by_cells(coarse)) / 3.0;
  }
};

/// Largest difference of a wheel's force to that of the load over approach, over mu N, shifted forth and
/// back. A shift d of the full one leaves the load of the approach that is less by d (Jaeger, Ciavarella); on
/// an ellipse that is Cattaneo's and Mindlin's law.
double shift_error(Wheel& wheel, double y, bool across) {
  constexpr int places = 20;
  constexpr double turned = 0.8, step = turned / places, time = 1e-3;
  wheel.stand(y, 80e3);
  const wrc_wrench standing = wheel.wrench;
  const double height = wheel.input.wheel.z;
  wrc_region region = sized<wrc_region>();
  wrc_contact_region(wheel.contact(), 0, &region);
  wrc_ellipse ellipse = region.ellipse;
  ellipse.normal_force = standing.normal_force;
  const wrc_material steel = steel_of_the_paper();
  const double slips = wheel.input.friction.coefficient * full_shift(ellipse, steel, across);
  // force at the places, and at those between them, over mu N
  double wanted[2 * places + 1] = {};
  for (int k = 1; k <= 2 * places; ++k) {
    wheel.input.wheel.z = height - 0.5 * k * step * full_shift(ellipse, steel, across, true);
    wheel.forget();
    wanted[k] = 1.0 - wheel.solve().normal_force / standing.normal_force;
  }
  wheel.stand(y, 80e3);
  double worst = 0.0;
  for (int k = 1; k <= 3 * places; ++k) {
    wheel.rest();
    wheel.input.wheel.velocity[across ? 1 : 0] = (k <= places ? step : -step) * slips / time;
    wheel.go(time);
    const double law = k <= places ? wanted[2 * k] : wanted[2 * places] - 2.0 * wanted[k - places];
    const int i = across ? 1 : 0;
    worst = std::max(worst, std::abs(-(wheel.wrench.force[i] - standing.force[i]) / wheel.limit() - law));
  }
  return worst;
}

int loops() {
  constexpr Loop all[] = {{"along x, 0.5", 0.5, 0, 0, false}, {"along x, 0.9", 0.9, 0, 0, false},
                          {"along x, 1.3", 1.3, 0, 0, false}, {"along y, 0.5", 0, 0.5, 0, false},
                          {"along y, 0.9", 0, 0.9, 0, false}, {"spin, 0.6", 0, 0, 0.6, false},
                          {"spin, 1", 0, 0, 1.0, false},      {"spin, 2", 0, 0, 2.0, false},
                          {"circle, 0.5", 0.5, 0.5, 0, true}, {"circle, 0.8", 0.8, 0.8, 0, true},
                          {"x and spin", 0.7, 0, 1.0, false}};
  const wrc_material steel = wrc_material_default();
  double worst = 0.0, off = 0.0;
  std::printf("work of a closed loop at rest on a plane: strips over exact, less 1 [%%], a/b 0.6, 1, 1.8\n");
  for (const Loop& loop : all) {
    std::printf("%-14s", loop.name);
    for (const double ratio : {0.6, 1.0, 1.8}) {
      wrc_ellipse ellipse = sized<wrc_ellipse>();
      ellipse.a = 6e-3 * std::sqrt(ratio);
      ellipse.b = 6e-3 / std::sqrt(ratio);
      ellipse.normal_force = 80e3;
      const Displaced displaced{ellipse, steel, 0.3, loop};
      const double error = displaced.by_strips() / displaced.exactly() - 1.0;
      std::printf("  %6.2f", 100.0 * error);
      worst = std::max(worst, std::abs(error));
    }
    std::printf("\n");
  }
  Wheel wheel(true);
  std::printf("shifts of a wheel beside its load over approach, over mu N [%%]: along, across\n");
  for (const double y :
       {4e-3, 3.5e-3, 3e-3, 2e-3, 1.5e-3, 1.1e-3, 0.75e-3, 0.4e-3, 0.0, -1.2e-3, -3e-3, -5e-3}) {
    const double along = shift_error(wheel, y, false), across = shift_error(wheel, y, true);
    std::printf("y %5.2f mm  %.2f  %.2f\n", 1e3 * y, 100.0 * along, 100.0 * across);
    off = std::max({off, along, across});
  }
  std::printf("largest: work %.1f %%, force %.2f %% of mu N\n", 100.0 * worst, 100.0 * off);
  return 0;
}

/// Medians of times [us]: without memory, with it, with it and derivatives.
struct Times {
  double without, with, derivatives;
};

/// A wheel that weaves at this speed, in steps of 1 ms; every step is marked, and committed.
Times times_at(Wheel& wheel, Wheel& forgets, double speed, bool load, int32_t start, long steps) {
  wheel.stand(4e-3, 80e3);
  wheel.roll(speed, 1e-3, 1e-3);
  if (load) {
    wheel.input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    wheel.input.vertical_load = 80e3;
  }
  wheel.input.start = start;
  std::vector<double> time[3];
  const auto take = [](std::vector<double>& into, const auto& call) {
    const double from = processor_time();
    call();
    into.push_back(processor_time() - from);
  };
  for (long k = 0; k < steps; ++k) {
    wheel.input.wheel.y = 4e-3 + 1e-4 * std::sin(0.05 * static_cast<double>(k));
    forgets.input = wheel.input;
    take(time[0], [&] { forgets.solve(); });
    wrc_contact_mark(forgets.contact());
    take(time[1], [&] { wheel.solve(1e-3); });
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    if (k % 8 == 0) {
      take(time[2],
           [&] { wrc_contact_wrench_derivatives(wheel.contact(), &wheel.input, &wheel.wrench, &found); });
    }
    wrc_contact_commit(wheel.contact());
  }
  wheel.input.start = WRC_START_COLD;
  return {at_share(time[0], 0.5), at_share(time[1], 0.5), at_share(time[2], 0.5)};
}

int cost(long steps) {
  std::printf("time over that without memory (with derivatives) at 0.1, 2, 20, 60 m/s\n");
  for (const char* const resolution : {"default", "real time"})
    for (const int32_t start : {WRC_START_COLD, WRC_START_MARK})
      for (const bool load : {false, true}) {
        Wheel wheel(true, resolution), forgets(false, resolution);
        std::printf("%-9s, %-6s given, %-12s", resolution, load ? "load" : "height",
                    start == WRC_START_MARK ? "from a mark:" : "cold:");
        for (const double speed : {0.1, 2.0, 20.0, 60.0}) {
          const Times t = times_at(wheel, forgets, speed, load, start, steps);
          std::printf("  %.2f (%.1f)", t.with / t.without, t.derivatives / t.without);
        }
        std::printf("\n");
      }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  const auto number = [&](int k, long usual) { return argc > k ? std::atol(argv[k]) : usual; };
  const auto seed = static_cast<unsigned long>(number(3, 1));
  try {
    if (what == "steady") return steady(number(2, 200), seed);
    if (what == "passive") return passive(number(2, 2000), seed);
    if (what == "scans") return scans();
    if (what == "loops") return loops();
    if (what == "cost") return cost(number(2, 800));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "memory_report: %s\n", error.what());
    return 1;
  }
  std::fprintf(
      stderr,
      "usage: memory_report steady [CASES [SEED]] | passive [STEPS [SEED]] | scans | loops | cost [STEPS]\n");
  return 2;
}
