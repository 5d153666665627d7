// Models that have the same textures hold them once.
#include "engine/textures.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <string>

#include "compat/mujoco.h"
#include "engine/fingerprint.h"

namespace mimo::test {
namespace {

using engine::ModelPtr;

// A ball of a size, with a picture of a colour and a width.
ModelPtr painted(const std::string& size, const std::string& color, int width = 16) {
  return engine::compile("<mujoco><asset><texture name='t' type='2d' builtin='flat' rgb1='" + color + "' width='" +
                             std::to_string(width) +
                             "' height='17'/><material name='m' texture='t'/></asset><worldbody>" + "<geom size='" +
                             size + "' material='m'/></worldbody></mujoco>",
                         {}, {});
}

TEST(Textures, OfTheSamePicturesAreShared) {
  const ModelPtr owner = painted("1", "1 0 0"), model = painted("2", "1 0 0");
  const ModelPtr slim = engine::with_textures_of(owner, model);
  ASSERT_NE(slim, model);
  EXPECT_EQ((*slim).*compat::kPixels, (*owner).*compat::kPixels);
  EXPECT_EQ(slim->ntexdata, 3 * 16 * 17);
  EXPECT_EQ(engine::fingerprint(*slim), engine::fingerprint(*model));
  EXPECT_EQ(slim->geom_size[0], 2);
  EXPECT_EQ(compat::color_texture(*slim, 0), 0);
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
