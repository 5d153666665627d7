// The sense of balance: linear acceleration and angular velocity, and what the labyrinths' nerves tell of both.
#pragma once

#include <memory>
#include <string>

#include "body/body.h"
#include "mimo/experimental/receptors.h"
#include "observation/sense.h"

namespace mimo::senses {

struct VestibularOptions {
  std::uint32_t wanted = MIMO_VESTIBULAR_ACCELERATION | MIMO_VESTIBULAR_ANGULAR_VELOCITY;  // MIMO_VESTIBULAR_ bits
  std::string at;  // site or body that carries the organ, in whose frame it feels; "": the middle of an infant's head
};

// `tick` is the time from one advance of its processes to the next, s. Throws Status::kNotFound with the sites that
// there are.
std::unique_ptr<observation::Sense> make_vestibular(const mjModel& model, const body::Body& body,
                                                    const VestibularOptions& options, double tick);

}  // namespace mimo::senses
