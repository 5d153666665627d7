#include "capi/handle.h"

#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

#include "base/process.h"

namespace mimo::capi {
namespace {

constexpr unsigned kMagic = 0x6d696d6fu;  // "mimo"

struct Control {
  unsigned magic;
  HandleType type;
  unsigned generation;                       // of forks, when it was made
  std::atomic<void*> object;                 // null once retired
  std::atomic_flag busy = ATOMIC_FLAG_INIT;  // a thread is at the message
  std::unique_ptr<Message> message = {};     // of the last failed call; null once retired
  std::atomic<std::uint64_t> users{0};       // see below
  bool kept = false;                         // for its owner
};

// Who is in a call on a handle: one alone (the mark of its thread), or numbers of the others, each kind of which has
// its own bits. kEnding: it is being destroyed, and stays so.
using Users = std::uint64_t;
constexpr Users kAlone = 1, kEnding = 2, kOneShares = 1u << 2, kOneIsGuest = 1u << 22, kOneWorks = Users{1} << 42;
constexpr Users kSharing = kOneIsGuest - kOneShares, kWorking = 0 - kOneWorks;

Users one_of(Sharing sharing) {
  return sharing == Sharing::kShared ? kOneShares : sharing == Sharing::kGuest ? kOneIsGuest : kOneWorks;
}

bool is_in_the_way(Users users, Sharing sharing) {
  if ((users & kAlone) != 0) return true;
  switch (sharing) {
    case Sharing::kShared: return (users & kWorking) != 0;
    case Sharing::kAtWork: return (users & kSharing) != 0;
    case Sharing::kAlone: return users != 0;
    case Sharing::kGuest: return false;
  }
  return true;
}

// How many calls this thread is in.
thread_local unsigned long calls = 0;

// The mark of this thread.
Users own_mark() { return reinterpret_cast<std::uintptr_t>(&calls) | kAlone; }

// For a few instructions. A lock of the system's would stay locked in a child that is forked meanwhile; this one is
// part of a handle that the child refuses.
class AtMessage {
 public:
  explicit AtMessage(Control& control) : busy_(control.busy) {
    while (busy_.test_and_set(std::memory_order_acquire)) sched_yield();
  }
  ~AtMessage() { busy_.clear(std::memory_order_release); }
  AtMessage(const AtMessage&) = delete;
  AtMessage& operator=(const AtMessage&) = delete;

 private:
  std::atomic_flag& busy_;
};

// Room for many control blocks. They stay as long as the library: each by itself would lie among the large blocks of a
// world that goes, and no later world of that size would fit into the gap.
struct Drawer {
  static constexpr std::size_t kPlaces = 256;

  explicit Drawer(Drawer* full) : before(full) {}
  // Null where it is full.
  void* take() {
    const std::size_t place = taken.fetch_add(1);
    return place < kPlaces ? room + place * sizeof(Control) : nullptr;
  }

