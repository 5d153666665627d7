// Triangle meshes and height fields in the form in which rays find them: immutable, shared by the renderers of a stage.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rays/vectors.h"
#include "render/surfaces.h"

namespace mimo::rays {

// A triangle as rays meet it, counter-clockwise seen from outside.
struct Triangle {
  std::array<float, 3> corner{}, edge1{}, edge2{};
};

// Triangles by their nine numbers, in blocks: a vector holds the same number of many triangles.
class Triangles {
 public:
  static constexpr std::size_t kBlock = 16;  // triangles; unused ones of the last are without size
  // Corner, edge1, edge2, of x, y, z each.
  struct Block {
    alignas(64) float number[9][kBlock]{};
  };

  void resize(std::size_t count) { blocks_.resize((count + kBlock - 1) / kBlock); }
  void set(std::size_t i, const Triangle& triangle) {
    Block& block = blocks_[i / kBlock];
    for (std::size_t k = 0; k < 3; ++k) {
      block.number[k][i % kBlock] = triangle.corner[k];
      block.number[3 + k][i % kBlock] = triangle.edge1[k];
      block.number[6 + k][i % kBlock] = triangle.edge2[k];
    }
  }
  Triangle operator[](std::size_t i) const {
    const auto three = [&block = blocks_[i / kBlock], i](std::size_t k) {
      return std::array<float, 3>{block.number[k][i % kBlock], block.number[k + 1][i % kBlock],
                                  block.number[k + 2][i % kBlock]};
    };
    return {three(0), three(3), three(6)};
  }
  const Block& block(std::size_t i) const { return blocks_[i]; }

 private:
  std::vector<Block> blocks_;
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
  std::int32_t first = 0, count = 0;  // its triangles
  std::int32_t child = 0;             // the other is the next; 0 for none
  std::int32_t axis = 0;              // along which the first child comes first
};

// Up to sixteen boxes of that tree, all of which are looked at together: those up to four levels below the box that
// this is made of, or those on the way there that bound one block of triangles or less.
struct Branch {
  static constexpr int kBoxes = 16;

  alignas(64) float low[3][kBoxes]{}, high[3][kBoxes]{};
  alignas(64) float least[3][kBoxes]{}, most[3][kBoxes]{};  // of the unit normals of the triangles in each
  std::int32_t node[kBoxes]{};                              // in the tree
  std::int32_t branch[kBoxes]{};                            // that continues it; 0 for none
  std::int32_t first[kBoxes]{};                             // triangle
  std::int32_t triangles[kBoxes]{};                         // how many
  std::int32_t count = 0;                                   // of boxes
};

struct Mesh {
  static constexpr int kDepth = 48;   // of the tree, at most
  static constexpr int kStack = 128;  // branches that wait to be looked at, at most: fifteen of each level of 24 / 4

  std::vector<Node> nodes;       // the root first; none if there are no triangles
  std::vector<Branch> branches;  // likewise
  Triangles triangles;
  std::vector<Surface> surfaces;  // of the same triangles
  std::array<float, 3> half{};    // of the box around the origin that holds it all
  bool textured = false;          // has texture coordinates of its own
};

class Meshes {
 public:
  explicit Meshes(const render::Stage& stage);

  // Null for shapes of other types.
  const Mesh* find(int shape_type, int data_id) const;

 private:
  std::vector<Mesh> meshes_, fields_;
};

// Triangles, gathered into a mesh with its tree of boxes.

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
