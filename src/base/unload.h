// What is given back when the library is unloaded.
#pragma once

namespace mimo {

// Whether the library is being unloaded by the host (dlclose, FreeLibrary), which uses nothing of it any more. Not at
// the process's end, when other threads may still make worlds, and handles may still be destroyed; and false where the
// system does not tell the two apart.
bool is_unloading();

// To be called once something is there that an unloaded library has to give back, never while the library is loaded:
// tells the process's end from unloading for libraries that a program is linked with.
void watch_the_end();

// Calls a function while the library is unloaded. For objects with static lifetime.
class AtUnload {
 public:
  explicit constexpr AtUnload(void (*give_back)()) : give_back_(give_back) {}
  ~AtUnload() {
    if (is_unloading()) give_back_();
  }
  AtUnload(const AtUnload&) = delete;
  AtUnload& operator=(const AtUnload&) = delete;

 private:
  void (*give_back_)();
};

}  // namespace mimo
