// MuJoCo reports trouble by mju_error, whose default prints and exits, and by mju_warning, whose default
// appends to a file. The guard catches both, on this thread, for the length of one call.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace mimo::engine {

// What MuJoCo said during one guarded call.
struct Complaint {
  // The texts are not zeroed beyond their first byte: this lies on the path of every step.
  Complaint() { error[0] = warning[0] = '\0'; }

  bool failed = false;            // mju_error was raised and the call did not finish
  int warnings = 0;               // number of mju_warning calls
  std::array<char, 512> error;    // text of the error
  std::array<char, 512> warning;  // text of the first warning
};

// Runs `call(argument)` with MuJoCo's errors and warnings caught. After an mju_error its frame, and all that it called,
// is left by longjmp: whatever lives across a call of MuJoCo must need no destructor. C++ exceptions (the XML loader
// lets std::bad_alloc out) pass through.
void call_guarded(void (*call)(void*), void* argument, Complaint& complaint);

template <typename Call>
Complaint guarded(Call&& call) {
  using Plain = std::remove_reference_t<Call>;
  static_assert(std::is_trivially_destructible_v<Plain>, "what lives across a longjmp must need no destructor");
  Complaint complaint;
  call_guarded([](void* argument) { (*static_cast<Plain*>(argument))(); }, &call, complaint);
  return complaint;
}

}  // namespace mimo::engine
