#include "proof/wheel.hpp"

#include <cmath>
#include <stdexcept>

std::vector<Methods> all_methods() {
  std::vector<Methods> all;
  for (int32_t normal = 0; normal < normal_methods; ++normal) {
    for (int32_t tangential : tangential_methods) all.push_back({normal, tangential, WRC_SIDE_RIGHT, 32, 32});
  }
  return all;
}

Wheel::Wheel(const Methods& methods) {
  wrc_profile wheel = made<wrc_profile>(wrc_profile_init), rail = made<wrc_profile>(wrc_profile_init);
  wheel.kind = WRC_PROFILE_S1002;
  rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  wrc_config config = made<wrc_config>(wrc_config_init);
  config.side = methods.side;
  config.normal_method = methods.normal;
  config.tangential_method = methods.tangential;
  config.strips = methods.strips;
  config.cells = methods.cells;
  config.instruction_set = methods.instruction_set;
  config.warm_start = 1;
  config.wheel = &wheel;
  config.rail = &rail;
  std::uint64_t bytes = 0, alignment = 0;
  if (wrc_model_create(&config, nullptr, &model) < 0 || wrc_contact_create(model, nullptr, &contact) < 0 ||
      wrc_contact_size(model, &bytes, &alignment) < 0)
    throw std::runtime_error("no model");
  state.resize(bytes);
}

Wheel::~Wheel() {
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

void Wheel::vary(int i) {
  const double t = 0.001 * i;
  pose.lateral = 1e-3 + 6e-3 * std::sin(7.0 * t);
  pose.yaw = 8e-3 * std::sin(3.0 * t);
  load.prescribed = i % 4 == 3 ? WRC_PRESCRIBE_APPROACH : WRC_PRESCRIBE_LOAD;
  load.normal_force = 80e3 + 40e3 * std::sin(11.0 * t);
  load.approach = 60e-6 + 61e-6 * std::sin(5.0 * t);
  creepage.longitudinal = 3e-3 * std::sin(13.0 * t);
  creepage.lateral = 3e-3 * std::cos(17.0 * t);
  creepage.spin = 0.8 * std::sin(19.0 * t);
}

int32_t Wheel::step() {
  const wrc_input input = {sizeof input, 0, &pose, nullptr, &load, &creepage, &friction};
  wrc_output output = {sizeof output, 0, &point, &patch, &forces, &damage};
  return wrc_step(contact, &input, &output);
}

int32_t Wheel::step_with(const Gap& gap) {
  const wrc_gap rows = shown(gap);
  const wrc_input input = {sizeof input, 0, nullptr, &rows, &load, &creepage, &friction};
  wrc_output output = {sizeof output, 0, nullptr, &patch, &forces, &damage};
  return wrc_step(contact, &input, &output);
}

Gap Wheel::gap_of_pose() {
  Gap gap;
  geometry();
  const auto copy = [&](int32_t field) {
    wrc_view view = made<wrc_view>(wrc_view_init);
    wrc_field(contact, 0, field, &view);
    return std::vector<double>(view.data, view.data + view.count[0]);
  };
  gap.y = copy(WRC_FIELD_GAP_Y);
  gap.height = copy(WRC_FIELD_GAP_HEIGHT);
  gap.centre = copy(WRC_FIELD_GAP_CENTRE);
  gap.curvature = copy(WRC_FIELD_GAP_CURVATURE);
  return gap;
}

wrc_gap shown(const Gap& gap) {
  wrc_gap rows = made<wrc_gap>(wrc_gap_init);
  rows.rows = static_cast<uint32_t>(gap.y.size());
  rows.y = gap.y.data();
  rows.height = gap.height.data();
  rows.centre = gap.centre.data();
  rows.curvature = gap.curvature.data();
  return rows;
}
