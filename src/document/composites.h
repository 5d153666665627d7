// Composites: ropes, loops, grids, cloth, particles and soft boxes of MJCF, which MuJoCo knew until version 3.
#pragma once

#include <array>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/span.h"
#include "document/budget.h"
#include "document/report.h"

namespace mimo::document {

// One composite as a document describes it.

struct Composite {
  // Throws Status::kModel for what MuJoCo 2.2 refuses whatever the type is.
  explicit Composite(pugi::xml_node element);

  bool is(std::initializer_list<const char*> types) const;
  // "ropeB3", "clothJ0_2_4": what MuJoCo calls its elements.
  std::string named(const char* kind, std::initializer_list<int> numbers) const;
  // Numbers of an attribute, in place of the first of those that are there.
  void read(pugi::xml_attribute attribute, Span<double> values) const;
  [[noreturn]] void refuse(const std::string& what) const;

  pugi::xml_node node;
  std::string prefix, type;
  std::array<int, 3> count{1, 1, 1};
  int dimensions = 0;
  double spacing = 0;
  std::array<double, 3> offset{};
  pugi::xml_node skin;  // empty where it has none
};

// The parts of a composite: attributes from its document, and MuJoCo's defaults.

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

using Position = std::array<double, 3>;

// Parts take nothing from the document's classes, so they name the main class, which is to be empty.
class CompositeParts {
 public:
  CompositeParts(const Composite& composite, const Sections& sections);

 protected:
  bool is_solid() const { return composite_.is({"box", "cylinder", "ellipsoid"}); }

  pugi::xml_node add(pugi::xml_node parent, const char* name) const;
  bool has(const char* name, const char* kind) const;
  pugi::xml_node add_body(pugi::xml_node parent, const std::string& name, const Position& place) const;
  pugi::xml_node add_geom(pugi::xml_node body, const std::string& name) const;
  void add_site(pugi::xml_node body, const std::string& name) const;
  pugi::xml_node add_joint(pugi::xml_node body, const char* kind, const std::string& name, const char* type,
                           const Position& place, const Position& axis) const;
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
                      const Position& place, const Position& axis) const;

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

// Skins of composites.

// Both do nothing for a composite without a skin: over a grid or cloth, and over a box, cylinder or ellipsoid.
void add_sheet_skin(const Composite& composite, pugi::xml_node assets);
void add_solid_skin(const Composite& composite, pugi::xml_node assets);

// Puts in place of each composite the bodies, joints, geoms, sites, tendons, constraints and the skin that MuJoCo 2.2
// makes of it, and reports it. Throws Status::kModel for a composite that MuJoCo 2.2 would refuse, and for documents
// with composites that do not keep within the limits.
void expand_composites(pugi::xml_node root, const Limits& limits, Report& report);

}  // namespace mimo::document
