/// What tests begin with: structs of the interface with their size set, and a configuration of the source
/// paper's steel, for which their numbers are stated.
#pragma once

#include "wrc/wrc_offline.h"

/// A struct of the interface without a default function: its size, everything else zero.
template <typename Struct>
Struct sized() {
  Struct value{};
  if constexpr (requires { value.struct_size; }) value.struct_size = sizeof value;
  return value;
}

/// G = 80 GPa, nu = 0.25.
inline wrc_material steel_of_the_paper() {
  wrc_material steel = wrc_material_default();
  steel.shear_modulus = 80e9;
  steel.poisson = 0.25;
  return steel;
}

/// The defaults, of the paper's steel.
inline wrc_config test_config() {
  wrc_config config = wrc_config_default();
  config.wheel_material = config.rail_material = steel_of_the_paper();
  return config;
}

/// A problem of the exact solvers with its defaults, of the paper's steel.
template <typename Problem>
Problem of_the_papers_steel(Problem problem) {
  problem.wheel_material = problem.rail_material = steel_of_the_paper();
  return problem;
}
