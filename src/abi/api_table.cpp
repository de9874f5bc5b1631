/// The function tables for hosts that load the library with dlopen.
#include "wrc/wrc_api.h"
#include "wrc/wrc_experimental_api.h"

extern "C" const wrc_api* wrc_get_api(uint32_t abi_version) {
  // Constant-initialised: no constructor runs when the library is loaded.
  static constexpr wrc_api table = {
      sizeof(wrc_api),
      WRC_ABI_VERSION,
#include "abi/generated/api_functions.inc"
  };
  return abi_version == WRC_ABI_VERSION ? &table : nullptr;
}

extern "C" const wrc_experimental_api* wrc_get_experimental_api(uint32_t experimental_version) {
  static constexpr wrc_experimental_api table = {
      sizeof(wrc_experimental_api),
      WRC_EXPERIMENTAL_VERSION,
#include "abi/generated/experimental_api_functions.inc"
  };
  return experimental_version == WRC_EXPERIMENTAL_VERSION ? &table : nullptr;
}
