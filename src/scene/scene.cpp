#include "scene/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"
#include "base/numbers.h"
#include "document/budget.h"
#include "document/compiler.h"
#include "document/composition.h"
#include "document/defaults.h"
#include "document/names.h"
#include "document/report.h"
#include "document/storage.h"
#include "document/xml.h"
#include "scene/anatomy.h"
#include "scene/growing.h"
#include "scene/recipe.h"

namespace mimo::scene {
namespace {

constexpr const char* kScenes[] = {"benchmark", "free", "reach", "standup", "selfbody", "catch", "rollover", "showroom",
                                   "playdate", "babybench-base", "babybench-crib", "babybench-cubes",
                                   // Behaviours.
                                   "head-lift", "chest-lift", "roll-to-belly", "roll-to-back", "sit-with-hands", "sit",
                                   "sit-up", "hands-and-knees", "crawl", "pull-to-stand", "stand-with-support", "stand",
                                   "cruise", "walk-with-help", "walk", "hand-to-mouth", "hands-together", "foot-grasp",
                                   "reach-moving", "lift", "bang", "drop", "follow", "prefer", "mobile"};
constexpr const char* kRooms[] = {"playroom"};
constexpr const char* kMirrored = "-mirrored";  // after the name of a body
constexpr const char* kBodies[] = {"mitten", "fingers", "mitten-mirrored", "fingers-mirrored"};
constexpr const char* kBodyClass = "mimo";  // default class of all that belongs to an infant
constexpr const char* kRoomClass = "room";

template <std::size_t N>
const char* entry(const char* const (&list)[N], std::size_t index) {
  return index < N ? list[index] : nullptr;
}

template <std::size_t N>
void require_known(const char* what, const char* const (&list)[N], const std::string& name) {
  if (std::find(std::begin(list), std::end(list), name) != std::end(list)) return;
  fail(Status::kNotFound, "no {} named \"{}\"; {}", what, name, choice_of(name, {std::begin(list), std::end(list)}));
}

pugi::xml_document load(const document::Library& library, const Source& source) {
  const int given = !source.name.empty() + !source.file.empty() + !source.xml.empty();
  require(given <= 1, "config: name \"{}\", file \"{}\" and xml exclude each other, {} of them are set", source.name,
          source.file, given);
  document::Loader loader(library, source.limits, source.log);
  if (!source.name.empty()) {
    require_known("scene", kScenes, source.name);
    return loader.built_in(source.name + ".xml");
  }
  if (!source.file.empty()) return loader.file(source.file);
  if (!source.xml.empty()) return loader.text(source.xml);
  return loader.text("<mujoco><include file=\"mimo/parts/options.xml\"/></mujoco>");
}

const char* shape_name(ObjectShape shape) {
  switch (shape) {
    case ObjectShape::kSphere: return "sphere";
    case ObjectShape::kCapsule: return "capsule";
    case ObjectShape::kEllipsoid: return "ellipsoid";
    case ObjectShape::kCylinder: return "cylinder";
    case ObjectShape::kBox: return "box";
  }
  return "";
}

double volume(const Object& object) {
  const auto [x, y, z] = object.size;
  switch (object.shape) {
    case ObjectShape::kSphere: return 4.0 / 3 * kPi * x * x * x;
    case ObjectShape::kCapsule: return 4.0 / 3 * kPi * x * x * x + 2 * kPi * x * x * y;
    case ObjectShape::kEllipsoid: return 4.0 / 3 * kPi * x * y * z;
    case ObjectShape::kCylinder: return 2 * kPi * x * x * y;
    case ObjectShape::kBox: return 8 * x * y * z;
  }
  return 0;
}

// The directions that are right and up in a camera's picture. Where it looks along z, y is up.
std::array<double, 6> picture_axes(const Camera& camera) {
  const Eigen::Map<const Eigen::Vector3d> from(camera.position.data());
  const Eigen::Map<const Eigen::Vector3d> to(camera.look_at.data());
  const Eigen::Vector3d forward = to - from;
  require(forward.norm() > 1e-9, "camera \"{}\" looks at its own position", camera.name);
  Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ());
  if (right.norm() < 1e-6 * forward.norm()) right = forward.cross(Eigen::Vector3d::UnitY());
  const Eigen::Vector3d up = right.cross(forward);
  return {right[0], right[1], right[2], up[0], up[1], up[2]};
}

// Textures and materials are the same for all kinds where they have the same name.
void add_assets(pugi::xml_node root, pugi::xml_node assets) {
  std::set<std::string> there;
  for (const pugi::xml_node section : root.children("asset")) {
    for (const pugi::xml_node asset : section.children()) {
      there.insert(std::string(asset.name()) + " " + asset.attribute("name").value());
    }
  }
  const pugi::xml_node added = document::append(root, "asset");
  for (const pugi::xml_node asset : assets.children()) {
    const bool is_new = there.count(std::string(asset.name()) + " " + asset.attribute("name").value()) == 0;
    if (asset.type() == pugi::node_element && is_new) document::copy_into(added, asset);
  }
  if (added.first_child().empty()) root.remove_child(added);
}

bool has_class(pugi::xml_node root, const std::string& name) {
  return !root.find_node([&](pugi::xml_node node) {
                return std::string(node.name()) == "default" && name == node.attribute("class").value();
              })
              .empty();
}

// What a document says to all of itself, said so that it does not reach what is put beside it.
void stand_alone(pugi::xml_document& document, const document::Limits& limits) {
  const pugi::xml_node root = document.document_element();
  document::require_local_coordinates(root, "the scene");
  document::weigh_alone(document, "the scene", limits);
  if (document::has_main_defaults(root)) document::name_main_defaults(root, names::kMainClass);
}

void require_other_names(pugi::xml_node infant, pugi::xml_node root, const std::string& prefix) {
  const std::string shared = document::shared_name(infant, root);
  require(shared.empty(), "agent name \"{}\": the scene already has a {}; {}", prefix.substr(0, prefix.find('/')),
          shared,
          prefix.empty() ? "give the agent a name: it goes before all the names of its body" : "give another name");
}

// Puts an infant without a place where there is one for it.
void find_spot(pugi::xml_document& document, const std::string& prefix, const document::Limits& limits) {
  constexpr document::Pose kOutOfTheWay{{0, 0, 1000}, {1, 0, 0, 0}};
  const pugi::xml_node body = document::find_named(document, "body", prefix + names::kRootBody);
  document::set_pose(body, kOutOfTheWay);
  engine::Physics physics = at_start(document::compile_quietly(document, limits));
  document::set_pose(body, free_spot(physics, prefix));
}

// Puts an infant where a part of it that is not its root has to be.
void put_by_anchor(pugi::xml_document& document, const std::string& prefix, const document::Place& place,
                   const document::Limits& limits) {
  const pugi::xml_node body = document::find_named(document, "body", prefix + names::kRootBody);
  document::set_pose(body, place.pose);
  document::set_pose(body, root_of(at_start(document::compile_quietly(document, limits)), prefix, place));
}

int count_bodies(pugi::xml_node root) {
  int count = 0;
  document::walk(root, [&](pugi::xml_node node) { count += std::string(node.name()) == "body" ? 1 : 0; });
  return count;
}

// A document that changes no more.
Document settled(pugi::xml_document&& document) {
  return std::make_shared<const pugi::xml_document>(std::move(document));
}

// "mitten" of "mitten-mirrored" as well.
std::string kind_of(const std::string& body) { return body.substr(0, body.rfind(kMirrored)); }

void turn_around(pugi::xml_node node, const char* attribute, std::size_t axis) {
  std::vector<double> vector = document::numbers(node.attribute(attribute));
  vector.at(axis) = -vector.at(axis);
  document::set(node, attribute, Span<const double>(vector));
}

// The left of the original's infants is the mirror image of their right, but for this: both mitten hands lie 7 mm off
// the axis of their forearms to the same side, and the left little finger's first bone turns about another axis.
pugi::xml_document body_document(const document::Library& models, const std::string& body) {
  const std::string kind = kind_of(body);
  pugi::xml_document document = document::Loader(models).built_in(kind + ".xml");
  if (kind == body) return document;
  const pugi::xml_node root = document.document_element();
  if (kind == "mitten") {
    turn_around(document::find_named(root, "body", "left_hand"), "pos", 1);
    turn_around(document::find_named(root, "joint", "robot:left_hand1"), "pos", 1);
  } else {
    turn_around(document::find_named(root, "joint", "robot:left_lf_meta"), "axis", 2);
  }
  return document;
}

}  // namespace

