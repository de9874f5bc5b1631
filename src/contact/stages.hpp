/// Stages of a step on a contact plane:
///
///     geometry -> normal -> regularise -> tangential -> damage
///
/// Each stage reads the results that the one before left in the contact and invalidates those after it, so
/// that a host may enter in the middle with its own data. All of them but surface_gap() are real-time code.
/// The caller (abi/) has checked that arguments are finite and in range. Each returns its fault and leaves
/// the contact usable.
#pragma once

#include "contact/state.hpp"
#include "geometry/surface_gap.hpp"

namespace wrc::contact {

// Geometry (gap_stage.cpp).

/// Contact point of the pose and rows of the gap about it.
Fault find_gap(Contact& contact, const geometry::Pose& pose);

/// Creepages of the wheelset's motion at the contact point of find_gap().
Fault find_creepages(const Contact& contact, const geometry::WheelsetMotion& motion,
                     geometry::RigidCreepage& rigid);

/// The surfaces whose expansion are the rows of find_gap(), heights up to one constant; the contact must be
/// `posed`. Not real-time code.
geometry::SurfaceGap surface_gap(const Contact& contact);

/// A gap of the host, in rows or on a grid, in the place of find_gap().
void take_gap(Contact& contact, const patch::GapRows& rows);
Fault take_gap(Contact& contact, const patch::GapGrid& grid);

// Normal (normal_stage.cpp).

/// Load or approach that presses the bodies together. Damping acts on a prescribed approach.
struct Load {
  normal::Prescribed prescribed = normal::Prescribed::load;
  double value = 0.0;              ///< [N] or [m]
  double approach_velocity = 0.0;  ///< [m/s]
  double damping = 0.0;            ///< alpha of normal/damping.hpp [s/m]
};

/// Strips with their pressure, and the patches they make.
Fault solve_normal(Contact& contact, const Load& load);

/// A pressure distribution of the host, or an exact double ellipse under load, in the place of
/// solve_normal().
Fault take_strips(Contact& contact, const patch::Strips& strips);
Fault take_double_ellipse(Contact& contact, const patch::Sdec& sdec, double normal_force);

/// Equivalent double ellipse of each patch.
Fault regularise_patch(Contact& contact);

// Tangential (tangential_stage.cpp, sensitivities.cpp).

/// Tractions and forces of all patches. With a `reverse_share` each patch rolls in both directions, and of
/// the reverse one forces and sensitivities alone count. `sensitivities`: nullptr, not wanted; with them no
/// fields are computed, and they are right where the contact differentiates().
Fault solve_tangential(Contact& contact, const tangential::Creepage& creepage, const Friction& friction,
                       const Rolling& rolling, tangential::TangentialSensitivities* sensitivities = nullptr);

/// Solves the last tangential stage again for its cells, where these have been lost.
void find_cells(Contact& contact);

/// Friction of the last tangential stage, its zones those kept in the contact.
Friction friction_of(const Contact& contact);

/// Did the last tangential stage have exact derivatives? Not so where the method has none, with flexibilities
/// that depend on the creepages, and with friction or a slope that falls as they grow.
bool differentiates(const Contact& contact);

/// Derivatives of the last tangential stage, found on a copy: the contact stays as it is.
Fault find_sensitivities(Contact& contact, tangential::TangentialSensitivities& sensitivities);

// Damage (assessments.cpp).

/// Frictional power and fatigue of all patches, kept in the contact.
Fault assess_damage(Contact& contact);

}  // namespace wrc::contact
