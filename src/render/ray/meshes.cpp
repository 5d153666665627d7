#include "render/ray/meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "render/ray/vectors.h"

namespace mimo::render::ray {
namespace {

struct Corner {
  Vec place{}, normal{};
  std::array<double, 2> texture{};
};
using Corners = std::array<Corner, 3>;

Vec normal_of(const Corners& corners) {
  return unit(cross(minus(corners[1].place, corners[0].place), minus(corners[2].place, corners[0].place)));
}

// Triangles without an area are left out: nothing of them is seen.
class MeshBuilder {
 public:
  void add(const Corners& corners) {
    const Vec e1 = minus(corners[1].place, corners[0].place);
    const Vec e2 = minus(corners[2].place, corners[0].place);
    const double a = dot(e1, e1);
    const double b = dot(e1, e2);
    const double c = dot(e2, e2);
    const double area = a * c - b * b;
    if (!(area > 1e-24 * a * c)) return;
    Triangle triangle;
    triangle.corner = narrow(corners[0].place);
    triangle.edge1 = narrow(e1);
    triangle.edge2 = narrow(e2);
    const Vec none = {0, 0, 0};
    Skin skin;
    skin.corner = triangle.corner;
    skin.to_u = narrow(plus(plus(none, e1, c / area), e2, -b / area));
    skin.to_v = narrow(plus(plus(none, e2, a / area), e1, -b / area));
    skin.normal = narrow(corners[0].normal);
    skin.normal_u = narrow(minus(corners[1].normal, corners[0].normal));
    skin.normal_v = narrow(minus(corners[2].normal, corners[0].normal));
    for (int k = 0; k < 2; ++k) {
      skin.texture[k] = static_cast<float>(corners[0].texture[k]);
      skin.texture_u[k] = static_cast<float>(corners[1].texture[k] - corners[0].texture[k]);
      skin.texture_v[k] = static_cast<float>(corners[2].texture[k] - corners[0].texture[k]);
    }
    triangles_.push_back(triangle);
    skins_.push_back(skin);
  }

  void add_flat(const Vec& a, const Vec& b, const Vec& c) {
    Corners corners;
    corners[0].place = a;
    corners[1].place = b;
    corners[2].place = c;
    for (Corner& corner : corners) corner.normal = normal_of(corners);
    add(corners);
  }

  Mesh finish(bool textured) {
    Mesh mesh;
    mesh.textured = textured;
    const int count = static_cast<int>(triangles_.size());
    if (count == 0) return mesh;
    order_.resize(triangles_.size());
    std::iota(order_.begin(), order_.end(), 0);
    mesh.nodes.resize(1);
    split(0, 0, count, mesh.nodes);
    for (const int i : order_) {
      mesh.triangles.push_back(triangles_[i]);
      mesh.skins.push_back(skins_[i]);
    }
    const Node& root = mesh.nodes[0];
    for (int k = 0; k < 3; ++k) mesh.half[k] = std::max({-root.low[k], root.high[k], 0.0F});
    return mesh;
  }

 private:
  static constexpr int kLeaf = 4;

  float corner(int triangle, int which, int k) const {
    const Triangle& t = triangles_[triangle];
    return t.corner[k] + (which == 1 ? t.edge1[k] : which == 2 ? t.edge2[k] : 0.0F);
  }
  float middle(int triangle, int k) const {
    return corner(triangle, 0, k) + corner(triangle, 1, k) + corner(triangle, 2, k);
  }

  // Halves triangles first..first + count along the axis on which their middles spread most.
  void split(int index, int first, int count, std::vector<Node>& nodes) {
    Node node;
    node.low.fill(std::numeric_limits<float>::max());
    node.high.fill(-std::numeric_limits<float>::max());
    float spread[3];
    for (int k = 0; k < 3; ++k) {
      float least = std::numeric_limits<float>::max();
      float most = -least;
      for (int i = first; i < first + count; ++i) {
        for (int which = 0; which < 3; ++which) {
          node.low[k] = std::min(node.low[k], corner(order_[i], which, k));
          node.high[k] = std::max(node.high[k], corner(order_[i], which, k));
        }
        least = std::min(least, middle(order_[i], k));
        most = std::max(most, middle(order_[i], k));
      }
      spread[k] = most - least;
      const float slack = 1e-6F * (std::abs(node.low[k]) + std::abs(node.high[k]));  // for what is rounded
      node.low[k] -= slack;
      node.high[k] += slack;
    }
    if (count <= kLeaf) {
      node.first = first;
      node.count = count;
      nodes[index] = node;
      return;
    }
    const int axis = static_cast<int>(std::max_element(spread, spread + 3) - spread);
    const int half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [this, axis](int a, int b) {
      return std::make_pair(middle(a, axis), a) < std::make_pair(middle(b, axis), b);
    });
    node.axis = axis;
    node.first = static_cast<std::int32_t>(nodes.size());
    nodes[index] = node;
    nodes.resize(nodes.size() + 2);
    split(node.first, first, half, nodes);
    split(node.first + 1, first + half, count - half, nodes);
  }

