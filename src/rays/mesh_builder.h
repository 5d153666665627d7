// Triangles, gathered into a mesh with its tree of boxes.
#pragma once

#include <array>
#include <vector>

#include "rays/meshes.h"
#include "rays/vectors.h"
#include "render/triangles.h"

namespace mimo::rays {

using render::Corner;
using render::Corners;

// A triangle as rays meet it and what is known of its points; false where it has no area, or is too large or too far
// away for floats: nothing of such a one is seen.
bool form(const Corners& corners, Triangle& triangle, Surface& surface);

// Boxes around triangles that have moved, in a tree that stays as it is; and the box around them all.
void refit(Mesh& mesh);

class MeshBuilder {
 public:
  // For so many triangles at most. Throws Status::kUnsupported where the kernels could not number them.
  explicit MeshBuilder(double most);

  // What is not seen is left out, unless it may be seen later.
  void add(const Corners& corners, bool keep = false);
  Mesh finish(bool textured);
  // Of each triangle of the finished mesh, when it was added.
  const std::vector<int>& order() const { return order_; }

 private:
  float middle(int triangle, int k) const;
  void split(int index, int first, int count, std::vector<Node>& nodes);

  std::vector<Triangle> triangles_;
  std::vector<Surface> surfaces_;
  std::vector<int> order_;
};

}  // namespace mimo::rays
