/// wrc_profiles.h: pairs of profiles behind the C interface. Offline: it allocates.
#include <algorithm>
#include <vector>

#include "abi/guarded.hpp"
#include "abi/handles.hpp"
#include "abi/structs.hpp"
#include "profiles/conicity.hpp"
#include "profiles/contact_functions.hpp"
#include "profiles/evolution.hpp"
#include "wrc/wrc_profiles.h"

namespace wrc::abi {
namespace {

/// An array of the caller, and the number that goes there.
struct Column {
  double* theirs;
  double (*value)(const profiles::SettledWheelset&);
};

Fault find_functions(const wrc_model* handle, const wrc_wheelset_geometry_problem* theirs,
                     wrc_wheelset_geometry* functions) {
  wrc_wheelset_geometry into;
  wrc_wheelset_geometry_problem problem;
  RETURN_IF_FAILED(read(functions, "functions", into));
  RETURN_IF_FAILED(read(theirs, "problem", problem));
  constexpr int right = static_cast<int>(geometry::Side::right),
                left = static_cast<int>(geometry::Side::left);
  using Settled = const profiles::SettledWheelset&;
  const Column columns[] = {
      {into.vertical, [](Settled s) { return s.vertical; }},
      {into.roll, [](Settled s) { return s.roll; }},
      {into.radius_difference, [](Settled s) { return s.side[right].radius - s.side[left].radius; }},
      {into.radius_right, [](Settled s) { return s.side[right].radius; }},
      {into.radius_left, [](Settled s) { return s.side[left].radius; }},
      {into.angle_right, [](Settled s) { return s.side[right].angle; }},
      {into.angle_left, [](Settled s) { return s.side[left].angle; }},
      {into.y_wheel_right, [](Settled s) { return s.side[right].y_wheel; }},
      {into.y_wheel_left, [](Settled s) { return s.side[left].y_wheel; }},
      {into.y_rail_right, [](Settled s) { return s.side[right].y_rail; }},
      {into.y_rail_left, [](Settled s) { return s.side[left].y_rail; }}};
  for (const Column& each : columns)
    if (each.theirs != nullptr) std::fill_n(each.theirs, problem.count, 0.0);
  if (!valid(handle)) return Fault::null("model");
  const contact::Model& model = *handle->model;
  if (!model.has_geometry)
    return Fault::sequence("model", "it has no profiles: give config.wheel and config.rail");
  std::vector<profiles::SettledWheelset> settled(problem.count);
  const Fault fault =
      profiles::settle_wheelset(model, problem.wheel_load, problem.count, problem.lateral, settled.data());
  if (fault.failed()) return fault;
  for (const Column& each : columns)
    if (each.theirs != nullptr) std::transform(settled.begin(), settled.end(), each.theirs, each.value);
  return fault;
}

Fault find_conicity(const wrc_conicity_problem* theirs, wrc_conicity* conicity) {
  wrc_conicity into;
  wrc_conicity_problem problem;
  RETURN_IF_FAILED(read(conicity, "conicity", into));
  RETURN_IF_FAILED(read(theirs, "problem", problem));
  for (double* each : {into.conicity, into.wavelength, into.centre})
    if (each != nullptr) std::fill_n(each, problem.amplitude_count, 0.0);
  for (std::uint32_t i = 1; i < problem.count; ++i) {
    if (!(problem.lateral[i] > problem.lateral[i - 1]))
      return Fault::range({"problem.lateral", i}, {problem.lateral[i], "m"}, "displacements must increase");
  }
  const double widest = 0.5 * (problem.lateral[problem.count - 1] - problem.lateral[0]);
  for (std::uint32_t i = 0; i < problem.amplitude_count; ++i) {
    if (problem.amplitudes[i] > widest * (1.0 + 1e-12))
      return Fault::range(
          {"problem.amplitudes", i}, {problem.amplitudes[i], "m", 1e-6, widest},
          "the displacements do not reach that far: an amplitude is half the distance from side to side");
  }
  std::vector<double> potential(problem.count);
  const profiles::RadiusDifference of{problem.count, problem.lateral, problem.radius_difference,
                                      potential.data()};
  profiles::integrate(of);
  const auto method = problem.method == WRC_CONICITY_WAVELENGTH ? profiles::conicity_by_wavelength
                                                                : profiles::conicity_by_regression;
  for (std::uint32_t i = 0; i < problem.amplitude_count; ++i) {
    const profiles::Conicity found =
        method(of, problem.amplitudes[i], problem.contact_distance, problem.radius);
    if (into.conicity != nullptr) into.conicity[i] = found.conicity;
    if (into.wavelength != nullptr) into.wavelength[i] = found.wavelength;
    if (into.centre != nullptr) into.centre[i] = found.centre;
  }
  return {};
}

Fault take_off(const wrc_profile_wear* theirs, wrc_worn_profile* worn) {
  wrc_worn_profile into;
  wrc_profile_wear ours;
  RETURN_IF_FAILED(read(worn, "worn", into));
  into.count = 0;
  into.passages = into.depth = into.area = 0.0;
  write(into, worn);
  RETURN_IF_FAILED(read(theirs, "wear", ours));
  if (into.y == nullptr || into.z == nullptr) return Fault::null("worn.y");
  profiles::WornProfile found;
  Fault fault = profiles::wear_profile(
      ours.count, ours.y, ours.z,
      {.body = ours.body == WRC_BODY_WHEEL ? geometry::ProfileBody::wheel : geometry::ProfileBody::rail,
       .bins = ours.bin_count,
       .first = ours.first,
       .width = ours.width,
       .depth = ours.depth,
       .passages = ours.passages,
       .largest_depth = ours.largest_depth,
       .smoothing = ours.smoothing,
       .spacing = ours.spacing},
      found);
  if (fault.failed()) {
    if (fault.field == nullptr) fault.field = "wear";
    return fault;
  }
  if (found.y.size() > into.capacity)
    return Fault::buffer("worn.capacity", {into.capacity, "", found.y.size(), found.y.size()},
                         "give more room, or a wider spacing");
  std::copy(found.y.begin(), found.y.end(), into.y);
  std::copy(found.z.begin(), found.z.end(), into.z);
  into.count = static_cast<std::uint32_t>(found.y.size());
  into.passages = found.passages;
  into.depth = found.depth;
  into.area = found.area;
  write(into, worn);
  return fault;
}

Fault find_flange(std::uint32_t count, const double* y, const double* z, double back, wrc_flange* flange) {
  if (flange == nullptr) return Fault::null("flange");
  *flange = {};
  if (y == nullptr || z == nullptr) return Fault::null("y");
  RETURN_IF_FAILED(check(static_cast<double>(count), "count", "", 4.0, 20000.0));
  RETURN_IF_FAILED(check(back, "flange_back_to_origin", "m", 0.01, 0.2));
  for (const double* each : {y, z})
    RETURN_IF_FAILED(check_all(each, count, "y or z", "m", -1.0, 1.0, nullptr, "did you pass mm?"));
  profiles::FlangeDimensions found;
  const Fault fault = profiles::measure_flange(count, y, z, back, found);
  if (fault.failed()) return fault;
  *flange = {found.height, found.thickness, found.slope, {}};
  return fault;
}

/// Runs a call that allocates; its sentence goes into `text`.
template <typename Work>
std::int32_t run(const char* function, char* text, std::uint64_t size, Work&& work) {
  return finish(function, guarded(work, "problem.count", "there is not enough memory for so many"), text,
                size);
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;

extern "C" {

int32_t wrc_profile_wheelset_geometry(const wrc_model* model, const wrc_wheelset_geometry_problem* problem,
                                      wrc_wheelset_geometry* functions, char* text, uint64_t size) {
  return abi::run(__func__, text, size, [&] { return abi::find_functions(model, problem, functions); });
}

int32_t wrc_equivalent_conicity(const wrc_conicity_problem* problem, wrc_conicity* conicity, char* text,
                                uint64_t size) {
  return abi::run(__func__, text, size, [&] { return abi::find_conicity(problem, conicity); });
}

int32_t wrc_profile_remove_wear(const wrc_profile_wear* wear, wrc_worn_profile* worn, char* text,
                                uint64_t size) {
  return abi::run(__func__, text, size, [&] { return abi::take_off(wear, worn); });
}

int32_t wrc_flange_dimensions(uint32_t count, const double* y, const double* z, double flange_back_to_origin,
                              wrc_flange* flange, char* text, uint64_t size) {
  return abi::run(__func__, text, size,
                  [&] { return abi::find_flange(count, y, z, flange_back_to_origin, flange); });
}

}  // extern "C"
