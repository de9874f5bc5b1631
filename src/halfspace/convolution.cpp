#include "halfspace/convolution.hpp"

#include <algorithm>
#include <utility>

#include "tangential/exact/cell_influence.hpp"

namespace wrc::halfspace {
Convolution::Convolution(const Grid& grid, const patch::Material& material, Kernel kernel, double coupling)
    : nx_(grid.nx),
      ny_(grid.ny),
      padded_x_(Fft::good_length(2 * grid.nx - 1)),
      padded_y_(Fft::good_length(2 * grid.ny - 1)),
      fft_x_(padded_x_),
      fft_y_(padded_y_) {
  const std::size_t coefficients =
      static_cast<std::size_t>(2 * nx_ - 1) * static_cast<std::size_t>(2 * ny_ - 1);
  kxx_.assign(coefficients, 0.0);
  kyy_.assign(coefficients, 0.0);
  kxy_.assign(coefficients, 0.0);
  const bool shear = kernel == Kernel::shear || kernel == Kernel::shear_slip || kernel == Kernel::tangential;
  const bool couples = kernel == Kernel::coupling || kernel == Kernel::coupling_slip;
  // which displacements, and whether they are differenced upstream, (u - u one cell ahead) / dx
  const bool differenced =
      kernel == Kernel::normal_slip || kernel == Kernel::tangential || kernel == Kernel::coupling_slip;
  // K / (pi G)
  const double factor = coupling / (pi * material.shear_modulus);
  const auto coefficient = [&](double at, double upstream) {
    if (kernel == Kernel::shear_slip) return at / grid.dx;
    return differenced ? (at - upstream) / grid.dx : at;
  };
  for (int my = 1 - ny_; my < ny_; ++my) {
    // Coefficients of a row of offsets from left to right: each one's upstream neighbour, one cell ahead, is
    // the next one's own. Where couples, p_x and p_y act through x / r^2 and y / r^2 instead.
    tangential::CellInfluence here =
        tangential::cell_influence(material, (1 - nx_) * grid.dx, my * grid.dy, grid.dx, grid.dy);
    for (int mx = 1 - nx_; couples && mx < nx_; ++mx) {
      const std::size_t k = offset(mx, my);
      const tangential::CouplingInfluence at =
          tangential::coupling_influence(mx * grid.dx, my * grid.dy, grid.dx, grid.dy);
      const tangential::CouplingInfluence upstream =
          tangential::coupling_influence((mx + 1) * grid.dx, my * grid.dy, grid.dx, grid.dy);
      kxy_[k] = factor * coefficient(at.x, upstream.x);
      kyy_[k] = factor * coefficient(at.y, upstream.y);
    }
    for (int mx = 1 - nx_; !couples && mx < nx_; ++mx) {
      const std::size_t k = offset(mx, my);
      const tangential::CellInfluence upstream =
          tangential::cell_influence(material, (mx + 1) * grid.dx, my * grid.dy, grid.dx, grid.dy);
      kxx_[k] = shear ? coefficient(here.xx, upstream.xx) : coefficient(here.zz, upstream.zz);
      kyy_[k] = shear ? coefficient(here.yy, upstream.yy) : kxx_[k];
      kxy_[k] = shear ? coefficient(here.xy, upstream.xy) : 0.0;
      here = upstream;
    }
  }
  const std::size_t padded = static_cast<std::size_t>(padded_x_) * static_cast<std::size_t>(padded_y_);
  // Neighbours in memory are to lie apart by other than whole pages, or reading one waits for writing
  // another.
  for (Field* field : {&re_, &im_, &work_re_, &work_im_}) {
    field->reserve(padded + 96);
    field->assign(padded, 0.0);
  }
  transform_kernel(kxx_, xx_re_, xx_im_);
  transform_kernel(kyy_, yy_re_, yy_im_);
  transform_kernel(kxy_, xy_re_, xy_im_);
}

void Convolution::transform(int rows) {
  // along x for `rows` signals, turned round to y slow, along y with zeros in the rows that were not given
  fft_x_.forward(re_.data(), im_.data(), work_re_.data(), work_im_.data(), rows);
  transpose(re_.data(), work_re_.data(), padded_x_, rows);
  transpose(im_.data(), work_im_.data(), padded_x_, rows);
  std::swap(re_, work_re_);
  std::swap(im_, work_im_);
  const std::size_t used = static_cast<std::size_t>(rows) * static_cast<std::size_t>(padded_x_);
  std::fill(re_.begin() + static_cast<std::ptrdiff_t>(used), re_.end(), 0.0);
  std::fill(im_.begin() + static_cast<std::ptrdiff_t>(used), im_.end(), 0.0);
  fft_y_.forward(re_.data(), im_.data(), work_re_.data(), work_im_.data(), padded_x_);
}

void Convolution::transform_kernel(const Field& kernel, Field& spectrum_re, Field& spectrum_im) {
  std::fill(re_.begin(), re_.end(), 0.0);
  std::fill(im_.begin(), im_.end(), 0.0);
  // the inverse transforms' factor goes into the kernel
  const double scale = 1.0 / (static_cast<double>(padded_x_) * padded_y_);
  for (int my = 1 - ny_; my < ny_; ++my) {
    for (int mx = 1 - nx_; mx < nx_; ++mx) {
      // negative offsets wrap round to the end; x slow
      const auto x = static_cast<std::size_t>((mx + padded_x_) % padded_x_);
      const auto y = static_cast<std::size_t>((my + padded_y_) % padded_y_);
      re_[x * static_cast<std::size_t>(padded_y_) + y] = scale * kernel[offset(mx, my)];
    }
  }
  transform(padded_y_);
  spectrum_re = re_;
  spectrum_im = im_;
}

// The spectrum Z of p_x + i p_y holds those of the two real fields, P_x(k) = (Z(k) + conj Z(-k)) / 2 and
// P_y(k) = (Z(k) - conj Z(-k)) / (2 i); the product is packed the same way.
void Convolution::multiply_by_kernel() {
  const auto nx = static_cast<std::size_t>(padded_x_), ny = static_cast<std::size_t>(padded_y_);
  for (std::size_t ky = 0; ky < ny; ++ky) {
    const std::size_t row = ky * nx, mirrored_row = (ky == 0 ? 0 : ny - ky) * nx;
    for (std::size_t kx = 0; kx < nx; ++kx) {
      const std::size_t k = row + kx, m = mirrored_row + (kx == 0 ? 0 : nx - kx);
      // spectra of both fields from their packed one
      const double xr = 0.5 * (re_[k] + re_[m]), xi = 0.5 * (im_[k] - im_[m]);
      const double yr = 0.5 * (im_[k] + im_[m]), yi = 0.5 * (re_[m] - re_[k]);
      // U_x = K_xx P_x + K_xy P_y, U_y = K_xy P_x + K_yy P_y, and U_x + i U_y
      const double ur = xx_re_[k] * xr - xx_im_[k] * xi + xy_re_[k] * yr - xy_im_[k] * yi;
      const double ui = xx_re_[k] * xi + xx_im_[k] * xr + xy_re_[k] * yi + xy_im_[k] * yr;
      const double vr = xy_re_[k] * xr - xy_im_[k] * xi + yy_re_[k] * yr - yy_im_[k] * yi;
      const double vi = xy_re_[k] * xi + xy_im_[k] * xr + yy_re_[k] * yi + yy_im_[k] * yr;
      work_re_[k] = ur - vi;
      work_im_[k] = ui + vr;
    }
  }
  std::swap(re_, work_re_);
  std::swap(im_, work_im_);
}

void Convolution::apply(const double* px, const double* py, double* out_x, double* out_y) {
  // both fields turned to x slow, with zeros beyond their cells
  transpose(px, re_.data(), ny_, nx_);
  transpose(py, im_.data(), ny_, nx_);
  const std::ptrdiff_t used = static_cast<std::ptrdiff_t>(nx_) * ny_;
  const std::ptrdiff_t padded = static_cast<std::ptrdiff_t>(padded_x_) * ny_;
  std::fill(re_.begin() + used, re_.begin() + padded, 0.0);
  std::fill(im_.begin() + used, im_.begin() + padded, 0.0);
  transform(ny_);
  // to spectra, products, and back for the rows that are cells
  multiply_by_kernel();
  backward_2d(fft_x_, fft_y_, ny_, {re_, im_, work_re_, work_im_});
  transpose(re_.data(), out_x, nx_, ny_);
  transpose(im_.data(), out_y, nx_, ny_);
}

}  // namespace wrc::halfspace
