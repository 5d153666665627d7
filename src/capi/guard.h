// The border: every function of the C API is one call of guard(), which turns exceptions into status codes; of
// translate() where a handle needs no use (capi/use.h).
#pragma once

#include <pthread.h>

#include <array>

#include "base/fail.h"
#include "base/processor.h"
#include "mimo/experimental.h"

namespace mimo::capi {

// The MIMO_E_ constant that came last; they have no gaps.
constexpr mimo_status kLastStatus = MIMO_E_END;

// Plain bytes, because keeping a message must work when memory is out, and needs no destructor when a thread ends.
using Message = std::array<char, 1024>;

// What the last failed call on a thread left behind.
struct LastError {
  mimo_status status = MIMO_OK;
  Message text = {};
};

const LastError& last_error() noexcept;

// Keeps the message for this thread, and with the handle, if there is one, for other threads.
mimo_status report(const void* handle, Status status, const char* message) noexcept;

// A function of the user's runs: what it leaves behind is its own. Afterwards the thread knows what it knew before.
class FreshError {
 public:
  FreshError() noexcept;
  ~FreshError();
  FreshError(const FreshError&) = delete;
  FreshError& operator=(const FreshError&) = delete;

 private:
  LastError before_;
};

// A call that has begun is finished: to cancel a thread unwinds it by force, which nothing here would survive. It is
// cancelled when it leaves.
class Uncancelled {
 public:
  Uncancelled() noexcept { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_); }
  ~Uncancelled() { pthread_setcancelstate(before_, nullptr); }
  Uncancelled(const Uncancelled&) = delete;
  Uncancelled& operator=(const Uncancelled&) = delete;

 private:
  int before_ = PTHREAD_CANCEL_ENABLE;
};

// `handle` is the one that the function was given first, null for those that take none. Functions that use a handle go
// through capi/use.h.
template <typename Body>
mimo_status translate(const void* handle, Body&& body) noexcept {
  const Uncancelled until_the_end;
  const PlainFloats plain;
  mimo_status status = MIMO_OK;
  caught(body, [&](Status failure, const char* text) { status = report(handle, failure, text); });
  return status;
}

template <typename Body>
mimo_status guard(Body&& body) noexcept {
  return translate(nullptr, body);
}

}  // namespace mimo::capi
