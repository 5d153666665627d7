#include "scene/recipe.h"

#include <cstring>

#include "base/fail.h"
#include "scene/groups.h"
#include "scene/loader.h"
#include "scene/names.h"
#include "scene/xml.h"

namespace mimo::scene {
namespace {

constexpr const char* kRecipe = "mimo:infant";
constexpr const char* kActs = "mimo:acts";
constexpr const char* kSenses = "mimo:senses";
constexpr const char* kRootJoint = "mimo:root_joint";
constexpr const char* kRootPose = "mimo:root";
constexpr const char* kRootBody = "mimo_location";

pugi::xml_node find_named(pugi::xml_node root, const char* section, const char* element, const std::string& name) {
  for (const pugi::xml_node part : root.children(section)) {
    const pugi::xml_node found = part.find_child_by_attribute(element, "name", name.c_str());
    if (!found.empty()) return found;
  }
  return {};
}

// An element of a name that the section has already gives its attributes to that one: so a recipe switches locks on.
void merge(pugi::xml_node root, pugi::xml_node part) {
  pugi::xml_node added = append(root, part.name());
  for (const pugi::xml_node element : part.children()) {
    if (element.type() != pugi::node_element) continue;
    const std::string name = element.attribute("name").value();
    const pugi::xml_node there = name.empty() ? pugi::xml_node() : find_named(root, part.name(), element.name(), name);
    if (there.empty()) {
      copy_into(added, element);
      continue;
    }
    for (const pugi::xml_attribute attribute : element.attributes()) set(there, attribute.name(), attribute.value());
  }
  if (added.first_child().empty()) root.remove_child(added);
}

// The original calls the root's free joint differently in each scene, and scripts find it by that name.
void name_root_joint(pugi::xml_node root, const std::string& prefix, const std::string& name) {
  pugi::xml_node joint = find_named(root, "worldbody", "body", prefix + kRootBody).child("freejoint");
  if (name == "none") {
    joint.remove_attribute("name");
  } else if (!name.empty()) {
    set(joint, "name", prefix + name);
  }
}

}  // namespace

std::string custom_text(pugi::xml_node root, const std::string& name) {
  return find_named(root, "custom", "text", name).attribute("data").value();
}

Recipe Recipe::of_room(pugi::xml_node room, const Library& library) {
  Recipe recipe;
  const std::string path = custom_text(room, kRecipe);
  if (!path.empty()) recipe.document_ = Loader(library).built_in(path);
  return recipe;
}

unsigned Recipe::acts() const {
  const std::string words = custom_text(document_.document_element(), kActs);
  return words.empty() ? static_cast<unsigned>(kAllGroups) : groups_from(words);
}

std::string Recipe::senses() const { return custom_text(document_.document_element(), kSenses); }

void Recipe::apply(pugi::xml_node root, const std::string& prefix, bool keep_root) {
  const pugi::xml_node own = document_.document_element();
  name_root_joint(root, prefix, custom_text(own, kRootJoint));
  if (keep_root) {
    pugi::xml_node pose = find_named(own, "custom", "numeric", kRootPose);
    if (!pose.empty()) pose.parent().remove_child(pose);
  }
  prefix_names(own, prefix);
  for (const pugi::xml_node part : own.children()) {
    if (part.type() == pugi::node_element) merge(root, part);
  }
}

void keep_motors(pugi::xml_node root, const std::string& prefix, unsigned groups) {
  for (pugi::xml_node section : root.children("actuator")) {
    for (pugi::xml_node motor = section.first_child(); motor;) {
      const pugi::xml_node next = motor.next_sibling();
      const std::string name = motor.attribute("name").value();
      if (name.compare(0, prefix.size(), prefix) == 0) {
        const unsigned group = group_of(name.substr(prefix.size()));
        if (group != 0 && (group & groups) == 0) section.remove_child(motor);
      }
      motor = next;
    }
  }
}

}  // namespace mimo::scene
