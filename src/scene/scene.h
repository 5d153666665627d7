// A scene under construction: one MJCF document that grows with every call, and the agents in it.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/log.h"
#include "document/attributes.h"
#include "document/budget.h"
#include "document/composition.h"
#include "document/library.h"
#include "document/storage.h"
#include "growth/growth.h"
#include "mimo/scene.h"
#include "scene/attachments.h"
#include "scene/recipe.h"

namespace mimo::scene {

// At most one of name, file and xml is not empty.
struct Source {
  std::string name;
  std::string file;
  std::string xml;
  std::string model_dir;
  document::Limits limits;
  LogSink log;  // for what is not as the document's author meant it
};

enum class ObjectShape : std::int32_t {
  kSphere = MIMO_SHAPE_SPHERE,
  kCapsule = MIMO_SHAPE_CAPSULE,
  kEllipsoid = MIMO_SHAPE_ELLIPSOID,
  kCylinder = MIMO_SHAPE_CYLINDER,
  kBox = MIMO_SHAPE_BOX,
};
// How many of an object's three sizes count.
std::size_t size_count(ObjectShape shape);

struct Object {
  std::string name;
  ObjectShape shape = ObjectShape::kSphere;
  std::array<double, 3> size{};
  document::Pose pose;
  double mass = 0;  // 0: from a density of 1000 kg/m^3
  std::array<double, 4> rgba{};
  bool fixed = false;
};

struct Camera {
  std::string name;
  std::string body;  // "": the world
  std::array<double, 3> position{};
  std::array<double, 3> look_at{};  // both in the body's frame, whose z axis is up in the picture
  double fovy = 45;                 // degrees
};

// An infant as a scene usually has it.
struct UsualInfant {
  const char* body;                 // static
  std::vector<std::string> senses;  // by their names; none: the usual ones
  bool muscles;                     // else motors
};

// Shared by copies of a scene; who changes a document changes a copy.
using Document = std::shared_ptr<const pugi::xml_document>;

class Scene {
 public:
  explicit Scene(const Source& source);

  // What fails leaves the scene as it was; so does every other call.
  // Gives a scene without one floor, sky and light. What it says itself of solver and pictures stays.
  void set_room(const std::string& room);

  // Adds the body of an infant ("mitten", "fingers", "mitten-mirrored", ...). Its model names get the prefix; no pose
  // means the scene's own place, and where it names none, on what is below or beside the origin; only motors of the
  // groups act, 0 means the scene's own choice.
  void add_body(const std::string& body, const std::string& prefix, const document::Pose* pose, unsigned groups = 0,
                document::Anchor anchor = document::Anchor::kRoot);
  // The same choice for an infant that the document brings along; 0 leaves its motors as they are.
  void choose_motors(const std::string& prefix, unsigned groups);
  // Gives an infant, also one that the document brings along, another age; the last one counts. Throws what
  // growth::grown throws.
  void grow(const std::string& prefix, const growth::Growth& growth);
  // Names of the infants that the scene is made for, "anna" and "ben"; empty where it names none.
  std::vector<std::string> infants() const;
  // The built-in scene that it started from; empty for others.
  const std::string& built_in() const { return built_in_; }
  // What the <custom> section of its document says; "" and no numbers where it says nothing.
  std::string custom_text(const std::string& name) const;
  std::vector<double> custom_numbers(const std::string& name) const;
  // The defaults of its next infant.
  UsualInfant usual_infant() const;
  // The room's place for it; the origin in a room that names none, near which it is put. Nothing where all places are
  // taken.
  std::optional<document::Pose> free_place() const;
  void add_object(const Object& object);
  void add_model(const Model& model);
  void add_camera(const Camera& camera);

  // Fastens a body; without a pose as they are to each other where the scene starts.
  void weld(const Weld& weld, const document::Pose* pose);
  // Where a hinge or slide starts, and a joint that is held there.
  void start_joint(const std::string& joint, double value);
  void lock_joint(const std::string& joint, double value);

  // Bodies below and including the infant's root, by their names without the prefix.
  std::vector<std::string> body_names(const std::string& prefix) const;

  // Warns about infants that start inside of something, except where a built-in scene has put them.
  void check_places(const engine::ModelPtr& model, const LogSink& log) const;

  // The document for people and other tools; built-in files keep their names, "mimo/textures/floor.png". Both throw
  // what compile throws where bodies are fastened as they start, or an infant has no place. What is composed keeps
  // within the limits; throws Status::kModel else.
  std::string xml() const;
  document::Composition compose() const;
  // The document with all its files, for tools that know nothing of libmimo; throws what xml() and document::package
  // throw.
  document::Package package() const;

 private:
  pugi::xml_document finished() const;
  pugi::xml_document shown() const;
  bool has_name(const char* element, const std::string& name) const;

  document::Library models_;
  document::Limits limits_;
  LogSink log_;
  Document document_;
  std::string built_in_;                         // name of the built-in scene that it started from; empty for others
  std::optional<std::string> unplaced_;          // prefix of the infant without a given place
  std::map<std::string, growth::Growth> grown_;  // by prefix: what of another age is to be made of infants
  std::map<std::string, document::Place> anchored_;  // by prefix: infants whose roots follow from where their soles are
  std::vector<std::string> to_check_;                // prefixes of infants whose places may be taken
  int bodies_ = 0;
  int objects_ = 0;
  std::vector<Weld> start_welds_;  // they follow from all the rest, so they are added last
  // How many infants of a body were added, and what the names of their default classes begin with.
  struct Added {
    int count = 0;
    std::string classes;
  };
  std::map<std::string, Added> added_;  // by bodies
};

// Names of the built-in scenes, rooms and bodies; nullptr past the last.
const char* built_in_scene(std::size_t index);
const char* built_in_room(std::size_t index);

}  // namespace mimo::scene
