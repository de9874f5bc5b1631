/// The methods a model can be made of: one row each, in the order of the enumerations in wrc_methods.h. A row
/// says which options and memory a method needs and which results it gives; nothing else in the library asks
/// which method it is.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "normal/problem.hpp"
#include "surface/surface_model.hpp"
#include "tangential/problem.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc::contact {

struct Contact;

/// Options of wrc_config and wrc_friction that some methods read and others do not.
enum class Option {
  max_iterations,
  max_sweeps,
  load_tolerance,
  warm_start,
  surface_iteration,  ///< config.surface.tolerance, .max_work, .max_iterations
  patch_model,
  traction_bound,
  flexibility,
  force_table,
  non_steady,
  surface_memory,
  slope_fall,         ///< friction.slope_limit and friction.slope_fall
  reduction_factors,  ///< friction.adhesion_reduction and friction.slip_reduction
  count
};

/// A set of them.
class OptionSet {
 public:
  template <class... Options>
  constexpr OptionSet(Options... options) : bits_(((1U << static_cast<unsigned>(options)) | ... | 0U)) {}
  constexpr bool has(Option option) const { return (bits_ >> static_cast<unsigned>(option) & 1U) != 0; }

 private:
  unsigned bits_;
};

/// A value of wrc_methods.h, and how it is written.
struct Enumerator {
  std::int32_t value = 0;
  const char* name = nullptr;
};

struct NormalMethod {
  Enumerator is;  ///< value of enum wrc_normal_method
  OptionSet reads{};
  /// The whole method; on a rail's surface it is applied patch by patch.
  Fault (*planar)(const normal::NormalProblem& problem, patch::Strips& strips,
                  normal::NormalSolution& solution) = nullptr;
  /// In its stead, a method that has its own way on a surface: needs the influence table in the model.
  bool half_space = false;
  std::int64_t (*workspace)(std::int32_t strips) = nullptr;  ///< in the contact [bytes]; nullptr: none
  /// Fills contact.normal, too.
  Fault (*solve)(Contact& contact, const normal::NormalProblem& problem, patch::Strips& strips) = nullptr;
};

struct TangentialMethod {
  Enumerator is;  ///< value of enum wrc_tangential_method
  OptionSet reads{};
  bool gives_tractions = false;    ///< and the slip of every cell; otherwise forces only
  bool gives_derivatives = false;  ///< otherwise differences stand in
  bool one_sliding_speed = false;  ///< friction falls with that of the patch, not with that of each strip
  bool takes_layer = false;        ///< friction with a layer that shears and yields; otherwise it is refused
  /// Its way over the strips of a surface, each with its own slip and coefficients, with the patch model
  /// WRC_PATCH_MODEL_PATCH_SDEC, separate flexibilities and a bound of each strip's load; otherwise it is
  /// applied patch by patch.
  bool over_strips = false;
  surface::SurfaceRollingMethod strips = surface::SurfaceRollingMethod::strip_fastsim;
  std::int64_t (*workspace)(std::int32_t strips,
                            std::int32_t cells) = nullptr;  ///< in the contact [bytes]; nullptr: none
  tangential::TangentialForces (*solve)(const tangential::RollingContact& contact,
                                        const tangential::TangentialFields& fields, Fault& fault,
                                        tangential::TangentialSensitivities* sensitivities) = nullptr;
};

/// The row of a value of wrc_methods.h; nullptr if there is none.
const NormalMethod* normal_method(std::int32_t value);
const TangentialMethod* tangential_method(std::int32_t value);

/// "only ... read it", for the refusal of an option that the chosen methods do not read.
const char* readers_of(Option option);

struct ModelOptions;

/// Methods for a wheel on a rail in a model of these options. The caller adds tables.
surface::SurfaceMethods surface_methods(const ModelOptions& options);

}  // namespace wrc::contact
