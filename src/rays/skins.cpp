#include "render/ray/skins.h"

#include <algorithm>
#include <limits>

#include "engine/physics.h"
#include "render/ray/mesh_builder.h"
#include "render/ray/vectors.h"
#include "render/visual_scene.h"

namespace mimo::render::ray {
namespace {

Vec vertex(const float* of, int i) {
  const float* v = of + 3 * static_cast<std::ptrdiff_t>(i);
  return {v[0], v[1], v[2]};
}

}  // namespace

SkinPattern::SkinPattern(const mjModel& model, int id, const float* vertices) {
  const int texture = model.skin_texcoordadr[id];
  const int count = model.skin_facenum[id];
  MeshBuilder builder(count);
  std::vector<std::array<int, 3>> faces(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::copy_n(model.skin_face + 3 * (static_cast<std::size_t>(model.skin_faceadr[id]) + i), 3, faces[i].begin());
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].place = vertex(vertices, faces[i][k]);
      if (texture < 0) continue;
      const float* at = model.skin_texcoord + 2 * (static_cast<std::ptrdiff_t>(texture) + faces[i][k]);
      std::copy_n(at, 2, corners[k].texture.begin());
    }
    builder.add(corners, true);
  }
  mesh_ = builder.finish(texture >= 0);
  for (const int i : builder.order()) corners_.push_back(faces[static_cast<std::size_t>(i)]);
}

std::array<double, 3> SkinPattern::drape(const float* vertices, const float* normals, Mesh& mesh) const {
  constexpr double kMost = std::numeric_limits<double>::max();
  Vec low = {kMost, kMost, kMost};
  Vec high = {-kMost, -kMost, -kMost};
  for (const auto& triangle : corners_) {
    for (const int i : triangle) {
      const Vec v = vertex(vertices, i);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], v[k]);
        high[k] = std::max(high[k], v[k]);
      }
    }
  }
  const Vec middle = {0.5 * low[0] + 0.5 * high[0], 0.5 * low[1] + 0.5 * high[1], 0.5 * low[2] + 0.5 * high[2]};
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].place = minus(vertex(vertices, corners_[i][k]), middle);
      corners[k].normal = vertex(normals, corners_[i][k]);
    }
    if (!form(corners, mesh.triangles[i], mesh.skins[i])) mesh.triangles[i] = {};  // no ray meets it
  }
  refit(mesh);
  return middle;
}

std::vector<SkinPattern> skin_patterns(const engine::ModelPtr& model) {
  std::vector<SkinPattern> patterns;
  if (model->nskin == 0) return patterns;
  engine::Physics reference(model, {});
  reference.forward();
  VisualScene scene(*model, {}, VisualScene::Shown::kExtras);
  scene.update(*model, reference.data(), {});
  for (int i = 0; i < model->nskin; ++i) {
    patterns.emplace_back(*model, i, scene.scene().skinvert + 3 * static_cast<std::ptrdiff_t>(model->skin_vertadr[i]));
  }
  return patterns;
}

}  // namespace mimo::render::ray
