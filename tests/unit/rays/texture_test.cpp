// Textures of the ray renderer: which texel goes where, and how small ones blur.
#include <algorithm>

#include "compat/mujoco.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

constexpr const char* kLamp = "<headlight ambient='1 1 1'/>";

// Fills a texture of the model; color(face, x, y) gives 0..255 a channel.
template <typename Color>
void fill(mjModel& model, int texture, Color&& color) {
  const int width = model.tex_width[texture];
  const int height = model.tex_height[texture];
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::array<int, 3> c = color(y / width, x, y % width);
      for (int k = 0; k < 3; ++k) {
        (model.*compat::kPixels)[model.tex_adr[texture] + 3 * (y * width + x) + k] = static_cast<mjtByte>(c[k]);
      }
    }
  }
}

std::string textured(const std::string& geom, const std::string& material) {
  return world(geom,
               "<texture name='flat' type='2d' builtin='flat' width='64' height='64'/>"
               "<texture name='cube' type='cube' builtin='flat' width='64' height='384'/>" +
                   format("<material name='painted' specular='0' rgba='1 1 1 1' {}/>", material),
               kLamp);
}

// A floor of 2 x 2 m whose texture has its column in red and its row in green.
Shot floor_with(const std::string& material, const render::View& view, int width, int height) {
  const auto model =
      engine::compile(textured("<geom type='plane' size='1 1 1' material='painted'/>", material), {}, {});
  fill(const_cast<mjModel&>(*model), 0, [](int, int x, int y) { return std::array<int, 3>{4 * x, 4 * y, 0}; });
  return Studio(model, {}).shoot(view, width, height);
}

