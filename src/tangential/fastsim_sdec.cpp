#include "tangential/fastsim_sdec.hpp"

#include "tangential/flexibility_form.hpp"
#include "tangential/march.hpp"

namespace wrc {

TangentialForces fastsim_sdec(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                              TangentialSensitivities* sensitivities) {
  const Flexibility separate = sdec_flexibility(contact.a, contact.b, contact.shape_number,
                                                contact.shear_modulus, *contact.linear_theory, fault);
  const Flexibility flexibility = in_form(separate, contact, contact.shape_number, contact.creepage);
  return march({contact.region, contact.creepage, flexibility, contact.friction, contact.bound},
               *contact.grid, fields, sensitivities);
}

}  // namespace wrc
