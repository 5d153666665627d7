#include "scene/growing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "base/fail.h"
#include "base/names.h"
#include "base/numbers.h"
#include "document/names.h"
#include "document/xml.h"
#include "growth/growth.h"
#include "growth/mechanics.h"
#include "scene/anatomy.h"
#include "scene/recipe.h"

namespace mimo::scene {
namespace {

// The first `count` numbers of an attribute; the rest stays.
void scale(pugi::xml_node node, const char* name, double factor, std::size_t count = 3) {
  std::vector<double> values = document::numbers(node.attribute(name));
  if (values.empty()) return;
  for (std::size_t i = 0; i < std::min(count, values.size()); ++i) values[i] *= factor;
  document::set(node, name, Span<const double>(values));
}

// A fastening to the world says where, seen from the infant's part.
void scale_fastenings(pugi::xml_node root, const std::string& prefix, double factor) {
  const pugi::xml_node infant = document::find_named(root, "body", prefix + names::kRootBody);
  for (const pugi::xml_node section : root.children("equality")) {
    for (const pugi::xml_node weld : section.children("weld")) {
      const bool own = !document::find_named(infant, "body", weld.attribute("body1").value()).empty();
      if (own && weld.attribute("body2").empty()) scale(weld, "relpose", factor);
    }
  }
}

void scale_all(pugi::xml_node body, double factor) {
  document::walk(body, [&](pugi::xml_node node) {
    for (const char* length : {"pos", "size", "fromto"}) scale(node, length, factor, 6);
  });
}

using growth::Skeleton;

void say(pugi::xml_node root, const std::string& name, const std::vector<double>& values) {
  const pugi::xml_node numeric = document::append(document::section(root, "custom"), "numeric");
  document::set(numeric, "name", name);
  document::set(numeric, "data", Span<const double>(values));
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
growth::Angles starting_angles(pugi::xml_node root, const Skeleton& skeleton, const std::string& prefix) {
  const auto joints = joints_of(skeleton, prefix);
  growth::Angles angles;
  for (const pugi::xml_node section : root.children("custom")) {
    for (const pugi::xml_node tuple : section.children("tuple")) {
      for (const pugi::xml_node entry : tuple.children("element")) {
        const auto joint = joints.find(entry.attribute("objname").value());
        const std::vector<double> value = document::numbers(entry.attribute("prm"));
        if (joint != joints.end() && !value.empty()) angles[joint->second->name] = value[0];
      }
    }
  }
  return angles;
}

double within(const growth::Joint& joint, double angle) { return std::clamp(angle, joint.range[0], joint.range[1]); }

// By how much a joint may have to miss its stored pose at an age; infinitely where the recipe does not care.
double pose_slack(pugi::xml_node root, const std::string& prefix) {
  const std::vector<double> slack = custom_numbers(root, prefix + names::kPoseSlack);
  return slack.size() == 1 ? slack[0] : std::numeric_limits<double>::infinity();
}

// Stored poses and locks bend no joint further than it goes at that age.
void clamp_poses(pugi::xml_node root, const Skeleton& skeleton, const std::string& prefix, double age) {
  const auto joints = joints_of(skeleton, prefix);
  const double slack = pose_slack(root, prefix);
  const auto clamp = [&](pugi::xml_node node, const char* names_joint, const char* holds_angle) {
    const auto joint = joints.find(node.attribute(names_joint).value());
    std::vector<double> values = document::numbers(node.attribute(holds_angle));
    if (joint == joints.end() || values.empty()) return;
    const double angle = within(*joint->second, values[0]);
    if (angle == values[0]) return;
    if (std::abs(values[0] - angle) > slack) {
      fail(Status::kUnsupported,
           "age is {} months, at which the scene's pose is impossible: {} is to start at {:.0f} degrees, and goes from "
           "{:.0f} to {:.0f}",
           age, joint->first, values[0] / kDegree, joint->second->range[0] / kDegree,
           joint->second->range[1] / kDegree);
    }
    values[0] = angle;
    document::set(node, holds_angle, Span<const double>(values));
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

// An infant as it starts: its root in the world, and the angles of its joints.
struct Start {
  Skeleton body;
  growth::Angles angles;

  growth::Vector place_of(const std::string& name) const {
    const auto poses = growth::poses(body, angles);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const auto at = poses[i].translation();
      if (body.bones[i].name == name) return {at.x(), at.y(), at.z()};
    }
    fail(Status::kModel, "{}: the infant has no body \"{}\"", names::kWithArm, name);
  }
};

// With its root where the document has it.
Start start_of(pugi::xml_node root, const std::string& prefix, Skeleton body) {
  growth::Angles angles = starting_angles(root, body, prefix);
  growth::Bone& first = body.bones.front();
  const pugi::xml_node node = document::find_named(root, "body", prefix + names::kRootBody);
  std::vector<double> pose = custom_numbers(root, prefix + names::kRootPose);
  if (pose.size() != 7) {
    pose = document::numbers(node.attribute("pos"));
    pose.resize(3);
    pose.insert(pose.end(), first.orientation.begin(), first.orientation.end());
  }
  std::copy_n(pose.begin(), 3, first.position.begin());
  std::copy_n(pose.begin() + 3, 4, first.orientation.begin());
  return {std::move(body), std::move(angles)};
}

void raise(pugi::xml_node node, const char* attribute, double up) {
  std::vector<double> place = document::numbers(node.attribute(attribute));
  place.resize(std::max<std::size_t>(place.size(), 3));
  place[2] += up;
  document::set(node, attribute, Span<const double>(place));
}

// Moves the root so that the lowest point stays where it was: it stands on its feet and lies on its back as before.
void keep_lowest(pugi::xml_node root, const std::string& prefix, const Start& was, const Start& is) {
  const double up = growth::lowest_point(was.body, was.angles) - growth::lowest_point(is.body, is.angles);
  raise(document::find_named(root, "body", prefix + names::kRootBody), "pos", up);
  const pugi::xml_node stored = document::find_named(root, "numeric", prefix + names::kRootPose);
  if (custom_numbers(root, prefix + names::kRootPose).size() == 7) raise(stored, "data", up);
}

const growth::Bone& bone_of(const Skeleton& skeleton, const std::string& name) {
  for (const growth::Bone& bone : skeleton.bones) {
    if (bone.name == name) return bone;
  }
  fail(Status::kUnsupported, "the infant has no body \"{}\", so it cannot grow", name);
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

// The limits of each hinge.
std::vector<double> ranges_of(const Skeleton& skeleton) {
  std::vector<double> limits;
  for (const growth::Bone& bone : skeleton.bones) {
    for (const growth::Joint& joint : bone.joints) limits.insert(limits.end(), joint.range.begin(), joint.range.end());
  }
  return limits;
}

// How large it is against the body of 18 months.
struct Factors {
  double stature, arm;
};

// Says in the document what tasks, muscles and skin have to know of it.
void tell(pugi::xml_node root, const std::string& prefix, const Skeleton& born, const Skeleton& grown,
          const Factors& factors, const growth::Growth& growth) {
  say(root, prefix + names::kGrowth, {growth.age, factors.stature, factors.arm});
  if (ranges_of(grown) != ranges_of(born)) say(root, prefix + names::kBornRanges, ranges_of(born));
  if (growth.keep_spacing) return;
  say(root, prefix + names::kBornSizes, of_geoms(born, &growth::Geom::size));
  say(root, prefix + names::kBornPlaces, of_geoms(born, &growth::Geom::position));
}

}  // namespace

void fit_to_stature(pugi::xml_node root, const std::string& prefix, double stature) {
  const std::vector<std::string> built = custom_words(root, prefix + names::kWithStature);
  if (built.empty()) return;
  for (const std::string& name : built) {
    scale_all(document::find_named(root, "body", prefix + name), stature);
    scale(document::find_named(root, "spatial", prefix + name), "range", stature, 2);
  }
  scale_fastenings(root, prefix, stature);
  scale(document::find_named(root, "body", prefix + names::kRootBody), "pos", stature, 2);
  scale(document::find_named(root, "numeric", prefix + names::kRootPose), "data", stature, 2);
}

void fit_to_arm(pugi::xml_node root, const std::string& prefix, double arm, const Reference& reference) {
  const std::vector<std::string> pairs = custom_words(root, prefix + names::kWithArm);
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    pugi::xml_node body = document::find_named(root, "body", prefix + pairs[i]);
    std::vector<double> place = document::numbers(body.attribute("pos"));
    if (place.size() != 3) continue;  // taken away, or moved by its owner in another way
    const auto was = reference.was(pairs[i + 1]), is = reference.is(pairs[i + 1]);
    for (std::size_t axis = 0; axis < 3; ++axis) place[axis] = is[axis] + arm * (place[axis] - was[axis]);
    document::set(body, "pos", Span<const double>(place));
  }
}

void grow(pugi::xml_node root, const std::string& prefix, const growth::Growth& growth) {
  Anatomy anatomy(root, prefix);
  const Skeleton born = anatomy.skeleton();
  const Skeleton grown = growth::grown(born, growth);
  const Start was = start_of(root, prefix, born);
  if (!anatomy.write(grown)) return;
  const Factors factors{growth::stature(grown) / growth::stature(born), arm_length(grown) / arm_length(born)};
  clamp_poses(root, grown, prefix, growth.age);
  fit_to_stature(root, prefix, factors.stature);
  keep_lowest(root, prefix, was, start_of(root, prefix, grown));
  const Start is = start_of(root, prefix, grown);
  fit_to_arm(root, prefix, factors.arm,
             {[&](const std::string& name) { return was.place_of(name); },
              [&](const std::string& name) { return is.place_of(name); }});
  tell(root, prefix, born, grown, factors, growth);
}

}  // namespace mimo::scene
