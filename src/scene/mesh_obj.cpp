// Wavefront's .obj, as far as MuJoCo reads it: the first object's faces, and what they refer to.
#include <algorithm>
#include <charconv>
#include <sstream>

#include "base/format.h"
#include "scene/attributes.h"
#include "scene/mesh_data.h"

namespace mimo::scene {
namespace {

// A corner of a face: numbers of a vertex, a point of a texture and a normal; 0 where it does not say.
using Corner = std::array<std::int64_t, 3>;

const char* const kKinds[3] = {"vertex", "texture point", "normal"};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

class Reader {
 public:
  Reader(const LoadedFile& file, const Limits& limits) : file_(file), limits_(limits) {}

  MeshData read() {
    const std::string& bytes = file_.bytes();
    const char* at = bytes.data();
    const char* const end = at + bytes.size();
    while (at < end) {
      const char* const stop = std::find_if(at, end, [](char c) { return c == '\n' || c == '\r'; });
      line(at, stop);
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
    require_few(file_, static_cast<double>(++faces_), "faces", limits_);
    int count = 0;
    for (;; ++count) {
      while (at != end && is_blank(*at)) ++at;
      if (at == end) break;
      Corner corner{};
      for (std::size_t kind = 0; kind < 3; ++kind) {
        const auto result = std::from_chars(at, end, corner[kind]);
        if (result.ec == std::errc::result_out_of_range) corner[kind] = kBeyond;
        corner[kind] = resolved(corner[kind], kind);
        at = result.ptr;
        if (at == end || *at != '/') break;
        ++at;
      }
      while (at != end && !is_blank(*at)) ++at;
      if (!first_is_over_) corners_.push_back(corner);
    }
    has_object_ = has_object_ || count == 3 || count == 4;  // of larger ones nothing may be left
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
    for (const Corner& corner : corners_) {
      for (std::size_t kind = 0; kind < 3; ++kind) {
        const bool needed = kind == 0 || counts_[kind] > 0;
        if (!needed || (corner[kind] >= 1 && corner[kind] <= counts_[kind])) continue;
        file_.refuse(format("has a face at {} {}, but there are {}", kKinds[kind], corner[kind], counts_[kind]));
      }
    }
    const bool fitting = (counts_[1] == 0 || counts_[1] == counts_[0]) && (counts_[2] == 0 || counts_[2] == counts_[0]);
    if (corners_.empty() && !fitting)
      file_.refuse("has no faces, and not as many normals and texture points as vertices");
  }

  MeshData used() {
    if (corners_.empty()) return {std::move(vertices_), false};
    MeshData data{{}, true};
    for (const Corner& corner : corners_) data.vertices.push_back(vertices_[static_cast<std::size_t>(corner[0] - 1)]);
    return data;
  }

  static constexpr std::int64_t kBeyond = INT64_C(1) << 40;

  const LoadedFile& file_;
  const Limits& limits_;
  std::vector<std::array<double, 3>> vertices_;
  std::vector<Corner> corners_;  // of the first object, the only one that MuJoCo takes
  Corner counts_{};
  std::int64_t faces_ = 0;
  bool has_object_ = false, first_is_over_ = false;
};

}  // namespace

MeshData read_obj(const LoadedFile& file, const Limits& limits) { return Reader(file, limits).read(); }

}  // namespace mimo::scene
