// What touch costs: mean time of writing the touch fields, apart from zeroing
// them, in reference steps; and the set-up.
//
// The world is the benchmark scene under random-like motor commands. In turns
// are measured: the sense, one mj_step of the same scene with a dense Jacobian
// (the reference step), and the plain zeroing of the sense's output.
//
//   bench_touch [steps, 2000 by default]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include "bench/measured.h"
#include "senses/touch/touch.h"
#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

using mimo::test::median;

using Clock = std::chrono::steady_clock;

template <typename Work>
double seconds(Work&& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::shared_ptr<const senses::touch::Skin> make_skin(double scale) {
  senses::TouchOptions options;
  options.scale = scale;
  const mjModel& model = *benchmark_model();
  return std::make_shared<const senses::touch::Skin>(model,
                                                     senses::spacings(model, body::find_body(model, ""), options));
}

void bench_setup(double scale) {
  const std::clock_t start = std::clock();  // time of the processor: a busy machine does not count
  const std::size_t sensors = make_skin(scale)->sensors().size();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("set-up at scale %g: %zu sensors in %.1f ms\n", scale, sensors, 1e3 * seconds);
}

void bench_step(double scale, bool all_outputs, int steps) {
  senses::TouchOptions options;
  if (all_outputs) options.wanted |= MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE;
  senses::Touch sense(make_skin(scale), options);
  std::size_t bytes = 0;
  for (observation::Field& field : sense.fields()) {
    field.offset = bytes;
    bytes += field.bytes();
  }
  std::vector<std::uint8_t> block(bytes);

  const auto world = benchmark_world();
  engine::PhysicsOptions dense;
  dense.jacobian = engine::Jacobian::kDense;
  engine::Physics reference(benchmark_model(), dense);
  std::vector<double> sensing, zeroing, stepping;
  double contacts = 0;
  for (int step = 0; step < steps; ++step) {
    const std::vector<float> actions = some_actions(*world, step / 10);
    world->step(actions, nullptr, {});
    std::copy_n(world->data().ctrl, world->model().nu, reference.data().ctrl);
    sensing.push_back(seconds([&] { sense.write(world->model(), world->data(), block.data()); }));
    // A step between them: both find the caches as they are after one.
    stepping.push_back(seconds([&] { reference.step(1); }));
    zeroing.push_back(seconds([&] { std::memset(block.data(), 0, bytes); }));
    contacts += world->data().ncon;
  }
  const double felt = median(sensing) - median(zeroing);
  std::printf(
      "scale %g%s: %.1f contacts, touch %.2f us, of which zeroing %.2f "
      "us; beyond that %.2f us = %.4f x two "
      "reference steps of %.1f us (medians)\n",
      scale, all_outputs ? ", all outputs" : "", contacts / steps, 1e6 * median(sensing), 1e6 * median(zeroing),
      1e6 * felt, felt / (2 * median(stepping)), 1e6 * median(stepping));
}

}  // namespace
}  // namespace mimo::test

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::max(1, std::atoi(argv[1])) : 2000;
  mimo::test::make_skin(0.1);  // compiles the model
  for (const double scale : {1.0, 2.0, 4.0}) mimo::test::bench_setup(scale);
  for (const double scale : {1.0, 2.0, 4.0}) mimo::test::bench_step(scale, false, steps);
  mimo::test::bench_step(1, true, steps);
}
