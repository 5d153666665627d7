// Signals that are sent to the process are the host's business, not that of our threads.
#pragma once

#include <memory>

namespace mimo {

// While this lives, the calling thread takes no signal, nor does any that it starts. Faults are not blocked: they are
// errors of a thread's own. Nor are signals by which managed runtimes stop each thread that has run their code, as
// tasks of the user's own may be.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  struct Mask;
  std::unique_ptr<Mask> before_;
};

}  // namespace mimo
