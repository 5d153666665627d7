#include "cli/touch_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "cli/picture.h"
#include "programs/joints.h"
#include "programs/summary.h"

namespace cli {
namespace {

using mimo::Vector;

constexpr std::uint32_t kWidth = 640, kHeight = 480;
constexpr Rgb kSkin{140, 140, 140};

// All joints of one number at 0.
mimo::Env straightened(const mimo::Env& env) {
  mimo::Env straight = env.clone();
  for (const std::int32_t joint : straight.ids(MIMO_JOINT)) {
    if (straight.width(MIMO_JOINT_POSITION, {joint}) == 1) straight.set_values(MIMO_JOINT_POSITION, {joint}, {0});
  }
  straight.update();
  return straight;
}

// The body that says where front and up are: an infant's hip, or the one that was made first.
std::int32_t trunk(const mimo::Env& env, const std::string& agent, const Skin& skin) {
  const std::string hip = agent.empty() ? "hip" : agent + "/hip";
  std::int32_t first = skin.sensors()[0].body;
  for (const Skin::Sensor& sensor : skin.sensors()) first = std::min(first, sensor.body);
  for (const std::int32_t body : env.ids(MIMO_BODY)) {
    if (env.name(MIMO_BODY, body) == hip) return body;
  }
  return first;
}

using mimo::Vector;
using Feelings = std::vector<Skin::Feeling>;

constexpr Rgb kUntouched{40, 70, 160};  // of a sensor that feels nothing
constexpr Rgb kOutline{30, 30, 30};

Spot spot(const Vector& pixel) { return {pixel[0], pixel[1]}; }
bool is_felt(const Skin::Feeling& sensor) { return norm(sensor.force) > kNothing; }

// A picture with what is needed to tell what hides what.
struct Scenery {
  ColorPicture picture;
  std::vector<float> depth;
  std::vector<std::int32_t> geoms;  // that the pixels show

  // The pixel behind which a place lies, if it is in the picture and hidden.
  bool hides(const Vector& pixel, std::size_t& at) const {
    constexpr double kOnTheSurface = 0.004;  // m
    const auto inside = [](double where, std::uint32_t size) { return where >= 0 && where < size; };
    if (pixel[2] <= 0 || !inside(pixel[0], picture.width) || !inside(pixel[1], picture.height)) return false;
    at = static_cast<std::size_t>(pixel[1]) * picture.width + static_cast<std::size_t>(pixel[0]);
    return pixel[2] > static_cast<double>(depth[at]) + kOnTheSurface;
  }
  bool shows(const Vector& pixel) const {
    std::size_t at = picture.pixels.size();
    return !hides(pixel, at) && at < picture.pixels.size();
  }
};

Scenery take(mimo::Env& env, const mimo_picture_config& config) {
  auto pictures = env.render(config, MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION);
  return {std::move(pictures.color), std::move(pictures.depth.pixels), std::move(pictures.segmentation.pixels)};
}

// What of the world itself stands between the camera and what is felt.
std::vector<std::int32_t> in_the_way(const mimo::Env& env, const Scenery& scenery, const std::vector<Vector>& pixels,
                                     const Feelings& felt) {
  std::vector<std::int32_t> geoms;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    std::size_t at = 0;
    if (!is_felt(felt[i]) || !scenery.hides(pixels[i], at)) continue;
    const std::int32_t geom = scenery.geoms[at];
    const bool known = std::find(geoms.begin(), geoms.end(), geom) != geoms.end();
    if (geom >= 0 && !known && env.body_of(MIMO_GEOM, geom) == 0) geoms.push_back(geom);
  }
  return geoms;
}

// The picture without them; what is behind them may be in the way as well.
Scenery take_free(mimo::Env& env, const mimo_picture_config& config, const std::vector<Vector>& pixels,
                  const Feelings& felt) {
  constexpr int kLayers = 4;
  Scenery scenery = take(env, config);
  const std::vector<double> colors = env.get_values(MIMO_GEOM_COLOR);
  std::vector<double> thinned = colors;
  for (int layer = 0; layer < kLayers; ++layer) {
    const auto geoms = in_the_way(env, scenery, pixels, felt);
    if (geoms.empty()) break;
    for (const std::int32_t geom : geoms) thinned[4 * static_cast<std::size_t>(geom) + 3] = 0;
    env.set_values(MIMO_GEOM_COLOR, thinned);
    scenery = take(env, config);
  }
  if (thinned != colors) env.set_values(MIMO_GEOM_COLOR, colors);
  return scenery;
}

// Those that get an arrow: the strongest of each neighbourhood, so that arrows do not cover each other.
std::vector<std::size_t> leaders(const std::vector<std::size_t>& strongest_first, const std::vector<Vector>& pixels,
                                 double apart) {
  std::vector<std::size_t> chosen;
  for (const std::size_t i : strongest_first) {
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return std::hypot(pixels[i][0] - pixels[other][0], pixels[i][1] - pixels[other][1]) < apart;
    });
    if (!near) chosen.push_back(i);
  }
  return chosen;
}

