/// Derivatives of the forces, handed back.
#include <algorithm>

#include "abi/fp_environment.hpp"
#include "abi/handles.hpp"
#include "abi/structs.hpp"

extern "C" int32_t wrc_sensitivities(wrc_contact* handle, wrc_sensitivity* sensitivity) {
  namespace abi = wrc::abi;
  if (!abi::valid(handle)) return WRC_ERROR_NULL;
  const abi::FloatingPointScope scope;
  wrc::Contact& contact = *handle->contact;
  wrc::Fault outcome = abi::clear(sensitivity);
  wrc::TangentialSensitivities found;
  if (!outcome.failed()) outcome = wrc::find_sensitivities(contact, found);
  contact.last = outcome;
  if (outcome.failed()) return outcome.status;
  wrc_sensitivity result = abi::defaults<wrc_sensitivity>();
  std::copy_n(&found.d[0][0], 15, &result.forces[0][0]);
  abi::write(result, sensitivity);
  return outcome.status;
}

extern "C" int32_t wrc_step_sensitivities(wrc_contact* handle, wrc_step_sensitivity* sensitivity) {
  namespace abi = wrc::abi;
  if (!abi::valid(handle)) return WRC_ERROR_NULL;
  const abi::FloatingPointScope scope;
  wrc::Contact& contact = *handle->contact;
  wrc::Fault outcome = abi::clear(sensitivity);
  wrc::StepSensitivities found;
  if (!outcome.failed()) outcome = wrc::find_step_sensitivities(contact, found);
  contact.last = outcome;
  if (outcome.failed()) return outcome.status;
  wrc_step_sensitivity result = abi::defaults<wrc_step_sensitivity>();
  std::copy_n(found.by_load, 4, result.by_load);
  std::copy_n(found.by_lateral, 4, result.by_lateral);
  abi::write(result, sensitivity);
  return outcome.status;
}
