/// Stand-in until the room's solver is there: Winkler strips, full slip.
#pragma once
#include <cstddef>
#include "geometry/profile.hpp"
#include "patch/material.hpp"
#include "surface/wheel_on_rail.hpp"
namespace wrc::stand_in {
struct SurfaceBodies {
  Profile wheel;  ///< as given: from its own origin
  Profile rail;   ///< as given, not canted
  double rail_inclination = 0.0;
  double rail_origin_y = 0.0, rail_origin_z = 0.0;  ///< of the right-hand rail, track axes
  double nominal_radius = 0.0;
  Material material;
};
struct SurfaceStrip { double s, y, z, ny, nz, width; };
struct SurfaceModel {
  double r0, rail_y, rail_z; Material material; std::int32_t strips, nodes;
  SurfaceStrip strip[1024]; double wy[2048], wz[2048];
};
struct SurfaceState { double unused[8]; };
std::size_t surface_model_bytes(std::int32_t wheel_nodes, std::int32_t rail_nodes);
std::int64_t surface_state_bytes();
std::int64_t surface_workspace_bytes();
Fault make_surface_model(const SurfaceBodies&, void* memory, const SurfaceModel*& model);
Fault solve_wheel_on_rail(const SurfaceModel&, const WheelOnRail&, SurfaceState&, void*, Wrench&) noexcept;
double strip_angle(const SurfaceModel&, std::int32_t strip);
}
