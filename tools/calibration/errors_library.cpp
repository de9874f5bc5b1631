// The errors of strip FASTSIM with given constants over the patches of files, as a library for fit.py: a fit
// calls it some hundred times.

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "rolling.hpp"
#include "tangential/methods/strip_fastsim.hpp"

namespace {

using namespace wrc;
using namespace wrc::calibration;

struct Loaded {
  Case exact;
  std::unique_ptr<Rolling> rolling;
};

constexpr int strips = 24, cells = 24;  // a discretisation error of 0.1 % of mu N

const OwnedGrid& grid() {
  static const OwnedGrid owned(cells);
  return owned;
}
std::vector<Loaded> loaded;

}  // namespace

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED int calibration_quantities() { return tangential::StripCalibration::quantities; }
EXPORTED int calibration_terms() { return tangential::StripCalibration::terms; }
/// 1 where a constant may be fitted when a fit starts from zero. The first two terms do not vanish with the
/// creepages: only turning and torsion, which are not in linear theory, may have them. Others left out here
/// were never worth their place in any trial.
EXPORTED int calibration_allowed(int quantity, int term) {
  if (term < 2)
    return quantity == tangential::StripCalibration::turning ||
           quantity == tangential::StripCalibration::torsion;
  if (quantity <= tangential::StripCalibration::turning) return 1;
  return term < (quantity == tangential::StripCalibration::torsion ? 5 : 6);
}
EXPORTED void calibration_fitted(double* constants) {
  for (const auto& row : tangential::fitted_calibration.constants) {
    for (double value : row) *constants++ = value;
  }
}

/// Adds the cases of a file; returns how many there are now, -1 where it cannot be read.
EXPORTED int calibration_load(const char* path) {
  try {
    for (const Case& c : read_cases(path)) {
      loaded.push_back({c, std::make_unique<Rolling>(c.patch, grid().grid, strips)});
    }
  } catch (const std::string& reason) {
    std::fprintf(stderr, "%s\n", reason.c_str());
    return -1;
  }
  return static_cast<int>(loaded.size());
}

/// Per case: adhesion, then errors of Fx, Fy (over mu N), of Mz (over mu N c) and of the power (relative).
EXPORTED void calibration_errors(const double* constants, double* out) {
  tangential::StripCalibration calibration{};
  for (auto& row : calibration.constants) {
    for (double& value : row) value = *constants++;
  }
  for (const Loaded& l : loaded) {
    const Patch& p = l.exact.patch;
    const ExactForces& exact = l.exact.exact;
    Fault fault;
    const tangential::TangentialForces f =
        tangential::calibrated_strip_fastsim(l.rolling->contact, {}, fault, nullptr, calibration);
    const double limit = p.friction * p.normal_force;
    *out++ = exact.adhesion;
    *out++ = (f.fx - exact.fx) / limit;
    *out++ = (f.fy - exact.fy) / limit;
    *out++ = (f.mz - exact.mz) / (limit * std::sqrt(p.a * p.b));
    *out++ = f.power_per_speed / exact.power - 1.0;
  }
}