double arrow_length(double force) { return 0.02 + 0.06 * strength(force); }  // m

}  // namespace

using mimo::Vector;

Vector sum(const Vector& a, const Vector& b, double scale) {
  return {a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]};
}

double norm(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

Vector rotated(const double* q, const Vector& v) {
  const Vector u{q[1], q[2], q[3]};
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Vector t = cross(u, v);
  return sum(sum(v, t, 2 * q[0]), cross(u, t), 2);
}

Skin::Skin(const mimo::Env& env, const std::string& fields_of) {
  const mimo::Layout layout = env.layout();
  const auto agents = env.agents();
  for (const mimo_field& field : layout.fields()) {
    for (const mimo_agent_info& agent : agents) {
      if (!fields_of.empty() && fields_of != agent.name) continue;
      if (field.name == prefix(agent) + "touch/force" && field.shape[1] == 3) add(layout, field);
    }
  }
}

void Skin::add(const mimo::Layout& layout, const mimo_field& field) {
  std::size_t force = field.offset;
  for (const mimo::Receptor& receptor : layout.receptors(field.name)) {
    sensors_.push_back({receptor.body, receptor.position, receptor.normal, force});
    force += 3 * sizeof(float);
  }
}

Vector Skin::components(std::size_t sensor, const mimo::Block& block) const {
  float force[3];
  std::memcpy(force, block.data() + sensors_[sensor].force, sizeof force);
  return {double{force[0]}, double{force[1]}, double{force[2]}};
}

double Skin::force(std::size_t sensor, const mimo::Block& block) const { return norm(components(sensor, block)); }

std::vector<Skin::Feeling> Skin::feelings(const mimo::Env& env, const mimo::Block& block) const {
  const auto bodies = env.ids(MIMO_BODY);
  const auto places = env.get_values(MIMO_BODY_POSITION | MIMO_NOW, bodies),
             turns = env.get_values(MIMO_BODY_ORIENTATION | MIMO_NOW, bodies);  // as the picture shows them
  std::vector<Feeling> feelings;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const auto body = static_cast<std::size_t>(sensors_[i].body);
    const Vector place{places[3 * body], places[3 * body + 1], places[3 * body + 2]};
    const double* turn = &turns[4 * body];
    feelings.push_back({sum(place, rotated(turn, sensors_[i].position)), rotated(turn, sensors_[i].normal),
                        rotated(turn, components(i, block))});
  }
  return feelings;
}

TouchMap::TouchMap(const mimo::Env& env, const std::string& agent) : skin_(env, agent) {
  if (!possible()) return;
  const mimo::Env straight = straightened(env);
  const auto turn = straight.get_values(MIMO_BODY_ORIENTATION | MIMO_NOW, {trunk(env, agent, skin_)});
  const double back[4] = {turn[0], -turn[1], -turn[2], -turn[3]};
  for (const Skin::Feeling& sensor : skin_.feelings(straight, straight.make_block())) {
    const Vector place = rotated(back, sensor.position), normal = rotated(back, sensor.normal);
    places_.push_back({place[1], place[2], normal[0] >= 0});
  }
}

ColorPicture TouchMap::draw(const mimo::Block& block) const {
  ColorPicture picture;
  picture.width = kWidth;
  picture.height = kHeight;
  picture.pixels.assign(std::size_t{kWidth} * kHeight, kPaper);
  const auto by_height =
      std::minmax_element(places_.begin(), places_.end(), [](const Place& a, const Place& b) { return a.up < b.up; });
  const auto by_side = std::minmax_element(places_.begin(), places_.end(),
                                           [](const Place& a, const Place& b) { return a.across < b.across; });
  const double low = by_height.first->up, tall = std::max(by_height.second->up - low, 1e-6);
  const double wide = std::max(by_side.second->across - by_side.first->across, 1e-6);
  const double middle = (by_side.second->across + by_side.first->across) / 2;
  const double scale = std::min((kHeight - 90) / tall, (kWidth / 2.0 - 30) / wide);
  const auto spot = [&](const Place& place) {
    const double aside = scale * (place.across - middle);
    return Spot{kWidth / 4.0 + (place.front ? aside : kWidth / 2.0 - aside), kHeight - 70 - scale * (place.up - low)};
  };
  std::vector<std::size_t> order(places_.size());
  std::vector<double> forces(places_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (const std::size_t i : order) forces[i] = skin_.force(i, block);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return forces[a] < forces[b]; });
  for (const std::size_t i : order) {  // the strongest last, so that nothing lies over them
    const bool felt = forces[i] > kNothing;
    stroke(picture, spot(places_[i]), spot(places_[i]), felt ? 3.2 : 1.0,
           {felt ? heat(strength(forces[i])) : kSkin, 1});
  }
  const auto label = [&](const char* text, double x) {
    write(picture, text, {x - width_of(text, 2) / 2, kHeight - 50}, 2, kInk);
  };
  label("FRONT", kWidth / 4.0);
  label("BACK", 3 * kWidth / 4.0);
  draw_scale(picture);
  return picture;
}

