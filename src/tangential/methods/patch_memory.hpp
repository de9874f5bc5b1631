/// The law of contact that remembers, for one patch over one step: a plane's (strip_memory.hpp) and those of
/// a wheel on a rail (surface/rolling/remembering.hpp).
///
/// Simplified theory with displacements u = L p of the bodies' particles. In a step the wheel is displaced
/// over the rail by D, and rolls by a length h, or rests. A particle that is at x now was where the bodies
/// carried it from, with the traction p' of then; it has
///     p = the point of the disk |p| <= bound nearest to p' - (D - U) / L,
/// one implicit step of friction, which dissipates. Particles enter without tractions.
///
///  - The half-spaces yield as a whole, U = S (F - F'), beside the displacement of each place by its own
///    traction. Local flexibilities give the forces of linear rolling (Kalker), both together the stiffness of
///    a patch that sticks at rest (Mindlin): S is the difference, no fitted number. U is a translation and a
///    rotation.
///  - Patches of a rail may overlap where humps touch (yielding_patch.hpp). A strip's cells move by the mean of
///    its patches' yields, by their shares, so all patches of a run are solved together, in one pass over cells.
///  - The bound has the friction limit of the patch. It depends on the share r of the area where pressure is
///    larger: 1 - x^2 - (2/3) q (1 - x^3), x = r / (1 - q + q r), q the share of U in the whole yield, less that
///    by which humps displace one another. So shifts at rest are Cattaneo's, 1 - (1 - d)^1.5, on ellipses. On
///    other patches a part of the bound is a cone's, 1 - x - (1/2) q (1 - x^2), by the mean of r under the
///    pressure (Jaeger, Ciavarella). Hysteresis is Mindlin's (Masing), as each cell sticks and slips by itself.
///  - Cells by themselves turn too slowly where the shift turns: round a circle their work is 12 to 18 % low.
///    So the displacement counts more for the direction of a cell that slides, the more the patch sticks, and
///    only as far as it rolls little. Work stays positive: bound times displacement along it.
///  - Arms of spin are longer than the cells' by a factor, for the forces and the displacements alike: the
///    bound is nearer to the centre than pressure is.
///  - Rolling steadily this is FASTSIM. The difference of steady strip FASTSIM to the same cells in steady
///    rolling is added and follows over the length rolled; at rest it stays. It is taken ahead by the yield of
///    the moment. Conditions that stay end in strip FASTSIM, and a step over two lengths of the patch is
///    strip FASTSIM, which takes over from 1.5 lengths on.
///  - Passivity: the contact counts the energy that it could give back. It is at most the energy stored in
///    cells and in U, and at most its value before and the step's work -F.D. Where less were left than a
///    quarter of the stored energy, tractions and forces are lowered to that. So the work over any path is
///    never below zero, however patches change.
///
/// Factors are fitted to random sequences solved exactly (tools/calibration, `make_patches memory`).
#pragma once

#include <cstdint>

#include "base/number.hpp"
#include "tangential/methods/past_strip.hpp"
#include "tangential/methods/yielding_patch.hpp"
#include "tangential/rolling_contact.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::tangential {

/// Strips of a step side by side: those remembered, and where the step's go.
struct PatchStrips {
  const PastStrip* past = nullptr;
  std::int64_t past_count = 0;
  PastStrip* written = nullptr;        ///< as many as the step has
  RememberingStrip* strips = nullptr;  ///< as many, with bounds and stiffness (add_to_strips())
  const double* number =
      nullptr;  ///< numbers of a rail's strips; nullptr: strips of a plane, whose past is found by place
  const PastStrip* const* past_of = nullptr;  ///< the past of each strip, or nullptr; with `number`
  double length = 0.0;                        ///< by which steps are divided [m]; 0: the patch's
  std::int32_t first = 0;                     ///< number of the first strip as the patches count them
};

/// The remembered strips that a strip comes from, and their shares [-].
struct Neighbours {
  const PastStrip *first = nullptr, *second = nullptr;
  double of_first = 1.0, of_second = 0.0;
};

/// Forces before a step on a plane: sets those of the patch.
struct PastOfPlane {
  double added[3] = {};  ///< difference to strip FASTSIM
  double energy = 0.0;   ///< it could give back [J]
};
PastOfPlane take_past_of_plane(const RollingContact& contact, const PatchStrips& strips,
                               YieldingPatch& patch);

/// Strips side by side during a step: one patch, or those that yield together. Motions of the strips are
/// about the centre of the first patch.
class PatchStep {
 public:
  static constexpr std::int32_t most_lobes = 8;

