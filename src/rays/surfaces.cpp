#include "rays/surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace mimo::rays {
namespace {

template <typename Number>
Vec vertex(const Number* of, int i) {
  const Number* at = of + 3 * static_cast<std::ptrdiff_t>(i);
  return {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
}

}  // namespace

// ---- A surface at rest --------------------------------------------------------------------------------------

SurfacePattern::SurfacePattern(const Faces& faces, const float* vertices) {
  const std::vector<std::array<int, 3>>& texels = faces.texels.empty() ? faces.vertices : faces.texels;
  MeshBuilder builder(static_cast<double>(faces.count()));
  for (std::size_t i = 0; i < faces.count(); ++i) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].place = vertex(vertices, faces.vertices[i][k]);
      if (faces.texcoords == nullptr) continue;
      std::copy_n(faces.texcoords + 2 * static_cast<std::ptrdiff_t>(texels[i][k]), 2, corners[k].texture.begin());
    }
    builder.add(corners, true);
  }
  mesh_ = builder.finish(faces.texcoords != nullptr);
  for (const int i : builder.order()) corners_.push_back(faces.vertices[static_cast<std::size_t>(i)]);
}

Vec SurfacePattern::drape(const float* vertices, const float* normals, Mesh& mesh) const {
  constexpr double kMost = std::numeric_limits<double>::max();
  Vec low = Vec::Constant(kMost);
  Vec high = Vec::Constant(-kMost);
  for (const auto& triangle : corners_) {
    for (const int i : triangle) {
      const Vec v = vertex(vertices, i);
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], v[k]);
        high[k] = std::max(high[k], v[k]);
      }
    }
  }
  const Vec middle = 0.5 * low + 0.5 * high;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].place = vertex(vertices, corners_[i][k]) - middle;
      corners[k].normal = vertex(normals, corners_[i][k]);
    }
    Triangle triangle;
    if (!form(corners, triangle, mesh.surfaces[i])) triangle = {};  // no ray meets it
    mesh.triangles.set(i, triangle);
  }
  refit(mesh);
  return middle;
}

// ---- A surface as it is drawn -------------------------------------------------------------------------------

// Drawn vertices: those of the upper side, of the lower side, and four of each edge. Of flat triangles each has its own
// three; of smooth ones the sides have those of the surface.
Shell::Shell(int vertices, Faces faces, const Style& style)
    : vertices_(vertices), faces_(std::move(faces)), style_(style) {
  if (faces_.texels.empty()) faces_.texels = faces_.vertices;
  drawn_.texcoords = faces_.texcoords;
  for (int side = 0; side < (style_.sheet ? 2 : 1); ++side) {
    for (std::size_t i = 0; i < faces_.count(); ++i) add_triangle(i, side);
  }
  if (style_.sheet) add_edges();
}

void Shell::add_triangle(std::size_t which, int side) {
  const Three& corners = faces_.vertices[which];
  Three drawn{};
  for (std::size_t k = 0; k < 3; ++k) {
    const int flat = 3 * (side * static_cast<int>(faces_.count()) + static_cast<int>(which)) + static_cast<int>(k);
    drawn[k] = style_.flat ? flat : side * vertices_ + corners[k];
  }
  Three texels = faces_.texels[which];
  if (side == 1) {  // seen from below, corners go the other way round
    std::swap(drawn[1], drawn[2]);
    std::swap(texels[1], texels[2]);
  }
  drawn_.vertices.push_back(drawn);
  drawn_.texels.push_back(texels);
}

