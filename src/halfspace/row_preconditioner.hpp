/// Approximate inverse of the Newton matrix of steady rolling: every row of cells along the rolling direction
/// is solved exactly on its own, its coupling to the other rows left out.
///
/// What makes the equations hard is along the rows (a cell acts on the slip upstream and downstream, with
/// opposite signs, and the solution builds up from the leading edge); with the rows inverted, GMRES needs 10
/// to 20 products whatever the grid.
#pragma once

#include <Eigen/LU>
#include <cstddef>
#include <vector>

#include "halfspace/convolution.hpp"
#include "halfspace/gmres.hpp"

namespace wrc::halfspace {

/// How the traction of one cell may change in a Newton step: freely in adhesion, along the circle |p| = g in
/// slip.
struct CellUnknowns {
  int i = 0, j = 0;       ///< the cell
  std::size_t first = 0;  ///< index of its first unknown
  int count = 0;          ///< 2: changes of p_x and p_y; 1: change along (tx, ty)
  double tx = 0.0, ty = 0.0;
  double stiffening = 0.0;  ///< slip: |s| / g, resistance to turning [1/Pa]
};

class RowPreconditioner {
 public:
  /// Factors the rows; cells ordered by row. Single precision: it only steers the iteration.
  void factor(const std::vector<CellUnknowns>& cells, const Convolution& coefficients);

  void apply(const Vector& in, Vector& out) const;

 private:
  struct Row {
    std::size_t first = 0;
    Eigen::Index size = 0;
    Eigen::PartialPivLU<Eigen::MatrixXf> inverse;
  };
  std::vector<Row> rows_;
};

}  // namespace wrc::halfspace
