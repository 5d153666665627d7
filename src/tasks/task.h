// What an episode is about: how it starts, what is rewarded, when it ends.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/bytes.h"
#include "base/random.h"
#include "base/span.h"
#include "engine/physics.h"

namespace mimo::tasks {

class Task {
 public:
  virtual ~Task() = default;
  // The world is in its initial state; randomise it.
  virtual void reset(engine::Physics& physics, Random& random) = 0;
  // After a step: one reward and one end per agent.
  virtual void evaluate(const engine::Physics& physics, Span<double> reward, Span<std::uint8_t> terminated) = 0;
  // What it remembers of the episode beside the physics: always the same number of bytes. A load that throws may
  // leave the task half loaded; the world then loads what was there before.
  virtual void save(ByteWriter&) const {}
  virtual void load(ByteReader&) {}
};

// No task: rewards are 0 and episodes do not end.
std::unique_ptr<Task> make_none();

}  // namespace mimo::tasks
