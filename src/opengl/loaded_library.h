// Shared libraries that somebody else has loaded into this process.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <vector>

namespace mimo::opengl {

// Path of the first loaded library whose file name starts with one of the prefixes; "" when there is none. First in
// the order of loading.
std::array<char, 4096> first_loaded(std::initializer_list<const char*> prefixes);

// Loads the first of these libraries that is there, for as long as the process lives; else null, and why the first one
// is not.
void* load_first(const std::vector<std::string>& names, std::string& why);

// A library that is already loaded, kept loaded while this lives. Empty (find gives null) when it is not loaded.
class LoadedLibrary {
 public:
  explicit LoadedLibrary(std::initializer_list<const char*> prefixes);
  ~LoadedLibrary();
  LoadedLibrary(const LoadedLibrary&) = delete;
  LoadedLibrary& operator=(const LoadedLibrary&) = delete;

  template <typename Function>
  Function find(const char* name) const {
    return reinterpret_cast<Function>(address(name));
  }

 private:
  void* address(const char* name) const;

  void* handle_ = nullptr;
};

}  // namespace mimo::opengl
