#include "document/pose.h"

#include "document/xml.h"

namespace mimo::document {

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
