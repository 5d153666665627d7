#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/format.h"
#include "document/composites.h"
#include "document/report.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

constexpr std::initializer_list<const char*> kTypes = {"particle", "grid", "rope",     "loop",
                                                       "cloth",    "box",  "cylinder", "ellipsoid"};
constexpr std::initializer_list<const char*> kAttributes = {"prefix", "type",        "count",        "spacing",
                                                            "offset", "flatinertia", "solrefsmooth", "solimpsmooth"};

bool holds(std::initializer_list<const char*> names, const std::string& name) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

// What came with versions between 2.2 and those that have no composites.
void require_known(pugi::xml_node node) {
  for (const pugi::xml_attribute attribute : node.attributes()) {
    if (is_note(attribute) || holds(kAttributes, attribute.name())) continue;
    refuse_unknown(node, format("the attribute {} of <composite> (\"{}\")", attribute.name(), attribute.value()));
  }
  const std::string type = node.attribute("type").value();
  if (!holds(kTypes, type)) refuse_unknown(node, format("<composite> of type \"{}\"", type));
}

constexpr Softness kUsual = {{.02, 1}, {.9, .95, .001, .5, 2}};  // MuJoCo's own
constexpr Softness kHard = {{.01, 1}, {.99, .99, .001, .5, 2}};
constexpr Softness kSoft = {{.02, 1}, {.9, .9, .001, .5, 2}};

}  // namespace

Composite::Composite(pugi::xml_node element)
    : node(element),
      prefix(element.attribute("prefix").value()),
      type(element.attribute("type").value()),
      skin(element.child("skin")) {
  require_known(node);
  std::array<double, 3> counts{1, 1, 1};
  read(node.attribute("count"), counts);
  read(node.attribute("spacing"), Span<double>(&spacing, 1));
  read(node.attribute("offset"), offset);
  if (!(spacing > 1e-14)) refuse(format("spacing is \"{}\", expected a length", node.attribute("spacing").value()));
  bool single = false;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const bool whole = counts[i] >= 1 && counts[i] <= 1e6 && counts[i] == std::floor(counts[i]);
    if (!whole || (single && counts[i] > 1)) {
      refuse(format("count is \"{}\", expected whole numbers from 1, with all ones at the end",
                    node.attribute("count").value()));
    }
    count[i] = static_cast<int>(counts[i]);
    single = count[i] == 1;
    dimensions += single ? 0 : 1;
  }
}

bool Composite::is(std::initializer_list<const char*> types) const { return holds(types, type); }

std::string Composite::named(const char* kind, std::initializer_list<int> numbers) const {
  return prefix + kind + join(numbers, "_");
}

void Composite::read(pugi::xml_attribute attribute, Span<double> values) const {
  const std::vector<double> given = numbers(attribute);
  if (given.size() > values.size()) {
    refuse(format("{} is \"{}\", expected at most {} numbers", attribute.name(), attribute.value(), values.size()));
  }
  std::copy(given.begin(), given.end(), values.begin());
}

void Composite::refuse(const std::string& what) const {
  fail(Status::kModel, "{}: composite of type \"{}\": {}", where(node), type, what);
}

Sections::Sections(pugi::xml_node root)
    : contact(prepend(root, "contact")),
      equality(prepend(root, "equality")),
      tendon(prepend(root, "tendon")),
      asset(append(root, "asset")) {}

CompositeParts::CompositeParts(const Composite& composite, const Sections& sections)
    : composite_(composite), sections_(sections), parent_(composite.node.parent()), count_(composite.count) {
  smooth_ = is_solid() ? kSoft : composite.is({"loop"}) ? kHard : kUsual;
  fix_ = is_solid() ? kSoft : kUsual;
  main_tendon_ = is_solid() || composite.is({"grid"}) ? kHard : kUsual;
  composite.read(composite.node.attribute("solrefsmooth"), smooth_.reference);
  composite.read(composite.node.attribute("solimpsmooth"), smooth_.impedance);
  const bool line = composite.is({"particle", "rope", "loop"}) || (composite.is({"grid"}) && composite.dimensions == 1);
  group_ = composite.skin.empty() || line ? "0" : "3";
}

pugi::xml_node CompositeParts::add(pugi::xml_node parent, const char* name) const {
  const pugi::xml_node made = parent == parent_ ? insert_before(composite_.node, name) : append(parent, name);
  for (const pugi::xml_attribute attribute : composite_.node.attributes()) {
    if (is_note(attribute)) set(made, attribute.name(), attribute.value());
  }
  return made;
}

pugi::xml_node CompositeParts::add_of_no_class(pugi::xml_node parent, const char* name) const {
  const pugi::xml_node made = add(parent, name);
  set(made, "class", "main");
  return made;
}

