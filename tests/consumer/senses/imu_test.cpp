// Inertial sensors against kinematics: 9.81 m/s^2 upwards at rest, w^2 r on a turning arm, and the data sheet's noise.
#include "check.hpp"

// Five sensors in a row on an arm that turns about a vertical axis without friction, 0 to 0.8 m from it.
static const char* const kArm = R"(<mujoco><option gravity="0 0 -9.81" timestep="0.005"/>
<worldbody><body name="arm"><joint name="axis" type="hinge" axis="0 0 1"/><geom size="0.1" mass="1"/>
<body name="head"><geom size="0.01"/></body>
<body name="left_hand" pos="0.2 0 0"><geom size="0.01"/></body>
<body name="right_hand" pos="0.4 0 0"><geom size="0.01"/></body>
<body name="left_foot" pos="0.5 0 0"><geom size="0.01"/></body>
<body name="right_foot" pos="0.8 0 0"><geom size="0.01"/></body>
</body></worldbody></mujoco>)";
enum Place { kLeftFoot, kRightFoot, kLeftHand, kRightHand, kHead, kPlaces };
static const double kRadius[kPlaces] = {0.5, 0.8, 0.2, 0.4, 0};

static mimo::Scene arm(const char* library, double noise, double bias) {
  mimo::Scene scene = scene_around(kArm, "arm");
  scene.load_sense(library);
  scene.set_parameter("imu/noise", noise);
  scene.set_parameter("imu/bias", bias);
  return scene;
}

static void turn(mimo::Env& world, double speed) {
  world.set_values(MIMO_JOINT_VELOCITY, {world.find(MIMO_JOINT, "axis")}, {speed});
}

static void check_kinematics(const char* library) {
  const mimo::Scene scene = arm(library, 0, 0);
  mimo::Env world(scene);
  mimo::Block block = world.make_block();
  const auto acceleration = block.view<float>(world.layout().field("imu/acceleration"));
  const auto turning = block.view<float>(world.layout().field("imu/angular_velocity"));
  for (const double speed : {0.0, 4.0, 20.0}) {
    world.reset(1, block);
    turn(world, speed);
    for (int i = 0; i < 3; ++i) world.step({}, block);
    for (std::size_t place = 0; place < kPlaces; ++place) {
      const double inwards = std::fmin(speed * speed * kRadius[place], 8 * 9.80665);  // the range is 8 g
      check_near(-inwards, acceleration[3 * place], 1e-3, "centripetal acceleration");
      check_near(0, acceleration[3 * place + 1], 1e-3, "tangential acceleration");
      check_near(9.81, acceleration[3 * place + 2], 1e-4, "gravity");
      check_near(std::fmin(speed, 1000 * 3.14159265358979 / 180), turning[3 * place + 2], 1e-4, "angular velocity");
    }
  }
}

// Of n numbers the standard deviation is known to 1 / sqrt(2 n): 5 such errors are 5 % of 5000.
static void check_noise(const char* library) {
  const mimo::Scene scene = arm(library, 1, 0);
  mimo::Env world(scene);
  mimo::Block block = world.make_block();
  const auto acceleration = block.view<float>(world.layout().field("imu/acceleration"));
  const auto turning = block.view<float>(world.layout().field("imu/angular_velocity"));
  double squares[2] = {0, 0};
  world.reset(3, block);
  for (int i = 0; i < 1000; ++i) {
    world.step({}, block);
    for (std::size_t place = 0; place < kPlaces; ++place) {
      squares[0] += std::pow(acceleration[3 * place + 2] - 9.81, 2);
      squares[1] += std::pow(turning[3 * place + 2], 2);
    }
  }
  // Data sheet, in a band of 50 Hz at 100 samples a second: 180 ug/sqrt(Hz), 0.007 deg/s/sqrt(Hz).
  const double band = std::sqrt(50.0), sheet[2] = {180e-6 * 9.80665 * band, 0.007 * 3.14159265358979 / 180 * band};
  check_near(sheet[0], std::sqrt(squares[0] / 5000), 0.05 * sheet[0], "noise of acceleration");
  check_near(sheet[1], std::sqrt(squares[1] / 5000), 0.05 * sheet[1], "noise of angular velocity");
}

// An offset stays the same in an episode, differs between episodes, and is that of the seed.
static void check_bias(const char* library) {
  const mimo::Scene scene = arm(library, 0, 1);
  mimo::Env world(scene);
  mimo::Block block = world.make_block();
  const auto acceleration = block.view<float>(world.layout().field("imu/acceleration"));
  double squares = 0;
  for (int episode = 0; episode < 100; ++episode) {
    world.reset(static_cast<std::uint64_t>(episode), block);
    const float first = acceleration[0];
    world.step({}, block);
    check(acceleration[0] == first, "an offset stays");
    for (std::size_t i = 0; i < 3 * kPlaces; i += 3) squares += std::pow(acceleration[i], 2);
    world.reset(static_cast<std::uint64_t>(episode), block);
    check(acceleration[0] == first, "an offset follows from the seed");
  }
  // 40 mg, from 500 numbers: 5 / sqrt(1000) is 16 %.
  check_near(40e-3 * 9.80665, std::sqrt(squares / 500), 0.16 * 40e-3 * 9.80665, "offset of acceleration");
}

// 50 samples a second: one for each second step of 10 ms, and four in a step of 80 ms.
static void check_rate(const char* library) {
  mimo::Scene scene = arm(library, 1, 0);
  scene.set_parameter("imu/rate", 50);
  mimo_env_config config = mimo::env_config();
  mimo::Env world(scene, config);
  mimo::Block block = world.make_block();
  const auto acceleration = block.view<float>(world.layout().field("imu/acceleration"));
  world.reset(1, block);
  int changes = 0;
  for (int i = 0; i < 20; ++i) {
    const float before = acceleration[0];
    world.step({}, block);
    changes += acceleration[0] != before;
  }
  check_near(10, changes, 0, "new samples in 20 steps");
  config.frame_skip = 16;
  const mimo::Env slow(scene, config);
  check(slow.layout().field("imu/acceleration").shape[1] == 4, "four samples in a step of 80 ms");
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  check_kinematics(argv[1]);
  check_noise(argv[1]);
  check_bias(argv[1]);
  check_rate(argv[1]);
  return failures;
}
