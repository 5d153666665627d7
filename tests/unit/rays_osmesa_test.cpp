// The ray renderer beside MuJoCo's own pictures.
#include <algorithm>
#include <random>

#include "compat/mujoco.h"
#include "support/scenes.h"
#include "unit/rays/agreement.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

// Both eyes in 50 states along a random motion.
TEST(RayOsmesa, TheInfantsEyes) {
  const engine::ModelPtr model = room_with_infant("benchmark");
  const_cast<mjModel&>(*model).vis.quality.offsamples = 0;
  const auto reference = osmesa_for(model);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  const auto ray = rays::make_renderer(model, {});
  engine::Physics physics(model, {});
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  Agreement agreement;
  Shot ours(256, 256), theirs(256, 256);  // the default size
  for (int k = 0; k < 50; ++k) {
    for (int step = 0; step < 30; ++step) {
      for (int i = 0; i < model->nu; ++i) {
        const double* range = model->actuator_forcerange + 2 * i;
        physics.data().ctrl[i] = range[0] + (range[1] - range[0]) * uniform(random);
      }
      physics.step(1);
    }
    for (const char* eye : {"eye_left", "eye_right"}) {
      const render::View view =
          render::camera_view(*model, physics.data(), engine::find_or_fail(*model, engine::Kind::kCamera, eye));
      ray->draw(*model, physics.data(), view, ours.picture());
      reference->draw(*model, physics.data(), view, theirs.picture());
      agreement.add(ours, theirs);
    }
  }
  agreement.expect(0.995, 0.995, 0.93);
}

// From outside, where silhouettes and shadows are many; OSMesa's solids are polygons.
TEST(RayOsmesa, TheInfantFromOutside) {
  const engine::ModelPtr model = room_with_infant("benchmark");
  const_cast<mjModel&>(*model).vis.quality.offsamples = 0;
  const auto reference = osmesa_for(model);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  Studio studio(model, {});
  Agreement agreement;
  for (int azimuth = 0; azimuth < 360; azimuth += 45) {
    const render::View view = render::orbit_view({0.1, 0, 0.4}, 1.6, azimuth, -20, 45);
    Shot theirs(192, 192);
    reference->draw(*model, studio.physics().data(), view, theirs.picture());
    agreement.add(studio.shoot(view, 192, 192), theirs);
  }
  agreement.expect(0.99, 0.97, 0.95);
}

#if MIMO_MUJOCO_4

class Lenses : public ::testing::TestWithParam<const char*> {};

// Cameras that are no pinhole before the middle of square pixels.
TEST_P(Lenses, LookTheSame) {
  const engine::ModelPtr model = engine::compile(
      world(std::string("<light pos='0 0 3' dir='.2 .1 -1'/><light pos='1 -1 3' dir='-.3 .3 -1' type='directional'/>"
                        "<geom type='plane' size='3 3 .1' material='tiles'/>"
                        "<geom type='box' pos='.3 .1 .5' size='.2 .2 .25' material='shiny'/>"
                        "<geom type='sphere' pos='-.5 .1 .5' size='.3' rgba='.8 .2 .1 1'/>"
                        "<geom type='capsule' pos='-.5 .8 .5' size='.1 .3' euler='30 40 0' rgba='.2 .8 .1 .5'/>"
                        "<geom type='cylinder' pos='.5 .8 .5' size='.1 .3' euler='30 40 0'/>"
                        "<geom type='ellipsoid' pos='.5 -.7 .4' size='.1 .3 .2' material='shiny'/>"
                        "<geom type='mesh' mesh='ball' pos='-.4 -.6 .6'/><camera pos='-1 -3 2' "
                        "xyaxes='1 -.3 0 .15 .5 1' ") +
                GetParam() + "/>",
            "<texture name='sky' type='skybox' builtin='gradient' rgb1='.5 .7 .9' rgb2='.2 .3 .4' width='64' "
            "height='64'/><texture name='tiles' type='2d' builtin='checker' rgb1='.2 .3 .4' rgb2='.6 .5 .2' width='64' "
            "height='64'/><material name='tiles' texture='tiles' texrepeat='5 5' texuniform='true' "
            "reflectance='.3'/><material name='shiny' rgba='.3 .3 .9 1' specular='1' shininess='.3'/>"
            "<mesh name='ball' builtin='sphere' params='3' scale='.3 .2 .25'/>",
            "<headlight ambient='.2 .2 .2' diffuse='.3 .3 .3' specular='.2 .2 .2'/>"),
      {}, {});
  const auto reference = osmesa_for(model);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  Studio studio(model, {});
  const render::View view = render::camera_view(*model, studio.physics().data(), 0);
  Shot theirs(192, 160);
  reference->draw(*model, studio.physics().data(), view, theirs.picture());
  Agreement agreement;
  agreement.add(studio.shoot(view, 192, 160), theirs);
  agreement.expect(0.99, 0.97, 0.93);
}

