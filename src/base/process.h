// What the process shares with the library's host: fork(), signals, unloading, and the locale of numbers.
#pragma once

#include <memory>

namespace mimo {

// What is to happen around fork(), on systems that have it.

// Registers functions for the length of the library's life, as pthread_atfork does; each may be null.
int watch_forks(void (*before)(), void (*in_parent)(), void (*in_child)());

// Signals that are sent to the process are the host's business, not that of our threads.

// While this lives, the calling thread takes no signal, nor does any that it starts. Faults are not blocked: they are
// errors of a thread's own. Nor are signals by which managed runtimes stop each thread that has run their code, as
// tasks of the user's own may be.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  struct Mask;
  std::unique_ptr<Mask> before_;
};

// What is given back when the library is unloaded.

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

// Numbers in texts have a decimal point, whatever the host's locale says.

// While this lives, C functions on this thread have the locale "C", also those that MuJoCo calls. Other threads keep
// theirs.
class PlainNumbers {
 public:
  PlainNumbers();
  ~PlainNumbers();
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;

 private:
  struct Locale;
  std::unique_ptr<Locale> before_;
};

}  // namespace mimo
