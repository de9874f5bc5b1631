/// What is asked of a contact's newest solution by the index of a region, of
/// patches and of a wheel's regions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "abi/handles.hpp"
#include "abi/wear.hpp"
#include "contact/assessments.hpp"
#include "contact/stages.hpp"
#include "contact/wheel.hpp"
#include "test_config.hpp"

namespace wrc::contact {
namespace {

using Numbers = std::vector<double>;

constexpr double speed = 20.0, friction = 0.3;

/// Numbers of a region that are compared between solutions.
struct Assessed {
  RegionResult region;
  DamageNumbers damage;
  WearNumbers wear;
  TemperatureNumbers temperature;
  BodyStresses stresses;
};

/// Stress peaks of equal value and place.
bool same(const BodyStresses& a, const BodyStresses& b) {
  const auto numbers = [](const BodyStresses& s) {
    Numbers all;
    for (const damage::StressPeaks* peaks : {&s.surface, &s.below})
      for (const damage::StressPeak* p : {&peaks->von_mises, &peaks->shear, &peaks->tension})
        all.insert(all.end(), {p->value, p->x, p->y, p->z});
    return all;
  };
  return numbers(a) == numbers(b);
}

class ContactRegion : public testing::Test {
 protected:
  wrc_config config = test_config();
  HostWheel wheel;
  damage::WearLaws laws;
  wrc_model* model = nullptr;
  wrc_contact* handle = nullptr;
  Contact* contact = nullptr;

  ContactRegion() {
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    wheel.of_wheelset = true;
    wheel.velocity[0] = speed;
    wheel.angular_velocity[1] = -speed / 0.46;
    wheel.frictionless = false;
    wheel.friction.law.coefficient = friction;
    wheel.load_prescribed = true;
    wheel.vertical_load = 80e3;
    EXPECT_EQ(abi::read_wear_laws(nullptr, "laws", laws).status, WRC_OK);
  }
  ~ContactRegion() override {
    wrc_contact_destroy(handle);
    wrc_model_destroy(model);
  }
  void create(int32_t side = WRC_SIDE_RIGHT) {
    wrc_contact_destroy(handle);
    wrc_model_destroy(model);
    handle = nullptr;
    model = nullptr;
    ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    take(side);
  }
  void take(int32_t side) {
    wrc_contact_destroy(handle);
    handle = nullptr;
    ASSERT_EQ(wrc_contact_create(model, side, nullptr, &handle, nullptr, 0), WRC_OK);
    contact = handle->contact;
  }

  /// A cylinder on a crown of that radius: Hertz's circle.
  void take_circle() {
    static Numbers y, crown, level;
    if (y.empty()) {
      constexpr double radius = 0.46;
      for (int i = -300; i <= 300; ++i) {
        y.push_back(1e-4 * i);
        crown.push_back(radius - std::sqrt(radius * radius - y.back() * y.back()));
        level.push_back(0.0);
      }
    }
    for (wrc_profile* profile : {&config.wheel, &config.rail}) {
      profile->kind = WRC_PROFILE_POINTS;
      profile->count = static_cast<uint32_t>(y.size());
      profile->y = y.data();
      profile->z = profile == &config.rail ? crown.data() : level.data();
    }
    config.track.placement = WRC_PLACEMENT_ORIGIN;
    config.track.rail_origin = 0.75;
  }
  HostWrench& solve() {
    const Fault fault = solve_wheel(*contact, wheel);
    EXPECT_GE(fault.status, WRC_OK) << fault.field;
    return contact->wheel;
  }
  /// The stages at a pose.
  void press(double lateral, double load, double yaw = 0.0) {
    ASSERT_FALSE(find_gap(*contact, {.lateral = lateral, .yaw = yaw}).failed());
    ASSERT_FALSE(solve_normal(*contact, {.prescribed = normal::Prescribed::load, .value = load}).failed());
    ASSERT_FALSE(regularise_patch(*contact).failed());
  }
  void roll(const tangential::Creepage& creepage, double way = 1.0) {
    Friction law;
    law.law.coefficient = friction;
    ASSERT_FALSE(solve_tangential(*contact, creepage, law, {.speed = speed, .direction = way}).failed());
  }

