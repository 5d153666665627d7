#include "rays/extras.h"

#include <algorithm>
#include <limits>

#include "engine/physics.h"
#include "rays/meshes.h"
#include "rays/vectors.h"
#include "render/visual_scene.h"

namespace mimo::rays {
namespace {

Vec vertex(const float* of, int i) {
  return Eigen::Map<const Eigen::Vector3f>(of + 3 * static_cast<std::ptrdiff_t>(i)).cast<double>();
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

Vec SkinPattern::drape(const float* vertices, const float* normals, Mesh& mesh) const {
  constexpr double kMost = std::numeric_limits<double>::max();
  Vec low = Vec::Constant(kMost);
  Vec high = Vec::Constant(-kMost);
  for (const auto& triangle : corners_) {
    for (const int i : triangle) {
      const Vec v = vertex(vertices, i);
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], v[k]);
        high[k] = std::max(high[k], v[k]);
      }
    }
  }
  const Vec middle = 0.5 * low + 0.5 * high;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].place = vertex(vertices, corners_[i][k]) - middle;
      corners[k].normal = vertex(normals, corners_[i][k]);
    }
    Triangle triangle;
    if (!form(corners, triangle, mesh.surfaces[i])) triangle = {};  // no ray meets it
    mesh.triangles.set(i, triangle);
  }
  refit(mesh);
  return middle;
}

std::vector<SkinPattern> skin_patterns(const engine::ModelPtr& model) {
  std::vector<SkinPattern> patterns;
  if (model->nskin == 0) return patterns;
  engine::Physics reference(model, {});
  reference.forward();
  render::VisualScene scene(*model, {}, render::VisualScene::Shown::kExtras);
  scene.update(*model, reference.data(), {});
  for (int i = 0; i < model->nskin; ++i) {
    patterns.emplace_back(*model, i, scene.scene().skinvert + 3 * static_cast<std::ptrdiff_t>(model->skin_vertadr[i]));
  }
  return patterns;
}

bool Extras::any(const mjModel& model) {
  const auto is_spatial = [&](int first) { return model.wrap_type[first] != mjWRAP_JOINT; };
  return model.nskin > 0 || std::any_of(model.tendon_adr, model.tendon_adr + model.ntendon, is_spatial) ||
         std::count(model.actuator_trntype, model.actuator_trntype + model.nu, mjTRN_SLIDERCRANK) > 0;
}

Extras::Extras(const mjModel& model, const std::vector<SkinPattern>& patterns)
    : list_(model, {}, render::VisualScene::Shown::kExtras) {
  for (const SkinPattern& pattern : patterns) skins_.push_back({&pattern, pattern.mesh()});
}

void Extras::update(const mjModel& model, const mjData& data, const render::View& view) {
  list_.update(model, data, view);
  const mjvScene& now = list_.scene();
  for (int i = 0; i < count(); ++i) {
    if (geom(i).type != mjGEOM_SKIN) continue;
    const int id = geom(i).objid;
    const std::ptrdiff_t first = 3 * static_cast<std::ptrdiff_t>(model.skin_vertadr[id]);
    Skin& skin = skins_[static_cast<std::size_t>(id)];
    skin.place = skin.pattern->drape(now.skinvert + first, now.skinnormal + first, skin.mesh);
  }
}

const Mesh& Extras::skin(int id, double* place) const {
  const Skin& skin = skins_[static_cast<std::size_t>(id)];
  std::copy_n(skin.place.data(), 3, place);
  return skin.mesh;
}

}  // namespace mimo::rays
