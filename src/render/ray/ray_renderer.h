// The renderer that casts rays at the model's geoms on the CPU: no display, no graphics library, no context.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/log.h"
#include "engine/model.h"
#include "render/renderer.h"

namespace mimo::render {

namespace ray {
class Textures;
}

// Runs `job(context, i)` for i = 0 .. count-1, in any order and on any threads, and returns when all are done.
struct RayExecutor {
  void (*run)(void* self, int count, void (*job)(void* context, int i), void* context) = nullptr;
  void* self = nullptr;
};

struct RayOptions {
  // Antialiasing: rays a pixel along each axis (1 to 8); colours are averaged, depth and segmentation are those of
  // the middle of the pixel for odd numbers and of the ray right below it for even ones.
  int samples = 1;
  bool shadows = true;
  bool reflections = true;
  bool skybox = true;
  bool haze = true;   // the strip of haze that MuJoCo draws at the horizon of an infinite plane
  bool fog = false;   // as MuJoCo's, which is off by default as well
  RayExecutor executor;  // none: the calling thread does it all. The picture does not depend on it.
  std::string simd;      // one of ray_simd_paths(); empty: the best that the machine has
  std::shared_ptr<const ray::Textures> textures;  // of another renderer of the same model; null: made anew
};

// The instruction sets that this build and this machine share, best first, e.g. "AVX2".
std::vector<std::string> ray_simd_paths();

// The textures of a model with their mipmaps: what renderers of one model share.
std::shared_ptr<const ray::Textures> make_ray_textures(const engine::ModelPtr& model);

// Throws Status::kUnsupported, naming the geom, where the model has something that this renderer cannot draw.
std::unique_ptr<Renderer> make_ray_renderer(engine::ModelPtr model, const RayOptions& options, const LogSink& log);

}  // namespace mimo::render
