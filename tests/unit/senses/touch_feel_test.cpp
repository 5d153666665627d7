// What sensors feel of known forces.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/format.h"
#include "touch_feeler.h"

namespace mimo::senses::touch {
namespace {

constexpr double kPush = 5;  // N

// A cube that stands still, turned in the world, and a ball before each of its six faces, pushed against it.
constexpr const char* kCube = R"(<mujoco><option timestep="0.005" gravity="0 0 0" cone="elliptic"/>
  <default><geom solref="0.005 1" solimp="0.95 0.99 0.001 0.5 1" condim="3"/><joint damping="5" type="slide"/></default>
  <worldbody><body name="cube" quat="0.8 0.2 0.4 -0.4"><geom type="box" size=".05 .05 .05"/>%s</body></worldbody></mujoco>)";

constexpr int kCubeBody = 1;
const Vec3 kDirections[] = {Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                            -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};

engine::ModelPtr cube() {
  std::string balls;
  for (const Vec3& d : kDirections) {
    const Vec3 place = 0.07 * d + Vec3(0.011, 0.007, -0.013) - Vec3(0.011, 0.007, -0.013).dot(d) * d;
    balls += format("<body pos='{} {} {}'><joint axis='{} {} {}'/><geom size='.02' mass='.1'/></body>", place.x(),
                    place.y(), place.z(), d.x(), d.y(), d.z());
  }
  std::string xml = kCube;
  xml.replace(xml.find("%s"), 2, "");
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.8, 0.2, 0.4, -0.4).normalized();
  // The balls' frame is that of the cube; they are no children of it, or they would not touch it.
  xml.insert(xml.find("</worldbody>"),
             format("<body quat='{} {} {} {}'>", turn.w(), turn.x(), turn.y(), turn.z()) + balls + "</body>");
  return test::compiled(xml);
}

// Only the i-th ball pushes; the others are drawn away.
void push(Feeler& feeler, std::size_t ball) {
  mjData& data = feeler.physics.data();
  feeler.physics.reset();
  for (std::size_t i = 0; i < 6; ++i) {
    data.qfrc_applied[i] = i == ball ? -kPush : 0;
    data.qpos[i] = i == ball ? 0 : 0.01;
  }
  feeler.physics.step(1000);
  feeler.physics.forward();
  feeler.feel();
}

TouchOptions with(Response response, TouchFrame frame) {
  TouchOptions options;
  options.response = response;
  options.frame = frame;
  return options;
}

class TouchFeel : public testing::TestWithParam<Response> {};

TEST_P(TouchFeel, FeelsEveryDirectionInTheFrameOfTheBody) {
  Feeler feeler(cube(), {{kCubeBody, 0.008}}, with(GetParam(), TouchFrame::kBody));
  for (std::size_t i = 0; i < 6; ++i) {
    push(feeler, i);
    EXPECT_LT((feeler.sum("touch/force", kCubeBody) + kPush * kDirections[i]).norm(), 1e-4 * kPush) << i;
    for (std::size_t s = 0; s < feeler.sensors().size(); ++s) {
      if (feeler.row("touch/force", s).isZero()) continue;
      EXPECT_GT(feeler.sensors()[s].position.dot(kDirections[i]), 0.049) << "a sensor on another face";
    }
  }
}

TEST_P(TouchFeel, FeelsEveryDirectionInTheFrameOfTheWorld) {
  Feeler feeler(cube(), {{kCubeBody, 0.008}}, with(GetParam(), TouchFrame::kWorld));
  for (std::size_t i = 0; i < 6; ++i) {
    push(feeler, i);
    const Vec3 expected = -kPush * (feeler.rotation(kCubeBody) * kDirections[i]);
    EXPECT_LT((feeler.sum("touch/force", kCubeBody) - expected).norm(), 1e-4 * kPush) << i;
  }
}

TEST_P(TouchFeel, PressureIsNegativeAlongTheSkinsNormal) {
  Feeler feeler(cube(), {{kCubeBody, 0.008}}, with(GetParam(), TouchFrame::kSkin));
  for (std::size_t i = 0; i < 6; ++i) {
    push(feeler, i);
    const Eigen::VectorXd sum = feeler.sum("touch/force", kCubeBody);
    EXPECT_NEAR(sum[0], -kPush, 1e-4 * kPush) << i;
    EXPECT_LT(sum.tail(2).norm(), 1e-4 * kPush) << "no shear";
  }
}

