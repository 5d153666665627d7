// Opaque handles. A handle points to a small control block that is given back only with the library, so that a
// destroyed or wrong-type handle is recognised instead of crashing the host.
#pragma once

#include <memory>

#include "base/fail.h"
#include "base/processor.h"
#include "capi/guard.h"

namespace mimo::capi {

enum class HandleType : unsigned {
  kScene = 1,
  kEnv = 2,
  kBatch = 3,
  kSenses = 4,
  kLayout = 5,
  kRecorder = 6,
  kRecording = 7,
  kStage = 8
};

// Makes a handle that owns the object.
void* make_handle(HandleType type, void* object);
// The object behind a handle. Throws Status::kBadHandle or kForked; `argument` names the parameter.
void* open_handle(const void* handle, HandleType type, const char* argument);
// The object behind a handle, or null for everything that open_handle refuses.
void* peek_handle(const void* handle, HandleType type) noexcept;
// Retires a handle and returns its object, or null for null, retired and foreign handles.
void* retire_handle(void* handle, HandleType type) noexcept;

// Keeps the message of a failed call with the handle that it was given; nothing where that is no handle in use.
void keep_message(const void* handle, const Message& message) noexcept;
// What was kept last, "" for nothing. Throws as open_handle.
Message message_of(const void* handle);

// Which calls on one handle get along: those that share it, or one alone. Of a batch further ones that work on one of
// its worlds, and so do not get along with those that share it and read all worlds; and guests, who use no world, or
// only read the one that they are in.
enum class Sharing { kShared, kAlone, kAtWork, kGuest };
// kNone: it is no handle of that type in use, which open_handle tells. kWithin: this thread is in a call that has the
// handle alone, so in a function that this call runs. kBusy: another call, as a rule another thread's, is in the way.
enum class Admission { kNone, kEntered, kWithin, kBusy };

// A call begins. What has kEntered has to leave. Throws Status::kBadHandle for a handle that is being destroyed.
Admission enter_handle(const void* handle, HandleType type, Sharing sharing, const char* argument);
// True if the handle was destroyed meanwhile and no other call uses it: the caller retires it and deletes its object.
bool leave_handle(const void* handle, Sharing sharing) noexcept;
// Whether this thread is in a call on any handle, so in a function that the call runs.
bool in_a_call() noexcept;
// No further call enters the handle. True if no call uses it: the caller retires it and deletes its object. Leaves
// alone what this thread is in, and what is kept for its owner.
bool condemn_handle(void* handle, HandleType type) noexcept;
// The handle goes with the call of this thread that has it alone.
void end_with_call(void* handle) noexcept;
// No call destroys the handle but its owner does, by await_nobody and retire_handle.
void keep_for_owner(void* handle) noexcept;
void await_nobody(void* handle) noexcept;

// What each public handle type stands for; specialised in objects.h.
template <typename Public>
struct HandleTraits;

template <typename Public>
using Object = typename HandleTraits<Public>::Type;

template <typename Public>
Public* wrap(std::unique_ptr<Object<Public>> object) {
  void* handle = make_handle(HandleTraits<Public>::kType, object.get());
  object.release();
  return static_cast<Public*>(handle);
}

template <typename Public>
Object<Public>& open(Public* handle) {
  using Traits = HandleTraits<Public>;
  auto& object = *static_cast<Object<Public>*>(open_handle(handle, Traits::kType, Traits::kName));
  require_access(object);
  return object;
}

template <typename Public>
const Object<Public>& open(const Public* handle) {
  return open(const_cast<Public*>(handle));
}

// Retires the handle, and destroys what it stands for.
template <typename Public>
void dispose(Public* handle) noexcept {
  delete static_cast<Object<Public>*>(retire_handle(handle, HandleTraits<Public>::kType));
}

// Leaves alone what a function runs for, and what others own. What another thread uses goes when its call returns.
template <typename Public>
void destroy(Public* handle) noexcept {
  const Uncancelled until_the_end;
  const PlainFloats plain;
  if (is_at_work_for(static_cast<const Object<Public>*>(peek_handle(handle, HandleTraits<Public>::kType)))) return;
  if (condemn_handle(handle, HandleTraits<Public>::kType)) dispose(handle);
}

}  // namespace mimo::capi
