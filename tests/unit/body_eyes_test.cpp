// Where the eyes look, and looking at points.
#include <gtest/gtest.h>

#include <cmath>

#include "body/face.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kApart = 0.049;  // of the eyes, m: twice 0.0245 (models/parts/upper_body.xml)

// The infant upright at the origin of its head's parent, every joint at 0.
class Looking : public ::testing::Test {
 protected:
  Looking() : world_(benchmark_world()), eyes_(world_->model(), world_->agents()[0].body) {}

  const mjModel& model() { return world_->model(); }
  const mjData& data() { return world_->data(); }
  Vector3d between_eyes() {
    const int left = id("left_eye"), right = id("right_eye");
    return 0.5 * (at(left) + at(right));
  }
  Vector3d at(int body) { return Eigen::Map<const Vector3d>(data().xpos + 3 * body); }
  int id(const char* body) { return engine::find_or_fail(model(), engine::Kind::kBody, body); }
  double angle(const char* joint) {
    return data().qpos[model().jnt_qposadr[engine::find_or_fail(model(), engine::Kind::kJoint, joint)]];
  }
  body::Look look(const Vector3d& point, bool head) {
    world_->physics().update_poses();
    const body::Look look = eyes_.look_at(model(), data(), point, head);
    for (const body::JointAngle& joint : look.angles) world_->physics().data().qpos[joint.qpos] = joint.angle;
    world_->physics().update_poses();
    return look;
  }
  body::Gaze gaze() { return eyes_.gaze(data()); }

  std::unique_ptr<env::World> world_;
  body::Eyes eyes_;
};

TEST_F(Looking, EyesLookAheadAtRest) {
  const body::Gaze rest = gaze();
  EXPECT_TRUE(rest.left.direction.isApprox(Vector3d(1, 0, 0), 1e-9));
  EXPECT_TRUE(rest.right.direction.isApprox(Vector3d(1, 0, 0), 1e-9));
  EXPECT_NEAR((rest.left.position - rest.right.position).y(), kApart, 1e-9);
  EXPECT_NEAR(rest.vergence, 0, 1e-9);
  EXPECT_FALSE(rest.meets);
}

// By hand: a point straight ahead at distance d needs a vergence of 2 atan(0.0245 / d); d counts from the eyes'
// centres.
TEST_F(Looking, VergenceOfAPointAhead) {
  for (const double d : {0.05, 0.2, 1.0, 10.0}) {
    const Vector3d point = between_eyes() + Vector3d(d, 0, 0);
    const body::Look done = look(point, false);
    EXPECT_NEAR(done.errors[0], 0, 1e-9);
    EXPECT_NEAR(gaze().vergence, 2 * std::atan(0.5 * kApart / d), 1e-9) << d;
    EXPECT_NEAR(angle("robot:left_eye_horizontal"), -std::atan(0.5 * kApart / d), 1e-9);
    EXPECT_NEAR(angle("robot:right_eye_horizontal"), -std::atan(0.5 * kApart / d), 1e-9);  // positive is outwards
    ASSERT_TRUE(gaze().meets);
    EXPECT_TRUE(gaze().point.isApprox(point, 1e-8));
    EXPECT_NEAR(gaze().miss, 0, 1e-9);
  }
}

