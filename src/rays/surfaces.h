// Surfaces whose vertices move: skins, cloth, soft bodies. Their triangles lie differently in every picture.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "rays/meshes.h"
#include "rays/solids.h"
#include "rays/vectors.h"

namespace mimo::rays {

// Triangles of vertices, and of texture coordinates where there are some.
struct Faces {
  std::vector<std::array<int, 3>> vertices;
  std::vector<std::array<int, 3>> texels;  // empty: as the vertices
  const float* texcoords = nullptr;        // 2 each; null: none

  std::size_t count() const { return vertices.size(); }
};

// A surface at rest. Which triangles a box of its tree holds is settled there, once: pictures do not depend on those
// before.
class SurfacePattern {
 public:
  // Without triangles: nothing to be seen.
  SurfacePattern() = default;
  SurfacePattern(const Faces& faces, const float* vertices);

  const Mesh& mesh() const { return mesh_; }
  // Moves the corners of a copy of the mesh to where the vertices are now. Returns the place around which it lies.
  Vec drape(const float* vertices, const float* normals, Mesh& mesh) const;

 private:
  Mesh mesh_;
  std::vector<std::array<int, 3>> corners_;  // vertices of the mesh's triangles
};

// Its own copy of a surface's mesh, for one picture at a time.
struct Draped {
  const SurfacePattern* pattern;
  Mesh mesh;
  Vec place = Vec::Zero();

  explicit Draped(const SurfacePattern& of) : pattern(&of), mesh(of.mesh()) {}
  void drape(const float* vertices, const float* normals) { place = pattern->drape(vertices, normals, mesh); }
};

// A surface's vertices as they are drawn: three numbers each. Room is kept from picture to picture.
struct DrawnVertices {
  std::vector<float> places, normals;
  std::vector<Vec> smooth;  // normals of the vertices that it has otherwise
};

// From a surface as it is simulated to one as it is drawn: outside of its vertices by a radius, with normals. A sheet
// has two sides and an edge around. Vertices that are drawn are more than those that it has.
class Shell {
 public:
  struct Style {
    double radius = 0;
    bool sheet = false;
    bool flat = false;  // each triangle has one normal; else they are smooth
  };

  Shell() = default;
  // Of so many vertices. Texture coordinates outlive what is made of it.
  Shell(int vertices, Faces faces, const Style& style);

  const Faces& drawn() const { return drawn_; }
  void expand(const double* vertices, DrawnVertices& drawn) const;

 private:
  using Edge = std::array<int, 2>;
  using Three = std::array<int, 3>;

  void add_triangle(std::size_t which, int side);
  void add_edges();

  int vertices_ = 0;
  Faces faces_;
  Style style_;
  std::vector<Edge> edges_;  // of a sheet: those of one triangle only
  Faces drawn_;
};

// A capsule from one place to another; false where these are one.
bool make_rod(const Vec& from, const Vec& to, double radius, Extra& rod);

// What renderers of one stage share of a surface.
struct MovingSurface {
  MovingSurface() = default;
  // As it lies at rest. Its normals follow from its vertices.
  MovingSurface(Shell given, const double* vertices);
  // Whose normals somebody else gives.
  explicit MovingSurface(SurfacePattern given) : pattern(std::move(given)) {}

  Shell shell;
  SurfacePattern pattern;
};

}  // namespace mimo::rays
