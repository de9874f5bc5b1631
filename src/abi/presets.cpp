/// Published methods, resolutions, friction and layers by name, each with its members.
#include "abi/presets.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "abi/fp_environment.hpp"
#include "abi/message.hpp"
#include "abi/structs.hpp"

namespace abi = wrc::abi;
using wrc::Fault;

namespace {

struct Preset {
  const char* name;
  int32_t method, patch_model, bound, flexibility, regularisation;
};

constexpr Preset presets[] = {
#define WRC_PRESET(identifier, name, method, model, bound, flexibility, regularisation, falls) \
  {name,                                                                                       \
   WRC_TANGENTIAL_##method,                                                                    \
   WRC_PATCH_MODEL_##model,                                                                    \
   WRC_BOUND_##bound,                                                                          \
   WRC_FLEXIBILITY_##flexibility,                                                              \
   WRC_REGULARISE_##regularisation},
    WRC_PRESET_LIST(WRC_PRESET)
#undef WRC_PRESET
};

struct Resolution {
  const char* name;
  double tread_width, corner_width, tolerance, max_work, max_iterations;
};

constexpr Resolution resolutions[] = {
#define WRC_RESOLUTION(identifier, name, ...) {name, __VA_ARGS__},
    WRC_RESOLUTION_LIST(WRC_RESOLUTION)
#undef WRC_RESOLUTION
};

constexpr const char* known_names = "no such method or resolution; there are"
#define WRC_PRESET(identifier, name, ...) " \"" name "\""
    WRC_PRESET_LIST(WRC_PRESET)
#undef WRC_PRESET
#define WRC_RESOLUTION(identifier, name, ...) " \"" name "\""
        WRC_RESOLUTION_LIST(WRC_RESOLUTION);
#undef WRC_RESOLUTION

struct NamedFriction {
  const char* name;
  double coefficient;
  int32_t speed_law;
  double kinetic_ratio, fall_rate, adhesion_reduction, slip_reduction;
  double thickness, modulus, yield, hardening;
};

constexpr NamedFriction frictions[] = {
#define WRC_FRICTION(identifier, name, coefficient, law, ratio, rate, adhesion, slip, thickness, modulus, \
                     yield, hardening, source, status)                                                    \
  {name, coefficient, WRC_SPEED_LAW_##law, ratio, rate, adhesion, slip, thickness, modulus, yield, hardening},
    WRC_FRICTION_LIST(WRC_FRICTION)
#undef WRC_FRICTION
};

constexpr const char* known_frictions = "no such friction; there are"
#define WRC_FRICTION(identifier, name, ...) " \"" name "\""
    WRC_FRICTION_LIST(WRC_FRICTION);
#undef WRC_FRICTION

Fault use(wrc_config* config, const char* name) {
  if (config == nullptr) return Fault::null("config");
  RETURN_IF_FAILED(abi::check_size(*config));
  if (name == nullptr) return Fault::null("name");
  const Preset* const preset = abi::row_of(presets, name);
  const Resolution* const resolution = abi::row_of(resolutions, name);
  if (preset == std::end(presets) && resolution == std::end(resolutions))
    return Fault::unsupported("name", known_names);
  wrc_config ours = abi::defaults<wrc_config>();
  const std::size_t known = std::min<std::size_t>(config->struct_size, sizeof ours);
  std::memcpy(&ours, config, known);  // not checked: other members may not be set yet
  if (preset != std::end(presets)) {
    wrc_config_tangential& tangential = ours.tangential;
    tangential.method = preset->method;
    tangential.patch_model = preset->patch_model;
    tangential.bound = preset->bound;
    tangential.flexibility = preset->flexibility;
    ours.planar.regularisation = preset->regularisation;
  } else {
    wrc_config_surface& surface = ours.surface;
    surface.tread_width = resolution->tread_width;
    surface.corner_width = resolution->corner_width;
    surface.tolerance = resolution->tolerance;
    surface.max_work = resolution->max_work;
    surface.max_iterations = resolution->max_iterations;
  }
  ours.struct_size = config->struct_size;
  std::memcpy(config, &ours, known);  // members of a newer header stay
  return {};
}

}  // namespace

Fault wrc::abi::use_friction(wrc_friction* friction, const char* name) {
  if (friction == nullptr) return Fault::null("friction");
  if (name == nullptr) return Fault::null("name");
  const NamedFriction* const row = abi::row_of(frictions, name);
  if (row == std::end(frictions)) return Fault::unsupported("name", known_frictions);
  friction->coefficient = row->coefficient;
  friction->speed_law = row->speed_law;
  friction->kinetic_ratio = row->kinetic_ratio;
  friction->fall_rate = row->fall_rate;
  friction->slope_reduction = 1.0;
  friction->slope_fall = 0.0;
  friction->adhesion_reduction = row->adhesion_reduction;
  friction->slip_reduction = row->slip_reduction;
  friction->layer_thickness = row->thickness;
  friction->layer_modulus = row->modulus;
  friction->layer_yield = row->yield;
  friction->layer_hardening = row->hardening;
  return {};
}

extern "C" int32_t wrc_friction_use(wrc_friction* friction, const char* name, char* text, uint64_t size) {
  return abi::finish(__func__, abi::use_friction(friction, name), text, size);
}

extern "C" int32_t wrc_config_use(wrc_config* config, const char* name, char* text, uint64_t size) {
  return abi::finish(__func__, use(config, name), text, size);
}
