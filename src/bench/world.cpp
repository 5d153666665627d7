#include "bench/world.h"

#include "bench/allocations.h"
#include "programs/timing.h"

namespace cli {
namespace {

mimo_env_config timed_config() {
  auto config = make_env_config();
  config.timing = 1;
  return config;
}

}  // namespace

FullWorld::FullWorld(const WorldOptions& options, std::size_t steps)
    : env_(open_world(options, timed_config())),
      block_(env_.make_block()),
      results_(env_.make_results()),
      times_(steps) {
  env_.reset(options.seed, block_);
}

void FullWorld::warm_up(const Actions& actions) {
  for (const auto& action : actions) env_.step(action, block_, results_);
  env_.reset_timing();
}

void FullWorld::run(const Actions& actions) {
  for (const auto& action : actions) {
    Allocations::start();
    const auto start = Clock::now();
    env_.step(action, block_, results_);
    times_.add(seconds_since(start));
    Allocations::stop();
    contacts_ += env_.contact_count();
  }
}

void FullWorld::reset(std::uint64_t seed) { env_.reset(seed, block_); }

}  // namespace cli
