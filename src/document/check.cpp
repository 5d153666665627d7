#include "document/check.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "document/attributes.h"
#include "document/budget.h"
#include "document/check_pictures.h"
#include "document/compiler.h"
#include "document/defaults.h"
#include "document/files.h"
#include "document/mesh_data.h"
#include "document/names.h"
#include "document/report.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

// Of the model: a vertex with normal and texture point, a corner of a hull's graph, a byte of a file.
constexpr double kVertexBytes = 40, kHullBytes = 70, kFileGrowth = 2;

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
  const auto with_size = [&](MeshData data) {
    data.file_bytes = static_cast<double>(file.bytes().size());
    return data;
  };
  if (ending == ".stl") return with_size(read_stl(file, limits));
  if (ending == ".msh") return with_size(read_msh(file, limits));
  if (ending == ".obj") return with_size(read_obj(file, limits));
  file.refuse("ends in \"" + ending + "\", expected .stl, .obj or .msh");
}

bool is_zero(pugi::xml_attribute attribute) {
  return !attribute.empty() && std::strtod(attribute.value(), nullptr) == 0;
}

std::string name_of(pugi::xml_node mesh) {
  const std::string name = mesh.attribute("name").value();
  return name.empty() ? stem_of(mesh.attribute("file").value()) : name;
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

void require_at_most(pugi::xml_node node, const char* attribute, double most, const char* limit) {
  const std::optional<double> value = number(node, attribute);
  if (!value || *value <= most) return;
  fail(Status::kModel, "{}: {}=\"{}\" is more than {} ({})", where(node), attribute, node.attribute(attribute).value(),
       limit, most);
}

void check_option(pugi::xml_node option, const Limits& limits) {
  const std::optional<double> step = number(option, "timestep");
  if (step && !(*step > 0 && std::isfinite(*step))) {
    fail(Status::kModel, "{}: timestep=\"{}\", expected seconds above 0", where(option),
         option.attribute("timestep").value());
  }
  for (const char* name :
       {"iterations", "noslip_iterations", "mpr_iterations", "ccd_iterations", "ls_iterations", "sdf_iterations"}) {
    require_at_most(option, name, static_cast<double>(limits.iterations), "max_iterations");
  }
}

// How far muscles and motors are moved to find their lengths, step by step.
void check_length_range(pugi::xml_node lengths) {
  constexpr double kMostSteps = 1e6;
  const double time = number(lengths, "inttotal").value_or(10), step = number(lengths, "timestep").value_or(0.01);
  if (step > 0 && time / step <= kMostSteps) return;
  fail(Status::kModel, "{}: inttotal {} over timestep {} of <lengthrange>, expected at most {} steps", where(lengths),
       time, step, kMostSteps);
}

// The compiler has room for 500 numbers, and believes what it is told.
void check_numeric(pugi::xml_node numeric) {
  constexpr double kMost = 500;
  const std::optional<double> size = number(numeric, "size");
  const double given = static_cast<double>(words(numeric.attribute("data")));
  if (size.value_or(given) <= kMost && given <= kMost) return;
  fail(Status::kModel, "{}: <numeric> of {} numbers, expected at most {}", where(numeric), size.value_or(given), kMost);
}

void check_composite_skin(pugi::xml_node composite, const Limits& limits) {
  const double fineness = 1 + std::max(0.0, number(composite.child("skin"), "subgrid").value_or(0));
  const double count = made_by(composite) * fineness * fineness;
  if (count <= static_cast<double>(limits.vertices)) return;
  fail(Status::kModel, "{}: the skin of a composite would have {} vertices, more than max_vertices ({})",
       where(composite), count, limits.vertices);
}

}  // namespace

Meshes::Meshes(pugi::xml_node root, const Limits& limits) : root_(root), limits_(limits) {}

// Meshes that touch others as some geom: of those MuJoCo makes convex hulls. Looked for once, for those that ask.
bool Meshes::has_hull(pugi::xml_node mesh) {
  if (!touched_) {
    touched_.emplace();
    const Defaults defaults(root_);
    const auto note = [&](pugi::xml_node node) {
      if (!is(node, "geom") || std::strcmp(defaults.find(node, "type").value(), "mesh") != 0) return;
      const bool touches = !is_zero(defaults.find(node, "contype")) || !is_zero(defaults.find(node, "conaffinity"));
      if (touches) touched_->insert(defaults.find(node, "mesh").value());
    };
    for (const pugi::xml_node world : root_.children("worldbody")) walk(world, note);
  }
  return compiler_setting(root_, "convexhull") != "false" && touched_->count(name_of(mesh)) > 0;
}

