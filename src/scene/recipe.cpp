#include "scene/recipe.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>

#include "base/fail.h"
#include "base/format.h"
#include "base/functions.h"
#include "base/names.h"
#include "base/numbers.h"
#include "body/body.h"
#include "document/attributes.h"
#include "document/names.h"
#include "document/storage.h"
#include "document/xml.h"
#include "engine/contacts.h"
#include "engine/model.h"
#include "scene/anatomy.h"

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

// Of what is neither in the scene nor in the recipe itself.
void drop_missing(pugi::xml_node own, std::set<std::string> parts) {
  parts.merge(parts_of(own));
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

using engine::Kind;

constexpr double kClearance = 0.0005;  // m

struct Spot {
  double x, y;
};

// The origin, and rings around it.
std::vector<Spot> spots() {
  constexpr int kRings = 8, kDirections = 8;
  constexpr double kBetween = 0.5;  // m
  std::vector<Spot> spots{{0, 0}};
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * kPi * i / kDirections, radius = kBetween * ring;
      spots.push_back({radius * fixed::cos(angle), radius * fixed::sin(angle)});
    }
  }
  return spots;
}

// Height of the lowest point of geoms.
double lowest(const engine::Physics& physics, const std::vector<int>& geoms) {
  double low = std::numeric_limits<double>::infinity();
  for (const int geom : geoms) {
    const double height = physics.data().geom_xpos[3 * geom + 2];
    low = std::min(low, height - engine::half_height(physics.model(), physics.data(), geom));
  }
  return low;
}

// Geoms of a body and of what hangs on it.
std::vector<int> geoms_below(const mjModel& model, int body) {
  std::vector<int> geoms;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    int at = model.geom_bodyid[geom];
    while (at != body && at != 0) at = model.body_parentid[at];
    if (at == body) geoms.push_back(geom);
  }
  return geoms;
}

std::array<double, 3> position_of(const engine::Physics& physics, int body) {
  const double* position = physics.data().xpos + 3 * body;
  return {position[0], position[1], position[2]};
}

std::array<double, 3> lowest_below(const engine::Physics& physics, int root) {
  const std::array<double, 3> at = position_of(physics, root);
  return {at[0], at[1], lowest(physics, geoms_below(physics.model(), root))};
}

std::array<double, 3> soles(const engine::Physics& physics, const std::string& prefix) {
  const mjModel& model = physics.model();
  std::array<double, 3> middle{0, 0, std::numeric_limits<double>::infinity()};
  for (const char* name : {"left_foot", "right_foot"}) {
    const int foot = engine::find_or_fail(model, Kind::kBody, prefix + name);
    const std::array<double, 3> at = lowest_below(physics, foot);
    middle = {middle[0] + at[0] / 2, middle[1] + at[1] / 2, std::min(middle[2], at[2])};
  }
  return middle;
}

class Search {
 public:
  Search(engine::Physics& physics, const std::string& prefix)
      : physics_(physics),
        root_(engine::find_or_fail(physics.model(), Kind::kBody, prefix + names::kRootBody)),
        address_(engine::free_joint_address(physics.model(), root_)),
        geoms_(engine::geoms_of_tree(physics.model(), root_)) {}

  document::Pose run() {
    put({0, 0}, 0);
    const double sole = lowest(physics_, geoms_);
    bool ground = false;
    constexpr double kCupboard = 1;  // m; it rather stands beside something than so high on it
    for (const double highest : {kCupboard, std::numeric_limits<double>::infinity()}) {
      for (const Spot& spot : spots()) {
        for (const double height : heights_under(spot)) {
          ground = true;
          if (std::abs(height) <= highest && fits(spot, height - sole + kClearance)) return pose();
        }
      }
    }
    for (const Spot& spot : spots()) {
      if (!ground && fits(spot, 0)) return pose();
    }
    return {};
  }

 private:
  void put(const Spot& spot, double z) {
    double* place = physics_.data().qpos + address_;
    const std::array<double, 7> pose{spot.x, spot.y, z, 1, 0, 0, 0};
    std::copy(pose.begin(), pose.end(), place);
    physics_.update_contacts();
  }

  document::Pose pose() {
    const double* place = physics_.data().qpos + address_;
    return {{place[0], place[1], place[2]}, {1, 0, 0, 0}};
  }

