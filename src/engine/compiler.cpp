#include "engine/compiler.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "compat/mujoco.h"
#include "engine/guard.h"
#include "engine/hooks.h"
#include "engine/model.h"

namespace mimo::engine {
namespace {

std::string printed() {
  std::vector<char> text(1 << 16);
  int length = 0;
  const Complaint complaint = guarded([&] {
    length = mj_printSchema(nullptr, text.data(), static_cast<int>(text.size()), /*flg_html=*/0, /*flg_pad=*/0);
  });
  if (complaint.failed || length <= 0) fail(Status::kInternal, "MuJoCo does not print its schema");
  return text.data();
}

// "(*)" after an element's name: how often it may stand there; R: it may hold itself.
bool is_type(const std::string& word) { return word.size() == 3 && word.front() == '(' && word.back() == ')'; }

// No stream: those take missing memory for the end of a text.
std::vector<std::string> split(const std::string& text, const char* at) {
  std::vector<std::string> parts;
  for (std::size_t begin = text.find_first_not_of(at); begin != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(at, end);
  }
  return parts;
}

// Three spaces a level, then name, type and attributes; lines that have no type go on with attributes.
SchemaElement parsed(const std::string& text) {
  constexpr std::size_t kIndent = 3;
  SchemaElement root;
  std::vector<SchemaElement*> path;
  for (const std::string& line : split(text, "\n")) {
    const std::vector<std::string> words = split(line, " ");
    if (words.empty()) continue;
    const bool begins = words.size() > 1 && is_type(words[1]);
    if (begins) {
      const std::size_t level = line.find_first_not_of(' ') / kIndent;
      const std::string name = words[0] == "(world)body" ? "body" : words[0];
      path.resize(std::min(level, path.size()));
      path.push_back(path.empty() ? &root : &path.back()->children[name]);
      path.back()->nests = words[1] == "(R)";
    }
    if (!path.empty()) path.back()->attributes.insert(words.begin() + (begins ? 2 : 0), words.end());
  }
  return root;
}

SchemaElement made() {
  SchemaElement root = parsed(printed());
  // MuJoCo writes it into a stream, which ends early where memory is out.
  if (root.children["keyframe"].children["key"].attributes.empty()) throw std::bad_alloc();
  SchemaElement world = root.children["body"];
  world.attributes.clear();
  world.nests = false;
  world.children["body"] = root.children["body"];
  root.children["worldbody"] = world;
  root.children.erase("body");
  return root;
}

std::optional<SchemaElement> known;  // under the lock

Bytes decoded(const mjModel& model, int texture) {
  const std::array<std::int32_t, 2> size{model.tex_width[texture], model.tex_height[texture]};
  const auto count = static_cast<std::size_t>(compat::channels(model, texture)) * static_cast<std::size_t>(size[0]) *
                     static_cast<std::size_t>(size[1]);
  Bytes bytes(sizeof size + count);
  std::memcpy(bytes.data(), size.data(), sizeof size);
  std::memcpy(bytes.data() + sizeof size, model.*compat::kPixels + model.tex_adr[texture], count);
  return bytes;
}

bool have_the_same(const mjModel& a, const mjModel& b) {
  const auto same = [&](auto* mjModel::*array, int count) { return std::equal(a.*array, a.*array + count, b.*array); };
  return a.ntex == b.ntex && a.ntexdata == b.ntexdata && same(&mjModel::tex_type, a.ntex) &&
         same(&mjModel::tex_height, a.ntex) && same(&mjModel::tex_width, a.ntex) && same(&mjModel::tex_adr, a.ntex) &&
         same(compat::kPixels, a.ntexdata);
}

// All but the textures' bytes; null where MuJoCo does not lay out its models as we know it.
mjModel* copy_without_textures(const mjModel& model) {
  mjModel source = model;
  const auto* end = static_cast<const mjtByte*>(compat::behind_pixels(model));
  source.nbuffer -= static_cast<int>(end - model.*compat::kPixels);
  source.ntexdata = 0;
  mjModel* copy = nullptr;
  const Complaint complaint = guarded([&] { copy = mj_copyModel(nullptr, &source); });
  return complaint.failed ? nullptr : copy;
}

}  // namespace

// fork() waits for the lock: in a child, MuJoCo's own, which printing takes, would never open.
const SchemaElement& schema() {
  const CompileLock lock;
  if (!known) known = made();
  return *known;
}

bool is_mujoco_2() { return mj_version() / 100 == 2; }

double most_model_bytes() {
  return is_mujoco_2() ? std::numeric_limits<int>::max() : std::numeric_limits<double>::infinity();
}

std::string compiler_name() { return std::string("MuJoCo ") + mj_versionString(); }

int hull_corners(const std::vector<std::array<double, 3>>& points) {
  std::string numbers;
  for (const auto& point : points) numbers += join(point, " ") + " ";
  const ModelPtr model = compile("<mujoco><asset><mesh name=\"m\" vertex=\"" + numbers +
                                     "\"/></asset><worldbody><geom type=\"mesh\" mesh=\"m\"/></worldbody></mujoco>",
                                 {}, {});
  return model->mesh_graph[model->mesh_graphadr[0]];
}

// No geom touches others with the mesh, so it gets no hull.
std::vector<std::array<double, 3>> vertices_of(const std::string& name, const std::string& bytes) {
  const Asset file{name, {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}};
  const ModelPtr model =
      compile("<mujoco><asset><mesh name=\"m\" file=\"" + name + "\"/></asset></mujoco>", {file}, {});
  std::vector<std::array<double, 3>> vertices;
  for (int i = 0; i < model->nmeshvert; ++i) {
    const float* at = model->mesh_vert + static_cast<std::ptrdiff_t>(3) * i;
    vertices.push_back({at[0], at[1], at[2]});
  }
  return vertices;
}

bool takes_decoded() { return MIMO_MUJOCO_4 == 0; }

// By the compiler's own decoder: as textures of a model that has nothing else.
std::vector<Bytes> decode(const std::vector<Asset>& pictures) {
  std::vector<Bytes> all;
  if (pictures.empty()) return all;
  std::string document = "<mujoco><asset>";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    document += "<texture type=\"2d\" name=\"" + std::to_string(i) + "\" file=\"" + pictures[i].name + "\"/>";
  }
  document += "</asset></mujoco>";
  const ModelPtr model = compile(document, pictures, {});
  for (int texture = 0; texture < model->ntex; ++texture) all.push_back(decoded(*model, texture));
  return all;
}

ModelPtr with_textures_of(const ModelPtr& owner, ModelPtr model) {
  if (model == owner || model->ntexdata == 0 || !have_the_same(*owner, *model)) return model;
  mjModel* slim = copy_without_textures(*model);
  if (slim == nullptr) return model;
  slim->nbuffer = model->nbuffer;  // as it says of itself it is the same, for MuJoCo that copies it, and for states
  slim->ntexdata = model->ntexdata;
  slim->*compat::kPixels = (*owner).*compat::kPixels;
  return ModelPtr(slim, [owner](mjModel* one) { mj_deleteModel(one); });
}

bool share_textures(const mjModel& one, const mjModel& other) { return one.*compat::kPixels == other.*compat::kPixels; }

}  // namespace mimo::engine
