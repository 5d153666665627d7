#include "env/world.h"

#include <algorithm>

#include "base/fail.h"

namespace mimo::env {
namespace {

bool sees(const std::vector<AgentOptions>& agents) {
  return std::any_of(agents.begin(), agents.end(), [](const AgentOptions& agent) { return agent.vision.any(); });
}

}  // namespace

World::World(engine::ModelPtr model, const std::vector<AgentOptions>& agents, const EnvOptions& options)
    : options_(options),
      agent_options_(agents),
      shared_model_(std::move(model)),
      physics_(shared_model_, options.physics),
      task_(tasks::make_none()) {
  if (sees(agents) && options_.renderer != "none") make_renderer();
  for (const AgentOptions& agent_options : agents) {
    Agent agent = make_agent(physics_, agent_options, renderer_.get());
    agent.action_offset = action_size_;
    action_size_ += agent.actuation->size();
    for (const auto& sense : agent.senses) {
      for (senses::Field& field : sense->fields()) layout_.add(field);
    }
    agents_.push_back(std::move(agent));
  }
  reward_.resize(agents_.size());
  terminated_.resize(agents_.size());
  measure_state();
  report_warnings();
}

void World::make_renderer() { renderer_ = render::make_osmesa_renderer(shared_model_, options_.log); }

std::pair<const Agent*, std::size_t> World::action(std::size_t index) const {
  for (const Agent& agent : agents_) {
    if (index < agent.action_offset + agent.actuation->size()) return {&agent, index - agent.action_offset};
  }
  fail(Status::kInvalidArgument, "action index {}: there are {} actions", index, action_size_);
}

void World::set_task(std::unique_ptr<tasks::Task> task) {
  task_ = std::move(task);
  measure_state();
}

void World::reset(const std::uint64_t* seed, std::uint8_t* block) {
  if (seed != nullptr) random_.reseed(*seed);
  physics_.reset();
  task_->reset(physics_, random_);
  elapsed_ = 0;
  if (block != nullptr) sense(block, false);
  report_warnings();
}

void World::step(Span<const float> actions, std::uint8_t* block, const Results& results) {
  physics_.require_usable();
  const Stopwatch total(options_.timing, timing_.total);
  if (!actions.empty()) {
    for (const Agent& agent : agents_) {
      agent.actuation->apply(actions.part(agent.action_offset, agent.actuation->size()), physics_.data());
    }
  }
  {
    const Stopwatch watch(options_.timing, timing_.physics);
    physics_.step(options_.frame_skip);
  }
  ++elapsed_;
  ++timing_.steps;
  if (block != nullptr) sense(block, options_.timing);
  evaluate(results);
  report_warnings();
}

void World::observe(std::uint8_t* block) {
  physics_.forward();
  sense(block, false);
}

// Only steps are timed: looking in between would blur what a step costs.
void World::sense(std::uint8_t* block, bool timed) {
  for (const Agent& agent : agents_) {
    for (const auto& sense : agent.senses) {
      const Stopwatch watch(timed, timing_.senses[static_cast<std::size_t>(sense->part())]);
      sense->write(model(), data(), block);
    }
  }
  layout_.clear_gaps(block);
}

void World::evaluate(const Results& results) {
  const Span<double> reward = results.reward.empty() ? Span<double>(reward_) : results.reward;
  const Span<std::uint8_t> ends = results.terminated.empty() ? Span<std::uint8_t>(terminated_) : results.terminated;
  task_->evaluate(physics_, reward, ends);
  const bool out_of_time = options_.max_steps > 0 && elapsed_ >= options_.max_steps;
  std::fill(results.truncated.begin(), results.truncated.end(), static_cast<std::uint8_t>(out_of_time));
}

void World::draw(const render::View& view, const render::Picture& picture) {
  if (renderer_ == nullptr) make_renderer();
  renderer_->draw(model(), data(), view, picture);
}

void World::report_warnings() {
  if (options_.log.write == nullptr) return;
  const std::string text = physics_.take_warnings();
  if (!text.empty()) options_.log(LogLevel::kWarning, text);
}

}  // namespace mimo::env
