// Rooms, welds, locks and poses that calls add to a scene, and scenes that are files with agents added to them.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <stdexcept>
#include <string>

#include "body/body.h"
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
using SceneFurnish = QuietTest;

constexpr double kDegree = mjPI / 180;

engine::Physics started(const scene::Scene& scene) {
  const engine::ModelPtr model = compile(scene);
  engine::Physics physics(model, {});
  body::read_stored_pose(*model, physics.start());
  physics.reset();
  return physics;
}

double angle(const engine::Physics& physics, const std::string& joint) {
  const mjModel& model = physics.model();
  return physics.data().qpos[model.jnt_qposadr[engine::find_or_fail(model, Kind::kJoint, joint)]];
}

std::vector<double> place(const engine::Physics& physics, const std::string& body) {
  return copy(physics.data().xpos + 3 * engine::find_or_fail(physics.model(), Kind::kBody, body), 3);
}

std::vector<double> turn(const engine::Physics& physics, const std::string& body) {
  return copy(physics.data().xquat + 4 * engine::find_or_fail(physics.model(), Kind::kBody, body), 4);
}

// ---- Rooms

TEST_F(SceneFurnish, AnEmptySceneGetsTheRoomOfFree) {
  scene::Scene scene(scene::Source{});
  scene.set_room("playroom");
  scene.add_body("mitten", "", nullptr);
  const engine::ModelPtr expected = room_with_infant("free"), actual = compile(scene);
  expect_same_physics(*expected, *actual);
  EXPECT_EQ(actual->nlight, expected->nlight);
  EXPECT_EQ(actual->ntex, expected->ntex);
  EXPECT_EQ(actual->opt.cone, mjCONE_ELLIPTIC);
  EXPECT_EQ(actual->stat.extent, expected->stat.extent);
}

TEST_F(SceneFurnish, KeepsWhatASceneDefines) {
  scene::Scene scene(from_text(
      "<mujoco><option timestep='0.002'/><visual><map znear='0.5'/></visual><custom><numeric name='mimo:place' "
      "data='1 2 3 1 0 0 0'/></custom><default><geom contype='4' conaffinity='4'/></default></mujoco>"));
  scene.set_room("playroom");
  scene.add_body("mitten", "", nullptr);
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(model->opt.timestep, 0.002);
  EXPECT_EQ(model->opt.iterations, 50) << "of what it does not say, the room's";
  EXPECT_EQ(model->vis.map.znear, 0.5f);
  EXPECT_EQ(model->geom_contype[engine::find_or_fail(*model, Kind::kGeom, "floor")], 1);
  EXPECT_EQ(copy(model->body_pos + 3 * engine::find_or_fail(*model, Kind::kBody, "mimo_location"), 3),
            (std::vector<double>{1, 2, 3}));
}

TEST_F(SceneFurnish, OneRoomIsEnough) {
  scene::Scene built_in(named("reach"));
  expect_error(Status::kInvalidArgument, "room already", [&] { built_in.set_room("playroom"); });
  scene::Scene own(from_text("<mujoco><worldbody><geom name='floor' size='1'/></worldbody></mujoco>"));
  const std::string before = own.xml();
  expect_error(Status::kInvalidArgument, "\"floor\"", [&] { own.set_room("playroom"); });
  expect_error(Status::kNotFound, "there are: playroom", [&] { own.set_room("attic"); });
  EXPECT_EQ(own.xml(), before);
}

// ---- Poses

const std::string kDrawer =
    "<default><geom contype='0'/><joint limited='true'/><default class='rail'><joint type='slide' range='0 "
    ".4'/></default></default>"
    "<worldbody><body name='chest'><geom size='.1'/>"
    "<body name='drawer'><joint name='rail' class='rail'/><geom size='.1'/></body>"
    "<body name='door'><joint name='hinge' range='-90 45' ref='10'/><geom size='.1'/></body>"
    "<body name='ball' pos='0 0 1'><joint name='ball' type='ball' limited='false'/><geom size='.1'/></body>"
    "</body></worldbody>";

TEST_F(SceneFurnish, JointsStartWhereTheyAreSet) {
  scene::Scene scene(named("standup"));
  scene.add_body("mitten", "anna/", nullptr);
  scene::Model chest;
  chest.name = "chest";
  chest.xml = "<mujoco>" + kDrawer + "</mujoco>";
  chest.fixed = true;
  scene.add_model(chest);
  scene.start_joint("chest/rail", 0.25);
  scene.start_joint("chest/hinge", -1);
  scene.start_joint("chest/hinge", -1.25);          // the last word counts
  scene.start_joint("anna/robot:head_tilt", 0.5);   // the recipe says nothing about this one
  scene.start_joint("anna/robot:left_knee", -1.5);  // and something else about this one
  engine::Physics physics = started(scene);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(angle(physics, "chest/rail"), 0.25);
    EXPECT_EQ(angle(physics, "chest/hinge"), -1.25);
    EXPECT_EQ(angle(physics, "anna/robot:head_tilt"), 0.5);
    EXPECT_EQ(angle(physics, "anna/robot:left_knee"), -1.5);
    EXPECT_EQ(angle(physics, "anna/robot:right_knee"), -2.53125) << "as the recipe says";
    physics.step(3);
    physics.reset();
  }
}

