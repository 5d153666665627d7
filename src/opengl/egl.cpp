// EGL: OpenGL of whatever graphics card there is, or Mesa's on the CPU, without a window.
#include <dlfcn.h>

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "opengl/context.h"
#include "opengl/loaded_library.h"
#include "opengl/renderer.h"

namespace mimo::opengl {
namespace {

// Types and numbers are spelled out here: EGL's headers are not needed to build libmimo.
using Display = void*;
using Config = void*;
using Surface = void*;
using GlContext = void*;
using Device = void*;
using Attributes = const std::int32_t*;

constexpr std::int32_t kNone = 0x3038;
constexpr unsigned kOpenGl = 0x30A2;               // of what eglBindAPI and eglQueryAPI know
constexpr unsigned kDevicePlatform = 0x313F;       // EGL_PLATFORM_DEVICE_EXT
constexpr unsigned kSurfacelessPlatform = 0x31DD;  // EGL_PLATFORM_SURFACELESS_MESA
constexpr std::int32_t kExtensions = 0x3055;
constexpr int kMostDevices = 32;

// A pixel buffer of red, green and blue, with depth, to be drawn to by OpenGL.
constexpr std::int32_t kConfig[] = {0x3033, 0x0001, 0x3024, 8, 0x3023, 8, 0x3022, 8, 0x3025, 24, 0x3040, 0x0008, kNone};
constexpr std::int32_t kOnePixel[] = {0x3057, 1, 0x3056, 1, kNone};

// Named like what they stand for, without the prefix egl.
struct Egl {
  void* (*GetProcAddress)(const char*) = nullptr;
  Display (*GetDisplay)(void* native) = nullptr;
  unsigned (*Initialize)(Display, std::int32_t* major, std::int32_t* minor) = nullptr;
  const char* (*QueryString)(Display, std::int32_t name) = nullptr;
  unsigned (*ChooseConfig)(Display, Attributes, Config*, std::int32_t size, std::int32_t* count) = nullptr;
  unsigned (*BindAPI)(unsigned) = nullptr;
  unsigned (*QueryAPI)() = nullptr;
  GlContext (*CreateContext)(Display, Config, GlContext shared, Attributes) = nullptr;
  unsigned (*DestroyContext)(Display, GlContext) = nullptr;
  Surface (*CreatePbufferSurface)(Display, Config, Attributes) = nullptr;
  unsigned (*DestroySurface)(Display, Surface) = nullptr;
  unsigned (*MakeCurrent)(Display, Surface draw, Surface read, GlContext) = nullptr;
  std::int32_t (*GetError)() = nullptr;
  // Extensions; null where they are absent.
  Display (*GetPlatformDisplay)(unsigned platform, void* native, Attributes) = nullptr;
  unsigned (*QueryDevices)(std::int32_t most, Device*, std::int32_t* count) = nullptr;
};

Egl load_egl(const std::vector<std::string>& names) {
  std::string why;
  void* handle = load_first(names, why);
  if (handle == nullptr) {
    fail(Status::kUnsupported,
         "the renderer gl needs the library EGL (Debian package libegl1), which cannot be loaded: {}", why);
  }
  const auto look_up = [handle](auto& function, const char* name) {
    assign(function, dlsym(handle, name), "EGL", name);
  };
  Egl egl;
  look_up(egl.GetProcAddress, "eglGetProcAddress");
  look_up(egl.GetDisplay, "eglGetDisplay");
  look_up(egl.Initialize, "eglInitialize");
  look_up(egl.QueryString, "eglQueryString");
  look_up(egl.ChooseConfig, "eglChooseConfig");
  look_up(egl.BindAPI, "eglBindAPI");
  look_up(egl.QueryAPI, "eglQueryAPI");
  look_up(egl.CreateContext, "eglCreateContext");
  look_up(egl.DestroyContext, "eglDestroyContext");
  look_up(egl.CreatePbufferSurface, "eglCreatePbufferSurface");
  look_up(egl.DestroySurface, "eglDestroySurface");
  look_up(egl.MakeCurrent, "eglMakeCurrent");
  look_up(egl.GetError, "eglGetError");
  const char* known = egl.QueryString(nullptr, kExtensions);
  const auto find = [&](auto& function, const char* extension, const char* name) {
    if (known == nullptr || std::strstr(known, extension) == nullptr) return;
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(egl.GetProcAddress(name));
  };
  find(egl.GetPlatformDisplay, "EGL_EXT_platform_base", "eglGetPlatformDisplayEXT");
  find(egl.QueryDevices, "EGL_EXT_device_enumeration", "eglQueryDevicesEXT");
  if (egl.QueryDevices == nullptr) find(egl.QueryDevices, "EGL_EXT_device_base", "eglQueryDevicesEXT");
  return egl;
}

// While this lives, EGL's functions of this thread are about OpenGL, not about OpenGL ES.
class OpenGlBound {
 public:
  explicit OpenGlBound(const Egl& egl) : egl_(egl), before_(egl.QueryAPI()) { egl_.BindAPI(kOpenGl); }
  ~OpenGlBound() { egl_.BindAPI(before_); }
  OpenGlBound(const OpenGlBound&) = delete;
  OpenGlBound& operator=(const OpenGlBound&) = delete;

