/// Patches with their exact forces, and the files that hold them: CSV with the columns `wrc_compare sdec`
/// reads and three more: shift and shift_P, how far the extrapolation from the grids went, and strips, five
/// numbers [m, Pa] for each strip of a patch that is no SDEC.
#pragma once

#include <functional>
#include <sstream>
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

/// Calls take(row) for each row of a file of make_patches, with blanks in place of commas. `first`: the
/// file's heading; `kind`: its name for the message. take returns false where a row is not complete. Throws a
/// sentence (std::string) then, and where the file has another heading.
void read_rows(const std::string& path, const char* first, const char* kind,
               const std::function<bool(std::istringstream&)>& take);

/// All cases of a file. Throws a sentence (std::string) where it cannot be read.
std::vector<Case> read_cases(const std::string& path);

}  // namespace wrc::calibration
