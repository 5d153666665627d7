#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/fail.h"
#include "base/format.h"
#include "scene/loader.h"
#include "scene/names.h"
#include "scene/recipe.h"
#include "scene/xml.h"

namespace mimo::scene {
namespace {

constexpr const char* kScenes[] = {"benchmark", "free", "reach", "standup", "selfbody"};
constexpr const char* kBodies[] = {"mitten"};
constexpr const char* kRootBody = "mimo_location";
constexpr const char* kPlaces = "mimo:place";  // custom number of a room: 7 values a place

template <std::size_t N>
const char* entry(const char* const (&list)[N], std::size_t index) {
  return index < N ? list[index] : nullptr;
}

template <std::size_t N>
void require_known(const char* what, const char* const (&list)[N], const std::string& name) {
  if (std::find(std::begin(list), std::end(list), name) != std::end(list)) return;
  fail(Status::kNotFound, "no {} named \"{}\"; there are: {}", what, name, fmt::join(list, ", "));
}

pugi::xml_document load(const Library& library, const Source& source) {
  Loader loader(library);
  if (!source.name.empty()) {
    require_known("scene", kScenes, source.name);
    return loader.built_in(source.name + ".xml");
  }
  if (!source.file.empty()) return loader.file(source.file);
  if (!source.xml.empty()) return loader.text(source.xml);
  return loader.text("<mujoco><include file=\"mimo/parts/options.xml\"/></mujoco>");
}

const char* shape_name(Shape shape) {
  switch (shape) {
    case Shape::kSphere: return "sphere";
    case Shape::kCapsule: return "capsule";
    case Shape::kEllipsoid: return "ellipsoid";
    case Shape::kCylinder: return "cylinder";
    case Shape::kBox: return "box";
  }
  return "";
}

double volume(const Object& object) {
  constexpr double kPi = 3.14159265358979323846;
  const auto [x, y, z] = object.size;
  switch (object.shape) {
    case Shape::kSphere: return 4.0 / 3 * kPi * x * x * x;
    case Shape::kCapsule: return 4.0 / 3 * kPi * x * x * x + 2 * kPi * x * x * y;
    case Shape::kEllipsoid: return 4.0 / 3 * kPi * x * y * z;
    case Shape::kCylinder: return 2 * kPi * x * x * y;
    case Shape::kBox: return 8 * x * y * z;
  }
  return 0;
}

void set_pose(pugi::xml_node body, const Pose& pose) {
  for (const char* other : {"euler", "axisangle", "xyaxes", "zaxis"}) body.remove_attribute(other);
  set(body, "pos", Span<const double>(pose.position));
  set(body, "quat", Span<const double>(pose.orientation));
}

pugi::xml_node section(pugi::xml_node root, const char* name) {
  const pugi::xml_node found = root.child(name);
  return found.empty() ? append(root, name) : found;
}

// The directions that are right and up in a camera's picture. Where it looks along z, y is up.
std::array<double, 6> picture_axes(const Camera& camera) {
  using Vector = std::array<double, 3>;
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto length = [](const Vector& v) { return std::hypot(v[0], v[1], v[2]); };
  Vector forward{};
  for (std::size_t i = 0; i < 3; ++i) forward[i] = camera.look_at[i] - camera.position[i];
  require(length(forward) > 1e-9, "camera \"{}\" looks at the point where it is", camera.name);
  Vector right = cross(forward, {0, 0, 1});
  if (length(right) < 1e-6 * length(forward)) right = cross(forward, {0, 1, 0});
  const Vector up = cross(right, forward);
  return {right[0], right[1], right[2], up[0], up[1], up[2]};
}

// MuJoCo sizes its buffers for the worst case, 19 MB a world. In ten hours of random movement an infant needed up to
// 37 contacts, 175 constraints (210 with every joint locked) and 23,000 numbers of stack. A buffer that is full after
// all shows as a warning, never as a crash.
struct Buffers {
  int contacts, constraints, stack;
};
constexpr Buffers kRoom = {20, 60, 20000};
constexpr Buffers kInfant = {100, 340, 80000};
constexpr Buffers kObject = {20, 60, 5000};

void size_buffers(pugi::xml_node root, int infants, int objects) {
  if (infants == 0) return;
  for (const pugi::xml_node given : root.children("size")) {
    for (const char* name : {"njmax", "nconmax", "nstack", "memory"}) {
      if (given.attribute(name)) return;  // the document's author has decided
    }
  }
  const auto sum = [=](int Buffers::*which) {
    return std::to_string(kRoom.*which + infants * kInfant.*which + objects * kObject.*which);
  };
  const pugi::xml_node size = section(root, "size");
  set(size, "nconmax", sum(&Buffers::contacts));
  set(size, "njmax", sum(&Buffers::constraints));
  set(size, "nstack", sum(&Buffers::stack));
}

// An attribute of the document's elements of that name in sections of that name; 0 where none has it. The last one
// counts, as MuJoCo reads them.
double setting(pugi::xml_node root, const char* section, const char* element, const char* attribute) {
  double value = 0;
  const auto read = [&](pugi::xml_node node) {
    const std::vector<double> given = numbers(node.attribute(attribute));
    if (given.size() == 1) value = given[0];
  };
  for (const pugi::xml_node part : root.children(section)) {
    if (element == nullptr) {
      read(part);
    } else {
      for (const pugi::xml_node node : part.children(element)) read(node);
    }
  }
  return value;
}

// Nothing nearer than znear * extent is drawn. MuJoCo's own choice, a hundredth of the size of all that there is, would
// hide an infant's hands from its eyes. Where the author has set both, it is so; else they become 5 mm and, for want of
// any other, 100 m.
void keep_hands_in_sight(pugi::xml_node root) {
  constexpr double kNear = 0.005, kExtent = 2;
  const double extent = setting(root, "statistic", nullptr, "extent"), near = setting(root, "visual", "map", "znear");
  if (extent > 0 && near > 0) return;
  const double own_extent = extent > 0 ? extent : near > 0 ? kNear / near : kExtent;
  if (extent == 0) set(section(root, "statistic"), "extent", Span<const double>(&own_extent, 1));
  if (near > 0) return;
  const double own_near = kNear / own_extent;
  const pugi::xml_node visual = section(root, "visual");
  set(section(visual, "map"), "znear", Span<const double>(&own_near, 1));
}

// Calls visit(node, attribute) for every reference to a built-in file.
template <typename Visit>
void visit_built_in_files(pugi::xml_node root, Visit&& visit) {
  walk(root, [&](pugi::xml_node node) {
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const bool is_file = std::string(attribute.name()).rfind("file", 0) == 0;
      if (is_file && std::string(attribute.value()).rfind("mimo/", 0) == 0) visit(node, attribute);
    }
  });
}

}  // namespace

