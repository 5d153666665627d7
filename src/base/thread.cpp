#include "base/thread.h"

#include <algorithm>
#include <cstddef>
#include <system_error>

#include "base/fail.h"
#include "base/signals.h"

namespace mimo {
namespace {

constexpr std::size_t kLeastStack = 512 * 1024;

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
  const SignalsBlocked signals;  // a new thread inherits the mask of the one that starts it
  const int error = pthread_create(&thread_, attributes.get(), run, argument);
  if (error == 0) return;
  fail(Status::kOutOfMemory, "the system gives no thread: {}", std::generic_category().message(error));
}

}  // namespace mimo
