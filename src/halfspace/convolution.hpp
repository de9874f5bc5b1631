/// Tractions to displacements over a grid: discrete convolution by FFT with zero padding, so that the answer
/// is the plain double sum (no periodic images).
#pragma once

#include <cstddef>
#include <vector>

#include "halfspace/fft.hpp"
#include "halfspace/grid.hpp"
#include "patch/material.hpp"

namespace wrc::halfspace {

/// out_x(i) = sum_j kxx(i-j) p_x(j) + kxy(i-j) p_y(j),  out_y(i) = sum_j kxy(i-j) p_x(j) + kyy(i-j) p_y(j).
///
/// The two components travel as real and imaginary part of one complex transform. Memory: 13 doubles per
/// padded cell, 104 * (2 nx) * (2 ny) bytes: 1.7 MB for 64 x 64 cells, 27 MB for 256 x 256.
class Convolution {
 public:
  /// Kernel of the convolution.
  enum class Kernel {
    normal,         ///< u_z from p_z, of two independent pressure fields at once
    normal_slip,    ///< (u_z - u_z one cell upstream) / dx from p_z, of two fields at once
    shear,          ///< u_x and u_y from p_x and p_y
    shear_slip,     ///< u_x / dx and u_y / dx from p_x and p_y: slip while the surfaces advance by a cell
    coupling,       ///< IInt (p_x x + p_y y)/r^2 K/(pi G) as out_y; of (0, p) K/(pi G) IInt p (x, y)/r^2
    coupling_slip,  ///< the same less that one cell upstream, over dx
    tangential      ///< (u_x - u_x one cell upstream) / dx and the same of u_y, from p_x and p_y: minus the
                ///< upstream difference quotient of displacement along the rolling direction, tangential.hpp
  };

  /// `coupling`: Kalker's K, of the kernels that have it.
  Convolution(const Grid& grid, const patch::Material& material, Kernel kernel, double coupling = 0.0);

  /// Both inputs and outputs are fields of the grid; outputs may be the inputs.
  void apply(const double* px, const double* py, double* out_x, double* out_y);

  /// One coefficient: effect at the cell (mx, my) cells away from the loaded one.
  double xx(int mx, int my) const { return kxx_[offset(mx, my)]; }
  double yy(int mx, int my) const { return kyy_[offset(mx, my)]; }
  double xy(int mx, int my) const { return kxy_[offset(mx, my)]; }

 private:
  std::size_t offset(int mx, int my) const {
    return static_cast<std::size_t>(my + ny_ - 1) * static_cast<std::size_t>(2 * nx_ - 1) +
           static_cast<std::size_t>(mx + nx_ - 1);
  }
  void transform(int rows);  // re_, im_ from space (x slow, `rows` signals) to spectrum (y slow)
  void multiply_by_kernel();
  void transform_kernel(const Field& kernel, Field& spectrum_re, Field& spectrum_im);

  int nx_ = 0, ny_ = 0;              // cells
  int padded_x_ = 0, padded_y_ = 0;  // lengths of the transforms
  Fft fft_x_, fft_y_;
  Field kxx_, kyy_, kxy_;                                // coefficients, (2 nx - 1) x (2 ny - 1)
  Field xx_re_, xx_im_, yy_re_, yy_im_, xy_re_, xy_im_;  // spectra, with 1/(padded_x padded_y)
  Field re_, im_, work_re_, work_im_;                    // padded_x x padded_y
};

}  // namespace wrc::halfspace
