// The lights of a frame, and what they see: whatever something else sees first lies in shadow.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rays/camera.h"

namespace mimo::rays {

constexpr int kMaxLights = 8;  // as many as fixed-function OpenGL has

struct Light {
  bool directional = false;
  bool spot = false;  // has a cutoff
  bool attenuated = false;
  bool bright = false;       // has a specular part
  std::int32_t caster = -1;  // index of its shadows, -1 for none
  Vec position = Vec::Zero();
  Vec direction = Vec::Zero();
  std::array<float, 3> ambient{}, diffuse{}, specular{}, attenuation{};
  float cos_cutoff = -1;
  Power exponent;
};

// A light in the frame of a solid.
struct LocalLight {
  std::array<float, 3> position{};   // or, for directional lights, the direction towards the light
  std::array<float, 3> direction{};  // in which it shines
};

// A light that casts shadows, as an eye.
struct Caster : Eye {
  // The camera's rays in the frame of this eye: o + t (a + x bx + y by).
  std::array<float, 3> o{}, a{}, bx{}, by{};
};

class Lights {
 public:
  // For so many solids at most.
  Lights(const render::Lights& given, std::size_t most);

  // The headlight, then the stage's lights. The camera has looked around.
  void gather(const render::Stage& stage, const render::Poses& poses, const Solids& solids, const Camera& camera,
              bool shadows);

  const Light& operator[](int i) const { return lights_[i]; }
  int count() const { return count_; }
  const LocalLight& at(int solid, int light) const {
    return local_[static_cast<std::size_t>(solid) * kMaxLights + light];
  }
  const Caster& caster(int i) const { return casters_[i]; }
  int caster_count() const { return caster_count_; }
  bool gray() const { return gray_; }         // all lights are without colour
  float ambient() const { return ambient_; }  // of a stage without lights

 private:
  void sum_up();
  void turn_to_solids(const Solids& solids);
  void cast_shadows(const Solids& solids, const Camera& camera, double sun_reach);

  std::array<Light, kMaxLights> lights_;
  int count_ = 0;
  bool gray_ = false;
  float ambient_ = 0;
  std::vector<LocalLight> local_;  // solid * kMaxLights + light
  std::array<Caster, kMaxLights> casters_;
  int caster_count_ = 0;
};

}  // namespace mimo::rays
