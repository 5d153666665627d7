#include "engine/schema.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <limits>
#include <new>
#include <optional>
#include <vector>

#include "base/fail.h"
#include "engine/compile_lock.h"
#include "engine/guard.h"

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

}  // namespace mimo::engine