std::size_t size_count(ObjectShape shape) {
  switch (shape) {
    case ObjectShape::kSphere: return 1;
    case ObjectShape::kCapsule:
    case ObjectShape::kCylinder: return 2;
    case ObjectShape::kEllipsoid:
    case ObjectShape::kBox: return 3;
  }
  return 0;
}

const char* built_in_scene(std::size_t index) { return entry(kScenes, index); }
const char* built_in_room(std::size_t index) { return entry(kRooms, index); }

Scene::Scene(const Source& source)
    : models_(source.model_dir),
      limits_(source.limits),
      log_(source.log),
      document_(settled(load(models_, source))),
      built_in_(source.name) {}

void Scene::set_room(const std::string& room) {
  require_known("room", kRooms, room);
  const pugi::xml_document guest = document::Loader(models_).built_in("free.xml");
  pugi::xml_document changed = document::copy(*document_);
  const pugi::xml_node root = changed.document_element();
  require(!has_class(root, kRoomClass), "room \"{}\": the scene has a room already", room);
  require(!has_name("geom", "floor"), "room \"{}\": the scene has a geom named \"floor\" already", room);
  const bool has_places = !scene::custom_numbers(root, names::kPlaces).empty();
  const pugi::xml_node own_start = pugi::xml_node(root).prepend_child("custom");  // what comes later counts
  if (own_start.empty()) throw std::bad_alloc();
  for (const pugi::xml_node part : guest.document_element().children()) {
    const std::string name = part.name();
    const bool setting = name == "option" || name == "statistic" || name == "visual";
    if (name == "custom" && has_places) continue;
    if (part.type() != pugi::node_element) continue;
    setting ? document::copy_before(own_start, part) : document::copy_into(root, part);
  }
  pugi::xml_node(root).remove_child(own_start);
  document_ = settled(std::move(changed));
}

