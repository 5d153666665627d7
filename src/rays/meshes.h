// Triangle meshes and height fields in the form in which rays find them: immutable, shared by the renderers of a model.
#pragma once

#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>
#include <vector>

namespace mimo::rays {

// A triangle as rays meet it, counter-clockwise seen from outside.
struct Triangle {
  std::array<float, 3> corner{}, edge1{}, edge2{};
};

// What is known of each point p of a triangle. It lies at  corner + u edge1 + v edge2  with u = to_u . (p - corner) and
// v = to_v . (p - corner); normals and texture coordinates are those of the corner, plus u and v times these changes.
struct Surface {
  std::array<float, 3> corner{}, to_u{}, to_v{};
  std::array<float, 3> normal{}, normal_u{}, normal_v{};
  std::array<float, 2> texture{}, texture_u{}, texture_v{};
};
constexpr int kSurfaceFloats = 24;
static_assert(sizeof(Surface) == kSurfaceFloats * sizeof(float));

// A box of the tree that bounds triangles.
struct Node {
  std::array<float, 3> low{}, high{};
  std::int32_t first = 0;  // child (the other is the next), or triangle
  std::int32_t count = 0;  // of triangles; 0 where there are children
  std::int32_t axis = 0;   // along which the first child comes first
};

struct Mesh {
  static constexpr int kDepth = 48;  // of the tree, at most

  std::vector<Node> nodes;  // the root first; none if there are no triangles
  std::vector<Triangle> triangles;
  std::vector<Surface> surfaces;  // of the same triangles
  std::array<float, 3> half{};    // of the box around the origin that holds it all
  bool textured = false;          // has texture coordinates of its own
};

class Meshes {
 public:
  explicit Meshes(const mjModel& model);

  // Null for geoms of other types.
  const Mesh* find(int geom_type, int data_id) const;

 private:
  std::vector<Mesh> meshes_, fields_;
};

}  // namespace mimo::rays
