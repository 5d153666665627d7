// Opaque handles. A handle points to a small control block that is given back only with the library, so that a
// destroyed or wrong-type handle is recognised instead of crashing the host.
#pragma once

#include <memory>

#include "base/fail.h"
#include "base/floats.h"
#include "capi/guard.h"

namespace mimo::capi {

enum class HandleType : unsigned {
  kScene = 1,
  kEnv = 2,
  kBatch = 3,
  kSenses = 4,
  kLayout = 5,
  kRecorder = 6,
  kRecording = 7
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
bool may_destroy(Public* handle) noexcept {
  using Traits = HandleTraits<Public>;
  const auto* object = static_cast<const Object<Public>*>(peek_handle(handle, Traits::kType));
  return object != nullptr && is_destructible(*object);
}

template <typename Public>
const Object<Public>& open(const Public* handle) {
  return open(const_cast<Public*>(handle));
}

// Leaves alone what may not be destroyed now or by this call.
template <typename Public>
void destroy(Public* handle) noexcept {
  const Uncancelled until_the_end;
  const PlainFloats plain;
  if (!may_destroy(handle)) return;
  delete static_cast<Object<Public>*>(retire_handle(handle, HandleTraits<Public>::kType));
}

}  // namespace mimo::capi
