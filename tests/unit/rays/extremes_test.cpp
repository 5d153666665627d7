// Pictures of nonsense: whatever a model or a simulation that has come to grief holds, nothing is read or written
// outside of what belongs to the picture, and every picture comes to an end. Most of this shows only where addresses
// are watched (the preset asan, whose kernels are watched as well).
#include <cmath>
#include <limits>
#include <random>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

// A grid of triangles, n x n x 2 of them, and with texture coordinates.
std::string sheet(const char* name, int n, double size) {
  std::string vertices;
  std::string texture;
  std::string faces;
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column <= n; ++column) {
      // Not flat: else it has no volume.
      vertices += format("{} {} {} ", size * column / n, size * row / n, 0.1 * size * ((row + column) % 2));
      texture += format("{} {} ", static_cast<double>(column) / n, static_cast<double>(row) / n);
      if (row == n || column == n) continue;
      const int i = row * (n + 1) + column;
      faces += format("{} {} {} {} {} {} ", i, i + 1, i + n + 2, i, i + n + 2, i + n + 1);
    }
  }
  return format("<mesh name='{}' vertex='{}' texcoord='{}' face='{}'/>", name, vertices, texture, faces);
}

std::string assets() {
  return sheet("large", 60, 1.2) + sheet("small", 1, 0.3) +
         "<texture name='sky' type='skybox' builtin='gradient' width='8' height='48' rgb1='.3 .5 .7' rgb2='.9 .8 .7'/>"
         "<texture name='check' type='2d' builtin='checker' width='17' height='5' rgb1='.2 .3 .9' rgb2='.9 .7 .5'/>"
         "<texture name='dot' type='2d' builtin='flat' width='1' height='1' rgb1='.2 .3 .9'/>"
         "<texture name='cube' type='cube' builtin='gradient' width='9' height='54' rgb1='1 .3 .4' rgb2='.2 .7 .6'/>"
         "<texture name='die' type='cube' builtin='flat' width='1' height='1' rgb1='1 .3 .4'/>"
         "<material name='check' texture='check' texrepeat='3 3'/><material name='dot' texture='dot'/>"
         "<material name='cube' texture='cube'/><material name='die' texture='die' texuniform='true'/>"
         "<material name='floor' texture='check' texuniform='true' texrepeat='2 2' reflectance='.3'/>"
         "<hfield name='hills' nrow='5' ncol='7' size='.5 .4 .2 .1'/>";
}

std::string scene() {
  return world(
      "<light pos='.3 .2 3' dir='.1 .1 -1'/><light directional='true' pos='1 1 3' dir='-1 -.5 -1'/>"
      "<light pos='-1 1 .8' dir='0 0 -1' cutoff='170' attenuation='1 0 1'/>"
      "<geom type='plane' size='0 0 1' material='floor' pos='0 0 -.5'/><geom type='plane' size='.4 .3 .1' pos='0 1 0'/>"
      "<geom type='mesh' mesh='large' material='check' pos='-.3 -.3 0'/>"
      "<geom type='mesh' mesh='small' material='check' pos='0 0 .2'/>"
      "<geom type='mesh' mesh='small' rgba='.4 .9 .3 .5' pos='.2 .1 .3'/>"
      "<geom type='hfield' hfield='hills' pos='.4 .4 0'/>"
      "<body name='free' pos='0 0 .6'><freejoint/><geom type='sphere' size='.1' material='dot'/>"
      "<geom type='box' size='.1 .05 .1' pos='.3 0 0' material='die'/><site name='b' pos='0 0 .1'/></body>"
      "<geom type='capsule' size='.05 .1' pos='-.4 .4 .2' material='cube'/>"
      "<geom type='ellipsoid' size='.1 .2 .05' pos='.4 -.4 .2' material='check'/>"
      "<geom type='cylinder' size='.1 .1' pos='-.4 -.4 .2' rgba='.4 .4 .9 .6'/><site name='a' pos='-.3 0 .5' "
      "size='.02'/>"
      "<body name='moved' pos='.5 0 .4'><joint type='hinge'/><geom type='sphere' size='.03'/></body>",
      assets() +
          "<skin name='skin' material='check' vertex='.5 0 .4 .8 0 .4 .5 .3 .4' texcoord='0 0 1 0 0 1' face='0 1 "
          "2'><bone "
          "body='moved' bindpos='0 0 0' bindquat='1 0 0 0' vertid='0 1 2' vertweight='1 1 1'/><bone body='free' "
          "bindpos='0 0 "
          "0' bindquat='1 0 0 0' vertid='2' vertweight='1'/></skin>",
      "<headlight ambient='.2 .2 .2' diffuse='.4 .4 .4'/>");
}

