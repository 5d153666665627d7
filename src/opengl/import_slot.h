// Where a loaded library keeps the address of a function that it imports.
#pragma once

namespace mimo::opengl {

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

}  // namespace mimo::opengl
