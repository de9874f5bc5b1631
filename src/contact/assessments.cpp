/// Effects of a solution's tractions on the bodies: damage, wear, temperatures, stresses. Calls by index
/// leave the contact as it is; the stage of damage takes all patches and keeps the power of their strips.
#include "contact/assessments.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rolled_region.hpp"
#include "contact/stages.hpp"
#include "contact/temperature_sums.hpp"
#include "damage/cells.hpp"
#include "damage/fatigue.hpp"
#include "damage/frictional_power.hpp"
#include "damage/subsurface.hpp"

namespace wrc::contact {
namespace {

constexpr const char* no_power = "this method has no power over the patch: choose another";
constexpr const char* no_wear = "this method has no tractions to wear by: choose another, or use T-gamma";
constexpr const char* no_stresses = "this method has no tractions over the patch: choose another";

/// Patches from first to end - 1: one, or all.
struct PatchRange {
  std::int32_t first = 0, end = 0;

  PatchRange(const Contact& contact, std::int32_t index)
      : first(index == all_regions ? 0 : index), end(index == all_regions ? contact.patches : index + 1) {}
};

/// Calls use(RolledRegion&) for the region, or for every patch.
template <class Use>
void for_regions(Contact& contact, std::int32_t index, Use&& use) {
  if (contact.newest == Solution::wheel) {
    RolledRegion rolled(contact, contact.wheel.wrench.region[index]);
    return use(rolled);
  }
  const PatchRange range(contact, index);
  for (std::int32_t k = range.first; k < range.end; ++k) {
    RolledRegion rolled(contact, contact.patch[k]);
    use(rolled);
  }
}

/// Refuses stages that have not rolled, and flags bodies that are apart.
Fault rolling_needed(const Contact& contact) {
  if (contact.reached < Stage::tangential) {
    return Fault::sequence("forces", "call wrc_planar_tangential first");
  }
  if (!contact.touching) return Fault::no_contact();
  return {};
}

/// Why the tractions of a region cannot be used; `why_not`: see tractions_needed().
Fault region_tractions_needed(const Contact& contact, std::int32_t index, const char* why_not) {
  const Fault fault = check_region(contact, index, true);
  if (fault.status != WRC_OK) return fault;
  if (contact.newest == Solution::stages) return tractions_needed(contact, why_not);
  if (has_tractions(contact)) return {};
  return Fault::unsupported("config.tangential.method",
                            "patches rolled as a whole: their strips have no tractions");
}

// ----------------------------------------------------------------------------------------------------------
// damage

/// Copies a point of the shakedown map, its limit and its fatigue index.
void place_in_map(const damage::ShakedownPoint& point, DamageNumbers& damage) {
  damage.fatigue_index = damage::fatigue_index(point);
  damage.utilisation = point.utilised_friction;
  damage.load_factor = point.load_factor;
  damage.shakedown_limit = damage::shakedown_limit(point.utilised_friction);
}

/// Damage of one patch or all; `into(patch, rolled)`: arrays for numbers over a patch's cells.
template <class Into>
DamageNumbers damage_of_patches(Contact& contact, std::int32_t index, Into&& into) {
  // Power and T-gamma are sums over the patches; indices are those of the worst cell and the worst patch.
  const ModelOptions& options = contact.model->options;
  const bool with_cells = gives_fields(contact);
  DamageNumbers damage;
  if (with_cells) damage.local_fatigue_index = damage::no_fatigue_index;
  const PatchRange range(contact, index);
  for (std::int32_t k = range.first; k < range.end; ++k) {
    // Power [W] and the largest numbers of the cells; without cells the power of the patch as a whole.
    const Patch& patch = contact.patch[k];
    if (with_cells) {
      const RolledRegion rolled(contact, patch);
      const damage::CellDamage found = assess(contact, rolled, into(patch, rolled));
      damage.power += found.power;
      damage.peak_power_density = std::max(damage.peak_power_density, found.peak_power_density);
      damage.local_fatigue_index = std::max(damage.local_fatigue_index, found.fatigue_index);
    } else {
      damage.power += patch.forces.power_per_speed * contact.rolling.speed;
    }

    // Methods that spread the load over the equivalent ellipse have that ellipse's peak pressure.
    const double peak =
        options.patch_model.on_ellipse
            ? patch::peak_pressure({patch.sdec.a, patch.sdec.b, 0.0}, patch.extent.normal_force)
            : patch.extent.peak_pressure;
    const damage::ShakedownPoint point =
        damage::shakedown_point(patch.forces, patch.extent.normal_force, peak, options.shear_yield);
    // With several patches the point in the map is that of the one nearest to damage.
    if (k == range.first || damage::fatigue_index(point) > damage.fatigue_index) place_in_map(point, damage);
  }
  // T-gamma of the sums [N].
  const tangential::TangentialForces& forces =
      index == all_regions ? contact.forces : contact.patch[range.first].forces;
  damage.t_gamma = damage::t_gamma(forces);
  damage.t_gamma_no_spin = damage::t_gamma_without_spin(forces, contact.creepage);
  return damage;
}

/// Damage of a wheel's region: resultants of its strips in the plane of contact, then its cells.
DamageNumbers damage_of_wheel(Contact& contact, std::int32_t index) {
  // T-gamma and the point of the shakedown map take the strips' resultants, not the cells.
  const WheelSums sums = wheel_sums(contact, index);
  DamageNumbers damage;
  damage.power = contact.wheel.wrench.region[index].power;
  damage.t_gamma = damage::t_gamma(sums.forces);
  damage.t_gamma_no_spin = damage::t_gamma_without_spin(sums.forces, sums.creepage);
  place_in_map(damage::shakedown_point(sums.forces, sums.extent.normal_force, sums.extent.peak_pressure,
                                       contact.model->options.shear_yield),
               damage);
  // A region rolled as a whole has no cells: their numbers stay 0.
  if (!has_tractions(contact)) return damage;
  const RolledRegion rolled(contact, contact.wheel.wrench.region[index]);
  const damage::CellDamage found = assess(contact, rolled, rolled.work);
  damage.peak_power_density = found.peak_power_density;
  damage.local_fatigue_index = found.fatigue_index;
  return damage;
}

// ----------------------------------------------------------------------------------------------------------
// wear

/// Frictional power density over the speed, -s . p, in a cell [N/m^2]. It is not negative in theory; the
/// march may leave a trace of the other sign beside a stick zone.
double work_in(const tangential::TangentialFields& fields, std::int32_t at) {
  return std::max(0.0,
                  -(fields.slip_x[at] * fields.traction_x[at] + fields.slip_y[at] * fields.traction_y[at]));
}

/// Largest wear rates over the cells of one region; `per_width`: volume by Sheffield's law, one number per
/// strip [m^3/m per m].
void add_wear(const RolledRegion& rolled, const damage::WearLaws& laws, double* per_width,
              WearNumbers& wear) {
  // Depth rate [m/m] by Sheffield's law, depth velocities [m/s] by the two others; the largest cell counts.
  const tangential::TangentialFields& fields = rolled.fields;
  const auto most = [](double& largest, double value) { largest = std::max(largest, value); };
  for (std::int32_t j = 0; j < rolled.strips.count; ++j) {
    per_width[j] = worn_of_strip(rolled, laws.sheffield, j, wear.largest_depth_rate);
    for (std::int32_t i = 0; i < rolled.cells(); ++i) {
      // Power law: V |s . p|; Archard's: pressure times sliding speed V |s|.
      const std::int32_t at = i * rolled.strips.count + j;
      const double sx = fields.slip_x[at], sy = fields.slip_y[at];
      most(wear.largest_power_depth_velocity,
           damage::wear_depth_velocity(laws.power, rolled.speed * work_in(fields, at)));
      most(wear.largest_depth_velocity,
           damage::wear_depth_velocity(laws.archard, rolled.pressure(i, j),
                                       rolled.speed * std::sqrt(sx * sx + sy * sy)));
    }
  }
}

/// Cross section worn off per distance rolled [m^2/m] by T-gamma [N].
double worn_area(const Contact& contact, const damage::WearLaws& laws, double t_gamma) {
  return damage::worn_area_rate(laws.t_gamma, t_gamma, 2.0 * contact.model->options.wheelset.nominal_radius);
}

// ----------------------------------------------------------------------------------------------------------
// temperatures

TemperatureSums temperature_sums(const Contact& contact, const tangential::BulkTemperatures& bulk,
                                 double speed) {
  const ModelOptions& options = contact.model->options;
  return {options.effusivities, bulk, cells_of_newest(contact), speed};
}

void add_temperature(const RolledRegion& rolled, double* rise, TemperatureSums& sums) {
  sums.add(rolled.strips, rolled.fields, rise,
           [&](std::int32_t i, std::int32_t j) { return rolled.x(i, j); });
}

// ----------------------------------------------------------------------------------------------------------
// stresses

/// Largest stresses at the depths, and around the largest of these.
BodyStresses stresses_under(const damage::LoadLanes& loads, const double* depths, std::int32_t count,
                            damage::StressPeaks* levels) {
  BodyStresses stresses;
  stresses.surface = loads.peaks(0.0);
  double deepest = 0.0;
  // Largest value of each of the three numbers below the surface, bracketed by the listed depths on both
  // sides of it.
  constexpr damage::StressPeak damage::StressPeaks::*each[3] = {
      &damage::StressPeaks::von_mises, &damage::StressPeaks::shear, &damage::StressPeaks::tension};
  double low[3] = {}, high[3] = {};
  for (std::int32_t k = 0; k < count; ++k) {
    const damage::StressPeaks found = depths[k] > 0.0 ? loads.peaks(depths[k]) : stresses.surface;
    if (levels) levels[k] = found;
    if (!(depths[k] > 0.0)) continue;
    for (int number = 0; number < 3; ++number) {
      if (high[number] == deepest) high[number] = depths[k];  // the largest so far was the depth before
      if (stresses.below.any && !((found.*each[number]).value > (stresses.below.*each[number]).value))
        continue;
      low[number] = deepest;
      high[number] = depths[k];
    }
    stresses.below.take(found);
    deepest = depths[k];
  }
  // Between the listed depths the largest is refined by golden sections beneath its place.
  const damage::StressPeaks listed = stresses.below;
  for (int number = 0; number < 3 && listed.any; ++number)
    loads.refine(listed.*each[number], each[number], low[number], high[number], stresses.below);
  return stresses;
}

/// Body and depths of a search for stresses.
struct StressTask {
  bool in_rail;
  const double* depths;
  std::int32_t count;
  damage::StressPeaks* levels;

