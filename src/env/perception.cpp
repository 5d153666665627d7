#include "env/perception.h"

#include <algorithm>
#include <optional>

#include "base/fail.h"
#include "base/format.h"
#include "base/numbers.h"
#include "body/body.h"
#include "engine/contacts.h"
#include "env/reflexes.h"
#include "env/spontaneous.h"
#include "env/surroundings.h"
#include "growth/maturity.h"
#include "observation/sense.h"
#include "senses/hearing/hearing.h"
#include "senses/proprioception.h"
#include "senses/touch/touch.h"
#include "senses/vestibular.h"
#include "senses/vision.h"

namespace mimo::env {
namespace {

using observation::Field;
using observation::Share;

// How late an agent feels the parts of its body.
class Ways {
 public:
  Ways(const mjModel& model, const body::Body& body, const growth::Conduction& nerves, const PartDelays& given)
      : nerves_(nerves), lengths_(body::nerve_lengths(model, body)), given_(static_cast<std::size_t>(model.nbody)) {
    if (given.everywhere) given_.assign(given_.size(), given.everywhere);
    for (const auto& [name, seconds] : given.parts) given_[body_of(model, body, name)] = seconds;
  }

  double to(int part, const Field& field) const {
    const auto id = static_cast<std::size_t>(part);
    return given_[id].value_or(nerves_.any() ? late(lengths_[id], field) : 0);
  }
  const growth::Conduction& nerves() const { return nerves_; }

 private:
  // Of nerves that end in the brain stem, and from there to the cortex; thin ones are slower.
  double late(double metres, const Field& field) const {
    const bool slow = field.nerve_speed > 0 && nerves_.speed > 0;
    return (slow ? metres / field.nerve_speed : nerves_.along(metres) / field.nerve_share) + nerves_.sensory;
  }

  static std::size_t body_of(const mjModel& model, const body::Body& body, const std::string& name) {
    std::vector<std::string> there;
    for (const int id : body.bodies) {
      if (body::short_name(model, body, id) == name) return static_cast<std::size_t>(id);
      there.push_back(body::short_name(model, body, id));
    }
    fail(Status::kNotFound, "sensory delay: the agent has no body \"{}\"; it has: {}", name, join(there, ", "));
  }

