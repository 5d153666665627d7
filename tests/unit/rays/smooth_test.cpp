// Light on planes is interpolated where it changes little. On the upper face of a box it is computed for each ray: the
// two must look the same, wherever the light has edges and peaks.
#include <algorithm>
#include <string>

#include "base/format.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

struct Lamp {
  const char* name;
  const char* light;
};

class Smooth : public ::testing::TestWithParam<Lamp> {};

TEST_P(Smooth, PlanesLookLikeBoxes) {
  const std::string lights =
      std::string("<light ") + GetParam().light + "/>" + "<geom type='sphere' size='.03' pos='.1 .05 .1'/>";
  const std::string assets =
      "<texture name='check' type='2d' builtin='checker' width='64' height='64' rgb1='.4 .6 .7' rgb2='.9 .8 .7'/>"
      "<material name='plain' specular='.6' shininess='.9' rgba='.5 .5 .5 1'/>"
      "<material name='colored' specular='.4' shininess='.1' rgba='.6 .4 .5 1'/>"
      "<material name='flat' texture='check' texrepeat='40 30' specular='.3' shininess='.5'/>";
  const std::string visual = "<headlight ambient='.1 .1 .1' diffuse='.2 .2 .2' specular='.3 .3 .3'/>";
  int different = 0;
  for (const char* material : {"plain", "colored", "flat"}) {
    Studio plane(world(format("{}<geom type='plane' size='5 5 1' material='{}'/>", lights, material), assets, visual));
    Studio box(world(format("{}<geom type='box' size='5 5 1' pos='0 0 -1' material='{}'/>", lights, material), assets,
                     visual));
    for (const int pixels : {48, 200, 440}) {  // tiles by themselves, two and four side by side
      for (const double distance : {0.25, 1.0, 3.0}) {
        for (const double elevation : {-80.0, -35.0}) {
          const render::View view = render::orbit_view({0.05, 0, 0}, distance, 70, elevation, 50);
          const Shot a = plane.shoot(view, pixels, pixels);
          const Shot b = box.shoot(view, pixels, pixels);
          ASSERT_EQ(a.ids, b.ids);
          for (std::size_t i = 0; i < a.rgb.size(); ++i) {
            const int difference = std::abs(a.rgb[i] - b.rgb[i]);
            different += difference > 0;
            // A texel may lie on the other side of a boundary by a rounding error, and shadows as well.
            EXPECT_LE(difference, 1) << material << ", " << pixels << " pixels, from " << distance << " m";
            if (difference > 1) return;
          }
        }
      }
    }
  }
  RecordProperty("different", different);
}

INSTANTIATE_TEST_SUITE_P(
    RaySmooth, Smooth,
    ::testing::Values(Lamp{"High", "pos='0 0 5' dir='0 0 -1' diffuse='.8 .8 .8'"},
                      Lamp{"Narrow", "pos='0 0 .4' dir='.1 0 -1' cutoff='6' exponent='0' diffuse='.9 .9 .9'"},
                      Lamp{"Peaked", "pos='0 .1 .5' dir='0 .2 -1' cutoff='60' exponent='100' diffuse='.9 .7 .5'"},
                      Lamp{"Low", "pos='.05 .1 .02' dir='0 0 -1' cutoff='180' diffuse='.6 .6 .6' castshadow='false'"},
                      Lamp{"Weak", "pos='.1 .1 .3' dir='0 0 -1' cutoff='180' attenuation='1 2 30' diffuse='.9 .5 .5'"},
                      Lamp{"Glint",
                           "directional='true' pos='0 0 3' dir='.3 -.4 -1' specular='1 1 1' diffuse='.3 .3 .3'"},
                      Lamp{"Below", "pos='0 0 -.5' dir='0 0 1' cutoff='80' ambient='.2 .2 .2' castshadow='false'"}),
    [](const auto& given) { return given.param.name; });

// Light that grazes the floor towards the eye has a highlight as narrow as a pixel or two.
TEST(RaySmooth, GrazingLightGlints) {
  constexpr const char* kMaterial = "<material name='m' specular='1' shininess='1' rgba='.5 .5 .5 1'/>";
  const std::string light =
      "<light directional='true' castshadow='false' pos='0 0 3' dir='1 0 -.0105' specular='1 1 1' diffuse='.3 .3 .3'/>";
  Studio plane(world(light + "<geom type='plane' size='20 20 1' material='m'/>", kMaterial));
  Studio box(world(light + "<geom type='box' size='20 20 1' pos='0 0 -1' material='m'/>", kMaterial));
  render::View view = render::orbit_view({0, 0, .3}, 1, 175.13, -11.59, 30);
  view.position = {10, 0, .2};
  const Shot a = plane.shoot(view, 256, 256);
  const Shot b = box.shoot(view, 256, 256);
  int glints = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    ASSERT_LE(std::abs(a.rgb[i] - b.rgb[i]), 1) << "byte " << i;
    glints += a.rgb[i] > 200;
  }
  EXPECT_GT(glints, 0);
}

