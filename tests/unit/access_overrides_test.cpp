// What differs from world to world, against mechanics on paper and against models that were compiled so.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/fingerprint.h"
#include "support/access.h"
#include "support/physical.h"
#include "support/tiny.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using access::Kind;
using access::Quantity;

constexpr double kStep = 0.001;
constexpr double kGravity = 9.81;

env::World room(const std::string& bodies, const std::string& settings = "") {
  return env::World(compiled("<mujoco><option timestep='0.001'/>" + settings +
                             "<worldbody><geom name='floor' type='plane' size='5 5 .1'/><light name='sun' pos='0 0 9' "
                             "dir='0 0 -1'/>" +
                             bodies + "</worldbody></mujoco>"),
                    {}, {});
}

std::string ball(double height) {
  return "<body name='ball' pos='0 0 " + std::to_string(height) +
         "'><freejoint/><geom name='ball' size='0.1' mass='2'/></body>";
}

// ---- Masses ---------------------------------------------------------------------------------------------------------

// v = F / m t, w = T / I t; a solid sphere's inertia is 0.4 m r^2.
TEST(Mass, PushedBodyGoesAsNewtonSays) {
  env::World world = room(ball(3), "<option gravity='0 0 0'/>");
  const std::int32_t body = id_of(world, Kind::kBody, "ball"), joint = world.model().body_jntadr[body];
  set(world, Quantity::kBodyMass, {body}, {0.5});
  EXPECT_EQ(get(world, Quantity::kBodyMass, {body}), Values{0.5});
  set(world, Quantity::kBodyForce, {body}, {1, -2, 3, 0.01, 0, 0});
  world.physics().step(100);
  const double t = 100 * kStep, inertia = 0.4 * 0.5 * 0.1 * 0.1;
  const Values velocity = get(world, Quantity::kJointVelocity, {joint});
  EXPECT_TRUE(close({1 / 0.5 * t, -2 / 0.5 * t, 3 / 0.5 * t, 0.01 / inertia * t, 0, 0}, velocity.data()));
}

TEST(Mass, RestingBodyWeighsIt) {
  env::World world = room(ball(0.1));
  set(world, Quantity::kBodyMass, {id_of(world, Kind::kBody, "ball")}, {7});
  world.physics().step(4000);
  EXPECT_NEAR(get(world, Quantity::kContactForce)[0], 7 * kGravity, 1e-4);
}

// Everything that MuJoCo's compiler derives from masses is as if it had compiled these.
TEST(Mass, IsAsIfCompiledSo) {
  const auto arm = [](double upper, double lower) {
    const auto box = [](double mass) {
      return "<inertial pos='0 0 -.1' mass='" + std::to_string(mass) + "' diaginertia='" + std::to_string(mass * 0.01) +
             " " + std::to_string(mass * 0.02) + " " + std::to_string(mass * 0.015) + "'/>";
    };
    return compiled(
        "<mujoco><worldbody><body name='upper' pos='0 0 1'><joint name='shoulder' axis='0 1 0'/>" + box(upper) +
        "<geom type='box' size='.02 .02 .1'/><site name='a'/><body name='lower' pos='0 0 -.2'><joint name='elbow' "
        "axis='1 0 0'/>" +
        box(lower) +
        "<geom type='box' size='.02 .02 .1'/><site name='b' pos='0 0 -.1'/></body></body></worldbody><tendon><spatial "
        "name='cord'><site site='a'/><site site='b'/></spatial></tendon><actuator><motor joint='elbow'/></actuator>"
        "</mujoco>");
  };
  const engine::ModelPtr shared = arm(2, 1);
  const std::uint64_t before = engine::fingerprint(*shared);
  env::World world(shared, {}, {});
  const std::int32_t upper = id_of(world, Kind::kBody, "upper"), lower = id_of(world, Kind::kBody, "lower");
  set(world, Quantity::kBodyMass, {upper, lower}, {0.5, 3});
  expect_same_physics(*arm(0.5, 3), world.model(), {1e-12, 1e-15});
  set(world, Quantity::kBodyMass, {lower, upper}, {1, 2});
  expect_same_physics(*shared, world.model(), {1e-12, 1e-15});
  EXPECT_EQ(engine::fingerprint(*shared), before) << "what worlds share stays as it is";
}

