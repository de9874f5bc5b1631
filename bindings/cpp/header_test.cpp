// wrc.hpp: handles own and move, statuses are values or exceptions, results have C's bits, nothing allocates.
// Compiled by every standard from C++17 on, with exceptions and without. Prints what it is made of.
#include <array>
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
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  return config;
}

wrc_planar_input usual_input() {
  wrc_planar_input input = wrc_planar_input_default();
  input.load.normal_force = 80e3;
  input.creepage.longitudinal = 0.5e-3;
  return input;
}

static_assert(!std::is_copy_constructible_v<wrc::contact> &&
              std::is_nothrow_move_constructible_v<wrc::contact>);
static_assert(!std::is_copy_constructible_v<wrc::model> && std::is_nothrow_move_assignable_v<wrc::model>);
static_assert(sizeof(wrc::contact) == sizeof(wrc_contact*) &&
              sizeof(wrc::contact_ref) == sizeof(wrc_contact*));

// Tractions of bodies that roll from rest grow.
void rolls_on() {
  wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
  problem.grid.nx = problem.grid.ny = 4;
  problem.grid.dx = problem.grid.dy = 1e-3;
  problem.grid.x0 = problem.grid.y0 = -1.5e-3;
  problem.creepage.longitudinal = 1e-3;
  const std::vector<double> pressure(16, 1e9);
  problem.pressure = pressure.data();
  wrc_exact_rolling_solution solution = wrc_exact_rolling_solution_default();
  auto made = wrc::transient::make(problem.grid, problem.materials);
  EXPECT(made.has_value());
  wrc::transient bodies(std::move(*made));
  EXPECT(bodies.step(problem, solution) == WRC_OK);
  const double first = solution.fx;
  EXPECT(bodies.step(problem, solution) == WRC_OK && solution.fx < first && first < 0.0);
  problem.grid.nx = 0;
  EXPECT(wrc::transient::make(problem.grid, problem.materials).error() == WRC_ERROR_RANGE);
  EXPECT(wrc::transient().step(problem, solution) == WRC_ERROR_NULL);
}