INSTANTIATE_TEST_SUITE_P(RayOsmesa, Lenses,
                         ::testing::Values("resolution='192 160' sensorsize='.024 .02' focal='.02 .02' "
                                           "principal='.004 .002'",
                                           "resolution='192 160' sensorsize='.024 .02' focal='.01 .02'",
                                           "projection='orthographic' fovy='2.5'"));

#endif

struct Switch {
  const char* name;
  bool render::Quality::*on;
  bool value;
};

class Switches : public ::testing::TestWithParam<Switch> {};

// Each switch changes the picture, and in the same way in both renderers.
TEST_P(Switches, LooksTheSame) {
  const engine::ModelPtr model = engine::compile(
      "<mujoco><statistic extent='2'/><visual><map znear='0.005' fogstart='0.5' fogend='3'/><rgba fog='.9 .6 .3 1' "
      "haze='1 .8 .8 1'/>"
      "<quality offsamples='0'/></visual><asset>"
      "<texture type='skybox' builtin='gradient' width='64' height='384' rgb1='.3 .5 .7' rgb2='.9 .8 .7'/>"
      "<material name='floor' reflectance='.4' rgba='.4 .5 .4 1'/></asset><worldbody>"
      "<light pos='1 0 3' dir='-.3 0 -1' diffuse='.8 .8 .8'/><geom type='plane' size='0 0 1' material='floor'/>"
      "<geom type='box' size='.2 .2 .3' pos='0 0 .4' rgba='.9 .3 .2 1'/></worldbody></mujoco>",
      {}, {});
  render::Quality quality;
  quality.*GetParam().on = GetParam().value;
  const auto reference = osmesa_for(model, quality);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  const auto plain = opengl::make_renderer(model, {}, {}, opengl::osmesa());
  Studio studio(model, rays::Options(quality));
  const render::View view = render::orbit_view({0, 0, 0.3}, 2, 60, -15, 60);
  Shot theirs(160, 160), before(160, 160);
  reference->draw(*model, studio.physics().data(), view, theirs.picture());
  plain->draw(*model, studio.physics().data(), view, before.picture());
  const Shot ours = studio.shoot(view, 160, 160);
  Agreement agreement;
  agreement.add(ours, theirs);
  agreement.expect(0.99, 0.99, 0.95);
  double difference = 0;
  for (std::size_t i = 0; i < theirs.rgb.size(); ++i) difference += std::abs(ours.rgb[i] - theirs.rgb[i]);
  EXPECT_LT(difference / static_cast<double>(theirs.rgb.size()), 4);  // the floor's light is that of its corners there
  int changed = 0;
  for (std::size_t i = 0; i < theirs.rgb.size(); ++i) changed += std::abs(theirs.rgb[i] - before.rgb[i]) > 4;
  EXPECT_GT(changed, 300);
}

INSTANTIATE_TEST_SUITE_P(RayOsmesa, Switches,
                         ::testing::Values(Switch{"shadows", &render::Quality::shadows, false},
                                           Switch{"reflections", &render::Quality::reflections, false},
                                           Switch{"skybox", &render::Quality::skybox, false},
                                           Switch{"haze", &render::Quality::haze, false},
                                           Switch{"fog", &render::Quality::fog, true}),
                         [](const auto& given) { return given.param.name; });

