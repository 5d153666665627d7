#include "document/composites.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/format.h"
#include "base/functions.h"
#include "base/names.h"
#include "base/numbers.h"
#include "document/check.h"
#include "document/defaults.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

class Maker : CompositeParts {
 public:
  using CompositeParts::CompositeParts;

  void make() const {
    if (is_solid()) return make_solid();
    if (composite_.is({"particle"})) return make_particles();
    if (composite_.is({"grid"})) return make_grid();
    composite_.is({"cloth"}) ? make_cloth() : make_rope();
  }

 private:
  Position in_grid(int x, int y, int z) const {
    const std::array<int, 3> at{x, y, z};
    Position place = composite_.offset;
    for (std::size_t i = 0; i < 3; ++i) place[i] += composite_.spacing * (at[i] - 0.5 * count_[i]);
    return place;
  }

  void add_slides(pugi::xml_node body, const std::vector<std::string>& names) const {
    for (std::size_t i = 0; i < 3; ++i) {
      Position axis{};
      axis[i] = 1;
      add_joint(body, "main", names.empty() ? "" : names[i], "slide", {}, axis);
    }
  }

  void make_particles() const {
    for (int x = 0; x < count_[0]; ++x) {
      for (int y = 0; y < count_[1]; ++y) {
        for (int z = 0; z < count_[2]; ++z) {
          const pugi::xml_node body = add_body(parent_, "", in_grid(x, y, z));
          add_slides(body, {});
          set(add_geom(body, ""), "type", "sphere");
        }
      }
    }
  }

  bool is_pinned(int x, int y) const {
    for (const pugi::xml_node pin : composite_.node.children("pin")) {
      std::array<double, 2> at{};
      composite_.read(pin.attribute("coord"), at);
      if (at[0] == x && at[1] == y) return true;
    }
    return false;
  }

  void make_grid() const {
    if (composite_.dimensions > 2) composite_.refuse("it has three dimensions, expected one or two");
    if (composite_.dimensions != 2 && (has("tendon", "shear") || !composite_.skin.empty())) {
      composite_.refuse("shear and skin need two dimensions");
    }
    for (int x = 0; x < count_[0]; ++x) {
      for (int y = 0; y < count_[1]; ++y) {
        Position place = in_grid(x, y, 0);
        place[2] = composite_.offset[2];
        const pugi::xml_node body = add_body(parent_, composite_.named("B", {x, y}), place);
        set(add_geom(body, composite_.named("G", {x, y})), "type", "sphere");
        add_site(body, composite_.named("S", {x, y}));
        if (is_pinned(x, y)) continue;
        add_slides(body, {composite_.named("J", {0, x, y}), composite_.named("J", {1, x, y}),
                          composite_.named("J", {2, x, y})});
      }
    }
    for (const int i : {0, 1}) {
      const int right = i == 0 ? 1 : 0, up = 1 - right;
      for (int x = 0; x + right < count_[0]; ++x) {
        for (int y = 0; y + up < count_[1]; ++y) {
          tie("main", composite_.named("T", {i, x, y}), composite_.named("S", {x, y}),
              composite_.named("S", {x + right, y + up}));
        }
      }
    }
    tie_diagonals();
    add_sheet_skin(composite_, sections_.asset);
  }

  // The place in the composite that the name of the body around it says: "B3", "B3_1".
  std::array<int, 2> origin(int dimensions) const {
    const std::string begin = composite_.prefix + "B", name = parent_.attribute("name").value();
    for (int x = 0; x < count_[0]; ++x) {
      for (int y = 0; y < count_[1]; ++y) {
        if (name == (dimensions == 1 ? composite_.named("B", {x}) : composite_.named("B", {x, y}))) return {x, y};
      }
    }
    composite_.refuse(format("the body around it is \"{}\", expected \"{}\" and {} from 0 and below count", name, begin,
                             dimensions == 1 ? "a number" : "X_Y, numbers"));
  }

