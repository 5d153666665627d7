// Where textures lie on triangles, beside pictures: of each triangle that is seen, the texture's pixel at its middle
// has the colour that the renderer draws there. (The renderer is compared with MuJoCo's own in rays_osmesa_test.cpp.)
#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include "compat/mujoco.h"
#include "geometry/mesh.h"
#include "geometry/texture.h"
#include "render/renderer.h"
#include "unit/rays/support.h"

namespace mimo::test {
namespace {

using Eigen::Vector3d;

constexpr int kTexels = 64;
constexpr int kPixels = 400;

// Red grows along a row, green from row to row, blue from face to face.
void paint(mjModel& model) {
  for (int texture = 0; texture < model.ntex; ++texture) {
    for (int y = 0; y < model.tex_height[texture]; ++y) {
      for (int x = 0; x < kTexels; ++x) {
        mjtByte* texel = model.*compat::kPixels + model.tex_adr[texture] + 3 * (y * kTexels + x);
        texel[0] = static_cast<mjtByte>(4 * x);
        texel[1] = static_cast<mjtByte>(4 * (y % kTexels));
        texel[2] = static_cast<mjtByte>(50 * (y / kTexels));
      }
    }
  }
}

std::string scene(const std::string& geom, const std::string& material) {
  return world("<geom material='painted' " + geom + "/>",
               "<texture name='flat' type='2d' builtin='flat' width='64' height='64'/>"
               "<texture name='cube' type='cube' builtin='flat' width='64' height='384'/>"
               "<mesh name='wedge' vertex='-.3 -.3 0 .3 -.3 0 0 .3 0 0 0 .4'/>"
               "<mesh name='tile' vertex='-.3 -.3 0 .3 -.3 0 .3 .3 .1 -.3 .3 .1 0 0 -.2' face='0 1 2 0 2 3 1 0 4 2 1 4 "
               "3 2 4 0 3 4'"
               " texcoord='.1 .2 .8 .1 .9 .9 .2 .7 .5 .5'/>"
               "<material name='painted' specular='0' rgba='1 1 1 1' " +
                   material + "/>",
               "<headlight ambient='1 1 1' diffuse='0 0 0' specular='0 0 0'/>");
}

Vector3d sample(const std::vector<std::uint8_t>& pixels, const geometry::TextureSize& size, const Eigen::Vector2d& at) {
  const auto index = [](double s, int n) { return std::min(static_cast<int>((s - std::floor(s)) * n), n - 1); };
  const std::size_t first =
      4 * (static_cast<std::size_t>(index(at[1], size.height)) * size.width + index(at[0], size.width));
  return {double(pixels[first]), double(pixels[first + 1]), double(pixels[first + 2])};
}

// Where the renderer mixes pixels of a texture's edge with those beyond.
bool at_edge(const geometry::TextureSize& size, const Eigen::Vector2d& at) {
  const double faces = size.cube() ? 6 : 1;
  const double s = at[0] - std::floor(at[0]);
  const double t = at[1] * faces - std::floor(at[1] * faces);
  return std::min({s, t, 1 - s, 1 - t}) < 1.0 / kTexels;
}

// Whether a pixel's neighbours look like it: no edge of a face or of the texture is near.
bool even(const Shot& shot, int x, int y) {
  for (const auto& [dx, dy] : {std::pair{-3, 0}, {3, 0}, {0, -3}, {0, 3}}) {
    for (int k = 0; k < 3; ++k) {
      if (std::abs(shot.color(x + dx, y + dy)[k] - shot.color(x, y)[k]) > 24) return false;
    }
    if (shot.id(x + dx, y + dy) != 0) return false;
  }
  return true;
}

struct Compared {
  int triangles = 0;
  int wrong = 0;
};

Compared compare(const std::string& geom, const std::string& material, double azimuth, double elevation) {
  const auto model = engine::compile(scene(geom, material), {}, {});
  paint(const_cast<mjModel&>(*model));
  Studio studio(model, {});
  const render::View view = render::orbit_view({0, 0, 0}, 5, azimuth, elevation, 16);
  const Shot shot = studio.shoot(view, kPixels, kPixels);
  const geometry::Mesh mesh = geometry::mesh_of(*model, 0, {96, 1});
  const int texture = geometry::material_of(*model, 0).paint.texture;
  const geometry::TextureSize size = geometry::size_of(*model, texture);
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * size.width * size.height));
  geometry::read_pixels(*model, texture, pixels);

