/// One wheel on its rail, driven with input that varies from call to call: what all the proofs run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "structs.hpp"
#include "test_config.hpp"

/// What a wheel is solved with. Fields not named here have the library's defaults.
struct Methods {
  int32_t normal = WRC_NORMAL_STRIP_HALFSPACE;
  int32_t tangential = preset_strip_fastsim;  ///< number of a published method
  int32_t side = WRC_SIDE_RIGHT;
  int32_t strips = 60, cells = 32;
  int32_t instruction_set = WRC_INSTRUCTIONS_BEST;
  int32_t bound = WRC_BOUND_PARABOLIC, flexibility = WRC_FLEXIBILITY_SEPARATE;
};

/// Every normal method with every tangential one; then, with one normal method, every traction bound and
/// every form of the flexibilities.
std::vector<Methods> all_methods();

/// The same with the kernels of each instruction set this processor has.
std::vector<Methods> on_every_instruction_set(const std::vector<Methods>& all);

/// "ekp, fastsim_sdec", and the bound and flexibilities if they are not the usual
/// ones.
std::string names_of(const Methods& methods);

/// A gap by rows, as a host would hold it.
struct Gap {
  std::vector<double> y, height, centre, curvature;
};

class Wheel {
 public:
  explicit Wheel(const Methods& methods);
  ~Wheel();
  Wheel(const Wheel&) = delete;
  Wheel& operator=(const Wheel&) = delete;

  /// Input number i: lateral shift up to the flange, yaw, load from 40 to 120 kN, in every fourth call the
  /// approach instead, now and then apart; creepages up to full slip.
  void vary(int i);

  /// Laws number i: constant friction, falling with the speed in two ways, every other time over zones; a
  /// layer between the bodies; damping of the approach, now and then of all the force.
  void vary_laws(int i);

  int32_t step();                     ///< from the pose
  int32_t step_with(const Gap& gap);  ///< from a gap of the host
  int32_t geometry() { return wrc_planar_geometry(contact, &pose, &output.point); }
  Gap gap_of_pose();  ///< what the geometry left in the contact
  int32_t save() { return wrc_contact_save(contact, state.data(), state.size()); }
  int32_t restore() { return wrc_contact_restore(contact, state.data(), state.size()); }

  const Methods methods;
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  wrc_model* remembering_model = nullptr;  ///< one with config.planar.non_steady, without profiles
  wrc_contact* remembering = nullptr;
  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_pose& pose = input.pose;
  wrc_planar_load& load = input.load;
  wrc_creepage& creepage = input.creepage;
  wrc_friction& friction = input.friction;
  wrc_planar_output output = sized<wrc_planar_output>();
  std::vector<char> state;          ///< room for a saved contact
  char* spare = nullptr;            ///< room for another contact, aligned as contacts are
  std::uint64_t contact_bytes = 0;  ///< of that room

 private:
  std::vector<char> spare_memory_;
};

/// wrc_planar_gap that shows rows of a host's gap.
wrc_planar_gap shown(const Gap& gap);
