// JSON texts that are read. Nlohmann's own values allocate when they are destroyed, which ends the process where memory
// has run out; these do not.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace mimo::capi {

struct ReadJson {
  enum class Kind { kNull, kFlag, kNegative, kNatural, kReal, kText, kList, kObject };

  Kind kind = Kind::kNull;
  std::int64_t negative = 0;
  std::uint64_t natural = 0;
  double real = 0;  // of every number
  std::string text;
  std::vector<std::string> names;  // of an object's parts
  std::vector<ReadJson> parts;

  bool is(Kind wanted) const { return kind == wanted; }
  // Null where an object lacks it, and where this is none.
  const ReadJson* find(const char* name) const;
  // Nothing where it is no number, or none of that type.
  template <typename T>
  std::optional<T> number() const;
};

// Nothing for what is no JSON, or deeper than anything that is written.
std::optional<ReadJson> read_json(const std::string& text);

template <typename T>
std::optional<T> ReadJson::number() const {
  using Limits = std::numeric_limits<T>;
  const bool whole = kind == Kind::kNegative || kind == Kind::kNatural;
  if constexpr (std::is_floating_point_v<T>) {
    if (whole || kind == Kind::kReal) return static_cast<T>(real);
  } else {
    if (kind == Kind::kNatural && natural <= std::uint64_t{Limits::max()}) return static_cast<T>(natural);
    if (kind == Kind::kNegative && std::is_signed_v<T> && negative >= std::int64_t{Limits::min()})
      return static_cast<T>(negative);
  }
  return std::nullopt;
}

}  // namespace mimo::capi