TEST(Mass, Refusals) {
  env::World world = room(ball(1));
  const std::int32_t body = id_of(world, Kind::kBody, "ball");
  const auto refuse = [&](const char* part, std::int32_t of, double mass) {
    expect_error(Status::kInvalidArgument, part, [&] { set(world, Quantity::kBodyMass, {of}, {mass}); });
  };
  refuse("(\"ball\") is 0, expected kilograms above 0", body, 0);
  refuse("is -1, expected", body, -1);
  refuse("values[0] is nan", body, std::nan(""));
  refuse("(\"world\") has no mass", 0, 1);
  EXPECT_EQ(get(world, Quantity::kBodyMass, {body}), Values{2});
  set(world, Quantity::kBodyMass, {0, body}, {0, 2});  // what is there may be written back
}

// ---- Shapes ---------------------------------------------------------------------------------------------------------

TEST(Size, SetsHowHighABallRests) {
  env::World world = room(ball(1));
  const std::int32_t geom = id_of(world, Kind::kGeom, "ball");
  set(world, Quantity::kGeomSize, {geom}, {0.25, 0, 0});
  EXPECT_EQ(get(world, Quantity::kGeomSize, {geom})[0], 0.25);
  EXPECT_EQ(get(world, Quantity::kBodyMass, {world.model().geom_bodyid[geom]}), Values{2}) << "the mass stays";
  world.physics().step(4000);
  EXPECT_NEAR(get(world, Quantity::kGeomPosition, {geom})[2], 0.25, 1e-3);
}

// The sphere around a geom, which decides what is looked at for contacts, is the compiler's.
TEST(Size, IsAsIfCompiledSo) {
  const auto shapes = [](double scale) {
    std::string bodies;
    for (const char* type : {"sphere", "capsule", "ellipsoid", "cylinder", "box"}) {
      bodies += format(
          "<body pos='0 0 9'><freejoint/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/><geom "
          "type='{}' size='{} {} {}'/></body>",
          type, 0.1 * scale, 0.2 * scale, 0.3 * scale);
    }
    return compiled("<mujoco><worldbody>" + bodies + "</worldbody></mujoco>");
  };
  env::World world(shapes(1), {}, {});
  for (int geom = 0; geom < 5; ++geom) set(world, Quantity::kGeomSize, {geom}, {0.15, 0.3, 0.45});
  const engine::ModelPtr expected = shapes(1.5);
  EXPECT_TRUE(close(copy(expected->geom_rbound, 5), world.model().geom_rbound));
  EXPECT_TRUE(close(copy(expected->geom_size + 6, 3), world.model().geom_size + 6)) << "of the ellipsoid";
}

TEST(Size, Refusals) {
  env::World world = room(ball(1));
  const std::int32_t geom = id_of(world, Kind::kGeom, "ball"), floor = id_of(world, Kind::kGeom, "floor");
  expect_error(Status::kInvalidArgument, "size 0 of geom 1 (\"ball\") is 0, expected metres above 0", [&] {
    set(world, Quantity::kGeomSize, {geom}, {0, 1, 1});
  });
  expect_error(Status::kInvalidArgument, "(\"floor\") is a plane", [&] {
    set(world, Quantity::kGeomSize, {floor}, {1, 1, 1});
  });
  set(world, Quantity::kGeomSize, {floor}, get(world, Quantity::kGeomSize, {floor}));  // what is there already
  EXPECT_EQ(world.model().geom_rbound[floor], 0) << "still endless for collisions";
}

// ---- Friction and damping -------------------------------------------------------------------------------------------

// On a slope of angle a (here gravity leans) a box slides from tan(a) = friction on, and then with the acceleration
// g (sin(a) - friction cos(a)).
TEST(Friction, SlidesAtItsAngle) {
  constexpr double kFriction = 0.3, kTime = 0.5;
  const auto speed = [&](double angle) {
    env::World world = room(
        "<body name='box' pos='0 0 0.05'><freejoint/><geom name='box' type='box' size='.2 .2 .05' "
        "mass='1'/></body>",
        "<option cone='elliptic' impratio='100' tolerance='1e-10' solver='Newton'/>");
    const std::int32_t box = id_of(world, Kind::kGeom, "box"), floor = id_of(world, Kind::kGeom, "floor");
    set(world, Quantity::kGeomFriction, {box, floor}, {kFriction, 0.005, 0.0001, kFriction, 0.005, 0.0001});
    set(world, Quantity::kWorldGravity, {0}, {kGravity * std::sin(angle), 0, -kGravity * std::cos(angle)});
    world.physics().step(static_cast<int>(kTime / kStep));
    return get(world, Quantity::kJointVelocity, {0})[0];
  };
  const double limit = std::atan(kFriction);
  EXPECT_NEAR(speed(limit - 0.03), 0, 0.01);
  const double steep = limit + 0.1;
  EXPECT_NEAR(speed(steep), kTime * kGravity * (std::sin(steep) - kFriction * std::cos(steep)), 0.01);
}

