#include "scene/anatomy.h"

#include <algorithm>

#include "base/angle.h"
#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"
#include "document/compiler.h"
#include "document/defaults.h"
#include "document/names.h"
#include "document/xml.h"

namespace mimo::scene {
namespace {

using growth::Geom;
using growth::Joint;
using growth::Motor;
using growth::Shape;

constexpr const char* kEyes = "eye_";  // how the names of an infant's own cameras begin

Shape shape_named(const std::string& type, const std::string& geom) {
  if (type.empty() || type == "sphere") return Shape::kSphere;
  if (type == "capsule") return Shape::kCapsule;
  if (type == "cylinder") return Shape::kCylinder;
  if (type == "box") return Shape::kBox;
  fail(Status::kUnsupported, "geom \"{}\" is a {}; an infant that grows has spheres, capsules, cylinders and boxes",
       geom, type);
}

std::size_t size_count(Shape shape) {
  switch (shape) {
    case Shape::kSphere: return 1;
    case Shape::kCapsule:
    case Shape::kCylinder: return 2;
    case Shape::kBox: return 3;
  }
  return 0;
}

// Writes attributes whose numbers have changed.
class Writer {
 public:
  explicit Writer(double unit) : unit_(unit) {}

  void write(pugi::xml_node node, const growth::Bone& is, const growth::Bone& was) {
    put(node, "pos", is.position, was.position);
  }

  void write(pugi::xml_node node, const Geom& is, const Geom& was) {
    put(node, "size", is.size, was.size, size_count(is.shape));
    put(node, "pos", is.position, was.position);
    put(node, "mass", is.mass, was.mass);
  }

  void write(pugi::xml_node node, const Joint& is, const Joint& was) {
    put(node, "pos", is.position, was.position);
    put(node, "range", in_units(is.range), in_units(was.range));
    put(node, "springref", is.springref / unit_, was.springref / unit_);
    put(node, "stiffness", is.stiffness, was.stiffness);
    put(node, "damping", is.damping, was.damping);
    put(node, "frictionloss", is.frictionloss, was.frictionloss);
    put(node, "armature", is.armature, was.armature);
  }

  void write(pugi::xml_node node, const growth::Mark& is, const growth::Mark& was) {
    put(node, "pos", is.position, was.position);
  }

  void write(pugi::xml_node node, const Motor& is, const Motor& was) {
    put(node, "gear", is.gear, was.gear);
    put(node, "user", is.muscle, was.muscle);
  }

  template <typename Parts>
  void write(const std::vector<pugi::xml_node>& nodes, std::size_t& next, const Parts& are, const Parts& were) {
    for (std::size_t i = 0; i < are.size(); ++i) write(nodes[next++], are[i], were[i]);
  }

  bool wrote() const { return wrote_; }

 private:
  std::array<double, 2> in_units(const std::array<double, 2>& range) const {
    return {range[0] / unit_, range[1] / unit_};
  }

  template <std::size_t N>
  void put(pugi::xml_node node, const char* name, const std::array<double, N>& is, const std::array<double, N>& was,
           std::size_t count = N) {
    if (is == was) return;
    document::set(node, name, Span<const double>(is.data(), count));
    wrote_ = true;
  }

  void put(pugi::xml_node node, const char* name, double is, double was) {
    put(node, name, std::array<double, 1>{is}, std::array<double, 1>{was});
  }

  double unit_;
  bool wrote_ = false;
};

}  // namespace

struct Anatomy::Reader {
  Anatomy& to;
  const std::string& prefix;
  document::Defaults defaults;
  double unit;

  template <std::size_t N>
  void take(pugi::xml_node node, const char* name, std::array<double, N>& values) const {
    const std::vector<double> given = document::numbers(defaults.find(node, name));
    std::copy_n(given.begin(), std::min(given.size(), N), values.begin());
  }

  void take(pugi::xml_node node, const char* name, double& value) const {
    const std::vector<double> given = document::numbers(defaults.find(node, name));
    if (!given.empty()) value = given[0];
  }

  std::string own_name(pugi::xml_node node) const {
    const std::string name = node.attribute("name").value();
    return begins_with(name, prefix) ? name.substr(prefix.size()) : std::string();
  }

