// The sense of balance: linear acceleration and angular velocity, and what the labyrinths' nerves tell of both.
#pragma once

#include <memory>
#include <string>

#include "body/body.h"
#include "observation/sense.h"

namespace mimo::senses {

// What nerves tell of the head's motion; in Hz, and an estimate of gravity.
struct LabyrinthOptions {
  bool canals = false, otoliths = false, gravity = false;
  bool any() const { return canals || otoliths || gravity; }
};

struct VestibularOptions {
  bool acceleration = true, angular_velocity = true;
  LabyrinthOptions labyrinth;
  std::string at;  // site or body that carries the organ, in whose frame it feels; "": the middle of an infant's head

  bool any() const { return acceleration || angular_velocity || labyrinth.any(); }
};

// `tick` is the time from one advance of its processes to the next, s. Throws Status::kNotFound with the sites that
// there are.
std::unique_ptr<observation::Sense> make_vestibular(const mjModel& model, const body::Body& body,
                                                    const VestibularOptions& options, double tick);

}  // namespace mimo::senses
