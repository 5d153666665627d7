// Which renderer a world gets.
#include <mutex>

#include "base/fail.h"
#include "render/ray/ray_renderer.h"
#include "render/renderer.h"

namespace mimo::render {

class Shelf {
 public:
  std::shared_ptr<const ray::Assets> assets(const engine::ModelPtr& model) {
    const std::lock_guard lock(mutex_);
    if (assets_ == nullptr) assets_ = make_ray_assets(model);
    return assets_;
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<const ray::Assets> assets_;
};

std::shared_ptr<Shelf> make_shelf() { return std::make_shared<Shelf>(); }

std::unique_ptr<Renderer> make_renderer(const std::string& name, const engine::ModelPtr& model, const Quality& quality,
                                        const std::shared_ptr<Shelf>& shelf, const LogSink& log) {
  if (name == "osmesa") return make_osmesa_renderer(model, quality, log);
  try {
    RayOptions options{quality};
    if (shelf != nullptr) options.assets = shelf->assets(model);
    return make_ray_renderer(model, options);
  } catch (const Error& error) {
    if (name != "auto" || error.status() != Status::kUnsupported) throw;
    log(LogLevel::kInfo, "drawing with OSMesa: " + error.message());
    return make_osmesa_renderer(model, quality, log);
  }
}

}  // namespace mimo::render
