// What infants of all ages touch, and what they must not.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <random>
#include <set>

#include "engine/physics.h"
#include "growth/growth.h"
#include "growth/mechanics.h"
#include "growth/skeleton.h"
#include "support/infants.h"

namespace mimo::test {
namespace {

using Eigen::Vector3d;
using growth::Skeleton;

const std::vector<double> kAges = {0, 1, 3, 6, 9, 12, 18, 24};

class GrowthReach : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Bodies, GrowthReach, ::testing::Values("mitten", "fingers"));

using Pairs = std::set<std::pair<std::string, std::string>>;

// Geoms that lie in each other, high above the floor with all joints at 0.
Pairs overlaps(const std::string& body, const growth::Growth& growth) {
  scene::Scene scene(named("benchmark"));
  scene.add_body(body, "", nullptr);
  scene.grow("", growth);
  const engine::ModelPtr model = compile(scene);
  engine::Physics physics(model, {});
  mju_copy(physics.data().qpos, model->qpos0, model->nq);
  const int root = engine::find_or_fail(*model, engine::Kind::kJoint, "mimo_orientation");
  physics.data().qpos[model->jnt_qposadr[root] + 2] = 5;
  physics.update_contacts();
  Pairs pairs;
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    if (contact.dist >= 0) continue;
    const std::string one = engine::name(*model, engine::Kind::kGeom, contact.geom1);
    const std::string two = engine::name(*model, engine::Kind::kGeom, contact.geom2);
    if (one != "floor" && two != "floor") pairs.insert({one, two});
  }
  return pairs;
}

TEST_P(GrowthReach, NothingOverlapsThatDidNotBefore) {
  const Pairs before = overlaps(GetParam(), {});
  for (const double age : kAges) {
    for (const double z : {-2.0, 0.0, 2.0}) {
      growth::Growth growth = aged(age);
      growth.z_weight = z;
      for (const auto& pair : overlaps(GetParam(), growth)) {
        EXPECT_TRUE(before.count(pair)) << pair.first << " and " << pair.second << " at " << age << ", z " << z;
      }
    }
  }
}

// Looks for angles of an arm that bring the palm to a point, by steps of one joint after the other from random starts.
class Search {
 public:
  Search(const Skeleton& body, const std::string& geom) : body_(body) {
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
      const growth::Bone& bone = body.bones[i];
      for (const growth::Joint& joint : bone.joints) {
        if (growth::side_of(joint.name) == "left_" && is_of_arm(joint)) joints_.push_back(joint);
      }
      for (const growth::Geom& it : bone.geoms) {
        if (it.name == geom) hand_ = i, palm_ = growth::pose_of(it).translation();
      }
    }
  }

  double nearest(const Vector3d& target) const {
    std::mt19937 random(1);
    double best = 1;
    for (int start = 0; start < 12; ++start) best = std::min(best, descend(target, random));
    return best;
  }

 private:
  static bool is_of_arm(const growth::Joint& joint) {
    const std::string name(growth::plain_name(joint.name));
    return name.rfind("shoulder", 0) == 0 || name == "elbow" || name.rfind("hand", 0) == 0;
  }

  double distance(const growth::Angles& angles, const Vector3d& target) const {
    return (growth::poses(body_, angles)[hand_] * palm_ - target).norm();
  }

  double descend(const Vector3d& target, std::mt19937& random) const {
    growth::Angles angles;
    for (const growth::Joint& joint : joints_) {
      angles[joint.name] = std::uniform_real_distribution<>(joint.range[0], joint.range[1])(random);
    }
    double best = distance(angles, target);
    double step = 0.5;
    while (step > 0.005) {
      const double before = best;
      for (const growth::Joint& joint : joints_) best = std::min(best, improve(angles, joint, step, target, best));
      if (best == before) step /= 2;
    }
    return best;
  }

  double improve(growth::Angles& angles, const growth::Joint& joint, double step, const Vector3d& target,
                 double best) const {
    for (const double change : {step, -step}) {
      growth::Angles tried = angles;
      tried[joint.name] = std::clamp(tried[joint.name] + change, joint.range[0], joint.range[1]);
      const double now = distance(tried, target);
      if (now >= best) continue;
      angles = tried;
      return now;
    }
    return best;
  }

  const Skeleton& body_;
  std::vector<growth::Joint> joints_;
  std::size_t hand_ = 0;
  Vector3d palm_;
};

// On the face, 40 degrees below its middle.
Vector3d mouth(const Skeleton& body) {
  const growth::Geom& head = growth::geom(body, "head");
  const double radius = head.size[0];
  for (std::size_t i = 0; i < body.bones.size(); ++i) {
    if (body.bones[i].name != "head") continue;
    return growth::poses(body, {})[i] * (growth::pose_of(head).translation() + radius * Vector3d(0.766, 0, -0.643));
  }
  return {};
}

// Before the breastbone, half an arm away: where two hands meet.
Vector3d before_chest(const Skeleton& body) {
  for (std::size_t i = 0; i < body.bones.size(); ++i) {
    if (body.bones[i].name != "upper_body") continue;
    const double arm = growth::bone(body, "left_lower_arm").position[2] + growth::bone(body, "left_hand").position[2];
    const double high = growth::geom(body, "ub2").position[2];
    return growth::poses(body, {})[i] * Vector3d(arm / 2 + growth::geom(body, "ub2").size[0] / 2, 0, high);
  }
  return {};
}

// Newborns do put their hands to their mouths.
TEST_P(GrowthReach, HandsReachTheMouthAndEachOtherAtEveryAge) {
  for (const double age : kAges) {
    const Skeleton body = grown(infant(GetParam()), aged(age));
    const growth::Geom& palm = growth::geom(body, "left_hand1");
    const Search search(body, "left_hand1");
    EXPECT_LT(search.nearest(mouth(body)), palm.size[2]) << age;
    EXPECT_LT(search.nearest(before_chest(body)), palm.size[2] / 2) << age;
  }
}

}  // namespace
}  // namespace mimo::test
