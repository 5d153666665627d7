// What differs from world to world, against mechanics on paper and against models that were compiled so.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/model.h"
#include "support/access.h"
#include "support/physical.h"
#include "support/tiny.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

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
  const std::int32_t body = id_of(world, MIMO_BODY, "ball"), joint = world.model().body_jntadr[body];
  set(world, MIMO_BODY_MASS, {body}, {0.5});
  EXPECT_EQ(get(world, MIMO_BODY_MASS, {body}), Values{0.5});
  set(world, MIMO_BODY_FORCE, {body}, {1, -2, 3, 0.01, 0, 0});
  world.physics().step(100);
  const double t = 100 * kStep, inertia = 0.4 * 0.5 * 0.1 * 0.1;
  const Values velocity = get(world, MIMO_JOINT_VELOCITY, {joint});
  EXPECT_TRUE(close({1 / 0.5 * t, -2 / 0.5 * t, 3 / 0.5 * t, 0.01 / inertia * t, 0, 0}, velocity.data()));
}

TEST(Mass, RestingBodyWeighsIt) {
  env::World world = room(ball(0.1));
  set(world, MIMO_BODY_MASS, {id_of(world, MIMO_BODY, "ball")}, {7});
  world.physics().step(4000);
  EXPECT_NEAR(get(world, MIMO_CONTACT_FORCE)[0], 7 * kGravity, 1e-4);
}

// Everything that MuJoCo's compiler derives from masses is as if it had compiled these.
TEST(Mass, EqualsRecompiling) {
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
  const std::int32_t upper = id_of(world, MIMO_BODY, "upper"), lower = id_of(world, MIMO_BODY, "lower");
  set(world, MIMO_BODY_MASS, {upper, lower}, {0.5, 3});
  expect_same_physics(*arm(0.5, 3), world.model(), {1e-12, 1e-15});
  set(world, MIMO_BODY_MASS, {lower, upper}, {1, 2});
  expect_same_physics(*shared, world.model(), {1e-12, 1e-15});
  EXPECT_EQ(engine::fingerprint(*shared), before) << "what worlds share stays as it is";
}

TEST(Mass, Refusals) {
  env::World world = room(ball(1));
  const std::int32_t body = id_of(world, MIMO_BODY, "ball");
  const auto refuse = [&](const char* part, std::int32_t of, double mass) {
    expect_error(Status::kInvalidArgument, part, [&] { set(world, MIMO_BODY_MASS, {of}, {mass}); });
  };
  refuse("(\"ball\") is 0, expected kilograms above 0", body, 0);
  refuse("is -1, expected", body, -1);
  refuse("values[0] is nan", body, std::nan(""));
  refuse("(\"world\") has no mass", 0, 1);
  EXPECT_EQ(get(world, MIMO_BODY_MASS, {body}), Values{2});
  set(world, MIMO_BODY_MASS, {0, body}, {0, 2});  // what is there may be written back
}

// ---- Shapes ---------------------------------------------------------------------------------------------------------

TEST(Size, SetsHowHighABallRests) {
  env::World world = room(ball(1));
  const std::int32_t geom = id_of(world, MIMO_GEOM, "ball");
  set(world, MIMO_GEOM_SIZE, {geom}, {0.25, 0, 0});
  EXPECT_EQ(get(world, MIMO_GEOM_SIZE, {geom})[0], 0.25);
  EXPECT_EQ(get(world, MIMO_BODY_MASS, {world.model().geom_bodyid[geom]}), Values{2}) << "the mass stays";
  world.physics().step(4000);
  EXPECT_NEAR(get(world, MIMO_GEOM_POSITION, {geom})[2], 0.25, 1e-3);
}

// The sphere around a geom, which decides what is looked at for contacts, is the compiler's.
TEST(Size, EqualsRecompiling) {
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
  for (int geom = 0; geom < 5; ++geom) set(world, MIMO_GEOM_SIZE, {geom}, {0.15, 0.3, 0.45});
  const engine::ModelPtr expected = shapes(1.5);
  EXPECT_TRUE(close(copy(expected->geom_rbound, 5), world.model().geom_rbound));
  EXPECT_TRUE(close(copy(expected->geom_size + 6, 3), world.model().geom_size + 6)) << "of the ellipsoid";
}

