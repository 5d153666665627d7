// The default classes of a document.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace mimo::scene {

// Finds out what elements get from their classes.
class Defaults {
 public:
  explicit Defaults(pugi::xml_node root);

  // The element that gives a joint, tendon, actuator, ... an attribute: itself, or else that of its class or of the
  // classes around that. Empty where none of them says.
  pugi::xml_node giver(pugi::xml_node element, const char* attribute) const;
  // The attribute as the compiler will take it.
  pugi::xml_attribute find(pugi::xml_node element, const char* attribute) const {
    return giver(element, attribute).attribute(attribute);
  }

 private:
  struct Class {
    std::string parent;
    std::vector<pugi::xml_node> nodes;  // main may be spread over several sections
  };

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

}  // namespace mimo::scene