  Assessed all_of(int32_t index) {
    Assessed all;
    if (index != all_regions) {
      EXPECT_EQ(find_region(*contact, index, all.region).status, WRC_OK);
    }
    EXPECT_EQ(region_damage(*contact, index, all.damage).status, WRC_OK);
    EXPECT_EQ(region_wear(*contact, index, laws, all.wear).status, WRC_OK);
    EXPECT_EQ(region_temperature(*contact, index, {20.0, 60.0}, all.temperature).status, WRC_OK);
    const double depths[] = {1e-3, 2e-3, 3e-3, 5e-3};
    EXPECT_EQ(region_stresses(*contact, index, true, depths, 4, nullptr, all.stresses).status, WRC_OK);
    return all;
  }
  Numbers field(int32_t index, FieldId which) {
    FieldSize size;
    EXPECT_EQ(region_field_size(*contact, index, which, size).status, WRC_OK);
    Numbers values(static_cast<std::size_t>(size.rows * size.cells), -7.0);
    EXPECT_EQ(region_field(*contact, index, which, laws.sheffield, values.data()).status, WRC_OK);
    return values;
  }
  /// Calls add(value, x, y, area) with every cell of a field.
  template <class Add>
  void over_cells(int32_t index, FieldId which, Add&& add) {
    const Numbers values = field(index, which), x = field(index, FieldId::x),
                  y = field(index, FieldId::strip_y), width = field(index, FieldId::strip_width),
                  half = field(index, FieldId::strip_half_length);
    const std::size_t cells = values.size() / width.size();
    for (std::size_t j = 0; j < width.size(); ++j)
      for (std::size_t i = 0; i < cells; ++i)
        add(values[j * cells + i], x[j * cells + i], y[j],
            width[j] * 2.0 * half[j] / static_cast<double>(cells));
  }
  double integral(int32_t index, FieldId which) {
    double sum = 0.0;
    over_cells(index, which, [&](double value, double, double, double area) { sum += value * area; });
    return sum;
  }
  std::vector<unsigned char> state() const {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(contact);
    return {bytes, bytes + state_bytes(*contact->model)};
  }
  /// Every number and field of all regions.
  Numbers everything() {
    Numbers all;
    for (int32_t index = 0; index < region_count(*contact); ++index) {
      all_of(index);
      for (int32_t k = 0; k < static_cast<int32_t>(FieldId::gap_y); ++k) {
        const auto which = static_cast<FieldId>(k);
        if (contact->newest == Solution::stages && which >= FieldId::strip_profile_y) continue;
        for (const double value : field(index, which)) all.push_back(value);
      }
    }
    return all;
  }
};

constexpr tangential::Creepage some{1e-3, -0.5e-3, 0.2};

TEST_F(ContactRegion, OnePatchIsTheWholeToTheBit) {
  create();
  press(0.0, 80e3);
  roll(some);
  ASSERT_EQ(contact->patches, 1);
  const Assessed one = all_of(0), whole = all_of(all_regions);
  EXPECT_EQ(std::memcmp(&one.damage, &whole.damage, sizeof one.damage), 0);
  EXPECT_EQ(std::memcmp(&one.wear, &whole.wear, sizeof one.wear), 0);
  EXPECT_EQ(std::memcmp(&one.temperature, &whole.temperature, sizeof one.temperature), 0);
  EXPECT_TRUE(same(one.stresses, whole.stresses));
  // and what the stage of damage gives
  ASSERT_EQ(assess_damage(*contact).status, WRC_OK);
  EXPECT_EQ(std::memcmp(&contact->damage, &whole.damage, sizeof whole.damage), 0);
}

TEST_F(ContactRegion, PatchesAddUpToTheWhole) {
  create();
  press(5.5e-3, 80e3);
  roll(some);
  ASSERT_EQ(contact->patches, 2);
  const Assessed whole = all_of(all_regions), first = all_of(0), second = all_of(1);
  const auto adds_up = [](double sum, double a, double b) { EXPECT_NEAR(a + b, sum, 1e-12 * std::abs(sum)); };
  adds_up(whole.damage.power, first.damage.power, second.damage.power);
  adds_up(whole.damage.t_gamma, first.damage.t_gamma, second.damage.t_gamma);
  adds_up(contact->extent.normal_force, first.region.normal_force, second.region.normal_force);
  adds_up(contact->extent.area, first.region.extent.area, second.region.extent.area);
  adds_up(contact->forces.fx, first.region.tangential.fx, second.region.tangential.fx);
  adds_up(contact->forces.mz, first.region.tangential.mz, second.region.tangential.mz);
  adds_up(whole.temperature.wheel_heat, first.temperature.wheel_heat, second.temperature.wheel_heat);
  EXPECT_EQ(whole.temperature.rise, std::max(first.temperature.rise, second.temperature.rise));
  EXPECT_EQ(whole.damage.fatigue_index, std::max(first.damage.fatigue_index, second.damage.fatigue_index));
  EXPECT_EQ(whole.damage.peak_power_density,
            std::max(first.damage.peak_power_density, second.damage.peak_power_density));
  EXPECT_EQ(whole.wear.largest_depth_rate,
            std::max(first.wear.largest_depth_rate, second.wear.largest_depth_rate));
  EXPECT_NE(first.damage.power, second.damage.power);
  // the places of both, on the bodies and in the track
  const RegionPlace &one = first.region.place, &other = second.region.place;
  EXPECT_LT(one.y_rail, other.y_rail - 5e-3);
  EXPECT_NEAR(other.y_rail - one.y_rail, other.y_wheel - one.y_wheel, 0.2e-3);
  EXPECT_GT(one.z_wheel, other.z_wheel + 1e-3);
  EXPECT_NEAR(other.z_rail - one.z_rail, other.z_wheel - one.z_wheel, 0.2e-3);
  for (const Assessed* each : {&first, &second}) {
    const RegionResult& region = each->region;
    ASSERT_TRUE(region.placed && region.rolled);
    EXPECT_NEAR(region.rolling_radius, 0.46 + region.place.z_wheel, 1e-12);
    double down = 0.0;
    for (int i = 0; i < 3; ++i) down -= region.force[i] * region.normal[i];
    EXPECT_NEAR(down, region.normal_force, 1e-9 * down);
  }
}

TEST_F(ContactRegion, FieldsAddUpOfBothSolutions) {
  for (const Solution solution : {Solution::stages, Solution::wheel}) {
    for (const double way : {1.0, -1.0}) {
      wheel.velocity[0] = way * speed;
      wheel.angular_velocity[1] = -way * speed / 0.461;
      wheel.y = 1e-3;
      create();
      if (solution == Solution::wheel) {
        solve();
      } else {
        press(1e-3, 80e3);
        roll(some, way);
      }
      ASSERT_EQ(region_count(*contact), 1);
      const Assessed all = all_of(0);
      const RegionResult& region = all.region;
      EXPECT_EQ(region.rolling_speed * way, std::abs(region.rolling_speed));
      EXPECT_NEAR(std::abs(region.rolling_speed), speed, 0.1);
      const double load = region.extent.normal_force;
      EXPECT_NEAR(integral(0, FieldId::pressure), load, 3e-3 * load);
      EXPECT_NEAR(integral(0, FieldId::traction_x), region.tangential.fx, 1e-6 * load);
      EXPECT_NEAR(integral(0, FieldId::traction_y), region.tangential.fy, 1e-6 * load);
      const double power = integral(0, FieldId::power_density);
      EXPECT_NEAR(power, region.power, 0.02 * power);
      EXPECT_NEAR(power, all.damage.power, 0.02 * power);
      const Numbers width = field(0, FieldId::strip_width), of_strips = field(0, FieldId::strip_power),
                    wear = field(0, FieldId::strip_wear), centre = field(0, FieldId::strip_centre),
                    half = field(0, FieldId::strip_half_length), x = field(0, FieldId::x),
                    coefficient = field(0, FieldId::strip_friction);
      double from_strips = 0.0, worn = 0.0, worn_by_cells = 0.0;
      for (std::size_t j = 0; j < width.size(); ++j) {
        from_strips += width[j] * of_strips[j];
        worn += width[j] * wear[j];
        const double* const cell = &x[j * x.size() / width.size()];
        EXPECT_GT(way * (cell[0] - centre[j]),
                  0.9 * half[j]);  // cell 0 leads, the next is behind it
        EXPECT_LT(way * (cell[1] - cell[0]), 0.0);
        EXPECT_EQ(coefficient[j], friction);
      }
      EXPECT_NEAR(from_strips, power, 1e-9 * power);
      const double v = std::abs(region.rolling_speed);
      over_cells(0, FieldId::power_density, [&](double density, double, double, double area) {
        worn_by_cells += area * damage::wear_depth_rate(laws.sheffield, std::max(0.0, density / v));
      });
      EXPECT_NEAR(worn, worn_by_cells, 1e-9 * worn);
      const Numbers density = field(0, FieldId::power_density), index = field(0, FieldId::fatigue_index),
                    rise = field(0, FieldId::temperature_rise);
      EXPECT_EQ(*std::max_element(density.begin(), density.end()), all.damage.peak_power_density);
      EXPECT_EQ(*std::max_element(index.begin(), index.end()), all.damage.local_fatigue_index);
      EXPECT_EQ(*std::max_element(rise.begin(), rise.end()), all.temperature.rise);
      const double most = *std::max_element(density.begin(), density.end());
      EXPECT_NEAR(all.wear.largest_depth_rate, damage::wear_depth_rate(laws.sheffield, most / v),
                  1e-9 * all.wear.largest_depth_rate);
    }
  }
}

// No stage need have been called before, and none is undone.
TEST_F(ContactRegion, AskingChangesNothing) {
  create();
  wheel.y = 5.5e-3;
  solve();
  ASSERT_EQ(region_count(*contact), 2);
  auto before = state();
  const Numbers of_wheel = everything();
  EXPECT_EQ(state(), before);
  press(5.5e-3, 80e3);
  roll(some);
  ASSERT_EQ(region_count(*contact), 2);
  before = state();
  const Numbers of_stages = everything();
  EXPECT_EQ(state(), before);
  EXPECT_EQ(everything(), of_stages);
  for (const Numbers* each : {&of_wheel, &of_stages})
    EXPECT_TRUE(std::all_of(each->begin(), each->end(), [](double v) { return std::isfinite(v); }));
}

// Tractions of cells lie where a wheel on a rail, derivatives and saved states do not keep them.
TEST_F(ContactRegion, CellsThatAreLostAreFoundAgain) {
  create();
  press(5.5e-3, 80e3);
  Friction law;
  law.law.coefficient = friction;
  for (const double reverse : {0.0, 0.3}) {
    if (reverse > 0.0) {  // and friction that is solved for
      law.law.temperature_law = tangential::TemperatureLaw::linear;
      law.law.hot_ratio = 0.4;
      law.law.hot_temperature = 400.0;
    }
    solve_tangential(*contact, some, law, {.speed = speed, .direction = -1.0, .reverse_share = reverse});
    ASSERT_EQ(region_count(*contact), 2);
    const Numbers found = everything();
    const auto saved = state();
    solve();
    EXPECT_NE(everything(), found);
    take_state(*contact, saved.data());
    EXPECT_EQ(everything(), found);
    tangential::TangentialSensitivities slopes;
    EXPECT_FALSE(find_sensitivities(*contact, slopes).failed());
    EXPECT_EQ(everything(), found);
    EXPECT_EQ(state(), saved);
  }
}

/// Hertz's circle by both solutions, at the creepages of the wheel.
TEST_F(ContactRegion, OnFlatGroundAWheelHasThePlanarNumbers) {
  take_circle();
  wheel.of_wheelset = false;
  wheel.angular_velocity[1] = -speed / 0.46 * 1.0008;
  wheel.velocity[1] = 0.01;
  create();
  const HostWrench& hosted = solve();
  const Assessed on_rail = all_of(0);
  press(0.0, 80e3);
  roll(on_rail.region.creepage);
  const Assessed planar = all_of(0);

  const RegionResult &a = on_rail.region, &b = planar.region;
  const auto near = [](double found, double expected, double part) {
    EXPECT_NEAR(found, expected, part * std::abs(expected));
  };
  EXPECT_NEAR(a.normal_force, 80e3, 50.0);
  near(a.tangential.fx, b.tangential.fx, 0.01);
  near(a.tangential.fy, b.tangential.fy, 0.01);
  near(a.power, b.power, 0.01);
  near(a.tangential.adhesion_fraction, b.tangential.adhesion_fraction, 0.01);
  EXPECT_NEAR(b.tangential.adhesion_fraction, 0.73, 0.05);
  near(a.extent.area, b.extent.area, 0.01);
  near(a.extent.peak_pressure, b.extent.peak_pressure, 0.01);
  near(std::sqrt(a.ellipse.sdec.a * a.ellipse.sdec.b), std::sqrt(b.ellipse.sdec.a * b.ellipse.sdec.b), 5e-3);
  near(a.rolling_radius, b.rolling_radius, 1e-5);
  near(a.rolling_radius, 0.46, 1e-5);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.point[i], b.point[i], 0.1e-3) << i;  // pressed into each other by 0.08 mm
    EXPECT_NEAR(a.normal[i], b.normal[i], 1e-3);
    EXPECT_NEAR(a.force[i], b.force[i], 2e-3 * 80e3);
    EXPECT_NEAR(a.moment[i], b.moment[i], 1.5);  // of 0.3 N times 6 mm, 144 N m
  }
  // its sums are the wrench
  near(a.tangential.fx, hosted.wrench.force[0], 1e-12);
  near(a.tangential.fy, hosted.wrench.force[1], 1e-2);
  near(a.power, hosted.wrench.power, 1e-12);

