// A stage: things that plain arrays describe, and pictures of them from many views and in many poses, on several
// threads.
#pragma once

#include <cstddef>
#include <memory>

#include "base/log.h"
#include "base/span.h"
#include "mimo/experimental/stage.h"

namespace mimo::stage {

// What a host gives; null: nothing of it, or what there was.
struct Given {
  const mimo_stage_shapes *geoms = nullptr, *sites = nullptr;
  const mimo_stage_meshes* meshes = nullptr;
  const mimo_stage_fields* fields = nullptr;
  const mimo_stage_textures* textures = nullptr;
  const mimo_stage_materials* materials = nullptr;
  const mimo_stage_surfaces* surfaces = nullptr;
  const mimo_stage_tendons* tendons = nullptr;
  const mimo_stage_lights* lights = nullptr;
  const mimo_stage_air* air = nullptr;
};

mimo_stage_air default_air();
mimo_stage_view default_view();

class Stage {
 public:
  // Throws Status::kInvalidArgument for what does not fit, Status::kUnsupported for what is too large.
  Stage(const Given& given, std::size_t threads, LogSink log);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  // Throws as the constructor, and then stays as it is.
  void update(const Given& given);

  // All views, or none: what is wrong with any of them is told before one is drawn.
  void draw(Span<const mimo_stage_poses> poses, Span<const mimo_stage_view> views);

 private:
  class Inside;

  std::unique_ptr<Inside> inside_;
};

}  // namespace mimo::stage
