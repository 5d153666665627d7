// What is not a geom or site: spatial tendons, slider-cranks and skins, beside MuJoCo's own pictures.
#include <algorithm>
#include <cmath>

#include "compat/mujoco.h"
#include "support/scenes.h"
#include "unit/rays/agreement.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

// A wall of 5 x 9 vertices, textured, half of which follows a hinge.
std::string curtain() {
  std::string vertices;
  std::string texture;
  std::string faces;
  std::string bones[2];
  std::string weights[2];
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 9; ++column) {
      const int i = row * 9 + column;
      vertices += format("{} 0 {} ", 0.1 * column - 0.4, 0.15 * row);
      texture += format("{} {} ", column / 8.0, row / 4.0);
      const double along = column / 8.0;
      bones[0] += format("{} ", i);
      bones[1] += format("{} ", i);
      weights[0] += format("{} ", 1 - along);
      weights[1] += format("{} ", along);
      if (row == 4 || column == 8) continue;
      faces += format("{} {} {} {} {} {} ", i, i + 1, i + 10, i, i + 10, i + 9);
    }
  }
  const auto bone = [&](const char* body, const char* place, int k) {
    return format("<bone body='{}' bindpos='{}' bindquat='1 0 0 0' vertid='{}' vertweight='{}'/>", body, place,
                  bones[k], weights[k]);
  };
  return format("<skin name='curtain' material='flat' inflate='.01' vertex='{}' texcoord='{}' face='{}'>", vertices,
                texture, faces) +
         bone("fixed", "-.4 0 0", 0) + bone("moved", ".4 0 0", 1) + "</skin>";
}

std::string assets() {
  return "<texture name='check' type='2d' builtin='checker' width='64' height='64' rgb1='.2 .3 .9' rgb2='.9 .7 .5'/>"
         "<material name='flat' texture='check' texrepeat='1 1' specular='0'/>"
         "<material name='rope' rgba='.9 .5 .2 1' specular='.3' emission='.1'/>"
         "<texture name='sky' type='skybox' builtin='gradient' width='32' height='192' rgb1='.3 .5 .7' rgb2='.9 .8 "
         ".7'/>";
}

const char* const kBones =
    "<body name='fixed' pos='-.4 0 0'><geom type='sphere' size='.02'/></body>"
    "<body name='moved' pos='.4 0 0'><joint type='hinge' axis='0 1 0' name='hinge'/><joint type='hinge' axis='0 0 1' "
    "name='turn'/><geom type='sphere' size='.02'/></body>";

struct Case {
  const char* name;
  std::string assets;
  std::string body;
  std::string rest;  // tendons, actuators
  bool shadows = true;
  double motion = 0.25;  // of every other joint from picture to picture
};

class Extras : public ::testing::TestWithParam<Case> {};

engine::ModelPtr model_of(const Case& given) {
  std::string xml = world(
      "<light pos='.5 -1.4 2' dir='-.2 .5 -1' diffuse='.7 .7 .7'/><geom type='plane' size='1 1 .1' "
      "pos='0 0 -.3'/>" +
          given.body,
      assets() + given.assets, "<headlight ambient='.2 .2 .2' diffuse='.4 .4 .4'/>");
  xml.insert(xml.rfind("</mujoco>"), given.rest);
  return compile(scene::Scene(from_text(xml)));  // which MuJoCo 4 needs for composites
}

// Joints are moved: extras are those of the pose, not of the model.
void pose(Studio& studio, int step, double motion = 0.25) {
  for (int i = 0; i < studio.model().nq; ++i) {
    studio.physics().data().qpos[i] += motion * step * (i % 2 == 0 ? 1 : -0.6);
  }
  studio.physics().forward();
}

TEST_P(Extras, LookTheSame) {
  const engine::ModelPtr model = model_of(GetParam());
  render::Quality quality;
  quality.shadows = GetParam().shadows;
  const auto reference = osmesa_for(model, quality);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  Studio studio(model, rays::Options(quality));
  double difference = 0;
  int seen = 0;
  Agreement agreement;
  for (int k = 0; k < 3; ++k) {
    pose(studio, k, GetParam().motion);
    const render::View view = render::orbit_view({0, 0, 0.25}, 1.5, 70 + 20 * k, -25 + 10 * k, 45);
    Shot theirs(160, 160);
    reference->draw(*model, studio.physics().data(), view, theirs.picture());
    const Shot ours = studio.shoot(view, 160, 160);
    for (std::size_t i = 0; i < ours.rgb.size(); ++i) difference += std::abs(ours.rgb[i] - theirs.rgb[i]);
    // What is neither a geom nor nothing.
    for (std::size_t i = 0; i < ours.ids.size(); ++i) seen += ours.ids[i] == -1 && ours.depth[i] < 49;
    agreement.add(ours, theirs);
  }
  EXPECT_GT(seen, 400);  // of 76800
  EXPECT_LT(difference / (3 * 160 * 160 * 3), 2.5);
  agreement.expect(0.99, 0.99, 0.93);
}

const std::string kPosts =
    "<site name='a' pos='-.4 0 .5' size='.01'/><site name='side' pos='0 -.2 .3' size='.01'/>"
    "<body pos='.4 0 .5'><joint type='slide' axis='0 0 1'/><geom type='sphere' size='.03'/><site name='b' "
    "size='.01'/></body><geom name='post' type='cylinder' size='.1 .3' euler='90 0 0' pos='0 0 .3' rgba='.4 .8 .3 1'/>"
    "<geom name='ball' type='sphere' size='.12' pos='0 .3 .3'/><site name='c' pos='-.4 .3 .35' size='.01'/><site "
    "name='d' "
    "pos='.4 .3 .4' size='.01'/>";

