/// Effects of a solution's tractions on the bodies: damage, wear, temperatures, stresses, and their sums
/// along the line.
///
/// Asked by the index of a region (contact/region.hpp) of the newest solution, of the stages or of a wheel on
/// a rail. Nothing in the contact changes but its work space.
#pragma once

#include <cstdint>

#include "contact/region.hpp"
#include "damage/bins.hpp"
#include "damage/stress.hpp"
#include "damage/wear.hpp"
#include "tangential/friction/flash_temperature.hpp"

namespace wrc::contact {

/// Why the stages' tractions cannot be used: none are solved yet, the method gives none (then `why_not` is
/// the sentence), or there is no contact.
Fault tractions_needed(const Contact& contact, const char* why_not);

/// With all_regions, fatigue is that of the patch nearest to damage. Without tractions the numbers over cells
/// are 0.
Fault region_damage(Contact& contact, std::int32_t index, DamageNumbers& damage);

/// Wear of one contact by the laws.
struct WearNumbers {
  double worn_area_rate = 0.0;                ///< by T-gamma [m^2/m]
  double largest_depth_rate = 0.0;            ///< Sheffield [m/m]
  double largest_depth_velocity = 0.0;        ///< Archard [m/s]
  double largest_power_depth_velocity = 0.0;  ///< power law [m/s]
};
Fault region_wear(Contact& contact, std::int32_t index, const damage::WearLaws& laws, WearNumbers& wear);

/// Temperatures in one contact.
struct TemperatureNumbers {
  double at_entry = 0.0;  ///< temperature of both surfaces at first touch [degC]
  double rise = 0.0, x = 0.0,
         y = 0.0;          ///< largest rise over at_entry, and its place as fields x and strip_y [K], [m]
  double mean_rise = 0.0;  ///< over the area [K]
  double wheel_heat = 0.0, rail_heat = 0.0;  ///< [W]
};
Fault region_temperature(Contact& contact, std::int32_t index, const tangential::BulkTemperatures& bulk,
                         TemperatureNumbers& temperature);

/// Largest stresses in one of the bodies.
struct BodyStresses {
  damage::StressPeaks surface, below;
};

/// At the surface, at `depths` (increasing; into `levels`, one for each, where not nullptr) and around the
/// largest of these. A wheel's region is laid flat along the rail's arc, y its arc length.
Fault region_stresses(Contact& contact, std::int32_t index, bool in_rail, const double* depths,
                      std::int32_t count, damage::StressPeaks* levels, BodyStresses& stresses);

/// A stretch of time during which the newest solution acts.
struct Accumulation {
  double duration = 0.0;  ///< [s]
  double distance = 0.0;  ///< along the track where it begins [m]
  damage::WearLaws wear;
  damage::WholeLifeLaw whole_life;
};

/// Sums added to each set of bins.
struct DamageTotals {
  double sum[damage::damage_sums] = {};
  double largest_pressure = 0.0, largest_traction = 0.0;  ///< [Pa]
};

/// Adds damage to the bins of wheel and rail (accumulation.cpp); nullptr: not wanted. The stages' frictional
/// power is assessed where it has not been.
Fault accumulate(Contact& contact, const Accumulation& accumulation, const damage::DamageBins* wheel,
                 const damage::DamageBins* rail, DamageTotals& totals);

}  // namespace wrc::contact