void Scene::add_body(const std::string& body, const std::string& prefix, const document::Pose* pose, unsigned groups,
                     document::Anchor anchor) {
  require_known("body", kBodies, body);
  const bool no_place =
      pose == nullptr && bodies_ == 0 && scene::custom_numbers(document_->document_element(), names::kPlaces).empty();
  const std::optional<document::Pose> place = pose != nullptr ? *pose : free_place();
  require(place.has_value(), "position: the scene has no place for infant number {}; set its position", bodies_ + 1);
  Recipe recipe = Recipe::of_room(document_->document_element(), models_);
  const std::vector<std::string> fit = recipe.bodies();
  const std::string kind = kind_of(body);
  require(fit.empty() || std::find(fit.begin(), fit.end(), kind) != fit.end(),
          "body \"{}\": the scene is made for {} only", body, join(fit, ", "));

  const pugi::xml_document guest = body_document(models_, body);
  const pugi::xml_node guest_root = guest.document_element();
  pugi::xml_document changed = document::copy(*document_);  // what fails half-way must leave the scene as it is
  const pugi::xml_node root = changed.document_element();
  document::prefix_names(guest_root, prefix);
  require_other_names(guest_root, root, prefix);
  stand_alone(changed, limits_);
  if (document::in_radians(root)) document::convert_to_radians(guest_root);
  const bool known = added_.count(kind) > 0;
  const std::string classes = known ? added_.at(kind).classes : has_class(root, kBodyClass) ? kind + ":" : "";
  document::prefix_classes(guest_root, classes);
  for (const pugi::xml_node part : guest_root.children()) {
    const std::string name = part.name();
    if (name == "compiler" || part.type() != pugi::node_element) continue;
    if (name == "asset") {
      add_assets(root, part);
    } else if (name != "default" || !known) {
      document::copy_into(root, part);
    }
  }
  for (const pugi::xml_node world : root.children("worldbody")) {
    const pugi::xml_node added = world.find_child_by_attribute("body", "name", (prefix + names::kRootBody).c_str());
    if (!added.empty()) document::set_pose(added, *place);
  }
  if (groups != 0) {
    keep_motors(root, prefix, groups);
  } else {
    keep_motors(root, prefix, recipe.acts(), recipe.still());
  }
  recipe.apply(root, prefix, pose != nullptr);
  std::vector<std::string> to_check = to_check_;
  if (pose != nullptr || built_in_.empty()) to_check.push_back(prefix);
  std::optional<std::string> unplaced = unplaced_;
  if (no_place && scene::custom_numbers(root, prefix + names::kRootPose).empty()) unplaced = prefix;
  std::map<std::string, document::Place> anchored = anchored_;
  if (pose != nullptr && anchor != document::Anchor::kRoot) anchored.emplace(prefix, document::Place{*pose, anchor});
  Document next = settled(std::move(changed));
  Added& added = added_.emplace(kind, Added{0, classes}).first->second;
  to_check_ = std::move(to_check);
  unplaced_ = std::move(unplaced);
  anchored_ = std::move(anchored);
  document_ = std::move(next);
  ++added.count;
  ++bodies_;
}

