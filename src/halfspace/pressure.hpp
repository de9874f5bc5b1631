/// Prescribed normal pressure on a grid: semi-elliptic SDEC patches and strip patches, so that tangential
/// methods can be judged alone.
#pragma once

#include "halfspace/grid.hpp"
#include "patch/strips.hpp"

namespace wrc::halfspace {

/// Simple double-elliptical contact: two half ellipses with the same semi-axis a along x, joined on the x
/// axis, b (1 + psi) towards +y and b (1 - psi) towards -y. Origin at the joint, the initial contact point.
struct SdecPatch {
  double a = 0.0;    ///< semi-axis along rolling [m]
  double b = 0.0;    ///< half of the total width [m]
  double psi = 0.0;  ///< shape number y0 / b, |psi| < 1

  /// x_l(y), half length of the patch at y; zero outside.
  double half_length(double y) const;
};

/// What a cell's pressure is.
enum class CellPressure {
  mean,  ///< mean over the cell: cells on the border carry their share, the load is exact, and the traction
         ///< bound goes smoothly to zero as the grid is refined or shifted. The default for accurate answers.
  centre  ///< value at the centre, as the reference program does: the border is a staircase
};

/// nx x ny cells over the patch's bounding box.
Grid grid_over(const SdecPatch& patch, int nx, int ny);

/// p = peak sqrt(x_l(y)^2 - x^2) / a on the cells of the grid [Pa].
Field sdec_pressure(const SdecPatch& patch, double peak, const Grid& grid, CellPressure rule);

/// Cell means of the pressure of a strip patch: strips keep their width and place, so the load is that of the
/// strips inside the grid.
Field strip_pressure(const Strips& strips, const Grid& grid);

/// nx x ny cells over the bounding box of the strips.
Grid grid_over(const Strips& strips, int nx, int ny);

}  // namespace wrc::halfspace
