// Light and colour of the ray renderer, against OpenGL's formulas written out here.
#include <algorithm>

#include "base/fail.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

using Rgb = std::array<double, 3>;

const char* const kFloor = "<geom type='plane' size='2 2 1' rgba='.8 .6 .4 1' material='mat'/>";

// The middle of the floor, seen from 1 m above.
std::array<int, 3> floor_under(const std::string& light, const std::string& visual = "") {
  return Studio(world(kFloor + light, "", visual)).shoot(from_above(1)).middle();
}

Rgb scaled(double k) { return {0.8 * k, 0.6 * k, 0.4 * k}; }

TEST(RayLight, AmbientLightWithoutLights) {
  // MuJoCo's ambient light of a scene without any light.
  EXPECT_TRUE(color_near(scaled(0.3), floor_under("", "<headlight active='0'/>")));
}

TEST(RayLight, Headlight) {
  EXPECT_TRUE(color_near({0.8 * 0.6, 0.6 * 0.5, 0.4 * 0.4},
                         floor_under("", "<headlight ambient='.1 .1 .1' diffuse='.5 .4 .3'/>")));
}

TEST(RayLight, Directional) {
  const std::string light =
      "<light directional='true' dir='1 0 -1' pos='-3 0 3' diffuse='.9 .9 .9' ambient='.05 .05 .05' castshadow='{}'/>";
  const Rgb expected = scaled(0.05 + 0.9 * std::sqrt(0.5));
  EXPECT_TRUE(color_near(expected, floor_under(format(fmt::runtime(light), "false"))));
  EXPECT_TRUE(color_near(expected, floor_under(format(fmt::runtime(light), "true"))));
}

TEST(RayLight, Colored) {
  EXPECT_TRUE(color_near({0.8 * 0.5, 0.6 * 0.25, 0.4 * 1.0},
                         floor_under("<light directional='true' dir='0 0 -1' diffuse='.5 .25 1'/>")));
}

TEST(RayLight, SpotWithExponent) {
  // At 30 degrees off the axis.
  const std::string light =
      "<light pos='0 0 2' dir='.57735 0 -1' diffuse='1 1 1' cutoff='{}' exponent='{}' castshadow='{}'/>";
  const double cosine = std::cos(kPi / 6);
  for (const double exponent : {0.0, 1.0, 2.5, 10.0, 33.3}) {
    const double tolerance = exponent > 30 ? 2 : 1.2;  // large exponents are rounded
    for (const char* shadow : {"true", "false"}) {
      EXPECT_TRUE(color_near(scaled(std::pow(cosine, exponent)),
                             floor_under(format(fmt::runtime(light), 45, exponent, shadow)), tolerance))
          << exponent;
      EXPECT_TRUE(color_near({0, 0, 0}, floor_under(format(fmt::runtime(light), 29, exponent, shadow))));
    }
  }
}

TEST(RayLight, AttenuatedPoint) {
  const std::string light = "<light pos='1.5 0 2' dir='0 0 1' cutoff='180' diffuse='1 1 1' attenuation='.5 .25 .125'/>";
  const double distance = 2.5;
  EXPECT_TRUE(color_near(scaled(0.8 / (0.5 + 0.25 * distance + 0.125 * distance * distance)), floor_under(light)));
}

TEST(RayLight, Emission) {
  Studio studio(world("<geom type='plane' size='2 2 1' material='glow'/>",
                      "<material name='glow' emission='.5' rgba='.8 .6 .4 1'/>"));
  EXPECT_TRUE(color_near(scaled(0.5), studio.shoot(from_above(1)).middle()));
}

TEST(RayLight, Specular) {
  // The eye straight above, the light 20 degrees off: the half vector is 10 degrees off the normal.
  for (const double shininess : {0.03, 0.1, 0.5, 0.7, 1.0}) {
    Studio studio(
        world("<geom type='plane' size='2 2 1' material='shiny'/><light directional='true' dir='.363970 0 -1' "
              "diffuse='0 0 0' specular='.9 .9 .9'/>",
              format("<material name='shiny' specular='.7' shininess='{}' rgba='.8 .6 .4 1'/>", shininess)));
    const double glint = 0.9 * 0.7 * std::pow(std::cos(10 * kPi / 180), 128 * shininess);
    EXPECT_TRUE(color_near({glint, glint, glint}, studio.shoot(from_above(1)).middle(), 1.6)) << shininess;
  }
}

// What looks away from a light gets none of its diffuse and specular parts.
TEST(RayLight, FacingAway) {
  EXPECT_TRUE(color_near(
      scaled(0.1),
      floor_under("<light directional='true' castshadow='false' dir='0 0 1' diffuse='1 1 1' ambient='.1 .1 .1'/>")));
}

