/// Largest stresses below a solved patch in bounded time.
///
/// Neighbouring strips become one lane with their load and area. A lane has `cells` cells that are the
/// shorter the nearer to its ends, borders at centre + half length cos(pi k / cells): pressure ends like a
/// root there, and so do the tractions of cells that slide; cells of one length would end in steps, beside
/// which tension is much too small. Where adhesion ends there is a border, too, for stresses peak there. A
/// cell's pressure is the mean of the semi-ellipse over it, its tractions the share of the pressure that they
/// are there in the lane's middle strip. A stress is a sum over loads: near cells as rectangles, exact at the
/// surface too, the others of a lane as forces at points of Gauss and Chebyshev's rule; from some depth on
/// fewer of these, whose error falls exponentially with the depth over their distances
/// (damage/load_stress.hpp). It is looked for at the middles of cells, and at the mirror images of some
/// behind the ends of a lane, coarsely, then around the largest of each number.
#pragma once

#include <cstdint>

#include "damage/stress.hpp"
#include "kernels/kernels.hpp"
#include "patch/strips.hpp"
#include "tangential/problem.hpp"

namespace wrc::damage {

/// Loads on the body, from all patches of a contact.
class LoadLanes {
 public:
  static constexpr std::int32_t most_lanes = 36, cells = 48;
  static constexpr std::int32_t wanted_lanes = 20;  ///< for all strips together; every patch has one at least
  static constexpr std::int32_t beyond = 7;         ///< cells looked at behind each end of a lane
  /// So many cells on both sides of an end are not looked at, half a hundredth of the lane's length: at the
  /// edge stresses change within less than an edge is known to.
  static constexpr std::int32_t spared = 2;

  LoadLanes(double poisson, const Kernels& kernels);

  /// One patch. pressure: of `own_cells` cells, over the strip's peak; tractions of cell i of strip j at
  /// i * region.count + j, cell 0 at the leading edge, which is at +x for way 1 and at -x for -1;
  /// strips_of_all: of all patches; sign: 1 where tractions are those on the body, -1 where on the other.
  void add_patch(const patch::Strips& region, const double* pressure,
                 const tangential::TangentialFields& fields, std::int32_t own_cells,
                 std::int32_t strips_of_all, double way, double sign);

  /// The largest numbers at one depth [m].
  StressPeaks peaks(double z) const;

  /// The largest beneath (x, y) of a peak, between two depths: golden sections, `below` takes all it meets.
  void refine(const StressPeak& from, StressPeak StressPeaks::*which, double low, double high,
              StressPeaks& below) const;

  Stress at(double x, double y, double z) const;

 private:
  static constexpr std::int32_t deep =
      16;  ///< points of a lane deep below; as cells a multiple of stress_parts
  struct Lane {
    double y, width, centre, half_length;  ///< the last with the sign of the way
    double pressure;                       ///< peak [Pa]
    std::int32_t slips_from = -1;          ///< first cell behind adhesion, -1: none
    double slips_at = 0.0;  ///< where adhesion ends [half lengths]: that cell's border is moved there
    double mean_before = 0.0, mean_behind = 0.0;  ///< mean_ of the cells on both sides of it
  };
  /// Points along x of a lane: places in half lengths, shares of the lane's force.
  struct Rule {
    double place[cells], weight[cells];
  };
  struct Shares;
  struct Corners;
  static void fill(std::int32_t count, Rule& rule);
  /// Has adhesion end at a border of a lane's cells, `place` in half lengths.
  void move_border(Lane& lane, double place) const;
  /// Middle of a cell [half lengths].
  double middle_of(const Lane& lane, std::int32_t cell) const;
  /// x of a cell's middle, or of its mirror image behind an end [m].
  double x_of(const Lane& lane, std::int32_t cell) const;
  /// Cells first..last - 1 of a lane as rectangles.
  void add_cells(std::int32_t lane, std::int32_t first, std::int32_t last, double x, double y,
                 Corners& corners) const;
  void flush(double z, Corners& corners, simd::StressParts& sum) const;

  double poisson_;
  const Kernels& kernels_;
  std::int32_t lanes_ = 0;
  double border_[cells + 1], middle_[cells], mean_[cells];  ///< places, mean of sqrt(1 - xi^2)
  Rule of_cells_, of_depths_;
  Lane lane_[most_lanes];
  double deep_from_ = 0.0;  ///< from there on few points serve [m]
  /// Tractions over pressure at the points of both rules.
  double along_[most_lanes][cells], across_[most_lanes][cells];
  double deep_along_[most_lanes][deep], deep_across_[most_lanes][deep];
};

}  // namespace wrc::damage
