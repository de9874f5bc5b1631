/// Results into the hash, member by member: padding and struct sizes stay out of it, so that structs may
/// grow.
#include "golden/plan.hpp"

void hash_point(const wrc_contact_point& point, Hash& hash) {
  for (double number : {point.x, point.y, point.z, point.y_wheel, point.y_rail, point.angle,
                        point.vertical_gap, point.rolling_radius})
    hash.add(number);
}

void hash_patch(const wrc_patch& patch, Hash& hash) {
  for (int32_t number : {patch.strips, patch.iterations, patch.patches}) hash.add(number);
  for (double number : {patch.a, patch.b, patch.psi, patch.normal_force, patch.approach, patch.stiffness,
                        patch.peak_pressure, patch.area, patch.length, patch.width, patch.y_min, patch.y_max})
    hash.add(number);
}

void hash_forces(const wrc_forces& forces, Hash& hash) {
  for (double number : {forces.fx, forces.fy, forces.fn, forces.mz, forces.power, forces.adhesion_fraction})
    hash.add(number);
}

void hash_damage(const wrc_damage& damage, Hash& hash) {
  for (double number :
       {damage.power, damage.peak_power_density, damage.t_gamma, damage.t_gamma_no_spin, damage.utilisation,
        damage.load_factor, damage.shakedown_limit, damage.fatigue_index, damage.local_fatigue_index})
    hash.add(number);
}

void hash_fields(const wrc_contact* contact, Hash& hash) {
  // STRIP_WEAR is left to the job that asks for wear numbers.
  for (int32_t patch = 0; patch < 16; ++patch) {
    for (int32_t field = WRC_FIELD_X; field < WRC_FIELD_STRIP_WEAR; ++field) {
      wrc_view view = made<wrc_view>(wrc_view_init);
      const int32_t status = wrc_contact_field(contact, patch, field, &view);
      if (status == WRC_ERROR_RANGE) return;  // no further patch
      hash.add(status);
      for (std::uint64_t i = 0; i < view.count[0]; ++i) {
        for (std::uint64_t j = 0; j < view.count[1]; ++j)
          hash.add(view.data[i * view.stride[0] + j * view.stride[1]]);
      }
    }
  }
}

void hash_step(wrc_contact* contact, int32_t status, const wrc_contact_point& point, const wrc_patch& patch,
               const wrc_forces& forces, const wrc_damage& damage, Hash& hash) {
  hash.add(status);
  hash_point(point, hash);
  hash_patch(patch, hash);
  hash_forces(forces, hash);
  hash_damage(damage, hash);
  hash_fields(contact, hash);
  for (int32_t k = 0; k < patch.patches; ++k) {
    wrc_patch one = made<wrc_patch>(wrc_patch_init);
    wrc_forces its = made<wrc_forces>(wrc_forces_init);
    if (wrc_contact_patch(contact, k, &one, &its) < 0) break;
    hash_patch(one, hash);
    hash_forces(its, hash);
  }
}
