// Messages, from the rooms' records to the public one.
#pragma once

#include <string>

#include "base/log.h"
#include "base/utf8.h"
#include "capi/handed.h"
#include "mimo/log.h"

namespace mimo::capi {

inline LogSink log_sink(mimo_log_fn write, void* user) {
  if (write == nullptr) return {};
  return LogSink([write, user](const LogRecord& record) {
    Handed<mimo_log_record> ours;
    ours->level = static_cast<std::int32_t>(record.level);
    ours->code = record.code;
    ours->in_world = record.in_world ? 1 : 0;
    const std::string text = as_line(record.text);
    ours->text = text.c_str();
    ours->world = record.world;
    ours->time = record.time;
    write(user, ours.get());
  });
}

}  // namespace mimo::capi
