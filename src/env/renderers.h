// Which renderer a world gets.
#pragma once

#include <memory>
#include <string>

#include "base/log.h"
#include "engine/model.h"
#include "render/renderer.h"

namespace mimo::env {

// By name: "ray", "osmesa", or "auto": rays where the model allows it, else OSMesa, which is said in the log. The shelf
// belongs to this very model; null: the renderer keeps everything to itself. Throws Status::kUnsupported where it does
// not work here.
std::unique_ptr<render::Renderer> choose_renderer(const std::string& name, const engine::ModelPtr& model,
                                                  const render::Quality& quality,
                                                  const std::shared_ptr<render::Shelf>& shelf, const LogSink& log);

}  // namespace mimo::env
