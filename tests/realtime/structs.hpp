/// What every program in this folder does with the C interface first: structs get their size, then their
/// defaults.
#pragma once

#include <cstdint>
#include <iterator>

#include "made.hpp"
#include "wrc/wrc.h"

/// Names of the methods, in the order of their enumerations in wrc.h.
inline constexpr const char* normal_names[] = {"hertz",   "kik_piotrowski", "ekp", "ekp_ellipse", "analyn",
                                               "stripes", "strip_halfspace"};
inline constexpr const char* tangential_names[] = {
    "fastsim",          "fastsim_eqe", "fastsim_eql",      "fastsim_sdec", "strip_fastsim",   "table",
    "modified_fastsim", "fastrip",     "fastrip_modified", "fastrip_sdec", "coarse_halfspace"};
inline constexpr int32_t normal_methods = WRC_NORMAL_STRIP_HALFSPACE + 1;
inline constexpr int32_t tangential_methods = WRC_TANGENTIAL_COARSE_HALFSPACE + 1;
static_assert(std::size(normal_names) == normal_methods && std::size(tangential_names) == tangential_methods);

/// The default configuration, with the book of tables at hand for the method that asks for it.
inline wrc_config made_config() {
  wrc_config config = made<wrc_config>(wrc_config_init);
  config.force_table = WRC_FORCE_TABLE;
  return config;
}

/// Has this processor, and this build, the instruction set?
inline bool available(int32_t instruction_set) {
  wrc_config config = made<wrc_config>(wrc_config_init);
  config.instruction_set = instruction_set;
  return wrc_config_check(&config, nullptr, 0) == WRC_OK;
}