  std::vector<Triangle> triangles_;
  std::vector<Skin> skins_;
  std::vector<int> order_;
};

// As MuJoCo draws them: with texture coordinates, normals are those of the vertices; without, only where they are near
// that of the triangle.
Mesh mesh_of(const mjModel& model, int id) {
  const int first = model.mesh_vertadr[id];
  const int texture = model.mesh_texcoordadr[id];
  MeshBuilder builder;
  for (int i = 0; i < model.mesh_facenum[id]; ++i) {
    const int* face = model.mesh_face + 3 * (static_cast<std::ptrdiff_t>(model.mesh_faceadr[id]) + i);
    Corners corners;
    for (int k = 0; k < 3; ++k) {
      const std::ptrdiff_t vertex = first + face[k];
      std::copy_n(model.mesh_vert + 3 * vertex, 3, corners[k].place.begin());
      std::copy_n(model.mesh_normal + 3 * vertex, 3, corners[k].normal.begin());
      if (texture >= 0) {
        const float* place = model.mesh_texcoord + 2 * (static_cast<std::ptrdiff_t>(texture) + face[k]);
        std::copy_n(place, 2, corners[k].texture.begin());
      }
    }
    if (texture < 0) {
      const Vec flat = normal_of(corners);
      for (Corner& corner : corners) {
        if (dot(corner.normal, flat) < 0.8) corner.normal = flat;
      }
    }
    builder.add(corners);
  }
  return builder.finish(texture >= 0);
}

// The surface, four sides and the bottom.
Mesh field_of(const mjModel& model, int id) {
  const int rows = model.hfield_nrow[id];
  const int columns = model.hfield_ncol[id];
  const double* size = model.hfield_size + 4 * static_cast<std::ptrdiff_t>(id);
  const float* data = model.hfield_data + model.hfield_adr[id];
  const auto at = [=](int row, int column) {
    return Vec{size[0] * (2.0 * column / (columns - 1) - 1), size[1] * (2.0 * row / (rows - 1) - 1),
               size[2] * data[static_cast<std::ptrdiff_t>(row) * columns + column]};
  };
  const auto below = [=](const Vec& p) { return Vec{p[0], p[1], -size[3]}; };
  MeshBuilder builder;
  const auto wall = [&](const Vec& a, const Vec& b) {  // with its inside to the left of the way from a to b
    builder.add_flat(a, below(a), below(b));
    builder.add_flat(a, below(b), b);
  };
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      builder.add_flat(at(row + 1, column), at(row, column), at(row + 1, column + 1));
      builder.add_flat(at(row, column), at(row, column + 1), at(row + 1, column + 1));
    }
    wall(at(row + 1, 0), at(row, 0));
    wall(at(row, columns - 1), at(row + 1, columns - 1));
  }
  for (int column = 0; column + 1 < columns; ++column) {
    wall(at(0, column), at(0, column + 1));
    wall(at(rows - 1, column + 1), at(rows - 1, column));
  }
  const Vec corners[4] = {below(at(0, 0)), below(at(rows - 1, 0)), below(at(rows - 1, columns - 1)),
                          below(at(0, columns - 1))};
  builder.add_flat(corners[0], corners[1], corners[2]);
  builder.add_flat(corners[0], corners[2], corners[3]);
  return builder.finish(false);
}

}  // namespace

Meshes::Meshes(const mjModel& model) {
  for (int i = 0; i < model.nmesh; ++i) meshes_.push_back(mesh_of(model, i));
  for (int i = 0; i < model.nhfield; ++i) fields_.push_back(field_of(model, i));
}

const Mesh* Meshes::find(int geom_type, int data_id) const {
  if (geom_type != mjGEOM_MESH && geom_type != mjGEOM_HFIELD) return nullptr;
  const std::vector<Mesh>& all = geom_type == mjGEOM_MESH ? meshes_ : fields_;
  return data_id >= 0 && data_id < static_cast<int>(all.size()) ? &all[data_id] : nullptr;
}

}  // namespace mimo::render::ray
