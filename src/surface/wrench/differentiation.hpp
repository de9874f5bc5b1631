/// A solution that is being differentiated: its strips in numbers that carry derivatives by the inputs of the
/// rail frame, and the memory of the parts that differentiate it.
#pragma once

#include <cstdint>

#include "base/arena.hpp"
#include "surface/pressure/pressure_jacobian.hpp"
#include "surface/rolling/rolling_arrays.hpp"
#include "surface/wrench/strip_rolling.hpp"
#include "surface/wrench/wheel_solution.hpp"
#include "surface/wrench/wrench_jacobian.hpp"

namespace wrc::surface {

inline RailFrameDual frame_number(const PlaceDual& a) {
  RailFrameDual n = a.value;
  for (std::size_t k = 0; k < place_inputs; ++k) n.d[k] = a.d[k];
  return n;
}
inline const RailFrameDual& frame_number(const RailFrameDual& a) { return a; }

/// The same again of a number that place and attitude alone change.
inline PlaceDual place_number(const RailFrameDual& a) {
  PlaceDual n = a.value;
  for (std::size_t k = 0; k < place_inputs; ++k) n.d[k] = a.d[k];
  return n;
}

/// Numbers of the strips that carry load; one element per strip.
struct LoadedStrips {
  std::int32_t count = 0;
  RailFrameDual friction_factor = 1.0;  ///< on the friction of all
  std::int32_t* pressed;                ///< number among the strips in contact
  double *place, *width;                ///< [m]
  RailFrameDual *normal, *centre, *half_length, *peak, *curvature, *slip_x, *slip_y, *spin, *friction,
      *flexibility;
  RailFrameDual *fx, *fy, *mz;
};

/// Forces of one direction of rolling.
struct DualForces {
  RailFrameDual *fx, *fy, *mz;
};

/// Plain numbers of differences, under friction over temperature and with memory.
struct DifferencesScratch {
  double *half_length, *peak, *curvature, *slip_x, *slip_y, *spin, *x, *friction, *fx, *fy, *mz;
  double *flexibility, *yield, *hardening;
  double* share;                                 ///< hot over cold friction in the solution [-]
  double *base_fx, *base_fy, *base_mz;           ///< forces that differences are taken from
  double *fx_by_time, *fy_by_time, *mz_by_time;  ///< derivatives, with memory [N/s], [N m/s]
  DualForces other;                              ///< the other direction's: friction over temperature
  RollingScratch rolling;                        ///< the same
  tangential::PastStrip* written;                ///< strips of steps that remember
  Arena remembering;                             ///< scratch of these steps
};

/// Memory of a differentiation.
struct DifferentiationScratch {
  PressedStrips pressed;
  double* pressures;  ///< scratch of differentiate_pressures(), whose memory is that of all below
  LoadedStrips loaded;
  RollingArraysOf<RailFrameDual> rolling;  ///< its memory is that of `pressed` but for the overlaps
  DualForces other;                        ///< the other direction's
  double* values;                          ///< for the kernel: its numbers without derivatives
  double* slopes;                          ///< from the kernel
  DifferencesScratch differences;          ///< its memory is that of the four above
};

/// A solution that is being differentiated.
struct Differentiation {
  const WheelProblem& problem;
  const WheelSolution& solved;
  JacobianBy by;
  DifferentiationScratch& w;

  /// Place of the k-th strip that carries load on the wheel's profile [m].
  RailFrameDual y_on_wheel(std::int32_t k) const {
    return frame_number(w.pressed.overlap[w.loaded.pressed[k]].y_wheel);
  }
};

}  // namespace wrc::surface
