#include "rays/meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/fail.h"
#include "render/surfaces.h"

namespace mimo::rays {
namespace {

Mesh mesh_of(const render::Meshes& meshes, int id) {
  MeshBuilder builder(meshes.triangle_count[id]);
  render::each_triangle_of_mesh(meshes, id, [&](const Corners& corners) { builder.add(corners); });
  return builder.finish(meshes.first_texcoord[id] >= 0);
}

Mesh field_of(const render::Fields& fields, int id) {
  MeshBuilder builder(2.0 * (fields.rows[id] + 1) * (fields.columns[id] + 1));
  render::each_triangle_of_field(fields, id, [&](const Corners& corners) { builder.add(corners); });
  return builder.finish(false);
}

constexpr int kLeaf = 4;

float corner_of(const Triangle& t, int which, int k) {
  return t.corner[k] + (which == 1 ? t.edge1[k] : which == 2 ? t.edge2[k] : 0.0F);
}

void empty(Node& node) {
  node.low.fill(std::numeric_limits<float>::max());
  node.high.fill(-std::numeric_limits<float>::max());
}

void enclose(const Triangle& triangle, Node& node) {
  for (int k = 0; k < 3; ++k) {
    for (int which = 0; which < 3; ++which) {
      node.low[k] = std::min(node.low[k], corner_of(triangle, which, k));
      node.high[k] = std::max(node.high[k], corner_of(triangle, which, k));
    }
  }
}

// For what is rounded.
void add_slack(Node& node) {
  for (int k = 0; k < 3; ++k) {
    const float slack = 1e-6F * (std::abs(node.low[k]) + std::abs(node.high[k]));
    node.low[k] -= slack;
    node.high[k] += slack;
  }
}

bool has_parts(const Node& node) { return node.child != 0 && node.count > static_cast<int>(Triangles::kBlock); }

// How many times a node is halved before all its parts are blocks.
int height(const Node& node) {
  const int blocks = (node.count + static_cast<int>(Triangles::kBlock) - 1) / static_cast<int>(Triangles::kBlock);
  int height = 0;
  while (1 << height < blocks) ++height;
  return height;
}

// Puts the boxes below a node into branches[index], and what is below them behind: four levels, but those of the first
// branch, so that most are full.
void gather(const std::vector<Node>& nodes, std::int32_t node, std::size_t index, std::vector<Branch>& branches) {
  std::vector<std::int32_t> boxes = {node};
  const int levels = (height(nodes[node]) + 3) % 4 + 1;
  for (int level = 0; level < levels; ++level) {
    std::vector<std::int32_t> next;
    for (const std::int32_t box : boxes) {
      const bool open = has_parts(nodes[box]);
      next.push_back(open ? nodes[box].child : box);
      if (open) next.push_back(nodes[box].child + 1);
    }
    boxes = std::move(next);
  }
  Branch branch;
  for (const std::int32_t box : boxes) {
    const int i = branch.count++;
    branch.node[i] = box;
    branch.first[i] = nodes[box].first;
    branch.triangles[i] = nodes[box].count;
    if (!has_parts(nodes[box])) continue;
    branch.branch[i] = static_cast<std::int32_t>(branches.size());
    branches.emplace_back();
    gather(nodes, box, branches.size() - 1, branches);
  }
  branches[index] = branch;
}

Vec wide(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

// How the triangles of boxes are turned, a hair wider for what is rounded. Without `known`: they may be turned anyhow.
void bound_normals(Mesh& mesh, bool known) {
  for (Branch& branch : mesh.branches) {
    for (int i = 0; i < branch.count; ++i) {
      Vec least = Vec::Constant(known ? 1 : -1);
      Vec most = -least;
      for (int k = branch.first[i]; known && k < branch.first[i] + branch.triangles[i]; ++k) {
        const Triangle triangle = mesh.triangles[static_cast<std::size_t>(k)];
        const Vec across = wide(triangle.edge1).cross(wide(triangle.edge2));
        if (!(dot(across, across) > 0)) continue;  // no ray meets it
        const Vec n = across / std::sqrt(dot(across, across));
        least = least.cwiseMin(n);
        most = most.cwiseMax(n);
      }
      for (int k = 0; k < 3; ++k) {
        branch.least[k][i] = static_cast<float>(least[k] - 1e-6);
        branch.most[k][i] = static_cast<float>(most[k] + 1e-6);
      }
    }
  }
}

void copy_boxes(Mesh& mesh) {
  for (Branch& branch : mesh.branches) {
    for (int i = 0; i < branch.count; ++i) {
      const Node& node = mesh.nodes[branch.node[i]];
      for (int k = 0; k < 3; ++k) {
        branch.low[k][i] = node.low[k];
        branch.high[k][i] = node.high[k];
      }
    }
  }
}

void measure(Mesh& mesh) {
  const Node& root = mesh.nodes[0];
  for (int k = 0; k < 3; ++k) mesh.half[k] = std::max({-root.low[k], root.high[k], 0.0F});
}

}  // namespace

Meshes::Meshes(const render::Stage& stage) {
  for (int i = 0; i < stage.meshes.count; ++i) meshes_.push_back(mesh_of(stage.meshes, i));
  for (int i = 0; i < stage.fields.count; ++i) fields_.push_back(field_of(stage.fields, i));
}

const Mesh* Meshes::find(int shape_type, int data_id) const {
  const bool field = shape_type == render::kFieldShape;
  if (!field && shape_type != render::kMeshShape && shape_type != render::kDistanceShape) return nullptr;
  const std::vector<Mesh>& all = field ? fields_ : meshes_;
  return data_id >= 0 && data_id < static_cast<int>(all.size()) ? &all[data_id] : nullptr;
}

bool form(const Corners& corners, Triangle& triangle, Surface& surface) {
  for (const Corner& corner : corners) {
    if (!std::all_of(corner.place.data(), corner.place.data() + 3, is_near)) return false;
  }
  const Vec e1 = corners[1].place - corners[0].place;
  const Vec e2 = corners[2].place - corners[0].place;
  const double a = dot(e1, e1);
  const double b = dot(e1, e2);
  const double c = dot(e2, e2);
  const double area = a * c - b * b;
  if (!(area > 1e-24 * a * c)) return false;
  triangle.corner = narrow(corners[0].place);
  triangle.edge1 = narrow(e1);
  triangle.edge2 = narrow(e2);
  surface.corner = triangle.corner;
  surface.to_u = narrow(c / area * e1 + -b / area * e2);
  surface.to_v = narrow(a / area * e2 + -b / area * e1);
  surface.normal = narrow(corners[0].normal);
  surface.normal_u = narrow(corners[1].normal - corners[0].normal);
  surface.normal_v = narrow(corners[2].normal - corners[0].normal);
  return true;
}

void refit(Mesh& mesh) {
  if (mesh.nodes.empty()) return;
  for (auto node = mesh.nodes.rbegin(); node != mesh.nodes.rend(); ++node) {  // children come after their parents
    if (node->child == 0) {
      empty(*node);
      for (int i = node->first; i < node->first + node->count; ++i) {
        enclose(mesh.triangles[static_cast<std::size_t>(i)], *node);
      }
      add_slack(*node);
      continue;
    }
    const Node& one = mesh.nodes[static_cast<std::size_t>(node->child)];
    const Node& other = mesh.nodes[static_cast<std::size_t>(node->child) + 1];
    for (int k = 0; k < 3; ++k) {
      node->low[k] = std::min(one.low[k], other.low[k]);
      node->high[k] = std::max(one.high[k], other.high[k]);
    }
  }
  copy_boxes(mesh);
  bound_normals(mesh, false);
  measure(mesh);
}

MeshBuilder::MeshBuilder(double most) {
  if (most * kSurfaceFloats <= std::numeric_limits<std::int32_t>::max()) return;
  fail(Status::kUnsupported, "a mesh or height field is too large for the ray renderer");
}

void MeshBuilder::add(const Corners& corners, bool keep) {
  Triangle triangle;
  Surface surface;
  if (!form(corners, triangle, surface) && !keep) return;
  for (int k = 0; k < 2; ++k) {
    surface.texture[k] = static_cast<float>(corners[0].texture[k]);
    surface.texture_u[k] = static_cast<float>(corners[1].texture[k] - corners[0].texture[k]);
    surface.texture_v[k] = static_cast<float>(corners[2].texture[k] - corners[0].texture[k]);
  }
  triangles_.push_back(triangle);
  surfaces_.push_back(surface);
}

Mesh MeshBuilder::finish(bool textured) {
  Mesh mesh;
  mesh.textured = textured;
  const int count = static_cast<int>(triangles_.size());
  if (count == 0) return mesh;
  order_.resize(triangles_.size());
  std::iota(order_.begin(), order_.end(), 0);
  mesh.nodes.resize(1);
  split(0, 0, count, mesh.nodes);
  mesh.branches.resize(1);
  gather(mesh.nodes, 0, 0, mesh.branches);
  copy_boxes(mesh);
  mesh.triangles.resize(triangles_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    mesh.triangles.set(i, triangles_[order_[i]]);
    mesh.surfaces.push_back(surfaces_[order_[i]]);
  }
  bound_normals(mesh, true);
  measure(mesh);
  return mesh;
}

float MeshBuilder::middle(int triangle, int k) const {
  const Triangle& t = triangles_[triangle];
  return corner_of(t, 0, k) + corner_of(t, 1, k) + corner_of(t, 2, k);
}

// Halves triangles first..first + count along the axis on which their middles spread most; where they are more than one
// block, between two of these.
void MeshBuilder::split(int index, int first, int count, std::vector<Node>& nodes) {
  Node node;
  empty(node);
  for (int i = first; i < first + count; ++i) enclose(triangles_[order_[i]], node);
  add_slack(node);
  node.first = first;
  node.count = count;
  if (count <= kLeaf) {
    nodes[index] = node;
    return;
  }
  float spread[3];
  for (int k = 0; k < 3; ++k) {
    float least = std::numeric_limits<float>::max();
    float most = -least;
    for (int i = first; i < first + count; ++i) {
      least = std::min(least, middle(order_[i], k));
      most = std::max(most, middle(order_[i], k));
    }
    spread[k] = most - least;
  }
  const int axis = static_cast<int>(std::max_element(spread, spread + 3) - spread);
  constexpr int kBlock = Triangles::kBlock;
  const int half = count > kBlock ? (count / 2 + kBlock - 1) / kBlock * kBlock : count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [this, axis](int a, int b) {
    return std::make_pair(middle(a, axis), a) < std::make_pair(middle(b, axis), b);
  });
  node.axis = axis;
  node.child = static_cast<std::int32_t>(nodes.size());
  nodes[index] = node;
  nodes.resize(nodes.size() + 2);
  split(node.child, first, half, nodes);
  split(node.child + 1, first + half, count - half, nodes);
}

}  // namespace mimo::rays
