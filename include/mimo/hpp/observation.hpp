/**
 * @file mimo/hpp/observation.hpp
 * Observation blocks and their fields. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_OBSERVATION
#define MIMO_HPP_OBSERVATION

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "handles.hpp"

namespace mimo {
inline namespace v1_0 {

/// The dtype of a field for a C++ type.
template <typename T>
struct Dtype;
template <>
struct Dtype<std::uint8_t> {
  static const std::int32_t value = MIMO_U8;
};
template <>
struct Dtype<std::int32_t> {
  static const std::int32_t value = MIMO_I32;
};
template <>
struct Dtype<float> {
  static const std::int32_t value = MIMO_F32;
};
template <>
struct Dtype<double> {
  static const std::int32_t value = MIMO_F64;
};

/// An observation block, aligned to 64 bytes. Views of it live as long as it does. A step into one without bytes senses
/// nothing, and takes no time for it.
class Block {
 public:
  explicit Block(std::size_t bytes = 0) : room_(bytes + 63), bytes_(bytes) {}
  /// What was moved from has no bytes.
  Block(Block &&other) noexcept : room_(std::move(other.room_)), bytes_(other.bytes_) { other.bytes_ = 0; }
  Block &operator=(Block &&other) noexcept {
    room_.swap(other.room_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  Block(const Block &other) : Block(other.bytes_) { *this = other; }
  Block &operator=(const Block &other) {
    if (this == &other) return *this;
    room_.resize(other.bytes_ + 63);
    bytes_ = other.bytes_;
    const std::uint8_t *from = other.data();
    std::uint8_t *to = data();
    for (std::size_t i = 0; i < bytes_; ++i) to[i] = from[i];
    return *this;
  }

  /// nullptr where there are no bytes.
  std::uint8_t *data() { return bytes_ == 0 ? nullptr : room_.data() + padding(); }
  const std::uint8_t *data() const { return bytes_ == 0 ? nullptr : room_.data() + padding(); }
  std::size_t bytes() const { return bytes_; }

  /// The elements of a field; throws std::invalid_argument when the field holds another type, std::out_of_range when it
  /// lies outside: it is a field of something else, or the block was moved from.
  template <typename T>
  View<const T> view(const mimo_field &field) const {
    const std::string name = field.name == nullptr ? "the field" : field.name;
    if (field.dtype != Dtype<T>::value) throw std::invalid_argument(name + " has another dtype");
    if (field.bytes > bytes_ || field.offset > bytes_ - field.bytes) {
      throw std::out_of_range(name + " ends at byte " + std::to_string(field.offset + field.bytes) + " of a block of " +
                              std::to_string(bytes_));
    }
    return View<const T>(reinterpret_cast<const T *>(data() + field.offset), field.bytes / sizeof(T));
  }

 private:
  std::size_t padding() const { return (64 - reinterpret_cast<std::uintptr_t>(room_.data()) % 64) % 64; }

  std::vector<std::uint8_t> room_;
  std::size_t bytes_;
};

}  // namespace v1_0
}  // namespace mimo

#endif
