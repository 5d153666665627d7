#include "scene/check_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "scene/attributes.h"
#include "scene/binary.h"
#include "scene/compiler.h"
#include "scene/defaults.h"
#include "scene/flat.h"
#include "scene/lines.h"
#include "scene/loaded_file.h"
#include "scene/mesh_data.h"
#include "scene/names.h"
#include "scene/xml.h"

namespace mimo::scene {
namespace {

// What an attribute that lists numbers in threes, such as faces, may not have.
void require_few(pugi::xml_node node, double count, const char* what, const Limits& limits) {
  if (count <= static_cast<double>(limits.vertices)) return;
  fail(Status::kModel, "{}: <{}> has {} {}, more than max_vertices ({})", where(node), node.name(), count, what,
       limits.vertices);
}

void check_faces(pugi::xml_node node, std::size_t vertices, const Limits& limits) {
  const std::vector<double> faces = numbers_in(node, "face");
  require_few(node, static_cast<double>(faces.size()) / 3, "faces", limits);
  for (const double index : faces) {
    if (index >= 0 && index < static_cast<double>(vertices)) continue;
    fail(Status::kModel, "{}: <{}> has a face at vertex {}, but {} vertices", where(node), node.name(), index,
         vertices);
  }
}

MeshData read_inline(pugi::xml_node mesh, const Limits& limits) {
  const std::vector<double> numbers = numbers_in(mesh, "vertex");
  require_few(mesh, static_cast<double>(numbers.size()) / 3, "vertices", limits);
  MeshData data{{}, !numbers_in(mesh, "face").empty()};
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    data.vertices.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  check_faces(mesh, data.vertices.size(), limits);
  return data;
}

MeshData read(pugi::xml_node mesh, const Limits& limits) {
  if (!mesh.attribute("file")) return read_inline(mesh, limits);
  const LoadedFile file(mesh, "file", limits);
  const std::string ending = file.extension();
  if (ending == ".stl") return read_stl(file, limits);
  if (ending == ".msh") return read_msh(file, limits);
  if (ending == ".obj") return read_obj(file, limits);
  file.refuse("ends in \"" + ending + "\", expected .stl, .obj or .msh");
}

bool is_zero(pugi::xml_attribute attribute) {
  return !attribute.empty() && std::strtod(attribute.value(), nullptr) == 0;
}

// Whether some geom touches others with this mesh: for that MuJoCo makes its convex hull.
bool is_touched(pugi::xml_node root, const std::string& name) {
  const Defaults defaults(root);
  bool touched = false;
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      const bool shows = is(node, "geom") && name == defaults.find(node, "mesh").value() &&
                         std::strcmp(defaults.find(node, "type").value(), "mesh") == 0;
      if (!shows) return;
      touched = touched || !is_zero(defaults.find(node, "contype")) || !is_zero(defaults.find(node, "conaffinity"));
    });
  }
  return touched;
}

std::string name_of(pugi::xml_node mesh) {
  const std::string name = mesh.attribute("name").value();
  return name.empty() ? stem_of(mesh.attribute("file").value()) : name;
}

// The library that makes convex hulls writes to the host's stderr where it cannot.
void check_hull(pugi::xml_node mesh, pugi::xml_node root, const MeshData& data) {
  constexpr std::size_t kFewest = 4;
  if (data.vertices.size() >= kFewest && !is_flat(data.vertices)) return;
  const bool makes_hulls = compiler_setting(root, "convexhull") != "false";
  if (data.has_faces && !(makes_hulls && is_touched(root, name_of(mesh)))) return;
  fail(
      Status::kModel,
      "{}: mesh \"{}\" is flat, and has no convex hull; give it faces and its geoms contype=\"0\" conaffinity=\"0\" if "
      "it is only looked at",
      where(mesh), name_of(mesh));
}

// Walks along the bones: a name, a pose, and as many vertices and weights as it says.
void check_bones(const LoadedFile& file, std::size_t at, std::int32_t bones) {
  constexpr std::size_t kBone = 4 * 18;
  const std::string& bytes = file.bytes();
  for (std::int32_t i = 0; i < bones; ++i) {
    if (bytes.size() - at < kBone) file.refuse("ends within a bone");
    const std::int32_t count = little_endian(bytes, at + kBone - 4);
    at += kBone;
    if (count < 1 || static_cast<std::uint64_t>(count) > (bytes.size() - at) / 8) file.refuse("ends within a bone");
    at += 8 * static_cast<std::size_t>(count);
  }
  if (at != bytes.size()) file.refuse("has another size than its header says");
}

void check_skin_file(const LoadedFile& file, const Limits& limits) {
  constexpr std::size_t kHeader = 16;
  const std::string& bytes = file.bytes();
  if (bytes.size() < kHeader) file.refuse("is too short for its header");
  std::int32_t counts[4];  // vertices, points of a texture, faces, bones
  for (std::size_t i = 0; i < 4; ++i) {
    counts[i] = little_endian(bytes, 4 * i);
    if (counts[i] < 0) file.refuse("has a count below 0 in its header");
    require_few(file, counts[i], "vertices, faces or bones", limits);
  }
  const auto count = [&](std::size_t i) { return static_cast<std::size_t>(counts[i]); };
  const std::size_t faces = kHeader + 12 * count(0) + 8 * count(1), bones = faces + 12 * count(2);
  if (bones > bytes.size()) file.refuse("is shorter than its header says");
  for (std::size_t at = faces; at < bones; at += 4) {
    const std::int32_t index = little_endian(bytes, at);
    if (index < 0 || index >= counts[0]) {
      file.refuse(format("has a face at vertex {}, but {} vertices", index, counts[0]));
    }
  }
  check_bones(file, bones, counts[3]);
}

}  // namespace

void check_mesh(pugi::xml_node mesh, pugi::xml_node root, const Limits& limits) {
  const MeshData data = read(mesh, limits);
  for (const auto& vertex : data.vertices) {
    for (const double number : vertex) {
      if (std::isfinite(static_cast<float>(number))) continue;
      fail(Status::kModel, "{}: mesh \"{}\" has a vertex at {}, expected finite numbers", where(mesh), name_of(mesh),
           number);
    }
  }
  if (!data.vertices.empty()) check_hull(mesh, root, data);
}

void check_skin(pugi::xml_node skin, const Limits& limits) {
  if (skin.attribute("file")) return check_skin_file(LoadedFile(skin, "file", limits), limits);
  const std::size_t vertices = numbers_in(skin, "vertex").size() / 3;
  require_few(skin, static_cast<double>(vertices), "vertices", limits);
  check_faces(skin, vertices, limits);
}

}  // namespace mimo::scene
