#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/picture.h"
#include "programs/joints.h"
#include "programs/summary.h"

namespace cli {
namespace {

using mimo::Vector;

struct Ball {
  std::int32_t geom;
  Vector center;
  double radius;
};

// What is farther from all infants (a ball that rolled away) is left out: showing it would make them tiny.
constexpr double kSurroundings = 2.0, kArmsReach = 0.6;

constexpr double kAzimuths[] = {130, 50, -130, -50};  // from the right and in front of an infant, and from other sides
struct View {
  double far, fovy;
};
constexpr View kViews[] = {{kSurroundings, 45}, {kArmsReach, 45}, {kArmsReach, 75}};

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector position(const mimo::Env& env, std::int32_t quantity, std::int32_t id) {
  const auto place = env.get_values(quantity, {id});
  return {place[0], place[1], place[2]};
}

// A ball around each geom that is not scenery: of the world itself, or as large as walls and furniture are.
std::vector<Ball> small_geoms(const mimo::Env& env) {
  constexpr double kLarge = 0.5;
  std::vector<Ball> balls;
  for (const std::int32_t geom : env.ids(MIMO_GEOM)) {
    const auto size = env.get_values(MIMO_GEOM_SIZE, {geom});
    const double radius = std::hypot(size[0], size[1], size[2]);
    if (env.body_of(MIMO_GEOM, geom) == 0 || radius > kLarge) continue;
    balls.push_back({geom, position(env, MIMO_GEOM_POSITION, geom), radius});
  }
  return balls;
}

// Those that are near an infant; all where there is none.
std::vector<Ball> near_infants(const mimo::Env& env, std::vector<Ball> balls, double far) {
  std::vector<Vector> places;
  for (const std::int32_t body : infants(env)) places.push_back(position(env, MIMO_BODY_POSITION, body));
  if (places.empty()) return balls;
  const auto stray = [&](const Ball& ball) {
    return std::none_of(places.begin(), places.end(), [&](const Vector& infant) {
      return std::hypot(ball.center[0] - infant[0], ball.center[1] - infant[1], ball.center[2] - infant[2]) <= far;
    });
  };
  balls.erase(std::remove_if(balls.begin(), balls.end(), stray), balls.end());
  return balls;
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

// A camera that has all balls in its picture.
mimo_picture_config view_of(const std::vector<Ball>& balls, mimo_picture_config config) {
  const double azimuth = config.azimuth * kDegree, elevation = config.elevation * kDegree;
  const Vector forward{std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                       std::sin(elevation)};
  const Vector right{std::sin(azimuth), -std::cos(azimuth), 0};
  const Vector up{-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth),
                  std::cos(elevation)};
  const double vertical = config.fovy / 2 * kDegree;
  const double horizontal = std::atan(std::tan(vertical) * config.width / config.height);

  constexpr double kMargin = 1.05;
  const Vector center = middle(balls);
  std::copy(center.begin(), center.end(), config.look_at);
  config.distance = kMargin * std::max(distance_to_see(balls, center, forward, up, vertical),
                                       distance_to_see(balls, center, forward, right, horizontal));
  return config;
}

bool among(const std::vector<Ball>& balls, std::int32_t geom) {
  return std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) { return ball.geom == geom; });
}

// How many of the balls a wall or other scenery hides from a camera that has them in its picture.
std::size_t count_hidden(mimo::Env& env, mimo_picture_config config, const std::vector<Ball>& balls,
                         const std::vector<Ball>& small) {
  constexpr std::uint32_t kCoarser = 8;
  config.width = std::max(config.width / kCoarser, 1u);
  config.height = std::max(config.height / kCoarser, 1u);
  const auto pictures = env.render(config, MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION);
  const auto& depth = pictures.depth.pixels;
  const auto& geoms = pictures.segmentation.pixels;

  std::vector<Vector> centers;
  for (const Ball& ball : balls) centers.push_back(ball.center);
  const auto pixels = env.project(config, centers);
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const auto x = static_cast<std::size_t>(std::clamp(pixels[i][0], 0.0, config.width - 1.0));
    const auto y = static_cast<std::size_t>(std::clamp(pixels[i][1], 0.0, config.height - 1.0));
    const std::size_t pixel = y * config.width + x;
    const bool scenery = geoms[pixel] >= 0 && !among(small, geoms[pixel]);
    hidden += scenery && depth[pixel] < pixels[i][2] - balls[i].radius;
  }
  return hidden;
}

}  // namespace

// The usual view, or the first other one that nothing stands in the way of: from another side, of the infants alone and
// from nearer, with a wider angle.
mimo_picture_config overview(mimo::Env& env, std::uint32_t width, std::uint32_t height) {
  auto config = mimo::picture_config();
  config.width = width;
  config.height = height;
  const auto small = small_geoms(env);
  if (near_infants(env, small, kSurroundings).empty()) return config;

  config.elevation = -20;
  std::optional<mimo_picture_config> best;
  std::size_t least_hidden = 0;
  for (const View& view : kViews) {
    const auto balls = near_infants(env, small, view.far);
    if (balls.empty()) continue;
    for (const double azimuth : kAzimuths) {
      config.fovy = view.fovy;
      config.azimuth = azimuth;
      config = view_of(balls, config);
      const std::size_t hidden = count_hidden(env, config, balls, small);
      if (!best || hidden < least_hidden) {
        best = config;
        least_hidden = hidden;
      }
      if (hidden == 0) return config;
    }
  }
  return *best;
}

}  // namespace cli
