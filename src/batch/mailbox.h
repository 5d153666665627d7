// What worlds have to say while other threads step them, kept for the thread that called.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/log.h"

namespace mimo::batch {

class Mailbox {
 public:
  // Of a world of this batch.
  Mailbox(LogSink user, std::size_t world, const void* batch) : user_(user), world_(world), batch_(batch) {}

  // The sink that the world gets.
  LogSink slot();
  // Hands everything to the user's sink, on this thread.
  void deliver();

 private:
  void keep(LogLevel level, const char* text);

  LogSink user_;
  std::size_t world_;
  const void* batch_;
  std::vector<std::pair<LogLevel, std::string>> messages_;
};

}  // namespace mimo::batch
