/// Stresses in a half-space under loads that are constant on the cells of a grid: closed forms of Boussinesq,
/// Love (1929) and Cerruti, exact for such loads.
///
/// The body lies at z >= 0 and x, y, z are the contact frame's for the rail; a wheel is its mirror image in
/// the contact plane, z its own depth. With F(x, y, z) = IInt load ln(r + z), F1 = IInt load (z ln(r + z) -
/// r), so that dF1/dz = F (Johnson, Contact Mechanics, 3.2), a pressure p into the body gives
///     2 pi s_xx = 2 nu F_zz - z F_xxz - (1 - 2 nu) F_xx       2 pi s_xy = -(1 - 2 nu) F_xy - z F_xyz
///     2 pi s_zz = F_zz - z F_zzz                              2 pi s_zx = -z F_xzz
/// and a traction q along x on the body
///     2 pi s_xx = 2 (1 + nu) F_xz + 2 nu F1_xxx - z F_xxx     2 pi s_xy = F_yz + 2 nu F1_xxy - z F_xxy
///     2 pi s_yy = 2 nu F_xz + 2 nu F1_xyy - z F_xyy           2 pi s_yz = -z F_xyz
///     2 pi s_zz = -z F_xzz                                    2 pi s_zx = F_zz - z F_xxz,
/// those left out by exchange of x and y. (The second set: Hooke's law on Johnson's displacements.)
#pragma once

#include <cstdint>
#include <vector>

#include "base/fault.hpp"
#include "damage/stress.hpp"
#include "halfspace/fft.hpp"
#include "halfspace/grid.hpp"
#include "halfspace/progress.hpp"

namespace wrc::halfspace {

/// Stresses per unit load of a cell: a pressure into the body, tractions along x and y on the body.
struct CellStress {
  Stress of_pressure, of_traction_x, of_traction_y;
};

/// At (x, y) from the centre of a cell of size dx x dy [m] and at the depth z >= 0. At z = 0 not on the
/// cell's border, where a traction's stress is infinite.
CellStress cell_stress(double poisson, double x, double y, double z, double dx, double dy);

/// What acts on the body.
struct BodyLoads {
  Grid grid;
  Field pressure, traction_x, traction_y;
  double poisson = 0.0;
};

/// The stress at a point: the sum over the cells.
Stress stress_at(const BodyLoads& loads, double x, double y, double z);

/// Stresses at the centres of all cells, and of some beyond the grid's border, at one depth after the other:
/// discrete convolutions by FFT with zero padding.
class StressField {
 public:
  explicit StressField(const BodyLoads& loads);

  /// The largest numbers at the cells' centres, at the depth z.
  StressPeaks peaks(double z);

  /// Every number at one depth; element as in `grid()`.
  const Grid& grid() const { return grid_; }
  Stress at(std::size_t cell) const;

 private:
  void evaluate(double z);
  void transform(Field& re, Field& im);
  void transform_back(Field& re, Field& im);

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
  StressPeaks surface, below;       ///< at z = 0; beneath it
  std::vector<StressPeaks> levels;  ///< at each of the depths asked for
  Fault fault;
};

/// Searches the depths: eleven up to 1.5 times the smaller half extent of the loaded cells, then golden
/// sections around the largest of each number. At each depth every cell is looked at.
SubsurfaceSolution search_stresses(const BodyLoads& loads, const std::vector<double>& depths,
                                   const ProgressCallback& progress);

}  // namespace wrc::halfspace
