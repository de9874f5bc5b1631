/// Tasks and results of the kernels of an instruction set: plain data, no constructors.
#pragma once

#include <cstdint>

#include "tangential/layer/layer.hpp"
#include "tangential/problem.hpp"

namespace wrc::tangential {

struct BoundShape;
struct MarchGrid;

inline constexpr std::int32_t memory_cells = 16;  ///< along a strip that remembers

}  // namespace wrc::tangential

namespace wrc::simd {

/// Forces and moment can be differentiated with respect to nu_x, nu_y, phi. (Friction and load follow: the
/// forces are homogeneous of degree one in creepages and friction together.)
inline constexpr std::int32_t inputs = 3;

/// A number and its derivatives with respect to nu_x, nu_y, phi.
struct Coefficient {
  double value;
  double d[inputs];
};

/// Results of a kernel, summed over the strips in their order.
struct Sums {
  double fx, fy, mz;       ///< [N], [N m]
  double power_per_speed;  ///< [N]
  double area, slid_area;  ///< [m^2]
  double d[3][inputs];     ///< derivatives of fx, fy, mz; zero if not asked for
};

/// Common part of MarchTask and SurfaceMarchTask.
struct MarchCells {
  std::int32_t strips, cells;
  bool parabolic;  ///< shape of the bound along a strip: parabola or semi-ellipse
  const tangential::BoundShape* shape;
  const tangential::TangentialFields* fields;
};

/// The march of simplified rolling contact (march.hpp). Tractions of full adhesion grow with the distance
/// from the leading edge by gx = gx_constant - gx_by_y y, gy = gy_constant + gy_by_x x [Pa/m].
struct MarchTask : MarchCells {
  const patch::Strips* region;
  const double* shares;  ///< by which friction differs from strip to strip; nullptr: it does not
  Coefficient gx_constant, gx_by_y, gy_constant, gy_by_x;
  double l11, l22;  ///< flexibilities that turn the excess of traction into slip [m/Pa]
  /// Bound at the middle of a strip of half length l: per_pressure * peak + per_length l + per_length_square
  /// l^2.
  double per_pressure, per_length, per_length_square;
};

/// The same where every strip has numbers of its own, about its own middle
/// (surface/rolling/surface_rolling.hpp). One element per strip; growth of adhesion tractions relative to the
/// bound at the strip's middle over the half length.
struct SurfaceMarchTask : MarchCells {
  const double *width, *half_length;  ///< [m]
  const double* bound;                ///< at the strip's middle [Pa]
  const double *growth_x, *growth_y;  ///< at the leading edge
  const double* rate;                 ///< by which the latter falls per half length
  const double *soft_x, *soft_y;      ///< flexibilities times bound over half length [-]
  double *fx, *fy, *mz;               ///< results: force [N], moment about the strip's middle [N m]
};

/// The march with a layer (layer/layer_march.hpp), of strips that each have numbers of their own, about their
/// own middles.
struct LayeredMarchTask : MarchCells {
  std::int32_t stride;                    ///< strips of the fields, which begin at this task's first
  const tangential::BoundShape* elastic;  ///< shape of the bodies' part of the displacement
  const double *width, *half_length;      ///< [m]
  const double* bound;                    ///< mu p at the strip's middle [Pa]
  const double* numbers[tangential::LayeredNumbers::numbers];
  double *fx, *fy, *mz;  ///< results: force [N], moment about the strip's middle [N m]
};

/// Common part of StripFastsimTask and SurfaceStripsTask.
struct StripFastsimMarch {
  std::int32_t strips, cells;
  const tangential::BoundShape* shape;
  const double* inverse_weight;  ///< weights of the cells of the first stick zone (march_grid.hpp)
  const tangential::TangentialFields* fields;
};

/// Strip FASTSIM (strip_fastsim.hpp): its model for a patch, its load and the creepages. Tractions
/// of full adhesion grow as in the march; the elastic slip under a strip that slips as a whole changes by 2 B
/// L x, with the flexibilities l11, l22; that part of it which differs between x and y, by 2 elastic x.
struct StripFastsimTask : StripFastsimMarch {
  const patch::Strips* region;
  const double* shares;  ///< by which friction differs from strip to strip; nullptr: it does not
  double nu_x, nu_y, phi, friction;
  Coefficient gx_constant, gx_by_y, gy_constant, gy_by_x;
  double l11, l22;                 ///< flexibilities of the stick zone [m/Pa]
  double t11, t22;                 ///< flexibilities for the turning of slip [m/Pa]
  Coefficient turning;             ///< factor on them
  Coefficient torsion;             ///< lateral elastic slip of a patch that spins [-]
  double B, elastic;               ///< B [Pa/m^2], (l_x - l_y) B [1/m], both where friction is the mean
  double across_even, across_odd;  ///< m, n of methods/slip_across.hpp, for fields
  double across_beside;            ///< its b
  double middle, per_width;        ///< y of the patch's middle [m], one over half its width [1/m]
};

/// Strip FASTSIM where every strip has numbers of its own, about its own middle
/// (surface/rolling/surface_rolling.hpp). One element per strip; lengths relative to the half length, growth
/// of adhesion tractions to the parabolic bound at the strip's middle over the half length.
struct SurfaceStripsTask : StripFastsimMarch {
  const double *width, *half_length;  ///< [m]
  const double* bound;                ///< traction bound at the strip's middle [Pa]
  const double *growth_x, *growth_y;  ///< growth of adhesion tractions at the strip's middle
  const double* curvature;            ///< their growth along y changes by 2 curvature per half length
  const double *slip_x, *slip_y;      ///< rigid slip at the strip's middle [-], torsion included
  const double* spin;                 ///< [1/m]
  const double* elastic;              ///< elastic slip at the leading edge: difference between x and y [-]
  const double *turn_x, *turn_y;      ///< flexibilities that turn the slip, times bound over half length [-]
  const double *edge_x, *edge_y;      ///< elastic slip at the leading edge, for fields [-]
  const double* across;               ///< factor on the slip at each strip's place across, for fields [-]
  const double* beside;               ///< b k of methods/slip_across.hpp, k by the mean spin, for fields [-]
  double *fx, *fy, *mz;               ///< results: force [N], moment about the strip's middle [N m]
  const double *rigid_x, *rigid_y;    ///< slip without torsion, for the balance of power [-]
};

/// Numbers that the forces of one of these strips depend on, besides its size and bound, to which they are
/// proportional.
enum SurfaceStripInput : std::int32_t {
  strip_growth_x,
  strip_growth_y,
  strip_curvature,
  strip_slip_x,
  strip_slip_y,
  strip_spin,  ///< times the half length
  strip_elastic,
  strip_turn_x,
  strip_turn_y,
  strip_inputs
};

/// Forces of the strips and their derivatives: element ((input * 3 + force), strip j) at
/// ((input * 3 + force) * strips + j), force of fx, fy, mz.
struct SurfaceStripsSlopesTask : SurfaceStripsTask {
  double* slopes;
};

/// A strip that remembers, in a part of a step (methods/patch_memory.hpp).
struct RememberingStrip {
  /// Tractions as the bodies bring them [Pa], and the share of the part for which a cell was in contact.
  double px[tangential::memory_cells], py[tangential::memory_cells], share[tangential::memory_cells];
  double bound[tangential::memory_cells];  ///< bounds of the tractions at the end of the step [Pa]
  double had[tangential::memory_cells];    ///< those before it; until then of one patch, with their sum [Pa]
  double bounds;                           ///< sum of the former [Pa]
  double centre, half_length;              ///< [m]
  double area;                             ///< area of a cell [m^2]
  double arm;                              ///< the factor on arms of its moments [-]
  double kept;                             ///< share of its tractions of before [-]
  double y, x;                             ///< its middle, from where motions are counted about [m]
  double growth_x, growth_y;               ///< 1 / L [Pa/m]
  double turns;                            ///< by which tractions turn faster as cells slide
  double own_x, own_y, own_turn;           ///< displacements beyond the yield per length [-], [1/m]
};

/// Bounds of cells from the share r of the area where pressure is larger: x = r / (1 - q + q r), the bound is
/// (1 - x) (middle + by_x x + by_x2 x^2).
struct MemoryBoundsTask {
  const double* parabola;  ///< 1 - the square of the cells' places
  const double* larger;    ///< share of the area of larger pressure, at squares 0, 1, 2 .. of pressures
  double share;            ///< q
  double middle, by_x, by_x2;
};

/// Where a strip's tractions come from: a past strip of half the length `half_length`, in `px`, `py`; over h
/// [m].
struct MemoryBringTask {
  const double *place, *px, *py;
  double old_lead, half_length;  ///< [m]
  double h, weight;
  bool adds;  ///< true: adds to the cells' tractions; false: replaces them
};

/// Cells displaced by `local` [m], [m], [rad] and by `travel` times their own [m]. Tractions go to px and 16
/// behind it, forces of each strip to force[0..2], `stride` from strip to strip.
struct MemoryPassTask {
  std::int32_t strips;
  const RememberingStrip* from;
  const double* place;  ///< middles of the cells over the half length
  double local[3];
  double h;        ///< rolled [m]
  double travel;   ///< [m]
  double to_come;  ///< share of the step that comes after [-]
  double *px, *force;
  std::int64_t stride;
};

/// Force [N], [N], [N m] of all strips, and its negative derivatives by the displacement.
struct MemoryPassSums {
  double force[3], slope[3][3];
};

/// Cells in steady rolling at displacements `per` length, brought over h; results as of MemoryPassTask.
struct MemoryMarchTask {
  std::int32_t strips;
  const RememberingStrip* from;
  const double* place;  ///< middles of the cells over the half length
  double per[3];
  double h;  ///< [m]
  double *px, *force;
  std::int64_t stride;
};

}  // namespace wrc::simd