  // The nearest to the origin's height first.
  std::vector<double> heights_under(const Spot& spot) const {
    constexpr double kReach = 0.12, kSame = 0.001;  // m
    std::vector<double> heights;
    for (int i = -2; i <= 2; ++i) {
      for (int j = -2; j <= 2; ++j) {
        const std::vector<double> met = engine::heights_at(physics_.model(), physics_.data(), geoms_,
                                                           spot.x + kReach * i / 2, spot.y + kReach * j / 2);
        heights.insert(heights.end(), met.begin(), met.end());
      }
    }
    std::sort(heights.begin(), heights.end());
    const auto same = [](double one, double other) { return other - one < kSame; };
    heights.erase(std::unique(heights.begin(), heights.end(), same), heights.end());
    std::stable_sort(heights.begin(), heights.end(),
                     [](double one, double other) { return std::abs(one) < std::abs(other); });
    return heights;
  }

  // Whether it is inside of nothing there, or a little higher, where the ground is uneven.
  bool fits(const Spot& spot, double z) {
    constexpr int kTries = 8;
    constexpr double kUneven = 0.05;  // m
    for (int i = 0; i < kTries; ++i) {
      put(spot, z);
      const double depth = engine::deepest_overlap(physics_.model(), physics_.data(), root_).depth;
      if (depth == 0) return true;
      if (depth > kUneven) return false;
      z += depth + kClearance;
    }
    return false;
  }

  engine::Physics& physics_;
  int root_;
  int address_;
  std::vector<int> geoms_;
};

// A side of a contact.
std::string described(const mjModel& model, int geom, int body_id) {
  const std::string body = engine::name(model, Kind::kBody, body_id);
  if (geom < 0) return "the flex of body \"" + body + "\"";
  const std::string name = engine::name(model, Kind::kGeom, geom);
  if (!name.empty()) return "geom \"" + name + "\"";
  return "geom " + std::to_string(geom) + " of body \"" + body + "\"";
}

}  // namespace

std::string custom_text(pugi::xml_node root, const std::string& name) {
  return find_named(root, "custom", "text", name).attribute("data").value();
}

std::vector<std::string> custom_words(pugi::xml_node root, const std::string& name) {
  std::istringstream words(custom_text(root, name));
  return {std::istream_iterator<std::string>(words), {}};
}

std::vector<double> custom_numbers(pugi::xml_node root, const std::string& name) {
  constexpr double kMost = 500;  // more is refused when the document is compiled
  const pugi::xml_node numeric = find_named(root, "custom", "numeric", name);
  std::vector<double> values = document::numbers(numeric.attribute("data"));
  const double size = document::number(numeric, "size").value_or(0);
  if (size > static_cast<double>(values.size())) values.resize(static_cast<std::size_t>(std::min(size, kMost)));
  return values;
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

std::vector<std::string> Recipe::senses() const { return custom_words(document_.document_element(), names::kSenses); }

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

engine::Physics at_start(const engine::ModelPtr& model) {
  engine::Physics physics(model, {});
  body::read_stored_pose(*model, physics.start());
  physics.reset();
  return physics;
}

document::Pose free_spot(engine::Physics& physics, const std::string& prefix) { return Search(physics, prefix).run(); }

document::Pose root_of(const engine::Physics& physics, const std::string& prefix, const document::Place& place) {
  const int root = engine::find_or_fail(physics.model(), Kind::kBody, prefix + names::kRootBody);
  const std::array<double, 3> is = position_of(physics, root);
  const bool by_soles = place.anchor == document::Anchor::kSoles;
  const std::array<double, 3> anchor = by_soles ? soles(physics, prefix) : lowest_below(physics, root);
  document::Pose pose = place.pose;
  for (std::size_t i = 0; i < 3; ++i) pose.position[i] += is[i] - anchor[i];
  return pose;
}

void warn_of_overlap(const engine::Physics& physics, const std::string& prefix, const LogSink& log) {
  constexpr double kWorthSaying = 0.005;  // m; what lies or stands sinks in by a millimetre or two
  const mjModel& model = physics.model();
  const int root = engine::find_or_fail(model, Kind::kBody, prefix + names::kRootBody);
  const engine::Overlap overlap = engine::deepest_overlap(model, physics.data(), root);
  if (overlap.depth < kWorthSaying) return;
  const std::size_t other = 1 - overlap.own;
  const std::string own = engine::name(model, Kind::kBody, overlap.met.bodies[overlap.own]);
  log(LogLevel::kWarning,
      format("the infant starts {:.1f} cm inside of {}, with its body \"{}\"; give it another place",
             100 * overlap.depth, described(model, overlap.met.geoms[other], overlap.met.bodies[other]), own));
}

}  // namespace mimo::scene
