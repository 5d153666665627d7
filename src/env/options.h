// What users choose of a world: the inner form of mimo_agent_config and mimo_env_config.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actuation/motor_path.h"
#include "engine/physics.h"
#include "growth/growth.h"
#include "growth/maturity.h"
#include "observation/eyesight.h"
#include "observation/limited_senses.h"
#include "render/renderer.h"
#include "senses/hearing/options.h"
#include "senses/proprioception.h"
#include "senses/touch/touch.h"
#include "senses/vestibular.h"
#include "senses/vision.h"
#include "tasks/task.h"

namespace mimo::env {

// Eyes and nerves.
struct Maturity {
  observation::Eyesight eyes;
  growth::Conduction nerves;
};

struct ReflexOptions {
  std::uint32_t wanted = 0;     // MIMO_REFLEX_ bits
  bool where_possible = false;  // of these, those that the body can do; else one that it cannot do is refused
  bool felt = false;            // reflex/activation has all that the body can do, whatever is wanted
};

// How late an agent feels parts of its body, in seconds, whatever its nerves are like.
struct PartDelays {
  std::optional<double> everywhere;
  std::map<std::string, double> parts;  // by body, without the agent's name

  bool any() const { return everywhere || !parts.empty(); }
};

class World;

// A sense of the user's own, and its parameters.
struct OwnSense {
  struct Parameter {
    std::string name, description;  // with the agent's and the sense's name: "anna/ct/rate"
    double standard, low, high;
  };

  std::string name;
  std::vector<Parameter> parameters;
  std::vector<double> values;  // of the parameters
  // Makes it for one agent of a world that is nearly made, and that outlives it.
  std::function<std::unique_ptr<observation::Sense>(const World& world, std::size_t agent,
                                                    const std::vector<double>& values)>
      make;
};

struct AgentOptions {
  std::string name;  // "" for a sole agent
  std::string root;  // "": an infant; else the body of the model that the agent consists of, with all below it
  senses::ProprioceptionOptions proprioception;
  std::vector<std::string> joints;  // that proprioception reads, by their names in the model; empty: all
  senses::VestibularOptions vestibular;
  senses::VisionOptions vision;
  senses::HearingOptions hearing;
  bool voice = false;  // of an infant
  actuation::Options actuation;
  double strength = 1;     // of an infant: factor of its motors' gears
  ReflexOptions reflexes;  // of an infant
  senses::TouchOptions touch;
  growth::Growth growth;                        // of an infant
  std::optional<Maturity> maturity;             // nothing: as its growth says
  PartDelays delays;                            // of touch and proprioception
  std::string face;                             // that it shows at first; "": the model's own
  std::vector<observation::PathLimits> limits;  // of its senses
  std::vector<actuation::MotorLimits> motors;   // and of the paths to its motors
  std::vector<OwnSense> own_senses;             // of the user's own

  // Prefix of its fields, and of an infant's names in the model.
  std::string prefix() const { return name.empty() ? "" : name + "/"; }
};

// A camera of the model as fields of the observation.
struct CameraOptions {
  std::string camera;
  senses::VisionOptions vision;
};

// How things of the scene feel: what of a body and all that hangs on it is told, of the rest nothing.
struct ThingOptions {
  std::string body;                     // its name in the model
  std::optional<double> temperature{};  // degrees Celsius; nothing: the room's
  std::string material{};               // by its name; "": plastic
};

// Makes a sense that is written behind those of agents and cameras, and belongs to no agent. The world is null where
// somebody else's simulation is sensed; model and world outlive the sense.
using FurtherSense = std::function<std::unique_ptr<observation::Sense>(const mjModel& model, const World* world)>;

// What one world has to itself among those of its kind.
struct Identity {
  std::uint64_t seed = 0;      // of the random stream, until a reset gives another
  std::size_t number = 0;      // in its batch
  const void* host = nullptr;  // the caller's handle of the world, passed to the user's own tasks
};

// Makes a task of the user's own for one agent of a world.
using CustomTask = std::function<std::unique_ptr<tasks::Task>(const Identity& world, std::size_t agent)>;

// What draws. Auto: rays where the model allows it, else OSMesa, which is said in the log. Gl: EGL. None: nothing is
// observed; explicit pictures use kAuto.
enum class RendererChoice { kAuto, kRay, kOsmesa, kGl, kNone };
// By its name, "auto", "ray", "osmesa", "gl" or "none"; throws for another one.
RendererChoice renderer_from(const std::string& name);

constexpr int kMostFrameSkip = 1000;
constexpr double kRoomTemperature = 24;  // degrees Celsius

struct EnvOptions {
  int frame_skip = 0;  // up to kMostFrameSkip; 0: the scene's own
  engine::PhysicsOptions physics;
  RendererChoice renderer = RendererChoice::kAuto;
  render::Quality quality;
  std::vector<CameraOptions> cameras;
  FurtherSense further_sense;  // empty: none
  double room_temperature = kRoomTemperature;
  std::vector<ThingOptions> things;  // later ones count more
  senses::PlayOptions play;
  std::uint32_t max_steps = 0;  // 0: the task's own
  std::string task;             // "": the scene's own
  tasks::Settings parameters;
  CustomTask custom_task;  // stands in for the scene's own, where given
  bool timing = false;
  bool step_contacts = false;  // what touched what in a step is recorded
};

// Whether anything in such a world observes pictures, and may.
bool draws(const std::vector<AgentOptions>& agents, const EnvOptions& options);
// Whether anybody hears.
bool listens(const std::vector<AgentOptions>& agents);

}  // namespace mimo::env
