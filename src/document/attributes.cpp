#include "document/attributes.h"

#include <cmath>
#include <cstring>

#include "base/read_double.h"

namespace mimo::document {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

std::optional<double> take_number(const char*& at, const char* end) {
  while (at != end && is_space(*at)) ++at;
  const char* const begin = at != end && *at == '+' ? at + 1 : at;
  double value = 0;
  const auto result = read_double(begin, end, value);
  if (result.ec == std::errc::result_out_of_range) {
    const bool tiny = std::string(begin, result.ptr).find_first_of("eE") != std::string::npos &&
                      std::string(begin, result.ptr).find('-', 1) != std::string::npos;
    const double huge = *begin == '-' ? -HUGE_VAL : HUGE_VAL;
    value = tiny ? 0 : huge;
  } else if (result.ec != std::errc()) {
    return std::nullopt;
  }
  at = result.ptr;
  return value;
}

std::vector<double> numbers_in(pugi::xml_node node, const char* attribute) {
  const char* at = node.attribute(attribute).value();
  const char* const end = at + std::strlen(at);
  std::vector<double> values;
  while (const std::optional<double> value = take_number(at, end)) values.push_back(*value);
  return values;
}

std::optional<double> number(pugi::xml_node node, const char* attribute) {
  const char* at = node.attribute(attribute).value();
  return take_number(at, at + std::strlen(at));
}

std::size_t words(pugi::xml_attribute attribute) {
  std::size_t count = 0;
  bool inside = false;
  for (const char* at = attribute.value(); *at != '\0'; ++at) {
    if (!inside && !is_space(*at)) ++count;
    inside = !is_space(*at);
  }
  return count;
}

}  // namespace mimo::document
