/// Approximate inverse of the Newton matrix of steady rolling: every row of cells along the rolling direction
/// is solved exactly on its own, its coupling to the other rows left out.
///
/// What makes the equations hard is along the rows (a cell acts on the slip upstream and downstream, with
/// opposite signs, and the solution builds up from the leading edge); with the rows inverted, GMRES needs 10
/// to 20 products whatever the grid.
#pragma once

#include <Eigen/LU>
#include <vector>

#include "halfspace/convolution.hpp"
#include "halfspace/gmres.hpp"
#include "tangential/coarse_halfspace/rolling_newton.hpp"

namespace wrc::halfspace {

class RowPreconditioner {
 public:
  /// Factors the rows; cells ordered by row. Single precision: it only steers the iteration.
  void factor(const std::vector<NewtonCell>& cells, const Convolution& coefficients);

  void apply(const Vector& in, Vector& out) const;

 private:
  struct Row {
    int first = 0;
    Eigen::Index size = 0;
    Eigen::PartialPivLU<Eigen::MatrixXf> inverse;
  };
  std::vector<Row> rows_;
};

}  // namespace wrc::halfspace
