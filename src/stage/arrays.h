// A host's arrays: copied, and checked against each other. Messages name the part, the array, the place and the value.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/fail.h"
#include "base/format.h"

namespace mimo::stage {

// Nothing that is drawn is farther away or larger, m.
constexpr double kFarthest = 1e12;
constexpr double kMostNumber = 1e6;  // of colours and the like

constexpr std::size_t kMostPoints = std::size_t{1} << 24;  // of paths, and extras

// What messages expect.
constexpr const char* kColor = "0 to 1e6";
constexpr const char* kShare = "0 to 1";
constexpr const char* kLength = "metres, 0 to 1e12";

// "materials[3]", of several numbers "sizes[3, 1]".
inline std::string place_in(const char* array, std::size_t i, std::size_t width) {
  return width == 1 ? format("{}[{}]", array, i) : format("{}[{}, {}]", array, i / width, i % width);
}

// The arrays of one part, of a length in common.
class Arrays {
 public:
  // No more than `most`, so that all numbers of what follows from them are numbers.
  Arrays(const char* part, std::size_t count, std::size_t most = kMostPoints) : part_(part), count_(count) {
    require(count <= most, "{}: count is {}, expected at most {}", part, count, most);
  }

  std::size_t count() const { return count_; }
  int whole_count() const { return static_cast<int>(count_); }

  // An array must be there, unless it is empty.
  template <typename T>
  void need(const T* array, const char* name) const {
    require(array != nullptr || count_ == 0, "{}: {} is NULL, but count is {}", part_, name, count_);
  }

  template <typename T>
  std::vector<T> copy(const T* array, const char* name, std::size_t width = 1) const {
    need(array, name);
    return array == nullptr ? std::vector<T>() : std::vector<T>(array, array + width * count_);
  }
  // Of one that may be NULL: then all have these numbers.
  template <typename T>
  std::vector<T> copy_or(const T* array, const char* name, const std::vector<T>& standard) const {
    if (array != nullptr) return copy(array, name, standard.size());
    std::vector<T> result;
    result.reserve(count_ * standard.size());
    for (std::size_t i = 0; i < count_; ++i) result.insert(result.end(), standard.begin(), standard.end());
    return result;
  }

  // Numbers are between these, and finite.
  template <typename T>
  void check(const T* values, const char* name, std::size_t width, double low, double high,
             const char* expected) const {
    check_values(values, width * count_, name, width, low, high, expected);
  }
  template <typename T>
  void check_values(const T* values, std::size_t length, const char* name, std::size_t width, double low, double high,
                    const char* expected) const {
    for (std::size_t i = 0; i < length; ++i) {
      const auto value = static_cast<double>(values[i]);
      if (value >= low && value <= high) continue;
      fail(Status::kInvalidArgument, "{}: {} is {}, expected {}", part_, place_in(name, i, width), values[i], expected);
    }
  }
  // Which of so many others, or -1 for none.
  void check_index(const std::vector<int>& values, const char* name, int count, const char* what) const {
    for (std::size_t i = 0; i < values.size(); ++i) check_one(values[i], i, name, count, what, -1);
  }
  // One of so many others.
  void check_one(int value, std::size_t i, const char* name, int count, const char* what, int least = 0) const {
    if (value >= least && value < count) return;
    fail(Status::kInvalidArgument, "{}: {} is {}, expected {}{}", part_, place_in(name, i, 1), value,
         least < 0 ? "-1, or " : "",
         count > 0 ? format("{} 0 to {}", what, count - 1) : format("{}, of which there is none", what));
  }
  // The length of an array that counts add up to.
  void check_total(std::size_t total, std::size_t sum, const char* name, const char* of) const {
    require(total == sum, "{}: {} is {}, expected {}, the sum of {}", part_, name, total, sum, of);
  }

  // Counts of something for each: not negative. Returns where each begins, and the sum behind the last.
  std::vector<std::size_t> firsts(const int* counts, const char* name, int least = 0) const {
    std::vector<std::size_t> result(count_ + 1);
    for (std::size_t i = 0; i < count_; ++i) {
      const int own = counts == nullptr ? 0 : counts[i];
      require(own >= least, "{}: {} is {}, expected at least {}", part_, place_in(name, i, 1), own, least);
      result[i + 1] = result[i] + static_cast<std::size_t>(own);
    }
    return result;
  }

  const char* part() const { return part_; }

  // What several parts have alike: colours, materials, groups.
  template <typename Given, typename Part>
  void take_looks(const Given& given, Part& part) const {
    part.colors = copy(given.colors, "colors", 4);
    check(part.colors.data(), "colors", 4, 0, kMostNumber, kColor);
    part.materials = copy_or<int>(given.materials, "materials", {-1});
    part.groups = copy_or<int>(given.groups, "groups", {0});
  }

 private:
  const char* part_;
  std::size_t count_;
};

}  // namespace mimo::stage
