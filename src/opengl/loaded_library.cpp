#include "opengl/loaded_library.h"

#include <dlfcn.h>
#include <link.h>

#include <cstdio>
#include <cstring>

namespace mimo::opengl {
namespace {

struct Search {
  std::initializer_list<const char*> prefixes;
  std::array<char, 4096> path{};
};

const char* file_name(const char* path) {
  const char* slash = std::strrchr(path, '/');
  return slash == nullptr ? path : slash + 1;
}

int visit(dl_phdr_info* info, std::size_t, void* argument) {
  Search& search = *static_cast<Search*>(argument);
  for (const char* prefix : search.prefixes) {
    if (std::strncmp(file_name(info->dlpi_name), prefix, std::strlen(prefix)) != 0) continue;
    std::snprintf(search.path.data(), search.path.size(), "%s", info->dlpi_name);
    return 1;  // ends the iteration
  }
  return 0;
}

}  // namespace

std::array<char, 4096> first_loaded(std::initializer_list<const char*> prefixes) {
  Search search;
  search.prefixes = prefixes;
  dl_iterate_phdr(visit, &search);
  return search.path;
}

void* load_first(const std::vector<std::string>& names, std::string& why) {
  for (const std::string& name : names) {
    // RTLD_LOCAL: with its 1300 gl* functions in the global scope, OSMesa would take the place of the OpenGL that
    // libraries loaded later by the host mean.
    if (void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) return handle;
    if (why.empty()) why = dlerror();
  }
  return nullptr;
}

LoadedLibrary::LoadedLibrary(std::initializer_list<const char*> prefixes) {
  // Asking dlopen alone (RTLD_NOLOAD) would search the file system in every picture of a process without it.
  const std::array<char, 4096> path = first_loaded(prefixes);
  if (path[0] != '\0') handle_ = dlopen(path.data(), RTLD_LAZY | RTLD_NOLOAD);
}

LoadedLibrary::~LoadedLibrary() {
  if (handle_ != nullptr) dlclose(handle_);
}

void* LoadedLibrary::address(const char* name) const { return handle_ == nullptr ? nullptr : dlsym(handle_, name); }

}  // namespace mimo::opengl
