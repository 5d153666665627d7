// What one agent senses, how late it senses and acts, and its actuation and task.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "actuation/actuation.h"
#include "actuation/motor_path.h"
#include "body/body.h"
#include "body/face.h"
#include "env/compiled_world.h"
#include "env/options.h"
#include "observation/limited_senses.h"
#include "observation/sense.h"
#include "senses/touch/felt.h"
#include "senses/touch/touch.h"
#include "tasks/task.h"

namespace mimo::movements {
class Spontaneous;
}

namespace mimo::sound {
struct Utterance;
}

namespace mimo::senses {

class FusimotorDrives;
class Soundscape;

}  // namespace mimo::senses

namespace mimo::env {

struct Perception {
  body::Body body;
  std::unique_ptr<actuation::Actuation> actuation;  // whose commands are felt
  std::vector<std::unique_ptr<observation::Sense>> senses;
  SkinPtr skin;                                       // null without touch
  std::shared_ptr<sound::Utterance> voice{};          // what it is told to say; null where it has none
  std::optional<std::size_t> own_sound{};             // of the sources around, its voice
  std::shared_ptr<senses::FusimotorDrives> drives{};  // of its spindles; null without them
};

// What its senses need to know of the world around.
struct Setting {
  double tick;  // from one advance of the senses' processes to the next, s
  senses::touch::ThingsPtr things;
  std::size_t ticks;                         // of a step
  senses::Soundscape* soundscape = nullptr;  // null if no agent hears
};

// Finds the agent in the model and attaches the senses that its options ask for; `renderer` is needed only for vision.
// A skin that is there already is shared instead of made anew.
Perception perceive(const mjModel& model, const AgentOptions& options, const Setting& setting,
                    render::Renderer* renderer, SkinPtr skin = nullptr);

// One more sense, unless it has no fields; the agent's name goes before theirs.
void add_sense(Perception& agent, const AgentOptions& options, std::unique_ptr<observation::Sense> sense);

// A camera that belongs to no agent; the renderer is null where there is none.
std::unique_ptr<observation::Sense> make_camera(const mjModel& model, const CameraOptions& options,
                                                render::Renderer* renderer);

// How well an infant sees, and how late it senses and acts, by nature.

// Of its senses: touch is late by the part of the body, proprioception by the joint, vision and the vestibular organ by
// themselves. Null where eyes are perfect and nerves take no time; the agent outlives it.
observation::NatureOf nature_of_senses(const mjModel& model, const Perception& agent, const AgentOptions& options);

// By action, how late its motors are, in seconds; empty where nerves take no time.
std::vector<double> motor_delays(const mjModel& model, const body::Body& body, const actuation::Actuation& actuation,
                                 const AgentOptions& options);

// One agent in a world: what it senses, its actuation, its task.

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
  std::optional<Age> age{};                                   // of an infant
  growth::Growth growth{};                                    // the same: the requested growth
  std::shared_ptr<const movements::Spontaneous> movements{};  // of an infant that is moved by torques; else null
  std::uint64_t movements_key = 0;                            // of its name: infants of one world move differently
};

// Makes the task of one agent, by its number.
using TaskMaker =
    std::function<std::unique_ptr<tasks::Task>(const mjModel& model, const body::Body& body, std::size_t agent)>;

// Finds the agent in the model and gives it what its options ask for; `renderer` is needed only for vision. A skin that
// is there already is shared instead of made anew.
Agent make_agent(engine::Physics& physics, const AgentOptions& options, const Setting& setting,
                 const TaskMaker& make_task, std::size_t number, render::Renderer* renderer, SkinPtr skin);

// An agent of somebody else's simulation, who commands its motors. Throws for options that concern more than senses.
Perception perceive_only(const mjModel& model, const AgentOptions& options, const Setting& setting,
                         render::Renderer* renderer);

}  // namespace mimo::env
