// What a world is made of: the inner form of mimo_agent_config and mimo_env_config.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "actuation/actuation.h"
#include "base/log.h"
#include "engine/physics.h"
#include "observation/limited_senses.h"
#include "render/renderer.h"
#include "senses/proprioception.h"
#include "senses/touch/options.h"
#include "senses/touch/skin.h"
#include "senses/vision.h"
#include "tasks/task.h"

namespace mimo::env {

struct AgentOptions {
  std::string name;  // "" for a sole agent
  std::string root;  // "": an infant; else the body of the model that the agent consists of, with all below it
  senses::ProprioceptionOptions proprioception;
  std::vector<std::string> joints;  // that proprioception reads, by their names in the model; empty: all
  bool vestibular = true;
  std::string vestibular_at;  // site or body that carries the organ; "": the infant's own sensors
  senses::VisionOptions vision;
  actuation::Options actuation;
  senses::TouchOptions touch;
  std::string face;                             // that it shows at first; "": the model's own
  std::vector<observation::PathLimits> limits;  // of its senses
  // That of the same agent in another world of the same model, to be shared instead of made anew.
  std::shared_ptr<const senses::touch::Skin> skin = nullptr;

  // Prefix of its fields, and of an infant's names in the model.
  std::string prefix() const { return name.empty() ? "" : name + "/"; }
};

// A camera of the model as fields of the observation.
struct CameraOptions {
  std::string camera;
  senses::VisionOptions vision;
};

// Makes the task of one agent, by its number.
using TaskMaker =
    std::function<std::unique_ptr<tasks::Task>(const mjModel& model, const body::Body& body, std::size_t agent)>;

struct EnvOptions {
  int frame_skip = 0;  // 0: the scene's own
  engine::PhysicsOptions physics;
  std::string renderer = "auto";
  render::Quality quality;
  // What renderers of one model have in common, for all worlds that are given the same; null: each has its own.
  std::shared_ptr<render::Shelf> shelf;
  std::vector<CameraOptions> cameras;
  std::uint32_t max_steps = 0;  // 0: the task's own
  std::string task;             // "": the scene's own
  tasks::Settings parameters;
  TaskMaker custom_task;  // stands in for the scene's own, where given
  bool timing = false;
  LogSink log;
  std::uint64_t seed = 0;                       // of the random stream, until a reset gives another
  render::Renderer* shared_renderer = nullptr;  // draws for this world, which then has none of its own; outlives it
};

// Whether anything in such a world observes pictures.
bool sees(const std::vector<AgentOptions>& agents, const EnvOptions& options);

// Makes what the options ask for. Throws Status::kUnsupported where it does not work here.
std::unique_ptr<render::Renderer> make_renderer(const engine::ModelPtr& model, const EnvOptions& options);

}  // namespace mimo::env
