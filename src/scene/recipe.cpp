#include "scene/recipe.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"
#include "document/loader.h"
#include "document/names.h"
#include "document/xml.h"
#include "scene/groups.h"

namespace mimo::scene {
namespace {

pugi::xml_node find_named(pugi::xml_node root, const char* section, const char* element, const std::string& name) {
  for (const pugi::xml_node part : root.children(section)) {
    const pugi::xml_node found = part.find_child_by_attribute(element, "name", name.c_str());
    if (!found.empty()) return found;
  }
  return {};
}

// "body hip", "joint robot:left_elbow", ...: what a recipe may refer to.
std::set<std::string> parts_of(pugi::xml_node root) {
  std::set<std::string> parts;
  for (const pugi::xml_node world : root.children("worldbody")) {
    document::walk(world, [&](pugi::xml_node node) {
      parts.insert(std::string(node.name()) + " " + node.attribute("name").value());
    });
  }
  return parts;
}

// Whether a constraint or an entry of a tuple refers to what is not there.
bool is_about_missing(pugi::xml_node element, const std::set<std::string>& parts) {
  const auto missing = [&](const std::string& kind, const char* attribute) {
    const std::string name = element.attribute(attribute).value();
    return !name.empty() && parts.count(kind + " " + name) == 0;
  };
  const std::string objects = element.attribute("objtype").value();
  return missing("body", "body1") || missing("body", "body2") || missing("joint", "joint1") ||
         missing("joint", "joint2") || missing(objects, "objname");
}

void drop_missing(pugi::xml_node own, const std::set<std::string>& parts) {
  for (const char* name : {"equality", "custom"}) {
    for (const pugi::xml_node section : own.children(name)) {
      std::vector<pugi::xml_node> missing;
      document::walk(section, [&](pugi::xml_node node) {
        if (is_about_missing(node, parts)) missing.push_back(node);
      });
      for (pugi::xml_node node : missing) node.parent().remove_child(node);
    }
  }
}

// An element of a name that the section has already gives its attributes to that one: so a recipe switches locks on.
// Which joint a lock holds, only the infant says; a lock of a recipe that finds none is for another body.
void merge(pugi::xml_node root, pugi::xml_node part) {
  pugi::xml_node added = document::append(root, part.name());
  for (const pugi::xml_node element : part.children()) {
    if (element.type() != pugi::node_element) continue;
    const std::string name = element.attribute("name").value();
    const pugi::xml_node there = name.empty() ? pugi::xml_node() : find_named(root, part.name(), element.name(), name);
    const bool switches = document::is(element, "joint") && element.attribute("joint1").empty();
    if (there.empty()) {
      if (!switches) document::copy_into(added, element);
      continue;
    }
    for (const pugi::xml_attribute attribute : element.attributes())
      document::set(there, attribute.name(), attribute.value());
  }
  if (added.first_child().empty()) root.remove_child(added);
}

// The original calls the root's free joint differently in each scene, and scripts find it by that name.
void name_root_joint(pugi::xml_node root, const std::string& prefix, const std::string& name) {
  pugi::xml_node joint = find_named(root, "worldbody", "body", prefix + names::kRootBody).child("freejoint");
  if (name == "none") {
    joint.remove_attribute("name");
  } else if (!name.empty()) {
    document::set(joint, "name", prefix + name);
  }
}

}  // namespace

std::string custom_text(pugi::xml_node root, const std::string& name) {
  return find_named(root, "custom", "text", name).attribute("data").value();
}

std::vector<std::string> custom_words(pugi::xml_node root, const std::string& name) {
  std::istringstream words(custom_text(root, name));
  return {std::istream_iterator<std::string>(words), {}};
}

Recipe Recipe::of_room(pugi::xml_node room, const document::Library& library) {
  Recipe recipe;
  const std::string path = custom_text(room, names::kInfant);
  if (!path.empty()) recipe.document_ = document::Loader(library).built_in(path);
  return recipe;
}

unsigned Recipe::acts() const {
  const std::string words = custom_text(document_.document_element(), names::kActs);
  return words.empty() ? static_cast<unsigned>(kAllGroups) : groups_from(words);
}

Senses Recipe::senses() const {
  const std::vector<std::string> words = custom_words(document_.document_element(), names::kSenses);
  if (words.empty()) return {};
  const auto has = [&](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); };
  return {has("proprioception"), has("vestibular"), has("vision"), has("touch")};
}

std::vector<std::string> Recipe::still() const { return custom_words(document_.document_element(), names::kStill); }

bool Recipe::muscles() const { return custom_text(document_.document_element(), names::kActuation) == "muscle"; }

std::vector<std::string> Recipe::bodies() const { return custom_words(document_.document_element(), names::kBodies); }

void Recipe::apply(pugi::xml_node root, const std::string& prefix, bool keep_root) {
  const pugi::xml_node own = document_.document_element();
  name_root_joint(root, prefix, custom_text(own, names::kRootJoint));
  if (keep_root) {
    pugi::xml_node pose = find_named(own, "custom", "numeric", names::kRootPose);
    if (!pose.empty()) pose.parent().remove_child(pose);
  }
  document::prefix_names(own, prefix);
  drop_missing(own, parts_of(root));
  for (const pugi::xml_node part : own.children()) {
    if (part.type() == pugi::node_element) merge(root, part);
  }
}

void keep_motors(pugi::xml_node root, const std::string& prefix, unsigned groups,
                 const std::vector<std::string>& still) {
  const auto rests = [&](const std::string& name) {
    return std::any_of(still.begin(), still.end(), [&](const std::string& start) {
      const std::string resting = prefix + names::kMotor + start;
      return begins_with(name, resting);
    });
  };
  for (pugi::xml_node section : root.children("actuator")) {
    for (pugi::xml_node motor = section.first_child(); motor;) {
      const pugi::xml_node next = motor.next_sibling();
      const std::string name = motor.attribute("name").value();
      if (begins_with(name, prefix)) {
        const unsigned group = group_of(name.substr(prefix.size()));
        if (rests(name) || (group != 0 && (group & groups) == 0)) section.remove_child(motor);
      }
      motor = next;
    }
  }
}

}  // namespace mimo::scene
