#include "rays/extras.h"

#include <algorithm>
#include <cstddef>

#include "compat/mujoco.h"
#include "engine/physics.h"

namespace mimo::rays {
namespace {

using Three = std::array<int, 3>;

std::vector<Three> threes(const int* from, int count) {
  std::vector<Three> result(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < result.size(); ++i) std::copy_n(from + 3 * i, 3, result[i].begin());
  return result;
}

MovingSurface skin_of(const mjModel& model, int id, const float* vertices) {
  const std::ptrdiff_t texture = model.skin_texcoordadr[id];
  Faces faces;
  faces.vertices =
      threes(model.skin_face + 3 * static_cast<std::ptrdiff_t>(model.skin_faceadr[id]), model.skin_facenum[id]);
  if (texture >= 0) faces.texcoords = model.skin_texcoord + 2 * texture;
  return MovingSurface(SurfacePattern(faces, vertices + 3 * static_cast<std::ptrdiff_t>(model.skin_vertadr[id])));
}

// Lines have no surface: they are drawn as rods.
MovingSurface flex_of(const mjModel& model, int id, const double* vertices) {
  const compat::Flex flex = compat::flex(model, id);
  if (flex.dimensions == 1) return {};
  const bool sheet = flex.dimensions == 2;
  Faces faces;
  faces.vertices = sheet ? threes(flex.element, flex.elements) : threes(flex.shell, flex.shells);
  if (sheet && flex.texcoords != nullptr) faces.texels = threes(flex.texels, flex.elements);
  faces.texcoords = flex.texcoords;
  Shell shell(flex.vertices, std::move(faces), {flex.radius, sheet, flex.flat});
  return {std::move(shell), vertices + 3 * static_cast<std::ptrdiff_t>(flex.first_vertex)};
}

Vec place_of(const double* of, int i) { return Eigen::Map<const Vec>(of + 3 * static_cast<std::ptrdiff_t>(i)); }

}  // namespace

std::vector<MovingSurface> surfaces_of(const engine::ModelPtr& model) {
  std::vector<MovingSurface> surfaces;
  if (model->nskin == 0 && compat::flex_count(*model) == 0) return surfaces;
  engine::Physics reference(model, {});
  reference.forward();
  render::VisualScene scene(*model, {}, render::VisualScene::Shown::kExtras);
  scene.update(*model, reference.data(), {});
  for (int i = 0; i < model->nskin; ++i) surfaces.push_back(skin_of(*model, i, scene.scene().skinvert));
  for (int i = 0; i < compat::flex_count(*model); ++i) {
    surfaces.push_back(flex_of(*model, i, compat::flex_vertices(reference.data())));
  }
  return surfaces;
}

bool Extras::any(const mjModel& model) {
  const auto is_spatial = [&](int first) { return model.wrap_type[first] != mjWRAP_JOINT; };
  return model.nskin > 0 || compat::flex_count(model) > 0 ||
         std::any_of(model.tendon_adr, model.tendon_adr + model.ntendon, is_spatial) ||
         std::count(model.actuator_trntype, model.actuator_trntype + model.nu, mjTRN_SLIDERCRANK) > 0;
}

Extras::Extras(const mjModel& model, const std::vector<MovingSurface>& surfaces)
    : list_(model, {}, render::VisualScene::Shown::kExtras), surfaces_(surfaces) {
  for (const MovingSurface& surface : surfaces) draped_.emplace_back(surface.pattern);
  most_ = static_cast<std::size_t>(list_.scene().maxgeom);
  for (int i = 0; i < compat::flex_count(model); ++i) {
    const compat::Flex flex = compat::flex(model, i);
    if (flex.dimensions == 1) most_ += static_cast<std::size_t>(flex.elements);
  }
  extras_.reserve(most_);
}

void Extras::update(const mjModel& model, const mjData& data, const render::View& view) {
  list_.update(model, data, view);
  extras_.clear();
  for (int i = 0; i < list_.scene().ngeom; ++i) add(model, data, list_.scene().geoms[i]);
}

// MuJoCo's visual geoms are in single precision, and with the sizes that OpenGL scales unit shapes by.
void Extras::add(const mjModel& model, const mjData& data, const mjvGeom& geom) {
  if (geom.type == mjGEOM_SKIN) return add_skin(model, geom.objid);
  if (geom.type == compat::kFlexGeom) return add_flex(model, data, geom.objid);
  Extra extra;
  extra.type = geom.type;
  std::copy_n(geom.pos, 3, extra.position);
  std::copy_n(geom.mat, 9, extra.rotation);
  extra.size[0] = geom.size[0];
  extra.size[1] = geom.size[2];
  extra.rgba = geom.rgba;
  if (geom.objtype == mjOBJ_TENDON) {
    extra.material = model.tendon_matid[geom.objid];
    extra.rgba = model.tendon_rgba + 4 * geom.objid;
  }
  extras_.push_back(extra);
}

void Extras::add_skin(const mjModel& model, int id) {
  const std::ptrdiff_t first = 3 * static_cast<std::ptrdiff_t>(model.skin_vertadr[id]);
  const auto which = static_cast<std::size_t>(id);
  draped_[which].drape(list_.scene().skinvert + first, list_.scene().skinnormal + first);
  add_surface(which, model.skin_matid[id], model.skin_rgba + 4 * id);
}

void Extras::add_flex(const mjModel& model, const mjData& data, int id) {
  const compat::Flex flex = compat::flex(model, id);
  const double* vertices = compat::flex_vertices(data) + 3 * static_cast<std::ptrdiff_t>(flex.first_vertex);
  const auto which = static_cast<std::size_t>(model.nskin + id);
  if (flex.dimensions > 1) {
    surfaces_[which].shell.expand(vertices, vertices_);
    draped_[which].drape(vertices_.places.data(), vertices_.normals.data());
    return add_surface(which, flex.material, flex.rgba);
  }
  for (const int* ends = flex.element; ends != flex.element + 2 * flex.elements; ends += 2) {
    Extra rod;
    rod.material = flex.material;
    rod.rgba = flex.rgba;
    if (make_rod(place_of(vertices, ends[0]), place_of(vertices, ends[1]), flex.radius, rod)) extras_.push_back(rod);
  }
}

void Extras::add_surface(std::size_t which, int material, const float* rgba) {
  Extra extra;
  extra.type = render::kMeshShape;
  std::copy_n(draped_[which].place.data(), 3, extra.position);
  extra.mesh = &draped_[which].mesh;
  extra.material = material;
  extra.rgba = rgba;
  extras_.push_back(extra);
}

}  // namespace mimo::rays
