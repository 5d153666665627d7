#include "base/processor.h"

namespace mimo {

#if defined(__x86_64__)
namespace {

// fegetenv and its like take a hundred times as long as looking first, and this is on the path of every call.
constexpr std::uint32_t kSseControl = 0xffc0;  // all but the flags
constexpr std::uint32_t kSsePlain = 0x1f80;
constexpr std::uint16_t kX87Plain = 0x037f;
constexpr std::uint16_t kX87Pending = 0x0080;
constexpr std::uint16_t kX87Flags = 0x80ff;  // with the two that sum them up

std::uint32_t sse() {
  std::uint32_t value;
  __asm__ volatile("stmxcsr %0" : "=m"(value) : : "memory");
  return value;
}

void set_sse(std::uint32_t value) { __asm__ volatile("ldmxcsr %0" : : "m"(value) : "memory"); }

std::uint16_t x87_control() {
  std::uint16_t value;
  __asm__ volatile("fnstcw %0" : "=m"(value) : : "memory");
  return value;
}

void set_x87_control(std::uint16_t value) { __asm__ volatile("fldcw %0" : : "m"(value) : "memory"); }

std::uint16_t x87_status() {
  std::uint16_t value;
  __asm__ volatile("fnstsw %0" : "=a"(value) : : "memory");
  return value;
}

void set_x87_flags(std::uint16_t status) {
  struct {
    std::uint32_t control, status, others[5];
  } all;
  __asm__ volatile("fnstenv %0" : "=m"(all) : : "memory");
  all.status = (all.status & ~std::uint32_t{kX87Flags}) | (status & kX87Flags);
  all.control = (all.control & 0xffff0000u) | kX87Plain;  // fnstenv has masked everything anyway
  __asm__ volatile("fldenv %0" : : "m"(all) : "memory");
}

}  // namespace

PlainFloats::PlainFloats() noexcept : sse_(sse()), x87_control_(x87_control()), x87_status_(x87_status()) {
  if ((sse_ & kSseControl) != kSsePlain) set_sse((sse_ & ~kSseControl) | kSsePlain);
  if (x87_control_ == kX87Plain) return;
  if ((x87_status_ & kX87Pending) != 0) __asm__ volatile("fnclex" : : : "memory");  // fldcw would raise it here
  set_x87_control(kX87Plain);
}

// Flags before traps: a trap that finds its flag raised is sprung.
PlainFloats::~PlainFloats() {
  if (sse() != sse_) set_sse(sse_);
  if (((x87_status() ^ x87_status_) & kX87Flags) != 0) set_x87_flags(x87_status_);
  if (x87_control() != x87_control_) set_x87_control(x87_control_);
}

#else

PlainFloats::PlainFloats() noexcept {
  std::fegetenv(&before_);
  std::fesetenv(FE_DFL_ENV);
}

PlainFloats::~PlainFloats() { std::fesetenv(&before_); }

#endif

}  // namespace mimo
