// Where a scene's parts come from: built-in files, a user's files and text, and the assets that they name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "compat/mujoco.h"
#include "repository_paths.h"
#include "support/files.h"
#include "support/physical.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using SceneSources = QuietTest;

const std::string kIncludesMimo = "<mujoco><include file='mimo/mitten.xml'/></mujoco>";

// A picture, and a tetrahedron.
const std::string kPicture = std::string(MIMO_MODELS) + "/textures/ball_c.png";
const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string with_picture(const std::string& compiler, const std::string& file) {
  return "<mujoco>" + compiler + "<asset><texture name='t' type='2d' file='" + file +
         "'/></asset><worldbody><geom size='0.1'/></worldbody></mujoco>";
}

std::string with_mesh(const std::string& compiler, const std::string& file) {
  return "<mujoco>" + compiler + "<asset><mesh name='m' file='" + file +
         "'/></asset><worldbody><body><geom type='mesh' mesh='m' density='600'/></body></worldbody></mujoco>";
}

TEST_F(SceneSources, BuiltInSceneByName) {
  EXPECT_STREQ(scene::built_in_scene(0), "benchmark");
  EXPECT_STREQ(scene::built_in_scene(1), "free");
  EXPECT_STREQ(scene::built_in_scene(4), "selfbody");
  EXPECT_STREQ(scene::built_in_scene(8), "playdate");
  EXPECT_STREQ(scene::built_in_scene(12), "head-lift");
  EXPECT_EQ(scene::built_in_scene(37), nullptr);
  EXPECT_EQ(compile(scene::Scene(named("benchmark")))->nbody, 3);  // world, box, ball
  EXPECT_EQ(compile(scene::Scene(named("free")))->nbody, 1);
}

TEST_F(SceneSources, UnknownNamesListWhatThereIs) {
  expect_error(Status::kNotFound, "no scene named \"bench\"; there are: benchmark, free",
               [] { scene::Scene scene(named("bench")); });
  scene::Scene scene(named("free"));
  expect_error(Status::kNotFound, "no body named \"mittens\"; did you mean \"mitten\"? there are: mitten",
               [&] { scene.add_body("mittens", "", nullptr); });
}

// No source at all is an empty world with the built-in solver options.
TEST_F(SceneSources, AreOneOfNameFileAndText) {
  scene::Source source;
  source.name = "free";
  source.xml = "<mujoco/>";
  expect_error(Status::kInvalidArgument, "and xml exclude each other, 2 of them are set",
               [&] { scene::Scene scene(source); });
  scene::Scene scene{scene::Source()};
  scene::Model model;
  model.name = "box";
  expect_error(Status::kInvalidArgument, "none of file and xml", [&] { scene.add_model(model); });
  model.file = "box.xml";
  model.xml = "<mujoco/>";
  expect_error(Status::kInvalidArgument, "both of file and xml", [&] { scene.add_model(model); });
}

TEST_F(SceneSources, EmptyWorld) {
  const engine::ModelPtr model = compile(scene::Scene(scene::Source{}));
  EXPECT_EQ(model->nbody, 1);
  EXPECT_EQ(model->ngeom, 0);
  EXPECT_EQ(model->opt.timestep, 0.005);
  EXPECT_EQ(model->opt.cone, mjCONE_ELLIPTIC);
}

TEST_F(SceneSources, IncludeInText) {
  const engine::ModelPtr model = compile(scene::Scene(from_text(kIncludesMimo)));
  EXPECT_EQ(model->nbody, 24);  // 26 of the benchmark scene less box and ball
  EXPECT_EQ(model->nu, 44);
}

TEST_F(SceneSources, IncludeInFileOnDisk) {
  const Folder folder;
  const std::string path = folder.write("room/mine.xml", kIncludesMimo);
  expect_same_physics(*compile(scene::Scene(from_text(kIncludesMimo))), *compile(scene::Scene(from_file(path))));
}

