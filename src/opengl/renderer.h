// MuJoCo's own pictures, by OpenGL that is loaded at run time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/log.h"
#include "engine/model.h"
#include "render/renderer.h"

namespace mimo::opengl {

class Platform;
using PlatformPtr = std::shared_ptr<const Platform>;

// Mesa's OpenGL on the CPU, and EGL's, on a graphics card if there is one. Both throw Status::kUnsupported where they
// are absent. MuJoCo keeps to the first OpenGL that it draws with, so a process draws with one of the two.
PlatformPtr osmesa();
PlatformPtr egl();
// The same with other names of the libraries.
PlatformPtr osmesa(const std::vector<std::string>& libraries);
PlatformPtr egl(const std::vector<std::string>& libraries);

std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr model, const render::Quality& quality,
                                                const LogSink& log, const PlatformPtr& platform);

}  // namespace mimo::opengl
