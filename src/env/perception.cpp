#include "env/perception.h"

#include <algorithm>

#include "base/fail.h"
#include "base/format.h"
#include "senses/proprioception.h"
#include "senses/vestibular.h"
#include "senses/vision.h"

namespace mimo::env {
namespace {

bool any(const senses::ProprioceptionOptions& p) {
  return p.position || p.velocity || p.torque || p.limit || p.actuation || p.joint_torque;
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
      for (const body::Joint& joint : body.joints) there.push_back(engine::name(model, engine::Kind::kJoint, joint.id));
      fail(Status::kNotFound, "proprioception: the agent has no hinge or slide joint \"{}\"; it has: {}", name,
           join(there, ", "));
    }
    chosen.push_back(*found);
  }
  body.joints = std::move(chosen);
  return body;
}

SkinPtr make_skin(const mjModel& model, const body::Body& body, const senses::TouchOptions& options) {
  return std::make_shared<senses::touch::Skin>(model, senses::spacings(model, body, options));
}

}  // namespace

Perception perceive(const mjModel& model, const AgentOptions& options, render::Renderer* renderer, SkinPtr skin) {
  Perception agent;
  agent.body = find(model, options);
  if (any(options.proprioception)) {
    senses::ProprioceptionOptions proprioception = options.proprioception;
    proprioception.position_control = options.actuation.mode == actuation::Mode::kPosition;
    if (actuation::is_muscle(options.actuation.mode)) proprioception.actuation = false;  // muscles tell by themselves
    agent.senses.push_back(std::make_unique<senses::Proprioception>(
        model, chosen_joints(model, agent.body, options.joints), proprioception));
  }
  if (options.vestibular) {
    agent.senses.push_back(senses::make_vestibular(model, agent.body, options.vestibular_at));
  }
  if (options.touch.any()) {
    agent.skin = skin != nullptr ? std::move(skin) : make_skin(model, agent.body, options.touch);
    agent.senses.push_back(std::make_unique<senses::Touch>(agent.skin, options.touch));
  }
  if (options.vision.any()) {
    if (renderer == nullptr) {
      fail(Status::kInvalidArgument, "renderer \"none\": the eyes are on; switch vision off or choose a renderer");
    }
    agent.senses.push_back(
        std::make_unique<senses::Vision>(model, senses::eyes(model, agent.body), options.vision, *renderer));
  }
  for (const auto& sense : agent.senses) name_fields(options, *sense);
  return agent;
}

void name_fields(const AgentOptions& options, senses::Sense& sense) {
  for (senses::Field& field : sense.fields()) field.name = options.prefix() + field.name;
}

}  // namespace mimo::env