  void read_body(pugi::xml_node node, int parent) {
    const int number = static_cast<int>(to.skeleton_.bones.size());
    growth::Bone& bone = to.skeleton_.bones.emplace_back();
    to.bones_.push_back(node);
    bone.name = own_name(node);
    bone.parent = parent;
    take(node, "pos", bone.position);
    take(node, "quat", bone.orientation);
    for (const pugi::xml_node part : node.children()) read_part(part);
    for (const pugi::xml_node child : node.children("body")) read_body(child, number);
  }

  void read_part(pugi::xml_node node) {
    if (document::is(node, "geom")) read_geom(node);
    if (document::is(node, "joint")) read_joint(node);
    if (document::is(node, "site") || (document::is(node, "camera") && begins_with(own_name(node), kEyes)))
      read_mark(node);
  }

  void read_geom(pugi::xml_node node) {
    Geom geom;
    geom.name = own_name(node);
    geom.shape = shape_named(defaults.find(node, "type").value(), geom.name);
    take(node, "size", geom.size);
    take(node, "pos", geom.position);
    take(node, "quat", geom.orientation);
    take(node, "mass", geom.mass);
    to.skeleton_.bones.back().geoms.push_back(geom);
    to.geoms_.push_back(node);
  }

  void read_joint(pugi::xml_node node) {
    const std::string type = defaults.find(node, "type").value();
    if (!type.empty() && type != "hinge") return;
    Joint joint;
    joint.name = own_name(node);
    take(node, "axis", joint.axis);
    take(node, "pos", joint.position);
    take(node, "range", joint.range);
    take(node, "springref", joint.springref);
    for (double* angle : {&joint.range[0], &joint.range[1], &joint.springref}) *angle *= unit;
    take(node, "stiffness", joint.stiffness);
    take(node, "damping", joint.damping);
    take(node, "frictionloss", joint.frictionloss);
    take(node, "armature", joint.armature);
    to.skeleton_.bones.back().joints.push_back(joint);
    to.joints_.push_back(node);
  }

  void read_mark(pugi::xml_node node) {
    growth::Mark mark;
    mark.name = own_name(node);
    take(node, "pos", mark.position);
    to.skeleton_.bones.back().marks.push_back(mark);
    to.marks_.push_back(node);
  }

  void read_motors() {
    for (const pugi::xml_node section : to.root_.children("actuator")) {
      for (const pugi::xml_node node : section.children("motor")) {
        if (own_name(node).empty()) continue;
        Motor motor;
        motor.name = own_name(node);
        const std::string joint = node.attribute("joint").value();
        motor.joint = begins_with(joint, prefix) ? joint.substr(prefix.size()) : joint;
        take(node, "gear", motor.gear);
        take(node, "user", motor.muscle);
        to.skeleton_.motors.push_back(motor);
        to.motors_.push_back(node);
      }
    }
  }
};

Anatomy::Anatomy(pugi::xml_node root, const std::string& prefix) : root_(root) {
  const std::string name = prefix + names::kRootBody;
  const pugi::xml_node body = document::find_named(root, "body", name);
  if (body.empty()) fail(Status::kNotFound, "no body \"{}\", so there is no infant that could grow", name);
  Reader reader{*this, prefix, document::Defaults(root), document::in_radians(root) ? 1 : kDegree};
  reader.read_body(body, -1);
  reader.read_motors();
}

bool Anatomy::write(const growth::Skeleton& changed) {
  Writer writer(document::in_radians(root_) ? 1 : kDegree);
  std::size_t bone = 0, geom = 0, joint = 0, mark = 0, motor = 0;
  writer.write(bones_, bone, changed.bones, skeleton_.bones);
  for (std::size_t i = 0; i < changed.bones.size(); ++i) {
    const growth::Bone &is = changed.bones[i], &was = skeleton_.bones[i];
    writer.write(geoms_, geom, is.geoms, was.geoms);
    writer.write(joints_, joint, is.joints, was.joints);
    writer.write(marks_, mark, is.marks, was.marks);
  }
  writer.write(motors_, motor, changed.motors, skeleton_.motors);
  skeleton_ = changed;
  return writer.wrote();
}

}  // namespace mimo::scene
