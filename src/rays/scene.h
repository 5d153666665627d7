// One frame as the kernels see it: every geom, light and eye brought into the form in which casting a ray is cheapest.
//
// All eyes are alike: the camera, its mirror image behind a reflecting plane, and each light that casts shadows.
// What an eye sees is parametrised by two numbers x, y (slopes right and up over depth); in the frame of a solid,
// a ray from the eye is then  o + t (a + x bx + y by)  with t the depth along the eye's axis. For the parallel rays
// of a directional light the roles are swapped: it is the origin that varies,  (a + x bx + y by) + t o.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/ray/assets.h"
#include "render/ray/extras.h"
#include "render/renderer.h"

namespace mimo::render::ray {

constexpr int kMaxLights = 8;  // as many as fixed-function OpenGL has
constexpr int kTile = 16;      // a tile is kTile x kTile rays

enum class Kind : std::int32_t { kPlane, kSphere, kCapsule, kEllipsoid, kCylinder, kBox, kMesh };

enum class Mapping : std::int32_t { kNone, kFlat, kCube, kGiven };  // kGiven: coordinates of a mesh

// x^exponent for x in 0..1: by repeated squaring where the exponent is whole or so large that it may be rounded, which
// changes the result by less than 1 / 40.
struct Power {
  float exponent = 0;
  std::int32_t whole = 0;  // the rounded exponent, -1 where it must not be rounded
};

struct Material {
  std::array<float, 3> rgb{};
  float alpha = 1;
  std::array<float, 3> emission{};
  float specular = 0;
  Power shininess;
  const Texture* texture = nullptr;
  Mapping mapping = Mapping::kNone;
  // Flat: s = scale[0] x - 1/2, t = scale[1] y - 1/2. Cube: direction = scale * (x, y, z), where the part of z beyond
  // `fold` (the round ends of a capsule) is scaled by scale[3].
  std::array<float, 4> scale{};
  float fold = 0;
};

struct Solid {
  Kind kind = Kind::kSphere;
  std::int32_t id = -1;         // what segmentation shows
  std::array<float, 3> size{};  // of a mesh: half of the box around it
  const Mesh* mesh = nullptr;
  std::array<double, 3> position{};
  std::array<double, 9> rotation{};
  double radius = 0;  // of the bounding sphere; 0 for planes
  Material material;
  bool transparent = false;
  double order = 0;  // of transparent solids: distance by which they are sorted
};

struct Light {
  bool directional = false;
  bool spot = false;  // has a cutoff
  bool attenuated = false;
  bool bright = false;       // has a specular part
  std::int32_t caster = -1;  // index of its shadows, -1 for none
  std::array<double, 3> position{};
  std::array<double, 3> direction{};
  std::array<float, 3> ambient{}, diffuse{}, specular{}, attenuation{};
  float cos_cutoff = -1;
  Power exponent;
};

// A light in the frame of a solid.
struct LocalLight {
  std::array<float, 3> position{};   // or, for directional lights, the direction towards the light
  std::array<float, 3> direction{};  // in which it shines
};

enum class Rays : std::int32_t { kPerspective, kParallel, kAround };

// A solid as an eye sees it.
struct Aspect {
  std::array<float, 3> o{}, a{}, bx{}, by{};
  float left = 0, right = 0, bottom = 0, top = 0;  // bounds of x and y
  float nearest = 0;                               // and of depth
  std::int32_t solid = 0;
  std::int32_t self = -2;  // among the camera's aspects, the one of the same solid
  // Rays with facing[0] + x facing[1] + y facing[2] > 0 lead away from the solid.
  std::array<float, 3> facing{};
  // For rays around a point: the bounding sphere, seen from the eye.
  std::array<float, 3> center{};
  float radius = 0;
};

struct Eye {
  Rays rays = Rays::kPerspective;
  std::array<double, 3> position{};
  std::array<std::array<double, 3>, 3> axes{};  // x (right), y (up), z (forward)
  double reach = 0;                             // nothing farther is of interest
  double wide = 0, high = 0;                    // nor anything outside of -wide..wide and -high..high
  std::vector<Aspect> aspects;                  // room for all solids; the first `count` count, nearest first
  int count = 0;
  // The camera's rays in the frame of this eye: o + t (a + x bx + y by).
  std::array<float, 3> o{}, a{}, bx{}, by{};
};

struct Scene {
  std::vector<Solid> solids;
  std::vector<int> seen;  // index of a solid's aspect for the camera, -2 if it has none
  int solid_count = 0;
  bool meshes = false;  // whether there are any among them
  std::array<Light, kMaxLights> lights;
  int light_count = 0;
  bool gray = false;              // all lights are without colour
  float ambient = 0;              // of a model without lights
  std::vector<LocalLight> local;  // solid * kMaxLights + light

  Eye camera;
  float near_plane = 0;
  float far_plane = 0;

  // What the one reflecting solid shows: the geoms as seen by the mirrored camera.
  int mirror = -1;  // index of the reflecting solid, -1 for none
  float reflectance = 0;
  Eye mirrored;

  std::array<Eye, kMaxLights> casters;
  int caster_count = 0;

  // Transparent solids (indices of camera aspects) in the order in which they are drawn.
  std::vector<int> transparent;
  int transparent_count = 0;

  const Texture* sky = nullptr;
  std::array<float, 3> sky_a{}, sky_bx{}, sky_by{};
  float sky_limit = 0;  // horizontal distance at which the sky hides the ground, 0 for no sky

  bool haze = false;
  int haze_plane = -1;  // the solid at whose horizon it hangs, in whose frame the rays are a + x bx + y by
  std::array<float, 3> haze_a{}, haze_bx{}, haze_by{};
  std::array<float, 3> haze_rgb{};
  float haze_radius = 0;  // relative to the sky's
  float haze_turn = 0;    // height (0..1) at which the haze is thickest
  float haze_elevation = 0;

  bool fog = false;
  std::array<float, 3> fog_rgb{};
  float fog_start = 0, fog_scale = 0;

  const std::uint32_t* texels = nullptr;

  std::unique_ptr<Extras> extras;  // null where the model has none

  Scene(const mjModel& model, const Assets& assets);
  void prepare(const mjModel& model, const mjData& data, const View& view, double aspect_ratio, const Assets& assets,
               const Quality& settings);
};

}  // namespace mimo::render::ray
