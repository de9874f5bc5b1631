/// Films on rail and wheel: books that balance, friction without a jump, the published law of recovery,
/// wheels in order of passage, threads and saved bins to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "not_finite.hpp"
#include "test_config.hpp"
#include "wrc/wrc_surface.h"

namespace {

constexpr double turn = 2.89;  // circumference of a wheel [m]

struct Band {
  std::vector<wrc_surface_bin> bin;
  wrc_surface surface = wrc_surface_default();

  Band(uint32_t count, double length, uint32_t closed = 0, uint32_t rows = 1) : bin(count * rows) {
    std::memset(bin.data(), 0, bin.size() * sizeof bin[0]);
    surface.rows = rows;
    surface.count = count;
    surface.length = length;
    surface.closed = closed;
    surface.bins = bin.data();
    surface.bin_size = sizeof bin[0];
  }
  Band(const Band& other) : bin(other.bin), surface(other.surface) { surface.bins = bin.data(); }
  Band& operator=(const Band& other) {
    bin = other.bin;
    surface = other.surface;
    surface.bins = bin.data();
    return *this;
  }
  ~Band() = default;

  double total(int32_t quantity, int32_t book = WRC_SURFACE_AMOUNT) const {
    double sum = -1.0;
    EXPECT_EQ(wrc_surface_values(&surface, quantity, book, nullptr, &sum, nullptr, 0), WRC_OK);
    return sum;
  }
  std::vector<double> values(int32_t quantity, int32_t book = WRC_SURFACE_AMOUNT) const {
    std::vector<double> all(bin.size());
    EXPECT_EQ(wrc_surface_values(&surface, quantity, book, all.data(), nullptr, nullptr, 0), WRC_OK);
    return all;
  }
  void add(int32_t quantity, double amount, double from, double to) {
    EXPECT_EQ(wrc_surface_add(&surface, quantity, amount, from, to, nullptr, 0), WRC_OK);
  }
  bool same(const Band& other) const {
    return bin.size() == other.bin.size() &&
           std::memcmp(bin.data(), other.bin.data(), bin.size() * sizeof bin[0]) == 0;
  }
};

Band rail_of(uint32_t count = 100, double length = 1.0) { return {count, length}; }
Band wheel_of(uint32_t count = 24) { return {count, turn / count, 1}; }

wrc_surface_laws laws_of(const char* name = "low adhesion") {
  wrc_surface_laws laws = wrc_surface_laws_default();
  EXPECT_EQ(wrc_surface_laws_use(&laws, name, nullptr, 0), WRC_OK);
  return laws;
}

wrc_surface_passage passage_of(double from, double to, double wheel_from, double wheel_to, double energy) {
  auto passage = sized<wrc_surface_passage>();
  passage.rail_from = from;
  passage.rail_to = to;
  passage.wheel_from = wheel_from;
  passage.wheel_to = wheel_to;
  passage.energy = energy;
  return passage;
}

wrc_surface_exchange go(Band& rail, Band* wheel, const wrc_surface_laws& laws,
                        const wrc_surface_passage& passage, int32_t status = WRC_OK) {
  auto exchange = sized<wrc_surface_exchange>();
  EXPECT_EQ(wrc_surface_pass(&rail.surface, wheel ? &wheel->surface : nullptr, &laws, &passage, &exchange,
                             nullptr, 0),
            status);
  return exchange;
}

wrc_friction friction_at(const Band& rail, const Band* wheel, const wrc_surface_laws& laws, double place,
                         double round = 0.0, const wrc_friction* base = nullptr, int32_t status = WRC_OK) {
  const wrc_surface_passage passage = passage_of(place, place, round, round, 0.0);
  wrc_friction friction{};
  EXPECT_EQ(wrc_surface_friction(&rail.surface, wheel ? &wheel->surface : nullptr, &laws, &passage, base,
                                 &friction, nullptr, 0),
            status);
  return friction;
}

/// Amount = put on - removed - squeezed - evaporated - carried, in every bin, as whole numbers.
void expect_balanced(const Band& band) {
  const auto minus = [](const uint64_t* a, const uint64_t* b, uint64_t* c) {
    c[0] = a[0] - b[0];
    c[1] = a[1] - b[1] - (a[0] < b[0] ? 1U : 0U);
  };
  for (const wrc_surface_bin& bin : band.bin)
    for (int q = 0; q < WRC_SURFACE_QUANTITIES; ++q) {
      uint64_t rest[2] = {bin.sum[8 * WRC_SURFACE_PUT_ON + q][0], bin.sum[8 * WRC_SURFACE_PUT_ON + q][1]};
      for (int book = WRC_SURFACE_REMOVED; book < WRC_SURFACE_BOOKS; ++book) {
        const uint64_t before[2] = {rest[0], rest[1]};
        minus(before, bin.sum[8 * book + q], rest);
      }
      ASSERT_EQ(bin.sum[q][0], rest[0]) << q;
      ASSERT_EQ(bin.sum[q][1], rest[1]) << q;
      ASSERT_EQ(bin.overflow, 0U);
    }
}

/// A rail with a bit of everything, and a wheel that has rolled over it.
struct Journey {
  Band rail = rail_of(), wheel = wheel_of();
  wrc_surface_laws laws = laws_of("low adhesion, layers");
  double energy = 0.0, beside = 0.0, at = 5.0, round = 0.3;

