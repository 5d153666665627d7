// What the nerves of a skin tell: touch afferents, temperature, pain. Beside what Touch says of forces.
#pragma once

#include <memory>

#include "body/body.h"
#include "observation/sense.h"
#include "senses/touch/options.h"
#include "senses/touch/things.h"

namespace mimo::senses {

// `tick` is the time from one advance of its process to the next, s.
std::unique_ptr<observation::Sense> make_skin_sense(const mjModel& model, const body::Body& body,
                                                    std::shared_ptr<const touch::Skin> skin,
                                                    const TouchOptions& options, touch::ThingsPtr things, double tick);

}  // namespace mimo::senses