  const mjData& data = studio.physics().data();
  const Vector3d position = Eigen::Map<const Vector3d>(data.geom_xpos);
  const Eigen::Matrix3d rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.geom_xmat);
  Compared done;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    // Points within the triangle, so that a shape of two triangles is compared at many.
    for (int a = 1; a < 10; a += 2) {
      for (int b = 1; a + b < 10; b += 2) {
        const double weight[3] = {a / 10.0, b / 10.0, 1 - a / 10.0 - b / 10.0};
        Vector3d place = Vector3d::Zero(), normal = Vector3d::Zero();
        Eigen::Vector2d at = Eigen::Vector2d::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
          const geometry::Vertex& vertex = mesh.vertices[mesh.indices[i + k]];
          place += weight[k] * vertex.place;
          normal += weight[k] * vertex.normal;
          at += weight[k] * vertex.texture;
        }
        const Vector3d point = position + rotation * place;
        if ((rotation * normal).normalized().dot((view.position - point).normalized()) < 0.4) continue;
        const Vector3d pixel = render::project(view, kPixels, kPixels, point);
        const int x = static_cast<int>(pixel[0]);
        const int y = static_cast<int>(pixel[1]);
        if (at_edge(size, at)) continue;
        if (std::min(x, y) < 4 || std::max(x, y) > kPixels - 5) continue;
        if (std::abs(shot.depth[shot.at(x, y)] - pixel[2]) > 0.01 || !even(shot, x, y)) continue;
        const std::array<int, 3> drawn = shot.color(x, y);
        const Vector3d difference = sample(pixels, size, at) - Vector3d(drawn[0], drawn[1], drawn[2]);
        ++done.triangles;
        if (difference.cwiseAbs().maxCoeff() > 14) ++done.wrong;
      }
    }
  }
  return done;
}

class EachShape : public testing::TestWithParam<const char*> {};

TEST_P(EachShape, TexturesLieWhereTheyAreDrawn) {
  for (const char* material :
       {"texture='flat'", "texture='flat' texrepeat='2 1'", "texture='flat' texuniform='true' texrepeat='3 2'",
        "texture='cube'", "texture='cube' texuniform='true'"}) {
    int seen = 0;
    for (const auto& [azimuth, elevation] : {std::pair{30.0, -40.0}, {160.0, -60.0}, {250.0, 40.0}}) {
      const Compared done = compare(GetParam(), material, azimuth, elevation);
      EXPECT_EQ(done.wrong, 0) << material << " of " << done.triangles << " seen from " << azimuth << " " << elevation;
      seen += done.triangles;
    }
    EXPECT_GT(seen, 20) << material;
  }
}

INSTANTIATE_TEST_SUITE_P(GeometryTexture, EachShape,
                         testing::Values("type='plane' size='.4 .3 .1' euler='10 5 20'", "type='sphere' size='.4'",
                                         "type='ellipsoid' size='.2 .3 .4' euler='20 30 40'",
                                         "type='capsule' size='.2 .3' euler='40 10 0'",
                                         "type='cylinder' size='.3 .2' euler='-30 60 20'",
                                         "type='box' size='.2 .3 .25' euler='15 25 35'", "type='mesh' mesh='wedge'"));

TEST(GeometryTexture, MeshesKeepTheirOwnPlaces) {
  for (const double azimuth : {30.0, 200.0}) {
    const Compared done = compare("type='mesh' mesh='tile'", "texture='flat'", azimuth, -50);
    EXPECT_EQ(done.wrong, 0) << done.triangles;
    EXPECT_GT(done.triangles, 4);
  }
}

}  // namespace
}  // namespace mimo::test