  Journey() {
    rail.add(WRC_SURFACE_FILM, 0.008, 10.0, 60.0);
    rail.add(WRC_SURFACE_WATER, 0.02, 0.0, 100.0);
    rail.add(WRC_SURFACE_OXIDE, 0.002, 20.0, 90.5);
    rail.add(WRC_SURFACE_SAND, 0.05, 40.0, 43.3);
    rail.add(WRC_SURFACE_LUBRICANT, 0.004, 30.0, 32.0);
  }
  void step(double way, double slip, double power, double duration = 1e-3) {
    const wrc_surface_passage passage = passage_of(at, at + way, round, round + way * (1.0 - slip), power);
    const wrc_surface_exchange exchange = go(rail, &wheel, laws, passage);
    energy += power;
    beside += exchange.beside_energy;
    at += way;
    round += way * (1.0 - slip);
    EXPECT_EQ(wrc_surface_rest(&wheel.surface, &laws, duration, nullptr, 0), WRC_OK);
  }
};

TEST(SurfaceFilm, BooksBalanceToTheBit) {
  Journey run;
  for (int k = 0; k < 1000; ++k) run.step(0.08, 0.2, 100.0 + k);
  EXPECT_EQ(wrc_surface_rest(&run.rail.surface, &run.laws, 30.0, nullptr, 0), WRC_OK);
  expect_balanced(run.rail);
  expect_balanced(run.wheel);
  const auto both = [&](int32_t quantity, int32_t book) {
    return run.rail.total(quantity, book) + run.wheel.total(quantity, book);
  };
  // all frictional energy is booked
  EXPECT_NEAR(both(WRC_SURFACE_HEAT, WRC_SURFACE_PUT_ON), run.energy, 1e-12 * run.energy);
  EXPECT_EQ(run.beside, 0.0);
  // evaporation takes its heat; that of wrc_surface_rest() is the air's
  const double by_friction = both(WRC_SURFACE_HEAT, WRC_SURFACE_EVAPORATED) / run.laws.latent_heat;
  EXPECT_GT(by_friction, 0.0);
  EXPECT_LT(by_friction, both(WRC_SURFACE_WATER, WRC_SURFACE_EVAPORATED));
  for (int32_t q = 0; q < WRC_SURFACE_HEAT; ++q) {
    // amounts that one body hands over the other has, and each way out is used
    EXPECT_EQ(both(q, WRC_SURFACE_CARRIED), 0.0) << q;
    EXPECT_NE(run.wheel.total(q, WRC_SURFACE_CARRIED), 0.0) << q;
    double gone = 0.0;
    for (const int32_t book : {WRC_SURFACE_REMOVED, WRC_SURFACE_SQUEEZED, WRC_SURFACE_EVAPORATED})
      gone += both(q, book);
    EXPECT_GT(gone, 0.0) << q;
    EXPECT_NEAR(both(q, WRC_SURFACE_AMOUNT) + gone, both(q, WRC_SURFACE_PUT_ON),
                1e-12 * both(q, WRC_SURFACE_PUT_ON));
    for (const double value : run.rail.values(q)) EXPECT_GE(value, 0.0);
  }
}

TEST(SurfaceFilm, SourcesLieWhereTheyArePut) {
  Band rail = rail_of(10, 2.0);
  rail.add(WRC_SURFACE_WATER, 0.5, 4.0, 12.0);
  EXPECT_NEAR(rail.total(WRC_SURFACE_WATER), 0.5 * 8.0 * rail.surface.width, 1e-14);
  const std::vector<double> water = rail.values(WRC_SURFACE_WATER);
  const double expected[] = {0.0, 0.0625, 0.4375, 0.5, 0.5, 0.4375, 0.0625, 0.0, 0.0, 0.0};
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(water[k], expected[k], 1e-14) << k;
  // over the end: that part is not put on
  EXPECT_EQ(wrc_surface_add(&rail.surface, WRC_SURFACE_SAND, 1.0, 18.0, 30.0, nullptr, 0),
            WRC_FLAG_BEYOND_SECTIONS);
  EXPECT_NEAR(rail.total(WRC_SURFACE_SAND), 1.0 * 2.0 * rail.surface.width, 1e-14);
  // a wheel has no end
  Band wheel = wheel_of();
  wheel.add(WRC_SURFACE_SAND, 0.1, -0.5 * turn, 2.5 * turn);
  for (const double value : wheel.values(WRC_SURFACE_SAND)) EXPECT_NEAR(value, 0.3, 1e-12);
}

TEST(SurfaceFilm, FrictionRecoversByThePublishedLaw) {
  // one substance on one body: mu = mu_0 - (mu_0 - mu_d) share exp(-tau W), however the way is divided
  wrc_surface_laws laws = wrc_surface_laws_default();
  laws.film.cover = 0.01;
  laws.film.weight = 1.0;
  laws.film.friction = laws.film.wet_friction = 0.04;
  laws.film.removal = 2e-6;
  wrc_friction dry = wrc_friction_default();
  dry.coefficient = 0.35;
  for (const int parts : {1, 7, 400}) {
    Band rail = rail_of();
    rail.add(WRC_SURFACE_FILM, 0.008, 0.0, 100.0);
    laws.film.friction = 0.04;
    if (parts == 7) {  // wet: the same between the frictions of the wet
      laws.water.cover = 1e-3;
      laws.water.wet_friction = 0.35;
      laws.film.friction = 0.15;
      rail.add(WRC_SURFACE_WATER, 0.1, 0.0, 100.0);
    }
    double worst = 0.0;
    for (int wheel = 0; wheel <= 8; ++wheel) {
      const double dose = 500.0 * wheel / rail.surface.width;  // 500 J/m [J/m^2]
      const double law = 0.35 - (0.35 - 0.04) * 0.8 * std::exp(-laws.film.removal * dose);
      worst = std::max(worst, std::abs(friction_at(rail, nullptr, laws, 47.3, 0.0, &dry).coefficient - law));
      for (int k = 0; k < parts; ++k)
        go(rail, nullptr, laws,
           passage_of(100.0 * k / parts, 100.0 * (k + 1) / parts, 0.0, 0.0, 50e3 / parts));
    }
    EXPECT_LT(worst, 1e-12) << parts;
  }
}

TEST(SurfaceFilm, MixesWhatCovers) {
  const wrc_surface_laws laws = laws_of();
  const auto of = [&](std::initializer_list<std::pair<int32_t, double>> amounts) {
    Band rail = rail_of();
    for (const auto& [quantity, amount] : amounts) rail.add(quantity, amount, 0.0, 100.0);
    return friction_at(rail, nullptr, laws, 50.0).coefficient;
  };
  EXPECT_EQ(of({}), 0.3);
  EXPECT_NEAR(of({{WRC_SURFACE_WATER, 1.0}}), 0.25, 1e-12);
  EXPECT_NEAR(of({{WRC_SURFACE_FILM, 1.0}}), 0.12, 1e-12);
  // wet leaves have .02 to .05, damp oxide about .1, sand on wet leaves mends
  const double leaves = of({{WRC_SURFACE_WATER, 1.0}, {WRC_SURFACE_FILM, 1.0}});
  EXPECT_NEAR(leaves, 0.03, 1e-12);
  EXPECT_GT(leaves, 0.02);
  EXPECT_LT(leaves, 0.05);
  EXPECT_NEAR(of({{WRC_SURFACE_WATER, 1.0}, {WRC_SURFACE_OXIDE, 1.0}}), 0.1, 1e-12);
  EXPECT_GT(of({{WRC_SURFACE_WATER, 1.0}, {WRC_SURFACE_FILM, 1.0}, {WRC_SURFACE_SAND, 1.0}}), 3.0 * leaves);
}

/// Largest step of a scan, over that of a scan with a tenth of the steps' length: 10 where nothing jumps.
double refinement(const std::function<double(double)>& scan, int steps = 1500) {
  const auto largest = [&](int count) {
    double most = 0.0, before = scan(0.0);
    for (int k = 1; k <= count; ++k) {
      const double now = scan(static_cast<double>(k) / count);
      most = std::max(most, std::abs(now - before));
      before = now;
    }
    return most;
  };
  return largest(steps / 10) / std::max(largest(steps), 1e-300);
}

struct Wheelset {
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  wrc_wheel_input input = wrc_wheel_input_default();

