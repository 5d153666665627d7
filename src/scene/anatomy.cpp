#include "scene/anatomy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"
#include "base/numbers.h"
#include "document/compiler.h"
#include "document/defaults.h"
#include "document/names.h"
#include "document/xml.h"
#include "scene/attachments.h"

namespace mimo::scene {
namespace {

using growth::Geom;
using growth::GeomShape;
using growth::Joint;
using growth::Motor;

constexpr const char* kEyeCamera = "eye_";  // how the names of an infant's own cameras begin

GeomShape shape_named(const std::string& type, const std::string& geom) {
  if (type.empty() || type == "sphere") return GeomShape::kSphere;
  if (type == "capsule") return GeomShape::kCapsule;
  if (type == "cylinder") return GeomShape::kCylinder;
  if (type == "box") return GeomShape::kBox;
  fail(Status::kUnsupported, "geom \"{}\" is a {}; an infant that grows has spheres, capsules, cylinders and boxes",
       geom, type);
}

std::size_t size_count(GeomShape shape) {
  switch (shape) {
    case GeomShape::kSphere: return 1;
    case GeomShape::kCapsule:
    case GeomShape::kCylinder: return 2;
    case GeomShape::kBox: return 3;
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

struct Named {
  const char* name;
  unsigned group;
};

constexpr std::array<Named, 11> kGroups = {{{"trunk", kTrunk},
                                            {"head", kHead},
                                            {"eyes", kEyes},
                                            {"right_arm", kRightArm},
                                            {"left_arm", kLeftArm},
                                            {"right_hand", kRightHand},
                                            {"left_hand", kLeftHand},
                                            {"right_leg", kRightLeg},
                                            {"left_leg", kLeftLeg},
                                            {"right_foot", kRightFoot},
                                            {"left_foot", kLeftFoot}}};

// How the names of motors begin, without "act:". The first that fits counts; a hip with a side is a leg's.
constexpr std::array<Named, 18> kMotors = {{{"hip_", kTrunk},
                                            {"head_", kHead},
                                            {"right_eye_", kEyes},
                                            {"left_eye_", kEyes},
                                            {"right_shoulder_", kRightArm},
                                            {"right_elbow", kRightArm},
                                            {"left_shoulder_", kLeftArm},
                                            {"left_elbow", kLeftArm},
                                            {"right_hip_", kRightLeg},
                                            {"right_knee", kRightLeg},
                                            {"left_hip_", kLeftLeg},
                                            {"left_knee", kLeftLeg},
                                            {"right_foot_", kRightFoot},
                                            {"left_foot_", kLeftFoot},
                                            {"right_toes", kRightFoot},
                                            {"left_toes", kLeftFoot},
                                            {"right_big_toe", kRightFoot},
                                            {"left_big_toe", kLeftFoot}}};

std::string text_of(pugi::xml_attribute attribute) { return attribute.value(); }

bool is_pose(const std::string& tuple) {
  const std::string ending = std::string("/") + names::kPose;
  return tuple == names::kPose ||
         (tuple.size() > ending.size() && tuple.compare(tuple.size() - ending.size(), ending.size(), ending) == 0);
}

// What the document says about a hinge or slide, in SI units.
class HeldJoint {
 public:
  HeldJoint(pugi::xml_node root, const std::string& name) : root_(root), defaults_(root) {
    for (const pugi::xml_node world : root.children("worldbody")) {
      if (node_.empty()) node_ = document::find_named(world, "joint", name);
    }
    if (node_.empty())
      fail(Status::kNotFound, "no joint named \"{}\"; {}", name, choice_of(name, document::names_of(root, {"joint"})));
    const std::string type = text_of(defaults_.find(node_, "type"));
    slides_ = type == "slide";
    require(type.empty() || slides_ || type == "hinge", "joint \"{}\" is of type {}, expected a hinge or slide", name,
            type);
  }

  double reference() const {
    const std::vector<double> given = document::numbers(defaults_.find(node_, "ref"));
    return given.empty() ? 0 : given[0] * unit();
  }

  void require_in_range(double value) const {
    const char* what = slides_ ? "metres" : "radians";
    const std::string name = text_of(node_.attribute("name"));
    require(std::isfinite(value), "value of joint \"{}\" is {}, expected {}", name, value, what);
    const std::vector<double> range = document::numbers(defaults_.find(node_, "range"));
    if (!limited() || range.size() != 2) return;
    const double low = range[0] * unit(), high = range[1] * unit();
    require(value >= low && value <= high, "value of joint \"{}\" is {}, expected {:.6g} to {:.6g} {}", name, value,
            low, high, what);
  }

 private:
  double unit() const { return slides_ || document::in_radians(root_) ? 1 : kDegree; }
  bool limited() const {
    const std::string said = text_of(defaults_.find(node_, "limited"));
    return said == "true" || (said != "false" && document::infers_limits(root_));
  }

  pugi::xml_node root_, node_;
  document::Defaults defaults_;
  bool slides_ = false;
};

// Where a stored pose says something about a joint; empty if none does.
pugi::xml_node stored(pugi::xml_node root, const std::string& joint) {
  for (const pugi::xml_node custom : root.children("custom")) {
    for (const pugi::xml_node tuple : custom.children("tuple")) {
      if (!is_pose(text_of(tuple.attribute("name")))) continue;
      const pugi::xml_node found = tuple.find_child_by_attribute("element", "objname", joint.c_str());
      if (!found.empty()) return found;
    }
  }
  return {};
}

pugi::xml_node stored_or_new(pugi::xml_node root, const std::string& joint) {
  const pugi::xml_node there = stored(root, joint);
  if (!there.empty()) return there;
  pugi::xml_node tuple;
  for (const pugi::xml_node custom : root.children("custom")) {
    if (tuple.empty()) tuple = custom.find_child_by_attribute("tuple", "name", names::kPose);
  }
  if (tuple.empty())
    document::set(tuple = document::append(document::section(root, "custom"), "tuple"), "name", names::kPose);
  const pugi::xml_node entry = document::append(tuple, "element");
  document::set(entry, "objtype", "joint");
  document::set(entry, "objname", joint);
  return entry;
}

// The equality that can hold a joint; a new one if there is none. An infant's joints have theirs.
pugi::xml_node lock_of(pugi::xml_node root, const std::string& joint) {
  for (const pugi::xml_node equalities : root.children("equality")) {
    for (const pugi::xml_node equality : equalities.children("joint")) {
      if (joint == text_of(equality.attribute("joint1")) && !equality.attribute("joint2")) return equality;
    }
  }
  const pugi::xml_node lock = add_equality(root, "joint");
  document::set(lock, "joint1", joint);
  return lock;
}

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
    if (document::is(node, "site") || (document::is(node, "camera") && begins_with(own_name(node), kEyeCamera)))
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
  if (body.empty()) fail(Status::kNotFound, "no body \"{}\", so there is no infant to grow", name);
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

unsigned group_of(const std::string& motor) {
  if (!begins_with(motor, names::kMotor)) return 0;
  const std::string name = motor.substr(std::string(names::kMotor).size());
  for (const Named& entry : kMotors) {
    if (begins_with(name, entry.name)) return entry.group;
  }
  // What is left are wrists and fingers, of which a hand may have many.
  if (begins_with(name, "right_")) return kRightHand;
  return begins_with(name, "left_") ? static_cast<unsigned>(kLeftHand) : 0u;
}

unsigned group_named(const std::string& word) {
  for (const Named& entry : kGroups) {
    if (word == entry.name) return entry.group;
  }
  return 0;
}

unsigned groups_from(const std::string& words) {
  std::istringstream stream(words);
  unsigned groups = 0;
  for (std::string word; stream >> word;) {
    const unsigned group = group_named(word);
    if (group == 0) fail(Status::kModel, "{}: \"{}\" is not a part of the infant", names::kActs, word);
    groups |= group;
  }
  return groups;
}

void start_joint(pugi::xml_node root, const std::string& joint, double value) {
  HeldJoint(root, joint).require_in_range(value);
  document::set(stored_or_new(root, joint), "prm", Span<const double>(&value, 1));
}

void lock_joint(pugi::xml_node root, const std::string& joint, double value) {
  start_joint(root, joint, value);
  const double offset = value - HeldJoint(root, joint).reference();
  const std::array<double, 5> line{offset, 1, 0, 0, 0};
  const pugi::xml_node lock = lock_of(root, joint);
  document::set(lock, "active", "true");
  document::set(lock, "polycoef", Span<const double>(line));
}

}  // namespace mimo::scene
