#include "opengl/context.h"

#include <unistd.h>

#include <atomic>

#include "base/fail.h"

namespace mimo::opengl {
namespace {

// The functions' types are spelled out here: GLX's and EGL's headers are not needed to build libmimo.
using GlxGetContext = void* (*)();
using GlxGetDisplay = void* (*)();
using GlxGetDrawable = unsigned long (*)();
using GlxMakeCurrent = int (*)(void* display, unsigned long draw, unsigned long read, void* context);

using EglGetContext = void* (*)();
using EglGetDisplay = void* (*)();
using EglGetSurface = void* (*)(int which);
using EglMakeCurrent = unsigned (*)(void* display, void* draw, void* read, void* context);
constexpr int kEglDraw = 0x3059;
constexpr int kEglRead = 0x305A;

// The process whose OpenGL has started its drawing threads; 0 before the first context. A forked child inherits its
// state but not these threads, and would wait for them for ever.
std::atomic<pid_t> drawing_process{0};

bool forked() {
  const pid_t process = drawing_process.load();
  return process != 0 && process != getpid();
}

}  // namespace

HostGlx::HostGlx() : library_({"libGLX.so", "libGL.so"}) {
  const auto get_context = library_.find<GlxGetContext>("glXGetCurrentContext");
  if (get_context == nullptr) return;
  context_ = get_context();
  if (context_ == nullptr) return;
  display_ = library_.find<GlxGetDisplay>("glXGetCurrentDisplay")();
  draw_ = library_.find<GlxGetDrawable>("glXGetCurrentDrawable")();
  read_ = library_.find<GlxGetDrawable>("glXGetCurrentReadDrawable")();
  library_.find<GlxMakeCurrent>("glXMakeContextCurrent")(display_, 0, 0, nullptr);
}

HostGlx::~HostGlx() {
  if (context_ == nullptr) return;
  library_.find<GlxMakeCurrent>("glXMakeContextCurrent")(display_, draw_, read_, context_);
}

HostEgl::HostEgl() : library_({"libEGL.so"}) {
  const auto get_context = library_.find<EglGetContext>("eglGetCurrentContext");
  if (get_context == nullptr) return;
  context_ = get_context();
  if (context_ == nullptr) return;
  display_ = library_.find<EglGetDisplay>("eglGetCurrentDisplay")();
  draw_ = library_.find<EglGetSurface>("eglGetCurrentSurface")(kEglDraw);
  read_ = library_.find<EglGetSurface>("eglGetCurrentSurface")(kEglRead);
  library_.find<EglMakeCurrent>("eglMakeCurrent")(display_, nullptr, nullptr, nullptr);
}

HostEgl::~HostEgl() {
  if (context_ == nullptr) return;
  library_.find<EglMakeCurrent>("eglMakeCurrent")(display_, draw_, read_, context_);
}

HostOsmesa::HostOsmesa() : library_({"libOSMesa.so"}) {
  const auto get_context = library_.find<decltype(&OSMesaGetCurrentContext)>("OSMesaGetCurrentContext");
  if (get_context == nullptr) return;
  context_ = get_context();
  if (context_ == nullptr) return;
  GLint format = 0;  // belongs to the context, not needed to make it current
  const auto get_buffer = library_.find<decltype(&OSMesaGetColorBuffer)>("OSMesaGetColorBuffer");
  if (!get_buffer(context_, &width_, &height_, &format, &buffer_)) context_ = nullptr;
  library_.find<decltype(&OSMesaGetIntegerv)>("OSMesaGetIntegerv")(OSMESA_TYPE, &type_);
}

HostOsmesa::~HostOsmesa() {
  if (context_ == nullptr) return;
  const auto make_current = library_.find<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
  make_current(context_, buffer_, static_cast<GLenum>(type_), width_, height_);
}

void refuse_forked() {
  if (!forked()) return;
  fail(Status::kForked,
       "OpenGL was used before fork(), and its threads do not exist in the child; spawn instead of forking, or fork "
       "before the first picture");
}

void begin_drawing() {
  refuse_forked();
  drawing_process = getpid();
}

Context::Context(PlatformPtr platform) : platform_(std::move(platform)) {
  begin_drawing();
  const auto look_up = [this](auto& function, const char* name) {
    assign(function, platform_->find(name), platform_->name(), name);
  };
  look_up(gl_.BindRenderbuffer, "glBindRenderbuffer");
  look_up(gl_.RenderbufferStorageMultisample, "glRenderbufferStorageMultisample");
  look_up(gl_.BindFramebuffer, "glBindFramebuffer");
  look_up(gl_.CheckFramebufferStatus, "glCheckFramebufferStatus");
  look_up(gl_.GetIntegerv, "glGetIntegerv");
  look_up(gl_.GetError, "glGetError");
  handle_ = platform_->make_handle();
}

Context::~Context() {
  if (forked()) static_cast<void>(handle_.release());
}

Context::Current::Current(Context& context) : handle_(*context.handle_) {
  refuse_forked();
  handle_.make_current();
}

Context::Current::~Current() { handle_.release(); }

}  // namespace mimo::opengl