// The infant's angles are in degrees; a document in radians gets them converted.
TEST_F(SceneSources, IncludeInDocumentInRadians) {
  const scene::Scene degrees(from_text(kIncludesMimo));
  const scene::Scene radians(from_text("<mujoco><compiler angle='radian'/><include file='mimo/mitten.xml'/></mujoco>"));
  expect_same_physics(*compile(degrees), *compile(radians), {1e-14, 1e-16});
}

TEST_F(SceneSources, BodyAddedToDocumentInRadians) {
  scene::Scene degrees(from_text("<mujoco/>"));
  scene::Scene radians(from_text("<mujoco><compiler angle='radian'/></mujoco>"));
  degrees.add_body("mitten", "", nullptr);
  radians.add_body("mitten", "", nullptr);
  expect_same_physics(*compile(degrees), *compile(radians), {1e-14, 1e-16});
}

TEST_F(SceneSources, UsersOwnIncludesAreBesideTheirFile) {
  const Folder folder;
  folder.write("room/parts/floor.xml",
               "<mujocoinclude><worldbody><geom name='mine' size='1'/></worldbody></mujocoinclude>");
  const std::string path = folder.write("room/mine.xml", "<mujoco><include file='parts/floor.xml'/></mujoco>");
  const engine::ModelPtr model = compile(scene::Scene(from_file(path)));
  EXPECT_EQ(engine::find(*model, engine::Kind::kGeom, "mine"), 0);
}

// The original's scenes keep the infant's parts in a folder of that name: a scene includes them section by section.
TEST_F(SceneSources, AUsersFolderMayBeCalledMimo) {
  const Folder folder;
  folder.write("assets/mimo/meta.xml",
               "<mujoco><compiler angle='degree'/><default><default class='limb'><joint damping='.2' range='-30 30' "
               "limited='true'/></default></default><asset><texture name='skin' type='2d' file='mimo/tex/skin.png'/>"
               "<material name='skin' texture='skin'/><mesh name='hat' file='mimo/hat.obj'/></asset></mujoco>");
  folder.copy_of(kPicture, "assets/mimo/tex/skin.png");
  folder.write("assets/mimo/hat.obj", kTetrahedron);
  folder.write(
      "assets/mimo/body.xml",
      "<mujoco><body name='hip' childclass='limb'><joint name='bend' axis='0 1 0'/><geom type='capsule' size='.05 "
      ".1' material='skin'/><geom type='mesh' mesh='hat'/><include file='mimo/arm.xml'/></body></mujoco>");
  folder.write("assets/mimo/arm.xml",
               "<mujoco><body name='arm'><joint name='turn'/><geom size='.03'/></body></mujoco>");
  folder.write("assets/mimo/motors.xml",
               "<mujoco><actuator><motor name='m' joint='bend'/></actuator><sensor><jointpos joint='turn'/></sensor>"
               "</mujoco>");
  const std::string scene =
      "<mujoco><include file='mimo/meta.xml'/><worldbody><geom type='plane' size='1 1 1'/><body "
      "name='root'><freejoint/><geom size='.04'/>"
      "<include file='mimo/body.xml'/></body></worldbody><include file='mimo/motors.xml'/></mujoco>";
  const std::string path = folder.write("assets/scene.xml", scene);
  const engine::ModelPtr model = compile(scene::Scene(from_file(path)));
  EXPECT_EQ(model->nbody, 4);
  EXPECT_EQ(model->njnt, 3);
  EXPECT_EQ(model->nu, 1);
  EXPECT_EQ(model->nsensor, 1);
  EXPECT_EQ(model->ntex, 1);
  EXPECT_EQ(model->nmesh, 1);
  const WorkingDirectory there(folder.path("assets"));
  EXPECT_EQ(compile(scene::Scene(from_text(scene)))->nbody, 4);
  // What the library has is the library's, whatever lies about.
  folder.write("assets/mimo/mitten.xml", "<mujoco/>");
  EXPECT_EQ(compile(scene::Scene(from_text(kIncludesMimo)))->nbody, 24);
}

