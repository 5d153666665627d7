// The OSMesa renderer in processes that use OpenGL themselves. What a process does to MuJoCo's OpenGL is for ever, so
// most of these tests run in a process of their own (gtest's "threadsafe" death tests start one).
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "engine/guard.h"
#include "opengl/loaded_library.h"
#include "opengl/osmesa.h"
#include "unit/opengl/fixture.h"

namespace mimo::opengl::test {
namespace {

// Runs the scenario in a new process and expects it to return true.
#define EXPECT_IN_NEW_PROCESS(scenario)                                          \
  do {                                                                           \
    GTEST_FLAG_SET(death_test_style, "threadsafe");                              \
    EXPECT_EXIT(std::_Exit((scenario) ? 0 : 1), testing::ExitedWithCode(0), ""); \
  } while (false)

bool failed(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  return false;
}
#define DEMAND(condition) \
  if (!(condition)) return failed(#condition)

bool draws_right(Renderer& renderer, const World& world) {
  const Image image = take(renderer, world);
  DEMAND(image.segmentation[image.at(0.5, 0.5)] == world.geom("red"));
  const std::uint8_t* middle = &image.rgb[3 * image.at(0.5, 0.5)];
  DEMAND(middle[0] > 2 * middle[1]);
  return true;
}

bool draws_right() {
  const World world;
  return draws_right(*renderer_for(world), world);
}

// A host that draws with OSMesa itself.
struct OsmesaHost {
  OsmesaHost() : osmesa(load_osmesa()), context(osmesa.CreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr)) {
    osmesa.MakeCurrent(context, pixels, GL_UNSIGNED_BYTE, 3, 2);
    clear_color = reinterpret_cast<decltype(&glClearColor)>(osmesa.GetProcAddress("glClearColor"));
    clear = reinterpret_cast<decltype(&glClear)>(osmesa.GetProcAddress("glClear"));
    finish = reinterpret_cast<decltype(&glFinish)>(osmesa.GetProcAddress("glFinish"));
  }
  ~OsmesaHost() {
    osmesa.MakeCurrent(nullptr, nullptr, 0, 0, 0);
    osmesa.DestroyContext(context);
  }
  void paint(float red) {
    clear_color(red, 0, 0, 1);
    clear(GL_COLOR_BUFFER_BIT);
    finish();
  }

  Osmesa osmesa;
  OSMesaContext context;
  unsigned char pixels[3 * 2 * 4] = {};
  decltype(&glClearColor) clear_color;
  decltype(&glClear) clear;
  decltype(&glFinish) finish;
};

TEST(Host, NothingIsCurrentAfterwardsIfNothingWasBefore) {
  const World world;
  const auto renderer = renderer_for(world);
  EXPECT_TRUE(draws_right(*renderer, world));
  EXPECT_EQ(load_osmesa().GetCurrentContext(), nullptr);
}

TEST(Host, OsmesaContextStaysCurrent) {
  OsmesaHost host;
  host.paint(1);
  ASSERT_EQ(host.pixels[4 * 5], 255);
  const World world;
  const auto renderer = renderer_for(world);
  EXPECT_TRUE(draws_right(*renderer, world));
  EXPECT_EQ(host.osmesa.GetCurrentContext(), host.context);
  host.paint(0.4F);  // into the same buffer, all of it
  EXPECT_EQ(host.pixels[0], 102);
  EXPECT_EQ(host.pixels[4 * 5], 102);
  GLint width = 0, height = 0, type = 0;
  host.osmesa.GetIntegerv(OSMESA_WIDTH, &width);
  host.osmesa.GetIntegerv(OSMESA_HEIGHT, &height);
  host.osmesa.GetIntegerv(OSMESA_TYPE, &type);
  EXPECT_EQ(width, 3);
  EXPECT_EQ(height, 2);
  EXPECT_EQ(type, GL_UNSIGNED_BYTE);
}

TEST(Host, OsmesaContextStaysCurrentAfterAFailureAndADestroyedRenderer) {
  OsmesaHost host;
  const World world;
  auto renderer = renderer_for(world);
  EXPECT_TRUE(draws_right(*renderer, world));
  mjModel broken = *world.model;
  broken.vis.map.znear = 0;
  Image image(8, 8);
  EXPECT_EQ(status_of([&] { renderer->draw(broken, world.physics.data(), world.view(), image.all()); }),
            Status::kRender);
  EXPECT_EQ(host.osmesa.GetCurrentContext(), host.context);
  renderer.reset();
  EXPECT_EQ(host.osmesa.GetCurrentContext(), host.context);
}

// What hosts with an OpenGL of their own have in common.
struct GlHost {
  template <typename Function>
  Function find(const char* name) {
    return reinterpret_cast<Function>(dlsym(library, name));
  }
  // OpenGL's functions, looked up by `gl`, answer for the host's context: a texture of its own is known.
  template <typename Lookup>
  bool knows_its_texture(Lookup&& gl) {
    if (texture == 0) {
      reinterpret_cast<void (*)(GLsizei, GLuint*)>(gl("glGenTextures"))(1, &texture);
      reinterpret_cast<void (*)(GLenum, GLuint)>(gl("glBindTexture"))(GL_TEXTURE_2D, texture);
    }
    return texture != 0 && reinterpret_cast<GLboolean (*)(GLuint)>(gl("glIsTexture"))(texture);
  }

