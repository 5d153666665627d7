// Worlds, from their configs to options.
#pragma once

#include "capi/objects.h"

namespace mimo::capi {

mimo_env_config default_env_config();
env::EnvOptions env_options(const mimo_env_config& config);

// `described_at` as WorldsByAge has it.
blueprint::WorldsByAgePtr worlds_of(const blueprint::Blueprint& blueprint, const mimo_env_config& config,
                                    blueprint::WorldsByAge::DescribedAt described_at = {});

}  // namespace mimo::capi
