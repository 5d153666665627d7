// Worlds to be stepped, saved and compared byte for byte.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "support/scenes.h"

namespace mimo::test {

inline engine::ModelPtr floating_model() {
  static const engine::ModelPtr model = room_with_infant("free");
  return model;
}

inline std::unique_ptr<env::World> make_world(const engine::ModelPtr& model, const env::EnvOptions& options = {}) {
  return std::make_unique<env::World>(model, std::vector<env::AgentOptions>{blind()}, options);
}

// The same actions for the same step, everywhere.
inline std::vector<float> some_actions(std::size_t count, int step) {
  std::vector<float> actions(count);
  for (std::size_t i = 0; i < count; ++i) {
    actions[i] = static_cast<float>(std::sin(0.37 * step + 1.7 * static_cast<double>(i)));
  }
  return actions;
}

using Bytes = std::vector<std::uint8_t>;

inline Bytes saved(const env::World& world) {
  Bytes state(world.state_bytes());
  world.save(Span<std::uint8_t>(state));
  return state;
}

inline void load(env::World& world, const Bytes& state) { world.load(Span<const std::uint8_t>(state)); }

inline Bytes step(env::World& world, int number) {
  Bytes block(world.layout().bytes(), 0xee);
  const std::vector<float> actions = some_actions(world.action_size(), number);
  world.step(Span<const float>(actions), block.data(), {});
  return block;
}

inline Bytes observed(env::World& world) {
  Bytes block(world.layout().bytes(), 0xdd);
  world.observe(block.data());
  return block;
}

}  // namespace mimo::test
