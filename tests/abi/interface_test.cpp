/// The C interface as a vendor meets it: handles, memory, struct versions, bad input, errors as sentences.
/// Links the shared library and nothing of its inside.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>
#if defined(_WIN32)
#include <xmmintrin.h>
#endif

#include "field_values.hpp"
#include "presets.hpp"
#include "reference_contact.hpp"
#include "test_config.hpp"
#include "wrc/wrc_api.h"
#include "wrc/wrc_experimental_api.h"
#include "wrc/wrc_offline.h"

namespace {

using Interface = ReferenceContact;

// ------------------------------------------------------------------------------------------------------- bad
// values

TEST_F(Interface, AGoodStepWorks) { expect_works(); }

TEST_F(Interface, LoadInKilonewtonsIsNoticed) {
  load.normal_force = 80.0;
  expect_refused(WRC_ERROR_RANGE, {"load.normal_force = 80 N", "100 .. 1e+06 N", "kN"});
  load.normal_force = 80e3;
  expect_works();
}

TEST_F(Interface, ALoadThatWasNotSetIsNoticed) {
  load = wrc_planar_load_default();
  expect_refused(WRC_ERROR_RANGE, {"load.normal_force = 0 N", "was it set?"});
  EXPECT_EQ(error().find("kN"), std::string::npos) << error();
}

TEST_F(Interface, NegativeAndAbsurdLoadsAreRefused) {
  load.normal_force = -80e3;
  expect_refused(WRC_ERROR_RANGE, {"load.normal_force = -80000 N", "compressive"});
  load.normal_force = 861e6;
  expect_refused(WRC_ERROR_RANGE, {"load.normal_force", "pressure"});
  load.normal_force = 80e3;
  expect_works();
}

TEST_F(Interface, NanAndInfinityAreNamedWhereverTheyStand) {
  double* const values[] = {&pose.lateral,          &pose.roll,        &pose.yaw,      &load.normal_force,
                            &creepage.longitudinal, &creepage.lateral, &creepage.spin, &creepage.speed,
                            &friction.coefficient};
  const char* const names[] = {
      "pose.lateral",     "pose.roll",     "pose.yaw",       "load.normal_force",   "creepage.longitudinal",
      "creepage.lateral", "creepage.spin", "creepage.speed", "friction.coefficient"};
  for (std::size_t i = 0; i < sizeof values / sizeof *values; ++i) {
    const double good = *values[i];
    for (double bad : {nan_value, infinity, -infinity}) {
      *values[i] = bad;
      expect_refused(WRC_ERROR_NOT_FINITE, {names[i]});
    }
    *values[i] = good;
  }
  expect_works();
}

TEST_F(Interface, FrictionMustBePositive) {
  for (double bad : {0.0, -0.3}) {
    friction.coefficient = bad;
    expect_refused(WRC_ERROR_RANGE, {"friction.coefficient", "positive"});
  }
  friction.coefficient = 35.0;
  expect_refused(WRC_ERROR_RANGE, {"friction.coefficient = 35", "per cent"});
}

TEST_F(Interface, PureNumbersHaveNoUnitInSentences) {
  wrc_ellipse slender = sized<wrc_ellipse>();
  slender.a = 3e-2;
  slender.b = 1e-3;
  slender.normal_force = 80e3;
  EXPECT_EQ(wrc_planar_tangential(contact, &slender, &creepage, &friction, &forces), WRC_FLAG_TABLE_RANGE);
  expect_words(error(), {" is outside 0.05 .. 20:"});
  EXPECT_EQ(error().find(" 1:"), std::string::npos) << error();
}

TEST_F(Interface, PoseInMillimetresIsNoticed) {
  pose.lateral = 3.0;
  expect_refused(WRC_ERROR_RANGE, {"pose.lateral = 3 m", "mm"});
  pose.lateral = -0.1;  // allowed as a number, but the wheel has left the rail
  EXPECT_LT(step(), 0);
  EXPECT_EQ(forces.fn, 0.0);
  pose.lateral = 0.0;
  expect_works();
}

TEST_F(Interface, ApproachInMillimetresIsNoticed) {
  load.prescribed = WRC_PRESCRIBE_APPROACH;
  load.approach = 0.067;
  expect_refused(WRC_ERROR_RANGE, {"load.approach = 0.067 m", "mm"});
}

TEST_F(Interface, WheelAboveTheRailIsNoContactAndNoError) {
  load.prescribed = WRC_PRESCRIBE_APPROACH;
  for (double apart : {0.0, -1e-6, -0.5}) {
    load.approach = apart;
    EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT);
    EXPECT_EQ(forces.fn, 0.0);
    EXPECT_EQ(forces.power, 0.0);
    EXPECT_EQ(normal.area, 0.0);
  }
  load.approach = 67e-6;
  EXPECT_EQ(step(), WRC_OK);
  EXPECT_NEAR(forces.fn, 80e3, 5e3);
}

TEST_F(Interface, ContactOnTheLastStripOfTheGivenGapIsFlagged) {
  // A parabolic gap cut off at y = 2 mm, well inside the patch.
  std::vector<double> y, height, curvature;
  for (int j = 0; j < 40; ++j) {
    y.push_back(-0.025 + 0.027 * j / 39.0);
    height.push_back(0.5 * y.back() * y.back());
    curvature.push_back(1.0 / 0.46);
  }
  wrc_planar_gap gap = sized<wrc_planar_gap>();
  gap.row_count = 40;
  gap.y = y.data();
  gap.height = height.data();
  gap.curvature = curvature.data();
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_FLAG_PATCH_AT_EDGE) << error();
  EXPECT_GT(normal.area, 0.0);
}

