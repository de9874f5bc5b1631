#include "tangential/fastsim_eqe.hpp"

#include "tangential/flexibility_form.hpp"
#include "tangential/march.hpp"

namespace wrc {

TangentialForces fastsim_eqe(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                             TangentialSensitivities* sensitivities) {
  const Flexibility separate = ellipse_flexibility(contact.a, contact.b, contact.shear_modulus,
                                                   contact.linear_theory->ellipse(), fault);
  const double y_centre = contact.shape_number * contact.b;
  Creepage at_centre = contact.creepage;
  at_centre.longitudinal -= at_centre.spin * y_centre;
  const Flexibility flexibility = in_form(separate, contact, 0.0, at_centre);
  TangentialForces forces = march({contact.region, at_centre, flexibility, contact.friction, contact.bound},
                                  *contact.grid, fields, sensitivities);
  forces.mz -= y_centre * forces.fx;
  if (sensitivities) refer_to(y_centre, *sensitivities);
  return forces;
}

}  // namespace wrc
