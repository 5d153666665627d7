// Textures with their mipmaps, immutable and shared by the renderers of one model.
#pragma once

#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>
#include <vector>

namespace mimo::rays {

struct Texture {
  static constexpr int kMaxLevels = 16;

  bool cube = false;
  bool sky = false;
  std::int32_t width = 0;  // of level 0; cube textures have square faces
  std::int32_t height = 0;
  std::int32_t levels = 0;
  // Where texel (0, 0) of each level is. Around each picture runs a border of one texel (what is beyond the edge: the
  // other side of a flat texture, the same edge of a cube's face), so rows are width + 2 texels apart, and a cube's
  // faces (width + 2) (height + 2).
  std::array<std::int32_t, kMaxLevels> origin{};
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

}  // namespace mimo::rays
