#include "capi/guard.h"

#include <cstring>

namespace mimo::capi {
namespace {

// Plain bytes: keeping a message must work when memory is out, and needs no destructor when a thread ends.
thread_local char last_error[1024] = "";
constexpr char kEnd[] = " ...";

// Where to cut a text that is too long: before the last word that does not fit; in a very long one between letters.
std::size_t cut_of(const char* text, std::size_t room) {
  constexpr std::size_t kLongWord = 100;
  for (std::size_t cut = room; cut + kLongWord > room; --cut) {
    if (text[cut] == ' ') return cut;
  }
  while ((text[room] & 0xC0) == 0x80) --room;  // not within a letter of UTF-8
  return room;
}

}  // namespace

void set_last_error(const char* message) noexcept {
  const std::size_t length = std::strlen(message);
  if (length < sizeof last_error) {
    std::memcpy(last_error, message, length + 1);
    return;
  }
  const std::size_t cut = cut_of(message, sizeof last_error - sizeof kEnd);
  std::memcpy(last_error, message, cut);
  std::memcpy(last_error + cut, kEnd, sizeof kEnd);
}

mimo_status report(Status status, const char* message) noexcept {
  set_last_error(message);
  return static_cast<mimo_status>(status);
}

}  // namespace mimo::capi

extern "C" const char* mimo_last_error(void) noexcept { return mimo::capi::last_error; }