// Whatever way head and body are turned: the lines of sight go through the point.
TEST_F(Looking, AnyPointInReach) {
  mjData& data = world_->physics().data();
  for (const char* joint : {"robot:head_swivel", "robot:head_tilt_side", "robot:hip_bend1", "robot:hip_rot1"}) {
    data.qpos[model().jnt_qposadr[engine::find_or_fail(model(), engine::Kind::kJoint, joint)]] = 0.2;
  }
  world_->physics().update_poses();
  const int head = id("head");
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> turn(data.xmat + 9 * head);
  int seen = 0;
  for (const double left : {-0.5, -0.1, 0.3, 0.6}) {
    for (const double up : {-0.6, 0.0, 0.4}) {
      const Vector3d point = at(head) + turn * Vector3d(0.5 * std::cos(left), 0.5 * std::sin(left), 0.067 + 0.5 * up);
      const body::Look done = look(point, false);
      if (done.errors[0] > 1e-6 || done.errors[1] > 1e-6) continue;
      ++seen;
      for (const body::Sightline& line : {gaze().left, gaze().right}) {
        EXPECT_NEAR(line.direction.cross(point - line.position).norm(), 0, 1e-8) << left << " " << up;
        EXPECT_GT(line.direction.dot(point - line.position), 0);
      }
      EXPECT_TRUE(gaze().point.isApprox(point, 1e-7));
      EXPECT_NEAR(angle("robot:left_eye_torsional"), 0, 1e-12);
    }
  }
  EXPECT_GE(seen, 8);  // all but those that are too far to the side or too low for one of the eyes
}

// The eyes reach 45 degrees to the sides, 33 up and 47 down; what is farther they miss by the rest.
TEST_F(Looking, StopsAtTheRanges) {
  const Vector3d eye = at(id("left_eye"));
  body::Look done = look(eye + Vector3d(0, 1, 0), false);
  EXPECT_NEAR(angle("robot:left_eye_horizontal"), 45 * kDegree, 1e-9);
  EXPECT_NEAR(done.errors[0], 45 * kDegree, 1e-9);
  done = look(eye + Vector3d(1, 0, 1), false);
  EXPECT_NEAR(angle("robot:left_eye_vertical"), 33 * kDegree, 1e-9);
  EXPECT_NEAR(done.errors[0], 12 * kDegree, 1e-9);
  done = look(eye + Vector3d(1, 0, -3), false);
  EXPECT_NEAR(angle("robot:left_eye_vertical"), -47 * kDegree, 1e-9);
  EXPECT_NEAR(done.errors[0], std::atan(3) - 47 * kDegree, 1e-9);
  // Crossed as far as they go, and beyond.
  done = look(between_eyes() + Vector3d(0.01, 0, 0), false);
  EXPECT_GT(done.errors[0], 0);
  EXPECT_GT(done.errors[1], 0);
}

// With the head the eyes turn to the sides alike, and not up or down.
TEST_F(Looking, TheHeadTurnsFirst) {
  const Vector3d start = between_eyes();
  for (const Vector3d& from : {Vector3d(1, 0.8, 0.5), Vector3d(0.2, -0.3, -0.2), Vector3d(-0.3, 1, 0.1)}) {
    const body::Look done = look(start + from, true);
    EXPECT_EQ(done.angles.size(), 8u);
    EXPECT_NEAR(done.errors[0] + done.errors[1], 0, 1e-9);
    EXPECT_NEAR(angle("robot:left_eye_horizontal"), angle("robot:right_eye_horizontal"), 1e-6);
    EXPECT_NEAR(angle("robot:left_eye_vertical"), 0, 1e-6);
    EXPECT_TRUE(gaze().point.isApprox(start + from, 1e-7));
  }
  // Behind the back: the neck turns by 111 degrees, the eyes by 45 more.
  const body::Look done = look(start + Vector3d(-1, -0.3, 0), true);
  EXPECT_NEAR(angle("robot:head_swivel"), -111 * kDegree, 1e-9);
  EXPECT_GT(done.errors[0], 5 * kDegree);
}

// Lines that lead apart meet nowhere.
TEST_F(Looking, DivergingEyes) {
  mjData& data = world_->physics().data();
  for (const char* joint : {"robot:left_eye_horizontal", "robot:right_eye_horizontal"}) {
    data.qpos[model().jnt_qposadr[engine::find_or_fail(model(), engine::Kind::kJoint, joint)]] = 0.1;
  }
  world_->physics().update_poses();
  EXPECT_NEAR(gaze().vergence, -0.2, 1e-9);
  EXPECT_FALSE(gaze().meets);
}

}  // namespace
}  // namespace mimo::test