TEST_F(Interface, GapOfTheCallerIsChecked) {
  std::vector<double> y{-0.02, -0.01, 0.0, 0.01, 0.02}, height{4e-4, 1e-4, 0.0, 1e-4, 4e-4},
      curvature(5, 2.0);
  wrc_planar_gap gap = sized<wrc_planar_gap>();
  gap.row_count = 5;
  gap.y = y.data();
  gap.height = height.data();
  gap.curvature = curvature.data();
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_OK) << error();
  height[3] = nan_value;
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_ERROR_NOT_FINITE);
  EXPECT_NE(error().find("gap.height[3]"), std::string::npos) << error();
  EXPECT_EQ(normal.area, 0.0);
  height[3] = 1e-4;
  y[2] = -0.015;
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_ERROR_GAP);
  EXPECT_NE(error().find("gap.y[2]"), std::string::npos) << error();
  y[2] = 0.0;
  curvature[4] = -2.0;
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_ERROR_RANGE);
  EXPECT_NE(error().find("gap.curvature[4]"), std::string::npos) << error();
  curvature[4] = 2.0;
  gap.row_count = 3;
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_ERROR_RANGE);
  gap.row_count = 100000;
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_ERROR_RANGE);
  gap.row_count = 5;
  gap.height = nullptr;
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_ERROR_NULL);
  gap.height = height.data();
  EXPECT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_OK) << error();
}

TEST_F(Interface, ElementWiseGapGivesTheSamePatchAsItsRows) {
  std::vector<double> x, y, h, height, centre, curvature;
  for (int i = 0; i < 61; ++i) x.push_back(-0.015 + 0.03 * i / 60.0);
  for (int j = 0; j < 101; ++j) {
    y.push_back(-0.02 + 0.04 * j / 100.0);
    height.push_back(0.8 * y[static_cast<std::size_t>(j)] * y[static_cast<std::size_t>(j)]);
    centre.push_back(0.1 * y[static_cast<std::size_t>(j)]);
    curvature.push_back(2.2);
    for (double xi : x) h.push_back(height.back() + 1.1 * (xi - centre.back()) * (xi - centre.back()));
  }
  wrc_planar_gap gap = sized<wrc_planar_gap>();
  gap.row_count = 101;
  gap.y = y.data();
  gap.height = height.data();
  gap.centre = centre.data();
  gap.curvature = curvature.data();
  wrc_planar_normal_solution by_rows{};
  ASSERT_EQ(wrc_planar_normal(contact, &gap, &load, &by_rows), WRC_OK) << error();
  gap.column_count = 61;
  gap.x = x.data();
  gap.h = h.data();
  gap.row_stride = 61;
  ASSERT_EQ(wrc_planar_normal(contact, &gap, &load, &normal), WRC_OK) << error();
  EXPECT_NEAR(normal.approach, by_rows.approach, 1e-9 * by_rows.approach);
  EXPECT_NEAR(normal.area, by_rows.area, 1e-9 * by_rows.area);
}

