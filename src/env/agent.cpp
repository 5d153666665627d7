#include "env/agent.h"

#include <algorithm>

#include "base/bits.h"
#include "base/fail.h"
#include "env/reflexes.h"
#include "observation/signals.h"

namespace mimo::env {
namespace {

// MuJoCo knows the forces between bodies only when a sensor wants something of the kind.
bool knows_forces_between_bodies(const mjModel& model) {
  return std::any_of(model.sensor_type, model.sensor_type + model.nsensor, [](int type) {
    return type == mjSENS_FORCE || type == mjSENS_TORQUE || type == mjSENS_ACCELEROMETER;
  });
}

void check_joint_torque(const mjModel& model, const AgentOptions& options) {
  if (!has_bit(options.proprioception.wanted, MIMO_PROPRIOCEPTION_JOINT_TORQUE) || knows_forces_between_bodies(model))
    return;
  fail(Status::kUnsupported,
       "proprioception: torque about the joints' axes needs a force, torque or accelerometer sensor somewhere in the "
       "model, for MuJoCo to compute the forces between its bodies");
}

void add_reflexes(Agent& agent, const mjModel& model, const AgentOptions& options, double tick) {
  std::unique_ptr<Reflexes> reflexes = make_reflexes(model, agent, options, tick);
  if (reflexes == nullptr) return;
  agent.reflexes = reflexes.get();
  auto felt = std::make_unique<observation::Signals>(observation::Share::kProprioception,
                                                     std::vector<observation::Signal>{reflexes->signal()});
  felt->keep(std::move(reflexes));
  add_sense(agent, options, std::move(felt));
}

}  // namespace

Agent make_agent(const engine::Physics& physics, const AgentOptions& options, const Setting& setting,
                 const TaskMaker& make_task, std::size_t number, render::Renderer* renderer, SkinPtr skin) {
  const mjModel& model = physics.model();
  check_joint_torque(model, options);
  Agent agent{perceive(model, options, setting, renderer, std::move(skin))};
  agent.name = options.name;
  if (options.root.empty()) {
    const growth::Growth grown = options.growth.body ? options.growth : growth::Growth{};
    agent.age = Age{grown.age, grown.physiological_age};
  }
  agent.growth = options.growth;
  agent.mode = options.actuation.mode;
  agent.faces = body::find_faces(model, agent.body);
  agent.mass = body::mass(model, agent.body);
  agent.height = body::height(model, physics.data(), agent.body);
  add_reflexes(agent, model, options, setting.tick);
  agent.task = make_task(model, agent.body, number);
  if (agent.task->goal_size() > kLargestGoal) {
    fail(Status::kUnsupported, "the goal of the agent's task has {} numbers, expected at most {}",
         agent.task->goal_size(), kLargestGoal);
  }
  add_sense(agent, options,
            std::make_unique<observation::Signals>(observation::Share::kTask, agent.task->signals(model)));
  return agent;
}

}  // namespace mimo::env
