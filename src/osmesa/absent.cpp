// What stands for this room where there is no OSMesa to be loaded: on other systems than Linux.
#include "base/fail.h"
#include "osmesa/renderer.h"

namespace mimo::osmesa {
namespace {

[[noreturn]] void refuse() {
  fail(Status::kUnsupported, "the renderer osmesa exists on Linux only; use ray, which draws everywhere");
}

}  // namespace

std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr, const render::Quality&, const LogSink&) { refuse(); }

std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr, const render::Quality&, const LogSink&,
                                                const std::vector<std::string>&) {
  refuse();
}

}  // namespace mimo::osmesa
