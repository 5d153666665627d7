#include "scene/joints.h"

#include <array>
#include <cmath>

#include "base/angle.h"
#include "base/choice.h"
#include "base/fail.h"
#include "base/names.h"
#include "document/compiler.h"
#include "document/defaults.h"
#include "document/names.h"
#include "document/xml.h"
#include "scene/equalities.h"

namespace mimo::scene {
namespace {

std::string text_of(pugi::xml_attribute attribute) { return attribute.value(); }

bool is_pose(const std::string& tuple) {
  const std::string ending = std::string("/") + names::kPose;
  return tuple == names::kPose ||
         (tuple.size() > ending.size() && tuple.compare(tuple.size() - ending.size(), ending.size(), ending) == 0);
}

// What the document says about a hinge or slide, in SI units.
class Joint {
 public:
  Joint(pugi::xml_node root, const std::string& name) : root_(root), defaults_(root) {
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

void start_joint(pugi::xml_node root, const std::string& joint, double value) {
  Joint(root, joint).require_in_range(value);
  document::set(stored_or_new(root, joint), "prm", Span<const double>(&value, 1));
}

void lock_joint(pugi::xml_node root, const std::string& joint, double value) {
  start_joint(root, joint, value);
  const double offset = value - Joint(root, joint).reference();
  const std::array<double, 5> line{offset, 1, 0, 0, 0};
  const pugi::xml_node lock = lock_of(root, joint);
  document::set(lock, "active", "true");
  document::set(lock, "polycoef", Span<const double>(line));
}

}  // namespace mimo::scene
