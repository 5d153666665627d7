#include "document/mesh_data.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/fail.h"
#include "base/format.h"
#include "document/attributes.h"
#include "document/files.h"
#include "document/report.h"
#include "engine/compiler.h"

namespace mimo::document {
namespace {

using Point = std::array<double, 3>;

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length(const Point& a) { return std::sqrt(dot(a, a)); }

// The point for which a measure is largest.
template <typename Measure>
const Point& farthest(const std::vector<Point>& points, Measure&& measure) {
  const Point* best = &points.front();
  double most = -1;
  for (const Point& point : points) {
    const double here = measure(point);
    if (here > most) {
      most = here;
      best = &point;
    }
  }
  return *best;
}

using Points = std::vector<std::array<double, 3>>;

void leave_out_repeated(Points& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

// The same ones every time, in no order that a file could have.
Points some_of(const Points& points, std::size_t count) {
  constexpr std::uint64_t kFactor = 6364136223846793005, kStep = 1442695040888963407;
  Points some;
  std::uint64_t state = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    state = state * kFactor + kStep;
    some.push_back(points[(state >> 32) % points.size()]);
  }
  leave_out_repeated(some);
  return some;
}

std::array<double, 3> point_at(const std::string& bytes, std::size_t at) {
  return {value_at<float>(bytes, at), value_at<float>(bytes, at + 4), value_at<float>(bytes, at + 8)};
}

// Numbers of a vertex, a point of a texture and a normal; 0 where a corner does not say.
using Numbers = std::array<std::int64_t, 3>;

struct Corner {
  Numbers numbers;
  std::size_t line;
};

const char* const kKinds[3] = {"vertex", "texture point", "normal"};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

class Reader {
 public:
  Reader(const LoadedFile& file, const Limits& limits) : file_(file), limits_(limits) {}

  MeshData read() {
    const std::string& bytes = file_.bytes();
    const char* at = bytes.data() + mark_of_utf8(bytes);
    const char* const end = bytes.data() + bytes.size();
    while (at < end) {
      const char* stop = std::find_if(at, end, [](char c) { return c == '\n' || c == '\r'; });
      ++line_;
      line(at, stop);
      if (stop + 1 < end && stop[0] == '\r' && stop[1] == '\n') ++stop;
      at = stop < end ? stop + 1 : end;
    }
    check();
    return used();
  }

 private:
  void line(const char* at, const char* end) {
    while (at != end && is_blank(*at)) ++at;
    const char* stop = at;
    while (stop != end && !is_blank(*stop)) ++stop;
    if (stop == end) return;  // a word alone says nothing, and is not counted
    const std::string word(at, stop);
    if (word == "v") return vertex(stop, end);
    if (word == "vt") ++counts_[1];
    if (word == "vn") ++counts_[2];
    if (word == "f") face(stop, end);
    if (word == "o" || word == "g") first_is_over_ = has_object_;
    if (word == "mtllib") libraries(stop, end);
  }

  void vertex(const char* at, const char* end) {
    std::array<double, 3> point{};
    for (double& number : point) number = take_number(at, end).value_or(0);
    vertices_.push_back(point);
    require_few(file_, static_cast<double>(++counts_[0]), "vertices", limits_);
  }

  // Numbers below 0 count back from what there is so far.
  std::int64_t resolved(std::int64_t given, std::size_t kind) const {
    return given < 0 ? counts_[kind] + given + 1 : given;
  }

  void face(const char* at, const char* end) {
    int count = 0;
    for (;; ++count) {
      while (at != end && is_blank(*at)) ++at;
      if (at == end) break;
      Numbers numbers{};
      for (std::size_t kind = 0; kind < 3; ++kind) {
        const auto result = std::from_chars(at, end, numbers[kind]);
        if (result.ec == std::errc::result_out_of_range) numbers[kind] = kBeyond;
        numbers[kind] = resolved(numbers[kind], kind);
        at = result.ptr;
        if (at == end || *at != '/') break;
        ++at;
      }
      while (at != end && !is_blank(*at)) ++at;
      if (!first_is_over_) corners_.push_back({numbers, line_});
    }
    count_polygon(count);
    has_object_ = has_object_ || count == 3 || count == 4;  // of larger ones nothing may be left
  }

  // A face becomes triangles. Whether one of three of its corners holds another one is asked of all of them.
  void count_polygon(int corners) {
    constexpr int kAsItIs = 4;
    faces_ += std::max(1, corners - 2);
    require_few(file_, static_cast<double>(faces_), "faces, cut into triangles", limits_);
    if (corners > kAsItIs) polygons_ += static_cast<double>(corners) * corners;
  }

