/// Tractions to displacements over a grid whose rows lie on a surface curved about x: half-space coefficients
/// over the arc length between two cells, tractions and displacements turned between the cells' own frames.
///
/// Row j has the angle a_j about x: e_y = (0, cos a, sin a), e_n = (0, -sin a, cos a) in axes common to all
/// rows. A traction of cell j displaces as if all of the half-space lay in cell j's frame; cell i feels the
/// component of that displacement along its own axes (Blanco-Lorenzo et al., Tribology Int. 103, 2016;
/// "half-space coefficients with angle correction" of CONTACT). Displacements u = u(wheel) - u(rail), p the
/// pressure (the traction on the wheel is -p e_n), d = a_i - a_j:
///     -u_n,i = sum_j  cos d K_zz p_j + sin d (K_xy p_x,j + K_yy p_y,j)
///      u_y,i = sum_j -sin d K_zz p_j + cos d (K_xy p_x,j + K_yy p_y,j)
///      u_x,i = sum_j  K_xx p_x,j + K_xy p_y,j
/// As cos d and sin d are sums of two products, every term is a plane convolution of fields multiplied by the
/// rows' cosines and sines.
#pragma once

#include "halfspace/convolution.hpp"
#include "halfspace/grid.hpp"

namespace wrc::halfspace {

class TurnedConvolution {
 public:
  /// `angles`: one per row [rad]; empty: all equal, and every product is that of Convolution.
  TurnedConvolution(const Grid& grid, const patch::Material& material, Convolution::Kernel kernel,
                    const Field& angles = {}, double coupling = 0.0);

  /// The coefficients within a row, and between any rows before turning.
  const Convolution& planar() const { return planar_; }

  /// Kernels normal, normal_slip: out_i = sum_j cos(a_i - a_j) K_ij p_j.
  void normal(const Field& p, Field& out);
  /// The same with sin(a_i - a_j).
  void normal_crossed(const Field& p, Field& out);

  /// Kernels shear, shear_slip, tangential, coupling, coupling_slip, in place: x <- sum_j K_xx x_j + K_xy
  /// y_j, y <- sum_j cos(a_i - a_j) (K_xy x_j + K_yy y_j).
  void tangential(Field& x, Field& y);
  /// out_i = sum_j sin(a_i - a_j) (K_xy x_j + K_yy y_j).
  void tangential_crossed(const Field& x, const Field& y, Field& out);

 private:
  // out <- p with each row times its factor.
  void scale_rows(const Field& factor, const Field& p, Field& out) const;
  // Convolutions of a field times the rows' cosines, and sines.
  void convolve_parts(const Field& p);
  void convolve_parts(const Field& x, const Field& y);
  // The parts turned back: sums over all rows j of cos(a_i - a_j), and of sin(a_i - a_j).
  void sum_cosines(Field& out) const;
  void sum_sines(Field& out) const;

  std::size_t nx_ = 0, ny_ = 0;
  Convolution planar_;
  Field cosine_, sine_;  // rows' angles; empty: all equal
  Field by_cosine_, by_sine_, unused_;
};

}  // namespace wrc::halfspace
