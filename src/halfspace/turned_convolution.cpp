#include "halfspace/turned_convolution.hpp"

#include <algorithm>

#include "base/elementary.hpp"

namespace wrc::halfspace {

TurnedConvolution::TurnedConvolution(const Grid& grid, const patch::Material& material,
                                     Convolution::Kernel kernel, const Field& angles, double coupling)
    : nx_(static_cast<std::size_t>(grid.nx)),
      ny_(static_cast<std::size_t>(grid.ny)),
      planar_(grid, material, kernel, coupling),
      unused_(grid.cells()) {
  // cos(a_i - a_j) = cos a_i cos a_j + sin a_i sin a_j, and the like for the sine: tabulated per row
  if (angles.empty()) return;
  by_cosine_.resize(grid.cells());
  by_sine_.resize(grid.cells());
  for (const double a : angles) {
    const SineCosine turned = sine_cosine(a);
    cosine_.push_back(turned.cosine);
    sine_.push_back(turned.sine);
  }
}

void TurnedConvolution::scale_rows(const Field& factor, const Field& p, Field& out) const {
  for (std::size_t j = 0, k = 0; j < ny_; ++j) {
    for (std::size_t i = 0; i < nx_; ++i, ++k) out[k] = factor[j] * p[k];
  }
}

void TurnedConvolution::convolve_parts(const Field& p) {
  scale_rows(cosine_, p, by_cosine_);
  scale_rows(sine_, p, by_sine_);
  planar_.apply(by_cosine_.data(), by_sine_.data(), by_cosine_.data(), by_sine_.data());
}

void TurnedConvolution::convolve_parts(const Field& x, const Field& y) {
  // a product has room for two fields: one for the cosines of both components, one for the sines
  for (const bool cosines : {true, false}) {
    const Field& factor = cosines ? cosine_ : sine_;
    Field& part = cosines ? by_cosine_ : by_sine_;
    scale_rows(factor, x, unused_);
    scale_rows(factor, y, part);
    planar_.apply(unused_.data(), part.data(), unused_.data(), part.data());
  }
}

void TurnedConvolution::sum_cosines(Field& out) const {
  for (std::size_t j = 0, k = 0; j < ny_; ++j) {
    for (std::size_t i = 0; i < nx_; ++i, ++k) out[k] = cosine_[j] * by_cosine_[k] + sine_[j] * by_sine_[k];
  }
}

void TurnedConvolution::sum_sines(Field& out) const {
  for (std::size_t j = 0, k = 0; j < ny_; ++j) {
    for (std::size_t i = 0; i < nx_; ++i, ++k) out[k] = sine_[j] * by_cosine_[k] - cosine_[j] * by_sine_[k];
  }
}

void TurnedConvolution::normal(const Field& p, Field& out) {
  if (cosine_.empty()) {
    std::fill(unused_.begin(), unused_.end(), 0.0);
    planar_.apply(p.data(), unused_.data(), out.data(), unused_.data());
    return;
  }
  convolve_parts(p);
  sum_cosines(out);
}

void TurnedConvolution::normal_crossed(const Field& p, Field& out) {
  std::fill(out.begin(), out.end(), 0.0);
  if (cosine_.empty()) return;
  convolve_parts(p);
  sum_sines(out);
}

void TurnedConvolution::tangential(Field& x, Field& y) {
  if (cosine_.empty()) {
    planar_.apply(x.data(), y.data(), x.data(), y.data());
    return;
  }
  // u_y = sum cos d (K_xy x + K_yy y) from the parts; u_x knows no turning
  convolve_parts(x, y);
  planar_.apply(x.data(), y.data(), x.data(), unused_.data());
  sum_cosines(y);
}

void TurnedConvolution::tangential_crossed(const Field& x, const Field& y, Field& out) {
  std::fill(out.begin(), out.end(), 0.0);
  if (cosine_.empty()) return;
  convolve_parts(x, y);
  sum_sines(out);
}

}  // namespace wrc::halfspace
