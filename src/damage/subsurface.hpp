/// Largest stresses below a solved patch in bounded time.
///
/// Neighbouring strips become one lane with their load and area. A lane has `cells` cells that are the
/// shorter the nearer to its ends, x = centre + half length cos(pi k / cells): pressure ends like a root
/// there, and so do the tractions of what slides; cells of one length would end in steps, beside which
/// tension is much too small. A cell's pressure is the mean of the semi-ellipse over it, its tractions the
/// share of the pressure that they are in the patch's own cells there. A stress is the sum over these cells:
/// near ones as rectangles under constant loads, exact at the surface too, all others as forces at points
/// (damage/cell_stress.hpp). It is looked for at the middles of cells, and at the mirror images of some
/// behind the ends of a lane, coarsely, then around the largest of each number.
#pragma once

#include <cstdint>

#include "damage/cell_stress.hpp"
#include "patch/strips.hpp"
#include "tangential/problem.hpp"

namespace wrc {

/// What acts on the body, from all patches of a contact.
class LoadLanes {
 public:
  static constexpr std::int32_t most_lanes = 36, cells = 56;
  static constexpr std::int32_t wanted_lanes = 20;  ///< of all strips together; every patch has one at least
  static constexpr std::int32_t beyond = 7;         ///< cells looked at behind each end of a lane
  /// So many cells on both sides of an end are not looked at, half a hundredth of the lane's length: at the
  /// edge stresses change within less than an edge is known to.
  static constexpr std::int32_t spared = 2;

  explicit LoadLanes(double poisson);

  /// One patch. pressure and tractions: of `own_cells` cells, cell i of strip j at i * region.count + j,
  /// cell 0 at the leading edge, which is at +x for way 1 and at -x for -1; strips_of_all: of all patches;
  /// sign: 1 where tractions are those on the body, -1 where on the other.
  void add_patch(const Strips& region, const double* pressure, const TangentialFields& fields,
                 std::int32_t own_cells, std::int32_t strips_of_all, double way, double sign);

  /// The largest numbers at one depth [m].
  StressPeaks peaks(double z) const;

  /// The largest beneath (x, y) of a peak, between two depths: golden sections, `below` takes all it meets.
  void refine(const StressPeak& from, StressPeak StressPeaks::*which, double low, double high,
              StressPeaks& below) const;

  Stress at(double x, double y, double z) const;

 private:
  struct Lane {
    double y, width, centre, half_length;  ///< the last with the sign of the way
  };
  /// Of a cell's middle, or behind an end.
  double x_of(const Lane& lane, std::int32_t cell) const;
  double poisson_;
  std::int32_t lanes_ = 0;
  Lane lane_[most_lanes];
  double middle_[cells], half_[cells], mean_[cells];  ///< place, half width, mean of sqrt(1 - xi^2)
  double pressure_[most_lanes][cells], along_[most_lanes][cells], across_[most_lanes][cells];
};

}  // namespace wrc