TEST_F(Interface, StagesOutOfOrderAreRefused) {
  wrc_contact* fresh = nullptr;
  ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &fresh, nullptr, 0), WRC_OK);
  EXPECT_EQ(wrc_planar_normal(fresh, nullptr, &load, &normal), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(wrc_planar_regularise(fresh, nullptr, &normal), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(wrc_planar_tangential(fresh, nullptr, &creepage, &friction, &forces), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(wrc_contact_damage(fresh, WRC_ALL_REGIONS, &damage), WRC_ERROR_SEQUENCE);
  double value = 7.0;
  uint64_t counts[2] = {7, 7};
  EXPECT_EQ(wrc_contact_field(fresh, 0, WRC_FIELD_PRESSURE, &value, 1, counts), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(counts[0], 0U);
  EXPECT_EQ(counts[1], 0U);
  EXPECT_EQ(wrc_contact_field(fresh, 0, 4711, &value, 1, counts), WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(value, 7.0);
  wrc_contact_destroy(fresh);
}

TEST_F(Interface, StagesAloneGiveTheBitsOfTheStep) {
  expect_works();
  const wrc_planar_forces whole = forces;
  const wrc_damage whole_damage = damage;
  EXPECT_EQ(wrc_planar_geometry(contact, &pose, &point), WRC_OK);
  EXPECT_EQ(wrc_planar_normal(contact, nullptr, &load, &normal), WRC_OK);
  EXPECT_EQ(wrc_planar_regularise(contact, nullptr, &normal), WRC_OK);
  EXPECT_EQ(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces), WRC_OK);
  EXPECT_EQ(wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage), WRC_OK);
  EXPECT_EQ(std::memcmp(&whole, &forces, sizeof forces), 0);
  EXPECT_EQ(std::memcmp(&whole_damage, &damage, sizeof damage), 0);
}

TEST_F(Interface, WearFollowsItsLaws) {
  wrc_wear wear{}, other = wrc_wear{};
  ASSERT_EQ(wrc_planar_geometry(contact, &pose, &point), WRC_OK);
  EXPECT_EQ(wrc_contact_wear(contact, WRC_ALL_REGIONS, nullptr, &wear), WRC_ERROR_SEQUENCE);
  expect_works();
  ASSERT_EQ(wrc_contact_wear(contact, WRC_ALL_REGIONS, nullptr, &wear), WRC_OK) << error();
  // Mild up to 100 N: 0.25 mm^3/(km N) over a diameter of 920 mm.
  ASSERT_LT(damage.t_gamma, 100.0);
  EXPECT_NEAR(wear.worn_area_rate, 0.25e-12 * damage.t_gamma / 0.92, 1e-9 * wear.worn_area_rate);
  EXPECT_GT(wear.largest_depth_rate, 0.0);
  EXPECT_GT(wear.largest_depth_velocity, 0.0);

  wrc_wear_laws laws = wrc_wear_laws_default();
  laws.sheffield_mild_slope *= 2.0;
  laws.hardness *= 2.0;
  laws.seizure_pressure = 1e3;
  ASSERT_EQ(wrc_contact_wear(contact, WRC_ALL_REGIONS, &laws, &other), WRC_OK) << error();
  EXPECT_NEAR(other.largest_depth_rate, 2.0 * wear.largest_depth_rate, 1e-12 * other.largest_depth_rate);

  // All is within the mild regime, where Sheffield's law is proportional to the frictional power. What the
  // strips lose by the published law, whatever was asked before, adds up to slope * T-gamma / density.
  double lost = 0.0;
  for (int32_t k = 0; k < normal.patch_count; ++k) {
    const FieldValues worn = field_values(contact, k, WRC_FIELD_STRIP_WEAR),
                      width = field_values(contact, k, WRC_FIELD_STRIP_WIDTH);
    ASSERT_EQ(worn.status, WRC_OK);
    ASSERT_EQ(width.status, WRC_OK);
    for (std::size_t j = 0; j < worn.strips; ++j) lost += worn[j] * width[j];
  }
  EXPECT_NEAR(lost, 5.3e-9 * damage.power / creepage.speed / 7850.0, 1e-3 * lost);
  EXPECT_LE(other.largest_depth_velocity, 0.5 * wear.largest_depth_velocity * (1.0 + 1e-12));

  laws.hardness = 3.0;
  EXPECT_EQ(wrc_contact_wear(contact, WRC_ALL_REGIONS, &laws, &other), WRC_ERROR_RANGE);
  EXPECT_EQ(other.worn_area_rate, 0.0);
  ASSERT_EQ(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces), WRC_OK);
  EXPECT_EQ(field_values(contact, 0, WRC_FIELD_STRIP_WEAR).status, WRC_OK);  // no call need come before
}

TEST_F(Interface, StripsOfTheCallerGoThrough) {
  // Two strips of 40 kN each.
  const double y[] = {-2e-3, 2e-3}, width[] = {4e-3, 4e-3}, half[] = {5e-3, 5e-3};
  const double peak_pressure = 40e3 / (0.5 * 3.14159265358979 * 5e-3 * 4e-3);
  double peak[] = {peak_pressure, peak_pressure};
  wrc_planar_strips strips = sized<wrc_planar_strips>();
  strips.count = 2;
  strips.y = y;
  strips.width = width;
  strips.half_length = half;
  strips.peak = peak;
  ASSERT_EQ(wrc_planar_regularise(contact, &strips, &normal), WRC_OK) << error();
  EXPECT_NEAR(normal.normal_force, 80e3, 1e-6);
  EXPECT_NEAR(normal.ellipse.b, 4e-3, 1e-15);
  EXPECT_NEAR(normal.ellipse.psi, 0.0, 1e-12);
  ASSERT_EQ(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces), WRC_OK) << error();
  EXPECT_NEAR(forces.fn, 80e3, 1e-6);
  peak[1] = -1.0;
  EXPECT_EQ(wrc_planar_regularise(contact, &strips, &normal), WRC_ERROR_RANGE);
  EXPECT_NE(error().find("strips.peak[1]"), std::string::npos);
}

// ----------------------------------------------------------------------------------------------------
// configuration

TEST_F(Interface, EveryInstructionSetGivesTheSameBits) {
  expect_works();
  const wrc_planar_forces best = forces;
  const wrc_damage best_damage = damage;
  for (int32_t set : {WRC_INSTRUCTIONS_BASELINE, WRC_INSTRUCTIONS_AVX2, WRC_INSTRUCTIONS_AVX512}) {
    config.instruction_set = set;
    char text[256];
    const int32_t supported = wrc_config_check(&config, text, sizeof text);
    if (supported != WRC_OK) {
      EXPECT_NE(set, static_cast<int32_t>(WRC_INSTRUCTIONS_BASELINE));
      expect_config_refused(WRC_ERROR_UNSUPPORTED, {"config.instruction_set", "lacks that instruction set"});
      continue;
    }
    create();
    expect_works();
    EXPECT_EQ(std::memcmp(&forces, &best, sizeof best), 0) << "set " << set;
    EXPECT_EQ(std::memcmp(&damage, &best_damage, sizeof best_damage), 0) << "set " << set;
  }
  config.instruction_set = 4;
  expect_config_refused(WRC_ERROR_UNSUPPORTED, {"config.instruction_set = 4", "enum wrc_instruction_set"});
}

TEST_F(Interface, RailsCantedTwiceOrTooShallowAreRefused) {
  config.track.rail_inclination = 0.025;
  expect_config_refused(WRC_ERROR_UNSUPPORTED,
                        {"config.track.rail_inclination = 0.025", "canted 1:40 already", "WRC_PROFILE_60E1"});
  rail.kind = WRC_PROFILE_60E1;
  EXPECT_EQ(wrc_config_check(&config, nullptr, 0), WRC_OK);
  // A head of 9 mm: where the gauge is measured, 14 mm below its top, there is no rail.
  std::vector<double> y, z;
  for (int i = 0; i <= 120; ++i) {
    y.push_back(-0.03 + 5e-4 * i);
    z.push_back(10.0 * y.back() * y.back());
  }
  rail.kind = WRC_PROFILE_POINTS;
  rail.count = static_cast<uint32_t>(y.size());
  rail.y = y.data();
  rail.z = z.data();
  config.track.rail_inclination = 0.0;
  expect_config_refused(WRC_ERROR_PROFILE, {"depth of the rail profile at its gauge end = 0.009 m",
                                            "0.014 .. 1 m", "config.track.gauge_depth"});
  config.track.gauge_depth = 8.9e-3;
  EXPECT_EQ(wrc_config_check(&config, nullptr, 0), WRC_OK);
  // A step of 5 mm is a step, whatever else it makes of the profile.
  for (std::size_t i = 70; i < z.size(); ++i) z[i] -= 5e-3;
  expect_config_refused(WRC_ERROR_PROFILE, {"step of rail profile z[70] = -0.00495", " m: ", "jumps"});
}

