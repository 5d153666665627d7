// What the OSMesa renderer draws. Distances and places are those of the world in render/fixture.h.
// This test replaces operator new to count; the compiler takes the pair of malloc and free for a mistake.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

#include "opengl/renderer.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <set>
#include <thread>

#include "compat/mujoco.h"
#include "engine/guard.h"
#include "opengl/osmesa.h"
#include "unit/opengl/fixture.h"

// Counts what this program's C++ code allocates. Sanitizers have allocators of their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kCounts = false;
#else
constexpr bool kCounts = true;
#endif
namespace {
std::atomic<long> allocations{0};
}
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace mimo::opengl::test {
namespace {

TEST(Osmesa, DepthIsTheDistanceAlongTheAxis) {
  const World world;
  const auto renderer = renderer_for(world);
  const Image image = take(*renderer, world, 257, 257);
  EXPECT_NEAR(image.depth[image.at(0.5, 0.5)], 1.9, 1e-3);  // front of the red box
  // Also away from the middle, where a ray to the same plane would be longer.
  EXPECT_NEAR(image.depth[image.at(0.5, 0.5 - 0.4)], 1.9, 1e-3);           // front of the blue box
  EXPECT_NEAR(image.depth[image.at(0.5 - 0.8 / 2.309, 0.5)], 1.82, 5e-3);  // the ball, on the ray to its centre
}

TEST(Osmesa, BackgroundDepthIsTheFarPlane) {
  const World world;
  const Image image = take(*renderer_for(world), world);
  EXPECT_EQ(image.depth[image.at(0.02, 0.02)], 100.0F);
  EXPECT_EQ(image.segmentation[image.at(0.02, 0.02)], -1);
}

TEST(Osmesa, SegmentationNamesGeoms) {
  const World world;
  const Image image = take(*renderer_for(world), world, 128, 128);
  EXPECT_EQ(image.segmentation[image.at(0.5, 0.5)], world.geom("red"));
  EXPECT_EQ(image.segmentation[image.at(0.5, 0.1)], world.geom("blue"));
  EXPECT_EQ(image.segmentation[image.at(0.15, 0.5)], world.geom("green"));
  EXPECT_EQ(image.segmentation[image.at(0.5, 0.97)], world.geom("floor"));
}

TEST(Osmesa, SitesHaveDepthButNoId) {
  const World world;
  const Image image = take(*renderer_for(world), world, 128, 128);
  const std::size_t dot = image.at(0.5 + 0.4 / 1.1547, 0.5);
  EXPECT_EQ(image.segmentation[dot], -1);
  EXPECT_NEAR(image.depth[dot], 0.954, 5e-3);
}

TEST(Osmesa, TransparentGeomsHaveDepthAndId) {
  const World world;
  const Image image = take(*renderer_for(world), world, 128, 128);
  const std::size_t pane = image.at(0.5, 0.5 + 0.4 / 1.1547);
  EXPECT_EQ(image.segmentation[pane], world.geom("pane"));
  EXPECT_NEAR(image.depth[pane], 0.99, 1e-3);
}

TEST(Osmesa, LeftIsLeftAndTopIsTop) {
  const World world;
  const Image image = take(*renderer_for(world), world, 128, 128);
  const auto shows = [&](double x, double y, std::size_t channel) {
    const std::uint8_t* pixel = &image.rgb[3 * image.at(x, y)];
    return pixel[channel] > 2 * pixel[(channel + 1) % 3] && pixel[channel] > 2 * pixel[(channel + 2) % 3];
  };
  EXPECT_TRUE(shows(0.5, 0.5, 0));   // red
  EXPECT_TRUE(shows(0.15, 0.5, 1));  // green
  EXPECT_TRUE(shows(0.5, 0.1, 2));   // blue
  EXPECT_FALSE(shows(0.85, 0.5, 1));
  EXPECT_FALSE(shows(0.5, 0.9, 2));
}

TEST(Osmesa, IdsAndDepthAreNotAveragedByMultisampling) {
  const World world;
  mjModel single = *world.model;
  single.vis.quality.offsamples = 0;
  const auto smooth = renderer_for(world);
  const auto sharp = make_renderer({&single, [](const mjModel*) {}}, Quality{}, LogSink{}, osmesa());
  const Image with = take(*smooth, world, 200, 150), without = take(*sharp, world, 200, 150);
  EXPECT_NE(with.rgb, without.rgb);  // edges are smooth
  EXPECT_EQ(with.segmentation, without.segmentation);
  for (std::size_t i = 0; i < with.pixels(); ++i) {
    const double z = without.depth[i];
    EXPECT_NEAR(with.depth[i], z, 1e-6 + z * z / 0.01 * std::exp2(-23));  // two steps of a depth buffer of 24 bits
  }
  const std::set<std::int32_t> seen(with.segmentation.begin(), with.segmentation.end());
  std::set<std::int32_t> there = {-1};
  for (const char* name : {"floor", "red", "blue", "green", "grey", "pane", "ball"}) there.insert(world.geom(name));
  EXPECT_EQ(seen, there);
}

TEST(Osmesa, AnySize) {
  const World world;
  const auto renderer = renderer_for(world);
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 512}, {511, 1}, {7, 5}, {640, 480}, {2048, 2048}, {3, 3}}) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    const Image image = take(*renderer, world, width, height);
    EXPECT_NEAR(image.depth[image.at(0.5, 0.5)], 1.9, 1e-3);
    EXPECT_EQ(image.segmentation[image.at(0.5, 0.5)], world.geom("red"));
    if (width < 100 || height < 100) continue;  // a large pixel averages the box and what is around it
    EXPECT_GT(image.rgb[3 * image.at(0.5, 0.5)], 2 * image.rgb[3 * image.at(0.5, 0.5) + 1]);
  }
}

