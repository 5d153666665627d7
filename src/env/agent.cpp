#include "env/agent.h"

namespace mimo::env {

Agent make_agent(const engine::Physics& physics, const AgentOptions& options, const TaskMaker& make_task,
                 std::size_t number, render::Renderer* renderer) {
  const mjModel& model = physics.model();
  Agent agent{perceive(model, options, renderer), options.name, {}, nullptr, nullptr};
  agent.faces = body::find_faces(model, agent.body);
  agent.mass = body::mass(model, agent.body);
  agent.height = body::height(model, physics.data(), agent.body);
  agent.actuation = actuation::make_actuation(model, agent.body, options.actuation);
  agent.task = make_task(model, agent.body, number);
  if (auto sense = agent.task->make_sense(model)) {
    name_fields(options, *sense);
    agent.senses.push_back(std::move(sense));
  }
  return agent;
}

std::vector<AgentOptions> sharing(std::vector<AgentOptions> options, const std::vector<Agent>& agents) {
  for (std::size_t i = 0; i < options.size(); ++i) options[i].skin = agents[i].skin;
  return options;
}

}  // namespace mimo::env
