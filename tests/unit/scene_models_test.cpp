// MJCF documents as objects of a scene: they stay what they are, and nothing of them clashes with anything.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <string>

#include "engine/model.h"
#include "engine/physics.h"
#include "support/files.h"
#include "support/physical.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using SceneModels = QuietTest;

// A cart with an arm that uses much of what MJCF has: main defaults and classes within classes, a hinge and a slide
// that share a class, all kinds of orientations, and one of each kind of element outside bodies.
const std::string kCart =
    "<default>"
    "  <geom type='box' size='.1 .1 .1' density='500' friction='.7 .01 .001' euler='10 20 30' material='red'/>"
    "  <joint damping='0.3' armature='0.01'/><site size='.02'/><general ctrllimited='true' ctrlrange='-2 2'/>"
    "  <tendon stiffness='5'/><equality solref='.05 1'/><pair condim='1'/><material shininess='0.25'/>"
    "  <default class='arm'><joint range='-40 50' limited='true'/><geom type='capsule' size='.03 .1'/>"
    "    <default class='hand'><geom type='sphere' size='.04'/></default></default>"
    "</default>"
    "<asset><texture name='grid' type='2d' builtin='checker' width='8' height='8'/>"
    "  <material name='red' rgba='1 0 0 1' texture='grid'/>"
    "  <mesh name='wedge' vertex='0 0 0  .1 0 0  0 .1 0  0 0 .1'/></asset>"
    "<worldbody>"
    "  <body name='cart' pos='0 0 1' quat='1 0 0 0'><joint name='rail' type='slide' class='arm' axis='1 0 0'/><geom/>"
    "    <body name='arm' pos='0 0 .2' euler='30 40 50' childclass='arm'>"
    "      <joint name='shoulder' axis='0 1 0' ref='15' springref='-20' stiffness='1'/><geom name='arm'/>"
    "      <body name='hand' pos='0 0 .3' axisangle='1 0 0 25'><joint name='wrist' range='-10 10'/>"
    "        <geom name='hand' class='hand'/><site name='tip' pos='0 0 .1'/>"
    "        <geom type='mesh' mesh='wedge' material='red' class='main'/><camera name='look' mode='targetbody' "
    "target='cart'/>"
    "      </body></body></body></worldbody>"
    "<contact><pair name='touching' geom1='arm' geom2='hand'/><exclude body1='cart' body2='hand'/></contact>"
    "<equality><weld name='hold' body1='hand' body2='world' active='false'/>"
    "  <joint name='stop' joint1='wrist' polycoef='.1 0 0 0 0'/></equality>"
    "<tendon><fixed name='both'><joint joint='shoulder' coef='1'/><joint joint='wrist' coef='-1'/></fixed></tendon>"
    "<actuator><motor name='push' joint='rail'/><position name='bend' joint='shoulder' kp='3'/>"
    "  <general name='pull' tendon='both'/></actuator>"
    "<sensor><jointpos name='where' joint='wrist'/><actuatorfrc name='effort' actuator='push'/>"
    "  <framepos name='far' objtype='site' objname='tip' reftype='body' refname='world'/></sensor>"
    "<custom><tuple name='mimo:pose'><element objtype='joint' objname='shoulder' prm='0.5'/></tuple></custom>";

scene::Model cart(const std::string& name, const std::string& settings = "") {
  scene::Model model;
  model.name = name;
  model.xml = "<mujoco>" + settings + kCart + "</mujoco>";
  model.pose = {{0, 0, 1}, {1, 0, 0, 0}};
  return model;
}

// In a class, euler angles of another order than the scene's cannot be converted.
scene::Model without_euler_in_class(scene::Model model) {
  const std::string in_class = " euler='10 20 30'";
  model.xml.erase(model.xml.find(in_class), in_class.size());
  return model;
}

scene::Model of(const std::string& content) {
  scene::Model model;
  model.name = "cup";
  model.xml = "<mujoco>" + content + "</mujoco>";
  return model;
}

