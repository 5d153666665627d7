/**
 * @file mimo/hpp/handles.hpp
 * What all else is made of: exceptions, views, handles that free themselves. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_HANDLES
#define MIMO_HPP_HANDLES

#include <cstddef>
#include <stdexcept>
#include <utility>

#include "../experimental.h"

namespace mimo {
inline namespace v1_0 {

/// What a failed call throws: its status, and the library's message.
class Exception : public std::runtime_error {
 public:
  explicit Exception(mimo_status status) : std::runtime_error(mimo_last_error()), status_(status) {}
  mimo_status status() const noexcept { return status_; }

 private:
  mimo_status status_;
};

/// "MIMO_E_NOT_FOUND".
inline const char *status_name(mimo_status status) { return mimo_status_name(status); }

inline void check(mimo_status status) {
  if (status != MIMO_OK) throw Exception(status);
}

/// Contiguous elements that belong to somebody else.
template <typename T>
class View {
 public:
  View(T *data, std::size_t size) : data_(data), size_(size) {}
  T *data() const { return data_; }
  std::size_t size() const { return size_; }
  T *begin() const { return data_; }
  T *end() const { return data_ + size_; }
  T &operator[](std::size_t i) const { return data_[i]; }

 private:
  T *data_;
  std::size_t size_;
};

/// Owns a handle; moves, does not copy.
template <typename T, void (*Destroy)(T *)>
class Handle {
 public:
  explicit Handle(T *handle = nullptr) noexcept : handle_(handle) {}
  ~Handle() { Destroy(handle_); }
  Handle(Handle &&other) noexcept : handle_(other.release()) {}
  Handle &operator=(Handle &&other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Handle(const Handle &) = delete;
  Handle &operator=(const Handle &) = delete;

  T *get() const noexcept { return handle_; }
  T *release() noexcept {
    T *handle = handle_;
    handle_ = nullptr;
    return handle;
  }

 private:
  T *handle_;
};

}  // namespace v1_0
}  // namespace mimo

#endif