TEST(Osmesa, WritesTheWholePictureAndNothingElse) {
  const World world;
  const auto renderer = renderer_for(world);
  Image image(17, 9);
  image.rgb.resize(image.rgb.size() + 100, 7);
  image.depth.resize(image.depth.size() + 100, -7);
  image.segmentation.resize(image.segmentation.size() + 100, -7);
  renderer->draw(*world.model, world.physics.data(), world.view(), image.all());
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    EXPECT_FALSE(image.rgb[3 * i] == 7 && image.rgb[3 * i + 1] == 7 && image.rgb[3 * i + 2] == 7);
    EXPECT_GT(image.depth[i], 0);
    EXPECT_GE(image.segmentation[i], -1);
  }
  for (std::size_t i = image.pixels(); i < image.depth.size(); ++i) {
    EXPECT_EQ(image.depth[i], -7);
    EXPECT_EQ(image.segmentation[i], -7);
  }
  EXPECT_TRUE(std::all_of(image.rgb.begin() + 3 * 17 * 9, image.rgb.end(), [](int value) { return value == 7; }));
}

TEST(Osmesa, EachPartAloneEqualsAllTogether) {
  const World world;
  const auto renderer = renderer_for(world);
  const Image all = take(*renderer, world);
  Image alone(64, 64);
  renderer->draw(*world.model, world.physics.data(), world.view(), {64, 64, alone.rgb.data(), nullptr, nullptr});
  renderer->draw(*world.model, world.physics.data(), world.view(), {64, 64, nullptr, alone.depth.data(), nullptr});
  renderer->draw(*world.model, world.physics.data(), world.view(),
                 {64, 64, nullptr, nullptr, alone.segmentation.data()});
  EXPECT_TRUE(alone == all);
}

TEST(Osmesa, DoesNotDependOnEarlierPictures) {
  const World world;
  const auto used = renderer_for(world);
  take(*used, world, 300, 40, "above");
  take(*used, world, 16, 400, "above");
  const Image here = take(*used, world), there = take(*renderer_for(world), world);
  EXPECT_TRUE(here == there);
}

