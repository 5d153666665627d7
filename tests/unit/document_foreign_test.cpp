// Infants and objects in scenes that were not made for them: neither gets anything of the other's settings.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <string>

#include "compat/mujoco.h"
#include "engine/physics.h"
#include "support/files.h"
#include "support/physical.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using SceneForeign = QuietTest;

// Two bodies of which one cannot be seen to have an inertia, and a third without a name that is welded to the first.
const std::string kRobot =
    "<worldbody><body name='bot' pos='3 0 1'><freejoint/>"
    "<inertial pos='.01 0 0' mass='2' diaginertia='.3 .2 .4'/><geom name='shell' size='.1' group='3'/>"
    "<body pos='.2 0 0'><geom size='.02' density='100' group='1'/></body>"
    "<body name='arm' pos='0 0 .3'><joint name='bend' axis='0 1 0'/><geom type='capsule' size='.02 .1' group='3'/>"
    "<geom name='looks' size='.3' contype='0' conaffinity='0' group='2'/></body></body></worldbody>";

const char* const kSettings[] = {"settotalmass='14'",
                                 "boundmass='0.5'",
                                 "boundinertia='0.01'",
                                 "balanceinertia='true'",
                                 "inertiagrouprange='3 4'",
                                 "inertiafromgeom='true'",
#if !MIMO_MUJOCO_4
                                 "exactmeshinertia='true'",
                                 "convexhull='false'",
#endif
                                 "discardvisual='true'",
                                 "fusestatic='true'",
                                 "eulerseq='zyx'",
                                 "angle='radian'",
                                 "inertiagrouprange='3 4' settotalmass='5' fusestatic='true'",
                                 "autolimits='true'",
                                 "fitaabb='true'",
                                 "usethread='false'",
                                 "strippath='true'",
                                 "boundmass='2' boundinertia='1' balanceinertia='true'"};

void expect_same_body(const mjModel& one, const std::string& name, const mjModel& other, const std::string& there) {
  const int a = engine::find(one, Kind::kBody, name.c_str()), b = engine::find(other, Kind::kBody, there.c_str());
  ASSERT_GE(a, 0) << name;
  ASSERT_GE(b, 0) << there;
  EXPECT_DOUBLE_EQ(one.body_mass[a], other.body_mass[b]) << name;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(one.body_inertia[3 * a + i], other.body_inertia[3 * b + i], 1e-15) << name;
    EXPECT_NEAR(one.body_ipos[3 * a + i], other.body_ipos[3 * b + i], 1e-15) << name;
  }
}

TEST_F(SceneForeign, SettingsReachNeitherInfantsNorObjects) {
  scene::Scene neutral(from_text("<mujoco/>"));
  const document::Pose place{{0, 0, 1}, {1, 0, 0, 0}};
  neutral.add_body("mitten", "", &place);
  const scene::Object ball{"ball", scene::ObjectShape::kSphere, {.001, 0, 0}, {{2, 2, 2}, {1, 0, 0, 0}}, 1e-4, {},
                           false};
  neutral.add_object(ball);
  const engine::ModelPtr expected = compile(neutral);
  for (const std::string setting : kSettings) {
    SCOPED_TRACE(setting);
    const std::string document = "<mujoco><compiler " + setting + "/>" + kRobot + "</mujoco>";
    const engine::ModelPtr alone = compiled(document);
    scene::Scene scene(from_text(document));
    scene.add_object(ball);
    scene.add_body("mitten", "", &place);
    const engine::ModelPtr model = compile(scene);
    for (int body = 1; body < expected->nbody; ++body) {
      const std::string name = engine::name(*expected, Kind::kBody, body);
      expect_same_body(*expected, name, *model, name);
      EXPECT_EQ(expected->body_geomnum[body], model->body_geomnum[engine::find(*model, Kind::kBody, name.c_str())]);
    }
    const int bot = engine::find(*alone, Kind::kBody, "bot");
    const int there = engine::find(*model, Kind::kBody, "bot");
    EXPECT_NEAR(model->body_subtreemass[there], alone->body_subtreemass[bot], 1e-12)
        << "what they do to the robot stays";
    expect_same_body(*alone, "arm", *model, "arm");
  }
}

// A main class in two sections, as includes bring them: what they say of one element adds up, the later one counts.
TEST_F(SceneForeign, MainDefaultsInSeveralSectionsAddUp) {
  scene::Scene scene(from_text(
      "<mujoco><default><geom condim='4' margin='.01'/></default><default><geom condim='6' gap='.002'/></default>"
      "<worldbody><body><geom name='own' size='.1'/></body></worldbody></mujoco>"));
  scene.add_object({"ball", scene::ObjectShape::kSphere, {.02, 0, 0}, {{2, 2, 2}, {1, 0, 0, 0}}, 0.1, {}, false});
  const engine::ModelPtr model = compile(scene);
  const int own = engine::find(*model, Kind::kGeom, "own"), ball = engine::find(*model, Kind::kGeom, "ball");
  EXPECT_EQ(model->geom_condim[own], 6);
  EXPECT_DOUBLE_EQ(model->geom_margin[own], 0.01);
  EXPECT_DOUBLE_EQ(model->geom_gap[own], 0.002);
  EXPECT_EQ(model->geom_margin[ball], 0) << "the object gets nothing of it";
}

