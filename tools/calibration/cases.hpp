/// Patches with their exact forces, and the files that hold them: CSV with the columns `wrc_compare sdec`
/// reads and three more: shift and shift_P, how far the extrapolation from the grids went, and strips, five
/// numbers [m, Pa] for each strip of a patch that is no SDEC.
#pragma once

#include <string>
#include <vector>

#include "exact_forces.hpp"
#include "random_patch.hpp"

namespace wrc::calibration {

struct Case {
  Patch patch;
  ExactForces exact;
};

inline constexpr const char* heading =
    "a_mm,b_mm,psi,nu,G_MPa,mu,N_kN,p0_MPa,cx,cy,phi_per_m,"
    "Fx_N,Fy_N,Mz_Nm,P_W_at_1mps,adh_frac,nx,ny,shift,shift_P,strips";

std::string text_of(const Patch& patch);  ///< the first columns
std::string text_of(const Case& c);       ///< a line, without its end

/// All cases of a file. Throws a sentence (std::string) where it cannot be read.
std::vector<Case> read_cases(const std::string& path);

}  // namespace wrc::calibration
