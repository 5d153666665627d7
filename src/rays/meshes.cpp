#include "rays/meshes.h"

#include "rays/mesh_builder.h"
#include "render/triangles.h"

namespace mimo::rays {
namespace {

Mesh mesh_of(const mjModel& model, int id) {
  MeshBuilder builder(model.mesh_facenum[id]);
  render::each_triangle_of_mesh(model, id, [&](const Corners& corners) { builder.add(corners); });
  return builder.finish(model.mesh_texcoordadr[id] >= 0);
}

Mesh field_of(const mjModel& model, int id) {
  MeshBuilder builder(2.0 * (model.hfield_nrow[id] + 1) * (model.hfield_ncol[id] + 1));
  render::each_triangle_of_field(model, id, [&](const Corners& corners) { builder.add(corners); });
  return builder.finish(false);
}

}  // namespace

Meshes::Meshes(const mjModel& model) {
  for (int i = 0; i < model.nmesh; ++i) meshes_.push_back(mesh_of(model, i));
  for (int i = 0; i < model.nhfield; ++i) fields_.push_back(field_of(model, i));
}

const Mesh* Meshes::find(int geom_type, int data_id) const {
  if (geom_type != mjGEOM_MESH && geom_type != mjGEOM_HFIELD) return nullptr;
  const std::vector<Mesh>& all = geom_type == mjGEOM_MESH ? meshes_ : fields_;
  return data_id >= 0 && data_id < static_cast<int>(all.size()) ? &all[data_id] : nullptr;
}

}  // namespace mimo::rays
