/// Fit of friction and of a layer to a measured creep curve, offline.
///
/// Weighted least squares: the smallest sum of ((f_k(p) - y_k) / s_k)^2. f_k is the adhesion that the
/// contact's tangential method gives at the slip, speed and load of point k; y_k is the measured adhesion.
/// s_k is the scatter of the point up to a common factor: 1, or in proportion to the adhesion. The first of
/// three fits then takes y_k for it, the two others f_k of the fit before. With y_k alone, points that happen
/// to be low would have too much weight. Levenberg's and Marquardt's method works in coordinates u: positive
/// parameters are start * exp(u), others start + unit * u. Slopes are central differences. Parameters stay
/// within their range: one at its end that would leave it is held in that step.
///
/// Spread: with J the slopes of the residuals at the end, covariance of u = sigma^2 (J^T J)^-1,
/// sigma^2 = sum / (points - parameters). Columns of J are scaled to one length first. Along eigenvectors
/// whose eigenvalue is below 1e-10 nothing is determined. Intervals are u +- t_95 sigma_u, t_95 of Student's
/// distribution. Theory manual, section 5.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/fault.hpp"
#include "base/progress.hpp"
#include "contact/state.hpp"
#include "patch/sdec.hpp"

namespace wrc::curves {

/// Most parameters of a fit.
inline constexpr std::int32_t most_parameters = 16;

/// A point of a creep curve.
struct CurvePoint {
  double slip = 0.0;      ///< longitudinal, amount [-]
  double adhesion = 0.0;  ///< measured [-]
  double speed = 0.0;     ///< [m/s]
  double load = 0.0;      ///< [N]
};

/// A parameter of the law to be found.
struct FitParameter {
  double contact::Friction::*friction = nullptr;  ///< one of these is set: the member that it is
  double tangential::FrictionLaw::*law = nullptr;
  double tangential::ReductionFactors::*reduction = nullptr;
  double tangential::Layer::*layer = nullptr;
  bool positive = true;          ///< varied by its logarithm
  double low = 0.0, high = 0.0;  ///< range
  double unit = 1.0;             ///< step of the value for u = 1, where it is not positive
  double vague = 1.0;            ///< undetermined where the deviation of u is larger

  double& of(contact::Friction& f) const {
    return friction ? f.*friction : law ? f.law.*law : reduction ? f.reduction.*reduction : f.layer.*layer;
  }
};

struct CurveFitProblem {
  std::vector<CurvePoint> points;
  patch::Sdec patch;        ///< under `patch_load`; axes grow with the cube root of the load
  double patch_load = 0.0;  ///< [N]
  contact::Friction start;  ///< the law the fit begins with
  std::vector<FitParameter> parameters;
  bool relative =
      true;  ///< points scatter in proportion to the adhesion, and to a hundredth of the largest at least
  std::int32_t max_iterations = 100;
  ProgressCallback progress;
};

struct CurveFit {
  Fault fault;
  std::int32_t iterations = 0;
  contact::Friction law;
  double scatter = 0.0;  ///< sigma: standard deviation of the residuals over s_k
  struct Of {
    double value = 0.0, deviation = 0.0, low = 0.0, high = 0.0;
    bool undetermined = false, at_limit = false;
  };
  std::array<Of, most_parameters> of{};  ///< in the order of the parameters
  double covariance[most_parameters][most_parameters] = {};
  std::vector<double> adhesion;  ///< that of the law at the points [-]
};

/// Fits the law. The contact's solution is overwritten.
CurveFit fit_curve(contact::Contact& contact, const CurveFitProblem& problem);

}  // namespace wrc::curves
