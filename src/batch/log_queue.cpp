#include "batch/log_queue.h"

#include "batch/current_thread.h"

namespace mimo::batch {

LogSink LogQueue::slot() {
  if (!user_) return {};
  return LogSink([this](const LogRecord& record) { keep(record); });
}

void LogQueue::keep(const LogRecord& record) {
  records_.push_back(record);
  if (current_thread().batch != batch_) deliver();  // a user works on this world alone, on a thread of their own
}

void LogQueue::deliver() {
  for (const LogRecord& record : records_) user_(record);
  records_.clear();
}

}  // namespace mimo::batch
