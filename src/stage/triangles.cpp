// Textures, meshes, height fields and surfaces, brought into the form in which rays find them.
#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <utility>

#include "stage/arrays.h"
#include "stage/parts.h"

namespace mimo::stage {

Textures::Textures(const mimo_stage_textures& given) {
  const Arrays arrays("textures", given.count);
  constexpr int kWidest = 65536;
  const std::vector<int> types = arrays.copy(given.types, "types"), widths = arrays.copy(given.widths, "widths");
  const std::vector<int> heights = arrays.copy(given.heights, "heights");
  const std::vector<int> channels = arrays.copy_or<int>(given.channels, "channels", {3});
  arrays.check(types.data(), "types", 1, MIMO_TEXTURE_FLAT, MIMO_TEXTURE_SKY, "a MIMO_TEXTURE_ constant, 0 to 2");
  arrays.check(widths.data(), "widths", 1, 1, kWidest, "1 to 65536 pixels");
  arrays.check(heights.data(), "heights", 1, 1, 6.0 * kWidest, "1 to 393216 pixels");
  arrays.check(channels.data(), "channels", 1, 1, 4, "1 to 4");
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < types.size(); ++i) {
    const bool cube = types[i] != MIMO_TEXTURE_FLAT;
    require(!cube || heights[i] == widths[i] || heights[i] == 6 * widths[i],
            "textures: heights[{}] is {}, expected {} or {} of a cube {} pixels wide", i, heights[i], widths[i],
            6LL * widths[i], widths[i]);
    bytes += static_cast<std::size_t>(channels[i]) * static_cast<std::size_t>(widths[i]) *
             static_cast<std::size_t>(heights[i]);
  }
  arrays.need(given.pixels, "pixels");
  require(given.pixel_bytes == bytes, "textures: pixel_bytes is {}, expected {}, what their sizes and channels make",
          given.pixel_bytes, bytes);
  count = arrays.whole_count();
  made = std::make_shared<const rays::Textures>(render::Textures{count, types.data(), widths.data(), heights.data(),
                                                                 channels.data(), given.pixels, nullptr, given.srgb});
}

