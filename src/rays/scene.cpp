#include "render/ray/scene.h"

#include <algorithm>
#include <cmath>

#include "render/ray/aspects.h"
#include "render/ray/lights.h"
#include "render/ray/materials.h"
#include "render/ray/vectors.h"

namespace mimo::render::ray {
namespace {

void place_camera(const View& view, double aspect_ratio, Scene& scene) {
  scene.camera.rays = Rays::kPerspective;
  scene.camera.position = view.position;
  scene.camera.axes[0] = column(view.rotation, 0);
  scene.camera.axes[1] = column(view.rotation, 1);
  scene.camera.axes[2] = column(view.rotation, 2);
  for (double& v : scene.camera.axes[2]) v = -v;
  scene.camera.reach = scene.far_plane;
  scene.camera.high = std::tan(view.fovy * kPi / 360);
  scene.camera.wide = scene.camera.high * aspect_ratio;
  scene.camera.count = 0;
}

// One geom or site, as MuJoCo stores it, or one of the extras.
struct Element {
  int type, id;  // id: what segmentation shows
  const double *size, *position, *rotation;
  int material;
  const float* rgba;
  bool is_geom;
  const Mesh* mesh;  // of a mesh, height field or skin
};

bool kind_of(int type, Kind& kind) {
  switch (type) {
    case mjGEOM_PLANE: kind = Kind::kPlane; return true;
    case mjGEOM_SPHERE: kind = Kind::kSphere; return true;
    case mjGEOM_CAPSULE: kind = Kind::kCapsule; return true;
    case mjGEOM_ELLIPSOID: kind = Kind::kEllipsoid; return true;
    case mjGEOM_CYLINDER: kind = Kind::kCylinder; return true;
    case mjGEOM_BOX: kind = Kind::kBox; return true;
    case mjGEOM_MESH:
    case mjGEOM_HFIELD:
    case mjGEOM_SKIN: kind = Kind::kMesh; return true;
    default: return false;
  }
}

double bounding_radius(Kind kind, const std::array<float, 3>& size) {
  switch (kind) {
    case Kind::kPlane: return 0;
    case Kind::kSphere: return size[0];
    case Kind::kCapsule: return static_cast<double>(size[0]) + size[1];
    case Kind::kEllipsoid: return std::max({size[0], size[1], size[2]});
    case Kind::kCylinder: return std::hypot(size[0], size[1]);
    case Kind::kBox:
    case Kind::kMesh: return std::hypot(size[0], size[1], size[2]);
  }
  return 0;
}

// Not where a simulation has come to grief.
bool has_place(const Element& element) {
  return std::all_of(element.position, element.position + 3, is_near) &&
         std::all_of(element.rotation, element.rotation + 9, is_near);
}

void add_solid(const mjModel& model, const Assets& assets, const Element& element, Scene& scene) {
  Solid solid;
  if (!kind_of(element.type, solid.kind) || !has_place(element)) return;
  solid.id = element.id;
  for (int k = 0; k < 3; ++k) solid.size[k] = static_cast<float>(std::min(element.size[k], kFarthest));
  std::copy_n(element.position, 3, solid.position.begin());
  std::copy_n(element.rotation, 9, solid.rotation.begin());
  const bool plane = solid.kind == Kind::kPlane;
  const bool prescaled = element.is_geom && (plane || solid.kind == Kind::kMesh);
  solid.mesh = element.mesh;
  const bool given = solid.mesh != nullptr && solid.mesh->textured;
  solid.material =
      material_of(model, element.material, element.rgba, {solid.kind, solid.size, prescaled, given}, assets.textures);
  if (solid.material.alpha == 0) return;
  if (element.type == mjGEOM_SKIN && !given) solid.material.mapping = Mapping::kNone;
  if (solid.kind == Kind::kMesh) {
    if (solid.mesh == nullptr || solid.mesh->nodes.empty()) return;
    solid.size = solid.mesh->half;
    scene.meshes = true;
  }
  solid.radius = bounding_radius(solid.kind, solid.size);
  const Vec offset = minus(solid.position, scene.camera.position);
  const bool behind = plane && dot(offset, column(solid.rotation, 2)) > 0;
  solid.transparent = solid.material.alpha < 0.995F || behind;
  if (behind) solid.material.alpha *= 0.3F;
  if (solid.transparent) solid.order = plane ? 1e10 : std::sqrt(dot(offset, offset)) - solid.radius;
  if (std::isnan(solid.order)) solid.order = 0;  // the camera is nowhere; what is sorted needs an order
  const float shine = element.material >= 0 ? model.mat_reflectance[element.material] : 0;
  if (scene.mirror < 0 && shine > 0 && !solid.transparent && (plane || solid.kind == Kind::kBox)) {
    scene.mirror = scene.solid_count;
    scene.reflectance = shine;
  }
  if (scene.haze_plane < 0 && plane && element.size[0] == 0 && element.size[1] == 0) {
    scene.haze_plane = scene.solid_count;
  }
  scene.solids[scene.solid_count++] = solid;
}

// Extras are MuJoCo's visual geoms: in single precision, and with the sizes that OpenGL scales unit shapes by.
void add_extras(const mjModel& model, const Assets& assets, Scene& scene) {
  for (int i = 0; i < scene.extras->count(); ++i) {
    const mjvGeom& geom = scene.extras->geom(i);
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
      mesh = &scene.extras->skin(geom.objid, position);
    }
    add_solid(model, assets, {geom.type, -1, size, position, rotation, material, rgba, false, mesh}, scene);
  }
}

// Geoms and sites of the groups that MuJoCo shows by default, and extras.
void gather_solids(const mjModel& model, const mjData& data, const Assets& assets, Scene& scene) {
  scene.solid_count = 0;
  scene.meshes = false;
  scene.mirror = -1;
  scene.haze_plane = -1;
  for (int i = 0; i < model.ngeom; ++i) {
    if (std::clamp(model.geom_group[i], 0, 5) > 2) continue;
    add_solid(model, assets,
              {model.geom_type[i], i, model.geom_size + 3 * i, data.geom_xpos + 3 * i, data.geom_xmat + 9 * i,
               model.geom_matid[i], model.geom_rgba + 4 * i, true,
               assets.meshes.find(model.geom_type[i], model.geom_dataid[i])},
              scene);
  }
  for (int i = 0; i < model.nsite; ++i) {
    if (std::clamp(model.site_group[i], 0, 5) > 2) continue;
    add_solid(model, assets,
              {model.site_type[i], -1, model.site_size + 3 * i, data.site_xpos + 3 * i, data.site_xmat + 9 * i,
               model.site_matid[i], model.site_rgba + 4 * i, false, nullptr},
              scene);
  }
  if (scene.extras != nullptr) add_extras(model, assets, scene);
}

// What the camera sees, and in which order transparent things are drawn.
void look_around(Scene& scene) {
  scene.transparent_count = 0;
  for (int i = 0; i < scene.solid_count; ++i) look_at(scene.solids[i], i, scene.camera, scene.near_plane);
  std::fill(scene.seen.begin(), scene.seen.end(), -2);
  for (int i = 0; i < scene.camera.count; ++i) {
    scene.seen[scene.camera.aspects[i].solid] = i;
    if (scene.solids[scene.camera.aspects[i].solid].transparent) scene.transparent[scene.transparent_count++] = i;
  }
  std::sort(scene.transparent.begin(), scene.transparent.begin() + scene.transparent_count, [&](int a, int b) {
    const int i = scene.camera.aspects[a].solid;
    const int j = scene.camera.aspects[b].solid;
    return scene.solids[i].order != scene.solids[j].order ? scene.solids[i].order < scene.solids[j].order : i < j;
  });
}

// The geoms as the camera's mirror image sees them.
void hold_mirror(bool reflections, Scene& scene) {
  scene.mirrored.count = 0;
  if (scene.mirror >= 0 && reflections) {
    const Solid& solid = scene.solids[scene.mirror];
    const Vec normal = column(solid.rotation, 2);
    Vec point = solid.position;
    if (solid.kind == Kind::kBox) point = plus(point, normal, solid.size[2]);
    const double height = dot(minus(scene.camera.position, point), normal);
    if (height < 0) {
      scene.mirror = -1;
    } else {
      scene.mirrored.rays = Rays::kPerspective;
      scene.mirrored.position = plus(scene.camera.position, normal, -2 * height);
      for (int k = 0; k < 3; ++k) {
        scene.mirrored.axes[k] = plus(scene.camera.axes[k], normal, -2 * dot(scene.camera.axes[k], normal));
      }
      scene.mirrored.reach = scene.far_plane;
      scene.mirrored.wide = scene.camera.wide;
      scene.mirrored.high = scene.camera.high;
      for (int i = 0; i < scene.solid_count; ++i) {
        // Only what rises above the mirror shows in it.
        const Solid& other = scene.solids[i];
        if (i == scene.mirror) continue;
        if (other.kind != Kind::kPlane && dot(minus(other.position, point), normal) < -other.radius) continue;
        look_at(other, i, scene.mirrored, scene.near_plane);
      }
    }
  } else {
    scene.mirror = -1;
  }
}

// Sky and haze.
void hang_backdrop(const mjModel& model, const Textures& textures, const Quality& settings, Scene& scene) {
  scene.sky = settings.skybox ? textures.sky() : nullptr;
  scene.haze = false;
  scene.sky_limit = 0;
  if (scene.sky != nullptr) {
    // MuJoCo's sky is a box map turned by 90 degrees about x.
    const auto turned = [](const Vec& v) { return narrow({v[0], v[2], -v[1]}); };
    scene.sky_a = turned(scene.camera.axes[2]);
    scene.sky_bx = turned(scene.camera.axes[0]);
    scene.sky_by = turned(scene.camera.axes[1]);
    scene.sky_limit = 0.7F * scene.far_plane;
    if (settings.haze && scene.haze_plane >= 0 && !scene.solids[scene.haze_plane].transparent) {
      const Solid& plane = scene.solids[scene.haze_plane];
      const double height = dot(minus(scene.camera.position, plane.position), column(plane.rotation, 2));
      const double r = model.vis.map.haze;
      scene.haze = height >= 0 && r > 0;
      scene.haze_a = narrow(to_local(plane, scene.camera.axes[2]));
      scene.haze_bx = narrow(to_local(plane, scene.camera.axes[0]));
      scene.haze_by = narrow(to_local(plane, scene.camera.axes[1]));
      scene.haze_elevation = static_cast<float>(height / scene.sky_limit);
      scene.haze_radius = static_cast<float>(r);
      const double alpha = std::atan2(1, r);
      const double beta = 0.75 * kPi - alpha;
      scene.haze_turn = static_cast<float>(std::sqrt(0.5) * r * std::sin(alpha) / std::sin(beta));
      scene.haze_rgb = three(model.vis.rgba.haze);
    }
  }
}

void spread_fog(const mjModel& model, bool fog, Scene& scene) {
  scene.fog = fog;
  scene.fog_rgb = three(model.vis.rgba.fog);
  scene.fog_start = static_cast<float>(model.vis.map.fogstart * model.stat.extent);
  const double fog_length = (model.vis.map.fogend - model.vis.map.fogstart) * model.stat.extent;
  scene.fog_scale = static_cast<float>(fog_length > 0 ? 1 / fog_length : 0);
}

}  // namespace

