#include "scene/growing.h"

#include <algorithm>
#include <map>

#include "base/fail.h"
#include "format/names.h"
#include "growth/grow.h"
#include "growth/kinematics.h"
#include "growth/measures.h"
#include "scene/anatomy.h"
#include "scene/pose.h"
#include "scene/xml.h"

namespace mimo::scene {
namespace {

using growth::Skeleton;

pugi::xml_node custom(pugi::xml_node root, const char* element, const std::string& name) {
  for (const pugi::xml_node section : root.children("custom")) {
    const pugi::xml_node found = section.find_child_by_attribute(element, "name", name.c_str());
    if (!found.empty()) return found;
  }
  return {};
}

void say(pugi::xml_node root, const std::string& name, const std::vector<double>& values) {
  const pugi::xml_node numeric = append(section(root, "custom"), "numeric");
  set(numeric, "name", name);
  set(numeric, "data", Span<const double>(values));
}

// Joints of the infant by their names in the document.
std::map<std::string, const growth::Joint*> joints_of(const Skeleton& skeleton, const std::string& prefix) {
  std::map<std::string, const growth::Joint*> joints;
  for (const growth::Bone& bone : skeleton.bones) {
    for (const growth::Joint& joint : bone.joints) joints[prefix + joint.name] = &joint;
  }
  return joints;
}

// Angles in which the infant starts, from all stored poses, by the joints' names without a prefix.
std::map<std::string, double> starting_angles(pugi::xml_node root, const Skeleton& skeleton,
                                              const std::string& prefix) {
  const auto joints = joints_of(skeleton, prefix);
  std::map<std::string, double> angles;
  for (const pugi::xml_node section : root.children("custom")) {
    for (const pugi::xml_node tuple : section.children("tuple")) {
      for (const pugi::xml_node entry : tuple.children("element")) {
        const auto joint = joints.find(entry.attribute("objname").value());
        const std::vector<double> value = numbers(entry.attribute("prm"));
        if (joint != joints.end() && !value.empty()) angles[joint->second->name] = value[0];
      }
    }
  }
  return angles;
}

double within(const growth::Joint& joint, double angle) { return std::clamp(angle, joint.range[0], joint.range[1]); }

// Stored poses and locks bend no joint further than it goes at that age.
void clamp_poses(pugi::xml_node root, const Skeleton& skeleton, const std::string& prefix) {
  const auto joints = joints_of(skeleton, prefix);
  const auto clamp = [&](pugi::xml_node node, const char* names_joint, const char* holds_angle) {
    const auto joint = joints.find(node.attribute(names_joint).value());
    std::vector<double> values = numbers(node.attribute(holds_angle));
    if (joint == joints.end() || values.empty()) return;
    const double angle = within(*joint->second, values[0]);
    if (angle == values[0]) return;
    values[0] = angle;
    set(node, holds_angle, Span<const double>(values));
  };
  for (const pugi::xml_node section : root.children("custom")) {
    for (const pugi::xml_node tuple : section.children("tuple")) {
      for (const pugi::xml_node entry : tuple.children("element")) clamp(entry, "objname", "prm");
    }
  }
  for (const pugi::xml_node section : root.children("equality")) {
    for (const pugi::xml_node lock : section.children("joint")) {
      if (lock.attribute("joint2").empty()) clamp(lock, "joint1", "polycoef");
    }
  }
}

// Height of the lowest point of a body in a pose over its root.
double lowest(Skeleton body, const Quaternion& orientation, const std::map<std::string, double>& angles) {
  body.bones.front().position = {0, 0, 0};
  body.bones.front().orientation = orientation;
  return growth::lowest_point(body, angles);
}

// An infant and where it starts.
struct Start {
  const Skeleton& body;
  std::map<std::string, double> angles;
};

// Moves the root so that the lowest point stays where it was: it stands on its feet and lies on its back as before.
void keep_lowest(pugi::xml_node root, pugi::xml_node body, const std::string& prefix, const Start& was,
                 const Start& is) {
  const std::vector<double> turned = numbers(body.attribute("quat"));
  Quaternion orientation{1, 0, 0, 0};
  if (turned.size() == 4) std::copy(turned.begin(), turned.end(), orientation.begin());
  const pugi::xml_node stored = custom(root, "numeric", prefix + names::kRootPose);
  std::vector<double> pose = numbers(stored.attribute("data"));
  if (pose.size() == 7) std::copy(pose.begin() + 3, pose.end(), orientation.begin());
  const double up = lowest(was.body, orientation, was.angles) - lowest(is.body, orientation, is.angles);
  std::vector<double> position = numbers(body.attribute("pos"));
  position.resize(3);
  position[2] += up;
  set(body, "pos", Span<const double>(position));
  if (pose.size() != 7) return;
  pose[2] += up;
  set(stored, "data", Span<const double>(pose));
}

const growth::Bone& bone_of(const Skeleton& skeleton, const std::string& name) {
  for (const growth::Bone& bone : skeleton.bones) {
    if (bone.name == name) return bone;
  }
  fail(Status::kUnsupported, "the infant has no body \"{}\", so it is none that grows", name);
}

// From the shoulder to the wrist.
double arm_length(const Skeleton& skeleton) {
  return bone_of(skeleton, "right_lower_arm").position[2] + bone_of(skeleton, "right_hand").position[2];
}

// Three numbers of each geom.
std::vector<double> of_geoms(const Skeleton& skeleton, growth::Vector growth::Geom::*what) {
  std::vector<double> numbers;
  for (const growth::Bone& bone : skeleton.bones) {
    for (const growth::Geom& geom : bone.geoms) {
      numbers.insert(numbers.end(), (geom.*what).begin(), (geom.*what).end());
    }
  }
  return numbers;
}

// Says in the document what tasks and skin have to know of it.
void tell(pugi::xml_node root, const std::string& prefix, const Skeleton& born, const Skeleton& grown,
          const growth::Growth& growth) {
  say(root, prefix + names::kGrowth,
      {growth.age, growth::stature(grown) / growth::stature(born), arm_length(grown) / arm_length(born)});
  if (growth.keep_spacing) return;
  say(root, prefix + names::kBornSizes, of_geoms(born, &growth::Geom::size));
  say(root, prefix + names::kBornPlaces, of_geoms(born, &growth::Geom::position));
}

}  // namespace

void grow(pugi::xml_node root, const std::string& prefix, const growth::Growth& growth) {
  Anatomy anatomy(root, prefix);
  const Skeleton born = anatomy.skeleton();
  const Skeleton grown = growth::grown(born, growth);
  const Start was{born, starting_angles(root, born, prefix)};
  if (!anatomy.write(grown)) return;
  clamp_poses(root, grown, prefix);
  keep_lowest(root, anatomy.root_body(), prefix, was, {grown, starting_angles(root, grown, prefix)});
  tell(root, prefix, born, grown, growth);
}

}  // namespace mimo::scene
