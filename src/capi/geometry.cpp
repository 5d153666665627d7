// What engines draw themselves.
#include <algorithm>
#include <cmath>

#include "capi/access_arguments.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "compat/mujoco.h"
#include "engine/present.h"
#include "geometry/axes.h"
#include "geometry/mesh.h"
#include "geometry/texture.h"

namespace mimo::capi {
namespace {

geometry::Conversion conversion(std::int32_t axes, const char* argument) {
  check_choice(axes, 0, MIMO_AXES_GLTF, argument);
  return geometry::Conversion(static_cast<geometry::Axes>(axes));
}

void check_element(int id, int count, const char* argument) {
  require(id >= 0 && id < count, "{} is {}, expected an id from 0 to {}", argument, id, count - 1);
}

Eigen::Map<Eigen::Vector3f> three(float* values) { return Eigen::Map<Eigen::Vector3f>(values); }

template <typename Convert>
void convert_each(float* values, std::size_t count, const char* argument, Convert convert) {
  check_length<float[3]>(count, argument);
  const Span<float> all = array(values, 3 * count, argument);
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Map<Eigen::Vector3f> one = three(all.data() + 3 * i);
    one = convert(one.cast<double>()).template cast<float>();
  }
}

mimo_quantity pose_of(std::int32_t kind) {
  switch (kind) {
    case MIMO_BODY: return MIMO_BODY_POSE;
    case MIMO_GEOM: return MIMO_GEOM_POSE;
    case MIMO_SITE: return MIMO_SITE_POSE;
    case MIMO_CAMERA: return MIMO_CAMERA_POSE;
    default: break;
  }
  fail(Status::kInvalidArgument, "kind is {} ({}), expected body, geom, site or camera", kind,
       access::words(kind_from(kind).constant));
}

void convert_poses(const geometry::Conversion& to, Span<float> poses) {
  for (float* pose = poses.data(); pose != poses.data() + poses.size(); pose += 7) {
    const Eigen::Map<Eigen::Vector4f> rotation(pose + 3);
    const Eigen::Vector4d q = rotation.cast<double>();
    three(pose) = to.point(three(pose).cast<double>()).cast<float>();
    Eigen::Map<Eigen::Vector4f>(pose + 3) = to.rotation({q[0], q[1], q[2], q[3]}).cast<float>();
  }
}

geometry::Detail detail_of(const mimo_mesh& wanted) {
  const auto& [name, low, high] = ranges::mesh::segments;
  require(ranges::mesh::segments.has(wanted.segments) && wanted.segments % 4 == 0,
          "mesh: {} is {}, expected a multiple of 4 from {} to {}", name, wanted.segments, low, high);
  require(wanted.plane > 0 && std::isfinite(wanted.plane), "mesh: plane is {}, expected metres above 0", wanted.plane);
  check_reserved(wanted.reserved, "mesh: reserved");
  return {static_cast<int>(wanted.segments), wanted.plane};
}

void check_capacity(std::size_t capacity, std::size_t needed, const char* what) {
  if (capacity >= needed) return;
  fail(Status::kBufferTooSmall, "mesh: {} is {}, but {} are needed", what, capacity, needed);
}

void check_room(const mimo_mesh& to) {
  if (to.positions != nullptr || to.normals != nullptr || to.texcoords != nullptr) {
    check_length<float[3]>(to.vertex_capacity, "mesh: vertex_capacity");
    check_capacity(to.vertex_capacity, to.vertex_count, "vertex_capacity");
  }
  if (to.indices == nullptr) return;
  check_length<std::uint32_t>(to.index_capacity, "mesh: index_capacity");
  check_capacity(to.index_capacity, to.index_count, "index_capacity");
}

void copy(const geometry::Mesh& mesh, const geometry::Conversion& to, const mimo_mesh& where) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const geometry::Vertex& vertex = mesh.vertices[i];
    if (where.positions != nullptr) three(where.positions + 3 * i) = to.point(vertex.place).cast<float>();
    if (where.normals != nullptr) three(where.normals + 3 * i) = to.direction(vertex.normal).cast<float>();
    if (where.texcoords != nullptr) {
      Eigen::Map<Eigen::Vector2f>(where.texcoords + 2 * i) = vertex.texture.cast<float>();
    }
  }
  if (where.indices == nullptr) return;
  std::copy(mesh.indices.begin(), mesh.indices.end(), where.indices);
  if (!to.flips()) return;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(where.indices[i + 1], where.indices[i + 2]);
}

void copy_color(const float* from, float* to) { std::copy_n(from, 3, to); }

void headlight(const mjModel& model, mimo_light& light) {
  const auto& head = model.vis.headlight;
  light.active = head.active != 0 ? 1 : 0;
  light.directional = 1;
  light.cutoff = 180;
  light.attenuation[0] = 1;
  copy_color(head.ambient, light.ambient);
  copy_color(head.diffuse, light.diffuse);
  copy_color(head.specular, light.specular);
}

