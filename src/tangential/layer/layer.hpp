/// An elasto-plastic layer between the bodies: a spring along the surface that yields.
///
/// Along each strip particles carry tractions p, and the displacement u of the bodies and of the layer's
/// spring. They carry the traction tau at which the layer yields, and how far it has flowed.
///
///     u = (bodies' part) + F p,                          F = thickness / shear modulus,
///     |p| <= min(mu p_n, tau),   tau = tau_0 + k lambda,  lambda the length of all flow, tau >= tau_0 / 10,
///
/// The layer is fresh at the leading edge: p = 0, tau = tau_0. Flow goes along the traction, sliding against
/// it. The model is that of Vollebregt's CONTACT (interfacial layer, M = 4); see theory.md, "A layer between
/// the bodies".
#pragma once

#include <cstdint>

namespace wrc::tangential {

/// Without padding: part of a contact's saved state.
template <class Number>
struct LayerOf {
  Number flexibility = 0.0;  ///< F [m/Pa]
  Number yield = 0.0;        ///< tau_0; 0: it does not yield [Pa]
  Number hardening = 0.0;    ///< k; < 0: it softens [Pa/m]

  bool present() const { return flexibility > 0.0 || yield > 0.0; }
};
using Layer = LayerOf<double>;

/// Share of tau_0 that softening leaves.
inline constexpr double least_yield = 0.1;

/// Numbers of a strip for the march, about its own middle. Displacements are over the half length, tractions
/// over the bound mu p at the middle; so slips need no unit.
struct LayeredNumbers {
  enum Number : std::int32_t {
    stick_x,  ///< slip at the strip's middle that moves particles which stick [-]
    stick_y,
    stick_turn,  ///< growth of stick_y per half length forwards [-]
    slip_x,      ///< slip at the middle that turns tractions of particles which slip [-]
    slip_y,
    slip_turn,  ///< growth of slip_y per half length forwards [-]
    bodies_x,   ///< displacement of the bodies by the bound, in the shape of strip theory
    bodies_y,
    spring_x,  ///< displacement by the bound that is linear in the traction: the layer's
    spring_y,
    turn_x,  ///< displacement of the bodies by the bound that resists turning
    turn_y,
    yield,      ///< tau_0 over the bound
    hardening,  ///< k times half length over the bound
    numbers
  };
};

template <class Number>
struct LayeredStrip {
  Number of[LayeredNumbers::numbers];
};

}  // namespace wrc::tangential
