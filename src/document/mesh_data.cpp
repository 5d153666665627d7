#include "document/mesh_data.h"

#include "base/format.h"
#include "document/binary.h"

namespace mimo::document {
namespace {

std::array<double, 3> point_at(const std::string& bytes, std::size_t at) {
  return {value_at<float>(bytes, at), value_at<float>(bytes, at + 4), value_at<float>(bytes, at + 8)};
}

}  // namespace

void require_few(const LoadedFile& file, double count, const char* what, const Limits& limits) {
  if (count <= static_cast<double>(limits.vertices)) return;
  file.refuse(format("has {} {}, more than max_vertices ({})", count, what, limits.vertices));
}

MeshData read_stl(const LoadedFile& file, const Limits& limits) {
  constexpr std::size_t kHeader = 84, kFace = 50, kNormal = 12;
  const std::string& bytes = file.bytes();
  if (bytes.size() < kHeader) file.refuse("is too short for its header");
  const std::uint32_t faces = value_at<std::uint32_t>(bytes, kHeader - 4);
  if (kHeader + faces * kFace != bytes.size()) file.refuse("has another size than its header says; is it binary STL?");
  require_few(file, faces, "faces", limits);
  MeshData data{{}, true};
  for (std::size_t at = kHeader; at + kFace <= bytes.size(); at += kFace) {
    for (std::size_t i = 0; i < 3; ++i) data.vertices.push_back(point_at(bytes, at + kNormal + 12 * i));
  }
  return data;
}

MeshData read_msh(const LoadedFile& file, const Limits& limits) {
  constexpr std::size_t kHeader = 16, kPoint = 12, kTexture = 8;
  const std::string& bytes = file.bytes();
  if (bytes.size() < kHeader) file.refuse("is too short for its header");
  std::size_t counts[4];  // vertices, normals, points of a texture, faces
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int32_t count = little_endian(bytes, 4 * i);
    if (count < 0) file.refuse("has a count below 0 in its header");
    require_few(file, count, "vertices or faces", limits);
    counts[i] = static_cast<std::size_t>(count);
  }
  const std::size_t before_faces = kHeader + kPoint * (counts[0] + counts[1]) + kTexture * counts[2];
  if (before_faces + kPoint * counts[3] != bytes.size()) file.refuse("has another size than its header says");
  MeshData data{{}, counts[3] > 0};
  for (std::size_t i = 0; i < counts[0]; ++i) data.vertices.push_back(point_at(bytes, kHeader + kPoint * i));
  for (std::size_t at = before_faces; at < bytes.size(); at += 4) {
    const std::int32_t index = little_endian(bytes, at);
    if (index >= 0 && static_cast<std::size_t>(index) < counts[0]) continue;
    file.refuse(format("has a face at vertex {}, but {} vertices", index, counts[0]));
  }
  return data;
}

}  // namespace mimo::document
