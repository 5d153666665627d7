// Modes of struck things, as measured.
#pragma once

#include <array>
#include <cstddef>

namespace mimo::sound {

constexpr std::size_t kModes = 8;
constexpr std::size_t kSizes = 6;
constexpr std::size_t kModeSets = 21;
constexpr std::size_t kTimbres = 8;

struct Mode {
  double frequency, gain, decay;  // Hz; share of the strongest; seconds to fall by 60 dB
};
struct ModeSet {
  std::size_t count;
  std::array<Mode, kModes> modes;
};
struct Timbre {
  const char* name;
  std::array<int, kSizes> sets;  // of kModeTable, by size, the smallest things first
};

extern const std::array<ModeSet, kModeSets> kModeTable;
extern const std::array<Timbre, kTimbres> kTimbreTable;

}  // namespace mimo::sound
