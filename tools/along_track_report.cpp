/// Figures of a rail that changes along the track and a wheel that is not round:
///     along_track_report [exact [PART OF A ROW'S NAME]]
/// Work round closed paths over a ramp, steps of the force across a section's border, the height and the
/// impact of a wheel with a flat, and what a step costs. Times compare rows of one run, measured in turns.
/// With `exact`: random poses on such bodies, in real time against wrc_exact_wrench; two minutes.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace {

constexpr double turn = 6.283185307179586, radius = 0.46;

/// A model with one contact, and an input for it.
class Pair {
 public:
  explicit Pair(const wrc_config& config) {
    if (wrc_model_create(&config, nullptr, &model_, nullptr, 0) < 0 ||
        wrc_contact_create(model_, WRC_SIDE_RIGHT, nullptr, &contact_, nullptr, 0) < 0) {
      char text[256];
      wrc_config_check(&config, text, sizeof text);
      std::printf("no model: %s\n", text);
      std::exit(1);
    }
    input.friction.coefficient = 0.0;
    input.start = WRC_START_COLD;
    input.wheel.velocity[0] = 20.0;
    input.wheel.angular_axes = WRC_AXES_TRACK;
    input.wheel.angular_velocity[1] = -20.0 / radius;
  }
  ~Pair() {
    wrc_contact_destroy(contact_);
    wrc_model_destroy(model_);
  }
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

  int32_t step() { return wrc_contact_wrench(contact_, &input, &wrench); }
  /// Height under a load.
  double height(double load) {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = load;
    step();
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    return wrench.z;
  }
  wrc_contact* contact() { return contact_; }
  const wrc_model* model() const { return model_; }

  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = sized<wrc_wrench>();

 private:
  wrc_model* model_ = nullptr;
  wrc_contact* contact_ = nullptr;
};

wrc_config bodies() {
  wrc_config config = test_config();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 0.025;
  return config;
}

/// Level to 2 m, 1:50 down to 5 m, level to 7 m; of `every` metres from section to section.
std::vector<wrc_rail_section> ramp(double every) {
  std::vector<wrc_rail_section> sections;
  for (int k = 0; k * every <= 7.0 + 1e-9; ++k) {
    wrc_rail_section section{};
    section.distance = k * every;
    section.z = 0.02 * (std::clamp(section.distance, 2.0, 5.0) - 2.0);
    section.profile.kind = WRC_PROFILE_60E1;
    sections.push_back(section);
  }
  return sections;
}

/// Sections 20 mm apart over 0.4 m, rising and moving aside by so much per length; both zero at 0.2 m.
std::vector<wrc_rail_section> steep_rail(double rise, double aside) {
  std::vector<wrc_rail_section> sections;
  for (int k = 0; k <= 20; ++k) {
    wrc_rail_section section{};
    section.distance = 0.02 * k;
    section.y = aside * (section.distance - 0.2);
    section.z = -rise * (section.distance - 0.2);
    section.profile.kind = WRC_PROFILE_60E1;
    sections.push_back(section);
  }
  return sections;
}

void give(const std::vector<wrc_rail_section>& sections, wrc_config& config) {
  config.rail_section_count = static_cast<uint32_t>(sections.size());
  config.rail_section_size = sizeof sections[0];
  config.rail_sections = sections.data();
}

