#include "env/attached.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "engine/model.h"
#include "env/perception.h"
#include "env/surroundings.h"
#include "senses/fusimotor_drives.h"
#include "senses/hearing/soundscape.h"

namespace mimo::env {

Attached::Attached(const CompiledWorld& compiled, double step)
    : model_(compiled.model), step_seconds_(step > 0 ? step : model_->opt.timestep), limits_(observer_) {
  if (draws(compiled.agents, compiled.options)) renderer_ = make_renderer(model_, compiled.options, compiled.services);
  soundscape_ = add_soundscape(observer_, *model_, step_seconds_, compiled.agents, compiled.options);
  const Setting setting{step_seconds_, things_of(*model_, compiled.agents, compiled.options), 1, soundscape_};
  for (const AgentOptions& agent : compiled.agents) {
    agents_.push_back(perceive_only(*model_, agent, setting, renderer_.get()));
  }
  for (const Perception& agent : agents_) {
    for (const auto& sense : agent.senses) observer_.add(*sense);
  }
  for (const CameraOptions& camera : compiled.options.cameras) {
    observer_.add(make_camera(*model_, camera, renderer_.get()));
  }
  if (compiled.options.further_sense) observer_.add(compiled.options.further_sense(*model_, nullptr));
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const AgentOptions& agent = compiled.agents[i];
    limits_.add(agent.prefix(), agent.limits, nature_of_senses(*model_, agents_[i], agent), clock());
  }
  for (int motor = 0; motor < model_->nu; ++motor) {
    if (drives_of(motor) != nullptr) driven_.push_back(motor);
  }
  limits_.make_room();
  episode_.start(random_, true);
  archive_ = Archive(engine::shape(*model_), sections());
}

// Noise is that of the physics step, as a world's is; what the host calls a step is at least one.
observation::Clock Attached::clock() const {
  const double ticks = std::max(1.0, std::round(step_seconds_ / model_->opt.timestep));
  return {step_seconds_ / ticks, static_cast<std::size_t>(ticks), false};
}

std::uint64_t Attached::ticks(std::uint64_t steps) const { return steps * clock().per_step; }

void Attached::reset(const mjData& data, const std::uint64_t* seed) {
  Random random = random_;
  if (seed != nullptr) random.reseed(*seed);
  Episode episode = episode_;
  episode.start(random, seed != nullptr);
  for (const Perception& agent : agents_) {
    if (agent.drives) agent.drives->reset();
  }
  observer_.begin(*model_, data);
  limits_.begin(*model_, data, nullptr, episode.noise);  // before the episode starts, as it may fail
  random_ = random;
  episode_ = episode;
}

void Attached::advance(const mjData& data) {
  observer_.advance(*model_, data, nullptr);
  limits_.step(*model_, data, nullptr, episode_.noise, ticks(episode_.step + 1), nullptr);
  ++episode_.step;
}

void Attached::play(const std::string& body, Span<const float> samples, double rate) {
  env::play(soundscape_, *model_, body, samples, rate);
}

void Attached::observe(const mjData& data, std::uint8_t* block) {
  limits_.look(*model_, data, block, episode_.noise, ticks(episode_.step));
}

senses::FusimotorDrives* Attached::drives_of(int motor) const {
  for (const Perception& agent : agents_) {
    if (agent.drives && agent.drives->has(motor)) return agent.drives.get();
  }
  return nullptr;
}

void Attached::drive_spindles(Span<const std::int32_t> motors, Span<const double> rates) {
  constexpr std::size_t kNumbers = senses::FusimotorDrives::kNumbers;
  require(rates.size() == kNumbers * motors.size(), "rate_count is {}, expected {}: {} for each actuator", rates.size(),
          kNumbers * motors.size(), kNumbers);
  for (std::size_t i = 0; i < motors.size(); ++i) {
    if (drives_of(motors[i]) != nullptr) continue;
    fail(Status::kNotFound,
         "actuators[{}] is {}, expected the number of a motor whose spindles are sensed; there are {}", i, motors[i],
         driven_.size());
  }
  for (std::size_t i = 0; i < rates.size(); ++i) {
    require(rates[i] >= 0 && rates[i] <= receptors::kMostFusimotorDrive, "rates[{}] is {}, expected 0 to {} Hz", i,
            rates[i], receptors::kMostFusimotorDrive);
  }
  for (std::size_t i = 0; i < motors.size(); ++i) drives_of(motors[i])->set(motors[i], rates.data() + kNumbers * i);
}

std::vector<Section> Attached::sections() {
  std::vector<Section> sections;
  sections.push_back(episode_.section());
  observer_.list(sections);
  limits_.list(sections);
  return sections;
}

}  // namespace mimo::env
