/// libFuzzer target: the bytes decide what hostile::play hands to the library.
#include <cstdio>
#include <cstdlib>

#include "play.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  hostile::Choices choices(bytes, size);
  const hostile::Verdict verdict = hostile::play(choices, {24});  // small, for many runs a second
  if (!verdict.broken.empty()) {
    std::fprintf(stderr, "%s\n", verdict.broken.c_str());
    std::abort();
  }
  return 0;
}
