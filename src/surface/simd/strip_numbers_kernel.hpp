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
  std::int32_t strip;

  double get(const double* of) const { return of[strip]; }
  void put(double* of, double x) const { of[strip] = x; }
};

/// A pack's strips.
struct StripLanes {
  using Number = Pack;
  using OneStrip = PlainStrip;
  std::int32_t first, count;

  Pack get(const double* of) const { return load(of, first, count, 1.0); }
  void put(double* of, Pack x) const { store(x, of + first, count); }
  template <class F>
  static void each(std::int32_t count, const F& f) {
    for (std::int32_t first = 0; first < count; first += lanes)
      f(StripLanes{first, count - first < lanes ? count - first : lanes});
  }
};

/// One strip with derivatives, whose vectors fill the lanes.
struct DualStrip {
  using Element = StripNumbersSlopesTask::Number;
  using Number = PackDual<StripNumbersSlopesTask::inputs>;
  using OneStrip = DualStrip;
  static_assert(sizeof(Element) == (1 + Number::inputs) * sizeof(double), "value and derivatives");
  std::int32_t strip;

  double get(const double* of) const { return of[strip]; }
  Number get(const Element* of) const { return Number::load(reinterpret_cast<const double*>(of + strip)); }
  void put(Element* of, const Number& x) const { x.store(reinterpret_cast<double*>(of + strip)); }
  template <class F>
  static void each(std::int32_t count, const F& f) {
    for (std::int32_t j = 0; j < count; ++j) f(DualStrip{j});
  }
};

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

/// SurfaceKernels::strip_means_slopes.
inline void strip_means_slopes_kernel(const StripNumbersSlopesTask& task) {
  surface::strip_numbers::link<DualStrip>(*task.in, *task.arrays);
  surface::strip_numbers::linear_theory<DualStrip>(*task.in, *task.shared, *task.arrays);
}

/// SurfaceKernels::strip_arrays_slopes.
inline void strip_arrays_slopes_kernel(const StripNumbersSlopesTask& task) {
  surface::strip_numbers::fill_arrays<DualStrip>(*task.in, *task.shared, *task.arrays);
}

}  // namespace
}  // namespace wrc::simd