  void* library = nullptr;
  void* display = nullptr;
  void* context = nullptr;
  GLuint texture = 0;
};

// A host that draws with EGL, without a window (Mesa's platform "surfaceless").
struct EglHost : GlHost {
  bool open(int flags) {
    library = dlopen("libEGL.so.1", RTLD_NOW | flags);
    if (library == nullptr) return false;
    const auto get_display = find<void* (*)(unsigned, void*, const void*)>("eglGetPlatformDisplay");
    const auto initialize = find<unsigned (*)(void*, int*, int*)>("eglInitialize");
    const auto bind = find<unsigned (*)(unsigned)>("eglBindAPI");
    const auto create = find<void* (*)(void*, void*, void*, const int*)>("eglCreateContext");
    constexpr unsigned kSurfaceless = 0x31DD, kOpenGl = 0x30A2;
    display = get_display == nullptr ? nullptr : get_display(kSurfaceless, nullptr, nullptr);
    if (display == nullptr || !initialize(display, nullptr, nullptr) || !bind(kOpenGl)) return false;
    context = create(display, nullptr, nullptr, nullptr);
    return context != nullptr && make_current(context);
  }
  bool make_current(void* which) {
    return find<unsigned (*)(void*, void*, void*, void*)>("eglMakeCurrent")(display, nullptr, nullptr, which) != 0;
  }
  bool works() {
    return knows_its_texture(find<void* (*)(const char*)>("eglGetProcAddress")) &&
           find<void* (*)()>("eglGetCurrentContext")() == context;
  }
};

bool has_egl() {
  static const bool has = [] {
    EglHost host;
    return host.open(RTLD_LOCAL) && host.make_current(nullptr);
  }();
  return has;
}

bool draws_beside_egl(int flags) {
  EglHost host;
  DEMAND(host.open(flags));
  DEMAND(host.works());
  const World world;
  auto renderer = renderer_for(world);
  DEMAND(draws_right(*renderer, world));
  DEMAND(host.works());
  DEMAND(draws_right(*renderer, world));
  renderer.reset();
  DEMAND(host.works());
  return draws_right() && host.works();
}

TEST(Host, DrawsBesideEglInTheGlobalScope) {
  if (!has_egl()) GTEST_SKIP() << "no EGL without a window here";
  EXPECT_IN_NEW_PROCESS(draws_beside_egl(RTLD_GLOBAL));
}

TEST(Host, DrawsBesideEglInALocalScope) {
  if (!has_egl()) GTEST_SKIP() << "no EGL without a window here";
  EXPECT_IN_NEW_PROCESS(draws_beside_egl(RTLD_LOCAL));
}

bool draws_beside_egl_that_came_later() {
  const World world;
  const auto renderer = renderer_for(world);
  DEMAND(draws_right(*renderer, world));
  EglHost host;
  DEMAND(host.open(RTLD_GLOBAL));
  DEMAND(host.works());
  DEMAND(draws_right(*renderer, world));
  DEMAND(host.works());
  return draws_right() && host.works();
}

TEST(Host, DrawsBesideEglLoadedLater) {
  if (!has_egl()) GTEST_SKIP() << "no EGL without a window here";
  EXPECT_IN_NEW_PROCESS(draws_beside_egl_that_came_later());
}

// A host that draws with GLX; it needs an X display, if only a virtual one (xvfb-run).
struct GlxHost : GlHost {
  bool open(int flags) {
    x11 = dlopen("libX11.so.6", RTLD_NOW | RTLD_LOCAL);
    library = dlopen("libGL.so.1", RTLD_NOW | flags);
    if (x11 == nullptr || library == nullptr) return false;
    display = reinterpret_cast<void* (*)(const char*)>(dlsym(x11, "XOpenDisplay"))(nullptr);
    if (display == nullptr) return false;
    constexpr int kDrawableType[] = {0x8010, 4, 0}, kSize[] = {0x8041, 8, 0x8040, 8, 0};
    int count = 0;
    void** configs =
        find<void** (*)(void*, int, const int*, int*)>("glXChooseFBConfig")(display, 0, kDrawableType, &count);
    if (configs == nullptr || count == 0) return false;
    pbuffer = find<unsigned long (*)(void*, void*, const int*)>("glXCreatePbuffer")(display, configs[0], kSize);
    context =
        find<void* (*)(void*, void*, int, void*, int)>("glXCreateNewContext")(display, configs[0], 0x8014, nullptr, 1);
    return find<int (*)(void*, unsigned long, unsigned long, void*)>("glXMakeContextCurrent")(display, pbuffer, pbuffer,
                                                                                              context) != 0;
  }
  bool works() {
    return knows_its_texture([this](const char* name) { return find<void*>(name); }) &&
           find<void* (*)()>("glXGetCurrentContext")() == context &&
           find<unsigned long (*)()>("glXGetCurrentDrawable")() == pbuffer;
  }