  // Libraries of materials are read with the file that names them, though nothing of them is used.
  void libraries(const char* at, const char* end) const {
    const std::string& path = file_.path();
    const std::size_t slash = path.find_last_of("/\\");
    const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash) + "/";
    std::istringstream names(std::string(at, end));
    for (std::string name; names >> name;) file_.read(folder + name, limits_);
  }

  void check() const {
    for (const auto& [numbers, line] : corners_) {
      for (std::size_t kind = 0; kind < 3; ++kind) {
        const bool needed = kind == 0 || counts_[kind] > 0;
        if (needed && !(numbers[kind] >= 1 && numbers[kind] <= counts_[kind])) refuse(kind, numbers[kind], line);
      }
    }
    const bool fitting = (counts_[1] == 0 || counts_[1] == counts_[0]) && (counts_[2] == 0 || counts_[2] == counts_[0]);
    if (corners_.empty() && !fitting)
      file_.refuse("has no faces, and not as many normals and texture points as vertices");
  }

  [[noreturn]] void refuse(std::size_t kind, std::int64_t number, std::size_t line) const {
    if (number == 0 && kind > 0) {
      file_.refuse(
          format("has, in line {}, a corner of a face without a {}, where the file has some; each corner of "
                 "each face needs one",
                 line, kKinds[kind]));
    }
    file_.refuse(
        format("has, in line {}, a face at {} {}, but there are {}", line, kKinds[kind], number, counts_[kind]));
  }

  MeshData used() {
    if (corners_.empty()) return {std::move(vertices_), false};
    std::vector<bool> used(vertices_.size());
    for (const Corner& corner : corners_) used[static_cast<std::size_t>(corner.numbers[0] - 1)] = true;
    MeshData data{{}, true, static_cast<double>(corners_.size()), 0, polygons_};
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (used[i]) data.vertices.push_back(vertices_[i]);
    }
    return data;
  }

  static constexpr std::int64_t kBeyond = INT64_C(1) << 40;

  const LoadedFile& file_;
  const Limits& limits_;
  std::vector<std::array<double, 3>> vertices_;
  std::vector<Corner> corners_;  // of the first object, the only one that MuJoCo takes
  Numbers counts_{};
  std::int64_t faces_ = 0;
  std::size_t line_ = 0;
  double polygons_ = 0;
  bool has_object_ = false, first_is_over_ = false;
};

}  // namespace

// A wide triangle among the points, and what is farthest from its plane.
bool is_flat(const std::vector<Point>& points) {
  if (points.empty()) return true;
  constexpr double kFlat = 3e-6;  // of the extent: below 1e-6 Qhull says at times that a hull is narrow
  const Point& any = points.front();
  const Point& one = farthest(points, [&](const Point& p) { return length(difference(p, any)); });
  const Point& two = farthest(points, [&](const Point& p) { return length(difference(p, one)); });
  const Point along = difference(two, one);
  const double extent = length(along);
  const auto from_line = [&](const Point& p) { return length(cross(along, difference(p, one))); };
  const Point& three = farthest(points, from_line);
  if (from_line(three) <= kFlat * extent * extent) return true;
  const Point normal = cross(along, difference(three, one));
  const auto from_plane = [&](const Point& p) { return std::abs(dot(normal, difference(p, one))) / length(normal); };
  return from_plane(farthest(points, from_plane)) <= kFlat * extent;
}

double hull_corners(Points points) {
  constexpr std::size_t kFew = 3000, kLeast = 512, kMost = 4096;  // of fewer, all may be corners
  if (points.size() > kFew) leave_out_repeated(points);
  const auto all = static_cast<double>(points.size());
  if (points.size() <= kFew) return all;
  const Points some = some_of(points, std::clamp(points.size() / 8, kLeast, kMost));
  if (is_flat(some)) return all;
  return std::min(all, all * engine::hull_corners(some) / static_cast<double>(some.size()));
}

Points kept_vertices(pugi::xml_node mesh, const Limits& limits) {
  const LoadedFile file(mesh, "file", limits);
  try {
    return engine::vertices_of("mesh" + file.extension(), file.bytes());
  } catch (const Error& error) {
    fail(error.status(), "{}: {}", where(mesh), error.message());
  }
}

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

// Wavefront's .obj, as far as MuJoCo reads it: the first object's faces, and what they refer to.

MeshData read_obj(const LoadedFile& file, const Limits& limits) { return Reader(file, limits).read(); }

}  // namespace mimo::document