  const BodyStresses &s = on_rail.stresses, &t = planar.stresses;
  near(s.surface.von_mises.value, t.surface.von_mises.value, 0.01);
  near(s.surface.shear.value, t.surface.shear.value, 0.01);
  near(s.below.von_mises.value, t.below.von_mises.value, 0.01);
  near(s.below.shear.value, t.below.shear.value, 0.01);
  near(s.below.shear.z, t.below.shear.z, 0.05);
  near(on_rail.damage.t_gamma, planar.damage.t_gamma, 0.01);
  near(on_rail.damage.t_gamma_no_spin, planar.damage.t_gamma_no_spin, 0.01);
  near(on_rail.damage.utilisation, planar.damage.utilisation, 0.01);
  near(on_rail.damage.local_fatigue_index, planar.damage.local_fatigue_index, 0.05);
  near(on_rail.wear.worn_area_rate, planar.wear.worn_area_rate, 0.01);
  near(on_rail.wear.largest_depth_rate, planar.wear.largest_depth_rate, 0.015);
  near(on_rail.wear.largest_depth_velocity, planar.wear.largest_depth_velocity, 0.015);
  near(on_rail.wear.largest_power_depth_velocity, planar.wear.largest_power_depth_velocity, 0.015);
  near(on_rail.temperature.rise, planar.temperature.rise, 0.015);
  near(on_rail.temperature.mean_rise, planar.temperature.mean_rise, 0.015);

