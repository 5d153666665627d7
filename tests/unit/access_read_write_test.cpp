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

constexpr double kStep = 0.005;

class EnvAccess : public ::testing::Test {
 protected:
  EnvAccess() : world_(benchmark_model(), {}, {}), physics_(world_.physics()) {}

  const mjModel& model() const { return physics_.model(); }
  int id(mimo_kind kind, const char* name) const { return id_of(world_, kind, name); }
  std::size_t width(mimo_quantity quantity, const Ids& ids) const {
    return access::width(world_, access::quantity_of(quantity), access::Ids(Span<const std::int32_t>(ids)));
  }
  Values get(mimo_quantity quantity, const Ids& ids, bool now = false) { return test::get(world_, quantity, ids, now); }
  void set(mimo_quantity quantity, const Ids& ids, const Values& values) { test::set(world_, quantity, ids, values); }
  Ids all(mimo_kind kind) const {
    Ids ids(static_cast<std::size_t>(access::kind_of(kind).count(world_)));
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int32_t>(i);
    return ids;
  }

  env::World world_;
  engine::Physics& physics_;
};

// 3 free joints and 47 hinges, 26 bodies, 39 geoms, 23 sites, 2 cameras, 44 motors, 69 sensor values.
TEST_F(EnvAccess, WidthsOfEverything) {
  struct Known {
    mimo_quantity quantity;
    mimo_kind kind;
    std::size_t width;
  };
  const Known known[] = {
      {MIMO_JOINT_POSITION, MIMO_JOINT, 3 * 7 + 47}, {MIMO_JOINT_VELOCITY, MIMO_JOINT, 3 * 6 + 47},
      {MIMO_JOINT_FORCE, MIMO_JOINT, 3 * 6 + 47},    {MIMO_JOINT_ACCELERATION, MIMO_JOINT, 3 * 6 + 47},
      {MIMO_JOINT_RANGE, MIMO_JOINT, 50 * 2},        {MIMO_BODY_POSITION, MIMO_BODY, 26 * 3},
      {MIMO_BODY_ORIENTATION, MIMO_BODY, 26 * 4},    {MIMO_BODY_VELOCITY, MIMO_BODY, 26 * 6},
      {MIMO_BODY_FORCE, MIMO_BODY, 26 * 6},          {MIMO_BODY_MASS, MIMO_BODY, 26},
      {MIMO_BODY_CENTER_OF_MASS, MIMO_BODY, 26 * 3}, {MIMO_GEOM_POSITION, MIMO_GEOM, 39 * 3},
      {MIMO_GEOM_ORIENTATION, MIMO_GEOM, 39 * 4},    {MIMO_GEOM_SIZE, MIMO_GEOM, 39 * 3},
      {MIMO_SITE_POSITION, MIMO_SITE, 23 * 3},       {MIMO_SITE_ORIENTATION, MIMO_SITE, 23 * 4},
      {MIMO_CAMERA_POSITION, MIMO_CAMERA, 2 * 3},    {MIMO_CAMERA_ORIENTATION, MIMO_CAMERA, 2 * 4},
      {MIMO_ACTUATOR_CONTROL, MIMO_ACTUATOR, 44},    {MIMO_ACTUATOR_FORCE, MIMO_ACTUATOR, 44},
      {MIMO_SENSOR_VALUE, MIMO_SENSOR, 69}};
  for (const Known& entry : known) {
    const access::Quantity& quantity = access::quantity_of(entry.quantity);
    EXPECT_EQ(quantity.kind().number, entry.kind);
    EXPECT_EQ(width(entry.quantity, all(entry.kind)), entry.width) << quantity.constant;
    EXPECT_EQ(width(entry.quantity, Ids{}), 0u);
  }
}