engine::ModelPtr in_scene(const std::string& host, const scene::Model& model) {
  scene::Scene scene(from_text("<mujoco>" + host + "</mujoco>"));
  scene.add_model(model);
  return compile(scene);
}

// In whatever it is put, it is what it is alone.
TEST_F(SceneModels, StayWhatTheyAre) {
  const engine::ModelPtr alone = compiled(cart("cart").xml);
  ASSERT_EQ(alone->njnt, 3);
  ASSERT_NEAR(alone->jnt_range[1], 50, 1e-12) << "a slide's range is no angle";
  ASSERT_NEAR(alone->jnt_range[3], 50 * mjPI / 180, 1e-12);
  const std::string hostile =
      "<default><geom type='sphere' size='.3' contype='2' margin='.1'/><joint type='slide' limited='true' range='0 1'/>"
      "<site type='box'/><general gear='3' forcelimited='true' forcerange='-1 1'/><tendon damping='4'/>"
      "<equality active='false'/><pair margin='.3'/><mesh scale='2 2 2'/></default>";
  for (const std::string& host :
       {std::string(), std::string("<compiler angle='radian'/>"), std::string("<compiler autolimits='true'/>"), hostile,
        "<compiler angle='radian'/>" + hostile}) {
    SCOPED_TRACE(host);
    expect_same_physics(*alone, *in_scene(host, cart("cart")), {1e-12, 1e-12});
  }
  const scene::Model plain = without_euler_in_class(cart("cart"));
  for (const char* host : {"<compiler eulerseq='ZyX'/>", "<compiler eulerseq='zyx' angle='radian'/>"}) {
    SCOPED_TRACE(host);
    expect_same_physics(*compiled(plain.xml), *in_scene(host, plain), {1e-12, 1e-12});
  }
}

// Its own settings count where the scene has others.
TEST_F(SceneModels, OwnSettingsCount) {
  for (const char* settings :
       {"<compiler angle='radian'/>", "<compiler eulerseq='ZYX'/>", "<compiler eulerseq='yxz'/>"}) {
    SCOPED_TRACE(settings);
    const scene::Model model = without_euler_in_class(cart("cart", settings));
    expect_same_physics(*compiled(model.xml), *in_scene("", model), {1e-12, 1e-12});
  }
  const std::string limits =
      "<compiler autolimits='true'/><default><default class='a'><joint range='-1 1'/></default></default><worldbody>"
      "<body><joint class='a'/><geom size='1'/></body></worldbody>";
  EXPECT_EQ(in_scene("", of(limits))->jnt_limited[0], 1);
  const std::string light =
      "<compiler inertiafromgeom='true'/><worldbody><body><inertial pos='0 0 0' mass='9' diaginertia='1 1 1'/>"
      "<geom size='1' mass='2'/></body></worldbody>";
  EXPECT_EQ(in_scene("", of(light))->body_mass[1], 2);
}

TEST_F(SceneModels, CopiesDoNotClash) {
  scene::Scene scene(named("benchmark"));
  scene.add_body("mitten", "", nullptr);
  for (const char* name : {"red", "blue"}) scene.add_model(cart(name));
  const engine::ModelPtr one = room_with_infant("benchmark");
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(model->nbody, one->nbody + 6);
  EXPECT_EQ(model->nmat, one->nmat + 2);
  EXPECT_EQ(model->ntex, one->ntex + 2);
  EXPECT_EQ(model->nmesh, 2);
  EXPECT_EQ(model->nu, one->nu + 6);
  EXPECT_EQ(model->nsensor, one->nsensor + 6);
  EXPECT_EQ(model->ntendon, one->ntendon + 2);
  EXPECT_EQ(model->neq, one->neq + 4);
  EXPECT_EQ(model->npair, one->npair + 2);
  for (const char* name : {"red/cart", "red/arm", "blue/hand"}) EXPECT_GE(engine::find(*model, Kind::kBody, name), 0);
  EXPECT_GE(engine::find(*model, Kind::kActuator, "blue/pull"), 0);
  EXPECT_GE(engine::find(*model, Kind::kCamera, "red/look"), 0);
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_MATERIAL, "blue/red"), 0);
  const int shoulder = engine::find_or_fail(*model, Kind::kJoint, "blue/shoulder");
  EXPECT_EQ(engine::custom_tuple(*model, "blue/mimo:pose", Kind::kJoint)[0].id, shoulder);
}

