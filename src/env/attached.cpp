#include "env/attached.h"

#include "base/fail.h"

namespace mimo::env {

Attached::Attached(const Kit& kit) : model_(kit.model) {
  if (draws(kit.agents, kit.options)) renderer_ = make_renderer(model_, kit.options, kit.services);
  for (const AgentOptions& agent : kit.agents) {
    require(agent.face.empty(), "face is \"{}\", but the model belongs to the host, whose materials stay as they are",
            agent.face);
    if (!agent.limits.empty()) {
      fail(Status::kUnsupported, "limits of \"{}\": attached senses have no past and no random numbers",
           agent.limits.front().path);
    }
    if (agent.actuation.effort || actuation::is_muscle(agent.actuation.mode)) {
      fail(Status::kUnsupported, "effort and muscles: attached senses see the host's simulation, not what commands it");
    }
    AgentOptions idle = agent;
    idle.actuation.none = true;  // the host commands
    agents_.push_back(perceive(*model_, idle, renderer_.get()));
  }
  for (const Perception& agent : agents_) {
    for (const auto& sense : agent.senses) observer_.add(*sense);
  }
  for (const CameraOptions& camera : kit.options.cameras) {
    observer_.add(make_camera(*model_, camera, renderer_.get()));
  }
}

}  // namespace mimo::env