// A path that only happens to begin like a built-in file's.
TEST_F(SceneSources, AFileInAFolderCalledMimo) {
  const Folder folder;
  folder.copy_of(kPicture, "mimo/textures/floor.png");
  folder.write("mimo/own.xml", with_picture("", "textures/floor.png"));
  const WorkingDirectory there(folder.path());
  const engine::ModelPtr model = compile(scene::Scene(from_file("mimo/own.xml")));
  const engine::ModelPtr expected = compile(scene::Scene(from_text(with_picture("", kPicture))));
  ASSERT_EQ(model->ntexdata, expected->ntexdata);
  EXPECT_EQ(
      std::memcmp((*model).*compat::kPixels, (*expected).*compat::kPixels, static_cast<std::size_t>(model->ntexdata)),
      0);
}

TEST_F(SceneSources, ReportBadIncludes) {
  expect_error(Status::kNotFound, "no/such.xml",
               [] { scene::Scene scene(from_text("<mujoco><include file='no/such.xml'/></mujoco>")); });
  expect_error(Status::kNotFound, "mimo/octopus.xml",
               [] { scene::Scene scene(from_text("<mujoco><include file='mimo/octopus.xml'/></mujoco>")); });
  expect_error(Status::kModel, "has no file", [] { scene::Scene scene(from_text("<mujoco><include/></mujoco>")); });
  expect_error(Status::kModel, "included twice", [] {
    scene::Scene scene(
        from_text("<mujoco><include file='mimo/mitten.xml'/><include file='mimo/mitten.xml'/></mujoco>"));
  });
  const Folder folder;
  const std::string path = folder.write("self.xml", "<mujoco><include file='self.xml'/></mujoco>");
  expect_error(Status::kModel, "included twice", [&] { scene::Scene scene(from_file(path)); });
}

TEST_F(SceneSources, BadDocumentsAreNamed) {
  expect_error(Status::kNotFound, "/no/such/file.xml", [] { scene::Scene scene(from_file("/no/such/file.xml")); });
  expect_error(Status::kModel, "xml text, line 2",
               [] { scene::Scene scene(from_text("<mujoco>\n<worldbody></mujoco>")); });
  const Folder folder;
  const std::string empty = folder.write("empty.xml", "");
  expect_error(Status::kModel, empty, [&] { scene::Scene scene(from_file(empty)); });
  expect_error(Status::kModel, "<robot>", [] { scene::Scene scene(from_text("<robot/>")); });
}

TEST_F(SceneSources, TextureBesideTheUsersFile) {
  const Folder folder;
  folder.copy_of(kPicture, "room/pictures/mine.png");
  const std::string beside = folder.write("room/a.xml", with_picture("", "pictures/mine.png"));
  const std::string by_folder =
      folder.write("room/b.xml", with_picture("<compiler texturedir='pictures'/>", "mine.png"));
  const std::string stripped = folder.write(
      "room/c.xml", with_picture("<compiler texturedir='pictures' strippath='true'/>", "/elsewhere/mine.png"));
  const std::string absolute = folder.write("d.xml", with_picture("", folder.path("room/pictures/mine.png")));
  for (const std::string& path : {beside, by_folder, stripped, absolute}) {
    EXPECT_EQ(compile(scene::Scene(from_file(path)))->ntex, 1) << path;
  }
}

TEST_F(SceneSources, MeshBesideTheUsersFile) {
  const Folder folder;
  folder.write("room/shapes/mine.obj", kTetrahedron);
  const std::string beside = folder.write("room/a.xml", with_mesh("", "shapes/mine.obj"));
  const std::string by_folder = folder.write("room/b.xml", with_mesh("<compiler meshdir='shapes'/>", "mine.obj"));
  for (const std::string& path : {beside, by_folder}) {
    const engine::ModelPtr model = compile(scene::Scene(from_file(path)));
    EXPECT_EQ(model->nmesh, 1) << path;
    EXPECT_EQ(model->mesh_facenum[0], 4) << path;
  }
}

