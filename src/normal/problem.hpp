/// The normal problem that all methods of this module solve, and the solution it returns.
#pragma once

#include <cstdint>
#include <limits>

#include "base/fault.hpp"
#include "kernels/kernels.hpp"
#include "patch/gap.hpp"
#include "patch/material.hpp"
#include "patch/strips.hpp"

namespace wrc::normal {

/// The quantity that is given; the other is a result. As wide as a double: it is part of a contact's saved
/// state, which has no padding.
enum class Prescribed : std::int64_t { load, approach };

struct NormalProblem {
  patch::GapRows gap;
  patch::Material material;
  Prescribed prescribed = Prescribed::load;
  double normal_force = 0.0;  ///< [N], prescribed == load
  double approach = 0.0;  ///< [m], prescribed == approach: motion towards each other since first touch (gap
                          ///< minimum taken as zero)
  const patch::GapMinimum* touch = nullptr;  ///< first touch, for methods that solve a patch about that
                                             ///< point; nullptr: at the gap's minimum
  double deepest =
      std::numeric_limits<double>::max();  ///< approach the rows are good for, if they do not end
                                           ///< before [m]; beyond, the solution goes on linearly
  std::int32_t strips = 0;                 ///< strips to divide the patch into
  std::int32_t max_iterations = 0;         ///< cap of the root find
  double force_tolerance = 0.0;            ///< relative error of the load at which the root find stops
  const Kernels* kernels = nullptr;        ///< those of an instruction set that the processor has
};

struct NormalSolution {
  double approach = 0.0;        ///< [m]
  double normal_force = 0.0;    ///< [N]
  double stiffness = 0.0;       ///< d normal_force / d approach [N/m]
  double peak_pressure = 0.0;   ///< [Pa]
  double area = 0.0;            ///< [m^2]
  double y_contact = 0.0;       ///< y of the gap's minimum, the initial contact point of this gap [m]
  std::int64_t iterations = 0;  ///< steps of the root find; evaluations of the method at a trial approach
};

}  // namespace wrc::normal