// Fog hides what mirrors show, what is seen through glass, and the haze at the horizon.
TEST(RayOsmesa, FogBeforeMirrorsGlassAndHaze) {
  const engine::ModelPtr model = engine::compile(
      "<mujoco><statistic extent='1'/><visual><map znear='.01' fogstart='0' fogend='6'/><rgba fog='.9 .6 .3 1' "
      "haze='.2 .3 1 1'/><headlight ambient='.4 .4 .4' diffuse='.3 .3 .3' specular='0 0 0'/><quality offsamples='0'/>"
      "</visual><asset><texture type='skybox' builtin='gradient' width='64' height='384' rgb1='0 0 0' rgb2='0 0 0'/>"
      "<material name='floor' reflectance='.9' specular='0' rgba='.1 .1 .1 1'/></asset><worldbody>"
      "<geom type='plane' size='0 0 1' material='floor'/>"
      "<geom type='box' size='.1 .6 .6' pos='-1.5 0 .8' rgba='.1 .8 .2 1'/>"
      "<geom type='box' size='.01 .5 .5' pos='.3 -.6 .8' rgba='.2 .2 .9 .6'/></worldbody></mujoco>",
      {}, {});
  render::Quality quality;
  quality.fog = true;
  const auto reference = osmesa_for(model, quality);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  Studio studio(model, rays::Options(quality));
  const render::View view = render::orbit_view({-1.5, 0, 0.3}, 3.5, 180, -12, 45);
  Shot theirs(160, 160);
  reference->draw(*model, studio.physics().data(), view, theirs.picture());
  const Shot ours = studio.shoot(view, 160, 160);
  int different = 0;
  for (std::size_t i = 0; i < theirs.rgb.size(); ++i) different += std::abs(ours.rgb[i] - theirs.rgb[i]) > 6;
  EXPECT_LT(different, 0.01 * static_cast<double>(theirs.rgb.size()));
}

struct Heap {
  const char* name;
  const char* shapes;
  double least;  // of the pixels that both show alike; OpenGL rounds depths in planes that are cut differently
};

class InOnePlace : public ::testing::TestWithParam<Heap> {};

// Of shapes in one place, OpenGL shows the one that is drawn last.
TEST_P(InOnePlace, TheLastOneShows) {
  const engine::ModelPtr model = engine::compile(world(GetParam().shapes), {}, {});
  const auto reference = osmesa_for(model);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  Studio studio(model, {});
  const render::View view = render::orbit_view({0, 0, 0}, 2.5, 80, -50, 45);
  Shot theirs(160, 160);
  reference->draw(*model, studio.physics().data(), view, theirs.picture());
  const Shot ours = studio.shoot(view, 160, 160);
  int same = 0, last = 0;
  const int number = static_cast<int>(model->ngeom) - 1;
  for (std::size_t i = 0; i < ours.ids.size(); ++i) {
    same += ours.ids[i] == theirs.ids[i];
    last += ours.ids[i] == number;
  }
  EXPECT_GE(same, GetParam().least * static_cast<double>(ours.ids.size()));
  EXPECT_GT(last, 500);
}

