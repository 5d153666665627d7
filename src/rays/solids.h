// The solids of a frame: the geoms, sites and extras that MuJoCo shows.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "rays/materials.h"
#include "rays/meshes.h"
#include "rays/vectors.h"

namespace mimo::render {
struct View;
}

namespace mimo::rays {

struct Assets;
class Extras;

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
  // Both belong to one model; the assets outlive this.
  Solids(const mjModel& model, const Assets& assets);
  ~Solids();
  Solids(const Solids&) = delete;
  Solids& operator=(const Solids&) = delete;

  // What is to be drawn now from this view. Throws Status::kRender.
  void gather(const mjModel& model, const mjData& data, const render::View& view);

  const Solid& operator[](int i) const { return solids_[i]; }
  int count() const { return count_; }
  std::size_t most() const { return solids_.size(); }
  bool meshes() const { return meshes_; }  // whether there are any among them
  int mirror() const { return mirror_; }   // the first that reflects, -1 for none
  int ground() const { return ground_; }   // the first endless plane, -1 for none

 private:
  struct Element;

  void add(const mjModel& model, const Element& element, const Vec& eye);
  void add_extras(const mjModel& model, const Vec& eye);

  const Assets& assets_;
  std::unique_ptr<Extras> extras_;  // null where the model has none
  std::vector<Solid> solids_;
  int count_ = 0;
  bool meshes_ = false;
  int mirror_ = -1;
  int ground_ = -1;
};

}  // namespace mimo::rays
