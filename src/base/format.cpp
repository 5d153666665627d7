// All of fmt, compiled in here: libmimo.so needs no libfmt.
#define FMT_HEADER_ONLY
#include "base/format.h"

#include <fmt/format.h>

#include <cstddef>

#ifndef __cpp_lib_to_chars
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/process.h"
#endif

namespace mimo {

std::string format_arguments(fmt::string_view format, fmt::format_args arguments) {
  return fmt::vformat(format, arguments);
}

std::string some_of(std::vector<std::string> names) {
  constexpr std::size_t kShown = 60;
  if (names.empty()) return "none";
  if (names.size() > kShown) {
    names.resize(kShown);
    names.emplace_back("...");
  }
  return join(names, ", ");
}

namespace {

// Bytes of the letter at a place, 0 where there is none. Table 3-7 of the Unicode standard: a letter is written in one
// way only, and none is half of a pair of UTF-16 or beyond U+10FFFF.
std::size_t letter_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t bytes = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  const unsigned low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < bytes; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  }
  return bytes;
}

// Of a letter of one to three bytes.
unsigned number_of(const std::string& text, std::size_t at, std::size_t bytes) {
  const auto low = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]) & 0x3Fu; };
  const auto first = static_cast<unsigned char>(text[at]);
  if (bytes == 1) return first;
  return bytes == 2 ? (first & 0x1Fu) << 6 | low(1) : (first & 0xFu) << 12 | low(1) << 6 | low(2);
}

// Controls (C0, DEL, C1), and the two separators that some take for the end of a line.
bool is_control(unsigned letter) {
  return letter < 0x20 || (letter >= 0x7F && letter < 0xA0) || letter == 0x2028 || letter == 0x2029;
}

std::string escape(unsigned letter) {
  switch (letter) {
    case '\n': return "\\n";
    case '\r': return "\\r";
    case '\t': return "\\t";
    default: return letter < 0x100 ? format("\\x{:02x}", letter) : format("\\u{:04x}", letter);
  }
}

}  // namespace

std::string as_line(const std::string& text) {
  std::string line;
  line.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = letter_at(text, at);
    if (bytes == 0) {
      line += '?';
    } else if (bytes < 4 && is_control(number_of(text, at, bytes))) {
      line += escape(number_of(text, at, bytes));
    } else {
      line.append(text, at, bytes);
    }
    at += bytes == 0 ? 1 : bytes;
  }
  return line;
}

std::string as_json(const std::string& text) {
  std::string quoted = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = letter_at(text, at);
    const char letter = text[at];
    if (bytes == 0) {
      quoted += "\\ufffd";
    } else if (bytes == 1 && static_cast<unsigned char>(letter) < 0x20) {
      quoted += format("\\u{:04x}", static_cast<unsigned>(letter));
    } else {
      if (letter == '"' || letter == '\\') quoted += '\\';
      quoted.append(text, at, bytes);
    }
    at += bytes == 0 ? 1 : bytes;
  }
  return quoted + '"';
}

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