TEST_F(Interface, ConfigurationValuesAreChecked) {
  config.rail_material.poisson = 0.51;
  expect_config_refused(WRC_ERROR_RANGE, {"config.rail_material.poisson = 0.51", "0 .. 0.5"});
  config.wheel_material.poisson = 0.52;
  expect_config_refused(WRC_ERROR_RANGE, {"config.wheel_material.poisson = 0.52", "0 .. 0.5"});
  config.wheel_material.poisson = config.rail_material.poisson = -0.1;
  expect_config_refused(WRC_ERROR_RANGE, {"config.wheel_material.poisson"});
  config.wheel_material.poisson = config.rail_material.poisson = nan_value;
  expect_config_refused(WRC_ERROR_NOT_FINITE, {"config.wheel_material.poisson"});
  config.wheel_material.poisson = config.rail_material.poisson = 0.28;
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 80e3;
  expect_config_refused(WRC_ERROR_RANGE, {"config.wheel_material.shear_modulus", "MPa"});
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 80e9;
  config.wheelset.wheel_radius = 460.0;
  expect_config_refused(WRC_ERROR_RANGE, {"config.wheelset.wheel_radius", "mm"});
  config.wheelset.wheel_radius = 0.46;
  config.planar.strips = 0;
  expect_config_refused(WRC_ERROR_RANGE, {"config.planar.strips"});
  config.planar.strips = 60;
  config.normal.method = 99;
  expect_config_refused(WRC_ERROR_UNSUPPORTED, {"config.normal.method"});
  config.normal.method = WRC_NORMAL_EKP;
  const wrc_profile given = rail;
  rail = sized<wrc_profile>();
  expect_config_refused(WRC_ERROR_PROFILE, {"config.rail", "WRC_PROFILE_NONE", "both"});
  std::swap(wheel, rail);
  expect_config_refused(WRC_ERROR_PROFILE, {"config.wheel", "WRC_PROFILE_NONE"});
  std::swap(wheel, rail);
  rail = given;
  config.rail = wheel;
  expect_config_refused(WRC_ERROR_PROFILE, {"config.rail"});
}

TEST_F(Interface, ProfilesFromPointsAreChecked) {
  std::vector<double> y, z;
  for (int i = 0; i <= 140; ++i) {  // a rail crown of 300 mm radius, with corners
    y.push_back(-0.035 + 0.0005 * i);
    const double corner = std::fmax(0.0, std::fabs(y.back()) - 0.025);
    z.push_back(0.3 - std::sqrt(0.09 - y.back() * y.back()) + 150.0 * corner * corner);
  }
  rail.kind = WRC_PROFILE_POINTS;
  const auto set = [&](std::size_t count) {
    rail.count = static_cast<uint32_t>(count);
    rail.y = y.data();
    rail.z = z.data();
  };
  const std::vector<double> good_y = y, good_z = z;
  set(y.size());
  char text[256];
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_OK) << text;
  set(3);
  expect_config_refused(WRC_ERROR_RANGE, {"config.rail.count = 3", "4 .. 20000", "spline"});
  set(y.size());
  z[17] = nan_value;
  expect_config_refused(WRC_ERROR_NOT_FINITE, {"17"});
  z = good_z;
  std::swap(y[50], y[51]);
  expect_config_refused(WRC_ERROR_PROFILE, {"51"});
  y = good_y;
  for (double& value : y) value *= 1e3;
  for (double& value : z) value *= 1e3;
  expect_config_refused(WRC_ERROR_PROFILE, {"millimetres"});
  y = good_y;
  z = good_z;
  for (double& value : z) value = -value;
  expect_config_refused(WRC_ERROR_PROFILE, {"down"});
  z = good_z;
  rail.z = nullptr;
  expect_config_refused(WRC_ERROR_NULL, {"config.rail"});
}

/// Every published name gives a model; others are refused with the names there are.
TEST_F(Interface, PublishedMethodsAreTakenByName) {
  for (int32_t preset = 0; preset < tangential_methods; ++preset) {
    config.tangential.bound = WRC_BOUND_ELLIPSOIDAL;  // of another method, tried before
    choose_tangential(config, preset);
    EXPECT_EQ(config.tangential.method, presets[preset].method);
    expect_works();
  }
  const wrc_config before = config;
  char text[512] = "";
  EXPECT_EQ(wrc_config_use(&config, "FASTSIM_SDEC", text, sizeof text), WRC_ERROR_UNSUPPORTED);
  for (const Preset& preset : presets) expect_words(text, {"\"" + std::string(preset.name) + "\""});
  EXPECT_EQ(wrc_config_use(&config, nullptr, text, sizeof text), WRC_ERROR_NULL);
  expect_words(text, {"name"});
  EXPECT_EQ(std::memcmp(&config, &before, sizeof config), 0);
  EXPECT_EQ(wrc_config_use(nullptr, "FASTSIM", nullptr, 0), WRC_ERROR_NULL);
  config.struct_size = 8;
  EXPECT_EQ(wrc_config_use(&config, "FASTSIM", nullptr, 0), WRC_ERROR_STRUCT_SIZE);
}

