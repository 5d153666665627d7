#include "scene/composition.h"

#include <algorithm>
#include <set>

#include "base/status.h"
#include "scene/check.h"
#include "scene/compiler.h"
#include "scene/library.h"
#include "scene/lines.h"
#include "scene/pictures.h"
#include "scene/xml.h"

namespace mimo::scene {
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

}  // namespace

std::vector<AssetFile> asset_files(pugi::xml_node root) {
  std::vector<AssetFile> files;
  for (const pugi::xml_node assets : root.children("asset")) {
    walk(assets, [&](pugi::xml_node node) {
      for (const pugi::xml_attribute attribute : node.attributes()) {
        if (std::string(attribute.name()).rfind("file", 0) == 0) files.push_back({node, attribute});
      }
    });
  }
  return files;
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
  check(document.document_element(), limits);
  Composition composition;
  const pugi::xml_document changed = copy(document);
  settle(changed.document_element());
  composition.lines = take_lines(changed.document_element());
  std::vector<engine::Asset> pictures;  // decoded for textures only: of heights, MuJoCo knows no such form
  std::set<std::string> seen;
  for (const auto& [node, attribute] : asset_files(changed.document_element())) {
    const auto bytes = built_in_asset(attribute.value());
    if (bytes.empty()) continue;
    // MuJoCo tells files in memory apart by their last part only: a user's own floor.png must not be taken for ours.
    std::string name = attribute.value();
    std::replace(name.begin(), name.end(), '/', ':');
    const bool is_texture = is(node, "texture");
    const std::string given = is_texture ? decoded_name(name) : name;
    set(node, attribute.name(), given);
    if (seen.insert(given).second) (is_texture ? pictures : composition.assets).push_back({name, bytes});
  }
  decode_pictures(pictures);
  composition.assets.insert(composition.assets.end(), pictures.begin(), pictures.end());
  composition.xml = print(changed);
  return composition;
}

engine::ModelPtr compile(const Composition& composition, const LogSink& log) {
  try {
    return engine::compile(composition.xml, composition.assets, log);
  } catch (const Error& error) {
    throw Error(error.status(), with_users_lines(error.message(), composition.xml, composition.lines));
  }
}

engine::ModelPtr compile_quietly(const pugi::xml_document& document, const Limits& limits) {
  pugi::xml_document unpainted = copy(document);
  drop_pictures(unpainted.document_element());
  return compile(packed(unpainted, limits), {});
}

}  // namespace mimo::scene
