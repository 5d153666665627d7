// The left side of an infant beside its right.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "growth/growth.h"
#include "growth/mechanics.h"
#include "support/infants.h"

namespace mimo::test {
namespace {

using Eigen::Vector3d;
using growth::Skeleton;

// Joints of both sides bent by the same random angles, the trunk straight.
growth::Angles same_on_both_sides(const Skeleton& body, unsigned seed) {
  std::mt19937 random(seed);
  growth::Angles angles;
  for (const growth::Bone& bone : body.bones) {
    for (const growth::Joint& joint : bone.joints) {
      if (growth::side_of(joint.name) != "left_") continue;
      const double angle = std::uniform_real_distribution<>(joint.range[0], joint.range[1])(random);
      angles[joint.name] = angle;
      angles["robot:right_" + std::string(growth::plain_name(joint.name))] = angle;
    }
  }
  return angles;
}

// The farthest that a shape on the left is from the mirror image of the same on the right, m, by the name of its bone.
std::map<std::string, double> apart(const Skeleton& body, const growth::Angles& angles) {
  const auto poses = growth::poses(body, angles);
  std::map<std::string, Vector3d> places;
  for (std::size_t i = 0; i < body.bones.size(); ++i) {
    for (const growth::Geom& geom : body.bones[i].geoms) {
      places[geom.name] = poses[i] * growth::pose_of(geom).translation();
    }
  }
  std::map<std::string, double> apart;
  for (const growth::Bone& bone : body.bones) {
    if (growth::side_of(bone.name) != "left_") continue;
    double& most = apart[std::string(growth::without_side(bone.name))];
    for (const growth::Geom& geom : bone.geoms) {
      Vector3d image = places.at("right_" + std::string(growth::without_side(geom.name)));
      image.y() = -image.y();
      most = std::max(most, (places.at(geom.name) - image).norm());
    }
  }
  return apart;
}

TEST(Mirror, LeftIsTheImageOfRight) {
  for (const char* name : {"mitten-mirrored", "fingers-mirrored"}) {
    for (const double age : {0.0, 6.0, 18.0}) {
      const Skeleton body = grown(infant(name), aged(age));
      for (unsigned seed = 0; seed < 5; ++seed) {
        const auto parts = apart(body, same_on_both_sides(body, seed));
        EXPECT_GE(parts.size(), 9u);
        for (const auto& [part, metres] : parts) EXPECT_LT(metres, 1e-12) << name << ", " << part << " at " << age;
      }
    }
  }
}

// The original puts both mitten hands 7 mm off the axis of their forearms, to the same side.
TEST(Mirror, MovesTheOriginalsLeftMittenBy14Millimetres) {
  const Skeleton& body = infant("mitten");
  for (const auto& [part, metres] : apart(body, {})) {
    EXPECT_NEAR(metres, part == "hand" || part == "fingers" ? 0.014 : 0, 1e-12) << part;
  }
}

// The original bends the little finger's first bone about (.571, 0, .821) on the right, whose image is
// (-.571, 0, -.821), and about (-.571, 0, .821) on the left.
TEST(Mirror, MovesTheOriginalsLittleFinger) {
  const Skeleton& body = infant("fingers");
  for (const auto& [part, metres] : apart(body, {})) EXPECT_LT(metres, 1e-12) << part;
  for (const auto& [part, metres] : apart(body, same_on_both_sides(body, 1))) {
    if (part.rfind("lf", 0) == 0) {
      EXPECT_GT(metres, 1e-4) << part;
    } else {
      EXPECT_LT(metres, 1e-12) << part;
    }
  }
}

// Nothing else differs from the original's.
TEST(Mirror, ChangesNothingElse) {
  for (const std::string kind : {"mitten", "fingers"}) {
    const Skeleton &was = infant(kind), &is = infant(kind + "-mirrored");
    ASSERT_EQ(was.bones.size(), is.bones.size());
    EXPECT_EQ(was.motors.size(), is.motors.size());
    int changes = 0;
    for (std::size_t i = 0; i < was.bones.size(); ++i) {
      const growth::Bone &before = was.bones[i], &after = is.bones[i];
      EXPECT_EQ(before.name, after.name);
      changes += before.position != after.position;
      for (std::size_t k = 0; k < before.geoms.size(); ++k) {
        EXPECT_EQ(before.geoms[k].position, after.geoms[k].position);
        EXPECT_EQ(before.geoms[k].mass, after.geoms[k].mass);
      }
      for (std::size_t k = 0; k < before.joints.size(); ++k) {
        const growth::Joint &one = before.joints[k], &other = after.joints[k];
        changes += one.position != other.position || one.axis != other.axis;
        EXPECT_EQ(one.range, other.range);
      }
    }
    EXPECT_EQ(changes, kind == "mitten" ? 2 : 1);
  }
}

// Scenes that are made for one kind of hands take its mirrored body as well.
TEST(Mirror, FitsTheScenesOfTheOriginal) {
  for (const auto& [scene, body] : {std::pair("reach", "mitten-mirrored"), std::pair("catch", "fingers-mirrored")}) {
    scene::Scene with(named(scene));
    with.add_body(body, "", nullptr);
    EXPECT_GT(compile(with)->nbody, 20) << scene;
  }
}

}  // namespace
}  // namespace mimo::test