const char* built_in_scene(std::size_t index) { return entry(kScenes, index); }
const char* built_in_body(std::size_t index) { return entry(kBodies, index); }

Scene::Scene(const Source& source) : library_(source.model_dir), document_(load(library_, source)) {}

void Scene::add_body(const std::string& body, const std::string& prefix, const Pose* pose, unsigned groups) {
  require_known("body", kBodies, body);
  const std::string root_name = prefix + kRootBody;
  require(!has_name("body", root_name), "agent name \"{}\": the scene already has a body named {}", prefix, root_name);
  const Pose place = pose != nullptr ? *pose : next_place();

  const pugi::xml_document guest = Loader(library_).built_in(body + ".xml");
  const pugi::xml_node guest_root = guest.document_element();
  pugi::xml_document changed = copy(document_);  // what fails half-way must leave the scene as it is
  const pugi::xml_node root = changed.document_element();
  prefix_names(guest_root, prefix);
  if (in_radians(root)) convert_to_radians(guest_root);
  for (const pugi::xml_node part : guest_root.children()) {
    const std::string name = part.name();
    const bool shared = name == "default" || name == "asset";
    if (name == "compiler" || part.type() != pugi::node_element) continue;
    if (shared && body_assets_added_) continue;
    copy_into(root, part);
  }
  for (const pugi::xml_node world : root.children("worldbody")) {
    const pugi::xml_node added = world.find_child_by_attribute("body", "name", root_name.c_str());
    if (!added.empty()) set_pose(added, place);
  }
  Recipe recipe = Recipe::of_room(root, library_);
  keep_motors(root, prefix, groups != 0 ? groups : recipe.acts());
  recipe.apply(root, prefix, pose != nullptr);
  document_ = std::move(changed);
  body_assets_added_ = true;
  ++bodies_;
}

void Scene::choose_motors(const std::string& prefix, unsigned groups) {
  if (groups == 0) return;
  pugi::xml_document changed = copy(document_);
  keep_motors(changed.document_element(), prefix, groups);
  document_ = std::move(changed);
}

std::string Scene::senses() const { return Recipe::of_room(document_.document_element(), library_).senses(); }

