#include "observation/many_lookups.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include <array>

#include "base/processor.h"

// zig tells this compiler of all that a baseline processor lacks, long registers among them.
#if defined(__clang__) && !defined(__apple_build_version__) && __clang_major__ >= 18 && __clang_major__ < 21
#define MIMO_WITH_AVX512 __attribute__((target("avx512bw,evex512")))
#else
#define MIMO_WITH_AVX512 __attribute__((target("avx512bw")))
#endif

namespace mimo::observation {
namespace {

constexpr std::size_t kMany = 32;      // pixels of a register with 16 bits for each
constexpr std::size_t kRegisters = 8;  // hold a table of 256 lights

// Where the colour of each pixel is among 96 bytes: the word of 16 bits, and whether it is the upper half of that. The
// first 32 words are bytes 0 to 63, the next 32 are bytes 32 to 95.
struct WordPlaces {
  alignas(64) std::array<std::uint16_t, kMany> word, shift;
};

constexpr WordPlaces places_of(std::size_t colour) {
  WordPlaces places{};
  for (std::size_t i = 0; i < kMany; ++i) {
    const std::size_t byte = 3 * i + colour, word = byte / 2;
    places.word[i] = static_cast<std::uint16_t>(word < kMany ? word : word + kMany / 2);
    places.shift[i] = byte % 2 == 0 ? 0 : 8;
  }
  return places;
}
constexpr std::array<WordPlaces, 3> kPlaces = {places_of(0), places_of(1), places_of(2)};

struct PixelBytes {
  __m512i first, last;  // bytes 0 to 63 and 32 to 95
};

MIMO_WITH_AVX512 inline PixelBytes load(const std::uint8_t* rgb) {
  return {_mm512_loadu_si512(rgb), _mm512_loadu_si512(rgb + 32)};
}

// The bytes of a colour, below eight bits that do not count.
MIMO_WITH_AVX512 inline __m512i bytes_of(const PixelBytes& pixels, std::size_t colour) {
  const __m512i word = _mm512_load_si512(kPlaces[colour].word.data());
  const __m512i shift = _mm512_load_si512(kPlaces[colour].shift.data());
  return _mm512_srlv_epi16(_mm512_permutex2var_epi16(pixels.first, word, pixels.last), shift);
}

// A table in registers.
struct RegisterTable {
  __m512i part[kRegisters];

  MIMO_WITH_AVX512 explicit RegisterTable(const LightTable& table) {
    for (std::size_t k = 0; k < kRegisters; ++k) part[k] = _mm512_loadu_si512(table.data() + k * kMany);
  }
};

// Permutations look at six bits of a byte: four of them, and two choices by the other bits.
MIMO_WITH_AVX512 inline __m512i look_up(const RegisterTable& table, __m512i bytes) {
  const auto& part = table.part;
  const __mmask32 seventh = _mm512_test_epi16_mask(bytes, _mm512_set1_epi16(64));
  const __mmask32 eighth = _mm512_test_epi16_mask(bytes, _mm512_set1_epi16(128));
  const __m512i lower = _mm512_mask_blend_epi16(seventh, _mm512_permutex2var_epi16(part[0], bytes, part[1]),
                                                _mm512_permutex2var_epi16(part[2], bytes, part[3]));
  const __m512i upper = _mm512_mask_blend_epi16(seventh, _mm512_permutex2var_epi16(part[4], bytes, part[5]),
                                                _mm512_permutex2var_epi16(part[6], bytes, part[7]));
  return _mm512_mask_blend_epi16(eighth, lower, upper);
}

MIMO_WITH_AVX512 std::size_t look_up_all(const std::uint8_t* rgb, std::size_t width, const LightTable& lights,
                                         Light* red, Light* green, Light* blue) {
  const RegisterTable table(lights);
  std::size_t x = 0;
  for (; x + kMany <= width; x += kMany) {
    const PixelBytes pixels = load(rgb + 3 * x);
    _mm512_storeu_si512(red + x, look_up(table, bytes_of(pixels, 0)));
    _mm512_storeu_si512(green + x, look_up(table, bytes_of(pixels, 1)));
    _mm512_storeu_si512(blue + x, look_up(table, bytes_of(pixels, 2)));
  }
  return x;
}

MIMO_WITH_AVX512 std::size_t add_up_all(const std::uint8_t* rgb, std::size_t width, const LightTable& red,
                                        const LightTable& green, const LightTable& blue, Light* sum) {
  const RegisterTable reds(red), greens(green), blues(blue);
  std::size_t x = 0;
  for (; x + kMany <= width; x += kMany) {
    const PixelBytes pixels = load(rgb + 3 * x);
    const __m512i of_red = look_up(reds, bytes_of(pixels, 0));
    const __m512i of_green = look_up(greens, bytes_of(pixels, 1));
    const __m512i of_blue = look_up(blues, bytes_of(pixels, 2));
    _mm512_storeu_si512(sum + x, _mm512_add_epi16(_mm512_add_epi16(of_red, of_green), of_blue));
  }
  return x;
}

}  // namespace

std::size_t look_up_many(const std::uint8_t* rgb, std::size_t width, const LightTable& table, Light* red, Light* green,
                         Light* blue) {
  return has_avx512() ? look_up_all(rgb, width, table, red, green, blue) : 0;
}

std::size_t add_up_many(const std::uint8_t* rgb, std::size_t width, const LightTable& red, const LightTable& green,
                        const LightTable& blue, Light* sum) {
  return has_avx512() ? add_up_all(rgb, width, red, green, blue, sum) : 0;
}

}  // namespace mimo::observation

#else

namespace mimo::observation {

std::size_t look_up_many(const std::uint8_t*, std::size_t, const LightTable&, Light*, Light*, Light*) { return 0; }
std::size_t add_up_many(const std::uint8_t*, std::size_t, const LightTable&, const LightTable&, const LightTable&,
                        Light*) {
  return 0;
}

}  // namespace mimo::observation

#endif