  explicit Wheelset(const char* resolution = "real time") {
    wrc_config config = wrc_config_default();
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_60E1;
    config.track.rail_inclination = 1.0 / 40.0;
    EXPECT_EQ(wrc_config_use(&config, resolution, nullptr, 0), WRC_OK);
    EXPECT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    EXPECT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0), WRC_OK);
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 55e3;
    input.wheel.velocity[0] = 20.0;
    input.wheel.pitch_rate = -20.0 / 0.46 * 0.97;
    input.friction.temperature_law = WRC_TEMPERATURE_LAW_NONE;
  }
  ~Wheelset() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  Wheelset(const Wheelset&) = delete;
  Wheelset& operator=(const Wheelset&) = delete;

  wrc_wrench solve(const wrc_friction& friction) {
    input.friction = friction;
    auto wrench = sized<wrc_wrench>();
    EXPECT_GE(wrc_contact_wrench(contact, &input, &wrench), WRC_OK);
    return wrench;
  }
};

TEST(SurfaceFilm, NothingJumpsAlongScans) {
  Wheelset set;
  const wrc_surface_laws laws = laws_of("low adhesion, layers");
  // place: over bins and past the ends of the film
  Journey run;
  for (int k = 0; k < 700; ++k) run.step(0.08, 0.2, 300.0);
  const auto by_place = [&](double t) {
    return friction_at(run.rail, &run.wheel, laws, 8.0 + 4.0 * t, 1.1 + t);
  };
  EXPECT_GT(refinement([&](double t) { return by_place(t).coefficient; }), 9.0);
  EXPECT_GT(refinement([&](double t) { return set.solve(by_place(t)).force[0]; }), 8.0);
  // amount of each substance from none on, beside water: coefficient and force
  const double cover[] = {laws.water.cover, laws.oxide.cover, laws.film.cover, laws.sand.cover,
                          laws.lubricant.cover};
  for (int32_t q = 0; q < WRC_SURFACE_HEAT; ++q) {
    const auto by_amount = [&](double t) {
      Band rail(1, 1.0);
      if (q != WRC_SURFACE_WATER) rail.add(WRC_SURFACE_WATER, 0.003, 0.0, 1.0);
      rail.add(q, cover[q] * 1.5 * t, 0.0, 1.0);
      return friction_at(rail, nullptr, laws, 0.5);
    };
    EXPECT_GT(refinement([&](double t) { return by_amount(t).coefficient; }), 8.0) << q;
    EXPECT_GT(refinement([&](double t) { return set.solve(by_amount(t)).force[0]; }), 6.0) << q;
  }
  // temperature, through friction over temperature
  wrc_friction heated = wrc_friction_default();
  heated.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  const auto by_heat = [&](double t) {
    Band rail(1, 1.0);
    rail.add(WRC_SURFACE_HEAT, 15e6 * t, 0.0, 1.0);
    return friction_at(rail, nullptr, laws, 0.5, 0.0, &heated);
  };
  EXPECT_NEAR(by_heat(1.0).bulk.rail, laws.ambient + 15e6 / laws.rail_heat_capacity, 1e-9);
  EXPECT_GT(refinement([&](double t) { return set.solve(by_heat(t)).force[0]; }, 500), 8.0);
}

TEST(SurfaceFilm, LayersLieInSeries) {
  const wrc_surface_laws laws = laws_of("low adhesion, layers");
  wrc_friction base = wrc_friction_default();
  base.layer_thickness = 20e-6;
  base.layer_modulus = 100e6;
  base.layer_yield = 300e6;
  Band rail = rail_of();
  rail.add(WRC_SURFACE_OXIDE, 0.104, 0.0, 100.0);  // 20 um
  const wrc_friction found = friction_at(rail, nullptr, laws, 50.0, 0.0, &base);
  EXPECT_NEAR(found.layer_thickness, 40e-6, 1e-12);
  EXPECT_NEAR(found.layer_thickness / found.layer_modulus, 20e-6 / 100e6 + 20e-6 / 176.63e6, 1e-22);
  EXPECT_NEAR(1.0 / found.layer_yield, 1.0 / 300e6 + 1.0 / 560e6, 1e-18);
  // a clean rail has a layer that does nothing: the same method all along
  const wrc_friction clean = friction_at(rail_of(), nullptr, laws, 50.0);
  EXPECT_EQ(clean.layer_thickness, 0.0);
  EXPECT_EQ(clean.layer_yield, 1e11);
  EXPECT_EQ(friction_at(rail_of(), nullptr, laws_of(), 50.0).layer_yield, 0.0);
}

TEST(SurfaceFilm, DividedPassagesAreNearlyTheSame) {
  const auto after = [](int parts) {
    Journey run;
    for (int k = 0; k < parts; ++k) run.step(80.0 / parts, 0.1, 80.0 * 600.0 / parts, 2.0 / parts);
    return run;
  };
  const Journey fine = after(2000), coarse = after(200);
  for (int32_t q = 0; q < WRC_SURFACE_QUANTITIES; ++q) {
    const double put_on = fine.rail.total(q, WRC_SURFACE_PUT_ON);
    EXPECT_NEAR(coarse.rail.total(q), fine.rail.total(q), 2e-3 * put_on) << q;
    EXPECT_NEAR(coarse.wheel.total(q), fine.wheel.total(q), 2e-3 * put_on) << q;
  }
}

TEST(SurfaceFilm, AWheelCarriesLubricantOn) {
  wrc_surface_laws laws = wrc_surface_laws_default();
  laws.lubricant.carry = 0.5;
  Band rail = rail_of(400), wheel = wheel_of();
  rail.add(WRC_SURFACE_LUBRICANT, 0.1, 10.0, 20.0);
  for (int k = 0; k < 4000; ++k)
    go(rail, &wheel, laws, passage_of(0.1 * k, 0.1 * (k + 1), 0.1 * k, 0.1 * (k + 1), 0.0));
  const std::vector<double> left = rail.values(WRC_SURFACE_LUBRICANT);
  EXPECT_EQ(left[6], 0.0);
  EXPECT_LT(left[12], 0.1);
  for (int k = 40; k < 320; k += 20) {
    EXPECT_GT(left[k], 0.0) << k;
    EXPECT_LT(left[k + 20], 0.75 * left[k]) << k;
  }
  EXPECT_NEAR(rail.total(WRC_SURFACE_LUBRICANT) + wheel.total(WRC_SURFACE_LUBRICANT),
              rail.total(WRC_SURFACE_LUBRICANT, WRC_SURFACE_PUT_ON), 1e-15);
  expect_balanced(rail);
}