TEST_F(SceneModels, PlaceAndFreedom) {
  const std::string plain = "<worldbody><body name='a' pos='5 5 5' euler='1 2 3'><geom size='1'/></body></worldbody>";
  scene::Model model = of(plain);
  model.pose = {{1, 2, 3}, {0, 0, 1, 0}};
  const engine::ModelPtr free = in_scene("", model);
  EXPECT_EQ(copy(free->body_pos + 3, 3), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(copy(free->body_quat + 4, 4), (std::vector<double>{0, 0, 1, 0}));
  EXPECT_STREQ(engine::name(*free, Kind::kBody, 1), "cup/a");
  ASSERT_EQ(free->njnt, 1);
  EXPECT_EQ(free->jnt_type[0], mjJNT_FREE);
  EXPECT_STREQ(engine::name(*free, Kind::kJoint, 0), "cup");
  model.fixed = true;
  EXPECT_EQ(in_scene("", model)->njnt, 0);
  const engine::ModelPtr nameless = in_scene("", of("<worldbody><body><geom size='1'/></body></worldbody>"));
  EXPECT_STREQ(engine::name(*nameless, Kind::kBody, 1), "cup");

  scene::Model hinged = of("<worldbody><body><joint name='lid'/><geom size='1'/></body></worldbody>");
  for (const bool fixed : {false, true}) {
    hinged.fixed = fixed;
    const engine::ModelPtr lid = in_scene("", hinged);
    ASSERT_EQ(lid->njnt, 1) << "its own joints are what it moves by";
    EXPECT_STREQ(engine::name(*lid, Kind::kJoint, 0), "cup/lid");
  }
  for (const char* joint : {"<freejoint/>", "<joint type='free'/>", "<joint class='loose'/>"}) {
    scene::Model loose = of(std::string("<default><default class='loose'><joint type='free'/></default></default>") +
                            "<worldbody><body>" + joint + "<geom size='1'/></body></worldbody>");
    EXPECT_EQ(in_scene("", loose)->njnt, 1);
    loose.fixed = true;
    expect_error(Status::kInvalidArgument, "fixed is 1", [&] { in_scene("", loose); });
  }
}

// What is there for looking at the document alone stays behind; solver and keyframes are the scene's business.
TEST_F(SceneModels, OnlyTheBodyComesAlong) {
  scene::Scene scene(
      from_text("<mujoco><option timestep='0.004'/><worldbody><body><freejoint/><geom size='1'/></body>"
                "</worldbody><keyframe><key qpos='1 2 3 1 0 0 0'/></keyframe></mujoco>"));
  scene.add_model(
      of("<option timestep='0.1' gravity='0 0 -1'/><size njmax='1'/><worldbody><light/><geom type='plane' "
         "size='1 1 1'/><site/><camera/></worldbody><worldbody><body><freejoint/><geom size='1'/></body>"
         "</worldbody><keyframe><key qpos='0 0 5 1 0 0 0'/></keyframe>"));
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(model->opt.timestep, 0.004);
  EXPECT_EQ(model->opt.gravity[2], -9.81);
  EXPECT_EQ(model->nbody, 3);
  EXPECT_EQ(model->ngeom, 2);
  EXPECT_EQ(model->nlight + model->nsite + model->ncam, 0);
  EXPECT_EQ(model->nkey, 0) << "keyframes are positions of other joints";
}

TEST_F(SceneModels, FilesLieBesideTheDocument) {
  const Folder folder;
  folder.write("toys/parts/leg.xml", "<mujoco><worldbody/><asset><mesh file='leg.obj'/></asset></mujoco>");
  folder.write("toys/meshes/leg.obj", "v 0 0 0\nv .1 0 0\nv 0 .1 0\nv 0 0 .1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  scene::Model stool;
  stool.file = folder.write("toys/stool.xml",
                            "<mujoco><compiler meshdir='meshes'/><include file='parts/leg.xml'/><worldbody><body>"
                            "<geom type='mesh' mesh='leg'/></body></worldbody></mujoco>");
  scene::Scene scene(named("free"));
  for (const char* name : {"one", "two"}) {
    stool.name = name;
    scene.add_model(stool);
  }
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(model->nmesh, 2);
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_MESH, "two/leg"), 0) << "called after its file";
  stool.file = folder.path("toys/table.xml");
  stool.name = "three";
  expect_error(Status::kNotFound, "table.xml", [&] { scene.add_model(stool); });
}

