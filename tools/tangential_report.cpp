/// Speed of the tangential methods, printed:
///     tangential_report speed [--json]             every method, grid and instruction set; ratios in one run
///     tangential_report solves METHOD SET WHAT N   N solves of one and nothing else, for a profiler;
///                                                  64 x 64 cells, WHAT: forces, fields or sensitivities
/// The patches are a dozen of the random double ellipses of the unit tests, from nearly full adhesion to full
/// slip. All variants take turns; a number is the fastest of many turns, which other programs cannot lower.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/instruction_set.hpp"
#include "tangential/methods/fastsim.hpp"
#include "tangential/methods/strip_fastsim.hpp"
#include "unit/tangential_patches.hpp"

namespace {

using namespace wrc;

constexpr int patches = 12;
const char* const set_names[] = {"baseline", "avx2", "avx512"};
const char* const what_names[] = {"forces", "fields", "sensitivities"};
enum What { forces, fields, sensitivities };

/// The patches on one grid for one instruction set.
class Patches {
 public:
  Patches(int strips, int cells, InstructionSet set)
      : table_(0.28), grid_(cells, set), traction_(4 * static_cast<std::size_t>(strips * cells) + line) {
    std::mt19937 random(17);
    for (int n = 0; n < patches; ++n) {
      const test::RandomCase c = test::random_case(random);
      strips_.push_back(test::sdec_strips(c.a, c.b, c.psi, c.normal_force, strips));
      contacts_.push_back({strips_.back().get(), c.a, c.b, c.psi, c.shear_modulus, &table_, &grid_.get(),
                           c.creepage, c.friction, tangential::TractionBound::parabolic});
    }
    const std::ptrdiff_t field = strips * cells;
    double* p = traction_.data();
    while (reinterpret_cast<std::uintptr_t>(p) % (line * sizeof *p) != 0) ++p;  // as a contact's fields lie
    fields_ = {p, p + field, p + 2 * field, p + 3 * field};
  }

  /// Solves them all; returns something that depends on the results.
  double solve(const std::string& method, What what) {
    double sum = 0.0;
    Fault fault;
    tangential::TangentialSensitivities derivatives;
    const tangential::TangentialFields wanted = what == fields ? fields_ : tangential::TangentialFields{};
    for (tangential::RollingContact& contact : contacts_) {
      contact.bound = method == "fastsim_sdec/elliptic" ? tangential::TractionBound::elliptic
                                                        : tangential::TractionBound::parabolic;
      const auto& solver = method == "strip_fastsim" ? tangential::strip_fastsim : tangential::fastsim;
      const tangential::TangentialForces f =
          solver(contact, wanted, fault, what == sensitivities ? &derivatives : nullptr);
      sum += f.fx + f.power_per_speed;
    }
    return sum;
  }

 private:
  static constexpr std::size_t line = 8;  ///< doubles in a line of the cache

