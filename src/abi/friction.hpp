/// Friction across the boundary.
#pragma once

#include "base/fault.hpp"
#include "contact/methods.hpp"
#include "contact/state.hpp"
#include "tangential/friction/film_rows.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// Films in rows are refused, or read by read_films().
enum class Films { refused, apart };

/// Translates friction whose members have been checked, and checks it for a tangential method. `of`: its
/// name in messages. The zones of the result are the caller's arrays.
Fault read_friction(const wrc_friction& checked, const char* of, const contact::TangentialMethod& method,
                    contact::Friction& friction, Films films = Films::refused);

/// Reads the films in rows of friction whose members have been checked; without rows `films` is empty.
Fault read_films(const wrc_friction& checked, const char* of, const contact::TangentialMethod& method,
                 tangential::FilmRows& films);

/// A layer, whole or absent, of any struct with its four members.
template <class Struct>
Fault read_layer(const Struct& checked, const char* of, tangential::Layer& layer) {
  const double thickness = checked.layer_thickness, modulus = checked.layer_modulus;
  const bool shears = thickness > 0.0;
  if (shears && modulus == 0.0) {
    return Fault::range({of, "layer_modulus"}, {modulus, "Pa", 1e3, 1e12},
                        "a layer with a thickness needs a shear modulus");
  }
  if (!shears && modulus > 0.0) {
    return Fault::range({of, "layer_modulus"}, {modulus, "Pa", 0.0, 0.0},
                        "layer_thickness is 0: a layer that does not shear has no shear modulus");
  }
  layer = {shears ? thickness / modulus : 0.0, checked.layer_yield, checked.layer_hardening};
  if (layer.hardening != 0.0 && layer.yield == 0.0) {
    return Fault::range({of, "layer_hardening"}, {layer.hardening, "Pa/m", 0.0, 0.0},
                        "layer_yield is 0: a layer that does not yield cannot harden");
  }
  // softening faster than the layer gives way would let tractions jump
  if (shears && layer.hardening < -0.5 / layer.flexibility) {
    return Fault::range(
        {of, "layer_hardening"}, {layer.hardening, "Pa/m", -0.5 / layer.flexibility, 1e14},
        "it softens faster than half of layer_modulus / layer_thickness: tractions would jump");
  }
  return {};
}

}  // namespace wrc::abi
