#include "base/signals.h"

namespace mimo {

// Windows sends no signals to threads.
struct SignalsBlocked::Mask {};

SignalsBlocked::SignalsBlocked() = default;
SignalsBlocked::~SignalsBlocked() = default;

}  // namespace mimo