ColorPicture TouchPicture::draw(mimo::Env& env, const mimo_picture_config& config, const mimo::Block& block) {
  const Feelings felt = skin_.feelings(env, block);
  std::vector<Vector> points, tails, above;
  for (const Skin::Feeling& f : felt) {
    const double force = norm(f.force);
    points.push_back(f.position);
    tails.push_back(sum(f.position, f.force, -arrow_length(force) / std::max(force, kNothing)));
    above.push_back(sum(f.position, f.normal, 1e-4));
  }
  const auto pixels = env.project(config, points), starts = env.project(config, tails);
  const auto lifted = env.project(config, above);
  Scenery scenery = take_free(env, config, pixels, felt);
  const auto visible = [&](std::size_t i) { return lifted[i][2] < pixels[i][2] && scenery.shows(pixels[i]); };
  const double size = config.height / 480.0;
  ColorPicture picture = scenery.picture;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    if (is_felt(felt[i])) {
      if (pixels[i][2] > 0 && starts[i][2] > 0) order.push_back(i);
    } else if (visible(i)) {
      stroke(picture, spot(pixels[i]), spot(pixels[i]), 0.8 * size, {kUntouched, 0.7});
    }
  }
  if (order.empty()) return picture;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return norm(felt[a].force) > norm(felt[b].force); });
  // Sensors that feel something show through, more weakly. The strongest come last, over all others.
  const auto opacity = [&](std::size_t i) { return visible(i) ? 1 : 0.35; };
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    const Ink ink{heat(strength(norm(felt[*i].force))), opacity(*i)};
    stroke(picture, spot(pixels[*i]), spot(pixels[*i]), 3.4 * size, {kOutline, 0.5 * ink.opacity});
    stroke(picture, spot(pixels[*i]), spot(pixels[*i]), 2.6 * size, ink);
  }
  // An arrow comes from outside and ends at its sensor.
  const auto arrows = leaders(order, pixels, 26 * size);
  for (auto i = arrows.rbegin(); i != arrows.rend(); ++i) {
    const double thick = (1 + 1.2 * strength(norm(felt[*i].force))) * size;
    arrow(picture, spot(starts[*i]), spot(pixels[*i]), thick, {kOutline, 0.8 * opacity(*i)}, size);
    arrow(picture, spot(starts[*i]), spot(pixels[*i]), thick, {heat(strength(norm(felt[*i].force))), opacity(*i)});
  }
  draw_scale(picture);
  return picture;
}

mimo_picture_config TouchPicture::close_up(mimo::Env& env, const mimo::Block& block) const {
  auto config = overview(env);
  const Feelings felt = skin_.feelings(env, block);
  Vector low{}, high{}, outward{};
  bool any = false;
  for (const Skin::Feeling& sensor : felt) {
    if (!is_felt(sensor)) continue;
    outward = sum(outward, sensor.normal, 0.05 + strength(norm(sensor.force)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = any ? std::min(low[axis], sensor.position[axis]) : sensor.position[axis];
      high[axis] = any ? std::max(high[axis], sensor.position[axis]) : sensor.position[axis];
    }
    any = true;
  }
  if (!any) return config;
  const Vector middle = sum(low, sum(high, low, -1), 0.5);
  const double far = norm(sum(high, low, -1)) / 2;
  // Against the skin, and a little from the side, so that arrows are not seen end on.
  constexpr double kAside = 25, kSteepest = 65, kNearest = 0.3, kFarthest = 1.6, kMargin = 1.35;
  const double level = std::hypot(outward[0], outward[1]);
  std::copy(middle.begin(), middle.end(), config.look_at);
  config.azimuth = std::atan2(-outward[1], -outward[0]) / kDegree + kAside;
  config.elevation = std::clamp(std::atan2(-outward[2], level) / kDegree, -kSteepest, kSteepest);
  config.distance = std::clamp(kMargin * far / std::tan(config.fovy / 2 * kDegree), kNearest, kFarthest);
  return config;
}

}  // namespace cli
