// The parts of a composite: what its document says of them, and what MuJoCo says by itself.
#pragma once

#include <array>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>

#include "document/composite.h"

namespace mimo::document {

// How soft constraints are: solref and solimp.
struct Softness {
  std::array<double, 2> reference;
  std::array<double, 5> impedance;
};

// Where in the document the parts are put that do not stand in bodies. MuJoCo makes those of composites first.
struct Sections {
  explicit Sections(pugi::xml_node root);
  pugi::xml_node contact, equality, tendon, asset;
};

using Place = std::array<double, 3>;

// Parts take nothing from the document's classes, so they name the main class, which is to be empty.
class CompositeParts {
 public:
  CompositeParts(const Composite& composite, const Sections& sections);

 protected:
  bool is_solid() const { return composite_.is({"box", "cylinder", "ellipsoid"}); }

  pugi::xml_node add(pugi::xml_node parent, const char* name) const;
  bool has(const char* name, const char* kind) const;
  pugi::xml_node add_body(pugi::xml_node parent, const std::string& name, const Place& place) const;
  pugi::xml_node add_geom(pugi::xml_node body, const std::string& name) const;
  void add_site(pugi::xml_node body, const std::string& name) const;
  pugi::xml_node add_joint(pugi::xml_node body, const char* kind, const std::string& name, const char* type,
                           const Place& place, const Place& axis) const;
  pugi::xml_node add_equality(const char* name, Softness softness) const;
  // Keeps a joint or tendon of a kind at where it starts.
  void add_fix(const char* element, const char* kind, const std::string& name, Softness softness) const;
  pugi::xml_node add_tendon(const char* type, const char* kind, const std::string& name,
                            std::initializer_list<const char*> others) const;
  // A tendon between two sites, kept at its length.
  void tie(const char* kind, const std::string& name, const std::string& one, const std::string& other) const;
  void tie_diagonals() const;
  // A joint beside the main ones that is held where it starts, if the composite asks for such.
  void add_held_joint(pugi::xml_node body, const char* kind, const std::string& name, const char* type,
                      const Place& place, const Place& axis) const;

  const Composite& composite_;
  const Sections& sections_;
  pugi::xml_node parent_;
  std::array<int, 3> count_;
  Softness smooth_{}, fix_{}, main_tendon_{};

 private:
  pugi::xml_node add_of_no_class(pugi::xml_node parent, const char* name) const;
  // What the composite says of its elements of a kind; "" where they have none.
  void describe(pugi::xml_node element, const char* name, const char* kind,
                std::initializer_list<const char*> others) const;

  const char* group_ = "0";
};

}  // namespace mimo::document