TEST(SurfaceFilm, WheelsPassInTheirOrder) {
  // the second of two unlike wheels meets the leavings of the first
  const auto after = [](double first, double second) {
    Journey run;
    const double start = run.at;
    for (const double energy : {first, second}) {
      run.at = start;
      for (int k = 0; k < 100; ++k) run.step(0.5, 0.1, energy);
    }
    return run;
  };
  const Journey once = after(200.0, 600.0), again = after(200.0, 600.0), swapped = after(600.0, 200.0);
  EXPECT_TRUE(once.rail.same(again.rail));
  EXPECT_TRUE(once.wheel.same(again.wheel));
  EXPECT_FALSE(once.rail.same(swapped.rail));
  // for the film as such only the sum of the energies counts
  EXPECT_NEAR(once.rail.total(WRC_SURFACE_FILM), swapped.rail.total(WRC_SURFACE_FILM),
              1e-2 * once.rail.total(WRC_SURFACE_FILM));
}

TEST(SurfaceFilm, SourcesOfThreadsMergeInAnyOrder) {
  const auto rain = [](Band& band, int which) {
    for (int k = 0; k < 200; ++k)
      band.add(k % WRC_SURFACE_QUANTITIES, 1e-3 / (1 + which + k), 0.37 * k, 0.37 * k + 9.0 + which);
  };
  std::vector<Band> own(4, rail_of());
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) threads.emplace_back([&, t] { rain(own[t], t); });
  for (std::thread& each : threads) each.join();
  Band all = rail_of(), forth = rail_of(), back = rail_of();
  for (int t = 0; t < 4; ++t) rain(all, t);
  for (int t = 0; t < 4; ++t) {
    EXPECT_EQ(wrc_surface_merge(&forth.surface, &own[t].surface, nullptr, 0), WRC_OK);
    EXPECT_EQ(wrc_surface_merge(&back.surface, &own[3 - t].surface, nullptr, 0), WRC_OK);
  }
  EXPECT_TRUE(all.same(forth));
  EXPECT_TRUE(all.same(back));
}

TEST(SurfaceFilm, ThreadsOnStretchesOfARailGiveTheSameBits) {
  // two wheels on the two halves of one rail, whose bins they do not share
  const auto half = [](Journey& run, Band& wheel, double start) {
    double at = start;
    for (int k = 0; k < 500; ++k, at += 0.08)
      go(run.rail, &wheel, run.laws, passage_of(at, at + 0.08, at, at + 0.07, 50.0));
  };
  Journey one, two;
  Band one_wheel = wheel_of(), two_wheel = wheel_of();
  half(one, one.wheel, 5.0);
  half(one, one_wheel, 55.0);
  std::thread first([&] { half(two, two.wheel, 5.0); });
  std::thread second([&] { half(two, two_wheel, 55.0); });
  first.join();
  second.join();
  EXPECT_TRUE(one.rail.same(two.rail));
  EXPECT_TRUE(one.wheel.same(two.wheel));
  EXPECT_TRUE(one_wheel.same(two_wheel));
}

TEST(SurfaceFilm, GoesOnFromCopiedBins) {
  Journey run;
  for (int k = 0; k < 300; ++k) run.step(0.08, 0.2, 100.0);
  const Journey saved = run;
  for (int k = 0; k < 300; ++k) run.step(0.08, 0.2, 100.0);
  Journey restored = saved;
  for (int k = 0; k < 300; ++k) restored.step(0.08, 0.2, 100.0);
  EXPECT_TRUE(run.rail.same(restored.rail));
  EXPECT_TRUE(run.wheel.same(restored.wheel));
  EXPECT_FALSE(run.rail.same(saved.rail));
}

TEST(SurfaceFilm, LockedSpinningBackwardsAndBeyondTheEnds) {
  // locked: the energy of the whole way is on one place of the wheel
  Journey locked;
  locked.rail.add(WRC_SURFACE_WATER, 0.0, 0.0, 1.0);
  go(locked.rail, &locked.wheel, locked.laws, passage_of(10.0, 60.0, 0.5, 0.5, 30e3));
  std::vector<double> hot = locked.wheel.values(WRC_SURFACE_HEAT);
  EXPECT_EQ(std::count_if(hot.begin(), hot.end(), [](double each) { return each > 0.0; }), 2);
  expect_balanced(locked.wheel);
  // spinning in place: one place of the rail
  Journey spinning;
  go(spinning.rail, &spinning.wheel, spinning.laws, passage_of(40.2, 40.2, 0.0, 50.0, 30e3));
  hot = spinning.rail.values(WRC_SURFACE_HEAT);
  EXPECT_EQ(std::count_if(hot.begin(), hot.end(), [](double each) { return each > 0.0; }), 2);
  expect_balanced(spinning.rail);
  // backwards over the same way: the same dose
  Journey forth, back;
  const wrc_surface_laws only = [] {
    wrc_surface_laws laws = wrc_surface_laws_default();
    laws.film.removal = 1e-6;
    return laws;
  }();
  go(forth.rail, nullptr, only, passage_of(12.3, 44.0, 0.0, 0.0, 9e3));
  go(back.rail, nullptr, only, passage_of(44.0, 12.3, 0.0, 0.0, 9e3));
  const std::vector<double> a = forth.rail.values(WRC_SURFACE_FILM), b = back.rail.values(WRC_SURFACE_FILM);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-14);
  // beyond an end: its amounts hold, nothing is changed, the energy is told
  Journey off;
  const wrc_surface_exchange exchange =
      go(off.rail, &off.wheel, off.laws, passage_of(95.0, 105.0, 0.0, 10.0, 1e3), WRC_FLAG_BEYOND_SECTIONS);
  EXPECT_NEAR(exchange.beside_energy, 0.5 * 0.5 * 1e3, 1e-9);
  EXPECT_NEAR(exchange.rail_energy + exchange.wheel_energy + exchange.beside_energy, 1e3, 1e-9);
  const Band untouched = rail_of();
  EXPECT_EQ(
      friction_at(off.rail, nullptr, off.laws, 120.0, 0.0, nullptr, WRC_FLAG_BEYOND_SECTIONS).coefficient,
      friction_at(off.rail, nullptr, off.laws, 99.9).coefficient);
}

