// Documents whose parts are each allowed, but not all of them together: what they cost MuJoCo in bytes, which it counts
// in ints, and in time, in which nobody else can make a world, is known before it sees them.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "document/mesh_data.h"
#include "support/files.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using SceneBudget = QuietTest;
using Points = std::vector<std::array<double, 3>>;

const std::string kBall = "<worldbody><geom size='1'/></worldbody>";
constexpr std::uint64_t kAnyTime = 1'000'000'000;

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

std::string world(const std::string& content) { return "<worldbody>" + content + "</worldbody>"; }

void expect_refused(scene::Source source, const std::string& what) {
  const auto start = std::chrono::steady_clock::now();
  expect_error(Status::kModel, what, [&] { compile(scene::Scene(source)); });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 20) << what;
}

// With all the time that it may want, for its bytes.
void expect_too_large(const std::string& content, const std::string& what) {
  scene::Source source = from_text("<mujoco>\n" + content + "</mujoco>");
  source.limits.compile_ms = kAnyTime;
  expect_refused(source, what);
}

void expect_too_long(const std::string& content, std::uint64_t most, const std::string& place) {
  scene::Source source = from_text("<mujoco>\n" + content + "</mujoco>");
  source.limits.compile_ms = most;
  expect_refused(source, place);
  expect_refused(source, "more than max_compile_ms (" + std::to_string(most) + ")");
}

// 3000 x 18000 pixels each, of three bytes: 14 are more than 2^31 bytes, and 27 wrapped to few.
TEST_F(SceneBudget, TexturesTogether) {
  std::string textures = "<asset>\n";
  for (int i = 0; i < 27; ++i) {
    textures += "<texture name='" + std::to_string(i) + "' type='cube' builtin='flat' width='3000' height='3000'/>\n";
  }
  expect_too_large(textures + "</asset>" + kBall, "with this <texture>, the model would have about");
  expect_refused(from_text("<mujoco>\n" + textures + "</asset>" + kBall + "</mujoco>"), "max_compile_ms (10000)");
#if !MIMO_MUJOCO_4
  expect_too_large(textures + "</asset>" + kBall,
                   "line 16: with this <texture>, the model would have about 2.27e+09 bytes");
  expect_too_large(textures + "</asset>" + kBall, "bytes, more than MuJoCo 2.2.2 can count (2147483647)");
#endif
}

// 8000 x 8000 points of four bytes: the 17th is above 4 GiB, the 9th above 2 GiB.
TEST_F(SceneBudget, HeightFieldsTogether) {
  std::string fields;
  for (int i = 0; i < 20; ++i)
    fields += "<hfield name='" + std::to_string(i) + "' nrow='8000' ncol='8000' size='1 1 1 1'/>";
  expect_too_large("<asset>" + fields + "</asset>" + kBall, "with this <hfield>, the model would have about");
}

TEST_F(SceneBudget, OneMeshUnderManyNames) {
  const Folder folder;
  std::string grid;
  for (int i = 0; i < 300; ++i) {
    for (int j = 0; j < 300; ++j)
      grid += "v " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(i * j) + "\n";
  }
  grid += repeated("f 1 302 603\n", 10);
  folder.write("a.obj", grid);
  scene::Source source = from_file(folder.write(
      "room.xml", "<mujoco><asset>" +
                      [] {
                        std::string meshes;
                        for (int i = 0; i < 3000; ++i)
                          meshes += "<mesh name='" + std::to_string(i) + "' file='a.obj'/>\n";
                        return meshes;
                      }() +
                      "</asset>" + kBall + "</mujoco>"));
  source.limits.compile_ms = 1000;
  expect_refused(source, "with this <mesh>, compiling the document would take about 1");
}

// Numbers that one class gives all geoms: 39,000 x 60,000 is more than an int holds.
TEST_F(SceneBudget, NumbersOfUsersByClass) {
  expect_too_large(
      "<default><geom user='" + repeated("1 ", 60000) + "'/></default>" + world(repeated("<geom size='1'/>", 39000)),
      "the model would have about");
}

TEST_F(SceneBudget, KeyframesOfManyJoints) {
  const std::string joints = repeated("<body><freejoint/><geom size='1'/></body>", 10000);
  expect_too_large(
      "<size nstack='100' njmax='1'/>" + world(joints) + "<keyframe>" + repeated("<key/>", 9000) + "</keyframe>",
      "with this <key>, the model would have about");
}

TEST_F(SceneBudget, NamesThatCompositesRepeat) {
  expect_too_large(world("<body><composite type='grid' prefix='" + std::string(500000, 'x') +
                         "' count='80 80 1' spacing='.1'><geom size='.01'/></composite></body>"),
                   "the model would have about");
}

TEST_F(SceneBudget, BuffersOfWorlds) {
  expect_too_large(kBall + "<sensor><user dim='2000000000'/><user dim='2000000000'/></sensor>", "max_world_bytes");
  std::string bodies, motors;
  for (int i = 0; i < 9900; ++i) {
    bodies += "<body><joint name='" + std::to_string(i) + "'/><geom size='1'/></body>";
    motors += "<motor joint='" + std::to_string(i) + "'/>";
  }
  scene::Source source = from_text("<mujoco><size nstack='100' njmax='1'/>" + world(bodies) + "<actuator>" + motors +
                                   "</actuator></mujoco>");
  source.limits.compile_ms = kAnyTime;
  source.limits.world_bytes = 500'000'000;  // each motor has a moment for each of the joints: 9900^2 numbers
  expect_refused(source, "9900 degrees of freedom), more than max_world_bytes");
}

