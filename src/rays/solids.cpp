#include "rays/solids.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "rays/frame.h"
#include "render/renderer.h"
#include "render/surfaces.h"

namespace mimo::rays {

// One shape, or one of the extras.
struct Solids::Element {
  int type, id;  // id: what segmentation shows
  const double *size, *position, *rotation;
  int material;
  const float* rgba;
  bool prescaled, surface;  // textures lie by its size; only where it has its own coordinates
  const Mesh* mesh;         // of a mesh, height field or surface
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

void Solids::gather(const render::Stage& stage, const render::Poses& poses, Span<const Extra> extras,
                    const render::View& view) {
  count_ = 0;
  meshes_ = false;
  mirror_ = -1;
  ground_ = -1;
  add_shapes(stage, stage.geoms, poses.geoms, view.position);
  add_shapes(stage, stage.sites, poses.sites, view.position);
  for (const Extra& extra : extras) {
    add(stage.materials,
        {extra.type, extra.id, extra.size, extra.position, extra.rotation, extra.material, extra.rgba, false,
         extra.mesh != nullptr, extra.mesh},
        view.position);
  }
}

void Solids::add_shapes(const render::Stage& stage, const render::Shapes& shapes, const render::Places& places,
                        const Vec& eye) {
  for (int i = 0; i < shapes.count; ++i) {
    if (!render::is_shown(shapes.groups == nullptr ? 0 : shapes.groups[i], shapes.shown)) continue;
    const Mesh* mesh = shapes.data == nullptr ? nullptr : assets_.find(shapes.types[i], shapes.data[i]);
    add(stage.materials,
        {shapes.types[i], shapes.first_id < 0 ? -1 : shapes.first_id + i, shapes.sizes + 3 * i,
         places.positions + 3 * i, places.rotations + 9 * i, shapes.materials[i], shapes.colors + 4 * i,
         shapes.prescaled, false, mesh},
        eye);
  }
}

void Solids::add(const render::Materials& materials, const Element& element, const Vec& eye) {
  Solid solid;
  if (!render::form_of(element.type, solid.kind) || !has_place(element.position, element.rotation)) return;
  solid.id = element.id;
  for (int k = 0; k < 3; ++k) solid.size[k] = static_cast<float>(std::min(element.size[k], kFarthest));
  solid.position = Eigen::Map<const Vec>(element.position);
  solid.rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(element.rotation);
  const bool plane = solid.kind == Form::kPlane;
  const bool prescaled = element.prescaled && (plane || solid.kind == Form::kMesh);
  solid.mesh = element.mesh;
  const bool given = solid.mesh != nullptr && solid.mesh->textured;
  solid.material = material_of(materials, element.material, element.rgba, {solid.kind, solid.size, prescaled, given},
                               assets_.textures);
  if (solid.material.alpha == 0) return;
  if (element.surface && !given) solid.material.mapping.kind = Mapping::kNone;
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
