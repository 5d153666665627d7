#include "document/attributes.h"

#include <cmath>
#include <cstring>

#include "base/format.h"
#include "document/xml.h"

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

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Pose seen_from(const Pose& from, const Pose& pose) {
  const Quaternion& q = from.orientation;
  const Quaternion back{q[0], -q[1], -q[2], -q[3]};
  Quaternion offset{};
  for (std::size_t i = 0; i < 3; ++i) offset[i + 1] = pose.position[i] - from.position[i];
  const Quaternion turned = product(product(back, offset), q);
  return {{turned[1], turned[2], turned[3]}, product(back, pose.orientation)};
}

void set_pose(pugi::xml_node body, const Pose& pose) {
  for (const char* other : {"euler", "axisangle", "xyaxes", "zaxis"}) body.remove_attribute(other);
  set(body, "pos", Span<const double>(pose.position));
  set(body, "quat", Span<const double>(pose.orientation));
}

}  // namespace mimo::document
