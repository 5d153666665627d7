/* Versions, names of statuses, the last error before anything failed. */
#include "support/capi.h"

/* A function, constants first and last by bytes, a struct, a member, and what merely resembles them. */
static const char* const known[] = {"mimo_env_step", "MIMO_ABI_VERSION", "mimo_version", "mimo_field",
                                    "mimo_field.period"};
static const char* const unknown[] = {"mimo_env_ste",
                                      "mimo_env_stepp",
                                      "MIMO_ENV_H",
                                      "MIMO_API",
                                      "MIMO_BODY_MAS",
                                      "mimo_field.",
                                      "mimo_field.x",
                                      "MIMO_ENV_STEP",
                                      "a",
                                      "zebra",
                                      "mimo_env",
                                      "struct_size",
                                      ""};

int main(void) {
  char version[32];
  size_t i;
  CHECK_TEXT("", mimo_last_error());
  CHECK(mimo_abi_version() == MIMO_ABI_VERSION);
  CHECK(mimo_api_version() == MIMO_API_MAJOR * 1000 + MIMO_API_MINOR);
  sprintf(version, "%d.%d.%d%s", MIMO_VERSION_MAJOR, MIMO_VERSION_MINOR, MIMO_VERSION_PATCH, MIMO_VERSION_LABEL);
  CHECK_TEXT(version, mimo_version());
  CHECK(strncmp(mimo_mujoco_version(), "2.2.", 4) == 0 || strncmp(mimo_mujoco_version(), "4.0.", 4) == 0);
  CHECK_TEXT("MIMO_OK", mimo_status_name(MIMO_OK));
  CHECK_TEXT("MIMO_E_INVALID_ARGUMENT", mimo_status_name(-1));
  CHECK_TEXT("MIMO_E_INTERNAL", mimo_status_name(-12));
  CHECK_TEXT("MIMO_E_UNKNOWN", mimo_status_name(-1000));
  CHECK_TEXT("MIMO_E_UNKNOWN", mimo_status_name(1));
  for (i = 0; i < sizeof known / sizeof *known; ++i) CHECK(mimo_supports(known[i]) == 1);
  for (i = 0; i < sizeof unknown / sizeof *unknown; ++i) CHECK(mimo_supports(unknown[i]) == 0);
  CHECK_TEXT("", mimo_last_error());
  return failures();
}
