/// FASTSIM and FaStrip by their published names: each is the method on its patch model. FASTSIM-SDEC and
/// FaStrip-SDEC are fastsim() and fastrip() as they stand.
#pragma once

#include "tangential/methods/fastrip.hpp"
#include "tangential/methods/fastsim.hpp"

namespace wrc::test {

inline RollingContact on(const PatchModel& model, RollingContact contact) {
  contact.model = model;
  return contact;
}

/// contact.region: the strips of the ellipse.
inline TangentialForces fastsim_ellipse(const RollingContact& contact, const TangentialFields& fields,
                                        Fault& fault, TangentialSensitivities* sensitivities = nullptr) {
  return fastsim(on(ellipse_at_point, contact), fields, fault, sensitivities);
}

/// contact.region: the strips of the ellipse about its own centre; creepages and forces at the contact point.
inline TangentialForces fastsim_eqe(const RollingContact& contact, const TangentialFields& fields,
                                    Fault& fault, TangentialSensitivities* sensitivities = nullptr) {
  RollingContact at_centre = on(ellipse_at_middle, contact);
  const double centre = contact.shape_number * contact.b;
  at_centre.creepage = seen_from(centre, contact.creepage);
  TangentialForces forces = fastsim(at_centre, fields, fault, sensitivities);
  refer_back(centre, forces, sensitivities);
  return forces;
}

inline TangentialForces fastsim_eql(const RollingContact& contact, const TangentialFields& fields,
                                    Fault& fault, TangentialSensitivities* sensitivities = nullptr) {
  return fastsim(on(patch_with_ellipse, contact), fields, fault, sensitivities);
}

/// contact.region: the strips of the ellipse.
inline TangentialForces fastrip_ellipse(const RollingContact& contact, const TangentialFields& fields,
                                        Fault& fault) {
  return fastrip(on(ellipse_at_point, contact), fields, fault);
}

inline TangentialForces fastrip_modified(const RollingContact& contact, const TangentialFields& fields,
                                         Fault& fault) {
  return fastrip(on(patch_with_ellipse, contact), fields, fault);
}

}  // namespace wrc::test