/// Work of the force on the wheel along straight legs through (distance, y, overlap below the height under
/// 10 kN): its sum, and what is exchanged.
void work_round_a_path() {
  wrc_config config = bodies();
  const auto sections = ramp(1.0);
  give(sections, config);
  Pair pair(config);
  std::printf("== frictionless work round closed paths over a ramp of 1:50, 80 kN and less\n");
  const auto round = [&](const char* name, double from, double to, double y_from, double y_to) {
    struct Corner {
      double distance, y, deeper;
    };
    const Corner corners[] = {{from, y_from, 0.0},   {to, y_to, 0.0},
                              {to, y_to, 60e-6},     {0.5 * (from + to), y_from, 60e-6},
                              {from, y_from, 60e-6}, {from, y_from, 0.0}};
    double work = 0.0, exchanged = 0.0;
    double at[3] = {}, force[3] = {};
    bool first = true;
    for (int leg = 0; leg + 1 < 6; ++leg) {
      const Corner &a = corners[leg], &b = corners[leg + 1];
      const auto base = [&](const Corner& c) {
        pair.input.distance = c.distance;
        pair.input.wheel.y = c.y;
        return pair.height(10e3) + c.deeper;
      };
      const double z_a = base(a), z_b = base(b);
      const int steps = a.distance == b.distance ? 60 : 1200;
      for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        pair.input.distance = a.distance + t * (b.distance - a.distance);
        pair.input.wheel.y = a.y + t * (b.y - a.y);
        pair.input.wheel.z = z_a + t * (z_b - z_a);
        pair.step();
        const double now[3] = {pair.input.distance, pair.input.wheel.y, pair.input.wheel.z};
        if (!first) {
          double done = 0.0;
          for (int k = 0; k < 3; ++k) done += 0.5 * (force[k] + pair.wrench.force[k]) * (now[k] - at[k]);
          work += done;
          exchanged += std::abs(done);
        }
        first = false;
        std::copy_n(now, 3, at);
        std::copy_n(pair.wrench.force, 3, force);
      }
    }
    std::printf("  %-34s %10.4f J of %9.4f J exchanged: %.4f %%\n", name, work, exchanged,
                100.0 * std::abs(work) / exchanged);
  };
  round("straight part, 3.2 to 3.8 m", 3.2, 3.8, 0.0, 0.0);
  round("straight part, y 0 to 3 mm", 3.2, 3.8, 0.0, 3e-3);
}

/// Along paths that keep to the ramp, so that the overlap stays within what steel carries.
void work_along_the_ramp() {
  wrc_config config = bodies();
  const auto sections = ramp(1.0);
  give(sections, config);
  Pair pair(config);
  const double from = 1.5, to = 5.5;
  const int steps = 4000;
  std::vector<double> base;
  for (int i = 0; i <= steps; ++i) {
    pair.input.distance = from + (to - from) * i / steps;
    base.push_back(pair.height(10e3));
  }
  double work = 0.0, exchanged = 0.0, at[2] = {}, force[2] = {};
  bool first = true;
  const auto visit = [&](double distance, double z) {
    pair.input.distance = distance;
    pair.input.wheel.z = z;
    pair.step();
    if (!first) {
      const double done = 0.5 * ((force[0] + pair.wrench.force[0]) * (distance - at[0]) +
                                 (force[1] + pair.wrench.force[2]) * (z - at[1]));
      work += done;
      exchanged += std::abs(done);
    }
    first = false;
    at[0] = distance;
    at[1] = z;
    force[0] = pair.wrench.force[0];
    force[1] = pair.wrench.force[2];
  };
  const auto place = [&](int i) { return from + (to - from) * i / steps; };
  for (int i = 0; i <= steps; ++i) visit(place(i), base[static_cast<std::size_t>(i)]);
  for (int i = 0; i <= 60; ++i) visit(to, base.back() + 1e-6 * i);
  for (int i = steps; i >= 0; --i) visit(place(i), base[static_cast<std::size_t>(i)] + 60e-6);
  for (int i = 60; i >= 0; --i) visit(from, base.front() + 1e-6 * i);
  std::printf("  %-34s %10.4f J of %9.4f J exchanged: %.4f %%\n", "whole ramp down and up again", work,
              exchanged, 100.0 * std::abs(work) / exchanged);
}

void scan_across_a_border() {
  wrc_config config = bodies();
  const auto sections = ramp(1.0);
  give(sections, config);
  Pair pair(config);
  pair.input.friction.coefficient = 0.3;
  pair.input.wheel.y = 4e-3;
  pair.input.wheel.velocity[1] = 0.02;
  std::printf(
      "== scans across the borders of sections: largest change from one step to the next, of the load\n");
  for (const double border : {2.0, 3.0, 5.0}) {
    for (const double step : {1e-6, 10e-6}) {
      pair.input.distance = border;
      pair.input.wheel.z = pair.height(80e3);
      double before[2][3] = {}, largest = 0.0, load = 1.0;
      for (int i = -200; i <= 200; ++i) {
        pair.input.distance = border + step * i;
        pair.step();
        load = pair.wrench.normal_force;
        for (int k = 0; k < 3; ++k) {
          const double now = pair.wrench.force[k];
          if (i > -199) largest = std::max(largest, std::abs(now - 2.0 * before[0][k] + before[1][k]) / load);
          before[1][k] = before[0][k];
          before[0][k] = now;
        }
      }
      std::printf("  at %.0f m, steps of %2.0f um: %.2e (limit 2e-3)\n", border, 1e6 * step, largest);
    }
  }
}