TEST_F(EnvAccess, ReadsWhatMuJoCoHolds) {
  physics_.data().ctrl[0] = 0.5;
  physics_.step(60);
  const mjModel& m = model();
  const mjData& d = physics_.data();
  EXPECT_EQ(get(MIMO_JOINT_POSITION, all(MIMO_JOINT)), copy(d.qpos, m.nq));
  EXPECT_EQ(get(MIMO_JOINT_VELOCITY, all(MIMO_JOINT)), copy(d.qvel, m.nv));
  EXPECT_EQ(get(MIMO_JOINT_ACCELERATION, all(MIMO_JOINT)), copy(d.qacc, m.nv));
  EXPECT_EQ(get(MIMO_BODY_POSITION, all(MIMO_BODY)), copy(d.xpos, 3 * m.nbody));
  EXPECT_EQ(get(MIMO_BODY_ORIENTATION, all(MIMO_BODY)), copy(d.xquat, 4 * m.nbody));
  EXPECT_EQ(get(MIMO_BODY_MASS, all(MIMO_BODY)), copy(m.body_mass, m.nbody));
  EXPECT_EQ(get(MIMO_BODY_CENTER_OF_MASS, all(MIMO_BODY)), copy(d.xipos, 3 * m.nbody));
  EXPECT_EQ(get(MIMO_GEOM_POSITION, all(MIMO_GEOM)), copy(d.geom_xpos, 3 * m.ngeom));
  EXPECT_EQ(get(MIMO_GEOM_SIZE, all(MIMO_GEOM)), copy(m.geom_size, 3 * m.ngeom));
  EXPECT_EQ(get(MIMO_SITE_POSITION, all(MIMO_SITE)), copy(d.site_xpos, 3 * m.nsite));
  EXPECT_EQ(get(MIMO_CAMERA_POSITION, all(MIMO_CAMERA)), copy(d.cam_xpos, 3 * m.ncam));
  EXPECT_EQ(get(MIMO_ACTUATOR_CONTROL, all(MIMO_ACTUATOR)), copy(d.ctrl, m.nu));
  EXPECT_EQ(get(MIMO_ACTUATOR_FORCE, all(MIMO_ACTUATOR)), copy(d.actuator_force, m.nu));
  EXPECT_EQ(get(MIMO_SENSOR_VALUE, all(MIMO_SENSOR)), copy(d.sensordata, m.nsensordata));
  // Any order, any number.
  const int knee = id(MIMO_JOINT, "robot:left_knee"), root = id(MIMO_JOINT, "mimo_orientation");
  const Values mixed = get(MIMO_JOINT_POSITION, {knee, root, knee});
  ASSERT_EQ(mixed.size(), 9u);
  EXPECT_EQ(mixed[0], d.qpos[m.jnt_qposadr[knee]]);
  EXPECT_EQ(mixed[8], mixed[0]);
  EXPECT_EQ(Values(mixed.begin() + 1, mixed.end() - 1), copy(d.qpos + m.jnt_qposadr[root], 7));
}

// Orientations turn the same way as MuJoCo's matrices.
TEST_F(EnvAccess, Orientations) {
  physics_.step(60);
  const auto expect = [&](mimo_quantity quantity, mimo_kind kind, const double* matrices) {
    for (const int element : all(kind)) {
      const Values quat = get(quantity, {element});
      double matrix[9];
      mju_quat2Mat(matrix, quat.data());
      EXPECT_TRUE(close(copy(matrices + 9 * element, 9), matrix, {1e-9, 1e-12})) << element;
    }
  };
  expect(MIMO_GEOM_ORIENTATION, MIMO_GEOM, physics_.data().geom_xmat);
  expect(MIMO_SITE_ORIENTATION, MIMO_SITE, physics_.data().site_xmat);
  expect(MIMO_CAMERA_ORIENTATION, MIMO_CAMERA, physics_.data().cam_xmat);
}

TEST_F(EnvAccess, Ranges) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(get(MIMO_JOINT_RANGE, {id(MIMO_JOINT, "mimo_orientation")}), (Values{-infinity, infinity}));
  const Values knee = get(MIMO_JOINT_RANGE, {id(MIMO_JOINT, "robot:left_knee")});
  EXPECT_TRUE(close({-145 * mjPI / 180, 4 * mjPI / 180}, knee.data()));
}