  wheel.angular_velocity[2] = 2.0;  // and spin, whose slips follow the crown
  solve();
  RegionResult spinning, in_plane;
  ASSERT_EQ(find_region(*contact, 0, spinning).status, WRC_OK);
  press(0.0, 80e3);
  roll(spinning.creepage);
  ASSERT_EQ(find_region(*contact, 0, in_plane).status, WRC_OK);
  EXPECT_NEAR(spinning.creepage.spin, 0.1, 1e-3);
  near(spinning.tangential.fy, in_plane.tangential.fy, 0.02);
  EXPECT_NEAR(spinning.tangential.mz, in_plane.tangential.mz, 1.5);
  EXPECT_GT(std::abs(spinning.tangential.fy - a.tangential.fy), 0.02 * 80e3);
}

// Hertz: p0 / 3 at 0.48 a for nu = 0.3; here 0.28 and 0.25 are the usual ones.
TEST_F(ContactRegion, StressesBelowAWheelAreHertzs) {
  take_circle();
  wheel.frictionless = true;
  create();
  solve();
  const Assessed found = all_of(0);
  const double p0 = found.region.extent.peak_pressure, nu = config.rail_material.poisson;
  const double a = std::sqrt(1.5 * 80e3 / (3.14159265358979 * p0));
  double largest = 0.0, depth = 0.0;  // on the axis: Johnson 1985, 3.4
  for (double z = 0.3; z < 0.7; z += 1e-4) {
    const double along = 1.0 / (1.0 + z * z);
    const double radial = (1.0 + nu) * (1.0 - z * std::atan(1.0 / z)) - 0.5 * along;
    if (0.5 * (along - radial) <= largest) continue;
    largest = 0.5 * (along - radial);
    depth = z;
  }
  EXPECT_NEAR(found.stresses.below.shear.value, largest * p0, 0.01 * largest * p0);
  EXPECT_NEAR(found.stresses.below.shear.z, depth * a, 0.05 * depth * a);
  EXPECT_EQ(found.region.tangential.adhesion_fraction, 0.0);
}

