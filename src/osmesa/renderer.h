// MuJoCo's own pictures through OSMesa, which is loaded at run time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/log.h"
#include "engine/model.h"
#include "render/renderer.h"

namespace mimo::osmesa {

// Throws Status::kUnsupported where there is no OSMesa.
std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr model, const render::Quality& quality,
                                                const LogSink& log);

// The same with other names of the library.
std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr model, const render::Quality& quality,
                                                const LogSink& log, const std::vector<std::string>& libraries);

}  // namespace mimo::osmesa
