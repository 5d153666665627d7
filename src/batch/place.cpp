#include "batch/place.h"

namespace mimo::batch {
namespace {

thread_local Place current;

}  // namespace

const Place& place() { return current; }

bool works_for(const void* batch) {
  const Place* at = &current;
  while (at != nullptr && at->batch != batch) at = at->of_caller;
  return at != nullptr;
}

AtPlace::AtPlace(const Place& at) : before_(current) { current = at; }
AtPlace::~AtPlace() { current = before_; }

}  // namespace mimo::batch
