/// Does a fit's spread hold the truth? Noisy creep curves of known laws, fitted by wrc_fit_creep_curve().
///     creep_fit_report [DRAWS] [NOISE] [LAW] [--keep FILE]
/// 1000 draws of 0.05 relative noise without arguments; exit 1 where the 95 % intervals of a parameter hold
/// less than 95 % of the true values, but for the scatter of that share itself (two deviations). LAW: that
/// one alone. FILE.0, FILE.1 ... of the laws have a line for each draw: a run that was stopped goes on behind
/// the last. Progress is on stderr. Each law starts from values that are wrong by a factor of up to two.
/// Printed for each parameter: the true value, the mean deviation stated over that found among the draws,
/// draws of which the interval holds it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

#include "creep_adhesion.hpp"
#include "wrc/wrc_offline.h"

namespace {

/// Numbers with the same bits everywhere: a linear congruence, and the sum of twelve for a bell.
class Random {
 public:
  double unit() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) / 9007199254740992.0;
  }
  double bell() {
    double sum = -6.0;
    for (int k = 0; k < 12; ++k) sum += unit();
    return sum;
  }

 private:
  std::uint64_t state_ = 2029;
};

constexpr const char* names[WRC_CREEP_PARAMETERS] = {
    "coefficient",        "kinetic_ratio",  "fall_rate",       "half_speed",  "slope_reduction",
    "adhesion_reduction", "slip_reduction", "layer_thickness", "layer_yield", "layer_hardening"};

double* number_of(wrc_friction& f, int parameter) {
  double* const numbers[] = {&f.coefficient,     &f.kinetic_ratio,      &f.fall_rate,      &f.half_speed,
                             &f.slope_reduction, &f.adhesion_reduction, &f.slip_reduction, &f.layer_thickness,
                             &f.layer_yield,     &f.layer_hardening};
  return numbers[parameter];
}

struct Law {
  const char* name;
  const char* friction;  ///< of WRC_FRICTION_LIST; nullptr: the defaults
  const char* method;    ///< of WRC_PRESET_LIST
  std::vector<int> parameters;
  void (*change)(wrc_friction& law);
};

const Law laws[] = {
    {"Polach dry",
     "Polach dry",
     "Polach",
     {WRC_CREEP_COEFFICIENT, WRC_CREEP_KINETIC_RATIO, WRC_CREEP_FALL_RATE, WRC_CREEP_ADHESION_REDUCTION,
      WRC_CREEP_SLIP_REDUCTION},
     [](wrc_friction&) {}},
    {"Polach wet",
     "Polach wet",
     "Polach",
     {WRC_CREEP_COEFFICIENT, WRC_CREEP_KINETIC_RATIO, WRC_CREEP_FALL_RATE, WRC_CREEP_ADHESION_REDUCTION,
      WRC_CREEP_SLIP_REDUCTION},
     [](wrc_friction&) {}},
    {"locomotive",
     "locomotive",
     "strip FASTSIM",
     {WRC_CREEP_COEFFICIENT, WRC_CREEP_KINETIC_RATIO, WRC_CREEP_FALL_RATE, WRC_CREEP_LAYER_THICKNESS},
     [](wrc_friction&) {}},
    {"layer that yields",
     "clay",
     "strip FASTSIM",
     {WRC_CREEP_COEFFICIENT, WRC_CREEP_LAYER_THICKNESS, WRC_CREEP_LAYER_YIELD},
     [](wrc_friction& law) {
       law.coefficient = 0.25;
       law.layer_hardening = 0.0;
     }},
    {"static and kinetic friction",
     nullptr,
     "FASTSIM-SDEC",
     {WRC_CREEP_COEFFICIENT, WRC_CREEP_KINETIC_RATIO, WRC_CREEP_HALF_SPEED, WRC_CREEP_SLOPE_REDUCTION},
     [](wrc_friction& law) {
       law.speed_law = WRC_SPEED_LAW_HYPERBOLIC;
       law.kinetic_ratio = 0.3;
       law.slope_reduction = 0.5;
     }},
};

