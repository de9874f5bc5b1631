/// Eigenvalues and eigenvectors of a small symmetric matrix, by Jacobi's rotations in a fixed order.
#pragma once

#include <cmath>

namespace wrc::curves {

template <int most>
struct Symmetric {
  int n = 0;
  double a[most][most] = {};        ///< the matrix; after diagonalise() its eigenvalues on the diagonal
  double vectors[most][most] = {};  ///< [i][k]: element i of eigenvector k

  /// Turns pairs of axes until the elements beside the diagonal are rounding errors.
  void diagonalise() {
    constexpr int most_sweeps = 60;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) vectors[i][k] = i == k ? 1.0 : 0.0;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      double beside = 0.0, diagonal = 0.0;
      for (int i = 0; i < n; ++i) {
        diagonal += a[i][i] * a[i][i];
        for (int k = 0; k < i; ++k) beside += a[i][k] * a[i][k];
      }
      if (!(beside > 1e-32 * diagonal)) return;
      for (int i = 0; i < n; ++i)
        for (int k = 0; k < i; ++k) turn(i, k);
    }
  }

 private:
  /// The rotation in the plane of axes i and k that makes a[i][k] zero.
  void turn(int i, int k) {
    if (a[i][k] == 0.0) return;
    const double theta = (a[k][k] - a[i][i]) / (2.0 * a[i][k]);
    const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
    const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
    for (int j = 0; j < n; ++j) {
      const double x = a[j][i], y = a[j][k];
      a[j][i] = c * x - s * y;
      a[j][k] = s * x + c * y;
    }
    for (int j = 0; j < n; ++j) {
      const double x = a[i][j], y = a[k][j];
      a[i][j] = c * x - s * y;
      a[k][j] = s * x + c * y;
      const double v = vectors[j][i], w = vectors[j][k];
      vectors[j][i] = c * v - s * w;
      vectors[j][k] = s * v + c * w;
    }
  }
};

}  // namespace wrc::curves
