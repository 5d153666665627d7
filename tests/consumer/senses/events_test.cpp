// Events of a known step in brightness: as many as thresholds of log intensity fit into it, worked out from the
// pictures.
#include <algorithm>
#include <vector>

#include "check.hpp"

static double luma(const std::uint8_t* rgb) { return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]; }

// Rises, falls and what did not fit, of a step to another colour of the ball before the eyes.
static void check_step(const char* library, double threshold, double refractory) {
  mimo_scene_config room = mimo::scene_config();
  room.name = "free";
  mimo::Scene scene(room);
  mimo_agent_config infant = mimo::agent_config();
  infant.touch = 0;
  infant.vision_width = infant.vision_height = 32;
  scene.add_agents(&infant);
  scene.load_sense(library);
  scene.set_parameter("events/threshold", threshold);
  scene.set_parameter("events/refractory", refractory);
  mimo_env_config config = mimo::env_config();
  config.disable = MIMO_DISABLE_GRAVITY;  // nothing moves
  mimo::Env world(scene, config);
  mimo::Block block = world.make_block();
  const auto picture = block.view<std::uint8_t>(world.layout().field("vision/eye_left"));
  const auto events = block.view<float>(world.layout().field("events/eye_left"));
  std::vector<std::int32_t> all(world.count(MIMO_GEOM));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
  world.reset(1, block);
  world.step({}, block);
  check(*std::max_element(events.begin(), events.end()) == 0, "a picture that stays gives no events");
  std::vector<double> reference;
  for (std::size_t i = 0; i < picture.size(); i += 3) reference.push_back(std::log(1 + luma(&picture[i])));
  const double grey[2] = {0.05, 0.9};
  for (const double level : grey) {
    std::vector<double> colours;
    for (std::size_t i = 0; i < all.size(); ++i) colours.insert(colours.end(), {level, level, level, 1});
    world.set_values(MIMO_GEOM_COLOR, all, colours);
    world.step({}, block);
    const double most = refractory > 0 ? std::floor(0.01 / refractory + 1e-9) : 1e9;  // in a picture's 10 ms
    int wrong = 0, some = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
      const double change = std::log(1 + luma(&picture[3 * i])) - reference[i];
      const double crossed = std::floor(std::fabs(change) / threshold + 1e-5), expected = std::fmin(crossed, most);
      reference[i] += (change > 0 ? 1 : -1) * crossed * threshold;
      const double rises = change > 0 ? expected : 0, falls = change < 0 ? expected : 0;
      wrong += std::fabs(events[2 * i] - rises) > 0 || std::fabs(events[2 * i + 1] - falls) > 0;
      some += expected > 0;
    }
    check(some > 50, "the step is seen");
    check_near(0, wrong, 0.02 * some, "pixels with other events");  // single precision at a threshold
  }
  world.step({}, block);
  check(*std::max_element(events.begin(), events.end()) == 0, "after the step all is still");
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  check_step(argv[1], 0.2, 0);
  check_step(argv[1], 0.5, 0);
  check_step(argv[1], 0.2, 0.005);
  return failures;
}
