/// The model: everything about a contact pair that does not change during a run. Immutable once made, so any
/// number of contacts and threads share it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "contact/layout.hpp"
#include "fault.hpp"
#include "geometry/placement.hpp"
#include "geometry/profile.hpp"
#include "linear_theory/sdec.hpp"
#include "normal/strip_halfspace.hpp"
#include "patch/material.hpp"
#include "patch/regularise.hpp"
#include "surface/surface_model.hpp"
#include "tangential/force_table.hpp"
#include "tangential/march_grid.hpp"
#include "tangential/problem.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc {

struct DamageKernels;
struct GeometryKernels;

/// The methods a model can be made of, one per stage.
enum class NormalMethod { hertz, kik_piotrowski, ekp, ekp_ellipse, analyn, stripes, strip_halfspace };
enum class TangentialMethod {
  fastsim,
  fastsim_eqe,
  fastsim_eql,
  fastsim_sdec,
  strip_fastsim,
  modified_fastsim,
  fastrip,
  fastrip_modified,
  fastrip_sdec,
  coarse_halfspace,
  table
};

/// Where a profile comes from: a standard shape or points of the caller.
struct ProfileSource {
  enum class Kind { none, points, s1002, rail_60e1, rail_uic60_benchmark } kind = Kind::none;
  std::int32_t count = 0;
  const double* y = nullptr;  ///< [m]
  const double* z = nullptr;  ///< [m]
  double smoothing = 0.0;     ///< wavelength below which waves of the points are damped; 0: kept [m]
};

struct ModelOptions {
  NormalMethod normal_method = NormalMethod::ekp;
  SecondCriterion regularisation = SecondCriterion::width;
  TangentialMethod tangential_method = TangentialMethod::fastsim_sdec;
  TractionBound traction_bound = TractionBound::parabolic;
  FlexibilityForm flexibility = FlexibilityForm::separate;
  InstructionSet instruction_set = InstructionSet::baseline;  ///< one this processor has
  ArraySizes sizes;
  std::int32_t max_patches = 0;
  std::int32_t max_iterations = 0;
  bool warm_start = false;  ///< of the strip half-space solver
  Material material;
  double load_tolerance = 0.0;  ///< relative
  double gap_limit = 0.0;       ///< [m]
  double shear_yield = 0.0;     ///< k [Pa]
  Side side = Side::right;
  TrackDimensions track;
  WheelsetDimensions wheelset;
  ProfileSource wheel, rail;
  const char* force_table = nullptr;  ///< file, with TangentialMethod::table
  ForceTableAxes force_table_axes;    ///< of that file; no nodes: no table
};

/// The options, and the profiles as placed; its arrays follow it in the same block of memory.
struct Model {
  ModelOptions options;  ///< profile sources and file name cleared: no pointer of the caller is kept
  bool has_geometry = false;
  Wheel wheel;  ///< wheel and rail are meaningful with has_geometry
  Rail rail;
  double wheel_deviation = 0.0;  ///< largest distance of a given point from the smoothed curve [m]
  double rail_deviation = 0.0;   ///< see wheel_deviation
  const StripKernel* strip_kernel = nullptr;          ///< with NormalMethod::strip_halfspace
  SdecTable linear_theory;                            ///< for the bodies' Poisson ratio
  MarchGrid march_grid;                               ///< along each strip, and the kernels
  const GeometryKernels* geometry_kernels = nullptr;  ///< of the same instruction set
  const DamageKernels* damage_kernels = nullptr;      ///< of the same instruction set
  ForceTable force_table;                             ///< with TangentialMethod::table
  const SurfaceModel* surface = nullptr;              ///< with profiles and NormalMethod::strip_halfspace
  ArrayLayout layout;                                 ///< of every contact of this model
};

/// Bytes of a model with these options (alignment: `block_alignment`).
std::size_t model_bytes(const ModelOptions& options);

/// Makes a model in `memory` (model_bytes, aligned). Checks the profiles and reads the force table;
/// everything else in the options has been checked by the caller.
Fault make_model(const ModelOptions& options, void* memory, Model*& model);

}  // namespace wrc
