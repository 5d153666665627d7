#include "batch/studio.h"

#include "batch/place.h"

namespace mimo::batch {

Studio::Studio(engine::ModelPtr model, const env::EnvOptions& options, std::size_t threads)
    : model_(std::move(model)), options_(options), renderers_(threads) {}

void Studio::furnish() {
  for (std::size_t i = 0; i < renderers_.size(); ++i) renderer(i);
}

// Outside of the pool a world is drawn by the calling thread, which is the last of the pool's threads.
void Studio::draw(const mjModel& model, const mjData& data, const render::View& view, const render::Picture& picture) {
  const std::size_t thread = place().batch == nullptr ? renderers_.size() - 1 : place().thread;
  renderer(thread).draw(model, data, view, picture);
}

render::Renderer& Studio::renderer(std::size_t thread) {
  if (renderers_[thread] == nullptr) renderers_[thread] = env::make_renderer(model_, options_);
  return *renderers_[thread];
}

}  // namespace mimo::batch