/// A wheel's deviation, periodic.
struct Flat {
  bool chord;
  double deep = 0.5e-3, length = 0.09;
  double operator()(double angle) const {
    const double from = angle > 0.5 * turn ? angle - turn : angle;
    if (chord) {
      const double half = std::acos(1.0 - deep / radius);
      return std::abs(from) < half ? radius * (std::cos(half) / std::cos(from) - 1.0) : 0.0;
    }
    const double half = 0.5 * length / radius;
    return std::abs(from) < half ? -0.5 * deep * (1.0 + std::cos(0.5 * turn * from / half)) : 0.0;
  }
};

/// Its table, in which the ends of the flat are given.
struct RoundTable {
  std::vector<double> angle, deviation;
  RoundTable(const Flat& flat, int count) {
    const double half = flat.chord ? std::acos(1.0 - flat.deep / radius) : 0.5 * flat.length / radius;
    for (int i = 0; i <= count; ++i) angle.push_back(turn * i / count);
    for (const double edge : {half, turn - half})
      angle[static_cast<std::size_t>(std::lround(edge / turn * count))] = edge;
    for (const double at : angle) deviation.push_back(flat(at < turn ? at : 0.0));
  }
  wrc_config_roundness table() const {
    return {static_cast<uint32_t>(angle.size()), 1, angle.data(), nullptr, deviation.data(), {}};
  }
};

/// How much lower the wheel's middle stands: radius less the largest of (r + d) cos, and its derivative.
double lower(const Flat& flat, double at) {
  double reach = 0.0, best = 0.0;
  for (int k = -600; k <= 600; ++k) {
    const double from = 0.15 * k / 600 + at;
    const double wrapped = from - turn * std::floor(from / turn);
    const double here = (radius + flat(wrapped)) * std::cos(from - at);
    if (here > reach) {
      reach = here;
      best = from;
    }
  }
  // finer, about the highest
  for (int k = -200; k <= 200; ++k) {
    const double from = best + 0.00025 * k / 200, wrapped = from - turn * std::floor(from / turn);
    reach = std::max(reach, (radius + flat(wrapped)) * std::cos(from - at));
  }
  return radius - reach;
}

/// At the lightest load there is: what the bodies yield then, more where the wheel is curved more, is within
/// the figures.
void height_of_a_flat() {
  constexpr double light = 100.0;  // [N]
  std::printf("== height of a wheel with a flat of 0.5 mm against its support function, %.1f kN\n",
              1e-3 * light);
  for (const bool chord : {false, true}) {
    const Flat flat{chord};
    const RoundTable round(flat, 19999);
    wrc_config config = bodies();
    config.roundness = round.table();
    Pair pair(config);
    pair.input.angle = 0.5 * turn;
    const double level = pair.height(light);
    double largest = 0.0;
    int failed = 0;
    const auto look = [&](double at) {
      pair.input.angle = -at;
      const double height = pair.height(light);
      if (pair.wrench.force[2] == 0.0)
        ++failed;
      else
        largest = std::max(largest, std::abs(height - level - lower(flat, at)));
    };
    for (int i = -100; i <= 100; ++i) look(0.13 * i / 100);
    for (int i = -100; i <= 100; ++i) look(0.002 * i / 100);  // where it goes over from edge to edge
    std::printf("  %-26s off by at most %.2f um; %d of 402 without a result\n",
                chord ? "chord, sharp edges" : "worn, a cosine of 90 mm", 1e6 * largest, failed);
  }
}

