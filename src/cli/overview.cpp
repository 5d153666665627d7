#include <algorithm>
#include <array>
#include <cmath>

#include "picture.h"

namespace cli {
namespace {

using Point = std::array<double, 3>;

struct Ball {
  Point center;
  double radius;
};

// Distance from a to the farthest point of b.
double reach(const Point& a, const Ball& b) {
  return std::hypot(a[0] - b.center[0], a[1] - b.center[1], a[2] - b.center[2]) + b.radius;
}

// A ball around each geom that does not belong to the world.
std::vector<Ball> movable_geoms(const Env& env) {
  std::vector<Ball> balls;
  for (const std::int32_t geom : env.ids(MIMO_GEOM)) {
    if (env.body_of(MIMO_GEOM, geom) == 0) continue;
    const auto place = env.get(MIMO_GEOM_POSITION, {geom});
    const auto size = env.get(MIMO_GEOM_SIZE, {geom});
    balls.push_back({{place[0], place[1], place[2]}, std::hypot(size[0], size[1], size[2])});
  }
  return balls;
}

// Drops what is so far from the infant (a ball that rolled away) that showing it would make the infant tiny.
void drop_strays(const Env& env, std::vector<Ball>& balls) {
  constexpr double kFar = 2.0;
  if (!env.has(MIMO_BODY, "mimo_location")) return;
  const auto place = env.get(MIMO_BODY_POSITION, {env.find(MIMO_BODY, "mimo_location")});
  const Point infant{place[0], place[1], place[2]};
  const auto stray = [&](const Ball& ball) { return reach(infant, ball) > kFar; };
  balls.erase(std::remove_if(balls.begin(), balls.end(), stray), balls.end());
}

// Around the middle of the balls' bounding box; a little larger than the smallest one.
Ball enclosing(const std::vector<Ball>& balls) {
  Ball all{{}, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Ball& ball : balls) {
      low = std::min(low, ball.center[axis] - ball.radius);
      high = std::max(high, ball.center[axis] + ball.radius);
    }
    all.center[axis] = (low + high) / 2;
  }
  for (const Ball& ball : balls) all.radius = std::max(all.radius, reach(all.center, ball));
  return all;
}

}  // namespace

mimo_picture_config overview(const Env& env, std::uint32_t width, std::uint32_t height) {
  auto config = defaults(mimo_picture_config_init);
  config.width = width;
  config.height = height;
  auto balls = movable_geoms(env);
  drop_strays(env, balls);
  if (balls.empty()) return config;

  constexpr double kDegree = 3.14159265358979323846 / 180;
  config.fovy = 45;
  config.azimuth = 130;
  config.elevation = -20;
  const double vertical = config.fovy / 2 * kDegree;
  const double horizontal = std::atan(std::tan(vertical) * width / height);
  const Ball all = enclosing(balls);
  std::copy(all.center.begin(), all.center.end(), config.look_at);
  config.distance = std::max(all.radius / std::sin(std::min(vertical, horizontal)), 0.1);
  return config;
}

}  // namespace cli
