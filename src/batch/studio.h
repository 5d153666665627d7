// The renderers of a batch: one for each thread instead of one for each world. They draw the same, and a thousand
// worlds would otherwise hold a thousand copies of all textures.
#pragma once

#include <memory>
#include <vector>

#include "env/world.h"

namespace mimo::batch {

// Hands on to the renderer of the thread that calls. It stands in every world of the batch for a renderer of its own.
class Studio : public render::Renderer {
 public:
  Studio(engine::ModelPtr model, const env::EnvOptions& options, std::size_t threads);
  // Makes all renderers now, so that what is missing here shows at once and no step has to.
  void furnish();
  void draw(const mjModel& model, const mjData& data, const render::View& view,
            const render::Picture& picture) override;

 private:
  render::Renderer& renderer(std::size_t thread);

  engine::ModelPtr model_;
  env::EnvOptions options_;
  std::vector<std::unique_ptr<render::Renderer>> renderers_;  // one per thread, made when first needed
};

}  // namespace mimo::batch
