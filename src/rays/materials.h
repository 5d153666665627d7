// The materials and textures of solids, in the terms of the kernels.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/surfaces.h"

namespace mimo::rays {

// Textures with their mipmaps, immutable and shared by the renderers of one stage.

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
  // Throws Status::kUnsupported where they are too large.
  explicit Textures(const render::Textures& given);

  const Texture* find(int id) const { return id < 0 || id >= count() ? nullptr : &textures_[id]; }
  const Texture* sky() const;  // the first skybox, null where there is none
  int count() const { return static_cast<int>(textures_.size()); }
  // Texels are 0x00BBGGRR, row 0 first as they were given.
  const std::uint32_t* texels() const { return texels_.get(); }
  std::size_t bytes() const { return size_ * sizeof(std::uint32_t); }

 private:
  void draw(const Texture& texture, int face, const unsigned char* pixels, int channels, bool srgb);
  void repeat(const Texture& texture, int face, int earlier);

  std::vector<Texture> textures_;
  std::size_t size_ = 0;
  std::unique_ptr<std::uint32_t[]> texels_;  // large, and written in full: zeros before would cost as much again
};

// What solids are made of, in the terms of the kernels.

using render::Form;
using render::Mapping;

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
  float reflectance = 0;
  Power shininess;
  const Texture* texture = nullptr;
  render::TextureMapping mapping;
};

Power power(double exponent);

// Of a geom or site: its material (-1 for none) and its own colour.
Material material_of(const render::Materials& materials, int id, const float* rgba, const render::Shape& shape,
                     const Textures& textures);

}  // namespace mimo::rays
