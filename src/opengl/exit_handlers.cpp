#include "opengl/exit_handlers.h"

#include <dlfcn.h>
#include <unistd.h>

#include <memory>
#include <mutex>
#include <new>

#include "opengl/import_slot.h"

// What atexit() is made of.
extern "C" int __cxa_atexit(void (*function)(void*), void* argument, void* library);  // NOLINT: the C library's name

namespace mimo::opengl {
namespace {

struct Handler {
  void (*function)(void*);
  void* argument;
  pid_t process;
};

// Runs once.
void run_at_home(void* argument) {
  const std::unique_ptr<const Handler> handler(static_cast<const Handler*>(argument));
  if (handler->process == getpid()) handler->function(handler->argument);
}

// From now on the process may call run_at_home at its end: unloading libmimo must leave it where it is.
void stay_loaded() {
  Dl_info self;
  if (dladdr(reinterpret_cast<void*>(run_at_home), &self) != 0) {
    dlopen(self.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
  }
}

int register_at_home(void (*function)(void*), void* argument, void* library) {
  auto* handler = new (std::nothrow) Handler{function, argument, getpid()};
  if (handler == nullptr) return -1;
  stay_loaded();
  return __cxa_atexit(run_at_home, handler, library);
}

}  // namespace

void keep_exit_handlers_from_children(const void* inside) {
  static std::once_flag once;
  std::call_once(once, [inside] {
    ImportSlot slot(inside, "__cxa_atexit");
    if (!slot.empty()) slot.exchange(reinterpret_cast<void*>(register_at_home));
  });
}

}  // namespace mimo::opengl
