// The sense of balance: linear acceleration and angular velocity.
#pragma once

#include <memory>
#include <string>

#include "body/body.h"
#include "observation/sense.h"

namespace mimo::senses {

// At a site or body of that name, in its frame; "" for an infant's own, in the middle of its head. Throws
// Status::kNotFound with the sites that there are.
std::unique_ptr<observation::Sense> make_vestibular(const mjModel& model, const body::Body& body,
                                                    const std::string& place);

}  // namespace mimo::senses
