/// Damage along the line: what bins hold adds up to what the step has, in any order with the same bits,
/// without a jump at a bin's border, and lies where the contact is.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "not_finite.hpp"
#include "test_config.hpp"
#include "wrc/wrc_damage.h"
#include "wrc/wrc_planar.h"

namespace {

/// Bins over a profile, and rows.
struct Bins {
  std::vector<wrc_damage_bin> bin;
  wrc_damage_bins bins = wrc_damage_bins_default();

  explicit Bins(double width = 1e-3, uint32_t rows = 1, double row_length = 0.0) {
    bins.first = -0.080;
    bins.width = width;
    bins.count = static_cast<uint32_t>(0.160 / width + 0.5);
    bins.row_count = rows;
    bins.row_length = row_length;
    bin.resize(bins.count * rows + 1);
    std::memset(bin.data(), 0, bin.size() * sizeof bin[0]);
    bins.bins = bin.data();
    bins.bin_size = sizeof bin[0];
  }
  std::vector<double> values(int32_t quantity) const {
    std::vector<double> all(bin.size());
    EXPECT_EQ(wrc_damage_values(&bins, quantity, all.data()), WRC_OK);
    return all;
  }
  double total(int32_t quantity) const {
    double sum = 0.0;
    for (const double value : values(quantity)) sum += value;
    return sum;
  }
  /// Arc length of the middle of a quantity.
  double middle(int32_t quantity) const {
    const auto all = values(quantity);
    double sum = 0.0, moment = 0.0;
    for (std::size_t k = 0; k < bins.count; ++k) {
      sum += all[k];
      moment += all[k] * (bins.first + bins.width * (static_cast<double>(k) + 0.5));
    }
    return moment / sum;
  }
  bool same(const Bins& other) const {
    return bin.size() == other.bin.size() &&
           std::memcmp(bin.data(), other.bin.data(), bin.size() * sizeof bin[0]) == 0;
  }
};

class Line : public testing::Test {
 protected:
  void SetUp() override {
    wrc_config config = test_config();
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_60E1;
    config.track.rail_inclination = 1.0 / 40.0;

    ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    for (int32_t side = 0; side < 2; ++side)
      ASSERT_EQ(wrc_contact_create(model, side, nullptr, &contact[side], nullptr, 0), WRC_OK);
  }
  void TearDown() override {
    for (wrc_contact* each : contact) wrc_contact_destroy(each);
    wrc_model_destroy(model);
  }

  wrc_wheel_input wheel_at(double y, double sign = 1.0) const {
    wrc_wheel_input input = wrc_wheel_input_default();
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 90e3;
    input.wheel.y = sign * y;
    input.wheel.yaw = sign * 4e-3;
    input.wheel.velocity[0] = 20.0;
    input.wheel.pitch_rate = -20.0 / 0.4605;
    return input;
  }
  wrc_wrench solve(double y, int32_t side = 0) const {
    const wrc_wheel_input input = wheel_at(y, side == 0 ? 1.0 : -1.0);
    wrc_wrench wrench = sized<wrc_wrench>();
    EXPECT_GE(wrc_contact_wrench(contact[side], &input, &wrench), WRC_OK);
    return wrench;
  }
  wrc_planar_output step(double y, int32_t side = 0) const {
    const double sign = side == 0 ? 1.0 : -1.0;
    wrc_planar_input input = wrc_planar_input_default();
    input.pose.lateral = sign * y;
    input.load.normal_force = 90e3;
    input.creepage.longitudinal = 2e-3;
    input.creepage.lateral = sign * 4e-3;
    input.creepage.spin = sign * 0.1;
    input.creepage.speed = 20.0;
    wrc_planar_output output = sized<wrc_planar_output>();
    EXPECT_GE(wrc_planar_step(contact[side], &input, &output), WRC_OK);
    return output;
  }
  wrc_accumulation accumulation() const {
    wrc_accumulation a = sized<wrc_accumulation>();
    a.duration = 1e-3;
    return a;
  }
  wrc_damage_totals add(Bins* wheel, Bins* rail, int32_t side = 0) const {
    const wrc_accumulation a = accumulation();
    wrc_damage_totals totals{};
    EXPECT_EQ(wrc_contact_accumulate(contact[side], &a, wheel ? &wheel->bins : nullptr,
                                     rail ? &rail->bins : nullptr, &totals),
              WRC_OK);
    return totals;
  }

