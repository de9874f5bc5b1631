/// wrench_derivatives - wrc_contact_wrench_derivatives() against central differences of
/// wrc_contact_wrench() on random poses, and what it takes beside a step.
///
///   wrench_derivatives [POSES [SEED]] [--frictionless | --heated | --factors | --memory] [--setting NAME]
///                      [--list ERROR]
///
/// Poses: S1002 on the benchmark UIC60, both sides, lateral +-8 mm, yaw +-15 mrad, roll +-10 mrad, the rail
/// displaced, turned, aslant and moving, vertical loads of 5 to 150 kN, 1 to 80 m/s, some backwards or near
/// standstill, creepages up to saturation, some with falling friction or a soft layer; `--heated`: all with
/// friction over temperature; `--factors`: all with friction over temperature that falls with the sliding
/// speed; `--memory`: all with config.surface.memory, after up to five committed steps of 10 us to 0.1 s, a
/// third of all steps at rest, some that turn back; `--setting`: strips as wide as at a setting of
/// WRC_RESOLUTION_LIST, solved as precisely and as far as at the default. An error is over the largest entry
/// of its row among the columns of the same unit (lengths, angles, velocities, angular velocities, slopes of
/// the rail, a factor on friction): that is less than the largest of the whole row. An entry whose
/// differences to the two sides are not the same stands at a kink: a strip enters, a cell goes from stick to
/// slip, a table's interval ends.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#include "test_config.hpp"
#include "wrc/wrc.h"
#include "wrench_inputs.hpp"

namespace {

constexpr int rows = 6, columns = WRC_BY_VERTICAL_LOAD + 4;
constexpr int slope_y = WRC_BY_VERTICAL_LOAD, slope_z = slope_y + 1, factor = slope_z + 1,
              duration = factor + 1;
constexpr const char* row_names[rows] = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
constexpr const char* column_names[columns] = {"y",       "z",       "roll",      "yaw",      "vx",
                                               "vy",      "vz",      "wx",        "wy",       "wz",
                                               "rail y",  "rail z",  "rail roll", "rail vy",  "rail vz",
                                               "rail wx", "slope y", "slope z",   "friction", "time"};

enum Unit { length, angle, velocity, angular_velocity, slope, pure, time_step, units };
constexpr Unit unit_of[columns] = {length,
                                   length,
                                   angle,
                                   angle,
                                   velocity,
                                   velocity,
                                   velocity,
                                   angular_velocity,
                                   angular_velocity,
                                   angular_velocity,
                                   length,
                                   length,
                                   angle,
                                   velocity,
                                   velocity,
                                   angular_velocity,
                                   slope,
                                   slope,
                                   pure,
                                   time_step};

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

struct Case {
  wrc_wheel_input input = wrc_wheel_input_default();

  double* number(int column) {
    return column == factor     ? &input.friction.coefficient
           : column == duration ? &input.time_step
           : column == slope_y  ? &input.rail.y_slope
           : column == slope_z  ? &input.rail.z_slope
                                : &wrench_input(input, column);
  }

  /// Makes this a step at this place: slower or faster, back, or at rest and displaced by up to 20 um.
  void step(std::mt19937_64& random) {
    const auto between = [&random](double low, double high) { return uniform(random, low, high); };
    input.time_step = std::pow(10.0, between(-5.0, -1.0));
    const bool rests = random() % 3 == 0;
    const double slower = rests ? 0.0 : between(-1.0, 1.0);
    for (int column = WRC_BY_VELOCITY_X; column <= WRC_BY_ANGULAR_VELOCITY_Z; ++column)
      *number(column) *= slower;
    for (int column = 0; rests && column < 2; ++column)
      *number(WRC_BY_VELOCITY_X + column) = between(-2e-5, 2e-5) / input.time_step;
    input.rail.y_velocity = input.rail.z_velocity = input.rail.roll_rate = 0.0;
  }
};

/// Of a column here, among those of wrc_wrench_derivatives.
int column_of(int column) {
  return column == factor     ? WRC_BY_FRICTION
         : column == duration ? WRC_BY_TIME_STEP
         : column == slope_y  ? WRC_BY_RAIL_Y_SLOPE
         : column == slope_z  ? WRC_BY_RAIL_Z_SLOPE
                              : column;
}

double seconds() {
  using clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(clock::now().time_since_epoch()).count();
}

struct Errors {
  std::vector<double> all;
  long kinks = 0;
  double at(double share) {
    if (all.empty()) return 0.0;
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
    std::nth_element(all.begin(), all.begin() + k, all.end());
    return all[static_cast<std::size_t>(k)];
  }
  double within(double limit) const {
    const auto good = std::count_if(all.begin(), all.end(), [&](double e) { return e <= limit; });
    return 100.0 * static_cast<double>(good) / static_cast<double>(std::max<std::size_t>(1, all.size()));
  }
};

/// What the command line asks for.
struct Options {
  long poses = 1000;
  unsigned seed = 1;
  double listed = 1e300;
  bool frictionless = false, heated = false, factors = false, memory = false;
  const char* setting = "default";
};

Options read_options(int argc, char** argv) {
  Options o;
  int numbers = 0;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--frictionless") == 0) {
      o.frictionless = true;
    } else if (std::strcmp(argv[i], "--heated") == 0) {
      o.heated = true;
    } else if (std::strcmp(argv[i], "--factors") == 0) {
      o.factors = true;
    } else if (std::strcmp(argv[i], "--memory") == 0) {
      o.memory = true;
    } else if (std::strcmp(argv[i], "--setting") == 0 && i + 1 < argc) {
      o.setting = argv[++i];
    } else if (std::strcmp(argv[i], "--list") == 0 && i + 1 < argc) {
      o.listed = std::atof(argv[++i]);
    } else if (numbers++ == 0) {
      o.poses = std::atol(argv[i]);
    } else {
      o.seed = static_cast<unsigned>(std::atol(argv[i]));
    }
  }
  return o;
}