TEST_F(ContactRegion, SpinMomentIsThatOfTheCells) {
  wheel.angular_velocity[2] = 0.05;
  for (const double y : {0.0, 5.5e-3, 6.6e-3}) {
    wheel.y = y;
    for (const double yaw : {0.0, 8e-3}) {
      const auto [sine, cosine] = std::pair(std::sin(yaw), std::cos(yaw));
      const double turned[3][3] = {{cosine, -sine, 0.0}, {sine, cosine, 0.0}, {0.0, 0.0, 1.0}};
      std::memcpy(wheel.rotation, turned, sizeof turned);
      create();
      const HostWrench& hosted = solve();
      ASSERT_GT(hosted.wrench.regions, 0);
      for (int32_t k = 0; k < hosted.wrench.regions; ++k) {
        RegionResult region;
        ASSERT_EQ(find_region(*contact, k, region).status, WRC_OK);
        double load = 0.0, x0 = 0.0, s0 = 0.0, spin = 0.0, size = 0.0;
        over_cells(k, FieldId::pressure, [&](double p, double x, double s, double area) {
          load += p * area;
          x0 += p * area * x;
          s0 += p * area * s;
        });
        x0 /= load;
        s0 /= load;
        EXPECT_NEAR(x0, region.point[0], 2e-5);
        over_cells(k, FieldId::traction_y, [&](double q, double x, double s, double area) {
          spin += q * area * (x - x0);
          size += std::abs(q) * area * std::hypot(x - x0, s - s0);
        });
        over_cells(k, FieldId::traction_x, [&](double q, double x, double s, double area) {
          spin -= q * area * (s - s0);
          size += std::abs(q) * area * std::hypot(x - x0, s - s0);
        });
        EXPECT_NEAR(region.tangential.mz, spin, 5e-3 * size) << y << " " << k;
        // without yaw nothing of the pressure turns about the normal of a
        // surface that is nearly flat
        double about_normal = 0.0;
        for (int i = 0; i < 3; ++i) about_normal += region.moment[i] * region.normal[i];
        if (yaw == 0.0 && y == 0.0) {
          EXPECT_NEAR(region.tangential.mz, about_normal, 0.02 * size);
        }
      }
    }
  }
}

