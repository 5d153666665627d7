// What belongs to one infant, and how tall it is.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "body/body.h"
#include "support/numbers.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;

TEST(BodyFind, EverythingOfTheMittenBody) {
  const mjModel& model = *benchmark_model();
  const body::Body body = body::find_body(model, "");
  EXPECT_STREQ(engine::name(model, Kind::kBody, body.root), "mimo_location");
  EXPECT_STREQ(engine::name(model, Kind::kBody, body.head), "head");
  EXPECT_STREQ(engine::name(model, Kind::kCamera, body.eye_left), "eye_left");
  EXPECT_STREQ(engine::name(model, Kind::kCamera, body.eye_right), "eye_right");
  EXPECT_EQ(body.bodies.size(), 23u);  // 26 less world, box and ball
  EXPECT_EQ(body.bodies.front(), body.root);
  EXPECT_EQ(body.joints.size(), 47u);
  EXPECT_EQ(body.actuators.size(), 44u);
  EXPECT_EQ(body.torques.size(), 21u);
  ASSERT_TRUE(body.accelerometer && body.gyroscope);
  EXPECT_EQ(body.accelerometer->address, 0);
  EXPECT_EQ(body.gyroscope->address, 3);
  EXPECT_EQ(body.gyroscope->dimension, 3);
  for (const body::Joint& joint : body.joints) {
    EXPECT_EQ(joint.qpos, model.jnt_qposadr[joint.id]);
    EXPECT_EQ(joint.dof, model.jnt_dofadr[joint.id]);
    EXPECT_LT(joint.low, joint.high);
  }
}

// The least that counts as an infant; sensors, cameras and motors may be absent.
std::string infant(const std::string& inside) {
  return "<mujoco><worldbody><body name='mimo_location'><freejoint/><geom size='0.1' mass='2'/><body name='head' "
         "pos='0 0 0.5'>" +
         inside + "</body></body></worldbody></mujoco>";
}

TEST(BodyFind, AcceptsMissingParts) {
  const engine::ModelPtr model = compiled(infant("<geom size='0.1' mass='1'/>"));
  const body::Body body = body::find_body(*model, "");
  EXPECT_TRUE(body.joints.empty() && body.actuators.empty() && body.torques.empty());
  EXPECT_FALSE(body.accelerometer || body.gyroscope);
  EXPECT_EQ(body.eye_left, -1);
  EXPECT_TRUE(close(3, body::mass(*model, body)));
}

TEST(BodyFind, JointsMustBeHinges) {
  const engine::ModelPtr model = compiled(infant("<joint name='robot:neck' type='slide'/><geom size='0.1'/>"));
  expect_error(Status::kModel, "robot:neck is not a hinge", [&] { body::find_body(*model, ""); });
}

TEST(BodyFind, MissingPartsAreNamed) {
  const engine::ModelPtr model =
      compiled("<mujoco><worldbody><body name='mimo_location'><geom size='1'/></body></worldbody></mujoco>");
  expect_error(Status::kNotFound, "no body named \"head\"", [&] { body::find_body(*model, ""); });
  expect_error(Status::kNotFound, "anna/mimo_location", [&] { body::find_body(*model, "anna/"); });
}

// From the sphere's lowest point at -0.1 to the highest point of one geom at 0.5 m.
double height_with(const std::string& geom) {
  engine::Physics physics(compiled(infant(geom)), {});
  return body::height(physics.model(), physics.data(), body::find_body(physics.model(), ""));
}

TEST(BodyHeight, OfEveryShape) {
  const double c = std::cos(mjPI / 6), s = 0.5;  // turned by 30 degrees about y
  const std::string turned = "' euler='0 30 0'/>";
  EXPECT_TRUE(close(0.6 + 0.2, height_with("<geom type='sphere' size='0.2'/>")));
  EXPECT_TRUE(close(0.6 + 0.05 + 0.3 * c, height_with("<geom type='capsule' size='0.05 0.3" + turned)));
  EXPECT_TRUE(close(0.6 + 0.05 * s + 0.3 * c, height_with("<geom type='cylinder' size='0.05 0.3" + turned)));
  EXPECT_TRUE(close(0.6 + 0.1 * s + 0.3 * c, height_with("<geom type='box' size='0.1 0.2 0.3" + turned)));
  EXPECT_TRUE(
      close(0.6 + std::hypot(0.1 * s, 0.3 * c), height_with("<geom type='ellipsoid' size='0.1 0.2 0.3" + turned)));
}

}  // namespace
}  // namespace mimo::test
