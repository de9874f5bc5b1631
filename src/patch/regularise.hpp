/// Regularisation of any contact patch to an equivalent SDEC region.
///
/// Criteria of Piotrowski, Liu and Bruni (2017), and the source paper's variant that keeps the width:
///   (1)  pi a b = area of the patch
///   (2)  a / b = length / width,     or   (2b)  2 b = width
///   (3)  the joint lies at the initial contact point: psi = y_mid / b, y_mid the middle of the patch's
///        width seen from there.
#pragma once

#include "base/fault.hpp"
#include "patch/sdec.hpp"
#include "patch/strips.hpp"

namespace wrc::patch {

enum class SecondCriterion {
  width,         ///< (2b): b as in the patch
  aspect_ratio,  ///< (2): a / b as in the patch
};

/// Largest |psi| handed out: beyond it one half ellipse is a sliver the linear theory has no coefficients
/// for.
inline constexpr double largest_psi = 0.95;

/// The equivalent SDEC region of a patch; `y_contact` is the initial contact point [m]. |psi| is clipped to
/// largest_psi, which happens when the contact point lies near or beyond a border of the patch, and flagged
/// with WRC_FLAG_TABLE_RANGE. WRC_FLAG_NO_CONTACT for a patch without strips.
Fault regularise(const StripTotals& patch, double y_contact, SecondCriterion criterion, Sdec& sdec) noexcept;

}  // namespace wrc::patch
