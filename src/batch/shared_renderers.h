// The renderers of a batch: one for each thread instead of one for each world. They draw the same, and a thousand
// worlds would otherwise hold a thousand copies of all textures.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "env/world.h"

namespace mimo::batch {

// Hands on to a renderer that nobody else draws with. It stands in every world of the batch for a renderer of its own.
class SharedRenderers : public render::Renderer {
 public:
  // `batch` is the one that it belongs to, as workplaces name it.
  SharedRenderers(env::CompiledWorldPtr compiled, std::size_t threads, const void* batch);
  const env::CompiledWorldPtr& compiled() const { return compiled_; }
  // Makes renderers for the first so many threads now, so that what is missing here shows at once and no step has to.
  void furnish(std::size_t threads);
  void draw(const mjModel& model, const mjData& data, const render::View& view,
            const render::Picture& picture) override;

 private:
  using RendererPtr = std::unique_ptr<render::Renderer>;

  render::Renderer& renderer(std::size_t thread);
  RendererPtr make() const;
  RendererPtr borrow();
  void give_back(RendererPtr renderer);

  env::CompiledWorldPtr compiled_;
  const void* batch_;
  std::vector<RendererPtr> renderers_;  // one per thread of the pool, made when first needed
  // For callers from outside, as many as ever drew at the same time: between the batch's own calls any number of
  // threads may draw, each another world, and so may tasks of other batches.
  std::vector<RendererPtr> lent_;
  std::mutex mutex_;
};

}  // namespace mimo::batch
