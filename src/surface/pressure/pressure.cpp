#include "surface/pressure/pressure.hpp"

#include "surface/pressure/iteration.hpp"
#include "surface/pressure/pressure_scratch.hpp"
#include "surface/pressure/start.hpp"

namespace wrc::surface {
namespace {

/// Part of the area that the first iteration from an earlier solution may move; beyond, the solve starts from
/// the overlaps.
constexpr double farthest_start = 0.3;

/// Strips of the candidates, with the lengths and shifts of the start. Returns whether any has a length.
bool load_strips(const RailStrips& rail, const Overlaps& o, const PressureStart& start, StripSet& s) {
  // Candidates that were not in contact then have L = 0 and may enter.
  bool started = false;
  s.count = o.count;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const std::int32_t j = o.strip[i];
    s.place[i] = rail.s[j];
    s.width[i] = rail.width[j];
    s.depth[i] = o.depth[i];
    s.curvature[i] = o.curvature[i];
    s.deepest_x[i] = o.centre[i];
    s.ny[i] = o.ny[i];
    s.nz[i] = o.nz[i];
    s.L[i] = start.set ? start.length_squared[j] : 0.0;
    s.shift[i] = start.set ? start.shift[j] : 0.0;
    started = started || s.L[i] > 0.0;
  }
  return started;
}

/// The solution over the candidates, and over the strips of the rail for the next start.
void store(const RailStrips& rail, const Overlaps& o, const StripSet& s, PressureStart& start,
           const StripPressure& p) {
  // Strips of the rail that are no candidates start the next solve without contact.
  for (std::int32_t j = 0; j < rail.count; ++j)
    start.length_squared[j] = start.shift[j] = start.depth[j] = 0.0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    start.length_squared[o.strip[i]] = s.L[i];
    start.shift[o.strip[i]] = s.shift[i];
    start.depth[o.strip[i]] = s.depth[i];
    p.length_squared[i] = s.L[i];
    p.peak_per_length[i] = s.lambda[i];
    p.centre[i] = s.deepest_x[i] + s.shift[i];
    p.line_load[i] = s.q[i];
  }
  start.set = true;
  start.extrapolated = false;
}

}  // namespace

std::int64_t pressure_doubles(std::int32_t most) {
  Arena counted;
  cut_pressure_scratch(counted, most);
  return counted.doubles();
}

PressureResult solve_pressure(const PressureModel& model, const RailStrips& rail, const Overlaps& o,
                              const PressureOptions& options, double* workspace, PressureStart& start,
                              const StripPressure& p) noexcept {
  Arena arena(workspace);
  PressureScratch w = cut_pressure_scratch(arena, o.capacity);
  StripSet& s = w.fine;
  const PressureProblem problem{
      model.kernels, {model.influence.tables(), model.influence.mean_under.data()}, model.compliance};
  PressureResult result;
  bool started = load_strips(rail, o, start, s);
  if (o.count == 0) {
    result.converged = true;
    store(rail, o, s, start, p);
    return result;
  }
  // From an earlier solution, if there is one that is near enough and leads to the end. Lengths predicted by
  // the caller are not moved again.
  if (started && !start.extrapolated) started = follow_overlaps(o, start, s);
  if (started) {
    result = iterate(problem, s, options.tolerance, farthest_start, options, w);
    started = result.converged;
  }
  // Else from the overlaps, which is the only way of a call without a past.
  if (!started) {
    const std::int32_t spent = result.iterations + start_from_overlaps(problem, o, options, w);
    result = iterate(problem, s, options.tolerance, any_change, options, w);
    result.iterations += spent;
  }
  store(rail, o, s, start, p);
  return result;
}

}  // namespace wrc::surface
