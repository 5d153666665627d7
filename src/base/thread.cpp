#include "base/thread.h"

#include <signal.h>

#include <algorithm>
#include <cstddef>
#include <system_error>

#include "base/fail.h"

namespace mimo {
namespace {

constexpr std::size_t kLeastStack = 512 * 1024;

// A new thread inherits the mask of the one that starts it. Faults are not blocked: they are errors of this thread's
// own. Nor are signals by which managed runtimes stop each thread that has run their code, as tasks of the user's own
// may be: Mono and .NET take real-time ones, older collectors SIGPWR and SIGXCPU.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t signals;
    sigfillset(&signals);
    for (int runtimes = SIGRTMIN; runtimes <= SIGRTMAX; ++runtimes) sigdelset(&signals, runtimes);
    for (const int runtimes : {SIGPWR, SIGXCPU}) sigdelset(&signals, runtimes);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS}) sigdelset(&signals, fault);
    pthread_sigmask(SIG_BLOCK, &signals, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

// The default is the limit of the shell that the host was started from, which may be anything.
class Attributes {
 public:
  Attributes() {
    std::size_t stack = 0;
    pthread_attr_init(&attributes_);
    pthread_attr_getstacksize(&attributes_, &stack);
    pthread_attr_setstacksize(&attributes_, std::max(stack, kLeastStack));
  }
  ~Attributes() { pthread_attr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const pthread_attr_t* get() const { return &attributes_; }

 private:
  pthread_attr_t attributes_;
};

}  // namespace

Thread::Thread(Run run, void* argument) {
  const Attributes attributes;
  const SignalsBlocked signals;
  const int error = pthread_create(&thread_, attributes.get(), run, argument);
  if (error == 0) return;
  fail(Status::kOutOfMemory, "the system gives no thread: {}", std::generic_category().message(error));
}

}  // namespace mimo
