// A world as it is described, before there is one: its scene, agents, cameras, parameters and task. It is edited by
// transactions, and compiles to what worlds are made of.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "blueprint/agents.h"
#include "env/compiled_world.h"
#include "env/world.h"
#include "scene/scene.h"

namespace mimo::blueprint {

// What is edited: a scene and all that its worlds are to have.
struct SceneEdit {
  scene::Scene scene;
  Agents agents{};
  Cameras cameras{};
  Fields fields{};
  tasks::Settings parameters{};
  env::CustomTask task{};                           // the user's own; empty: the scene's
  double room_temperature = env::kRoomTemperature;  // degrees Celsius
  std::vector<env::ThingOptions> things{};          // how they feel and sound
  senses::PlayOptions play{};                       // how much can be played
  std::vector<std::string> calls{};                 // that made all of it but the scene, as recordings keep them

  std::size_t add_agent(const AgentPlan& plan) { return agents.add(plan, scene); }
  std::size_t add_agents(const AgentPlan& plan) { return agents.add_all(plan, scene); }
  void grow(std::size_t agent, const growth::Growth& growth) { agents.grow(agent, growth, scene); }
  void add_camera(const CameraPlan& plan) { cameras.add(plan, scene); }
};

using env::CompiledWorldPtr;

// Of the options, what the edit says itself is overwritten. What the compiler has to say goes to `scene_log`. Throws
// what document::compile throws.
env::CompiledWorld compile(const SceneEdit& edit, const env::EnvOptions& options, const LogSink& scene_log,
                           const LogSink& log);
// The same agents and cameras around a model of somebody else's.
env::CompiledWorld around(const SceneEdit& edit, engine::ModelPtr model, const env::EnvOptions& options,
                          const LogSink& log);

class Blueprint {
 public:
  explicit Blueprint(const scene::Source& source) : current_{scene::Scene(source)}, log_(source.log) {}

  // Of its last edit.
  const SceneEdit& current() const { return current_; }
  const LogSink& log() const { return log_; }

  // Calls change(edit), and gives what that does. A change happens whole or not at all: it is made to a copy, which
  // takes the place of the last one when it is done.
  template <typename Change>
  auto edit(Change&& change) {
    SceneEdit changed = current_;
    if constexpr (std::is_void_v<decltype(change(changed))>) {
      change(changed);
      current_ = std::move(changed);
    } else {
      auto result = change(changed);
      current_ = std::move(changed);
      return result;
    }
  }

  CompiledWorldPtr compile(const env::EnvOptions& options, const LogSink& log) const {
    return std::make_shared<const env::CompiledWorld>(blueprint::compile(current_, options, log_, log));
  }

 private:
  SceneEdit current_;
  LogSink log_;
};

}  // namespace mimo::blueprint
