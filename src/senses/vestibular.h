// The sense of balance: accelerometer and gyroscope in the middle of the head, in the head's frame.
#pragma once

#include "body/body.h"
#include "senses/sense.h"

namespace mimo::senses {

class Vestibular : public Sense {
 public:
  explicit Vestibular(const body::Body& body);
  Part part() const override { return Part::kVestibular; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  std::vector<int> addresses_;  // in sensordata, one per field
};

}  // namespace mimo::senses