/// FASTSIM and FaStrip on an ellipse about mid-width: creepages are those of its centre, y_c = psi b from the
/// contact point, and the moment comes back by - y_c Fx.
TEST_F(Interface, AnEllipseAboutMidWidthSpinsAboutItsOwnCentre) {
  wrc_ellipse own = sized<wrc_ellipse>();
  own.a = 4e-3;
  own.b = 6e-3;
  own.psi = 0.4;
  own.normal_force = 80e3;
  const double centre = own.psi * own.b, limit = friction.coefficient * own.normal_force;
  for (int32_t method : {WRC_TANGENTIAL_FASTSIM, WRC_TANGENTIAL_FASTRIP}) {
    config.tangential.method = method;
    config.tangential.patch_model = WRC_PATCH_MODEL_ELLIPSE_AT_MIDDLE;
    create();
    creepage.spin = 0.4;
    creepage.longitudinal = creepage.spin * centre;
    creepage.lateral = 0.0;
    ASSERT_EQ(wrc_planar_tangential(contact, &own, &creepage, &friction, &forces), WRC_OK);
    EXPECT_NEAR(forces.fx, 0.0, 1e-9 * limit);
    EXPECT_LT(forces.fy, -0.05 * limit);
    creepage.spin = 0.0;
    creepage.longitudinal = 1e-3;
    ASSERT_EQ(wrc_planar_tangential(contact, &own, &creepage, &friction, &forces), WRC_OK);
    EXPECT_NEAR(forces.mz, -centre * forces.fx, 1e-9 * limit);
    const wrc_planar_forces about_middle = forces;
    config.tangential.patch_model = WRC_PATCH_MODEL_ELLIPSE_AT_POINT;
    create();
    ASSERT_EQ(wrc_planar_tangential(contact, &own, &creepage, &friction, &forces), WRC_OK);
    EXPECT_EQ(forces.fx, about_middle.fx);  // without spin where the ellipse lies does not matter
  }
}

/// Modified FASTSIM is a law on any patch model; without a fall of the slope it is FASTSIM.
TEST_F(Interface, TheSlopeFallsOnEveryPatchModel) {
  creepage.longitudinal = -2e-3;
  for (int32_t each = WRC_PATCH_MODEL_PATCH_SDEC; each <= WRC_PATCH_MODEL_ELLIPSE_AT_POINT; ++each) {
    config.tangential.method = WRC_TANGENTIAL_FASTSIM;
    config.tangential.patch_model = each;
    create();
    friction.slope_fall = 0.0;
    friction.slope_limit = 0.5;
    ASSERT_EQ(step(), WRC_OK) << error();
    const double clean = forces.fx;
    friction.slope_limit = 0.02;
    ASSERT_EQ(step(), WRC_OK) << error();
    EXPECT_EQ(forces.fx, clean);
    friction.slope_fall = 0.6;
    ASSERT_EQ(step(), WRC_OK) << error();
    EXPECT_LT(forces.fx, 0.95 * clean);
    EXPECT_GT(forces.fx, 0.2 * clean);
  }
}

/// An option without effect is a mistake: refused by name, with who would read it.
TEST_F(Interface, OptionsTheMethodsDoNotReadAreRefused) {
  const wrc_config good = config;
  const auto refused = [&](const std::vector<std::string>& words) {
    expect_config_refused(WRC_ERROR_UNSUPPORTED, words);
    config = good;
  };
  config.normal.load_tolerance = 1e-6;
  refused({"config.normal.load_tolerance = 1e-06", "only WRC_NORMAL_HERTZ, ", "WRC_NORMAL_STRIPES read it"});
  config.normal.method = WRC_NORMAL_EKP;
  config.planar.start = WRC_START_WARM;
  refused({"config.planar.start = 1", "only WRC_NORMAL_STRIP_HALFSPACE reads it"});
  config.tangential.force_table = "force_table.bin";
  refused({"config.tangential.force_table", "only WRC_TANGENTIAL_FORCE_TABLE reads it"});
  for (const Preset& preset : presets) {
    if (preset.method == WRC_TANGENTIAL_FASTSIM) continue;
    config.tangential.method = preset.method;
    config.tangential.bound = WRC_BOUND_ELLIPTIC;
    refused({"config.tangential.bound = 1", "only WRC_TANGENTIAL_FASTSIM reads it"});
    config.tangential.method = preset.method;
    config.tangential.flexibility = WRC_FLEXIBILITY_BLENDED;
    refused({"config.tangential.flexibility = 2", "only WRC_TANGENTIAL_FASTSIM reads it"});
    if (preset.method == WRC_TANGENTIAL_FASTRIP) continue;
    config.tangential.method = preset.method;
    config.tangential.patch_model = WRC_PATCH_MODEL_ELLIPSE_AT_POINT;
    refused(
        {"config.tangential.patch_model = 3", "only WRC_TANGENTIAL_FASTSIM, WRC_TANGENTIAL_FASTRIP read it"});
  }
  wheel.smoothing = 5e-3;
  refused({"config.wheel.smoothing = 0.005 m", "points"});
  wheel.smoothing = 0.0;

  wheel = rail = sized<wrc_profile>();
  const wrc_config without_profiles = config;
  EXPECT_EQ(wrc_config_check(&config, nullptr, 0), WRC_OK);
  const struct {
    double* member;
    double value;
    const char* words;
  } placed[] = {{&config.wheelset.tape_circle_distance, 0.4, "config.wheelset.tape_circle_distance = 0.4 m"},
                {&config.track.gauge, 0.4, "config.track.gauge = 0.4 m"},
                {&config.track.gauge_depth, 0.02, "config.track.gauge_depth = 0.02 m"},
                {&config.track.rail_inclination, 0.02, "config.track.rail_inclination = 0.02"}};
  for (const auto& each : placed) {
    config = without_profiles;
    *each.member = each.value;
    expect_config_refused(WRC_ERROR_UNSUPPORTED, {each.words, "no profiles"});
  }
  config = without_profiles;
  config.track.placement = WRC_PLACEMENT_ORIGIN;
  config.track.rail_origin = 0.76;
  expect_config_refused(WRC_ERROR_UNSUPPORTED, {"config.track.placement", "no profiles"});
}

