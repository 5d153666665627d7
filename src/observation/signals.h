// Senses made of signals: fields of numbers, each with the function that fills it.
#pragma once

#include <functional>
#include <vector>

#include "observation/sense.h"

namespace mimo::observation {

struct Signal {
  Field field;  // of float
  // Fills all of the field.
  std::function<void(const mjModel& model, const mjData& data, float* out)> write;
};

class Signals : public Sense {
 public:
  // A signal without any numbers is left out.
  Signals(Share share, std::vector<Signal> signals);
  Share share() const override { return share_; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  Share share_;
  std::vector<decltype(Signal::write)> writers_;  // one per field
};

}  // namespace mimo::observation
