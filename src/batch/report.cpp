#include "batch/report.h"

#include "base/utf8.h"

namespace mimo::batch {

void Report::note(Status what, const char* why) noexcept {
  status = what;
  try {
    message = as_line(why);
  } catch (...) {
    message.clear();
  }
}

}  // namespace mimo::batch
