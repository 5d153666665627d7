// One agent in a world: what it senses, its actuation, its task.
#pragma once

#include <memory>
#include <vector>

#include "body/faces.h"
#include "env/options.h"
#include "env/perception.h"
#include "tasks/task.h"

namespace mimo::env {

struct Agent : Perception {
  std::string name;
  body::Faces faces;
  std::unique_ptr<tasks::Task> task;
  std::size_t action_offset = 0;
  double mass = 0;
  double height = 0;
};

// Finds the agent in the model and gives it what its options ask for; `renderer` is needed only for vision.
Agent make_agent(const engine::Physics& physics, const AgentOptions& options, const TaskMaker& make_task,
                 std::size_t number, render::Renderer* renderer);

// The options of agents that share what is immutable with those of a world that they were made for before.
std::vector<AgentOptions> sharing(std::vector<AgentOptions> options, const std::vector<Agent>& agents);

}  // namespace mimo::env