/// The cap is the one of whichever method solves, and its flag names it.
TEST_F(Interface, TheIterationCapIsHonoured) {
  const auto flagged = [&](int32_t& option, const std::string& name, int32_t cap) {
    option = cap;
    create();
    int count = 0;
    for (double lateral = 5.0e-3; lateral < 7.05e-3; lateral += 0.1e-3) {
      pose.lateral = lateral;
      const int32_t status = step();
      EXPECT_GE(status, 0) << error();
      if (status != WRC_FLAG_ITERATION_CAP) continue;
      ++count;
      expect_words(error(), {name + " = " + std::to_string(cap)});
    }
    return count;
  };
  const struct {
    int32_t method;
    int32_t *option, *other;
    const char *name, *other_name;
  } each[] = {{WRC_NORMAL_STRIP_HALFSPACE, &config.planar.max_sweeps, &config.normal.max_iterations,
               "config.planar.max_sweeps", "config.normal.max_iterations"},
              {WRC_NORMAL_EKP, &config.normal.max_iterations, &config.planar.max_sweeps,
               "config.normal.max_iterations", "config.planar.max_sweeps"}};
  for (const auto& [method, option, other, name, other_name] : each) {
    config.normal = test_config().normal;
    config.normal.method = method;
    if (method == WRC_NORMAL_EKP) config.normal.load_tolerance = 1e-14;
    const int32_t usual = *option;
    EXPECT_GT(flagged(*option, name, 4), 0) << method;
    EXPECT_EQ(flagged(*option, name, usual), 0) << method;
    EXPECT_EQ(flagged(*option, name, 1000), 0) << method;
    for (int32_t bad : {-1, 0, 1, 3, 1001}) {
      *option = bad;
      expect_config_refused(WRC_ERROR_RANGE, {name, "4 .. 1000"});
    }
    *option = usual;
    ++*other;
    expect_config_refused(WRC_ERROR_UNSUPPORTED, {other_name, "only WRC_NORMAL_"});
  }
}

