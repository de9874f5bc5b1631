/// Results of a contact's newest solution by the index of a region, a patch of the stages or a region of a
/// wheel on a rail: its place, its load and forces, and fields over its strips and cells.
///
/// Nothing in the contact changes but its work space. Regions are counted from 0, by increasing y, or from
/// the gauge side of a rail. Faults: WRC_ERROR_SEQUENCE without a solution, or before the stage whose result
/// it is; WRC_ERROR_RANGE where there is no such region; WRC_ERROR_UNSUPPORTED where a method gives no
/// tractions.
#pragma once

#include <cstdint>

#include "contact/state.hpp"
#include "damage/wear.hpp"

namespace wrc::contact {

/// In the place of an index: all patches together. A wheel's regions have tractions in planes of their own.
inline constexpr std::int32_t all_regions = -1;

/// Patches of the stages, or regions of a wheel on a rail; 0 without a solution or contact.
std::int32_t region_count(const Contact& contact);

/// Does the newest solution have tractions and slips of cells?
bool has_tractions(const Contact& contact);

/// Cells along each strip of the newest solution.
std::int32_t cells_of_newest(const Contact& contact);

/// Is there such a region? `or_all`: all_regions may stand for all patches.
Fault check_region(const Contact& contact, std::int32_t index, bool or_all);

/// The equivalent double ellipse of a region: its joint at the initial contact point of a patch, where the
/// strips of a wheel are longest.
struct RegionEllipse {
  patch::Sdec sdec;
  double joint = 0.0;         ///< lateral place, or arc length [m]
  double normal_force = 0.0;  ///< sum of the strips' loads [N]
};

/// A region. Contact axes: x forward, y to the right in the contact plane, z into the rail; a wheel's strips
/// are laid flat along the rail's arc, and forces along that count along y.
struct RegionResult {
  bool placed = false;                 ///< is the place known? Of the stages with a pose and the normal stage
  bool rolled = false;                 ///< are the tangential forces known?
  bool adhesion_known = false;         ///< is the adhesion fraction known?
  std::int32_t strips = 0, cells = 0;  ///< cells along each strip
  std::int32_t face = 0;               ///< number of the rail's surface

  // Place; of the stages with a pose.
  /// In track axes, x from the reference point [m]: a wheel's centre of pressure, a patch's joint in the
  /// contact plane.
  double point[3] = {};
  double normal[3] = {};                 ///< into the rail, of unit length, track axes
  double angle = 0.0;                    ///< about x from the track's z to the normal [rad]
  RegionPlace place;                     ///< on both bodies' profiles
  double rolling_radius = 0.0;           ///< radius of the wheel there [m]
  double force[3] = {}, moment[3] = {};  ///< on the wheel, moment about `point`, track axes [N], [N m]

  // Load and forces.
  patch::StripTotals extent;  ///< its strips'; y as RegionEllipse::joint
  RegionEllipse ellipse;
  double normal_force = 0.0;  ///< resultant of the pressure [N]
  /// Sums of the strips' own along x and y; mz of a wheel about the normal through `point`, of a patch about
  /// the origin of the contact frame.
  tangential::TangentialForces tangential;
  tangential::Creepage creepage;  ///< means over a wheel's load; of a patch those at the origin of the frame
  double rolling_speed = 0.0;     ///< speed that creepages are divided by, < 0 backwards [m/s]
  double power = 0.0;             ///< frictional [W]
};

/// WRC_FLAG_TABLE_RANGE where the ellipse's shape number was cut.
Fault find_region(Contact& contact, std::int32_t index, RegionResult& region);

/// Elements that a field has values over.
enum class FieldOver { cells, strips, gap_rows };

/// Result that a field needs: strips of any solution; strips that rolled; tractions in their cells; strips of
/// a wheel; rows of the stages' gap.
enum class FieldNeeds { strips, rolling, tractions, wheel, gap };

/// Every field: name, elements it has values over, result it needs.
#define WRC_FIELDS(FIELD)                   \
  FIELD(x, cells, strips)                   \
  FIELD(pressure, cells, strips)            \
  FIELD(traction_x, cells, tractions)       \
  FIELD(traction_y, cells, tractions)       \
  FIELD(slip_x, cells, tractions)           \
  FIELD(slip_y, cells, tractions)           \
  FIELD(power_density, cells, tractions)    \
  FIELD(fatigue_index, cells, tractions)    \
  FIELD(temperature_rise, cells, tractions) \
  FIELD(strip_y, strips, strips)            \
  FIELD(strip_width, strips, strips)        \
  FIELD(strip_centre, strips, strips)       \
  FIELD(strip_half_length, strips, strips)  \
  FIELD(strip_peak, strips, strips)         \
  FIELD(strip_power, strips, tractions)     \
  FIELD(strip_friction, strips, rolling)    \
  FIELD(strip_wear, strips, tractions)      \
  FIELD(strip_profile_y, strips, wheel)     \
  FIELD(strip_profile_z, strips, wheel)     \
  FIELD(strip_angle, strips, wheel)         \
  FIELD(gap_y, gap_rows, gap)               \
  FIELD(gap_height, gap_rows, gap)          \
  FIELD(gap_centre, gap_rows, gap)          \
  FIELD(gap_curvature, gap_rows, gap)

enum class FieldId : std::int32_t {
#define WRC_FIELD(name, over, needs) name,
  WRC_FIELDS(WRC_FIELD)
#undef WRC_FIELD
      count_
};

/// Values of a field: those of cell i of strip j, or of row j, at j * cells + i, cell 0 at the leading edge.
struct FieldSize {
  std::int32_t rows = 0;   ///< strips, or rows of the gap
  std::int32_t cells = 1;  ///< along each
};

/// Size of a field; for rows of the gap the index does not matter.
Fault region_field_size(const Contact& contact, std::int32_t index, FieldId field, FieldSize& size);

/// Writes rows * cells values. `wear`: the law that strip_wear follows.
Fault region_field(Contact& contact, std::int32_t index, FieldId field, const damage::SheffieldWearLaw& wear,
                   double* values);

}  // namespace wrc::contact