  Drawer* before;  // so that leak checkers see them all
  std::atomic<std::size_t> taken{0};
  alignas(Control) std::byte room[kPlaces * sizeof(Control)];
};

std::atomic<Drawer*> open_drawer{nullptr};

const AtUnload give_back([] {
  for (Drawer* drawer = open_drawer.exchange(nullptr); drawer != nullptr;) {
    const std::unique_ptr<Drawer> gone(drawer);
    drawer = gone->before;
  }
});

// Takes no lock, which a child could inherit from a thread that it does not have.
void* room_for_control() {
  for (;;) {
    Drawer* drawer = open_drawer.load();
    if (void* place = drawer == nullptr ? nullptr : drawer->take()) return place;
    watch_the_end();
    auto next = std::make_unique<Drawer>(drawer);
    if (open_drawer.compare_exchange_strong(drawer, next.get())) next.release();
  }
}

// Counts forks on the child's side: handles of the parent have an older number.
std::atomic<unsigned> fork_generation{0};

[[maybe_unused]] const int watching = watch_forks(nullptr, nullptr, [] { fork_generation.fetch_add(1); });

const char* word(HandleType type) {
  switch (type) {
    case HandleType::kScene: return "mimo_scene";
    case HandleType::kEnv: return "mimo_env";
    case HandleType::kBatch: return "mimo_batch";
    case HandleType::kSenses: return "mimo_senses";
    case HandleType::kLayout: return "mimo_layout";
    case HandleType::kRecorder: return "mimo_recorder";
    case HandleType::kRecording: return "mimo_recording";
    case HandleType::kStage: return "mimo_stage";
  }
  return "handle";
}

// A handle of any type; null for what is none, and for another process's.
Control* sound(const void* handle) noexcept {
  auto* control = static_cast<Control*>(const_cast<void*>(handle));
  if (control == nullptr || control->magic != kMagic) return nullptr;
  return control->generation == fork_generation.load() ? control : nullptr;
}

Control* sound(const void* handle, HandleType type) noexcept {
  Control* control = sound(handle);
  return control == nullptr || control->type != type ? nullptr : control;
}

void check_generation(const Control& control, const char* argument) {
  if (control.generation == fork_generation.load()) return;
  fail(Status::kForked, "{} was made before fork(); make a new one in the child process", argument);
}

[[noreturn]] void fail_destroyed(const Control& control, const char* argument) {
  fail(Status::kBadHandle, "{} is a {} that has been destroyed", argument, word(control.type));
}

}  // namespace

void* make_handle(HandleType type, void* object) {
  auto message = std::make_unique<Message>();
  auto* control = new (room_for_control()) Control{kMagic, type, fork_generation.load(), {object}};
  control->message = std::move(message);
  return control;
}

void* open_handle(const void* handle, HandleType type, const char* argument) {
  if (handle == nullptr) fail(Status::kInvalidArgument, "{} is NULL, expected a {}", argument, word(type));
  const auto* control = static_cast<const Control*>(handle);
  if (control->magic != kMagic || control->type != type) {
    fail(Status::kBadHandle, "{} is not a {}", argument, word(type));
  }
  check_generation(*control, argument);
  void* object = control->object.load();
  if (object == nullptr) fail_destroyed(*control, argument);
  return object;
}

void* retire_handle(void* handle, HandleType type) noexcept {
  Control* control = sound(handle, type);
  if (control == nullptr) return nullptr;
  std::unique_ptr<Message> freed;  // outside of the lock
  const AtMessage alone(*control);
  freed = std::move(control->message);
  return control->object.exchange(nullptr);
}

Admission enter_handle(const void* handle, HandleType type, Sharing sharing, const char* argument) {
  Control* control = sound(handle, type);
  if (control == nullptr) return Admission::kNone;
  const Users own = own_mark();
  Users users = 0;
  while (!control->users.compare_exchange_weak(users, sharing == Sharing::kAlone ? own : users + one_of(sharing),
                                               std::memory_order_acquire, std::memory_order_relaxed)) {
    if ((users & kEnding) != 0) fail_destroyed(*control, argument);
    if (users == own) return Admission::kWithin;
    if (is_in_the_way(users, sharing)) return Admission::kBusy;
  }
  ++calls;
  return Admission::kEntered;
}

bool in_a_call() noexcept { return calls > 0; }

bool leave_handle(const void* handle, Sharing sharing) noexcept {
  auto* control = static_cast<Control*>(const_cast<void*>(handle));
  --calls;
  if (sharing == Sharing::kAlone) {
    Users own = own_mark();
    return !control->users.compare_exchange_strong(own, 0, std::memory_order_acq_rel);
  }
  const Users one = one_of(sharing);
  return control->users.fetch_sub(one, std::memory_order_acq_rel) == (one | kEnding);
}

bool condemn_handle(void* handle, HandleType type) noexcept {
  Control* control = sound(handle, type);
  if (control == nullptr || control->kept) return false;
  const Users own = own_mark();
  Users users = 0;
  while (
      !control->users.compare_exchange_weak(users, (users == 0 ? own : users) | kEnding, std::memory_order_acq_rel)) {
    if ((users & kEnding) != 0 || users == own) return false;
  }
  return users == 0;
}

void end_with_call(void* handle) noexcept { static_cast<Control*>(handle)->users.fetch_or(kEnding); }

void keep_for_owner(void* handle) noexcept { static_cast<Control*>(handle)->kept = true; }

// A thread that is in here finds that the owner is leaving, and leaves, too.
void await_nobody(void* handle) noexcept {
  auto* control = static_cast<Control*>(handle);
  Users nobody = 0;
  while (!control->users.compare_exchange_weak(nobody, own_mark() | kEnding, std::memory_order_acq_rel)) {
    nobody = 0;
    sched_yield();
  }
}

void* peek_handle(const void* handle, HandleType type) noexcept {
  const Control* control = sound(handle, type);
  return control == nullptr ? nullptr : control->object.load();
}

void keep_message(const void* handle, const Message& message) noexcept {
  Control* control = sound(handle);
  if (control == nullptr) return;
  const AtMessage alone(*control);
  if (control->message != nullptr) *control->message = message;
}

Message message_of(const void* handle) {
  require(handle != nullptr, "handle is NULL");
  auto* control = static_cast<Control*>(const_cast<void*>(handle));
  if (control->magic != kMagic) fail(Status::kBadHandle, "handle is not a handle of this library");
  check_generation(*control, "handle");
  {
    const AtMessage alone(*control);
    if (control->message != nullptr) return *control->message;
  }
  fail_destroyed(*control, "handle");
}

}  // namespace mimo::capi
