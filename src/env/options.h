// What a world is made of: the inner form of mimo_agent_config and mimo_env_config.
#pragma once

#include <memory>
#include <string>

#include "actuation/actuation.h"
#include "base/log.h"
#include "engine/physics.h"
#include "senses/proprioception.h"
#include "senses/touch/options.h"
#include "senses/vision.h"
#include "tasks/parameters.h"

namespace mimo::env {

struct AgentOptions {
  std::string name;  // "" for a sole agent
  senses::ProprioceptionOptions proprioception;
  bool vestibular = true;
  senses::VisionOptions vision;
  actuation::Options actuation;
  senses::TouchOptions touch;
  std::shared_ptr<const senses::touch::Skin> skin;  // from another world of the same model and options; null: make one

  // Prefix of its model names and fields.
  std::string prefix() const { return name.empty() ? "" : name + "/"; }
};

struct EnvOptions {
  int frame_skip = 0;  // 0: the scene's own
  engine::PhysicsOptions physics;
  std::string renderer = "auto";
  std::uint32_t max_steps = 0;  // 0: the task's own
  std::string task;             // "": the scene's own
  tasks::Settings parameters;
  bool timing = false;
  LogSink log;
};

}  // namespace mimo::env