std::string with_tendon(std::string xml) {
  return xml.insert(xml.rfind("</mujoco>"),
                    "<tendon><spatial width='.02'><site site='a'/><site site='b'/></spatial></tendon>");
}

// A picture with room around its parts, in which nothing may be written.
struct Guarded {
  static constexpr int kWidth = 21;
  static constexpr int kHeight = 18;
  static constexpr std::size_t kPixels = static_cast<std::size_t>(kWidth) * kHeight;
  static constexpr std::size_t kRoom = 64;

  std::vector<std::uint8_t> rgb = std::vector<std::uint8_t>(3 * kPixels + 2 * kRoom, 0xA5);
  std::vector<float> depth = std::vector<float>(kPixels + 2 * kRoom, -123);
  std::vector<std::int32_t> ids = std::vector<std::int32_t>(kPixels + 2 * kRoom, -123);

  render::Picture picture() { return {kWidth, kHeight, rgb.data() + kRoom, depth.data() + kRoom, ids.data() + kRoom}; }
  void expect_whole(int geoms) const {
    for (std::size_t i = 0; i < kRoom; ++i) {
      ASSERT_EQ(rgb[i], 0xA5);
      ASSERT_EQ(rgb[3 * kPixels + kRoom + i], 0xA5);
      ASSERT_EQ(depth[i], -123);
      ASSERT_EQ(depth[kPixels + kRoom + i], -123);
      ASSERT_EQ(ids[i], -123);
      ASSERT_EQ(ids[kPixels + kRoom + i], -123);
    }
    for (std::size_t i = kRoom; i < kRoom + kPixels; ++i) ASSERT_TRUE(ids[i] >= -1 && ids[i] < geoms) << ids[i];
  }
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kOdd[] = {0,    -1,    1e-320, 1e-30, 1e-9, 1,     -1e9,  1e10,      1e18, -1e19,
                           1e30, -1e30, 1e37,   3e38,  1e60, 1e100, 1e300, kInfinity, kNan};

// The same strange scene with everything that a picture is made of at one's disposal.
class Strange {
 public:
  explicit Strange(int samples) : studio_(a_copy(), options(samples)) {
    view = render::orbit_view({0, 0, 0.1}, 1.6, 70, -40, 60);
  }

  mjModel& model() { return studio_.change(); }
  mjData& data() { return studio_.physics().data(); }
  void draw() {
    Guarded guarded;
    try {
      studio_.renderer().draw(model(), data(), view, guarded.picture());
    } catch (const Error& error) {  // MuJoCo 4 lays out nothing that begins too near
      if (!MIMO_MUJOCO_4 || error.message().find("frustum_near too small") == std::string::npos) throw;
      return;
    }
    guarded.expect_whole(model().ngeom);
  }

  render::View view;

 private:
  static engine::ModelPtr a_copy() {
    static const engine::ModelPtr original = engine::compile(with_tendon(scene()), {}, {});
    return {mj_copyModel(nullptr, original.get()), mj_deleteModel};
  }
  static rays::Options options(int samples) {
    rays::Options options;
    options.samples = samples;
    options.fog = true;
    return options;
  }

