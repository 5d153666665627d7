// Textures with their mipmaps, immutable and shared by the renderers of one model.
#pragma once

#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>
#include <vector>

namespace mimo::render::ray {

struct Texture {
  static constexpr int kMaxLevels = 16;

  bool cube = false;
  bool sky = false;
  std::int32_t width = 0;   // of level 0; cube textures have square faces
  std::int32_t height = 0;
  std::int32_t levels = 0;
  // Where each level starts, in texels; the faces of a cube follow each other within a level.
  std::array<std::int32_t, kMaxLevels> offset{};
};

class Textures {
 public:
  explicit Textures(const mjModel& model);

  const Texture* find(int id) const { return id < 0 || id >= count() ? nullptr : &textures_[id]; }
  const Texture* sky() const;  // the first skybox, null where there is none
  int count() const { return static_cast<int>(textures_.size()); }
  // Texels are 0x00BBGGRR, row 0 first as in the model.
  const std::uint32_t* texels() const { return texels_.data(); }
  std::size_t bytes() const { return texels_.size() * sizeof(std::uint32_t); }

 private:
  std::vector<Texture> textures_;
  std::vector<std::uint32_t> texels_;
};

}  // namespace mimo::render::ray
