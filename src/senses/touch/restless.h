// The sensors of a skin that are not at rest: only they cost anything.
#pragma once

#include <cstdint>
#include <vector>

namespace mimo::senses::touch {

class Restless {
 public:
  explicit Restless(std::size_t sensors) : is_(sensors) { all_.reserve(sensors); }
  void add(int sensor) {
    if (is_[static_cast<std::size_t>(sensor)] != 0) return;
    is_[static_cast<std::size_t>(sensor)] = 1;
    all_.push_back(sensor);
  }
  void clear() {
    for (const int sensor : all_) is_[static_cast<std::size_t>(sensor)] = 0;
    all_.clear();
  }
  const std::vector<int>& all() const { return all_; }
  // Calls go_on(sensor) for each, which says whether it stays restless.
  template <typename GoOn>
  void each(GoOn&& go_on) {
    std::size_t kept = 0;
    for (const int sensor : all_) {
      if (go_on(static_cast<std::size_t>(sensor))) {
        all_[kept++] = sensor;
      } else {
        is_[static_cast<std::size_t>(sensor)] = 0;
      }
    }
    all_.resize(kept);
  }

 private:
  std::vector<std::uint8_t> is_;
  std::vector<int> all_;
};

}  // namespace mimo::senses::touch
