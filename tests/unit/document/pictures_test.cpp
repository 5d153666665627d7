// Built-in pictures that are decoded before a model is compiled: the compiler makes the same textures of them.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <string>

#include "compat/mujoco.h"
#include "document/library.h"
#include "engine/compiler.h"

namespace mimo::test {
namespace {

std::vector<engine::Asset> pictures() {
  std::vector<engine::Asset> assets;
  for (const std::string name : {"head_front_fear", "head_back", "floor"}) {
    assets.push_back({name + ".png", document::built_in_file("textures/" + name + ".png")});
  }
  return assets;
}

engine::ModelPtr painted(const std::vector<engine::Asset>& assets) {
  std::string xml = "<mujoco><asset><texture name='cube' type='cube' rgb1='1 0 0'";
  xml += " fileright='" + assets[0].name + "' fileleft='" + assets[1].name + "' fileup='" + assets[0].name + "'/>";
  xml += "<texture name='flat' type='2d' file='" + assets[2].name + "' hflip='true'/></asset></mujoco>";
  return engine::compile(xml, assets, {});
}

TEST(Pictures, EqualTheTexturesOfTheirFiles) {
  std::vector<engine::Asset> assets = pictures();
  const engine::ModelPtr of_files = painted(assets);
  document::decode_pictures(assets);
  const engine::ModelPtr of_pixels = painted(assets);
  ASSERT_EQ(of_pixels->ntexdata, 3 * (6 * 256 * 256 + 512 * 512));
  EXPECT_EQ(of_pixels->ntexdata, of_files->ntexdata);
  const auto pixels = compat::kPixels;
  EXPECT_TRUE(std::equal((*of_files).*pixels, (*of_files).*pixels + of_files->ntexdata, (*of_pixels).*pixels));
}

TEST(Pictures, AreDecodedOnce) {
  if (!engine::takes_decoded()) GTEST_SKIP() << "this MuJoCo keeps what it has decoded";
  std::vector<engine::Asset> first = pictures(), second = pictures();
  document::decode_pictures(first);
  document::decode_pictures(second);
  ASSERT_EQ(second[2].bytes.size(), 8 + 3 * 512 * 512);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].bytes.data(), second[i].bytes.data());
}

TEST(Pictures, LeaveOtherFilesUnchanged) {
  const unsigned char bytes[] = {1, 2, 3};
  std::vector<engine::Asset> assets = {{"mesh.stl", {bytes, 3}}};
  document::decode_pictures(assets);
  EXPECT_EQ(assets[0].name, "mesh.stl");
  EXPECT_EQ(assets[0].bytes.data(), bytes);
  EXPECT_EQ(document::decoded_name("mesh.stl"), "mesh.stl");
}

}  // namespace
}  // namespace mimo::test
