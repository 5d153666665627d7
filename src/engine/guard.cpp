#include "engine/guard.h"

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <mutex>

#include "compat/mujoco.h"

// Exported by MuJoCo but not declared in its headers. Weak: a build of MuJoCo may lack them. Windows has no such
// imports, and all of MuJoCo's builds for it export them.
#ifdef _WIN32
#define MIMO_MAYBE
#else
#define MIMO_MAYBE __attribute__((weak))
#endif
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the names are MuJoCo's
extern "C" {
#if MIMO_MUJOCO_4
MIMO_MAYBE mjfLogHandler _mjPRIVATE_setTlsLogHandler(mjfLogHandler handler);
#else
using mimo_mujoco_handler = void (*)(const char*);
MIMO_MAYBE mimo_mujoco_handler _mjPRIVATE__get_tls_error_fn();
MIMO_MAYBE mimo_mujoco_handler _mjPRIVATE__get_tls_warning_fn();
MIMO_MAYBE void _mjPRIVATE__set_tls_error_fn(mimo_mujoco_handler handler);
MIMO_MAYBE void _mjPRIVATE__set_tls_warning_fn(mimo_mujoco_handler handler);
#endif
}
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

namespace mimo::engine {
namespace {

struct Frame {
  std::jmp_buf jump;
  Complaint* complaint;
  Frame* outer;
};

thread_local Frame* current = nullptr;

// In one line: MuJoCo 4 writes more.
void copy_text(std::array<char, 512>& to, const char* from) {
  const std::size_t length = from == nullptr ? 0 : std::min(std::strlen(from), to.size() - 1);
  std::replace_copy(from, from + length, to.data(), '\n', ' ');
  to[length] = '\0';
}

void on_error(const char* text) {
  copy_text(current->complaint->error, text);
  std::longjmp(current->jump, 1);
}

void on_warning(const char* text) {
  if (current->complaint->warnings++ == 0) copy_text(current->complaint->warning, text);
}

// The innermost call of this thread, as long as this lives.
class Entered {
 public:
  explicit Entered(Frame& frame) {
    frame.outer = current;
    current = &frame;
  }
  ~Entered() { current = current->outer; }
  Entered(const Entered&) = delete;
  Entered& operator=(const Entered&) = delete;
};

#if MIMO_MUJOCO_4

void on_message(const mjLogMessage* message) {
  if (message->level == mjLOG_ERROR) on_error(message->subject);
  if (message->level == mjLOG_WARNING) on_warning(message->subject);
}

// Fallback for a MuJoCo without thread-local handlers: a process-wide one that chains to what the host had set.
mjfLogHandler host_handler = nullptr;

void on_global_message(const mjLogMessage* message) {
  if (current != nullptr) {
    on_message(message);
  } else if (host_handler != nullptr) {
    host_handler(message);
  }
}

void install_global_handler() {
  static std::once_flag once;
  std::call_once(once, [] { host_handler = mju_setLogHandler(on_global_message); });
}

// Puts our handler in place and gives the host's back, also when an exception passes.
class Handlers {
 public:
  Handlers() {
    if (_mjPRIVATE_setTlsLogHandler != nullptr) {
      previous_ = _mjPRIVATE_setTlsLogHandler(on_message);
    } else {
      install_global_handler();
    }
  }

  ~Handlers() {
    if (_mjPRIVATE_setTlsLogHandler != nullptr) _mjPRIVATE_setTlsLogHandler(previous_);
  }

  Handlers(const Handlers&) = delete;
  Handlers& operator=(const Handlers&) = delete;

 private:
  mjfLogHandler previous_ = nullptr;
};

#else

#ifdef _WIN32
bool has_thread_handlers() { return true; }
#else
bool has_thread_handlers() { return _mjPRIVATE__set_tls_error_fn != nullptr; }
#endif

// Fallback for a MuJoCo without thread-local handlers: process-wide ones that chain to what the host had set.
mimo_mujoco_handler host_error = nullptr;
mimo_mujoco_handler host_warning = nullptr;

void on_global_error(const char* text) {
  if (current != nullptr) on_error(text);
  if (host_error != nullptr) host_error(text);
}

void on_global_warning(const char* text) {
  if (current != nullptr) {
    on_warning(text);
  } else if (host_warning != nullptr) {
    host_warning(text);
  }
}

void install_global_handlers() {
  static std::once_flag once;
  std::call_once(once, [] {
    host_error = mju_user_error;
    host_warning = mju_user_warning;
    mju_user_error = on_global_error;
    mju_user_warning = on_global_warning;
  });
}

// Puts our handlers in place and gives the host's back, also when an exception passes.
class Handlers {
 public:
  Handlers() {
    if (!has_thread_handlers()) {
      install_global_handlers();
      return;
    }
    error_ = _mjPRIVATE__get_tls_error_fn();
    warning_ = _mjPRIVATE__get_tls_warning_fn();
    _mjPRIVATE__set_tls_error_fn(on_error);
    _mjPRIVATE__set_tls_warning_fn(on_warning);
  }

  ~Handlers() {
    if (!has_thread_handlers()) return;
    _mjPRIVATE__set_tls_error_fn(error_);
    _mjPRIVATE__set_tls_warning_fn(warning_);
  }

  Handlers(const Handlers&) = delete;
  Handlers& operator=(const Handlers&) = delete;

 private:
  mimo_mujoco_handler error_ = nullptr;
  mimo_mujoco_handler warning_ = nullptr;
};

#endif

// In a function of its own, so that no object with a destructor lives in the frame that setjmp returns to.
bool run(Frame& frame, void (*call)(void*), void* argument) {
  if (setjmp(frame.jump) != 0) return false;
  call(argument);
  return true;
}

}  // namespace

void call_guarded(void (*call)(void*), void* argument, Complaint& complaint) {
  Frame frame;
  frame.complaint = &complaint;
  const Entered entered(frame);
  const Handlers handlers;
  complaint.failed = !run(frame, call, argument);
}

}  // namespace mimo::engine
