/// Stresses below a solved patch in real time.
#include "abi/stresses.hpp"

#include "abi/call.hpp"

namespace wrc::abi {
namespace {

constexpr double most_depths = 64.0, deepest = 0.1;

Fault check_depths(std::int32_t body, const double* depths, std::uint32_t count) {
  if (body != WRC_BODY_WHEEL && body != WRC_BODY_RAIL) {
    return {.status = WRC_ERROR_UNSUPPORTED,
            .field = "body",
            .value = static_cast<double>(body),
            .unit = "",
            .cause = "see enum wrc_body: WRC_BODY_WHEEL (0), _RAIL (1)"};
  }
  if (depths == nullptr) return {.status = WRC_ERROR_NULL, .field = "depths"};
  Fault fault = check_all(depths, count, "depths", "m", 0.0, deepest, "depths are positive in both bodies",
                          "did you pass mm?");
  for (std::uint32_t k = 1; k < count && !fault.failed(); ++k) {
    if (depths[k] > depths[k - 1]) continue;
    fault = {.status = WRC_ERROR_RANGE,
             .index = static_cast<std::int32_t>(k),
             .field = "depths",
             .value = depths[k],
             .unit = "m",
             .cause = "depths must be in order, each larger than the one before"};
  }
  return fault;
}

}  // namespace
}  // namespace wrc::abi

extern "C" int32_t wrc_contact_stresses(wrc_contact* handle, int32_t body, const double* depths,
                                        uint32_t count, wrc_stress_peaks* levels, wrc_stresses* stresses) {
  namespace abi = wrc::abi;
  const wrc::Fault of_count = abi::check(count, "count", "", 1.0, abi::most_depths);
  const std::uint32_t known = of_count.failed() ? 0 : count;
  for (std::uint32_t k = 0; levels != nullptr && k < known; ++k) levels[k] = {};
  return abi::call(__func__, handle, abi::clear(stresses), [&](wrc::Contact& contact) {
    wrc::Fault outcome = of_count;
    if (!outcome.failed()) outcome = abi::check_depths(body, depths, count);
    if (outcome.failed()) return outcome;
    wrc::StressPeaks found[static_cast<std::size_t>(abi::most_depths)];
    wrc::BodyStresses of_body;
    outcome = wrc::find_stresses(contact, body == WRC_BODY_RAIL, depths, static_cast<std::int32_t>(count),
                                 found, of_body);
    if (outcome.failed()) return outcome;
    for (std::uint32_t k = 0; levels != nullptr && k < count; ++k) levels[k] = abi::peaks_of(found[k]);
    wrc_stresses result = abi::empty<wrc_stresses>();
    abi::fill(of_body.surface, of_body.below, body, result);
    abi::write(result, stresses);
    return outcome;
  });
}
