#include <dlfcn.h>

#include "libraries.h"

namespace cli {

void* open_library(const char* name) { return dlopen(name, RTLD_NOW | RTLD_LOCAL); }

void* find_symbol(void* library, const char* name) { return dlsym(library, name); }

std::string library_of(const void* inside) {
  Dl_info info = {};
  return dladdr(inside, &info) == 0 ? "" : info.dli_fname;
}

}  // namespace cli
