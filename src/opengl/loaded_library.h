// Shared libraries that the host or somebody else has loaded into this process, and the functions that they import.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <vector>

namespace mimo::opengl {

// Shared libraries that somebody else has loaded into this process.

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

// Where a loaded library keeps the address of a function that it imports.

class ImportSlot {
 public:
  // Of the library that holds the address `inside`. Empty when there is no such import, or where the dynamic linker's
  // tables are not those of 64-bit glibc.
  ImportSlot(const void* inside, const char* function);

  bool empty() const { return place_ == nullptr; }

  // Lets the library call something else; gives what it called before, null when the slot cannot be written.
  void* exchange(void* function);

  // Used by the search, which is a callback of C.
  struct Search;

 private:
  void** place_ = nullptr;
  bool read_only_ = false;  // write-protected by the dynamic linker after loading
};

// Mesa ends its threads by a function that exit() calls. In a forked child these threads do not exist, and it crashes
// or waits for ever.

// What the library that holds the address `inside` registers from now on for the end of the process is run in the
// process that registered it, and not in its children. As far as the dynamic linker's tables can be read.
void keep_exit_handlers_from_children(const void* inside);

}  // namespace mimo::opengl