  void make_rope() const {
    if (composite_.dimensions != 1) composite_.refuse("expected one dimension");
    const int first = origin(1)[0];
    add_link_geom(parent_, first);
    for (const int step : {1, -1}) {
      pugi::xml_node body = parent_;
      for (int x = first + step; x >= 0 && x < count_[0]; x += step) body = add_link(body, x, step);
    }
    if (composite_.is({"loop"})) close_loop();
  }

  void add_link_geom(pugi::xml_node body, int x) const {
    const std::array<double, 4> along_x{std::sqrt(0.5), 0, std::sqrt(0.5), 0};
    const pugi::xml_node geom = add_geom(body, composite_.named("G", {x}));
    set(geom, "quat", Span<const double>(along_x));
  }

  pugi::xml_node add_link(pugi::xml_node parent, int x, int step) const {
    const double dx = step * composite_.spacing;
    const pugi::xml_node body = add_body(parent, composite_.named("B", {x}), {dx, 0, 0});
    if (composite_.is({"loop"})) bend(body, step);
    add_link_geom(body, x);
    const Position middle{-0.5 * dx, 0, 0};
    add_joint(body, "main", composite_.named("J", {0, x}), "hinge", middle, {0, 1, 0});
    add_joint(body, "main", composite_.named("J", {1, x}), "hinge", middle, {0, 0, 1});
    add_held_joint(body, "twist", composite_.named("JT", {x}), "hinge", middle, {1, 0, 0});
    add_held_joint(body, "stretch", composite_.named("JS", {x}), "slide", middle, {1, 0, 0});
    return body;
  }

  // Links of a loop start as a regular polygon.
  void bend(pugi::xml_node body, int step) const {
    const double angle = 2 * kPi / count_[0];
    const double length = 0.5 * composite_.spacing * fixed::sin(kPi - angle) / fixed::sin(0.5 * angle);
    const Position place{step * length * fixed::cos(0.5 * angle), length * fixed::sin(0.5 * angle), 0};
    const std::array<double, 4> turn{fixed::cos(0.5 * angle), 0, 0, fixed::sin(step * 0.5 * angle)};
    set(body, "pos", Span<const double>(place));
    set(body, "quat", Span<const double>(turn));
  }

  void close_loop() const {
    const std::string first = composite_.named("B", {0}), last = composite_.named("B", {count_[0] - 1});
    const Position anchor{-0.5 * composite_.spacing, 0, 0};
    const pugi::xml_node connect = add_equality("connect", smooth_);
    set(connect, "anchor", Span<const double>(anchor));
    const pugi::xml_node exclude = add(sections_.contact, "exclude");
    for (const pugi::xml_node node : {connect, exclude}) {
      set(node, "body1", first);
      set(node, "body2", last);
    }
  }

  using Cell = std::array<int, 2>;

  void make_cloth() const {
    if (composite_.dimensions != 2) composite_.refuse("expected two dimensions");
    const Cell first = origin(2);
    fill_cell(parent_, first);
    add_columns(parent_, first);
    for (const int step : {1, -1}) {
      pugi::xml_node body = parent_;
      for (int x = first[0] + step; x >= 0 && x < count_[0]; x += step) {
        body = add_cell(body, {x - step, first[1]}, {x, first[1]});
        add_columns(body, {x, first[1]});
      }
    }
    for (int y = 0; y < count_[1]; ++y) {
      for (int x = 0; y != first[1] && x + 1 < count_[0]; ++x) {
        tie("main", composite_.named("T", {x, y}), composite_.named("S", {x, y}), composite_.named("S", {x + 1, y}));
      }
    }
    tie_diagonals();
    add_sheet_skin(composite_, sections_.asset);
  }

  void add_columns(pugi::xml_node row, Cell at) const {
    for (const int step : {1, -1}) {
      pugi::xml_node body = row;
      for (int y = at[1] + step; y >= 0 && y < count_[1]; y += step) {
        body = add_cell(body, {at[0], y - step}, {at[0], y});
      }
    }
  }

