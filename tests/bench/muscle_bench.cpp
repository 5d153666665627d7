// What muscles cost: one update of all of them beside one bare physics step of the benchmark scene, for both bodies and
// both models. Prints microseconds of the processor's time (a busy machine does not count), medians of blocks of 100.
#include <cstdio>
#include <ctime>
#include <vector>

#include "bench/measured.h"
#include "support/scenes.h"

namespace {

using mimo::test::median;

using mimo::actuation::Mode;

template <typename Call>
double microseconds(Call&& call) {
  const std::clock_t start = std::clock();
  for (int i = 0; i < 100; ++i) call();
  return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / 100;
}

void measure(const char* body, const char* model, Mode mode) {
  mimo::env::AgentOptions agent = mimo::test::blind();
  agent.actuation.mode = mode;
  mimo::env::World world(mimo::test::benchmark_model(body), {agent}, mimo::test::without_renderer());
  mimo::actuation::Actuation& muscles = *world.agents()[0].actuation;
  std::vector<float> actions(world.action_size());
  std::vector<double> updates, steps;
  for (int block = 0; block < 40; ++block) {
    for (std::size_t i = 0; i < actions.size(); ++i) actions[i] = static_cast<float>((i * 7 + block * 13) % 10) / 10;
    world.step(actions, nullptr, {});
    steps.push_back(microseconds([&] { world.step_physics(1); }));
    updates.push_back(microseconds([&] { muscles.advance(world.physics()); }));
  }
  const double update = median(updates), step = median(steps) - update;
  std::printf("%-8s %-6s  muscles %6.2f  physics step %7.1f  share %.2f %%\n", body, model, update, step,
              100 * update / step);
}

}  // namespace

int main() {
  for (const char* body : {"mitten", "fingers"}) {
    measure(body, "MIMo", Mode::kMuscle);
    measure(body, "MuJoCo", Mode::kMujocoMuscle);
  }
}
