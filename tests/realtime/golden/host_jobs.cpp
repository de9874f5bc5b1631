/// Data of the host in the middle of the chain: gaps by rows and by elements, strips with pressure, double
/// ellipses.
#include "golden/plan.hpp"
#include "test_config.hpp"

wrc_planar_gap HostGap::view() const {
  wrc_planar_gap gap = sized<wrc_planar_gap>();
  gap.row_count = static_cast<uint32_t>(y.size());
  gap.column_count = static_cast<uint32_t>(x.size());
  gap.y = y.data();
  gap.height = height.empty() ? nullptr : height.data();
  gap.centre = centre.empty() ? nullptr : centre.data();
  gap.curvature = curvature.empty() ? nullptr : curvature.data();
  gap.x = x.empty() ? nullptr : x.data();
  gap.h = h.empty() ? nullptr : h.data();
  gap.row_stride = x.size();
  return gap;
}

namespace {

/// Bumps side by side, each a paraboloid: {y of its top, lateral radius, height over the lowest}.
struct Bump {
  double y, radius, height;
};

double lowest(const std::vector<Bump>& bumps, double y) {
  double least = 1.0;
  for (const Bump& bump : bumps) {
    const double h = bump.height + (y - bump.y) * (y - bump.y) / (2.0 * bump.radius);
    if (h < least) least = h;
  }
  return least;
}

HostGap by_rows(const std::vector<Bump>& bumps, int rows, double yaw) {
  HostGap gap;
  for (int j = 0; j < rows; ++j) {
    const double y = -0.02 + 0.04 * j / (rows - 1);
    gap.y.push_back(y);
    gap.height.push_back(lowest(bumps, y));
    gap.centre.push_back(yaw * y);
    gap.curvature.push_back(1.0 / (0.46 + 2.0 * y));
  }
  return gap;
}

HostGap by_elements(const std::vector<Bump>& bumps, int rows, int columns) {
  HostGap gap;
  for (int i = 0; i < columns; ++i) gap.x.push_back(-0.012 + 0.024 * i / (columns - 1));
  for (int j = 0; j < rows; ++j) {
    const double y = -0.02 + 0.04 * j / (rows - 1);
    gap.y.push_back(y);
    for (double x : gap.x) gap.h.push_back(lowest(bumps, y) + x * x / (2.0 * 0.46));
  }
  return gap;
}

wrc_config& add_model(Plan& plan, int32_t normal, int32_t tangential) {
  wrc_config& config = plan.models.emplace_back(test_config());
  config.normal.method = normal;
  choose_tangential(config, tangential);
  config.planar.strips = 45;
  config.planar.cells = 24;
  return config;
}

Step on(const HostGap& gap, double load) {
  Step step;
  step.gap = &gap;
  step.load.normal_force = load;
  step.creepage.longitudinal = -0.6e-3;
  step.creepage.lateral = 0.9e-3;
  step.creepage.spin = -0.2;
  return step;
}

void add_gaps(Plan& plan) {
  const std::vector<std::vector<Bump>> shapes = {
      {{0.0, 0.3, 0.0}},                                             // an elliptic contact
      {{0.0, 0.02, 0.0}},                                            // slender along rolling
      {{-0.006, 0.3, 0.0}, {0.006, 0.2, 15e-6}},                     // two patches
      {{-0.011, 0.1, 0.0}, {0.0, 0.15, 5e-6}, {0.011, 0.1, 10e-6}},  // three
      {{-0.001, 1.0, 0.0}, {0.004, 0.08, -2e-6}},                    // a flat one with a shoulder
  };
  for (const auto& shape : shapes) {
    plan.gaps.push_back(by_rows(shape, 101, 0.02));
    plan.gaps.push_back(by_rows(shape, 256, 0.0));
    plan.gaps.push_back(by_elements(shape, 120, 41));
  }
  for (int32_t normal = 0; normal < normal_methods; ++normal) {
    add_model(plan, normal, normal % 2 == 0 ? preset_strip_fastsim : preset_fastsim_sdec);
    Job job{"gaps", plan.models.size() - 1, {}, {}};
    for (const HostGap& gap : plan.gaps) job.steps.push_back(on(gap, 70e3));
    plan.jobs.push_back(std::move(job));
  }
}

/// Pressure of the host as strips: two hills with a gap between, then the whole chain from
/// wrc_planar_regularise on.
void run_strips(wrc_contact* contact, Hash& hash) {
  Numbers numbers(3);
  for (int round = 0; round < 4; ++round) {
    std::vector<double> y, width, centre, half, peak;
    double edge = -0.012;
    for (int j = 0; j < 24; ++j) {
      const double w = numbers.between(0.4e-3, 0.8e-3);
      if (round % 2 == 1 && j == 9) edge += 2e-3;
      y.push_back(edge + 0.5 * w);
      width.push_back(w);
      centre.push_back(numbers.between(-0.4e-3, 0.4e-3));
      half.push_back(numbers.between(1e-3, 6e-3));
      peak.push_back(numbers.between(2e8, 1.4e9));
      edge += w;
    }
    wrc_planar_strips strips = sized<wrc_planar_strips>();
    strips.count = static_cast<uint32_t>(y.size());
    strips.y = y.data();
    strips.width = width.data();
    strips.centre = round < 2 ? nullptr : centre.data();
    strips.half_length = half.data();
    strips.peak = peak.data();
    wrc_planar_normal_solution normal{};
    wrc_planar_forces forces{};
    wrc_damage damage{};
    wrc_creepage creepage = wrc_creepage_default();
    creepage.longitudinal = numbers.between(-3e-3, 3e-3);
    creepage.lateral = numbers.between(-3e-3, 3e-3);
    creepage.spin = numbers.between(-0.5, 0.5);
    const wrc_friction friction = wrc_friction_default();
    hash.add(wrc_planar_regularise(contact, &strips, &normal));
    hash.add(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces));
    hash.add(wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage));
    hash_normal(normal, hash);
    hash_forces(forces, hash);
    hash_damage(damage, hash);
    hash_fields(contact, hash, forces.available != 0);
  }
}

