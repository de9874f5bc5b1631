/// The model: everything about a contact pair that does not change during a run. Immutable once made, so any
/// number of contacts and threads share it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/fault.hpp"
#include "contact/layout.hpp"
#include "geometry/arc_length.hpp"
#include "geometry/placement.hpp"
#include "geometry/profile.hpp"
#include "kernels/kernels.hpp"
#include "normal/strip_halfspace/strip_halfspace.hpp"
#include "patch/material.hpp"
#include "patch/regularise.hpp"
#include "surface/surface_model.hpp"
#include "tangential/force_table/force_table.hpp"
#include "tangential/friction/flash_temperature.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/problem.hpp"
#include "tangential/rolling_contact.hpp"
#include "theory/sdec.hpp"

namespace wrc::contact {

struct NormalMethod;
struct TangentialMethod;

/// Source of a profile: a standard shape or points of the caller.
struct ProfileSource {
  enum class Kind { none, points, s1002, rail_60e1, rail_uic60_benchmark } kind = Kind::none;
  std::int32_t count = 0;
  const double* y = nullptr;  ///< [m]
  const double* z = nullptr;  ///< [m]
  double smoothing = 0.0;     ///< wavelength below which waves of the points are damped; 0: kept [m]
};

/// A cross section of a rail that changes along the track, as the caller has it
/// (surface/geometry/varying_rail.hpp).
struct RailSectionSource {
  surface::RailSection section;  ///< all but its profile
  ProfileSource profile;
};

/// The caller's sections, which are read one by one while the model is made.
struct RailSectionSources {
  std::int32_t count = 0;
  const void* given = nullptr;
  RailSectionSource (*read)(const void* given, std::int32_t k) = nullptr;
};

struct ModelOptions {
  const NormalMethod* normal_method = nullptr;  ///< a row of methods.hpp
  patch::SecondCriterion regularisation = patch::SecondCriterion::width;
  const TangentialMethod* tangential_method = nullptr;  ///< see normal_method
  tangential::PatchModel patch_model;                   ///< ignored by methods that do not read it
  tangential::TractionBound traction_bound = tangential::TractionBound::parabolic;
  tangential::FlexibilityForm flexibility = tangential::FlexibilityForm::separate;
  InstructionSet instruction_set = InstructionSet::baseline;  ///< one this processor has
  ArraySizes sizes;
  std::int32_t surface_cells = 0;  ///< along each strip of a wheel on a rail
  surface::StripWidths strip_widths;
  surface::PressureOptions pressure;  ///< options of a wheel on a rail
  std::int32_t max_patches = 0;
  std::int32_t max_iterations = 0, max_sweeps = 0;
  bool non_steady = false;        ///< contacts remember their tractions
  bool surface_memory = false;    ///< contacts of a wheel on a rail remember their tractions
  bool warm_start = false;        ///< does the strip half-space solver begin with the last solution?
  patch::Material material;       ///< combined
  double coupling = 0.0;          ///< Kalker's K [-]
  double load_tolerance = 0.0;    ///< relative
  double gap_limit = 0.0;         ///< [m]
  double roller_curvature = 0.0;  ///< curvature of a rail that is a roller, at its profile's origin [1/m]
  std::uint64_t numbers = 0;      ///< checksum of all numbers of the configuration that results depend on
  double shear_yield = 0.0;       ///< k [Pa]
  tangential::Effusivities effusivities;
  double wheel_poisson = 0.0,
         rail_poisson = 0.0;  ///< Poisson ratio of each body by itself; `material` has both combined [-]
  geometry::TrackDimensions track;
  geometry::WheelsetDimensions wheelset;
  ProfileSource wheel, rail;
  RailSectionSources sections;  ///< cross sections, those of a check rail, too
  bool check_rail = false;
  surface::RadiusTable radius;
  const char* force_table = nullptr;            ///< file, for the methods that read it
  tangential::ForceTableAxes force_table_axes;  ///< axes of that file; no nodes: no table
};

/// Wheel and rail of one side, as placed.
struct Bodies {
  geometry::Wheel wheel;
  geometry::Rail rail;
};

/// The options, and the profiles as placed; its arrays follow it in the same block of memory.
struct Model {
  ModelOptions options;  ///< profile sources and file name cleared: no pointer of the caller is kept
  bool has_geometry = false;
  Bodies bodies[2];                  ///< right and left; meaningful with has_geometry
  geometry::MeasuredProfile arc[2];  ///< arc lengths of the right-hand wheel and rail
  double wheel_deviation = 0.0;      ///< largest distance of a given point from the smoothed curve [m]
  double rail_deviation = 0.0;       ///< see wheel_deviation
  const normal::InfluenceTables* influence = nullptr;  ///< with NormalMethod::half_space
  theory::SdecTable linear_theory;                     ///< for the bodies' Poisson ratio
  tangential::MarchGrid march_grid;                    ///< along each strip of a contact plane
  tangential::MarchGrid surface_grid;                  ///< along each strip of a wheel on a rail
  const Kernels* kernels = nullptr;    ///< kernels of the instruction set; everything else has this pointer
  tangential::ForceTable force_table;  ///< with Option::force_table
  const surface::SurfaceModel* surface = nullptr;  ///< with profiles
  ArrayLayout layout;                              ///< places of arrays in every contact of this model
  std::uint64_t configuration = 0;                 ///< equal in models that give equal results
};

/// Strips of a wheel on a rail that contacts remember; 0: none.
std::int32_t remembered_strips(const ModelOptions& options);

/// Bytes of a model with these options (alignment: `block_alignment`).
std::size_t model_bytes(const ModelOptions& options);

/// Makes a model in `memory` (model_bytes, aligned). Checks the profiles and reads the force table;
/// everything else in the options has been checked by the caller.
Fault make_model(const ModelOptions& options, void* memory, Model*& model);

}  // namespace wrc::contact
