// What a batch costs in resident memory, and how much of that a further world; how long saving and loading a state
// takes; and what a batch on one thread costs beyond stepping its worlds one after the other.
//
//   cmake --build build --target bench_worlds && build/bin/bench_worlds [SCENE...]
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <mimo/mimo.hpp>
#include <random>
#include <vector>

#include "batch/batch.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using Clock = std::chrono::steady_clock;

// Without what malloc keeps for later.
double resident_kb() {
  malloc_trim(0);
  long total = 0, resident = 0;
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr || std::fscanf(file, "%ld %ld", &total, &resident) != 2) std::perror("/proc/self/statm");
  if (file != nullptr) std::fclose(file);
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1024;
}

// Worlds of one model have in common what those of the interface have.
env::CompiledWorld compiled_of(const char* scene) {
  env::Services services;
  services.skins = std::make_shared<env::Skins>();
  return {room_with_infant(scene), {blind()}, without_renderer(), services};
}

// Worlds that have moved for a second: memory that was never touched is not resident.
struct Moved {
  Moved(const env::CompiledWorld& compiled, std::size_t worlds)
      : batch(compiled_worlds_of(compiled), options(worlds)),
        blocks(worlds * batch.world(0).layout().bytes()),
        actions(worlds * batch.world(0).action_size(), 0.3F) {
    batch::Output output;
    output.blocks = blocks.data();
    for (int step = 0; step < 100; ++step) batch.step(actions.data(), output);
  }

  static batch::Options options(std::size_t worlds) {
    batch::Options options;
    options.worlds = worlds;
    options.autoreset = batch::Autoreset::kSameStep;
    return options;
  }

  batch::Batch batch;
  std::vector<std::uint8_t> blocks;
  std::vector<float> actions;
};

// A batch as users make it, after a second of random play.
mimo::Batch played(const char* scene, std::size_t worlds, mimo::Block& blocks) {
  mimo_scene_config named = mimo::scene_config();
  named.name = scene;
  mimo::Scene made(named);
  mimo_agent_config agent = made.default_agent();
  agent.vision = 0;
  made.add_agents(&agent);
  mimo::Batch batch(made, worlds);
  blocks = batch.make_blocks();
  batch.reset({}, blocks);
  std::mt19937 random;
  std::vector<float> actions(worlds * batch.layout().info().actions);
  for (int step = 0; step < 100; ++step) {
    for (float& action : actions) action = static_cast<float>(random()) / 2147483648.0F - 1;
    batch.step(actions, blocks);
  }
  return batch;
}

// Two batches of a scene have as much in common, their model above all: what the larger one has more is its worlds'.
void bench_memory(const char* scene) {
  constexpr std::size_t kFew = 8, kMore = 72;
  mimo::Block of_first, of_few, of_more;
  const mimo::Batch first = played(scene, kFew, of_first);  // what the library keeps for all
  const double before = resident_kb();
  const mimo::Batch few = played(scene, kFew, of_few);
  const double between = resident_kb();
  const mimo::Batch more = played(scene, kMore, of_more);
  const double of_world = (resident_kb() - between - (between - before)) / (kMore - kFew);
  const double block = static_cast<double>(of_more.bytes()) / kMore / 1024;
  std::printf("%s: a further world takes %.0f kB, its block %.0f of them; a batch without its worlds %.0f kB\n", scene,
              of_world, block, between - before - kFew * of_world);
}

void bench_state(const char* scene) {
  Moved moved(compiled_of(scene), 1);
  env::World& world = moved.batch.world(0);
  std::vector<std::uint8_t> state(world.state_bytes());
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) {
    const auto start = Clock::now();
    world.save(Span<std::uint8_t>(state));
    world.load(Span<const std::uint8_t>(state.data(), state.size()));
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count() * 1e6);
  }
  std::nth_element(times.begin(), times.begin() + 1000, times.end());
  std::printf("%s: saving and loading %zu bytes takes %.1f us (median)\n", scene, state.size(), times[1000]);
}

double seconds_of(const std::function<void()>& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void bench_overhead(const char* scene) {
  Moved moved(compiled_of(scene), 16);
  const std::size_t bytes = moved.batch.world(0).layout().bytes(), width = moved.batch.world(0).action_size();
  batch::Output output;
  output.blocks = moved.blocks.data();
  std::vector<double> ratios;
  for (int turn = 0; turn < 200; ++turn) {
    const double together = seconds_of([&] { moved.batch.step(moved.actions.data(), output); });
    const double one_by_one = seconds_of([&] {
      for (std::size_t i = 0; i < moved.batch.size(); ++i) {
        moved.batch.world(i).step({moved.actions.data() + i * width, width}, moved.blocks.data() + i * bytes, {});
      }
    });
    ratios.push_back(together / one_by_one);
  }
  std::nth_element(ratios.begin(), ratios.begin() + 100, ratios.end());
  std::printf("%s: a batch takes %.3f of the time of its worlds stepped one by one (median)\n", scene, ratios[100]);
}

void bench(const char* scene) {
  bench_memory(scene);
  bench_state(scene);
  bench_overhead(scene);
}

}  // namespace
}  // namespace mimo::test

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) mimo::test::bench(argv[i]);
  for (const char* scene : {"reach", "benchmark"}) {
    if (argc == 1) mimo::test::bench(scene);
  }
}
