// Failures inside the library are exceptions of one type; src/capi turns them into mimo_status.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <utility>

#include "mimo/status.h"

namespace mimo {

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

}  // namespace mimo