TEST_F(ContactRegion, ForcesAlongTheRailAreThoseOfTheWrench) {
  wheel.y = 5.5e-3;
  wheel.velocity[1] = 0.02;
  create();
  const HostWrench& hosted = solve();
  ASSERT_EQ(hosted.wrench.regions, 2);
  double along = 0.0;
  for (int32_t k = 0; k < 2; ++k) {
    RegionResult region;
    ASSERT_EQ(find_region(*contact, k, region).status, WRC_OK);
    along += region.tangential.fx;
    EXPECT_NEAR(region.tangential.fx, region.force[0], 1e-9 * region.normal_force);
    const double across = region.normal[2] * region.force[1] - region.normal[1] * region.force[2];
    EXPECT_NEAR(region.tangential.fy, across, 2e-3 * region.normal_force);
    EXPECT_GT(std::abs(region.tangential.fy), 0.01 * region.normal_force);
  }
  EXPECT_NEAR(along, hosted.wrench.force[0], 1e-9 * hosted.wrench.normal_force);
}

// The mirror image of a right-hand wheel: what lies across and turns about x or
// the normal changes sign.
TEST_F(ContactRegion, SidesAreMirrorImages) {
  wheel.y = 5.5e-3;
  wheel.velocity[1] = 0.02;
  wheel.angular_velocity[2] = 0.05;
  create();
  solve();
  std::vector<Assessed> right;
  for (int32_t k = 0; k < region_count(*contact); ++k) right.push_back(all_of(k));
  ASSERT_EQ(right.size(), 2U);
  for (double* each : {&wheel.y, &wheel.velocity[1], &wheel.angular_velocity[2]}) *each = -*each;
  take(WRC_SIDE_LEFT);
  solve();
  ASSERT_EQ(region_count(*contact), 2);
  for (int32_t k = 0; k < 2; ++k) {
    const Assessed& one = right[static_cast<std::size_t>(k)];
    const Assessed other = all_of(k);
    const RegionResult &a = one.region, &b = other.region;
    for (int i = 0; i < 3; ++i) {
      const double sign = i == 1 ? -1.0 : 1.0;
      EXPECT_EQ(a.point[i], sign * b.point[i]);
      EXPECT_EQ(a.normal[i], sign * b.normal[i]);
      EXPECT_EQ(a.force[i], sign * b.force[i]);
      EXPECT_EQ(a.moment[i], -sign * b.moment[i]);
    }
    EXPECT_EQ(a.angle, -b.angle);
    EXPECT_EQ(a.place.y_rail, b.place.y_rail);
    EXPECT_EQ(a.tangential.fx, b.tangential.fx);
    EXPECT_EQ(a.tangential.fy, -b.tangential.fy);
    EXPECT_EQ(a.tangential.mz, -b.tangential.mz);
    EXPECT_EQ(a.creepage.lateral, -b.creepage.lateral);
    EXPECT_EQ(a.creepage.spin, -b.creepage.spin);
    EXPECT_EQ(a.tangential.adhesion_fraction, b.tangential.adhesion_fraction);
    EXPECT_EQ(std::memcmp(&one.damage, &other.damage, sizeof one.damage), 0);
    EXPECT_GT(one.damage.t_gamma_no_spin, 0.0);
    EXPECT_EQ(std::memcmp(&one.wear, &other.wear, sizeof one.wear), 0);
    EXPECT_TRUE(same(one.stresses, other.stresses));
  }
}

// On both sides: by the wheel's height where it carries the load, and by the
// stages' gap.
TEST_F(ContactRegion, BothSolutionsSayWhereTheContactIs) {
  create();
  for (const int32_t side : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    take(side);
    wheel.y = side == WRC_SIDE_RIGHT ? -3e-3 : 3e-3;
    solve();
    RegionResult on_rail, planar;
    ASSERT_EQ(find_region(*contact, 0, on_rail).status, WRC_OK);
    press(wheel.y, 80e3);
    roll(some);
    ASSERT_EQ(find_region(*contact, 0, planar).status, WRC_OK);
    const RegionPlace &a = on_rail.place, &b = planar.place;
    EXPECT_NEAR(a.y_rail, b.y_rail, 0.5e-3);
    EXPECT_NEAR(a.y_wheel, b.y_wheel, 0.5e-3);
    EXPECT_NEAR(a.z_rail, b.z_rail, 0.1e-3);
    EXPECT_NEAR(a.z_wheel, b.z_wheel, 0.1e-3);
    EXPECT_NEAR(on_rail.rolling_radius, planar.rolling_radius, 0.1e-3);
    EXPECT_NEAR(on_rail.angle, planar.angle, 5e-3);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(on_rail.point[i], planar.point[i], i == 1 ? 0.5e-3 : 0.1e-3);
    EXPECT_EQ(on_rail.angle < 0.0, side == WRC_SIDE_RIGHT);
    EXPECT_GT(std::abs(a.y_rail), 2e-3);
  }
}

