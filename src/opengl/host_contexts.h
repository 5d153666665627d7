// The OpenGL contexts that the host has current on this thread. They are put aside while we draw and are current
// again afterwards, as if nothing had happened.
#pragma once

#include <GL/osmesa.h>

#include "opengl/loaded_library.h"

namespace mimo::opengl {

class HostGlx {
 public:
  HostGlx();
  ~HostGlx();
  HostGlx(const HostGlx&) = delete;
  HostGlx& operator=(const HostGlx&) = delete;

 private:
  LoadedLibrary library_;
  void* context_ = nullptr;
  void* display_ = nullptr;
  unsigned long draw_ = 0;
  unsigned long read_ = 0;
};

class HostEgl {
 public:
  HostEgl();
  ~HostEgl();
  HostEgl(const HostEgl&) = delete;
  HostEgl& operator=(const HostEgl&) = delete;

 private:
  LoadedLibrary library_;
  void* context_ = nullptr;
  void* display_ = nullptr;
  void* draw_ = nullptr;
  void* read_ = nullptr;
};

class HostOsmesa {
 public:
  HostOsmesa();
  ~HostOsmesa();
  HostOsmesa(const HostOsmesa&) = delete;
  HostOsmesa& operator=(const HostOsmesa&) = delete;

 private:
  LoadedLibrary library_;
  OSMesaContext context_ = nullptr;
  void* buffer_ = nullptr;
  GLint width_ = 0;
  GLint height_ = 0;
  GLint type_ = 0;
};

// All of them. The order matters: Mesa's GLX, EGL and OSMesa share one notion of the current context, and OSMesa would
// take a context of the others for its own. So it is asked last, when the others have none.
class HostContexts {
 public:
  HostContexts() = default;

 private:
  HostGlx glx_;
  HostEgl egl_;
  HostOsmesa osmesa_;
};

}  // namespace mimo::opengl
