/// Plain numbers of the theory that need no contact.
#include "abi/fp_environment.hpp"
#include "abi/structs.hpp"
#include "damage/fatigue.hpp"
#include "theory/sdec.hpp"

namespace wrc::abi {
namespace {

std::int32_t limit(double utilisation, double* load_factor, double (*of)(double)) {
  if (load_factor == nullptr) return WRC_ERROR_NULL;
  *load_factor = 0.0;
  const FloatingPointScope scope;
  const Fault fault = check(utilisation, "utilisation", "", 0.0, 10.0);
  if (!fault.failed()) *load_factor = of(utilisation);
  return fault.status;
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;
using wrc::Fault;

extern "C" {

int32_t wrc_linear_coefficients(double a_over_b, double psi, double poisson, wrc_coefficients* coefficients) {
  if (coefficients == nullptr) return WRC_ERROR_NULL;
  const abi::FloatingPointScope scope;
  for (const Fault& fault :
       {abi::clear(coefficients), abi::check(a_over_b, "a_over_b", "", 1e-3, 1e3),
        abi::check(psi, "psi", "", -0.95, 0.95), abi::check(poisson, "poisson", "", 0.0, 0.5)}) {
    if (fault.failed()) return fault.status;
  }
  const wrc::theory::SdecTable table(poisson);
  Fault fault;
  const wrc::theory::KalkerCoefficients kalker = table.ellipse().at(a_over_b, fault);
  const wrc::theory::SdecCoefficients sdec = table.at(a_over_b, psi, fault);
  wrc_coefficients ours = abi::defaults<wrc_coefficients>();
  ours.c11 = kalker.c11;
  ours.c22 = kalker.c22;
  ours.c23 = kalker.c23;
  ours.c11s = sdec.c11;
  ours.c13s = sdec.c13;
  ours.c22s = sdec.c22;
  ours.c23s = sdec.c23;
  abi::write(ours, coefficients);
  return fault.status;
}

int32_t wrc_shakedown_limit(double utilisation, double* load_factor) {
  return abi::limit(utilisation, load_factor, wrc::damage::shakedown_limit);
}

int32_t wrc_shakedown_limit_point(double utilisation, double* load_factor) {
  return abi::limit(utilisation, load_factor, wrc::damage::shakedown_limit_of_point);
}

}  // extern "C"
