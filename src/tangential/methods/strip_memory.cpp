#include "tangential/methods/strip_memory.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tangential/methods/strip_fastsim.hpp"

namespace wrc::tangential {
namespace {

Memory& memory_at(void* memory) { return *static_cast<Memory*>(memory); }

/// Lists of the patch: its strips are written behind those of the patches before.
PatchStrips strips_of(Memory& memory) {
  return {.past = memory.remembered(),
          .past_count = memory.count,
          .written = memory.other() + memory.written,
          .strips = memory.scratch()};
}

/// Keeps the patch's strips, as of bodies rolling forwards, with their parts of the energy and of the
/// difference to strip FASTSIM. Moments are about the strips' own middles.
void keep_strips(const RollingContact& contact, double energy, const double added[3], Memory& memory) {
  const double part = 1.0 / contact.region.count;
  PastStrip* const written = memory.other() + memory.written;
  for (std::int32_t j = 0; j < contact.region.count; ++j) {
    written[j].energy = energy * part;
    std::fill_n(written[j].slip, 3, 0.0);
    written[j].way = 0.0;
    for (int i = 0; i < 3; ++i) written[j].added[i] = added[i] * part;
    const RememberingStrip& at = memory.scratch()[j];
    std::copy_n(at.bound, std::size(written[j].bound), written[j].bound);
    double* const force = written[j].force;
    force[2] += at.y * force[0] - at.x * force[1];
    written[j] = turned(written[j], contact.memory.direction);
  }
  memory.written += contact.region.count;
}

/// Brings forces from the centre, with its longer arms, to the origin.
void refer_to_origin(const PatchNumbers& numbers, double of[3]) {
  of[2] += numbers.centre_x * of[1] - numbers.centre_y * of[0];
}

}  // namespace

std::size_t strip_memory_bytes(std::int32_t strips) {
  return Memory::bytes(strips, 3) + static_cast<std::size_t>(strips) * sizeof(RememberingStrip);
}

void make_strip_memory(std::int32_t strips, void* at) {
  memory_at(at) = {};
  memory_at(at).capacity = strips;
}

void begin_step(void* at) { memory_at(at).written = 0; }

void end_step(void* at) { memory_at(at).turn_over(); }

TangentialForces roll_with_memory(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                                  const MemoryFactors& factors) {
  Memory& memory = memory_at(contact.memory.at);
  const PatchNumbers numbers = patch_numbers(contact, fault, factors);
  YieldingPatch whole{.numbers = numbers, .end = contact.region.count};
  const PastOfPlane before = take_past_of_plane(contact, strips_of(memory), whole);
  std::for_each_n(memory.scratch(), contact.region.count, clear_strip);
  add_to_strips(contact, whole, factors, memory.scratch());
  PatchStep patch(contact, strips_of(memory), &whole, 1);
  const double rolled = contact.memory.at_rest ? 0.0 : contact.memory.rolled;
  const double takes_over = forgotten(rolled / std::max(numbers.length, least_divisor));
  const bool rests = hardly_rolls(rolled, numbers.length), from_now = takes_over == 1.0;
  // Cells at the end of the step, and the displacements per length at which strip FASTSIM is asked
  double shift[3] = {}, last = 0.0, cells_force[3] = {};
  Creepage asked = contact.creepage;
  if (from_now) {
    about_centre(numbers, contact.creepage, 1.0, shift);
    patch.steady(shift, last_part(numbers.length), memory.other() + memory.written, cells_force);
  } else {
    double per[3];
    about_centre(numbers, contact.creepage, 1.0, per);
    patch.go(per, rests ? contact.memory.rolled : rolled, rests ? 0.0 : rolled, shift, last);
    const double ahead = factors.ahead * (1.0 - takes_over);
    for (int i = 0; i < 3; ++i) shift[i] += ahead * (whole.local[i] - shift[i]);
    if (!rests) asked = about_origin(numbers, shift, last);
  }
  // The difference to strip FASTSIM follows over the length that is rolled.
  TangentialForces forces;
  RollingContact steady = contact;
  steady.creepage = asked;
  if (!rests || fields.any()) forces = strip_fastsim(steady, fields, fault);
  const double steady_power = forces.power_per_speed;
  double added[3];
  std::copy_n(before.added, 3, added);
  if (!rests) {
    double per[3], of_cells[3];
    about_centre(numbers, asked, 1.0, per);
    patch.steady(per, last, memory.list(2), of_cells);
    if (from_now)
      std::copy_n(cells_force, 3, of_cells);
    else if (takes_over > 0.0)
      for (std::int32_t j = 0; j < contact.region.count; ++j)
        tend_to(contact.grid->kernels->tangential, memory.list(2)[j], takes_over,
                memory.other()[memory.written + j]);
    refer_to_origin(numbers, of_cells);
    const double share = follows(numbers, rolled, factors);
    const double of_strips[3] = {forces.fx, forces.fy, forces.mz};
    for (int i = 0; i < 3; ++i) added[i] += share * (of_strips[i] - of_cells[i] - added[i]);
  }
  // Forces, within friction
  double force[3];
  patch.forces(force);
  refer_to_origin(numbers, force);
  const double fx = force[0] + added[0], fy = force[1] + added[1];
  const double within = std::min(1.0, numbers.limit / std::max(std::sqrt(fx * fx + fy * fy), least_divisor));
  added[0] = within * fx - force[0];
  added[1] = within * fy - force[1];
  for (int i = 0; i < 3; ++i) force[i] += added[i];
  // Work of the step, -F.D, and the energy it leaves.
  const Creepage& c = contact.creepage;
  const double work =
      -contact.memory.rolled * (force[0] * c.longitudinal + force[1] * c.lateral + force[2] * c.spin);
  const EnergyLeft energy = count_energy(before.energy, work, patch.stored());
  patch.lower(energy.scale);
  for (double& part : added) part *= energy.scale;
  forces.adhesion_fraction = from_now ? forces.adhesion_fraction : patch.adhesion_fraction();
  keep_strips(contact, energy.left, added, memory);
  if (from_now && energy.scale == 1.0) return forces;
  forces.fx = energy.scale * force[0];
  forces.fy = energy.scale * force[1];
  forces.mz = energy.scale * force[2];
  forces.power_per_speed = rests ? 0.0 : energy.dissipated / rolled;
  scale_slips(steady_power > 0.0 ? forces.power_per_speed / steady_power : 0.0,
              static_cast<std::ptrdiff_t>(contact.grid->cells) * contact.region.count, fields);
  return forces;
}

}  // namespace wrc::tangential
