// Where an episode is: its step, and the seed of all noise in it.
#pragma once

#include <array>
#include <cstdint>

#include "base/bytes.h"
#include "base/hash.h"
#include "base/random.h"
#include "base/section.h"

namespace mimo::env {

struct Episode {
  std::uint64_t step = 0;   // that were made
  std::uint64_t noise = 0;  // seed; the same random stream gives the same, and uses up nothing of it

  // `anew`: the stream was just seeded. Else noise goes on from that of the episode before, so that it differs even
  // where nobody draws random numbers.
  void start(const Random& random, bool anew) {
    std::array<std::uint8_t, 32> bytes{};
    ByteWriter writer{Span<std::uint8_t>(bytes)};
    random.save(writer);
    Hash hash;
    hash.add(Span<const std::uint8_t>(bytes));
    if (!anew) hash.add(noise);
    noise = hash.value();
    step = 0;
  }

  // This object outlives it.
  Section section() {
    Section section;
    section.name = "episode";
    section.save = [this](ByteWriter& to) {
      to.put(step);
      to.put(noise);
    };
    section.load = [this](ByteReader& from) {
      step = from.take<std::uint64_t>();
      noise = from.take<std::uint64_t>();
    };
    return section;
  }
};

}  // namespace mimo::env
