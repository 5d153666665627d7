#include "rays/solids.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "rays/extras.h"
#include "rays/frame.h"
#include "render/renderer.h"
#include "render/surfaces.h"

namespace mimo::rays {

// One geom or site, as MuJoCo stores it, or one of the extras.
struct Solids::Element {
  int type, id;  // id: what segmentation shows
  const double *size, *position, *rotation;
  int material;
  const float* rgba;
  bool is_geom;
  const Mesh* mesh;  // of a mesh, height field or skin
};

namespace {

double bounding_radius(Form kind, const std::array<float, 3>& size) {
  switch (kind) {
    case Form::kPlane: return 0;
    case Form::kSphere: return size[0];
    case Form::kCapsule: return static_cast<double>(size[0]) + size[1];
    case Form::kEllipsoid: return std::max({size[0], size[1], size[2]});
    case Form::kCylinder: return length_of(size[0], size[1]);
    case Form::kBox:
    case Form::kMesh: return length_of(size[0], size[1], size[2]);
  }
  return 0;
}

// Not where a simulation has come to grief.
bool has_place(const double* position, const double* rotation) {
  return std::all_of(position, position + 3, is_near) && std::all_of(rotation, rotation + 9, is_near);
}

}  // namespace

Solids::Solids(const mjModel& model, const Assets& assets) : assets_(assets) {
  std::size_t most = static_cast<std::size_t>(model.ngeom + model.nsite);
  if (Extras::any(model)) {
    extras_ = std::make_unique<Extras>(model, assets.skins);
    most += static_cast<std::size_t>(extras_->most());
  }
  solids_.resize(most);
}

Solids::~Solids() = default;

void Solids::gather(const mjModel& model, const mjData& data, const render::View& view) {
  if (extras_ != nullptr) extras_->update(model, data, view);
  count_ = 0;
  meshes_ = false;
  mirror_ = -1;
  ground_ = -1;
  for (int i = 0; i < model.ngeom; ++i) {
    if (!render::is_shown(model.geom_group[i])) continue;
    add(model,
        {model.geom_type[i], i, model.geom_size + 3 * i, data.geom_xpos + 3 * i, data.geom_xmat + 9 * i,
         model.geom_matid[i], model.geom_rgba + 4 * i, true,
         assets_.meshes.find(model.geom_type[i], model.geom_dataid[i])},
        view.position);
  }
  for (int i = 0; i < model.nsite; ++i) {
    if (!render::is_shown(model.site_group[i])) continue;
    add(model,
        {model.site_type[i], -1, model.site_size + 3 * i, data.site_xpos + 3 * i, data.site_xmat + 9 * i,
         model.site_matid[i], model.site_rgba + 4 * i, false, nullptr},
        view.position);
  }
  if (extras_ != nullptr) add_extras(model, view.position);
}

// Extras are MuJoCo's visual geoms: in single precision, and with the sizes that OpenGL scales unit shapes by.
void Solids::add_extras(const mjModel& model, const Vec& eye) {
  for (int i = 0; i < extras_->count(); ++i) {
    const mjvGeom& geom = extras_->geom(i);
    double position[3];
    double rotation[9];
    std::copy_n(geom.pos, 3, position);
    std::copy_n(geom.mat, 9, rotation);
    double size[3] = {geom.size[0], geom.size[2], 0};
    const Mesh* mesh = nullptr;
    int material = -1;
    const float* rgba = geom.rgba;
    if (geom.objtype == mjOBJ_TENDON) {
      material = model.tendon_matid[geom.objid];
      rgba = model.tendon_rgba + 4 * geom.objid;
    } else if (geom.type == mjGEOM_SKIN) {
      material = model.skin_matid[geom.objid];
      rgba = model.skin_rgba + 4 * geom.objid;
      mesh = &extras_->skin(geom.objid, position);
    }
    add(model, {geom.type, -1, size, position, rotation, material, rgba, false, mesh}, eye);
  }
}

void Solids::add(const mjModel& model, const Element& element, const Vec& eye) {
  Solid solid;
  if (!render::form_of(element.type, solid.kind) || !has_place(element.position, element.rotation)) return;
  solid.id = element.id;
  for (int k = 0; k < 3; ++k) solid.size[k] = static_cast<float>(std::min(element.size[k], kFarthest));
  solid.position = Eigen::Map<const Vec>(element.position);
  solid.rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(element.rotation);
  const bool plane = solid.kind == Form::kPlane;
  const bool prescaled = element.is_geom && (plane || solid.kind == Form::kMesh);
  solid.mesh = element.mesh;
  const bool given = solid.mesh != nullptr && solid.mesh->textured;
  solid.material =
      material_of(model, element.material, element.rgba, {solid.kind, solid.size, prescaled, given}, assets_.textures);
  if (solid.material.alpha == 0) return;
  if (element.type == mjGEOM_SKIN && !given) solid.material.mapping.kind = Mapping::kNone;
  if (solid.kind == Form::kMesh) {
    if (solid.mesh == nullptr || solid.mesh->nodes.empty()) return;
    solid.size = solid.mesh->half;
    meshes_ = true;
  }
  solid.radius = bounding_radius(solid.kind, solid.size);
  const Vec offset = solid.position - eye;
  const bool behind = plane && dot(offset, solid.rotation.col(2)) > 0;
  solid.transparent = solid.material.alpha < 0.995F || behind;
  if (behind) solid.material.alpha *= 0.3F;
  if (solid.transparent) solid.order = plane ? 1e10 : std::sqrt(dot(offset, offset)) - solid.radius;
  if (std::isnan(solid.order)) solid.order = 0;  // the camera is nowhere; what is sorted needs an order
  const bool flat = plane || solid.kind == Form::kBox;
  if (mirror_ < 0 && solid.material.reflectance > 0 && !solid.transparent && flat) mirror_ = count_;
  if (ground_ < 0 && plane && element.size[0] == 0 && element.size[1] == 0) ground_ = count_;
  solids_[count_++] = solid;
}

}  // namespace mimo::rays
