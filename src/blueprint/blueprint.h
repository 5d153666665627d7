// A world as it is described, before there is one: its scene, agents, cameras, parameters and task. It is edited by
// transactions, and compiles to what worlds are made of.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "blueprint/agents.h"
#include "blueprint/cameras.h"
#include "blueprint/fields.h"
#include "env/kit.h"
#include "env/world.h"
#include "scene/scene.h"

namespace mimo::blueprint {

// What is edited.
struct Draft {
  scene::Scene scene;
  Agents agents;
  Cameras cameras;
  Fields fields;
  tasks::Settings parameters;
  env::CustomTask task;                   // the user's own; empty: the scene's
  double room_temperature = 24;           // degrees Celsius
  std::vector<env::ThingOptions> things;  // how they feel and sound
  senses::PlayOptions play;               // how much can be played

  std::size_t add_agent(const AgentPlan& plan) { return agents.add(plan, scene); }
  std::size_t add_agents(const AgentPlan& plan) { return agents.add_all(plan, scene); }
  void grow(std::size_t agent, const growth::Growth& growth) { agents.grow(agent, growth, scene); }
  void add_camera(const CameraPlan& plan) { cameras.add(plan, scene); }
};

using env::KitPtr;

// Of the options, what the draft says itself is overwritten. What the compiler has to say goes to `scene_log`. Throws
// what scene::compile throws.
env::Kit compile(const Draft& draft, const env::EnvOptions& options, const LogSink& scene_log, const LogSink& log);
// The same agents and cameras around a model of somebody else's.
env::Kit around(const Draft& draft, engine::ModelPtr model, const env::EnvOptions& options, const LogSink& log);

class Blueprint {
 public:
  explicit Blueprint(const scene::Source& source)
      : draft_{scene::Scene(source), {}, {}, {}, {}, {}, 24, {}, {}}, log_(source.log) {}

  // Of its last edit.
  const Draft& draft() const { return draft_; }
  const LogSink& log() const { return log_; }

  // Calls change(draft), and gives what that does. A change happens whole or not at all: it is made to a copy, which
  // takes the place of the draft when it is done.
  template <typename Change>
  auto edit(Change&& change) {
    Draft changed = draft_;
    if constexpr (std::is_void_v<decltype(change(changed))>) {
      change(changed);
      draft_ = std::move(changed);
    } else {
      auto result = change(changed);
      draft_ = std::move(changed);
      return result;
    }
  }

  KitPtr compile(const env::EnvOptions& options, const LogSink& log) const {
    return std::make_shared<const env::Kit>(blueprint::compile(draft_, options, log_, log));
  }

 private:
  Draft draft_;
  LogSink log_;
};

// A built-in scene with all its infants, everything as it usually is.
Blueprint ready_world(const std::string& scene);

// A world in the state that another of the same kit is in. It shares with that one what never changes.
std::unique_ptr<env::World> clone(const env::Kit& kit, const env::World& original, const env::Identity& identity);

}  // namespace mimo::blueprint
