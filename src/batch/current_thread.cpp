#include "batch/current_thread.h"

namespace mimo::batch {
namespace {

thread_local CurrentThread current;

}  // namespace

const CurrentThread& current_thread() { return current; }

bool works_for(const void* batch) {
  const CurrentThread* at = &current;
  while (at != nullptr && at->batch != batch) at = at->of_caller;
  return at != nullptr;
}

AtWork::AtWork(const CurrentThread& at) : before_(current) { current = at; }
AtWork::~AtWork() { current = before_; }

}  // namespace mimo::batch
