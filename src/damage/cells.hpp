/// Damage of the surface by friction, cell by cell (Liu, Bruni 2024): power density, eq. 10,
///
///     P_f = -V (s_x p_x + s_y p_y)  [W/m^2],   V the rolling speed,
///
/// the input of wear models, and the local fatigue index, eq. 12,
///
///     (sqrt(p_x^2 + p_y^2) - k) / p_n  [-],   p_n the pressure at the middle of the cell,
///
/// which is no_fatigue_index in strips that carry no pressure.
#pragma once

#include "damage/simd/tasks.hpp"
#include "kernels/kernels.hpp"

namespace wrc::damage {

/// The cells of a patch together.
struct CellDamage {
  double power = 0.0;               ///< [W]
  double peak_power_density = 0.0;  ///< [W/m^2]
  double fatigue_index = 0.0;       ///< the largest [-]
};

/// Fills the task's arrays and adds up; work proportional to strips times cells.
CellDamage assess_cells(const simd::CellTask& task, const Kernels& kernels);

}  // namespace wrc::damage
