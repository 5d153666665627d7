// Meshes and height fields: where rays meet them, and MuJoCo's own picture of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/format.h"
#include "compat/mujoco.h"
#include "unit/rays/agreement.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

constexpr int kAround = 24, kAlong = 12;

// A ring of radius 0.3 m whose tube is 0.1 m thick: not convex, and it shades itself. Vertices of the first and the
// last row and column are twice there, as texture coordinates ask for.
struct Ring {
  std::string vertex, normal, texcoord, face;

  Ring() {
    for (int i = 0; i <= kAround; ++i) {
      for (int k = 0; k <= kAlong; ++k) {
        const double a = 2 * kPi * i / kAround;
        const double b = 2 * kPi * k / kAlong;
        const double r = 0.3 + 0.1 * std::cos(b);
        vertex += format("{} {} {} ", r * std::cos(a), r * std::sin(a), 0.1 * std::sin(b));
        normal += format("{} {} {} ", std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
        texcoord += format("{} {} ", 4.0 * i / kAround, 1.0 * k / kAlong);
      }
    }
    const auto at = [](int i, int k) { return i * (kAlong + 1) + k; };
    for (int i = 0; i < kAround; ++i) {
      for (int k = 0; k < kAlong; ++k) {
        face += format("{} {} {} ", at(i, k), at(i + 1, k), at(i + 1, k + 1));
        face += format("{} {} {} ", at(i, k), at(i + 1, k + 1), at(i, k + 1));
      }
    }
  }

  std::string xml(const std::string& name, bool normals, bool texcoords) const {
    return "<mesh name='" + name + "' vertex='" + vertex + "' face='" + face + "'" +
           (normals ? " normal='" + normal + "'" : "") + (texcoords ? " texcoord='" + texcoord + "'" : "") + "/>";
  }
};

std::string assets() {
  const Ring ring;
  return ring.xml("plain", false, false) + ring.xml("smooth", true, false) + ring.xml("mapped", true, true) +
         "<mesh name='wedge' vertex='0 0 0  .4 0 0  0 .4 0  0 0 .4'/>"
         "<hfield name='hills' nrow='17' ncol='13' size='.6 .5 .25 .1'/>"
         "<texture name='check' type='2d' builtin='checker' width='64' height='64' rgb1='.1 .3 .5' rgb2='.9 .8 .7'/>"
         "<texture name='cube' type='cube' builtin='gradient' mark='edge' markrgb='1 0 0' width='64' height='64' "
         "rgb1='.1 .3 .5' rgb2='.9 .8 .7'/>"
         "<material name='flat' texture='check' texrepeat='3 2' specular='.2'/>"
         "<material name='uniform' texture='check' texrepeat='3 2' texuniform='true' specular='0'/>"
         "<material name='cube' texture='cube' specular='0'/>"
         "<material name='mirror' reflectance='.5' specular='0' rgba='.3 .3 .3 1'/>";
}

engine::ModelPtr scene(const std::string& body) {
  engine::ModelPtr model =
      engine::compile(world("<light pos='.5 -.4 2' dir='-.2 .2 -1' diffuse='.7 .7 .7' specular='.2 .2 .2'/>" + body,
                            assets(), "<headlight ambient='.2 .2 .2' diffuse='.4 .4 .4'/>"),
                      {}, {});
  // MuJoCo 2.2 has no way to write elevations into the model's text.
  mjModel& change = const_cast<mjModel&>(*model);
  for (int i = 0; i < change.nhfielddata; ++i) {
    change.hfield_data[i] = static_cast<float>(0.5 + 0.5 * std::sin(0.9 * (i / 13)) * std::cos(0.7 * (i % 13)));
  }
  return model;
}

struct Case {
  const char* name;
  const char* body;
};

class Meshes : public ::testing::TestWithParam<Case> {};

TEST_P(Meshes, LookTheSame) {
  if (MIMO_MUJOCO_4 && std::string(GetParam().name) == "MappedRing") {
    GTEST_SKIP() << "MuJoCo 4 repeats textures otherwise on meshes that bring places in them; rays as 2.2 does";
  }
  const engine::ModelPtr model = scene(GetParam().body);
  const auto reference = osmesa_for(model);
  if (!reference) GTEST_SKIP() << "there is no OSMesa on this machine";
  Studio studio(model, {});
  double difference = 0;
  int seen = 0;
  Agreement agreement;
  for (const int azimuth : {20, 140, 260}) {
    const render::View view = render::orbit_view({0, 0, 0.1}, 1.4, azimuth, -35, 45);
    Shot theirs(160, 160);
    reference->draw(*model, studio.physics().data(), view, theirs.picture());
    const Shot ours = studio.shoot(view, 160, 160);
    for (std::size_t i = 0; i < ours.rgb.size(); ++i) difference += std::abs(ours.rgb[i] - theirs.rgb[i]);
    for (const int id : ours.ids) seen += id == 0;
    agreement.add(ours, theirs);
  }
  EXPECT_GT(seen, 3000);  // of 76800
  EXPECT_LT(difference / (3 * 160 * 160 * 3), 2.5);
  agreement.expect(0.995, 0.995, 0.93);
}

INSTANTIATE_TEST_SUITE_P(
    RayMesh, Meshes,
    ::testing::Values(
        Case{"PlainRing",
             "<geom type='mesh' mesh='plain' euler='30 20 0'/><geom type='plane' size='1 1 .1' pos='0 0 -.4'/>"},
        Case{"SmoothRing", "<geom type='mesh' mesh='smooth' euler='30 20 0' rgba='.8 .4 .3 1'/>"},
        Case{"MappedRing", "<geom type='mesh' mesh='mapped' euler='-40 20 0' material='flat'/>"},
        Case{"GeneratedFlat", "<geom type='mesh' mesh='plain' euler='30 20 0' material='flat'/>"},
        Case{"GeneratedUniform", "<geom type='mesh' mesh='plain' euler='30 20 0' material='uniform'/>"},
        Case{"GeneratedCube", "<geom type='mesh' mesh='smooth' euler='30 20 0' material='cube'/>"},
        Case{"Wedge",
             "<geom type='mesh' mesh='wedge' rgba='.4 .8 .3 1'/><geom type='plane' size='1 1 .1' pos='0 0 -.3'/>"},
        Case{"Mirrored",
             "<geom type='mesh' mesh='smooth' euler='60 20 0' pos='0 0 .3' rgba='.8 .4 .3 1'/><geom type='plane' "
             "size='1 1 .1' "
             "pos='0 0 -.2' material='mirror'/>"},
        Case{"Hills", "<geom type='hfield' hfield='hills' rgba='.4 .6 .3 1'/>"},
        Case{"TexturedHills", "<geom type='hfield' hfield='hills' material='flat'/>"},
        Case{"OnHills",
             "<geom type='hfield' hfield='hills' pos='0 0 -.2'/><geom type='box' size='.1 .15 .1' euler='0 30 0' "
             "pos='.1 .1 .25' rgba='1 .5 0 1'/>"}),
    [](const auto& given) { return given.param.name; });

// A tetrahedron's face lies in the plane x + y + z = 0.4 m, its frame at the centre of mass (0.1, 0.1, 0.1).
TEST(RayMesh, DepthOfAFace) {
  Studio studio(world("<geom type='mesh' mesh='wedge'/>", assets()));
  // From (0.1, 0.1, 1) straight down: z = 0.2 there.
  render::View view = from_above(1);
  view.position = {0.1, 0.1, 1};
  const Shot shot = studio.shoot(view);
  EXPECT_EQ(shot.middle_id(), 0);
  EXPECT_NEAR(shot.depth[shot.at(16, 16)], 0.8, 1e-5);
  // Its back, from within, is not seen.
  view.position = {0.1, 0.1, 0.05};
  view.rotation << 1, 0, 0, 0, -1, 0, 0, 0, -1;  // upwards
  EXPECT_EQ(studio.shoot(view).middle_id(), -1);
}

// Light from the side does not reach the inner side of the ring's far part, before which its near part stands.
TEST(RayMesh, ShadesItself) {
  const std::string body =
      "<light directional='true' pos='2 0 0' dir='-1 0 -.02' diffuse='1 1 1' specular='0 0 0'/>"
      "<geom type='mesh' mesh='smooth' material='mat'/>";
  Studio studio(world(body, assets()));
  rays::Options options;
  options.shadows = false;
  Studio lit(world(body, assets()), options);
  // The inner side at x = -0.2 looks towards +x, where the tube at x = 0.2..0.4 is in the way.
  const render::View view = render::orbit_view({-0.2, 0, 0.03}, 0.3, 180, -30, 20);
  EXPECT_EQ(studio.shoot(view).middle_id(), 0);
  EXPECT_TRUE(color_near({0, 0, 0}, studio.shoot(view).middle()));
  EXPECT_GT(lit.shoot(view).middle()[0], 60);
}

TEST(RayMesh, EveryInstructionSet) {
  const engine::ModelPtr model = scene(
      "<geom type='mesh' mesh='mapped' euler='30 20 0' material='flat' pos='0 0 .2'/><geom type='hfield' "
      "hfield='hills' "
      "pos='0 0 -.3'/><geom type='mesh' mesh='plain' pos='.2 .2 .3' rgba='.3 .4 .9 .5'/>");
  Studio best(model, {});
  for (const std::string& path : rays::simd_paths()) {
    rays::Options options;
    options.simd = path;
    Studio studio(model, options);
    for (const int azimuth : {10, 130, 250}) {
      const render::View view = render::orbit_view({0, 0, 0.1}, 1.4, azimuth, -25, 45);
      const Shot expected = best.shoot(view, 150, 110);
      const Shot actual = studio.shoot(view, 150, 110);
      EXPECT_EQ(actual.rgb, expected.rgb) << path;
      EXPECT_EQ(actual.depth, expected.depth) << path;
      EXPECT_EQ(actual.ids, expected.ids) << path;
    }
  }
}

// A board of 1 x 0.8 x 0.02 m, as 20,160 triangles.
std::string board_mesh() {
  constexpr int kSide = 70;
  std::string vertices;
  std::string normals;
  std::string faces;
  int count = 0;
  // A side of the box that is looked at from outside along `out`: u x v = out.
  const auto side = [&](const Eigen::Vector3d& out, const Eigen::Vector3d& u, const Eigen::Vector3d& v, int rows) {
    for (int i = 0; i <= kSide; ++i) {
      for (int k = 0; k <= rows; ++k) {
        const Eigen::Vector3d at = out + (2.0 * i / kSide - 1) * u + (2.0 * k / rows - 1) * v;
        vertices += format("{} {} {} ", at[0], at[1], at[2]);
        const Eigen::Vector3d n = out.normalized();
        normals += format("{} {} {} ", n[0], n[1], n[2]);
        if (i == kSide || k == rows) continue;
        const int here = count + i * (rows + 1) + k;
        faces += format("{} {} {} {} {} {} ", here, here + rows + 1, here + rows + 2, here, here + rows + 2, here + 1);
      }
    }
    count += (kSide + 1) * (rows + 1);
  };
  const Eigen::Vector3d x = {0.5, 0, 0};
  const Eigen::Vector3d y = {0, 0.4, 0};
  const Eigen::Vector3d z = {0, 0, 0.01};
  side(z, x, y, kSide);
  side(-z, y, x, kSide);
  side(y, z, x, 1);
  side(-y, x, z, 1);
  side(x, y, z, 1);
  side(-x, z, y, 1);
  return "<mesh name='board' vertex='" + vertices + "' normal='" + normals + "' face='" + faces + "'/>";
}

struct Lamp {
  const char* name;
  const char* light;
};

class Boards : public ::testing::TestWithParam<Lamp> {};

// A box is met in closed form, with neither tree nor triangles.
TEST_P(Boards, OfManyTrianglesLookLikeABox) {
  const auto room = [](const char* board) {
    return std::string(GetParam().light) +
           "<geom type='plane' size='3 3 .1' pos='0 0 -.4' material='mat' rgba='.8 .7 .6 1'/>"
           "<geom type='sphere' size='.1' pos='.1 .1 .25' material='mat' rgba='.2 .9 .3 1'/>"
           "<geom pos='0 0 .05' euler='8 -5 20' material='mat' rgba='.8 .4 .3 1' " +
           board + "/>";
  };
  const std::string headlight = "<headlight ambient='.2 .2 .2' diffuse='.2 .2 .2' specular='0 0 0'/>";
  Studio boxes(world(room("type='box' size='.5 .4 .01'"), "", headlight));
  const engine::ModelPtr model =
      engine::compile(world(room("type='mesh' mesh='board'"), board_mesh(), headlight), {}, {});
  for (const std::string& path : rays::simd_paths()) {
    rays::Options options;
    options.simd = path;
    Studio meshes(model, options);
    for (const auto& [azimuth, elevation, size] : {std::array<int, 3>{20, -35, 256}, {200, -60, 130}, {110, 30, 90}}) {
      const render::View view = render::orbit_view({0, 0, 0}, 1.7, azimuth, elevation, 45);
      const Shot expected = boxes.shoot(view, size, size);
      const Shot shot = meshes.shoot(view, size, size);
      int ids = 0;
      int colors = 0;
      double depth = 0;
      for (std::size_t i = 0; i < shot.ids.size(); ++i) {
        if (shot.ids[i] != expected.ids[i]) {
          ++ids;
          continue;
        }
        depth = std::max(depth, static_cast<double>(std::abs(shot.depth[i] - expected.depth[i])));
        int difference = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          difference = std::max(difference, std::abs(shot.rgb[3 * i + k] - expected.rgb[3 * i + k]));
        }
        colors += difference > 1;
      }
      // Pixels on edges of the board and of shadows.
      const int pixels = size * size;
      EXPECT_LE(ids, pixels / 1000) << path << ", from " << azimuth;
      EXPECT_LE(colors, pixels / 500) << path << ", from " << azimuth;
      EXPECT_LT(depth, 1e-4) << path << ", from " << azimuth;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    RayMesh, Boards,
    ::testing::Values(Lamp{"Spot",
                           "<light pos='.4 -.3 1.6' dir='-.2 .2 -1' cutoff='40' exponent='0' specular='0 0 0'/>"},
                      Lamp{"Around", "<light pos='.3 .2 1.1' dir='0 0 -1' cutoff='180' specular='0 0 0'/>"},
                      Lamp{"Near", "<light pos='.1 -.1 .16' dir='0 0 -1' cutoff='180' specular='0 0 0'/>"},
                      Lamp{"Sun", "<light directional='true' pos='0 0 3' dir='-.4 .3 -1' specular='0 0 0'/>"}),
    [](const auto& given) { return given.param.name; });

// A floor with edges far away looks like one without; what is seen past an edge lies in the shadow of a plane.
TEST(RayMesh, PlanesWithEdges) {
  const auto room = [](const char* size, const char* material) {
    return std::string("<light directional='true' pos='0 0 3' dir='-.4 .3 -1' specular='0 0 0'/>") +
           "<geom type='plane' size='" + size + "' material='" + material +
           "'/><geom type='capsule' size='.1 .3' pos='.1 .2 .15' euler='70 20 0' material='mat'/>";
  };
  for (const char* material : {"uniform", "mirror", "mat"}) {
    Studio endless(world(room("0 0 1", material), assets(), "<headlight ambient='.2 .2 .2' diffuse='.4 .4 .4'/>"));
    Studio wide(world(room("30 20 1", material), assets(), "<headlight ambient='.2 .2 .2' diffuse='.4 .4 .4'/>"));
    const render::View view = render::orbit_view({0, 0, 0.1}, 1.7, 30, -40, 45);
    const Shot expected = endless.shoot(view, 150, 110);
    const Shot shot = wide.shoot(view, 150, 110);
    EXPECT_EQ(shot.ids, expected.ids);
    int most = 0;
    for (std::size_t i = 0; i < shot.rgb.size(); ++i) most = std::max(most, std::abs(shot.rgb[i] - expected.rgb[i]));
    EXPECT_LE(most, 1) << material;
  }
  const auto table = [](const char* board) {
    return std::string("<light directional='true' pos='0 0 3' dir='.6 0 -1' specular='0 0 0'/>") + "<geom " + board +
           " material='mat'/><geom type='box' size='.3 .3 .01' pos='.65 0 -.5' material='mat'/>";
  };
  const std::string ambient = "<headlight ambient='.2 .2 .2' diffuse='0 0 0' specular='0 0 0'/>";
  Studio plane(world(table("type='plane' size='.5 .5 1'"), "", ambient));
  Studio box(world(table("type='box' size='.5 .5 .001' pos='0 0 -.001'"), "", ambient));
  const render::View view = render::orbit_view({0.6, 0, -0.3}, 1.5, 180, -70, 45);
  const Shot shot = plane.shoot(view, 101, 101);
  const Shot expected = box.shoot(view, 101, 101);
  int shaded = 0;
  int different = 0;
  for (std::size_t i = 0; i < shot.ids.size(); ++i) {
    if (shot.ids[i] != 1 || expected.ids[i] != 1) continue;
    shaded += expected.rgb[3 * i] < 60;
    different += std::abs(shot.rgb[3 * i] - expected.rgb[3 * i]) > 1;
  }
  EXPECT_GT(shaded, 200);
  EXPECT_LT(different, 20);
}

}  // namespace
}  // namespace mimo::test