void Scene::choose_motors(const std::string& prefix, unsigned groups) {
  if (groups == 0) return;
  pugi::xml_document changed = document::copy(*document_);
  keep_motors(changed.document_element(), prefix, groups);
  document_ = settled(std::move(changed));
}

void Scene::grow(const std::string& prefix, const growth::Growth& growth) {
  const pugi::xml_document trial = document::copy(*document_);
  scene::grow(trial.document_element(), prefix, growth);
  grown_[prefix] = growth;
}

std::vector<std::string> Scene::infants() const { return custom_words(document_->document_element(), names::kInfants); }

std::string Scene::custom_text(const std::string& name) const {
  return scene::custom_text(document_->document_element(), name);
}

std::vector<double> Scene::custom_numbers(const std::string& name) const {
  return scene::custom_numbers(document_->document_element(), name);
}

UsualInfant Scene::usual_infant() const {
  const Recipe recipe = Recipe::of_room(document_->document_element(), models_);
  const std::vector<std::string> fit = recipe.bodies();
  const auto* const found =
      fit.empty() ? std::begin(kBodies) : std::find(std::begin(kBodies), std::end(kBodies), fit.front());
  const char* body = found != std::end(kBodies) ? *found : kBodies[0];
  return {body, recipe.senses(), recipe.muscles()};
}

void Scene::add_object(const Object& object) {
  require(!has_name("body", object.name) && !has_name("geom", object.name),
          "object name \"{}\": the scene already has a body or geom of that name", object.name);
  pugi::xml_document changed = document::copy(*document_);
  stand_alone(changed, limits_);
  const pugi::xml_node body = document::append(document::section(changed.document_element(), "worldbody"), "body");
  document::set(body, "name", object.name);
  document::set_pose(body, object.pose);
  if (!object.fixed) document::set(document::append(body, "freejoint"), "name", object.name);
  const pugi::xml_node geom = document::append(body, "geom");
  document::set(geom, "name", object.name);
  document::set(geom, "type", shape_name(object.shape));
  document::set(geom, "size", Span<const double>(object.size));
  document::set(geom, "rgba", Span<const double>(object.rgba));
  const double mass = object.mass > 0 ? object.mass : 1000 * volume(object);
  document::set(geom, "mass", Span<const double>(&mass, 1));
  document::set(geom, "condim", "6");
  document::set(geom, "friction", "1 0.005 0.0001");
  document::set(geom, "solref", "0.005 1");
  document::set(geom, "solimp", "0.95 0.99 0.001 0.5 1");
  document_ = settled(std::move(changed));
  ++objects_;
}

void Scene::add_model(const Model& model) {
  require(model.file.empty() != model.xml.empty(), "model \"{}\": {} of file and xml are set, expected one", model.name,
          model.file.empty() ? "none" : "both");
  document::require_plain(model.name);
  require(!has_name("body", model.name) && !has_name("joint", model.name) && !has_name("freejoint", model.name) &&
              !document::has_names_with(document_->document_element(), model.name + "/"),
          "model name \"{}\": the scene already has something of that name", model.name);
  document::Loader loader(models_, limits_, log_);
  pugi::xml_document guest = model.file.empty() ? loader.text(model.xml) : loader.file(model.file);
  pugi::xml_document changed = document::copy(*document_);
  const pugi::xml_node root = changed.document_element();
  stand_alone(changed, limits_);
  become_object(guest, root, model, limits_);
  for (const char* name :
       {"default", "asset", "worldbody", "contact", "equality", "tendon", "actuator", "sensor", "custom"}) {
    for (const pugi::xml_node part : guest.document_element().children(name)) document::copy_into(root, part);
  }
  document_ = settled(std::move(changed));
  objects_ += count_bodies(guest.document_element());
}

void Scene::weld(const Weld& weld, const document::Pose* pose) {
  require_bodies(document_->document_element(), weld);
  if (pose == nullptr) return start_welds_.push_back(weld);
  pugi::xml_document changed = document::copy(*document_);
  add_weld(changed.document_element(), weld, *pose);
  document_ = settled(std::move(changed));
}

