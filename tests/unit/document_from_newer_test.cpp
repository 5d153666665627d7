// Documents that were written for newer versions of MuJoCo; what the words mean there is from its documentation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "compat/mujoco.h"
#include "repository_paths.h"
#include "support/files.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using SceneNewer = QuietTest;

// A scene's warnings, and the model that comes of it.
struct Loaded {
  engine::ModelPtr model;
  std::vector<std::string> warnings;
};

Loaded load(const std::string& xml) {
  Loaded loaded;
  scene::Source source = from_text(xml);
  source.log = LogSink([&loaded](const LogRecord& record) { loaded.warnings.push_back(record.text); });
  loaded.model = compile(scene::Scene(source));
  return loaded;
}

// An arm with one hinge, and what else a test puts beside it.
std::string arm(const std::string& joint, const std::string& rest, const std::string& before = "") {
  return "<mujoco>" + before + "<worldbody><body><joint name='elbow' " + joint +
         "/><geom size='.1'/></body></worldbody>" + rest + "</mujoco>";
}

void expect_refused(const std::string& xml, const std::string& what) {
  expect_error(Status::kModel, what, [&] { load(xml); });
}

#if !MIMO_MUJOCO_4  // which knows the words
TEST_F(SceneNewer, HarmlessAttributesAreLeftOutWithOneWarning) {
  const Loaded loaded = load(
      "<mujoco>\n<option ccd_iterations='50'/><visual><global bvactive='true'/></visual>\n"
      "<worldbody>\n<camera resolution='2 2'/><camera resolution='2 2'/>\n<geom size='1'/></worldbody></mujoco>");
  ASSERT_EQ(loaded.warnings.size(), 3u);
  EXPECT_EQ(loaded.model->ncam, 2);
  EXPECT_EQ(
      loaded.warnings[2],
      "xml text, line 4 (and 1 more): MuJoCo 2.2.2 does not know the attribute resolution of <camera>; it is left "
      "out");
}

TEST_F(SceneNewer, NearestIntegrator) {
  const Loaded loaded = load(arm("", "", "<option integrator='implicitfast'/>"));
  EXPECT_EQ(loaded.model->opt.integrator, mjINT_IMPLICIT);
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_NE(loaded.warnings[0].find("\"implicit\" comes nearest"), std::string::npos) << loaded.warnings[0];
}
#endif

TEST_F(SceneNewer, LimitsAreInferred) {
  const Loaded loaded = load(arm("range='-90 90'", "<actuator><motor joint='elbow' ctrlrange='-1 1'/></actuator>"));
  EXPECT_EQ(loaded.model->jnt_limited[0], 1);
  EXPECT_EQ(loaded.model->actuator_ctrllimited[0], 1);
  EXPECT_EQ(loaded.model->actuator_forcelimited[0], 0);
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_EQ(load(arm("limited='false' range='-90 90'", "")).model->jnt_limited[0], 0);
  expect_refused(arm("range='-90 90'", "", "<compiler autolimits='false'/>"), "autolimits");
}

// force = kp * (target - position) - kv * velocity
TEST_F(SceneNewer, PositionActuatorsWithDamping) {
  const Loaded loaded =
      load(arm("", "<actuator><position joint='elbow' class='p'/><position joint='elbow' kp='3'/></actuator>",
               "<default><default class='p'><position kp='20' kv='2'/></default></default>"));
  EXPECT_TRUE(loaded.warnings.empty());
  const mjModel& m = *loaded.model;
  EXPECT_EQ(m.actuator_gainprm[0], 20);
  EXPECT_EQ(m.actuator_biasprm[1], -20);
  EXPECT_EQ(m.actuator_biasprm[2], -2);
  EXPECT_EQ(m.actuator_gainprm[mjNGAIN], 3);
  EXPECT_EQ(m.actuator_biasprm[mjNBIAS + 1], -3);
  EXPECT_EQ(m.actuator_biasprm[mjNBIAS + 2], 0);
}

