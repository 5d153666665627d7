#include "batch/studio.h"

#include "batch/workplace.h"

namespace mimo::batch {

Studio::Studio(const env::Kit& kit, std::size_t threads, const void* batch)
    : model_(kit.model), options_(kit.options), services_(kit.services), batch_(batch), renderers_(threads) {}

void Studio::furnish(std::size_t threads) {
  for (std::size_t i = 0; i < threads; ++i) renderer(i);
}

// A step of the batch takes no lock: its threads have renderers of their own. One that is lost when drawing fails is
// made again.
void Studio::draw(const mjModel& model, const mjData& data, const render::View& view, const render::Picture& picture) {
  if (workplace().batch == batch_) return renderer(workplace().thread).draw(model, data, view, picture);
  RendererPtr borrowed = borrow();
  borrowed->draw(model, data, view, picture);
  give_back(std::move(borrowed));
}

render::Renderer& Studio::renderer(std::size_t thread) {
  if (renderers_[thread] == nullptr) renderers_[thread] = env::make_renderer(model_, options_, services_);
  return *renderers_[thread];
}

Studio::RendererPtr Studio::borrow() {
  {
    const std::lock_guard lock(mutex_);
    if (!lent_.empty()) {
      RendererPtr last = std::move(lent_.back());
      lent_.pop_back();
      return last;
    }
  }
  return env::make_renderer(model_, options_, services_);
}

void Studio::give_back(RendererPtr renderer) {
  const std::lock_guard lock(mutex_);
  lent_.push_back(std::move(renderer));
}

}  // namespace mimo::batch