// A free wheel of inertia I slows down as exp(-b t / I); MuJoCo's implicit damping gives (1 + h b / I)^-n.
TEST(Damping, SlowsAWheel) {
  env::World world = room(
      "<body pos='0 0 2'><joint name='axle' axis='0 0 1'/><inertial pos='0 0 0' mass='1' "
      "diaginertia='.02 .02 .02'/></body>");
  const std::int32_t axle = id_of(world, Kind::kJoint, "axle");
  set(world, Quantity::kJointDamping, {axle}, {0.05});
  EXPECT_EQ(get(world, Quantity::kJointDamping, {axle}), Values{0.05});
  set(world, Quantity::kJointVelocity, {axle}, {3});
  world.physics().step(200);
  EXPECT_TRUE(close(3 * std::pow(1 + kStep * 0.05 / 0.02, -200), get(world, Quantity::kJointVelocity, {axle})[0]));
  expect_error(Status::kInvalidArgument, "is -1, expected 0 or more",
               [&] { set(world, Quantity::kJointDamping, {axle}, {-1}); });
}

// ---- Places ---------------------------------------------------------------------------------------------------------

const char* const kTable = "<body name='table' pos='3 0 0'><geom name='top' type='box' size='.5 .5 .2'/></body>";

TEST(Place, OfAFixedObject) {
  env::World world = room(kTable + ball(1));
  const std::int32_t table = id_of(world, Kind::kBody, "table"), top = id_of(world, Kind::kGeom, "top");
  set(world, Quantity::kBodyPosition, {table}, {0, 0, 0.1});
  EXPECT_EQ(get(world, Quantity::kGeomPosition, {top}), (Values{0, 0, 0.1})) << "at once";
  world.physics().step(3000);
  EXPECT_NEAR(get(world, Quantity::kGeomPosition, {id_of(world, Kind::kGeom, "ball")})[2], 0.3 + 0.1, 2e-3)
      << "the ball lies on it";
  set(world, Quantity::kBodyPose, {table}, {0, 0, 0.1, 2, 0, 0, 2});
  EXPECT_TRUE(close({std::sqrt(0.5), 0, 0, std::sqrt(0.5)}, get(world, Quantity::kBodyOrientation, {table}).data()));
  world.reset(nullptr, nullptr);
  EXPECT_EQ(get(world, Quantity::kBodyPosition, {table}), (Values{0, 0, 0.1})) << "outlives resets";
}

// ---- All of them ----------------------------------------------------------------------------------------------------

// Changes everything that can be changed, in a room with a table, a ball and a light.
void change_all(env::World& world) {
  const std::int32_t body = id_of(world, Kind::kBody, "ball"), geom = id_of(world, Kind::kGeom, "ball");
  set(world, Quantity::kBodyMass, {body}, {0.7});
  set(world, Quantity::kGeomSize, {geom}, {0.2, 0, 0});
  set(world, Quantity::kGeomFriction, {geom}, {0.1, 0.2, 0.3});
  set(world, Quantity::kGeomColor, {geom}, {1, 0.5, 0.25, 0.75});
  set(world, Quantity::kJointDamping, {0}, {0.5});
  set(world, Quantity::kBodyPose, {id_of(world, Kind::kBody, "table")}, {0, 1, 0, 0, 1, 0, 0});
  set(world, Quantity::kLightPosition, {0}, {1, 2, 3});
  set(world, Quantity::kLightDirection, {0}, {0, 3, -4});
  set(world, Quantity::kLightColor, {0}, {0.5, 0.25, 0.125});
  set(world, Quantity::kWorldGravity, {0}, {0, 1, -3});
}

Values all_of(env::World& world) {
  Values all;
  for (const Quantity quantity : {Quantity::kBodyMass, Quantity::kGeomSize, Quantity::kGeomFriction,
                                  Quantity::kGeomColor, Quantity::kJointDamping, Quantity::kLightPosition,
                                  Quantity::kLightDirection, Quantity::kLightColor, Quantity::kWorldGravity}) {
    const Values values = get(world, quantity);
    all.insert(all.end(), values.begin(), values.end());
  }
  const Values table = get(world, Quantity::kBodyPose, {id_of(world, Kind::kBody, "table")});
  all.insert(all.end(), table.begin(), table.end());
  return all;
}

