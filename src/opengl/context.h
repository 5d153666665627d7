// An OpenGL context, made current for the length of a call only, so that it may move between threads.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <memory>

#include "base/fail.h"
#include "opengl/loaded_library.h"

namespace mimo::opengl {

// One of the ways to come by OpenGL: a library that is loaded at run time, and contexts of its making.

// A context with the smallest buffer that it can have: MuJoCo draws into another.
class Handle {
 public:
  virtual ~Handle() = default;
  // On this thread, where no other is. Throws Status::kRender.
  virtual void make_current() = 0;
  virtual void release() noexcept = 0;
};

class Platform {
 public:
  virtual ~Platform() = default;
  virtual const char* name() const = 0;  // as users know it: "OSMesa"
  // The function by which it finds OpenGL's functions, and what MuJoCo knows that by.
  virtual void* finder() const = 0;
  virtual const char* finder_name() const = 0;
  // What `finder` finds; null for nothing.
  virtual void* find(const char* function) const = 0;
  // Throws Status::kRender.
  virtual std::unique_ptr<Handle> make_handle() const = 0;
};
using PlatformPtr = std::shared_ptr<const Platform>;

// Makes a function of what was found under a name. Throws Status::kUnsupported where that is nothing.
template <typename Function, typename Address>
void assign(Function& function, Address found, const char* library, const char* name) {
  if (found == nullptr) fail(Status::kUnsupported, "the installed {} has no function {}", library, name);
  function = reinterpret_cast<Function>(found);
}

// The OpenGL contexts that the host has current on this thread. They are put aside while we draw and are current
// again afterwards, as if nothing had happened.

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

// Throws Status::kForked in a child of a process that had begun to draw.
void refuse_forked();

// This process begins to draw. Throws what refuse_forked() throws.
void begin_drawing();

class Context {
 public:
  // Throws Status::kRender, Status::kUnsupported, and Status::kForked in a process that was forked from one that has
  // drawn.
  explicit Context(PlatformPtr platform);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The context is current on this thread while this lives; afterwards the host's is again. Throws what the
  // constructor throws.
  class Current {
   public:
    explicit Current(Context& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    HostContexts host_;
    Handle& handle_;
  };

  // The few functions of OpenGL that MuJoCo does not call for us.
  struct Functions {
    PFNGLBINDRENDERBUFFERPROC BindRenderbuffer = nullptr;
    PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC RenderbufferStorageMultisample = nullptr;
    PFNGLBINDFRAMEBUFFERPROC BindFramebuffer = nullptr;
    PFNGLCHECKFRAMEBUFFERSTATUSPROC CheckFramebufferStatus = nullptr;
    decltype(&glGetIntegerv) GetIntegerv = nullptr;
    decltype(&glGetError) GetError = nullptr;
  };
  const Functions& gl() const { return gl_; }
  const Platform& platform() const { return *platform_; }

 private:
  const PlatformPtr platform_;
  Functions gl_;
  std::unique_ptr<Handle> handle_;
};

}  // namespace mimo::opengl