void values() {
  wrc_allocator allocator = wrc_allocator_default();
  allocator.allocate = allocate;
  allocator.release = release;
  {
    auto made = wrc::model::make(usual(), &allocator);
    EXPECT(made.has_value());
    wrc::model model = std::move(*made);
    auto right = wrc::contact::make(model, WRC_SIDE_RIGHT, &allocator);
    EXPECT(right && alive == 2);
    wrc::contact contact = std::move(*right);
    EXPECT(contact && !*right);

    // what was moved from says so
    wrc_planar_output output = wrc_planar_output_default();
    EXPECT(right->step(usual_input(), output) == WRC_ERROR_NULL);

    // the C call's bits
    wrc_planar_output of_c = wrc_planar_output_default();
    const wrc_planar_input input = usual_input();
    EXPECT(wrc_planar_step(contact.get(), &input, &of_c) == WRC_OK);
    const int before = news;
    EXPECT(contact.step(input, output) == WRC_OK);
    EXPECT(std::memcmp(&output, &of_c, sizeof output) == 0);
    auto tried = contact.try_step(input);
    EXPECT(tried && tried->flag == WRC_OK && tried->forces.fx == of_c.forces.fx && of_c.forces.fx < 0.0);

    // a field, its rows and a field over strips
    auto pressure = contact.try_field(0, WRC_FIELD_PRESSURE);
    EXPECT(pressure.has_value());
    double most = 0.0;
    for (std::size_t i = 0; i < pressure->rows(); ++i) {
      const wrc::span<const double> row = pressure->row(i);
      EXPECT(row.size() == pressure->columns());
      for (std::size_t j = 0; j < row.size(); ++j) {
        EXPECT(row[j] == (*pressure)(i, j));
        if (row[j] > most) most = row[j];
      }
    }
    EXPECT(most > 0.8e9 && most < 0.9e9);
    auto peak = contact.try_field(0, WRC_FIELD_STRIP_PEAK);
    EXPECT(peak && peak->values().size() == static_cast<std::size_t>(of_c.normal.strips));
    EXPECT(!contact.try_field(7, WRC_FIELD_PRESSURE) &&
           contact.try_field(7, WRC_FIELD_PRESSURE).error() == WRC_ERROR_RANGE);

    // a flag is no failure, and comes with the answer
    wrc_planar_input apart = input;
    apart.load = wrc_planar_load_default();
    apart.load.prescribed = WRC_PRESCRIBE_APPROACH;
    apart.load.approach = -1e-6;
    auto away = contact.try_step(apart);
    EXPECT(away && away->flag == WRC_FLAG_NO_CONTACT && away->flag.flagged() && away->forces.fn == 0.0);

    // save and restore; sentences
    std::array<char, 300> sentence{};
    wrc_planar_input wrong = input;
    wrong.load.normal_force = 80.0;
    EXPECT(contact.try_step(wrong).error() == WRC_ERROR_RANGE);
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
    wrc_contact* both[] = {contact.get(), left->get()};
    wrc_wheel_input wheelset = wrc_wheel_input_default();
    wheelset.wheel.y = 1e-3;
    wheelset.wheel.z = 3e-4;
    wheelset.wheel.velocity[0] = 20.0;
    wheelset.wheel.angular_velocity[1] = -20.0 / 0.46;
    std::array<wrc_wrench, 2> wrenches{wrc_wrench_default(), wrc_wrench_default()};
    std::array<std::int32_t, 2> statuses{};
    const wrc::span<const wrc_wheel_input> one_for_all(&wheelset, 1);
    EXPECT(wrc::contact_wrench_batch(both, one_for_all, wrenches, statuses) == WRC_OK);
    EXPECT(wrenches[0].force[1] == contact.try_wrench(wheelset)->force[1] &&
           wrenches[1].force[1] == left->try_wrench(wheelset)->force[1] &&
           wrenches[0].force[1] != wrenches[1].force[1]);
    EXPECT(wrc::contact_wrench_batch(both, one_for_all, wrc::span<wrc_wrench>(wrenches.data(), 1), {}) ==
           WRC_ERROR_BUFFER);

    // memory of the caller's own
    std::uint64_t size = 0, alignment = 0;
    EXPECT(model.contact_size(size, alignment) == WRC_OK);
    memory_alignment = alignment;
    void* memory = ::operator new(static_cast<std::size_t>(size), std::align_val_t(alignment));
    auto placed = wrc::contact_ref::init(model, WRC_SIDE_RIGHT,
                                         {static_cast<std::byte*>(memory), static_cast<std::size_t>(size)});
    EXPECT(placed && placed->try_step(input)->forces.fx == of_c.forces.fx);
    ::operator delete(memory, std::align_val_t(alignment));

    // handing over
    wrc_contact* raw = contact.release();
    EXPECT(raw && !contact);
    wrc_contact_destroy(raw);
  }
  EXPECT(alive == 0);
  wrc_config wrong = usual();
  wrong.wheel_material.shear_modulus = wrong.rail_material.shear_modulus = 80.0;
  EXPECT(!wrc::model::make(wrong) && wrc::model::make(wrong).error() == WRC_ERROR_RANGE);
  const auto coefficients = wrc::try_linear_coefficients(1.0, 0.0, 0.25);
  EXPECT(coefficients && coefficients->c11 > 4.0 && coefficients->c11 < 4.3);
  rolls_on();
}

#ifdef WRC_EXCEPTIONS
void exceptions() {
  wrc_config config = usual();
  wrc::check(wrc::config_use(config, "FASTSIM-SDEC", {}));
  wrc::model model(config);
  wrc::contact contact(model, WRC_SIDE_RIGHT);
  EXPECT(contact.step(usual_input()).forces.fx < 0.0 && contact.field(0, WRC_FIELD_SLIP_X).rows() == 32);
  EXPECT(wrc::shakedown_limit(0.1) > 1.0 && model.contact_state_size() > 1000);
  contact = wrc::contact(model, WRC_SIDE_LEFT);
  wrc_planar_input wrong = usual_input();
  wrong.load.normal_force = 80.0;
  const int before = news;
  try {
    static_cast<void>(contact.step(wrong));
    expect(false, "throws", __LINE__);
  } catch (const wrc::error& error) {
    EXPECT(error.why() == WRC_ERROR_RANGE && std::strstr(error.what(), "did you pass kN?"));
  }
  try {
    wrc_planar_output output = wrc_planar_output_default();
    contact.check(contact.step(wrong, output));
    expect(false, "throws", __LINE__);
  } catch (const std::exception& error) {
    EXPECT(std::strstr(error.what(), "input.load.normal_force"));
  }
  config.wheel_material.poisson = config.rail_material.poisson = 0.7;
  try {
    const wrc::model none(config);
    expect(false, "throws", __LINE__);
  } catch (const wrc::error& error) {
    EXPECT(std::strstr(error.what(), "config.material.poisson"));
  }
  EXPECT(news == before);
  EXPECT(wrc::try_shakedown_limit(-1.0).error() == WRC_ERROR_RANGE);
}
#endif

}  // namespace

int main() {
  values();
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
