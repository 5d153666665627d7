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
#pragma once

#include <memory>
#include <mutex>

#include "opengl/platform.h"

namespace mimo::opengl {

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

}  // namespace mimo::opengl
