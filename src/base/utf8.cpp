#include "base/utf8.h"

#include <cstddef>

#include "base/format.h"

namespace mimo {
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

}  // namespace mimo
