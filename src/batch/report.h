// What became of a world in the last call that concerned it.
#pragma once

#include <string>

#include "base/status.h"

namespace mimo::batch {

struct Report {
  Status status = Status::kOk;
  std::string message;
  bool settled = false;  // it failed, and was or will be restarted as configured

  // Without the message where no memory is left for it.
  void note(Status what, const char* why) noexcept;
};

}  // namespace mimo::batch
