#include "geometry/texture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "compat/mujoco.h"
#include "geometry/mesh.h"

namespace mimo::geometry {
namespace {

using Vec = Eigen::Vector3d;
constexpr int kFaces = 6;

// The direction in which a cube texture is seen.
Vec direction(const render::TextureMapping& mapping, const Vec& place) {
  const double fold = static_cast<double>(mapping.fold);
  const double z = std::clamp(place[2], -fold, fold);
  const auto scale = [&](int k) { return static_cast<double>(mapping.scale[static_cast<std::size_t>(k)]); };
  return {place[0] * scale(0), place[1] * scale(1), z * scale(2) + (place[2] - z) * scale(3)};
}

// +x, -x, +y, -y, +z, -z.
int face_of(const Vec& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return 2 * axis + (direction[axis] < 0 ? 1 : 0);
}

// The place in a face, 0 to 1 each, as OpenGL turns the faces. Beyond its edges a face's edge goes on.
Eigen::Vector2d place_in(int face, const Vec& q, double texel) {
  const double sign = face % 2 == 0 ? 1 : -1;
  Eigen::Vector2d at;
  switch (face / 2) {
    case 0: at = {-sign * q[2], -q[1]}; break;
    case 1: at = {q[0], sign * q[2]}; break;
    default: at = {sign * q[0], -q[1]}; break;
  }
  const double major = std::max(std::abs(q[face / 2]), std::numeric_limits<double>::min());
  at = (0.5 / major * at).array() + 0.5;
  return at.cwiseMax(0.5 * texel).cwiseMin(1 - 0.5 * texel);
}

using Polygon = std::vector<Vertex>;

Vertex between(const Vertex& a, const Vertex& b, double part) {
  Vertex vertex;
  vertex.place = a.place + part * (b.place - a.place);
  vertex.normal = (a.normal + part * (b.normal - a.normal)).normalized();
  return vertex;
}

// Lays triangles in the faces of a cube texture; those that lie in several are cut where the faces meet.
class CubeLayer {
 public:
  CubeLayer(const render::TextureMapping& mapping, double texel) : mapping_(mapping), texel_(texel) {}

  Mesh lay(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const Polygon corners = {mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
                               mesh.vertices[mesh.indices[i + 2]]};
      const int face = face_of(seen(middle_of(corners)));
      if (std::all_of(corners.begin(), corners.end(), [&](const Vertex& v) { return lies_in(face, v); }))
        add(corners, face);
      else
        for (const Polygon& piece : cut(corners)) add(piece, face_of(seen(middle_of(piece))));
    }
    return welder_.take();
  }

 private:
  Vec seen(const Vec& place) const { return direction(mapping_, place); }

  static Vec middle_of(const Polygon& polygon) {
    Vec sum = Vec::Zero();
    for (const Vertex& vertex : polygon) sum += vertex.place;
    return sum / static_cast<double>(polygon.size());
  }

  bool lies_in(int face, const Vertex& vertex) const {
    const Vec q = seen(vertex.place);
    const double major = face % 2 == 0 ? q[face / 2] : -q[face / 2];
    return major > (1 - kSlack) * q.cwiseAbs().maxCoeff();
  }

