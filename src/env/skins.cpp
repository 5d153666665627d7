// Skins that worlds share.
#include "env/compiled_world.h"

namespace mimo::env {

SkinPtr Skins::of(std::size_t agent) const {
  const std::lock_guard lock(mutex_);
  return agent < all_.size() ? all_[agent] : nullptr;
}

void Skins::keep(std::size_t agent, const SkinPtr& skin) {
  const std::lock_guard lock(mutex_);
  if (all_.size() <= agent) all_.resize(agent + 1);
  if (all_[agent] == nullptr) all_[agent] = skin;
}

}  // namespace mimo::env
