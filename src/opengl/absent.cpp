// What stands for this room where there is no OpenGL to be loaded: on other systems than Linux.
#include "base/fail.h"
#include "opengl/renderer.h"

namespace mimo::opengl {
namespace {

[[noreturn]] void refuse(const char* renderer) {
  fail(Status::kUnsupported, "the renderer {} exists on Linux only; use ray, which draws everywhere", renderer);
}

}  // namespace

PlatformPtr osmesa() { refuse("osmesa"); }
PlatformPtr osmesa(const std::vector<std::string>&) { refuse("osmesa"); }
PlatformPtr egl() { refuse("gl"); }
PlatformPtr egl(const std::vector<std::string>&) { refuse("gl"); }

std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr, const render::Quality&, const LogSink&,
                                                const PlatformPtr&) {
  return nullptr;  // there is no platform to call it with
}

}  // namespace mimo::opengl
