// Configs of agents.
#pragma once

#include "mimo/mimo.h"
#include "scene/scene.h"

namespace mimo::capi {

mimo_agent_config default_agent_config();
// What the scene gives its infant by default.
mimo_agent_config default_agent_config(const scene::Scene& scene);

}  // namespace mimo::capi
