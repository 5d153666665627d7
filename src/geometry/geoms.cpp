#include "geometry/geoms.h"

#include <algorithm>
#include <utility>

#include "geometry/shapes.h"
#include "geometry/texture.h"
#include "geometry/welder.h"
#include "render/triangles.h"

namespace mimo::geometry {
namespace {

using Vec = Eigen::Vector3d;

Mesh welded(const mjModel& model, int geom) {
  Welder welder;
  const auto take = [&welder](const render::Corners& corners) {
    for (const render::Corner& corner : corners) {
      welder.add({corner.place, corner.normal, {corner.texture[0], corner.texture[1]}});
    }
  };
  const int id = model.geom_dataid[geom];
  if (model.geom_type[geom] == mjGEOM_MESH)
    render::each_triangle_of_mesh(model, id, take);
  else
    render::each_triangle_of_field(model, id, take);
  return welder.take();
}

Mesh bare(const mjModel& model, int geom, const Detail& detail) {
  const Vec size = Eigen::Map<const Vec>(model.geom_size + 3 * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_PLANE: return plane(size[0] > 0 ? size[0] : detail.plane, size[1] > 0 ? size[1] : detail.plane);
    case mjGEOM_SPHERE: return ellipsoid(Vec::Constant(size[0]), detail.segments);
    case mjGEOM_ELLIPSOID: return ellipsoid(size, detail.segments);
    case mjGEOM_CAPSULE: return capsule(size[0], size[1], detail.segments);
    case mjGEOM_CYLINDER: return cylinder(size[0], size[1], detail.segments);
    case mjGEOM_BOX: return box(size);
    case mjGEOM_MESH:
    case mjGEOM_HFIELD: return welded(model, geom);
    default: return {};
  }
}

// Planes and meshes are drawn at their size, other shapes are unit shapes that are scaled.
render::Shape shape_of(const mjModel& model, int geom) {
  render::Shape shape{};
  render::form_of(model.geom_type[geom], shape.kind);
  for (int k = 0; k < 3; ++k)
    shape.size[static_cast<std::size_t>(k)] = static_cast<float>(model.geom_size[3 * geom + k]);
  shape.prescaled = shape.kind == render::Form::kPlane || shape.kind == render::Form::kMesh;
  shape.given = model.geom_type[geom] == mjGEOM_MESH && model.mesh_texcoordadr[model.geom_dataid[geom]] >= 0;
  return shape;
}

}  // namespace

Mesh mesh_of(const mjModel& model, int geom, const Detail& detail) {
  const int texture = material_of(model, geom).paint.texture;
  if (texture < 0) return bare(model, geom, detail);
  const TextureSize size = size_of(model, texture);
  const render::TextureMapping mapping =
      render::map_texture(model, model.geom_matid[geom], size.cube(), shape_of(model, geom));
  Mesh mesh = bare(model, geom, detail);
  lay(mesh, mapping, size);
  return mesh;
}

Material material_of(const mjModel& model, int geom) {
  Material material;
  material.group = model.geom_group[geom];
  material.paint = render::paint_of(model, model.geom_matid[geom], model.geom_rgba + 4 * geom);
  material.visible = render::is_shown(material.group) && material.paint.color[3] > 0;
  return material;
}

}  // namespace mimo::geometry
