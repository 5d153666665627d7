// An OpenGL context of OSMesa, made current for the length of a call only: so it may move between threads.
#pragma once

#include <GL/osmesa.h>

#include <array>

#include "osmesa/host_contexts.h"
#include "osmesa/library.h"

namespace mimo::osmesa {

class Context {
 public:
  // Throws Status::kRender, Status::kUnsupported, and Status::kForked in a process that was forked from one that has
  // drawn.
  explicit Context(const Library& library);
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
    const Library& library_;
    HostContexts host_;
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

 private:
  const Library library_;
  Functions gl_;
  OSMesaContext context_ = nullptr;
  // The context's own frame buffer, of one pixel: MuJoCo draws into another.
  std::array<unsigned char, 4> pixel_{};
};

}  // namespace mimo::osmesa