/// Double ellipses of the host, from round to slender and lopsided, to the ends of the ranges.
void run_patches(wrc_contact* contact, Hash& hash) {
  Numbers numbers(4);
  const double shapes[][3] = {
      {6e-3, 6e-3, 0.0}, {6e-3, 4e-3, 0.3}, {3e-3, 9e-3, -0.6}, {8e-3, 1e-3, 0.95}, {0.5e-3, 2e-2, -0.95},
      {1e-6, 1e-6, 0.0}, {0.1, 0.1, 0.5},   {5e-3, 5e-3, 1e-9}, {2e-2, 2e-5, 0.0},  {2e-5, 2e-2, -0.2}};
  for (const auto& shape : shapes) {
    wrc_ellipse ellipse = sized<wrc_ellipse>();
    ellipse.a = shape[0];
    ellipse.b = shape[1];
    ellipse.psi = shape[2];
    ellipse.normal_force = numbers.between(1e3, 2e5);
    wrc_planar_forces forces{};
    wrc_damage damage{};
    wrc_creepage creepage = wrc_creepage_default();
    const wrc_friction friction = wrc_friction_default();
    for (double size : {1e-5, 1e-3, 1e-2}) {
      creepage.longitudinal = numbers.between(-size, size);
      creepage.lateral = numbers.between(-size, size);
      creepage.spin = numbers.between(-size, size) / 5e-3;
      hash.add(wrc_planar_tangential(contact, &ellipse, &creepage, &friction, &forces));
      hash.add(wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage));
      hash_forces(forces, hash);
      hash_damage(damage, hash);
    }
    hash_fields(contact, hash, forces.available != 0);
  }
}

}  // namespace

void add_host_data(Plan& plan) {
  add_gaps(plan);
  for (int32_t tangential = 0; tangential < tangential_methods; ++tangential) {
    add_model(plan, WRC_NORMAL_EKP, tangential);
    plan.jobs.push_back({"strips", plan.models.size() - 1, {}, run_strips});
    plan.jobs.push_back({"patches", plan.models.size() - 1, {}, run_patches});
  }
}
