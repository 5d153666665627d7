#include "rays/lights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/functions.h"
#include "base/numbers.h"
#include "render/stage.h"

namespace mimo::rays {
namespace {

Light headlight(const render::Air& air, const Vec& direction) {
  Light light;
  light.directional = true;
  light.direction = direction;
  light.ambient = three(air.ambient);
  light.diffuse = three(air.diffuse);
  light.specular = three(air.specular);
  return light;
}

Light light_of(const render::Lights& lights, const render::Poses& poses, int i) {
  Light light;
  light.directional = lights.is_directional(i);
  light.position = Eigen::Map<const Vec>(poses.light_positions + 3 * i);
  light.direction = Eigen::Map<const Vec>(poses.light_directions + 3 * i);
  light.ambient = three(lights.ambient + 3 * i);
  light.diffuse = three(lights.diffuse + 3 * i);
  light.specular = three(lights.specular + 3 * i);
  light.attenuation = three(lights.attenuation + 3 * i);
  if (light.directional) return light;
  const double cutoff = lights.cutoff[i];
  light.spot = cutoff < 180;
  light.cos_cutoff = static_cast<float>(fixed::cos(cutoff * kPi / 180));
  light.exponent = power(lights.exponent[i]);
  light.attenuated = light.attenuation[0] != 1 || light.attenuation[1] != 0 || light.attenuation[2] != 0;
  return light;
}

// A light as an eye.
void open_eye(const Light& light, double cutoff, Eye& eye) {
  const Vec forward = unit(light.direction);
  const Vec helper = std::abs(forward[0]) < 0.7 ? Vec(1, 0, 0) : Vec(0, 1, 0);
  const Vec right = unit(helper.cross(forward));
  eye.position = light.position;
  eye.axes << right, forward.cross(right), forward;
  eye.rays = light.directional ? Rays::kParallel : light.spot && cutoff <= 80 ? Rays::kPerspective : Rays::kAround;
}

// Whether a camera before a plane sees nothing that is behind it: the plane has no edges, or the camera is above its
// rectangle, and every other solid is before the plane or above the rectangle, too, which then hides what is behind.
bool hides_all_behind(const Solid& plane, double side, const Solids& solids, const Eye& camera) {
  const auto covers = [&plane](const Vec& at, double radius) {
    for (int k = 0; k < 2; ++k) {
      if (plane.size[k] > 0 && !(std::abs(at[k]) + radius < plane.size[k] * (1 - 1e-5))) return false;
    }
    return true;
  };
  if (plane.size[0] <= 0 && plane.size[1] <= 0) return true;
  if (!covers(to_local(plane, camera.position - plane.position), 0)) return false;
  for (int i = 0; i < solids.count(); ++i) {
    const Solid& other = solids[i];
    if (&other == &plane) continue;
    const Vec at = to_local(plane, other.position - plane.position);
    const bool before = other.kind != Form::kPlane && side * at[2] > other.radius;
    if (!before && (other.kind == Form::kPlane || !covers(at, other.radius))) return false;
  }
  return true;
}

// An opaque plane never comes between a light and what a camera on the same side sees, unless that is seen past its
// edges.
bool never_shades(const Solid& solid, const Eye& light, const Solids& solids, const Eye& camera) {
  if (solid.kind != Form::kPlane || solid.transparent || camera.rays == Rays::kParallel) return false;
  const Vec normal = solid.rotation.col(2);
  const double light_side =
      light.rays == Rays::kParallel ? -dot(light.axes.col(2), normal) : dot(light.position - solid.position, normal);
  const double camera_side = dot(camera.position - solid.position, normal);
  return light_side * camera_side > 0 && hides_all_behind(solid, camera_side < 0 ? -1 : 1, solids, camera);
}

}  // namespace

Lights::Lights(const render::Lights& given, std::size_t most) : local_(most * kMaxLights) {
  int shadows = 0;
  for (int i = 0; i < given.count && shadows < kMaxLights; ++i) shadows += given.casts_shadow[i] != 0;
  for (int i = 0; i < shadows; ++i) casters_[i].aspects.resize(most);
}

void Lights::gather(const render::Stage& stage, const render::Poses& poses, const Solids& solids, const Camera& camera,
                    bool shadows) {
  const render::Lights& given = stage.lights;
  count_ = 0;
  caster_count_ = 0;
  if (stage.air.headlight) lights_[count_++] = headlight(stage.air, camera.axes.col(2));
  for (int i = 0; i < given.count && count_ < kMaxLights; ++i) {
    if (!given.active[i]) continue;
    Light light = light_of(given, poses, i);
    if (shadows && given.casts_shadow[i]) {
      light.caster = caster_count_++;
      open_eye(light, given.cutoff[i], casters_[light.caster]);
    }
    lights_[count_++] = light;
  }
  sum_up();
  turn_to_solids(solids);
  cast_shadows(solids, camera, stage.air.sun_reach);
}

// What shading would else find out anew for every pixel.
void Lights::sum_up() {
  ambient_ = count_ == 0 ? 0.3F : 0.0F;
  gray_ = true;
  for (int i = 0; i < count_; ++i) {
    Light& light = lights_[i];
    for (const auto* rgb : {&light.ambient, &light.diffuse, &light.specular}) {
      gray_ = gray_ && (*rgb)[0] == (*rgb)[1] && (*rgb)[1] == (*rgb)[2];
    }
    light.bright = light.specular[0] > 0 || light.specular[1] > 0 || light.specular[2] > 0;
  }
}

void Lights::turn_to_solids(const Solids& solids) {
  for (int i = 0; i < solids.count(); ++i) {
    for (int k = 0; k < count_; ++k) {
      LocalLight& to = local_[static_cast<std::size_t>(i) * kMaxLights + k];
      const Vec direction = to_local(solids[i], lights_[k].direction);
      to.direction = narrow(direction);
      to.position = narrow(lights_[k].directional ? Vec(-direction)
                                                  : to_local(solids[i], lights_[k].position - solids[i].position));
    }
  }
}

void Lights::cast_shadows(const Solids& solids, const Camera& camera, double sun_reach) {
  for (int k = 0; k < caster_count_; ++k) {
    Caster& eye = casters_[k];
    eye.count = 0;
    eye.reach = eye.wide = eye.high = std::numeric_limits<double>::max();
    const bool sun = eye.rays == Rays::kParallel, near_by = sun && sun_reach > 0;
    if (near_by) eye.wide = eye.high = sun_reach;
    for (int i = 0; i < solids.count(); ++i) {
      if (never_shades(solids[i], eye, solids, camera)) continue;
      // MuJoCo lets transparent things cast shadows, too. A light of parallel rays shines from infinitely far away,
      // unless its shadows have a reach.
      eye.look_at(solids[i], i, sun && !near_by ? -kEverywhere : 0.0);
    }
    for (int i = 0; i < eye.count; ++i) eye.aspects[i].self = camera.seen[eye.aspects[i].solid];
    const auto turn = [&eye](const Vec& v) { return narrow(seen_from(eye.axes, v)); };
    eye.o = turn(camera.position - eye.position);
    eye.a = turn(camera.axes.col(2));
    eye.bx = turn(camera.axes.col(0));
    eye.by = turn(camera.axes.col(1));
  }
}

}  // namespace mimo::rays
