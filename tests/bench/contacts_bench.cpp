// What it costs to record what touches what within a step (step_contacts): two worlds of the benchmark scene that go
// the same way, one of which records, are stepped in turns without senses.
//
//   bench_contacts [steps, 4000 by default]
#include <mimo/mimo.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

void check(mimo_status status) {
  if (status == MIMO_OK) return;
  std::fprintf(stderr, "%s\n", mimo_last_error());
  std::exit(1);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

mimo_env* make(bool records) {
  mimo_scene_config named;
  check(mimo_scene_config_init(&named, sizeof named));
  named.name = "benchmark";
  mimo_scene* scene = nullptr;
  check(mimo_scene_create(&named, &scene));
  mimo_agent_config blind;
  check(mimo_scene_default_agent(scene, &blind, sizeof blind));
  blind.vision = 0;
  check(mimo_scene_add_agent(scene, &blind, nullptr));
  mimo_env_config config;
  check(mimo_env_config_init(&config, sizeof config));
  config.step_contacts = records ? 1 : 0;
  mimo_env* env = nullptr;
  check(mimo_env_create(scene, &config, &env));
  mimo_scene_destroy(scene);
  return env;
}

// Each motor has a rhythm of its own.
std::vector<float> wish(std::size_t actions, int step) {
  std::vector<float> action(actions);
  for (std::size_t i = 0; i < actions; ++i) {
    action[i] = static_cast<float>(std::sin(0.05 * step * (1 + 0.1 * static_cast<double>(i)) + static_cast<double>(i)));
  }
  return action;
}

double seconds(mimo_env* env, const std::vector<float>& action) {
  const auto start = Clock::now();
  check(mimo_env_step(env, action.data(), action.size(), nullptr, 0, nullptr));
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 4000;
  mimo_env *const recording = make(true), *const usual = make(false);
  const mimo_layout* layout = nullptr;
  mimo_layout_info info{};
  info.struct_size = sizeof info;
  check(mimo_env_layout(usual, &layout));
  check(mimo_layout_describe(layout, &info));

  std::vector<double> with, without, shares;
  std::size_t pairs = 0;
  for (int step = 0; step < steps; ++step) {
    const std::vector<float> action = wish(info.actions, step);
    // Who goes second finds warm caches: they take turns at that, too.
    if (step % 2 == 0) with.push_back(seconds(recording, action));
    without.push_back(seconds(usual, action));
    if (step % 2 != 0) with.push_back(seconds(recording, action));
    shares.push_back(with.back() / without.back() - 1);
    std::size_t now = 0;
    check(mimo_env_count(recording, MIMO_STEP_CONTACT, &now));
    pairs += now;
  }
  std::printf(
      "a step takes %.1f us, with its contacts recorded %.1f us: %.4f of a step more (median); %.1f pairs touch\n",
      median(without) * 1e6, median(with) * 1e6, median(shares),
      static_cast<double>(pairs) / static_cast<double>(steps));
  mimo_env_destroy(recording);
  mimo_env_destroy(usual);
}
