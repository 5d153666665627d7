// Where a thread is: in which batch, on which world, as which of the pool's threads.
#pragma once

#include <cstddef>

namespace mimo::batch {

struct CurrentThread {
  const void* batch = nullptr;  // null: outside
  std::size_t world = 0;
  std::size_t thread = 0;
  const CurrentThread* of_caller = nullptr;  // of the task that stepped this batch, where one did
};

const CurrentThread& current_thread();
// Whether this thread is at work for a batch: on one of its worlds, or for a task of one that waits for this thread.
bool works_for(const void* batch);

// The thread is at a current_thread as long as this lives.
class AtWork {
 public:
  explicit AtWork(const CurrentThread& at);
  ~AtWork();
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  CurrentThread before_;
};

}  // namespace mimo::batch