// The velocity of a body's origin: a ball 0.1 m in radius that turns about its own centre and flies.
TEST_F(EnvAccess, BodyVelocityIsLinearThenAngular) {
  const int ball = id(MIMO_BODY, "test_object2");
  const Values velocity = {1, 2, 3, 0.5, -0.25, 4};  // at rest orientation the body's frame is the world's
  set(MIMO_JOINT_VELOCITY, {model().body_jntadr[ball]}, velocity);
  physics_.forward();
  EXPECT_TRUE(close(velocity, get(MIMO_BODY_VELOCITY, {ball}).data()));
}

TEST_F(EnvAccess, ReadsWhatWasWritten) {
  const int knee = id(MIMO_JOINT, "robot:left_knee"), ball = id(MIMO_BODY, "test_object2");
  const Ids joints = {knee, model().body_jntadr[ball]};
  const Values places = {-0.5, 1, 2, 3, 0.5, 0.5, -0.5, 0.5};
  set(MIMO_JOINT_POSITION, joints, places);
  EXPECT_EQ(get(MIMO_JOINT_POSITION, joints), places);
  set(MIMO_JOINT_POSITION, {joints[1]}, {1, 2, 3, 0, 0, -4, 3});
  EXPECT_EQ(get(MIMO_JOINT_POSITION, {joints[1]}), (Values{1, 2, 3, 0, 0, -0.8, 0.6})) << "normalised";
  const Values seven = {1, 2, 3, 4, 5, 6, 7};
  set(MIMO_JOINT_VELOCITY, joints, seven);
  EXPECT_EQ(get(MIMO_JOINT_VELOCITY, joints), seven);
  set(MIMO_JOINT_FORCE, joints, seven);
  EXPECT_EQ(get(MIMO_JOINT_FORCE, joints), seven);
  set(MIMO_BODY_FORCE, {ball}, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(get(MIMO_BODY_FORCE, {ball}), (Values{1, 2, 3, 4, 5, 6}));
  set(MIMO_ACTUATOR_CONTROL, {3, 1}, {0.25, -0.75});
  EXPECT_EQ(get(MIMO_ACTUATOR_CONTROL, {1, 3}), (Values{-0.75, 0.25}));
}

TEST_F(EnvAccess, MovingABallByItsBody) {
  const int ball = id(MIMO_BODY, "test_object2"), geom = model().body_geomadr[ball];
  const int joint = model().body_jntadr[ball];
  set(MIMO_JOINT_VELOCITY, {joint}, {0, 0, 1, 0, 0, 0});
  set(MIMO_BODY_POSITION, {ball}, {0.5, -0.25, 2});
  EXPECT_EQ(get(MIMO_BODY_POSITION, {ball}), (Values{0.5, -0.25, 2}));
  EXPECT_EQ(get(MIMO_GEOM_POSITION, {geom}), (Values{0.5, -0.25, 2})) << "poses follow at once";
  EXPECT_EQ(get(MIMO_JOINT_VELOCITY, {joint}), (Values{0, 0, 1, 0, 0, 0})) << "velocities stay";
  set(MIMO_BODY_ORIENTATION, {ball}, {0, 0, 0, 2});
  EXPECT_EQ(get(MIMO_BODY_ORIENTATION, {ball}), (Values{0, 0, 0, 1})) << "normalised";
  physics_.step(1);
  physics_.update_poses();
  const double speed = 1 - 9.81 * kStep;
  EXPECT_TRUE(close(2 + speed * kStep, get(MIMO_BODY_POSITION, {ball})[2]));
}

// Setting what is there already leaves the trajectory to the bit.
TEST_F(EnvAccess, ReadingAndRewritingKeepTheTrajectory) {
  engine::Physics plain(benchmark_model(), {});
  for (int step = 0; step < 120; ++step) {
    plain.step(1);
    physics_.step(1);
    get(MIMO_BODY_VELOCITY, all(MIMO_BODY));
    physics_.update_poses();
    set(MIMO_JOINT_VELOCITY, all(MIMO_JOINT), get(MIMO_JOINT_VELOCITY, all(MIMO_JOINT)));
    ASSERT_EQ(copy(physics_.data().qpos, model().nq), copy(plain.data().qpos, model().nq)) << step;
  }
}

// Without gravity and contacts, from rest: v = F / m t for the force, w = T / I t for the torque.
TEST_F(EnvAccess, ForcesMoveAsNewtonSays) {
  env::EnvOptions floating;
  floating.physics.gravity = floating.physics.contacts = false;
  env::World world(benchmark_model(), {}, floating);
  engine::Physics& physics = world.physics();
  const std::int32_t box = id_of(world, MIMO_BODY, "test_object1");
  const double mass = 8, inertia = 8.0 / 12 * (0.2 * 0.2 + 0.2 * 0.2);  // a cube of 0.2 m
  test::set(world, MIMO_BODY_FORCE, Ids{box}, Values{2, -4, 8, 0, 0, 0.5});
  physics.step(10);
  const double t = 10 * kStep;
  const Ids joint = {model().body_jntadr[box]};
  Values velocity = test::get(world, MIMO_JOINT_VELOCITY, joint);
  EXPECT_TRUE(close({2 / mass * t, -4 / mass * t, 8 / mass * t, 0, 0, 0.5 / inertia * t}, velocity.data()));
  // Until changed, and no longer than until a reset: taken away, it flies on. The same by the joint's own generalised
  // force.
  test::set(world, MIMO_BODY_FORCE, Ids{box}, Values(6, 0));
  test::set(world, MIMO_JOINT_FORCE, joint, Values{0, 8, 0, 0, 0, 0});
  physics.step(10);
  velocity = test::get(world, MIMO_JOINT_VELOCITY, joint);
  EXPECT_TRUE(close({2 / mass * t, 4 / mass * t, 8 / mass * t, 0, 0, 0.5 / inertia * t}, velocity.data()));
  physics.reset();
  EXPECT_EQ(test::get(world, MIMO_JOINT_FORCE, joint), Values(6, 0)) << "reset takes forces away";
}

TEST_F(EnvAccess, Refusals) {
  const int ball = id(MIMO_BODY, "test_object2"), hand = id(MIMO_BODY, "left_hand");
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Values before = copy(physics_.data().qpos, model().nq);
  const auto refuse = [&](const char* part, mimo_quantity quantity, const Ids& ids, const Values& values) {
    expect_error(Status::kInvalidArgument, part, [&] { set(quantity, ids, values); });
  };
  refuse("\"left_hand\") cannot be moved", MIMO_BODY_POSITION, {ball, hand}, {1, 1, 1, 1, 1, 1});
  refuse("\"world\") cannot be moved", MIMO_BODY_ORIENTATION, {0}, {1, 0, 0, 0});
  refuse("values[1] is nan", MIMO_BODY_POSITION, {ball}, {1, nan, 1});
  refuse("values[2] is inf", MIMO_BODY_POSITION, {ball}, {1, 1, infinity});
  refuse("quaternion", MIMO_BODY_ORIENTATION, {ball}, {0, 0, 0, 0});
  refuse("quaternion", MIMO_JOINT_POSITION, {model().body_jntadr[ball]}, {9, 9, 9, 0, 0, 0, 0});
  refuse("MIMO_BODY_VELOCITY, which can only be read", MIMO_BODY_VELOCITY, {ball}, {1, 1, 1, 1, 1, 1});
  refuse("MIMO_SENSOR_VALUE, which can only be read", MIMO_SENSOR_VALUE, {0}, {1, 1, 1});
  EXPECT_EQ(copy(physics_.data().qpos, model().nq), before) << "nothing was written";
  expect_error(Status::kInvalidArgument, "ids[1] is 26, expected a body id from 0 to 25", [&] {
    width(MIMO_BODY_MASS, Ids{0, 26});
  });
  expect_error(Status::kInvalidArgument, "ids[0] is -1", [&] { width(MIMO_JOINT_POSITION, Ids{-1}); });
}

// A pose is a position and an orientation.
TEST_F(EnvAccess, Poses) {
  physics_.step(60);
  const auto expect = [&](mimo_kind kind, mimo_quantity pose, mimo_quantity position, mimo_quantity orientation) {
    for (const int element : all(kind)) {
      Values expected = get(position, {element});
      const Values turn = get(orientation, {element});
      expected.insert(expected.end(), turn.begin(), turn.end());
      EXPECT_EQ(get(pose, {element}), expected) << element;
    }
  };
  expect(MIMO_BODY, MIMO_BODY_POSE, MIMO_BODY_POSITION, MIMO_BODY_ORIENTATION);
  expect(MIMO_GEOM, MIMO_GEOM_POSE, MIMO_GEOM_POSITION, MIMO_GEOM_ORIENTATION);
  expect(MIMO_SITE, MIMO_SITE_POSE, MIMO_SITE_POSITION, MIMO_SITE_ORIENTATION);
  expect(MIMO_CAMERA, MIMO_CAMERA_POSE, MIMO_CAMERA_POSITION, MIMO_CAMERA_ORIENTATION);
  const int ball = id(MIMO_BODY, "test_object2");
  set(MIMO_BODY_POSE, {ball}, {1, 2, 3, 0, 0, 3, 4});
  EXPECT_EQ(get(MIMO_BODY_POSE, {ball}), (Values{1, 2, 3, 0, 0, 0.6, 0.8}));
}

// Of now: what an update would give, while the values of the last step and the trajectory stay. A falling ball tells
// the two apart: its last step started where it was one step ago.
TEST_F(EnvAccess, CurrentPosesAreThoseAfterTheStep) {
  env::World twin(benchmark_model(), {}, {});
  const int ball = id(MIMO_BODY, "test_object2");
  set(MIMO_BODY_POSITION, {ball}, {3, 3, 5});
  test::set(twin, MIMO_BODY_POSITION, {ball}, {3, 3, 5});
  for (int step = 0; step < 20; ++step) {
    physics_.step(1);
    twin.physics().step(1);
    const Values last = get(MIMO_BODY_POSITION, all(MIMO_BODY));
    const Values now = get(MIMO_BODY_POSITION, all(MIMO_BODY), true);
    const Values velocity = get(MIMO_BODY_VELOCITY, {ball}, true);
    EXPECT_EQ(last, test::get(twin, MIMO_BODY_POSITION, all(MIMO_BODY))) << "nothing is changed by asking";
    EXPECT_EQ(get(MIMO_BODY_POSITION, all(MIMO_BODY)), last);
    const double speed = -9.81 * kStep * (step + 1);
    EXPECT_TRUE(close(now[3 * ball + 2] - last[3 * ball + 2], speed * kStep, {1e-6, 1e-12}));
    EXPECT_TRUE(close(speed, velocity[2], {1e-9, 1e-12}));
    EXPECT_TRUE(close(speed + 9.81 * kStep, get(MIMO_BODY_VELOCITY, {ball})[2], {1e-9, 1e-12}));
    ASSERT_EQ(copy(physics_.data().qpos, model().nq), copy(twin.data().qpos, model().nq)) << step;
    engine::Physics moved(benchmark_model(), {});
    std::copy_n(physics_.data().qpos, model().nq, moved.data().qpos);
    moved.update_poses();
    EXPECT_EQ(now, copy(moved.data().xpos, 3 * model().nbody));
  }
  EXPECT_EQ(get(MIMO_JOINT_POSITION, {0}, true), get(MIMO_JOINT_POSITION, {0})) << "always current";
  expect_error(Status::kInvalidArgument, "MIMO_JOINT_ACCELERATION, which only physics steps compute",
               [&] { get(MIMO_JOINT_ACCELERATION, {0}, true); });
}

// Finite, but far beyond what the simulation takes: refused by the next step, not by a crash.
TEST_F(EnvAccess, AbsurdPositionsFailTheWorld) {
  const int ball = id(MIMO_BODY, "test_object2");
  set(MIMO_BODY_POSITION, {ball}, {1e200, 0, 0});
  expect_error(Status::kSimulation, "QPOS", [&] { physics_.step(1); });
  expect_error(Status::kSimulation, "reset", [&] { set(MIMO_BODY_POSITION, {ball}, {0, 0, 1}); });
  physics_.reset();
  physics_.step(1);
}

// A weight on a turntable, half a metre from its axle, at 3 rad/s: it is drawn inwards by w^2 r, carried against
// gravity, and a torque of as much as its inertia, m (r^2 + 0.4 a^2), speeds it up by 1 rad/s^2.
TEST(EnvInertial, IsWhatASensorOnATurntableReads) {
  env::World world(
      compiled("<mujoco><option timestep='0.001'/><worldbody><body name='table'><joint axis='0 0 1'/>"
               "<body name='weight' pos='0.5 0 0'><geom size='0.1' mass='2'/></body></body>"
               "<body name='falling' pos='0 0 9'><freejoint/><geom size='0.1'/></body></worldbody></mujoco>"),
      {}, {});
  const auto inertial = [&world](const char* body) {
    return get(world, MIMO_BODY_INERTIAL, {id_of(world, MIMO_BODY, body)});
  };
  set(world, MIMO_JOINT_VELOCITY, {0}, {3});
  set(world, MIMO_JOINT_FORCE, {0}, {2 * (0.5 * 0.5 + 0.4 * 0.1 * 0.1)});
  world.physics().step(1);
  EXPECT_TRUE(close({-9 * 0.5, 0.5, 9.81, 0, 0, 3, 0, 0, 1}, inertial("weight").data()));
  EXPECT_TRUE(close({0, 0, 9.81, 0, 0, 3, 0, 0, 1}, inertial("table").data())) << "on the axle";
  EXPECT_TRUE(close({0, 0, 0, 0, 0, 0, 0, 0, 0}, inertial("falling").data()));
  EXPECT_TRUE(close({0, 0, 9.81, 0, 0, 0, 0, 0, 0}, inertial("world").data()));
  world.physics().step(524);  // a quarter of a turn: the sensor turns with its body
  EXPECT_NEAR(inertial("weight")[0], -std::pow(3 + 0.524, 2) * 0.5, 1e-2);
}

// A ball at rest carries its weight: along the contact's normal, which points from geom 1 to geom 2.
TEST(EnvContacts, BallAtRestCarriesItsWeight) {
  env::World world(
      compiled(
          "<mujoco><option timestep='0.005'/><worldbody><geom name='floor' type='plane' size='1 1 .1'/>"
          "<body name='ball' pos='0 0 0.05'><freejoint/><geom size='0.05' mass='0.3'/></body></worldbody></mujoco>"),
      {}, {});
  world.physics().step(2000);
  ASSERT_EQ(access::kind_of(MIMO_CONTACT).count(world), 1);
  EXPECT_EQ(get(world, MIMO_CONTACT_GEOMS), (Values{0, 1}));
  EXPECT_EQ(get(world, MIMO_CONTACT_BODIES), (Values{0, 1}));
  EXPECT_TRUE(close({0, 0, 1}, get(world, MIMO_CONTACT_FRAME).data(), {0, 1e-9})) << "up, from floor to ball";
  EXPECT_NEAR(get(world, MIMO_CONTACT_POSITION)[2], 0, 1e-3);
  EXPECT_LT(get(world, MIMO_CONTACT_DISTANCE)[0], 0);
  EXPECT_TRUE(close({0.3 * 9.81, 0, 0}, get(world, MIMO_CONTACT_FORCE).data(), {1e-6, 1e-6})) << "on the ball";
  EXPECT_TRUE(close({0, 0, 0}, get(world, MIMO_CONTACT_TORQUE).data(), {0, 1e-6}));
}

}  // namespace
}  // namespace mimo::test
