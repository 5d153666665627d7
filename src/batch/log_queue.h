// What worlds have to say while other threads step them, kept for the thread that called.
#pragma once

#include <vector>

#include "base/log.h"

namespace mimo::batch {

class LogQueue {
 public:
  // Of a world of this batch.
  LogQueue(LogSink user, const void* batch) : user_(std::move(user)), batch_(batch) {}

  // The sink that the world gets.
  LogSink slot();
  // Hands everything to the user's sink, on this thread.
  void deliver();

 private:
  void keep(const LogRecord& record);

  LogSink user_;
  const void* batch_;
  std::vector<LogRecord> records_;
};

}  // namespace mimo::batch
