#include "batch/shared_renderers.h"

#include "batch/current_thread.h"

namespace mimo::batch {

SharedRenderers::SharedRenderers(env::CompiledWorldPtr compiled, std::size_t threads, const void* batch)
    : compiled_(std::move(compiled)), batch_(batch), renderers_(threads) {}

SharedRenderers::RendererPtr SharedRenderers::make() const {
  return env::make_renderer(compiled_->model, compiled_->options, compiled_->services);
}

void SharedRenderers::furnish(std::size_t threads) {
  for (std::size_t i = 0; i < threads; ++i) renderer(i);
}

// A step of the batch takes no lock: its threads have renderers of their own. One that is lost when drawing fails is
// made again.
void SharedRenderers::draw(const mjModel& model, const mjData& data, const render::View& view,
                           const render::Picture& picture) {
  if (current_thread().batch == batch_) return renderer(current_thread().thread).draw(model, data, view, picture);
  RendererPtr borrowed = borrow();
  borrowed->draw(model, data, view, picture);
  give_back(std::move(borrowed));
}

render::Renderer& SharedRenderers::renderer(std::size_t thread) {
  if (renderers_[thread] == nullptr) renderers_[thread] = make();
  return *renderers_[thread];
}

SharedRenderers::RendererPtr SharedRenderers::borrow() {
  {
    const std::lock_guard lock(mutex_);
    if (!lent_.empty()) {
      RendererPtr last = std::move(lent_.back());
      lent_.pop_back();
      return last;
    }
  }
  return make();
}

void SharedRenderers::give_back(RendererPtr renderer) {
  const std::lock_guard lock(mutex_);
  lent_.push_back(std::move(renderer));
}

}  // namespace mimo::batch