// As MuJoCo keeps them: scaled, as floats.
void Meshes::scale(pugi::xml_node mesh, MeshData& data) {
  if (!defaults_) defaults_.emplace(root_);
  const std::vector<double> scale = numbers_in(defaults_->giver(mesh, "scale"), "scale");
  for (auto& vertex : data.vertices) {
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      const auto number = static_cast<float>(static_cast<float>(vertex[i]) * (scale.size() == 3 ? scale[i] : 1));
      if (!std::isfinite(number)) {
        fail(Status::kModel, "{}: mesh \"{}\" has a vertex at {}, expected finite numbers", where(mesh), name_of(mesh),
             scale.size() == 3 ? vertex[i] * scale[i] : vertex[i]);
      }
      vertex[i] = number;
    }
  }
}

// The library that makes convex hulls writes to the host's stderr where it cannot.
void Meshes::check_hull(pugi::xml_node mesh, MeshData& data, Budget& budget) {
  constexpr std::size_t kFewest = 4;
  if (data.has_faces && !has_hull(mesh)) return;
  if (data.polygons > 0) {
    data.vertices = kept_vertices(mesh, limits_);
    scale(mesh, data);
  }
  if (data.vertices.size() >= kFewest && !is_flat(data.vertices)) {
    const double corners = hull_corners(data.vertices);
    budget.add_time(mesh, (cost::kHullCorner + cost::kHullPair * corners) * corners);
    return budget.add_bytes(mesh, kHullBytes * corners);
  }
  fail(
      Status::kModel,
      "{}: mesh \"{}\" is flat, and has no convex hull; give it faces and its geoms contype=\"0\" conaffinity=\"0\" if "
      "it is only looked at",
      where(mesh), name_of(mesh));
}

void Meshes::check(pugi::xml_node mesh, Budget& budget) {
  for (const double number : numbers_in(mesh, "refpos")) {
    if (std::isfinite(static_cast<float>(number))) continue;
    fail(Status::kModel, "{}: mesh \"{}\" has refpos=\"{}\", expected finite numbers", where(mesh), name_of(mesh),
         mesh.attribute("refpos").value());
  }
  MeshData data = read(mesh, limits_);
  budget.add_time(mesh, cost::kTextByte * data.file_bytes + cost::kPolygon * data.polygons);
  budget.add_bytes(mesh, kFileGrowth * data.file_bytes +
                             kVertexBytes * std::max(data.kept, static_cast<double>(data.vertices.size())));
  scale(mesh, data);
  if (!data.vertices.empty()) check_hull(mesh, data, budget);
}

void check_skin(pugi::xml_node skin, const Limits& limits, Budget& budget) {
  if (skin.attribute("file")) {
    const LoadedFile file(skin, "file", limits);
    const auto bytes = static_cast<double>(file.bytes().size());
    budget.add_time(skin, cost::kTextByte * bytes);
    budget.add_bytes(skin, kFileGrowth * bytes);
    return check_skin_file(file, limits);
  }
  const std::size_t vertices = numbers_in(skin, "vertex").size() / 3;
  require_few(skin, static_cast<double>(vertices), "vertices", limits);
  check_faces(skin, vertices, limits);
}

Budget check(pugi::xml_node root, const Limits& limits) {
  Budget budget(limits);
  Counts counts(limits);
  walk(root, [&](pugi::xml_node node) { counts.add(node); });
  counts.check(root, budget);
  Meshes meshes(root, limits);
  walk(root, [&](pugi::xml_node node) {
    if (is(node, "option")) check_option(node, limits);
    if (is(node, "lengthrange")) check_length_range(node);
    if (is(node, "numeric")) check_numeric(node);
    if (is(node, "composite")) check_composite_skin(node, limits);
    if (is(node, "quality")) check_shadows(node, limits);
    if (!is(node.parent(), "asset")) return;
    if (is(node, "texture")) check_texture(node, limits, budget);
    if (is(node, "hfield")) check_height_field(node, limits, budget);
    if (is(node, "mesh")) meshes.check(node, budget);
    if (is(node, "skin")) check_skin(node, limits, budget);
  });
  counts.check_world(root, budget);
  return budget;
}

}  // namespace mimo::document
