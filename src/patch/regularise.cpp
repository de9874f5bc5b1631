#include "patch/regularise.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"

namespace wrc::patch {

Fault regularise(const StripTotals& patch, double y_contact, SecondCriterion criterion, Sdec& sdec) noexcept {
  sdec = {};
  if (!(patch.area > 0.0)) return Fault::no_contact();
  // Criteria of the header: (2) or (2b) gives b, (1) a = area / (pi b), (3) psi.
  const double width = patch.y_max - patch.y_min;
  sdec.b =
      criterion == SecondCriterion::width ? 0.5 * width : std::sqrt(patch.area / pi * width / patch.length);
  sdec.a = patch.area / (pi * sdec.b);
  const double y_mid = 0.5 * (patch.y_min + patch.y_max) - y_contact;
  const double psi = y_mid / sdec.b;
  sdec.psi = std::clamp(psi, -largest_psi, largest_psi);
  if (sdec.psi != psi)
    return Fault::table_range("psi", {psi, nullptr, -largest_psi, largest_psi},
                              "the contact point lies at the border of the patch");
  return {};
}

}  // namespace wrc::patch
