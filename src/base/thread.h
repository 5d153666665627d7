// A thread of ours in the host's process.
#pragma once

#include <pthread.h>

namespace mimo {

// Signals that are sent to the process are the host's business: this thread takes none, from its first moment on. Its
// stack is large enough for us, also where the host's threads have small ones.
class Thread {
 public:
  using Run = void* (*)(void* argument);

  // Throws Status::kOutOfMemory when the system has no thread to give.
  Thread(Run run, void* argument);
  ~Thread() { pthread_join(thread_, nullptr); }
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

 private:
  pthread_t thread_;
};

}  // namespace mimo
