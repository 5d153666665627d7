#include "senses/touch/options.h"

#include "base/fail.h"

namespace mimo::senses {

// Both are fields of one name.
void check_outputs(const TouchOptions& options) {
  constexpr std::uint32_t kBoth = MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE;
  require((options.wanted & kBoth) != kBoth,
          "touch is {:#x}: MIMO_TOUCH_FORCE and MIMO_TOUCH_NORMAL_FORCE exclude each other", options.wanted);
}

}  // namespace mimo::senses