INSTANTIATE_TEST_SUITE_P(
    RayExtras, Extras,
    ::testing::Values(
        Case{"Tendon", "", kPosts,
             "<tendon><spatial width='.02' rgba='.9 .2 .2 1'><site site='a'/><site site='side'/><site "
             "site='b'/></spatial></tendon>"},
        Case{"TendonOfAMaterial", "", kPosts,
             "<tendon><spatial width='.02' material='rope'><site site='a'/><site site='b'/></spatial></tendon>"},
        Case{"TendonAroundThings", "", kPosts,
             "<tendon><spatial width='.015'><site site='a'/><geom geom='post'/><site site='b'/><pulley "
             "divisor='2'/><site "
             "site='c'/><geom geom='ball'/><site site='d'/></spatial></tendon>"},
        Case{"TransparentTendon", "", kPosts,
             "<tendon><spatial width='.04' rgba='.1 .9 .2 .5'><site site='c'/><site site='d'/></spatial></tendon>"},
        Case{"HangingTendon", "", kPosts,
             "<tendon><spatial width='.015' range='0 1.2' limited='true'><site site='a'/><site "
             "site='b'/></spatial></tendon>"},
        Case{"SliderCrank", "",
             "<body name='crank' pos='-.3 0 .3'><joint type='hinge' axis='0 1 0'/><geom type='capsule' size='.03' "
             "fromto='0 0 0 0 0 .2'/><site name='pin' pos='0 0 .2' size='.01'/></body><body pos='.3 0 .3'><site "
             "name='slide' euler='0 -90 0' size='.01'/></body>",
             "<actuator><motor cranksite='pin' slidersite='slide' cranklength='.3'/></actuator>"},
        // (Of a skin with one side, MuJoCo draws a shadow only where its back is turned to the light.)
        Case{"Skin", curtain(), kBones, "", false},
        Case{"Cloth", "",
             "<body name='B3_3' pos='0 0 .3'><freejoint/><composite type='cloth' count='7 7 1' spacing='.1' "
             "flatinertia='.01'><geom type='capsule' size='.015 .01' group='4'/><skin rgba='.8 .3 .4 1' inflate='.01' "
             "subgrid='1'/></composite>"
             "</body>",
             ""}),
    [](const auto& given) { return given.param.name; });

#if MIMO_MUJOCO_4

// A soft body whose vertices move by themselves.
std::string soft(const char* dimensions, const char* count, const char* more) {
  return format(
      "<flexcomp name='soft' type='grid' dim='{}' count='{}' spacing='.08 .08 .08' mass='1' pos='0 0 .3' {} "
      "rgba='.8 .3 .4 1'><contact selfcollide='none'/></flexcomp>",
      dimensions, count, more);
}

// (Of a sheet, MuJoCo draws a shadow only where its back is turned to the light.)
INSTANTIATE_TEST_SUITE_P(RayFlexes, Extras,
                         ::testing::Values(Case{"Rope", "", soft("1", "9 1 1", "radius='.02'"), "", false, 0.004},
                                           Case{"Sheet", "", soft("2", "7 7 1", "radius='.01'"), "", false, 0.004},
                                           Case{"Block", "", soft("3", "4 4 4", "radius='.005'"), "", false, 0.004}),
                         [](const auto& given) { return given.param.name; });

#endif

Case skin() { return {"", curtain(), kBones, "", true}; }

// A picture does not depend on those before, nor on whether it is drawn with others' assets.
TEST(RayExtras, LeaveNothingInTheNextPicture) {
  const engine::ModelPtr model = model_of(skin());
  rays::Options options;
  options.assets = rays::make_assets(model);
  Studio used(model, options);
  Studio fresh(model, {});
  const render::View view = render::orbit_view({0, 0, 0.25}, 1.5, 80, -20, 45);
  for (int k = 1; k < 4; ++k) {
    pose(used, k);
    used.shoot(view, 90, 90);
  }
  std::copy_n(used.physics().data().qpos, model->nq, fresh.physics().data().qpos);
  fresh.physics().forward();
  const Shot expected = fresh.shoot(view, 90, 90);
  const Shot actual = used.shoot(view, 90, 90);
  EXPECT_EQ(actual.rgb, expected.rgb);
  EXPECT_EQ(actual.depth, expected.depth);
}

TEST(RayExtras, EveryInstructionSet) {
  Case all = skin();
  all.body += kPosts;
  all.rest =
      "<tendon><spatial width='.02' rgba='.9 .2 .2 .6'><site site='a'/><site site='side'/><site "
      "site='b'/></spatial></tendon>";
  const engine::ModelPtr model = model_of(all);
  Studio best(model, {});
  pose(best, 1);
  const render::View view = render::orbit_view({0, 0, 0.25}, 1.5, 80, -20, 45);
  const Shot expected = best.shoot(view, 150, 110);
  for (const std::string& path : rays::simd_paths()) {
    rays::Options options;
    options.simd = path;
    Studio studio(model, options);
    pose(studio, 1);
    const Shot actual = studio.shoot(view, 150, 110);
    EXPECT_EQ(actual.rgb, expected.rgb) << path;
    EXPECT_EQ(actual.depth, expected.depth) << path;
  }
}

}  // namespace
}  // namespace mimo::test