void Shell::add_edges() {
  std::map<Edge, int> triangles;  // of each edge, whichever way it goes
  const auto sorted = [](int a, int b) { return Edge{std::min(a, b), std::max(a, b)}; };
  for (const Three& corners : faces_.vertices) {
    for (std::size_t k = 0; k < 3; ++k) ++triangles[sorted(corners[k], corners[(k + 1) % 3])];
  }
  int first = 2 * (style_.flat ? 3 * static_cast<int>(faces_.count()) : vertices_);
  for (std::size_t i = 0; i < faces_.count(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = faces_.vertices[i][k], b = faces_.vertices[i][(k + 1) % 3];
      if (triangles[sorted(a, b)] != 1) continue;
      const int s = faces_.texels[i][k], t = faces_.texels[i][(k + 1) % 3];
      edges_.push_back({a, b});
      // Upper a, upper b, lower a, lower b.
      drawn_.vertices.push_back({first, first + 3, first + 1});
      drawn_.texels.push_back({s, t, t});
      drawn_.vertices.push_back({first + 3, first, first + 2});
      drawn_.texels.push_back({t, s, s});
      first += 4;
    }
  }
}

void Shell::expand(const double* vertices, DrawnVertices& drawn) const {
  const auto normal_of = [&](const Three& corners) -> Vec {
    const Vec a = vertex(vertices, corners[0]);
    return (vertex(vertices, corners[1]) - a).cross(vertex(vertices, corners[2]) - a);
  };
  drawn.smooth.assign(static_cast<std::size_t>(vertices_), Vec::Zero());
  for (const Three& corners : faces_.vertices) {
    const Vec normal = normal_of(corners);  // as long as the triangle is large
    for (const int i : corners) drawn.smooth[static_cast<std::size_t>(i)] += normal;
  }
  for (Vec& normal : drawn.smooth) normal = unit(normal);

  drawn.places.clear();
  drawn.normals.clear();
  const auto put = [&](int i, double sign, const Vec& normal) {
    const Vec place = vertex(vertices, i) + sign * style_.radius * drawn.smooth[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) {
      drawn.places.push_back(static_cast<float>(place[k]));
      drawn.normals.push_back(static_cast<float>(normal[k]));
    }
  };
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0 && !style_.sheet) break;
    if (style_.flat) {
      for (const Three& corners : faces_.vertices) {
        const Vec normal = sign * unit(normal_of(corners));
        for (const int i : corners) put(i, sign, normal);
      }
    } else {
      for (int i = 0; i < vertices_; ++i) put(i, sign, sign * drawn.smooth[static_cast<std::size_t>(i)]);
    }
  }
  for (const Edge& edge : edges_) {
    const Vec up = drawn.smooth[static_cast<std::size_t>(edge[0])] + drawn.smooth[static_cast<std::size_t>(edge[1])];
    const Vec outward = unit((vertex(vertices, edge[1]) - vertex(vertices, edge[0])).cross(up));
    for (const double sign : {1.0, -1.0}) {
      for (const int i : edge) put(i, sign, outward);
    }
  }
}

// ---- Rods ---------------------------------------------------------------------------------------------------

bool make_rod(const Vec& from, const Vec& to, double radius, Extra& rod) {
  const Vec along = to - from;
  const double length = std::sqrt(dot(along, along));
  if (!(length > 0)) return false;
  const Vec z = along / length;
  const Vec x = unit((std::abs(z[0]) < 0.7 ? Vec(1, 0, 0) : Vec(0, 1, 0)).cross(z));
  const Vec y = z.cross(x), middle = 0.5 * from + 0.5 * to;
  rod.type = render::kCapsuleShape;
  rod.size[0] = radius;
  rod.size[1] = 0.5 * length;
  for (int k = 0; k < 3; ++k) {
    rod.position[k] = middle[k];
    rod.rotation[3 * k] = x[k];
    rod.rotation[3 * k + 1] = y[k];
    rod.rotation[3 * k + 2] = z[k];
  }
  return true;
}

MovingSurface::MovingSurface(Shell given, const double* vertices) : shell(std::move(given)) {
  DrawnVertices at_rest;
  shell.expand(vertices, at_rest);
  pattern = SurfacePattern(shell.drawn(), at_rest.places.data());
}

}  // namespace mimo::rays