void light_of(const env::World& world, int id, const geometry::Conversion& to, mimo_light& light) {
  const mjModel& model = world.model();
  engine::Present present;
  const mjData& now = present.of(world.physics());
  light.active = model.light_active[id] != 0 ? 1 : 0;
  light.directional = compat::is_directional(model, id) ? 1 : 0;
  light.casts_shadow = model.light_castshadow[id] != 0 ? 1 : 0;
  light.cutoff = model.light_cutoff[id];
  light.exponent = model.light_exponent[id];
  three(light.position) = to.point(Eigen::Map<const Eigen::Vector3d>(now.light_xpos + 3 * id)).cast<float>();
  three(light.direction) = to.direction(Eigen::Map<const Eigen::Vector3d>(now.light_xdir + 3 * id)).cast<float>();
  copy_color(model.light_ambient + 3 * id, light.ambient);
  copy_color(model.light_diffuse + 3 * id, light.diffuse);
  copy_color(model.light_specular + 3 * id, light.specular);
  copy_color(model.light_attenuation + 3 * id, light.attenuation);
}

mimo_mesh default_mesh() {
  mimo_mesh mesh{};
  mesh.struct_size = sizeof mesh;
  mesh.segments = 24;
  mesh.plane = 20;
  return mesh;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_convert_points(int32_t axes, float* points, size_t point_count) noexcept {
  return guard([&] {
    const geometry::Conversion to = conversion(axes, "axes");
    convert_each(points, point_count, "points", [&to](const Eigen::Vector3d& p) { return to.point(p); });
  });
}

mimo_status mimo_convert_directions(int32_t axes, float* directions, size_t direction_count) noexcept {
  return guard([&] {
    const geometry::Conversion to = conversion(axes, "axes");
    convert_each(directions, direction_count, "directions",
                 [&to](const Eigen::Vector3d& v) { return to.direction(v); });
  });
}

mimo_status mimo_convert_poses(int32_t axes, float* poses, size_t pose_count) noexcept {
  return guard([&] {
    check_length<float[7]>(pose_count, "poses");
    convert_poses(conversion(axes, "axes"), array(poses, 7 * pose_count, "poses"));
  });
}

mimo_status mimo_env_poses(const mimo_env* env, int32_t kind, int32_t axes, float* poses, size_t value_count) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    const access::Quantity& quantity = access::quantity_of(pose_of(kind));
    const geometry::Conversion to = conversion(axes, "axes");
    const access::Ids all = ids_of(world, quantity, nullptr, 0);
    const Span<float> where = array(poses, value_count, "poses");
    check_exact(value_count, access::width(world, quantity, all), "value_count");
    access::get(world, quantity, all, true, where);
    convert_poses(to, where);
  });
}

mimo_status mimo_mesh_init(mimo_mesh* mesh, size_t size) noexcept {
  return guard([&] { write_struct(mesh, size, default_mesh(), "mesh"); });
}

mimo_status mimo_env_mesh(const mimo_env* env, int32_t geom, mimo_mesh* mesh) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world().model();
    check_element(geom, model.ngeom, "geom");
    require(mesh != nullptr, "mesh is NULL");
    mimo_mesh ours = read_struct(mesh, "mesh");
    const geometry::Conversion to = conversion(ours.axes, "mesh: axes");
    const geometry::Mesh made = geometry::mesh_of(model, geom, detail_of(ours));
    ours.vertex_count = made.vertices.size();
    ours.index_count = made.indices.size();
    check_room(ours);
    write_back(mesh, ours, "mesh");
    copy(made, to, ours);
  });
}

mimo_status mimo_env_appearance(const mimo_env* env, int32_t geom, mimo_appearance* appearance) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world().model();
    check_element(geom, model.ngeom, "geom");
    const geometry::Material found = geometry::material_of(model, geom);
    mimo_appearance ours{};
    ours.visible = found.visible ? 1 : 0;
    ours.group = found.group;
    ours.texture = found.paint.texture;
    std::copy(found.paint.color.begin(), found.paint.color.end(), ours.color);
    ours.emission = found.paint.emission;
    ours.specular = found.paint.specular;
    ours.shininess = found.paint.shininess;
    ours.reflectance = found.paint.reflectance;
    write_described(appearance, ours, "appearance");
  });
}

mimo_status mimo_env_texture_count(const mimo_env* env, size_t* count) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world().model();
    out(count, "count") = static_cast<size_t>(model.ntex);
  });
}

mimo_status mimo_env_texture(const mimo_env* env, int32_t texture_id, mimo_texture* texture) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world().model();
    check_element(texture_id, model.ntex, "texture_id");
    require(texture != nullptr, "texture is NULL");
    mimo_texture ours = read_struct(texture, "texture");
    const geometry::TextureSize size = geometry::size_of(model, texture_id);
    ours.type = static_cast<std::int32_t>(size.type);
    ours.width = static_cast<std::uint32_t>(size.width);
    ours.height = static_cast<std::uint32_t>(size.height);
    const std::size_t bytes = std::size_t{4} * ours.width * ours.height;
    check_buffer(ours.pixels, ours.pixel_bytes, bytes, "texture: pixels");
    write_back(texture, ours, "texture");
    if (ours.pixels != nullptr) geometry::read_pixels(model, texture_id, {ours.pixels, bytes});
  });
}

mimo_status mimo_env_light(const mimo_env* env, int32_t id, mimo_light* light) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    if (id != MIMO_HEADLIGHT) check_element(id, world.model().nlight, "id");
    require(light != nullptr, "light is NULL");
    const mimo_light asked = read_struct(light, "light");
    check_reserved(asked.reserved, "light: reserved");
    const geometry::Conversion to = conversion(asked.axes, "light: axes");
    mimo_light ours{};
    ours.axes = asked.axes;
    if (id == MIMO_HEADLIGHT)
      headlight(world.model(), ours);
    else
      light_of(world, id, to, ours);
    write_back(light, ours, "light");
  });
}

}  // extern "C"
