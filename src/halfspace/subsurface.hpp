/// Stresses in a half-space under loads that are constant on the cells of a grid (damage/cell_stress.hpp),
/// and where they are largest. The exact way: FFT over all cells, depth by depth.
#pragma once

#include <cstdint>
#include <vector>

#include "base/fault.hpp"
#include "base/progress.hpp"
#include "damage/cell_stress.hpp"
#include "damage/stress.hpp"
#include "halfspace/fft.hpp"
#include "halfspace/grid.hpp"

namespace wrc::halfspace {

/// Loads on the body's surface.
struct BodyLoads {
  Grid grid;
  Field pressure, traction_x, traction_y;
  double poisson = 0.0;
};

/// The stress at a point: the sum over the cells.
damage::Stress stress_at(const BodyLoads& loads, double x, double y, double z);

/// Stresses at the centres of all cells, and of some beyond the grid's border, at one depth after the other:
/// discrete convolutions by FFT with zero padding.
class StressField {
 public:
  explicit StressField(const BodyLoads& loads);

  /// The largest numbers at the cells' centres, at the depth z.
  damage::StressPeaks peaks(double z);

  /// Every number at one depth; element as in `grid()`.
  const Grid& grid() const { return grid_; }
  damage::Stress at(std::size_t cell) const;

 private:
  void evaluate(double z);
  void transform(Field& re, Field& im);

  double poisson_ = 0.0;
  Grid grid_;                        // the loads' with a margin
  int padded_x_ = 0, padded_y_ = 0;  // lengths of the transforms
  Fft fft_x_, fft_y_;
  Field load_re_[3], load_im_[3];  // spectra
  Field re_[3], im_[3];            // xx + i yy, zz + i xy, yz + i zx: x slow, padded_x x padded_y
  Field kernel_re_, kernel_im_, work_re_, work_im_;
};

/// Largest stresses in the body.
struct SubsurfaceSolution {
  damage::StressPeaks surface, below;       ///< at z = 0; beneath it
  std::vector<damage::StressPeaks> levels;  ///< at each of the depths asked for
  Fault fault;
};

/// Searches the depths: eleven up to 1.5 times the smaller half extent of the loaded cells, then golden
/// sections around the largest of each number. At each depth every cell is looked at.
SubsurfaceSolution search_stresses(const BodyLoads& loads, const std::vector<double>& depths,
                                   const ProgressCallback& progress);

}  // namespace wrc::halfspace
