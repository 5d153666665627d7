// One picture, whatever draws it: every instruction set, any number of threads, many renderers at once; and what a
// frame costs in memory.
#include <atomic>
#include <cstdlib>
#include <new>
#include <thread>

#include "base/fail.h"
#include "support/scenes.h"
#include "unit/rays/support.h"

namespace {

std::atomic<long> allocations{0};
std::atomic<long> allocated{0};

void* counted(std::size_t size) {
  ++allocations;
  allocated += static_cast<long>(size);
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}

}  // namespace

// Compilers that take one of a pair into the caller and not the other believe that the pair does not fit.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace mimo::test {
namespace {

// Every kind of thing that the renderer draws.
std::string everything() {
  return "<mujoco><statistic extent='2'/><visual><map znear='0.005' fogend='8'/></visual><asset>"
         "<texture type='skybox' builtin='gradient' width='64' height='384' rgb1='.3 .5 .7' rgb2='.9 .8 .7'/>"
         "<texture name='check' type='2d' builtin='checker' width='64' height='64' rgb1='.2 .3 .4' rgb2='.8 .7 .6'/>"
         "<texture name='cube' type='cube' builtin='gradient' width='33' height='198' rgb1='1 .3 .4' rgb2='.2 .7 .6'/>"
         "<material name='floor' texture='check' texrepeat='3 3' texuniform='true' reflectance='.3'/>"
         "<material name='cube' texture='cube' texuniform='true' shininess='.03'/>"
         "<material name='glow' emission='.3' specular='1' shininess='.7' rgba='.3 .5 .8 1'/></asset><worldbody>"
         "<light pos='0 0 4' dir='.1 .1 -1' ambient='.1 .1 .1'/><light directional='true' pos='2 2 3' dir='-1 -.5 -1' "
         "diffuse='.3 .2 .1'/>"
         "<light pos='-1 1 .8' dir='0 0 -1' cutoff='180' attenuation='1 0 1' diffuse='.3 .3 .5'/>"
         "<geom type='plane' size='0 0 1' material='floor'/>"
         "<geom type='sphere' size='.2' pos='0 0 .3' material='cube'/><geom type='capsule' size='.1 .2' pos='.5 0 .3' "
         "euler='40 20 0' material='cube'/>"
         "<geom type='ellipsoid' size='.1 .2 .3' pos='-.5 0 .3' euler='10 20 30' material='glow'/>"
         "<geom type='cylinder' size='.2 .1' pos='0 .5 .3' euler='60 20 30' material='cube'/>"
         "<geom type='box' size='.1 .2 .1' pos='0 -.5 .2' euler='10 20 30' material='glow'/>"
         "<geom type='box' size='.3 .01 .3' pos='.2 -.9 .4' rgba='.9 .4 .2 .4'/></worldbody></mujoco>";
}

std::vector<Shot> views(Studio& studio) {
  std::vector<Shot> shots;
  for (const int azimuth : {10, 75, 200, 300}) {
    shots.push_back(studio.shoot(render::orbit_view({0, 0, 0.3}, 1.8, azimuth, -20, 50), 150, 110));
  }
  return shots;
}

// Not only within a level: the same bits.
TEST(RaySame, EveryInstructionSet) {
  const engine::ModelPtr scenes[] = {engine::compile(everything(), {}, {}), benchmark_model()};
  for (const engine::ModelPtr& model : scenes) {
    Studio best(model, {});
    const std::vector<Shot> expected = views(best);
    const std::vector<std::string> paths = rays::simd_paths();
    EXPECT_FALSE(paths.empty());
    for (const std::string& path : paths) {
      rays::Options options;
      options.simd = path;
      Studio studio(model, options);
      const std::vector<Shot> actual = views(studio);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(actual[i].rgb, expected[i].rgb) << path << ", view " << i;
        EXPECT_EQ(actual[i].depth, expected[i].depth) << path << ", view " << i;
        EXPECT_EQ(actual[i].ids, expected[i].ids) << path << ", view " << i;
      }
    }
  }
  rays::Options unknown;
  unknown.simd = "MMX";
  EXPECT_THROW(Studio(scenes[0], unknown), Error);
}

TEST(RaySame, ThreadsOfAFrame) {
  const engine::ModelPtr model = engine::compile(everything(), {}, {});
  Studio single(model, {});
  rays::Options options;
  options.threads = 5;
  Studio many(model, options);
  const std::vector<Shot> expected = views(single);
  const std::vector<Shot> actual = views(many);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(actual[i].rgb, expected[i].rgb);
    EXPECT_EQ(actual[i].ids, expected[i].ids);
  }
}

TEST(RaySame, SixtyFourRenderersOnEightThreads) {
  const engine::ModelPtr model = benchmark_model();
  rays::Options options;
  options.assets = rays::make_assets(model);
  std::vector<std::unique_ptr<Studio>> studios;
  for (int i = 0; i < 64; ++i) studios.push_back(std::make_unique<Studio>(model, options));
  const render::View view = render::orbit_view({0, 0, 0.4}, 1.5, 150, -20, 45);
  std::vector<Shot> shots(64, Shot(128, 128));
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k) {
    threads.emplace_back([&, k] {
      for (int i = k; i < 64; i += 8) {
        for (int repeat = 0; repeat < 3; ++repeat) shots[i] = studios[i]->shoot(view, 128, 128);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (int i = 1; i < 64; ++i) {
    ASSERT_EQ(shots[i].rgb, shots[0].rgb) << i;
    ASSERT_EQ(shots[i].depth, shots[0].depth) << i;
    ASSERT_EQ(shots[i].ids, shots[0].ids) << i;
  }
}

TEST(RaySame, NoAllocationAFrameAndLittleMemory) {
  const engine::ModelPtr model = benchmark_model();
  rays::Options options;
  options.assets = rays::make_assets(model);
  Studio studio(model, options);
  Shot shot(256, 256);
  const render::View view = render::orbit_view({0, 0, 0.4}, 1.5, 150, -20, 45);
  const long bytes_before = allocated;
  const auto renderer = rays::make_renderer(model, options);
  renderer->draw(*model, studio.physics().data(), view, shot.picture());
  EXPECT_LT(allocated - bytes_before, 4 << 20);
  const long before = allocations;
  for (int i = 0; i < 10; ++i) renderer->draw(*model, studio.physics().data(), view, shot.picture());
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace mimo::test
