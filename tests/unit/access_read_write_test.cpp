// Named access: every quantity against the numbers it stands for, and forces against Newton.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <limits>

#include "support/access.h"
#include "support/numbers.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using access::Kind;
using access::Quantity;

constexpr double kStep = 0.005;

class EnvAccess : public ::testing::Test {
 protected:
  EnvAccess() : world_(benchmark_model(), {}, {}), physics_(world_.physics()) {}

  const mjModel& model() const { return physics_.model(); }
  int id(Kind kind, const char* name) const { return id_of(world_, kind, name); }
  std::size_t width(Quantity quantity, const Ids& ids) const {
    return access::width(world_, quantity, access::Ids(Span<const std::int32_t>(ids)));
  }
  Values get(Quantity quantity, const Ids& ids, bool now = false) { return test::get(world_, quantity, ids, now); }
  void set(Quantity quantity, const Ids& ids, const Values& values) { test::set(world_, quantity, ids, values); }
  Ids all(Kind kind) const {
    Ids ids(static_cast<std::size_t>(access::count(world_, kind)));
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int32_t>(i);
    return ids;
  }

  env::World world_;
  engine::Physics& physics_;
};

// 3 free joints and 47 hinges, 26 bodies, 39 geoms, 23 sites, 2 cameras, 44 motors, 69 sensor values.
TEST_F(EnvAccess, WidthsOfEverything) {
  struct Known {
    Quantity quantity;
    Kind kind;
    std::size_t width;
  };
  const Known known[] = {
      {Quantity::kJointPosition, Kind::kJoint, 3 * 7 + 47}, {Quantity::kJointVelocity, Kind::kJoint, 3 * 6 + 47},
      {Quantity::kJointForce, Kind::kJoint, 3 * 6 + 47},    {Quantity::kJointAcceleration, Kind::kJoint, 3 * 6 + 47},
      {Quantity::kJointRange, Kind::kJoint, 50 * 2},        {Quantity::kBodyPosition, Kind::kBody, 26 * 3},
      {Quantity::kBodyOrientation, Kind::kBody, 26 * 4},    {Quantity::kBodyVelocity, Kind::kBody, 26 * 6},
      {Quantity::kBodyForce, Kind::kBody, 26 * 6},          {Quantity::kBodyMass, Kind::kBody, 26},
      {Quantity::kBodyCenterOfMass, Kind::kBody, 26 * 3},   {Quantity::kGeomPosition, Kind::kGeom, 39 * 3},
      {Quantity::kGeomOrientation, Kind::kGeom, 39 * 4},    {Quantity::kGeomSize, Kind::kGeom, 39 * 3},
      {Quantity::kSitePosition, Kind::kSite, 23 * 3},       {Quantity::kSiteOrientation, Kind::kSite, 23 * 4},
      {Quantity::kCameraPosition, Kind::kCamera, 2 * 3},    {Quantity::kCameraOrientation, Kind::kCamera, 2 * 4},
      {Quantity::kActuatorControl, Kind::kActuator, 44},    {Quantity::kActuatorForce, Kind::kActuator, 44},
      {Quantity::kSensorValue, Kind::kSensor, 69}};
  for (const Known& entry : known) {
    EXPECT_EQ(access::traits(entry.quantity).kind(), entry.kind);
    EXPECT_EQ(width(entry.quantity, all(entry.kind)), entry.width) << access::traits(entry.quantity).name;
    EXPECT_EQ(width(entry.quantity, Ids{}), 0u);
  }
}