namespace {

// Where the parts of many meshes begin, in the form that renderers read.
std::vector<int> whole(const std::vector<std::size_t>& firsts) {
  std::vector<int> result;
  for (const std::size_t first : firsts) result.push_back(static_cast<int>(first));
  return result;
}

constexpr std::size_t kMostCorners = std::numeric_limits<int>::max() / 3;

// Corners of the triangles of each mesh: of so many vertices, or normals, or texture coordinates. Meshes that have none
// of the latter need none.
void check_corners(const Arrays& arrays, const int* corners, const std::vector<std::size_t>& triangles,
                   const std::vector<std::size_t>& others, const char* name, const char* what) {
  for (std::size_t mesh = 0; mesh < arrays.count(); ++mesh) {
    const auto count = static_cast<int>(others[mesh + 1] - others[mesh]);
    if (count == 0) continue;
    for (std::size_t i = 3 * triangles[mesh]; i < 3 * triangles[mesh + 1]; ++i) {
      if (corners[i] >= 0 && corners[i] < count) continue;
      fail(Status::kInvalidArgument, "{}: {} is {}, but mesh {} has {} {}", arrays.part(), place_in(name, i, 3),
           corners[i], mesh, count, what);
    }
  }
}

// Normals of vertices, from all triangles around, the larger the more.
std::vector<float> normals_of(const float* vertices, std::size_t count, const int* triangles,
                              std::size_t triangle_count) {
  using rays::Vec;
  const auto place = [&](int i) -> Vec {
    return Eigen::Map<const Eigen::Vector3f>(vertices + 3 * static_cast<std::ptrdiff_t>(i)).cast<double>();
  };
  std::vector<Vec> sums(count, Vec::Zero());
  for (const int* corners = triangles; corners != triangles + 3 * triangle_count; corners += 3) {
    const Vec a = place(corners[1]) - place(corners[0]), b = place(corners[2]) - place(corners[0]);
    const Vec normal(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    for (int k = 0; k < 3; ++k) sums[static_cast<std::size_t>(corners[k])] += normal;
  }
  std::vector<float> normals;
  for (const Vec& sum : sums) {
    const Vec normal = rays::unit(sum);
    for (int k = 0; k < 3; ++k) normals.push_back(static_cast<float>(normal[k]));
  }
  return normals;
}

// Meshes that have no normals get some: behind the others, as many as vertices.
struct Normals {
  std::vector<float> all;
  std::vector<int> first, triangles;

  Normals(const mimo_stage_meshes& given, const std::vector<std::size_t>& vertex,
          const std::vector<std::size_t>& normal, const std::vector<std::size_t>& triangle)
      : first(whole(normal)) {
    if (given.normals != nullptr) all.assign(given.normals, given.normals + 3 * given.normal_total);
    const int* corners = given.normal_triangles == nullptr ? given.triangles : given.normal_triangles;
    if (corners != nullptr) triangles.assign(corners, corners + 3 * given.triangle_total);
    for (std::size_t i = 0; i < given.count; ++i) {
      if (normal[i + 1] > normal[i]) continue;
      const std::vector<float> own = normals_of(given.vertices + 3 * vertex[i], vertex[i + 1] - vertex[i],
                                                given.triangles + 3 * triangle[i], triangle[i + 1] - triangle[i]);
      first[i] = static_cast<int>(all.size() / 3);
      all.insert(all.end(), own.begin(), own.end());
      std::copy(given.triangles + 3 * triangle[i], given.triangles + 3 * triangle[i + 1],
                triangles.begin() + static_cast<std::ptrdiff_t>(3 * triangle[i]));
    }
  }
};

}  // namespace

Meshes::Meshes(const mimo_stage_meshes& given) {
  const Arrays arrays("meshes", given.count);
  count = arrays.whole_count();
  arrays.need(given.vertex_counts, "vertex_counts");
  arrays.need(given.triangle_counts, "triangle_counts");
  const auto vertex = arrays.firsts(given.vertex_counts, "vertex_counts");
  const auto normal = arrays.firsts(given.normal_counts, "normal_counts");
  const auto texcoord = arrays.firsts(given.texcoord_counts, "texcoord_counts");
  const auto triangle = arrays.firsts(given.triangle_counts, "triangle_counts");
  arrays.check_total(given.vertex_total, vertex.back(), "vertex_total", "vertex_counts");
  arrays.check_total(given.normal_total, normal.back(), "normal_total", "normal_counts");
  arrays.check_total(given.texcoord_total, texcoord.back(), "texcoord_total", "texcoord_counts");
  arrays.check_total(given.triangle_total, triangle.back(), "triangle_total", "triangle_counts");
  for (const std::size_t total : {vertex.back(), normal.back(), texcoord.back(), triangle.back()}) {
    if (total > kMostCorners) fail(Status::kUnsupported, "the meshes are too large for the ray renderer");
  }
  arrays.need(given.vertices, "vertices");
  arrays.need(given.triangles, "triangles");
  require(given.normals != nullptr || normal.back() == 0, "meshes: normals is NULL, but normal_total is {}",
          normal.back());
  require(given.texcoords != nullptr || texcoord.back() == 0, "meshes: texcoords is NULL, but texcoord_total is {}",
          texcoord.back());
  arrays.check_values(given.vertices, 3 * vertex.back(), "vertices", 3, -kFarthest, kFarthest, "a number of metres");
  arrays.check_values(given.normals, 3 * normal.back(), "normals", 3, -kMostNumber, kMostNumber, "a number");
  arrays.check_values(given.texcoords, 2 * texcoord.back(), "texcoords", 2, -kMostNumber, kMostNumber, "-1e6 to 1e6");
  check_corners(arrays, given.triangles, triangle, vertex, "triangles", "vertices");
  std::vector<int> first_texcoord = whole(texcoord);
  const Normals normals(given, vertex, normal, triangle);
  const int* texels = given.texcoord_triangles == nullptr ? given.triangles : given.texcoord_triangles;
  check_corners(arrays, given.normal_triangles == nullptr ? given.triangles : given.normal_triangles, triangle, normal,
                "normal_triangles", "normals");
  check_corners(arrays, texels, triangle, texcoord, "texcoord_triangles", "texture coordinates");
  for (std::size_t i = 0; i < arrays.count(); ++i) {
    if (texcoord[i + 1] == texcoord[i]) first_texcoord[i] = -1;
  }
  const std::vector<int> first_vertex = whole(vertex), first_triangle = whole(triangle);
  render::Stage stage;
  stage.meshes.count = count;
  stage.meshes.first_vertex = first_vertex.data();
  stage.meshes.first_normal = normals.first.data();
  stage.meshes.first_texcoord = first_texcoord.data();
  stage.meshes.first_triangle = first_triangle.data();
  stage.meshes.triangle_count = given.triangle_counts;
  stage.meshes.vertices = given.vertices;
  stage.meshes.normals = normals.all.data();
  stage.meshes.texcoords = given.texcoords;
  stage.meshes.triangles = given.triangles;
  stage.meshes.normal_triangles = normals.triangles.data();
  stage.meshes.texcoord_triangles = texels;
  made = std::make_shared<const rays::Meshes>(stage);
}

Fields::Fields(const mimo_stage_fields& given) {
  const Arrays arrays("fields", given.count);
  count = arrays.whole_count();
  const std::vector<int> rows = arrays.copy(given.rows, "rows"), columns = arrays.copy(given.columns, "columns");
  arrays.check(rows.data(), "rows", 1, 2, 65536, "2 to 65536");
  arrays.check(columns.data(), "columns", 1, 2, 65536, "2 to 65536");
  arrays.need(given.sizes, "sizes");
  arrays.check(given.sizes, "sizes", 4, 0, kFarthest, kLength);
  std::vector<std::size_t> first(arrays.count() + 1);
  for (std::size_t i = 0; i < arrays.count(); ++i) {
    first[i + 1] = first[i] + static_cast<std::size_t>(rows[i]) * static_cast<std::size_t>(columns[i]);
  }
  arrays.check_total(given.height_total, first.back(), "height_total", "rows times columns");
  if (first.back() > kMostCorners) fail(Status::kUnsupported, "the height fields are too large for the ray renderer");
  arrays.need(given.heights, "heights");
  arrays.check_values(given.heights, first.back(), "heights", 1, -kMostNumber, kMostNumber, "a number");
  const std::vector<int> firsts = whole(first);
  render::Stage stage;
  stage.fields = {count, rows.data(), columns.data(), firsts.data(), given.sizes, given.heights};
  made = std::make_shared<const rays::Meshes>(stage);
}

namespace {

// Elements of one surface: triangles, or rods.
void take_elements(const Arrays& arrays, const mimo_stage_surfaces& given, std::size_t which, std::size_t first,
                   int corners, rays::Faces& faces, Surface& surface) {
  const auto at = [&](const int* of, std::size_t element, int k) {
    return of[first + element * static_cast<std::size_t>(corners) + static_cast<std::size_t>(k)];
  };
  const auto check = [&](int value, std::size_t element, int k, const char* name, int most, const char* what) {
    if (value >= 0 && value < most) return;
    fail(Status::kInvalidArgument, "{}: {} is {}, but surface {} has {} {}", arrays.part(),
         place_in(name, first + element * static_cast<std::size_t>(corners) + static_cast<std::size_t>(k), 1), value,
         which, most, what);
  };
  const int* texels = given.texcoord_elements == nullptr ? given.elements : given.texcoord_elements;
  const int texcoords = given.texcoord_counts == nullptr ? 0 : given.texcoord_counts[which];
  const auto count = static_cast<std::size_t>(given.element_counts[which]);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<int, 3> vertices{}, places{};
    for (int k = 0; k < corners; ++k) {
      vertices[static_cast<std::size_t>(k)] = at(given.elements, i, k);
      check(at(given.elements, i, k), i, k, "elements", surface.vertices, "vertices");
      if (texcoords == 0) continue;
      places[static_cast<std::size_t>(k)] = at(texels, i, k);
      check(at(texels, i, k), i, k, "texcoord_elements", texcoords, "texture coordinates");
    }
    if (corners == 2) {
      surface.rods.push_back({vertices[0], vertices[1]});
    } else {
      faces.vertices.push_back(vertices);
      if (texcoords > 0) faces.texels.push_back(places);
    }
  }
}

}  // namespace