TEST(Touch, ForceAndNormalForceExcludeEachOther) {
  TouchOptions options;
  options.wanted |= MIMO_TOUCH_NORMAL_FORCE | MIMO_TOUCH_SLIP;
  try {
    const Feeler feeler(cube(), {{kCubeBody, 0.008}}, options);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kInvalidArgument);
    EXPECT_EQ(error.message(), "touch is 0x7: MIMO_TOUCH_FORCE and MIMO_TOUCH_NORMAL_FORCE exclude each other");
  }
}

TEST_P(TouchFeel, NormalForceAlone) {
  TouchOptions options;
  options.wanted = MIMO_TOUCH_NORMAL_FORCE;
  options.response = GetParam();
  Feeler feeler(cube(), {{kCubeBody, 0.008}}, options);
  EXPECT_EQ(feeler.field("touch/force").shape, (std::vector<std::size_t>{feeler.sensors().size(), 1}));
  for (std::size_t i = 0; i < 6; ++i) {
    push(feeler, i);
    EXPECT_NEAR(feeler.sum("touch/force", kCubeBody)[0], kPush, 1e-4 * kPush) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Responses, TouchFeel,
                         testing::Values(Response::kNearest, Response::kLinear, Response::kGaussian));

TEST(TouchFeel, BothSidesOfAContactFeelOppositeForces) {
  Feeler feeler(cube(), {{kCubeBody, 0.008}, {3, 0.004}}, with(Response::kLinear, TouchFrame::kWorld));
  push(feeler, 0);
  const Eigen::VectorXd on_cube = feeler.sum("touch/force", kCubeBody), on_ball = feeler.sum("touch/force", 3);
  EXPECT_NEAR(on_cube.norm(), kPush, 1e-3);
  EXPECT_LT((on_cube + on_ball).norm(), 1e-5);
}

TEST(TouchFeel, PointsLieOnTheSurfaceOfEachBody) {
  Feeler feeler(cube(), {{kCubeBody, 0.008}});
  push(feeler, 4);
  const engine::Physics& physics = feeler.physics;
  ASSERT_EQ(physics.data().ncon, 1);
  EXPECT_LT(physics.data().contact[0].dist, -1e-6);
  const auto force = pressing(physics.model(), physics.data(), 0);
  ASSERT_TRUE(force);
  for (const Side side : {Side::kFirst, Side::kSecond}) {
    const Press press =
        press_on(physics.model(), physics.data(), engine::meeting(physics.model(), physics.data(), 0), *force, side);
    const Vec3 local =
        feeler.rotation(press.body).transpose() * (press.point - Vec3(physics.data().xpos + 3 * press.body));
    EXPECT_NEAR(press.body == kCubeBody ? local.z() : local.norm(), press.body == kCubeBody ? 0.05 : 0.02, 1e-9);
    EXPECT_NEAR(press.force.dot(press.normal), -kPush, 1e-3);
    EXPECT_NEAR(press.normal_force, kPush, 1e-3);
  }
}

TEST(TouchFeel, FeelsNothingWithoutContacts) {
  Feeler feeler(cube(), {{kCubeBody, 0.008}});
  for (int i = 0; i < 6; ++i) feeler.physics.data().qpos[i] = 0.05;
  feeler.physics.forward();
  feeler.feel();
  for (std::size_t s = 0; s < feeler.sensors().size(); ++s) EXPECT_TRUE(feeler.row("touch/force", s).isZero());
}

TEST(TouchFeel, HasNoFieldsWithoutSkin) {
  Feeler feeler(cube(), {});
  EXPECT_TRUE(feeler.sense.fields().empty());
  feeler.feel();
}

TEST(TouchFeel, NeverWritesToTheSimulation) {
  TouchOptions options;
  options.wanted |= MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE;
  Feeler feeler(cube(), {{kCubeBody, 0.008}, {3, 0.004}}, options);
  push(feeler, 0);
  const mjData& data = feeler.physics.data();
  const auto* bytes = static_cast<const std::uint8_t*>(data.buffer);
  const std::vector<std::uint8_t> before(bytes, bytes + data.nbuffer);
  const std::vector<std::uint8_t> head(reinterpret_cast<const std::uint8_t*>(&data),
                                       reinterpret_cast<const std::uint8_t*>(&data) + sizeof data);
  const Eigen::VectorXd first = feeler.sum("touch/force", kCubeBody);
  feeler.feel();
  EXPECT_EQ(feeler.sum("touch/force", kCubeBody), first) << "a second reading gives the same";
  EXPECT_TRUE(std::equal(before.begin(), before.end(), bytes));
  EXPECT_EQ(std::memcmp(head.data(), &data, sizeof data), 0);
}

}  // namespace
}  // namespace mimo::senses::touch
