// Agents, from their configs to plans.
#pragma once

#include "blueprint/agents.h"
#include "capi/objects.h"

namespace mimo::capi {

mimo_agent_config default_agent_config();
// What the scene gives its infant by itself.
mimo_agent_config default_agent_config(const scene::Scene& scene);

blueprint::AgentPlan plan_from(const mimo_agent_config& config);

}  // namespace mimo::capi
