#include "touch_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "canvas.h"

namespace cli {
namespace {

using Vector = std::array<double, 3>;

constexpr Rgb kSkin{40, 70, 160};    // of a sensor that feels nothing
constexpr double kNothing = 1e-4;    // N
constexpr double kFullColor = 5;     // N; as red as it gets
constexpr double kLongestArrow = 0.05;  // m

Vector sum(const Vector& a, const Vector& b, double scale = 1) {
  return {a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]};
}
double norm(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

// By a unit quaternion w x y z.
Vector rotated(const double* q, const Vector& v) {
  const Vector u{q[1], q[2], q[3]};
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Vector t = cross(u, v);
  return sum(sum(v, t, 2 * q[0]), cross(u, t), 2);
}

// From yellow to red.
Rgb heat(double force) {
  const double share = std::sqrt(std::min(force / kFullColor, 1.0));
  return {255, static_cast<std::uint8_t>(std::lround(225 * (1 - share))), 0};
}

// A picture with the depth of each pixel: what hides what.
struct Scenery {
  ColorPicture picture;
  std::vector<float> depth;

  bool hides(const Vector& pixel) const {
    constexpr double kOnTheSurface = 0.004;  // m
    const auto inside = [](double at, std::uint32_t size) { return at >= 0 && at < size; };
    if (pixel[2] <= 0 || !inside(pixel[0], picture.width) || !inside(pixel[1], picture.height)) return true;
    const auto row = static_cast<std::size_t>(pixel[1]), column = static_cast<std::size_t>(pixel[0]);
    return pixel[2] > static_cast<double>(depth[row * picture.width + column]) + kOnTheSurface;
  }
};

Scenery take(Env& env, const mimo_picture_config& config) {
  const std::size_t pixels = std::size_t{config.width} * config.height;
  Scenery scenery{{config.width, config.height, std::vector<Rgb>(pixels)}, std::vector<float>(pixels)};
  check(mimo_env_render(env.get(), &config, &scenery.picture.pixels[0].r, pixels * sizeof(Rgb), scenery.depth.data(),
                        pixels, nullptr, 0));
  return scenery;
}

// x, y and depth in the picture.
std::vector<Vector> project(const Env& env, const mimo_picture_config& config, const std::vector<Vector>& points) {
  std::vector<Vector> pixels(points.size());
  if (points.empty()) return pixels;
  check(mimo_env_project(env.get(), &config, points[0].data(), points.size(), pixels[0].data()));
  return pixels;
}

Spot spot(const Vector& pixel) { return {pixel[0], pixel[1]}; }

}  // namespace

TouchPicture::TouchPicture(const Env& env) {
  std::size_t count = 0;
  if (!env.agent()) return;
  for (const Field& field : env.fields()) {
    const std::string end = "touch/force";
    const bool force = field.name.size() >= end.size() && field.name.substr(field.name.size() - end.size()) == end;
    if (!force || field.shape[1] != 3) continue;
    count = field.shape[0];
    offset_ = field.offset;
    break;
  }
  std::vector<std::int32_t> bodies(count);
  std::vector<double> positions(3 * count), frames(MIMO_TOUCH_FRAME_VALUES * count);
  if (count == 0) return;
  check(mimo_env_touch_sensors(env.get(), 0, bodies.data(), nullptr, positions.data(), frames.data(), count, nullptr));
  for (std::size_t i = 0; i < count; ++i) {
    const double *p = &positions[3 * i], *n = &frames[MIMO_TOUCH_FRAME_VALUES * i];
    sensors_.push_back({bodies[i], {p[0], p[1], p[2]}, {n[0], n[1], n[2]}});
  }
}

std::vector<TouchPicture::Feeling> TouchPicture::feelings(const Env& env, const Block& block) const {
  const auto bodies = env.ids(MIMO_BODY);
  const auto places = env.get(MIMO_BODY_POSITION, bodies), turns = env.get(MIMO_BODY_ORIENTATION, bodies);
  std::vector<Feeling> feelings;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const auto body = static_cast<std::size_t>(sensors_[i].body);
    const Vector place{places[3 * body], places[3 * body + 1], places[3 * body + 2]};
    float force[3];
    std::memcpy(force, block.data() + offset_ + sizeof force * i, sizeof force);
    const double* turn = &turns[4 * body];
    feelings.push_back({sum(place, rotated(turn, sensors_[i].position)), rotated(turn, sensors_[i].normal),
                        rotated(turn, {double{force[0]}, double{force[1]}, double{force[2]}})});
  }
  return feelings;
}

ColorPicture TouchPicture::draw(Env& env, const mimo_picture_config& config, const Block& block) {
  Scenery scenery = take(env, config);
  const auto felt = feelings(env, block);  // after the picture, which brings poses up to date
  double strongest = kNothing;
  std::vector<Vector> points, tails;
  for (const Feeling& f : felt) strongest = std::max(strongest, norm(f.force));
  for (const Feeling& f : felt) {
    points.push_back(f.position);
    tails.push_back(sum(f.position, f.force, -kLongestArrow / strongest));
  }
  const auto pixels = project(env, config, points), starts = project(env, config, tails);
  const double size = config.height / 480.0;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    if (norm(felt[i].force) > kNothing || scenery.hides(pixels[i])) continue;
    stroke(scenery.picture, spot(pixels[i]), spot(pixels[i]), 0.8 * size, {kSkin, 0.7});
  }
  // An arrow comes from outside and ends at its sensor; it shows through, like the sensors that feel something.
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const double force = norm(felt[i].force);
    if (force <= kNothing || pixels[i][2] <= 0 || starts[i][2] <= 0) continue;
    const double opacity = scenery.hides(pixels[i]) ? 0.35 : 1;
    arrow(scenery.picture, spot(starts[i]), spot(pixels[i]), 0.7 * size, {heat(force), opacity});
    stroke(scenery.picture, spot(pixels[i]), spot(pixels[i]), 2 * size, {heat(force), opacity});
  }
  return scenery.picture;
}

mimo_picture_config TouchPicture::close_up(const Env& env, const Block& block) const {
  auto config = overview(env);
  const auto felt = feelings(env, block);
  const auto strongest = std::max_element(felt.begin(), felt.end(), [](const Feeling& a, const Feeling& b) {
    return norm(a.force) < norm(b.force);
  });
  if (strongest == felt.end() || norm(strongest->force) <= kNothing) return config;
  constexpr double kDegree = 3.14159265358979323846 / 180;
  // Against the skin, and a little from the side, so that arrows are not seen end on.
  const Vector& normal = strongest->normal;
  const double level = std::hypot(normal[0], normal[1]);
  std::copy(strongest->position.begin(), strongest->position.end(), config.look_at);
  config.azimuth = std::atan2(-normal[1], -normal[0]) / kDegree + 35;
  config.elevation = std::clamp(std::atan2(-normal[2], level) / kDegree, -60.0, 60.0);
  config.distance = 0.35;
  return config;
}

}  // namespace cli