/// A wheel's share of mass under a constant load rolls over a flat at 60 km/h on a rigid rail.
void impact_of_a_flat() {
  std::printf("== impact at 60 km/h, 600 kg under 80 kN, rigid rail: largest force\n");
  std::vector<double> y, rail_z, wheel_z;
  for (int i = -140; i <= 140; ++i) {
    y.push_back(0.25e-3 * i);
    rail_z.push_back(0.3 - std::sqrt(0.09 - y.back() * y.back()));
    wheel_z.push_back(0.0);
  }
  wrc_config config = test_config();
  config.wheel = {WRC_PROFILE_POINTS, static_cast<uint32_t>(y.size()), y.data(), wheel_z.data(), 0.0, {}};
  config.rail = {WRC_PROFILE_POINTS, static_cast<uint32_t>(y.size()), y.data(), rail_z.data(), 0.0, {}};
  config.track.placement = WRC_PLACEMENT_ORIGIN;
  config.track.rail_origin = 0.75;
  const double mass = 600.0, load = 80e3, speed = 60.0 / 3.6, step = 4e-6;
  constexpr int steps = 4000;  // 16 ms
  // Hertz's spring F = C depth^(3/2) over the wheel's radius
  constexpr int radii = 24;
  double of_radius[radii], spring[radii];
  for (int k = 0; k < radii; ++k) {
    wrc_config hertz = config;
    hertz.normal.method = WRC_NORMAL_HERTZ;
    hertz.wheelset.wheel_radius = of_radius[k] = 0.1 + 1.4 * k / (radii - 1);
    Pair closed(hertz);
    wrc_planar_input input = wrc_planar_input_default();
    input.load.normal_force = load;
    wrc_planar_output output = sized<wrc_planar_output>();
    wrc_planar_step(closed.contact(), &input, &output);
    spring[k] = load / std::pow(output.normal.approach, 1.5);
  }
  const auto spring_at = [&](double r) {
    const double place = std::clamp((r - 0.1) / 1.4, 0.0, 1.0) * (radii - 1);
    const int k = std::min(static_cast<int>(place), radii - 2);
    return spring[k] + (place - k) * (spring[k + 1] - spring[k]);
  };
  // radius of curvature where the wheel touches, from its support function
  const auto curved = [&](const Flat& flat, double at) {
    constexpr double h = 3e-3 / radius;
    const double bend = (lower(flat, at + h) - 2.0 * lower(flat, at) + lower(flat, at - h)) / (h * h);
    return radius - lower(flat, at) - bend;
  };
  for (const bool chord : {false, true}) {
    const Flat flat{chord};
    const RoundTable round(flat, 19999);
    config.roundness = round.table();
    Pair pair(config);
    pair.input.start = WRC_START_WARM;
    pair.input.angle = 0.5 * turn;
    double largest[3] = {}, took = 0.0;
    for (const int model : {0, 1, 2}) {
      const double standing = std::pow(load / spring_at(radius), 2.0 / 3.0);
      double z = model > 0 ? standing : pair.height(load), v = 0.0, angle = 0.2;
      const auto begin = std::chrono::steady_clock::now();
      for (int i = 0; i < steps; ++i) {
        double force;
        if (model > 0) {
          const double depth = z - lower(flat, -angle);
          force = depth > 0.0 ? spring_at(model == 1 ? radius : curved(flat, -angle)) * std::pow(depth, 1.5)
                              : 0.0;
        } else {
          pair.input.angle = angle;
          pair.input.wheel.z = z;
          pair.step();
          force = -pair.wrench.force[2];
        }
        largest[model] = std::max(largest[model], force);
        v += step * (load - force) / mass;
        z += step * v;
        angle -= step * speed / radius;
      }
      if (model == 0) took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    std::printf(
        "  %-26s %.1f kN; Hertz's spring of the radius there %.1f kN: %+.2f %%, of the round wheel %.1f kN: "
        "%+.2f "
        "%%  (%.1f s of computing for 0.016 s)\n",
        chord ? "chord, sharp edges" : "worn, a cosine of 90 mm", 1e-3 * largest[0], 1e-3 * largest[2],
        100.0 * (largest[0] / largest[2] - 1.0), 1e-3 * largest[1], 100.0 * (largest[0] / largest[1] - 1.0),
        took);
  }
}

void cost() {
  std::printf("== time of a call at 80 kN or so, median of 400 taken in turns [us]\n");
  const auto few = ramp(1.0), many = ramp(0.0075);
  const RoundTable round(Flat{false}, 720);
  wrc_config constant = bodies(), sections = bodies(), more = bodies(), flat = bodies(), both = bodies();
  give(few, sections);
  give(many, more);
  flat.roundness = round.table();
  give(few, both);
  both.roundness = round.table();
  struct Row {
    const char* name;
    Pair pair;
    std::vector<double> times[2];
  } rows[] = {{"constant", Pair(constant), {}},
              {"8 sections", Pair(sections), {}},
              {"934 sections", Pair(more), {}},
              {"a flat", Pair(flat), {}},
              {"8 sections and a flat", Pair(both), {}}};
  auto slopes = sized<wrc_wrench_derivatives>();
  for (int i = 0; i < 400; ++i) {
    for (Row& row : rows) {
      wrc_wheel_input& input = row.pair.input;
      input.friction.coefficient = 0.3;
      input.wheel.y = 2e-3 + 1e-5 * (i % 20);
      input.wheel.z = 0.14e-3;
      if (row.pair.input.distance == 0.0 && (&row == &rows[1] || &row == &rows[2] || &row == &rows[4]))
        input.distance = 1.0;
      if (&row >= &rows[3]) input.angle = 3.0;
      for (int with : {0, 1}) {
        const auto begin = std::chrono::steady_clock::now();
        if (with)
          wrc_contact_wrench_derivatives(row.pair.contact(), &input, &row.pair.wrench, &slopes);
        else
          row.pair.step();
        row.times[with].push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      }
    }
  }
  double base[2] = {};
  for (Row& row : rows) {
    double median[2];
    for (int with : {0, 1}) {
      std::sort(row.times[with].begin(), row.times[with].end());
      median[with] = row.times[with][200];
      if (&row == rows) base[with] = median[with];
    }
    std::printf("  %-24s %7.1f (%.2f)   with derivatives %7.1f (%.2f)   load %.0f kN\n", row.name,
                1e6 * median[0], median[0] / base[0], 1e6 * median[1], median[1] / base[1],
                -1e-3 * row.pair.wrench.force[2]);
  }
}

double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Median, 95th percentile and worst [%].
void print(std::vector<double>& errors) {
  std::sort(errors.begin(), errors.end());
  const double last = static_cast<double>(errors.size()) - 1.0;
  const auto at = [&](double share) {
    return errors.empty() ? 0.0 : 100.0 * errors[static_cast<std::size_t>(std::lround(share * last))];
  };
  std::printf(" %6.2f / %5.2f / %5.2f  ", at(0.5), at(0.95), at(1.0));
}

/// 60E1 of which the gauge corner is worn off, 0.6 mm at most.
class WornHead {
 public:
  WornHead() {
    wrc_config config = bodies();
    config.track.rail_inclination = 0.0;
    Pair pair(config);
    wrc_view y, z;
    wrc_model_profile(pair.model(), WRC_SIDE_RIGHT, WRC_BODY_RAIL, &y, &z, nullptr);
    const double *const at_y = y.data, *const at_z = z.data;
    const double middle = 0.5 * (at_y[0] + at_y[y.count - 1]);
    for (uint32_t k = 0; k < y.count; ++k) {
      const double from_corner = (at_y[k] - middle + 27e-3) / 12e-3;
      y_.push_back(at_y[k] - middle);
      z_.push_back(at_z[k] + 0.6e-3 * std::exp(-from_corner * from_corner));
    }
  }
  wrc_profile profile() const {
    return {WRC_PROFILE_POINTS, static_cast<uint32_t>(y_.size()), y_.data(), z_.data(), 0.0, {}};
  }

 private:
  std::vector<double> y_, z_;
};

/// Distance of two vectors.
double distance_of(const double (&a)[3], const double (&b)[3]) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                   (a[2] - b[2]) * (a[2] - b[2]));
}

