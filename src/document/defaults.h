// The default classes of a document.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace mimo::document {

// Finds out what elements get from their classes.
class Defaults {
 public:
  explicit Defaults(pugi::xml_node root);

  // The element that gives a joint, tendon, actuator, ... something: itself, or else that of its class or of the
  // classes around that. Empty where none of them does.
  template <typename Gives>
  pugi::xml_node first(pugi::xml_node element, Gives&& gives) const {
    if (gives(element)) return element;
    for (const pugi::xml_node setting : settings(element)) {
      if (gives(setting)) return setting;
    }
    return {};
  }
  // The one that gives it an attribute.
  pugi::xml_node giver(pugi::xml_node element, const char* attribute) const {
    return first(element, [&](pugi::xml_node node) { return !node.attribute(attribute).empty(); });
  }
  // The attribute as the compiler will take it.
  pugi::xml_attribute find(pugi::xml_node element, const char* attribute) const {
    return giver(element, attribute).attribute(attribute);
  }

 private:
  struct Class {
    std::string parent;
    std::vector<pugi::xml_node> nodes;  // main may be spread over several sections
  };

  // What speaks for an element, from its own class outwards; of one class the last comes first.
  std::vector<pugi::xml_node> settings(pugi::xml_node element) const;
  void read(pugi::xml_node node, const std::string& name, const std::string& parent);
  std::string class_of(pugi::xml_node element) const;

  std::string main_ = "main";
  std::map<std::string, Class> classes_;
};

// Whether the main class, from which all elements and classes get something, says anything at all.
bool has_main_defaults(pugi::xml_node root);

// Turns the main class into one of that name, and has everything that it counted for name it: for the document all
// stays as it was, while what is put beside it gets nothing from it.
void name_main_defaults(pugi::xml_node root, const std::string& name);

}  // namespace mimo::document