void Scene::start_joint(const std::string& joint, double value) {
  pugi::xml_document changed = document::copy(*document_);
  scene::start_joint(changed.document_element(), joint, value);
  document_ = settled(std::move(changed));
}

void Scene::lock_joint(const std::string& joint, double value) {
  pugi::xml_document changed = document::copy(*document_);
  scene::lock_joint(changed.document_element(), joint, value);
  document_ = settled(std::move(changed));
}

void Scene::add_camera(const Camera& camera) {
  require(!has_name("camera", camera.name), "camera name \"{}\": the scene already has a camera of that name",
          camera.name);
  pugi::xml_document changed = document::copy(*document_);
  const pugi::xml_node carrier = camera.body.empty() ? document::section(changed.document_element(), "worldbody")
                                                     : document::find_named(changed, "body", camera.body);
  if (carrier.empty()) fail(Status::kNotFound, "camera \"{}\": no body named \"{}\"", camera.name, camera.body);
  const pugi::xml_node node = document::append(carrier, "camera");
  document::set(node, "name", camera.name);
  document::set(node, "mode", "fixed");
  document::set(node, "pos", Span<const double>(camera.position));
  document::set(node, "xyaxes", Span<const double>(picture_axes(camera)));
  document::set(node, "fovy", Span<const double>(&camera.fovy, 1));
  document_ = settled(std::move(changed));
}

pugi::xml_document Scene::finished() const {
  pugi::xml_document document = document::copy(*document_);
  const pugi::xml_node root = document.document_element();
  const auto count = [&](const char* body) { return added_.count(body) > 0 ? added_.at(body).count : 0; };
  document::size_buffers(root, count("mitten"), count("fingers"), objects_);
  const bool infants = bodies_ > 0 || has_name("body", names::kRootBody);
  if (infants) document::keep_hands_in_sight(root);
  if (bodies_ + objects_ > 0) {
    document::put_stateful_last(root);
    document::fit_user_numbers(root);
  }
  // Keyframes are positions of all joints that the document itself had.
  while (bodies_ + objects_ > 0 && root.child("keyframe")) pugi::xml_node(root).remove_child("keyframe");
  document::settle(root);
  for (const auto& [prefix, growth] : grown_) scene::grow(root, prefix, growth);
  for (const auto& [prefix, place] : anchored_) put_by_anchor(document, prefix, place, limits_);
  if (unplaced_) find_spot(document, *unplaced_, limits_);
  if (!start_welds_.empty()) add_start_welds(root, start_welds_, document::compile_quietly(document, limits_));
  return document;
}

// Without what only we can read.
pugi::xml_document Scene::shown() const {
  pugi::xml_document document = finished();
  document::take_lines(document.document_element());
  return document;
}

void Scene::check_places(const engine::ModelPtr& model, const LogSink& log) const {
  if (to_check_.empty() || !log) return;
  const engine::Physics physics = at_start(model);
  for (const std::string& prefix : to_check_) warn_of_overlap(physics, prefix, log);
}

std::string Scene::xml() const { return document::print(shown()); }

document::Package Scene::package() const { return document::package(shown(), limits_); }

document::Composition Scene::compose() const { return document::packed(finished(), limits_); }

std::vector<std::string> Scene::body_names(const std::string& prefix) const {
  const auto is = [&](pugi::xml_node node, const std::string& name) {
    return std::string(node.name()) == "body" && name == node.attribute("name").value();
  };
  const pugi::xml_node root =
      document_->find_node([&](pugi::xml_node node) { return is(node, prefix + names::kRootBody); });
  std::vector<std::string> names;
  document::walk(root, [&](pugi::xml_node node) {
    const std::string name = node.attribute("name").value();
    if (is(node, name) && name.size() > prefix.size()) names.push_back(name.substr(prefix.size()));
  });
  return names;
}

bool Scene::has_name(const char* element, const std::string& name) const {
  return !document::find_named(*document_, element, name).empty();
}

std::optional<document::Pose> Scene::free_place() const {
  const std::vector<double> places = scene::custom_numbers(document_->document_element(), names::kPlaces);
  const std::size_t first = static_cast<std::size_t>(bodies_) * 7;
  if (places.empty() && bodies_ == 0) return document::Pose{};
  if (places.size() < first + 7) return std::nullopt;
  document::Pose pose;
  std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(first), 3, pose.position.begin());
  std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(first) + 3, 4, pose.orientation.begin());
  return pose;
}

}  // namespace mimo::scene
