#include "document/names.h"

#include <algorithm>
#include <set>

#include "base/fail.h"
#include "base/format.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

// Attributes that name a model element in these sections, or refer to one.
constexpr const char* kSections[] = {"worldbody", "contact", "equality", "tendon", "actuator", "sensor", "custom"};
constexpr const char* kReferences[] = {"name",     "body",          "body1",      "body2",   "joint",  "joint1",
                                       "joint2",   "jointinparent", "geom",       "geom1",   "geom2",  "site",
                                       "sidesite", "cranksite",     "slidersite", "tendon",  "target", "objname",
                                       "camera",   "refsite",       "refname",    "actuator"};
// Those that name default classes and assets, wherever they stand; elements of a composite are named by its prefix.
constexpr const char* kShared[] = {"class", "childclass", "material", "mesh", "hfield", "texture", "prefix"};

void prefix_attribute(pugi::xml_node node, const char* name, const std::string& prefix) {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (attribute.empty()) return;
  const std::string value = attribute.value();
  const bool the_world = value == "world" && std::string(name) != "name";  // there is only one
  if (!the_world) set(node, name, prefix + value);
}

// Names of the same kind must differ.
std::string kind_of(pugi::xml_node node) {
  const std::string section = node.parent().name(), name = node.name();
  for (const char* all : {"equality", "tendon", "actuator", "sensor"}) {
    if (section == all) return section;
  }
  return name == "freejoint" ? "joint" : name;
}

template <typename Visit>
void visit_named(pugi::xml_node root, Visit&& visit) {
  for (const char* section : kSections) {
    for (const pugi::xml_node top : root.children(section)) {
      walk(top, [&](pugi::xml_node node) {
        if (node.attribute("name")) visit(kind_of(node) + " \"" + node.attribute("name").value() + "\"");
      });
    }
  }
}

// Not isalnum, whose letters depend on the host's locale.
bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

}  // namespace

void require_plain(const std::string& name) {
  require(std::all_of(name.begin(), name.end(), is_plain), "name is \"{}\", expected letters, digits, '_', '-' and '.'",
          name);
}

std::string stem_of(const std::string& path) {
  const std::string file = path.substr(path.find_last_of("/\\") + 1);
  return file.substr(0, file.find_last_of('.'));
}

void prefix_names(pugi::xml_node root, const std::string& prefix) {
  if (prefix.empty()) return;
  for (const char* section : kSections) {
    for (const pugi::xml_node top : root.children(section)) {
      walk(top, [&](pugi::xml_node node) {
        for (const char* name : kReferences) prefix_attribute(node, name, prefix);
      });
    }
  }
}

void prefix_all_names(pugi::xml_node root, const std::string& prefix) {
  prefix_names(root, prefix);
  for (const pugi::xml_node assets : root.children("asset")) {
    for (const pugi::xml_node asset : assets.children()) name_after_file(asset);
    walk(assets, [&](pugi::xml_node node) {
      for (const char* name : {"name", "body"}) prefix_attribute(node, name, prefix);  // bones of a skin are bodies
    });
  }
  walk(root, [&](pugi::xml_node node) {
    if (is(node, "composite") && !node.attribute("prefix")) set(node, "prefix", "");
    for (const char* name : kShared) prefix_attribute(node, name, prefix);
  });
}

void name_after_file(pugi::xml_node asset) {
  if (asset.attribute("name") || !asset.attribute("file")) return;
  set(asset, "name", stem_of(asset.attribute("file").value()));
}

pugi::xml_node find_named(pugi::xml_node root, const char* element, const std::string& name) {
  return root.find_node([&](pugi::xml_node node) {
    return std::string(node.name()) == element && name == node.attribute("name").value();
  });
}

std::vector<std::string> names_of(pugi::xml_node root, std::initializer_list<const char*> elements) {
  std::vector<std::string> names;
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      if (is_one_of(node, elements) && node.attribute("name")) names.emplace_back(node.attribute("name").value());
    });
  }
  return names;
}

std::string shared_name(pugi::xml_node one, pugi::xml_node other) {
  std::set<std::string> names;
  visit_named(other, [&](const std::string& name) { names.insert(name); });
  std::string found;
  visit_named(one, [&](const std::string& name) {
    if (found.empty() && names.count(name) > 0) found = name;
  });
  return found;
}

bool has_names_with(pugi::xml_node root, const std::string& prefix) {
  return !root.find_node([&](pugi::xml_node node) {
                for (const char* name : {"name", "class"}) {
                  if (begins_with(node.attribute(name).value(), prefix)) return true;
                }
                return false;
              })
              .empty();
}

void prefix_classes(pugi::xml_node root, const std::string& prefix) {
  if (prefix.empty()) return;
  walk(root, [&](pugi::xml_node node) {
    for (const char* name : {"class", "childclass"}) {
      const pugi::xml_attribute attribute = node.attribute(name);
      if (!attribute.empty()) set(node, name, prefix + attribute.value());
    }
  });
}

}  // namespace mimo::document
