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

#include <cstddef>
#include <cstdint>

#include "tangential/methods/patch_numbers.hpp"
#include "tangential/rolling_contact.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::tangential {

/// Memory of a strip, of the bodies rolling forwards.
struct PastStrip {
  double y;                    ///< place on the rail [m], or number of the rail's strip
  double centre, half_length;  ///< [m]
  /// Forces of its cells: Fx, Fy [N], and Mz about its own middle over the factor on arms [N m].
  double force[3];
  double added[3];  ///< its part of the difference to strip FASTSIM, Mz about the origin, on a rail its own
  double energy;    ///< it could give back [J]
  double slip[3];   ///< in the step, on a rail: creepages of its middle [-], spin [1/m]
  double way;       ///< rolled under these conditions over the contact's length, backwards below zero [-]
  double px[memory_cells], py[memory_cells];  ///< tractions of its cells, from the largest x on [Pa]
  double bound[memory_cells / 2];  ///< their bounds up to the middle; the others are symmetric [Pa]
};
static_assert(sizeof(PastStrip) == (14 + 2 * memory_cells + memory_cells / 2) * sizeof(double),
              "no padding: its bytes are saved");

using simd::RememberingStrip;

/// The strips that a contact remembers, and those of the step that is being solved: behind it in memory.
struct Memory {
  std::int64_t capacity;  ///< strips
  std::int64_t present;   ///< the list of the two behind that is remembered; the other is being written
  std::int64_t count;     ///< strips of the list that is remembered
  std::int64_t written;   ///< strips of the other list

  /// Bytes of this with `lists` lists of so many strips behind it.
  static std::size_t bytes(std::int32_t strips, std::size_t lists) {
    return sizeof(Memory) + static_cast<std::size_t>(strips) * lists * sizeof(PastStrip);
  }

  PastStrip* list(std::int64_t which) { return reinterpret_cast<PastStrip*>(this + 1) + which * capacity; }
  PastStrip* remembered() { return list(present); }
  PastStrip* other() { return list(1 - present); }
  RememberingStrip* scratch() { return reinterpret_cast<RememberingStrip*>(list(3)); }

  /// The strips written are remembered from now on.
  void turn_over() {
    present = 1 - present;
    count = written;
  }
};

/// Forces of strips that have left a rail's patch, of bodies rolling forwards. Sums of fx and fy [N], of
/// moments about the strips' own middles, and of x fy - y fx from the patch's origin [N m]. The half-spaces
/// yield as these forces vanish.
struct LeftStrips {
  double fx = 0.0, fy = 0.0, mz = 0.0, turn = 0.0;
};

/// Strips of one patch: those remembered, and where the step's go.
struct PatchStrips {
  const PastStrip* past = nullptr;
  std::int64_t past_count = 0;
  PastStrip* written = nullptr;         ///< as many as the patch has
  RememberingStrip* scratch = nullptr;  ///< as many
  const double* number =
      nullptr;  ///< numbers of a rail's strips; nullptr: strips of a plane, whose past is found by place
  const PastStrip* const* past_of = nullptr;  ///< the past of each strip, or nullptr; with `number`
  const double* inside = nullptr;             ///< share of each strip's width within the patch; with `number`
  double length = 0.0;                        ///< by which steps are divided [m]; 0: the patch's
};

/// The remembered strips that a strip comes from, and their shares [-].
struct Neighbours {
  const PastStrip *first = nullptr, *second = nullptr;
  double of_first = 1.0, of_second = 0.0;
};

/// A patch during a step. Displacements are a translation of the patch's centre [m] and a rotation [rad].
class PatchStep {
 public:
  PatchStep(const RollingContact& contact, const PatchStrips& strips, const PatchNumbers& numbers,
            const MemoryFactors& factors = fitted_memory);

  /// Bounds of the cells, and how much faster they turn, by this patch alone.
  void set_bounds();
  /// On a rail: strips that two partitions share take their bounds, growths and displacements per length,
  /// which are the same in all patches they are of. `left`: forces of strips that the patch has lost.
  void take_shared(const RememberingStrip* const* shared, const LeftStrips& left);

  double length() const { return strips_.length > 0.0 ? strips_.length : numbers_.length; }

  /// Goes through the step in parts: displaced by `per` length over `travel`, and rolled. Leaves the
  /// displacement of the cells over the last part, that of the patch, and the rolled length of the part [m].
  void go(const double per[3], double travel, double rolled, double local[3], double of_part[3],
          double& last);

