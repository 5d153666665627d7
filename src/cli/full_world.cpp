#include "full_world.h"

#include "allocations.h"
#include "timing.h"

namespace cli {
namespace {

mimo_env_config timed_config() {
  auto config = make_env_config();
  config.timing = 1;
  return config;
}

}  // namespace

FullWorld::FullWorld(const WorldOptions& options, std::size_t steps)
    : env_(open_world(options, timed_config())), block_(env_.make_block()), times_(steps) {
  env_.reset(options.seed, block_);
}

void FullWorld::warm_up(const Actions& actions) {
  for (const auto& action : actions) env_.step(action, block_);
  check(mimo_env_timing_reset(env_.get()));
}

void FullWorld::run(const Actions& actions) {
  for (const auto& action : actions) {
    Allocations::start();
    const auto start = Clock::now();
    env_.step(action, block_);
    times_.add(seconds_since(start));
    Allocations::stop();
    std::size_t contacts = 0;
    check(mimo_env_contacts(env_.get(), nullptr, nullptr, 0, &contacts));
    contacts_ += contacts;
  }
}

void FullWorld::reset(std::uint64_t seed) { env_.reset(seed, block_); }

}  // namespace cli
