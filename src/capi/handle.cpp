#include "capi/handle.h"

#include <pthread.h>

#include <atomic>
#include <mutex>

namespace mimo::capi {
namespace {

constexpr unsigned kMagic = 0x6d696d6fu;  // "mimo"

struct Control {
  unsigned magic;
  HandleKind kind;
  unsigned generation;        // of forks, when it was made
  std::atomic<void*> object;  // null once retired
  Control* next;              // all control blocks, so that leak checkers see them
};

std::atomic<Control*> all_controls{nullptr};

// Counts forks on the child's side: handles of the parent have an older number.
std::atomic<unsigned> fork_generation{0};

void watch_forks() {
  static std::once_flag once;
  std::call_once(once, [] { pthread_atfork(nullptr, nullptr, [] { fork_generation.fetch_add(1); }); });
}

const char* word(HandleKind kind) {
  switch (kind) {
    case HandleKind::kScene: return "mimo_scene";
    case HandleKind::kEnv: return "mimo_env";
    case HandleKind::kBatch: return "mimo_batch";
    case HandleKind::kSenses: return "mimo_senses";
  }
  return "handle";
}

// Neither null nor of another kind nor another process's.
const Control* sound(const void* handle, HandleKind kind) noexcept {
  const auto* control = static_cast<const Control*>(handle);
  if (control == nullptr || control->magic != kMagic || control->kind != kind) return nullptr;
  return control->generation == fork_generation.load() ? control : nullptr;
}

}  // namespace

void* make_handle(HandleKind kind, void* object) {
  watch_forks();
  auto* control = new Control{kMagic, kind, fork_generation.load(), {object}, all_controls.load()};
  while (!all_controls.compare_exchange_weak(control->next, control)) {
  }
  return control;
}

void* open_handle(const void* handle, HandleKind kind, const char* argument) {
  if (handle == nullptr) fail(Status::kInvalidArgument, "{} is NULL, expected a {}", argument, word(kind));
  const auto* control = static_cast<const Control*>(handle);
  if (control->magic != kMagic || control->kind != kind) {
    fail(Status::kBadHandle, "{} is not a {}", argument, word(kind));
  }
  if (control->generation != fork_generation.load()) {
    fail(Status::kForked, "{} was made before fork(); make a new one in the child process", argument);
  }
  void* object = control->object.load();
  if (object == nullptr) fail(Status::kBadHandle, "{} is a {} that has been destroyed", argument, word(kind));
  return object;
}

void* retire_handle(void* handle, HandleKind kind) noexcept {
  return sound(handle, kind) == nullptr ? nullptr : static_cast<Control*>(handle)->object.exchange(nullptr);
}

void* peek_handle(const void* handle, HandleKind kind) noexcept {
  const Control* control = sound(handle, kind);
  return control == nullptr ? nullptr : control->object.load();
}

}  // namespace mimo::capi