  /// Forces of the cells in steady rolling at displacements `per` length, brought over h at least. The strips
  /// go to `into`.
  void steady(const double per[3], double h, PastStrip* into, double of[3]);

  /// Share of the difference to strip FASTSIM that follows over the length rolled.
  double follows(double rolled) const;

  /// Forces of the written cells.
  void forces(double of[3]) const;
  /// Brings forces from the centre, with its longer arms, to the origin.
  void refer_to_origin(double of[3]) const { of[2] += numbers_.centre_x * of[1] - numbers_.centre_y * of[0]; }

  /// The displacements of the patch's centre for creepages about the origin, and back.
  void about_centre(const Creepage& c, double length, double shift[3]) const;
  Creepage about_origin(const double shift[3], double length) const;
  /// One over a length, and less where displacements `size` over it would be more than slides everywhere.
  static double per_length(double size, double length);

  /// Energy stored in the written strips [J].
  double stored() const;
  void lower(double scale);  ///< all that is written, times `scale`
  double adhesion_fraction() const;

  /// On a plane, before the step: difference to strip FASTSIM, and the energy it could give back [J].
  const double* added() const { return added_; }
  double energy() const { return energy_; }

 private:
  void take_past_of_rail();
  void take_past_of_plane();
  void add_past_of_rail(std::int32_t j, double share, double to[3]) const;
  void let_strips_leave();
  void set_strips();
  Neighbours past_of(std::int32_t j) const;
  /// A part of a step: is it the first, its share of the step, and that of the parts after it [-].
  struct Part {
    bool first;
    double share, to_come;
  };
  /// Leaves the displacement of the cells, and the amount by which the equation of U is not met.
  void solve_part(const double shift[3], double h, const Part& part, double local[3], double rest[3]);
  void bring(double h, bool first);
  void place_strips(double done);
  void set_own(double travel);
  double key(std::int32_t j) const {
    return strips_.number ? strips_.number[j] : contact_.memory.y(contact_.region.y[j]);
  }

  const RollingContact& contact_;
  const PatchStrips strips_;
  const RememberingStrip* const* shared_ = nullptr;  // those of take_shared()
  const MemoryFactors& factors_;
  const PatchNumbers& numbers_;
  double before_[3] = {}, added_[3] = {}, energy_ = 0.0;  // at the beginning of the part, and of the step
  double left_[3] = {};                                   // forces of strips that leave in the step
};

/// Middles of the cells over the half length, from the leading edge on.
const double* memory_places();

/// Cells of strips in steady rolling, brought over h at least, into `into` (forces, tractions).
void march_steadily(const RollingContact& contact, const RememberingStrip* strips, std::int32_t count,
                    const double per[3], double h, PastStrip* into);

/// Over which a step of which nothing before is seen brings its cells [m].
double last_part(double length);

/// Lengths of the longest strip: a step of which nothing before is seen.
inline constexpr double all_forgotten = 2.0;

/// Is a path none? `length`: of the longest strip [m].
bool hardly_rolls(double rolled, double length);
/// Share of steady rolling in such a path: 1 where nothing before is seen.
double forgotten(double rolled, double length);
/// Gives a strip's cells that share of those in steady rolling.
void tend_to(const PastStrip& steady, double share, PastStrip& strip);
/// Energy stored in the tractions of a strip's cells [J].
double stored_in(const PastStrip& strip, double area, double growth_x, double growth_y);
/// Energy stored in the half-spaces under these forces of a patch [J].
double stored_by(const double yield[3], const double force[3]);
/// Adds `weight` times the numbers of a strip's cells to others.
void add_cells(double weight, const double* from, double* to);
/// A strip's cells, times `scale`.
void lower(double scale, PastStrip& strip);

/// Energy that can be given back after a step, and the rest of it.
struct EnergyLeft {
  double scale = 1.0;       ///< on all forces and tractions
  double left = 0.0;        ///< [J]
  double dissipated = 0.0;  ///< [J]
};

/// `before`: energy that could be given back before; `work` put in; `stored` in tractions as they are [J].
EnergyLeft count_energy(double before, double work, double stored);

/// A past strip as the bodies roll now: backwards it is the mirror image.
PastStrip turned(const PastStrip& strip, double direction);

}  // namespace wrc::tangential
