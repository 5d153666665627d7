// Versioned structs: they begin with struct_size and only ever grow at the end.
#pragma once

#include <algorithm>
#include <cstring>

#include "base/fail.h"
#include "mimo/experimental.h"

namespace mimo::capi {

// The size that a struct had in its first version; smaller ones never existed.
template <typename T>
struct FirstSize {
  static constexpr std::size_t kBytes = sizeof(T);
};
#define MIMO_FIRST_SIZE(type, bytes)                               \
  template <>                                                      \
  struct FirstSize<type> {                                         \
    static_assert(bytes <= sizeof(type), #type " became smaller"); \
    static constexpr std::size_t kBytes = bytes;                   \
  }
#ifndef __wasm32__  // a module of WebAssembly and what calls it travel together
#include "capi/first_sizes.h"
#endif
#undef MIMO_FIRST_SIZE

template <typename T>
void check_struct_size(std::size_t size, const char* argument) {
  constexpr std::size_t kLargest = 4096;  // beyond any version: memory that was never initialised
  if (size < FirstSize<T>::kBytes || size > kLargest) {
    fail(Status::kStructSize, "{}: struct_size is {}, expected {}, the struct's sizeof", argument, size, sizeof(T));
  }
}

// What a caller of a newer interface has beyond our struct must be zero, which means what we do.
template <typename T>
void check_tail(const T* theirs, std::size_t size, const char* argument) {
  if (size <= sizeof(T)) return;
  const auto* bytes = reinterpret_cast<const unsigned char*>(theirs);
  if (std::all_of(bytes + sizeof(T), bytes + size, [](unsigned char byte) { return byte == 0; })) return;
  fail(Status::kUnsupported, "{}: it has members beyond its first {} bytes that need an interface newer than {}.{}",
       argument, sizeof(T), MIMO_API_MAJOR, MIMO_API_MINOR);
}

// A caller's struct. Members that the caller does not know are zero, which is the old behaviour.
template <typename T>
T read_struct(const T* theirs, const char* argument) {
  const std::size_t size = theirs->struct_size;
  check_struct_size<T>(size, argument);
  check_tail(theirs, size, argument);
  T ours{};
  std::memcpy(&ours, theirs, std::min(size, sizeof(T)));
  ours.struct_size = sizeof(T);
  return ours;
}

// The same for one that may be NULL, which means the defaults.
template <typename T>
T read_struct(const T* theirs, const T& defaults, const char* argument) {
  return theirs == nullptr ? defaults : read_struct(theirs, argument);
}

// Fills the first `size` bytes of a caller's struct, as much as we know of it, and zeros beyond.
template <typename T>
void fill_struct(T* theirs, std::size_t size, const T& ours, const char* argument) {
  require(theirs != nullptr, "{} is NULL", argument);
  check_struct_size<T>(size, argument);
  auto* bytes = reinterpret_cast<unsigned char*>(theirs);
  const std::size_t known = std::min(size, sizeof(T));
  std::memcpy(bytes, &ours, known);
  std::fill(bytes + known, bytes + size, static_cast<unsigned char>(0));
}

// A config with its defaults. It keeps the caller's size, so that what they set beyond ours is seen and refused.
template <typename T>
void write_struct(T* theirs, std::size_t size, const T& ours, const char* argument) {
  fill_struct(theirs, size, ours, argument);
  theirs->struct_size = static_cast<std::uint32_t>(size);
}

// A description, whose size the caller has put into struct_size. It says afterwards how much of it was filled.
template <typename T>
void write_described(T* theirs, const T& ours, const char* argument) {
  require(theirs != nullptr, "{} is NULL", argument);
  const std::size_t size = theirs->struct_size;
  fill_struct(theirs, size, ours, argument);
  theirs->struct_size = static_cast<std::uint32_t>(std::min(size, sizeof(T)));
}

// A struct that is read and filled. It keeps the caller's size, as it may be handed in again as it is.
template <typename T>
void write_back(T* theirs, const T& ours, const char* argument) {
  write_struct(theirs, theirs->struct_size, ours, argument);
}

}  // namespace mimo::capi