TEST(Overrides, AreReadAsTheyWereWritten) {
  env::World world = room(kTable + ball(1));
  change_all(world);
  EXPECT_EQ(get(world, Quantity::kLightDirection, {0}), (Values{0, 0.6, -0.8})) << "normalised";
  EXPECT_EQ(get(world, Quantity::kLightColor, {0}), (Values{0.5, 0.25, 0.125}));
  EXPECT_EQ(get(world, Quantity::kGeomColor, {id_of(world, Kind::kGeom, "ball")}), (Values{1, 0.5, 0.25, 0.75}));
  EXPECT_EQ(get(world, Quantity::kGeomFriction, {id_of(world, Kind::kGeom, "ball")}), (Values{0.1, 0.2, 0.3}));
  const Values before = all_of(world);
  world.reset(nullptr, nullptr);
  EXPECT_EQ(all_of(world), before) << "outlives resets";
}

TEST(Overrides, ArePartOfTheState) {
  env::World changed = room(kTable + ball(1));
  const Values before = all_of(changed);
  const Bytes unchanged = saved(changed);
  change_all(changed);
  changed.physics().step(300);
  const Values after = all_of(changed);
  const Bytes state = saved(changed);
  changed.physics().step(300);
  const Values end = get(changed, Quantity::kJointPosition, {0});
  load(changed, unchanged);
  EXPECT_EQ(all_of(changed), before);
  env::World other = room(kTable + ball(1));
  load(other, state);
  EXPECT_EQ(all_of(other), after);
  EXPECT_EQ(saved(other), state);
  other.physics().step(300);
  EXPECT_EQ(get(other, Quantity::kJointPosition, {0}), end) << "to the last bit";
}

TEST(Overrides, LeaveOtherWorldsAlone) {
  const engine::ModelPtr model = benchmark_model();
  const std::uint64_t before = engine::fingerprint(*model);
  env::World changed(model, {}, {}), other(model, {}, {}), twin(model, {}, {});
  const std::int32_t box = id_of(changed, Kind::kBody, "test_object1");
  Values masses = get(changed, Quantity::kBodyMass);
  Ids bodies;
  for (int i = 0; i < static_cast<int>(masses.size()); ++i) bodies.push_back(i);
  for (double& mass : masses) mass *= 1.5;
  set(changed, Quantity::kBodyMass, bodies, masses);
  set(changed, Quantity::kGeomSize, {changed.model().body_geomadr[box]}, {0.3, 0.3, 0.3});
  changed.physics().step(50);
  other.physics().step(50);
  twin.physics().step(50);
  EXPECT_EQ(engine::fingerprint(*model), before);
  EXPECT_EQ(copy(other.data().qpos, model->nq), copy(twin.data().qpos, model->nq));
  EXPECT_NE(copy(changed.data().qpos, model->nq), copy(twin.data().qpos, model->nq));
}

TEST(Overrides, Refusals) {
  env::World world = room(ball(1) + "<body name='lamp' pos='0 0 5'><light name='lamp' mode='track'/></body>");
  const auto refuse = [&](Status status, const char* part, Quantity quantity, std::int32_t id, const Values& values) {
    expect_error(status, part, [&] { set(world, quantity, {id}, values); });
  };
  const Values before = get(world, Quantity::kGeomColor);
  refuse(Status::kInvalidArgument, "color of geom of 1 is 1.5, expected 0 to 1", Quantity::kGeomColor, 1,
         {0, 1.5, 0, 1});
  refuse(Status::kInvalidArgument, "friction of geom of 1 is -0.5", Quantity::kGeomFriction, 1, {1, 1, -0.5});
  refuse(Status::kInvalidArgument, "direction of light 0 is zero", Quantity::kLightDirection, 0, {0, 0, 0});
  refuse(Status::kInvalidArgument, "expected 0 to 100", Quantity::kLightColor, 0, {0, 0, 101});
  refuse(Status::kUnsupported, "light 1 (\"lamp\") follows a body", Quantity::kLightPosition, 1, {0, 0, 1});
  refuse(Status::kInvalidArgument, "expected 0 to 0", Quantity::kWarningSteps, 0, {1});
  EXPECT_EQ(get(world, Quantity::kGeomColor), before);
}

}  // namespace
}  // namespace mimo::test
