/// A group of strips, one strip per lane, before and after marching, for both marches: places of the strips,
/// cells in their first stick zones, sums of tractions and forces.
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Results of a kernel besides the forces: each is a kernel of its own.
enum class Output { forces, fields, sensitivities };

/// Groups of strips that are marched side by side, so that one computes while another waits for a root.
constexpr std::int32_t in_flight = 2;

struct StripGroup {
  std::int32_t first, count;  ///< strips
  std::int32_t all_stick;     ///< cells before this one lie in the first stick zones of all strips
  std::int32_t all_move;      ///< cells from this one on begin where all strips have left theirs
  Pack lead, y, half_length;  ///< x of the leading edge, y, half length [m]
  Pack cell;                  ///< area of a cell [m^2]
  Pack bound;                 ///< traction bound at the strip's middle [Pa]
  Pack stick_cells;           ///< cells whose middle lies in the first stick zone
};

/// Places the strips first .. first + count - 1. Lanes without a strip have no width, but a length to divide
/// by.
inline void place(const patch::Strips& strips, std::int32_t cells, std::int32_t first, std::int32_t count,
                  StripGroup& g) {
  g.first = first;
  g.count = count;
  g.half_length = load(strips.half_length, first, count, 1.0);
  g.lead = load(strips.centre, first, count, 0.0) + g.half_length;
  g.y = load(strips.y, first, count, 0.0);
  g.cell = g.half_length * (2.0 / cells) * load(strips.width, first, count, 0.0);
}

/// The same of strips that are each seen from their own middle.
inline void place(const double* width, const double* half_length, std::int32_t cells, std::int32_t first,
                  std::int32_t count, StripGroup& g) {
  g.first = first;
  g.count = count;
  g.half_length = load(half_length, first, count, 1.0);
  g.lead = g.half_length;
  g.y = 0.0;
  g.cell = g.half_length * (2.0 / cells) * load(width, first, count, 0.0);
}

/// Sets the first stick zones, `stick` cells long.
inline void set_stick_zone(Pack stick, std::int32_t cells, StripGroup& g) {
  // a cell belongs to the zone if its middle does; the shortest and the longest zone of the strips, not of
  // lanes without one
  g.stick_cells = nearest_integer(stick);
  double of_strip[lanes];
  store_pack(of_strip, g.stick_cells);
  double least = cells, most = 0.0;
  for (std::int32_t k = 0; k < g.count; ++k) {
    least = of_strip[k] < least ? of_strip[k] : least;
    most = of_strip[k] > most ? of_strip[k] : most;
  }
  g.all_stick = static_cast<std::int32_t>(least);
  g.all_move = static_cast<std::int32_t>(most) + 1;
}

/// Sums of tractions over the bound, or of their derivatives: over the first stick zone and over the cells
/// that moved, t the distance of a cell from the leading edge in half lengths.
struct ForceSums {
  Pack stick_px, stick_py, stick_t_py;
  Pack px, py;
  Pack py_so_far;  ///< sum over the cells of py after each: n - i times the traction of cell i of n
};

inline void add_cell(Pack px, Pack py, ForceSums& s) {
  s.px += px;
  s.py += py;
  s.py_so_far += s.py;
}

/// Forces [N] and moment [N m] of each lane.
struct LaneForces {
  double fx[lanes], fy[lanes], mz[lanes];
};

inline LaneForces lane_forces(const StripGroup& g, std::int32_t cells, const ForceSums& s) {
  // With t = (i + 1/2) h of cell i of n and sum (n - i) p_i = py_so_far: sum t_i p_i over the cells that
  // moved is h ((n + 1/2) sum p_i - sum (n - i) p_i). Moment M_z = sum x p_y - y p_x with x = lead - l t.
  const Pack force = g.bound * g.cell, h = 2.0 / cells;
  const Pack px = s.stick_px + s.px, py = s.stick_py + s.py;
  const Pack t_py = s.stick_t_py + h * ((cells + 0.5) * s.py - s.py_so_far);
  LaneForces f;
  store_pack(f.fx, force * px);
  store_pack(f.fy, force * py);
  store_pack(f.mz, force * (g.lead * py - g.half_length * t_py - g.y * px));
  return f;
}

/// Adds a group's power and areas strip by strip. unslid: cells behind the first stick zone that have not
/// slid; power: of the slip [N].
inline void add_power(const StripGroup& g, std::int32_t cells, Pack unslid, Pack power, Sums& total) {
  // lane by lane, in the order of the strips: the same bits for any width of a pack
  double of_power[lanes], cell[lanes], slid[lanes];
  store_pack(of_power, power);
  store_pack(cell, g.cell);
  store_pack(slid, g.cell * ((cells - g.stick_cells) - unslid));
  for (std::int32_t k = 0; k < g.count; ++k) {
    total.power_per_speed += of_power[k];
    total.area += cells * cell[k];
    total.slid_area += slid[k];
  }
}

/// Adds a group's forces strip by strip.
inline void add_forces(const StripGroup& g, std::int32_t cells, const ForceSums& s, Sums& total) {
  const LaneForces f = lane_forces(g, cells, s);
  for (std::int32_t k = 0; k < g.count; ++k) {
    total.fx += f.fx[k];
    total.fy += f.fy[k];
    total.mz += f.mz[k];
  }
}

/// Stores a group's forces where strips have axes of their own.
inline void store_forces(const StripGroup& g, std::int32_t cells, const ForceSums& s, double* fx, double* fy,
                         double* mz) {
  const LaneForces f = lane_forces(g, cells, s);
  for (std::int32_t k = 0; k < g.count; ++k) {
    fx[g.first + k] = f.fx[k];
    fy[g.first + k] = f.fy[k];
    mz[g.first + k] = f.mz[k];
  }
}

/// Adds the derivatives of a group's forces with respect to an input.
inline void add_derivative(const StripGroup& g, std::int32_t cells, const ForceSums& s, std::int32_t input,
                           Sums& total) {
  const LaneForces f = lane_forces(g, cells, s);
  for (std::int32_t k = 0; k < g.count; ++k) {
    total.d[0][input] += f.fx[k];
    total.d[1][input] += f.fy[k];
    total.d[2][input] += f.mz[k];
  }
}

inline bool all_wanted(const tangential::TangentialFields& fields) {
  return fields.traction_x && fields.traction_y && fields.slip_x && fields.slip_y;
}

/// Tractions [Pa] and slip [-] of a cell of a group; strips: of all groups.
WRC_IN_LOOP void store_cell(const tangential::TangentialFields& fields, const StripGroup& g,
                            std::int32_t cell, std::int32_t strips, Pack traction_x, Pack traction_y,
                            Pack slip_x, Pack slip_y) {
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(cell) * strips + g.first;
  // Most groups are full and most calls ask for all fields: one test for four arrays.
  if (g.count == lanes && all_wanted(fields)) {
    store_pack(fields.traction_x + at, traction_x);
    store_pack(fields.traction_y + at, traction_y);
    store_pack(fields.slip_x + at, slip_x);
    store_pack(fields.slip_y + at, slip_y);
    return;
  }
  // the last group, or some of the fields
  if (fields.traction_x != nullptr) store(traction_x, fields.traction_x + at, g.count);
  if (fields.traction_y != nullptr) store(traction_y, fields.traction_y + at, g.count);
  if (fields.slip_x != nullptr) store(slip_x, fields.slip_x + at, g.count);
  if (fields.slip_y != nullptr) store(slip_y, fields.slip_y + at, g.count);
}

}  // namespace
}  // namespace wrc::simd
