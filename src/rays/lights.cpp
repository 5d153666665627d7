#include "render/ray/lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/ray/aspects.h"
#include "render/ray/materials.h"
#include "render/ray/vectors.h"

namespace mimo::render::ray {
namespace {

Light headlight(const mjModel& model, const Vec& direction) {
  Light light;
  light.directional = true;
  light.direction = direction;
  light.ambient = three(model.vis.headlight.ambient);
  light.diffuse = three(model.vis.headlight.diffuse);
  light.specular = three(model.vis.headlight.specular);
  return light;
}

Light light_of(const mjModel& model, const mjData& data, int i) {
  Light light;
  light.directional = model.light_directional[i] != 0;
  std::copy_n(data.light_xpos + 3 * i, 3, light.position.begin());
  std::copy_n(data.light_xdir + 3 * i, 3, light.direction.begin());
  light.ambient = three(model.light_ambient + 3 * i);
  light.diffuse = three(model.light_diffuse + 3 * i);
  light.specular = three(model.light_specular + 3 * i);
  light.attenuation = three(model.light_attenuation + 3 * i);
  if (light.directional) return light;
  const double cutoff = model.light_cutoff[i];
  light.spot = cutoff < 180;
  light.cos_cutoff = static_cast<float>(std::cos(cutoff * kPi / 180));
  light.exponent = power(model.light_exponent[i]);
  light.attenuated = light.attenuation[0] != 1 || light.attenuation[1] != 0 || light.attenuation[2] != 0;
  return light;
}

// A light as an eye.
void open_eye(const Light& light, double cutoff, Eye& eye) {
  eye.position = light.position;
  eye.axes[2] = unit(light.direction);
  const Vec helper = std::abs(eye.axes[2][0]) < 0.7 ? Vec{1, 0, 0} : Vec{0, 1, 0};
  eye.axes[0] = unit(cross(helper, eye.axes[2]));
  eye.axes[1] = cross(eye.axes[2], eye.axes[0]);
  eye.rays = light.directional ? Rays::kParallel : light.spot && cutoff <= 80 ? Rays::kPerspective : Rays::kAround;
}

// What shading would else find out anew for every pixel.
void sum_up(Scene& scene) {
  scene.ambient = scene.light_count == 0 ? 0.3F : 0.0F;
  scene.gray = true;
  for (int i = 0; i < scene.light_count; ++i) {
    Light& light = scene.lights[i];
    for (const auto* rgb : {&light.ambient, &light.diffuse, &light.specular}) {
      scene.gray = scene.gray && (*rgb)[0] == (*rgb)[1] && (*rgb)[1] == (*rgb)[2];
    }
    light.bright = light.specular[0] > 0 || light.specular[1] > 0 || light.specular[2] > 0;
  }
}

void turn_to_solids(Scene& scene) {
  for (int i = 0; i < scene.solid_count; ++i) {
    for (int k = 0; k < scene.light_count; ++k) {
      LocalLight& to = scene.local[static_cast<std::size_t>(i) * kMaxLights + k];
      const Vec direction = to_local(scene.solids[i], scene.lights[k].direction);
      to.direction = narrow(direction);
      to.position = scene.lights[k].directional
                        ? narrow({-direction[0], -direction[1], -direction[2]})
                        : narrow(to_local(scene.solids[i], minus(scene.lights[k].position, scene.solids[i].position)));
    }
  }
}

// An unlimited opaque plane never comes between a light and what a camera on the same side sees.
bool never_shades(const Solid& solid, const Eye& light, const Eye& camera) {
  if (solid.kind != Kind::kPlane || solid.size[0] > 0 || solid.size[1] > 0 || solid.transparent) return false;
  const Vec normal = column(solid.rotation, 2);
  const double light_side =
      light.rays == Rays::kParallel ? -dot(light.axes[2], normal) : dot(minus(light.position, solid.position), normal);
  return light_side * dot(minus(camera.position, solid.position), normal) > 0;
}

}  // namespace

void gather_lights(const mjModel& model, const mjData& data, bool shadows, Scene& scene) {
  scene.light_count = 0;
  scene.caster_count = 0;
  if (model.vis.headlight.active) scene.lights[scene.light_count++] = headlight(model, scene.camera.axes[2]);
  for (int i = 0; i < model.nlight && scene.light_count < kMaxLights; ++i) {
    if (!model.light_active[i]) continue;
    Light light = light_of(model, data, i);
    if (shadows && model.light_castshadow[i]) {
      light.caster = scene.caster_count++;
      open_eye(light, model.light_cutoff[i], scene.casters[light.caster]);
    }
    scene.lights[scene.light_count++] = light;
  }
  sum_up(scene);
  turn_to_solids(scene);
}

void cast_shadows(Scene& scene) {
  const Eye& camera = scene.camera;
  for (int k = 0; k < scene.caster_count; ++k) {
    Eye& eye = scene.casters[k];
    eye.count = 0;
    eye.reach = eye.wide = eye.high = std::numeric_limits<double>::max();
    for (int i = 0; i < scene.solid_count; ++i) {
      if (never_shades(scene.solids[i], eye, camera)) continue;
      // MuJoCo lets transparent things cast shadows, too. A light of parallel rays shines from infinitely far away.
      look_at(scene.solids[i], i, eye, eye.rays == Rays::kParallel ? -kEverywhere : 0.0);
    }
    for (int i = 0; i < eye.count; ++i) eye.aspects[i].self = scene.seen[eye.aspects[i].solid];
    const auto turn = [&eye](const Vec& v) {
      return narrow({dot(eye.axes[0], v), dot(eye.axes[1], v), dot(eye.axes[2], v)});
    };
    eye.o = turn(minus(camera.position, eye.position));
    eye.a = turn(camera.axes[2]);
    eye.bx = turn(camera.axes[0]);
    eye.by = turn(camera.axes[1]);
  }
}

}  // namespace mimo::render::ray