TEST_F(SceneNewer, TargetsInheritTheJointsRange) {
  const engine::ModelPtr m =
      load(arm("range='-90 30'", "<actuator><position joint='elbow' inheritrange='.5'/></actuator>")).model;
  const double degree = 3.14159265358979323846 / 180;
  EXPECT_NEAR(m->actuator_ctrlrange[0], -60 * degree, 1e-12);
  EXPECT_NEAR(m->actuator_ctrlrange[1], 0 * degree, 1e-12);
  EXPECT_EQ(m->actuator_ctrllimited[0], 1);
}

#if !MIMO_MUJOCO_4  // which knows the words
// The joint feels gear * force.
TEST_F(SceneNewer, LimitOfAJointsForceIsItsOnlyMotors) {
  const engine::ModelPtr m =
      load(arm("actuatorfrcrange='-6 4'", "<actuator><motor joint='elbow' gear='-2'/></actuator>")).model;
  EXPECT_EQ(m->actuator_forcelimited[0], 1);
  EXPECT_EQ(m->actuator_forcerange[0], -2);
  EXPECT_EQ(m->actuator_forcerange[1], 3);
  const engine::ModelPtr both =
      load(arm("actuatorfrcrange='-6 4'", "<actuator><motor joint='elbow' forcerange='-5 5'/></actuator>")).model;
  EXPECT_EQ(both->actuator_forcerange[0], -5);
  EXPECT_EQ(both->actuator_forcerange[1], 4);
  expect_refused(arm("actuatorfrcrange='-6 4'", "<actuator><motor joint='elbow'/><motor joint='elbow'/></actuator>"),
                 "MuJoCo 2.2.2 does not know the attribute actuatorfrcrange of <joint>");
}

TEST_F(SceneNewer, RefusesUnsupportedElementsByName) {
  expect_refused("<mujoco>\n<worldbody>\n<body gravcomp='1'/></worldbody></mujoco>",
                 "xml text, line 3: MuJoCo 2.2.2 does not know the attribute gravcomp of <body> (\"1\")");
  expect_refused("<mujoco><worldbody><frame/></worldbody></mujoco>",
                 "xml text, line 1: MuJoCo 2.2.2 does not know <frame> in <worldbody>");
  expect_refused("<mujoco><worldbody><geom sice='1'/></worldbody></mujoco>",
                 "does not know the attribute sice of <geom>");
  expect_refused(arm("", "<actuator><position joint='elbow' dampratio='1'/></actuator>"), "dampratio of <position>");
  expect_refused("<mujoco><deformable/></mujoco>", "does not know <deformable> in <mujoco>");
  EXPECT_EQ(
      load("<mujoco><worldbody><body gravcomp='0.0'><geom size='1'/></body></worldbody></mujoco>").warnings.size(), 1u);
}
#endif

TEST_F(SceneNewer, RenamesElements) {
  const Folder folder;
  folder.copy_of(std::string(MIMO_MODELS) + "/textures/ball_c.png", "a/mine.png");
  const std::string path = folder.write(
      "room.xml",
      "<mujoco><compiler assetdir='a'/><asset><texture name='t' type='2d' file='mine.png'/></asset><worldbody>"
      "<light type='directional'/><geom size='1'/></worldbody></mujoco>");
  const engine::ModelPtr model = compile(scene::Scene(from_file(path)));
  EXPECT_EQ(model->ntex, 1);
  EXPECT_TRUE(compat::is_directional(*model, 0));
}

// A hollow cube of side 2 and mass 12 has 12/6 * 2^2 * 5/3 = 40/3 about its middle, a full one 12/6 * 2^2 = 8.
TEST_F(SceneNewer, ShellsOfMeshes) {
  const std::string corners = "-1 -1 -1  1 -1 -1  -1 1 -1  1 1 -1  -1 -1 1  1 -1 1  -1 1 1  1 1 1";
  const auto inertia = [&](const std::string& kind) {
    return load("<mujoco><asset><mesh name='m' " + kind + " vertex='" + corners +
                "'/></asset><worldbody><body><geom type='mesh' mesh='m' mass='12'/></body></worldbody></mujoco>")
        .model->body_inertia[3];
  };
  EXPECT_NEAR(inertia("inertia='shell'"), 40.0 / 3, 1e-5);
  EXPECT_NEAR(inertia(""), 8, 1e-5);
}

