#include <algorithm>
#include <array>
#include <cmath>

#include "picture.h"

namespace cli {
namespace {

using Vector = std::array<double, 3>;

struct Ball {
  Vector center;
  double radius;
};

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector position(const Env& env, std::int32_t quantity, std::int32_t id) {
  const auto place = env.get(quantity, {id});
  return {place[0], place[1], place[2]};
}

// A ball around each geom that does not belong to the world.
std::vector<Ball> movable_geoms(const Env& env) {
  std::vector<Ball> balls;
  for (const std::int32_t geom : env.ids(MIMO_GEOM)) {
    if (env.body_of(MIMO_GEOM, geom) == 0) continue;
    const auto size = env.get(MIMO_GEOM_SIZE, {geom});
    balls.push_back({position(env, MIMO_GEOM_POSITION, geom), std::hypot(size[0], size[1], size[2])});
  }
  return balls;
}

// Drops what is so far from all infants (a ball that rolled away) that showing it would make them tiny.
void drop_strays(const Env& env, std::vector<Ball>& balls) {
  constexpr double kFar = 2.0;
  std::vector<Vector> infants;
  for (const std::int32_t body : env.infants()) infants.push_back(position(env, MIMO_BODY_POSITION, body));
  if (infants.empty()) return;
  const auto stray = [&](const Ball& ball) {
    return std::none_of(infants.begin(), infants.end(), [&](const Vector& infant) {
      return std::hypot(ball.center[0] - infant[0], ball.center[1] - infant[1], ball.center[2] - infant[2]) <= kFar;
    });
  };
  balls.erase(std::remove_if(balls.begin(), balls.end(), stray), balls.end());
}

// The middle of the balls' bounding box.
Vector middle(const std::vector<Ball>& balls) {
  Vector center{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Ball& ball : balls) {
      low = std::min(low, ball.center[axis] - ball.radius);
      high = std::max(high, ball.center[axis] + ball.radius);
    }
    center[axis] = (low + high) / 2;
  }
  return center;
}

// How far from the point it looks at a camera has to be for all balls to lie between two planes of its frustum,
// which open by half_angle on either side of `forward` along `sideways`.
double distance_to_see(const std::vector<Ball>& balls, const Vector& look_at, const Vector& forward,
                       const Vector& sideways, double half_angle) {
  double distance = 0;
  for (const Ball& ball : balls) {
    const Vector place{ball.center[0] - look_at[0], ball.center[1] - look_at[1], ball.center[2] - look_at[2]};
    const double aside = std::abs(dot(place, sideways)) + ball.radius / std::cos(half_angle);
    distance = std::max(distance, aside / std::tan(half_angle) - dot(place, forward));
  }
  return distance;
}

}  // namespace

mimo_picture_config overview(const Env& env, std::uint32_t width, std::uint32_t height) {
  auto config = defaults(mimo_picture_config_init);
  config.width = width;
  config.height = height;
  auto balls = movable_geoms(env);
  drop_strays(env, balls);
  if (balls.empty()) return config;

  config.fovy = 45;
  config.azimuth = 130;
  config.elevation = -20;
  constexpr double kDegree = 3.14159265358979323846 / 180;
  const double azimuth = config.azimuth * kDegree, elevation = config.elevation * kDegree;
  const Vector forward{std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                       std::sin(elevation)};
  const Vector right{std::sin(azimuth), -std::cos(azimuth), 0};
  const Vector up{-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth),
                  std::cos(elevation)};
  const double vertical = config.fovy / 2 * kDegree;
  const double horizontal = std::atan(std::tan(vertical) * width / height);

  constexpr double kMargin = 1.05;
  const Vector center = middle(balls);
  std::copy(center.begin(), center.end(), config.look_at);
  config.distance = kMargin * std::max(distance_to_see(balls, center, forward, up, vertical),
                                       distance_to_see(balls, center, forward, right, horizontal));
  return config;
}

}  // namespace cli
