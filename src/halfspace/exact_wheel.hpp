/// A host's wheel on a rail, solved exactly: the bodies of a contact's model as the exact solver has them,
/// the solution, and the wrench in the host's axes.
#pragma once

#include "contact/wheel.hpp"
#include "halfspace/surface_contact.hpp"

namespace wrc::halfspace {

/// Solves `hosted`; `regions` becomes the number of regions in contact, whose places `result` does not have.
/// Friction must not fall with the temperature.
Fault solve_exact_wheel(const contact::Contact& contact, const contact::HostWheel& hosted,
                        const SurfaceOptions& options, const ProgressCallback& progress,
                        contact::HostWrench& result, std::int32_t& regions);

}  // namespace wrc::halfspace
