/// Stresses of many loads at one point (damage/subsurface.hpp) for the instruction set of the unit: one load
/// per lane.
#pragma once

#include "base/pack.hpp"
#include "base/pack_elementary.hpp"
#include "damage/load_stress.hpp"
#include "damage/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// From some element on, the sums of the loads whose elements are alike modulo stress_parts.
struct StressSum {
  damage::StressOf<Pack> sum;

  StressSum(const StressParts& parts, std::int32_t at)
      : sum{load_pack(parts.part[0] + at), load_pack(parts.part[1] + at), load_pack(parts.part[2] + at),
            load_pack(parts.part[3] + at), load_pack(parts.part[4] + at), load_pack(parts.part[5] + at)} {}
  void keep(StressParts& parts, std::int32_t at) const {
    store_pack(parts.part[0] + at, sum.xx);
    store_pack(parts.part[1] + at, sum.yy);
    store_pack(parts.part[2] + at, sum.zz);
    store_pack(parts.part[3] + at, sum.xy);
    store_pack(parts.part[4] + at, sum.yz);
    store_pack(parts.part[5] + at, sum.zx);
  }
  WRC_IN_LOOP void add(const damage::StressOf<Pack>& s) {
    sum.xx += s.xx;
    sum.yy += s.yy;
    sum.zz += s.zz;
    sum.xy += s.xy;
    sum.yz += s.yz;
    sum.zx += s.zx;
  }
};

inline void stress_of_points_kernel(const PointLoads& loads, StressParts& stress) {
  const Pack y = loads.y, z = loads.z, spared = loads.spared, none = 0.0;
  for (std::int32_t part = 0; part < stress_parts; part += lanes) {
    StressSum sum(stress, part);
    for (std::int32_t k = part; k < loads.count; k += stress_parts) {
      const Pack x = Pack(loads.x) - Pack(loads.half_length) * load_pack(loads.place + k);
      const Mask left_out = magnitude(x) < spared;
      const Pack normal = select(left_out, none, Pack(loads.scale) * load_pack(loads.weight + k));
      sum.add(damage::point_force_stress_of(loads.poisson, select(left_out, spared, x), y, z, normal,
                                            normal * load_pack(loads.along + k),
                                            normal * load_pack(loads.across + k)));
    }
    sum.keep(stress, part);
  }
}

inline void stress_of_corners_kernel(const CornerLoads& loads, StressParts& stress) {
  const Pack z = loads.z;
  for (std::int32_t part = 0; part < stress_parts; part += lanes) {
    StressSum sum(stress, part);
    for (std::int32_t k = part; k < loads.count; k += stress_parts) {
      const damage::CellStressOf<Pack> s =
          damage::corner_stress_of(loads.poisson, load_pack(loads.x + k), load_pack(loads.y + k), z);
      const Pack p = load_pack(loads.pressure + k), qx = load_pack(loads.along + k),
                 qy = load_pack(loads.across + k);
      const auto of = [&](Pack pressed, Pack pulled, Pack pushed) {
        return p * pressed + qx * pulled + qy * pushed;
      };
      sum.add({of(s.of_pressure.xx, s.of_traction_x.xx, s.of_traction_y.xx),
               of(s.of_pressure.yy, s.of_traction_x.yy, s.of_traction_y.yy),
               of(s.of_pressure.zz, s.of_traction_x.zz, s.of_traction_y.zz),
               of(s.of_pressure.xy, s.of_traction_x.xy, s.of_traction_y.xy),
               of(s.of_pressure.yz, s.of_traction_x.yz, s.of_traction_y.yz),
               of(s.of_pressure.zx, s.of_traction_x.zx, s.of_traction_y.zx)});
    }
    sum.keep(stress, part);
  }
}

}  // namespace
}  // namespace wrc::simd
