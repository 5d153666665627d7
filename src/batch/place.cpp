#include "batch/place.h"

namespace mimo::batch {
namespace {

thread_local Place current;

}  // namespace

const Place& place() { return current; }

AtPlace::AtPlace(const Place& at) : before_(current) { current = at; }
AtPlace::~AtPlace() { current = before_; }

}  // namespace mimo::batch
