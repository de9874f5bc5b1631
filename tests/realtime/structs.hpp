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

/// Takes a tangential method, and the book of tables for the one that reads it.
inline void choose_tangential(wrc_config& config, int32_t method) {
  config.tangential_method = method;
  config.force_table = method == WRC_TANGENTIAL_TABLE ? WRC_FORCE_TABLE : nullptr;
}

/// The modified FASTSIM's slope falls; every other method refuses a fall it does not read.
inline double slope_fall_for(int32_t tangential_method) {
  return tangential_method == WRC_TANGENTIAL_MODIFIED_FASTSIM ? 0.6 : 0.0;
}

/// Has this processor, and this build, the instruction set?
inline bool available(int32_t instruction_set) {
  wrc_config config = made<wrc_config>(wrc_config_init);
  config.instruction_set = instruction_set;
  return wrc_config_check(&config, nullptr, 0) == WRC_OK;
}
