/// Thousands of hostile cases from a fixed seed.
///   hostile_test [seconds [cases]]               as many as fit, at most `cases` (default `most_cases`)
///   hostile_test seconds cases finest calls first   many inputs: grids up to finest x finest, up to `calls`
///                                                   calls on each contact, from case `first` on
///   hostile_test --case NUMBER [finest calls]    one of them, to debug it
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "play.hpp"

namespace {

constexpr std::uint64_t seed = 20160424;
constexpr long most_cases = 20000;
// The hard bound of a call at the largest grid (512 x 512 cells, 4096 rows); an instrumented build on a busy
// machine is a hundred times slower than a release build alone.
constexpr double longest_call = 120.0;  // [s]

struct Size {
  std::int32_t finest = 512;
  std::uint32_t calls = 5;
};

hostile::Verdict play(long number, const Size& size) {
  hostile::Choices choices(seed + static_cast<std::uint64_t>(number) * 1000003U);
  return hostile::play(choices, size.finest, size.calls);
}

}  // namespace

int main(int argc, char** argv) {
  Size size;
  if (argc > 4) size = {std::atoi(argv[3]), static_cast<std::uint32_t>(std::atol(argv[4]))};
  if (argc > 2 && std::strcmp(argv[1], "--case") == 0) {
    const hostile::Verdict verdict = play(std::atol(argv[2]), size);
    std::printf("%s\n", verdict.broken.empty() ? "holds" : verdict.broken.c_str());
    return verdict.broken.empty() ? 0 : 1;
  }
  const double seconds = argc > 1 ? std::atof(argv[1]) : 20.0;
  const long limit = argc > 2 ? std::atol(argv[2]) : most_cases;
  const long first = argc > 5 ? std::atol(argv[5]) : 0;
  const auto start = std::chrono::steady_clock::now();
  long cases = 0, models = 0, calls = 0, solved = 0, failed = 0;
  double slowest = 0.0;
  for (; cases < limit; ++cases) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    if (spent.count() > seconds) break;
    hostile::Verdict verdict = play(first + cases, size);
    if (verdict.broken.empty() && verdict.slowest_call > longest_call)
      verdict.broken = "a call took too long";
    models += verdict.model_made;
    calls += verdict.calls;
    solved += verdict.solved;
    slowest = std::max(slowest, verdict.slowest_call);
    if (!verdict.broken.empty()) {
      ++failed;
      std::printf("case %ld: %s\n", first + cases, verdict.broken.c_str());
      std::fflush(stdout);
    }
  }
  std::printf(
      "%ld cases, %ld models accepted, %ld hostile calls, %ld of all calls with forces, slowest call %.3f "
      "s\n",
      cases, models, calls, solved, slowest);
  // Mostly refusals would prove nothing.
  if (cases >= 100 && (models < cases / 3 || solved < cases)) {
    std::printf("the cases are refused too often to mean anything\n");
    ++failed;
  }
  std::printf("%ld passed, %ld failed\n", cases - std::min(failed, cases), failed);
  return failed == 0 ? 0 : 1;
}