  /// `patches`: those of each lobe alone are among them, in their order.
  PatchStep(const RollingContact& contact, const PatchStrips& strips, YieldingPatch* patches,
            std::int32_t count);

  /// Goes through the step in parts: displaced by `per` length over `travel`, and rolled. Leaves the
  /// displacement of the cells over the last part in the patches, that of the bodies, and the rolled length
  /// of the part [m].
  void go(const double per[3], double travel, double rolled, double of_part[3], double& last);

  /// Forces of the cells in steady rolling at displacements `per` length of one patch, brought over h at
  /// least. The strips go to `into`.
  void steady(const double per[3], double h, PastStrip* into, double of[3]);

  /// Forces of the written cells of one patch about its centre, with its arms.
  void forces(double of[3]) const;
  /// Energy stored in the written strips [J].
  double stored() const;
  void lower(double scale);  ///< all that is written, times `scale`
  double adhesion_fraction() const;

 private:
  /// Strips that move alike, with the lobe; a strip across a border moves with the next lobe, too.
  struct Group {
    std::int32_t first, end, lobe;
    double share;
  };
  /// Forces of the lobes, and their negative derivatives by the lobes' motions.
  struct LobeSums {
    double force[most_lobes][3];
    double slope[most_lobes][most_lobes][3][3];
  };
  /// A part of a step: is it the first, its share of the step, and that of the parts after it [-].
  struct Part {
    bool first;
    double share, to_come;
  };
  void set_strips();
  void find_groups();
  void let_strips_leave();
  Neighbours past_of(std::int32_t j) const;
  void solve_part(const double of_part[3], double h, double travel, const Part& part);
  void bring(double h, bool first);
  void place_strips(double done);
  void sum_lobes(simd::MemoryPassTask& task, LobeSums& sums) const;
  /// `known`: number of lobes, or 0.
  template <std::int32_t known>
  void take_newton_step(double yields, LobeSums& sums);
  void add_yield(const YieldingPatch& patch);
  void find_motions();
  void aim(simd::MemoryPassTask& task, const Group& group) const;
  void force_of_patch(const YieldingPatch& patch, const double (*of_lobes)[3], double of[3]) const;
  void motion_by(const YieldingPatch& patch, const double displaced[3], double motion[3]) const;
  void written_forces(double (*of_lobes)[3]) const;
  double length() const { return strips_.length > 0.0 ? strips_.length : patches_->numbers.length; }
  double key(std::int32_t j) const {
    return strips_.number ? strips_.number[j] : contact_.memory.y(contact_.region.y[j]);
  }

  const RollingContact& contact_;
  const PatchStrips strips_;
  YieldingPatch* const patches_;
  const std::int32_t patch_count_;
  double x_, y_;  // place that motions are about [m]
  Group groups_[2 * most_lobes];
  std::int32_t group_count_ = 0, lobes_ = 1;
  double yield_[most_lobes][most_lobes][3][3];  // motions of lobes by forces on them
  double motion_[most_lobes][3];                // displacements of the lobes' cells
};

/// Displacements of the patch's centre for creepages about the origin, and back.
void about_centre(const PatchNumbers& numbers, const Creepage& c, double length, double shift[3]);
Creepage about_origin(const PatchNumbers& numbers, const double shift[3], double length);
/// One over a length, and less where displacements `size` over it would be more than slides everywhere.
double per_length(double size, double length);

/// Share of the difference to strip FASTSIM that follows over the length rolled.
double follows(const PatchNumbers& numbers, double rolled, const MemoryFactors& factors = fitted_memory);

/// Cells of strips in steady rolling, brought over h at least, into `into` (forces, tractions).
void march_steadily(const RollingContact& contact, const RememberingStrip* strips, std::int32_t count,
                    const double per[3], double h, PastStrip* into);

/// Over which a step of which nothing before is seen brings its cells [m].
double last_part(double length);

/// Lengths of the longest strip: a step of which nothing before is seen.
inline constexpr double all_forgotten = 2.0;

/// Lengths from which on steady rolling takes over.
inline constexpr double forgets_from = 1.5;

/// Share of steady rolling in a path of so many lengths: 1 where nothing before is seen.
inline double forgotten(double lengths) {
  return smooth_step((lengths - forgets_from) * (1.0 / (all_forgotten - forgets_from)));
}

/// Is a path none? `length`: of the longest strip [m].
bool hardly_rolls(double rolled, double length);
}  // namespace wrc::tangential
