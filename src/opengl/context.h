// An OpenGL context, made current for the length of a call only: so it may move between threads.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <memory>

#include "opengl/host_contexts.h"
#include "opengl/platform.h"

namespace mimo::opengl {

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