// A wall behind the sky is not seen, but tiles in which it may be take the way of those that show several things: each
// ray is cast, and each coloured by itself.
class Plain : public ::testing::TestWithParam<const char*> {
 protected:
  static constexpr const char* kAssets =
      "<texture type='skybox' builtin='gradient' mark='random' random='.1' markrgb='.6 .2 .1' width='64' height='64' "
      "rgb1='.2 .5 .9' rgb2='.9 .8 .7'/>"
      "<texture name='check' type='2d' builtin='checker' width='64' height='64' rgb1='.4 .6 .7' rgb2='.9 .8 .7'/>"
      "<material name='floor' texture='check' texrepeat='3 2' texuniform='true' specular='.3'/>";
  static constexpr const char* kWall = "<geom type='box' size='.01 30 30' pos='40 0 0'/>";
  static constexpr const char* kCellar = "<geom type='box' size='60 60 .01' pos='0 0 -29'/>";  // the floor hides it

  std::string floor() const {
    return std::string("<light ") + GetParam() + "/><geom type='plane' size='0 0 1' material='floor'/>" +
           "<geom type='sphere' size='.3' pos='0 0 .31'/><geom type='capsule' size='.1 .3' pos='.6 0 .4'/>";
  }
  static render::View to_the_wall(double elevation, double height = 0.2) {
    return render::orbit_view({0, 0, height}, 2, 0, elevation, 60);
  }
};

TEST_P(Plain, TilesEqualTheFullCalculation) {
  Studio alone(world(floor(), kAssets));
  Studio walled(world(floor() + kWall + kCellar, kAssets));
  // From above all, from the floor to its horizon, and from high up, where much of the floor is in the haze.
  const render::View views[] = {to_the_wall(-80), to_the_wall(-40), to_the_wall(-10), to_the_wall(-2),
                                to_the_wall(-25, 5)};
  int different = 0;
  for (const render::View& view : views) {
    int different_below = 0;
    for (const int pixels : {64, 400}) {
      const Shot a = alone.shoot(view, pixels, pixels);
      const Shot b = walled.shoot(view, pixels, pixels);
      ASSERT_EQ(a.rgb.size(), b.rgb.size());
      for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const int difference = std::abs(a.rgb[i] - b.rgb[i]);
        ASSERT_LE(difference, 1) << pixels << " pixels, from " << view.position.transpose() << ", byte " << i;
        different += difference > 0;
        different_below += difference > 0 && i > a.rgb.size() / 2;
      }
    }
    // The lower half is floor. The two ways round differently here and there; equal bytes would be those of one way.
    EXPECT_GT(different_below, 0) << "from " << view.position.transpose();
  }
  EXPECT_LE(different, 5 * 3 * (64 * 64 + 400 * 400) / 100);  // as 16 bits a channel round nearly alike
  RecordProperty("different", different);
}

TEST_P(Plain, ColorsDoNotDependOnOtherOutputs) {
  Studio studio(world(floor(), kAssets));
  const render::View view = to_the_wall(-40);
  const Shot all = studio.shoot(view, 200, 200);
  Shot colors(200, 200);
  studio.renderer().draw(studio.model(), studio.physics().data(), view, {200, 200, colors.rgb.data()});
  EXPECT_EQ(colors.rgb, all.rgb);
}

TEST_P(Plain, SkyIsTheSame) {
  Studio alone(world("", kAssets));
  const std::string above_and_below =
      "<geom type='box' size='40 40 .01' pos='0 0 40'/><geom type='box' size='40 40 .01' pos='0 0 -40'/>";
  Studio walled(world(kWall + above_and_below, kAssets));
  for (const double elevation : {-89.0, -20.0, 10.0, 60.0, 89.0}) {
    const Shot a = alone.shoot(to_the_wall(elevation), 300, 300);
    EXPECT_EQ(a.rgb, walled.shoot(to_the_wall(elevation), 300, 300).rgb) << elevation;
    EXPECT_GT(*std::max_element(a.rgb.begin(), a.rgb.end()), 100);
  }
}

// With fog every ray looks for its face of the sky by itself; here the fog begins far behind all that is seen.
TEST(RaySmooth, SkyOnOneFaceEqualsSingleRays) {
  constexpr const char* kSky =
      "<texture type='skybox' builtin='gradient' mark='random' random='.1' markrgb='.6 .2 .1' width='256' "
      "height='256' rgb1='.2 .5 .9' rgb2='.9 .8 .7'/>";
  constexpr const char* kBall = "<geom type='sphere' size='.3'/>";
  rays::Options foggy;
  foggy.fog = true;
  Studio clear(world(kBall, kSky));
  Studio each(world(kBall, kSky, "<map fogstart='1e6' fogend='2e6'/>"), foggy);
  for (const int pixels : {16, 64, 400}) {  // pixels of some 24, 6 and 1 texels
    for (const double elevation : {-85.0, -50.0, -5.0, 40.0}) {
      const render::View view = render::orbit_view({0.3, 0, 0}, 2, 25, elevation, 60);
      const Shot a = clear.shoot(view, pixels, pixels);
      const Shot b = each.shoot(view, pixels, pixels);
      for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        ASSERT_LE(std::abs(a.rgb[i] - b.rgb[i]), 1) << pixels << " pixels, elevation " << elevation << ", byte " << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RaySmooth, Plain,
                         ::testing::Values("pos='0 0 4' dir='.1 .1 -1' diffuse='.6 .6 .6'",
                                           "directional='true' pos='0 0 3' dir='.3 -.4 -1' diffuse='.6 .6 .6'",
                                           "pos='.3 .4 2' dir='0 0 -1' cutoff='180' diffuse='.6 .6 .6'"),
                         [](const auto& given) {
                           return std::string(given.index == 0 ? "Spot" : given.index == 1 ? "Directional" : "Around");
                         });

}  // namespace
}  // namespace mimo::test
