// The errors of strip FASTSIM on the surface with given constants over the cases of files, as a library for
// fit.py.

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "patch/material.hpp"
#include "rolling.hpp"
#include "surface_case.hpp"

namespace {

using namespace wrc;
using namespace wrc::calibration;

std::vector<ExactSurfaceCase> loaded;

const OwnedGrid& grid() {
  static const OwnedGrid owned(24);  // a discretisation error of 0.1 % of mu N
  return owned;
}

}  // namespace

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED int calibration_quantities() { return surface::SurfaceCalibration::quantities; }
EXPORTED int calibration_terms() { return surface::SurfaceCalibration::terms; }
/// 1 where a constant may be fitted when a fit starts from zero: linear theory is not fitted.
EXPORTED int calibration_allowed(int quantity, int term) {
  if (quantity < surface::SurfaceCalibration::turning)
    return term >= tangential::SaturationTerms::longitudinal;
  if (quantity == surface::SurfaceCalibration::turning) return 1;
  return term <= (quantity == surface::SurfaceCalibration::torsion ? tangential::SaturationTerms::pull
                                                                   : tangential::SaturationTerms::spin);
}
EXPORTED void calibration_fitted(double* constants) {
  for (const auto& row : surface::fitted_surface_calibration.constants) {
    for (double value : row) *constants++ = value;
  }
}

/// Adds the cases of a file; returns how many there are now, -1 where it cannot be read.
EXPORTED int calibration_load(const char* path) {
  try {
    for (ExactSurfaceCase& c : read_surface_cases(path)) loaded.push_back(std::move(c));
  } catch (const std::string& reason) {
    std::fprintf(stderr, "%s\n", reason.c_str());
    return -1;
  }
  return static_cast<int>(loaded.size());
}

/// Per case: adhesion, then errors of Fx, of the lateral force along the contact's mean tangent (over mu N),
/// of Mz (over mu N c) and of the power (relative).
EXPORTED void calibration_errors(const double* constants, double* out) {
  static const surface::StripCoefficientTable coefficients{
      theory::KalkerTable(loaded.empty() ? 0.28 : loaded[0].rolling.poisson)};
  surface::SurfaceCalibration calibration{};
  for (auto& row : calibration.constants) {
    for (double& value : row) value = *constants++;
  }
  for (const ExactSurfaceCase& l : loaded) {
    const SurfaceForces &exact = l.exact, f = strip_forces(l.rolling, grid().grid, coefficients, calibration);
    const double limit = l.rolling.friction * l.rolling.normal_force;
    double area = 0.0, angle = 0.0;
    for (const SurfaceStrip& s : l.rolling.strips) {
      area += 2.0 * s.half_length * s.width;
      angle += 0.5 * pi * s.width * s.peak * s.half_length * s.angle / l.rolling.normal_force;
    }
    *out++ = exact.adhesion;
    *out++ = (f.fx - exact.fx) / limit;
    *out++ = ((f.fy - exact.fy) * std::cos(angle) + (f.fz - exact.fz) * std::sin(angle)) / limit;
    *out++ = (f.mz - exact.mz) / (limit * std::sqrt(area / pi));
    *out++ = f.power / exact.power - 1.0;
  }
}
