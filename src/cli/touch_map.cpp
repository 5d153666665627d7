#include "cli/touch_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cli/canvas.h"
#include "cli/force_colors.h"
#include "cli/lettering.h"

namespace cli {
namespace {

using mimo::Vector;

constexpr std::uint32_t kWidth = 640, kHeight = 480;
constexpr Rgb kPaper{255, 255, 255}, kSkin{140, 140, 140}, kInk{60, 60, 60};

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

}  // namespace

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

}  // namespace cli
