// The border: every function of the C API is one call of guard(), which turns exceptions into status codes.
#pragma once

#include <exception>
#include <new>

#include "base/floats.h"
#include "base/status.h"
#include "mimo/mimo.h"

namespace mimo::capi {

// Keeps the message for mimo_last_error() on this thread, cut to its room; then it ends in "..."
void set_last_error(const char* message) noexcept;

mimo_status report(Status status, const char* message) noexcept;

template <typename Body>
mimo_status guard(Body&& body) noexcept {
  const PlainFloats plain;
  try {
    body();
    return MIMO_OK;
  } catch (const Error& error) {
    return report(error.status(), error.what());
  } catch (const std::bad_alloc&) {
    return report(Status::kOutOfMemory, "out of memory");
  } catch (const std::exception& error) {
    return report(Status::kInternal, error.what());
  } catch (...) {
    return report(Status::kInternal, "an unknown exception");
  }
}

}  // namespace mimo::capi
