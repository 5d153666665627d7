// Where a thread is: in which batch, on which world, as which of the pool's threads.
#pragma once

#include <cstddef>

namespace mimo::batch {

struct Place {
  const void* batch = nullptr;  // null: outside
  std::size_t world = 0;
  std::size_t thread = 0;
};

const Place& place();

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