// Curved shapes: where the normal is known.
TEST(RayLight, Normals) {
  const std::string light = "<light directional='true' castshadow='false' dir='0 0 -1' diffuse='1 1 1'/>";
  const auto at = [&](const std::string& geom, int x) {
    return Studio(world(geom + light)).shoot(from_above(10, 2), 101, 101).color(x, 50)[0] / 255.0;
  };
  const double pixel = 2 * 10 * std::tan(kPi / 180) / 101;  // at the origin; the picture is nearly parallel
  const double offset = 25 * pixel;
  const double r = 0.15;
  const double slope = std::sqrt(1 - offset * offset / (r * r));
  EXPECT_NEAR(at("<geom type='sphere' size='.15' material='mat' rgba='1 1 1 1'/>", 75), slope, 0.02);
  EXPECT_NEAR(at("<geom type='capsule' size='.15 .2' euler='90 0 0' material='mat' rgba='1 1 1 1'/>", 75), slope, 0.02);
  EXPECT_NEAR(at("<geom type='cylinder' size='.15 .2' euler='90 0 0' material='mat' rgba='1 1 1 1'/>", 75), slope,
              0.02);
  EXPECT_NEAR(at("<geom type='ellipsoid' size='.15 .15 .15' material='mat' rgba='1 1 1 1'/>", 75), slope, 0.02);
  EXPECT_NEAR(at("<geom type='cylinder' size='.15 .2' material='mat' rgba='1 1 1 1'/>", 75), 1, 0.01);
  EXPECT_NEAR(at("<geom type='box' size='.2 .2 .2' euler='0 60 0' material='mat' rgba='1 1 1 1'/>", 55),
              std::sqrt(0.75), 0.01);
  EXPECT_NEAR(at("<geom type='box' size='.2 .2 .2' euler='0 60 0' material='mat' rgba='1 1 1 1'/>", 95), 0.5, 0.01);
}

class EachLight : public ::testing::TestWithParam<const char*> {};

// A ball between the light and the floor; the floor beside it, and the ball itself, are lit.
TEST_P(EachLight, CastsShadows) {
  const std::string ball = "<geom type='{}' pos='0 0 .5' size='.1 .1 .1'/>";
  const render::View view = render::orbit_view({0, 0, 0}, 1, 90, -35, 40);
  for (const char* kind : {"sphere", "capsule", "ellipsoid", "cylinder", "box"}) {
    const std::string body = kFloor + format(fmt::runtime(ball), kind);
    rays::Options plain;
    plain.shadows = false;
    Studio dark(world(body + GetParam()));
    Studio bright(world(body + GetParam()), plain);
    EXPECT_EQ(dark.shoot(view).middle_id(), 0);
    EXPECT_TRUE(color_near({0, 0, 0}, dark.shoot(view).middle())) << kind;
    EXPECT_GT(bright.shoot(view).middle()[0], 30) << kind;
    const Shot beside = dark.shoot(view, 65, 65);
    EXPECT_EQ(beside.color(2, 60), bright.shoot(view, 65, 65).color(2, 60)) << kind;
    const Shot top = dark.shoot(from_above(1));
    EXPECT_EQ(top.middle_id(), 1);
    EXPECT_GT(top.middle()[0], 30) << kind;
  }
}

INSTANTIATE_TEST_SUITE_P(
    RayLight, EachLight,
    ::testing::Values("<light directional='true' dir='0 0 -1' pos='0 0 2' diffuse='1 1 1'/>",
                      "<light dir='0 0 -1' pos='0 0 2' cutoff='60' exponent='0' diffuse='1 1 1'/>",
                      "<light dir='1 0 0' pos='0 0 2' cutoff='180' diffuse='1 1 1'/>",
                      "<light dir='0 0 -1' pos='0 0 2' cutoff='89' exponent='0' diffuse='1 1 1'/>"));

// A wall that is a plane casts a shadow; the floor never shades what stands on it.
TEST(RayLight, PlanesCastShadows) {
  const std::string light = "<light directional='true' dir='1 0 -1' pos='-3 0 3' diffuse='1 1 1'/>";
  const std::string wall = "<geom type='plane' size='.5 .5 1' pos='-.3 0 .2' euler='0 90 0'/>";
  EXPECT_TRUE(color_near({0, 0, 0}, Studio(world(kFloor + wall + light)).shoot(from_above(1)).middle()));
  const std::string ground = "<geom type='plane' size='0 0 1' pos='0 0 -.1'/>";
  EXPECT_TRUE(color_near(scaled(std::sqrt(0.5)), Studio(world(kFloor + ground + light)).shoot(from_above(1)).middle()));
}

