// How threads get along on one handle. Functions that take a const handle share it, others need it alone; a call that
// finds another thread in its way answers Status::kBusy and does nothing. Functions of the host's that a call runs (of
// a task, of the log) may use that call's handle: to read it, and where it lends() itself.
#pragma once

#include <type_traits>

#include "base/fail.h"
#include "capi/guard.h"
#include "capi/objects.h"

namespace mimo::capi {

// A call uses a handle as long as this lives. Says nothing of what is no handle in use: that is open()'s.
template <typename Public>
class Use {
 public:
  explicit Use(Public* handle, Sharing sharing = std::is_const_v<Public> ? Sharing::kShared : Sharing::kAlone)
      : handle_(handle), sharing_(sharing), entry_(enter(handle, sharing)) {
    if (entry_ == Admission::kEntered) enter_whole();
    if (entry_ == Admission::kWithin) require_lent();
    if (entry_ == Admission::kBusy) require_work();
  }

  ~Use() {
    if (entry_ != Admission::kEntered) return;
    const void* const whole = whole_;
    if (leave_handle(handle_, sharing_)) dispose(const_cast<std::remove_const_t<Public>*>(handle_));
    if (whole != nullptr && leave_handle(whole, of_whole())) {
      dispose(static_cast<mimo_batch*>(const_cast<void*>(whole)));
    }
  }

  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  using Traits = HandleTraits<std::remove_const_t<Public>>;
  static constexpr HandleType kType = Traits::kType;
  static constexpr const char* kName = Traits::kName;

  const typename Traits::Type* object() const {
    return static_cast<const typename Traits::Type*>(peek_handle(handle_, kType));
  }

  static Admission enter(Public* handle, Sharing sharing) {
    if (sharing == Sharing::kAlone) {
      require_changeable(static_cast<const typename Traits::Type*>(peek_handle(handle, kType)));
    }
    return enter_handle(handle, kType, sharing, kName);
  }

  // The tasks of a batch run on threads of its own.
  void require_work() const {
    if (is_at_work_for(object())) return;
    fail(Status::kBusy,
         "{} is in use by another thread{}; only calls that read it (const in the header) may run together", kName,
         in_a_call() ? ", or by the call that runs this function" : "");
  }

  // Different threads use worlds of a batch while no call has exclusive use of the batch.
  void enter_whole() {
    const void* const whole = whole_of(object());
    if (whole == nullptr) return;
    try {
      const Admission entry = enter_handle(whole, HandleType::kBatch, of_whole(), "the batch of env");
      if (entry == Admission::kEntered) whole_ = whole;
      if (entry == Admission::kBusy) {
        fail(Status::kBusy, "{} is a world of a batch that is at work, or in use by another thread", kName);
      }
    } catch (...) {
      leave_handle(handle_, sharing_);
      throw;
    }
  }

  void require_lent() const {
    if (sharing_ != Sharing::kAlone || lends(object()) || is_at_work_for(object())) return;
    fail(Status::kBusy, "{} is in the call that runs this function, which may only read it", kName);
  }

  Sharing of_whole() const { return sharing_ == Sharing::kAlone ? Sharing::kAtWork : Sharing::kGuest; }

  Public* handle_;
  Sharing sharing_;
  Admission entry_;
  const void* whole_ = nullptr;  // of what is shared beside it
};

// The body of a function of the C API that takes a handle first.
template <typename Public, typename Body>
mimo_status guard(Public* handle, Body&& body) noexcept {
  return translate(handle, [&] {
    const Use<Public> use(handle);
    body();
  });
}

// Of one that uses no world of a batch.
template <typename Body>
mimo_status guard_guest(const mimo_batch* batch, Body&& body) noexcept {
  return translate(batch, [&] {
    const Use<const mimo_batch> use(batch, Sharing::kGuest);
    body();
  });
}

}  // namespace mimo::capi