TEST(SurfaceFilm, DerivativesOfTheWrenchAreThoseOfItsFriction) {
  // friction is an input held over the step: the column of friction answers a film that gets thinner
  Wheelset set;
  set.input.prescribed = WRC_PRESCRIBE_HEIGHT;
  set.input.vertical_load = 0.0;
  set.input.wheel.z = 0.12e-3;
  const wrc_surface_laws laws = laws_of();
  const auto with = [&](double amount) {
    Band rail(1, 1.0);
    rail.add(WRC_SURFACE_FILM, amount, 0.0, 1.0);
    return friction_at(rail, nullptr, laws, 0.5);
  };
  const double amount = 0.006, less = 1e-6;
  const wrc_friction friction = with(amount), more = with(amount - less), fewer = with(amount + less);
  const double slope =
      (set.solve(more).force[0] - set.solve(fewer).force[0]) / (more.coefficient - fewer.coefficient);
  set.input.friction = friction;
  auto by = sized<wrc_wrench_derivatives>();
  EXPECT_GE(wrc_contact_wrench_derivatives(set.contact, &set.input, nullptr, &by), WRC_OK);
  EXPECT_NEAR(by.wrench[0][WRC_BY_FRICTION] / friction.coefficient, slope, 1e-4 * std::abs(slope));
}

// ------------------------------------------------------------------------------------------------ rows
// across

/// Rows of 5 mm: 14 on the rail from the gauge face on, 16 on the wheel from the flange on.
struct Across {
  Band rail{20, 1.0, 0, 14}, wheel{24, turn / 24, 1, 16};
  wrc_surface_laws laws;
  std::vector<double> numbers = std::vector<double>(WRC_FILM_NUMBERS(16, 16));
  Wheelset set;

  explicit Across(const char* name = "low adhesion", const char* resolution = "real time")
      : laws(laws_of(name)), set(resolution) {
    rail.surface.width = wheel.surface.width = 5e-3;
    rail.surface.row_first = -36e-3;
    wheel.surface.row_first = -45e-3;
  }
  /// A source on one row.
  static void add(Band& band, uint32_t row, int32_t quantity, double amount) {
    wrc_surface one = band.surface;
    one.rows = 0;
    one.bins += static_cast<std::size_t>(row) * one.count;
    const double end = one.first + one.count * one.length;
    EXPECT_EQ(wrc_surface_add(&one, quantity, amount, one.first, end, nullptr, 0), WRC_OK);
  }
  /// Films of unlike amounts in all rows of both bodies.
  void lay_all() {
    for (uint32_t k = 0; k < 14; ++k) add(rail, k, WRC_SURFACE_FILM, 0.002 + 0.005 * (k % 3));
    for (uint32_t k = 0; k < 16; ++k) add(wheel, k, WRC_SURFACE_LUBRICANT, 4e-4 * (k % 4));
    rail.add(WRC_SURFACE_WATER, 0.003, 0.0, 20.0);
  }
  wrc_surface_passage at(double place) {
    wrc_surface_passage passage = passage_of(place, place, 0.3, 0.3, 0.0);
    passage.film_rows = numbers.data();
    passage.film_numbers = static_cast<uint32_t>(numbers.size());
    passage.contact = set.contact;
    return passage;
  }
  wrc_friction friction(double place = 7.3, const wrc_friction* base = nullptr) {
    const wrc_surface_passage passage = at(place);
    wrc_friction found{};
    EXPECT_EQ(wrc_surface_friction(&rail.surface, &wheel.surface, &laws, &passage, base, &found, nullptr, 0),
              WRC_OK);
    return found;
  }
};

TEST(SurfaceFilm, StripsHaveTheFrictionOfTheirRows) {
  // rows of the rail alone, dry: friction is that of zones whose breakpoints are the middles of the rows
  Across across;
  std::vector<double> y(14), coefficient(14);
  for (uint32_t k = 0; k < 14; ++k) {
    const double share = 0.07 * k;
    Across::add(across.rail, k, WRC_SURFACE_FILM, share * across.laws.film.cover);
    y[k] = across.rail.surface.row_first + (k + 0.5) * across.rail.surface.width;
    coefficient[k] = 0.3 + (across.laws.film.friction - 0.3) * share;
  }
  wrc_friction zones = wrc_friction_default();
  zones.zone_y = y.data();
  zones.zone_coefficients = coefficient.data();
  zones.zone_count = 14;
  zones.zone_frame = WRC_ZONES_RAIL_PROFILE;
  const wrc_friction rows = across.friction();
  for (const double lateral : {-4e-3, 0.0, 3e-3, 6e-3}) {
    across.set.input.wheel.y = lateral;
    const wrc_wrench a = across.set.solve(rows), b = across.set.solve(zones);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a.force[i], b.force[i], 1e-9 * 55e3) << lateral;
    EXPECT_NEAR(a.power, b.power, 1e-9 * b.power) << lateral;
  }
}

TEST(SurfaceFilm, EqualRowsAreOneBand) {
  // the same films in all rows, with layers: the wrench of one band
  for (const char* name : {"low adhesion", "low adhesion, layers"}) {
    Across across(name);
    Band rail(20, 1.0);
    for (Band* each : {&across.rail, &rail}) {
      each->add(WRC_SURFACE_FILM, 0.006, 0.0, 20.0);
      each->add(WRC_SURFACE_WATER, 0.002, 0.0, 20.0);
    }
    const wrc_wrench a = across.set.solve(across.friction());
    const wrc_wrench b = across.set.solve(friction_at(rail, nullptr, across.laws, 7.3));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a.force[i], b.force[i], 1e-9 * 55e3) << name;
    EXPECT_NEAR(a.power, b.power, 1e-9 * b.power) << name;
  }
}

TEST(SurfaceFilm, ZonesStayBelowRows) {
  // a clean rail leaves zones as they are; a film that covers all steel hides them
  Across across;
  const double y[] = {-10e-3, 10e-3}, coefficient[] = {0.1, 0.4};
  wrc_friction zones = wrc_friction_default();
  zones.zone_y = y;
  zones.zone_coefficients = coefficient;
  zones.zone_count = 2;
  zones.zone_frame = WRC_ZONES_WHEEL_PROFILE;
  const wrc_wrench clean = across.set.solve(zones);
  EXPECT_NEAR(across.set.solve(across.friction(7.3, &zones)).force[0], clean.force[0], 1e-9 * 55e3);
  across.rail.add(WRC_SURFACE_FILM, 1.0, 0.0, 20.0);
  wrc_friction covered = wrc_friction_default();
  covered.coefficient = across.laws.film.friction;
  EXPECT_NEAR(across.set.solve(across.friction(7.3, &zones)).force[0], across.set.solve(covered).force[0],
              1e-9 * 55e3);
}

