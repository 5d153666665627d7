// What is behind everything, and between: sky, haze and fog.
#pragma once

#include <array>

#include "rays/camera.h"

namespace mimo::render {
struct Air;
struct Quality;
}  // namespace mimo::render

namespace mimo::rays {

struct Sky {
  const Texture* texture = nullptr;  // null: there is none
  std::array<float, 3> a{}, bx{}, by{};
  float limit = 0;  // horizontal distance at which it hides the ground, 0 for no sky
  float step = 1;   // the slope of a ray one beside the middle
};

// At the horizon of an endless plane, in whose frame the rays are a + x bx + y by.
struct Haze {
  bool shown = false;
  std::array<float, 3> a{}, bx{}, by{};
  std::array<float, 3> rgb{};
  float radius = 0;  // relative to the sky's
  float turn = 0;    // height (0..1) at which it is thickest
  float elevation = 0;
};

struct Fog {
  bool shown = false;
  std::array<float, 3> rgb{};
  float start = 0, scale = 0;
};

struct Backdrop {
  Sky sky;
  Haze haze;
  Fog fog;
};

Backdrop backdrop_of(const render::Air& air, const Textures& textures, const Solids& solids, const Camera& camera,
                     const render::Quality& quality);

}  // namespace mimo::rays
