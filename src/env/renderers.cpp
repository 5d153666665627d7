#include "env/renderers.h"

#include "base/fail.h"
#include "osmesa/renderer.h"
#include "rays/renderer.h"
#include "render/shelf.h"

namespace mimo::env {

std::unique_ptr<render::Renderer> choose_renderer(const std::string& name, const engine::ModelPtr& model,
                                                  const render::Quality& quality,
                                                  const std::shared_ptr<render::Shelf>& shelf, const LogSink& log) {
  if (name == "osmesa") return osmesa::make_renderer(model, quality, log);
  try {
    rays::Options options(quality);
    if (shelf != nullptr) options.assets = shelf->get([&] { return rays::make_assets(model); });
    return rays::make_renderer(model, options);
  } catch (const Error& error) {
    if (name != "auto" || error.status() != Status::kUnsupported) throw;
    log(LogLevel::kInfo, "drawing with OSMesa: " + error.message());
    return osmesa::make_renderer(model, quality, log);
  }
}

}  // namespace mimo::env