/// Relative errors of poses against the exact solver [-], and the number of poses with another flag.
struct ExactErrors {
  std::vector<double> force, moment, power;
  int others = 0;

  /// Solves the pair's step both ways at its height.
  void add(Pair& pair) {
    wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
    options.cell_x = options.cell_s = 3e-4;
    wrc_wrench exact = sized<wrc_wrench>();
    const int32_t status = pair.step(),
                  exact_status = wrc_exact_wrench(pair.contact(), &pair.input, &options, &exact);
    // the end of a surface is flagged
    if ((status != WRC_OK && status != WRC_FLAG_PATCH_AT_EDGE) ||
        (exact_status != WRC_OK && exact_status != WRC_FLAG_PATCH_AT_EDGE)) {
      ++others;
      return;
    }
    const double none[3] = {}, size = std::max(distance_of(exact.force, none), 20e3);
    force.push_back(distance_of(pair.wrench.force, exact.force) / size);
    moment.push_back(distance_of(pair.wrench.moment, exact.moment) / (0.75 * size));
    if (exact.power > 100.0) power.push_back(std::abs(pair.wrench.power / exact.power - 1.0));
  }

  void print_row(const char* name) {
    std::printf("  %-34s", name);
    print(force);
    print(moment);
    print(power);
    std::printf("%s\n", others > 0 ? (" flagged: " + std::to_string(others)).c_str() : "");
    std::fflush(stdout);
  }
};

