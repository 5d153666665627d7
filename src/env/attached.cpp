#include "env/attached.h"

#include <cmath>

#include "base/fail.h"
#include "engine/fingerprint.h"
#include "env/requested_fields.h"

namespace mimo::env {

Attached::Attached(const Kit& kit, double step)
    : model_(kit.model), step_seconds_(step > 0 ? step : model_->opt.timestep) {
  if (draws(kit.agents, kit.options)) renderer_ = make_renderer(model_, kit.options, kit.services);
  for (const AgentOptions& agent : kit.agents) add_agent(agent);
  for (const Perception& agent : agents_) {
    for (const auto& sense : agent.senses) observer_.add(*sense);
  }
  for (const CameraOptions& camera : kit.options.cameras) {
    observer_.add(make_camera(*model_, camera, renderer_.get()));
  }
  if (!kit.options.fields.empty()) {
    observer_.add(std::make_unique<RequestedFields>(*model_, nullptr, kit.options.fields));
  }
  for (const AgentOptions& agent : kit.agents) limits_.add(layout(), agent.prefix(), agent.limits, step_seconds_);
  limits_.make_room(layout());
  episode_.start(random_, true);
  archive_ = Archive(engine::shape(*model_), sections());
}

void Attached::add_agent(const AgentOptions& options) {
  require(options.face.empty(), "face is \"{}\", but the model belongs to the host, whose materials stay as they are",
          options.face);
  if (!options.motors.empty()) {
    fail(Status::kUnsupported, "limits of the paths to motors: with attached senses the host commands them");
  }
  if (options.actuation.effort || actuation::is_muscle(options.actuation.mode)) {
    fail(Status::kUnsupported, "effort and muscles: attached senses see the host's simulation, not what commands it");
  }
  AgentOptions idle = options;
  idle.actuation.none = true;  // the host commands
  agents_.push_back(perceive(*model_, idle, renderer_.get()));
}

std::uint8_t* Attached::sensed(const mjData& data) {
  if (!limits_.late()) return nullptr;
  observer_.observe(*model_, data, limits_.room(), nullptr);
  return limits_.room();
}

void Attached::reset(const mjData& data, const std::uint64_t* seed) {
  std::uint8_t* now = sensed(data);  // first, as it may fail
  if (seed != nullptr) random_.reseed(*seed);
  episode_.start(random_, seed != nullptr);
  if (now != nullptr) limits_.begin(now, episode_.noise);
}

void Attached::advance(const mjData& data) {
  std::uint8_t* now = sensed(data);
  ++episode_.step;
  if (now != nullptr) limits_.step(now, episode_.noise, episode_.step);
}

void Attached::observe(const mjData& data, std::uint8_t* block) {
  observer_.observe(*model_, data, block, nullptr);
  limits_.look(block, episode_.noise, episode_.step);
}

std::vector<Section> Attached::sections() {
  std::vector<Section> sections;
  sections.push_back(episode_.section());
  limits_.list(sections);
  return sections;
}

}  // namespace mimo::env
