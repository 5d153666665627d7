#include "touch_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "canvas.h"
#include "facts.h"

namespace cli {
namespace {

using mimo::Vector;

constexpr Rgb kSkin{40, 70, 160};       // of a sensor that feels nothing
constexpr double kNothing = 1e-4;       // N
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
Rgb heat(double share) { return {255, static_cast<std::uint8_t>(std::lround(225 * (1 - share))), 0}; }

// A picture with what is needed to tell what hides what.
struct Scenery {
  ColorPicture picture;
  std::vector<float> depth;
  std::vector<bool> movable;  // the pixel shows a body that can move

  // From below one looks through floors, at the body that matters; anything else would show through it.
  bool hides(const Vector& pixel, bool matters) const {
    constexpr double kOnTheSurface = 0.004;  // m
    const auto inside = [](double at, std::uint32_t size) { return at >= 0 && at < size; };
    if (pixel[2] <= 0 || !inside(pixel[0], picture.width) || !inside(pixel[1], picture.height)) return true;
    const std::size_t at = static_cast<std::size_t>(pixel[1]) * picture.width + static_cast<std::size_t>(pixel[0]);
    return (movable[at] || !matters) && pixel[2] > static_cast<double>(depth[at]) + kOnTheSurface;
  }
};

Scenery take(mimo::Env& env, const mimo_picture_config& config) {
  auto pictures = env.render(config, MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION);
  Scenery scenery{std::move(pictures.color), std::move(pictures.depth.pixels), {}};
  for (const std::int32_t geom : pictures.segmentation.pixels) {
    scenery.movable.push_back(geom >= 0 && env.body_of(MIMO_GEOM, geom) != 0);
  }
  return scenery;
}

Spot spot(const Vector& pixel) { return {pixel[0], pixel[1]}; }

}  // namespace

TouchPicture::TouchPicture(const mimo::Env& env) {
  const mimo::Layout layout = env.layout();
  const auto agents = env.agents();
  for (const mimo_field& field : layout.fields()) {
    for (const mimo_agent_info& agent : agents) {
      if (field.name == prefix(agent) + "touch/force" && field.shape[1] == 3) add(layout, field);
    }
  }
}

void TouchPicture::add(const mimo::Layout& layout, const mimo_field& field) {
  std::size_t force = field.offset;
  for (const mimo::Receptor& receptor : layout.receptors(field.name)) {
    sensors_.push_back({receptor.body, receptor.position, receptor.normal, force});
    force += 3 * sizeof(float);
  }
}

std::vector<TouchPicture::Feeling> TouchPicture::feelings(const mimo::Env& env, const mimo::Block& block) const {
  const auto bodies = env.ids(MIMO_BODY);
  const auto places = env.get_values(MIMO_BODY_POSITION | MIMO_NOW, bodies),
             turns = env.get_values(MIMO_BODY_ORIENTATION | MIMO_NOW, bodies);  // as the picture shows them
  std::vector<Feeling> feelings;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const auto body = static_cast<std::size_t>(sensors_[i].body);
    const Vector place{places[3 * body], places[3 * body + 1], places[3 * body + 2]};
    float force[3];
    std::memcpy(force, block.data() + sensors_[i].force, sizeof force);
    const double* turn = &turns[4 * body];
    feelings.push_back({sum(place, rotated(turn, sensors_[i].position)), rotated(turn, sensors_[i].normal),
                        rotated(turn, {double{force[0]}, double{force[1]}, double{force[2]}})});
  }
  return feelings;
}

std::size_t TouchPicture::strongest_of(const std::vector<Feeling>& felt) {
  const auto weaker = [](const Feeling& a, const Feeling& b) { return norm(a.force) < norm(b.force); };
  return static_cast<std::size_t>(std::max_element(felt.begin(), felt.end(), weaker) - felt.begin());
}

ColorPicture TouchPicture::draw(mimo::Env& env, const mimo_picture_config& config, const mimo::Block& block) {
  Scenery scenery = take(env, config);
  const auto felt = feelings(env, block);
  const std::size_t most = strongest_of(felt);
  const double strongest = std::max(norm(felt[most].force), kNothing);
  std::vector<Vector> points, tails, above;
  for (const Feeling& f : felt) {
    points.push_back(f.position);
    tails.push_back(sum(f.position, f.force, -kLongestArrow / strongest));
    above.push_back(sum(f.position, f.normal, 1e-4));
  }
  const auto pixels = env.project(config, points), starts = env.project(config, tails);
  const auto lifted = env.project(config, above);
  const auto hidden = [&](std::size_t i) {
    const bool matters = sensors_[i].body == sensors_[most].body;
    return lifted[i][2] >= pixels[i][2] || scenery.hides(pixels[i], matters);
  };
  const double size = config.height / 480.0;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    if (norm(felt[i].force) > kNothing || hidden(i)) continue;
    stroke(scenery.picture, spot(pixels[i]), spot(pixels[i]), 0.8 * size, {kSkin, 0.7});
  }
  // An arrow comes from outside and ends at its sensor; it shows through, like the sensors that feel something.
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const double force = norm(felt[i].force);
    if (force <= kNothing || pixels[i][2] <= 0 || starts[i][2] <= 0) continue;
    const Ink ink{heat(force / strongest), hidden(i) ? 0.35 : 1};
    arrow(scenery.picture, spot(starts[i]), spot(pixels[i]), 0.7 * size, ink);
    stroke(scenery.picture, spot(pixels[i]), spot(pixels[i]), 2 * size, ink);
  }
  return scenery.picture;
}

mimo_picture_config TouchPicture::close_up(mimo::Env& env, const mimo::Block& block) const {
  auto config = overview(env);
  const auto felt = feelings(env, block);
  const Feeling& strongest = felt[strongest_of(felt)];
  if (norm(strongest.force) <= kNothing) return config;
  constexpr double kDegree = 3.14159265358979323846 / 180;
  // Against the skin, and a little from the side, so that arrows are not seen end on.
  const Vector& normal = strongest.normal;
  const double level = std::hypot(normal[0], normal[1]);
  std::copy(strongest.position.begin(), strongest.position.end(), config.look_at);
  config.azimuth = std::atan2(-normal[1], -normal[0]) / kDegree + 35;
  config.elevation = std::clamp(std::atan2(-normal[2], level) / kDegree, -60.0, 60.0);
  config.distance = 0.35;
  return config;
}

}  // namespace cli