  theory::SdecTable table_;
  test::OwnedGrid grid_;
  std::vector<double> traction_;
  tangential::TangentialFields fields_;
  std::vector<test::OwnedStrips> strips_;
  std::vector<tangential::RollingContact> contacts_;
};

const char* const methods[] = {"fastsim_sdec", "fastsim_sdec/elliptic", "strip_fastsim"};

std::vector<InstructionSet> sets_here() {
  std::vector<InstructionSet> sets;
  for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    if (set <= best_instruction_set()) sets.push_back(set);
  return sets;
}

struct Entry {
  std::string method;
  InstructionSet set;
  int size;
  What what;
  double best = 1e300;  // [s] for all patches
};

double cost(const std::vector<Entry>& entries, const std::string& method, InstructionSet set, int size,
            What what) {
  for (const Entry& e : entries)
    if (e.method == method && e.set == set && e.size == size && e.what == what) return e.best;
  return 0.0;
}

int speed(bool json) {
  std::vector<Entry> entries;
  std::map<std::pair<int, int>, std::unique_ptr<Patches>> all;
  for (int size : {32, 64}) {
    for (InstructionSet set : sets_here()) {
      all[{size, static_cast<int>(set)}] = std::make_unique<Patches>(size, size, set);
      for (const char* method : methods)
        for (What what : {forces, fields, sensitivities}) entries.push_back({method, set, size, what});
    }
  }
  volatile double sink = 0.0;
  for (int turn = 0; turn < 300; ++turn) {
    for (Entry& e : entries) {
      Patches& p = *all[{e.size, static_cast<int>(e.set)}];
      sink = p.solve(e.method, e.what);  // not timed: a step, too, finds its patch where it was just written
      const auto start = std::chrono::steady_clock::now();
      sink = p.solve(e.method, e.what);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      e.best = std::min(e.best, took.count());
    }
  }
  static_cast<void>(sink);
  std::printf("%-22s %-9s %5s %10s %8s %14s %7s %14s %12s\n", "method", "set", "grid", "us/patch", "ns/cell",
              "/fastsim_sdec", "fields", "sensitivities", "/widest set");
  std::string text;
  for (const Entry& e : entries) {
    if (e.what != forces) continue;
    const double patch = e.best / patches, cell = patch / (e.size * e.size);
    const auto of = [&](const std::string& method, InstructionSet set, What what) {
      return cost(entries, method, set, e.size, what);
    };
    const double ratio = e.best / of("fastsim_sdec", e.set, forces);
    const double with_fields = of(e.method, e.set, fields) / e.best;
    const double with_derivatives = of(e.method, e.set, sensitivities) / e.best;
    const double to_widest = e.best / of(e.method, best_instruction_set(), forces);
    const char* set = set_names[static_cast<int>(e.set)];
    std::printf("%-22s %-9s %2dx%2d %10.2f %8.2f %14.2f %7.2f %14.2f %12.2f\n", e.method.c_str(), set, e.size,
                e.size, patch * 1e6, cell * 1e9, ratio, with_fields, with_derivatives, to_widest);
    char row[400];
    std::snprintf(row, sizeof row,
                  "%s{\"method\": \"%s\", \"set\": \"%s\", \"grid\": %d, \"ns_per_cell\": %.4f, "
                  "\"to_fastsim_sdec\": %.4f, "
                  "\"with_fields\": %.4f, \"with_sensitivities\": %.4f, \"to_widest\": %.4f}",
                  text.empty() ? "" : ", ", e.method.c_str(), set, e.size, cell * 1e9, ratio, with_fields,
                  with_derivatives, to_widest);
    text += row;
  }
  if (json) std::printf("{\"speed\": [%s]}\n", text.c_str());
  return 0;
}

template <std::size_t n>
int index_of(const char* word, const char* const (&names)[n]) {
  for (std::size_t k = 0; k < n; ++k)
    if (std::strcmp(word, names[k]) == 0) return static_cast<int>(k);
  return -1;
}

int solves(char** words) {
  const int set = index_of(words[1], set_names), what = index_of(words[2], what_names);
  if (index_of(words[0], methods) < 0 || what < 0 || set < 0 ||
      set > static_cast<int>(best_instruction_set())) {
    std::fprintf(stderr, "no such method, instruction set or output\n");
    return 2;
  }
  Patches p(64, 64, static_cast<InstructionSet>(set));
  double sum = 0.0;
  for (int n = std::atoi(words[3]); n > 0; --n) sum += p.solve(words[0], static_cast<What>(what));
  std::printf("%g\n", sum);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc >= 2 && std::strcmp(argv[1], "speed") == 0)
    return speed(argc > 2 && std::strcmp(argv[2], "--json") == 0);
  if (argc == 6 && std::strcmp(argv[1], "solves") == 0) return solves(argv + 2);
  std::fprintf(stderr, "usage: tangential_report speed [--json] | solves METHOD SET WHAT N\n");
  return 2;
}
