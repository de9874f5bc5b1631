#include "halfspace/row_preconditioner.hpp"

namespace wrc::halfspace {
void RowPreconditioner::factor(const std::vector<NewtonCell>& cells, const Convolution& coefficients) {
  // Scaled by the largest coefficient: 1/Pa would underflow in single precision products.
  const double scale = 1.0 / coefficients.xx(0, 0);
  rows_.clear();
  for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
    while (end < cells.size() && cells[end].at - cells[end].i == cells[begin].at - cells[begin].i) ++end;
    const int first = cells[begin].first;
    const Eigen::Index size = cells[end - 1].first + cells[end - 1].count - first;
    Eigen::MatrixXf matrix(size, size);
    for (std::size_t bi = begin; bi < end; ++bi) {
      const NewtonCell& b = cells[bi];
      const Eigen::Index column = b.first - first;
      for (std::size_t ai = begin; ai < end; ++ai) {
        const NewtonCell& a = cells[ai];
        const Eigen::Index row = a.first - first;
        const auto xx = static_cast<float>(scale * coefficients.xx(a.i - b.i, 0));
        const auto yy = static_cast<float>(scale * coefficients.yy(a.i - b.i, 0));
        couple(a, b, xx, yy, [&](int r, int c, float value) { matrix(row + r, column + c) = value; });
      }
      if (b.count == 1) matrix(column, column) += static_cast<float>(scale * b.stiffening);
    }
    rows_.push_back({.first = first, .size = size, .inverse = matrix.partialPivLu()});
  }
}

void RowPreconditioner::apply(const Vector& in, Vector& out) const {
  for (const Row& row : rows_) {
    Eigen::Map<const Eigen::VectorXd> right(in.data() + row.first, row.size);
    Eigen::Map<Eigen::VectorXd> left(out.data() + row.first, row.size);
    left = row.inverse.solve(right.cast<float>()).cast<double>();
  }
}

}  // namespace wrc::halfspace
