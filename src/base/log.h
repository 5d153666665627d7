// Where messages for the user go: the callback of a config. Silent by default.
#pragma once

#include <cstdint>
#include <string>

#include "base/floats.h"

namespace mimo {

enum class LogLevel : std::int32_t { kWarning = 1, kInfo = 2 };

struct LogSink {
  void (*write)(void* user, std::int32_t level, const char* message) = nullptr;
  void* user = nullptr;

  void operator()(LogLevel level, const std::string& message) const {
    if (write == nullptr) return;
    const PlainFloats plain;  // what the callback changes ends with it
    write(user, static_cast<std::int32_t>(level), message.c_str());
  }
};

}  // namespace mimo
