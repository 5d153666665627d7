// What a further world of a batch costs in resident memory, against its mjData (but for the constraints' Jacobian,
// which lies behind what MuJoCo counts) and its block; and how long saving and loading a state takes; and what a batch
// on one thread costs beyond stepping its worlds one after the other.
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

void bench_memory(const char* scene) {
  constexpr std::size_t kFew = 8, kMore = 64;
  mimo::Block of_few, of_more;
  const mimo::Batch few = played(scene, kFew, of_few);
  const double before = resident_kb();
  const mimo::Batch more = played(scene, kMore, of_more);
  const double of_one = (resident_kb() - before) / kMore;
  const Moved one(compiled_of(scene), 1);
  const env::World& world = one.batch.world(0);
  const double data = (static_cast<double>(sizeof(mjData)) + world.data().nbuffer + 8.0 * world.data().nstack) / 1024;
  const double block = static_cast<double>(of_more.bytes()) / kMore / 1024;
  std::printf(
      "%s: a further world takes %.0f kB; its mjData has %.0f without the Jacobian, its block %.0f: %.2f x that "
      "mjData beyond the block\n",
      scene, of_one, data, block, (of_one - block) / data);
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

}  // namespace
}  // namespace mimo::test

int main(int argc, char** argv) {
  std::vector<const char*> scenes(argv + 1, argv + argc);
  if (scenes.empty()) scenes = {"reach", "benchmark"};
  for (const char* scene : scenes) {
    mimo::test::bench_memory(scene);
    mimo::test::bench_state(scene);
    mimo::test::bench_overhead(scene);
  }
}
