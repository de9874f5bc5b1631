#include "surface/pressure/pressure_scratch.hpp"

#include <initializer_list>

namespace wrc::surface {

PressureScratch cut_pressure_scratch(Arena& arena, std::int32_t most) {
  PressureScratch w;
  // Kernels read whole packs from any strip on: a pack more than the strips fill.
  const std::int64_t padded = simd::whole_packs(most) + simd::most_lanes;
  for (StripSet* s : {&w.fine, &w.coarse})
    arena.each(padded, s->place, s->width, s->depth, s->curvature, s->deepest_x, s->ny, s->nz, s->L, s->shift,
               s->q);
  // Rows of the elimination come in fours and end in right-hand sides; kernels fill whole packs of them.
  const std::int32_t size = (most + 3) / 4 * 4;
  const std::int64_t stride = simd::elimination_stride(size);
  w.places = stride * simd::least_places(size);
  w.matrix = arena.take(w.places + simd::most_lanes);
  w.rows = arena.take(stride * rows_at_a_time + simd::most_lanes);
  w.solution = arena.take(stride);
  // Sources, points that see them, and numbers of edges, by strip or by active strip.
  ActiveStrips& a = w.active;
  arena.each(padded, a.place, a.centre, a.half_length, a.inverse_length, a.half_width, a.factor, a.q,
             a.load_factor, a.load, a.width, a.ny, a.nz, a.width_behind, a.per_lambda_reach,
             a.per_apart_squared);
  arena.each(padded, w.depth_before, w.half_length, w.continued, w.outside_place, w.outside_x, w.outside_ny,
             w.outside_nz, w.u_leading, w.u_trailing, w.edge_lambda, w.edge_shift, w.inverse_reach,
             w.rim_weight, w.upper, w.smooth_part, w.residual_before, w.best.q);
  // Vectors of all unknowns: L, then shifts.
  arena.each(2 * padded, w.residual, w.next, w.best.x);
  for (Iterate& iterate : w.iterate) {
    arena.each(2 * padded, iterate.x, iterate.f);
    iterate.q = arena.take(padded);
  }
  arena.each(padded, a.index, w.in_contact, w.outside, w.pair_of);
  return w;
}

}  // namespace wrc::surface
