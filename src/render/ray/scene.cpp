#include "render/ray/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mimo::render::ray {
namespace {

using Vec = std::array<double, 3>;

constexpr double kPi = 3.14159265358979323846;

double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec plus(const Vec& a, const Vec& b, double k) { return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]}; }
Vec column(const std::array<double, 9>& m, int k) { return {m[k], m[3 + k], m[6 + k]}; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec unit(const Vec& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? Vec{a[0] / length, a[1] / length, a[2] / length} : Vec{0, 0, 1};
}
Vec to_local(const Solid& solid, const Vec& v) {
  return {dot(column(solid.rotation, 0), v), dot(column(solid.rotation, 1), v), dot(column(solid.rotation, 2), v)};
}
std::array<float, 3> narrow(const Vec& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
std::array<float, 3> three(const float* v) { return {v[0], v[1], v[2]}; }

Power power(double exponent) {
  Power p;
  p.exponent = static_cast<float>(exponent);
  const double rounded = std::round(exponent);
  const bool whole = std::abs(rounded - exponent) < 1e-4 || exponent > 8;
  p.whole = whole ? static_cast<std::int32_t>(rounded) : -1;
  return p;
}

// Bounds of what an eye sees, gathered from points with a spread: ellipsoids (also flat ones) and corners.
class Bounds {
 public:
  Bounds(bool parallel, double near_depth) : parallel_(parallel), near_(near_depth) {}

  // An ellipsoid around c in the eye's frame whose extent in direction n is sqrt(n' M n).
  void add(const Vec& c, double xx, double yy, double zz, double xz, double yz) {
    const double depth = std::sqrt(std::max(zz, 0.0));
    nearest_ = std::min(nearest_, c[2] - depth);
    farthest_ = std::max(farthest_, c[2] + depth);
    box_[0].extend(c[0], std::sqrt(std::max(xx, 0.0)));
    box_[1].extend(c[1], std::sqrt(std::max(yy, 0.0)));
    if (parallel_ || nearest_ <= near_) return;
    tangents(slope_[0], c[0], c[2], xx, zz, xz);
    tangents(slope_[1], c[1], c[2], yy, zz, yz);
  }

  // An unlimited plane.
  void add_everything() {
    nearest_ = -kAll;
    farthest_ = kAll;
    box_[0].extend(0, kAll);
    box_[1].extend(0, kAll);
  }

  bool cut() const { return nearest_ <= near_; }  // some of it is too near
  double low(int k) const {
    if (parallel_) return box_[k].low;
    if (!cut()) return slope_[k].low;
    // What is left of a box when it is cut off at the near plane.
    return box_[k].low / (box_[k].low < 0 ? near_ : farthest_);
  }
  double high(int k) const {
    if (parallel_) return box_[k].high;
    if (!cut()) return slope_[k].high;
    return box_[k].high / (box_[k].high > 0 ? near_ : farthest_);
  }
  double nearest() const { return nearest_; }
  double farthest() const { return farthest_; }

  static constexpr double kAll = 1e9;

 private:
  struct Range {
    double low = kAll;
    double high = -kAll;

    void extend(double middle, double half) {
      low = std::min(low, middle - half);
      high = std::max(high, middle + half);
    }
  };

  // Slopes s = x / z of the lines through the eye that touch the ellipse: (x - s z)^2 = xx - 2 s xz + s^2 zz.
  static void tangents(Range& range, double x, double z, double xx, double zz, double xz) {
    const double a = z * z - zz;
    const double b = x * z - xz;
    const double c = x * x - xx;
    range.extend(b / a, std::sqrt(std::max(b * b - a * c, 0.0)) / a);
  }

  bool parallel_;
  double near_;
  Range box_[2];
  Range slope_[2];
  double nearest_ = kAll;
  double farthest_ = -kAll;
};

// The direction from a point of a solid's surface to `eye`, such that the solid lies behind the plane through that
// point across it; zero if the eye is inside. All in the solid's frame. (For a plane, which has no inside: zero.)
Vec away_from(const Solid& solid, const Vec& eye) {
  const double s0 = solid.size[0];
  const double s1 = solid.size[1];
  const double s2 = solid.size[2];
  const Vec none = {0, 0, 0};
  switch (solid.kind) {
    case Kind::kPlane: return none;
    case Kind::kSphere: return dot(eye, eye) > s0 * s0 ? eye : none;
    case Kind::kEllipsoid: {
      const Vec n = {eye[0] / (s0 * s0), eye[1] / (s1 * s1), eye[2] / (s2 * s2)};
      return dot(eye, n) > 1 ? n : none;
    }
    case Kind::kCapsule: {
      const Vec n = {eye[0], eye[1], eye[2] - std::clamp(eye[2], -s1, s1)};
      return dot(n, n) > s0 * s0 ? n : none;
    }
    case Kind::kCylinder: {
      const double r = std::hypot(eye[0], eye[1]);
      const double aside = r > s0 ? 1 - s0 / r : 0;
      return {eye[0] * aside, eye[1] * aside, eye[2] - std::clamp(eye[2], -s1, s1)};
    }
    case Kind::kBox:
      return {eye[0] - std::clamp(eye[0], -s0, s0), eye[1] - std::clamp(eye[1], -s1, s1),
              eye[2] - std::clamp(eye[2], -s2, s2)};
  }
  return none;
}

// Adds a solid to what an eye sees, unless all of it is behind the eye or too far away.
void look_at(const Solid& solid, int index, Eye& eye, double near_depth) {
  const Vec offset = minus(solid.position, eye.position);
  const Vec c = {dot(eye.axes[0], offset), dot(eye.axes[1], offset), dot(eye.axes[2], offset)};
  Vec axis[3];  // of the solid in the eye's frame
  for (int k = 0; k < 3; ++k) {
    const Vec world = column(solid.rotation, k);
    axis[k] = {dot(eye.axes[0], world), dot(eye.axes[1], world), dot(eye.axes[2], world)};
  }
  Aspect aspect;
  aspect.solid = index;
  Bounds bounds(eye.rays == Rays::kParallel, near_depth);
  const double s0 = solid.size[0];
  const double s1 = solid.size[1];
  const double s2 = solid.size[2];
  const auto ball = [&](const Vec& at, double r) { bounds.add(at, r * r, r * r, r * r, 0, 0); };
  switch (solid.kind) {
    case Kind::kPlane:
      if (s0 > 0 && s1 > 0) {
        for (int k = 0; k < 4; ++k) {
          bounds.add(plus(plus(c, axis[0], k & 1 ? s0 : -s0), axis[1], k & 2 ? s1 : -s1), 0, 0, 0, 0, 0);
        }
      } else {
        bounds.add_everything();
      }
      break;
    case Kind::kSphere:
      ball(c, s0);
      break;
    case Kind::kCapsule:
      ball(plus(c, axis[2], s1), s0);
      ball(plus(c, axis[2], -s1), s0);
      break;
    case Kind::kEllipsoid: {
      double m[5] = {0, 0, 0, 0, 0};
      for (int k = 0; k < 3; ++k) {
        const double square = solid.size[k] * static_cast<double>(solid.size[k]);
        m[0] += square * axis[k][0] * axis[k][0];
        m[1] += square * axis[k][1] * axis[k][1];
        m[2] += square * axis[k][2] * axis[k][2];
        m[3] += square * axis[k][0] * axis[k][2];
        m[4] += square * axis[k][1] * axis[k][2];
      }
      bounds.add(c, m[0], m[1], m[2], m[3], m[4]);
      break;
    }
    case Kind::kCylinder: {
      const Vec& z = axis[2];
      const double r = s0 * s0;
      for (int side = -1; side <= 1; side += 2) {
        bounds.add(plus(c, z, side * s1), r * (1 - z[0] * z[0]), r * (1 - z[1] * z[1]), r * (1 - z[2] * z[2]),
                   -r * z[0] * z[2], -r * z[1] * z[2]);
      }
      break;
    }
    case Kind::kBox:
      for (int k = 0; k < 8; ++k) {
        bounds.add(plus(plus(plus(c, axis[0], k & 1 ? s0 : -s0), axis[1], k & 2 ? s1 : -s1), axis[2],
                        k & 4 ? s2 : -s2), 0, 0, 0, 0, 0);
      }
      break;
  }
  const bool directed = eye.rays != Rays::kAround;
  if (directed && (bounds.farthest() < near_depth || bounds.nearest() > eye.reach)) return;
  // A hair of slack for what is rounded below.
  const auto slack = [](double v) { return 1e-5 * (1 + std::abs(v)); };
  aspect.left = static_cast<float>(bounds.low(0) - slack(bounds.low(0)));
  aspect.right = static_cast<float>(bounds.high(0) + slack(bounds.high(0)));
  aspect.bottom = static_cast<float>(bounds.low(1) - slack(bounds.low(1)));
  aspect.top = static_cast<float>(bounds.high(1) + slack(bounds.high(1)));
  aspect.nearest = static_cast<float>(std::max(bounds.nearest() - slack(bounds.nearest()), -Bounds::kAll));
  aspect.center = narrow(c);
  aspect.radius = static_cast<float>(solid.kind == Kind::kPlane ? Bounds::kAll : solid.radius);

  if (directed && (aspect.left > eye.wide || aspect.right < -eye.wide || aspect.bottom > eye.high ||
                   aspect.top < -eye.high)) {
    return;
  }

  const Vec from_solid = to_local(solid, minus(eye.position, solid.position));
  const Vec right = to_local(solid, eye.axes[0]);
  const Vec up = to_local(solid, eye.axes[1]);
  const Vec ahead = to_local(solid, eye.axes[2]);
  if (eye.rays == Rays::kPerspective && bounds.cut() && solid.kind != Kind::kPlane) {
    const Vec away = away_from(solid, from_solid);
    if (dot(away, away) == 0) return;  // seen from inside: not at all
    const double middle = dot(away, ahead);
    const double x = dot(away, right);
    const double y = dot(away, up);
    if (middle - std::abs(x) * eye.wide - std::abs(y) * eye.high >= 0) return;
    aspect.facing = narrow({middle, x, y});
  }
  aspect.bx = narrow(right);
  aspect.by = narrow(up);
  const std::array<float, 3> forward = narrow(ahead);
  if (eye.rays == Rays::kParallel) {
    aspect.a = narrow(from_solid);
    aspect.o = forward;
  } else {
    aspect.o = narrow(from_solid);
    aspect.a = forward;
  }

  // Nearest first: few solids, mostly in order already.
  int place = eye.count++;
  while (place > 0 && eye.aspects[place - 1].nearest > aspect.nearest) {
    eye.aspects[place] = eye.aspects[place - 1];
    --place;
  }
  eye.aspects[place] = aspect;
}

Material material_of(const mjModel& model, int id, const float* rgba, Kind kind, const std::array<float, 3>& size,
                     bool is_plane_geom, const Textures& textures) {
  Material material;
  const float* color = rgba;
  // MuJoCo takes an element's own colour only where it differs from the default.
  const bool is_default = rgba[0] == 0.5F && rgba[1] == 0.5F && rgba[2] == 0.5F && rgba[3] == 1.0F;
  float emission = 0;
  double shininess = 0.5;
  material.specular = 0.5F;
  if (id >= 0) {
    if (is_default) color = model.mat_rgba + 4 * id;
    emission = model.mat_emission[id];
    material.specular = model.mat_specular[id];
    shininess = model.mat_shininess[id];
    material.texture = textures.find(model.mat_texid[id]);
  }
  material.rgb = three(color);
  material.alpha = color[3];
  for (int k = 0; k < 3; ++k) material.emission[k] = emission * color[k];
  material.shininess = power(128 * shininess);
  if (material.texture == nullptr) return material;

  // OpenGL's object coordinates are those of a unit shape that is then scaled, except for planes of the model.
  const bool uniform = model.mat_texuniform[id] != 0;
  float scale[3];  // what the unit shape is scaled by
  switch (kind) {
    case Kind::kSphere: scale[0] = scale[1] = scale[2] = size[0]; break;
    case Kind::kCapsule:
    case Kind::kCylinder: scale[0] = scale[1] = size[0]; scale[2] = size[1]; break;
    default: std::copy(size.begin(), size.end(), scale); break;
  }
  const auto over = [](float a, float b) { return b > 0 ? a / b : 0.0F; };
  if (!material.texture->cube) {
    material.mapping = Mapping::kFlat;
    for (int k = 0; k < 2; ++k) {
      float repeat = model.mat_texrepeat[2 * id + k];
      if (is_plane_geom && size[k] > 0) repeat /= size[k];
      if (uniform && scale[k] > 0) repeat *= scale[k];
      material.scale[k] = (k == 0 ? 0.5F : -0.5F) * (is_plane_geom ? repeat : over(repeat, scale[k]));
    }
  } else {
    material.mapping = Mapping::kCube;
    for (int k = 0; k < 3; ++k) {
      const float factor = uniform ? scale[k] : 1.0F;
      material.scale[k] = is_plane_geom ? factor : over(factor, scale[k]);
    }
    material.fold = std::numeric_limits<float>::max();
    if (kind == Kind::kCapsule) {
      material.fold = size[1];
      material.scale[3] = over(uniform ? scale[2] : 1.0F, size[0]);
    }
  }
  return material;
}

}  // namespace

int unsupported_geom(const mjModel& model) {
  for (int i = 0; i < model.ngeom; ++i) {
    if (std::clamp(model.geom_group[i], 0, 5) > 2) continue;
    switch (model.geom_type[i]) {
      case mjGEOM_PLANE:
      case mjGEOM_SPHERE:
      case mjGEOM_CAPSULE:
      case mjGEOM_ELLIPSOID:
      case mjGEOM_CYLINDER:
      case mjGEOM_BOX: break;
      default: return i;
    }
  }
  return -1;
}

Scene::Scene(const mjModel& model) {
  const std::size_t room = static_cast<std::size_t>(model.ngeom + model.nsite);
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
                    const Textures& textures, const Settings& settings) {
  texels = textures.texels();
  near_plane = static_cast<float>(model.vis.map.znear * model.stat.extent);
  far_plane = static_cast<float>(model.vis.map.zfar * model.stat.extent);

  // The camera.
  camera.rays = Rays::kPerspective;
  camera.position = view.position;
  camera.axes[0] = column(view.rotation, 0);
  camera.axes[1] = column(view.rotation, 1);
  camera.axes[2] = column(view.rotation, 2);
  for (double& v : camera.axes[2]) v = -v;
  camera.reach = far_plane;
  camera.high = std::tan(view.fovy * kPi / 360);
  camera.wide = camera.high * aspect_ratio;
  camera.count = 0;

  // Solids: geoms and sites of the groups that MuJoCo shows by default.
  solid_count = 0;
  transparent_count = 0;
  mirror = -1;
  haze_plane = -1;
  const auto add = [&](int type, int id, const double* size, const double* position, const double* rotation,
                       int matid, const float* rgba, bool is_geom) {
    Solid solid;
    switch (type) {
      case mjGEOM_PLANE: solid.kind = Kind::kPlane; break;
      case mjGEOM_SPHERE: solid.kind = Kind::kSphere; break;
      case mjGEOM_CAPSULE: solid.kind = Kind::kCapsule; break;
      case mjGEOM_ELLIPSOID: solid.kind = Kind::kEllipsoid; break;
      case mjGEOM_CYLINDER: solid.kind = Kind::kCylinder; break;
      case mjGEOM_BOX: solid.kind = Kind::kBox; break;
      default: return;
    }
    solid.id = id;
    for (int k = 0; k < 3; ++k) solid.size[k] = static_cast<float>(size[k]);
    std::copy_n(position, 3, solid.position.begin());
    std::copy_n(rotation, 9, solid.rotation.begin());
    const bool plane = solid.kind == Kind::kPlane;
    solid.material = material_of(model, matid, rgba, solid.kind, solid.size, plane && is_geom, textures);
    if (solid.material.alpha == 0) return;
    switch (solid.kind) {
      case Kind::kPlane: solid.radius = 0; break;
      case Kind::kSphere: solid.radius = size[0]; break;
      case Kind::kCapsule: solid.radius = size[0] + size[1]; break;
      case Kind::kEllipsoid: solid.radius = std::max({size[0], size[1], size[2]}); break;
      case Kind::kCylinder: solid.radius = std::hypot(size[0], size[1]); break;
      case Kind::kBox: solid.radius = std::sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]); break;
    }
    const bool behind =
        plane && dot(minus(camera.position, solid.position), column(solid.rotation, 2)) < 0;
    solid.transparent = solid.material.alpha < 0.995F || behind;
    if (behind) solid.material.alpha *= 0.3F;
    if (solid.transparent) {
      const Vec offset = minus(solid.position, camera.position);
      solid.order = plane ? 1e10 : std::sqrt(dot(offset, offset)) - solid.radius;
    }
    const float shine = matid >= 0 ? model.mat_reflectance[matid] : 0;
    if (mirror < 0 && shine > 0 && !solid.transparent && (plane || solid.kind == Kind::kBox)) {
      mirror = solid_count;
      reflectance = shine;
    }
    if (haze_plane < 0 && plane && size[0] == 0 && size[1] == 0) haze_plane = solid_count;
    solids[solid_count++] = solid;
  };
  for (int i = 0; i < model.ngeom; ++i) {
    if (std::clamp(model.geom_group[i], 0, 5) > 2) continue;
    add(model.geom_type[i], i, model.geom_size + 3 * i, data.geom_xpos + 3 * i, data.geom_xmat + 9 * i,
        model.geom_matid[i], model.geom_rgba + 4 * i, true);
  }
  for (int i = 0; i < model.nsite; ++i) {
    if (std::clamp(model.site_group[i], 0, 5) > 2) continue;
    add(model.site_type[i], -1, model.site_size + 3 * i, data.site_xpos + 3 * i, data.site_xmat + 9 * i,
        model.site_matid[i], model.site_rgba + 4 * i, false);
  }

  for (int i = 0; i < solid_count; ++i) look_at(solids[i], i, camera, near_plane);
  std::fill(seen.begin(), seen.end(), -2);
  for (int i = 0; i < camera.count; ++i) {
    seen[camera.aspects[i].solid] = i;
    if (solids[camera.aspects[i].solid].transparent) transparent[transparent_count++] = i;
  }
  std::sort(transparent.begin(), transparent.begin() + transparent_count, [&](int a, int b) {
    const int i = camera.aspects[a].solid;
    const int j = camera.aspects[b].solid;
    return solids[i].order != solids[j].order ? solids[i].order < solids[j].order : i < j;
  });

  // Lights: the headlight, then the scene's.
  light_count = 0;
  caster_count = 0;
  if (model.vis.headlight.active) {
    Light light;
    light.directional = true;
    light.direction = camera.axes[2];
    light.ambient = three(model.vis.headlight.ambient);
    light.diffuse = three(model.vis.headlight.diffuse);
    light.specular = three(model.vis.headlight.specular);
    lights[light_count++] = light;
  }
  for (int i = 0; i < model.nlight && light_count < kMaxLights; ++i) {
    if (!model.light_active[i]) continue;
    Light light;
    light.directional = model.light_directional[i] != 0;
    std::copy_n(data.light_xpos + 3 * i, 3, light.position.begin());
    std::copy_n(data.light_xdir + 3 * i, 3, light.direction.begin());
    light.ambient = three(model.light_ambient + 3 * i);
    light.diffuse = three(model.light_diffuse + 3 * i);
    light.specular = three(model.light_specular + 3 * i);
    light.attenuation = three(model.light_attenuation + 3 * i);
    if (!light.directional) {
      const double cutoff = model.light_cutoff[i];
      light.spot = cutoff < 180;
      light.cos_cutoff = static_cast<float>(std::cos(cutoff * kPi / 180));
      light.exponent = power(model.light_exponent[i]);
      light.attenuated =
          light.attenuation[0] != 1 || light.attenuation[1] != 0 || light.attenuation[2] != 0;
    }
    if (settings.shadows && model.light_castshadow[i]) {
      Eye& eye = casters[caster_count];
      light.caster = caster_count++;
      eye.position = light.position;
      eye.axes[2] = unit(light.direction);
      const Vec helper = std::abs(eye.axes[2][0]) < 0.7 ? Vec{1, 0, 0} : Vec{0, 1, 0};
      eye.axes[0] = unit(cross(helper, eye.axes[2]));
      eye.axes[1] = cross(eye.axes[2], eye.axes[0]);
      eye.rays = light.directional ? Rays::kParallel
                 : light.spot && model.light_cutoff[i] <= 80 ? Rays::kPerspective : Rays::kAround;
    }
    lights[light_count++] = light;
  }
  ambient = light_count == 0 ? 0.3F : 0.0F;
  gray = true;
  for (int i = 0; i < light_count; ++i) {
    Light& light = lights[i];
    for (const auto* rgb : {&light.ambient, &light.diffuse, &light.specular}) {
      gray = gray && (*rgb)[0] == (*rgb)[1] && (*rgb)[1] == (*rgb)[2];
    }
    light.bright = light.specular[0] > 0 || light.specular[1] > 0 || light.specular[2] > 0;
  }
  for (int i = 0; i < solid_count; ++i) {
    for (int k = 0; k < light_count; ++k) {
      LocalLight& to = local[static_cast<std::size_t>(i) * kMaxLights + k];
      const Vec direction = to_local(solids[i], lights[k].direction);
      to.direction = narrow(direction);
      to.position = lights[k].directional
                        ? narrow({-direction[0], -direction[1], -direction[2]})
                        : narrow(to_local(solids[i], minus(lights[k].position, solids[i].position)));
    }
  }

  // Shadows: what each light sees. An unlimited opaque plane never comes between a light and what a camera on the
  // same side sees.
  const auto never_shades = [this](const Solid& solid, const Eye& eye) {
    if (solid.kind != Kind::kPlane || solid.size[0] > 0 || solid.size[1] > 0 || solid.transparent) return false;
    const Vec normal = column(solid.rotation, 2);
    const double light_side = eye.rays == Rays::kParallel ? -dot(eye.axes[2], normal)
                                                          : dot(minus(eye.position, solid.position), normal);
    return light_side * dot(minus(camera.position, solid.position), normal) > 0;
  };
  for (int k = 0; k < caster_count; ++k) {
    Eye& eye = casters[k];
    eye.count = 0;
    eye.reach = eye.wide = eye.high = std::numeric_limits<double>::max();
    for (int i = 0; i < solid_count; ++i) {
      if (never_shades(solids[i], eye)) continue;
      // MuJoCo lets transparent things cast shadows, too. A light of parallel rays shines from infinitely far away.
      look_at(solids[i], i, eye, eye.rays == Rays::kParallel ? -Bounds::kAll : 0.0);
    }
    for (int i = 0; i < eye.count; ++i) eye.aspects[i].self = seen[eye.aspects[i].solid];
    const auto turn = [&eye](const Vec& v) {
      return narrow({dot(eye.axes[0], v), dot(eye.axes[1], v), dot(eye.axes[2], v)});
    };
    eye.o = turn(minus(camera.position, eye.position));
    eye.a = turn(camera.axes[2]);
    eye.bx = turn(camera.axes[0]);
    eye.by = turn(camera.axes[1]);
  }

  // The mirror.
  mirrored.count = 0;
  if (mirror >= 0 && settings.reflections) {
    const Solid& solid = solids[mirror];
    const Vec normal = column(solid.rotation, 2);
    Vec point = solid.position;
    if (solid.kind == Kind::kBox) point = plus(point, normal, solid.size[2]);
    const double height = dot(minus(camera.position, point), normal);
    if (height < 0) {
      mirror = -1;
    } else {
      mirrored.rays = Rays::kPerspective;
      mirrored.position = plus(camera.position, normal, -2 * height);
      for (int k = 0; k < 3; ++k) {
        mirrored.axes[k] = plus(camera.axes[k], normal, -2 * dot(camera.axes[k], normal));
      }
      mirrored.reach = far_plane;
      mirrored.wide = camera.wide;
      mirrored.high = camera.high;
      for (int i = 0; i < solid_count; ++i) {
        // Only what rises above the mirror shows in it.
        const Solid& other = solids[i];
        if (i == mirror) continue;
        if (other.kind != Kind::kPlane && dot(minus(other.position, point), normal) < -other.radius) continue;
        look_at(other, i, mirrored, near_plane);
      }
    }
  } else {
    mirror = -1;
  }

  // Sky and haze.
  sky = settings.skybox ? textures.sky() : nullptr;
  haze = false;
  sky_limit = 0;
  if (sky != nullptr) {
    // MuJoCo's sky is a box map turned by 90 degrees about x.
    const auto turned = [](const Vec& v) { return narrow({v[0], v[2], -v[1]}); };
    sky_a = turned(camera.axes[2]);
    sky_bx = turned(camera.axes[0]);
    sky_by = turned(camera.axes[1]);
    sky_limit = 0.7F * far_plane;
    if (settings.haze && haze_plane >= 0 && !solids[haze_plane].transparent) {
      const Solid& plane = solids[haze_plane];
      const double height = dot(minus(camera.position, plane.position), column(plane.rotation, 2));
      const double r = model.vis.map.haze;
      haze = height >= 0 && r > 0;
      haze_a = narrow(to_local(plane, camera.axes[2]));
      haze_bx = narrow(to_local(plane, camera.axes[0]));
      haze_by = narrow(to_local(plane, camera.axes[1]));
      haze_elevation = static_cast<float>(height / sky_limit);
      haze_radius = static_cast<float>(r);
      const double alpha = std::atan2(1, r);
      const double beta = 0.75 * kPi - alpha;
      haze_turn = static_cast<float>(std::sqrt(0.5) * r * std::sin(alpha) / std::sin(beta));
      haze_rgb = three(model.vis.rgba.haze);
    }
  }
  fog = settings.fog;
  fog_rgb = three(model.vis.rgba.fog);
  fog_start = static_cast<float>(model.vis.map.fogstart * model.stat.extent);
  const double fog_length = (model.vis.map.fogend - model.vis.map.fogstart) * model.stat.extent;
  fog_scale = static_cast<float>(fog_length > 0 ? 1 / fog_length : 0);
}

}  // namespace mimo::render::ray