TEST(SurfaceFilm, DerivativesWithRowsAreThoseOfDifferences) {
  for (const char* name : {"low adhesion", "low adhesion, layers"}) {
    Across across(name);
    Wheelset& set = across.set;
    across.lay_all();
    const wrc_friction rows = across.friction();
    set.input.wheel.y = 4.2e-3;
    set.input.wheel.z = set.solve(rows).z;
    set.input.prescribed = WRC_PRESCRIBE_HEIGHT;
    set.input.vertical_load = 0.0;
    set.solve(rows);
    auto by = sized<wrc_wrench_derivatives>();
    EXPECT_GE(wrc_contact_wrench_derivatives(set.contact, &set.input, nullptr, &by), WRC_OK);
    const double at = set.input.wheel.y, step = 2e-8;
    set.input.wheel.y = at + step;
    const wrc_wrench more = set.solve(rows);
    set.input.wheel.y = at - step;
    const wrc_wrench less = set.solve(rows);
    for (int i = 0; i < 3; ++i) {
      const double slope = (more.force[i] - less.force[i]) / (2.0 * step);
      EXPECT_NEAR(by.wrench[i][WRC_BY_Y], slope, 2e-4 * std::abs(slope) + 1e3) << name << i;
    }
  }
}

TEST(SurfaceFilm, NothingJumpsAcrossTheRows) {
  for (const char* name : {"low adhesion", "low adhesion, layers"}) {
    Across across(name, "default");  // at real time the tolerance of the pressures hides finer steps
    across.lay_all();
    // adhesion: the force over the load, which has a tolerance of its own
    const auto adhesion = [&](const wrc_friction& friction) {
      const wrc_wrench wrench = across.set.solve(friction);
      return wrench.force[0] / wrench.normal_force;
    };
    // derivatives by the pose, over more than a row, beside differences of 5 um and 0.5 um
    const wrc_friction rows = across.friction();
    const auto by_pose = [&](double t) {
      across.set.input.wheel.y = -1e-3 + 1.5e-3 * t;
      return adhesion(rows);
    };
    EXPECT_GT(refinement(by_pose, 3000), 8.0) << name;
    // derivatives by slip, and by the place along a film that ends
    across.set.input.wheel.y = 1e-3;
    const auto by_slip = [&](double t) {
      across.set.input.wheel.pitch_rate = -20.0 / 0.46 * (1.02 - 0.1 * t);
      return adhesion(rows);
    };
    EXPECT_GT(refinement(by_slip), 8.0) << name;
    across.rail.add(WRC_SURFACE_OXIDE, 0.004, 6.4, 20.0);
    EXPECT_GT(refinement([&](double t) { return adhesion(across.friction(5.0 + 3.0 * t)); }), 8.0) << name;
  }
}

TEST(SurfaceFilm, RowsHaveTheEnergyOfTheirStrips) {
  Across across;
  across.lay_all();
  const Band before = across.rail;
  double energy = 0.0, place = 2.0;
  for (int k = 0; k < 300; ++k) {
    across.set.input.wheel.y = 5e-3 * std::sin(0.05 * k);
    wrc_surface_passage passage = across.at(place);
    passage.rail_to = passage.wheel_to = place += 0.04;
    passage.wheel_from = passage.rail_from;
    passage.energy = across.set.solve(across.friction(passage.rail_from)).power * 2e-3;
    energy += passage.energy;
    const wrc_surface_exchange exchange = go(across.rail, &across.wheel, across.laws, passage);
    EXPECT_NEAR(exchange.rail_energy + exchange.wheel_energy + exchange.beside_energy, passage.energy,
                1e-12 * passage.energy);
  }
  // books of all rows: energy, and amounts that went from body to body
  expect_balanced(across.rail);
  expect_balanced(across.wheel);
  const auto both = [&](int32_t quantity, int32_t book) {
    return across.rail.total(quantity, book) + across.wheel.total(quantity, book);
  };
  EXPECT_NEAR(both(WRC_SURFACE_HEAT, WRC_SURFACE_PUT_ON), energy, 1e-12 * energy);
  for (int32_t q = 0; q < WRC_SURFACE_HEAT; ++q) EXPECT_EQ(both(q, WRC_SURFACE_CARRIED), 0.0) << q;
  EXPECT_GT(across.wheel.total(WRC_SURFACE_FILM), 0.0);
  // rows beside the contact are as they were, and copied bins go on with the same bits
  const std::vector<double> then = before.values(WRC_SURFACE_FILM),
                            now = across.rail.values(WRC_SURFACE_FILM);
  int changed = 0;
  for (uint32_t row = 0; row < 14; ++row) changed += now[row * 20 + 8] != then[row * 20 + 8] ? 1 : 0;
  EXPECT_GT(changed, 2);
  EXPECT_LT(changed, 12);
  Band again[2] = {across.rail, across.rail}, tread[2] = {across.wheel, across.wheel};
  for (int i = 0; i < 2; ++i) {
    wrc_surface_passage passage = across.at(4.0);
    passage.rail_to = 6.0;
    passage.energy = 100.0;
    go(again[i], &tread[i], across.laws, passage);
  }
  EXPECT_TRUE(again[0].same(again[1]));
  EXPECT_TRUE(tread[0].same(tread[1]));
}

/// A wheel with a tread of rows on a rail that others pass, too: friction, wrench and passage of each step.
struct OnRail {
  Across own;
  double place;

  OnRail(double start, double lateral) : place(start) {
    own.set.input.wheel.y = lateral;
    own.set.input.start = WRC_START_WARM;
  }
  void step(Band& rail) {
    wrc_surface_passage passage = own.at(place);
    wrc_friction friction{};
    EXPECT_EQ(wrc_surface_friction(&rail.surface, &own.wheel.surface, &own.laws, &passage, nullptr, &friction,
                                   nullptr, 0),
              WRC_OK);
    passage.energy = own.set.solve(friction).power * 2e-3;
    passage.rail_to = place += 0.04;
    passage.wheel_to = 0.3 + place - passage.rail_from;
    go(rail, &own.wheel, own.laws, passage);
    EXPECT_EQ(wrc_surface_rest(&own.wheel.surface, &own.laws, 2e-3, nullptr, 0), WRC_OK);
  }
};

Band rail_with_rows() {
  Across across;
  across.lay_all();
  return across.rail;
}

TEST(SurfaceFilm, WheelsOneBehindTheOtherOnRowsAreInOrderOfPassage) {
  // the second wheel passes each place after the first; they never share a bin in one step, so the order of
  // calls within a step does not change a bit, and the order of passage does
  const auto run = [](bool second_first, double ahead) {
    Band rail = rail_with_rows();
    OnRail first(3.0 + ahead, 2e-3), second(3.0, -1e-3);
    for (int k = 0; k < 100; ++k) {
      (second_first ? second : first).step(rail);
      (second_first ? first : second).step(rail);
    }
    return std::vector<Band>{rail, first.own.wheel, second.own.wheel};
  };
  const std::vector<Band> once = run(false, 3.0), again = run(false, 3.0), swapped = run(true, 3.0),
                          behind = run(false, -2.5);
  for (std::size_t i = 0; i < once.size(); ++i) {
    expect_balanced(once[i]);
    EXPECT_TRUE(once[i].same(again[i])) << i;
    EXPECT_TRUE(once[i].same(swapped[i])) << i;
  }
  EXPECT_FALSE(once[2].same(behind[2]));
}

