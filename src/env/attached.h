// Senses of somebody else's simulation: they look at its data and change nothing.
#pragma once

#include <vector>

#include "env/perception.h"
#include "observation/observer.h"
#include "render/renderer.h"

namespace mimo::env {

class Attached {
 public:
  // The model outlives this object. Of the options only those of pictures count.
  explicit Attached(const Kit& kit);

  const mjModel& model() const { return *model_; }
  const observation::Layout& layout() const { return observer_.layout(); }
  const std::vector<Perception>& agents() const { return agents_; }

  // What is sensed in data of the model, as they are: of the last step that their owner made.
  void observe(const mjData& data, std::uint8_t* block) const { observer_.observe(*model_, data, block, nullptr); }

 private:
  engine::ModelPtr model_;
  std::unique_ptr<render::Renderer> renderer_;
  std::vector<Perception> agents_;
  observation::Observer observer_;
};

}  // namespace mimo::env
