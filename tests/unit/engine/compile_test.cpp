#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "engine/compiler.h"
#include "engine/hooks.h"
#include "engine/model.h"
#include "support/quiet.h"
#include "support/tiny.h"

namespace mimo::engine {
namespace {

int compile_in_the_child() {
  alarm(30);
  try {
    const CompileLock lock;
    return 0;
  } catch (const Error& error) {
    return static_cast<int>(-static_cast<std::int32_t>(error.status()));
  }
}

int exit_status_of_a_child() {
  const pid_t child = fork();
  if (child == 0) _exit(compile_in_the_child());
  int status = -1;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(CompileLock, ForkWaitsForTheCompiler) {
  std::atomic<bool> compiling{false}, done{false};
  std::thread other([&] {
    const CompileLock lock;
    compiling = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    done = true;
  });
  while (!compiling) std::this_thread::yield();
  EXPECT_EQ(exit_status_of_a_child(), 0);
  EXPECT_TRUE(done);
  other.join();
  const CompileLock still_opens;
}

// As a signal handler may do that interrupts the compiler: nobody could wait for it.
TEST(CompileLock, AChildOfTheCompilingThreadIsRefused) {
  {
    const CompileLock lock;
    EXPECT_EQ(exit_status_of_a_child(), -static_cast<int>(Status::kForked));
  }
  EXPECT_EQ(exit_status_of_a_child(), 0);
}

}  // namespace

}  // namespace mimo::engine

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

TEST_F(EngineCompile, RefusesTextThatIsNotXml) { expect_refused("this is no xml", "XML"); }
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

using engine::ModelPtr;

// A ball of a size, with a picture of a colour and a width.
ModelPtr painted(const std::string& size, const std::string& color, int width = 16) {
  return engine::compile("<mujoco><asset><texture name='t' type='2d' builtin='flat' rgb1='" + color + "' width='" +
                             std::to_string(width) +
                             "' height='17'/><material name='m' texture='t'/></asset><worldbody>" + "<geom size='" +
                             size + "' material='m'/></worldbody></mujoco>",
                         {}, {});
}

// Models that have the same textures hold them once.
TEST(Textures, OfTheSamePicturesAreShared) {
  const ModelPtr owner = painted("1", "1 0 0"), model = painted("2", "1 0 0");
  const ModelPtr slim = engine::with_textures_of(owner, model);
  ASSERT_NE(slim, model);
  EXPECT_EQ((*slim).*compat::kPixels, (*owner).*compat::kPixels);
  EXPECT_EQ(slim->ntexdata, 3 * 16 * 17);
  EXPECT_EQ(engine::fingerprint(*slim), engine::fingerprint(*model));
  EXPECT_EQ(slim->geom_size[0], 2);
  EXPECT_EQ(compat::color_textures(*slim)[0], 0);
  EXPECT_STREQ(mj_id2name(slim.get(), mjOBJ_MATERIAL, 0), "m");
}

TEST(Textures, LiveAsLongAsAModelUsesThem) {
  ModelPtr owner = painted("1", "1 0 0");
  const ModelPtr slim = engine::with_textures_of(owner, painted("2", "1 0 0"));
  owner.reset();
  EXPECT_EQ(((*slim).*compat::kPixels)[0], 255);
  EXPECT_EQ(((*slim).*compat::kPixels)[3 * 16 * 17 - 1], 0);
}

TEST(Textures, AreCopiedWithTheModel) {
  const ModelPtr slim = engine::with_textures_of(painted("1", "1 0 0"), painted("2", "1 0 0"));
  mjModel* copy = mj_copyModel(nullptr, slim.get());
  EXPECT_NE((*copy).*compat::kPixels, (*slim).*compat::kPixels);
  EXPECT_EQ(((*copy).*compat::kPixels)[0], 255);
  mj_deleteModel(copy);
}

TEST(Textures, OfOtherPicturesStay) {
  const ModelPtr owner = painted("1", "1 0 0"), blue = painted("1", "0 0 1"), wide = painted("1", "1 0 0", 32);
  EXPECT_EQ(engine::with_textures_of(owner, blue), blue);
  EXPECT_EQ(engine::with_textures_of(owner, wide), wide);
  EXPECT_EQ(engine::with_textures_of(owner, owner), owner);
}

}  // namespace
}  // namespace mimo::test
