#include "blueprint/worlds_by_age.h"

#include <algorithm>

#include "base/fail.h"
#include "engine/textures.h"
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
    require(is_infant(agents[i]), "growth[{}]: agent {} is body \"{}\" and what hangs on it, but only infants grow", i,
            i, agents[i].root);
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

}  // namespace mimo::blueprint
