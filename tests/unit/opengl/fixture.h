// The small world of the tests of render, and OSMesa to draw it with.
#pragma once

#include <memory>

#include "opengl/renderer.h"
#include "unit/render/fixture.h"

namespace mimo::opengl::test {

using namespace render;
using namespace render::test;

inline std::unique_ptr<Renderer> renderer_for(const World& world) {
  return make_renderer(world.model, Quality{}, LogSink{}, osmesa());
}

}  // namespace mimo::opengl::test