TEST(SurfaceFilm, ThreadsOnStretchesOfRowsGiveTheSameBits) {
  const auto roll = [](Band& rail, OnRail& wheel) {
    for (int k = 0; k < 60; ++k) wheel.step(rail);
  };
  Band alone = rail_with_rows(), shared = alone;
  OnRail one(3.0, 2e-3), two(13.0, -1e-3), one_thread(3.0, 2e-3), two_thread(13.0, -1e-3);
  roll(alone, one);
  roll(alone, two);
  std::thread first([&] { roll(shared, one_thread); });
  std::thread second([&] { roll(shared, two_thread); });
  first.join();
  second.join();
  EXPECT_TRUE(alone.same(shared));
  EXPECT_TRUE(one.own.wheel.same(one_thread.own.wheel));
  EXPECT_TRUE(two.own.wheel.same(two_thread.own.wheel));
}

TEST(SurfaceFilm, SourcesOfRowsMergeInAnyOrder) {
  const auto lay = [](Band& band, int which) {
    for (uint32_t row = 0; row < 14; ++row)
      Across::add(band, row, static_cast<int32_t>(row % WRC_SURFACE_QUANTITIES), 1e-3 / (1 + which + row));
  };
  const Band empty = Across().rail;
  std::vector<Band> own(3, empty);
  Band all = empty, forth = empty, back = empty;
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) threads.emplace_back([&, t] { lay(own[t], t); });
  for (std::thread& each : threads) each.join();
  for (int t = 0; t < 3; ++t) {
    lay(all, t);
    EXPECT_EQ(wrc_surface_merge(&forth.surface, &own[t].surface, nullptr, 0), WRC_OK);
    EXPECT_EQ(wrc_surface_merge(&back.surface, &own[2 - t].surface, nullptr, 0), WRC_OK);
  }
  EXPECT_TRUE(all.same(forth));
  EXPECT_TRUE(all.same(back));
}

TEST(SurfaceFilm, RowsGoOnFromCopiedBinsAndASavedContact) {
  Band rail = rail_with_rows();
  OnRail wheel(3.0, 2e-3);
  for (int k = 0; k < 30; ++k) wheel.step(rail);
  // bins are copied as bytes, the contact that begins its iterations from the last wrench is saved
  const Band rail_then = rail, tread_then = wheel.own.wheel;
  uint64_t bytes = 0;
  EXPECT_EQ(wrc_contact_state_size(wheel.own.set.model, &bytes), WRC_OK);
  std::vector<char> state(bytes);
  EXPECT_EQ(wrc_contact_save(wheel.own.set.contact, state.data(), bytes), WRC_OK);
  const double place = wheel.place;
  for (int k = 0; k < 30; ++k) wheel.step(rail);
  const Band rail_once = rail, tread_once = wheel.own.wheel;
  rail = rail_then;
  wheel.own.wheel = tread_then;
  wheel.place = place;
  EXPECT_EQ(wrc_contact_restore(wheel.own.set.contact, state.data(), bytes), WRC_OK);
  for (int k = 0; k < 30; ++k) wheel.step(rail);
  EXPECT_TRUE(rail.same(rail_once));
  EXPECT_TRUE(wheel.own.wheel.same(tread_once));
  EXPECT_FALSE(rail.same(rail_then));
}

TEST(SurfaceFilm, WrongRowsAreToldInASentence) {
  Across across;
  char text[400];
  wrc_friction friction{};
  wrc_surface_passage passage = across.at(7.3);
  const wrc_surface *rail = &across.rail.surface, *wheel = &across.wheel.surface;
  const auto mixes = [&](const wrc_friction* base = nullptr) {
    return wrc_surface_friction(rail, wheel, &across.laws, &passage, base, &friction, text, sizeof text);
  };
  passage.film_numbers = 100;
  EXPECT_EQ(mixes(), WRC_ERROR_RANGE);
  EXPECT_NE(std::string(text).find("WRC_FILM_NUMBERS"), std::string::npos) << text;
  passage = across.at(7.3);
  EXPECT_EQ(mixes(), WRC_OK);
  const wrc_friction rows = friction;
  EXPECT_EQ(mixes(&rows), WRC_ERROR_UNSUPPORTED);
  EXPECT_NE(std::string(text).find("clean bodies"), std::string::npos) << text;
  // a passage with rows needs a contact that was solved
  EXPECT_EQ(
      wrc_surface_pass(&across.rail.surface, nullptr, &across.laws, &passage, nullptr, text, sizeof text),
      WRC_ERROR_SEQUENCE);
  passage.contact = nullptr;
  EXPECT_EQ(
      wrc_surface_pass(&across.rail.surface, nullptr, &across.laws, &passage, nullptr, text, sizeof text),
      WRC_ERROR_SEQUENCE);
  EXPECT_NE(std::string(text).find("passage.contact"), std::string::npos) << text;
  // film_rows that no call has filled
  auto wrench = sized<wrc_wrench>();
  across.set.input.friction = rows;
  across.numbers[0] = 3.5;
  EXPECT_EQ(wrc_contact_wrench(across.set.contact, &across.set.input, &wrench), WRC_ERROR_RANGE);
  across.numbers[0] = 14.0;
  across.numbers[8] = 1.5;
  EXPECT_EQ(wrc_contact_wrench(across.set.contact, &across.set.input, &wrench), WRC_ERROR_RANGE);
  across.numbers[8] = nan_value;
  EXPECT_EQ(wrc_contact_wrench(across.set.contact, &across.set.input, &wrench), WRC_ERROR_RANGE);
  across.set.input.friction.film_rows = nullptr;
  EXPECT_EQ(wrc_contact_wrench(across.set.contact, &across.set.input, &wrench), WRC_ERROR_NULL);
}

