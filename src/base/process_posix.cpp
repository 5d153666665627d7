#include <locale.h>
#include <pthread.h>
#include <signal.h>

#include <atomic>
#include <cstdlib>
#include <initializer_list>

#include "base/process.h"

#ifdef __APPLE__
#include <xlocale.h>
#endif

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

bool unloading = false, ending = false;
std::atomic_flag watched = ATOMIC_FLAG_INIT;

#ifdef __ELF__
// When a library is unloaded, functions like this one run before the destructors of static objects, and before what was
// given to atexit(): those are called by the first entry of the list that this function stands in, and the list is run
// backwards. When the process ends, exit() calls first what came last. The lists of libraries that the program is
// linked with come after what the program's run gave to atexit(), and before the destructors of their static objects.
__attribute__((destructor)) void begin() { unloading = true; }
#endif

}  // namespace

int watch_forks(void (*before)(), void (*in_parent)(), void (*in_child)()) {
  return pthread_atfork(before, in_parent, in_child);
}

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

bool is_unloading() { return unloading && !ending; }

void watch_the_end() {
  if (!watched.test_and_set()) std::atexit([] { ending = !unloading; });
}

struct PlainNumbers::Locale {
  locale_t plain, previous;
};

PlainNumbers::PlainNumbers() : before_(std::make_unique<Locale>()) {
  before_->plain = newlocale(LC_ALL_MASK, "C", nullptr);
  before_->previous = uselocale(before_->plain);
}

PlainNumbers::~PlainNumbers() {
  uselocale(before_->previous);
  if (before_->plain != nullptr) freelocale(before_->plain);
}

}  // namespace mimo
