#include "blueprint/aging_world.h"

#include <algorithm>

#include "base/fail.h"
#include "engine/compiler.h"
#include "render/renderer.h"

namespace mimo::blueprint {
namespace {

bool is_infant(const env::AgentOptions& agent) { return agent.root.empty(); }

using Agents = std::vector<env::AgentOptions>;

void set_all(const Agents& agents, const growth::Growth& growth, std::vector<growth::Growth>& growths) {
  require(std::any_of(agents.begin(), agents.end(), is_infant), "growth: none of the {} agents is an infant",
          agents.size());
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (is_infant(agents[i])) growths[i] = growth;
  }
}

void set_each(const Agents& agents, const Ages& ages, std::vector<growth::Growth>& growths) {
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (!ages[i]) continue;
    require(is_infant(agents[i]), "growth[{}]: agent {} is body \"{}\" and its children, but only infants grow", i, i,
            agents[i].root);
    growths[i] = *ages[i];
  }
}

std::vector<growth::Growth> growths_of(const Agents& agents, const Ages& ages) {
  const std::size_t count = agents.size();
  require(ages.size() <= 1 || ages.size() == count, "growth_count is {}, expected 0, 1 or {}, the number of agents",
          ages.size(), count);
  std::vector<growth::Growth> growths;
  for (const env::AgentOptions& agent : agents) growths.push_back(agent.growth);
  if (ages.size() == 1 && count != 1) {
    if (ages[0]) set_all(agents, *ages[0], growths);
  } else if (!ages.empty()) {
    set_each(agents, ages, growths);
  }
  return growths;
}

}  // namespace

env::CompiledWorldPtr WorldsByAge::as_described(const Ages& ages, const LogSink& scene_log) {
  return find_or_compile(growths_of(edit_.agents.all(), ages), scene_log);
}

env::CompiledWorldPtr WorldsByAge::grown(const env::CompiledWorld& now, const Ages& ages) {
  return find_or_compile(growths_of(now.agents, ages), log_);
}

// One thread compiles at a time anyway: MuJoCo's compiler is not for more.
env::CompiledWorldPtr WorldsByAge::find_or_compile(Growths growths, const LogSink& scene_log) {
  const std::lock_guard lock(mutex_);
  if (env::CompiledWorldPtr known = find(growths)) return known;
  env::CompiledWorldPtr made = compile(growths, scene_log);
  keep({std::move(growths), made});
  return made;
}

SceneEdit WorldsByAge::described_at(const Growths& growths) const {
  if (described_at_) return described_at_(growths);
  SceneEdit grown = edit_;
  for (std::size_t i = 0; i < growths.size(); ++i) {
    if (growths[i] != edit_.agents.all()[i].growth) grown.grow(i, growths[i]);
  }
  return grown;
}

env::CompiledWorldPtr WorldsByAge::compile(const Growths& growths, const LogSink& scene_log) {
  env::CompiledWorld compiled = blueprint::compile(described_at(growths), options_, scene_log, log_);
  share_textures(compiled);
  return std::make_shared<const env::CompiledWorld>(std::move(compiled));
}

void WorldsByAge::share_textures(env::CompiledWorld& compiled) {
  if (painted_ == nullptr) {
    painted_ = compiled.model;
    textures_ = render::make_shelf();
  }
  compiled.model = engine::with_textures_of(painted_, std::move(compiled.model));
  if (engine::share_textures(*compiled.model, *painted_)) compiled.services.textures = textures_;
}

env::CompiledWorldPtr WorldsByAge::find(const Growths& growths) {
  const auto same = [&](const Member& member) { return member.growths == growths; };
  const auto found = std::find_if(members_.begin(), members_.end(), same);
  if (found == members_.end()) return nullptr;
  std::rotate(found, found + 1, members_.end());
  return members_.back().compiled;
}

void WorldsByAge::keep(Member member) {
  const auto idle = [](const Member& one) { return one.compiled.use_count() == 1; };
  while (members_.size() >= kKept) {
    const auto oldest = std::find_if(members_.begin(), members_.end(), idle);
    if (oldest == members_.end()) break;
    members_.erase(oldest);
  }
  members_.push_back(std::move(member));
}

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
