// Errors: exceptions with a status and a formatted message of one line, and the checks that throw them.
#pragma once

// The small part of fmt; format.cpp has the rest. Most of a file's compile time hangs on this.
#include <fmt/core.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "mimo/status.h"

namespace mimo {

// Failures inside the library are exceptions of one type; src/capi turns them into mimo_status.

// Of the header.
enum class Status : mimo_status {
  kOk = MIMO_OK,
  kInvalidArgument = MIMO_E_INVALID_ARGUMENT,
  kBadHandle = MIMO_E_BAD_HANDLE,
  kBufferTooSmall = MIMO_E_BUFFER_TOO_SMALL,
  kStructSize = MIMO_E_STRUCT_SIZE,
  kNotFound = MIMO_E_NOT_FOUND,
  kModel = MIMO_E_MODEL,
  kSimulation = MIMO_E_SIMULATION,
  kRender = MIMO_E_RENDER,
  kUnsupported = MIMO_E_UNSUPPORTED,
  kOutOfMemory = MIMO_E_OUT_OF_MEMORY,
  kForked = MIMO_E_FORKED,
  kInternal = MIMO_E_INTERNAL,
  kFile = MIMO_E_FILE,
  kTask = MIMO_E_TASK,
  kBusy = MIMO_E_BUSY,
  kMismatch = MIMO_E_MISMATCH,
  kEnd = MIMO_E_END,
};

class Error : public std::exception {
 public:
  Error(Status status, std::string message) : status_(status), message_(std::move(message)) {}

  Status status() const { return status_; }
  const std::string& message() const { return message_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  Status status_;
  std::string message_;
};

// fail(status, "size {} of {}", a, b): throws an Error with a formatted message.

[[noreturn]] void fail_formatted(Status status, fmt::string_view format, fmt::format_args arguments);

template <typename... Args>
[[noreturn]] void fail(Status status, fmt::format_string<Args...> format, Args&&... args) {
  fail_formatted(status, format, fmt::make_format_args(args...));
}

// The commonest check: an argument that is not what was expected.
template <typename... Args>
void require(bool condition, fmt::format_string<Args...> format, Args&&... args) {
  if (!condition) fail_formatted(Status::kInvalidArgument, format, fmt::make_format_args(args...));
}

// A number that is out of its range, or no number. `unit` is told behind the range, as " seconds".
template <typename T>
void require_between(T value, T low, T high, const char* argument, const char* unit = "") {
  require(value >= low && value <= high, "{} is {}, expected {} to {}{}", argument, value, low, high, unit);
}

// check_finite(values, count, "action"): refuses numbers that are not finite.

inline void check_finite(const double* values, std::size_t count, const char* argument) {
  for (std::size_t i = 0; i < count; ++i) {
    require(std::isfinite(values[i]), "{}[{}] is {}, expected a finite number", argument, i, values[i]);
  }
}

// What a message says of a name that is not there.

// "there are: a, b", and before that which of them may have been meant: a name that begins otherwise ("left_elbow" for
// "robot:left_elbow"), or a letter or two apart.
std::string choice_of(const std::string& wanted, std::vector<std::string> names);

// Where no exception may pass.

// Calls work(), and failed(status, text) with what it throws.
template <typename Work, typename Failed>
void caught(Work&& work, Failed&& failed) noexcept {
  try {
    work();
  } catch (const Error& error) {
    failed(error.status(), error.what());
  } catch (const std::bad_alloc&) {
    failed(Status::kOutOfMemory, "out of memory");
  } catch (const std::exception& error) {
    failed(Status::kInternal, error.what());
  } catch (...) {
    failed(Status::kInternal, "an unknown exception");
  }
}

}  // namespace mimo