Surfaces::Surfaces(const mimo_stage_surfaces& given) {
  const Arrays arrays("surfaces", given.count);
  arrays.need(given.vertex_counts, "vertex_counts");
  arrays.need(given.element_counts, "element_counts");
  const auto vertex = arrays.firsts(given.vertex_counts, "vertex_counts");
  const auto texcoord = arrays.firsts(given.texcoord_counts, "texcoord_counts");
  arrays.firsts(given.element_counts, "element_counts");
  const std::vector<int> corners = arrays.copy_or<int>(given.corners, "corners", {3});
  arrays.check(corners.data(), "corners", 1, 2, 3, "2 or 3");
  std::vector<std::size_t> element(arrays.count() + 1);
  for (std::size_t i = 0; i < arrays.count(); ++i) {
    element[i + 1] =
        element[i] + static_cast<std::size_t>(corners[i]) * static_cast<std::size_t>(given.element_counts[i]);
  }
  arrays.check_total(given.vertex_total, vertex.back(), "vertex_total", "vertex_counts");
  arrays.check_total(given.texcoord_total, texcoord.back(), "texcoord_total", "texcoord_counts");
  arrays.check_total(given.element_length, element.back(), "element_length", "corners times element_counts");
  for (const std::size_t total : {vertex.back(), texcoord.back(), element.back()}) {
    if (total > kMostCorners / 8) fail(Status::kUnsupported, "the surfaces are too large for the ray renderer");
  }
  require(given.vertices != nullptr || vertex.back() == 0, "surfaces: vertices is NULL, but vertex_total is {}",
          vertex.back());
  require(given.elements != nullptr || element.back() == 0, "surfaces: elements is NULL, but element_length is {}",
          element.back());
  require(given.texcoords != nullptr || texcoord.back() == 0, "surfaces: texcoords is NULL, but texcoord_total is {}",
          texcoord.back());
  arrays.check_values(given.vertices, 3 * vertex.back(), "vertices", 3, -kFarthest, kFarthest, "a number of metres");
  arrays.check_values(given.texcoords, 2 * texcoord.back(), "texcoords", 2, -kMostNumber, kMostNumber, "-1e6 to 1e6");
  const std::vector<float> radii = arrays.copy_or<float>(given.radii, "radii", {0});
  arrays.check(radii.data(), "radii", 1, 0, kFarthest, kLength);
  const std::vector<unsigned char> sheets = arrays.copy_or<unsigned char>(given.sheets, "sheets", {0});
  const std::vector<unsigned char> flat = arrays.copy_or<unsigned char>(given.flat, "flat", {0});
  arrays.take_looks(given, *this);
  if (given.objects != nullptr) {
    objects = arrays.copy(given.objects, "objects", 2);
  } else {
    for (int i = 0; i < arrays.whole_count(); ++i) objects.insert(objects.end(), {i, 0});
  }
  vertices = vertex.back();
  std::vector<rays::MovingSurface> at_rest;
  for (std::size_t i = 0; i < arrays.count(); ++i) {
    Surface surface;
    surface.first_vertex = static_cast<int>(vertex[i]);
    surface.vertices = given.vertex_counts[i];
    surface.radius = radii[i];
    rays::Faces faces;
    take_elements(arrays, given, i, element[i], corners[i], faces, surface);
    if (faces.count() > 0) {
      if (texcoord[i + 1] > texcoord[i]) faces.texcoords = given.texcoords + 2 * texcoord[i];
      rays::Shell shell(surface.vertices, std::move(faces), {surface.radius, sheets[i] != 0, flat[i] != 0});
      at_rest.emplace_back(std::move(shell), given.vertices + 3 * vertex[i]);
    } else {
      at_rest.emplace_back();
    }
    all.push_back(std::move(surface));
  }
  moving = std::make_shared<const std::vector<rays::MovingSurface>>(std::move(at_rest));
}

}  // namespace mimo::stage
