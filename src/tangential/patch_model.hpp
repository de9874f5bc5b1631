/// How FASTSIM and FaStrip see a patch: on which strips tractions live, and whose linear theory they follow.
#pragma once

namespace wrc::tangential {

/// With an ellipse creepages, forces and y refer to the ellipse's centre.
struct PatchModel {
  bool on_ellipse = false;  ///< on the strips of the equivalent ellipse; otherwise on those of the patch
  bool at_middle =
      false;            ///< that ellipse lies about the patch's mid-width; otherwise about its contact point
  bool of_sdec = true;  ///< coefficients of the equivalent double ellipse; otherwise of the ellipse
};

inline constexpr PatchModel patch_with_sdec{};
inline constexpr PatchModel patch_with_ellipse{.of_sdec = false};
inline constexpr PatchModel ellipse_at_middle{.on_ellipse = true, .at_middle = true, .of_sdec = false};
inline constexpr PatchModel ellipse_at_point{.on_ellipse = true, .of_sdec = false};

}  // namespace wrc::tangential