  void fill_cell(pugi::xml_node body, Cell at) const {
    const double half = std::sqrt(0.5);
    const bool odd = (at[0] + at[1]) % 2 != 0;
    const std::array<double, 4> turn =
        odd ? std::array<double, 4>{half, half, 0, 0} : std::array<double, 4>{.5, .5, .5, .5};
    const pugi::xml_node geom = add_geom(body, composite_.named("G", {at[0], at[1]}));
    set(geom, "quat", Span<const double>(turn));
    flatten(body, geom);
    add_site(body, composite_.named("S", {at[0], at[1]}));
  }

  pugi::xml_node add_cell(pugi::xml_node parent, Cell from, Cell at) const {
    const Position step{composite_.spacing * (at[0] - from[0]), composite_.spacing * (at[1] - from[1]), 0};
    const bool along_x = at[0] != from[0];
    const pugi::xml_node body = add_body(parent, composite_.named("B", {at[0], at[1]}), step);
    fill_cell(body, at);
    const Position behind{-step[0], -step[1], 0}, along = along_x ? Position{1, 0, 0} : Position{0, 1, 0};
    const Position across = along_x ? Position{0, 1, 0} : Position{1, 0, 0};
    add_joint(body, "main", composite_.named("J", {0, at[0], at[1]}), "hinge", behind, across);
    add_joint(body, "main", composite_.named("J", {1, at[0], at[1]}), "hinge", behind, {0, 0, 1});
    add_held_joint(body, "twist", composite_.named("JT", {at[0], at[1]}), "hinge", behind, along);
    add_held_joint(body, "stretch", composite_.named("JS", {at[0], at[1]}), "slide", behind, along);
    return body;
  }

  static double volume(pugi::xml_node geom) {
    std::vector<double> size = numbers(geom.attribute("size"));
    size.resize(3);
    const std::string type = geom.attribute("type").value();
    if (type == "ellipsoid") return 4 * kPi / 3 * size[0] * size[1] * size[2];
    const double ball = 4 * kPi / 3 * size[0] * size[0] * size[0];
    return type == "capsule" ? ball + kPi * size[0] * size[0] * 2 * size[1] : ball;
  }

  // The mass of the geom, spread over a square that is thin.
  void flatten(pugi::xml_node body, pugi::xml_node geom) const {
    double flat = 0, density = 1000;
    composite_.read(composite_.node.attribute("flatinertia"), Span<double>(&flat, 1));
    if (flat <= 0) return;
    composite_.read(geom.attribute("density"), Span<double>(&density, 1));
    double mass = density * volume(geom);
    composite_.read(geom.attribute("mass"), Span<double>(&mass, 1));
    const double side = 0.25 * composite_.spacing * composite_.spacing, thin = side * flat * flat;
    const Position middle{}, inertia{mass * (side + thin) / 3, mass * (side + thin) / 3, mass * (side + side) / 3};
    pugi::xml_node(body).remove_child("inertial");
    const pugi::xml_node inertial = add(body, "inertial");
    set(inertial, "pos", Span<const double>(middle));
    set(inertial, "mass", Span<const double>(&mass, 1));
    set(inertial, "diaginertia", Span<const double>(inertia));
  }

  // A corner of the unit cube, which is 2 wide, as a place on the solid.
  Position on_solid(Position at) const {
    Position size{};
    for (std::size_t i = 0; i < 3; ++i) size[i] = 0.5 * composite_.spacing * (count_[i] - 1);
    double scale = 1;
    if (composite_.is({"cylinder"})) {
      const double length = length_of(at[0], at[1]);
      scale = length > 0 ? std::max(std::abs(at[0]), std::abs(at[1])) / length : 1;
      return {at[0] * scale * size[0], at[1] * scale * size[1], at[2] * size[2]};
    }
    if (composite_.is({"ellipsoid"})) scale = 1 / length_of(at[0], at[1], at[2]);
    for (std::size_t i = 0; i < 3; ++i) at[i] *= scale * size[i];
    return at;
  }

