#include "tangential/fastsim_eql.hpp"

#include "tangential/flexibility_form.hpp"
#include "tangential/march.hpp"

namespace wrc {

TangentialForces fastsim_eql(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                             TangentialSensitivities* sensitivities) {
  const Flexibility separate = ellipse_flexibility(contact.a, contact.b, contact.shear_modulus,
                                                   contact.linear_theory->ellipse(), fault);
  const Flexibility flexibility = in_form(separate, contact, 0.0, contact.creepage);
  return march({contact.region, contact.creepage, flexibility, contact.friction, contact.bound},
               *contact.grid, fields, sensitivities);
}

}  // namespace wrc
