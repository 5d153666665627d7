// MuJoCo's own pictures, by OpenGL that is loaded at run time.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/log.h"
#include "engine/model.h"
#include "opengl/context.h"
#include "render/renderer.h"

namespace mimo::opengl {

// Which OpenGL MuJoCo draws with.
//
// MuJoCo 2.2 is linked to none. The first mjr_makeContext in a process looks the functions up and keeps them for the
// whole process. It takes them from eglGetProcAddress, OSMesaGetProcAddress or glXGetProcAddressARB, whichever is the
// first of these in the global scope, else from the first loaded library called libGLX.so*, libGL.so*, libEGL.so* or
// libOSMesa.so*. Where the host has loaded EGL or GLX, it would pass ours by and fail, and for ever: the look-up is
// a static initialisation.
//
// Therefore, where the look-up would go elsewhere, libmujoco's reference to dlsym leads to us for the time of it.
// What cannot be helped: a host that has drawn with this same MuJoCo through another OpenGL before us keeps that (and
// we say so); one that begins after us finds ours.

// While this lives, MuJoCo's look-up on this thread finds this OpenGL. Only one lives at a time, because the functions
// that MuJoCo keeps are global. Throws Status::kUnsupported where the look-up cannot be led, or has led to another
// OpenGL before.
class MujocoBinding {
 public:
  explicit MujocoBinding(const Platform& platform);
  ~MujocoBinding();
  MujocoBinding(const MujocoBinding&) = delete;
  MujocoBinding& operator=(const MujocoBinding&) = delete;

  // MuJoCo has made a context: from now on its functions are those of this OpenGL.
  void confirm();

 private:
  class Detour;

  const Platform& platform_;
  std::lock_guard<std::mutex> lock_;
  std::unique_ptr<Detour> detour_;
};

#if defined(__linux__)
constexpr bool kExists = true;
#else
constexpr bool kExists = false;  // absent.cpp
#endif

class Platform;
using PlatformPtr = std::shared_ptr<const Platform>;

// Mesa's OpenGL on the CPU, and EGL's, on a graphics card if there is one. Both throw Status::kUnsupported where they
// are absent. MuJoCo keeps to the first OpenGL that it draws with, so a process draws with one of the two.
PlatformPtr osmesa();
PlatformPtr egl();
// The same with other names of the libraries.
PlatformPtr osmesa(const std::vector<std::string>& libraries);
PlatformPtr egl(const std::vector<std::string>& libraries);

std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr model, const render::Quality& quality,
                                                const LogSink& log, const PlatformPtr& platform);

}  // namespace mimo::opengl