/// A contact of each side, with the state in which it has no memory yet.
class Contacts {
 public:
  Contacts() = default;
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;
  ~Contacts() {
    for (wrc_contact* contact : contacts_) wrc_contact_destroy(contact);
    wrc_model_destroy(model_);
  }

  bool create(const Options& o) {
    wrc_config config = test_config(), used = test_config();
    if (wrc_config_use(&used, o.setting, nullptr, 0) != WRC_OK) return false;
    config.surface.tread_width = used.surface.tread_width;
    config.surface.corner_width = used.surface.corner_width;
    config.surface.tolerance = 1e-9;  // difference quotients have errors of that part over their step
    config.surface.memory = o.memory;
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    uint64_t state_bytes = 0;
    if (wrc_model_create(&config, nullptr, &model_, nullptr, 0) != WRC_OK ||
        wrc_contact_state_size(model_, &state_bytes) != WRC_OK)
      return false;
    for (std::size_t side = 0; side < 2; ++side) {
      unused_[side].resize(state_bytes);
      if (wrc_contact_create(model_, static_cast<int32_t>(side), nullptr, &contacts_[side], nullptr, 0) !=
              WRC_OK ||
          wrc_contact_save(contacts_[side], unused_[side].data(), state_bytes) != WRC_OK)
        return false;
    }
    return true;
  }

  /// The contact of a side, as unused.
  wrc_contact* unused(std::size_t side) {
    wrc_contact_restore(contacts_[side], unused_[side].data(), unused_[side].size());
    return contacts_[side];
  }

 private:
  wrc_model* model_ = nullptr;
  wrc_contact* contacts_[2] = {nullptr, nullptr};
  std::vector<unsigned char> unused_[2];
};

/// Sets place, motion, rail and friction of a random pose, without its height; returns the speed [m/s].
double draw_pose(std::mt19937_64& random, const Options& o, Case& c) {
  const auto between = [&random](double low, double high) { return uniform(random, low, high); };
  c.input.wheel.reference = random() % 2 ? WRC_REFERENCE_WHEELSET : WRC_REFERENCE_WHEEL;
  c.input.wheel.angular_axes = static_cast<std::int32_t>(random() % 3);
  c.input.wheel.y = between(-8e-3, 8e-3);
  c.input.wheel.roll = between(-10e-3, 10e-3);
  c.input.wheel.yaw = between(-15e-3, 15e-3);
  c.input.rail.y = between(-1e-3, 1e-3);
  c.input.rail.z = between(-1e-3, 1e-3);
  c.input.rail.roll = between(-5e-3, 5e-3);
  // one in ten near standstill, one in ten backwards
  const double kind = between(0.0, 1.0), amount = kind < 0.1 ? between(0.0, 0.15) : between(1.0, 80.0);
  const double speed = kind > 0.9 ? -amount : amount, slip = std::pow(10.0, between(-4.0, -2.0));
  c.input.wheel.velocity[0] = speed;
  c.input.wheel.velocity[1] = between(-slip, slip) * speed;
  c.input.wheel.velocity[2] = between(-0.1, 0.1);
  *c.number(WRC_BY_ANGULAR_VELOCITY_X) = between(-0.1, 0.1);
  *c.number(WRC_BY_ANGULAR_VELOCITY_Y) = -speed / 0.46 * (1.0 + between(-slip, slip));
  *c.number(WRC_BY_ANGULAR_VELOCITY_Z) = between(-0.1, 0.1);
  c.input.rail.y_velocity = between(-0.01, 0.01);
  c.input.rail.z_velocity = between(-0.01, 0.01);
  c.input.rail.roll_rate = between(-0.01, 0.01);
  c.input.rail.y_slope = between(-5e-3, 5e-3);
  c.input.rail.z_slope = between(-5e-3, 5e-3);
  c.input.damping = random() % 2 ? between(0.0, 0.2) : 0.0;
  c.input.friction.coefficient = between(0.1, 0.6);
  if (random() % 4 == 0) {
    c.input.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
    c.input.friction.kinetic_ratio = 0.4;
    c.input.friction.fall_rate = between(0.1, 1.0);
  } else if (random() % 4 == 0) {
    c.input.friction.slope_reduction = between(0.2, 1.0);
  }
  if (o.frictionless) c.input.friction.coefficient = 0.0;
  if (o.heated || o.factors) {
    c.input.friction = wrc_friction_default();
    c.input.friction.coefficient = 0.4;
    c.input.friction.speed_law = o.factors ? WRC_SPEED_LAW_EXPONENTIAL : WRC_SPEED_LAW_NONE;
    c.input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  }
  return speed;
}

