#include "document/composition.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

#include "base/fail.h"
#include "base/format.h"
#include "document/check.h"
#include "document/compiler.h"
#include "document/defaults.h"
#include "document/files.h"
#include "document/library.h"
#include "document/names.h"
#include "document/report.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

// They are most of what a compiler does, and tell nothing of where things are.
void drop_pictures(pugi::xml_node root) {
  for (pugi::xml_node assets : root.children("asset")) {
    while (assets.child("texture")) assets.remove_child("texture");
  }
  walk(root, [](pugi::xml_node node) {
    if (!is(node, "material")) return;
    node.remove_attribute("texture");
    while (node.child("layer")) node.remove_child("layer");
  });
}

// MuJoCo takes a mark of UTF-8 for part of the first word of an .obj, and so the first vertex for none.
void hand_over_unmarked(pugi::xml_node mesh, const Limits& limits, Composition& composition) {
  if (extension_of(mesh.attribute("file").value()) != ".obj") return;
  const LoadedFile file(mesh, "file", limits);
  const std::size_t mark = mark_of_utf8(file.bytes());
  if (mark == 0) return;
  if (!mesh.attribute("name")) set(mesh, "name", stem_of(file.path()));
  const std::string name = "unmarked:" + std::to_string(composition.texts.size()) + ".obj";
  set(mesh, "file", name);
  composition.texts.push_back(std::make_shared<const std::string>(file.bytes().substr(mark)));
  const std::string& text = *composition.texts.back();
  composition.assets.push_back({name, {reinterpret_cast<const unsigned char*>(text.data()), text.size()}});
}

// MuJoCo would look for what is not there on the disk.
void require_held(pugi::xml_node root, const Files& files) {
  walk(root, [&](pugi::xml_node node) {
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const std::string path = attribute.value();
      if (std::string(attribute.name()).rfind("file", 0) != 0 || path.empty()) continue;
      if (files.count(path) != 0 || !built_in_asset(path).empty()) continue;
      fail(Status::kModel, "{}: there is no file \"{}\" beside the document", where(node), path);
    }
  });
}

// MuJoCo tells files in memory apart by their last part only.
std::string flat_name(std::string path) {
  std::replace(path.begin(), path.end(), '/', ':');
  return path;
}

// The files outlive the composition, as the limits of its scene hold them.
void hand_over(const Files& files, pugi::xml_node node, pugi::xml_attribute attribute, std::set<std::string>& seen,
               Composition& composition) {
  const auto found = files.find(attribute.value());
  if (found == files.end()) return;  // handed over in another form already
  const std::string name = flat_name(found->first);
  set(node, attribute.name(), name);
  const std::string& bytes = found->second;
  if (!seen.insert(name).second) return;
  composition.assets.push_back({name, {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}});
}

// The compiler makes a step of what it has compiled, in which every geom may be asked about every other one: for as
// long as that takes, no other thread could compile. Whether the document itself has contacts.
bool leave_out_contacts(pugi::xml_node root) {
  constexpr const char* kOff = "disable";
  bool had = true;
  for (const pugi::xml_node option : root.children("option")) {
    for (const pugi::xml_node flag : option.children("flag")) {
      if (flag.attribute("contact")) had = std::strcmp(flag.attribute("contact").value(), kOff) != 0;
    }
  }
  set(append(append(root, "option"), "flag"), "contact", kOff);
  return had;
}

// Every kind of actuator except the general one sets the state, also in classes.
bool has_state(pugi::xml_node actuator, const Defaults& defaults) {
  const pugi::xml_node decides = defaults.first(
      actuator, [](pugi::xml_node node) { return !is(node, "general") || !node.attribute("dyntype").empty(); });
  const std::string dynamics = decides.attribute("dyntype").value();
  if (is(decides, "general")) return !dynamics.empty() && dynamics != "none";
  return is_one_of(decides, {"muscle", "intvelocity", "cylinder"});
}

struct UserNumbers {
  const char* size;
  std::initializer_list<const char*> elements;
  const char* section;  // instead: all that stands there
};
const std::array<UserNumbers, 8> kUserNumbers = {
    {{"nuser_body", {"body"}, ""},
     {"nuser_jnt", {"joint", "freejoint"}, ""},
     {"nuser_geom", {"geom"}, ""},
     {"nuser_site", {"site"}, ""},
     {"nuser_cam", {"camera"}, ""},
     {"nuser_tendon", {"tendon"}, "tendon"},
     {"nuser_actuator",
      {"general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion"},
      "actuator"},
     {"nuser_sensor", {}, "sensor"}}};

// The most numbers that an element, or one of a default class, has.
int longest(pugi::xml_node root, const UserNumbers& kind) {
  std::size_t most = 0;
  walk(root, [&](pugi::xml_node node) {
    const pugi::xml_attribute user = node.attribute("user");
    if (user && (is(node.parent(), kind.section) || is_one_of(node, kind.elements))) {
      most = std::max(most, numbers(user).size());
    }
  });
  return static_cast<int>(most);
}

}  // namespace