  damage::LoadLanes lanes(const Contact& contact) const {
    const ModelOptions& options = contact.model->options;
    return {in_rail ? options.rail_poisson : options.wheel_poisson, *contact.model->kernels};
  }
  /// strips_of_all: number of strips of all regions that are added.
  void add(const RolledRegion& rolled, std::int32_t strips_of_all, damage::LoadLanes& loads) const {
    loads.add_patch(rolled.strips, rolled.grid->middles.pressure, rolled.fields, rolled.cells(),
                    strips_of_all, rolled.direction, in_rail ? -1.0 : 1.0);  // tractions act on the wheel
  }
};

BodyStresses stresses_of_patches(Contact& contact, std::int32_t index, const StressTask& task) {
  const PatchRange range(contact, index);
  std::int32_t strips = 0;
  // Lanes are shared out among the patches by their numbers of strips.
  for (std::int32_t k = range.first; k < range.end; ++k) strips += contact.patch[k].region_count;
  damage::LoadLanes loads = task.lanes(contact);
  for (std::int32_t k = range.first; k < range.end; ++k)
    task.add(RolledRegion(contact, contact.patch[k]), strips, loads);
  return stresses_under(loads, task.depths, task.count, task.levels);
}

BodyStresses stresses_of_wheel(Contact& contact, std::int32_t index, const StressTask& task) {
  // The region marches before the lanes are made: each of the two takes half of the stack that a call may
  // use.
  const RolledRegion rolled(contact, contact.wheel.wrench.region[index]);
  damage::LoadLanes loads = task.lanes(contact);
  task.add(rolled, rolled.strips.count, loads);
  return stresses_under(loads, task.depths, task.count, task.levels);
}

}  // namespace

damage::CellDamage assess(const Contact& contact, const RolledRegion& rolled, const CellNumbers& into) {
  const Model& model = *contact.model;
  return damage::assess_cells({.region = &rolled.strips,
                               .fields = &rolled.fields,
                               .middles = &rolled.grid->middles,
                               .cells = rolled.cells(),
                               .speed = rolled.speed,
                               .shear_yield = model.options.shear_yield,
                               .power_density = into.power_density,
                               .fatigue_index = into.fatigue_index,
                               .strip_power = into.strip_power},
                              *model.kernels);
}

double worn_of_strip(const RolledRegion& rolled, const damage::SheffieldWearLaw& law, std::int32_t strip,
                     double& largest) {
  // Depth rates of the cells [m/m], all of one length 2 L / cells.
  double sum = 0.0;
  for (std::int32_t i = 0; i < rolled.cells(); ++i) {
    const double rate = damage::wear_depth_rate(law, work_in(rolled.fields, i * rolled.strips.count + strip));
    sum += rate;
    largest = std::max(largest, rate);
  }
  return sum * 2.0 * rolled.strips.half_length[strip] / rolled.cells();
}

// ----------------------------------------------------------------------------------------------------------
// by index

Fault region_damage(Contact& contact, std::int32_t index, DamageNumbers& damage) {
  damage = {};
  Fault fault = check_region(contact, index, true);
  if (fault.status != WRC_OK) return fault;
  if (contact.newest == Solution::wheel) {
    damage = damage_of_wheel(contact, index);
    return {};
  }
  // Numbers over cells go to work space: the stage's own results stay.
  if (fault = rolling_needed(contact); fault.status != WRC_OK) return fault;
  damage =
      damage_of_patches(contact, index, [](const Patch&, const RolledRegion& rolled) { return rolled.work; });
  return {};
}

Fault region_wear(Contact& contact, std::int32_t index, const damage::WearLaws& laws, WearNumbers& wear) {
  wear = {};
  const Fault fault = region_tractions_needed(contact, index, no_wear);
  if (fault.status != WRC_OK) return fault;
  // Resultants of the region, or of all patches.
  const tangential::TangentialForces forces = contact.newest == Solution::wheel
                                                  ? wheel_sums(contact, index).forces
                                              : index == all_regions ? contact.forces
                                                                     : contact.patch[index].forces;
  // T-gamma takes the resultants, the other laws take the cells.
  wear.worn_area_rate = worn_area(contact, laws, damage::t_gamma(forces));
  for_regions(contact, index,
              [&](RolledRegion& rolled) { add_wear(rolled, laws, rolled.work.strip_power, wear); });
  return {};
}

Fault region_temperature(Contact& contact, std::int32_t index, const tangential::BulkTemperatures& bulk,
                         TemperatureNumbers& temperature) {
  // The rise of each cell goes to the work space of its power; sums run over all regions asked for.
  temperature = {};
  const Fault fault = region_tractions_needed(contact, index, no_power);
  if (fault.status != WRC_OK) return fault;
  const bool wheel = contact.newest == Solution::wheel;
  TemperatureSums sums = temperature_sums(
      contact, bulk, wheel ? surface_state(contact).kept.head->speed : contact.rolling.speed);
  for_regions(contact, index,
              [&](RolledRegion& rolled) { add_temperature(rolled, rolled.work.power_density, sums); });
  temperature = sums.numbers();
  return {};
}

Fault region_stresses(Contact& contact, std::int32_t index, bool in_rail, const double* depths,
                      std::int32_t count, damage::StressPeaks* levels, BodyStresses& stresses) {
  stresses = {};
  const Fault fault = region_tractions_needed(contact, index, no_stresses);
  if (fault.status != WRC_OK) return fault;
  const StressTask task{in_rail, depths, count, levels};
  stresses = contact.newest == Solution::wheel ? stresses_of_wheel(contact, index, task)
                                               : stresses_of_patches(contact, index, task);
  return {};
}

// ----------------------------------------------------------------------------------------------------------
// stages

Fault tractions_needed(const Contact& contact, const char* why_not) {
  const Fault fault = rolling_needed(contact);
  if (fault.failed() || gives_fields(contact)) return fault;
  return Fault::unsupported("config.tangential.method", why_not);
}

Fault assess_damage(Contact& contact) {
  const Fault fault = rolling_needed(contact);
  if (!fault.failed()) contact.reached = Stage::damage;
  if (fault.status != WRC_OK) return fault;
  contact.damage =
      damage_of_patches(contact, all_regions, [&](const Patch& patch, const RolledRegion& rolled) {
        // The power of each strip per width [W/m] is kept for accumulate().
        CellNumbers into = rolled.work;
        into.strip_power = array(contact, Array::strip_power) + patch.region_first;
        return into;
      });
  return {};
}

}  // namespace wrc::contact