// MuJoCo draws with its defaults, shadows and reflection among them, into a buffer of exactly this size.
TEST(Osmesa, IsMujocosOwnPicture) {
  const World world;
  const auto renderer = renderer_for(world);
  const Image image = take(*renderer, world, 96, 64);
  const Osmesa library = load_osmesa();
  OSMesaContext context = library.CreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
  std::array<unsigned char, 4> pixel{};
  ASSERT_TRUE(library.MakeCurrent(context, pixel.data(), GL_UNSIGNED_BYTE, 1, 1));
  mjModel model = *world.model;
  model.vis.global.offwidth = 96;
  model.vis.global.offheight = 64;
  mjrContext buffers;
  mjr_defaultContext(&buffers);
  mjr_makeContext(&model, &buffers, 100);
  mjr_setBuffer(mjFB_OFFSCREEN, &buffers);
  mjvScene scene;
  mjv_defaultScene(&scene);
  mjv_makeScene(&model, &scene, 1000);
  mjvOption option;
  mjv_defaultOption(&option);
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.type = mjCAMERA_FIXED;
  camera.fixedcamid = 0;
  mjData* data = const_cast<mjData*>(&world.physics.data());
  std::vector<std::uint8_t> own(96 * 64 * 3);
  for (int twice = 0; twice < 2; ++twice) {  // MuJoCo centres the floor on the camera of the picture before
    mjv_updateScene(&model, data, &option, nullptr, &camera, mjCAT_ALL, &scene);
  }
  mjr_render({0, 0, 96, 64}, &scene, &buffers);
  mjr_readPixels(own.data(), nullptr, {0, 0, 96, 64}, &buffers);
  mjr_freeContext(&buffers);
  mjv_freeScene(&scene);
  library.MakeCurrent(nullptr, nullptr, 0, 0, 0);
  library.DestroyContext(context);
  // An endless floor's corners are rounded on MuJoCo 4: 164 of these bytes differ, each by one level.
  constexpr int kRounding = MIMO_MUJOCO_4 ? 1 : 0;
  int most = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::size_t row = i / (96 * 3), upside_down = (63 - row) * 96 * 3 + i % (96 * 3);
    most = std::max(most, std::abs(image.rgb[i] - own[upside_down]));
  }
  EXPECT_LE(most, kRounding);
}

TEST(Osmesa, DrawsTheWorldsOwnModel) {
  const World world;
  const auto renderer = renderer_for(world);
  const std::size_t middle = 3 * Image(64, 64).at(0.5, 0.5);
  mjModel own = *world.model;  // as a world does that overrides something
  std::vector<float> colours(own.geom_rgba, own.geom_rgba + 4 * own.ngeom);
  std::swap(colours[4 * static_cast<std::size_t>(world.geom("red"))],
            colours[4 * static_cast<std::size_t>(world.geom("red")) + 1]);
  own.geom_rgba = colours.data();
  Image image(64, 64);
  renderer->draw(own, world.physics.data(), world.view(), image.all());
  EXPECT_LT(image.rgb[middle], image.rgb[middle + 1]);
  image = take(*renderer, world);
  EXPECT_GT(image.rgb[middle], image.rgb[middle + 1]);
}

TEST(Osmesa, TwoThreadsDrawTheSame) {
  const World world;
  const Image expected = take(*renderer_for(world), world);
  const auto work = [&](int* same) {
    const auto renderer = renderer_for(world);
    for (int i = 0; i < 20; ++i) {
      take(*renderer, world, 30 + i, 40, "above");
      if (take(*renderer, world) == expected) ++*same;
    }
  };
  int same[2] = {};
  std::thread first(work, &same[0]), second(work, &same[1]);
  first.join();
  second.join();
  EXPECT_EQ(same[0], 20);
  EXPECT_EQ(same[1], 20);
}

TEST(Osmesa, MovesBetweenThreads) {
  const World world;
  auto renderer = renderer_for(world);
  const Image expected = take(*renderer, world);
  for (int i = 0; i < 3; ++i) {
    std::thread([&] { EXPECT_TRUE(take(*renderer, world) == expected); }).join();
  }
  EXPECT_TRUE(take(*renderer, world) == expected);
  std::thread([&] { renderer.reset(); }).join();
  EXPECT_TRUE(take(*renderer_for(world), world) == expected);
}

TEST(Osmesa, LeavesTheSimulationAlone) {
  World world;
  world.physics.step(50);
  mjData& data = world.physics.data();
  const mjData before = data;
  const std::vector<char> arrays(static_cast<char*>(data.buffer), static_cast<char*>(data.buffer) + data.nbuffer);
  take(*renderer_for(world), world);
  EXPECT_EQ(std::memcmp(&before, &data, sizeof data), 0);
  EXPECT_EQ(std::memcmp(arrays.data(), data.buffer, arrays.size()), 0);
}

