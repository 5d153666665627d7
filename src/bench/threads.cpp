#include <algorithm>
#include <numeric>
#include <thread>

#include "bench/measurements.h"
#include "programs/program.h"
#include "programs/senses.h"
#include "programs/summary.h"

namespace cli {
namespace {

constexpr std::size_t kBareTurn = 100;  // steps of each bare world between two looks at the others

// Steps of a batch in a turn: long enough for caches to be those of its worlds, short enough for turns to be many.
constexpr std::size_t turn_of(std::size_t worlds) { return std::max<std::size_t>(5, 100 / worlds); }

mimo::Batch open_batch(const WorldOptions& options, int worlds, int threads) {
  auto env = make_env_config();
  set_renderer(options, env);
  env.timing = 1;
  auto config = mimo::batch_config();
  config.worlds = static_cast<std::uint32_t>(worlds);
  config.threads = static_cast<std::uint32_t>(threads);
  config.autoreset = MIMO_AUTORESET_SAME_STEP;
  return mimo::Batch(make_scene(options, Senses::kAll), env, config);
}

}  // namespace

BatchWorld::BatchWorld(const WorldOptions& options, int worlds, int threads)
    : batch_(open_batch(options, worlds, threads)),
      worlds_(static_cast<std::size_t>(worlds)),
      blocks_(batch_.make_blocks()) {
  std::vector<std::uint64_t> seeds(worlds_);
  std::iota(seeds.begin(), seeds.end(), options.seed);
  batch_.reset(seeds, blocks_);
}

void BatchWorld::step(const std::vector<float>& action) {
  actions_.clear();
  for (std::size_t i = 0; i < worlds_; ++i) actions_.insert(actions_.end(), action.begin(), action.end());
  batch_.step(actions_, blocks_);
}

void BatchWorld::forget_times() {
  for (std::size_t i = 0; i < worlds_; ++i) batch_.env(i).reset_timing();
}

mimo_timing BatchWorld::timing() {
  mimo_timing sum{};
  for (std::size_t i = 0; i < worlds_; ++i) {
    const mimo_timing one = batch_.env(i).timing();
    sum.steps += one.steps;
    sum.total += one.total;
    for (const Time& part : kTimes) sum.*part.seconds += one.*part.seconds;
  }
  return sum;
}

double BatchWorld::ms_per_step() {
  const mimo_timing sum = timing();
  return sum.steps == 0 ? 0 : sum.total * 1e3 / static_cast<double>(sum.steps);
}

nlohmann::ordered_json BatchWorld::split() {
  nlohmann::ordered_json split = nlohmann::ordered_json::object();
  for (const auto& [part, ms] : split_ms(timing(), ms_per_step())) split[part] = ms;
  return split;
}

ThreadScaling::ThreadScaling(const WorldOptions& options, std::size_t steps, int worlds, int threads)
    : steps_(steps),
      worlds_(static_cast<std::size_t>(worlds)),
      threads_(static_cast<std::size_t>(threads)),
      with_threads_(options, worlds, threads),
      with_one_(options, worlds, 1),
      actions_(open_bare_world(options, make_env_config()), options.seed),
      step_with_threads_(steps),
      step_with_one_(steps),
      bare_with_threads_(steps),
      bare_with_one_(steps) {
  for (std::size_t i = 0; i < threads_; ++i) {
    bare_.push_back(std::make_unique<PhysicsWorld>(options, MIMO_JACOBIAN_MODEL, 0));
  }
}

// Everything takes turns, so that a busy machine slows all alike; ratios are of medians.
void ThreadScaling::run() {
  const auto first = actions_.draw();  // the same for both: they have to go the same way
  for (BatchWorld* batch : {&with_threads_, &with_one_}) batch->step(first);
  for (const auto& bare : bare_) bare->warm_up(draw(actions_, kBareTurn));
  with_threads_.forget_times();
  Progress progress(steps_);
  for (std::size_t done = 0; done < steps_;) {
    const std::size_t turn = std::min(turn_of(worlds_), steps_ - done);
    const Actions actions = draw(actions_, turn);
    run_batch(with_threads_, actions, step_with_threads_, true);
    if (threads_ > 1) {
      run_batch(with_one_, actions, step_with_one_, false);
      run_bare(draw(actions_, kBareTurn));
    }
    progress.show(done += turn);
  }
}

void ThreadScaling::run_batch(BatchWorld& batch, const Actions& actions, StepTimes& times, bool counted) {
  for (const auto& action : actions) {
    if (counted) AllocationCounter::start();
    const auto start = Clock::now();
    batch.step(action);
    times.add(seconds_since(start));
    if (counted) AllocationCounter::stop();
  }
}

// The same work on each of the threads at once, and on one alone.
void ThreadScaling::run_bare(const Actions& actions) {
  auto start = Clock::now();
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads_; ++i) others.emplace_back([&, i] { bare_[i]->run(actions); });
  bare_[0]->run(actions);
  for (std::thread& other : others) other.join();
  bare_with_threads_.add(seconds_since(start));

  start = Clock::now();
  bare_[0]->run(actions);
  bare_with_one_.add(seconds_since(start));
}

nlohmann::ordered_json ThreadScaling::result() {
  const double world_steps = static_cast<double>(steps_ * worlds_);
  const double simulated = bare_[0]->env().timestep() * bare_[0]->env().frame_skip();
  const double wall = step_with_threads_.sum();
  nlohmann::ordered_json result = {{"worlds", worlds_},
                                   {"threads", threads_},
                                   {"wall_s", wall},
                                   {"realtime_factor", world_steps * simulated / wall},
                                   {"ms_per_step", with_threads_.ms_per_step()},
                                   {"split_ms", with_threads_.split()},
                                   {"steps_per_second", world_steps / wall}};
  if (threads_ > 1) {
    result["scaling"] = step_with_one_.median() / step_with_threads_.median();
    result["raw_scaling"] = static_cast<double>(threads_) * bare_with_one_.median() / bare_with_threads_.median();
  }
  return result;
}

}  // namespace cli