  // Faces meet where two components of a direction are equal except for the sign.
  std::vector<Polygon> cut(const Polygon& polygon) const {
    std::vector<Polygon> pieces = {polygon};
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        const auto side = [&](const Vertex& vertex) {
          const Vec q = seen(vertex.place);
          const double beyond = q[axis] - sign * q[(axis + 1) % 3];
          return std::abs(beyond) > kSlack * q.cwiseAbs().maxCoeff() ? beyond : 0;
        };
        std::vector<Polygon> halves;
        for (const Polygon& piece : pieces) {
          halves.push_back(part_beyond(piece, [&](const Vertex& v) { return side(v); }));
          halves.push_back(part_beyond(piece, [&](const Vertex& v) { return -side(v); }));
        }
        pieces.clear();
        for (Polygon& half : halves) {
          if (half.size() >= 3) pieces.push_back(std::move(half));
        }
      }
    }
    return pieces;
  }

  // The part of a convex polygon where `side` is not negative; nothing where it is nowhere positive.
  template <typename Side>
  static Polygon part_beyond(const Polygon& polygon, Side side) {
    Polygon part;
    bool any = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vertex& from = polygon[i];
      const Vertex& to = polygon[(i + 1) % polygon.size()];
      const double here = side(from);
      const double there = side(to);
      any = any || here > 0;
      if (here >= 0) part.push_back(from);
      if ((here > 0 && there < 0) || (here < 0 && there > 0)) part.push_back(between(from, to, here / (here - there)));
    }
    return any ? part : Polygon{};
  }

  void add(const Polygon& polygon, int face) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const Polygon corners = {polygon[0], polygon[i - 1], polygon[i]};
      if (!is_flat(corners)) add_triangle(corners, face, 0);
    }
  }

  // Cuts leave corners on straight edges and next to each other, and three of them are no triangle.
  static bool is_flat(const Polygon& corners) {
    const Vec a = corners[1].place - corners[0].place;
    const Vec b = corners[2].place - corners[0].place;
    const double longest = std::max({a.norm(), b.norm(), (a - b).norm()});
    const double far = corners[0].place.norm();
    return longest < kFlat * far || a.cross(b).norm() < kFlat * longest * longest;
  }

  // Along a triangle that comes nearer to the middle of the cube the texture does not advance evenly, as it does in
  // what draws it: such ones are divided.
  void add_triangle(const Polygon& corners, int face, int depth) {
    double least = std::numeric_limits<double>::max(), most = 0;
    for (const Vertex& corner : corners) {
      const double major = std::abs(seen(corner.place)[face / 2]);
      least = std::min(least, major);
      most = std::max(most, major);
    }
    if (most > kUneven * least && depth < kDepth) {
      const Vertex a = between(corners[0], corners[1], 0.5);
      const Vertex b = between(corners[1], corners[2], 0.5);
      const Vertex c = between(corners[2], corners[0], 0.5);
      add_triangle({corners[0], a, c}, face, depth + 1);
      add_triangle({a, corners[1], b}, face, depth + 1);
      add_triangle({c, b, corners[2]}, face, depth + 1);
      add_triangle({a, b, c}, face, depth + 1);
      return;
    }
    for (Vertex vertex : corners) {
      const Eigen::Vector2d at = place_in(face, seen(vertex.place), texel_);
      vertex.texture = {at[0], (face + at[1]) / kFaces};
      welder_.add(vertex);
    }
  }

  static constexpr double kUneven = 1.1;
  static constexpr int kDepth = 4;
  static constexpr double kSlack = 1e-9;
  static constexpr double kFlat = 1e-5;  // relative; single precision has little more

  render::TextureMapping mapping_;
  double texel_;
  Welder welder_;
};

}  // namespace

TextureSize size_of(const mjModel& model, int texture) {
  TextureSize size;
  switch (model.tex_type[texture]) {
    case mjTEXTURE_CUBE: size.type = TextureType::kCube; break;
    case mjTEXTURE_SKYBOX: size.type = TextureType::kSky; break;
    default: break;
  }
  size.width = model.tex_width[texture];
  size.height = size.cube() ? kFaces * size.width : model.tex_height[texture];
  return size;
}

void read_pixels(const mjModel& model, int texture, Span<std::uint8_t> rgba) {
  const TextureSize size = size_of(model, texture);
  const unsigned char* stored_pixels = model.*compat::kPixels + model.tex_adr[texture];
  const int channels = compat::channels(model, texture);
  // A cube texture as high as wide is one picture for all six faces.
  const std::size_t stored = static_cast<std::size_t>(model.tex_width[texture]) * model.tex_height[texture];
  const std::size_t pixels = static_cast<std::size_t>(size.width) * size.height;
  for (std::size_t i = 0; i < pixels; ++i) {
    const unsigned char* from = stored_pixels + static_cast<std::size_t>(channels) * (i % stored);
    for (int k = 0; k < 3; ++k) rgba[4 * i + k] = from[compat::channel_of(channels, k)];
    rgba[4 * i + 3] = 255;
  }
}

void lay(Mesh& mesh, const render::TextureMapping& mapping, const TextureSize& size) {
  if (mapping.kind == render::Mapping::kCube) {
    mesh = CubeLayer(mapping, 1.0 / size.width).lay(mesh);
    return;
  }
  if (mapping.kind != render::Mapping::kFlat) return;
  for (Vertex& vertex : mesh.vertices) {
    for (int k = 0; k < 2; ++k) {
      const auto i = static_cast<std::size_t>(k);
      vertex.texture[k] =
          vertex.place[k] * static_cast<double>(mapping.scale[i]) + static_cast<double>(mapping.origin[i]);
    }
  }
}

}  // namespace mimo::geometry
