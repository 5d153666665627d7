#include "osmesa/context.h"

#include <unistd.h>

#include <atomic>

#include "base/fail.h"

namespace mimo::osmesa {
namespace {

// The process whose Mesa has started its drawing threads; 0 before the first context. A forked child inherits Mesa's
// state but not these threads, and would wait for them for ever.
std::atomic<pid_t> drawing_process{0};

bool forked() {
  const pid_t process = drawing_process.load();
  return process != 0 && process != getpid();
}

void refuse_forked() {
  if (!forked()) return;
  fail(Status::kForked,
       "the renderer osmesa was used before fork(), and Mesa's threads do not exist in the child; spawn instead of "
       "forking, or fork before the first picture");
}

}  // namespace

Context::Context(const Library& library) : library_(library) {
  refuse_forked();
  const auto look_up = [&library](auto& function, const char* name) {
    assign(function, library.GetProcAddress(name), name);
  };
  look_up(gl_.BindRenderbuffer, "glBindRenderbuffer");
  look_up(gl_.RenderbufferStorageMultisample, "glRenderbufferStorageMultisample");
  look_up(gl_.BindFramebuffer, "glBindFramebuffer");
  look_up(gl_.CheckFramebufferStatus, "glCheckFramebufferStatus");
  look_up(gl_.GetIntegerv, "glGetIntegerv");
  look_up(gl_.GetError, "glGetError");
  drawing_process = getpid();
  context_ = library_.CreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
  if (context_ == nullptr) fail(Status::kRender, "OSMesa cannot create a context");
}

Context::~Context() {
  if (!forked()) library_.DestroyContext(context_);
}

Context::Current::Current(Context& context) : library_(context.library_), host_(context.library_) {
  refuse_forked();
  if (!library_.MakeCurrent(context.context_, context.pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
    fail(Status::kRender, "OSMesa cannot make its context current");
  }
}

Context::Current::~Current() { library_.MakeCurrent(nullptr, nullptr, 0, 0, 0); }

}  // namespace mimo::osmesa