  Studio studio_;
};

// Lanes of a tile that belong to a larger mesh have numbers of triangles that the smaller does not have.
TEST(RayExtremes, ASmallMeshBeforeALargeOne) {
  Studio studio(world("<geom type='mesh' mesh='small' material='check' pos='0 0 .2'/><geom type='mesh' mesh='large' "
                      "material='check' pos='-.5 -.5 0'/>",
                      assets(), "<headlight ambient='.2 .2 .2' diffuse='.4 .4 .4'/>"),
                {});
  int seen[2] = {0, 0};
  for (int azimuth = 0; azimuth < 360; azimuth += 30) {
    const Shot shot = studio.shoot(render::orbit_view({0.1, 0.1, 0.1}, 1, azimuth, -60, 60));
    for (const int id : shot.ids) seen[0] += id == 0, seen[1] += id == 1;
  }
  EXPECT_GT(seen[0], 500);  // of 13068
  EXPECT_GT(seen[1], 5000);
}

TEST(RayExtremes, FarPlane) {
  Strange strange(1);
  for (const double extent : {1.0, 3e38, 1e300}) {
    for (const float far : {1e10F, 1e30F, 1e37F, 3e38F}) {
      strange.model().vis.map.zfar = far;
      strange.model().stat.extent = extent;
      strange.draw();
    }
  }
}

TEST(RayExtremes, Sizes) {
  for (const double odd : kOdd) {
    Strange strange(1);
    for (int i = 0; i < strange.model().ngeom; ++i) {
      for (int k = 0; k < 3; ++k) strange.model().geom_size[3 * i + k] = odd;
    }
    strange.draw();
  }
}

TEST(RayExtremes, Cameras) {
  Strange strange(1);
  const render::View usual = strange.view;
  for (const double odd : kOdd) {
    for (int k = 0; k < 3; ++k) {
      strange.view = usual;
      strange.view.position[k] = odd;
      strange.draw();
    }
    for (int k = 0; k < 9; k += 4) {
      strange.view = usual;
      strange.view.rotation.data()[k] = odd;
      strange.draw();
    }
    strange.view = usual;
    strange.view.fovy = odd;
    strange.draw();
  }
  for (const double fovy : {90.0, 179.9, 180.0, 181.0, 360.0, -60.0}) {
    strange.view.fovy = fovy;
    strange.draw();
  }
}

// All numbers that a picture is made of, some of them odd, in 200 combinations.
TEST(RayExtremes, RandomScenesDoNotCrash) {
  std::mt19937 random(17);
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto odd = [&] { return kOdd[below(static_cast<int>(std::size(kOdd)))]; };
  for (int round = 0; round < 200; ++round) {
    Strange strange(round % 8 == 0 ? 4 : 1);
    mjModel& m = strange.model();
    mjData& d = strange.data();
    struct Numbers {
      double* of;
      long long count;
    };
    const Numbers doubles[] = {{m.geom_size, 3 * m.ngeom},
                               {m.site_size, 3 * m.nsite},
                               {d.geom_xpos, 3 * m.ngeom},
                               {d.geom_xmat, 9 * m.ngeom},
                               {d.site_xpos, 3 * m.nsite},
                               {d.xpos, 3 * m.nbody},
                               {d.xquat, 4 * m.nbody},
                               {d.light_xpos, 3 * m.nlight},
                               {d.light_xdir, 3 * m.nlight},
                               {d.wrap_xpos, 3 * 2},
                               {m.tendon_width, m.ntendon},
                               {&m.stat.extent, 1},
                               {strange.view.position.data(), 3},
                               {strange.view.rotation.data(), 9},
                               {&strange.view.fovy, 1}};
    struct Floats {
      float* of;
      long long count;
    };
    const Floats floats[] = {{m.mat_texrepeat, 2 * m.nmat},
                             {m.mat_shininess, m.nmat},
                             {m.mat_emission, m.nmat},
                             {m.mat_specular, m.nmat},
                             {m.mat_reflectance, m.nmat},
                             {m.mat_rgba, 4 * m.nmat},
                             {m.geom_rgba, 4 * m.ngeom},
                             {m.light_cutoff, m.nlight},
                             {m.light_exponent, m.nlight},
                             {m.light_attenuation, 3 * m.nlight},
                             {m.light_diffuse, 3 * m.nlight},
                             {m.skin_inflate, m.nskin},
                             {&m.vis.map.znear, 1},
                             {&m.vis.map.zfar, 1},
                             {&m.vis.map.haze, 1},
                             {&m.vis.map.fogstart, 1},
                             {&m.vis.map.fogend, 1}};
    for (int k = below(4); k >= 0; --k) {
      const Numbers& at = doubles[below(static_cast<int>(std::size(doubles)))];
      at.of[below(static_cast<int>(at.count))] = odd();
      const Floats& in = floats[below(static_cast<int>(std::size(floats)))];
      in.of[below(static_cast<int>(in.count))] = static_cast<float>(odd());
    }
    SCOPED_TRACE(round);
    strange.draw();
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace mimo::test
