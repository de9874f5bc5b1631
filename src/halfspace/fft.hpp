/// Fast Fourier transform of many interleaved signals at once, for the convolutions of the half-space
/// solvers.
///
/// Real and imaginary parts lie in separate arrays and the transformed index is the slow one: element k of
/// signal q is at k * signals + q. The inner loops then run over contiguous signals and vectorise, which is
/// why this is not a general library's row-by-row transform: products are where the exact solver spends its
/// time.
#pragma once

#include <vector>

namespace wrc::halfspace {

class Fft {
 public:
  /// Plans transforms of `length` points; length must be a product of 2, 3, 4 and 5 (good_length).
  explicit Fft(int length);

  /// Smallest length >= minimum the transform accepts.
  static int good_length(int minimum);

  int length() const { return length_; }

  /// X_k = sum_n x_n exp(-2 pi i k n / length) for every signal, in place; `work` arrays are of the same
  /// size.
  void forward(double* re, double* im, double* work_re, double* work_im, int signals) const;

  /// The inverse without its factor 1/length.
  void backward(double* re, double* im, double* work_re, double* work_im, int signals) const;

 private:
  struct Stage {
    int radix = 0;
    int blocks = 0;           // butterflies per stage and stride: remaining length / radix
    std::vector<double> cos;  // cos and sin of 2 pi p r / (blocks * radix), r = 1..radix-1, for each block p
    std::vector<double> sin;
  };

  int length_ = 0;
  std::vector<Stage> stages_;
};

/// out[j * rows + i] = in[i * columns + j], in small tiles that stay in cache.
void transpose(const double* in, double* out, int rows, int columns);

/// Real and imaginary parts of signals over x and y, and arrays of the same size to work with.
struct Plane {
  std::vector<double>&re, &im, &work_re, &work_im;
};

/// From the spectrum (y slow) back to space (x slow), without the factors, for the first `rows` rows;
/// overwrites the work arrays.
void backward_2d(const Fft& along_x, const Fft& along_y, int rows, const Plane& plane);

}  // namespace wrc::halfspace
