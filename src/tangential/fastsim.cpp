#include "tangential/fastsim.hpp"

#include "tangential/march.hpp"

namespace wrc {

TangentialForces fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                         TangentialSensitivities* sensitivities) {
  const Flexibility flexibility = ellipse_flexibility(contact.a, contact.b, contact.shear_modulus,
                                                      contact.linear_theory->ellipse(), fault);
  return march({contact.region, contact.creepage, flexibility, contact.friction, contact.bound},
               *contact.grid, fields, sensitivities);
}

}  // namespace wrc