TEST_F(SceneSources, TextStartsFromTheWorkingDirectory) {
  const Folder folder;
  folder.copy_of(kPicture, "pictures/mine.png");
  const WorkingDirectory there(folder.path());
  EXPECT_EQ(compile(scene::Scene(from_text(with_picture("", "pictures/mine.png"))))->ntex, 1);
}

// The same built-in picture as heights and as a texture: 512 x 512 of both, three bytes of the texture's a pixel.
TEST_F(SceneSources, ABuiltInPictureGivesHeightsToo) {
  const std::string heights = "<hfield name='hills' file='mimo/textures/floor.png' size='1 1 0.1 0.1'/>";
  const std::string texture = "<texture name='floor' type='2d' file='mimo/textures/floor.png'/>";
  for (const std::string& assets : {heights, heights + texture, texture + heights}) {
    SCOPED_TRACE(assets);
    const engine::ModelPtr model = compile(scene::Scene(from_text("<mujoco><asset>" + assets + "</asset></mujoco>")));
    ASSERT_EQ(model->nhfielddata, 512 * 512);
    EXPECT_EQ(*std::max_element(model->hfield_data, model->hfield_data + model->nhfielddata), 1.0F);
    EXPECT_EQ(model->ntexdata, model->ntex * 3 * 512 * 512);
  }
}

// The user's folders are for the user's files only: the infant's own pictures are still found.
TEST_F(SceneSources, UsersFoldersDoNotAffectTheInfant) {
  const Folder folder;
  folder.copy_of(kPicture, "pictures/floor.png");
  const std::string path = folder.write(
      "mine.xml",
      "<mujoco><compiler texturedir='pictures' meshdir='shapes' strippath='true'/><include file='mimo/mitten.xml'/>"
      "<asset><texture name='t' type='2d' file='floor.png'/></asset></mujoco>");
  const engine::ModelPtr alone = compile(scene::Scene(from_text(kIncludesMimo)));
  EXPECT_EQ(compile(scene::Scene(from_file(path)))->ntex, alone->ntex + 1);
}

TEST_F(SceneSources, ModelDir) {
  scene::Source source = named("benchmark");
  source.model_dir = MIMO_MODELS;
  scene::Scene scene(source);
  scene.add_body("mitten", "", nullptr);
  expect_same_physics(*benchmark_model(), *compile(scene));

  const Folder folder;
  folder.write("free.xml", "<mujoco><worldbody><geom name='marker' size='1'/></worldbody></mujoco>");
  source = named("free");
  source.model_dir = folder.path();
  EXPECT_EQ(engine::find(*compile(scene::Scene(source)), engine::Kind::kGeom, "marker"), 0);
  source.name = "benchmark";
  expect_error(Status::kNotFound, "benchmark.xml in model_dir " + folder.path(), [&] { scene::Scene other(source); });
}

// The composed document says the same again.
TEST_F(SceneSources, ComposedTextReloads) {
  scene::Scene scene(named("benchmark"));
  scene.add_body("mitten", "", nullptr);
  const scene::Scene again(from_text(scene.xml()));
  expect_same_physics(*compile(scene), *compile(again));
  EXPECT_EQ(again.xml(), scene.xml());
}

// The way from a document to a model leads through memory: no file appears, neither here (the fixture looks) nor where
// temporary files go.
TEST_F(SceneSources, NoTemporaryFile) {
  const Folder folder;
  ::setenv("TMPDIR", folder.path().c_str(), 1);
  room_with_infant("benchmark");
  ::unsetenv("TMPDIR");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace mimo::test
