// From a scene and a config to what worlds are made from.
#pragma once

#include "capi/objects.h"

namespace mimo::capi {

mimo_env_config default_env_config();
// The options of everything that is made from a scene.
env::EnvOptions make_options(const SceneObject& object, const mimo_env_config& config);
RecipePtr make_recipe(const SceneObject& object, const mimo_env_config& config);

}  // namespace mimo::capi
