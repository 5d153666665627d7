// What an infant feels of its own commands: what its actuation has to tell, and how much effort they cost.
#pragma once

#include "actuation/actuation.h"

namespace mimo::actuation {

class Feedback : public senses::Sense {
 public:
  // The actuation outlives it.
  Feedback(const mjModel& model, const Actuation& actuation, bool own_fields, bool effort);
  senses::Part part() const override { return senses::Part::kProprioception; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  const Actuation& actuation_;
  std::size_t own_ = 0;  // fields of the actuation, which come first
};

}  // namespace mimo::actuation