/// Each wrong call with a part of its sentence. Nothing is changed.
TEST(SurfaceFilm, WrongInputIsToldInASentence) {
  Journey run;
  run.step(0.08, 0.2, 100.0);
  const Journey before = run;
  char text[400];
  wrc_surface& rail = run.rail.surface;
  wrc_surface& wheel = run.wheel.surface;
  wrc_surface_laws& laws = run.laws;
  wrc_surface_passage passage = passage_of(10.0, 10.1, 0.0, 0.1, 5.0);
  wrc_friction friction{};
  const auto source = [&](int32_t quantity, double amount, double from, double to) {
    return wrc_surface_add(&rail, quantity, amount, from, to, text, sizeof text);
  };
  const auto passes = [&] {
    return wrc_surface_pass(&rail, &wheel, &laws, &passage, nullptr, text, sizeof text);
  };
  const auto mixes = [&](const wrc_friction* base = nullptr) {
    return wrc_surface_friction(&rail, &wheel, &laws, &passage, base, &friction, text, sizeof text);
  };
  const auto expect = [&](int32_t status, int32_t expected, const char* part) {
    EXPECT_EQ(status, expected) << text;
    EXPECT_NE(std::string(text).find(part), std::string::npos) << text << "\n  has not: " << part;
  };
  const auto with = [&](double& member, double value, const std::function<int32_t()>& call, int32_t expected,
                        const char* part) {
    const double kept = member;
    member = value;
    expect(call(), expected, part);
    member = kept;
  };
  expect(source(WRC_SURFACE_WATER, -1e-3, 0.0, 1.0), WRC_ERROR_RANGE, "a source puts on");
  expect(source(WRC_SURFACE_WATER, 500.0, 0.0, 1.0), WRC_ERROR_RANGE, "did you pass g?");
  expect(source(WRC_SURFACE_WATER, nan_value, 0.0, 1.0), WRC_ERROR_NOT_FINITE, "amount");
  expect(source(WRC_SURFACE_WATER, 1e-3, 5.0, 1.0), WRC_ERROR_RANGE, "ends before it begins");
  expect(source(WRC_SURFACE_WATER, 1e-3, 0.0, 2e6), WRC_ERROR_RANGE, "divide the stretch");
  expect(source(7, 1e-3, 0.0, 1.0), WRC_ERROR_UNSUPPORTED, "_LUBRICANT (4)");
  with(rail.length, 0.0, passes, WRC_ERROR_RANGE, "was it set?");
  with(rail.length, -1.0, passes, WRC_ERROR_RANGE, "rail.length");
  with(rail.width, 0.0, passes, WRC_ERROR_RANGE, "no area");
  with(wheel.first, infinity, passes, WRC_ERROR_NOT_FINITE, "wheel.first");
  with(passage.energy, -5.0, passes, WRC_ERROR_RANGE, "wrc_wrench.power");
  with(passage.energy, nan_value, passes, WRC_ERROR_NOT_FINITE, "passage.energy");
  with(passage.rail_to, 1e8, passes, WRC_ERROR_RANGE, "divide the stretch");
  with(passage.wheel_to, 1e8, passes, WRC_ERROR_RANGE, "passage.wheel_to");
  with(
      laws.film.cover, 0.0, [&] { return mixes(); }, WRC_ERROR_RANGE, "no effect");
  with(
      laws.film.weight, 0.0, [&] { return mixes(); }, WRC_ERROR_RANGE, "needs its weight");
  with(
      laws.water.weight, 1.0, [&] { return mixes(); }, WRC_ERROR_RANGE, "water wets");
  with(
      laws.water.wet_friction, 0.0, [&] { return mixes(); }, WRC_ERROR_RANGE, "laws.water.wet_friction");
  with(
      laws.film.friction, 3.0, [&] { return mixes(); }, WRC_ERROR_RANGE, "laws.film.friction");
  with(laws.sand.layer_yield, 0.0, passes, WRC_ERROR_RANGE, "cannot harden");
  with(laws.water.squeeze, 1.0, passes, WRC_ERROR_RANGE, "squeeze");
  with(laws.cooling_time, 0.0, passes, WRC_ERROR_RANGE, "cooling_time");
  rail.bin_size = 8;
  expect(passes(), WRC_ERROR_RANGE, "sizeof(wrc_surface_bin)");
  rail.bin_size = sizeof(wrc_surface_bin) + 4;
  expect(passes(), WRC_ERROR_STRUCT_SIZE, "sizeof(wrc_surface_bin)");
  rail.bin_size = sizeof(wrc_surface_bin);
  rail.bins = nullptr;
  expect(passes(), WRC_ERROR_NULL, "rail.bins");
  rail.bins = wheel.bins;
  expect(passes(), WRC_ERROR_RANGE, "bins of its own");
  rail.bins = run.rail.bin.data();
  const double zone_y[2] = {-1.0, 1.0}, zone_mu[2] = {0.1, 0.4};
  wrc_friction zones = wrc_friction_default();
  zones.zone_count = 2;
  zones.zone_y = zone_y;
  zones.zone_coefficients = zone_mu;
  expect(mixes(&zones), WRC_ERROR_UNSUPPORTED, "zones");
  EXPECT_EQ(friction.coefficient, wrc_friction_default().coefficient);
  expect(wrc_surface_rest(&rail, &laws, -1.0, text, sizeof text), WRC_ERROR_RANGE, "time does not go back");
  expect(wrc_surface_merge(&rail, &wheel, text, sizeof text), WRC_ERROR_RANGE, "lie elsewhere");
  expect(wrc_surface_laws_use(&laws, "wet", text, sizeof text), WRC_ERROR_UNSUPPORTED, "\"low adhesion\"");
  expect(wrc_surface_values(&rail, 0, 9, nullptr, nullptr, text, sizeof text), WRC_ERROR_UNSUPPORTED,
         "_CARRIED (5)");
  expect(wrc_surface_values(&rail, 0, 0, nullptr, nullptr, text, sizeof text), WRC_ERROR_NULL, "values");
  EXPECT_TRUE(before.rail.same(run.rail));
  EXPECT_TRUE(before.wheel.same(run.wheel));
  EXPECT_EQ(passes(), WRC_OK) << text;
  EXPECT_EQ(text[0], '\0');
}

TEST(SurfaceFilm, BinsThatWereNeverZeroedGiveNumbers) {
  Journey run;
  std::memset(run.rail.bin.data(), 0xb7, run.rail.bin.size() * sizeof run.rail.bin[0]);
  std::memset(run.wheel.bin.data(), 0x5a, run.wheel.bin.size() * sizeof run.wheel.bin[0]);
  const wrc_surface_passage passage = passage_of(10.0, 12.0, 0.0, 2.0, 500.0);
  wrc_friction friction{};
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(wrc_surface_friction(&run.rail.surface, &run.wheel.surface, &run.laws, &passage, nullptr,
                                   &friction, nullptr, 0),
              WRC_FLAG_SUM_OVERFLOW);
    EXPECT_TRUE(std::isfinite(friction.coefficient));
    EXPECT_TRUE(friction.coefficient >= 1e-4 && friction.coefficient <= 2.0);
    wrc_surface_pass(&run.rail.surface, &run.wheel.surface, &run.laws, &passage, nullptr, nullptr, 0);
    wrc_surface_rest(&run.rail.surface, &run.laws, 1.0, nullptr, 0);
  }
}

}  // namespace
