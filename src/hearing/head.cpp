#include "hearing/head.h"

#include <cmath>

#include "base/angle.h"

namespace mimo::hearing {

std::array<Eigen::Vector3d, kEars> ears_of_frame() {
  constexpr double kAzimuth = 100 * kDegree;
  const double forward = std::cos(kAzimuth), aside = std::sin(kAzimuth);
  return {Eigen::Vector3d(forward, aside, 0), Eigen::Vector3d(forward, -aside, 0)};
}

Ways ways_to(const Head& head, const Eigen::Vector3d& place) {
  const Eigen::Vector3d to = place - head.middle;
  const double distance = to.norm();
  Ways ways;
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    const double cosine = distance > 0 ? head.ears[ear].dot(to) / distance : 0;
    ways[ear] = sound::way_to_ear(head.radius, distance, cosine);
  }
  return ways;
}

}  // namespace mimo::hearing
