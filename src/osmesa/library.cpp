#include "osmesa/library.h"

#include <dlfcn.h>

#include "base/fail.h"
#include "osmesa/exit_handlers.h"

namespace mimo::osmesa {
namespace {

void* open_first(const std::vector<std::string>& names) {
  std::string why;
  for (const std::string& name : names) {
    // RTLD_LOCAL: with its 1300 gl* functions in the global scope, OSMesa would take the place of the OpenGL that
    // libraries loaded later by the host mean.
    if (void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) return handle;
    if (why.empty()) why = dlerror();
  }
  fail(Status::kUnsupported,
       "the renderer osmesa needs the library OSMesa (Debian package libosmesa6), which cannot be loaded: {}", why);
}

template <typename Function>
void look_up(void* handle, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(handle, name));
  if (function == nullptr) fail(Status::kUnsupported, "the installed OSMesa has no function {}", name);
}

}  // namespace

Library load_library(const std::vector<std::string>& names) {
  void* handle = open_first(names);
  Library library;
  look_up(handle, "OSMesaCreateContextExt", library.CreateContextExt);
  look_up(handle, "OSMesaDestroyContext", library.DestroyContext);
  look_up(handle, "OSMesaMakeCurrent", library.MakeCurrent);
  look_up(handle, "OSMesaGetCurrentContext", library.GetCurrentContext);
  look_up(handle, "OSMesaGetIntegerv", library.GetIntegerv);
  look_up(handle, "OSMesaGetColorBuffer", library.GetColorBuffer);
  look_up(handle, "OSMesaGetProcAddress", library.GetProcAddress);
  keep_exit_handlers_from_children(reinterpret_cast<const void*>(library.CreateContextExt));
  return library;
}

}  // namespace mimo::osmesa
