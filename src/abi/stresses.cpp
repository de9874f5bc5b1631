/// Depths at which stresses are wanted.
#include "abi/stresses.hpp"

#include "abi/structs.hpp"

namespace wrc::abi {

Fault check_stress_depths(std::int32_t body, const double* depths, std::uint32_t count) {
  if (body != WRC_BODY_WHEEL && body != WRC_BODY_RAIL) {
    return Fault::unsupported("body", {body, ""}, "see enum wrc_body: WRC_BODY_WHEEL (0), _RAIL (1)");
  }
  constexpr double deepest = 0.1;  // [m]
  if (depths == nullptr) return Fault::null("depths");
  Fault fault = check_all(depths, count, "depths", "m", 0.0, deepest, "depths are positive in both bodies",
                          "did you pass mm?");
  for (std::uint32_t k = 1; k < count && !fault.failed(); ++k) {
    if (depths[k] > depths[k - 1]) continue;
    fault = Fault::range({"depths", k}, {depths[k], "m"},
                         "depths must be in order, each larger than the one before");
  }
  return fault;
}

}  // namespace wrc::abi