/// Sets the height for a random load, as if without friction: that always has an equilibrium.
bool stand(std::mt19937_64& random, wrc_contact* contact, Case& c) {
  wrc_wrench wrench = sized<wrc_wrench>();
  Case loaded = c;
  loaded.input.friction.coefficient = 0.0;
  loaded.input.damping = 0.0;
  loaded.input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  loaded.input.vertical_load = std::exp(uniform(random, std::log(5e3), std::log(150e3)));
  if (wrc_contact_wrench(contact, &loaded.input, &wrench) != WRC_OK) return false;
  c.input.wheel.z = wrench.z;
  return true;
}

/// Commits up to five steps at the place, then makes this one more.
void go_on(std::mt19937_64& random, wrc_contact* contact, Case& c) {
  const Case end = c;
  wrc_wrench wrench = sized<wrc_wrench>();
  const auto steps = static_cast<int>(random() % 6);
  for (int i = 0; i < steps; ++i) {
    c.step(random);
    if (wrc_contact_wrench(contact, &c.input, &wrench) >= WRC_OK) wrc_contact_commit(contact);
  }
  c = end;
  c.step(random);
}

/// Times of a step without and with derivatives [s].
struct Times {
  double step = 0.0, both = 0.0;
  std::vector<double> ratios;

  void print(long steps) {
    std::sort(ratios.begin(), ratios.end());
    std::printf(
        "time: step %.1f us, step with derivatives %.1f us; ratio of sums %.2f, median %.2f, 99 %% %.2f\n",
        1e6 * step / static_cast<double>(steps), 1e6 * both / static_cast<double>(steps), both / step,
        ratios[ratios.size() / 2], ratios[ratios.size() * 99 / 100]);
  }
};

/// The derivatives; false where the step or they are flagged.
bool differentiate(wrc_contact* contact, const Case& c, wrc_wrench_derivatives& found, Times& times) {
  wrc_wrench wrench = sized<wrc_wrench>();
  wrc_contact_wrench(contact, &c.input, &wrench);
  const double t0 = seconds();
  const int32_t without = wrc_contact_wrench(contact, &c.input, &wrench);
  const double t1 = seconds();
  const int32_t with = wrc_contact_wrench_derivatives(contact, &c.input, &wrench, &found);
  const double t2 = seconds();
  if (without != WRC_OK || with != WRC_OK) return false;
  times.step += t1 - t0;
  times.both += t2 - t1;
  times.ratios.push_back((t2 - t1) / (t1 - t0));
  return true;
}

/// Central differences of a step, and where those to the two sides are not the same.
struct Differences {
  double by[rows][columns] = {};
  bool kink[rows][columns] = {};