TEST_F(EnvAccess, ReadsWhatMuJoCoHolds) {
  physics_.data().ctrl[0] = 0.5;
  physics_.step(60);
  const mjModel& m = model();
  const mjData& d = physics_.data();
  EXPECT_EQ(get(Quantity::kJointPosition, all(Kind::kJoint)), copy(d.qpos, m.nq));
  EXPECT_EQ(get(Quantity::kJointVelocity, all(Kind::kJoint)), copy(d.qvel, m.nv));
  EXPECT_EQ(get(Quantity::kJointAcceleration, all(Kind::kJoint)), copy(d.qacc, m.nv));
  EXPECT_EQ(get(Quantity::kBodyPosition, all(Kind::kBody)), copy(d.xpos, 3 * m.nbody));
  EXPECT_EQ(get(Quantity::kBodyOrientation, all(Kind::kBody)), copy(d.xquat, 4 * m.nbody));
  EXPECT_EQ(get(Quantity::kBodyMass, all(Kind::kBody)), copy(m.body_mass, m.nbody));
  EXPECT_EQ(get(Quantity::kBodyCenterOfMass, all(Kind::kBody)), copy(d.xipos, 3 * m.nbody));
  EXPECT_EQ(get(Quantity::kGeomPosition, all(Kind::kGeom)), copy(d.geom_xpos, 3 * m.ngeom));
  EXPECT_EQ(get(Quantity::kGeomSize, all(Kind::kGeom)), copy(m.geom_size, 3 * m.ngeom));
  EXPECT_EQ(get(Quantity::kSitePosition, all(Kind::kSite)), copy(d.site_xpos, 3 * m.nsite));
  EXPECT_EQ(get(Quantity::kCameraPosition, all(Kind::kCamera)), copy(d.cam_xpos, 3 * m.ncam));
  EXPECT_EQ(get(Quantity::kActuatorControl, all(Kind::kActuator)), copy(d.ctrl, m.nu));
  EXPECT_EQ(get(Quantity::kActuatorForce, all(Kind::kActuator)), copy(d.actuator_force, m.nu));
  EXPECT_EQ(get(Quantity::kSensorValue, all(Kind::kSensor)), copy(d.sensordata, m.nsensordata));
  // Any order, any number.
  const int knee = id(Kind::kJoint, "robot:left_knee"), root = id(Kind::kJoint, "mimo_orientation");
  const Values mixed = get(Quantity::kJointPosition, {knee, root, knee});
  ASSERT_EQ(mixed.size(), 9u);
  EXPECT_EQ(mixed[0], d.qpos[m.jnt_qposadr[knee]]);
  EXPECT_EQ(mixed[8], mixed[0]);
  EXPECT_EQ(Values(mixed.begin() + 1, mixed.end() - 1), copy(d.qpos + m.jnt_qposadr[root], 7));
}

// Orientations turn the same way as MuJoCo's matrices.
TEST_F(EnvAccess, Orientations) {
  physics_.step(60);
  const auto expect = [&](Quantity quantity, Kind kind, const double* matrices) {
    for (const int element : all(kind)) {
      const Values quat = get(quantity, {element});
      double matrix[9];
      mju_quat2Mat(matrix, quat.data());
      EXPECT_TRUE(close(copy(matrices + 9 * element, 9), matrix, {1e-9, 1e-12})) << element;
    }
  };
  expect(Quantity::kGeomOrientation, Kind::kGeom, physics_.data().geom_xmat);
  expect(Quantity::kSiteOrientation, Kind::kSite, physics_.data().site_xmat);
  expect(Quantity::kCameraOrientation, Kind::kCamera, physics_.data().cam_xmat);
}

TEST_F(EnvAccess, Ranges) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(get(Quantity::kJointRange, {id(Kind::kJoint, "mimo_orientation")}), (Values{-infinity, infinity}));
  const Values knee = get(Quantity::kJointRange, {id(Kind::kJoint, "robot:left_knee")});
  EXPECT_TRUE(close({-145 * mjPI / 180, 4 * mjPI / 180}, knee.data()));
}

// The velocity of a body's origin: a ball 0.1 m in radius that turns about its own centre and flies.
TEST_F(EnvAccess, BodyVelocityIsLinearThenAngular) {
  const int ball = id(Kind::kBody, "test_object2");
  const Values velocity = {1, 2, 3, 0.5, -0.25, 4};  // at rest orientation the body's frame is the world's
  set(Quantity::kJointVelocity, {model().body_jntadr[ball]}, velocity);
  physics_.forward();
  EXPECT_TRUE(close(velocity, get(Quantity::kBodyVelocity, {ball}).data()));
}

