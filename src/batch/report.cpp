#include "batch/report.h"

namespace mimo::batch {

void Report::note(Status what, const char* why) noexcept {
  status = what;
  try {
    message = why;
  } catch (...) {
    message.clear();
  }
}

}  // namespace mimo::batch
