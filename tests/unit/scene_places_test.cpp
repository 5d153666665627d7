// Where an infant stands whom nobody has given a place, and what is said of one that starts inside of something.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/physics.h"
#include "repository_paths.h"
#include "support/files.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using ScenePlaces = QuietTest;

constexpr double kSole = 0.33;  // of who stands, below mimo_location; to 5 mm

std::string world(const std::string& content) {
  return "<mujoco><include file='mimo/parts/options.xml'/><worldbody>" + content + "</worldbody></mujoco>";
}

struct Start {
  double x, y, z;
  double deepest;  // m; positive inside of something
  double fastest;  // m/s, of the root in the first half second
};

Start start_in(const std::string& document) {
  scene::Scene scene(from_text(document));
  scene.add_body("mitten", "anna/", nullptr);
  engine::Physics physics(compile(scene), {});
  const int root = engine::find(physics.model(), Kind::kBody, "anna/mimo_location");
  const double* place = physics.data().xpos + 3 * root;
  Start start{place[0], place[1], place[2], 0, 0};
  const auto own = [&](int geom) { return physics.model().body_rootid[physics.model().geom_bodyid[geom]] == root; };
  for (int i = 0; i < physics.data().ncon; ++i) {
    const mjContact& contact = physics.data().contact[i];
    if (own(contact.geom1) != own(contact.geom2)) start.deepest = std::max(start.deepest, -contact.dist);
  }
  for (int step = 0; step < 100; ++step) {
    physics.step(1);
    const auto velocity = engine::body_velocity(physics.model(), physics.data(), root);
    for (std::size_t i = 0; i < 3; ++i) start.fastest = std::max(start.fastest, std::abs(velocity[i]));
  }
  return start;
}

// On its feet with nothing to hold it, it topples in half a second no faster than it would fall.
void expect_standing(const Start& start, double ground) {
  EXPECT_NEAR(start.z, ground + kSole, 0.005);
  EXPECT_EQ(start.deepest, 0);
  EXPECT_LT(start.fastest, 3) << "falling takes it to 2.5 m/s; what was inside the floor left it with 9";
}

TEST_F(ScenePlaces, OnTheFloor) {
  for (const double height : {0.0, 0.4, -2.0}) {
    SCOPED_TRACE(height);
    const Start start = start_in(world("<geom type='plane' size='5 5 1' pos='0 0 " + std::to_string(height) + "'/>"));
    EXPECT_EQ(start.x, 0);
    EXPECT_EQ(start.y, 0);
    expect_standing(start, height);
  }
}

TEST_F(ScenePlaces, OnATableThatLeavesNoRoomBelow) {
  const std::string floor = "<geom type='plane' size='5 5 1'/>";
  expect_standing(start_in(world(floor + "<geom type='box' size='.5 .5 .02' pos='0 0 .6'/>")), 0.62);
  expect_standing(start_in(world(floor + "<geom type='box' size='.5 .5 .02' pos='0 0 1.5'/>")), 0);
  expect_standing(start_in(world(floor + "<geom type='box' size='.5 .5 .5'/>")), 0.5);
}

TEST_F(ScenePlaces, OnUnevenGround) {
  const std::string ramp =
      "<asset><mesh name='ramp' vertex='-1 -1 0  1 -1 0  1 1 .3  -1 1 .3  -1 -1 -.5  1 -1 -.5  1 1 -.5  -1 1 -.5'/>"
      "</asset><worldbody><geom type='mesh' mesh='ramp'/></worldbody>";
  const std::string hill = "<asset><hfield name='hill' file='" + std::string(MIMO_MODELS) +
                           "/textures/ball_c.png' size='4 4 .3 .1'/></asset><worldbody><geom type='hfield' "
                           "hfield='hill'/></worldbody>";
  for (const std::string& ground : {ramp, hill}) {
    const Start start = start_in("<mujoco><include file='mimo/parts/options.xml'/>" + ground + "</mujoco>");
    EXPECT_EQ(start.deepest, 0);
    EXPECT_GT(start.z, kSole - 0.05);
    EXPECT_LT(start.z, kSole + 0.35) << "neither ground is higher than 0.3 m";
  }
}

TEST_F(ScenePlaces, BesideWhatStandsThere) {
  const std::string robot = "<body pos='0 0 .5'><freejoint/><geom type='box' size='.2 .2 .5'/></body>";
  const Start start = start_in(world("<geom type='plane' size='9 9 1'/>" + robot));
  EXPECT_GT(std::hypot(start.x, start.y), 0.25);
  EXPECT_LT(std::hypot(start.x, start.y), 1.1);
  EXPECT_NEAR(start.z, kSole, 0.005);
  EXPECT_EQ(start.deepest, 0);
}

// What cannot be touched is no ground.
TEST_F(ScenePlaces, WithoutGroundAtTheOrigin) {
  const Start start = start_in(world("<geom type='plane' size='5 5 1' pos='0 0 1' contype='0' conaffinity='0'/>"));
  EXPECT_EQ(start.z, 0);
}

TEST_F(ScenePlaces, OnObjectsAddedLater) {
  scene::Scene scene(from_text(world("")));
  scene.add_body("mitten", "", nullptr);
  scene.add_object({"block", scene::ObjectShape::kBox, {.5, .5, .1}, {{0, 0, 0}, {1, 0, 0, 0}}, 1, {1, 1, 1, 1}, true});
  const engine::ModelPtr model = compile(scene);
  EXPECT_NEAR(model->body_pos[3 * engine::find(*model, Kind::kBody, "mimo_location") + 2], 0.1 + kSole, 0.005);
}

std::vector<std::string> warnings(scene::Scene& scene) {
  std::vector<std::string> told;
  scene.check_places(compile(scene), LogSink([&told](const LogRecord& record) { told.push_back(record.text); }));
  return told;
}

TEST_F(ScenePlaces, ReportsAGivenPlaceThatIsTaken) {
  const std::string floor = world("<geom name='floor' type='plane' size='5 5 1'/>");
  const document::Pose inside{{0, 0, 0.3}, {1, 0, 0, 0}}, above{{0, 0, 0.34}, {1, 0, 0, 0}};
  scene::Scene scene(from_text(floor));
  scene.add_body("mitten", "anna/", &inside);
  const std::vector<std::string> told = warnings(scene);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("cm inside of geom \"floor\""), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("starts 2.9 cm"), std::string::npos) << told[0];  // 7 + 135 + 177 + 10 mm of legs, 300 of room
  scene::Scene other(from_text(floor));
  other.add_body("mitten", "", &above);
  EXPECT_TRUE(warnings(other).empty());
  scene::Scene unplaced(from_text(floor));
  unplaced.add_body("mitten", "", nullptr);
  EXPECT_TRUE(warnings(unplaced).empty());
}

TEST_F(ScenePlaces, AnInfantOfTheDocumentIsLeftAlone) {
  scene::Scene scene(
      from_text("<mujoco><include file='mimo/mitten.xml'/><worldbody><geom type='plane' size='5 5 1' pos='0 "
                "0 .3'/></worldbody></mujoco>"));
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(model->body_pos[3 * engine::find(*model, Kind::kBody, "mimo_location") + 2], 0.4);
}

}  // namespace
}  // namespace mimo::test
