#include "geometry/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/functions.h"
#include "base/numbers.h"
#include "geometry/texture.h"
#include "render/model_stage.h"
#include "render/surfaces.h"

namespace mimo::geometry {
namespace {

using Vec = Eigen::Vector3d;

// Two triangles between four corners, counter-clockwise from outside.
void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.add_triangle(a, b, c);
  mesh.add_triangle(a, c, d);
}

// The six sides of a cube from -1 to 1, each a grid of its own. `place` gets a place in a side, and the side's normal.
template <typename Place>
Mesh cube_grid(int pieces, Place place) {
  Mesh mesh;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1 : -1;
    const Vec normal = sign * Vec::Unit(axis);
    const Vec along = Vec::Unit((axis + 1) % 3);
    const Vec across = normal.cross(along);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto row = static_cast<std::uint32_t>(pieces) + 1;
    for (int i = 0; i <= pieces; ++i) {
      for (int j = 0; j <= pieces; ++j)
        mesh.add(place(normal, along, 2.0 * i / pieces - 1, across, 2.0 * j / pieces - 1));
    }
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      for (std::uint32_t j = 0; j + 1 < row; ++j) {
        const std::uint32_t corner = first + i * row + j;
        add_quad(mesh, corner, corner + row, corner + row + 1, corner + 1);
      }
    }
  }
  return mesh;
}

// A point of the outline that turns around the z axis.
struct Outline {
  double radius, z;
  double normal_radius, normal_z;
};

void add_ring(Mesh& mesh, const Outline& outline, int segments) {
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * kPi * i / segments;
    const double c = fixed::cos(angle);
    const double s = fixed::sin(angle);
    mesh.add({{outline.radius * c, outline.radius * s, outline.z},
              {outline.normal_radius * c, outline.normal_radius * s, outline.normal_z}});
  }
}

// From the lowest to the highest; where two follow each other at one place, there is an edge.
Mesh turned(const std::vector<Outline>& outline, int segments) {
  Mesh mesh;
  for (const Outline& ring : outline) add_ring(mesh, ring, segments);
  const auto count = static_cast<std::uint32_t>(segments);
  for (std::uint32_t ring = 0; ring + 1 < outline.size(); ++ring) {
    const Outline& low = outline[ring];
    const Outline& high = outline[ring + 1];
    if (low.radius == high.radius && low.z == high.z) continue;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = ring * count + i;
      const std::uint32_t b = ring * count + (i + 1) % count;
      if (low.radius > 0) mesh.add_triangle(a, b, b + count);
      if (high.radius > 0) mesh.add_triangle(a, b + count, a + count);
    }
  }
  return mesh;
}

using Vec = Eigen::Vector3d;

Mesh welded(const mjModel& model, int geom) {
  Welder welder;
  const auto take = [&welder](const render::Corners& corners) {
    for (const render::Corner& corner : corners) {
      welder.add({corner.place, corner.normal, {corner.texture[0], corner.texture[1]}});
    }
  };
  const int id = model.geom_dataid[geom];
  if (model.geom_type[geom] == mjGEOM_MESH)
    render::each_triangle_of_mesh(render::meshes_of(model), id, take);
  else
    render::each_triangle_of_field(render::fields_of(model), id, take);
  return welder.take();
}

Mesh bare(const mjModel& model, int geom, const Detail& detail) {
  const Vec size = Eigen::Map<const Vec>(model.geom_size + 3 * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_PLANE: return plane(size[0] > 0 ? size[0] : detail.plane, size[1] > 0 ? size[1] : detail.plane);
    case mjGEOM_SPHERE: return ellipsoid(Vec::Constant(size[0]), detail.segments);
    case mjGEOM_ELLIPSOID: return ellipsoid(size, detail.segments);
    case mjGEOM_CAPSULE: return capsule(size[0], size[1], detail.segments);
    case mjGEOM_CYLINDER: return cylinder(size[0], size[1], detail.segments);
    case mjGEOM_BOX: return box(size);
    case mjGEOM_MESH:
    case mjGEOM_HFIELD: return welded(model, geom);
    default: return {};
  }
}

// Planes and meshes are drawn at their size, other shapes are unit shapes that are scaled.
render::Shape shape_of(const mjModel& model, int geom) {
  render::Shape shape{};
  render::form_of(model.geom_type[geom], shape.kind);
  for (int k = 0; k < 3; ++k)
    shape.size[static_cast<std::size_t>(k)] = static_cast<float>(model.geom_size[3 * geom + k]);
  shape.prescaled = shape.kind == render::Form::kPlane || shape.kind == render::Form::kMesh;
  shape.given = model.geom_type[geom] == mjGEOM_MESH && model.mesh_texcoordadr[model.geom_dataid[geom]] >= 0;
  return shape;
}

}  // namespace

Mesh plane(double half_x, double half_y) {
  Mesh mesh;
  for (const double x : {-half_x, half_x}) {
    for (const double y : {-half_y, half_y}) mesh.add({{x, y, 0}, Vec::UnitZ()});
  }
  add_quad(mesh, 0, 2, 3, 1);
  return mesh;
}

Mesh box(const Vec& half) {
  return cube_grid(1, [&half](const Vec& normal, const Vec& along, double u, const Vec& across, double v) {
    return Vertex{half.cwiseProduct(normal + u * along + v * across), normal};
  });
}

// Angles rather than lengths are divided, so that triangles are of similar size.
Mesh ellipsoid(const Vec& radii, int segments) {
  const auto even = [](double u) { return fixed::tan(u * kPi / 4); };
  return cube_grid(segments / 4, [&](const Vec& normal, const Vec& along, double u, const Vec& across, double v) {
    const Vec place = (normal + even(u) * along + even(v) * across).normalized();
    return Vertex{place.cwiseProduct(radii), place.cwiseQuotient(radii).normalized()};
  });
}

Mesh capsule(double radius, double half, int segments) {
  std::vector<Outline> outline;
  const int quarter = segments / 4;
  for (const double end : {-1.0, 1.0}) {
    for (int i = 0; i <= quarter; ++i) {
      const double angle = kPi / 2 * (end < 0 ? i - quarter : i) / quarter;
      const bool pole = std::abs(angle) == kPi / 2;
      const double c = pole ? 0 : fixed::cos(angle);
      outline.push_back({radius * c, end * half + radius * fixed::sin(angle), c, fixed::sin(angle)});
    }
  }
  return turned(outline, segments);
}

Mesh cylinder(double radius, double half, int segments) {
  return turned({{0, -half, 0, -1},
                 {radius, -half, 0, -1},
                 {radius, -half, 1, 0},
                 {radius, half, 1, 0},
                 {radius, half, 0, 1},
                 {0, half, 0, 1}},
                segments);
}

Mesh mesh_of(const mjModel& model, int geom, const Detail& detail) {
  const int texture = material_of(model, geom).paint.texture;
  if (texture < 0) return bare(model, geom, detail);
  const TextureSize size = size_of(model, texture);
  const render::TextureMapping mapping =
      render::map_texture(render::materials_of(model), model.geom_matid[geom], size.cube(), shape_of(model, geom));
  Mesh mesh = bare(model, geom, detail);
  lay(mesh, mapping, size);
  return mesh;
}

Material material_of(const mjModel& model, int geom) {
  Material material;
  material.group = model.geom_group[geom];
  material.paint = render::paint_of(render::materials_of(model), model.geom_matid[geom], model.geom_rgba + 4 * geom);
  material.visible = render::is_shown(material.group) && material.paint.color[3] > 0;
  return material;
}

}  // namespace mimo::geometry
