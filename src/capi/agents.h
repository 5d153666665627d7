// Configs of agents, and what scenes have by default.
#pragma once

#include "blueprint/blueprint.h"
#include "mimo/mimo.h"
#include "scene/scene.h"

namespace mimo::capi {

mimo_agent_config default_agent_config();
// What the scene gives its infant by default.
mimo_agent_config default_agent_config(const scene::Scene& scene);
// An infant as the scene has it.
blueprint::AgentPlan usual_agent(const scene::Scene& scene);
// A built-in scene with all its infants.
blueprint::Blueprint ready_world(const std::string& scene);

}  // namespace mimo::capi
