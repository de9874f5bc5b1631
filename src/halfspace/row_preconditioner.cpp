#include "halfspace/row_preconditioner.hpp"

namespace wrc::halfspace {
namespace {

// Fills the block of the matrix that gives the slip of cell a from the traction change of cell b of its row.
// Within a row u_x does not depend on p_y (the coefficient is odd in y).
template <typename Block>
void fill(Block block, const CellUnknowns& a, const CellUnknowns& b, double xx, double yy) {
  const auto x = static_cast<float>(xx), y = static_cast<float>(yy);
  const auto ax = static_cast<float>(a.tx), ay = static_cast<float>(a.ty);
  const auto bx = static_cast<float>(b.tx), by = static_cast<float>(b.ty);
  if (a.count == 2 && b.count == 2) {
    block << x, 0.0F, 0.0F, y;
  } else if (a.count == 2) {
    block << x * bx, y * by;
  } else if (b.count == 2) {
    block << ax * x, ay * y;
  } else {
    block << ax * x * bx + ay * y * by;
  }
}

}  // namespace

void RowPreconditioner::factor(const std::vector<CellUnknowns>& cells, const Convolution& coefficients) {
  // Scaled by the largest coefficient: 1/Pa would underflow in single precision products.
  const double scale = 1.0 / coefficients.xx(0, 0);
  rows_.clear();
  for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
    while (end < cells.size() && cells[end].j == cells[begin].j) ++end;
    const std::size_t first = cells[begin].first;
    const auto size = static_cast<Eigen::Index>(cells[end - 1].first - first) +
                      static_cast<Eigen::Index>(cells[end - 1].count);
    Eigen::MatrixXf matrix(size, size);
    for (std::size_t bi = begin; bi < end; ++bi) {
      const CellUnknowns& b = cells[bi];
      const auto column = static_cast<Eigen::Index>(b.first - first);
      for (std::size_t ai = begin; ai < end; ++ai) {
        const CellUnknowns& a = cells[ai];
        const auto row = static_cast<Eigen::Index>(a.first - first);
        fill(matrix.block(row, column, a.count, b.count), a, b, scale * coefficients.xx(a.i - b.i, 0),
             scale * coefficients.yy(a.i - b.i, 0));
      }
      if (b.count == 1) matrix(column, column) += static_cast<float>(scale * b.stiffening);
    }
    rows_.push_back({.first = first, .size = size, .inverse = matrix.partialPivLu()});
  }
}

void RowPreconditioner::apply(const Vector& in, Vector& out) const {
  for (const Row& row : rows_) {
    const auto first = static_cast<std::ptrdiff_t>(row.first);
    Eigen::Map<const Eigen::VectorXd> right(in.data() + first, row.size);
    Eigen::Map<Eigen::VectorXd> left(out.data() + first, row.size);
    left = row.inverse.solve(right.cast<float>()).cast<double>();
  }
}

}  // namespace wrc::halfspace