  growth::Conduction nerves_;
  std::vector<double> lengths_;
  std::vector<std::optional<double>> given_;  // by body
};

std::vector<double> of_receptors(const Field& field, const Ways& ways) {
  const std::size_t width = field.count() / field.receptors.size();
  std::vector<double> delays;
  delays.reserve(field.count());
  for (const observation::Receptor& receptor : field.receptors) {
    delays.insert(delays.end(), width, ways.to(receptor.body, field));
  }
  return delays;
}

std::vector<double> delays_of(const Field& field, Share share, const Ways& ways) {
  if (share == Share::kVision) return {ways.nerves().vision};
  if (share == Share::kVestibular) return {ways.nerves().vestibular};
  if (share == Share::kHearing) return {ways.nerves().hearing};
  if (!field.receptors.empty()) return of_receptors(field, ways);
  std::vector<double> delays;
  for (const int body : field.bodies) delays.push_back(ways.to(body, field));
  return delays;
}

// Settings that were given explicitly, or follow from the age.
Maturity maturity_of(const AgentOptions& options) {
  if (options.maturity) return *options.maturity;
  const growth::Growth& growth = options.growth;
  Maturity maturity;
  if (growth.eyes) {
    const growth::EyeMaturity eyes = growth::eye_maturity_at(growth.physiological_age);
    maturity.eyes = {eyes.acuity, eyes.peak_contrast, eyes.chroma, growth.flicker ? eyes.flicker : 0, growth.threshold};
  }
  if (growth.delays) maturity.nerves = growth::conduction_at(growth.physiological_age);
  return maturity;
}

// The actuator that an action commands, or a muscle of which it is.
int actuator_of(const mjModel& model, const body::Body& body, const std::string& action) {
  for (const int id : body.actuators) {
    const std::string name = engine::name(model, engine::Kind::kActuator, id);
    if (action == name || action.compare(0, name.size() + 1, name + "/") == 0) return id;
  }
  return -1;
}

body::Body find(const mjModel& model, const AgentOptions& options) {
  return options.root.empty() ? body::find_body(model, options.prefix()) : body::find_part(model, options.root);
}

// The body with those joints only that proprioception is to read.
body::Body chosen_joints(const mjModel& model, body::Body body, const std::vector<std::string>& names) {
  if (names.empty()) return body;
  std::vector<body::Joint> chosen;
  for (const std::string& name : names) {
    const auto is = [&](const body::Joint& joint) {
      return engine::name(model, engine::Kind::kJoint, joint.id) == name;
    };
    const auto found = std::find_if(body.joints.begin(), body.joints.end(), is);
    if (found == body.joints.end()) {
      std::vector<std::string> there;
      for (const body::Joint& joint : body.joints)
        there.emplace_back(engine::name(model, engine::Kind::kJoint, joint.id));
      fail(Status::kNotFound, "proprioception: the agent has no hinge or slide joint \"{}\"; it has: {}", name,
           join(there, ", "));
    }
    chosen.push_back(*found);
  }
  body.joints = std::move(chosen);
  return body;
}

SkinPtr make_skin(const mjModel& model, const body::Body& body, const senses::TouchOptions& options) {
  return std::make_shared<senses::touch::Skin>(model, senses::spacings(model, body, options),
                                               senses::touch::BornGeoms(model, body));
}

// What the infant's ears are like at its age; of what is no infant, at 18 months.
senses::HearingSetting ears_of(const AgentOptions& options, const Setting& setting) {
  senses::HearingSetting ears{setting.soundscape, setting.ticks, {}};
  const double age = (options.growth.body ? options.growth : growth::Growth{}).physiological_age;
  const hearing::Levels centres = hearing::band_centres();
  for (std::size_t band = 0; band < hearing::kBands; ++band) {
    ears.thresholds[band] = growth::hearing_threshold(age, centres[band]);
  }
  return ears;
}

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

observation::NatureOf nature_of_senses(const mjModel& model, const Perception& agent, const AgentOptions& options) {
  const Maturity is = maturity_of(options);
  const bool late = is.nerves.any() || options.delays.any();
  if (!is.eyes.any() && !late) return {};
  return [late, eyes = is.eyes, &agent, ways = Ways(model, agent.body, is.nerves, options.delays)](const Field& field) {
    const auto its = std::find_if(agent.senses.begin(), agent.senses.end(),
                                  [&field](const auto& sense) { return sense->has(field); });
    if (its == agent.senses.end()) return observation::Nature{};
    const Share share = (*its)->share();
    return observation::Nature{late ? delays_of(field, share, ways) : std::vector<double>{},
                               share == Share::kVision ? eyes : observation::Eyesight{}};
  };
}

std::vector<double> motor_delays(const mjModel& model, const body::Body& body, const actuation::Actuation& actuation,
                                 const AgentOptions& options) {
  const growth::Conduction nerves = maturity_of(options).nerves;
  if (!nerves.any()) return {};
  const std::vector<double> lengths = body::nerve_lengths(model, body);
  std::vector<double> delays;
  for (const std::string& action : actuation.names()) {
    const int actuator = actuator_of(model, body, action);
    const int part = actuator < 0 ? 0 : body::moved_by(model, actuator);
    delays.push_back(part == 0 ? 0 : nerves.along(lengths[static_cast<std::size_t>(part)]) + nerves.motor);
  }
  return delays;
}

Perception perceive(const mjModel& model, const AgentOptions& options, const Setting& setting,
                    render::Renderer* renderer, SkinPtr skin) {
  Perception agent;
  const auto add = [&](std::unique_ptr<observation::Sense> sense) { add_sense(agent, options, std::move(sense)); };
  agent.body = find(model, options);
  agent.actuation = actuation::make_actuation(model, agent.body, options.actuation);
  actuation::Feedback feedback = agent.actuation->feedback(model, agent.body, options.proprioception.wanted);
  if (options.voice) add_voice(agent, model, options, setting.soundscape);
  if (has_bit(options.proprioception.wanted, senses::kSpindles)) {
    agent.drives = senses::make_fusimotor_drives(model, agent.body);
  }
  if (has_bit(options.proprioception.wanted, ~MIMO_PROPRIOCEPTION_EFFORT)) {
    add(senses::make_proprioception(
        model, chosen_joints(model, agent.body, options.joints), options.proprioception, std::move(feedback.commands),
        [actuation = agent.actuation.get()](const mjData& data, double* shares) {
          return actuation->pulls(data, shares);
        },
        agent.drives, setting.tick));
  }
  if (options.vestibular.wanted != 0) add(senses::make_vestibular(model, agent.body, options.vestibular, setting.tick));
  if (options.touch.wanted != 0) {
    engine::require_told_forces(model);
    agent.skin = skin != nullptr ? std::move(skin) : make_skin(model, agent.body, options.touch);
    add(std::make_unique<senses::Touch>(agent.skin, options.touch));
    if (has_bit(options.touch.wanted, senses::kSkinNerves)) {
      add(senses::make_skin_sense(model, agent.body, agent.skin, options.touch, setting.things, setting.tick));
    }
  }
  if (options.vision.wanted != 0) {
    if (renderer == nullptr) {
      fail(Status::kInvalidArgument, "renderer \"none\": the eyes are on; switch vision off or choose a renderer");
    }
    add(std::make_unique<senses::Vision>(model, senses::eyes(model, agent.body), options.vision, *renderer));
  }
  if (options.hearing.wanted != 0) {
    senses::HearingSetting ears = ears_of(options, setting);
    if (agent.own_sound) ears.own = *agent.own_sound;
    add(senses::make_hearing(model, agent.body, options.hearing, ears));
  }
  add(std::make_unique<observation::Signals>(observation::Share::kProprioception, std::move(feedback.exertion)));
  return agent;
}

std::unique_ptr<observation::Sense> make_camera(const mjModel& model, const CameraOptions& options,
                                                render::Renderer* renderer) {
  if (renderer == nullptr) {
    fail(Status::kInvalidArgument, "renderer \"none\": camera \"{}\" is observed; choose a renderer", options.camera);
  }
  const int camera = engine::find_or_fail(model, engine::Kind::kCamera, options.camera);
  const std::vector<senses::Lens> lenses = {{"vision/" + options.camera, camera}};
  return std::make_unique<senses::Vision>(model, lenses, options.vision, *renderer);
}

void add_sense(Perception& agent, const AgentOptions& options, std::unique_ptr<observation::Sense> sense) {
  if (sense->fields().empty()) return;
  for (observation::Field& field : sense->fields()) field.name = options.prefix() + field.name;
  for (const auto& process : sense->processes()) process->belong_to(options.prefix());
  agent.senses.push_back(std::move(sense));
}

Agent make_agent(engine::Physics& physics, const AgentOptions& options, const Setting& setting,
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
  if (agent.age && agent.mode == actuation::Mode::kTorque) add_spontaneous(agent);
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
  if (options.strength != 1) {  // where it is 1, worlds share their gears
    for (const int motor : agent.body.actuators) physics.gear(motor) *= options.strength;
  }
  if (!options.face.empty()) physics.paint(agent.faces.geom, agent.faces.find(options.face).material);
  return agent;
}

Perception perceive_only(const mjModel& model, const AgentOptions& options, const Setting& setting,
                         render::Renderer* renderer) {
  require(options.face.empty(), "face is \"{}\", but the model belongs to the host, whose materials stay as they are",
          options.face);
  if (!options.motors.empty()) {
    fail(Status::kUnsupported, "limits of the paths to motors: with attached senses the host commands them");
  }
  if (has_bit(options.proprioception.wanted, MIMO_PROPRIOCEPTION_EFFORT) ||
      actuation::is_muscle(options.actuation.mode)) {
    fail(Status::kUnsupported, "effort and muscles: attached senses see the host's simulation, not what commands it");
  }
  if (options.strength != 1) fail(Status::kUnsupported, "strength: with attached senses the motors are the host's");
  if (options.voice) {
    fail(Status::kUnsupported, "voice: with attached senses there are no actions; play its sounds at its head instead");
  }
  if (options.reflexes.wanted != 0) {
    fail(Status::kUnsupported, "reflexes: with attached senses the host commands the motors, and nothing adds to that");
  }
  if (!options.own_senses.empty()) {
    fail(Status::kUnsupported,
         "sense \"{}\": attached senses have none of your own, which need a world of the library's",
         options.own_senses[0].name);
  }
  AgentOptions idle = options;
  idle.actuation.none = true;  // the host commands
  return perceive(model, idle, setting, renderer);
}

}  // namespace mimo::env
