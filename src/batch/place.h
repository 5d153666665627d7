// Where a thread is: in which batch, on which world, as which of the pool's threads.
#pragma once

#include <cstddef>

namespace mimo::batch {

struct Place {
  const void* batch = nullptr;  // null: outside
  std::size_t world = 0;
  std::size_t thread = 0;
  const Place* of_caller = nullptr;  // of the task that stepped this batch, where one did
};

const Place& place();
// Whether this thread is at work for a batch: on one of its worlds, or for a task of one that waits for this thread.
bool works_for(const void* batch);

// The thread is at a place as long as this lives.
class AtPlace {
 public:
  explicit AtPlace(const Place& at);
  ~AtPlace();
  AtPlace(const AtPlace&) = delete;
  AtPlace& operator=(const AtPlace&) = delete;

 private:
  Place before_;
};

}  // namespace mimo::batch
