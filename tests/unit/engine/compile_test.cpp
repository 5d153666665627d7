// Models that do not compile: MuJoCo's message comes back as an error, and nothing else happens.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <string>

#include "compat/mujoco.h"
#include "support/quiet.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using EngineCompile = QuietTest;

const std::string kGood = "<mujoco><worldbody><geom name='ball' size='0.1'/></worldbody></mujoco>";

std::string with_asset(const std::string& asset) {
  return "<mujoco><asset>" + asset + "</asset><worldbody><geom size='0.1'/></worldbody></mujoco>";
}

void expect_refused(const std::string& xml, const std::string& part) {
  expect_error(Status::kModel, part, [&] { compiled(xml); });
  EXPECT_EQ(compiled(kGood)->ngeom, 1) << "a good model compiles after a bad one";
}

TEST_F(EngineCompile, TextThatIsNoXml) { expect_refused("this is no xml", "XML"); }
TEST_F(EngineCompile, TruncatedDocument) { expect_refused(kGood.substr(0, kGood.size() / 2), "XML"); }
TEST_F(EngineCompile, UnknownElement) { expect_refused("<mujoco><wordlbody/></mujoco>", "wordlbody"); }
TEST_F(EngineCompile, BadNumber) {
  expect_refused("<mujoco><worldbody><geom name='ball' size='wide'/></worldbody></mujoco>", "size");
}
TEST_F(EngineCompile, RepeatedName) {
  expect_refused("<mujoco><worldbody><geom name='twin' size='1'/><geom name='twin' size='1'/></worldbody></mujoco>",
                 "twin");
}
TEST_F(EngineCompile, UnknownReference) {
  expect_refused("<mujoco><worldbody><geom size='1'/></worldbody><actuator><motor joint='knee'/></actuator></mujoco>",
                 "knee");
}
TEST_F(EngineCompile, BodyWithoutMass) {
  expect_refused("<mujoco><worldbody><body name='ghost'><freejoint/></body></worldbody></mujoco>", "mass");
}
TEST_F(EngineCompile, MissingMeshFile) {
  expect_refused(with_asset("<mesh name='m' file='no/such/mesh.stl'/>"), "mesh.stl");
}
// MuJoCo 2 names the texture, not its file; MuJoCo 4 the file that it cannot open, and what it cannot decode by both.
#if MIMO_MUJOCO_4
constexpr const char *kWallMissing = "no/such/picture.png", *kHillsMissing = "no/such/hills.png";
constexpr const char *kWallDamaged = "name 'wall'", *kSmallStack = "<size memory='1K'/>", *kOverflow = "stack overflow";
#else
constexpr const char *kWallMissing = "name = wall", *kHillsMissing = "name = hills", *kWallDamaged = "name = wall";
constexpr const char *kSmallStack = "<size nstack='10'/>", *kOverflow = "Stack overflow";
#endif
TEST_F(EngineCompile, MissingTextureFile) {
  expect_refused(with_asset("<texture name='wall' type='2d' file='no/such/picture.png'/>"), kWallMissing);
}
TEST_F(EngineCompile, MissingHeightField) {
  expect_refused(with_asset("<hfield name='hills' file='no/such/hills.png' size='1 1 1 1'/>"), kHillsMissing);
}
TEST_F(EngineCompile, DamagedTextureFile) {
  const std::string broken = "this is no picture";
  const engine::Asset asset{"broken.png", {reinterpret_cast<const unsigned char*>(broken.data()), broken.size()}};
  const std::string xml = with_asset("<texture name='wall' type='2d' file='broken.png'/>");
  expect_error(Status::kModel, kWallDamaged, [&] { engine::compile(xml, {asset}, {}); });
}
// The compiler runs the physics once: a stack of a few numbers is not enough even for that.
TEST_F(EngineCompile, StackTooSmallForTheCompiler) { expect_refused(pile(4, kSmallStack), kOverflow); }

TEST_F(EngineCompile, MessageHasOneLine) {
  const std::string xml = "<mujoco>\n<worldbody>\n<body name='ghost'>\n<freejoint/>\n</body></worldbody></mujoco>";
  const Error error = error_of([&] { compiled(xml); });
  EXPECT_EQ(error.message().find('\n'), std::string::npos) << error.message();
  EXPECT_FALSE(error.message().empty());
}

TEST_F(EngineCompile, GoodModelIsSilent) {
  int messages = 0;
  const LogSink log([&messages](const LogRecord&) { ++messages; });
  engine::compile(kGood, {}, log);
  EXPECT_EQ(messages, 0);
}

TEST_F(EngineCompile, NamesAreFound) {
  const engine::ModelPtr model = compiled(kGood);
  EXPECT_EQ(engine::find(*model, engine::Kind::kGeom, "ball"), 0);
  EXPECT_EQ(engine::find(*model, engine::Kind::kGeom, "bal"), -1);
  EXPECT_EQ(engine::find(*model, engine::Kind::kGeom, ""), -1);
  EXPECT_STREQ(engine::name(*model, engine::Kind::kBody, 0), "world");
  expect_error(Status::kNotFound, "no geom named \"bal\"; did you mean \"ball\"? there are: ball",
               [&] { engine::find_or_fail(*model, engine::Kind::kGeom, "bal"); });
  expect_error(Status::kNotFound, "there are: none",
               [&] { engine::find_or_fail(*model, engine::Kind::kSensor, "bal"); });
}

}  // namespace
}  // namespace mimo::test
