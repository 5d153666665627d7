// What all that is in a model is like: how warm it is, how well it takes heat, how rough it is, how it sounds.
#pragma once

#include <vector>

#include "env/options.h"
#include "senses/touch/things.h"

namespace mimo::sound {
struct Solid;
}

namespace mimo::env {

// Infants are as warm as naked skin in the room; all else is as warm as the room and of plastic, unless it is told.
// Throws Status::kNotFound for a body that the model does not have.
senses::touch::ThingsPtr things_of(const mjModel& model, const std::vector<AgentOptions>& agents,
                                   const EnvOptions& options);

// What it sounds like when it is struck: likewise.
std::shared_ptr<const std::vector<sound::Solid>> solids_of(const mjModel& model,
                                                           const std::vector<AgentOptions>& agents,
                                                           const EnvOptions& options);

// Throws Status::kNotFound for a material that is not known, naming those that are.
void check_material(const std::string& name);
// The index-th one that is known, null past the last. Static string.
const char* material_name(std::size_t index);

}  // namespace mimo::env
