#include "osmesa/library.h"

#include <dlfcn.h>

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

}  // namespace

Library load_library(const std::vector<std::string>& names) {
  void* handle = open_first(names);
  const auto look_up = [handle](auto& function, const char* name) { assign(function, dlsym(handle, name), name); };
  Library library;
  look_up(library.CreateContextExt, "OSMesaCreateContextExt");
  look_up(library.DestroyContext, "OSMesaDestroyContext");
  look_up(library.MakeCurrent, "OSMesaMakeCurrent");
  look_up(library.GetCurrentContext, "OSMesaGetCurrentContext");
  look_up(library.GetIntegerv, "OSMesaGetIntegerv");
  look_up(library.GetColorBuffer, "OSMesaGetColorBuffer");
  look_up(library.GetProcAddress, "OSMesaGetProcAddress");
  keep_exit_handlers_from_children(reinterpret_cast<const void*>(library.CreateContextExt));
  return library;
}

}  // namespace mimo::osmesa
