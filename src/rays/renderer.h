// The renderer that casts rays at the model's geoms on the CPU: no display, no graphics library, no context.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/model.h"
#include "render/renderer.h"

namespace mimo::render {

namespace ray {
struct Assets;
}

// With several samples colours are averaged; depth and segmentation are those of the middle of the pixel.
struct RayOptions : Quality {
  RayOptions() = default;
  explicit RayOptions(const Quality& quality) : Quality(quality) {}

  std::string simd;                           // one of ray_simd_paths(); empty: the best that the machine has
  std::shared_ptr<const ray::Assets> assets;  // of another renderer of the same model; null: made anew
};

// The instruction sets that this build and this machine share, best first, e.g. "AVX2".
std::vector<std::string> ray_simd_paths();

// What renderers of one model share: its textures with their mipmaps, its meshes and height fields. Throws
// Status::kUnsupported where textures are too large.
std::shared_ptr<const ray::Assets> make_ray_assets(const engine::ModelPtr& model);

// Throws as make_ray_assets, and Status::kInvalidArgument for a number of samples that it does not know.
std::unique_ptr<Renderer> make_ray_renderer(engine::ModelPtr model, const RayOptions& options);

}  // namespace mimo::render
