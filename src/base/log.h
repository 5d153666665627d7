// Where messages for the user go: the callback of a config. Silent by default.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "base/processor.h"
#include "mimo/log.h"

namespace mimo {

enum class LogLevel : std::int32_t { kWarning = MIMO_LOG_WARNING, kInfo = MIMO_LOG_INFO };

struct LogRecord {
  LogLevel level;
  std::string text;
  int code = 0;  // of an engine::Warning, where physics warns
  bool in_world = false;
  std::size_t world = 0;  // its number in its batch
  double time = 0;        // of the world, in seconds
};

class LogSink {
 public:
  using Write = std::function<void(const LogRecord&)>;

  LogSink() = default;
  explicit LogSink(Write write) : write_(std::move(write)) {}

  // Whether anybody listens.
  explicit operator bool() const { return static_cast<bool>(write_); }

  void operator()(const LogRecord& record) const {
    if (!write_) return;
    const PlainFloats plain;  // what the callback changes ends with it
    write_(record);
  }
  // A message of no world.
  void operator()(LogLevel level, const std::string& text) const { (*this)(LogRecord{level, text}); }

 private:
  Write write_;
};

}  // namespace mimo