  void* x11 = nullptr;
  unsigned long pbuffer = 0;
};

bool draws_beside_a_glx_context(int flags) {
  GlxHost host;
  DEMAND(host.open(flags));
  DEMAND(host.works());
  const World world;
  auto renderer = renderer_for(world);
  DEMAND(draws_right(*renderer, world));
  DEMAND(host.works());
  renderer.reset();
  return draws_right() && host.works();
}

TEST(Host, DrawsBesideAGlxContext) {
  if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no X display here";
  EXPECT_IN_NEW_PROCESS(draws_beside_a_glx_context(RTLD_GLOBAL));
  EXPECT_IN_NEW_PROCESS(draws_beside_a_glx_context(RTLD_LOCAL));
}

bool draws_beside_glx(int flags) {
  DEMAND(dlopen("libGL.so.1", RTLD_NOW | flags) != nullptr);
  return draws_right();
}

TEST(Host, DrawsBesideGlxThatIsOnlyLoaded) {
  if (dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL) == nullptr) GTEST_SKIP() << "no GLX here";
  EXPECT_IN_NEW_PROCESS(draws_beside_glx(RTLD_GLOBAL));
  EXPECT_IN_NEW_PROCESS(draws_beside_glx(RTLD_LOCAL));
}

TEST(Host, DrawsWithoutAnyOtherOpenGl) { EXPECT_IN_NEW_PROCESS(draws_right()); }

// What cannot be helped is at least said.
bool says_that_mujoco_belongs_to_egl() {
  EglHost host;
  DEMAND(host.open(RTLD_GLOBAL));
  const World world;
  mjrContext buffers;
  mjr_defaultContext(&buffers);
  DEMAND(!engine::guarded([&] { mjr_makeContext(world.model.get(), &buffers, 100); }).failed);
  const auto renderer = renderer_for(world);
  for (int twice = 0; twice < 2; ++twice) {
    try {
      take(*renderer, world);
      return failed("drew with EGL");
    } catch (const Error& error) {
      DEMAND(error.status() == Status::kRender);
      DEMAND(error.message().find("another OpenGL") != std::string::npos);
    }
    DEMAND(host.works());
  }
  engine::guarded([&] { mjr_freeContext(&buffers); });
  return host.works();
}

TEST(Host, SaysThatMujocoBelongsToAnotherOpenGl) {
  if (!has_egl()) GTEST_SKIP() << "no EGL without a window here";
  EXPECT_IN_NEW_PROCESS(says_that_mujoco_belongs_to_egl());
}

// Mesa's threads are not there after fork(): without the refusal the child would wait for ever.
TEST(Host, RefusesToDrawInAForkedChild) {
  const World world;
  auto renderer = renderer_for(world);
  ASSERT_TRUE(draws_right(*renderer, world));
  const pid_t child = fork();
  if (child == 0) {
    alarm(20);
    const bool old = status_of([&] { take(*renderer, world); }) == Status::kForked;
    const bool fresh = status_of([&] { draws_right(); }) == Status::kForked;
    renderer.reset();
    std::_Exit(old && fresh ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(draws_right(*renderer, world));
}

bool draws_in_a_child_forked_before() {
  const World world;
  const auto renderer = renderer_for(world);
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    std::_Exit(draws_right(*renderer, world) ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0;
}

TEST(Host, DrawsInAChildForkedBeforeTheFirstPicture) { EXPECT_IN_NEW_PROCESS(draws_in_a_child_forked_before()); }

TEST(Host, ImportSlotBelongsToTheFunction) {
  ImportSlot slot(dlsym(RTLD_DEFAULT, "mjr_makeContext"), "dlsym");
  ASSERT_FALSE(slot.empty());
  const auto other = reinterpret_cast<void*>(&draws_beside_glx);
  void* original = slot.exchange(other);
  EXPECT_EQ(slot.exchange(original), other);
  EXPECT_TRUE(ImportSlot(dlsym(RTLD_DEFAULT, "mjr_makeContext"), "no_such_function").empty());
  EXPECT_TRUE(ImportSlot(nullptr, "dlsym").empty());
}

}  // namespace
}  // namespace mimo::opengl::test
