#include <algorithm>

#include "capi/names.h"
#include "engine/physics.h"
#include "mimo/mimo.h"

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

const char* mimo_status_name(mimo_status status) noexcept {
  switch (status) {
    case MIMO_OK: return "MIMO_OK";
    case MIMO_E_INVALID_ARGUMENT: return "MIMO_E_INVALID_ARGUMENT";
    case MIMO_E_BAD_HANDLE: return "MIMO_E_BAD_HANDLE";
    case MIMO_E_BUFFER_TOO_SMALL: return "MIMO_E_BUFFER_TOO_SMALL";
    case MIMO_E_STRUCT_SIZE: return "MIMO_E_STRUCT_SIZE";
    case MIMO_E_NOT_FOUND: return "MIMO_E_NOT_FOUND";
    case MIMO_E_MODEL: return "MIMO_E_MODEL";
    case MIMO_E_SIMULATION: return "MIMO_E_SIMULATION";
    case MIMO_E_RENDER: return "MIMO_E_RENDER";
    case MIMO_E_UNSUPPORTED: return "MIMO_E_UNSUPPORTED";
    case MIMO_E_OUT_OF_MEMORY: return "MIMO_E_OUT_OF_MEMORY";
    case MIMO_E_FORKED: return "MIMO_E_FORKED";
    case MIMO_E_INTERNAL: return "MIMO_E_INTERNAL";
    case MIMO_E_FILE: return "MIMO_E_FILE";
    case MIMO_E_TASK: return "MIMO_E_TASK";
    case MIMO_E_BUSY: return "MIMO_E_BUSY";
    default: return "MIMO_E_UNKNOWN";
  }
}

}  // extern "C"