TEST(RayTextures, FlatCoversThePlane) {
  // From above, right is +x and up is +y; row 0 of a texture is at +y.
  const Shot shot = floor_with("texture='flat'", from_above(10, 2 * std::atan(0.1) * 180 / kPi), 64, 64);
  for (int y = 2; y < 62; ++y) {
    for (int x = 2; x < 62; ++x) {
      EXPECT_NEAR(shot.color(x, y)[0], 4 * x, 4) << x << " " << y;
      EXPECT_NEAR(shot.color(x, y)[1], 4 * y, 4) << x << " " << y;
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(RayTextures, FlatRepeats) {
  const render::View view = from_above(10, 2 * std::atan(0.1) * 180 / kPi);
  const Shot shot = floor_with("texture='flat' texrepeat='4 2'", view, 256, 256);
  // Four periods along x, two along y.
  for (const int x : {5, 20, 40}) {
    for (const int y : {7, 33, 100}) {
      EXPECT_NEAR(shot.color(x, y)[0], shot.color(x + 64, y)[0], 6);
      EXPECT_NEAR(shot.color(x, y)[1], shot.color(x, y + 128)[1], 6);
      EXPECT_NEAR(shot.color(x + 10, y)[0] - shot.color(x, y)[0], 40, 8);
      EXPECT_NEAR(shot.color(x, y + 10)[1] - shot.color(x, y)[1], 20, 8);
    }
  }
}

// With texuniform, texrepeat counts per metre, whatever the size.
TEST(RayTextures, FlatUniform) {
  const auto model = engine::compile(textured("<geom type='plane' size='1.5 3 1' material='painted'/>",
                                              "texture='flat' texuniform='true' texrepeat='2 2'"),
                                     {}, {});
  fill(const_cast<mjModel&>(*model), 0, [](int, int x, int y) { return std::array<int, 3>{4 * x, 4 * y, 0}; });
  const Shot shot = Studio(model, {}).shoot(from_above(10, 2 * std::atan(0.1) * 180 / kPi), 256, 256);
  for (const int i : {10, 40, 90}) {  // 128 pixels are a metre and a period
    EXPECT_NEAR(shot.color(i, i)[0], shot.color(i + 128, i)[0], 6);
    EXPECT_NEAR(shot.color(i, i)[1], shot.color(i, i + 128)[1], 6);
    EXPECT_NEAR(shot.color(i + 10, i)[0] - shot.color(i, i)[0], 20, 6);
  }
}

// Faces in MuJoCo's order, right left up down front back, are +x -x +y -y +z -z of the geom.
TEST(RayTextures, CubeFaces) {
  const std::array<std::array<int, 3>, 6> colors = {
      {{250, 0, 0}, {0, 250, 0}, {0, 0, 250}, {250, 250, 0}, {0, 250, 250}, {250, 0, 250}}};
  for (const char* kind : {"type='box' size='.2 .3 .4'", "type='sphere' size='.2'", "type='ellipsoid' size='.1 .2 .3'",
                           "type='capsule' size='.2 .3'", "type='cylinder' size='.2 .3'"}) {
    const auto model =
        engine::compile(textured(format("<geom {} material='painted'/>", kind), "texture='cube'"), {}, {});
    fill(const_cast<mjModel&>(*model), 1, [&](int face, int, int) { return colors[face]; });
    Studio studio(model, {});
    const double sides[6][2] = {{180, 0}, {0, 0}, {-90, 0}, {90, 0}, {90, -90}, {90, 90}};
    for (int face = 0; face < 6; ++face) {
      const Shot shot = studio.shoot(render::orbit_view({0, 0, 0}, 2, sides[face][0], sides[face][1], 30));
      EXPECT_EQ(shot.middle(), colors[face]) << kind << " face " << face;
    }
  }
}

// Orientation within a face, as OpenGL defines it: on +z, columns run along x and rows against y.
TEST(RayTextures, CubeOrientation) {
  const auto model = engine::compile(
      textured("<geom type='box' size='1 1 .1' material='painted'/>", "texture='cube' texuniform='true'"), {}, {});
  fill(const_cast<mjModel&>(*model), 1, [](int face, int x, int y) {
    return std::array<int, 3>{4 * x, 4 * y, face * 40};
  });
  const auto close_up = [&](double x, double y) {
    return Studio(model, {}).shoot(render::orbit_view({x, y, 0.1}, 1, 90, -90, 1)).middle();
  };
  // The map looks along (x, y, z) itself: near the middle of the face, |x| and |y| must be below 0.1.
  EXPECT_NEAR(close_up(0.05, 0)[0], 4 * 48, 4);
  EXPECT_NEAR(close_up(-0.05, 0)[0], 4 * 16, 4);
  EXPECT_NEAR(close_up(0, 0.05)[1], 4 * 16, 4);
  EXPECT_NEAR(close_up(0, 0)[2], 160, 1);
  EXPECT_NEAR(close_up(0.5, 0)[2], 0, 1);
  EXPECT_NEAR(close_up(-0.5, 0)[2], 40, 1);
}

// What is much smaller than a pixel turns into its mean, without a pattern of its own.
TEST(RayTextures, SmallBlurs) {
  for (const char* material : {"texture='flat' texrepeat='40 40'", "texture='cube'"}) {
    const auto model =
        engine::compile(textured("<geom type='box' size='1 1 1' material='painted'/>", material), {}, {});
    for (const int texture : {0, 1}) {
      fill(const_cast<mjModel&>(*model), texture, [](int, int x, int y) {
        const int c = (x / 2 + y / 2) % 2 ? 250 : 0;
        return std::array<int, 3>{c, c, c};
      });
    }
    const Shot shot = Studio(model, {}).shoot(from_above(49, 12));
    for (int y = 14; y < 19; ++y) {
      for (int x = 14; x < 19; ++x) EXPECT_NEAR(shot.color(x, y)[0], 125, 6) << material << " " << x << " " << y;
    }
  }
}

TEST(RayTextures, SharedByRenderers) {
  const auto model =
      engine::compile(textured("<geom type='box' size='1 1 1' material='painted'/>", "texture='flat'"), {}, {});
  rays::Options options;
  options.assets = rays::make_assets(model);
  Studio one(model, options), two(model, options), own(model, {});
  EXPECT_EQ(options.assets.use_count(), 3);
  EXPECT_EQ(one.shoot(from_above(3)).rgb, own.shoot(from_above(3)).rgb);
  EXPECT_EQ(two.shoot(from_above(3)).rgb, own.shoot(from_above(3)).rgb);
}

// The sky's map is turned by 90 degrees about x: up is its +y face.
TEST(RayTextures, Sky) {
  const auto model =
      engine::compile(world("", "<texture type='skybox' builtin='flat' width='64' height='384'/>"), {}, {});
  const std::array<std::array<int, 3>, 6> colors = {
      {{250, 0, 0}, {0, 250, 0}, {0, 0, 250}, {250, 250, 0}, {0, 250, 250}, {250, 0, 250}}};
  fill(const_cast<mjModel&>(*model), 0, [&](int face, int, int) { return colors[face]; });
  Studio studio(model, {});
  const double towards[6][2] = {{0, 0}, {180, 0}, {0, 90}, {0, -90}, {-90, 0}, {90, 0}};
  for (int face = 0; face < 6; ++face) {
    const Shot shot = studio.shoot(render::orbit_view({0, 0, 0}, 1, towards[face][0], towards[face][1], 30));
    EXPECT_EQ(shot.middle(), colors[face]) << face;
    EXPECT_EQ(shot.middle_id(), -1);
    EXPECT_EQ(shot.depth[0], 50.0F);
  }
  rays::Options black;
  black.skybox = false;
  EXPECT_EQ(Studio(model, black).shoot(from_above(1)).middle(), (std::array<int, 3>{0, 0, 0}));
}

}  // namespace
}  // namespace mimo::test