TEST_F(SceneNewer, AdhesionIsLimitedByItsClass) {
  const Loaded loaded = load(
      "<mujoco><default><adhesion ctrlrange='0 2'/></default><worldbody><body name='b'><geom size='1'/></body>"
      "</worldbody><actuator><adhesion body='b'/></actuator></mujoco>");
  EXPECT_EQ(loaded.model->actuator_ctrlrange[1], 2);
}

TEST_F(SceneNewer, BuiltInScenesUseNoRemovedMjcf) {
  scene::Scene scene(named("benchmark"));
  scene.add_body("mitten", "", nullptr);
  EXPECT_EQ(scene.xml().find("apirate"), std::string::npos);
  EXPECT_NE(scene.xml().find("autolimits=\"true\""), std::string::npos);
  EXPECT_EQ(scene.xml().find("mimo:line"), std::string::npos);
}

std::string filmed(const std::string& camera, const std::string& before = "") {
  return "<mujoco>" + before + "<worldbody>\n<camera " + camera + "/><geom size='.1'/></worldbody></mujoco>";
}

// 2 atan(0.006 / 2 / 0.01) = 33.3985 degrees. A pixel is 0.006 / 100 high: 10 mm are 166.667 of them.
TEST_F(SceneNewer, LensesOfCameras) {
  const double expected = 2 * std::atan(0.003 / 0.01) * 180 / 3.14159265358979323846;
  ASSERT_NEAR(expected, 33.3985, 1e-4);
  const std::string sensor = "sensorsize='0.0096 0.006' resolution='160 100'";
  for (const std::string& xml :
       {filmed("focal='0.01 0.01' " + sensor), filmed("focalpixel='166.6666667 166.6666667' " + sensor),
        filmed("class='c'",
               "<default><default class='c'><camera focal='0.01 0.01' " + sensor + "/></default></default>"),
        filmed("class='c' focal='0.01 0.01'",
               "<default><camera fovy='70'/><default class='c'><camera " + sensor + "/></default></default>")}) {
    const Loaded loaded = load(xml);
    EXPECT_NEAR(loaded.model->cam_fovy[0], expected, 1e-4) << xml;
    for (const std::string& warning : loaded.warnings)
      EXPECT_NE(warning.find("resolution"), std::string::npos) << warning;
  }
}

#if !MIMO_MUJOCO_4
TEST_F(SceneNewer, RefusesCamerasThatNoFieldOfViewDescribes) {
  const std::string sensor = "focal='0.01 0.01' sensorsize='0.0096 0.006' ";
  const auto warned = [](const std::string& camera, const std::string& what) {
    const Loaded loaded = load(filmed(camera));
    const auto says = [&](const std::string& warning) { return warning.find(what) != std::string::npos; };
    EXPECT_EQ(std::count_if(loaded.warnings.begin(), loaded.warnings.end(), says), 1) << what;
    return loaded.model->cam_fovy[0];
  };
  const char* const moved =
      "xml text, line 2: MuJoCo 2.2.2 does not know principal points: the picture of this <camera> is "
      "moved by 10 % of its width and -5 % of its height";
  warned(sensor + "principal='0.00096 -0.0003' resolution='160 100'", moved);
  warned(sensor + "principalpixel='16 -5' resolution='160 100'", moved);
  warned(sensor + "resolution='160 200'", "are 2 times as wide as high");
  EXPECT_EQ(warned("fovy='3' projection='orthographic'", "this one shows in perspective, 45 degrees high"), 45);
  EXPECT_EQ(warned("fovy='3' orthographic='true'", "this one shows in perspective, 45 degrees high"), 45);
  // Without a sensor the lens says nothing.
  EXPECT_EQ(warned("fovy='50' focal='0.01 0.01'", "the attribute focal of <camera>; it is left out"), 50);
}
#endif

}  // namespace
}  // namespace mimo::test