/// A curve of 48 points from 0.02 to 40 % slip, at three speeds and two loads.
class Curve {
 public:
  wrc_creep_curve told = wrc_creep_curve_default();
  std::vector<double> adhesion;

  Curve(wrc_contact* contact, const wrc_friction& law) {
    constexpr int points = 48;
    constexpr double speeds[] = {2.0, 10.0, 30.0};
    told.ellipse.a = 6e-3;
    told.ellipse.b = 5e-3;
    told.ellipse.normal_force = 80e3;
    for (int i = 0; i < points; ++i) {
      slip_.push_back(2e-4 * std::pow(2000.0, static_cast<double>(i) / (points - 1)));
      speed_.push_back(speeds[i % 3]);
      load_.push_back(i % 2 == 0 ? 80e3 : 60e3);
      exact_.push_back(creep_adhesion(contact, told.ellipse, law, slip_.back(), speed_.back(), load_.back()));
      if (!std::isfinite(exact_.back())) std::abort();
    }
    told.count = points;
    told.slip = slip_.data();
    told.speed = speed_.data();
    told.load = load_.data();
  }
  void scatter(double noise, Random& random) {
    adhesion.clear();
    for (const double exact : exact_) adhesion.push_back(exact * (1.0 + noise * random.bell()));
    told.adhesion = adhesion.data();
  }

 private:
  std::vector<double> slip_, speed_, load_, exact_;
};

/// Outcome of a draw, as a line of the file: did the fit settle, is a parameter undetermined; then for each
/// parameter of the law value, stated deviation and the ends of its interval.
struct Draw {
  int settled = 0, undetermined = 0;
  double value[WRC_CREEP_PARAMETERS][4] = {};
};

bool read(std::FILE* file, const Law& law, Draw& draw) {
  bool whole = std::fscanf(file, "%d %d", &draw.settled, &draw.undetermined) == 2;
  for (const int p : law.parameters)
    for (double& one : draw.value[p]) whole = whole && std::fscanf(file, "%lf", &one) == 1;
  return whole;
}

void write(std::FILE* file, const Law& law, const Draw& draw) {
  std::fprintf(file, "%d %d", draw.settled, draw.undetermined);
  for (const int p : law.parameters)
    for (const double one : draw.value[p]) std::fprintf(file, " %.17g", one);
  std::fprintf(file, "\n");
  std::fflush(file);
}

/// Fits one curve from values that are wrong.
Draw fit_one(wrc_contact* contact, const Law& law, const wrc_creep_curve& told) {
  wrc_creep_fit fit{};
  fit.struct_size = sizeof fit;
  const int32_t status = wrc_fit_creep_curve(contact, &told, &fit, nullptr);
  if (status < 0) {
    char text[400] = "";
    wrc_contact_last_error(contact, text, sizeof text);
    std::fprintf(stderr, "%s\n", text);
  }
  Draw draw{status == WRC_OK, fit.undetermined != 0, {}};
  for (const int p : law.parameters) {
    const double numbers[] = {fit.value[p], fit.deviation[p], fit.low[p], fit.high[p]};
    std::copy(std::begin(numbers), std::end(numbers), draw.value[p]);
  }
  return draw;
}

/// The law before a fit: each parameter of it wrong by a factor of up to two.
wrc_friction wrong_law(const wrc_friction& truth, const Law& law, Random& random) {
  wrc_friction start = truth;
  for (const int p : law.parameters) {
    double& begins = *number_of(start, p);
    const double half = random.unit();  // friction begins high, a yield low: above mu p a layer has no effect
    begins *= p == WRC_CREEP_COEFFICIENT   ? 1.0 + 0.5 * half
              : p == WRC_CREEP_LAYER_YIELD ? 0.5 + 0.5 * half
                                           : 0.5 + half;
    if (p == WRC_CREEP_ADHESION_REDUCTION || p == WRC_CREEP_SLOPE_REDUCTION) begins = std::fmin(begins, 1.0);
  }
  start.slip_reduction = std::fmin(start.slip_reduction, start.adhesion_reduction);
  return start;
}

