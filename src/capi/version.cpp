#include <algorithm>

#include "capi/names.h"
#include "engine/physics.h"
#include "mimo/experimental.h"

#define MIMO_TEXT_OF(x) #x
#define MIMO_TEXT(x) MIMO_TEXT_OF(x)

extern "C" {

uint32_t mimo_abi_version(void) noexcept { return MIMO_ABI_VERSION; }

uint32_t mimo_api_version(void) noexcept { return MIMO_API_VERSION; }

int32_t mimo_supports(const char* name) noexcept {
  return name != nullptr &&
         std::binary_search(mimo::capi::kNames, mimo::capi::kNames + mimo::capi::kNameCount, std::string_view(name));
}

const char* mimo_version(void) noexcept {
  return MIMO_TEXT(MIMO_VERSION_MAJOR) "." MIMO_TEXT(MIMO_VERSION_MINOR) "." MIMO_TEXT(MIMO_VERSION_PATCH)
      MIMO_VERSION_LABEL;
}

const char* mimo_mujoco_version(void) noexcept { return mimo::engine::mujoco_version(); }

const char* mimo_status_name(mimo_status status) noexcept { return mimo::capi::name_of(status); }

}  // extern "C"
