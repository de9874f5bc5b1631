/// A case as the tangential methods are given it.
#pragma once

#include <vector>

#include "cases.hpp"
#include "kernels/kernels.hpp"
#include "patch/sdec.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc::calibration {

/// Owns what the view `contact` points to; neither copied nor moved.
class Rolling {
 public:
  /// An SDEC is cut into `strips` strips, other patches keep theirs.
  Rolling(const Patch& p, const tangential::MarchGrid& grid, int strips) : table_(p.poisson) {
    const std::size_t count = p.strips.empty() ? static_cast<std::size_t>(strips) : p.strips.size();
    memory_.resize(5 * count);
    double* const m = memory_.data();
    patch::Strips& s = contact.region;
    s = {static_cast<std::int32_t>(count),
         static_cast<std::int32_t>(count),
         m,
         m + count,
         m + 2 * count,
         m + 3 * count,
         m + 4 * count};
    if (p.strips.empty()) {
      patch::sdec_strips({p.a, p.b, p.psi}, 0.0, 0.0, p.normal_force, strips, s);
    } else {
      for (std::size_t j = 0; j < count; ++j) {
        s.y[j] = p.strips[j].y;
        s.width[j] = p.strips[j].width;
        s.centre[j] = p.strips[j].centre;
        s.half_length[j] = p.strips[j].half_length;
        s.peak[j] = p.strips[j].peak;
      }
    }
    contact.a = p.a;
    contact.b = p.b;
    contact.shape_number = p.psi;
    contact.shear_modulus = p.shear_modulus;
    contact.linear_theory = &table_;
    contact.grid = &grid;
    contact.creepage = p.creepage;
    contact.friction = p.friction;
  }
  Rolling(const Rolling&) = delete;
  Rolling& operator=(const Rolling&) = delete;

  tangential::RollingContact contact;

 private:
  theory::SdecTable table_;
  std::vector<double> memory_;
};

/// A march grid with its memory.
struct OwnedGrid {
  explicit OwnedGrid(int cells)
      : memory(tangential::march_grid_size(cells)),
        grid(tangential::make_march_grid(cells, memory.data(), kernels_for(InstructionSet::baseline))) {}
  std::vector<double> memory;
  tangential::MarchGrid grid;
};

}  // namespace wrc::calibration
