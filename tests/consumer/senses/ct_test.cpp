// C-tactile afferents against what the literature says of strokes: top between 1 and 10 cm/s, less at 0.3 and 30; most
// at 32 degrees, less at 18 and 42; at most 100 impulses a second; fatigue; nothing on glabrous skin.
#include <vector>

#include "check.hpp"

// A forearm that stays, and a brush that is drawn over it and pressed on it by its weight.
static std::string forearm(const char* name) {
  return std::string(R"(<mujoco><option gravity="0 0 -9.81" timestep="0.002"/><worldbody><body name=")") + name +
         R"("><geom type="box" size="0.6 0.03 0.03"/></body>
<body name="brush" pos="-0.5 0 0.0495"><joint name="along" type="slide" axis="1 0 0"/>
<joint name="down" type="slide" axis="0 0 1"/><geom type="sphere" size="0.02" mass="0.05" friction="0.01 0 0"/></body>
</worldbody></mujoco>)";
}

struct Stroke {
  double speed;        // m/s
  double temperature;  // of the brush, degrees Celsius
  double seconds;
};

// The highest rate of the last tenth of a second, Hz.
static double rate_of(const char* library, const Stroke& stroke, bool tires) {
  const std::string xml = forearm("left_lower_arm");
  mimo::Scene scene = scene_around(xml.c_str(), "left_lower_arm");
  scene.set_touch(0.01);
  scene.set_temperature("brush", stroke.temperature);
  scene.load_sense(library);
  if (!tires) scene.set_parameter("ct/tiring", 0);
  mimo_env_config config = mimo::env_config();
  config.frame_skip = 5;
  mimo::Env world(scene, config);
  mimo::Block block = world.make_block();
  const auto rates = block.view<float>(world.layout().field("ct"));
  const std::int32_t along = world.find(MIMO_JOINT, "along");
  world.reset(1, block);
  double most = 0;
  const int steps = static_cast<int>(stroke.seconds / 0.01);
  for (int i = 0; i < steps; ++i) {
    world.set_values(MIMO_JOINT_VELOCITY, {along}, {stroke.speed});
    world.step({}, block);
    for (const float rate : rates) {
      check(rate >= 0 && rate <= 100, "at most 100 impulses a second");
      if (i >= steps - 10) most = std::fmax(most, rate);
    }
  }
  return most;
}

static void check_speeds(const char* library) {
  std::vector<double> rates;
  for (const double speed : {0.003, 0.01, 0.03, 0.1, 0.3}) rates.push_back(rate_of(library, {speed, 32, 1}, false));
  std::printf("0.3, 1, 3, 10, 30 cm/s: %.1f %.1f %.1f %.1f %.1f Hz\n", rates[0], rates[1], rates[2], rates[3],
              rates[4]);
  for (const int top : {1, 2, 3}) check(rates[top] > rates[0] && rates[top] > rates[4], "1 to 10 cm/s fire more");
  check(rates[2] > rates[1] && rates[2] > rates[3], "3 cm/s fires most");
  check(rates[0] < rates[2] / 2 && rates[4] < rates[2] / 2, "the ends fire less than half as much");
}

static void check_temperatures(const char* library) {
  const double cool = rate_of(library, {0.01, 18, 3}, false), neutral = rate_of(library, {0.01, 32, 3}, false),
               warm = rate_of(library, {0.01, 42, 3}, false);
  std::printf("18, 32, 42 degrees: %.1f %.1f %.1f Hz\n", cool, neutral, warm);
  check(neutral > cool && neutral > warm, "a neutral stroke fires most");
}

// The brush goes to and fro over the same skin.
static void check_fatigue(const char* library) {
  const double rested = rate_of(library, {0.03, 32, 0.5}, true);
  const std::string xml = forearm("left_lower_arm");
  mimo::Scene scene = scene_around(xml.c_str(), "left_lower_arm");
  scene.set_touch(0.01);
  scene.set_temperature("brush", 32);
  scene.load_sense(library);
  mimo::Env world(scene);
  mimo::Block block = world.make_block();
  const auto rates = block.view<float>(world.layout().field("ct"));
  const std::int32_t along = world.find(MIMO_JOINT, "along");
  world.reset(1, block);
  double most = 0;
  for (int stroke = 0; stroke < 40; ++stroke) {
    most = 0;
    for (int i = 0; i < 125; ++i) {
      world.set_values(MIMO_JOINT_VELOCITY, {along}, {stroke % 2 == 0 ? 0.03 : -0.03});
      world.step({}, block);
      for (const float rate : rates) most = std::fmax(most, rate);
    }
  }
  std::printf("first and fortieth stroke: %.1f %.1f Hz\n", rested, most);
  check(most < 0.7 * rested, "strokes of the same skin tire it");
}

static void check_glabrous(const char* library) {
  const std::string xml = forearm("left_hand");
  mimo::Scene scene = scene_around(xml.c_str(), "left_hand");
  scene.set_touch(0.01);
  scene.load_sense(library);
  try {
    const mimo::Env world(scene);
    check(false, "glabrous skin was not refused");
  } catch (const mimo::Exception& error) {
    check(std::string(error.what()).find("no hairy skin") != std::string::npos, error.what());
  }
}

// Unmyelinated: 0.9 m/s along the nerve, where the infant's delays are by its age; slower than large fibres.
static void check_delay(const char* library) {
  mimo_scene_config room = mimo::scene_config();
  room.name = "free";
  mimo::Scene scene(room);
  mimo_agent_config infant = mimo::agent_config();
  infant.vision = 0;
  infant.touch = MIMO_TOUCH_SLIP | MIMO_TOUCH_TEMPERATURE;
  scene.add_agents(&infant);
  mimo_maturity maturity;
  mimo::check(mimo_maturity_at(18, &maturity, sizeof maturity));
  scene.set_maturity(maturity);
  scene.load_sense(library);
  const mimo::Env world(scene);
  const std::vector<double> delays = world.layout().delays("ct");
  const std::vector<mimo::Receptor> skin = world.layout().receptors("ct");
  check(delays.size() == skin.size() && !skin.empty(), "a receptor for each number");
  const double length = world.get_values(MIMO_BODY_NERVE_LENGTH, {skin[0].body})[0];
  const double central = delays[0] - length / 0.9;  // from the brain stem to the cortex, the same for all
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double metres = world.get_values(MIMO_BODY_NERVE_LENGTH, {skin[i].body})[0];
    check_near(metres / 0.9 + central, delays[i], 0.011, "delay of a slow nerve");
  }
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  check_speeds(argv[1]);
  check_temperatures(argv[1]);
  check_fatigue(argv[1]);
  check_glabrous(argv[1]);
  check_delay(argv[1]);
  return failures;
}
