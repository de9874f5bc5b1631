/// The cells of a strip, the traction bound in each of them, and the kernels that march over them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/kernels.hpp"
#include "tangential/problem.hpp"

namespace wrc::tangential {

/// A traction bound over a strip relative to its value at the strip's middle: 1 - s^2 (parabolic) or
/// sqrt(1 - s^2) (elliptic), s = (x - centre) / half_length.
struct BoundShape {
  /// Mean over each cell. Means instead of mid-cell values make the bound integrate to mu N exactly on any
  /// grid (Coulomb's limit); as the shape is concave they never exceed the mid-cell value.
  const double* mean = nullptr;
  /// Change from the leading to the trailing border of each cell, as half the change of the square over the
  /// mean: with it the elastic part of the dissipated power sums to zero over a strip that slips as a whole.
  const double* rise = nullptr;
};

/// The middle of each cell, relative to its strip: the same numbers for all strips.
struct CellMiddles {
  const double* place = nullptr;             ///< s = (x - centre) / half_length [-]
  const double* pressure = nullptr;          ///< sqrt(1 - s^2): pressure / peak of the strip [-]
  const double* inverse_pressure = nullptr;  ///< its inverse [-]
};

/// Cells along a strip, cell 0 at the leading edge; the same for every strip and every step of a model.
struct MarchGrid {
  std::int32_t cells = 0;
  BoundShape parabolic, elliptic;
  CellMiddles middles;
  /// 1 / ((n - i)^(3/2) - (n - i - 1)^(3/2)) for cell i of n: one over the integral over the cell of
  /// 3/2 sqrt(u / h), u the distance from the trailing edge.
  const double* inverse_weight = nullptr;
  const Kernels* kernels = nullptr;  ///< kernels of an instruction set the processor has

  const BoundShape& shape(TractionBound bound) const {
    return bound == TractionBound::parabolic ? parabolic : elliptic;
  }
};

/// Memory a grid needs [doubles].
std::size_t march_grid_size(std::int32_t cells);

/// Fills memory (march_grid_size(cells) doubles, owned by the caller) and returns the view of it. At init.
MarchGrid make_march_grid(std::int32_t cells, double* memory, const Kernels& kernels);

}  // namespace wrc::tangential
