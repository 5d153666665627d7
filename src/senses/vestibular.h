// The sense of balance: linear acceleration and angular velocity.
#pragma once

#include <memory>
#include <string>

#include "body/body.h"
#include "engine/motion.h"
#include "observation/sense.h"

namespace mimo::senses {

// An infant's: MuJoCo's accelerometer and gyroscope in the middle of the head, in the head's frame.
class Vestibular : public observation::Sense {
 public:
  explicit Vestibular(const body::Body& body);
  observation::Part part() const override { return observation::Part::kVestibular; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  std::vector<int> addresses_;  // in sensordata, one per field
};

// The same at any place of a model, which needs no sensors for it; in the frame of the site or body.
class Organ : public observation::Sense {
 public:
  explicit Organ(engine::Place place);
  observation::Part part() const override { return observation::Part::kVestibular; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  engine::Place place_;
};

// At a site or body of that name; "" for the infant's own. Throws Status::kNotFound with the sites that there are.
std::unique_ptr<observation::Sense> make_vestibular(const mjModel& model, const body::Body& body,
                                                    const std::string& place);

}  // namespace mimo::senses
