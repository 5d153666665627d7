#include "capi/guard.h"

#include <algorithm>
#include <cstring>

#include "base/format.h"
#include "capi/check.h"
#include "capi/handle.h"

namespace mimo::capi {
namespace {

thread_local LastError last;
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

void keep(const char* message) {
  const std::size_t length = std::strlen(message);
  if (length < last.text.size()) {
    std::memcpy(last.text.data(), message, length + 1);
    return;
  }
  const std::size_t cut = cut_of(message, last.text.size() - sizeof kEnd);
  std::memcpy(last.text.data(), message, cut);
  std::memcpy(last.text.data() + cut, kEnd, sizeof kEnd);
}

}  // namespace

const LastError& last_error() noexcept { return last; }

mimo_status report(const void* handle, Status status, const char* message) noexcept {
  last.status = static_cast<mimo_status>(status);
  keep(message);
  // Of another library's exception; it needs no memory.
  std::replace_if(
      last.text.begin(), last.text.end(), [](char c) { return (c > 0 && c < ' ') || c == 0x7F; }, '?');
  keep_message(handle, last.text);
  return last.status;
}

FreshError::FreshError() noexcept : before_(last) { last = LastError(); }
FreshError::~FreshError() { last = before_; }

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

const char* mimo_last_error(void) noexcept { return last.text.data(); }

// Its own failures leave the handle's message alone.
mimo_status mimo_last_error_of(const void* handle, char* text, size_t capacity, size_t* length) noexcept {
  return guard([&] {
    const Message message = message_of(handle);
    const std::size_t bytes = std::strlen(message.data());
    check_buffer(text, capacity, bytes + 1, "text");
    if (text != nullptr) std::memcpy(text, message.data(), bytes + 1);
    if (length != nullptr) *length = bytes;
  });
}

mimo_status mimo_fail(mimo_status status, const char* message) noexcept {
  return guard([&] {
    require(status < 0, "status is {}, expected a MIMO_E_ constant, {} to {}", status, kLastStatus,
            MIMO_E_INVALID_ARGUMENT);
    check_choice(status, kLastStatus, MIMO_E_INVALID_ARGUMENT, "status");
    require(message != nullptr, "message is NULL");
    throw Error(static_cast<Status>(status), as_line(message));
  });
}

}  // extern "C"
