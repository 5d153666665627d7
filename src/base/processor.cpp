// Asked of the processor itself: not every compiler's runtime brings what __builtin_cpu_supports() calls.
#include "base/processor.h"

#if defined(__x86_64__)

#include <cpuid.h>

#include <atomic>
#include <cstdint>

namespace mimo {
namespace {

struct Leaf {
  unsigned a = 0, b = 0, c = 0, d = 0;
};

Leaf leaf(unsigned number) {
  Leaf found;
  __get_cpuid_count(number, 0, &found.a, &found.b, &found.c, &found.d);  // all zero for numbers it does not know
  return found;
}

bool has_all(unsigned word, unsigned bits) { return (word & bits) == bits; }

// The registers that the system saves when it switches threads.
bool system_saves(unsigned registers) {
  if (!has_all(leaf(1).c, bit_OSXSAVE)) return false;
  unsigned low = 0, high = 0;
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return has_all(low, registers);
}

constexpr unsigned kVectors256 = 0x06;  // SSE's and AVX's
constexpr unsigned kVectors512 = 0xe6;  // and those of AVX-512, with its masks

// An answer kept: in a virtual machine the processor's takes microseconds. No static at first use, whose lock a child
// process could find closed.
class Answer {
 public:
  template <typename Ask>
  bool get(Ask ask) {
    int known = known_.load(std::memory_order_relaxed);
    if (known == kUnknown) known_.store(known = ask() ? kYes : kNo, std::memory_order_relaxed);
    return known == kYes;
  }

 private:
  enum { kUnknown, kNo, kYes };
  std::atomic<int> known_{kUnknown};
};

Answer avx2, avx512;

}  // namespace

bool has_sse4() { return has_all(leaf(1).c, bit_SSE4_2 | bit_PCLMUL); }

bool has_avx() { return system_saves(kVectors256) && has_all(leaf(1).c, bit_AVX); }

bool has_avx2() {
  return avx2.get([] {
    return system_saves(kVectors256) && has_all(leaf(1).c, bit_FMA) && has_all(leaf(7).b, bit_AVX2 | bit_BMI2);
  });
}

bool has_avx512() {
  constexpr unsigned kAll = bit_AVX512F | bit_AVX512VL | bit_AVX512DQ | bit_AVX512BW | bit_AVX512CD;
  return avx512.get([] { return system_saves(kVectors512) && has_all(leaf(7).b, kAll); });
}

}  // namespace mimo

#endif
