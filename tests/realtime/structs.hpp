/// What every program in this folder does with the C interface first: structs get their size, then their
/// defaults.
#pragma once

#include <cstdint>

#include "made.hpp"
#include "wrc/wrc.h"

/// Names of the methods, in the order of their enumerations in wrc.h.
inline constexpr const char* normal_names[] = {"hertz",   "kik_piotrowski", "ekp", "ekp_ellipse", "analyn",
                                               "stripes", "strip_halfspace"};
inline constexpr const char* tangential_names[] = {"fastsim", "fastsim_eqe", "fastsim_eql", "fastsim_sdec",
                                                   "strip_fastsim"};
inline constexpr int32_t normal_methods = WRC_NORMAL_STRIP_HALFSPACE + 1;
inline constexpr int32_t tangential_methods = WRC_TANGENTIAL_STRIP_FASTSIM + 1;
