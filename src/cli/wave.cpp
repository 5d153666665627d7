#include <algorithm>
#include <cmath>
#include <sstream>

#include "cli/commands.h"
#include "programs/files.h"
#include "programs/program.h"

namespace cli {
namespace {

constexpr float kLargest = 32767;
constexpr std::uint16_t kChannels = 2, kBytes = 2;

// Numbers of WAV files have their lowest byte first.
template <typename T>
void put(std::ostream& file, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) file.put(static_cast<char>((value >> (8 * i)) & 0xff));
}

mimo_field find(const mimo::Layout& layout, const std::string& name) {
  for (const mimo_field& field : layout.fields()) {
    if (name == field.name) return field;
  }
  throw Failure("nothing to write sound of: there is no field " + name);
}

}  // namespace

Wave::Wave(const mimo::Layout& layout, const std::string& prefix)
    : left_(find(layout, prefix + "hearing/ear_left")), right_(find(layout, prefix + "hearing/ear_right")) {}

void Wave::add(const mimo::Block& block) {
  const auto* bytes = block.data();
  const auto* left = reinterpret_cast<const float*>(bytes + left_.offset);
  const auto* right = reinterpret_cast<const float*>(bytes + right_.offset);
  for (std::size_t i = 0; i < left_.bytes / sizeof(float); ++i) {
    samples_.push_back(left[i]);
    samples_.push_back(right[i]);
    peak_ = std::max({peak_, std::abs(left[i]), std::abs(right[i])});
  }
}

void Wave::write(const std::string& path, double full_scale) const {
  const auto rate = static_cast<std::uint32_t>(std::lround(left_.sample_rate));
  const auto bytes = static_cast<std::uint32_t>(samples_.size() * kBytes);
  std::ostringstream file;
  file << "RIFF";
  put(file, std::uint32_t{36} + bytes);
  file << "WAVEfmt ";
  put(file, std::uint32_t{16});
  put(file, std::uint16_t{1});  // whole numbers
  put(file, kChannels);
  put(file, rate);
  put(file, rate * kChannels * kBytes);
  put(file, static_cast<std::uint16_t>(kChannels * kBytes));
  put(file, static_cast<std::uint16_t>(8 * kBytes));
  file << "data";
  put(file, bytes);
  for (const float sample : samples_) {
    const float level = std::clamp(sample / static_cast<float>(full_scale), -1.0F, 1.0F) * kLargest;
    put(file, static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(level))));
  }
  write_file(path, file.str());
}

}  // namespace cli
