#include "damage/cells.hpp"

namespace wrc::damage {

CellDamage assess_cells(const simd::CellTask& task, const Kernels& kernels) {
  simd::CellExtremes extremes;
  kernels.damage.assess_cells(task, extremes);
  double power = 0.0;
  for (std::int32_t j = 0; j < task.region->count; ++j) power += task.strip_power[j] * task.region->width[j];
  return {power, extremes.power_density, extremes.fatigue_index};
}

}  // namespace wrc::damage
