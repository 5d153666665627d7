#include <signal.h>

#include <initializer_list>

#include "base/signals.h"

namespace mimo {
namespace {

// Mono and .NET take real-time ones, older collectors SIGPWR and SIGXCPU.
void leave_to_runtimes(sigset_t& signals) {
#ifdef SIGRTMIN  // macOS has neither
  for (int runtimes = SIGRTMIN; runtimes <= SIGRTMAX; ++runtimes) sigdelset(&signals, runtimes);
  sigdelset(&signals, SIGPWR);
#endif
  sigdelset(&signals, SIGXCPU);
}

}  // namespace

struct SignalsBlocked::Mask {
  sigset_t signals;
};

SignalsBlocked::SignalsBlocked() : before_(std::make_unique<Mask>()) {
  sigset_t signals;
  sigfillset(&signals);
  leave_to_runtimes(signals);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS}) sigdelset(&signals, fault);
  pthread_sigmask(SIG_BLOCK, &signals, &before_->signals);
}

SignalsBlocked::~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_->signals, nullptr); }

}  // namespace mimo