TEST_F(Interface, NullIsSafeEverywhere) {
  EXPECT_EQ(wrc_config_init(nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_config_check(nullptr, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_model_size(&config, nullptr, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_model_create(&config, nullptr, nullptr, nullptr, 0), WRC_ERROR_NULL);
  wrc_model* none = nullptr;
  EXPECT_EQ(wrc_model_create(nullptr, nullptr, &none, nullptr, 0), WRC_ERROR_NULL);
  wrc_contact* no_contact = nullptr;
  EXPECT_EQ(wrc_contact_create(nullptr, WRC_SIDE_RIGHT, nullptr, &no_contact, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_geometry(nullptr, &pose, &point), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_geometry(contact, nullptr, &point), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_geometry(contact, &pose, nullptr), WRC_OK);
  EXPECT_EQ(wrc_planar_normal(nullptr, nullptr, &load, &normal), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_normal(contact, nullptr, nullptr, &normal), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_normal(contact, nullptr, &load, nullptr), WRC_OK);
  EXPECT_EQ(wrc_planar_tangential(contact, nullptr, nullptr, &friction, &forces), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_tangential(contact, nullptr, &creepage, nullptr, &forces), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_tangential(contact, nullptr, &creepage, &friction, nullptr), WRC_OK);
  EXPECT_EQ(wrc_contact_damage(contact, WRC_ALL_REGIONS, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_wear(contact, WRC_ALL_REGIONS, nullptr, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_region(contact, 0, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_step(contact, nullptr, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_field(contact, 0, WRC_FIELD_X, nullptr, 0, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_last_error(contact, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_last_error(nullptr, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_save(contact, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_restore(nullptr, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_linear_coefficients(1.0, 0.0, 0.25, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_shakedown_limit(0.3, nullptr), WRC_ERROR_NULL);
  wrc_model_destroy(nullptr);
  wrc_contact_destroy(nullptr);
}

/// No contact, or something else in its place: refused like any bad input, and no old number is left.
TEST_F(Interface, WithoutAContactOutputsAreZero) {
  alignas(64) unsigned char foreign[256] = {};
  for (wrc_contact* wrong : {static_cast<wrc_contact*>(nullptr), reinterpret_cast<wrc_contact*>(foreign)}) {
    const auto refill = [&] {
      expect_works();
      ASSERT_NE(forces.fn, 0.0);
    };
    refill();
    std::swap(contact, wrong);
    EXPECT_EQ(step(), WRC_ERROR_NULL);
    expect_zeros();
    std::swap(contact, wrong);

    refill();
    EXPECT_EQ(wrc_planar_geometry(wrong, &pose, &point), WRC_ERROR_NULL);
    EXPECT_EQ(wrc_planar_normal(wrong, nullptr, &load, &normal), WRC_ERROR_NULL);
    EXPECT_EQ(wrc_planar_tangential(wrong, nullptr, &creepage, &friction, &forces), WRC_ERROR_NULL);
    EXPECT_EQ(wrc_contact_damage(wrong, WRC_ALL_REGIONS, &damage), WRC_ERROR_NULL);
    expect_zeros();

    refill();
    EXPECT_EQ(wrc_planar_regularise(wrong, nullptr, &normal), WRC_ERROR_NULL);
    EXPECT_EQ(normal.area, 0.0);
    refill();
    wrc_region one = sized<wrc_region>();
    ASSERT_EQ(wrc_contact_region(contact, 0, &one), WRC_OK);
    EXPECT_EQ(wrc_contact_region(wrong, 0, &one), WRC_ERROR_NULL);
    EXPECT_EQ(one.area, 0.0);
    EXPECT_EQ(one.normal_force, 0.0);

    wrc_wear wear{};
    wear.worn_area_rate = 1.0;
    EXPECT_EQ(wrc_contact_wear(wrong, WRC_ALL_REGIONS, nullptr, &wear), WRC_ERROR_NULL);
    EXPECT_EQ(wear.worn_area_rate, 0.0);
    wrc_creepage result = creepage;
    EXPECT_EQ(wrc_planar_creepages(wrong, nullptr, &result), WRC_ERROR_NULL);
    EXPECT_EQ(result.spin, 0.0);
    uint64_t counts[2] = {7, 7};
    EXPECT_EQ(wrc_contact_field(wrong, 0, WRC_FIELD_PRESSURE, nullptr, 0, counts), WRC_ERROR_NULL);
    EXPECT_EQ(counts[0], 0U);
    EXPECT_EQ(counts[1], 0U);
  }
}

TEST_F(Interface, WrongStructSizeIsRefusedForInputsAndOutputs) {
  for (const uint32_t bad : {0U, 7U, 4096U}) {  // 4096: more than any header has
    input.struct_size = bad;
    expect_refused(WRC_ERROR_STRUCT_SIZE, {"wrc_planar_input", "struct_size"});
    input.struct_size = sizeof input;
    expect_works();
    output.struct_size = bad;
    EXPECT_EQ(step(), WRC_ERROR_STRUCT_SIZE);
    expect_words(error(), {"wrc_planar_output", "struct_size"});
    EXPECT_NE(forces.fn, 0.0);  // not touched
    output.struct_size = sizeof output;
  }
  wrc_region patch = sized<wrc_region>();
  patch.struct_size -= 8;
  EXPECT_EQ(wrc_contact_region(contact, 0, &patch), WRC_ERROR_STRUCT_SIZE);
  expect_works();
}

TEST_F(Interface, DefaultsHaveTheSizeTheyWereCompiledWith) {
  EXPECT_EQ(wrc_config_default().struct_size, sizeof(wrc_config));
  EXPECT_EQ(wrc_planar_input_default().struct_size, sizeof(wrc_planar_input));
  EXPECT_EQ(sized<wrc_planar_output>().struct_size, sizeof(wrc_planar_output));
  EXPECT_EQ(wrc_friction_default().slope_reduction, 1.0);
  EXPECT_EQ(wrc_planar_input_default().friction.slope_reduction, 1.0);  // those of structs within, too
  EXPECT_EQ(wrc_config_default().track.gauge, 1.435);
  EXPECT_EQ(wrc_config_default().rail_material.shear_modulus, 82e9);
  EXPECT_EQ(wrc_config_default().rail_material.poisson, 0.28);
  wrc_config config_of_run_time;
  config_of_run_time.struct_size = sizeof config_of_run_time;
  EXPECT_EQ(wrc_config_init(&config_of_run_time), WRC_OK);
  const wrc_config by_value = wrc_config_default();
  EXPECT_EQ(std::memcmp(&config_of_run_time, &by_value, sizeof by_value), 0);
}

/// The joint of a patch lies in the plane of contact, and its normal into the rail.
TEST_F(Interface, PatchesHaveTheirPlaceAfterAPose) {
  pose.lateral = -5e-3;
  expect_works();
  wrc_region patch = sized<wrc_region>();
  ASSERT_EQ(wrc_contact_region(contact, 0, &patch), WRC_OK);
  EXPECT_EQ(patch.available, static_cast<uint32_t>(WRC_AVAILABLE_PLACE | WRC_AVAILABLE_TRACTIONS));
  EXPECT_EQ(patch.ellipse.psi, normal.ellipse.psi);
  EXPECT_EQ(patch.longitudinal_force, forces.fx);
  EXPECT_NEAR(patch.point[1], point.y + std::cos(point.angle) * patch.ellipse.y, 1e-12);
  EXPECT_NEAR(patch.point[2], point.z + std::sin(point.angle) * patch.ellipse.y, 1e-12);
  EXPECT_NEAR(patch.normal[1], -std::sin(point.angle), 1e-12);
  EXPECT_NEAR(patch.normal[2], std::cos(point.angle), 1e-12);

  wrc_ellipse own = sized<wrc_ellipse>();
  own.a = own.b = 5e-3;
  own.normal_force = 80e3;
  ASSERT_EQ(wrc_planar_tangential(contact, &own, &creepage, &friction, &forces), WRC_OK) << error();
  ASSERT_EQ(wrc_contact_region(contact, 0, &patch), WRC_OK);
  EXPECT_EQ(patch.available & WRC_AVAILABLE_PLACE, 0U);
  EXPECT_EQ(patch.normal[2], 0.0);
}

// --------------------------------------------------------------------------------------------- host's
// environment

#if defined(_WIN32)
// What glibc has, for the vector unit's control register: exception k traps while bit 7 + k is 0.
int fegetexcept() { return static_cast<int>(~_mm_getcsr() >> 7) & FE_ALL_EXCEPT; }
void feenableexcept(int which) { _mm_setcsr(_mm_getcsr() & ~(static_cast<unsigned>(which) << 7)); }
void fedisableexcept(int which) { _mm_setcsr(_mm_getcsr() | static_cast<unsigned>(which) << 7); }

TEST_F(Interface, HostKeepsItsOtherFloatingPointUnitToo) {
  wrc_exact_check_options options = wrc_exact_check_options_default();
  options.nx = options.ny = 32;
  wrc_exact_check_result plain = sized<wrc_exact_check_result>(), found = plain;
  expect_works();
  ASSERT_EQ(wrc_exact_check(contact, &options, &plain), WRC_OK);
  const unsigned short usual = 0x037f,
                       mean = 0x0c70;  // 24 bits, towards zero, traps but for denormals and inexact
  unsigned short after = 0;
  __asm__ volatile("fldcw %0" : : "m"(mean));
  const int32_t status = wrc_exact_check(contact, &options, &found);
  __asm__ volatile("fnstcw %0\n\tfnclex\n\tfldcw %1" : "=m"(after) : "m"(usual));
  EXPECT_EQ(status, WRC_OK);
  EXPECT_EQ(after, mean);
  EXPECT_EQ(std::memcmp(&plain, &found, sizeof found), 0);
}
#endif

TEST_F(Interface, HostKeepsItsFloatingPointEnvironmentAndItsTrapsStayQuiet) {
  expect_works();
  const wrc_planar_forces plain = forces;
  std::fesetround(FE_UPWARD);
  feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW);
  EXPECT_EQ(step(), WRC_OK);
  creepage.spin = 0.0;
  creepage.longitudinal = 0.0;
  creepage.lateral = 0.0;
  EXPECT_EQ(step(), WRC_OK);  // nothing slips: every 0/0 that could be is here
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  EXPECT_EQ(fegetexcept(), FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW);
  fedisableexcept(FE_ALL_EXCEPT);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(forces.fx, 0.0);
  creepage.longitudinal = -0.49e-3;
  creepage.lateral = -0.22e-3;
  creepage.spin = 0.29;
  EXPECT_EQ(step(), WRC_OK);
  EXPECT_EQ(std::memcmp(&plain, &forces, sizeof forces), 0);
}

// ------------------------------------------------------------------------------------------------------------
// table

TEST(FunctionTable, ServesThisInterfaceVersionOnly) {
  const wrc_api* api = wrc_get_api(WRC_ABI_VERSION);
  ASSERT_NE(api, nullptr);
  EXPECT_EQ(api->struct_size, sizeof(wrc_api));
  EXPECT_EQ(api->abi_version, static_cast<uint32_t>(WRC_ABI_VERSION));
  EXPECT_EQ(api->version(), wrc_version());
  EXPECT_EQ(api->planar_step, wrc_planar_step);
  EXPECT_EQ(api->contact_damage, wrc_contact_damage);
  const wrc_experimental_api* later = wrc_get_experimental_api(WRC_EXPERIMENTAL_VERSION);
  ASSERT_NE(later, nullptr);
  EXPECT_EQ(later->struct_size, sizeof(wrc_experimental_api));
  EXPECT_EQ(later->shakedown_limit, wrc_shakedown_limit);
  EXPECT_EQ(wrc_get_experimental_api(WRC_EXPERIMENTAL_VERSION + 1), nullptr);
  EXPECT_EQ(wrc_get_api(WRC_ABI_VERSION + 1), nullptr);
  EXPECT_EQ(wrc_get_api(1), nullptr);
  const auto says = [](uint32_t requested, const char* words) {
    return std::string(wrc_version_text(requested)).find(words) != std::string::npos;
  };
  EXPECT_TRUE(says(WRC_ABI_VERSION, "the one asked for"));
  EXPECT_TRUE(says(1, "compile the program with the headers of this library"));
  EXPECT_TRUE(says(WRC_ABI_VERSION + 1, "a newer one was asked for"));
  EXPECT_EQ(std::string(wrc_build_info()).rfind("wrc " + std::to_string(WRC_VERSION_MAJOR), 0), 0U);
  // every pointer is filled in
  const char* bytes = reinterpret_cast<const char*>(api);
  for (std::size_t at = offsetof(wrc_api, version); at < sizeof(wrc_api); at += sizeof(void*)) {
    void* entry = nullptr;
    std::memcpy(&entry, bytes + at, sizeof entry);
    EXPECT_NE(entry, nullptr) << "offset " << at;
  }
}

TEST(Statuses, HaveNamesAndTexts) {
  int32_t least = 0, most = 0;
#define WRC_TEST(name, value, text)           \
  EXPECT_EQ(name, value);                     \
  EXPECT_STREQ(wrc_status_name(name), #name); \
  EXPECT_STREQ(wrc_status_text(name), text);  \
  EXPECT_GT(std::strlen(text), 3U) << #name;  \
  least = std::min<int32_t>(least, name);     \
  most = std::max<int32_t>(most, name);
  WRC_STATUS_LIST(WRC_TEST)
#undef WRC_TEST
  EXPECT_STREQ(wrc_status_name(least - 1), "unknown status");
  EXPECT_STREQ(wrc_status_name(most + 1), "unknown status");
  EXPECT_STREQ(wrc_status_name(-4711), "unknown status");
}

TEST(LinearCoefficients, AreKalkersForTheCircle) {
  wrc_coefficients c{};
  ASSERT_EQ(wrc_linear_coefficients(1.0, 0.0, 0.25, &c), WRC_OK);
  EXPECT_NEAR(c.c11, 4.1128, 1e-4);  // printed as 4.12, 3.67, 1.47
  EXPECT_NEAR(c.c22, 3.6683, 1e-4);
  EXPECT_NEAR(c.c23, 1.4661, 1e-4);
  EXPECT_EQ(c.c13s, 0.0);
  EXPECT_EQ(wrc_linear_coefficients(-1.0, 0.0, 0.25, &c), WRC_ERROR_RANGE);
  EXPECT_EQ(c.c11, 0.0);
  EXPECT_EQ(wrc_linear_coefficients(1.0, nan_value, 0.25, &c), WRC_ERROR_NOT_FINITE);
}

}  // namespace