// MuJoCo blends transparent things twice; behind a plane, its alpha is 0.3 of what it was.
TEST(RayLight, Transparency) {
  const std::string light = "<light directional='true' castshadow='false' dir='0 0 -1' diffuse='1 1 1'/>";
  Studio studio(
      world(kFloor + light + "<geom type='box' size='.2 .2 .01' pos='0 0 .3' material='mat' rgba='0 0 1 .4'/>"));
  const double cover = 1 - 0.6 * 0.6;
  EXPECT_TRUE(color_near({0.8 * (1 - cover), 0.6 * (1 - cover), 0.4 * (1 - cover) + cover},
                         studio.shoot(from_above(1)).middle(), 2));
  EXPECT_EQ(studio.shoot(from_above(1)).middle_id(), 1);

  Studio below(world(std::string("<geom type='plane' size='1 1 1' rgba='.8 .6 .4 1' material='mat'/>") + light +
                     "<geom type='box' size='1 1 .1' pos='0 0 .5' rgba='0 0 0 1'/>"));
  const double back = 1 - 0.7 * 0.7;
  EXPECT_TRUE(color_near(scaled(back), below.shoot(render::orbit_view({0, 0, 0}, 1, 90, 90, 40)).middle(), 2));
}

// A mirror adds the picture of what is above it, without sky.
TEST(RayLight, Mirrors) {
  const std::string light = "<light directional='true' castshadow='false' dir='0 0 1' diffuse='.9 .9 .9'/>";
  const std::string glass = "<material name='glass' reflectance='.5' specular='0' rgba='.2 .2 .2 1'/>";
  for (const char* mirror : {"<geom type='plane' size='1 1 1' material='glass'/>",
                             "<geom type='box' size='1 1 .1' pos='0 0 -.1' material='glass'/>"}) {
    // The lower face of the slab is lit from below and shows in the mirror beside it.
    Studio studio(world(
        mirror + light + "<geom type='box' size='.6 .1 .02' pos='0 .5 .4' rgba='1 .5 0 1' material='mat'/>", glass));
    const render::View view = render::orbit_view({0, 0, 0}, 1, 90, -39, 10);
    EXPECT_EQ(studio.shoot(view).middle_id(), 0) << mirror;
    EXPECT_TRUE(color_near({0.45, 0.225, 0}, studio.shoot(view).middle(), 2)) << mirror;
    rays::Options dull;
    dull.reflections = false;
    Studio without(
        world(mirror + light + "<geom type='box' size='.6 .1 .02' pos='0 .5 .4' rgba='1 .5 0 1' material='mat'/>",
              glass),
        dull);
    EXPECT_TRUE(color_near({0, 0, 0}, without.shoot(view).middle())) << mirror;
  }
}

TEST(RayLight, Fog) {
  rays::Options foggy;
  foggy.fog = true;
  const std::string visual = "<map znear='0.01' fogstart='1' fogend='5'/><rgba fog='.2 .4 .6 1'/>";
  const std::string body = kFloor + std::string("<light directional='true' dir='0 0 -1' diffuse='1 1 1'/>");
  for (const double height : {0.5, 2.0, 4.0}) {
    const double f = std::clamp((height - 1) / 4, 0.0, 1.0);
    Studio studio(world(body, "", visual), foggy);
    EXPECT_TRUE(color_near({0.8 * (1 - f) + 0.2 * f, 0.6 * (1 - f) + 0.4 * f, 0.4 * (1 - f) + 0.6 * f},
                           studio.shoot(from_above(height)).middle()));
  }
}

// More rays a pixel smooth edges, and leave depth and ids alone.
TEST(RayLight, Antialiasing) {
  const std::string body =
      "<light directional='true' dir='0 0 -1' diffuse='1 1 1'/><geom type='box' size='.2 .2 .2' euler='0 0 30' rgba='1 "
      "1 1 1' material='mat'/>";
  Studio plain(world(body));
  const Shot sharp = plain.shoot(from_above(2), 50, 40);
  for (const int samples : {4, 16, 64}) {
    rays::Options options;
    options.samples = samples;
    Studio studio(world(body), options);
    const Shot smooth = studio.shoot(from_above(2), 50, 40);
    EXPECT_EQ(smooth.ids, sharp.ids);
    EXPECT_EQ(smooth.depth, sharp.depth);
    int between = 0;
    double sum[2] = {0, 0};
    for (std::size_t i = 0; i < sharp.rgb.size(); i += 3) {
      between += smooth.rgb[i] > 0 && smooth.rgb[i] < 255;
      sum[0] += sharp.rgb[i];
      sum[1] += smooth.rgb[i];
    }
    EXPECT_GT(between, 30);
    EXPECT_NEAR(sum[0], sum[1], 0.03 * sum[0]);
  }
  rays::Options wrong;
  wrong.samples = 3;
  EXPECT_THROW(Studio(world(body), wrong), Error);
}

}  // namespace
}  // namespace mimo::test
