/// The numbers of strips that roll (surface/rolling/strip_numbers.hpp): one strip per lane, but for the sums
/// that run along the strips.
#pragma once

#include "base/pack.hpp"
#include "base/pack_dual.hpp"
#include "surface/rolling/strip_numbers.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Access to the numbers of one strip in the arrays (strip_numbers.hpp).
struct PlainStrip {
  using Number = double;
  using Still = double;
  std::int32_t strip;

  double get(const double* of) const { return of[strip]; }
  double still(const double* of) const { return of[strip]; }
  void put(double* of, double x) const { of[strip] = x; }
};

/// A pack's strips.
struct StripLanes {
  using Number = Pack;
  using Still = Pack;
  using OneStrip = PlainStrip;
  std::int32_t first, count;

  Pack get(const double* of) const { return load(of, first, count, 1.0); }
  Pack still(const double* of) const { return get(of); }
  void put(double* of, Pack x) const { store(x, of + first, count); }
  template <class F>
  static void each(std::int32_t count, const F& f) {
    for (std::int32_t first = 0; first < count; first += lanes)
      f(StripLanes{first, count - first < lanes ? count - first : lanes});
  }
};

/// One strip with derivatives, whose vectors fill the lanes. Of `Still` numbers those by the first inputs
/// alone, by the wheel's place, are not zero.
template <class StillNumber>
struct DualStrip {
  using Element = StripNumbersSlopesTask::Number;
  using Number = PackDual<StripNumbersSlopesTask::inputs>;
  using Still = StillNumber;
  using OneStrip = DualStrip;
  static_assert(sizeof(Element) == (1 + Number::inputs) * sizeof(double), "value and derivatives");
  std::int32_t strip;

  double get(const double* of) const { return of[strip]; }
  Number get(const Element* of) const { return Number::load(reinterpret_cast<const double*>(of + strip)); }
  Still still(const Element* of) const { return Still::load(reinterpret_cast<const double*>(of + strip)); }
  template <std::size_t n>
  void put(Element* of, const PackDual<n>& x) const {
    double* const to = reinterpret_cast<double*>(of + strip);
    x.store(to);
    for (std::size_t k = n; k < Number::inputs; k += abreast) store_columns(to + 1 + k, in_all_columns(0.0));
  }
  template <class F>
  static void each(std::int32_t count, const F& f) {
    for (std::int32_t j = 0; j < count; ++j) f(DualStrip{j});
  }
};
using MovingStrip = DualStrip<PackDual<StripNumbersSlopesTask::inputs>>;
using StillStrip = DualStrip<PackDual<StripNumbersSlopesTask::still_inputs>>;

inline surface::StripCoefficientsOf<Pack> coefficients_at(const surface::StripCoefficientNodes& table,
                                                          const Pack& m) {
  // Each lane reads its own step of the table: indices of the products at the node, one column after another.
  constexpr int quantities = surface::StripCoefficientNodes::quantities;
  const surface::PlaceInTable<Pack> place(table, m);
  const Pack node = smaller(whole_part(place.inside), surface::StripCoefficientNodes::steps - 1.0);
  const Pack t = place.inside - node;
  const double* const nodes = table.node[0][0];
  const Indices at = indices(2.0 * quantities * node);
  Pack product[quantities];
  for (int k = 0; k < quantities; ++k) {
    const Neighbours first = pick(nodes + 2 * k, at), second = pick(nodes + 2 * (quantities + k), at);
    product[k] = surface::between_nodes(first.at, first.behind, second.at, second.behind, t, place.beyond);
  }
  return surface::coefficients_of(product, m);
}

/// SurfaceKernels::strip_numbers.
inline void strip_numbers_kernel(const StripNumbersTask& task) {
  // Loads and their means' equations, coefficients and means; the numbers of the march where it is strip
  // FASTSIM's.
  const surface::SurfaceRollingInput& in = *task.in;
  const surface::RollingArrays& a = *task.arrays;
  surface::strip_numbers::link<StripLanes>(in, a);
  surface::strip_numbers::linear_theory<StripLanes>(in, *task.shared, a);
  if (task.for_strip_fastsim) surface::strip_numbers::fill_arrays<StripLanes>(in, *task.shared, a);
}

/// Calls act() with the access to strips that a task needs.
template <class Act>
void with_strips_of(const StripNumbersSlopesTask& task, const Act& act) {
  if (task.still_loads)
    act(StillStrip{0});
  else
    act(MovingStrip{0});
}

/// SurfaceKernels::strip_means_slopes.
inline void strip_means_slopes_kernel(const StripNumbersSlopesTask& task) {
  with_strips_of(task, [&](auto at) {
    surface::strip_numbers::link<decltype(at)>(*task.in, *task.arrays);
    surface::strip_numbers::linear_theory<decltype(at)>(*task.in, *task.shared, *task.arrays);
  });
}

/// SurfaceKernels::strip_arrays_slopes.
inline void strip_arrays_slopes_kernel(const StripNumbersSlopesTask& task) {
  with_strips_of(task, [&](auto at) {
    surface::strip_numbers::fill_arrays<decltype(at)>(*task.in, *task.shared, *task.arrays);
  });
}

/// SurfaceKernels::strip_forces_slopes.
inline void strip_forces_slopes_kernel(const StripForcesSlopesTask& task) {
  using Number = PackDual<StripNumbersSlopesTask::inputs>;
  const auto number = [](const StripNumbersSlopesTask::Number* of, std::int32_t k) {
    return Number::load(reinterpret_cast<const double*>(of + k));
  };
  constexpr std::int32_t results = 3;
  for (std::int32_t k = 0; k < task.count; ++k) {
    Number f[results];
    for (std::int32_t r = 0; r < results; ++r) f[r] = task.found[r][k];
    const auto add = [&](const double(&slope)[results], const Number& x) {
      for (std::int32_t r = 0; r < results; ++r) f[r].add_derivatives(slope[r], x);
    };
    // Forces are proportional to bound and half length, the moment to the square of that.
    // dF = F (dB / B + dl / l) + sum over the inputs of dF/dx dx
    const Number bound = number(task.bound, k), length = number(task.half_length, k);
    const double per_bound = bound.value > 0.0 ? 1.0 / bound.value : 0.0, per_length = 1.0 / length.value;
    add({f[0].value * per_bound, f[1].value * per_bound, f[2].value * per_bound}, bound);
    add({f[0].value * per_length, f[1].value * per_length, 2.0 * f[2].value * per_length}, length);
    for (std::int32_t i = 0; i < strip_inputs; ++i) {
      const double* const slope = task.slopes + results * i * task.count + k;
      const Number x = number(task.inputs[i], k);
      add({slope[0], slope[task.count], slope[2 * task.count]}, i == strip_spin ? x * length : x);
    }
    for (std::int32_t r = 0; r < results; ++r) f[r].store(reinterpret_cast<double*>(task.to[r] + k));
  }
}

}  // namespace
}  // namespace wrc::simd