/// A patch's force and moment in track axes, summed over its cells.
TEST_F(ContactRegion, APatchHasTheWrenchOfItsCells) {
  for (const int32_t side : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    create(side);
    press(side == WRC_SIDE_RIGHT ? 3e-3 : -3e-3, 80e3, 5e-3);
    roll(some);
    for (int32_t k = 0; k < region_count(*contact); ++k) {
      RegionResult region;
      ASSERT_EQ(find_region(*contact, k, region).status, WRC_OK);
      const double *const n = region.normal, joint = region.ellipse.joint;
      double force[3] = {}, moment[3] = {};
      const auto add = [&](double x, double y, double area, double qx, double qy, double p) {
        const double at[3] = {x, n[2] * (y - joint), -n[1] * (y - joint)};
        const double f[3] = {area * qx, area * (n[2] * qy - n[1] * p), area * (-n[1] * qy - n[2] * p)};
        for (int i = 0; i < 3; ++i) {
          force[i] += f[i];
          moment[i] += at[(i + 1) % 3] * f[(i + 2) % 3] - at[(i + 2) % 3] * f[(i + 1) % 3];
        }
      };
      over_cells(k, FieldId::pressure,
                 [&](double p, double x, double y, double area) { add(x, y, area, 0.0, 0.0, p); });
      over_cells(k, FieldId::traction_x,
                 [&](double q, double x, double y, double area) { add(x, y, area, q, 0.0, 0.0); });
      over_cells(k, FieldId::traction_y,
                 [&](double q, double x, double y, double area) { add(x, y, area, 0.0, q, 0.0); });
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(region.force[i], force[i], 3e-3 * region.normal_force) << i;
        EXPECT_NEAR(region.moment[i], moment[i], 3e-3 * region.normal_force * 5e-3) << i;
      }
    }
  }
}

TEST_F(ContactRegion, TheNewestSolutionAnswers) {
  create();
  EXPECT_EQ(region_count(*contact), 0);
  RegionResult region;
  DamageNumbers damage;
  FieldSize size;
  EXPECT_EQ(find_region(*contact, 0, region).status, WRC_ERROR_SEQUENCE);
  EXPECT_EQ(region_damage(*contact, all_regions, damage).status, WRC_ERROR_SEQUENCE);
  press(0.0, 80e3);
  ASSERT_EQ(find_region(*contact, 0, region).status, WRC_OK);
  EXPECT_TRUE(region.placed);
  EXPECT_FALSE(region.rolled);
  EXPECT_EQ(region_damage(*contact, 0, damage).status, WRC_ERROR_SEQUENCE);
  EXPECT_EQ(region_field_size(*contact, 0, FieldId::traction_x, size).status, WRC_ERROR_SEQUENCE);
  EXPECT_NEAR(integral(0, FieldId::pressure), 80e3, 300.0);
  EXPECT_EQ(field(5, FieldId::gap_height).size(), static_cast<std::size_t>(contact->gap_rows));
  EXPECT_EQ(region_field_size(*contact, 0, FieldId::strip_profile_y, size).status, WRC_ERROR_UNSUPPORTED);
  roll(some);
  EXPECT_EQ(region_damage(*contact, all_regions, damage).status, WRC_OK);
  EXPECT_EQ(region_damage(*contact, 1, damage).status, WRC_ERROR_RANGE);
  EXPECT_EQ(region_field_size(*contact, all_regions, FieldId::x, size).status, WRC_ERROR_RANGE);

  solve();
  EXPECT_EQ(region_damage(*contact, all_regions, damage).status, WRC_ERROR_RANGE);
  EXPECT_EQ(region_damage(*contact, 0, damage).status, WRC_OK);
  EXPECT_EQ(region_field_size(*contact, 0, FieldId::gap_y, size).status, WRC_ERROR_SEQUENCE);
  EXPECT_EQ(field(0, FieldId::strip_angle).size(), field(0, FieldId::strip_y).size());
  wheel.load_prescribed = false;
  wheel.z = -5e-3;
  solve();
  EXPECT_EQ(region_count(*contact), 0);
  EXPECT_EQ(find_region(*contact, 0, region).status, WRC_ERROR_RANGE);
  roll(some);  // of the patch that was pressed before
  EXPECT_EQ(region_damage(*contact, all_regions, damage).status, WRC_OK);
}

