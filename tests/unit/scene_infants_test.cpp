// Infants in a scene: names, places, several at once, and what a user's document may not do to them.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "body/body.h"
#include "compat/mujoco.h"
#include "support/physical.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using SceneInfants = QuietTest;

const document::Pose kLeft{{0, 1, 0.4}, {1, 0, 0, 0}};
const document::Pose kRight{{0, -1, 0.4}, {0.5, 0.5, 0.5, 0.5}};

const document::Pose kFar{{3, 0, 0.4}, {1, 0, 0, 0}};

engine::ModelPtr anna_and_ben() {
  scene::Scene scene(named("free"));
  scene.add_body("mitten", "anna/", &kLeft);
  scene.add_body("mitten", "ben/", &kRight);
  return compile(scene);
}

TEST_F(SceneInfants, PlaceOfTheRoom) {
  const engine::ModelPtr model = room_with_infant("free");
  const int root = engine::find_or_fail(*model, Kind::kBody, "mimo_location");
  EXPECT_EQ(copy(model->body_pos + 3 * root, 3), (std::vector<double>{0, 0, 0.4}));
  scene::Scene bare(from_text("<mujoco/>"));
  bare.add_body("mitten", "", nullptr);
  const engine::ModelPtr at_origin = compile(bare);
  const int there = engine::find_or_fail(*at_origin, Kind::kBody, "mimo_location");
  EXPECT_EQ(copy(at_origin->body_pos + 3 * there, 3), (std::vector<double>{0, 0, 0}));
}

