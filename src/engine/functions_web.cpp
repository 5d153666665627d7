// What stands for the C library's functions in a module of WebAssembly, which brings its MuJoCo along: those that give
// the same bytes everywhere. The linker leads every call of a function to its __wrap_ (--wrap, cmake/MimoMujoco.cmake).
//
// A page that plays a recording knows more: where the C library of the machine that recorded rounds otherwise.
#include <array>
#include <cstddef>
#include <unordered_map>

#include "base/substitutes.h"

namespace fixed = mimo::fixed;

namespace {

using Bits = std::uint64_t;
using Call = std::array<Bits, 3>;  // Substitute, arguments

struct Hash {
  std::size_t operator()(const Call& call) const {
    constexpr Bits kFactor = 0x9e3779b97f4a7c15;  // 2^64 by the golden ratio
    Bits all = 0;
    for (const Bits bits : call) all = (all ^ bits ^ all >> 29) * kFactor;
    return static_cast<std::size_t>(all >> 32);
  }
};

std::unordered_map<Call, double, Hash> recorded;

Bits bits_of(double x) {
  Bits bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

double rounded(mimo::Substitute function, double x, double y, double result) {
  if (recorded.empty()) return result;
  const auto found = recorded.find({static_cast<Bits>(function), bits_of(x), bits_of(y)});
  return found == recorded.end() ? result : found->second;
}

}  // namespace

#define MIMO_WRAP(name) \
  double __wrap_##name(double x) { return rounded(mimo::Substitute::name, x, 0, fixed::name(x)); }
#define MIMO_WRAP_2(name) \
  double __wrap_##name(double x, double y) { return rounded(mimo::Substitute::name, x, y, fixed::name(x, y)); }

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the names are the linker's
extern "C" {
MIMO_SUBSTITUTES_OF_1(MIMO_WRAP)
MIMO_SUBSTITUTES_OF_2(MIMO_WRAP_2)
}
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

// From now on these calls give these results, and no others do. A row is Substitute, x, y (0 where there is none) and
// the result, of 8 bytes each, as rounding/rounding.h notes them.
extern "C" void mimo_round_as(const Bits* rows, std::size_t count) {
  recorded.clear();
  for (std::size_t i = 0; i < count; ++i, rows += 4) {
    double result;
    std::memcpy(&result, rows + 3, sizeof result);
    recorded[{rows[0], rows[1], rows[2]}] = result;
  }
}
