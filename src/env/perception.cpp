#include "env/perception.h"

#include <algorithm>

#include "base/bits.h"
#include "base/fail.h"
#include "base/format.h"
#include "engine/flexes.h"
#include "env/sounds.h"
#include "growth/hearing.h"
#include "observation/signals.h"
#include "senses/hearing/hearing.h"
#include "senses/proprioception.h"
#include "senses/touch/skin_sense.h"
#include "senses/vestibular.h"
#include "senses/vision.h"

namespace mimo::env {
namespace {

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

}  // namespace

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
    fail(Status::kInvalidArgument, "renderer \"none\": camera \"{}\" is to be observed; choose a renderer",
         options.camera);
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

}  // namespace mimo::env
