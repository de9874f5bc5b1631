/// The methods of wrc_methods.h for tests that go through all of them.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "test_config.hpp"
#include "wrc/wrc.h"

/// Normal methods by identifier, in the order of their values.
#define WRC_METHOD(identifier, value) #identifier,
inline constexpr const char* normal_names[] = {WRC_NORMAL_METHOD_LIST(WRC_METHOD)};
#undef WRC_METHOD
inline constexpr std::int32_t normal_methods = sizeof normal_names / sizeof *normal_names;

/// Numbers of the published tangential methods, in the order of their list.
enum : std::int32_t {
#define WRC_PRESET(identifier, ...) preset_##identifier,
  WRC_PRESET_LIST(WRC_PRESET)
#undef WRC_PRESET
      tangential_methods
};

/// A published tangential method: what it is called and what it is made of.
struct Preset {
  const char* identifier;
  const char* name;
  std::int32_t method;
  bool slope_falls;
};

inline constexpr Preset presets[] = {
#define WRC_PRESET(identifier, name, method, model, bound, flexibility, regularisation, falls) \
  {#identifier, name, WRC_TANGENTIAL_##method, falls != 0},
    WRC_PRESET_LIST(WRC_PRESET)
#undef WRC_PRESET
};

/// Takes a published tangential method, and the force table for the one that reads it.
inline void choose_tangential(wrc_config& config, std::int32_t preset) {
  char text[512] = "";
  if (wrc_config_use(&config, presets[preset].name, text, sizeof text) != WRC_OK) {
    std::fprintf(stderr, "%s\n", text);
    std::abort();
  }
  config.tangential.force_table =
      presets[preset].method == WRC_TANGENTIAL_FORCE_TABLE ? WRC_FORCE_TABLE : nullptr;
}

/// The slope falls in modified FASTSIM.
inline double slope_fall_for(std::int32_t preset) { return presets[preset].slope_falls ? 0.6 : 0.0; }

/// Does a tangential method give tractions and slip? The force table and Polach's law give forces alone.
inline bool method_gives_tractions(std::int32_t method) {
  return method != WRC_TANGENTIAL_FORCE_TABLE && method != WRC_TANGENTIAL_POLACH;
}
inline bool gives_tractions(std::int32_t preset) { return method_gives_tractions(presets[preset].method); }

/// The same of a contact's method, of a contact with a solution.
inline bool gives_tractions(wrc_contact* contact) {
  std::uint64_t counts[2];
  return wrc_contact_field(contact, 0, WRC_FIELD_TRACTION_X, nullptr, 0, counts) != WRC_ERROR_UNSUPPORTED;
}