TEST(Osmesa, LeavesTheFloatingPointUnitAlone) {
  const World world;
  const auto renderer = renderer_for(world);
  std::fesetround(FE_TOWARDZERO);
  take(*renderer, world);
  const int rounding = std::fegetround();
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(rounding, FE_TOWARDZERO);
  volatile double tiny = DBL_MIN;
  tiny = tiny / 4;
  EXPECT_GT(tiny, 0);  // no flush to zero
}

TEST(Osmesa, DoesNotAllocateOnceItHasDrawn) {
  if (!kCounts) GTEST_SKIP() << "allocations are not counted under a sanitizer";
  const World world;
  const auto renderer = renderer_for(world);
  Image image(64, 64);
  const View view = world.view();
  const auto draw = [&] { renderer->draw(*world.model, world.physics.data(), view, image.all()); };
  for (int i = 0; i < 5; ++i) draw();
  const long before = allocations;
  for (int i = 0; i < 20; ++i) draw();
  EXPECT_EQ(allocations, before);
}

TEST(Osmesa, MissingLibraryNamesThePackage) {
  const World world;
  try {
    make_renderer(world.model, Quality{}, LogSink{}, osmesa({"libNoSuchMesa.so.1", "libNoSuchMesa.so"}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kUnsupported);
    EXPECT_NE(error.message().find("libosmesa6"), std::string::npos) << error.message();
    EXPECT_NE(error.message().find("libNoSuchMesa.so.1"), std::string::npos) << error.message();
  }
}

TEST(Osmesa, AnotherLibraryOfThatNameIsRefused) {
  const World world;
  EXPECT_EQ(status_of([&] { make_renderer(world.model, Quality{}, LogSink{}, osmesa({"libm.so.6"})); }),
            Status::kUnsupported);
}

TEST(Osmesa, NextNameIsTried) {
  const World world;
  take(*make_renderer(world.model, Quality{}, LogSink{},
                      osmesa({"libNoSuchMesa.so", "libOSMesa.so.8", "libOSMesa.so.6"})),
       world);
}

TEST(Osmesa, RefusesInvalidPictureSizes) {
  const World world;
  const auto renderer = renderer_for(world);
  const auto draw = [&](int width, int height, double fovy) {
    View view = world.view();
    view.fovy = fovy;
    return status_of([&] { renderer->draw(*world.model, world.physics.data(), view, {width, height}); });
  };
  EXPECT_EQ(draw(0, 4, 60), Status::kInvalidArgument);
  EXPECT_EQ(draw(4, -1, 60), Status::kInvalidArgument);
  EXPECT_EQ(draw(4, 4, 0), Status::kInvalidArgument);
  EXPECT_EQ(draw(4, 4, 180), Status::kInvalidArgument);
  EXPECT_EQ(draw(4, 4, std::nan("")), Status::kInvalidArgument);
  EXPECT_EQ(draw(1, 100000, 60), Status::kInvalidArgument);
  EXPECT_EQ(draw(4, 4, 60), Status::kOk);
}

TEST(Osmesa, DrawsAgainAfterAnError) {
  const World world;
  const auto renderer = renderer_for(world);
  const Image expected = take(*renderer, world);
  mjModel broken = *world.model;
  broken.vis.map.znear = 0;  // MuJoCo raises mju_error
  Image image(64, 64);
  EXPECT_EQ(status_of([&] { renderer->draw(broken, world.physics.data(), world.view(), image.all()); }),
            Status::kRender);
  EXPECT_TRUE(take(*renderer, world) == expected);
}

#if !MIMO_MUJOCO_4  // later there is no such limit
TEST(Osmesa, RefusesMoreTexturesThanMujocoHasRoomFor) {
  std::string textures;
  for (int i = 0; i < 101; ++i) {
    textures += "<texture name=\"t" + std::to_string(i) + "\" type=\"2d\" builtin=\"flat\" width=\"1\" height=\"1\"/>";
  }
  const World world("<mujoco><asset>" + textures + "</asset><worldbody><camera name=\"front\"/></worldbody></mujoco>");
  const auto renderer = renderer_for(world);
  EXPECT_EQ(status_of([&] { take(*renderer, world); }), Status::kRender);
}
#endif

}  // namespace
}  // namespace mimo::opengl::test
