// The sense of balance: linear acceleration and angular velocity.
#pragma once

#include <memory>
#include <string>

#include "body/body.h"
#include "observation/sense.h"

namespace mimo::senses {

struct VestibularOptions {
  bool acceleration = true, angular_velocity = true;
  std::string at;  // site or body that carries the organ, in whose frame it feels; "": the middle of an infant's head

  bool any() const { return acceleration || angular_velocity; }
};

// Throws Status::kNotFound with the sites that there are.
std::unique_ptr<observation::Sense> make_vestibular(const mjModel& model, const body::Body& body,
                                                    const VestibularOptions& options);

}  // namespace mimo::senses
