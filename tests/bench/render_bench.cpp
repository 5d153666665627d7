// What a picture costs: both renderers against the reference step (one bare mj_step of the benchmark scene with a
// dense Jacobian, under random control), all measured in turn in one run, so that whatever else the machine does
// meets all of them. Times are those of the processor, summed over threads (OSMesa has some), so that waiting for a
// busy machine does not count.
//
//   bench_render [states, 25 by default] [instruction set]

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "bench/measured.h"
#include "engine/physics.h"
#include "opengl/renderer.h"
#include "rays/renderer.h"
#include "render/renderer.h"
#include "support/scenes.h"

namespace {

using namespace mimo;
using test::median;
using test::processor_seconds;

struct Size {
  int pixels;
  std::vector<double> ray{}, osmesa{};
  std::unique_ptr<render::Renderer> reference{};
};

int run(int states, const std::string& simd) {
  const engine::ModelPtr model = test::benchmark_model();
  engine::PhysicsOptions options;
  options.jacobian = engine::Jacobian::kDense;
  engine::Physics physics(model, options);
  rays::Options ray_options;
  ray_options.simd = simd;
  const auto ray = rays::make_renderer(model, ray_options);
  std::vector<Size> sizes;
  for (const int pixels : {64, 128, 256, 512}) sizes.push_back({pixels});
  for (Size& size : sizes) {
    try {
      size.reference = opengl::make_renderer(model, {}, {}, opengl::osmesa());
    } catch (const Error& error) {
      std::cout << format("without OSMesa: {}\n", error.message());
    }
  }

  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> steps;
  std::vector<std::uint8_t> rgb(512 * 512 * 3);
  for (int state = 0; state < states; ++state) {
    for (int step = 0; step < 40; ++step) {
      for (int i = 0; i < model->nu; ++i) {
        const double* range = model->actuator_forcerange + 2 * i;
        physics.data().ctrl[i] = range[0] + (range[1] - range[0]) * uniform(random);
      }
      const double start = processor_seconds();
      physics.step(1);
      steps.push_back(processor_seconds() - start);
    }
    for (const char* eye : {"eye_left", "eye_right"}) {
      const render::View view =
          render::camera_view(*model, physics.data(), engine::find_or_fail(*model, engine::Kind::kCamera, eye));
      for (Size& size : sizes) {
        const render::Picture picture{size.pixels, size.pixels, rgb.data()};
        for (int repeat = 0; repeat < 5; ++repeat) {
          const double start = processor_seconds();
          ray->draw(*model, physics.data(), view, picture);
          if (state > 0) size.ray.push_back(processor_seconds() - start);
        }
        if (!size.reference) continue;
        const double start = processor_seconds();
        size.reference->draw(*model, physics.data(), view, picture);
        if (state > 0) size.osmesa.push_back(processor_seconds() - start);
      }
    }
  }

  const double step = median(steps);
  std::cout << format("reference step {:.1f} us; medians of {} states, both eyes, processor time, {}\n", step * 1e6,
                      states, simd.empty() ? rays::simd_paths().front() : simd);
  std::cout << format("{:>8} {:>12} {:>8} {:>12} {:>8} {:>10}\n", "pixels", "ray [us]", "[steps]", "OSMesa [us]",
                      "[steps]", "ray faster");
  for (const Size& size : sizes) {
    const double a = median(size.ray);
    const double b = median(size.osmesa);
    std::cout << format("{:>8} {:>12.1f} {:>8.2f} {:>12.1f} {:>8.2f} {:>9.1f}x\n", size.pixels, a * 1e6, a / step,
                        b * 1e6, b / step, b / a);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc > 1 ? std::max(2, std::atoi(argv[1])) : 25, argc > 2 ? argv[2] : "");
  } catch (const Error& error) {
    std::cerr << error.message() << '\n';
    return 1;
  }
}