TEST_F(SceneModels, RefusalsLeaveTheSceneAsItWas) {
  const std::string body = "<worldbody><body name='b'><geom size='1'/></body></worldbody>";
  scene::Scene scene(named("benchmark"));
  scene.add_body("mitten", "", nullptr);
  scene.add_model(cart("red"));
  const std::string before = scene.xml();
  const auto refuse = [&](Status status, const std::string& part, const scene::Model& model) {
    SCOPED_TRACE(part);
    expect_error(status, part, [&] { scene.add_model(model); });
    EXPECT_EQ(scene.xml(), before);
  };
  refuse(Status::kModel, "0 bodies", of(""));
  refuse(Status::kModel, "2 bodies", of("<worldbody><body/></worldbody><worldbody><body/></worldbody>"));
  refuse(Status::kModel, "<robot>", [] {
    scene::Model model = of("");
    model.xml = "<robot/>";
    return model;
  }());
  refuse(Status::kUnsupported, "coordinate", of("<compiler coordinate='global'/>" + body));
  refuse(Status::kUnsupported, "eulerseq",
         of("<compiler eulerseq='zyx'/><default><geom euler='1 2 3'/></default>" + body));
#if !MIMO_MUJOCO_4  // where composites are elements like others
  refuse(Status::kUnsupported, "composite",
         of("<compiler angle='radian'/><worldbody><body><composite type='rope' count='3 1 1' spacing='.1'/></body>"
            "</worldbody>"));
#endif
  for (const char* taken : {"red", "test_object1", "head"}) {
    scene::Model model = of(body);
    model.name = taken;
    refuse(Status::kInvalidArgument, taken, model);
  }
  scene::Scene global(from_text("<mujoco><compiler coordinate='global'/></mujoco>"));
  expect_error(Status::kUnsupported, "global", [&] { global.add_model(of(body)); });
  expect_error(Status::kUnsupported, "global", [&] { global.add_body("mitten", "", nullptr); });
}

// Classes that lead back to themselves are the compiler's to refuse.
TEST_F(SceneModels, OddClassesEndInAMessage) {
  const std::string body = "<worldbody><body><joint range='0 1'/><geom size='1'/></body></worldbody>";
  for (const char* classes : {"<default><default class='a'><default class='a'/></default></default>",
                              "<default><default><joint damping='1'/></default></default>",
                              "<default><default class='main'><default class='main'/></default></default>"}) {
    scene::Scene scene(scene::Source{});
    scene.add_model(of(std::string("<compiler autolimits='true'/>") + classes + body));
    expect_error(Status::kModel, "class", [&] { compile(scene); });
  }
}

// A rope's elements are made by the compiler; their names and those who refer to them agree.
TEST_F(SceneModels, CompositesHaveNamesOfTheirOwn) {
  const std::string rope =
      "<worldbody><body name='B1'><composite type='rope' count='3 1 1' spacing='.1'><geom type='capsule' size='.02 "
      ".03'/>"
      "</composite></body></worldbody><sensor><framepos objtype='body' objname='B0'/></sensor>";
  scene::Scene scene(scene::Source{});
  for (const char* name : {"one", "two"}) {
    scene::Model model = of(rope);
    model.name = name;
    scene.add_model(model);
  }
  EXPECT_GE(engine::find(*compile(scene), Kind::kBody, "two/B0"), 0);
}

}  // namespace
}  // namespace mimo::test
