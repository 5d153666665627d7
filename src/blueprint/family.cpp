#include "blueprint/family.h"

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

env::KitPtr Family::as_described(const Ages& ages, const LogSink& scene_log) {
  return find_or_compile(growths_of(draft_.agents.all(), ages), scene_log);
}

env::KitPtr Family::grown(const env::Kit& now, const Ages& ages) {
  return find_or_compile(growths_of(now.agents, ages), log_);
}

// One thread compiles at a time anyway: MuJoCo's compiler is not for more.
env::KitPtr Family::find_or_compile(Growths growths, const LogSink& scene_log) {
  const std::lock_guard lock(mutex_);
  if (env::KitPtr known = find(growths)) return known;
  env::KitPtr made = compile(growths, scene_log);
  keep({std::move(growths), made});
  return made;
}

env::KitPtr Family::compile(const Growths& growths, const LogSink& scene_log) {
  Draft grown = draft_;
  for (std::size_t i = 0; i < growths.size(); ++i) {
    if (growths[i] != draft_.agents.all()[i].growth) grown.grow(i, growths[i]);
  }
  env::Kit kit = blueprint::compile(grown, options_, scene_log, log_);
  share_textures(kit);
  return std::make_shared<const env::Kit>(std::move(kit));
}

void Family::share_textures(env::Kit& kit) {
  if (painted_ == nullptr) {
    painted_ = kit.model;
    textures_ = render::make_shelf();
  }
  kit.model = engine::with_textures_of(painted_, std::move(kit.model));
  if (engine::share_textures(*kit.model, *painted_)) kit.services.textures = textures_;
}

env::KitPtr Family::find(const Growths& growths) {
  const auto same = [&](const Member& member) { return member.growths == growths; };
  const auto found = std::find_if(members_.begin(), members_.end(), same);
  if (found == members_.end()) return nullptr;
  std::rotate(found, found + 1, members_.end());
  return members_.back().kit;
}

void Family::keep(Member member) {
  const auto idle = [](const Member& one) { return one.kit.use_count() == 1; };
  while (members_.size() >= kKept) {
    const auto oldest = std::find_if(members_.begin(), members_.end(), idle);
    if (oldest == members_.end()) break;
    members_.erase(oldest);
  }
  members_.push_back(std::move(member));
}

}  // namespace mimo::blueprint
