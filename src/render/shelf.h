// Where renderers of one model find what they can share, made by the first that asks.
#pragma once

#include <any>
#include <mutex>

namespace mimo::render {

// For renderers of one kind; thread-safe.
class Shelf {
 public:
  // What `make` gives, or gave.
  template <typename Make>
  auto get(Make&& make) {
    const std::lock_guard lock(mutex_);
    if (!assets_.has_value()) assets_ = make();
    return std::any_cast<decltype(make())>(assets_);
  }

 private:
  std::mutex mutex_;
  std::any assets_;
};

}  // namespace mimo::render
