/// How long a step takes, as met and by itself, and what the machine adds to a loop that does the same work
/// every time.
///
/// By itself: blocks of steps are run three times from the same saved state, so the three are the same work,
/// bit for bit; of each step the shortest time counts. What remains varies with the input alone.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "proof/processor_time.hpp"
#include "proof/proofs.hpp"
#include "proof/wheel.hpp"
#include "test_config.hpp"

namespace {

using Clock = std::chrono::steady_clock;
constexpr int block = 500;  ///< steps repeated from one saved state
constexpr int repeats = 3;

/// Times in microseconds.
using Times = std::vector<float>;

double quantile(const Times& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

constexpr double shares[] = {0.5, 0.99, 0.9999, 1.0};

/// Prints the percentiles of times, which it leaves sorted.
void print_row(const char* name, Times& times) {
  std::sort(times.begin(), times.end());
  std::printf("%-34s", name);
  for (double share : shares) std::printf(" %9.2f", quantile(times, share));
  std::printf(" %9.2f\n", times.back() / quantile(times, 0.5));
}

/// The same percentiles of two sorted lists, one over the other.
void print_ratio(const char* name, const Times& times, const Times& unit) {
  std::printf("%-34s", name);
  for (double share : shares) std::printf(" %9.2f", quantile(times, share) / quantile(unit, share));
  std::printf("\n");
}

/// Arithmetic of fixed length: the same instructions every time, so that all variation is the machine's.
class FixedWork {
 public:
  /// As long as `microseconds`, as well as a few trials can tell.
  explicit FixedWork(double microseconds) {
    double best = 1e9;
    for (int i = 0; i < 200; ++i) best = std::min(best, time_of(10000));
    rounds_ = std::max(1, static_cast<int>(10000.0 * microseconds / best));
  }
  void run() { state_ = turn(rounds_); }

 private:
  double turn(int rounds) const {
    double x = state_;
    for (int i = 0; i < rounds; ++i) x = 1.0 + 1.0 / (1.0 + x);
    return x;
  }
  double time_of(int rounds) {
    const double start = processor_time();
    state_ = turn(rounds);
    return processor_time() - start;
  }
  int rounds_ = 1;
  volatile double state_ = 1.0;
};

/// What is timed: input(i) prepares, work(i) is timed, save() and restore() bracket a block.
class Subject {
 public:
  virtual ~Subject() = default;
  virtual void input(int i) = 0;
  virtual void work() = 0;
  virtual void save() = 0;
  virtual void restore() = 0;
};

/// The complete step of one wheel: prescribed gap and load, strips in half-space equilibrium, FASTSIM-SDEC on
/// 60 x 50 cells, damage. The gaps are those of a sweep from the field side of the head to the flange.
class OneWheel : public Subject {
 public:
  OneWheel() : wheel_({WRC_NORMAL_STRIP_HALFSPACE, preset_fastsim_sdec, WRC_SIDE_RIGHT, 60, 50}) {
    for (int i = 0; i < positions; ++i) {
      wheel_.pose.lateral = -5e-3 + 12e-3 * i / (positions - 1);
      gaps_.push_back(wheel_.gap_of_pose());
    }
  }
  void input(int i) override {
    wheel_.vary(i);
    wheel_.load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
    // There and back through all positions in 4000 steps, as a wheelset moves: 6 um per step.
    position_ = std::min(i % 4000, 4000 - i % 4000) * (positions - 1) / 2000;
  }
  void work() override { wheel_.step_with(gaps_[static_cast<std::size_t>(position_)]); }
  void save() override { wheel_.save(); }
  void restore() override { wheel_.restore(); }

 private:
  static constexpr int positions = 500;
  Wheel wheel_;
  std::vector<Gap> gaps_;
  int position_ = 0;
};

/// Eight wheels with two patches each (shifts of 5.0 to 5.3 mm towards the flange), poses prescribed, one
/// after the other.
class EightWheels : public Subject {
 public:
  explicit EightWheels(bool from_pose) : from_pose_(from_pose) {
    for (int k = 0; k < 8; ++k) {
      Methods methods{WRC_NORMAL_STRIP_HALFSPACE, preset_fastsim_sdec,
                      k % 2 == 0 ? WRC_SIDE_RIGHT : WRC_SIDE_LEFT, 60, 50};
      wheels_.push_back(std::make_unique<Wheel>(methods));
      contacts_.push_back(wheels_.back()->contact);
      std::vector<Gap>& gaps = gaps_.emplace_back();
      for (int i = 0; i < positions; ++i) {
        place(k, i);
        gaps.push_back(wheels_.back()->gap_of_pose());
      }
    }
    inputs_.resize(8);
    outputs_.resize(8);
    shown_.resize(8);
  }
  void input(int i) override {
    for (int k = 0; k < 8; ++k) {
      Wheel& wheel = *wheels_[static_cast<std::size_t>(k)];
      const auto at = static_cast<std::size_t>(k);
      wheel.vary(i + 100 * k);
      wheel.load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
      wheel.load.normal_force = 50e3 + 0.25 * wheel.load.normal_force;  // 60 .. 80 kN: above they merge
      wheel.pose.yaw = 0.0;
      const int position = std::abs((i + 25 * k) % 200 - 100) * (positions - 1) / 100;
      place(k, position);
      shown_[at] = shown(gaps_[at][static_cast<std::size_t>(position)]);
      inputs_[at] = wheel.input;
      if (!from_pose_) inputs_[at].gap = &shown_[at];
      outputs_[at] = sized<wrc_planar_output>();
    }
  }
  void work() override {
    for (std::size_t k = 0; k < 8; ++k) wrc_planar_step(contacts_[k], &inputs_[k], &outputs_[k]);
    ++cycles_;
    for (const wrc_planar_output& output : outputs_) patches_ += output.normal.patch_count;
  }
  void save() override {
    for (const auto& wheel : wheels_) wheel->save();
  }
  void restore() override {
    for (const auto& wheel : wheels_) wheel->restore();
  }
  /// Patches per cycle, in the mean over all cycles so far.
  double patches() const { return static_cast<double>(patches_) / static_cast<double>(cycles_); }

 private:
  static constexpr int positions = 50;
  void place(int k, int i) {
    const double shift = 5.0e-3 + 0.3e-3 * i / (positions - 1);
    wheels_[static_cast<std::size_t>(k)]->pose.lateral = k % 2 == 0 ? shift : -shift;
  }
  bool from_pose_;
  long cycles_ = 0, patches_ = 0;
  std::vector<std::unique_ptr<Wheel>> wheels_;
  std::vector<wrc_contact*> contacts_;
  std::vector<std::vector<Gap>> gaps_;
  std::vector<wrc_planar_input> inputs_;
  std::vector<wrc_planar_output> outputs_;
  std::vector<wrc_planar_gap> shown_;
};

struct Time {
  float met = 0.0F, own = 0.0F;
};

Time timed(Subject& subject) {
  const double processor_start = processor_time();
  const auto start = Clock::now();
  subject.work();
  const std::chrono::duration<float, std::micro> met = Clock::now() - start;
  return {met.count(), static_cast<float>(processor_time() - processor_start)};
}

/// `goal`: what 99 of 100 steps by themselves should stay below [us].
void report(const char* title, Subject& subject, int steps, double goal) {
  for (int i = 0; i < 300; ++i) {  // warm up, and a first idea of the time
    subject.input(i);
    subject.work();
  }
  Times trial;
  for (int i = 0; i < 300; ++i) {
    subject.input(i);
    trial.push_back(timed(subject).own);
  }
  std::sort(trial.begin(), trial.end());
  FixedWork fixed(quantile(trial, 0.5));

  Times met, own, machine, empty;
  for (Times* times : {&met, &own, &machine, &empty}) times->resize(static_cast<std::size_t>(steps));
  for (int first = 0; first < steps; first += block) {
    const int end = std::min(first + block, steps);
    subject.save();
    for (int repeat = 0; repeat < repeats; ++repeat) {
      if (repeat > 0) subject.restore();
      for (int i = first; i < end; ++i) {
        const auto k = static_cast<std::size_t>(i);
        subject.input(i);
        const Time time = timed(subject);
        if (repeat > 0) {
          own[k] = std::min(own[k], time.own);
          continue;
        }
        met[k] = time.met;
        own[k] = time.own;
        // In the same loop, so that the machine is in the same mood.
        const auto start = Clock::now();
        fixed.run();
        const auto between = Clock::now();
        const auto after = Clock::now();
        machine[k] = std::chrono::duration<float, std::micro>(between - start).count();
        empty[k] = std::chrono::duration<float, std::micro>(after - between).count();
      }
    }
  }
  std::printf("%s, %d steps, microseconds\n%-34s %9s %9s %9s %9s %9s\n", title, steps, "", "p50", "p99",
              "p99.99", "max", "max/p50");
  print_row("step as met", met);
  print_row("fixed arithmetic in its place", machine);
  print_row("nothing in its place", empty);
  print_ratio("step as met / fixed arithmetic", met, machine);
  print_row("step by itself (least of 3)", own);
  std::printf("p99 by itself %.1f us, goal %.0f us: %s\n", quantile(own, 0.99), goal,
              quantile(own, 0.99) < goal ? "reached" : "missed");
}

}  // namespace

void print_latency(int steps) {
  OneWheel one;
  report("one wheel: gap and load given, 60 x 50, damage, warm", one, steps, 60.0);
  const int cycles = std::max(1, steps / 16);
  EightWheels eight(false), posed(true);
  report("\neight wheels, two patches each: gaps and loads given", eight, cycles, 500.0);
  std::printf("%.2f patches per cycle\n", eight.patches());
  report("\neight wheels, two patches each: poses and loads given", posed, cycles, 500.0);
  std::printf("%.2f patches per cycle\n", posed.patches());
}
