// Shapes as the ray renderer sees them, against MuJoCo's own ray casting.
#include <algorithm>
#include <random>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

// The direction of a pixel's ray in the world; as long as its part along the camera's axis is 1.
std::array<double, 3> ray_of(const render::View& view, int width, int height, int x, int y) {
  const double step = 2 * std::tan(view.fovy * kPi / 360) / height;
  const double right = step * (x + 0.5 - 0.5 * width);
  const double up = step * (0.5 * height - y - 0.5);
  std::array<double, 3> d{};
  for (int k = 0; k < 3; ++k) {
    d[k] = right * view.rotation(k, 0) + up * view.rotation(k, 1) - view.rotation(k, 2);
  }
  return d;
}

double ray_of_mujoco(Studio& studio, const double* from, const double* along, int& geom) {
#if MIMO_MUJOCO_4
  return mj_ray(&studio.model(), &studio.physics().data(), from, along, nullptr, 1, -1, &geom, nullptr);
#else
  return mj_ray(&studio.model(), &studio.physics().data(), from, along, nullptr, 1, -1, &geom);
#endif
}

// Compares every `stride`-th pixel with mj_ray. At silhouettes the two may disagree on a pixel or two.
void expect_as_mujoco(Studio& studio, const render::View& view, const Shot& shot, int stride = 1) {
  int different = 0;
  int looked = 0;
  const double far = studio.model().vis.map.zfar * studio.model().stat.extent;
  for (int y = 0; y < shot.height; y += stride) {
    for (int x = 0; x < shot.width; x += stride) {
      const std::array<double, 3> d = ray_of(view, shot.width, shot.height, x, y);
      int id = -1;
      // mj_ray's distance is in units of the direction's length, which makes it a depth.
      double t = ray_of_mujoco(studio, view.position.data(), d.data(), id);
      if (t < 0 || t > far) {
        id = -1;
        t = far;
      }
      ++looked;
      if (id != shot.id(x, y)) {
        ++different;
      } else {
        EXPECT_NEAR(t, shot.depth[shot.at(x, y)], 1e-4 * t + 2e-5) << "pixel " << x << " " << y;
      }
    }
  }
  EXPECT_LE(different, 1 + looked / 500);
}

class EachKind : public ::testing::TestWithParam<const char*> {};

TEST_P(EachKind, FromManySides) {
  Studio studio(world(GetParam()));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  int seen = 0;
  for (int k = 0; k < 24; ++k) {
    const render::View view = render::orbit_view({0.02, 0.01, -0.02}, 0.5 + 3 * uniform(random), 360 * uniform(random),
                                                 180 * uniform(random) - 90, 10 + 50 * uniform(random));
    // mj_ray sees planes from the front only.
    const double* plane = studio.physics().data().geom_xmat;
    const double side = view.position[0] * plane[2] + view.position[1] * plane[5] + view.position[2] * plane[8];
    if (studio.model().geom_type[0] == mjGEOM_PLANE && side < 0) continue;
    const Shot shot = studio.shoot(view, 61, 47);
    expect_as_mujoco(studio, view, shot);
    seen += static_cast<int>(std::count(shot.ids.begin(), shot.ids.end(), 0));
  }
  EXPECT_GT(seen, 2000);
}

// Solids are not seen from inside; what lies outside is.
TEST_P(EachKind, NotSeenFromInside) {
  if (std::string(GetParam()).find("plane") != std::string::npos) GTEST_SKIP() << "a plane has no inside";
  Studio studio(world(std::string(GetParam()) + "<geom type='box' size='3 3 .1' pos='0 0 -2'/>"));
  const double* center = studio.physics().data().geom_xpos;
  const Shot shot = studio.shoot(render::orbit_view({center[0], center[1], center[2] - 1e-3}, 1e-3, 0, -89, 30));
  for (const int id : shot.ids) ASSERT_EQ(id, 1);
}

INSTANTIATE_TEST_SUITE_P(RaySolids, EachKind,
                         ::testing::Values("<geom type='plane' size='.6 .4 .1' euler='20 -30 10'/>",
                                           "<geom type='plane' size='0 0 .1' euler='5 3 0'/>",
                                           "<geom type='sphere' size='.2' pos='.05 0 0'/>",
                                           "<geom type='capsule' size='.1 .25' euler='30 40 50'/>",
                                           "<geom type='ellipsoid' size='.1 .2 .3' euler='50 20 70'/>",
                                           "<geom type='cylinder' size='.15 .2' euler='-30 60 20'/>",
                                           "<geom type='cylinder' size='.3 .01' euler='80 10 0'/>",
                                           "<geom type='box' size='.1 .2 .3' euler='15 25 35'/>"));

// Everything at once, overlapping; also cameras that touch or nearly touch solids.
TEST(RaySolids, Crowd) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::string body = "<geom type='plane' size='0 0 1' pos='0 0 -.7'/>";
  const char* kinds[] = {"sphere", "capsule", "ellipsoid", "cylinder", "box"};
  for (int k = 0; k < 60; ++k) {
    body += format("<geom type='{}' size='{} {} {}' pos='{} {} {}' euler='{} {} {}'/>", kinds[k % 5],
                   0.05 + 0.1 * std::abs(uniform(random)), 0.02 + 0.2 * std::abs(uniform(random)),
                   0.02 + 0.1 * std::abs(uniform(random)), uniform(random), uniform(random), 0.5 * uniform(random),
                   180 * uniform(random), 180 * uniform(random), 180 * uniform(random));
  }
  Studio studio(world(body));
  for (int k = 0; k < 12; ++k) {
    const render::View view = render::orbit_view({0, 0, 0}, 2.5, 30 * k, -10 - 5 * k, 45);
    expect_as_mujoco(studio, view, studio.shoot(view, 80, 60));
  }
}

