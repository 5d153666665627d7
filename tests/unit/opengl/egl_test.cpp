// EGL beside OSMesa. That both draw the same picture is asked in tests/capi/gl.c, of two processes.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "opengl/context.h"
#include "unit/opengl/fixture.h"

namespace mimo::opengl::test {
namespace {

bool has_egl() {
  try {
    return egl() != nullptr;
  } catch (const Error&) {
    return false;
  }
}

std::string message_of(const std::vector<std::string>& libraries) {
  try {
    egl(libraries);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kUnsupported);
    return error.message();
  }
  return "";
}

TEST(Egl, MissingLibraryNamesThePackage) {
  const std::string message = message_of({"libNoSuchEgl.so.1", "libNoSuchEgl.so"});
  EXPECT_NE(message.find("renderer gl"), std::string::npos) << message;
  EXPECT_NE(message.find("libegl1"), std::string::npos) << message;
  EXPECT_NE(message.find("libNoSuchEgl.so.1"), std::string::npos) << message;
}

TEST(Egl, AnotherLibraryOfThatNameIsRefused) {
  EXPECT_NE(message_of({"libm.so.6"}).find("eglGetProcAddress"), std::string::npos);
}

bool exits_with_success(pid_t child) {
  int status = -1;
  return waitpid(child, &status, 0) == child && status == 0;
}

// An EGL that knows no driver; it asks for them once in a process. No driver has started threads that a child lacks.
TEST(Egl, WithoutADriverItSaysSoAndChildrenMayDraw) {
  if (dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL) == nullptr) GTEST_SKIP() << "no EGL here";
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto refused = [] {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json", 1);
    if (message_of({"libEGL.so.1"}).find("found no graphics card") == std::string::npos) return false;
    const pid_t child = fork();
    if (child == 0) _exit(status_of([] { begin_drawing(); }) == Status::kOk ? 0 : 1);
    return exits_with_success(child);
  };
  EXPECT_EXIT(std::_Exit(refused() ? 0 : 1), testing::ExitedWithCode(0), "");
}

// A host that draws with OpenGL ES by EGL, in a context of its own.
struct Host {
  bool open() {
    library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    constexpr unsigned kSurfaceless = 0x31DD;
    display = call<void* (*)(unsigned, void*, const void*)>("eglGetPlatformDisplay")(kSurfaceless, nullptr, nullptr);
    if (display == nullptr || call<unsigned (*)(void*, int*, int*)>("eglInitialize")(display, nullptr, nullptr) == 0) {
      return false;
    }
    call<unsigned (*)(unsigned)>("eglBindAPI")(kApi);
    constexpr int kSecond[] = {0x3098, 2, 0x3038};
    context = call<void* (*)(void*, void*, void*, const int*)>("eglCreateContext")(display, nullptr, nullptr, kSecond);
    return context != nullptr &&
           call<unsigned (*)(void*, void*, void*, void*)>("eglMakeCurrent")(display, nullptr, nullptr, context) != 0;
  }
  bool is_current() const {
    return call<void* (*)()>("eglGetCurrentContext")() == context && call<unsigned (*)()>("eglQueryAPI")() == kApi;
  }
  template <typename Function>
  Function call(const char* name) const {
    return reinterpret_cast<Function>(dlsym(library, name));
  }

  static constexpr unsigned kApi = 0x30A0;  // OpenGL ES, which the renderer does not draw with
  void* library = nullptr;
  void* display = nullptr;
  void* context = nullptr;
};

bool leaves_the_host_alone() {
  Host host;
  if (!host.open()) return false;
  const World world;
  auto renderer = make_renderer(world.model, Quality{}, LogSink{}, egl());
  const Image image = take(*renderer, world);
  const bool drawn = image.segmentation[image.at(0.5, 0.5)] == world.geom("red");
  const bool current = host.is_current();
  renderer.reset();
  return drawn && current && host.is_current();
}

TEST(Egl, LeavesAContextOfTheHostsCurrent) {
  if (!has_egl()) GTEST_SKIP() << "no EGL here";
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(std::_Exit(leaves_the_host_alone() ? 0 : 1), testing::ExitedWithCode(0), "");
}

// The driver's threads are not there.
TEST(Egl, IsRefusedInAForkedChild) {
  if (!has_egl()) GTEST_SKIP() << "no EGL here";
  const pid_t child = fork();
  if (child == 0) _exit(status_of([] { egl(); }) == Status::kForked ? 0 : 1);
  EXPECT_TRUE(exits_with_success(child));
}

}  // namespace
}  // namespace mimo::opengl::test
