// Failures inside the library are exceptions of one type; src/capi turns them into mimo_status.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <utility>

namespace mimo {

// The numbers are those of mimo.h (asserted in src/capi/enums.cpp).
enum class Status : std::int32_t {
  kOk = 0,
  kInvalidArgument = -1,
  kBadHandle = -2,
  kBufferTooSmall = -3,
  kStructSize = -4,
  kNotFound = -5,
  kModel = -6,
  kSimulation = -7,
  kRender = -8,
  kUnsupported = -9,
  kOutOfMemory = -10,
  kForked = -11,
  kInternal = -12,
  kFile = -13,
  kTask = -14,
  kBusy = -15,
  kMismatch = -16,
  kEnd = -17,
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

}  // namespace mimo