Scene::Scene(const mjModel& model, const Assets& assets) {
  std::size_t room = static_cast<std::size_t>(model.ngeom + model.nsite);
  if (Extras::any(model)) {
    extras = std::make_unique<Extras>(model, assets.skins);
    room += static_cast<std::size_t>(extras->most());
  }
  solids.resize(room);
  local.resize(room * kMaxLights);
  camera.aspects.resize(room);
  mirrored.aspects.resize(room);
  transparent.resize(room);
  seen.resize(room);
  int shadows = 0;
  for (int i = 0; i < model.nlight && shadows < kMaxLights; ++i) shadows += model.light_castshadow[i] != 0;
  for (int i = 0; i < shadows; ++i) casters[i].aspects.resize(room);
}

void Scene::prepare(const mjModel& model, const mjData& data, const View& view, double aspect_ratio,
                    const Assets& assets, const Quality& settings) {
  texels = assets.textures.texels();
  near_plane = static_cast<float>(model.vis.map.znear * model.stat.extent);
  far_plane = static_cast<float>(model.vis.map.zfar * model.stat.extent);
  place_camera(view, aspect_ratio, *this);
  if (extras != nullptr) extras->update(model, data, view);
  gather_solids(model, data, assets, *this);
  look_around(*this);
  gather_lights(model, data, settings.shadows, *this);
  cast_shadows(*this);
  hold_mirror(settings.reflections, *this);
  hang_backdrop(model, assets.textures, settings, *this);
  spread_fog(model, settings.fog, *this);
}

}  // namespace mimo::render::ray
