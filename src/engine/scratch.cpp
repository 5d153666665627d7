#include "engine/scratch.h"

#include "compat/mujoco.h"

#if MIMO_MUJOCO_4

namespace mimo::engine {

Scratch::Scratch(const mjModel&, mjData& data) : data_(data) {}
Scratch::~Scratch() = default;

ScratchSupply::ScratchSupply(std::size_t threads) : threads_(threads) {}
ScratchSupply::~ScratchSupply() = default;
void ScratchSupply::provide(const mjModel&, const mjData&) const { static_cast<void>(threads_); }

}  // namespace mimo::engine

#else

#include <atomic>
#include <cstdint>
#include <memory>
#include <new>

#include "base/process.h"

namespace mimo::engine {
namespace {

constexpr std::size_t kAlignment = 64;  // as MuJoCo's own

unsigned char* allocate(std::size_t bytes) {
  return static_cast<unsigned char*>(::operator new (bytes, std::align_val_t{kAlignment}, std::nothrow));
}

void release(unsigned char* memory) { ::operator delete (memory, std::align_val_t{kAlignment}); }

unsigned char* bytes_of(void* array) { return static_cast<unsigned char*>(array); }

std::size_t stack_bytes(const mjData& data) {
  const std::size_t bytes = static_cast<std::size_t>(data.nstack) * sizeof(mjtNum);
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

// From the first of its arrays to the end of the last (engine/data.cpp).
std::size_t jacobian_bytes(const mjModel& model, const mjData& data) {
  const mjtNum* end = data.efc_JT + static_cast<std::size_t>(model.njmax) * static_cast<std::size_t>(model.nv);
  return static_cast<std::size_t>(bytes_of(const_cast<mjtNum*>(end)) - bytes_of(data.efc_J_colind));
}

template <typename T>
void move_array(T*& array, std::ptrdiff_t bytes) {
  array = reinterpret_cast<T*>(reinterpret_cast<std::intptr_t>(array) + bytes);
}

// By integers: its old and its new place are of two memories.
void move_jacobian(mjData& data, std::ptrdiff_t bytes) {
  move_array(data.efc_J_colind, bytes);
  move_array(data.efc_JT_colind, bytes);
  move_array(data.efc_J, bytes);
  move_array(data.efc_JT, bytes);
}

}  // namespace

// Of a list that only grows: no thread waits for another, and no child forked at the wrong time finds a lock closed.
struct ScratchMemory {
  std::atomic<bool> in_use{true};
  unsigned char* bytes = nullptr;
  std::size_t size = 0;
  ScratchMemory* before = nullptr;

  ~ScratchMemory() { release(bytes); }
  bool take() { return !in_use.load(std::memory_order_relaxed) && !in_use.exchange(true, std::memory_order_acquire); }
  void give_back() { in_use.store(false, std::memory_order_release); }

  bool hold(std::size_t wanted) {
    if (wanted <= size) return true;
    release(bytes);
    bytes = allocate(wanted);
    size = bytes == nullptr ? 0 : wanted;
    return bytes != nullptr;
  }
};

namespace {

std::atomic<ScratchMemory*> last_made{nullptr};

const AtUnload give_back([] {
  for (ScratchMemory* memory = last_made.exchange(nullptr); memory != nullptr;) {
    const std::unique_ptr<ScratchMemory> gone(memory);
    memory = gone->before;
  }
});

// In use by the caller; null where there is no memory.
ScratchMemory* make() {
  watch_the_end();
  ScratchMemory* const made = new (std::nothrow) ScratchMemory;
  if (made == nullptr) return nullptr;
  made->before = last_made.load();
  while (!last_made.compare_exchange_weak(made->before, made)) {
  }
  return made;
}

// That no thread uses, made where all are in use. Null where there is no memory. A thread takes the one that it had
// before, which its core may still have in the cache.
ScratchMemory* borrow() {
  thread_local ScratchMemory* mine = nullptr;
  if (mine != nullptr && mine->take()) return mine;
  ScratchMemory* found = last_made.load();
  while (found != nullptr && !found->take()) found = found->before;
  return mine = found != nullptr ? found : make();
}

constexpr std::size_t kMostBytes = 16 << 20;

// 0 for a world that uses its own.
std::size_t bytes_needed(const mjModel& model, const mjData& data) {
  const std::size_t bytes = stack_bytes(data) + jacobian_bytes(model, data);
  return bytes <= kMostBytes ? bytes : 0;
}

std::atomic<std::size_t> threads_to_come{1};  // also one of the host's

}  // namespace

ScratchSupply::ScratchSupply(std::size_t threads) : threads_(threads) { threads_to_come += threads_; }
ScratchSupply::~ScratchSupply() { threads_to_come -= threads_; }

void ScratchSupply::provide(const mjModel& model, const mjData& data) const {
  const std::size_t bytes = bytes_needed(model, data);
  if (bytes == 0) return;
  std::size_t count = 0;
  const auto fit = [&](ScratchMemory& memory) {
    memory.hold(bytes);
    memory.give_back();
  };
  for (ScratchMemory* memory = last_made.load(); memory != nullptr; memory = memory->before, ++count) {
    if (memory->take()) fit(*memory);
  }
  for (; count < threads_to_come; ++count) {
    if (ScratchMemory* const memory = make()) fit(*memory);
  }
}

Scratch::Scratch(const mjModel& model, mjData& data) : data_(data) {
  const std::size_t bytes = bytes_needed(model, data), stack = stack_bytes(data);
  ScratchMemory* const memory = bytes == 0 ? nullptr : borrow();
  if (memory == nullptr) return;
  if (!memory->hold(bytes)) {
    memory->give_back();
    return;
  }
  memory_ = memory;
  own_stack_ = data.stack;
  data.stack = reinterpret_cast<mjtNum*>(memory->bytes);
  data.pstack = 0;
  moved_ = reinterpret_cast<std::intptr_t>(memory->bytes + stack) - reinterpret_cast<std::intptr_t>(data.efc_J_colind);
  move_jacobian(data, moved_);
}

// The stack is empty again, also where MuJoCo's error left it.
Scratch::~Scratch() {
  if (memory_ == nullptr) return;
  data_.stack = own_stack_;
  data_.pstack = 0;
  move_jacobian(data_, -moved_);
  memory_->give_back();
}

}  // namespace mimo::engine

#endif
