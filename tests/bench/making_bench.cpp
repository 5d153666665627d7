// What it takes to make a world of a built-in scene with everything that it has by itself, eyes too, and a clone of it;
// and what a world of ten infants takes.
//
//   cmake --build build --target bench_making && build/bin/bench_making [SCENE...]
//
// The first world of a process also decodes the pictures. Times are of the processor, medians. In brackets they are in
// physics steps of the benchmark scene as the original solves it (dense Jacobian), measured in turns with them.
#include <array>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

#include "bench/measured.h"
#include "blueprint/agents.h"
#include "blueprint/aging_world.h"
#include "blueprint/blueprint.h"
#include "capi/configs.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using mimo::test::median;

double milliseconds_of(const std::function<void()>& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

// A step of the benchmark scene, dense.
class Reference {
 public:
  Reference() : physics_(room_with_infant("benchmark"), options()) {}
  double step() {
    return milliseconds_of([&] { physics_.step(100); }) / 100;
  }

 private:
  static engine::PhysicsOptions options() {
    engine::PhysicsOptions options;
    options.jacobian = engine::Jacobian::kDense;
    options.own_solver = false;
    return options;
  }

  engine::Physics physics_;
};

using WorldPtr = std::unique_ptr<blueprint::AgingWorld>;

WorldPtr make(const char* scene) {
  const auto worlds =
      std::make_shared<blueprint::WorldsByAge>(capi::ready_world(scene).current(), env::EnvOptions{}, LogSink{});
  return std::make_unique<blueprint::AgingWorld>(worlds, worlds->as_described({}, {}), blueprint::Surroundings{});
}

void bench_making(const char* scene, Reference& reference) {
  constexpr int kTurns = 7;
  std::vector<double> steps, making, cloning;
  for (int turn = 0; turn < kTurns; ++turn) {
    WorldPtr made;
    steps.push_back(reference.step());
    making.push_back(milliseconds_of([&] { made = make(scene); }));
    for (int i = 0; i < 5; ++i) {
      WorldPtr clone;
      cloning.push_back(
          milliseconds_of([&] { clone = std::make_unique<blueprint::AgingWorld>(*made, env::Identity{}); }));
    }
  }
  const double step = median(steps);
  std::printf("%s: making takes %.1f ms (%.0f steps), the first in this process %.1f; a clone %.2f ms (%.2f steps)\n",
              scene, median(making), median(making) / step, making.front(), median(cloning), median(cloning) / step);
}

void bench_ten_infants() {
  scene::Scene scene(named("free"));
  for (int i = 0; i < 10; ++i) {
    const document::Pose pose{{0.8 * (i % 5), 0.8 * (i / 5), 0.3}, {1, 0, 0, 0}};
    scene.add_body("mitten", "i" + std::to_string(i) + "/", &pose);
  }
  const engine::Physics physics(compile(scene), {});
  const mjData& data = physics.data();
  std::printf("ten infants: a world's mjData has %.1f MB without the Jacobian, of which %.1f are the solver's stack\n",
              1e-6 * (static_cast<double>(data.nbuffer) + 8.0 * data.nstack), 8e-6 * data.nstack);
}

}  // namespace
}  // namespace mimo::test

int main(int argc, char** argv) {
  constexpr std::array<const char*, 4> kUsual{"benchmark", "reach", "showroom", "playdate"};
  mimo::test::Reference reference;
  for (int i = 1; i < argc; ++i) mimo::test::bench_making(argv[i], reference);
  for (const char* scene : kUsual) {
    if (argc == 1) mimo::test::bench_making(scene, reference);
  }
  mimo::test::bench_ten_infants();
}