INSTANTIATE_TEST_SUITE_P(
    RayOsmesa, InOnePlace,
    ::testing::Values(
        Heap{"capsules", "<geom type='capsule' size='.2 .4'/><geom type='capsule' size='.2 .4'/>", 0.99},
        Heap{"spheres", "<geom size='.4'/><geom size='.4'/><geom type='ellipsoid' size='.4 .4 .4'/>", 0.99},
        Heap{"boxes", "<geom type='box' size='.3 .2 .1'/><geom type='box' size='.3 .2 .1'/>", 0.99},
        Heap{"cylinders", "<geom type='cylinder' size='.3 .2'/><geom type='cylinder' size='.3 .2'/>", 0.99},
        Heap{"a mat on a floor", "<geom type='plane' size='1 1 .1'/><geom type='plane' size='.4 .4 .1'/>", 0.95},
        Heap{"a mat on an endless floor", "<geom type='plane' size='0 0 .1'/><geom type='plane' size='.4 .4 .1'/>",
             0.9}),
    [](const auto& given) {
      std::string name = given.param.name;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

#if MIMO_MUJOCO_4
// Flat textures are decoded before light falls on them, cubes are not.
TEST(RayOsmesa, ColoursInSrgb) {
  const engine::ModelPtr model = engine::compile(
      world("<geom type='plane' size='1 1 .1' material='flat'/><geom type='box' size='.3 .2 .1' pos='0 0 .1' "
            "material='cube'/>",
            "<texture name='flat' type='2d' builtin='flat' colorspace='sRGB' width='8' height='8' rgb1='.74 .5 .3'/>"
            "<texture name='cube' type='cube' builtin='flat' colorspace='sRGB' width='8' height='8' rgb1='.74 .5 .3'/>"
            "<material name='flat' texture='flat' specular='0'/><material name='cube' texture='cube' specular='0'/>",
            "<headlight ambient='.5 .5 .5' diffuse='.5 .5 .5'/>"),
      {}, {});
  const auto reference = osmesa_for(model);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  Studio studio(model, {});
  const render::View view = render::orbit_view({0, 0, 0}, 2.5, 80, -50, 45);
  Shot theirs(160, 160);
  reference->draw(*model, studio.physics().data(), view, theirs.picture());
  const Shot ours = studio.shoot(view, 160, 160);
  double difference = 0;
  for (std::size_t i = 0; i < ours.rgb.size(); ++i) difference += std::abs(ours.rgb[i] - theirs.rgb[i]);
  EXPECT_LT(difference / static_cast<double>(ours.rgb.size()), 1);
}
#endif

// MuJoCo 4 lays textures of texrepeat and texuniform otherwise on these; rays lay them as 2.2 does.
bool is_laid_otherwise(const std::string& body) {
  if (!MIMO_MUJOCO_4) return false;
  const auto says = [&](const char* word) { return body.find(word) != std::string::npos; };
  return (says("'flat'") && (says("'plane'") || says("'box'") || says("'capsule'"))) ||
         (says("'uniform'") && says("'sphere'"));
}

class Feature : public ::testing::TestWithParam<const char*> {};

// One feature at a time, as MuJoCo draws it.
TEST_P(Feature, LooksTheSame) {
  if (is_laid_otherwise(GetParam())) GTEST_SKIP() << "MuJoCo 4 lays this texture otherwise, rays as 2.2 does";
  const engine::ModelPtr model = engine::compile(
      world(std::string("<light pos='0 0 3' dir='0 0 -1' castshadow='false' specular='0 0 0'/>") + GetParam(),
            "<texture name='check' type='2d' builtin='checker' width='64' height='64' rgb1='.1 .3 .5' rgb2='.9 .8 .7'/>"
            "<texture name='cube' type='cube' builtin='checker' mark='edge' markrgb='1 0 0' width='64' height='64' "
            "rgb1='.1 .3 .5' rgb2='.9 .8 .7'/>"
            "<material name='flat' texture='check' texrepeat='3 2' specular='0'/>"
            "<material name='uniform' texture='check' texrepeat='3 2' texuniform='true' specular='0'/>"
            "<material name='cube' texture='cube' specular='0'/>"
            "<material name='cubeuniform' texture='cube' texuniform='true' specular='0'/>"
            "<material name='mirror' reflectance='.5' specular='0' rgba='.3 .3 .3 1'/>",
            "<headlight ambient='.3 .3 .3' diffuse='.3 .3 .3'/>"),
      {}, {});
  const auto reference = osmesa_for(model);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  Studio studio(model, {});
  double difference = 0;
  Agreement agreement;
  for (const int azimuth : {20, 140, 260}) {
    const render::View view = render::orbit_view({0, 0, 0.1}, 1.2, azimuth, -35, 45);
    Shot theirs(160, 160);
    reference->draw(*model, studio.physics().data(), view, theirs.picture());
    const Shot ours = studio.shoot(view, 160, 160);
    for (std::size_t i = 0; i < ours.rgb.size(); ++i) difference += std::abs(ours.rgb[i] - theirs.rgb[i]);
    agreement.add(ours, theirs);
  }
  EXPECT_LT(difference / (3 * 160 * 160 * 3), 2.5);
  agreement.expect(0.99, 0.75, 0.93);  // a large ball of OSMesa's is up to 2 mm flatter
}

INSTANTIATE_TEST_SUITE_P(
    RayOsmesa, Feature,
    ::testing::Values(
        "<geom type='plane' size='.5 .4 .1' material='flat'/>", "<geom type='plane' size='0 0 .1' material='uniform'/>",
        "<geom type='box' size='.3 .2 .1' material='flat'/>", "<geom type='box' size='.3 .2 .1' material='cube'/>",
        "<geom type='box' size='.3 .2 .1' material='cubeuniform'/>", "<geom type='sphere' size='.3' material='cube'/>",
        "<geom type='sphere' size='.3' material='uniform'/>",
        "<geom type='capsule' size='.15 .2' euler='30 60 0' material='cube'/>",
        "<geom type='capsule' size='.15 .2' euler='30 60 0' material='cubeuniform'/>",
        "<geom type='capsule' size='.15 .2' euler='30 60 0' material='flat'/>",
        "<geom type='cylinder' size='.2 .2' euler='30 60 0' material='cubeuniform'/>",
        "<geom type='ellipsoid' size='.1 .2 .3' euler='30 60 0' material='cube'/>",
        "<geom type='plane' size='1 1 .1' material='mirror'/><geom type='capsule' size='.1 .2' pos='0 0 .4' rgba='1 .5 "
        "0 1'/>",
        "<geom type='plane' size='1 1 .1' rgba='.9 .9 .9 1'/><geom type='box' size='.2 .2 .2' pos='0 0 .3' rgba='1 0 0 "
        ".3'/>"
        "<geom type='sphere' size='.2' pos='.3 0 .3' rgba='0 0 1 .6'/>"));

}  // namespace
}  // namespace mimo::test
