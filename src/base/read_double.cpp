#include "base/read_double.h"

#ifndef __cpp_lib_to_chars
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/plain_numbers.h"
#endif

namespace mimo {

#ifdef __cpp_lib_to_chars

std::from_chars_result read_double(const char* at, const char* end, double& value) {
  return std::from_chars(at, end, value);
}

#else

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Where a number that starts at `at` ends: nothing that strtod reads beyond the standard's pattern, such as 0x10.
const char* end_of_number(const char* at, const char* end) {
  const auto skip_digits = [&] { return at = std::find_if_not(at, end, is_digit); };
  const char* const begin = at;
  if (at != end && *at == '-') ++at;
  const char* const digits = at;
  const char* last = skip_digits();
  std::ptrdiff_t count = last - digits;
  if (at != end && *at == '.') {
    ++at;
    const char* const behind = at;
    last = skip_digits();
    count += last - behind;
  }
  if (count == 0) return begin;
  if (at == end || (*at != 'e' && *at != 'E')) return last;
  ++at;
  if (at != end && (*at == '-' || *at == '+')) ++at;
  const char* const exponent = at;
  skip_digits();
  return at == exponent ? last : at;
}

// "inf" and "nan".
std::from_chars_result read_word(const char* at, const char* end, double& value) {
  const char* const letters = at != end && *at == '-' ? at + 1 : at;
  if (letters == end || std::strchr("iInN", *letters) == nullptr) return {at, std::errc::invalid_argument};
  const std::string text(at, end);
  char* stop = nullptr;
  const double read = std::strtod(text.c_str(), &stop);
  if (stop == text.c_str()) return {at, std::errc::invalid_argument};
  value = read;
  return {at + (stop - text.c_str()), std::errc()};
}

}  // namespace

std::from_chars_result read_double(const char* at, const char* end, double& value) {
  const char* const stop = end_of_number(at, end);
  if (stop == at) return read_word(at, end, value);
  const PlainNumbers plain;
  const double read = std::strtod(std::string(at, stop).c_str(), nullptr);
  const char* const exponent = std::find_if(at, stop, [](char c) { return c == 'e' || c == 'E'; });
  const bool vanished = read == 0 && std::any_of(at, exponent, [](char c) { return c >= '1' && c <= '9'; });
  if (std::isinf(read) || vanished) return {stop, std::errc::result_out_of_range};
  value = read;
  return {stop, std::errc()};
}

#endif

}  // namespace mimo
