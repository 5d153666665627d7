#include "batch/mailbox.h"

#include "base/format.h"
#include "batch/workplace.h"

namespace mimo::batch {

LogSink Mailbox::slot() {
  if (user_.write == nullptr) return {};
  const auto write = [](void* self, std::int32_t level, const char* text) {
    static_cast<Mailbox*>(self)->keep(static_cast<LogLevel>(level), text);
  };
  return {write, this};
}

void Mailbox::keep(LogLevel level, const char* text) {
  messages_.emplace_back(level, format("world {}: {}", world_, text));
  if (workplace().batch != batch_) deliver();  // a user works on this world alone, on a thread of their own
}

void Mailbox::deliver() {
  for (const auto& [level, text] : messages_) user_(level, text);
  messages_.clear();
}

}  // namespace mimo::batch
