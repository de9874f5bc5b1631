#include "proof/wheel.hpp"

#include <cmath>
#include <stdexcept>

#include "field_values.hpp"
#include "test_config.hpp"

std::vector<Methods> all_methods() {
  std::vector<Methods> all;
  for (int32_t normal = 0; normal < normal_methods; ++normal) {
    for (int32_t tangential = 0; tangential < tangential_methods; ++tangential)
      all.push_back({normal, tangential, WRC_SIDE_RIGHT, 32, 32});
  }
  for (int32_t tangential = 0; tangential < tangential_methods; ++tangential) {
    if (presets[tangential].method != WRC_TANGENTIAL_FASTSIM) continue;
    for (int32_t other : {1, 2}) {  // both at once: they do not meet in the code
      Methods methods{WRC_NORMAL_EKP, tangential, WRC_SIDE_RIGHT, 32, 32};
      methods.bound = other;
      methods.flexibility = other;
      all.push_back(methods);
    }
  }
  return all;
}

std::vector<Methods> on_every_instruction_set(const std::vector<Methods>& all) {
  std::vector<Methods> everywhere;
  for (int32_t set = WRC_INSTRUCTIONS_BASELINE; set <= WRC_INSTRUCTIONS_AVX512; ++set) {
    if (!available(set)) continue;
    for (Methods methods : all) {
      methods.instruction_set = set;
      everywhere.push_back(methods);
    }
  }
  return everywhere;
}

std::string names_of(const Methods& methods) {
  static constexpr const char* bounds[] = {"", ", elliptic", ", ellipsoidal"};
  static constexpr const char* flexibilities[] = {"", ", single", ", blended"};
  return std::string(normal_names[methods.normal]) + ", " + presets[methods.tangential].identifier +
         bounds[methods.bound] + flexibilities[methods.flexibility];
}

Wheel::Wheel(const Methods& with) : methods(with) {
  wrc_config config = test_config();
  config.normal.method = methods.normal;
  choose_tangential(config, methods.tangential);
  config.planar.strips = methods.strips;
  config.planar.cells = methods.cells;
  config.instruction_set = methods.instruction_set;
  config.tangential.bound = methods.bound;
  config.tangential.flexibility = methods.flexibility;
  config.planar.start = methods.normal == WRC_NORMAL_STRIP_HALFSPACE ? 1 : 0;
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  std::uint64_t alignment = 0, state_bytes = 0;
  if (wrc_model_create(&config, nullptr, &model, nullptr, 0) < 0 ||
      wrc_contact_create(model, methods.side, nullptr, &contact, nullptr, 0) < 0 ||
      wrc_contact_size(model, &contact_bytes, &alignment) < 0 ||
      wrc_contact_state_size(model, &state_bytes) < 0)
    throw std::runtime_error("no model");
  wrc_config of_memory = test_config();
  of_memory.planar.non_steady = 1;
  of_memory.instruction_set = methods.instruction_set;
  if (wrc_model_create(&of_memory, nullptr, &remembering_model, nullptr, 0) < 0 ||
      wrc_contact_create(remembering_model, methods.side, nullptr, &remembering, nullptr, 0) < 0)
    throw std::runtime_error("no model that remembers");
  state.resize(state_bytes);
  spare_memory_.resize(contact_bytes + alignment);
  const auto first = reinterpret_cast<std::uintptr_t>(spare_memory_.data());
  spare = spare_memory_.data() + (alignment - first % alignment);
}

Wheel::~Wheel() {
  wrc_contact_destroy(remembering);
  wrc_model_destroy(remembering_model);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

void Wheel::vary(int i) {
  const double t = 0.001 * i;
  pose.lateral = 1e-3 + 6e-3 * std::sin(7.0 * t);
  pose.yaw = 8e-3 * std::sin(3.0 * t);
  load.prescribed = i % 4 == 3 ? WRC_PRESCRIBE_APPROACH : WRC_PRESCRIBE_NORMAL_FORCE;
  load.normal_force = 80e3 + 40e3 * std::sin(11.0 * t);
  load.approach = 60e-6 + 61e-6 * std::sin(5.0 * t);
  creepage.longitudinal = 3e-3 * std::sin(13.0 * t);
  creepage.lateral = 3e-3 * std::cos(17.0 * t);
  creepage.spin = 0.8 * std::sin(19.0 * t);
}

void Wheel::vary_laws(int i) {
  static constexpr double zone_y[] = {-4e-3, 0.0, 0.0, 5e-3}, zone_coefficient[] = {0.1, 0.3, 0.0, 0.4};
  friction.speed_law = i % 3;
  friction.slope_reduction = i % 5 == 4 ? 0.4 : 1.0;
  friction.slope_fall = slope_fall_for(methods.tangential);
  friction.zone_count = i % 2 == 1 ? 4 : 0;
  friction.zone_y = zone_y;
  friction.zone_coefficients = zone_coefficient;
  friction.zone_frame = i % 7 < 3   ? WRC_ZONES_RAIL_PROFILE
                        : i % 7 < 5 ? WRC_ZONES_WHEEL_PROFILE
                                    : WRC_ZONES_CONTACT_FRAME;
  creepage.speed = 0.7 * (i % 60);
  load.damping = 0.2 * (i % 3);
  load.approach_velocity = 4.0 * std::sin(0.023 * i);
}

int32_t Wheel::step() { return wrc_planar_step(contact, &input, &output); }

int32_t Wheel::step_with(const Gap& gap) {
  const wrc_planar_gap rows = shown(gap);
  input.gap = &rows;
  const int32_t status = wrc_planar_step(contact, &input, &output);
  input.gap = nullptr;
  return status;
}

Gap Wheel::gap_of_pose() {
  Gap gap;
  geometry();
  const auto copy = [&](int32_t field) { return field_values(contact, 0, field).values; };
  gap.y = copy(WRC_FIELD_GAP_Y);
  gap.height = copy(WRC_FIELD_GAP_HEIGHT);
  gap.centre = copy(WRC_FIELD_GAP_CENTRE);
  gap.curvature = copy(WRC_FIELD_GAP_CURVATURE);
  return gap;
}

wrc_planar_gap shown(const Gap& gap) {
  wrc_planar_gap rows = sized<wrc_planar_gap>();
  rows.row_count = static_cast<uint32_t>(gap.y.size());
  rows.y = gap.y.data();
  rows.height = gap.height.data();
  rows.centre = gap.centre.data();
  rows.curvature = gap.curvature.data();
  return rows;
}
