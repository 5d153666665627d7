#include "env/agent.h"

#include "base/fail.h"
#include "senses/vestibular.h"

namespace mimo::env {
namespace {

bool any(const senses::ProprioceptionOptions& p) {
  return p.position || p.velocity || p.torque || p.limit || p.actuation || p.joint_torque;
}

std::shared_ptr<const senses::touch::Skin> make_skin(const mjModel& model, const body::Body& body,
                                                     const senses::TouchOptions& options) {
  return std::make_shared<senses::touch::Skin>(model, senses::spacings(model, body, options));
}

}  // namespace

Agent make_agent(const engine::Physics& physics, const AgentOptions& options, const TaskMaker& make_task,
                 std::size_t number, render::Renderer* renderer) {
  const mjModel& model = physics.model();
  Agent agent;
  agent.name = options.name;
  agent.body = body::find_body(model, options.prefix());
  agent.faces = body::find_faces(model, agent.body);
  agent.mass = body::mass(model, agent.body);
  agent.height = body::height(model, physics.data(), agent.body);
  agent.actuation = actuation::make_actuation(model, agent.body, options.actuation);
  agent.task = make_task(model, agent.body, number);
  if (any(options.proprioception)) {
    senses::ProprioceptionOptions proprioception = options.proprioception;
    proprioception.position_control = options.actuation.mode == actuation::Mode::kPosition;
    agent.senses.push_back(std::make_unique<senses::Proprioception>(model, agent.body, proprioception));
  }
  if (options.vestibular) agent.senses.push_back(std::make_unique<senses::Vestibular>(agent.body));
  if (options.touch.any()) {
    agent.skin = options.skin != nullptr ? options.skin : make_skin(model, agent.body, options.touch);
    agent.senses.push_back(std::make_unique<senses::Touch>(agent.skin, options.touch));
  }
  if (options.vision.any()) {
    if (renderer == nullptr) {
      fail(Status::kInvalidArgument, "renderer \"none\": the eyes are on; switch vision off or choose a renderer");
    }
    agent.senses.push_back(
        std::make_unique<senses::Vision>(model, senses::eyes(agent.body), options.vision, *renderer));
  }
  if (auto sense = agent.task->make_sense(model)) agent.senses.push_back(std::move(sense));
  for (const auto& sense : agent.senses) {
    for (senses::Field& field : sense->fields()) field.name = options.prefix() + field.name;
  }
  return agent;
}

std::vector<AgentOptions> sharing(std::vector<AgentOptions> options, const std::vector<Agent>& agents) {
  for (std::size_t i = 0; i < options.size(); ++i) options[i].skin = agents[i].skin;
  return options;
}

}  // namespace mimo::env