TEST(Size, Refusals) {
  env::World world = room(ball(1));
  const std::int32_t geom = id_of(world, MIMO_GEOM, "ball"), floor = id_of(world, MIMO_GEOM, "floor");
  expect_error(Status::kInvalidArgument, "size 0 of geom 1 (\"ball\") is 0, expected metres above 0", [&] {
    set(world, MIMO_GEOM_SIZE, {geom}, {0, 1, 1});
  });
  expect_error(Status::kInvalidArgument, "(\"floor\") is a plane", [&] {
    set(world, MIMO_GEOM_SIZE, {floor}, {1, 1, 1});
  });
  set(world, MIMO_GEOM_SIZE, {floor}, get(world, MIMO_GEOM_SIZE, {floor}));  // what is there already
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
    const std::int32_t box = id_of(world, MIMO_GEOM, "box"), floor = id_of(world, MIMO_GEOM, "floor");
    set(world, MIMO_GEOM_FRICTION, {box, floor}, {kFriction, 0.005, 0.0001, kFriction, 0.005, 0.0001});
    set(world, MIMO_WORLD_GRAVITY, {0}, {kGravity * std::sin(angle), 0, -kGravity * std::cos(angle)});
    world.physics().step(static_cast<int>(kTime / kStep));
    return get(world, MIMO_JOINT_VELOCITY, {0})[0];
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
  const std::int32_t axle = id_of(world, MIMO_JOINT, "axle");
  set(world, MIMO_JOINT_DAMPING, {axle}, {0.05});
  EXPECT_EQ(get(world, MIMO_JOINT_DAMPING, {axle}), Values{0.05});
  set(world, MIMO_JOINT_VELOCITY, {axle}, {3});
  world.physics().step(200);
  EXPECT_TRUE(close(3 * std::pow(1 + kStep * 0.05 / 0.02, -200), get(world, MIMO_JOINT_VELOCITY, {axle})[0]));
  expect_error(Status::kInvalidArgument, "is -1, expected 0 or more",
               [&] { set(world, MIMO_JOINT_DAMPING, {axle}, {-1}); });
}

// ---- Places ---------------------------------------------------------------------------------------------------------

const char* const kTable = "<body name='table' pos='3 0 0'><geom name='top' type='box' size='.5 .5 .2'/></body>";

TEST(Place, OfAFixedObject) {
  env::World world = room(kTable + ball(1));
  const std::int32_t table = id_of(world, MIMO_BODY, "table"), top = id_of(world, MIMO_GEOM, "top");
  set(world, MIMO_BODY_POSITION, {table}, {0, 0, 0.1});
  EXPECT_EQ(get(world, MIMO_GEOM_POSITION, {top}), (Values{0, 0, 0.1})) << "at once";
  world.physics().step(3000);
  EXPECT_NEAR(get(world, MIMO_GEOM_POSITION, {id_of(world, MIMO_GEOM, "ball")})[2], 0.3 + 0.1, 2e-3)
      << "the ball lies on it";
  set(world, MIMO_BODY_POSE, {table}, {0, 0, 0.1, 2, 0, 0, 2});
  EXPECT_TRUE(close({std::sqrt(0.5), 0, 0, std::sqrt(0.5)}, get(world, MIMO_BODY_ORIENTATION, {table}).data()));
  world.reset(nullptr, nullptr);
  EXPECT_EQ(get(world, MIMO_BODY_POSITION, {table}), (Values{0, 0, 0.1})) << "outlives resets";
}

// ---- All of them ----------------------------------------------------------------------------------------------------

// Changes everything that can be changed, in a room with a table, a ball and a light.
void change_all(env::World& world) {
  const std::int32_t body = id_of(world, MIMO_BODY, "ball"), geom = id_of(world, MIMO_GEOM, "ball");
  set(world, MIMO_BODY_MASS, {body}, {0.7});
  set(world, MIMO_GEOM_SIZE, {geom}, {0.2, 0, 0});
  set(world, MIMO_GEOM_FRICTION, {geom}, {0.1, 0.2, 0.3});
  set(world, MIMO_GEOM_COLOR, {geom}, {1, 0.5, 0.25, 0.75});
  set(world, MIMO_JOINT_DAMPING, {0}, {0.5});
  set(world, MIMO_BODY_POSE, {id_of(world, MIMO_BODY, "table")}, {0, 1, 0, 0, 1, 0, 0});
  set(world, MIMO_LIGHT_POSITION, {0}, {1, 2, 3});
  set(world, MIMO_LIGHT_DIRECTION, {0}, {0, 3, -4});
  set(world, MIMO_LIGHT_COLOR, {0}, {0.5, 0.25, 0.125});
  set(world, MIMO_WORLD_GRAVITY, {0}, {0, 1, -3});
}

