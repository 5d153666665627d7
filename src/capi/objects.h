// What the public handles stand for.
#pragma once

#include <vector>

#include "capi/handle.h"
#include "env/world.h"
#include "mimo/mimo.h"
#include "scene/scene.h"

namespace mimo::capi {

struct SceneObject {
  scene::Scene scene;
  std::vector<env::AgentOptions> agents;
  LogSink log;
  tasks::Settings parameters;
};

struct EnvObject {
  EnvObject(engine::ModelPtr model, const std::vector<env::AgentOptions>& agents, const env::EnvOptions& options)
      : world(std::move(model), agents, options) {}
  env::World world;
};

template <>
struct HandleTraits<mimo_scene> {
  using Type = SceneObject;
  static constexpr HandleKind kKind = HandleKind::kScene;
  static constexpr const char* kName = "scene";
};

template <>
struct HandleTraits<mimo_env> {
  using Type = EnvObject;
  static constexpr HandleKind kKind = HandleKind::kEnv;
  static constexpr const char* kName = "env";
};

}  // namespace mimo::capi
