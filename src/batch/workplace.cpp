#include "batch/workplace.h"

namespace mimo::batch {
namespace {

thread_local Workplace current;

}  // namespace

const Workplace& workplace() { return current; }

bool works_for(const void* batch) {
  const Workplace* at = &current;
  while (at != nullptr && at->batch != batch) at = at->of_caller;
  return at != nullptr;
}

AtWork::AtWork(const Workplace& at) : before_(current) { current = at; }
AtWork::~AtWork() { current = before_; }

}  // namespace mimo::batch