Values all_of(env::World& world) {
  Values all;
  for (const mimo_quantity quantity :
       {MIMO_BODY_MASS, MIMO_GEOM_SIZE, MIMO_GEOM_FRICTION, MIMO_GEOM_COLOR, MIMO_JOINT_DAMPING, MIMO_LIGHT_POSITION,
        MIMO_LIGHT_DIRECTION, MIMO_LIGHT_COLOR, MIMO_WORLD_GRAVITY}) {
    const Values values = get(world, quantity);
    all.insert(all.end(), values.begin(), values.end());
  }
  const Values table = get(world, MIMO_BODY_POSE, {id_of(world, MIMO_BODY, "table")});
  all.insert(all.end(), table.begin(), table.end());
  return all;
}

TEST(Overrides, AreReadAsTheyWereWritten) {
  env::World world = room(kTable + ball(1));
  change_all(world);
  EXPECT_EQ(get(world, MIMO_LIGHT_DIRECTION, {0}), (Values{0, 0.6, -0.8})) << "normalised";
  EXPECT_EQ(get(world, MIMO_LIGHT_COLOR, {0}), (Values{0.5, 0.25, 0.125}));
  EXPECT_EQ(get(world, MIMO_GEOM_COLOR, {id_of(world, MIMO_GEOM, "ball")}), (Values{1, 0.5, 0.25, 0.75}));
  EXPECT_EQ(get(world, MIMO_GEOM_FRICTION, {id_of(world, MIMO_GEOM, "ball")}), (Values{0.1, 0.2, 0.3}));
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
  const Values end = get(changed, MIMO_JOINT_POSITION, {0});
  load(changed, unchanged);
  EXPECT_EQ(all_of(changed), before);
  env::World other = room(kTable + ball(1));
  load(other, state);
  EXPECT_EQ(all_of(other), after);
  EXPECT_EQ(saved(other), state);
  other.physics().step(300);
  EXPECT_EQ(get(other, MIMO_JOINT_POSITION, {0}), end) << "to the last bit";
}

TEST(Overrides, LeaveOtherWorldsAlone) {
  const engine::ModelPtr model = benchmark_model();
  const std::uint64_t before = engine::fingerprint(*model);
  env::World changed(model, {}, {}), other(model, {}, {}), twin(model, {}, {});
  const std::int32_t box = id_of(changed, MIMO_BODY, "test_object1");
  Values masses = get(changed, MIMO_BODY_MASS);
  Ids bodies;
  for (int i = 0; i < static_cast<int>(masses.size()); ++i) bodies.push_back(i);
  for (double& mass : masses) mass *= 1.5;
  set(changed, MIMO_BODY_MASS, bodies, masses);
  set(changed, MIMO_GEOM_SIZE, {changed.model().body_geomadr[box]}, {0.3, 0.3, 0.3});
  changed.physics().step(50);
  other.physics().step(50);
  twin.physics().step(50);
  EXPECT_EQ(engine::fingerprint(*model), before);
  EXPECT_EQ(copy(other.data().qpos, model->nq), copy(twin.data().qpos, model->nq));
  EXPECT_NE(copy(changed.data().qpos, model->nq), copy(twin.data().qpos, model->nq));
}

TEST(Overrides, Refusals) {
  env::World world = room(ball(1) + "<body name='lamp' pos='0 0 5'><light name='lamp' mode='track'/></body>");
  const auto refuse = [&](Status status, const char* part, mimo_quantity quantity, std::int32_t id,
                          const Values& values) {
    expect_error(status, part, [&] { set(world, quantity, {id}, values); });
  };
  const Values before = get(world, MIMO_GEOM_COLOR);
  refuse(Status::kInvalidArgument, "color of geom of 1 is 1.5, expected 0 to 1", MIMO_GEOM_COLOR, 1, {0, 1.5, 0, 1});
  refuse(Status::kInvalidArgument, "friction of geom of 1 is -0.5", MIMO_GEOM_FRICTION, 1, {1, 1, -0.5});
  refuse(Status::kInvalidArgument, "direction of light 0 is zero", MIMO_LIGHT_DIRECTION, 0, {0, 0, 0});
  refuse(Status::kInvalidArgument, "expected 0 to 100", MIMO_LIGHT_COLOR, 0, {0, 0, 101});
  refuse(Status::kUnsupported, "light 1 (\"lamp\") cannot be moved or turned: it follows a body", MIMO_LIGHT_POSITION,
         1, {0, 0, 1});
  refuse(Status::kInvalidArgument, "expected 0 to 0", MIMO_WARNING_STEPS, 0, {1});
  EXPECT_EQ(get(world, MIMO_GEOM_COLOR), before);
}

}  // namespace
}  // namespace mimo::test
