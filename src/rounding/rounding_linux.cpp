#include <dlfcn.h>

#include <array>
#include <atomic>
#include <map>
#include <mutex>

#include "base/substitutes.h"
#include "rounding/rounding.h"

namespace cli {
namespace {

using Bits = std::uint64_t;

struct Notes {
  std::mutex mutex;
  std::map<std::array<Bits, 3>, Bits> results;  // of Substitute and arguments
};

Notes notes;
std::atomic<bool> noting{false};

Bits bits_of(double x) {
  Bits bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

void note(mimo::Substitute function, double x, double y, double result, double substitute) {
  if (bits_of(result) == bits_of(substitute)) return;
  const std::lock_guard lock(notes.mutex);
  notes.results[{static_cast<Bits>(function), bits_of(x), bits_of(y)}] = bits_of(result);
}

// The C library's function, which is looked up at the first call, maybe before main().
template <typename Function>
Function next(std::atomic<Function>& known, const char* name, Function otherwise) {
  Function function = known.load(std::memory_order_relaxed);
  if (function == nullptr) {
    function = reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
    if (function == nullptr) function = otherwise;
    known.store(function, std::memory_order_relaxed);
  }
  return function;
}

using Of1 = double (*)(double);
using Of2 = double (*)(double, double);
using SineAndCosine = void (*)(double, double*, double*);

void sine_and_cosine(double x, double* sine, double* cosine) {
  *sine = mimo::fixed::sin(x);
  *cosine = mimo::fixed::cos(x);
}

}  // namespace

RoundingNotes::RoundingNotes() {
  notes.results.clear();
  noting = true;
}

RoundingNotes::~RoundingNotes() { noting = false; }

std::string RoundingNotes::rows() const {
  const std::lock_guard lock(notes.mutex);
  std::string bytes;
  for (const auto& [call, result] : notes.results) {
    const Bits row[] = {call[0], call[1], call[2], result};
    bytes.append(reinterpret_cast<const char*>(row), sizeof row);
  }
  return bytes;
}

}  // namespace cli

#define MIMO_VISIBLE extern "C" __attribute__((visibility("default")))
#define MIMO_PASS_ON(name)                                                                  \
  MIMO_VISIBLE double name(double x) noexcept {                                             \
    static std::atomic<cli::Of1> known{nullptr};                                            \
    const double result = cli::next<cli::Of1>(known, #name, mimo::fixed::name)(x);          \
    if (cli::noting) cli::note(mimo::Substitute::name, x, 0, result, mimo::fixed::name(x)); \
    return result;                                                                          \
  }
#define MIMO_PASS_ON_2(name)                                                                   \
  MIMO_VISIBLE double name(double x, double y) noexcept {                                      \
    static std::atomic<cli::Of2> known{nullptr};                                               \
    const double result = cli::next<cli::Of2>(known, #name, mimo::fixed::name)(x, y);          \
    if (cli::noting) cli::note(mimo::Substitute::name, x, y, result, mimo::fixed::name(x, y)); \
    return result;                                                                             \
  }

MIMO_SUBSTITUTES_OF_1(MIMO_PASS_ON)
MIMO_SUBSTITUTES_OF_2(MIMO_PASS_ON_2)

// Compilers call it where a program wants both.
MIMO_VISIBLE void sincos(double x, double* sine, double* cosine) noexcept {
  static std::atomic<cli::SineAndCosine> known{nullptr};
  cli::next<cli::SineAndCosine>(known, "sincos", cli::sine_and_cosine)(x, sine, cosine);
  if (!cli::noting) return;
  cli::note(mimo::Substitute::sin, x, 0, *sine, mimo::fixed::sin(x));
  cli::note(mimo::Substitute::cos, x, 0, *cosine, mimo::fixed::cos(x));
}
