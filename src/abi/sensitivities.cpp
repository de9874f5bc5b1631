/// Derivatives of the forces, handed back.
#include <algorithm>

#include "abi/call.hpp"
#include "contact/stages.hpp"
#include "wrc/wrc_planar.h"

namespace abi = wrc::abi;

extern "C" int32_t wrc_planar_tangential_derivatives(wrc_contact* handle,
                                                     wrc_planar_derivatives* derivatives) {
  return abi::call(__func__, handle, abi::clear(derivatives), [&](wrc::contact::Contact& contact) {
    wrc::tangential::TangentialSensitivities found;
    const wrc::Fault outcome = wrc::contact::find_sensitivities(contact, found);
    if (outcome.failed()) return outcome;
    wrc_planar_derivatives result = abi::defaults<wrc_planar_derivatives>();
    constexpr int columns = 5;
    for (int i = 0; i < 3; ++i) std::copy_n(found.d[i], columns, result.forces[i]);
    abi::write(result, derivatives);
    return outcome;
  });
}
