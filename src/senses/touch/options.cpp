#include "senses/touch/options.h"

#include "base/fail.h"

namespace mimo::senses {
namespace {

// As mimo.h numbers them (MIMO_TOUCH_FORCE ...).
unsigned outputs(const TouchOptions& options) {
  return (options.force ? 1U : 0U) | (options.normal_force ? 2U : 0U) | (options.slip ? 4U : 0U) |
         (options.friction_use ? 8U : 0U);
}

}  // namespace

// Both are fields of one name.
void check_outputs(const TouchOptions& options) {
  require(!(options.force && options.normal_force),
          "touch is {:#x}: MIMO_TOUCH_FORCE and MIMO_TOUCH_NORMAL_FORCE exclude each other", outputs(options));
}

}  // namespace mimo::senses
