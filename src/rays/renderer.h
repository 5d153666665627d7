// The renderer that casts rays at the model's geoms on the CPU: no display, no graphics library, no context.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/model.h"
#include "rays/painter.h"
#include "render/renderer.h"

namespace mimo::rays {

struct Assets;
class Textures;

struct Options : render::Quality {
  Options() = default;
  explicit Options(const render::Quality& quality) : render::Quality(quality) {}

  std::string simd;                      // one of simd_paths(); empty: the best that the machine has
  std::shared_ptr<const Assets> assets;  // of another renderer of the same model; null: made anew
};

// A model's textures with their mipmaps. Throws Status::kUnsupported where they are too large.
std::shared_ptr<const Textures> make_textures(const engine::ModelPtr& model);
// What renderers of one model share: its textures, which are made anew where none are given, its meshes and height
// fields. Throws as make_textures.
std::shared_ptr<const Assets> make_assets(const engine::ModelPtr& model,
                                          std::shared_ptr<const Textures> textures = nullptr);

// What of a model its pictures leave out although MuJoCo's show it: a line for each reason.
std::vector<std::string> omissions(const mjModel& model);

// Throws as make_textures, and Status::kInvalidArgument for a number of samples that it does not know.
std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr model, const Options& options);

}  // namespace mimo::rays
