// Scenes that are written to disk: MuJoCo alone makes of them what we do.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <sys/resource.h>

#include <array>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
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

namespace fs = std::filesystem;
using SceneSave = QuietTest;

engine::ModelPtr plain_mujoco(const std::string& path) {
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML(path.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
  if (model == nullptr) throw std::runtime_error(error.data());
  return {model, [](const mjModel* m) { mj_deleteModel(const_cast<mjModel*>(m)); }};
}

void expect_same(const mjModel& one, const mjModel& other) {
  expect_same_physics(one, other);
  ASSERT_EQ(one.ntexdata, other.ntexdata);
  EXPECT_EQ(std::memcmp(one.*compat::kPixels, other.*compat::kPixels, static_cast<std::size_t>(one.ntexdata)), 0);
  ASSERT_EQ(one.nnames, other.nnames);
  EXPECT_EQ(std::memcmp(one.names, other.names, static_cast<std::size_t>(one.nnames)), 0);
  ASSERT_EQ(one.nmat, other.nmat);
  EXPECT_TRUE(std::equal(one.geom_matid, one.geom_matid + one.ngeom, other.geom_matid));
  EXPECT_TRUE(std::equal(one.mat_texid, one.mat_texid + one.nmat, other.mat_texid));
}

std::string read(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(SceneSave, BuiltInScenes) {
  for (const std::string name : {"benchmark", "catch", "showroom"}) {
    SCOPED_TRACE(name);
    const Folder folder;
    scene::Scene scene(named(name));
    scene.add_body(scene.usual_infant().body, "", nullptr);
    document::save(scene.package(), folder.path("a/b"));
    const engine::ModelPtr model = plain_mujoco(folder.path("a/b/scene.xml"));
    expect_same(*compile(scene), *model);
    EXPECT_GT(model->ntex, 5);
  }
}

// Two files of one name, one with a name that not every disk takes, and meshes that are called after their files.
TEST_F(SceneSave, UsersFiles) {
  const Folder folder, elsewhere;
  const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const std::string picture = read(std::string(MIMO_MODELS) + "/textures/ball_c.png");
  folder.write("one/part.obj", corner);
  folder.write("two/part.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  folder.write("A b:\xc3\xa9.obj", corner);
  folder.write("looks/part.png", picture);
  const std::string path = folder.write(
      "scene.xml",
      "<mujoco><asset><mesh file='one/part.obj'/><mesh name='other' file='two/part.obj'/><mesh file='A "
      "b:\xc3\xa9.obj'/>"
      "<texture name='t' type='2d' file='looks/part.png'/></asset><worldbody><body><freejoint/>"
      "<geom type='mesh' mesh='part'/><geom type='mesh' mesh='other'/><geom type='mesh' mesh='A b:\xc3\xa9'/></body>"
      "</worldbody></mujoco>");
  const scene::Scene scene(from_file(path));
  document::save(scene.package(), elsewhere.path("saved"));
  expect_same(*compile(scene), *plain_mujoco(elsewhere.path("saved/scene.xml")));
  for (const auto& entry : fs::directory_iterator(elsewhere.path("saved/assets"))) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-."), std::string::npos) << name;
  }
}

TEST_F(SceneSave, NothingIsOverwritten) {
  const Folder folder;
  scene::Scene scene(named("free"));
  document::save(scene.package(), folder.path("s"));
  document::save(scene.package(), folder.path("s"));  // the same again is there already
  const std::string before = read(folder.path("s/scene.xml"));
  scene.add_body("mitten", "", nullptr);
  expect_error(Status::kFile, "scene.xml already exists with other content",
               [&] { document::save(scene.package(), folder.path("s")); });
  EXPECT_EQ(read(folder.path("s/scene.xml")), before);
  EXPECT_FALSE(fs::exists(folder.path("s/assets/mimo_skin.png")));
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder.path("s/assets"))) files += entry.is_regular_file();
  EXPECT_EQ(files, 1u) << "the floor's picture, and none of the infant's";
  const std::string file = folder.write("file", "");
  expect_error(Status::kFile, "cannot be made", [&] { document::save(scene.package(), file); });
  expect_error(Status::kFile, "cannot be made", [&] { document::save(scene.package(), file + "/below"); });
}

// All files below a folder, and folders, by their paths, with what they hold.
std::map<std::string, std::string> content_of(const std::string& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    content[entry.path().string()] = entry.is_regular_file() ? read(entry.path().string()) : "a folder";
  }
  return content;
}

// Files that may not grow further than that, as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

// One file after the other is the first for which there is no room, the longest at last.
TEST_F(SceneSave, AFullDiskLeavesNothing) {
  const Folder folder, elsewhere, half;
  scene::Scene scene(named("free"));
  document::save(scene.package(), half.path("s"));  // a part of what follows
  fs::remove(half.path("s/scene.xml"));
  const auto before = content_of(half.path(""));
  scene.add_body("mitten", "", nullptr);
  document::save(scene.package(), elsewhere.path("s"));
  std::set<std::size_t> sizes;
  for (const auto& entry : fs::recursive_directory_iterator(elsewhere.path("s"))) {
    if (entry.is_regular_file()) sizes.insert(fs::file_size(entry));
  }
  ASSERT_GE(sizes.size(), 3u);
  for (const std::size_t size : sizes) {
    SCOPED_TRACE(size);
    {
      const SmallDisk disk(size - 1);
      expect_error(Status::kFile, "cannot be written", [&] { document::save(scene.package(), folder.path("a/b")); });
    }
    EXPECT_TRUE(content_of(folder.path("")).empty());
  }
  {
    const SmallDisk disk(*sizes.rbegin() - 1);
    expect_error(Status::kFile, "cannot be written", [&] { document::save(scene.package(), half.path("s")); });
  }
  EXPECT_EQ(content_of(half.path("")), before);
  document::save(scene.package(), half.path("s"));  // and now there is room
  expect_same(*plain_mujoco(half.path("s/scene.xml")), *plain_mujoco(elsewhere.path("s/scene.xml")));
}

TEST_F(SceneSave, AMissingFileIsNamed) {
  const Folder folder;
  const scene::Scene scene(from_text("<mujoco><asset><mesh file='no/such.obj'/></asset></mujoco>"));
  expect_error(Status::kNotFound, "no/such.obj", [&] { document::save(scene.package(), folder.path("s")); });
  EXPECT_FALSE(fs::exists(folder.path("s")));
}

}  // namespace
}  // namespace mimo::test
