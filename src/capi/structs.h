// Versioned structs: they begin with struct_size and only ever grow at the end.
#pragma once

#include <algorithm>
#include <cstring>

#include "base/fail.h"
#include "mimo/mimo.h"

namespace mimo::capi {

// The size that a struct had in the first version of the interface that is kept; smaller ones never existed. For
// structs of that version it stands in first_sizes.h, so that they may grow; later ones name theirs there when they do.
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
#include "capi/first_sizes.h"
#undef MIMO_FIRST_SIZE

template <typename T>
void check_struct_size(std::size_t size, const char* argument) {
  constexpr std::size_t kLargest = 4096;  // beyond any version: memory that was never initialised
  if (size < FirstSize<T>::kBytes || size > kLargest) {
    fail(Status::kStructSize, "{}: struct_size is {}, expected {}, the struct's sizeof", argument, size, sizeof(T));
  }
}

// A caller's struct over our defaults. What we do not know of it must be zero.
template <typename T>
T read_struct(const T* theirs, const T& defaults, const char* argument) {
  if (theirs == nullptr) return defaults;
  const std::size_t size = theirs->struct_size;
  check_struct_size<T>(size, argument);
  const auto* bytes = reinterpret_cast<const unsigned char*>(theirs);
  const std::size_t known = std::min(size, sizeof(T));
  if (std::any_of(bytes + known, bytes + size, [](unsigned char byte) { return byte != 0; })) {
    fail(Status::kStructSize, "{}: it has fields that this version ({} bytes) does not know, and they are not zero",
         argument, sizeof(T));
  }
  T ours = defaults;
  std::memcpy(&ours, bytes, known);
  ours.struct_size = sizeof(T);
  return ours;
}

// Fills a caller's struct of `size` bytes; a tail that we do not know becomes zero.
template <typename T>
void write_struct(T* theirs, std::size_t size, const T& ours, const char* argument) {
  require(theirs != nullptr, "{} is NULL", argument);
  check_struct_size<T>(size, argument);
  auto* bytes = reinterpret_cast<unsigned char*>(theirs);
  const std::size_t known = std::min(size, sizeof(T));
  std::memcpy(bytes, &ours, known);
  std::fill(bytes + known, bytes + size, static_cast<unsigned char>(0));
  theirs->struct_size = static_cast<std::uint32_t>(size);
}

// The same for descriptions, whose size the caller has put into struct_size.
template <typename T>
void write_described(T* theirs, const T& ours, const char* argument) {
  require(theirs != nullptr, "{} is NULL", argument);
  write_struct(theirs, theirs->struct_size, ours, argument);
}

}  // namespace mimo::capi
