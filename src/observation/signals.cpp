#include "observation/signals.h"

#include <utility>

namespace mimo::observation {

Signals::Signals(Share share, std::vector<Signal> signals) : share_(share) {
  for (Signal& signal : signals) {
    if (signal.field.count() == 0) continue;
    fields_.push_back(std::move(signal.field));
    writers_.push_back(std::move(signal.write));
  }
}

void Signals::write(const mjModel& model, const mjData& data, std::uint8_t* block) {
  for (std::size_t i = 0; i < writers_.size(); ++i) writers_[i](model, data, at<float>(block, i));
}

}  // namespace mimo::observation