// What settings do not reach, for a document that becomes an object.
TEST_F(SceneForeign, SettingsOfAModelApplyToItAlone) {
  for (const std::string setting : kSettings) {
    SCOPED_TRACE(setting);
    const std::string document = "<mujoco><compiler " + setting + "/>" + kRobot + "</mujoco>";
    const engine::ModelPtr alone = compiled(document);
    scene::Scene scene(from_text("<mujoco><compiler boundmass='1' inertiagrouprange='0 2'/></mujoco>"));
    scene::Model robot;
    robot.name = "its";
    robot.xml = document;
    robot.pose = {{3, 0, 1}, {1, 0, 0, 0}};
    scene.add_model(robot);
    const engine::ModelPtr model = compile(scene);
    const int bot = engine::find(*alone, Kind::kBody, "bot"), there = engine::find(*model, Kind::kBody, "its/bot");
    EXPECT_NEAR(model->body_subtreemass[there], alone->body_subtreemass[bot], 1e-12);
  }
}

#if !MIMO_MUJOCO_4  // where composites are elements like others
TEST_F(SceneForeign, GeneratedElementsCannotBeWeighedAlone) {
  scene::Scene scene(
      from_text("<mujoco><compiler settotalmass='3'/><worldbody><body><composite type='rope' count='3 1 1' "
                "spacing='.1'><geom type='capsule' size='.02 .03'/></composite></body></worldbody></mujoco>"));
  const std::string before = scene.xml();
  expect_error(Status::kUnsupported, "settotalmass=\"3\"", [&] { scene.add_body("mitten", "", nullptr); });
  EXPECT_EQ(scene.xml(), before);
}
#endif

// MuJoCo takes the last number of a size that is given twice, and refuses what is longer.
TEST_F(SceneForeign, UserNumbersFitBoth) {
  scene::Scene scene(from_text(
      "<mujoco><size nuser_actuator='5' nuser_jnt='0'/><worldbody><body><joint name='j'/><geom size='1'/></body>"
      "</worldbody><actuator><motor joint='j' user='1 2 3 4 5'/></actuator></mujoco>"));
  scene.add_body("mitten", "", nullptr);
  scene::Model model;
  model.name = "cup";
  model.xml = "<mujoco><worldbody><body><joint user='7 8'/><geom size='1'/></body></worldbody></mujoco>";
  scene.add_model(model);
  const engine::ModelPtr made = compile(scene);
  EXPECT_EQ(made->nuser_actuator, 5);
  EXPECT_EQ(made->actuator_user[4], 5);
  EXPECT_EQ(made->nuser_jnt, 2);
  const int lean = engine::find(*made, Kind::kActuator, "act:right_fingers");
  EXPECT_EQ(made->actuator_user[5 * lean], 3.019) << "the first number of the mitten's muscle";
}

// MuJoCo wants them in that order. What has a state may say so itself, by its kind, or in a class.
TEST_F(SceneForeign, MotorsWithAStateComeLast) {
  scene::Scene scene(from_text(
      "<mujoco><default><default class='slow'><general dyntype='filter' dynprm='.1'/></default>"
      "<default class='flesh'><muscle timeconst='.01 .04'/></default></default>"
      "<worldbody><body><joint name='j' range='-1 1' limited='true'/><geom size='1'/></body></worldbody><actuator>"
      "<motor name='plain' joint='j' class='slow'/><general name='none' class='slow' dyntype='none' joint='j'/>"
      "<general name='own' joint='j' dyntype='integrator'/><general name='class' joint='j' class='slow'/>"
      "<muscle name='muscle' joint='j' lengthrange='0 1'/><general name='flesh' joint='j' class='flesh' lengthrange='0 "
      "1'/><intvelocity name='kind' joint='j' ctrllimited='true' ctrlrange='-1 1' actrange='-1 "
      "1'/></actuator></mujoco>"));
  scene.add_body("mitten", "", nullptr);
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(model->nu, 7 + 44);
  EXPECT_EQ(model->na, 5);
  const char* const last[] = {"own", "class", "muscle", "flesh", "kind"};
  for (int i = 0; i < 5; ++i) EXPECT_STREQ(engine::name(*model, Kind::kActuator, model->nu - 5 + i), last[i]);
  EXPECT_STREQ(engine::name(*model, Kind::kActuator, 0), "plain");
}

TEST_F(SceneForeign, ANameInUseIsExplained) {
  scene::Scene scene(from_text("<mujoco><worldbody><body name='head'><geom size='1'/></body></worldbody></mujoco>"));
  const std::string before = scene.xml();
  expect_error(Status::kInvalidArgument, "a body \"head\"; give the agent a name",
               [&] { scene.add_body("mitten", "", nullptr); });
  EXPECT_EQ(scene.xml(), before);
  scene.add_body("mitten", "anna/", nullptr);
  EXPECT_GE(engine::find(*compile(scene), Kind::kBody, "anna/head"), 0);
}

#if !MIMO_MUJOCO_4  // which has no such limits
// Sizes for a scene without infants are too small for one.
TEST_F(SceneForeign, BuffersGrow) {
  scene::Scene scene(from_text("<mujoco><size nconmax='5' njmax='20' nstack='3000'/></mujoco>"));
  EXPECT_EQ(compile(scene)->nconmax, 5);
  scene.add_body("mitten", "", nullptr);
  const engine::ModelPtr model = compile(scene);
  EXPECT_GE(model->nconmax, 100);
  EXPECT_GE(model->njmax, 340);
  EXPECT_GE(model->nstack, 70000);
  scene::Scene generous(from_text("<mujoco><size nconmax='5000' njmax='2000'/></mujoco>"));
  generous.add_body("mitten", "", nullptr);
  EXPECT_EQ(compile(generous)->nconmax, 5000);
}
#endif

}  // namespace
}  // namespace mimo::test
