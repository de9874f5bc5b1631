// wrc.hpp: handles own and move, statuses are values or exceptions, results have C's bits, nothing allocates.
// Compiled by every standard from C++17 on, with exceptions and without. Prints what it is made of.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

#include "wrc/wrc.hpp"

// Allocations by C++; the library's own are malloc's, through the allocator below.
static int news = 0;
void* operator new(std::size_t size) {
  ++news;
  if (void* memory = std::malloc(size)) return memory;
  std::abort();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

int checks = 0, failures = 0;

void expect(bool holds, const char* what, int line) {
  ++checks;
  if (holds) return;
  ++failures;
  std::printf("line %d: %s does not hold\n", line, what);
}
#define EXPECT(what) expect(what, #what, __LINE__)

int alive = 0;  // pieces of memory the library holds
void* allocate(void*, std::uint64_t bytes, std::uint64_t alignment) {
  ++alive;
  return ::operator new(static_cast<std::size_t>(bytes), std::align_val_t(alignment));
}
std::uint64_t memory_alignment = 64;
void release(void*, void* memory) {
  --alive;
  ::operator delete(memory, std::align_val_t(memory_alignment));
}

wrc_config usual() {
  auto config = wrc::defaults<wrc_config>();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  return config;
}

// 1 mm aside, yawed, rolling, in contact.
wrc_wheel_input usual_input() {
  auto input = wrc::defaults<wrc_wheel_input>();
  input.wheel.y = 1e-3;
  input.wheel.z = 0.3e-3;
  input.wheel.yaw = 2e-3;
  input.wheel.velocity[0] = 20.0;
  input.wheel.pitch_rate = -20.0 / 0.46;
  return input;
}

static_assert(!std::is_copy_constructible_v<wrc::contact> &&
              std::is_nothrow_move_constructible_v<wrc::contact>);
static_assert(!std::is_copy_constructible_v<wrc::model> && std::is_nothrow_move_assignable_v<wrc::model>);
static_assert(sizeof(wrc::contact) == sizeof(wrc_contact*) &&
              sizeof(wrc::contact_ref) == sizeof(wrc_contact*));

// Tractions of bodies that roll from rest grow.
void rolls_on() {
  auto problem = wrc::defaults<wrc_exact_rolling_problem>();
  problem.grid.nx = problem.grid.ny = 4;
  problem.grid.dx = problem.grid.dy = 1e-3;
  problem.grid.x0 = problem.grid.y0 = -1.5e-3;
  problem.creepage.longitudinal = 1e-3;
  const std::vector<double> pressure(16, 1e9);
  problem.pressure = pressure.data();
  auto solution = wrc::defaults<wrc_exact_rolling_solution>();
  auto made = wrc::transient::make(problem.grid);
  EXPECT(made.has_value());
  wrc::transient bodies(std::move(*made));
  EXPECT(bodies.step(problem, solution) == WRC_OK);
  const double first = solution.fx;
  EXPECT(bodies.step(problem, solution) == WRC_OK && solution.fx < first && first < 0.0);
  problem.grid.nx = 0;
  std::array<char, 300> text{};
  EXPECT(wrc::transient::make(problem.grid, nullptr, nullptr, text).error() == WRC_ERROR_RANGE &&
         std::strstr(text.data(), "nx"));
  EXPECT(wrc::transient().step(problem, solution) == WRC_ERROR_NULL);
}

// Size set, and the library's defaults where it has some.
void structs() {
  EXPECT(wrc::defaults<wrc_wrench>().struct_size == sizeof(wrc_wrench) &&
         wrc::defaults<wrc_wrench>().z == 0.0);
  EXPECT(wrc::defaults<wrc_config>().track.gauge == 1.435 &&
         wrc::defaults<wrc_config>().struct_size == sizeof(wrc_config));
  EXPECT(wrc::defaults<wrc_rail_state>().y == 0.0 && wrc::defaults<wrc_creepage>().speed == 1.0);
  EXPECT(wrc::defaults<wrc_profile_wear>().passages == 1.0);
  EXPECT(wrc::met(WRC_FLAG_BIT(WRC_FLAG_CLIMBING), WRC_FLAG_CLIMBING) &&
         !wrc::met(WRC_FLAG_BIT(WRC_FLAG_CLIMBING), WRC_FLAG_NO_CONTACT));
}

// A wheel on a rail, its regions and their fields.
void wheel_on_rail(wrc::contact& contact) {
  const wrc_wheel_input input = usual_input();
  auto wrench = wrc::defaults<wrc_wrench>(), of_c = wrench;
  EXPECT(wrc_contact_wrench(contact.get(), &input, &of_c) == WRC_OK);
  const int before = news;
  EXPECT(contact.wrench(input, wrench) == WRC_OK);
  EXPECT(std::memcmp(&wrench, &of_c, sizeof wrench) == 0);
  const auto tried = contact.try_wrench(input);
  EXPECT(tried && tried->flag == WRC_OK && tried->flags == 0 && tried->force[2] == of_c.force[2] &&
         of_c.force[2] < -1e4);
  EXPECT(of_c.region_count > 0);
  double area = 0.0;
  for (std::int32_t i = 0; i < of_c.region_count; ++i) {
    const auto region = contact.try_region(i);
    EXPECT(region && region->strip_count > 0);
    area += region->area;
  }
  EXPECT(std::fabs(area / of_c.area - 1.0) < 1e-12);
  EXPECT(contact.try_region(of_c.region_count).error() == WRC_ERROR_RANGE);

  // a field in memory of the caller's, and of the shape that was asked for first
  wrc::field_shape shape;
  EXPECT(contact.field(0, WRC_FIELD_PRESSURE, {}, shape) == WRC_OK && shape.size() > 100);
  static double room[1 << 16];
  EXPECT(contact.field(0, WRC_FIELD_PRESSURE, room, shape) == WRC_OK);
  wrc::field_shape none = shape;
  EXPECT(contact.field(0, WRC_FIELD_PRESSURE, wrc::span<double>(room, shape.size() - 1), none) ==
             WRC_ERROR_BUFFER &&
         none.size() == 0);

  // wear by the published laws, and derivatives
  const auto wear = contact.try_wear(0);
  EXPECT(wear && wear->worn_area_rate > 0.0);
  auto by = wrc::defaults<wrc_wrench_derivatives>();
  EXPECT(contact.wrench_derivatives(input, nullptr, &by) == WRC_OK && by.wrench[2][WRC_BY_Z] < -1e8);
  EXPECT(news == before);

  // the same field in a vector
  const auto pressure = contact.try_field(0, WRC_FIELD_PRESSURE);
  EXPECT(pressure && pressure->cells() == shape.cells && pressure->strips() == shape.strips);
  double most = 0.0;
  for (std::size_t j = 0; j < pressure->strips(); ++j) {
    const wrc::span<const double> strip = pressure->strip(j);
    EXPECT(strip.size() == pressure->cells());
    for (std::size_t i = 0; i < strip.size(); ++i) {
      EXPECT(strip[i] == (*pressure)(i, j) && strip[i] == room[j * strip.size() + i]);
      if (strip[i] > most) most = strip[i];
    }
  }
  EXPECT(most > 0.9 * of_c.peak_pressure && most <= of_c.peak_pressure);
  const auto peak = contact.try_field(0, WRC_FIELD_STRIP_PEAK);
  EXPECT(peak && peak->cells() == 1 && peak->values().size() == shape.strips);
  EXPECT(contact.try_field(7, WRC_FIELD_PRESSURE).error() == WRC_ERROR_RANGE);

  // a flag is no failure, and comes with the answer
  wrc_wheel_input apart = input;
  apart.wheel.z = -1e-3;
  const auto away = contact.try_wrench(apart);
  EXPECT(away && away->flag == WRC_FLAG_NO_CONTACT && away->flag.flagged() &&
         wrc::met(away->flags, WRC_FLAG_NO_CONTACT) && away->force[2] == 0.0 && away->clearance > 0.0);
}

void stages(wrc::contact& contact) {
  auto input = wrc::defaults<wrc_planar_input>();
  input.load.normal_force = 80e3;
  input.creepage.longitudinal = 0.5e-3;
  const auto output = contact.try_planar_step(input);
  EXPECT(output && output->forces.fx < 0.0 && output->normal.patch_count > 0);
  const auto all = contact.try_damage(WRC_ALL_REGIONS);
  EXPECT(all && all->power == output->damage.power);
}

void values() {
  auto allocator = wrc::defaults<wrc_allocator>();
  allocator.allocate = allocate;
  allocator.release = release;
  {
    auto made = wrc::model::make(usual(), {}, &allocator);
    EXPECT(made.has_value());
    wrc::model model = std::move(*made);
    auto right = wrc::contact::make(model, WRC_SIDE_RIGHT, {}, &allocator);
    EXPECT(right && alive == 2);
    wrc::contact contact = std::move(*right);
    EXPECT(contact && !*right);

    // what was moved from says so
    const wrc_wheel_input input = usual_input();
    auto wrench = wrc::defaults<wrc_wrench>();
    EXPECT(right->wrench(input, wrench) == WRC_ERROR_NULL);
    wheel_on_rail(contact);
    stages(contact);

    // a profile as the model has it
    const auto rail = model.try_profile(WRC_SIDE_RIGHT, WRC_BODY_RAIL);
    EXPECT(rail && rail->y.size() > 100 && rail->y.size() == rail->z.size());

    // save and restore; sentences
    const int before = news;
    wrc_wheel_input wrong = input;
    wrong.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    wrong.vertical_load = 80.0;
    std::array<char, 300> sentence{};
    EXPECT(contact.try_wrench(wrong).error() == WRC_ERROR_RANGE);
    EXPECT(contact.last_error(sentence) == WRC_OK && std::strstr(sentence.data(), "did you pass kN?"));
    EXPECT(news == before);
    const auto bytes = model.try_contact_state_size();
    EXPECT(bytes.has_value());
    std::vector<std::byte> state(static_cast<std::size_t>(*bytes));
    EXPECT(contact.save(state) == WRC_OK && contact.restore(state) == WRC_OK);
    EXPECT(contact.save(wrc::span<std::byte>(state.data(), 8)) == WRC_ERROR_BUFFER);

    // several contacts in one call: one input for all, one for each, too few
    auto left = wrc::contact::make(model, WRC_SIDE_LEFT);
    EXPECT(left.has_value());
    EXPECT(contact.wrench(input, wrench) == WRC_OK);
    wrc_contact* both[] = {contact.get(), left->get()};
    std::array<wrc_wrench, 2> wrenches{wrc::defaults<wrc_wrench>(), wrc::defaults<wrc_wrench>()};
    std::array<std::int32_t, 2> statuses{};
    EXPECT(wrc::contact_wrench_batch(both, wrc::span<const wrc_wheel_input>(&input, 1), wrenches, statuses) ==
           WRC_OK);
    EXPECT(wrenches[0].force[1] == wrench.force[1] &&
           wrenches[1].force[1] == left->try_wrench(input)->force[1]);
    EXPECT(wrc::contact_wrench_batch(both, wrc::span<const wrc_wheel_input>(&input, 1),
                                     wrc::span<wrc_wrench>(wrenches.data(), 1), {}) == WRC_ERROR_BUFFER);

    // memory of the caller's own
    std::uint64_t size = 0, alignment = 0;
    EXPECT(model.contact_size(size, alignment) == WRC_OK);
    memory_alignment = alignment;
    void* memory = ::operator new(static_cast<std::size_t>(size), std::align_val_t(alignment));
    auto placed = wrc::contact_ref::init(model, WRC_SIDE_RIGHT,
                                         {static_cast<std::byte*>(memory), static_cast<std::size_t>(size)});
    EXPECT(placed && placed->try_wrench(input)->force[1] == wrench.force[1]);
    sentence = {};
    EXPECT(!wrc::contact_ref::init(model, WRC_SIDE_RIGHT, {static_cast<std::byte*>(memory), 8}, sentence) &&
           std::strstr(sentence.data(), "wrc_contact_init"));
    ::operator delete(memory, std::align_val_t(alignment));

    // handing over
    wrc_contact* raw = contact.release();
    EXPECT(raw && !contact);
    wrc_contact_destroy(raw);
  }
  EXPECT(alive == 0);
  wrc_config wrong = usual();
  wrong.wheel_material.shear_modulus = 80.0;
  std::array<char, 300> sentence{};
  EXPECT(wrc::model::make(wrong).error() == WRC_ERROR_RANGE);
  EXPECT(!wrc::model::make(wrong, sentence) && std::strstr(sentence.data(), "wheel_material.shear_modulus"));
  const auto coefficients = wrc::try_linear_coefficients(1.0, 0.0, 0.25);
  EXPECT(coefficients && coefficients->c11 > 4.0 && coefficients->c11 < 4.3);
  rolls_on();
}

// First tries of a wheel's motion: the right force, or a sentence.
void motions() {
  wrc_config config = usual();
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  auto model = wrc::model::make(config);
  EXPECT(model.has_value());
  auto contact = wrc::contact::make(*model, WRC_SIDE_RIGHT);
  EXPECT(contact.has_value());
  wrc_wheel_input input = wrc_wheel_input_default();
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  input.friction.coefficient = 0.35;
  input.wheel.velocity[0] = 20.0;
  const wrc_wheel_input straight = input;
  const double yaw = 5e-3, rolling = -20.0 / 0.46, sine = std::sin(yaw), cosine = std::cos(yaw);
  const auto right = [&] {
    const auto wrench = contact->try_wrench(input);
    return wrench && wrench->flag == WRC_OK && std::fabs(wrench->force[1] - 24.84e3) < 10.0 &&
           std::fabs(wrench->power - 2779.0) < 1.0;
  };
  std::array<char, 300> sentence{};
  const auto refused = [&](const char* words) {
    return contact->try_wrench(input).error() == WRC_ERROR_RANGE && contact->last_error(sentence) == WRC_OK &&
           std::strstr(sentence.data(), words);
  };
  input.wheel.yaw = yaw;
  input.wheel.angular_velocity[1] = rolling;
  EXPECT(refused("WRC_AXES_TRACK") && std::strstr(sentence.data(), "WRC_AXES_BODY"));
  input.wheel.angular_axes = WRC_AXES_BODY;
  EXPECT(right());
  input = straight;
  input.wheel.yaw = yaw;
  input.wheel.pitch_rate = rolling;
  EXPECT(right());

  // by columns, as Eigen's data() has it
  const double columns[9] = {cosine, sine, 0.0, -sine, cosine, 0.0, 0.0, 0.0, 1.0};
  input.wheel.yaw = 0.0;
  std::memcpy(input.wheel.rotation, columns, sizeof columns);
  EXPECT(refused("WRC_ORIENTATION_COLUMNS"));
  input.wheel.orientation = WRC_ORIENTATION_COLUMNS;
  EXPECT(right());
  input.wheel.pitch_rate = 0.0;
  input.wheel.angular_axes = WRC_AXES_TRACK;
  input.wheel.angular_velocity[0] = -sine * rolling;
  input.wheel.angular_velocity[1] = cosine * rolling;
  EXPECT(right());
  input.wheel.orientation = WRC_ORIENTATION_ROWS;
  const auto transposed = contact->try_wrench(input);
  EXPECT(transposed && transposed->flag == WRC_FLAG_ROTATION_TRANSPOSED);

  input = straight;  // over a rail at rest, 1 mrad aslant
  input.wheel.pitch_rate = rolling;
  input.rail.y_slope = 1e-3;
  const auto aslant = contact->try_wrench(input);
  EXPECT(aslant && std::fabs(aslant->force[1]) < 500.0);
}

#ifdef WRC_EXCEPTIONS
template <class Call>
void fails(std::int32_t why, const char* sentence, const Call& call, int line) {
  try {
    call();
    expect(false, "throws", line);
  } catch (const wrc::error& error) {
    expect(error.why() == why && std::strstr(error.what(), sentence), error.what(), line);
  }
}

void exceptions() {
  wrc_config config = usual();
  wrc::check(wrc::config_use(config, "FASTSIM-SDEC", {}));
  wrc::model model(config);
  wrc::contact contact(model, WRC_SIDE_RIGHT);
  const auto wrench = contact.wrench(usual_input());
  EXPECT(wrench.force[2] < 0.0 && contact.field(0, WRC_FIELD_SLIP_X).strips() > 10);
  EXPECT(contact.region(0).area > 0.0 && contact.temperature(0).at_entry == 20.0);
  EXPECT(model.profile(WRC_SIDE_LEFT, WRC_BODY_WHEEL).y.size() > 100);
  EXPECT(wrc::shakedown_limit(0.1) > 1.0 && model.contact_state_size() > 1000);
  contact = wrc::contact(model, WRC_SIDE_LEFT);
  wrc_wheel_input wrong = usual_input();
  wrong.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  wrong.vertical_load = 80.0;
  const int before = news;
  fails(
      WRC_ERROR_RANGE, "did you pass kN?", [&] { static_cast<void>(contact.wrench(wrong)); }, __LINE__);
  fails(
      WRC_ERROR_RANGE, "input.vertical_load",
      [&] {
        auto output = wrc::defaults<wrc_wrench>();
        contact.check(contact.wrench(wrong, output));
      },
      __LINE__);
  config.wheel_material.poisson = 0.7;
  fails(
      WRC_ERROR_RANGE, "config.wheel_material.poisson", [&] { const wrc::model none(config); }, __LINE__);
  fails(
      WRC_ERROR_UNSUPPORTED, "side", [&] { const wrc::contact none(model, 2); }, __LINE__);
  EXPECT(news == before);
  EXPECT(wrc::try_shakedown_limit(-1.0).error() == WRC_ERROR_RANGE);
}
#endif

}  // namespace

int main() {
  structs();
  values();
  motions();
#ifdef WRC_EXCEPTIONS
  exceptions();
  const char* exceptions_are = "with exceptions";
#else
  const char* exceptions_are = "without exceptions";
#endif
#ifdef __cpp_lib_expected
  const char* expected_is = "std::expected";
#else
  const char* expected_is = "own expected";
#endif
#ifdef __cpp_lib_span
  const char* span_is = "std::span";
#else
  const char* span_is = "own span";
#endif
  std::printf("C++%ld, %s, %s, %s: %d checks, %d failed\n", __cplusplus / 100, span_is, expected_is,
              exceptions_are, checks, failures);
  return failures != 0;
}
