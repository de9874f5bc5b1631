/// Derivatives of the forces, handed back.
#include <algorithm>

#include "abi/call.hpp"

namespace abi = wrc::abi;

extern "C" int32_t wrc_planar_tangential_derivatives(wrc_contact* handle, wrc_planar_derivatives* sensitivity) {
  return abi::call(handle, abi::clear(sensitivity), [&](wrc::Contact& contact) {
    wrc::TangentialSensitivities found;
    const wrc::Fault outcome = wrc::find_sensitivities(contact, found);
    if (outcome.failed()) return outcome;
    wrc_planar_derivatives result = abi::defaults<wrc_planar_derivatives>();
    std::copy_n(&found.d[0][0], 15, &result.forces[0][0]);
    abi::write(result, sensitivity);
    return outcome;
  });
}

extern "C" int32_t wrc_contact_step_sensitivities(wrc_contact* handle, wrc_step_sensitivity* sensitivity) {
  return abi::call(handle, abi::clear(sensitivity), [&](wrc::Contact& contact) {
    wrc::StepSensitivities found;
    const wrc::Fault outcome = wrc::find_step_sensitivities(contact, found);
    if (outcome.failed()) return outcome;
    wrc_step_sensitivity result = abi::defaults<wrc_step_sensitivity>();
    std::copy_n(found.by_load, 4, result.by_load);
    std::copy_n(found.by_lateral, 4, result.by_lateral);
    abi::write(result, sensitivity);
    return outcome;
  });
}
