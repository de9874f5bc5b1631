/// Results into the hash, member by member: padding and struct sizes stay out of it, so that structs may
/// grow.
#include "field_values.hpp"
#include "golden/plan.hpp"

void hash_point(const wrc_planar_point& point, Hash& hash) {
  for (double number : {point.x, point.y, point.z, point.y_wheel, point.y_rail, point.angle,
                        point.vertical_gap, point.rolling_radius})
    hash.add(number);
}

namespace {

/// `of`: what the numbers that a patch shares with its contact are taken from.
void hash_loaded(const wrc_planar_normal_solution& of, int32_t strips, const wrc_ellipse& ellipse,
                 double normal_force, const double (&extent)[6], Hash& hash) {
  for (int32_t number : {strips, of.iterations, of.patch_count}) hash.add(number);
  for (double number : {ellipse.a, ellipse.b, ellipse.psi, normal_force, of.approach, of.stiffness})
    hash.add(number);
  for (double number : extent) hash.add(number);
}

}  // namespace

void hash_normal(const wrc_planar_normal_solution& of, Hash& hash) {
  hash_loaded(of, of.strip_count, of.ellipse, of.normal_force,
              {of.peak_pressure, of.area, of.length, of.width, of.y_min, of.y_max}, hash);
}

void hash_forces(const wrc_planar_forces& forces, Hash& hash) {
  for (double number : {forces.fx, forces.fy, forces.fn, forces.mz, forces.power, forces.adhesion_fraction})
    hash.add(number);
}

void hash_damage(const wrc_damage& damage, Hash& hash) {
  // What stood for "not available" when the hashes were written.
  const bool tractions = (damage.available & WRC_AVAILABLE_TRACTIONS) != 0 || damage.load_factor == 0.0;
  for (double number : {damage.power, damage.peak_power_density, damage.t_gamma, damage.t_gamma_no_spin,
                        damage.utilisation, damage.load_factor, damage.shakedown_limit, damage.fatigue_index,
                        tractions ? damage.local_fatigue_index : -1e30})
    hash.add(number);
}

namespace {

/// The fields that hashes are of, in the order in which they have always been added, and the stage that must
/// have come before: none is added from before it.
constexpr struct {
  int32_t field;
  Reached stage;
} hashed_fields[] = {{WRC_FIELD_X, Reached::tangential},
                     {WRC_FIELD_PRESSURE, Reached::tangential},
                     {WRC_FIELD_TRACTION_X, Reached::tangential},
                     {WRC_FIELD_TRACTION_Y, Reached::tangential},
                     {WRC_FIELD_SLIP_X, Reached::tangential},
                     {WRC_FIELD_SLIP_Y, Reached::tangential},
                     {WRC_FIELD_POWER_DENSITY, Reached::damage},
                     {WRC_FIELD_FATIGUE_INDEX, Reached::damage},
                     {WRC_FIELD_STRIP_Y, Reached::gap},
                     {WRC_FIELD_STRIP_WIDTH, Reached::gap},
                     {WRC_FIELD_STRIP_CENTRE, Reached::gap},
                     {WRC_FIELD_STRIP_HALF_LENGTH, Reached::gap},
                     {WRC_FIELD_STRIP_PEAK, Reached::gap},
                     {WRC_FIELD_STRIP_POWER, Reached::damage},
                     {WRC_FIELD_GAP_Y, Reached::gap},
                     {WRC_FIELD_GAP_HEIGHT, Reached::gap},
                     {WRC_FIELD_GAP_CENTRE, Reached::gap},
                     {WRC_FIELD_GAP_CURVATURE, Reached::gap}};

}  // namespace

void hash_fields(wrc_contact* contact, Hash& hash, bool tractions, Reached reached) {
  constexpr int32_t most_patches = 16;
  bool apart = false;  // there is no patch: the rows of the gap are added again and again
  for (int32_t patch = 0; patch < most_patches; ++patch) {
    for (const auto& [field, stage] : hashed_fields) {
      const bool of_tractions = stage >= Reached::tangential;
      if (of_tractions && !tractions) {
        hash.add(int32_t{WRC_ERROR_UNSUPPORTED});
        continue;
      }
      const FieldValues found = field_values(contact, patch, field);
      int32_t status = found.status;
      apart = apart || (status == WRC_ERROR_RANGE && patch == 0);
      if (status == WRC_ERROR_RANGE && !apart) return;  // no further patch
      if (status == WRC_ERROR_RANGE || stage > reached) status = WRC_ERROR_SEQUENCE;
      hash.add(status);
      if (status < 0) continue;
      for (std::uint64_t i = 0; i < found.cells; ++i)
        for (std::uint64_t j = 0; j < found.strips; ++j) hash.add(found.at(i, j));
    }
  }
}

void hash_step(wrc_contact* contact, int32_t status, const wrc_planar_output& output, bool tractions,
               Hash& hash) {
  hash.add(status);
  hash_point(output.point, hash);
  hash_normal(output.normal, hash);
  hash_forces(output.forces, hash);
  hash_damage(output.damage, hash);
  hash_fields(contact, hash, tractions);
  for (int32_t k = 0; k < output.normal.patch_count; ++k) {
    wrc_region one = sized<wrc_region>();
    if (wrc_contact_region(contact, k, &one) < 0) break;
    hash_loaded(output.normal, one.strip_count, one.ellipse, one.ellipse.normal_force,
                {one.peak_pressure, one.area, one.length, one.width, one.y_min, one.y_max}, hash);
    for (double number : {one.longitudinal_force, one.lateral_force, one.normal_force, one.spin_moment,
                          one.power, one.adhesion_fraction})
      hash.add(number);
  }
}