 private:
  const Egl& egl_;
  unsigned before_;
};

// A display that can be drawn to, and how.
struct Screen {
  Display display = nullptr;
  Config config = nullptr;
};

class EglHandle final : public Handle {
 public:
  // A null context could not be made.
  EglHandle(const Egl& egl, const Screen& screen) : egl_(egl), display_(screen.display) {
    const OpenGlBound bound(egl_);
    surface_ = egl_.CreatePbufferSurface(display_, screen.config, kOnePixel);
    if (surface_ != nullptr) context_ = egl_.CreateContext(display_, screen.config, nullptr, nullptr);
    if (context_ == nullptr) error_ = egl_.GetError();  // the next call of EGL, eglBindAPI, forgets it
  }
  ~EglHandle() override {
    if (context_ != nullptr) egl_.DestroyContext(display_, context_);
    if (surface_ != nullptr) egl_.DestroySurface(display_, surface_);
  }
  EglHandle(const EglHandle&) = delete;
  EglHandle& operator=(const EglHandle&) = delete;

  bool works() const { return context_ != nullptr; }
  std::int32_t error() const { return error_; }  // why it does not

  void make_current() override {
    const OpenGlBound bound(egl_);
    if (egl_.MakeCurrent(display_, surface_, surface_, context_) != 0) return;
    fail(Status::kRender, "EGL cannot make its context current (error {:#x})", egl_.GetError());
  }
  void release() noexcept override {
    const OpenGlBound bound(egl_);
    egl_.MakeCurrent(display_, nullptr, nullptr, nullptr);
  }

 private:
  const Egl egl_;
  Display display_;
  Surface surface_ = nullptr;
  GlContext context_ = nullptr;
  std::int32_t error_ = 0;
};

// All displays without a window, those of graphics cards first: Mesa lists its own on the CPU behind them.
std::vector<Display> displays(const Egl& egl) {
  std::vector<Display> all;
  std::vector<Device> devices(kMostDevices);
  std::int32_t count = 0;
  if (egl.GetPlatformDisplay != nullptr && egl.QueryDevices != nullptr) {
    egl.QueryDevices(kMostDevices, devices.data(), &count);
  }
  for (std::int32_t i = 0; i < count; ++i) {
    all.push_back(egl.GetPlatformDisplay(kDevicePlatform, devices[static_cast<std::size_t>(i)], nullptr));
  }
  if (egl.GetPlatformDisplay != nullptr) {
    all.push_back(egl.GetPlatformDisplay(kSurfacelessPlatform, nullptr, nullptr));
  }
  all.push_back(egl.GetDisplay(nullptr));
  return all;
}

// The first that gives a context of OpenGL.
Screen find_screen(const Egl& egl) {
  for (const Display display : displays(egl)) {
    Screen screen{display, nullptr};
    std::int32_t count = 0;
    if (display == nullptr || egl.Initialize(display, nullptr, nullptr) == 0) continue;
    begin_drawing();  // a driver's threads start with its display
    const bool chosen = egl.ChooseConfig(display, kConfig, &screen.config, 1, &count) != 0 && count > 0;
    if (chosen && EglHandle(egl, screen).works()) return screen;
  }
  fail(Status::kUnsupported,
       "the renderer gl found no graphics card with OpenGL through EGL, nor Mesa's driver for the CPU (Debian package "
       "libgl1-mesa-dri)");
}

class EglPlatform final : public Platform {
 public:
  explicit EglPlatform(const Egl& egl) : egl_(egl), screen_(find_screen(egl)) {}
  const char* name() const override { return "EGL"; }
  void* finder() const override { return reinterpret_cast<void*>(egl_.GetProcAddress); }
  const char* finder_name() const override { return "eglGetProcAddress"; }
  void* find(const char* function) const override { return egl_.GetProcAddress(function); }
  std::unique_ptr<Handle> make_handle() const override {
    auto handle = std::make_unique<EglHandle>(egl_, screen_);
    if (!handle->works()) fail(Status::kRender, "EGL cannot create a context (error {:#x})", handle->error());
    return handle;
  }

 private:
  const Egl egl_;
  const Screen screen_;
};

}  // namespace

PlatformPtr egl(const std::vector<std::string>& libraries) {
  refuse_forked();
  return std::make_shared<EglPlatform>(load_egl(libraries));
}

PlatformPtr egl() { return egl({"libEGL.so.1", "libEGL.so"}); }

}  // namespace mimo::opengl