// Forces alone: of a patch or a region that rolled as a whole there are no
// cells.
TEST_F(ContactRegion, WithoutTractionsWhatNeedsThemIsRefused) {
  config.tangential.method = WRC_TANGENTIAL_FASTSIM;
  config.tangential.flexibility = WRC_FLEXIBILITY_SINGLE;
  create();
  solve();
  Assessed all;
  FieldSize size;
  ASSERT_EQ(find_region(*contact, 0, all.region).status, WRC_OK);
  EXPECT_FALSE(all.region.adhesion_known);
  EXPECT_EQ(region_damage(*contact, 0, all.damage).status, WRC_OK);
  EXPECT_GT(all.damage.power, 0.0);
  EXPECT_EQ(all.damage.peak_power_density, 0.0);
  EXPECT_EQ(region_wear(*contact, 0, laws, all.wear).status, WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(region_temperature(*contact, 0, {}, all.temperature).status, WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(region_field_size(*contact, 0, FieldId::slip_x, size).status, WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(region_field_size(*contact, 0, FieldId::strip_friction, size).status, WRC_OK);
  EXPECT_NEAR(integral(0, FieldId::pressure), all.region.extent.normal_force, 3e-3 * all.region.normal_force);
}

// ----------------------------------------------------------------------------------------------------------
// clearance

/// Lowered by its clearance the wheel touches, and a nanometre higher it does
/// not.
TEST_F(ContactRegion, LoweredByItsClearanceAWheelTouches) {
  const struct {
    double y, yaw;
    bool on_flange;
  } poses[] = {{0.0, 0.0, false}, {-4e-3, 5e-3, false}, {6.5e-3, 0.0, true}, {9e-3, -10e-3, true}};
  wheel.load_prescribed = false;
  create();
  for (const int32_t side : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    take(side);
    const double outward = side == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    for (const auto& pose : poses) {
      wheel.y = outward * pose.y;
      const auto [sine, cosine] = std::pair(std::sin(outward * pose.yaw), std::cos(pose.yaw));
      const double turned[3][3] = {{cosine, -sine, 0.0}, {sine, cosine, 0.0}, {0.0, 0.0, 1.0}};
      std::memcpy(wheel.rotation, turned, sizeof turned);
      wheel.z = -40e-3;
      const double about = wheel.z + solve().wrench.clearance;
      for (const double above : {0.3e-3, 3e-3, 12e-3, 35e-3}) {
        wheel.z = about - above;
        const double touch = wheel.z + solve().wrench.clearance;
        EXPECT_NEAR(touch, about, 1e-9) << above << " " << pose.y;
        wheel.z = touch - 1e-9;
        EXPECT_EQ(solve().wrench.regions, 0) << above << " " << pose.y;
        EXPECT_NEAR(contact->wheel.wrench.clearance, 1e-9, 1e-10);
        wheel.z = touch + 1e-9;
        const surface::Wrench& found = solve().wrench;
        EXPECT_GT(found.regions, 0) << above << " " << pose.y;
        EXPECT_EQ(found.clearance, 0.0);
        EXPECT_EQ(contact->wheel.place[0].y_wheel < -25e-3, pose.on_flange)
            << contact->wheel.place[0].y_wheel;
      }
    }
  }
}

TEST_F(ContactRegion, ClearanceFollowsTheHeightAndEndsAtItsBound) {
  wheel.load_prescribed = false;
  create();
  wheel.y = 2e-3;
  wheel.z = -49e-3;
  const double touch = wheel.z + solve().wrench.clearance;
  for (const double above : {40e-3, 10e-3, 1.7e-3, 1.4e-3, 0.6e-3, 0.4e-3, 1e-5, 1e-8}) {
    wheel.z = touch - above;
    EXPECT_NEAR(solve().wrench.clearance, above, 1e-10);
  }
  wheel.z = touch - surface::farthest_touch - 1e-3;
  EXPECT_EQ(solve().wrench.clearance, surface::farthest_touch);
  wheel.z = touch - 0.3;
  EXPECT_EQ(solve().wrench.clearance, surface::farthest_touch);
  // beside the rail nothing is there to touch
  wheel.y = -0.19;
  wheel.z = 0.0;
  ASSERT_EQ(solve().wrench.regions, 0);
  EXPECT_EQ(contact->wheel.wrench.clearance, surface::farthest_touch);
  // no clearance inside it
  wheel.y = 0.02;
  ASSERT_EQ(solve().wrench.regions, 0);
  EXPECT_EQ(contact->wheel.wrench.clearance, 0.0);
  // nor where a load is carried
  wheel.y = 0.0;
  wheel.z = -30e-3;
  wheel.load_prescribed = true;
  wheel.vertical_load = 50e3;
  EXPECT_EQ(solve().wrench.clearance, 0.0);
}

}  // namespace
}  // namespace wrc::contact
