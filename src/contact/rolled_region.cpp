#include "contact/rolled_region.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "contact/stages.hpp"

namespace wrc::contact {

StripRun strip_run(const surface::StripResults& kept, const surface::SurfaceRegion& region) {
  const auto all = static_cast<std::int32_t>(kept.head->count);
  StripRun run;
  // strips of results increase by number, and a region is a run of them
  while (run.first < all && kept.strip[run.first] < region.first) ++run.first;
  while (run.first + run.count < all && kept.strip[run.first + run.count] < region.first + region.count)
    ++run.count;
  return run;
}

std::int32_t touching_strips(const Contact& contact, damage::TouchingStrip* strips) {
  const surface::StripResults kept = surface_state(contact).kept;
  const std::int32_t count = static_cast<std::int32_t>(kept.head->count);
  double power = 0.0, longest = 0.0;  // [W], [m]
  for (std::int32_t k = 0; k < count; ++k) {
    power += std::max(kept.power[k], 0.0);
    longest = std::max(longest, kept.half_length[k]);
  }
  // by y of both profiles: places and half widths [m], shares of power and of length [-]
  for (std::int32_t k = 0; k < count; ++k) {
    constexpr double rounding = 1e-9;  // keeps half widths above 0 [m]
    const double advance = std::abs(sine_cosine(kept.angle[k]).cosine);
    strips[k] = {.y = {kept.y[k], kept.y_wheel[k]},
                 .half_width = 0.5 * kept.width[k] * advance + rounding,
                 .energy = power > 0.0 ? std::max(kept.power[k], 0.0) / power : 0.0,
                 .share = kept.half_length[k] / longest};
  }
  return count;
}

RolledRegion::RolledRegion(Contact& contact, const Patch& patch)
    : strips(patch_strips(contact, patch)),
      grid(&contact.model->march_grid),
      speed(contact.rolling.speed),
      direction(contact.reached >= Stage::tangential ? contact.rolling.direction : 1.0) {
  // pressed alone, or rolled by a method without tractions: strips and no cells
  if (contact.reached < Stage::tangential || !gives_fields(contact)) return;
  strips = region_strips(contact, patch);
  find_cells(contact);
  fields = cell_fields(contact, patch);
  friction = array(contact, Array::strip_friction) + patch.region_first;
  // the work space of the contact: two numbers per cell, one per strip
  const std::int32_t all = strips.count * cells();
  work.power_density = work_space(contact);
  work.fatigue_index = work.power_density + all;
  work.strip_power = work.fatigue_index + all;
}

RolledRegion::RolledRegion(Contact& contact, const surface::SurfaceRegion& region, bool with_cells)
    : grid(&contact.model->surface_grid) {
  const surface::StripResults kept = surface_state(contact).kept;
  const auto [first, count] = strip_run(kept, region);
  strips = {count,
            count,
            kept.place + first,
            kept.width + first,
            kept.centre + first,
            kept.half_length + first,
            kept.peak + first};
  friction = kept.friction + first;
  profile_y = kept.y + first;
  profile_z = kept.z + first;
  angle = kept.angle + first;
  speed = kept.head->speed;
  direction = kept.head->backwards > 0.0 ? -1.0 : 1.0;
  if (!with_cells || kept.head->by_region > 0.0) return;
  const surface::StripFields rolled =
      surface::fields_of_strips(*contact.model->surface, kept, first, count, work_space(contact));

  // beyond the deepest overlap solved tractions grow as the load does; slips stay
  for (double* const a : {rolled.traction_x, rolled.traction_y})
    for (std::int32_t at = 0; at < rolled.strips * rolled.cells; ++at) a[at] *= kept.head->factor;
  fields = {rolled.traction_x, rolled.traction_y, rolled.slip_x, rolled.slip_y};
  work = {rolled.slip_x, rolled.slip_y, rolled.of_strips};
}

}  // namespace wrc::contact
