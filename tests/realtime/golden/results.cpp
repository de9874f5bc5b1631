/// Results into the hash, member by member: padding and struct sizes stay out of it, so that structs may
/// grow.
#include "test_config.hpp"
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
  for (int32_t number : {strips, of.iterations, of.patches}) hash.add(number);
  for (double number : {ellipse.a, ellipse.b, ellipse.psi, normal_force, of.approach, of.stiffness})
    hash.add(number);
  for (double number : extent) hash.add(number);
}

}  // namespace

void hash_normal(const wrc_planar_normal_solution& of, Hash& hash) {
  hash_loaded(of, of.strips, of.ellipse, of.normal_force,
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

void hash_fields(const wrc_contact* contact, Hash& hash) {
  // STRIP_WEAR is left to the job that asks for wear numbers.
  for (int32_t patch = 0; patch < 16; ++patch) {
    for (int32_t field = WRC_FIELD_X; field < WRC_FIELD_STRIP_WEAR; ++field) {
      wrc_view view{};
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

void hash_step(wrc_contact* contact, int32_t status, const wrc_planar_output& output, Hash& hash) {
  hash.add(status);
  hash_point(output.point, hash);
  hash_normal(output.normal, hash);
  hash_forces(output.forces, hash);
  hash_damage(output.damage, hash);
  hash_fields(contact, hash);
  for (int32_t k = 0; k < output.normal.patch_count; ++k) {
    wrc_patch one = sized<wrc_patch>();
    if (wrc_contact_patch(contact, k, &one) < 0) break;
    hash_loaded(output.normal, one.strips, one.ellipse, one.ellipse.normal_force,
                {one.peak_pressure, one.area, one.length, one.width, one.y_min, one.y_max}, hash);
    hash_forces(one.forces, hash);
  }
}
