// Wavefront's .obj, as far as MuJoCo reads it: the first object's faces, and what they refer to.
#include <algorithm>
#include <charconv>
#include <sstream>

#include "base/format.h"
#include "document/attributes.h"
#include "document/binary.h"
#include "document/mesh_data.h"

namespace mimo::document {
namespace {

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

MeshData read_obj(const LoadedFile& file, const Limits& limits) { return Reader(file, limits).read(); }

}  // namespace mimo::document
