/// Published methods by name: what a configuration is made of for each.
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

constexpr const char* known_names = "no such method; there are"
#define WRC_PRESET(identifier, name, ...) " \"" name "\""
    WRC_PRESET_LIST(WRC_PRESET);
#undef WRC_PRESET

Fault use(wrc_config* config, const char* name) {
  if (config == nullptr) return Fault::null("config");
  RETURN_IF_FAILED(abi::check_size(*config));
  if (name == nullptr) return Fault::null("name");
  const Preset* const preset = std::find_if(std::begin(presets), std::end(presets), [&](const Preset& each) {
    return std::strcmp(each.name, name) == 0;
  });
  if (preset == std::end(presets)) return Fault::unsupported("name", known_names);
  wrc_config ours = abi::defaults<wrc_config>();
  const std::size_t known = std::min<std::size_t>(config->struct_size, sizeof ours);
  std::memcpy(&ours, config, known);  // not checked: other members may not be set yet
  wrc_config_tangential& tangential = ours.tangential;
  tangential.method = preset->method;
  tangential.patch_model = preset->patch_model;
  tangential.bound = preset->bound;
  tangential.flexibility = preset->flexibility;
  ours.planar.regularisation = preset->regularisation;
  ours.struct_size = config->struct_size;
  std::memcpy(config, &ours, known);  // members of a newer header stay
  return {};
}

}  // namespace

extern "C" int32_t wrc_config_use(wrc_config* config, const char* name, char* text, uint64_t size) {
  return abi::finish(__func__, use(config, name), text, size);
}
