// The OSMesa renderer, with names of the library that tests can choose.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/renderer.h"

namespace mimo::render {

std::unique_ptr<Renderer> make_osmesa_renderer(engine::ModelPtr model, const Quality& quality, const LogSink& log,
                                               const std::vector<std::string>& libraries);

}  // namespace mimo::render
