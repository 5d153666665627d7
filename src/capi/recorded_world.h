// The world of a recording, made of the calls that the file keeps.
#pragma once

#include <memory>

#include "capi/objects.h"

namespace mimo::capi {

std::unique_ptr<EnvObject> make_recorded(const std::shared_ptr<recording::Recording>& recording,
                                         const mimo_env_config* config, const mimo_agent_config* senses);

}  // namespace mimo::capi
