// What the processor can do, and how a thread calculates: rounding, traps, what becomes of tiny numbers.
#pragma once

#if defined(__x86_64__)
#include <cstdint>
#else
#include <cfenv>
#endif

namespace mimo {

// Which instruction sets this processor has and its system saves; for x86 only.

bool has_sse4();  // SSE4.2 and PCLMUL
bool has_avx();
bool has_avx2();    // with FMA and BMI2
bool has_avx512();  // F, VL, DQ, BW and CD

// How a thread calculates: rounding, traps, what becomes of tiny numbers. Hosts change it (Free Pascal and SBCL trap,
// -ffast-math flushes denormals to zero), and then we would compute other bytes, or raise a signal.

// While this lives, the calling thread calculates by the book: to the nearest, without traps, with denormals.
// Afterwards it does as it did before, and the flags of exceptions are those of before. A thread inherits this from the
// one that starts it.
class PlainFloats {
 public:
  PlainFloats() noexcept;
  ~PlainFloats();
  PlainFloats(const PlainFloats&) = delete;
  PlainFloats& operator=(const PlainFloats&) = delete;

 private:
#if defined(__x86_64__)
  std::uint32_t sse_;                       // the register MXCSR
  std::uint16_t x87_control_, x87_status_;  // of the old unit: libstdc++'s hash tables use it, and hosts set it
#else
  std::fenv_t before_;
#endif
};

}  // namespace mimo