  wrc_model* model = nullptr;
  wrc_contact* contact[2] = {};
};

TEST_F(Line, BinsHoldWhatTheStepHas) {
  double worst = 0.0;
  for (const double y : {0.0, 0.002, 0.0045, 0.0062, 0.0068}) {
    for (const bool of_wheel : {true, false}) {
      const double power = of_wheel ? solve(y).power : step(y).damage.power;
      Bins wheel, rail(0.37e-3, 7, 5e-3);
      const wrc_damage_totals totals = add(&wheel, &rail);
      worst = std::max(worst, std::abs(totals.sum[WRC_DAMAGE_WORK] / (1e-3 * power) - 1.0));
      for (int32_t q = 0; q < WRC_DAMAGE_SUMS; ++q) {
        const double size = std::abs(totals.sum[q]);
        EXPECT_TRUE(q == WRC_DAMAGE_SURFACE_FATIGUE || q == WRC_DAMAGE_WHOLE_LIFE || size > 0.0) << q;
        for (const Bins* bins : {&wheel, &rail})
          worst = std::max(worst, std::abs(bins->total(q) - totals.sum[q]) / std::max(size, 1e-300));
      }
      double pressure = 0.0;
      for (const double each : wheel.values(WRC_DAMAGE_LARGEST_PRESSURE)) pressure = std::max(pressure, each);
      EXPECT_EQ(pressure, totals.largest_pressure);
      EXPECT_GT(totals.largest_traction, 0.0);
      EXPECT_LT(totals.largest_traction, 0.31 * pressure);
    }
  }
  std::printf("  sums over bins, and work, against the step's: %.1e\n", worst);
  EXPECT_LT(worst, 1e-12);
}

TEST_F(Line, AnyOrderGivesTheSameBits) {
  Bins one, first, second;
  constexpr double places[] = {0.001, 0.0055, 0.0066, -0.003};
  for (const double y : places) {
    solve(y);
    add(&one, nullptr);
  }
  for (int i = 3; i >= 0; --i) {
    solve(places[i]);
    add(i % 2 == 0 ? &first : &second, nullptr);
  }
  Bins merged;
  EXPECT_EQ(wrc_damage_merge(&merged.bins, &second.bins), WRC_OK);
  EXPECT_EQ(wrc_damage_merge(&merged.bins, &first.bins), WRC_OK);
  EXPECT_TRUE(merged.same(one));
  EXPECT_FALSE(first.same(one));
  Bins other(2e-3);
  EXPECT_EQ(wrc_damage_merge(&merged.bins, &other.bins), WRC_ERROR_RANGE);
}

/// Bins moved a little under the strips: every bin changes a little, at most by the densest strip's share.
TEST_F(Line, NothingJumpsAtABinsBorder) {
  solve(0.0062);
  Bins before(0.7e-3);
  const double whole = add(nullptr, &before).sum[WRC_DAMAGE_WORK];
  double largest = 0.0;
  auto last = before.values(WRC_DAMAGE_WORK);
  constexpr double shift = 1e-6;
  for (int i = 1; i <= 700; ++i) {  // over a whole bin
    Bins now(0.7e-3);
    now.bins.first += shift * i;
    add(nullptr, &now);
    const auto values = now.values(WRC_DAMAGE_WORK);
    for (std::size_t k = 0; k < values.size(); ++k)
      largest = std::max(largest, std::abs(values[k] - last[k]) / whole);
    last = values;
  }
  std::printf("  bins moved by 1 um change by at most %.1e of the work\n", largest);
  EXPECT_LT(largest, shift / 1e-3);  // the work lies on some millimetres
}

TEST_F(Line, LiesWhereTheContactIs) {
  for (const double y : {0.0, 0.003, -0.004, 0.0066}) {
    const wrc_wrench wrench = solve(y);
    wrc_region region = sized<wrc_region>();
    double y_wheel = 0.0, y_rail = 0.0, load = 0.0;
    for (int32_t i = 0; i < wrench.region_count; ++i) {
      ASSERT_EQ(wrc_contact_region(contact[0], i, &region), WRC_OK);
      y_wheel += region.normal_force * region.y_wheel;
      y_rail += region.normal_force * region.y_rail;
      load += region.normal_force;
    }
    if (wrench.region_count > 1) continue;
    Bins wheel(0.25e-3), rail(0.25e-3);
    add(&wheel, &rail);
    double at = wheel.middle(WRC_DAMAGE_TIME), place = 0.0;
    ASSERT_EQ(wrc_model_arc_places(model, WRC_BODY_WHEEL, 1, &at, &place, nullptr), WRC_OK);
    EXPECT_NEAR(place, y_wheel / load, y > 0.006 ? 2e-3 : 1e-3) << y;  // by time, not by load
    at = rail.middle(WRC_DAMAGE_TIME);
    ASSERT_EQ(wrc_model_arc_places(model, WRC_BODY_RAIL, 1, &at, &place, nullptr), WRC_OK);
    EXPECT_NEAR(place, y_rail / load, y > 0.006 ? 2e-3 : 1e-3) << y;
    // the stages' contact point, half the contact away at most
    const wrc_planar_output output = step(y);
    Bins of_stages(0.25e-3);
    add(&of_stages, nullptr);
    at = of_stages.middle(WRC_DAMAGE_TIME);
    ASSERT_EQ(wrc_model_arc_places(model, WRC_BODY_WHEEL, 1, &at, &place, nullptr), WRC_OK);
    EXPECT_NEAR(place, output.point.y_wheel, 0.5 * output.normal.width) << y;
  }
}

TEST_F(Line, LeftIsTheMirrorImage) {
  for (const bool of_wheel : {true, false}) {
    Bins wheel[2], rail[2];
    for (int32_t side = 0; side < 2; ++side) {
      of_wheel ? (void)solve(0.0063, side) : (void)step(0.0063, side);
      add(&wheel[side], &rail[side], side);
    }
    for (int32_t q : {0, 1, 2, 3, 4, 5, 6, 7, int32_t{WRC_DAMAGE_LARGEST_PRESSURE},
                      int32_t{WRC_DAMAGE_LARGEST_TRACTION}}) {
      const auto right = wheel[0].values(q), left = wheel[1].values(q);
      const auto on_right = rail[0].values(q), on_left = rail[1].values(q);
      const double size = std::abs(wheel[0].total(q)) + 1e-300;
      for (std::size_t k = 0; k < right.size(); ++k) {
        EXPECT_NEAR(right[k] / size, left[k] / size, 1e-6) << of_wheel << q << k;
        EXPECT_NEAR(on_right[k] / size, on_left[k] / size, 1e-6) << of_wheel << q << k;
      }
    }
  }
}

TEST_F(Line, RowsShareTheDistance) {
  solve(0.004);
  Bins whole, rows(1e-3, 10, 0.004);
  wrc_accumulation a = accumulation();
  a.distance = 0.010;  // to 0.030, but for creep: rows 2 to 7
  ASSERT_EQ(wrc_contact_accumulate(contact[0], &a, nullptr, &rows.bins, nullptr), WRC_OK);
  ASSERT_EQ(wrc_contact_accumulate(contact[0], &a, nullptr, &whole.bins, nullptr), WRC_OK);
  const auto values = rows.values(WRC_DAMAGE_WORK);
  std::vector<double> row(10);
  for (std::size_t k = 0; k + 1 < values.size(); ++k) row[k / rows.bins.count] += values[k];
  const double work = whole.total(WRC_DAMAGE_WORK);
  const double expected[] = {0, 0, 0.1, 0.2, 0.2, 0.2, 0.2, 0.1, 0, 0};
  for (std::size_t r = 0; r < 10; ++r) EXPECT_NEAR(row[r] / work, expected[r], 2e-3) << r;
}

/// Stages called one by one, with damage asked for or not, add what the step adds.
TEST_F(Line, StagesOneByOneAddWhatTheStepAdds) {
  step(0.0);
  Bins at_once;
  add(&at_once, nullptr);
  const wrc_planar_pose pose = sized<wrc_planar_pose>();
  wrc_planar_load load = wrc_planar_load_default();
  load.normal_force = 90e3;
  wrc_creepage creepage = wrc_creepage_default();
  creepage.longitudinal = 2e-3;
  creepage.lateral = 4e-3;
  creepage.spin = 0.1;
  creepage.speed = 20.0;
  const wrc_friction friction = wrc_friction_default();
  for (const bool asked : {false, true}) {
    ASSERT_EQ(wrc_planar_geometry(contact[0], &pose, nullptr), WRC_OK);
    ASSERT_GE(wrc_planar_normal(contact[0], nullptr, &load, nullptr), WRC_OK);
    ASSERT_GE(wrc_planar_tangential(contact[0], nullptr, &creepage, &friction, nullptr), WRC_OK);
    wrc_damage damage = sized<wrc_damage>();
    if (asked) {
      ASSERT_EQ(wrc_contact_damage(contact[0], WRC_ALL_REGIONS, &damage), WRC_OK);
    }
    Bins one_by_one;
    add(&one_by_one, nullptr);
    for (int32_t sum = 0; sum < WRC_DAMAGE_SUMS; ++sum)
      EXPECT_EQ(one_by_one.values(sum), at_once.values(sum)) << asked << ' ' << sum;
    EXPECT_GT(one_by_one.total(WRC_DAMAGE_WORK), 0.0);
  }
}

TEST_F(Line, RefusesWhatItCannotUse) {
  Bins wheel;
  wrc_accumulation a = accumulation();
  EXPECT_EQ(wrc_contact_accumulate(contact[0], &a, &wheel.bins, nullptr, nullptr), WRC_ERROR_SEQUENCE);
  solve(0.0);
  EXPECT_EQ(wrc_contact_accumulate(contact[0], nullptr, &wheel.bins, nullptr, nullptr), WRC_ERROR_NULL);
  a.duration = -1.0;
  EXPECT_EQ(wrc_contact_accumulate(contact[0], &a, &wheel.bins, nullptr, nullptr), WRC_ERROR_RANGE);
  a.duration = 1.0;
  Bins bad;
  bad.bins.bins = nullptr;
  EXPECT_EQ(wrc_contact_accumulate(contact[0], &a, &wheel.bins, &bad.bins, nullptr), WRC_ERROR_NULL);
  bad = Bins();
  bad.bins.bin_size = 0;
  EXPECT_EQ(wrc_contact_accumulate(contact[0], &a, &wheel.bins, &bad.bins, nullptr), WRC_ERROR_RANGE);
  bad.bins.bin_size = 8;
  EXPECT_EQ(wrc_contact_accumulate(contact[0], &a, &wheel.bins, &bad.bins, nullptr), WRC_ERROR_RANGE);
  bad = Bins();
  bad.bins.row_count = 2;
  EXPECT_EQ(wrc_contact_accumulate(contact[0], &a, &wheel.bins, &bad.bins, nullptr), WRC_ERROR_RANGE);
  wrc_fatigue_laws laws = wrc_fatigue_laws_default();
  laws.whole_life_end = laws.whole_life_peak_at;
  a.fatigue = &laws;
  EXPECT_EQ(wrc_contact_accumulate(contact[0], &a, &wheel.bins, nullptr, nullptr), WRC_ERROR_RANGE);
  EXPECT_TRUE(wheel.same(Bins()));
  std::vector<double> values(wheel.bin.size());
  EXPECT_EQ(wrc_damage_values(&wheel.bins, 10, values.data()), WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(wrc_damage_values(&wheel.bins, 0, nullptr), WRC_ERROR_NULL);
}

TEST_F(Line, SavedStatesAccumulateTheSame) {
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  std::vector<char> state(bytes);
  solve(0.0061);
  ASSERT_EQ(wrc_contact_save(contact[0], state.data(), bytes), WRC_OK);
  Bins before, after;
  add(&before, nullptr);
  solve(0.001);
  ASSERT_EQ(wrc_contact_restore(contact[0], state.data(), bytes), WRC_OK);
  add(&after, nullptr);
  EXPECT_TRUE(before.same(after));
}

TEST(Laws, WholeLifeAndPointShakedown) {
  const double t[] = {0.0, 15.0, 40.0, 65.0, 120.0, 175.0, 285.0};
  const double expected[] = {0.0, 0.0, 5e-6, 1e-5, 5e-6, 0.0, -1e-5};
  for (int i = 0; i < 7; ++i) {
    double damage = 1.0;
    EXPECT_EQ(wrc_whole_life_damage(nullptr, t[i], &damage), WRC_OK);
    EXPECT_NEAR(damage, expected[i], 1e-18) << t[i];
  }
  // tools/calibration/shakedown_point.py
  const double mu[] = {0.0, 0.05, 0.10, 0.15, 0.20}, limit[] = {4.676, 4.671, 4.654, 4.626, 4.586};
  for (int i = 0; i < 5; ++i) {
    double found = 0.0, line = 0.0;
    EXPECT_EQ(wrc_shakedown_limit_point(mu[i], &found), WRC_OK);
    EXPECT_EQ(wrc_shakedown_limit(mu[i], &line), WRC_OK);
    EXPECT_NEAR(found, limit[i], 2e-3 * limit[i]);
    EXPECT_GT(found, line);
  }
  for (const double high : {0.25, 0.5, 2.0}) {
    double found = 0.0;
    EXPECT_EQ(wrc_shakedown_limit_point(high, &found), WRC_OK);
    EXPECT_EQ(found, 1.0 / high);
  }
}

TEST(Profiles, ArcLengthsAreDistancesAlongTheCurve) {
  wrc_config config = test_config();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  wrc_model* model = nullptr;
  ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
  for (const int32_t body : {WRC_BODY_WHEEL, WRC_BODY_RAIL}) {
    constexpr int count = 3001;
    std::vector<double> arc(count), y(count), z(count);
    for (int i = 0; i < count; ++i) arc[i] = -0.030 + 0.02e-3 * i;
    ASSERT_EQ(wrc_model_arc_places(model, body, count, arc.data(), y.data(), z.data()), WRC_OK);
    EXPECT_NEAR(y[1500], 0.0, 1e-9);
    for (int i = 1; i < count; ++i) EXPECT_NEAR(std::hypot(y[i] - y[i - 1], z[i] - z[i - 1]), 0.02e-3, 2e-10);
  }
  wrc_model_destroy(model);
}

}  // namespace
