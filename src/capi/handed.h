// What the library hands to the host's functions: structs, which may be of a newer interface, and log messages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

#include "base/format.h"
#include "base/log.h"
#include "mimo/log.h"

namespace mimo::capi {

// Structs that the library hands to functions of the host's, which may be of a newer interface.

// The header promises this many bytes, zero where our struct has none: a newer function may read and write them.
constexpr std::size_t kHandedBytes = 256;

// Zero, except the struct's size.
template <typename T>
class Handed {
 public:
  Handed() { ours_.struct_size = sizeof(T); }
  Handed(const Handed&) = delete;
  Handed& operator=(const Handed&) = delete;

  T* operator->() { return &ours_; }
  T& operator*() { return ours_; }
  // With all the room behind it.
  T* get() { return reinterpret_cast<T*>(this); }
  // Where a newer function has set a member that we do not have; 0 where it has set none.
  std::size_t newer_at() const {
    const auto* set = std::find_if(std::begin(room_), std::end(room_), [](unsigned char byte) { return byte != 0; });
    return set == std::end(room_) ? 0 : sizeof(T) + static_cast<std::size_t>(set - room_);
  }

 private:
  static_assert(sizeof(T) < kHandedBytes, "there is no room left for newer members");

  T ours_{};
  unsigned char room_[kHandedBytes - sizeof(T)]{};
};

// Messages, from the rooms' records to the public one.

inline LogSink log_sink(mimo_log_fn write, void* user) {
  if (write == nullptr) return {};
  return LogSink([write, user](const LogRecord& record) {
    Handed<mimo_log_record> ours;
    ours->level = static_cast<std::int32_t>(record.level);
    ours->code = record.code;
    ours->in_world = record.in_world ? 1 : 0;
    const std::string text = as_line(record.text);
    ours->text = text.c_str();
    ours->world = record.world;
    ours->time = record.time;
    write(user, ours.get());
  });
}

}  // namespace mimo::capi
