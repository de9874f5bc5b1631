/// What every program in this folder does with the C interface first: structs get their size, then their
/// defaults.
#pragma once

#include <cstdint>

#include "made.hpp"
#include "wrc/wrc.h"

/// Names of the methods, in the order of their enumerations in wrc.h.
inline constexpr const char* normal_names[] = {"hertz",   "kik_piotrowski", "ekp", "ekp_ellipse", "analyn",
                                               "stripes", "strip_halfspace"};
inline constexpr const char* tangential_names[] = {
    "fastsim",          "fastsim_eqe", "fastsim_eql",      "fastsim_sdec", "strip_fastsim",   "table",
    "modified_fastsim", "fastrip",     "fastrip_modified", "fastrip_sdec", "coarse_halfspace"};
inline constexpr int32_t normal_methods = WRC_NORMAL_STRIP_HALFSPACE + 1;
/// All but the book of tables, which has no fields.
inline constexpr int32_t tangential_methods[] = {
    WRC_TANGENTIAL_FASTSIM,         WRC_TANGENTIAL_FASTSIM_EQE,      WRC_TANGENTIAL_FASTSIM_EQL,
    WRC_TANGENTIAL_FASTSIM_SDEC,    WRC_TANGENTIAL_STRIP_FASTSIM,    WRC_TANGENTIAL_MODIFIED_FASTSIM,
    WRC_TANGENTIAL_FASTRIP,         WRC_TANGENTIAL_FASTRIP_MODIFIED, WRC_TANGENTIAL_FASTRIP_SDEC,
    WRC_TANGENTIAL_COARSE_HALFSPACE};