void CompositeParts::describe(pugi::xml_node element, const char* name, const char* kind,
                              std::initializer_list<const char*> others) const {
  for (const pugi::xml_node said : composite_.node.children(name)) {
    if (std::string(said.attribute("kind").value()) != kind) continue;
    for (const pugi::xml_attribute attribute : said.attributes()) {
      const bool other = std::any_of(others.begin(), others.end(),
                                     [&](const char* one) { return std::string(attribute.name()) == one; });
      if (!other && !is_note(attribute)) set(element, attribute.name(), attribute.value());
    }
  }
}

bool CompositeParts::has(const char* name, const char* kind) const {
  return !composite_.node.find_child_by_attribute(name, "kind", kind).empty();
}

pugi::xml_node CompositeParts::add_body(pugi::xml_node parent, const std::string& name, const Position& place) const {
  const pugi::xml_node body = add(parent, "body");
  if (!name.empty()) set(body, "name", name);
  set(body, "pos", Span<const double>(place));
  return body;
}

pugi::xml_node CompositeParts::add_geom(pugi::xml_node body, const std::string& name) const {
  const pugi::xml_node geom = add_of_no_class(body, "geom");
  if (!name.empty()) set(geom, "name", name);
  set(geom, "group", group_);
  if (is_solid()) set(geom, "contype", "0");
  if (composite_.is({"particle"})) {
    set(geom, "condim", "1");
    set(geom, "priority", "1");
  }
  describe(geom, "geom", "", {});
  const std::string type = geom.attribute("type").value();
  if (!type.empty() && type != "sphere" && type != "capsule" && type != "ellipsoid") {
    composite_.refuse(format("type of its geom is \"{}\", expected sphere, capsule or ellipsoid", type));
  }
  return geom;
}

void CompositeParts::add_site(pugi::xml_node body, const std::string& name) const {
  const pugi::xml_node site = add_of_no_class(body, "site");
  set(site, "name", name);
  set(site, "group", "3");
  describe(site, "site", "", {});
}

pugi::xml_node CompositeParts::add_joint(pugi::xml_node body, const char* kind, const std::string& name,
                                         const char* type, const Position& place, const Position& axis) const {
  const pugi::xml_node joint = add_of_no_class(body, "joint");
  if (!name.empty()) set(joint, "name", name);
  set(joint, "type", type);
  set(joint, "pos", Span<const double>(place));
  set(joint, "axis", Span<const double>(axis));
  set(joint, "group", "3");
  // MuJoCo looks for "limited" elsewhere, and finds nothing.
  describe(joint, "joint", kind, {"kind", "solreffix", "solimpfix", "limited"});
  return joint;
}

pugi::xml_node CompositeParts::add_equality(const char* name, Softness softness) const {
  const pugi::xml_node equality = add_of_no_class(sections_.equality, name);
  set(equality, "solref", Span<const double>(softness.reference));
  set(equality, "solimp", Span<const double>(softness.impedance));
  return equality;
}

void CompositeParts::add_fix(const char* element, const char* kind, const std::string& name, Softness softness) const {
  for (const pugi::xml_node said : composite_.node.children(element)) {
    if (std::string(said.attribute("kind").value()) != kind) continue;
    composite_.read(said.attribute("solreffix"), softness.reference);
    composite_.read(said.attribute("solimpfix"), softness.impedance);
  }
  set(add_equality(element, softness), (std::string(element) + "1").c_str(), name);
}

pugi::xml_node CompositeParts::add_tendon(const char* type, const char* kind, const std::string& name,
                                          std::initializer_list<const char*> others) const {
  const pugi::xml_node tendon = add_of_no_class(sections_.tendon, type);
  set(tendon, "name", name);
  set(tendon, "group", group_);
  describe(tendon, "tendon", kind, others);
  return tendon;
}

void CompositeParts::tie(const char* kind, const std::string& name, const std::string& one,
                         const std::string& other) const {
  const pugi::xml_node tendon = add_tendon("spatial", kind, name, {"kind", "solreffix", "solimpfix", "limited"});
  for (const std::string& site : {one, other}) set(append(tendon, "site"), "site", site);
  add_fix("tendon", kind, name, std::string(kind) == "main" ? main_tendon_ : fix_);
}

void CompositeParts::tie_diagonals() const {
  if (!has("tendon", "shear")) return;
  for (int x = 0; x + 1 < count_[0]; ++x) {
    for (int y = 0; y + 1 < count_[1]; ++y) {
      tie("shear", composite_.named("TS", {x, y}), composite_.named("S", {x, y}),
          composite_.named("S", {x + 1, y + 1}));
    }
  }
}

void CompositeParts::add_held_joint(pugi::xml_node body, const char* kind, const std::string& name, const char* type,
                                    const Position& place, const Position& axis) const {
  if (!has("joint", kind)) return;
  add_joint(body, kind, name, type, place, axis);
  add_fix("joint", kind, name, fix_);
}

}  // namespace mimo::document
