/* Versions, names of statuses, the last error before anything failed. */
#include "support/capi.h"

int main(void) {
  char version[32];
  CHECK_TEXT("", mimo_last_error());
  CHECK(mimo_abi_version() == MIMO_ABI_VERSION);
  CHECK(mimo_api_version() == MIMO_API_MAJOR * 1000 + MIMO_API_MINOR);
  sprintf(version, "%d.%d.%d%s", MIMO_VERSION_MAJOR, MIMO_VERSION_MINOR, MIMO_VERSION_PATCH, MIMO_VERSION_LABEL);
  CHECK_TEXT(version, mimo_version());
  CHECK(strncmp(mimo_mujoco_version(), "2.2.", 4) == 0 || strncmp(mimo_mujoco_version(), "4.0.", 4) == 0);
  CHECK_TEXT("MIMO_OK", mimo_status_name(MIMO_OK));
  CHECK_TEXT("MIMO_E_INVALID_ARGUMENT", mimo_status_name(MIMO_E_INVALID_ARGUMENT));
  CHECK_TEXT("MIMO_E_BAD_HANDLE", mimo_status_name(MIMO_E_BAD_HANDLE));
  CHECK_TEXT("MIMO_E_BUFFER_TOO_SMALL", mimo_status_name(MIMO_E_BUFFER_TOO_SMALL));
  CHECK_TEXT("MIMO_E_STRUCT_SIZE", mimo_status_name(MIMO_E_STRUCT_SIZE));
  CHECK_TEXT("MIMO_E_NOT_FOUND", mimo_status_name(MIMO_E_NOT_FOUND));
  CHECK_TEXT("MIMO_E_MODEL", mimo_status_name(MIMO_E_MODEL));
  CHECK_TEXT("MIMO_E_SIMULATION", mimo_status_name(MIMO_E_SIMULATION));
  CHECK_TEXT("MIMO_E_RENDER", mimo_status_name(MIMO_E_RENDER));
  CHECK_TEXT("MIMO_E_UNSUPPORTED", mimo_status_name(MIMO_E_UNSUPPORTED));
  CHECK_TEXT("MIMO_E_OUT_OF_MEMORY", mimo_status_name(MIMO_E_OUT_OF_MEMORY));
  CHECK_TEXT("MIMO_E_FORKED", mimo_status_name(MIMO_E_FORKED));
  CHECK_TEXT("MIMO_E_INTERNAL", mimo_status_name(MIMO_E_INTERNAL));
  CHECK_TEXT("MIMO_E_FILE", mimo_status_name(MIMO_E_FILE));
  CHECK_TEXT("MIMO_E_TASK", mimo_status_name(MIMO_E_TASK));
  CHECK_TEXT("MIMO_E_BUSY", mimo_status_name(MIMO_E_BUSY));
  CHECK_TEXT("MIMO_E_UNKNOWN", mimo_status_name(-16));
  CHECK_TEXT("MIMO_E_UNKNOWN", mimo_status_name(1));
  CHECK_TEXT("", mimo_last_error());
  return failures();
}