  /// `moving`: a velocity that stands for the step's own [m/s].
  Differences(wrc_contact* contact, Case c, double moving) {
    for (int column = 0; column < columns; ++column) {
      double* const number = c.number(column);
      const double value = *number;
      const double h = unit_of[column] == length             ? 1e-9
                       : unit_of[column] == angle            ? 1e-9
                       : unit_of[column] == slope            ? 1e-9
                       : unit_of[column] == velocity         ? 1e-8 * moving
                       : unit_of[column] == angular_velocity ? 2e-8 * moving
                                                             : 1e-7 * value;
      if (!(h > 0.0)) continue;  // a factor on no friction: nothing
      double ends[3][rows];
      for (int end = 0; end < 3; ++end) {
        *number = value + (end - 1) * h;
        wrc_wrench wrench = sized<wrc_wrench>();
        wrc_contact_wrench(contact, &c.input, &wrench);
        for (int r = 0; r < 3; ++r) {
          ends[end][r] = wrench.force[r];
          ends[end][r + 3] = wrench.moment[r];
        }
      }
      const double high = value + h, low = value - h;
      *number = value;
      for (int r = 0; r < rows; ++r) {
        by[r][column] = (ends[2][r] - ends[0][r]) / (high - low) * (column == factor ? value : 1.0);
        kink[r][column] = std::fabs(ends[2][r] - 2.0 * ends[1][r] + ends[0][r]) >
                          1e-3 * std::fabs(ends[2][r] - ends[0][r]) / 2.0 + 1e-9 * std::fabs(ends[1][r]);
      }
    }
  }
};

/// Errors over the largest entry of the row, over that of the same unit, and the latter entry by entry.
struct AllErrors {
  Errors of_row, of_unit, by_entry[rows][columns];

  /// Counts the errors of pose number `pose`, and prints those above `listed`.
  void add(long pose, const Case& c, const wrc_wrench_derivatives& found, const Differences& difference,
           double listed) {
    for (int r = 0; r < rows; ++r) {
      double largest = 0.0, largest_of[units] = {};
      for (int column = 0; column < columns; ++column) {
        const double size = std::fabs(difference.by[r][column]);
        largest = std::max(largest, size);
        largest_of[unit_of[column]] = std::max(largest_of[unit_of[column]], size);
      }
      for (int column = 0; column < columns; ++column) {
        const double here = found.wrench[r][column_of(column)],
                     error = std::fabs(here - difference.by[r][column]);
        const auto over = [&](double size) { return size > 0.0 ? error / size : error > 0.0 ? 1.0 : 0.0; };
        const double relative = over(largest_of[unit_of[column]]);
        for (Errors* const e : {&of_row, &of_unit, &by_entry[r][column]}) {
          if (difference.kink[r][column])
            ++e->kinks;
          else
            e->all.push_back(e == &of_row ? over(largest) : relative);
        }
        if (relative > listed && !difference.kink[r][column])
          std::printf("pose %ld y %.4f mm yaw %.4f z %.6f: d%s/d%s %.9g by differences %.9g\n", pose,
                      1e3 * c.input.wheel.y, c.input.wheel.yaw, c.input.wheel.z, row_names[r],
                      column_names[column], here, difference.by[r][column]);
      }
    }
  }

  void print() {
    for (Errors* const e : {&of_row, &of_unit}) {
      std::printf(
          "%-34s 50 %% %.1e  95 %% %.1e  99 %% %.1e  largest %.1e  within 1e-5 %.2f %%, within 1e-3 %.2f %%, "
          "at kinks %ld of %ld\n",
          e == &of_row ? "over the largest of the row:" : "over the largest of the same unit:", e->at(0.5),
          e->at(0.95), e->at(0.99), e->at(1.0), e->within(1e-5), e->within(1e-3), e->kinks,
          e->kinks + static_cast<long>(e->all.size()));
    }
    std::printf("95 %% of the errors, entry by entry (same unit)\n%10s", "");
    for (const char* name : row_names) std::printf(" %8s", name);
    std::printf("\n");
    for (int column = 0; column < columns; ++column) {
      std::printf("%10s", column_names[column]);
      for (auto& row : by_entry) std::printf(" %8.1e", row[column].at(0.95));
      std::printf("\n");
    }
  }
};

}  // namespace

int main(int argc, char** argv) {
  const Options o = read_options(argc, argv);
  Contacts contacts;
  if (!contacts.create(o)) return 1;
  std::mt19937_64 random(o.seed);
  AllErrors errors;
  Times times;
  long done = 0, skipped = 0;
  while (done < o.poses) {
    Case c;
    wrc_contact* const contact = contacts.unused(random() % 2);
    const double speed = draw_pose(random, o, c);
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    bool counts = stand(random, contact, c);
    if (counts && o.memory) go_on(random, contact, c);
    counts = counts && differentiate(contact, c, found, times);
    if (!counts) {
      ++skipped;
      continue;
    }
    ++done;
    const double moving =
        o.memory ? std::min(std::fabs(speed), 1e-3 / c.input.time_step) : std::max(0.1, std::fabs(speed));
    errors.add(done, c, found, Differences(contact, c, moving), o.listed);
  }
  std::printf("%ld poses, %ld others without contact or flagged\n", done, skipped);
  errors.print();
  times.print(done);
  return 0;
}
