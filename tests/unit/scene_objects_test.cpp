// Objects added by calls.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <string>

#include "support/numbers.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using scene::ObjectShape;
using SceneObjects = QuietTest;

scene::Object object(const std::string& name, ObjectShape shape) {
  scene::Object result;
  result.name = name;
  result.shape = shape;
  result.size = {0.1, 0.2, 0.3};
  result.pose = {{1, -2, 3}, {0, 0, 0, 1}};
  result.rgba = {0.25, 0.5, 0.75, 1};
  return result;
}

engine::ModelPtr world_with(const scene::Object& object) {
  scene::Scene scene(scene::Source{});
  scene.add_object(object);
  return compile(scene);
}

// Volumes with radius 0.1, half length 0.2, half sizes 0.1, 0.2, 0.3.
TEST_F(SceneObjects, ShapesAndMassByDensity) {
  struct Known {
    ObjectShape shape;
    int type;
    double volume;
  };
  const Known known[] = {{ObjectShape::kSphere, mjGEOM_SPHERE, 4.0 / 3 * mjPI * 0.001},
                         {ObjectShape::kCapsule, mjGEOM_CAPSULE, 4.0 / 3 * mjPI * 0.001 + mjPI * 0.01 * 0.4},
                         {ObjectShape::kEllipsoid, mjGEOM_ELLIPSOID, 4.0 / 3 * mjPI * 0.006},
                         {ObjectShape::kCylinder, mjGEOM_CYLINDER, mjPI * 0.01 * 0.4},
                         {ObjectShape::kBox, mjGEOM_BOX, 8 * 0.006}};
  for (const Known& shape : known) {
    const engine::ModelPtr model = world_with(object("toy", shape.shape));
    EXPECT_EQ(model->geom_type[0], shape.type);
    EXPECT_TRUE(close(1000 * shape.volume, model->body_mass[1])) << "1000 kg/m^3";
  }
}

TEST_F(SceneObjects, EverythingAskedFor) {
  scene::Object toy = object("toy", ObjectShape::kBox);
  toy.mass = 2.5;
  const engine::ModelPtr model = world_with(toy);
  EXPECT_EQ(engine::find(*model, Kind::kBody, "toy"), 1);
  EXPECT_EQ(engine::find(*model, Kind::kGeom, "toy"), 0);
  EXPECT_EQ(engine::find(*model, Kind::kJoint, "toy"), 0);
  EXPECT_EQ(model->jnt_type[0], mjJNT_FREE);
  EXPECT_TRUE(close(2.5, model->body_mass[1]));
  EXPECT_EQ(copy(model->geom_size, 3), (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(copy(model->body_pos + 3, 3), (std::vector<double>{1, -2, 3}));
  EXPECT_EQ(copy(model->body_quat + 4, 4), (std::vector<double>{0, 0, 0, 1}));
  EXPECT_EQ(model->geom_rgba[2], 0.75f);
  EXPECT_EQ(model->geom_condim[0], 6);
}

TEST_F(SceneObjects, FixedOnesDoNotMove) {
  scene::Object shelf = object("shelf", ObjectShape::kBox);
  shelf.fixed = true;
  const engine::ModelPtr model = world_with(shelf);
  EXPECT_EQ(model->nv, 0);
  EXPECT_EQ(copy(model->body_pos + 3, 3), (std::vector<double>{1, -2, 3}));
}

TEST_F(SceneObjects, NamesInUseAreRefused) {
  scene::Scene scene(named("benchmark"));
  scene.add_body("mitten", "", nullptr);
  scene.add_object(object("toy", ObjectShape::kSphere));
  const std::string before = scene.xml();
  for (const char* taken : {"toy", "test_object1", "floor", "left_hand"}) {
    expect_error(Status::kInvalidArgument, std::string("\"") + taken + "\"",
                 [&] { scene.add_object(object(taken, ObjectShape::kBox)); });
  }
  EXPECT_EQ(scene.xml(), before);
}

TEST_F(SceneObjects, ACameraThatIsRefusedLeavesNoTrace) {
  scene::Scene scene(from_text("<mujoco/>"));
  const std::string before = scene.xml();
  const scene::Camera blind{"aside", "", {1, 2, 3}, {1, 2, 3}};
  expect_error(Status::kInvalidArgument, "looks at its own position", [&] { scene.add_camera(blind); });
  EXPECT_EQ(scene.xml(), before);
}

// A name with characters that XML minds.
TEST_F(SceneObjects, NamesAreEscaped) {
  const std::string name = "<\"tea\" & 'cake'>";
  EXPECT_EQ(engine::find(*world_with(object(name, ObjectShape::kSphere)), Kind::kBody, name.c_str()), 1);
}

// An object is what the call says, whatever the main defaults of a user's document say.
TEST_F(SceneObjects, MainDefaultsDoNotReachObjects) {
  const std::string defaults =
      "<default><geom type='box' contype='2' conaffinity='4' condim='1' priority='2' friction='.3 .2 .1' solmix='3' "
      "solref='.1 .5' "
      "solimp='.5 .6 .1' margin='.1' gap='.05' pos='1 1 1' quat='0 1 0 0' group='4' mass='7' "
      "shellinertia='true'/></default>";
  scene::Scene neutral(from_text("<mujoco/>"));
  scene::Scene hostile(from_text("<mujoco>" + defaults + "</mujoco>"));
  scene::Object heavy = object("heavy", ObjectShape::kCapsule);
  heavy.mass = 2;
  for (scene::Scene* scene : {&neutral, &hostile}) {
    scene->add_object(object("toy", ObjectShape::kBox));
    scene->add_object(heavy);
  }
  const engine::ModelPtr expected = compile(neutral);
  const engine::ModelPtr actual = compile(hostile);
  for (int geom = 0; geom < 2; ++geom) {
    EXPECT_EQ(actual->geom_contype[geom], expected->geom_contype[geom]);
    EXPECT_EQ(actual->geom_conaffinity[geom], expected->geom_conaffinity[geom]);
    EXPECT_EQ(actual->geom_condim[geom], expected->geom_condim[geom]);
    EXPECT_EQ(actual->geom_priority[geom], expected->geom_priority[geom]);
    EXPECT_EQ(actual->geom_solmix[geom], expected->geom_solmix[geom]);
    EXPECT_EQ(actual->geom_margin[geom], expected->geom_margin[geom]);
    EXPECT_EQ(actual->geom_gap[geom], expected->geom_gap[geom]);
    EXPECT_EQ(actual->geom_group[geom], expected->geom_group[geom]);
    EXPECT_EQ(copy(actual->geom_friction + 3 * geom, 3), copy(expected->geom_friction + 3 * geom, 3));
    EXPECT_EQ(copy(actual->geom_solref + 2 * geom, 2), copy(expected->geom_solref + 2 * geom, 2));
    EXPECT_EQ(copy(actual->geom_solimp + 5 * geom, 5), copy(expected->geom_solimp + 5 * geom, 5));
    EXPECT_EQ(copy(actual->geom_pos + 3 * geom, 3), copy(expected->geom_pos + 3 * geom, 3));
    EXPECT_EQ(copy(actual->geom_quat + 4 * geom, 4), copy(expected->geom_quat + 4 * geom, 4));
    EXPECT_EQ(actual->body_mass[1 + geom], expected->body_mass[1 + geom]);
    EXPECT_EQ(copy(actual->body_inertia + 3 * (1 + geom), 3), copy(expected->body_inertia + 3 * (1 + geom), 3));
  }
}

}  // namespace
}  // namespace mimo::test