  bool is_outside(const std::array<int, 3>& at) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (at[i] == 0 || at[i] == count_[i] - 1) return true;
    }
    return false;
  }

  void make_solid() const {
    if (composite_.dimensions != 3) composite_.refuse("expected three dimensions");
    const pugi::xml_node middle = add_geom(parent_, composite_.named("Gcenter", {}));
    const std::vector<double> size = numbers(middle.attribute("size"));
    const std::array<double, 3> twice{size.empty() ? 0 : 2 * size[0], 0, 0};
    set(middle, "type", "sphere");
    set(middle, "size", Span<const double>(twice));
    const std::string name = composite_.named("T", {});
    const pugi::xml_node tendon =
        add_tendon("fixed", "main", name, {"kind", "solreffix", "solimpfix", "limited", "material", "rgba", "width"});
    for (int x = 0; x < count_[0]; ++x) {
      for (int y = 0; y < count_[1]; ++y) {
        for (int z = 0; z < count_[2]; ++z) {
          if (is_outside({x, y, z})) add_shell_part({x, y, z}, tendon);
        }
      }
    }
    add_fix("tendon", "main", name, main_tendon_);
    add_solid_skin(composite_, sections_.asset);
  }

  void add_shell_part(const std::array<int, 3>& at, pugi::xml_node tendon) const {
    Position corner{};
    for (std::size_t i = 0; i < 3; ++i) corner[i] = 2.0 * at[i] / (count_[i] - 1) - 1;
    const Position place = on_solid(corner);
    const pugi::xml_node body = add_body(parent_, composite_.named("B", {at[0], at[1], at[2]}), place);
    set(body, "zaxis", Span<const double>(place));
    const pugi::xml_node geom = add_geom(body, composite_.named("G", {at[0], at[1], at[2]}));
    std::vector<double> size = numbers(geom.attribute("size"));
    size.resize(3);
    const bool capsule = std::string(geom.attribute("type").value()) == "capsule";
    if (!capsule) set(geom, "type", "sphere");
    const Position inwards{0, 0, -(capsule ? size[0] + size[1] : size[0])};
    set(geom, "pos", Span<const double>(inwards));
    const std::string joint = composite_.named("J", {at[0], at[1], at[2]});
    add_joint(body, "main", joint, "slide", {}, {0, 0, 1});
    add_fix("joint", "main", joint, fix_);
    const pugi::xml_node part = append(tendon, "joint");
    set(part, "joint", joint);
    set(part, "coef", "1");
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<int, 3> next = at;
      ++next[i];
      if (next[i] >= count_[i] || !is_outside(next)) continue;
      const pugi::xml_node equality = add_equality("joint", smooth_);
      set(equality, "joint1", joint);
      set(equality, "joint2", composite_.named("J", {next[0], next[1], next[2]}));
    }
  }
};

bool is_composite(pugi::xml_node node) { return is(node, "composite"); }

}  // namespace

void expand_composites(pugi::xml_node root, const Limits& limits, Report& report) {
  if (root.find_node(is_composite).empty()) return;
  check(root, limits);
  name_main_defaults(root, names::kMainClass);
  const Sections sections(root);
  for (pugi::xml_node node = root.find_node(is_composite); node; node = root.find_node(is_composite)) {
    Maker(Composite(node), sections).make();
    report.add(node, nobody_knows() + "<composite>; its bodies and what holds them together are written out");
    node.parent().remove_child(node);
  }
  for (pugi::xml_node part : {sections.contact, sections.equality, sections.tendon, sections.asset}) {
    if (part.first_child().empty()) root.remove_child(part);
  }
}

}  // namespace mimo::document
