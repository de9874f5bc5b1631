/// FASTSIM and FaStrip by their published names: each is the method on its patch model. FASTSIM-SDEC and
/// FaStrip-SDEC are fastsim() and fastrip() as they stand.
#pragma once

#include "tangential/methods/fastrip.hpp"
#include "tangential/methods/fastsim.hpp"

namespace wrc::test {

inline tangential::RollingContact on(const tangential::PatchModel& model,
                                     tangential::RollingContact contact) {
  contact.model = model;
  return contact;
}

/// contact.region: the strips of the ellipse.
inline tangential::TangentialForces fastsim_ellipse(
    const tangential::RollingContact& contact, const tangential::TangentialFields& fields, Fault& fault,
    tangential::TangentialSensitivities* sensitivities = nullptr) {
  return tangential::fastsim(on(tangential::ellipse_at_point, contact), fields, fault, sensitivities);
}

/// contact.region: the strips of the ellipse about its own centre; creepages and forces at the contact point.
inline tangential::TangentialForces fastsim_eqe(
    const tangential::RollingContact& contact, const tangential::TangentialFields& fields, Fault& fault,
    tangential::TangentialSensitivities* sensitivities = nullptr) {
  tangential::RollingContact at_centre = on(tangential::ellipse_at_middle, contact);
  const double centre = contact.shape_number * contact.b;
  at_centre.creepage = tangential::seen_from(centre, contact.creepage);
  tangential::TangentialForces forces = tangential::fastsim(at_centre, fields, fault, sensitivities);
  tangential::refer_back(centre, forces, sensitivities);
  return forces;
}

inline tangential::TangentialForces fastsim_eql(
    const tangential::RollingContact& contact, const tangential::TangentialFields& fields, Fault& fault,
    tangential::TangentialSensitivities* sensitivities = nullptr) {
  return tangential::fastsim(on(tangential::patch_with_ellipse, contact), fields, fault, sensitivities);
}

/// contact.region: the strips of the ellipse.
inline tangential::TangentialForces fastrip_ellipse(const tangential::RollingContact& contact,
                                                    const tangential::TangentialFields& fields,
                                                    Fault& fault) {
  return tangential::fastrip(on(tangential::ellipse_at_point, contact), fields, fault);
}

inline tangential::TangentialForces fastrip_modified(const tangential::RollingContact& contact,
                                                     const tangential::TangentialFields& fields,
                                                     Fault& fault) {
  return tangential::fastrip(on(tangential::patch_with_ellipse, contact), fields, fault);
}

}  // namespace wrc::test
