#include "scene/composition.h"

#include <algorithm>
#include <set>

#include "scene/library.h"
#include "scene/xml.h"

namespace mimo::scene {

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

Composition packed(const pugi::xml_document& document) {
  Composition composition;
  const pugi::xml_document changed = copy(document);
  std::set<std::string> seen;
  for (const auto& [node, attribute] : asset_files(changed.document_element())) {
    const auto bytes = built_in_asset(attribute.value());
    if (bytes.empty()) continue;
    // MuJoCo tells files in memory apart by their last part only: a user's own floor.png must not be taken for ours.
    std::string name = attribute.value();
    std::replace(name.begin(), name.end(), '/', ':');
    set(node, attribute.name(), name);
    if (seen.insert(name).second) composition.assets.push_back({name, bytes});
  }
  composition.xml = print(changed);
  return composition;
}

engine::ModelPtr compile_quietly(const pugi::xml_document& document) {
  const Composition composition = packed(document);
  return engine::compile(composition.xml, composition.assets, {});
}

}  // namespace mimo::scene
