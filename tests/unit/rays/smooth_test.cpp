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
    for (const int pixels : {48, 200}) {
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

}  // namespace
}  // namespace mimo::test
