// The parts of a stage: copies of a host's arrays, and what rays need of them. A part never changes; another one takes
// its place.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "rays/frame.h"
#include "rays/surfaces.h"
#include "render/stage.h"
#include "stage/stage.h"

namespace mimo::stage {

struct Shapes {
  Shapes(const mimo_stage_shapes& given, const char* part);

  render::Shapes view() const;

  int object_type;
  std::vector<int> forms, materials, groups, data;
  std::vector<double> sizes;
  std::vector<float> colors;
};

struct Materials {
  explicit Materials(const mimo_stage_materials& given);

  render::Materials view() const;

  std::vector<float> colors, emission, specular, shininess, reflectance, repeats;
  std::vector<int> textures;
  std::vector<unsigned char> uniform;
  bool from_corner = false;
};

struct Lights {
  explicit Lights(const mimo_stage_lights& given);

  render::Lights view() const;

  std::vector<int> types;
  std::vector<unsigned char> active, casts_shadow;
  std::vector<float> ambient, diffuse, specular, attenuation, cutoff, exponent;
};

// Ropes have rods for triangles.
struct Surface {
  int first_vertex = 0, vertices = 0;
  double radius = 0;
  std::vector<std::array<int, 2>> rods;
};

struct Surfaces {
  explicit Surfaces(const mimo_stage_surfaces& given);

  std::size_t vertices = 0;
  std::vector<Surface> all;
  std::shared_ptr<const std::vector<rays::MovingSurface>> moving;
  std::vector<float> colors;
  std::vector<int> materials, groups, objects;
};

struct Tendons {
  explicit Tendons(const mimo_stage_tendons& given);

  int object_type;
  std::vector<double> widths;
  std::vector<float> colors;
  std::vector<int> materials, groups;
};

struct Meshes {
  explicit Meshes(const mimo_stage_meshes& given);

  int count;
  std::shared_ptr<const rays::Meshes> made;
};

struct Fields {
  explicit Fields(const mimo_stage_fields& given);

  int count;
  std::shared_ptr<const rays::Meshes> made;
};

struct Textures {
  explicit Textures(const mimo_stage_textures& given);

  int count;
  std::shared_ptr<const rays::Textures> made;
};

class Parts {
 public:
  // Parts that are not given are empty.
  explicit Parts(const Given& given);
  // Those of another stage, but for what is given. Throws for what does not fit.
  Parts(const Parts& other, const Given& given);

  render::Stage view() const;
  const std::shared_ptr<const rays::Assets>& assets() const { return assets_; }
  const Shapes& geoms() const { return *geoms_; }
  const Shapes& sites() const { return *sites_; }
  const Surfaces& surfaces() const { return *surfaces_; }
  const Tendons& tendons() const { return *tendons_; }
  const Lights& lights() const { return *lights_; }
  int materials() const { return static_cast<int>(materials_->textures.size()); }

  // What of these is not drawn: one line for each reason.
  std::vector<std::string> omissions() const;

 private:
  void take(const Given& given);
  void check() const;

  std::shared_ptr<const Shapes> geoms_, sites_;
  std::shared_ptr<const Meshes> meshes_;
  std::shared_ptr<const Fields> fields_;
  std::shared_ptr<const Textures> textures_;
  std::shared_ptr<const Materials> materials_;
  std::shared_ptr<const Surfaces> surfaces_;
  std::shared_ptr<const Tendons> tendons_;
  std::shared_ptr<const Lights> lights_;
  mimo_stage_air air_ = default_air();
  std::shared_ptr<const rays::Assets> assets_;
};

}  // namespace mimo::stage