TEST_F(EnvAccess, WrittenIsRead) {
  const int knee = id(Kind::kJoint, "robot:left_knee"), ball = id(Kind::kBody, "test_object2");
  const Ids joints = {knee, model().body_jntadr[ball]};
  const Values places = {-0.5, 1, 2, 3, 0.5, 0.5, -0.5, 0.5};
  set(Quantity::kJointPosition, joints, places);
  EXPECT_EQ(get(Quantity::kJointPosition, joints), places);
  set(Quantity::kJointPosition, {joints[1]}, {1, 2, 3, 0, 0, -4, 3});
  EXPECT_EQ(get(Quantity::kJointPosition, {joints[1]}), (Values{1, 2, 3, 0, 0, -0.8, 0.6})) << "normalised";
  const Values seven = {1, 2, 3, 4, 5, 6, 7};
  set(Quantity::kJointVelocity, joints, seven);
  EXPECT_EQ(get(Quantity::kJointVelocity, joints), seven);
  set(Quantity::kJointForce, joints, seven);
  EXPECT_EQ(get(Quantity::kJointForce, joints), seven);
  set(Quantity::kBodyForce, {ball}, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(get(Quantity::kBodyForce, {ball}), (Values{1, 2, 3, 4, 5, 6}));
  set(Quantity::kActuatorControl, {3, 1}, {0.25, -0.75});
  EXPECT_EQ(get(Quantity::kActuatorControl, {1, 3}), (Values{-0.75, 0.25}));
}

TEST_F(EnvAccess, MovingABallByItsBody) {
  const int ball = id(Kind::kBody, "test_object2"), geom = model().body_geomadr[ball];
  const int joint = model().body_jntadr[ball];
  set(Quantity::kJointVelocity, {joint}, {0, 0, 1, 0, 0, 0});
  set(Quantity::kBodyPosition, {ball}, {0.5, -0.25, 2});
  EXPECT_EQ(get(Quantity::kBodyPosition, {ball}), (Values{0.5, -0.25, 2}));
  EXPECT_EQ(get(Quantity::kGeomPosition, {geom}), (Values{0.5, -0.25, 2})) << "poses follow at once";
  EXPECT_EQ(get(Quantity::kJointVelocity, {joint}), (Values{0, 0, 1, 0, 0, 0})) << "velocities stay";
  set(Quantity::kBodyOrientation, {ball}, {0, 0, 0, 2});
  EXPECT_EQ(get(Quantity::kBodyOrientation, {ball}), (Values{0, 0, 0, 1})) << "normalised";
  physics_.step(1);
  physics_.update_poses();
  const double speed = 1 - 9.81 * kStep;
  EXPECT_TRUE(close(2 + speed * kStep, get(Quantity::kBodyPosition, {ball})[2]));
}

// Setting what is there already leaves the trajectory to the bit.
TEST_F(EnvAccess, LookingAndRewritingLeaveTheTrajectory) {
  engine::Physics plain(benchmark_model(), {});
  for (int step = 0; step < 120; ++step) {
    plain.step(1);
    physics_.step(1);
    get(Quantity::kBodyVelocity, all(Kind::kBody));
    physics_.update_poses();
    set(Quantity::kJointVelocity, all(Kind::kJoint), get(Quantity::kJointVelocity, all(Kind::kJoint)));
    ASSERT_EQ(copy(physics_.data().qpos, model().nq), copy(plain.data().qpos, model().nq)) << step;
  }
}

// Without gravity and contacts, from rest: v = F / m t for the force, w = T / I t for the torque.
TEST_F(EnvAccess, ForcesMoveAsNewtonSays) {
  env::EnvOptions floating;
  floating.physics.gravity = floating.physics.contacts = false;
  env::World world(benchmark_model(), {}, floating);
  engine::Physics& physics = world.physics();
  const std::int32_t box = id_of(world, Kind::kBody, "test_object1");
  const double mass = 8, inertia = 8.0 / 12 * (0.2 * 0.2 + 0.2 * 0.2);  // a cube of 0.2 m
  test::set(world, Quantity::kBodyForce, Ids{box}, Values{2, -4, 8, 0, 0, 0.5});
  physics.step(10);
  const double t = 10 * kStep;
  const Ids joint = {model().body_jntadr[box]};
  Values velocity = test::get(world, Quantity::kJointVelocity, joint);
  EXPECT_TRUE(close({2 / mass * t, -4 / mass * t, 8 / mass * t, 0, 0, 0.5 / inertia * t}, velocity.data()));
  // Until changed, and no longer than until a reset: taken away, it flies on. The same by the joint's own generalised
  // force.
  test::set(world, Quantity::kBodyForce, Ids{box}, Values(6, 0));
  test::set(world, Quantity::kJointForce, joint, Values{0, 8, 0, 0, 0, 0});
  physics.step(10);
  velocity = test::get(world, Quantity::kJointVelocity, joint);
  EXPECT_TRUE(close({2 / mass * t, 4 / mass * t, 8 / mass * t, 0, 0, 0.5 / inertia * t}, velocity.data()));
  physics.reset();
  EXPECT_EQ(test::get(world, Quantity::kJointForce, joint), Values(6, 0)) << "reset takes forces away";
}

TEST_F(EnvAccess, Refusals) {
  const int ball = id(Kind::kBody, "test_object2"), hand = id(Kind::kBody, "left_hand");
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Values before = copy(physics_.data().qpos, model().nq);
  const auto refuse = [&](const char* part, Quantity quantity, const Ids& ids, const Values& values) {
    expect_error(Status::kInvalidArgument, part, [&] { set(quantity, ids, values); });
  };
  refuse("\"left_hand\") cannot be moved", Quantity::kBodyPosition, {ball, hand}, {1, 1, 1, 1, 1, 1});
  refuse("\"world\") cannot be moved", Quantity::kBodyOrientation, {0}, {1, 0, 0, 0});
  refuse("values[1] is nan", Quantity::kBodyPosition, {ball}, {1, nan, 1});
  refuse("values[2] is inf", Quantity::kBodyPosition, {ball}, {1, 1, infinity});
  refuse("quaternion", Quantity::kBodyOrientation, {ball}, {0, 0, 0, 0});
  refuse("quaternion", Quantity::kJointPosition, {model().body_jntadr[ball]}, {9, 9, 9, 0, 0, 0, 0});
  refuse("MIMO_BODY_VELOCITY, which can only be read", Quantity::kBodyVelocity, {ball}, {1, 1, 1, 1, 1, 1});
  refuse("MIMO_SENSOR_VALUE, which can only be read", Quantity::kSensorValue, {0}, {1, 1, 1});
  EXPECT_EQ(copy(physics_.data().qpos, model().nq), before) << "nothing was written";
  expect_error(Status::kInvalidArgument, "ids[1] is 26, expected a body id from 0 to 25", [&] {
    width(Quantity::kBodyMass, Ids{0, 26});
  });
  expect_error(Status::kInvalidArgument, "ids[0] is -1", [&] { width(Quantity::kJointPosition, Ids{-1}); });
}

// A pose is a position and an orientation.
TEST_F(EnvAccess, Poses) {
  physics_.step(60);
  const auto expect = [&](Kind kind, Quantity pose, Quantity position, Quantity orientation) {
    for (const int element : all(kind)) {
      Values expected = get(position, {element});
      const Values turn = get(orientation, {element});
      expected.insert(expected.end(), turn.begin(), turn.end());
      EXPECT_EQ(get(pose, {element}), expected) << element;
    }
  };
  expect(Kind::kBody, Quantity::kBodyPose, Quantity::kBodyPosition, Quantity::kBodyOrientation);
  expect(Kind::kGeom, Quantity::kGeomPose, Quantity::kGeomPosition, Quantity::kGeomOrientation);
  expect(Kind::kSite, Quantity::kSitePose, Quantity::kSitePosition, Quantity::kSiteOrientation);
  expect(Kind::kCamera, Quantity::kCameraPose, Quantity::kCameraPosition, Quantity::kCameraOrientation);
  const int ball = id(Kind::kBody, "test_object2");
  set(Quantity::kBodyPose, {ball}, {1, 2, 3, 0, 0, 3, 4});
  EXPECT_EQ(get(Quantity::kBodyPose, {ball}), (Values{1, 2, 3, 0, 0, 0.6, 0.8}));
}

// Of now: what an update would give, while the values of the last step and the trajectory stay. A falling ball tells
// the two apart: its last step started where it was one step ago.
TEST_F(EnvAccess, NowIsAfterTheStep) {
  env::World twin(benchmark_model(), {}, {});
  const int ball = id(Kind::kBody, "test_object2");
  set(Quantity::kBodyPosition, {ball}, {3, 3, 5});
  test::set(twin, Quantity::kBodyPosition, {ball}, {3, 3, 5});
  for (int step = 0; step < 20; ++step) {
    physics_.step(1);
    twin.physics().step(1);
    const Values last = get(Quantity::kBodyPosition, all(Kind::kBody));
    const Values now = get(Quantity::kBodyPosition, all(Kind::kBody), true);
    const Values velocity = get(Quantity::kBodyVelocity, {ball}, true);
    EXPECT_EQ(last, test::get(twin, Quantity::kBodyPosition, all(Kind::kBody))) << "nothing is changed by asking";
    EXPECT_EQ(get(Quantity::kBodyPosition, all(Kind::kBody)), last);
    const double speed = -9.81 * kStep * (step + 1);
    EXPECT_TRUE(close(now[3 * ball + 2] - last[3 * ball + 2], speed * kStep, {1e-6, 1e-12}));
    EXPECT_TRUE(close(speed, velocity[2], {1e-9, 1e-12}));
    EXPECT_TRUE(close(speed + 9.81 * kStep, get(Quantity::kBodyVelocity, {ball})[2], {1e-9, 1e-12}));
    ASSERT_EQ(copy(physics_.data().qpos, model().nq), copy(twin.data().qpos, model().nq)) << step;
    engine::Physics moved(benchmark_model(), {});
    std::copy_n(physics_.data().qpos, model().nq, moved.data().qpos);
    moved.update_poses();
    EXPECT_EQ(now, copy(moved.data().xpos, 3 * model().nbody));
  }
  EXPECT_EQ(get(Quantity::kJointPosition, {0}, true), get(Quantity::kJointPosition, {0})) << "always current";
  expect_error(Status::kInvalidArgument, "MIMO_JOINT_ACCELERATION, which physics steps compute",
               [&] { get(Quantity::kJointAcceleration, {0}, true); });
}

// Finite, but far beyond what the simulation takes: refused by the next step, not by a crash.
TEST_F(EnvAccess, AbsurdPositionsFailTheWorld) {
  const int ball = id(Kind::kBody, "test_object2");
  set(Quantity::kBodyPosition, {ball}, {1e200, 0, 0});
  expect_error(Status::kSimulation, "QPOS", [&] { physics_.step(1); });
  expect_error(Status::kSimulation, "reset", [&] { set(Quantity::kBodyPosition, {ball}, {0, 0, 1}); });
  physics_.reset();
  physics_.step(1);
}

// A ball at rest carries its weight: along the contact's normal, which points from geom 1 to geom 2.
TEST(EnvContacts, BallAtRestCarriesItsWeight) {
  env::World world(
      compiled(
          "<mujoco><option timestep='0.005'/><worldbody><geom name='floor' type='plane' size='1 1 .1'/>"
          "<body name='ball' pos='0 0 0.05'><freejoint/><geom size='0.05' mass='0.3'/></body></worldbody></mujoco>"),
      {}, {});
  world.physics().step(2000);
  ASSERT_EQ(access::count(world, Kind::kContact), 1);
  EXPECT_EQ(get(world, Quantity::kContactGeoms), (Values{0, 1}));
  EXPECT_EQ(get(world, Quantity::kContactBodies), (Values{0, 1}));
  EXPECT_TRUE(close({0, 0, 1}, get(world, Quantity::kContactFrame).data(), {0, 1e-9})) << "up, from floor to ball";
  EXPECT_NEAR(get(world, Quantity::kContactPosition)[2], 0, 1e-3);
  EXPECT_LT(get(world, Quantity::kContactDistance)[0], 0);
  EXPECT_TRUE(close({0.3 * 9.81, 0, 0}, get(world, Quantity::kContactForce).data(), {1e-6, 1e-6})) << "on the ball";
  EXPECT_TRUE(close({0, 0, 0}, get(world, Quantity::kContactTorque).data(), {0, 1e-6}));
}

}  // namespace
}  // namespace mimo::test
