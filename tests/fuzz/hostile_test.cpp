/// Thousands of hostile cases from a fixed seed.
///   hostile_test [seconds [cases]]               as many as fit, at most `cases` (default `most_cases`)
///   hostile_test --many INPUTS [FIRST]           that many inputs, on small grids with few long calls, from
///                                                case FIRST on, with a line now and then from which to go on
///   hostile_test --case NUMBER [many]            one of them, to debug it
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "play.hpp"

namespace {

constexpr std::uint64_t seed = 20160424;
constexpr long most_cases = 20000;
// The hard bound of a call at the largest grid (512 x 512 cells, 4096 rows); an instrumented build
// is ten to thirty times slower than a release build.
constexpr double longest_call = 120.0;  // [s]

/// What --many plays.
constexpr hostile::Size many = {8, 200, true};

hostile::Verdict play(long number, const hostile::Size& size) {
  hostile::Choices choices(seed + static_cast<std::uint64_t>(number) * 1000003U);
  return hostile::play(choices, size);
}

/// What was played so far.
struct Count {
  long cases = 0, models = 0, inputs = 0, solved = 0, failed = 0;
  double slowest = 0.0;  ///< [s]

  void add(long number, hostile::Verdict verdict) {
    if (verdict.broken.empty() && verdict.slowest_call > longest_call)
      verdict.broken = "a call took too long";
    ++cases;
    models += verdict.model_made;
    inputs += verdict.inputs;
    solved += verdict.solved;
    slowest = std::max(slowest, verdict.slowest_call);
    if (verdict.broken.empty()) return;
    ++failed;
    std::printf("case %ld: %s\n", number, verdict.broken.c_str());
  }
  void print() const {
    std::printf(
        "%ld cases, %ld models accepted, %ld hostile inputs, %ld calls with forces, slowest call %.3f s\n",
        cases, models, inputs, solved, slowest);
    std::fflush(stdout);
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::strcmp(argv[1], "--case") == 0) {
    const hostile::Verdict verdict = play(std::atol(argv[2]), argc > 3 ? many : hostile::Size{});
    std::printf("%s\n", verdict.broken.empty() ? "holds" : verdict.broken.c_str());
    return verdict.broken.empty() ? 0 : 1;
  }
  Count count;
  if (argc > 2 && std::strcmp(argv[1], "--many") == 0) {
    const long inputs = std::atol(argv[2]);
    long next = argc > 3 ? std::atol(argv[3]) : 0;
    for (; count.inputs < inputs; ++next) {
      count.add(next, play(next, many));
      if (count.cases % 50 != 0) continue;
      std::printf("next case %ld: ", next + 1);
      count.print();
    }
  } else {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 20.0;
    const long limit = argc > 2 ? std::atol(argv[2]) : most_cases;
    const auto start = std::chrono::steady_clock::now();
    while (count.cases < limit) {
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      if (spent.count() > seconds) break;
      count.add(count.cases, play(count.cases, {}));
    }
  }
  count.print();
  // Mostly refusals would prove nothing.
  if (count.cases >= 100 && (count.models < count.cases / 3 || count.solved < count.cases)) {
    std::printf("the cases are refused too often to mean anything\n");
    ++count.failed;
  }
  std::printf("%ld passed, %ld failed\n", count.cases - std::min(count.failed, count.cases), count.failed);
  return count.failed == 0 ? 0 : 1;
}