TEST_F(SceneInfants, PlaceOfTheCaller) {
  const engine::ModelPtr model = anna_and_ben();
  const int anna = engine::find_or_fail(*model, Kind::kBody, "anna/mimo_location");
  const int ben = engine::find_or_fail(*model, Kind::kBody, "ben/mimo_location");
  EXPECT_EQ(copy(model->body_pos + 3 * anna, 3), (std::vector<double>{0, 1, 0.4}));
  EXPECT_EQ(copy(model->body_pos + 3 * ben, 3), (std::vector<double>{0, -1, 0.4}));
  EXPECT_EQ(copy(model->body_quat + 4 * ben, 4), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
}

TEST_F(SceneInfants, TwoInfantsHaveSeparateParts) {
  const engine::ModelPtr one = room_with_infant("free");
  const engine::ModelPtr two = anna_and_ben();
  EXPECT_EQ(two->nbody, 1 + 2 * (one->nbody - 1));
  EXPECT_EQ(two->ngeom, 1 + 2 * (one->ngeom - 1));
  EXPECT_EQ(two->nu, 2 * one->nu);
  EXPECT_EQ(two->nsensor, 2 * one->nsensor);
  EXPECT_EQ(two->ntendon, 2 * one->ntendon);
  EXPECT_EQ(two->neq, 2 * one->neq);
  EXPECT_EQ(two->npair, 2 * one->npair);
  EXPECT_EQ(two->nexclude, 2 * one->nexclude);
  EXPECT_EQ(two->nmat, one->nmat) << "materials are shared";
  const body::Body sole = body::find_body(*one, "");
  for (const char* prefix : {"anna/", "ben/"}) {
    const body::Body body = body::find_body(*two, prefix);
    ASSERT_EQ(body.joints.size(), 47u);
    ASSERT_EQ(body.actuators.size(), 44u);
    ASSERT_EQ(body.torques.size(), 21u);
    EXPECT_EQ(body.bodies.size(), sole.bodies.size());
    EXPECT_TRUE(close(10.90487, body::mass(*two, body)));
    for (std::size_t i = 0; i < 47; ++i) {
      EXPECT_EQ(engine::name(*two, Kind::kJoint, body.joints[i].id),
                prefix + std::string(engine::name(*one, Kind::kJoint, sole.joints[i].id)));
      EXPECT_EQ(body.joints[i].low, sole.joints[i].low);
      EXPECT_EQ(body.joints[i].high, sole.joints[i].high);
    }
  }
}

// Of the room for contacts, constraints and the solver half is enough, for one infant and for ten in a heap.
TEST_F(SceneInfants, BuffersAreLargeEnough) {
  for (const int count : {1, 2, 10}) {
    scene::Scene scene(named("free"));
    for (int i = 0; i < count; ++i) {
      const document::Pose place{{0.15 * (i % 2), 0.3 * (i / 2), 0.4}, {1, 0, 0, 0}};
      scene.add_body("mitten", std::to_string(i) + "/", &place);
    }
    engine::Physics physics(compile(scene), {});
    const mjModel& model = physics.model();
    int contacts = 0;
    for (int step = 0; step < 120; ++step) {
      for (int i = 0; i < model.nu; ++i) physics.data().ctrl[i] = std::sin(0.5 * step + i);
      physics.step(1);
      contacts = std::max(contacts, physics.data().ncon);
#if !MIMO_MUJOCO_4
      ASSERT_LT(2 * physics.data().ncon, model.nconmax) << count;
      ASSERT_LT(2 * physics.data().nefc, model.njmax) << count;
#endif
    }
    EXPECT_GT(contacts, 5 * count) << "they lie on the floor";
#if MIMO_MUJOCO_4  // one buffer for all
    EXPECT_LT(2 * physics.data().maxuse_arena, model.narena) << count;
#else
    EXPECT_LT(2 * physics.data().maxuse_stack, model.nstack) << count;
#endif
  }
}

// A motor of Ben's moves Ben as it would move a sole infant, and Anna not at all.
TEST_F(SceneInfants, TwoMoveIndependently) {
  engine::PhysicsOptions floating;
  floating.contacts = floating.gravity = false;
  engine::Physics both(anna_and_ben(), floating);
  engine::Physics sole(room_with_infant("free"), floating);
  both.data().ctrl[engine::find_or_fail(both.model(), Kind::kActuator, "ben/act:left_elbow")] = 0.5;
  sole.data().ctrl[engine::find_or_fail(sole.model(), Kind::kActuator, "act:left_elbow")] = 0.5;
  both.step(20);
  sole.step(20);
  const body::Body anna = body::find_body(both.model(), "anna/");
  const body::Body ben = body::find_body(both.model(), "ben/");
  const body::Body alone = body::find_body(sole.model(), "");
  double moved = 0;
  engine::Physics still(room_with_infant("free"), floating);
  still.step(20);
  for (std::size_t i = 0; i < 47; ++i) {
    const double expected = sole.data().qpos[alone.joints[i].qpos];
    EXPECT_TRUE(close(expected, both.data().qpos[ben.joints[i].qpos], {1e-9, 1e-11}));
    EXPECT_TRUE(close(still.data().qpos[alone.joints[i].qpos], both.data().qpos[anna.joints[i].qpos], {1e-9, 1e-11}));
    moved = std::max(moved, std::abs(expected - still.data().qpos[alone.joints[i].qpos]));
  }
  EXPECT_GT(moved, 0.1);
}

double stiffness(const mjModel& model, const std::string& joint) {
  return model.jnt_stiffness[engine::find_or_fail(model, Kind::kJoint, joint)];
}

double lock_stiffness(const mjModel& model, const std::string& lock) {
  return model.eq_solimp[mjNIMP * mj_name2id(&model, mjOBJ_EQUALITY, lock.c_str()) + 1];
}

// Mittens and five fingers have classes of the same names with other content. The numbers are the original's tables
// (tests/golden).
void expect_one_of_each(const engine::ModelPtr& model) {
  EXPECT_TRUE(close(10.90487, body::mass(*model, body::find_body(*model, "anna/"))));
  EXPECT_TRUE(close(10.8999078, body::mass(*model, body::find_body(*model, "ben/"))));
  EXPECT_EQ(stiffness(*model, "anna/robot:left_toes"), 0.106);
  EXPECT_EQ(stiffness(*model, "ben/robot:left_toes"), 0.053);
  EXPECT_EQ(lock_stiffness(*model, "anna/robot:left_elbow"), 0.95);
  EXPECT_EQ(lock_stiffness(*model, "ben/robot:left_elbow"), 0.99999);
}

TEST_F(SceneInfants, MittensAndFingersInOneScene) {
  scene::Scene first(named("free")), second(named("free"));
  first.add_body("mitten", "anna/", &kLeft);
  first.add_body("fingers", "ben/", &kRight);
  expect_one_of_each(compile(first));
  second.add_body("fingers", "ben/", &kRight);
  second.add_body("mitten", "anna/", &kLeft);
  second.add_body("fingers", "carl/", &kFar);
  expect_one_of_each(compile(second));
  scene::Scene included(from_text("<mujoco><include file='mimo/mitten.xml'/></mujoco>"));
  included.add_body("fingers", "ben/", &kRight);
  EXPECT_EQ(stiffness(*compile(included), "robot:left_toes"), 0.106);
  EXPECT_EQ(stiffness(*compile(included), "ben/robot:left_toes"), 0.053);
}

// One recipe does for both; what it says about a mitten does not concern five fingers.
TEST_F(SceneInfants, RecipesFitTheBody) {
  const engine::ModelPtr mitten = room_with_infant("reach"), fingers = room_with_infant("reach", "fingers");
  const auto welds = [](const mjModel& model) {
    return std::count(model.eq_type, model.eq_type + model.neq, mjEQ_WELD);
  };
  EXPECT_EQ(welds(*mitten), 6);
  EXPECT_EQ(welds(*fingers), 5);
  EXPECT_EQ(fingers->nu, 4 + 3 + 22) << "arm, wrist and fingers";
  scene::Scene standup(named("standup"));
  const std::string before = standup.xml();
  expect_error(Status::kInvalidArgument, "body \"fingers\": the scene is made for mitten only",
               [&] { standup.add_body("fingers", "", nullptr); });
  EXPECT_EQ(standup.xml(), before);
}

TEST_F(SceneInfants, DuplicatesAreRefused) {
  scene::Scene scene(named("free"));
  scene.add_body("mitten", "anna/", &kLeft);
  const std::string before = scene.xml();
  expect_error(Status::kInvalidArgument, "anna/", [&] { scene.add_body("mitten", "anna/", &kRight); });
  EXPECT_EQ(scene.xml(), before);
  scene::Scene included(from_text("<mujoco><include file='mimo/mitten.xml'/></mujoco>"));
  expect_error(Status::kInvalidArgument, "mimo_location", [&] { included.add_body("mitten", "", nullptr); });
}

TEST_F(SceneInfants, ReportsThatNoPlaceIsLeft) {
  scene::Scene scene(named("free"));
  scene.add_body("mitten", "anna/", nullptr);
  expect_error(Status::kInvalidArgument, "no place for infant number 2",
               [&] { scene.add_body("mitten", "ben/", nullptr); });
}

TEST_F(SceneInfants, MissingInfantIsNamed) {
  const engine::ModelPtr model = compile(scene::Scene(named("free")));
  expect_error(Status::kNotFound, "anna/mimo_location", [&] { body::find_body(*model, "anna/"); });
}

// Main defaults of a user's document, each of them other than MuJoCo's.
const std::string kHostileDefaults =
    "<default>"
    "<geom type='box' contype='2' conaffinity='4' condim='1' group='3' priority='2' friction='.3 .2 .1' mass='7' "
    "density='9' "
    "solmix='3' solref='.1 .5' solimp='.5 .6 .1' margin='.1' gap='.05' shellinertia='true' pos='1 1 1' "
    "rgba='1 0 0 1' fluidshape='ellipsoid'/>"
    "<joint type='slide' axis='1 1 0' pos='1 1 1' limited='false' range='0 1' margin='.2' ref='0.1' springref='5' "
    "stiffness='3' "
    "damping='4' armature='.5' frictionloss='2' springdamper='.1 1' solreflimit='.2 .7' solimplimit='.5 .6 .1' "
    "solreffriction='.2 .7' solimpfriction='.5 .6 .1' group='2'/>"
    "<site type='box' size='1 1 1' pos='1 1 1' group='5'/><camera fovy='20' ipd='.5' mode='track'/>"
    "<tendon limited='false' stiffness='3' damping='2' frictionloss='1' margin='.1' springlength='.3' group='1'/>"
    "<general ctrllimited='false' forcelimited='false' ctrlrange='-9 9' forcerange='-9 9' gear='3' gainprm='2' "
    "dyntype='filter'/>"
    "<pair condim='6' friction='2 2 .1 .1 .1' solref='.3 1' margin='.1' gap='.1'/>"
    "<equality active='true' solref='.3 1' solimp='.5 .6 .1'/></default>";

TEST_F(SceneInfants, MainDefaultsDoNotReachIntoTheBody) {
  scene::Scene neutral(from_text("<mujoco/>"));
  scene::Scene hostile(from_text("<mujoco>" + kHostileDefaults + "</mujoco>"));
  neutral.add_body("mitten", "", nullptr);
  hostile.add_body("mitten", "", nullptr);
  expect_same_physics(*compile(neutral), *compile(hostile));
  const std::string include = "<include file='mimo/mitten.xml'/>";
  expect_same_physics(*compile(scene::Scene(from_text("<mujoco>" + include + "</mujoco>"))),
                      *compile(scene::Scene(from_text("<mujoco>" + kHostileDefaults + include + "</mujoco>"))));
}

// Where nothing is drawn that is nearer, m.
double near_plane(const std::string& document, bool add) {
  scene::Scene scene(from_text(document));
  if (add) scene.add_body("mitten", "", nullptr);
  const engine::ModelPtr model = compile(scene);
  return static_cast<double>(model->vis.map.znear) * model->stat.extent;
}

// A hand may come within a centimetre of an eye, however large the world is; unless its author says otherwise.
TEST_F(SceneInfants, SeeHandsBeforeTheirEyes) {
  const std::string large = "<worldbody><geom type='box' size='20 20 1' pos='0 0 -9'/></worldbody>";
  const std::string included = "<include file='mimo/mitten.xml'/>";
  for (const std::string room : {"free", "benchmark", "reach", "standup", "selfbody"}) {
    const engine::ModelPtr model = room_with_infant(room);
    EXPECT_LE(static_cast<double>(model->vis.map.znear) * model->stat.extent, 0.01) << room;
  }
  for (const std::string settings :
       {"", "<statistic extent='30'/>", "<visual><map znear='0.01'/></visual>", "<statistic center='0 0 1'/>",
        "<visual><map zfar='20'/></visual><visual><quality shadowsize='64'/></visual>"}) {
    EXPECT_NEAR(near_plane("<mujoco>" + settings + large + "</mujoco>", true), 0.005, 1e-6) << settings;
    EXPECT_NEAR(near_plane("<mujoco>" + settings + large + included + "</mujoco>", false), 0.005, 1e-6) << settings;
  }
  const std::string both = "<statistic extent='3'/><visual><map znear='0.02'/></visual>";
  EXPECT_NEAR(near_plane("<mujoco>" + both + large + "</mujoco>", true), 0.06, 1e-6);
  EXPECT_GT(near_plane("<mujoco>" + large + "</mujoco>", false), 0.1);  // no infant, no business of ours
}

}  // namespace
}  // namespace mimo::test