// The eye lies on the eyeball's surface, and must not see it.
TEST(RaySolids, CameraOnTheSurface) {
  for (const char* kind : {"type='sphere' size='.1'", "type='box' size='.1 .1 .1'", "type='cylinder' size='.1 .1'",
                           "type='ellipsoid' size='.1 .2 .2'", "type='capsule' size='.1 .1'"}) {
    Studio studio(world(format("<geom {}/><geom type='box' size='.1 3 3' pos='2 0 0'/>", kind)));
    const Shot shot = studio.shoot(render::orbit_view({0.2, 0, 0}, 0.1, 0, 0, 60));
    for (const int id : shot.ids) ASSERT_EQ(id, 1) << kind;
  }
}

TEST(RaySolids, NearAndFarPlane) {
  // The near plane cuts a hole into the sphere through which its inside is not seen either.
  Studio studio(world("<geom type='sphere' size='.1'/><geom type='box' size='1 1 .1' pos='0 0 -1'/>"));
  const auto middle = [&](double gap) { return studio.shoot(from_above(0.1 + gap, 60)).middle_id(); };
  EXPECT_EQ(middle(0.011), 0);
  EXPECT_EQ(middle(0.009), 1);
  const Shot cut = studio.shoot(from_above(0.1 + 0.009, 120));
  EXPECT_EQ(cut.middle_id(), 1);
  EXPECT_EQ(cut.id(1, 1), 0);

  Studio distant(world("<geom type='box' size='9 9 .1' pos='0 0 -.1'/>"));
  const Shot seen = distant.shoot(from_above(49.9));
  EXPECT_EQ(seen.middle_id(), 0);
  EXPECT_NEAR(seen.depth[seen.at(16, 16)], 49.9, 1e-3);
  const Shot beyond = distant.shoot(from_above(50.1));
  EXPECT_EQ(beyond.middle_id(), -1);
  EXPECT_EQ(beyond.depth[beyond.at(16, 16)], 50.0F);
}

// Any size; nothing is written outside of the picture.
TEST(RaySolids, Sizes) {
  Studio studio(world("<geom type='plane' size='0 0 1'/><geom type='sphere' size='.2' pos='0 0 .1'/>"));
  const render::View view = render::orbit_view({0, 0, 0.1}, 1, 30, -30, 50);
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 512}, {512, 1}, {3, 5}, {16, 16}, {17, 33}, {2048, 2048}}) {
    const std::size_t count = static_cast<std::size_t>(width) * height;
    Shot shot(width, height);
    shot.rgb.resize(3 * count + 64, 77);
    shot.depth.resize(count + 16, -7);
    shot.ids.resize(count + 16, -7);
    studio.renderer().draw(studio.model(), studio.physics().data(), view, shot.picture());
    for (std::size_t i = 0; i < 64; ++i) ASSERT_EQ(shot.rgb[3 * count + i], 77) << width << " " << height;
    for (std::size_t i = 0; i < 16; ++i) ASSERT_EQ(shot.depth[count + i], -7) << width << " " << height;
    for (std::size_t i = 0; i < 16; ++i) ASSERT_EQ(shot.ids[count + i], -7) << width << " " << height;
    expect_as_mujoco(studio, view, shot, std::max(1, width / 64));
  }
}

TEST(RaySolids, RefuseInvalidPictureSizes) {
  Studio studio(world("<geom size='.1'/>"));
  EXPECT_THROW(studio.renderer().draw(studio.model(), studio.physics().data(), from_above(1), {0, 5}), Error);
}

// Groups 0 to 2 show, and nothing whose alpha is 0; sites show, without an id.
TEST(RaySolids, ShowGroups0To2) {
  const auto id_of = [](const std::string& body) { return Studio(world(body)).shoot(from_above(1)).middle_id(); };
  EXPECT_EQ(id_of("<geom size='.1' group='2'/>"), 0);
  EXPECT_EQ(id_of("<geom size='.1' group='3'/>"), -1);
  EXPECT_EQ(id_of("<geom size='.1' rgba='1 1 1 0'/>"), -1);
  EXPECT_EQ(id_of("<geom size='.1' rgba='1 1 1 .2'/>"), 0);
  const char* site =
      "<light pos='0 0 2' diffuse='1 1 1'/><geom size='.05'/><site size='.1' group='{}' rgba='1 0 0 1'/>";
  Studio shown(world(format(fmt::runtime(site), 2)));
  EXPECT_EQ(shown.shoot(from_above(1)).middle_id(), -1);
  EXPECT_GT(shown.shoot(from_above(1)).middle()[0], 100);
  EXPECT_EQ(id_of(format(fmt::runtime(site), 3)), 0);
}

}  // namespace
}  // namespace mimo::test
