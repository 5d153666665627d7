// One agent in a world: what it senses, its actuation, its task.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "actuation/motor_path.h"
#include "body/faces.h"
#include "env/compiled_world.h"
#include "env/perception.h"
#include "tasks/task.h"

namespace mimo::env {

constexpr int kLargestGoal = 1024;  // numbers of a task's goal; reading one takes so much of a thread's stack

// In months.
struct Age {
  double body;        // of size and mass
  double physiology;  // of strength, range of motion and tone
};

class Reflexes;

struct Agent : Perception {
  std::string name{};
  body::Faces faces{};
  actuation::Mode mode = actuation::Mode::kTorque;
  std::unique_ptr<actuation::MotorPath> path{};  // of its actions to its motors; null: nothing limits it
  Reflexes* reflexes = nullptr;                  // a process of one of its senses; null: it has none
  std::unique_ptr<tasks::Task> task{};
  std::size_t action_offset = 0;
  double mass = 0;
  double height = 0;
  std::optional<Age> age{};  // of an infant
  growth::Growth growth{};   // likewise: what it was asked to be
};

// Makes the task of one agent, by its number.
using TaskMaker =
    std::function<std::unique_ptr<tasks::Task>(const mjModel& model, const body::Body& body, std::size_t agent)>;

// Finds the agent in the model and gives it what its options ask for; `renderer` is needed only for vision. A skin that
// is there already is shared instead of made anew.
Agent make_agent(const engine::Physics& physics, const AgentOptions& options, const Setting& setting,
                 const TaskMaker& make_task, std::size_t number, render::Renderer* renderer, SkinPtr skin);

}  // namespace mimo::env
