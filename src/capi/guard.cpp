#include "capi/guard.h"

#include <cstdio>

namespace mimo::capi {
namespace {

// Plain bytes: keeping a message must work when memory is out, and needs no destructor when a thread ends.
thread_local char last_error[1024] = "";

}  // namespace

void set_last_error(const char* message) noexcept { std::snprintf(last_error, sizeof last_error, "%s", message); }

mimo_status report(Status status, const char* message) noexcept {
  set_last_error(message);
  return static_cast<mimo_status>(status);
}

}  // namespace mimo::capi

extern "C" const char* mimo_last_error(void) noexcept { return mimo::capi::last_error; }
