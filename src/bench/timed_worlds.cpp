#include "bench/timed_worlds.h"

#include "bench/measurements.h"
#include "programs/summary.h"

namespace cli {
namespace {

mimo_env_config bare_config(std::int32_t jacobian) {
  auto config = make_env_config();
  config.jacobian = jacobian;
  config.disable = MIMO_DISABLE_OWN_SOLVER;  // bare means mj_step and nothing else
  return config;
}

mimo_env_config timed_config() {
  auto config = make_env_config();
  config.timing = 1;
  return config;
}

}  // namespace

Actions draw(RandomActions& random, std::size_t count) {
  Actions actions(count);
  std::generate(actions.begin(), actions.end(), [&] { return random.draw(); });
  return actions;
}

PhysicsWorld::PhysicsWorld(const WorldOptions& world, std::int32_t jacobian, std::size_t steps)
    : env_(open_bare_world(world, bare_config(jacobian))), motors_(world.actuation == "torque"), times_(steps) {
  if (motors_) {
    for (const mimo_action& action : env_.layout().actions()) {
      actuators_.push_back(env_.find(MIMO_ACTUATOR, action.name));
    }
  }
  env_.reset(world.seed, nothing_);
}

void PhysicsWorld::step(const std::vector<float>& action) {
  if (!motors_) return env_.step(action, nothing_, unwanted_);
  for (std::size_t i = 0; i < env_.frame_skip(); ++i) env_.physics_step(1);  // each of them whole, with its sensors
}

void PhysicsWorld::run(const Actions& actions) {
  const double frame_skip = env_.frame_skip();
  for (const auto& action : actions) {
    if (motors_) env_.set_values(MIMO_ACTUATOR_CONTROL, actuators_, std::vector<double>(action.begin(), action.end()));
    const auto start = Clock::now();
    step(action);
    times_.add(seconds_since(start) / frame_skip);
  }
}

void PhysicsWorld::go_to(const mimo::Env& other) {
  const auto joints = env_.ids(MIMO_JOINT);
  for (const std::int32_t quantity : {MIMO_JOINT_POSITION, MIMO_JOINT_VELOCITY}) {
    env_.set_values(quantity, joints, other.get_values(quantity, joints));
  }
}

void PhysicsWorld::warm_up(const Actions& actions) {
  run(actions);
  forget();
}

SensingWorld::SensingWorld(const WorldOptions& options, std::size_t steps)
    : env_(open_world(options, timed_config())),
      block_(env_.make_block()),
      results_(env_.make_results()),
      times_(steps) {
  env_.reset(options.seed, block_);
}

void SensingWorld::warm_up(const Actions& actions) {
  for (const auto& action : actions) env_.step(action, block_, results_);
  env_.reset_timing();
}

void SensingWorld::run(const Actions& actions) {
  for (const auto& action : actions) {
    AllocationCounter::start();
    const auto start = Clock::now();
    env_.step(action, block_, results_);
    times_.add(seconds_since(start));
    AllocationCounter::stop();
    contacts_ += env_.contact_count();
  }
}

void SensingWorld::reset(std::uint64_t seed) { env_.reset(seed, block_); }

}  // namespace cli
