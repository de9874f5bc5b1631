#include "normal/strip_system.hpp"

#include <initializer_list>

namespace wrc {
namespace {

constexpr std::int64_t arrays_of_doubles = 19;
constexpr std::int64_t arrays_of_indices = 3;

}  // namespace

StripSystem lay_out_strips(void* memory, std::int32_t capacity) noexcept {
  const std::int32_t n = capacity;
  auto* next = static_cast<double*>(memory);
  const auto take = [&](std::int64_t size) {
    double* const block = next;
    next += size;
    return block;
  };
  StripSystem s;
  for (double** field :
       {&s.grid.y, &s.grid.width, &s.cell_y, &s.cell_width, &s.height, &s.curvature, &s.gap_centre,
        &s.half_length, &s.inverse_length, &s.centre, &s.peak, &s.by_approach, &s.by_height, &s.level,
        &s.shift, &s.pair_y, &s.pair_centre, &s.pair_inverse_length, &s.pair_strength})
    *field = take(n);
  s.influence = take(static_cast<std::int64_t>(n) * n);
  s.matrix = take(static_cast<std::int64_t>(n) * n);
  auto* const indices =
      reinterpret_cast<std::int32_t*>(next);  // behind the doubles, in memory nobody has typed yet
  s.grid.region = indices;
  s.active = indices + n;
  s.next_active = indices + 2 * n;
  return s;
}

std::int64_t strip_system_bytes(std::int32_t capacity) noexcept {
  const auto n = static_cast<std::int64_t>(capacity);
  constexpr auto real = static_cast<std::int64_t>(sizeof(double));
  constexpr auto index = static_cast<std::int64_t>(sizeof(std::int32_t));
  return (arrays_of_doubles * n + 2 * n * n) * real + arrays_of_indices * n * index;
}

}  // namespace wrc