/// Fits of one law among all draws; false where an interval holds too few. `keep`: name of its file of draws,
/// or empty.
bool report(const Law& law, int draws, double noise, const std::string& keep) {
  wrc_config config = wrc_config_default();
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  char text[400] = "";
  if (wrc_config_use(&config, law.method, text, sizeof text) < 0 ||
      wrc_model_create(&config, nullptr, &model, text, sizeof text) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, text, sizeof text) < 0) {
    std::fprintf(stderr, "%s\n", text);
    return false;
  }
  wrc_friction truth = wrc_friction_default();
  if (law.friction != nullptr) wrc_friction_use(&truth, law.friction, nullptr, 0);
  law.change(truth);
  Curve curve(contact, truth);
  Random random;
  int held[WRC_CREEP_PARAMETERS] = {}, undetermined = 0, failed = 0, all = 0;
  double stated[WRC_CREEP_PARAMETERS] = {}, squares[WRC_CREEP_PARAMETERS] = {};
  std::FILE* const kept = keep.empty() ? nullptr : std::fopen(keep.c_str(), "a+");
  bool known = kept != nullptr;
  for (int draw = 0; draw < draws; ++draw) {
    // the curve and its start, in the same order whether the draw is in the file or not
    curve.scatter(noise, random);
    curve.told.parameters = 0;
    for (const int p : law.parameters) curve.told.parameters |= 1U << static_cast<unsigned>(p);
    curve.told.friction = wrong_law(truth, law, random);
    Draw found;
    known = known && read(kept, law, found);
    if (!known) {
      found = fit_one(contact, law, curve.told);
      if (kept != nullptr) write(kept, law, found);
      std::fprintf(stderr, "%s: draw %d of %d\n", law.name, draw + 1, draws);
    }
    // sums over the draws
    failed += found.settled == 0;
    undetermined += found.undetermined;
    bool whole = true;
    for (const int p : law.parameters) {
      const double value = *number_of(truth, p), error = found.value[p][0] - value;
      const bool holds = found.value[p][2] <= value && value <= found.value[p][3];
      held[p] += holds;
      whole = whole && holds;
      stated[p] += found.value[p][1] / draws;
      squares[p] += error * error / draws;
    }
    all += whole;
  }
  if (kept != nullptr) std::fclose(kept);
  std::printf("%s, by %s: %d draws, %d not settled, %d with a parameter undetermined; all held in %.1f %%\n",
              law.name, law.method, draws, failed, undetermined, 100.0 * all / draws);
  bool fine = failed == 0;
  for (const int p : law.parameters) {
    const double share = static_cast<double>(held[p]) / draws;
    std::printf("  %-20s true %-12.5g stated deviation %.3f of it, found %.3f; held in %.1f %%\n", names[p],
                *number_of(truth, p), stated[p] / *number_of(truth, p),
                std::sqrt(squares[p]) / *number_of(truth, p), 100.0 * share);
    fine = fine && share >= 0.95 - 2.0 * std::sqrt(0.95 * 0.05 / draws);
  }
  std::fflush(stdout);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return fine;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words;
  std::string keep;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--keep" && i + 1 < argc)
      keep = argv[++i];
    else
      words.emplace_back(argv[i]);
  const int draws = !words.empty() ? std::atoi(words[0].c_str()) : 1000;
  const double noise = words.size() > 1 ? std::atof(words[1].c_str()) : 0.05;
  bool fine = true, found = false;
  const bool allowed = draws > 0 && noise >= 0.0;
  for (const Law& law : laws) {
    if (!allowed) break;
    if (words.size() > 2 && words[2] != law.name) continue;
    found = true;
    const std::string file = keep.empty() ? keep : keep + "." + std::to_string(&law - laws);
    fine = report(law, draws, noise, file) && fine;
  }
  if (found) return fine ? 0 : 1;
  std::fprintf(stderr, "usage: creep_fit_report [DRAWS] [NOISE] [LAW] [--keep FILE]\n");
  return 2;
}
