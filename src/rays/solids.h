// The solids of a frame: the geoms, sites and extras that a picture shows.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/span.h"
#include "rays/materials.h"
#include "rays/meshes.h"
#include "rays/vectors.h"
#include "render/stage.h"

namespace mimo::render {
struct View;
}

namespace mimo::rays {

struct Assets;

// What a picture shows beside geoms and sites: pieces of tendons, surfaces, a marker.
struct Extra {
  int type = render::kSphereShape;  // a ShapeType
  double size[3] = {0, 0, 0};
  double position[3] = {0, 0, 0};
  double rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  int material = -1;
  const float* rgba = nullptr;  // 4
  const Mesh* mesh = nullptr;   // of a surface, around its position
  std::int32_t id = -1;         // what segmentation shows
};

struct Solid {
  Form kind = Form::kSphere;
  std::int32_t id = -1;         // what segmentation shows
  std::array<float, 3> size{};  // of a mesh: half of the box around it
  const Mesh* mesh = nullptr;
  Vec position = Vec::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
  double radius = 0;  // of the bounding sphere; 0 for planes
  Material material;
  bool transparent = false;
  double order = 0;  // of transparent solids: distance by which they are sorted
};

inline Vec to_local(const Solid& solid, const Vec& v) { return seen_from(solid.rotation, v); }

class Solids {
 public:
  // For so many at most; the assets outlive this.
  Solids(std::size_t most, const Assets& assets) : assets_(assets), solids_(most) {}
  Solids(const Solids&) = delete;
  Solids& operator=(const Solids&) = delete;

  // What is to be drawn now from this view.
  void gather(const render::Stage& stage, const render::Poses& poses, Span<const Extra> extras,
              const render::View& view);

  const Solid& operator[](int i) const { return solids_[i]; }
  int count() const { return count_; }
  std::size_t most() const { return solids_.size(); }
  bool meshes() const { return meshes_; }  // whether there are any among them
  int mirror() const { return mirror_; }   // the first that reflects, -1 for none
  int ground() const { return ground_; }   // the first endless plane, -1 for none

 private:
  struct Element;

  void add_shapes(const render::Stage& stage, const render::Shapes& shapes, const render::Places& places,
                  const Vec& eye);
  void add(const render::Materials& materials, const Element& element, const Vec& eye);

  const Assets& assets_;
  std::vector<Solid> solids_;
  int count_ = 0;
  bool meshes_ = false;
  int mirror_ = -1;
  int ground_ = -1;
};

}  // namespace mimo::rays
