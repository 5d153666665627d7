#include "document/defaults.h"

#include <algorithm>
#include <array>

#include "document/xml.h"

namespace mimo::document {
namespace {

// Whether an element of a class speaks for an element of the model. Tendons and equalities have one kind of defaults
// for all; all kinds of actuators write into the same.
bool speaks_for(pugi::xml_node setting, pugi::xml_node element) {
  const pugi::xml_node section = element.parent();
  if (is(section, "tendon")) return is(setting, "tendon");
  if (is(section, "equality")) return is(setting, "equality");
  if (!is(section, "actuator")) return is(setting, element.name());
  return is_one_of(
      setting, {"general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion"});
}

std::string main_class(pugi::xml_node root) {
  for (const pugi::xml_node top : root.children("default")) {
    if (top.attribute("class")) return top.attribute("class").value();
  }
  return "main";
}

// Sections whose elements have a class.
constexpr std::array<const char*, 4> kWithClass = {"contact", "equality", "tendon", "actuator"};

void name_class(pugi::xml_node element, const char* attribute, const std::string& name) {
  if (element.attribute(attribute).empty()) set(element, attribute, name);
}

void name_class_outside_bodies(pugi::xml_node root, const std::string& name) {
  for (const pugi::xml_node world : root.children("worldbody")) {
    for (const pugi::xml_node child : world.children()) {
      if (is(child, "body")) name_class(child, "childclass", name);
      if (is_one_of(child, {"geom", "site", "camera", "light"})) name_class(child, "class", name);
    }
  }
  for (const pugi::xml_node assets : root.children("asset")) {
    for (const pugi::xml_node asset : assets.children()) {
      if (is_one_of(asset, {"material", "mesh"})) name_class(asset, "class", name);
    }
  }
  for (const char* section : kWithClass) {
    for (const pugi::xml_node part : root.children(section)) {
      for (const pugi::xml_node element : part.children()) {
        if (element.type() == pugi::node_element && !is(element, "exclude")) name_class(element, "class", name);
      }
    }
  }
}

}  // namespace

Defaults::Defaults(pugi::xml_node root) : main_(main_class(root)) {
  for (const pugi::xml_node top : root.children("default")) read(top, main_, "");
}

void Defaults::read(pugi::xml_node node, const std::string& name, const std::string& parent) {
  if (name.empty()) return;  // an error that the compiler will tell of
  Class& entry =
      classes_.emplace(name, Class{parent, {}}).first->second;  // the first counts: no class is its own parent
  entry.nodes.push_back(node);
  for (const pugi::xml_node nested : node.children("default")) read(nested, nested.attribute("class").value(), name);
}

std::string Defaults::class_of(pugi::xml_node element) const {
  if (element.attribute("class")) return element.attribute("class").value();
  for (pugi::xml_node around = element.parent(); around; around = around.parent()) {
    if (around.attribute("childclass")) return around.attribute("childclass").value();
  }
  return main_;
}

std::vector<pugi::xml_node> Defaults::settings(pugi::xml_node element) const {
  std::vector<pugi::xml_node> found;
  for (auto it = classes_.find(class_of(element)); it != classes_.end(); it = classes_.find(it->second.parent)) {
    const std::size_t outer = found.size();
    for (const pugi::xml_node node : it->second.nodes) {
      for (const pugi::xml_node setting : node.children()) {
        if (speaks_for(setting, element)) found.push_back(setting);
      }
    }
    std::reverse(found.begin() + static_cast<std::ptrdiff_t>(outer), found.end());
  }
  return found;
}

bool has_main_defaults(pugi::xml_node root) {
  for (const pugi::xml_node top : root.children("default")) {
    for (const pugi::xml_node child : top.children()) {
      if (child.type() == pugi::node_element && !is(child, "default")) return true;
    }
  }
  return false;
}

namespace {

// A class says something of each element once; what several sections of the main class say adds up, the last one
// counts.
void add_to_class(pugi::xml_node to, pugi::xml_node child) {
  pugi::xml_node there = is(child, "default") ? pugi::xml_node() : to.child(child.name());
  if (!there) return copy_into(to, child);
  for (const pugi::xml_attribute attribute : child.attributes()) set(there, attribute.name(), attribute.value());
}

}  // namespace

void name_main_defaults(pugi::xml_node root, const std::string& name) {
  const std::string old_name = main_class(root);
  pugi::xml_node top = append(root, "default");
  pugi::xml_node renamed = append(top, "default");
  set(renamed, "class", name);
  for (pugi::xml_node other = root.child("default"); other != top; other = root.child("default")) {
    for (const pugi::xml_node child : other.children()) add_to_class(renamed, child);
    root.remove_child(other);
  }
  walk(root, [&](pugi::xml_node node) {
    for (const char* attribute : {"class", "childclass"}) {
      if (node.attribute(attribute) && old_name == node.attribute(attribute).value()) set(node, attribute, name);
    }
  });
  name_class_outside_bodies(root, name);
}

}  // namespace mimo::document
