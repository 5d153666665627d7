#include "blueprint/aging_world.h"

namespace mimo::blueprint {

AgingWorld::AgingWorld(WorldsByAgePtr worlds, env::CompiledWorldPtr compiled, Surroundings around)
    : worlds_(std::move(worlds)),
      compiled_(std::move(compiled)),
      around_(std::move(around)),
      world_(make(compiled_)),
      description_(around_.shared) {
  if (description_ == nullptr) description_ = &own_.emplace(describe(*world_));
}

AgingWorld::AgingWorld(const AgingWorld& original, const env::Identity& identity)
    : AgingWorld(original.worlds_, original.compiled_, {identity}) {
  std::vector<std::uint8_t> state(original.world().state_bytes());
  original.world().save(Span<std::uint8_t>(state));
  world_->load(Span<const std::uint8_t>(state));
}

std::unique_ptr<env::World> AgingWorld::make(const env::CompiledWorldPtr& compiled) const {
  const env::Services services = around_.services ? around_.services(compiled) : compiled->services;
  return std::make_unique<env::World>(compiled->model, compiled->agents, compiled->options, services, around_.identity);
}

void AgingWorld::require_alike(const env::CompiledWorldPtr& next) const {
  const env::Description other = describe(*make(next));
  check_alike(*description_->read(), other);
}

void AgingWorld::reset(const Ages& ages, const std::uint64_t* seed, std::uint8_t* block) {
  if (ages.empty()) return world_->reset(seed, block);
  world_->require_ready_to_reset();
  reset_as(with(ages), seed, block);
}

void AgingWorld::grow(const Growths& growths) {
  const std::vector<env::AgentOptions>& agents = compiled_->agents;
  Ages ages(agents.size());
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (agents[i].root.empty() && growths.at(i) != agents[i].growth) ages[i] = growths[i];
  }
  world_->require_ready_to_reset();
  if (const env::CompiledWorldPtr next = with(ages); next != compiled_) reset_as(next, nullptr, nullptr);
}

void AgingWorld::reset_as(const env::CompiledWorldPtr& next, const std::uint64_t* seed, std::uint8_t* block) {
  if (next == compiled_) return world_->reset(seed, block);
  auto successor = make(next);
  env::Description changed = env::describe(*successor);
  check_alike(*description_->read(), changed);
  replace_world(std::move(successor), seed, block);
  compiled_ = next;
  if (own_) {
    own_->adopt(std::move(changed));
  } else {
    description_->widen(changed);
  }
}

// The next world goes on where this one was (env::World::succeed).
void AgingWorld::replace_world(std::unique_ptr<env::World> next, const std::uint64_t* seed, std::uint8_t* block) {
  world_->require_ready_to_reset();
  next->succeed(*world_);
  world_.swap(next);  // before the reset, as tasks of the user's own ask for the world that is there
  try {
    world_->reset(seed, block);
  } catch (...) {
    world_.swap(next);
    throw;
  }
  world_->take_step_observer(*next);
}

}  // namespace mimo::blueprint