std::vector<AssetFile> asset_files(pugi::xml_node root) {
  std::vector<AssetFile> files;
  for (const pugi::xml_node assets : root.children("asset")) {
    walk(assets, [&](pugi::xml_node node) {
      for (const pugi::xml_attribute attribute : node.attributes()) {
        if (begins_with(attribute.name(), "file")) files.push_back({node, attribute});
      }
    });
  }
  return files;
}

std::vector<std::string> files_named_by(const std::string& xml) {
  const pugi::xml_document document = parse(xml, "xml text", Root::kMujoco);
  std::vector<std::string> names;
  for (const auto& [node, attribute] : asset_files(document.document_element())) names.emplace_back(attribute.value());
  return names;
}

Span<const unsigned char> built_in_asset(const std::string& path) {
  const std::string prefix = "mimo/";
  if (path.rfind(prefix, 0) != 0) return {};
  return built_in_file(path.substr(prefix.size()));
}

void settle(pugi::xml_node root) {
  if (compiler_setting(root, "autolimits").empty()) set(section(root, "compiler"), "autolimits", "true");
  for (pugi::xml_node option : root.children("option")) option.remove_attribute("apirate");
}

Composition packed(const pugi::xml_document& document, const Limits& limits) {
  Composition composition;
  if (limits.files != nullptr) require_held(document.document_element(), *limits.files);
  composition.seconds = check(document.document_element(), limits).seconds();
  const pugi::xml_document changed = copy(document);
  settle(changed.document_element());
  composition.lines = take_lines(changed.document_element());
  std::vector<engine::Asset> pictures;  // decoded for textures only: of heights, MuJoCo knows no such form
  std::set<std::string> seen;
  for (const auto& [node, attribute] : asset_files(changed.document_element())) {
    const auto bytes = built_in_asset(attribute.value());
    if (bytes.empty() && is(node, "mesh")) hand_over_unmarked(node, limits, composition);
    if (bytes.empty() && limits.files != nullptr) hand_over(*limits.files, node, attribute, seen, composition);
    if (bytes.empty()) continue;
    // A user's own floor.png must not be taken for ours.
    const std::string name = flat_name(attribute.value());
    const bool is_texture = is(node, "texture");
    const std::string given = is_texture ? decoded_name(name) : name;
    set(node, attribute.name(), given);
    if (seen.insert(given).second) (is_texture ? pictures : composition.assets).push_back({name, bytes});
  }
  decode_pictures(pictures);
  composition.assets.insert(composition.assets.end(), pictures.begin(), pictures.end());
  composition.has_contacts = leave_out_contacts(changed.document_element());
  composition.xml = print(changed);
  return composition;
}

engine::ModelPtr compile(const Composition& composition, const LogSink& log) {
  constexpr double kWorthSaying = 1;
  if (composition.seconds > kWorthSaying) {
    log(LogLevel::kWarning,
        format(
            "compiling may take {:.3g} s, in which no other world of this process can be made; max_compile_ms of the "
            "scene limits that",
            composition.seconds));
  }
  try {
    engine::ModelPtr model = engine::compile(composition.xml, composition.assets, log);
    if (composition.has_contacts) engine::enable_contacts(*model);
    return model;
  } catch (const Error& error) {
    throw Error(error.status(), with_users_lines(error.message(), composition.xml, composition.lines));
  }
}

engine::ModelPtr compile_quietly(const pugi::xml_document& document, const Limits& limits) {
  pugi::xml_document unpainted = copy(document);
  drop_pictures(unpainted.document_element());
  return compile(packed(unpainted, limits), {});
}

void put_stateful_last(pugi::xml_node root) {
  const Defaults defaults(root);
  std::vector<pugi::xml_node> stateful;
  bool in_order = true;
  for (const pugi::xml_node section : root.children("actuator")) {
    for (const pugi::xml_node actuator : section.children()) {
      if (actuator.type() != pugi::node_element) continue;
      if (has_state(actuator, defaults)) {
        stateful.push_back(actuator);
      } else {
        in_order = in_order && stateful.empty();
      }
    }
  }
  if (in_order) return;
  const pugi::xml_node last = append(root, "actuator");
  for (pugi::xml_node actuator : stateful) {
    copy_into(last, actuator);
    actuator.parent().remove_child(actuator);
  }
}

void fit_user_numbers(pugi::xml_node root) {
  for (const UserNumbers& kind : kUserNumbers) {
    int most = -1;
    for (const pugi::xml_node size : root.children("size")) {
      if (size.attribute(kind.size)) most = std::max(most, size.attribute(kind.size).as_int(-1));
    }
    if (most < 0) continue;  // MuJoCo counts for itself
    const std::string fitting = std::to_string(std::max(most, longest(root, kind)));
    for (const pugi::xml_node size : root.children("size")) {
      if (size.attribute(kind.size)) set(size, kind.size, fitting);
    }
  }
}

}  // namespace mimo::document
