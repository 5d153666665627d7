// Which renderer a world gets.
#include "base/fail.h"
#include "render/ray/ray_renderer.h"
#include "render/renderer.h"

namespace mimo::render {

std::unique_ptr<Renderer> make_renderer(const std::string& name, const engine::ModelPtr& model, const LogSink& log) {
  if (name == "osmesa") return make_osmesa_renderer(model, log);
  try {
    return make_ray_renderer(model, RayOptions(), log);
  } catch (const Error& error) {
    if (name != "auto" || error.status() != Status::kUnsupported) throw;
    log(LogLevel::kInfo, "drawing with OSMesa: " + error.message());
    return make_osmesa_renderer(model, log);
  }
}

}  // namespace mimo::render