TEST_F(SceneFurnish, RangesComeFromTheClassInItsUnit) {
  for (const char* settings : {"", "<compiler angle='radian'/>"}) {
    scene::Scene scene(from_text(std::string("<mujoco>") + settings + kDrawer + "</mujoco>"));
    const std::string before = scene.xml();
    const double high = *settings == '\0' ? 45 * kDegree : 45;
    for (const auto& set : {&scene::Scene::start_joint, &scene::Scene::lock_joint}) {
      expect_error(Status::kInvalidArgument, "0 to 0.4 metres", [&] { (scene.*set)("rail", 0.41); });
      expect_error(Status::kInvalidArgument, "radians", [&] { (scene.*set)("hinge", 1.001 * high); });
      expect_error(Status::kInvalidArgument, "of type ball", [&] { (scene.*set)("ball", 0); });
      expect_error(Status::kNotFound, "there are: rail, hinge, ball", [&] { (scene.*set)("wheel", 0); });
      EXPECT_EQ(scene.xml(), before);
    }
    scene.start_joint("hinge", 0.999 * high);
  }
}

// Poses that documents store: of joints, and of the root of an infant; prefixes end with a slash.
TEST_F(SceneFurnish, StoredPoses) {
  const auto document = [](const std::string& custom) {
    return "<mujoco><worldbody><body name='a'><joint name='j'/><geom size='.1'/></body><body name='c' pos='0 0 "
           "3'><joint "
           "name='ball' type='ball'/><geom size='.1'/></body><body name='x/mimo_location' pos='0 0 "
           "1'><freejoint/><geom "
           "size='.1'/></body><body name='y/mimo_location'><geom size='.1'/></body></worldbody><custom>" +
           custom + "</custom></mujoco>";
  };
  const auto pose = [](const std::string& tuple, const std::string& joint) {
    return "<tuple name='" + tuple + "'><element objtype='joint' objname='" + joint + "' prm='0.7'/></tuple>";
  };
  const auto start = [&](const std::string& custom) { return started(scene::Scene(from_text(document(custom)))); };
  EXPECT_EQ(angle(start(pose("mimo:pose", "j")), "j"), 0.7);
  EXPECT_EQ(angle(start(pose("cup/mimo:pose", "j")), "j"), 0.7);
  EXPECT_EQ(angle(start(pose("notmimo:pose", "j")), "j"), 0);
  expect_error(Status::kModel, "joint ball is not a hinge", [&] { start(pose("mimo:pose", "ball")); });
  engine::Physics placed = start("<numeric name='x/mimo:root' data='1 2 3 0 0 0 2'/>");
  EXPECT_EQ(place(placed, "x/mimo_location"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(copy(placed.data().qpos + placed.model().nq - 4, 4), (std::vector<double>{0, 0, 0, 1})) << "normalised";
  expect_error(Status::kModel, "y/mimo_location has no free joint",
               [&] { start("<numeric name='y/mimo:root' data='1 2 3 1 0 0 0'/>"); });
}

// ---- Locks

TEST_F(SceneFurnish, LockedJointsStay) {
  scene::Scene scene(named("free"));
  scene.add_body("mitten", "anna/", nullptr);
  scene::Model chest;
  chest.name = "chest";
  chest.xml = "<mujoco>" + kDrawer + "</mujoco>";
  chest.fixed = true;
  chest.pose.position = {3, 0, 3};
  scene.add_model(chest);
  const int equalities = compile(scene)->neq;
  scene.lock_joint("anna/robot:left_elbow", -1);
  scene.lock_joint("chest/hinge", 0.5);
  scene.lock_joint("chest/hinge", 0.6);
  scene.lock_joint("chest/rail", 0.1);
  engine::Physics physics = started(scene);
  EXPECT_EQ(physics.model().neq, equalities + 2) << "an infant's joints have theirs already";
  physics.step(100);
  EXPECT_NEAR(angle(physics, "anna/robot:left_elbow"), -1, 0.02);
  EXPECT_NEAR(angle(physics, "chest/hinge"), 0.6, 0.02);
  EXPECT_NEAR(angle(physics, "chest/rail"), 0.1, 0.01);
  EXPECT_GT(angle(physics, "anna/robot:right_elbow"), -0.5) << "nobody holds this one";
}

// ---- Welds

// Where the weld of a body wants it to be in the other's frame.
const double* held_at(const mjModel& model, const std::string& body) {
  const int id = engine::find_or_fail(model, Kind::kBody, body);
  for (int i = 0; i < model.neq; ++i) {
    if (model.eq_type[i] == mjEQ_WELD && model.eq_obj2id[i] == id) return model.eq_data + i * mjNEQDATA + 3;
  }
  throw std::runtime_error("no weld of " + body);
}

// Where everything is at the start, it stays, whatever qpos0 says.
TEST_F(SceneFurnish, WeldedAsTheyStart) {
  scene::Scene scene(named("standup"));
  scene.add_body("mitten", "anna/", nullptr);
  scene::Object ball;
  ball.name = "ball";
  ball.size = {0.03, 0, 0};
  ball.pose = {{0.4, 0.1, 0.6}, {0.5, 0.5, -0.5, 0.5}};
  scene.add_object(ball);
  scene.weld({"ball", "anna/head"}, nullptr);
  scene.weld({"anna/left_lower_arm", "world"}, nullptr);
  scene.start_joint("anna/robot:head_tilt", 0.4);  // after the weld
  engine::Physics physics = started(scene);
  ASSERT_GT(std::abs(place(physics, "anna/head")[2] - 0.8), 0.1) << "it squats, unlike in qpos0";
  const auto apart = [&] {  // the ball in the head's frame
    double offset[3], local[3];
    const auto head = place(physics, "anna/head"), there = place(physics, "ball"), facing = turn(physics, "anna/head");
    mju_sub3(offset, there.data(), head.data());
    double back[4];
    mju_negQuat(back, facing.data());
    mju_rotVecQuat(local, offset, back);
    return copy(local, 3);
  };
  const std::vector<double> at_first = apart(), arm = place(physics, "anna/left_lower_arm");
  EXPECT_TRUE(close(at_first, held_at(physics.model(), "ball"), {1e-9, 1e-9}));
  EXPECT_TRUE(close(arm, held_at(physics.model(), "anna/left_lower_arm"), {1e-9, 1e-9}));
  physics.step(100);
  physics.update_poses();
  EXPECT_TRUE(close(at_first, apart().data(), {0, 0.01}));
  EXPECT_TRUE(close(arm, place(physics, "anna/left_lower_arm").data(), {0, 0.01}));
}

// The pose of the first in the frame of the second: a ball is drawn to where that says.
TEST_F(SceneFurnish, WeldedInAPose) {
  const std::string document =
      "<mujoco><option gravity='0 0 0' timestep='.005'/><worldbody><body name='a' pos='1 0 0' quat='1 0 0 1'><geom "
      "size='.1'/></body><body name='b' pos='1 1.1 0'><freejoint/><geom size='.1' mass='1'/></body></worldbody>"
      "</mujoco>";
  const document::Pose pose{{1, 0, 0.5}, {2, 2, 0, 0}};
  for (const char* other : {"a", "world"}) {
    scene::Scene scene(from_text(document));
    scene.weld({"b", other}, &pose);
    engine::Physics physics = started(scene);
    physics.step(400);
    physics.update_poses();
    const bool world = std::string(other) == "world";
    const std::vector<double> there = world ? std::vector<double>{1, 0, 0.5} : std::vector<double>{1, 1, 0.5};
    const double half = std::sqrt(0.5);
    const std::vector<double> turned = world ? std::vector<double>{half, half, 0, 0} : std::vector<double>(4, 0.5);
    EXPECT_TRUE(close(there, place(physics, "b").data(), {0, 1e-3})) << other;
    EXPECT_TRUE(same_rotation(turned, turn(physics, "b").data(), {0, 1e-3})) << other;
  }
}

TEST_F(SceneFurnish, WeldsNeedBodies) {
  scene::Scene scene(from_text("<mujoco><worldbody><body name='a'/><body name='b'/></worldbody></mujoco>"));
  const std::string before = scene.xml();
  const document::Pose pose;
  for (const document::Pose* given : {static_cast<const document::Pose*>(nullptr), &pose}) {
    expect_error(Status::kNotFound, "\"c\"; there are: a, b", [&] { scene.weld({"c", "a"}, given); });
    expect_error(Status::kNotFound, "\"d\"; there are: a, b", [&] { scene.weld({"a", "d"}, given); });
    expect_error(Status::kInvalidArgument, "\"a\"", [&] { scene.weld({"a", "a"}, given); });
    EXPECT_EQ(scene.xml(), before);
  }
}

// Main defaults of a user's document do not switch off what calls add.
TEST_F(SceneFurnish, MainDefaultsDoNotReachWeldsAndLocks) {
  scene::Scene scene(
      from_text("<mujoco><default><equality active='false' solref='1 1' solimp='.1 .2 .3'/></default><worldbody>"
                "<body name='a'><joint name='j'/><geom size='1'/></body></worldbody></mujoco>"));
  const document::Pose pose;
  scene.weld({"a", "world"}, &pose);
  scene.lock_joint("j", 1);
  const engine::ModelPtr model = compile(scene);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(((*model).*compat::kLockFlags)[i], 1);
    EXPECT_EQ(model->eq_solref[2 * i], 0.02);
    EXPECT_EQ(model->eq_solimp[5 * i], 0.9);
  }
}

// A stored pose may stand in any section; there is one of it.
TEST_F(SceneFurnish, LocksJoinTheStoredPose) {
  scene::Scene scene(named("babybench-cubes"));
  scene.add_body("mitten", "", nullptr);
  const engine::ModelPtr without = compile(scene);
  scene.lock_joint("robot:left_elbow", -1);
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(model->ntuple, without->ntuple);
}

// ---- Infants in scenes that are files

TEST_F(SceneFurnish, AFileWithSettingsOfItsOwn) {
  const Folder folder;
  const std::string file =
      folder.write("room.xml",
                   "<mujoco><compiler angle='radian' eulerseq='zyx' autolimits='true' meshdir='m'/><option "
                   "timestep='0.005' cone='elliptic'/><size nconmax='300' njmax='900' nstack='400000'/><default><geom "
                   "condim='1' rgba='1 0 0 1'/><joint damping='7' range='-1 1'/></default><worldbody><geom "
                   "type='plane' size='0 0 1'/><body name='box' pos='2 0 .5'><joint name='j'/><geom type='box' "
                   "size='.1 .1 .1'/></body></worldbody><keyframe><key qpos='1'/></keyframe></mujoco>");
  scene::Scene scene(from_file(file));
  const document::Pose left{{0, 1, 0.4}, {1, 0, 0, 0}}, right{{0, -1, 0.4}, {1, 0, 0, 0}};
  scene.add_body("mitten", "anna/", &left);
  scene.add_body("mitten", "ben/", &right);
  const engine::ModelPtr model = compile(scene), sole = room_with_infant("free");
  EXPECT_EQ(model->njmax, 900) << "as its author decided";
  EXPECT_EQ(model->jnt_limited[engine::find_or_fail(*model, Kind::kJoint, "j")], 1);
  for (const char* joint : {"robot:left_knee", "robot:head_swivel"}) {
    const int expected = engine::find_or_fail(*sole, Kind::kJoint, joint);
    const int actual = engine::find_or_fail(*model, Kind::kJoint, std::string("ben/") + joint);
    EXPECT_TRUE(close(copy(sole->jnt_range + 2 * expected, 2), model->jnt_range + 2 * actual));
    EXPECT_EQ(model->dof_damping[model->jnt_dofadr[actual]], sole->dof_damping[sole->jnt_dofadr[expected]]);
  }
}

// The infant that a file brings along and one that is added share what they are made of.
TEST_F(SceneFurnish, AFileWithAnInfantGetsAnother) {
  scene::Scene scene(from_text("<mujoco><include file='mimo/mitten.xml'/></mujoco>"));
  const document::Pose place{{0, 1, 0.4}, {1, 0, 0, 0}};
  scene.add_body("mitten", "ben/", &place);
  const engine::ModelPtr model = compile(scene), sole = room_with_infant("free");
  EXPECT_EQ(model->nu, 2 * sole->nu);
  EXPECT_EQ(model->nmat + 1, sole->nmat) << "all but the room's";
}

TEST_F(SceneFurnish, ScenesNameTheirInfants) {
  EXPECT_TRUE(scene::Scene(named("reach")).infants().empty());
  EXPECT_EQ(scene::Scene(named("playdate")).infants(), (std::vector<std::string>{"anna", "ben"}));
  EXPECT_EQ(scene::Scene(from_text("<mujoco><custom><text name='mimo:infants' data=' a  b c '/></custom></mujoco>"))
                .infants(),
            (std::vector<std::string>{"a", "b", "c"}));
}

TEST_F(SceneFurnish, CopiesOfScenesAreApart) {
  scene::Scene scene(named("free"));
  scene.add_body("mitten", "", nullptr);
  scene.weld({"mimo_location", "world"}, nullptr);
  const std::string before = scene.xml();
  scene::Scene twin(scene);
  EXPECT_EQ(twin.xml(), before);
  twin.lock_joint("robot:left_knee", -1);
  EXPECT_NE(twin.xml(), before);
  EXPECT_EQ(scene.xml(), before);
}

}  // namespace
}  // namespace mimo::test
