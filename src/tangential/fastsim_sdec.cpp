#include "tangential/fastsim_sdec.hpp"

#include "tangential/march.hpp"

namespace wrc {

TangentialForces fastsim_sdec(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                              TangentialSensitivities* sensitivities) {
  const Flexibility flexibility = sdec_flexibility(contact.a, contact.b, contact.shape_number,
                                                   contact.shear_modulus, *contact.linear_theory, fault);
  return march({contact.region, contact.creepage, flexibility, contact.friction, contact.bound},
               *contact.grid, fields, sensitivities);
}

}  // namespace wrc
