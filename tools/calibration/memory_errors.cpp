#include "memory_errors.hpp"

#include <cmath>
#include <utility>

namespace wrc::calibration {
namespace {

constexpr int strips = 24, cells = 24;

/// Work that the wheel puts into the last steps, by forces at their ends [J].
template <class ForceAt>
double work_of_loop(const MemoryCase& c, ForceAt force_at) {
  double work = 0.0;
  for (std::size_t k = c.steps.size() - static_cast<std::size_t>(c.loop); k < c.steps.size(); ++k) {
    const tangential::TangentialForces before = force_at(k - 1), now = force_at(k);
    const MemoryStep& s = c.steps[k];
    work -= 0.5 * ((before.fx + now.fx) * s.x + (before.fy + now.fy) * s.y + (before.mz + now.mz) * s.turn);
  }
  return work;
}

}  // namespace

RememberedCase::RememberedCase(MemoryCase exact) : exact_(std::move(exact)) {
  static const OwnedGrid grid(cells);
  double load = 0.0;
  for (const MemoryStep& s : exact_.steps) {
    if (s.load != load)
      under_.push_back(std::make_unique<Rolling>(under_load(exact_.patch, s.load), grid.grid, strips));
    load = s.load;
    which_.push_back(under_.size() - 1);
  }
}

std::vector<MemoryError> RememberedCase::errors(const tangential::MemoryFactors& factors,
                                                double& loop) const {
  std::vector<double> memory(tangential::strip_memory_bytes(strips) / sizeof(double) + 1);
  tangential::make_strip_memory(strips, memory.data());
  std::vector<tangential::TangentialForces> found;
  std::vector<MemoryError> errors;
  for (std::size_t k = 0; k < exact_.steps.size(); ++k) {
    // backwards as the mirror image that rolls forwards; at rest displacements are creepages over 1 mm
    const MemoryStep& s = exact_.steps[k];
    const double direction = s.direction < 0 ? -1.0 : 1.0, length = s.direction == 0 ? 1e-3 : s.rolled;
    tangential::RollingContact contact = under_[which_[k]]->contact;
    contact.memory.at = memory.data();
    contact.memory.rolled = length;
    contact.memory.at_rest = s.direction == 0;
    contact.memory.direction = direction;
    contact.creepage = {direction * s.x / length, s.y / length, direction * s.turn / length};
    Fault fault;
    tangential::begin_step(memory.data());
    tangential::TangentialForces f = tangential::roll_with_memory(contact, {}, fault, factors);
    tangential::end_step(memory.data());
    f.fx *= direction;
    f.mz *= direction;
    found.push_back(f);
    const Patch& p = exact_.patch;
    const double limit = p.friction * s.load;
    errors.push_back(
        {(f.fx - s.fx) / limit, (f.fy - s.fy) / limit, (f.mz - s.mz) / (limit * std::sqrt(p.a * p.b))});
  }
  loop = 0.0;
  if (exact_.loop > 0) {
    const double exact = work_of_loop(exact_, [&](std::size_t k) {
      const MemoryStep& s = exact_.steps[k];
      return tangential::TangentialForces{s.fx, s.fy, s.mz, 0.0, 0.0};
    });
    loop = work_of_loop(exact_, [&](std::size_t k) { return found[k]; }) / exact - 1.0;
  }
  return errors;
}

}  // namespace wrc::calibration