// The compiler compares all elements with each other, turns dense matrices around, and moves muscles to their ends.
TEST_F(SceneBudget, TimesOfElements) {
  expect_too_long(world(repeated("<geom size='1'/>", 39000)), 2000, "compiling the document would take about 3");
  const std::string joints = repeated("<body><freejoint/><geom size='1'/></body>", 1000);
  expect_too_long("<option jacobian='dense'/>" + world(joints), 10000, "xml text, line 1");
  std::string bodies, muscles;
  for (int i = 0; i < 100; ++i) {
    bodies += "<body><joint name='" + std::to_string(i) + "'/><geom size='1'/></body>";
    muscles += "<muscle joint='" + std::to_string(i) + "'/>";
  }
  expect_too_long(world(bodies) + "<actuator>" + muscles + "</actuator>", 2000, "xml text, line 1");
}

// Whether three corners of a face hold one of its others is asked of each: a minute for 100,000.
TEST_F(SceneBudget, FacesOfManyCorners) {
  const Folder folder;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const scene::Source source =
      from_file(folder.write("room.xml", "<mujoco>\n<asset>\n<mesh file='a.obj'/></asset>" + kBall + "</mujoco>"));
  folder.write("a.obj", corners + "f" + repeated(" 1 2 3 4", 20000) + "\n");
  expect_refused(source, "line 3: with this <mesh>, compiling the document would take about 32 s");
  folder.write("a.obj", corners + "f" + repeated(" 1 2 3 4", 300000) + "\n");
  expect_refused(source, "has 1199998 faces, cut into triangles, more than max_vertices (1000000)");
}

Points on_sphere(int count) {
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  Points points;
  for (int i = 0; i < count; ++i) {
    const double x = gauss(random), y = gauss(random), z = gauss(random), r = std::sqrt(x * x + y * y + z * z);
    points.push_back({x / r, y / r, z / r});
  }
  return points;
}

// A cube of size 1 whose sides are grids.
Points on_cube(int cells) {
  Points points;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const double a = double(i) / cells, b = double(j) / cells;
      for (const double side : {0.0, 1.0}) {
        points.push_back({side, a, b});
        points.push_back({a, side, b});
        points.push_back({a, b, side});
      }
    }
  }
  return points;
}

// All points of a sphere are corners of their hull; of a cube there are eight.
TEST_F(SceneBudget, CornersOfHulls) {
  EXPECT_EQ(document::hull_corners(on_sphere(2000)), 2000);
  EXPECT_NEAR(document::hull_corners(on_sphere(40000)), 40000, 400);
  EXPECT_LT(document::hull_corners(on_cube(100)), 6000);
}

std::string mesh_of(const Points& points, const std::string& geom) {
  std::string numbers;
  for (const auto& point : points) {
    for (const double number : point) numbers += std::to_string(number) + " ";
  }
  return "<asset><mesh name='m' vertex='" + numbers + "'/></asset>" + world(geom);
}

TEST_F(SceneBudget, TimesOfHulls) {
  const std::string geom = "<geom type='mesh' mesh='m'/>";
  expect_too_long(mesh_of(on_sphere(120000), geom), 10000, "line 2: with this <mesh>, compiling");
  EXPECT_EQ(compile(scene::Scene(from_text("<mujoco>" + mesh_of(on_cube(60), geom) + "</mujoco>")))->nmesh, 1);
}

TEST_F(SceneBudget, LongTimesAreTold) {
  std::vector<std::string> told;
  const LogSink log([&told](const LogRecord& record) { told.push_back(record.text); });
  const std::string sites = world(repeated("<site/>", 25000));
  document::compile(scene::Scene(from_text("<mujoco>" + sites + "</mujoco>")).compose(), log);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("compiling may take 1.2"), std::string::npos) << told[0];
  told.clear();
  document::compile(scene::Scene(from_text("<mujoco>" + world(repeated("<site/>", 1000)) + "</mujoco>")).compose(),
                    log);
  EXPECT_TRUE(told.empty()) << told[0];
}

// The compiler knows nothing of contacts, the model does.
TEST_F(SceneBudget, ContactsAreThere) {
  EXPECT_EQ(compile(scene::Scene(from_text("<mujoco>" + kBall + "</mujoco>")))->opt.disableflags & mjDSBL_CONTACT, 0);
  const std::string off = "<option><flag contact='disable'/></option>",
                    on = "<option><flag contact='enable'/></option>";
  EXPECT_NE(compile(scene::Scene(from_text("<mujoco>" + off + kBall + "</mujoco>")))->opt.disableflags & mjDSBL_CONTACT,
            0);
  EXPECT_EQ(
      compile(scene::Scene(from_text("<mujoco>" + off + kBall + on + "</mujoco>")))->opt.disableflags & mjDSBL_CONTACT,
      0);
}

// 16 million pairs of geoms lie in each other: half a minute, were they asked whether they touch.
TEST_F(SceneBudget, GeomsThatLieInEachOther) {
  const std::string pile = "<body><freejoint/>" + repeated("<geom size='.1 .1 .1' type='box'/>", 4000) + "</body>";
  const scene::Scene scene(from_text("<mujoco>" + world(pile + pile) + "</mujoco>"));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(compile(scene)->ngeom, 8000);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 10);
}

}  // namespace
}  // namespace mimo::test