void Scene::add_object(const Object& object) {
  require(!has_name("body", object.name) && !has_name("geom", object.name),
          "object name \"{}\": the scene already has a body or geom of that name", object.name);
  pugi::xml_document changed = copy(document_);
  const pugi::xml_node body = append(section(changed.document_element(), "worldbody"), "body");
  set(body, "name", object.name);
  set_pose(body, object.pose);
  if (!object.fixed) set(append(body, "freejoint"), "name", object.name);
  const pugi::xml_node geom = append(body, "geom");
  set(geom, "name", object.name);
  set(geom, "type", shape_name(object.shape));
  set(geom, "size", Span<const double>(object.size));
  set(geom, "rgba", Span<const double>(object.rgba));
  const double mass = object.mass > 0 ? object.mass : 1000 * volume(object);
  set(geom, "mass", Span<const double>(&mass, 1));
  // Spelt out, so that main defaults of a user's document do not change what was asked for.
  for (const char* one : {"contype", "conaffinity", "solmix"}) set(geom, one, "1");
  for (const char* zero : {"group", "priority", "margin", "gap"}) set(geom, zero, "0");
  set(geom, "shellinertia", "false");
  set(geom, "pos", "0 0 0");
  set(geom, "quat", "1 0 0 0");
  set(geom, "condim", "6");
  set(geom, "friction", "1 0.005 0.0001");
  set(geom, "solref", "0.005 1");
  set(geom, "solimp", "0.95 0.99 0.001 0.5 1");
  document_ = std::move(changed);
  ++objects_;
}

void Scene::add_camera(const Camera& camera) {
  require(!has_name("camera", camera.name), "camera name \"{}\": the scene already has a camera of that name",
          camera.name);
  const pugi::xml_node carrier =
      camera.body.empty() ? section(document_.document_element(), "worldbody") : find_named("body", camera.body);
  if (carrier.empty()) fail(Status::kNotFound, "camera \"{}\": no body named \"{}\"", camera.name, camera.body);
  const std::array<double, 6> axes = picture_axes(camera);  // before anything is changed
  const pugi::xml_node node = append(carrier, "camera");
  set(node, "name", camera.name);
  set(node, "mode", "fixed");
  set(node, "pos", Span<const double>(camera.position));
  set(node, "xyaxes", Span<const double>(axes));
  set(node, "fovy", Span<const double>(&camera.fovy, 1));
}

pugi::xml_document Scene::finished() const {
  pugi::xml_document document = copy(document_);
  size_buffers(document.document_element(), bodies_, objects_);
  const bool infants = bodies_ > 0 || has_name("body", kRootBody);
  if (infants) keep_hands_in_sight(document.document_element());
  return document;
}

std::string Scene::xml() const { return print(finished()); }

Composition Scene::compose() const {
  const pugi::xml_document document = finished();
  Composition composition;
  std::set<std::string> seen;
  visit_built_in_files(document.document_element(), [&](pugi::xml_node node, pugi::xml_attribute attribute) {
    const std::string path = std::string(attribute.value()).substr(5);
    const auto bytes = built_in_file(path);
    if (bytes.empty()) return;
    // MuJoCo tells files in memory apart by their last part only: a user's own floor.png must not be taken for ours.
    std::string name = "mimo:" + path;
    std::replace(name.begin(), name.end(), '/', ':');
    set(node, attribute.name(), name);
    if (seen.insert(name).second) composition.assets.push_back({name, bytes});
  });
  composition.xml = print(document);
  return composition;
}

std::vector<std::string> Scene::body_names(const std::string& prefix) const {
  const auto is = [&](pugi::xml_node node, const std::string& name) {
    return std::string(node.name()) == "body" && name == node.attribute("name").value();
  };
  const pugi::xml_node root = document_.find_node([&](pugi::xml_node node) { return is(node, prefix + kRootBody); });
  std::vector<std::string> names;
  walk(root, [&](pugi::xml_node node) {
    const std::string name = node.attribute("name").value();
    if (is(node, name) && name.size() > prefix.size()) names.push_back(name.substr(prefix.size()));
  });
  return names;
}

pugi::xml_node Scene::find_named(const char* element, const std::string& name) const {
  return document_.find_node([&](pugi::xml_node node) {
    return std::string(node.name()) == element && name == node.attribute("name").value();
  });
}

bool Scene::has_name(const char* element, const std::string& name) const { return !find_named(element, name).empty(); }

// The room's next free place for an infant; the origin in a room that names none.
Pose Scene::next_place() const {
  std::vector<double> places;
  for (const pugi::xml_node custom : document_.document_element().children("custom")) {
    const pugi::xml_node node = custom.find_child_by_attribute("numeric", "name", kPlaces);
    if (!node.empty()) places = numbers(node.attribute("data"));
  }
  const std::size_t first = static_cast<std::size_t>(bodies_) * 7;
  if (places.empty() && bodies_ == 0) return {};
  require(places.size() >= first + 7, "position: the scene has no place for infant number {}; give one", bodies_ + 1);
  Pose pose;
  std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(first), 3, pose.position.begin());
  std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(first) + 3, 4, pose.orientation.begin());
  return pose;
}

}  // namespace mimo::scene