/// Sets a random pose and motion without its height; `change` has the last word. Returns the load [N].
double draw_pose(std::mt19937_64& random, const std::function<void(wrc_wheel_input&)>& change,
                 wrc_wheel_input& input) {
  input.damping = 0.0;
  input.friction.coefficient = 0.0;
  input.wheel.y = between(random, -6e-3, 6.5e-3);
  input.wheel.yaw = between(random, -10e-3, 10e-3);
  input.wheel.velocity[1] = between(random, -0.1, 0.1);
  input.wheel.velocity[2] = 0.0;
  input.wheel.angular_velocity[1] = -20.0 / radius * (1.0 + between(random, -4e-3, 4e-3));
  change(input);
  // it runs where it points to, and turns about its own axle
  input.wheel.velocity[1] += 20.0 * std::tan(input.wheel.yaw);
  input.wheel.angular_axes = WRC_AXES_BODY;
  return between(random, 20e3, 120e3);
}

/// `only`: part of the names of the rows wanted.
void against_exact(const char* only) {
  constexpr int poses = 40;
  std::printf(
      "== %d poses each from tread to flange, 20 to 120 kN, in real time against exactly on 0.3 mm: median / "
      "p95 / worst [%%]\n  %-34s %-24s %-24s %-24s\n",
      poses, "", "force (size or 20 kN)", "moment (0.75 m times)", "power (of those > 100 W)");
  const WornHead worn_head;
  std::vector<wrc_rail_section> changing = ramp(1.0);
  for (std::size_t k = 0; k < changing.size(); ++k) {
    changing[k].y = k % 2 == 0 ? 0.0 : 4e-3;
    if (k % 3 == 0) changing[k].profile = worn_head.profile();
  }
  const auto straight = ramp(1.0), nose10 = steep_rail(0.1, 0.0), nose20 = steep_rail(0.05, 0.0),
             wing = steep_rail(0.0, 1.0 / 9.0);
  RoundTable polygon(Flat{false}, 720), worn(Flat{false, 0.5e-3, 0.09}, 2000), chord(Flat{true}, 2000);
  for (std::size_t i = 0; i < polygon.angle.size(); ++i)
    polygon.deviation[i] = 1e-4 * std::cos(18.0 * polygon.angle[i]);
  std::vector<wrc_rail_section> step = ramp(1.0);
  step.resize(3);
  step.insert(step.end(), step.begin() + 1, step.end());
  for (std::size_t k = 3; k < step.size(); ++k) {
    step[k].surface = 1;
    step[k].z = -1e-3;
  }
  std::mt19937_64 random(1);
  using Input = wrc_wheel_input;
  const auto nothing = [](wrc_config&) {};
  const auto still = [](Input&) {};
  const auto anywhere = [&](Input& input) { input.distance = between(random, 1.5, 5.5); };
  const auto steep = [&](Input& input) { input.distance = between(random, 0.1, 0.3); };
  const auto about = [&](Input& input) { input.angle = between(random, -0.15, 0.15); };
  const auto shearing = [&](Input& input) {
    input.friction.layer_thickness = 1e-3;
    input.friction.layer_modulus = 1e-3 / (4e-14 * 0.05 * std::pow(60.0, between(random, 0.0, 1.0)));
  };
  const auto rounded = [](const RoundTable& table) {
    return [&table](wrc_config& config) { config.roundness = table.table(); };
  };
  const struct {
    const char* name;
    std::function<void(wrc_config&)> bodies;
    std::function<void(Input&)> pose;
  } each[] = {
      {"the same rail everywhere", nothing, still},
      {"damping 0.5 s/m, +-0.3 m/s", nothing,
       [&](Input& input) {
         input.damping = 0.5;
         input.wheel.velocity[2] = between(random, -0.3, 0.3);
       }},
      {"a layer, 0.3 to 1 of the slope", nothing,
       [&](Input& input) { input.friction.slope_reduction = between(random, 0.3, 1.0); }},
      {"a ramp of 1:50", [&](wrc_config& config) { give(straight, config); }, anywhere},
      {"profiles and gauge that change", [&](wrc_config& config) { give(changing, config); }, anywhere},
      {"a nose that rises 1:10", [&](wrc_config& config) { give(nose10, config); }, steep},
      {"a nose that rises 1:20", [&](wrc_config& config) { give(nose20, config); }, steep},
      {"a wing that moves aside 1:9", [&](wrc_config& config) { give(wing, config); },
       [&](Input& input) {
         input.distance = between(random, 0.17, 0.23);
         input.wheel.y = between(random, -6e-3, 3e-3);
       }},
      {"a polygon of 18 corners, 0.1 mm", rounded(polygon), about},
      {"a worn flat of 0.5 mm", rounded(worn), about},
      {"a fresh flat of 0.5 mm", rounded(chord), about},
      {"the same rail, yaw 15 to 40 mrad", nothing,
       [&](Input& input) {
         input.wheel.yaw = std::copysign(between(random, 15e-3, 40e-3), input.wheel.yaw);
       }},
      // 0.05 to 3 times the flexibility of the bodies; then yielding from 30 to 400 MPa on
      {"a layer that shears", nothing, shearing},
      {"a layer that shears and yields", nothing,
       [&](Input& input) {
         shearing(input);
         input.friction.layer_yield = between(random, 30e6, 400e6);
       }},
      {"one that hardens or softens", nothing,
       [&](Input& input) {
         shearing(input);
         input.friction.layer_yield = between(random, 30e6, 400e6);
         input.friction.layer_hardening = between(random, -1e12, 4e12);
       }},
      {"a rail that begins, 1 mm higher", [&](wrc_config& config) { give(step, config); },
       [&](Input& input) { input.distance = between(random, 0.988, 1.004); }}};
  for (const auto& [name, change, pose] : each) {
    wrc_config config = bodies();
    change(config);
    Pair pair(config);
    ExactErrors errors;
    const bool wanted = std::strstr(name, only) != nullptr;
    for (int n = 0; n < poses; ++n) {
      const double load = draw_pose(random, pose, pair.input);
      if (!wanted) continue;  // poses of a row are the same, whichever rows run
      const double damping = std::exchange(pair.input.damping, 0.0);
      pair.input.wheel.z = pair.height(load);
      pair.input.damping = damping;
      pair.input.friction.coefficient = 0.3;
      errors.add(pair);
    }
    if (wanted) errors.print_row(name);
  }
}

}  // namespace

int main(int arguments, char** argument) {
  if (arguments > 1 && std::strcmp(argument[1], "exact") == 0) {
    against_exact(arguments > 2 ? argument[2] : "");
    return 0;
  }
  work_round_a_path();
  work_along_the_ramp();
  scan_across_a_border();
  height_of_a_flat();
  impact_of_a_flat();
  cost();
}
