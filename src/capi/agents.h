// Infants, from their config to the scene.
#pragma once

#include "capi/objects.h"

namespace mimo::capi {

mimo_agent_config default_agent_config();
// What the scene gives its infant by itself.
mimo_agent_config default_agent_config(const scene::Scene& scene);

// Checks everything before it changes anything; gives the agent's number.
std::size_t add_agent(SceneObject& object, const mimo_agent_config& config);

// Throws for a number that is none of an agent.
env::AgentOptions& agent_at(SceneObject& object, std::int32_t agent);
// All that the scene names, or none of them; gives their number.
std::size_t add_agents(SceneObject& object, const mimo_agent_config& config);

// Letters, digits, '_', '-' and '.'.
void check_plain_name(const std::string& name);

// Checked numbers of a config: position, and orientation as a quaternion that is not zero.
scene::Pose pose(const double (&position)[3], const double (&orientation)[4]);

}  // namespace mimo::capi
