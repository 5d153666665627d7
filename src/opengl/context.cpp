#include "opengl/context.h"

#include <unistd.h>

#include <atomic>

#include "base/fail.h"

namespace mimo::opengl {
namespace {

// The process whose OpenGL has started its drawing threads; 0 before the first context. A forked child inherits its
// state but not these threads, and would wait for them for ever.
std::atomic<pid_t> drawing_process{0};

bool forked() {
  const pid_t process = drawing_process.load();
  return process != 0 && process != getpid();
}

}  // namespace

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
