// MuJoCo's list of what is to be drawn, made anew for every picture.
#pragma once

#include <mujoco/mjvisualize.h>

#include <cstdint>
#include <vector>

#include "render/renderer.h"

namespace mimo::render {

class VisualScene {
 public:
  // What is listed: all, or neither geoms nor sites nor the beams of range finders.
  enum class Shown { kAll, kExtras };

  // Large enough for everything that a model of these sizes shows. Throws Status::kOutOfMemory.
  VisualScene(const mjModel& model, const Quality& quality, Shown shown = Shown::kAll);
  ~VisualScene();
  VisualScene(const VisualScene&) = delete;
  VisualScene& operator=(const VisualScene&) = delete;

  // Throws Status::kRender.
  void update(const mjModel& model, const mjData& data, const View& view);

  // Draw ids as colours instead of the picture.
  void show_ids(bool ids);

  // The geom behind each id: -1 for what is none (sites, tendons, skins).
  const std::vector<std::int32_t>& geoms() const { return geoms_; }

  mjvScene* get() { return &scene_; }
  const mjvScene& scene() const { return scene_; }
  bool parallel() const { return parallel_; }  // as of the last view
  float near() const { return scene_.camera[0].frustum_near; }
  float far() const { return scene_.camera[0].frustum_far; }

 private:
  mjvScene scene_;
  mjvOption option_;
  std::vector<std::int32_t> geoms_;
  bool parallel_ = false;
};

}  // namespace mimo::render
