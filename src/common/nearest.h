// The name that was probably meant, for messages about one that is not there.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace mimo {

// A name without what is in front of it, "anna/robot:", in small letters.
inline std::string own_part(const std::string& name) {
  std::string own = name.substr(name.find_last_of(":/") + 1);
  for (char& letter : own) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return own;
}

// How many letters have to be put in, left out, changed or swapped with their neighbours.
inline std::size_t edit_distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> before, last(to.size() + 1), now(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t other = from[i - 1] == to[j - 1] ? 0 : 1;
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + other});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
        now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before = std::exchange(last, now);
  }
  return last[to.size()];
}

// The nearest name, or an empty one where none is near.
inline std::string nearest(const std::string& wanted, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 100, kLetters = 6;  // one letter in so many may be wrong, and one more
  if (wanted.empty() || wanted.size() > kLongest) return "";
  const std::string own = own_part(wanted);
  std::string found;
  std::size_t least = 2 + own.size() / kLetters;
  for (const std::string& name : names) {
    const std::string other = own_part(name);
    if (other.empty() || std::max(other.size(), own.size()) - std::min(other.size(), own.size()) >= least) continue;
    const std::size_t apart = edit_distance(own, other);
    if (apart < least && apart < own.size()) {
      least = apart;
      found = name;
    }
  }
  return found;
}

}  // namespace mimo
