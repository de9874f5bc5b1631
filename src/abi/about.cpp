/// Version of the library, how it was built, and the statuses by name.
#include "abi/message.hpp"
#include "base/instruction_set.hpp"
#include "wrc/wrc.h"

// A number or name of the preprocessor as text.
#define WRC_QUOTED(text) #text
#define WRC_TEXT_OF(name) WRC_QUOTED(name)
#define WRC_VERSION_TEXT \
  WRC_TEXT_OF(WRC_VERSION_MAJOR) "." WRC_TEXT_OF(WRC_VERSION_MINOR) "." WRC_TEXT_OF(WRC_VERSION_PATCH)
#define WRC_ITSELF "this is wrc " WRC_VERSION_TEXT ", interface " WRC_TEXT_OF(WRC_ABI_VERSION)

// WRC_COMMIT and WRC_FLAGS come from CMakeLists.txt.
#if defined(__clang__)
#define WRC_COMPILER "clang " __clang_version__
#else
#define WRC_COMPILER "gcc " __VERSION__
#endif
#define WRC_BUILD                                                                             \
  "wrc " WRC_VERSION_TEXT                                                                     \
  ", interface " WRC_TEXT_OF(WRC_ABI_VERSION) ", experimental interface " WRC_TEXT_OF(        \
      WRC_EXPERIMENTAL_VERSION) ", commit " WRC_COMMIT ", " WRC_COMPILER ", flags " WRC_FLAGS \
                                ", kernels for "                                              \
                                "this processor: "

extern "C" {

uint32_t wrc_version(void) {
  return WRC_VERSION_MAJOR * 65536U + WRC_VERSION_MINOR * 256U + WRC_VERSION_PATCH;
}

uint32_t wrc_abi_version(void) { return WRC_ABI_VERSION; }

const char* wrc_version_text(uint32_t requested) {
  if (requested == WRC_ABI_VERSION) return WRC_ITSELF ", the one asked for";
  if (requested < WRC_ABI_VERSION)
    return WRC_ITSELF
        "; an older one was asked for, which it does not serve: compile the program with the headers of this "
        "library (docs/interface_0_9.md says what changed), or ship the library it was compiled with";
  return WRC_ITSELF
      "; a newer one was asked for: ship the library that came with the headers the program was compiled "
      "with";
}

const char* wrc_build_info(void) {
  switch (wrc::best_instruction_set()) {
    case wrc::InstructionSet::avx512:
      return WRC_BUILD "AVX-512";
    case wrc::InstructionSet::avx2:
      return WRC_BUILD "AVX2";
    default:
      return WRC_BUILD "baseline";
  }
}

const char* wrc_status_name(int32_t status) { return wrc::abi::status_name(status); }
const char* wrc_status_text(int32_t status) { return wrc::abi::status_text(status); }

}  // extern "C"
