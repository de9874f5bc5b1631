/// Constants of a wheel that rolls on a rail: both cross sections by arc length, the rail's strips, elastic
/// constants and tables. Immutable after creation; any number of contacts use one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/number.hpp"
#include "geometry/profile.hpp"
#include "kernels/kernels.hpp"
#include "normal/elasticity/influence_tables.hpp"
#include "patch/material.hpp"
#include "surface/geometry/surface_geometry.hpp"
#include "surface/pressure/planar_pressure.hpp"
#include "surface/pressure/pressure.hpp"
#include "surface/rolling/region_rolling.hpp"
#include "surface/rolling/surface_rolling.hpp"
#include "tangential/friction/flash_temperature.hpp"
#include "tangential/march/march_grid.hpp"

namespace wrc::surface {

/// Methods that solve a wheel on a rail.
struct SurfaceMethods {
  PlanarMethod planar;  ///< without `solve`: strips in half-space equilibrium on the surface
  SurfaceRollingMethod strips = SurfaceRollingMethod::strip_fastsim;
  bool parabolic = false;  ///< SurfaceRollingInput
  RegionRolling
      region;  ///< with `solve`: patch by patch where by_region, or the slope of the creep curve falls
  bool by_region = false;
  bool remembers = false;  ///< strips keep their tractions from step to step (rolling/remembering.hpp)
  const theory::SdecTable* linear_theory = nullptr;  ///< for patches that remember

  bool differentiable() const { return !planar.solve && !region.solve; }
};

/// The bodies, right-hand, as the caller gave them.
struct SurfaceBodies {
  geometry::Profile wheel;                          ///< from its own origin, z down
  geometry::Profile rail;                           ///< from its own origin, not canted
  double rail_inclination = 0.0;                    ///< tangent of the cant about that origin
  double rail_origin_y = 0.0, rail_origin_z = 0.0;  ///< right-hand rail, track axes [m]
  double nominal_radius = 0.0;                      ///< radius of the wheel at its profile's origin [m]
  std::int32_t sections = 0;                        ///< 0: the rail is the same everywhere
  const RailSection* section = nullptr;
  RadiusTable radius;             ///< without rows: the wheel is round
  double roller_curvature = 0.0;  ///< 1 / radius of a roller at its profile's origin; 0: a rail [1/m]
  patch::Material material;
  double coupling = 0.0;  ///< Kalker's K [-]
  tangential::Effusivities effusivities;
  // These outlive the model:
  const normal::InfluenceTables* influence = nullptr;
  const Kernels* kernels = nullptr;
  const theory::KalkerTable* ellipse = nullptr;  ///< at the material's Poisson ratio
  const tangential::MarchGrid* grid = nullptr;
  SurfaceMethods methods;
  StripWidths widths;  ///< widths of the rail's strips
  PressureOptions pressure;
};

/// Most strips a rail of up to four faces may be cut into, and most of them that may overlap a wheel at a
/// time.
inline constexpr std::int32_t most_strips_of_a_rail = 1024, most_overlapping_strips = 256;

/// Most strips a rail of so many faces may be cut into: each has a fourth of those of four, or more.
constexpr std::int32_t strips_of_a_rail(std::int32_t faces) {
  return faces > 4 ? 2 * most_strips_of_a_rail : most_strips_of_a_rail;
}
static_assert(strips_of_a_rail(most_rail_faces) / most_rail_faces == most_strips_of_a_rail / 4);
static_assert(strips_of_a_rail(most_rail_faces) <= second_places, "one bit above strips tells second places");

struct SurfaceModel : SurfaceGeometry {
  double rail_origin_y = 0.0, rail_origin_z = 0.0;  ///< right-hand rail, track axes [m]
  patch::Material material;
  double coupling = 0.0;  ///< Kalker's K [-]
  tangential::Effusivities effusivities;
  const normal::InfluenceTables* influence = nullptr;
  StripCoefficientTable coefficients;
  const tangential::MarchGrid* grid = nullptr;
  SurfaceMethods methods;
  PressureOptions pressure;           ///< options of a solution to the end
  std::int32_t most_overlapping = 0;  ///< overlapping_strips() of its widths
  std::int32_t rail_strips = 0;       ///< the rail's, with those between its faces
};

/// Strips of these widths that may overlap a wheel at a time: as many as 64 mm of a rail's tread and 16 mm of
/// its corner are cut into, within most_overlapping_strips. Memory goes with the square.
inline std::int32_t overlapping_strips(const StripWidths& widths) {
  constexpr double tread = 64e-3, corner = 16e-3;  // [m]
  const double strips = tread / widths.widest + corner / widths.narrowest;
  return static_cast<std::int32_t>(smaller(strips + 0.5, most_overlapping_strips));
}

/// `sections`, `section_nodes`, `faces`: how many, nodes of the longest, and surfaces that they are of.
std::size_t surface_model_bytes(std::int32_t wheel_nodes, std::int32_t rail_nodes, std::int32_t sections,
                                std::int32_t section_nodes, std::int32_t faces, const RadiusTable& radius);

/// Makes the model in memory of surface_model_bytes(), aligned as a double.
Fault make_surface_model(const SurfaceBodies& bodies, void* memory, const SurfaceModel*& model);

/// The model's constants of the normal problem.
inline PressureModel pressure_model(const SurfaceModel& model) {
  return {*model.influence, *model.kernels, model.material.normal_compliance(),
          changes(model.varying) ? lambda_length_along_track : usual_lambda_length, changes(model.varying)};
}

}  // namespace wrc::surface
