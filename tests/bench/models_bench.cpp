// What pictures of models cost, of 256 x 256 pixels, colour and depth, on one thread: rays, and where there is OSMesa
// MuJoCo's own renderer in turns with them. Times are those of the processor, as in bench_render.
//
//   bench_models ring [ROUNDS]      a ring of 20,736 triangles before an infant's eyes, near to far, over the same
//                                   picture without it
//   bench_models [--alone] FILE[:AZIMUTH,ELEVATION,DISTANCE,X,Y,Z] ...
//                                   MJCF files, seen by MuJoCo's free camera: from its default place, or from this one;
//                                   alone: rays only
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "base/numbers.h"
#include "bench/measured.h"
#include "engine/model.h"
#include "engine/physics.h"
#include "opengl/renderer.h"
#include "rays/renderer.h"
#include "render/renderer.h"
#include "support/scenes.h"

namespace {

using namespace mimo;
using test::median;
using test::processor_seconds;

constexpr int kPixels = 256;

// A renderer's picture, and a number that changes when it does.
class Picture {
 public:
  double draw(render::Renderer& renderer, const mjModel& model, const mjData& data, const render::View& view) {
    const double start = processor_seconds();
    renderer.draw(model, data, view, {kPixels, kPixels, rgb_.data(), depth_.data(), nullptr});
    return processor_seconds() - start;
  }
  // FNV-1a of colours and depths.
  std::uint64_t sum() const {
    std::uint64_t sum = 14695981039346656037ULL;
    const auto add = [&sum](const void* data, std::size_t size) {
      for (std::size_t i = 0; i < size; ++i)
        sum = (sum ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211ULL;
    };
    add(rgb_.data(), rgb_.size());
    add(depth_.data(), depth_.size() * sizeof(float));
    return sum;
  }

 private:
  std::vector<std::uint8_t> rgb_ = std::vector<std::uint8_t>(kPixels * kPixels * 3);
  std::vector<float> depth_ = std::vector<float>(kPixels * kPixels);
};

std::unique_ptr<render::Renderer> osmesa_for(const engine::ModelPtr& model) {
  try {
    return opengl::make_renderer(model, {}, {}, opengl::osmesa());
  } catch (const Error& error) {
    if (error.status() != Status::kUnsupported) throw;
    return nullptr;
  }
}

// Vertices and triangles of a ring around its x axis, radius 1, whose tube is a third as thick.
std::string ring() {
  constexpr int kAround = 144;
  constexpr int kAlong = 72;
  std::string vertices, normals, faces;
  for (int i = 0; i < kAround; ++i) {
    for (int k = 0; k < kAlong; ++k) {
      const double a = 2 * kPi * i / kAround;
      const double b = 2 * kPi * k / kAlong;
      const double r = 1 + std::cos(b) / 3;
      vertices += format("{} {} {} ", std::sin(b) / 3, r * std::cos(a), r * std::sin(a));
      normals += format("{} {} {} ", std::sin(b), std::cos(a) * std::cos(b), std::sin(a) * std::cos(b));
      const int here = i * kAlong + k;
      const int beside = i * kAlong + (k + 1) % kAlong;
      const int next = (i + 1) % kAround * kAlong + k;
      const int both = (i + 1) % kAround * kAlong + (k + 1) % kAlong;
      faces += format("{} {} {} {} {} {} ", here, next, both, here, both, beside);
    }
  }
  return "<asset><mesh name='ring' scale='.1 .1 .1' vertex='" + vertices + "' normal='" + normals + "' face='" + faces +
         "'/></asset>";
}

double share_of(render::Renderer& renderer, const mjModel& model, const mjData& data, const render::View& view,
                int geom) {
  std::vector<std::int32_t> ids(kPixels * kPixels);
  renderer.draw(model, data, view, {kPixels, kPixels, nullptr, nullptr, ids.data()});
  return static_cast<double>(std::count(ids.begin(), ids.end(), geom)) / (kPixels * kPixels);
}

int compare_ring(int rounds) {
  scene::Scene scene(test::from_text("<mujoco><include file='mimo/benchmark.xml'/>" + ring() +
                                     "<worldbody><geom name='ring' type='mesh' mesh='ring' contype='0' "
                                     "conaffinity='0' rgba='.8 .4 .3 1'/></worldbody></mujoco>"));
  scene.add_body("mitten", "", nullptr);
  const engine::ModelPtr model = test::compile(scene);
  mjModel& change = const_cast<mjModel&>(*model);  // nobody else has it
  const int geom = engine::find_or_fail(*model, engine::Kind::kGeom, "ring");
  engine::Physics physics(model, {});
  const auto renderer = rays::make_renderer(model, {});
  Picture picture;
  for (const double distance : {0.35, 0.5, 0.8}) {
    std::vector<double> without, with;
    double share = 0;
    std::uint64_t sum = 0;
    for (int round = 0; round < rounds; ++round) {
      for (const char* eye : {"eye_left", "eye_right"}) {
        for (const bool there : {false, true}) {
          physics.forward();
          const int camera = engine::find_or_fail(*model, engine::Kind::kCamera, eye);
          const render::View view = render::camera_view(*model, physics.data(), camera);
          const Eigen::Vector3d at =
              view.position - view.rotation.col(2) * (there ? distance : -distance) + view.rotation.col(1) * 0.02;
          std::copy_n(at.data(), 3, change.geom_pos + 3 * geom);
          physics.forward();
          const double time = picture.draw(*renderer, *model, physics.data(), view);
          if (round > 0) (there ? with : without).push_back(time);
          if (!there || round > 0) continue;
          sum ^= picture.sum();
          share += share_of(*renderer, *model, physics.data(), view, geom) / 2;
        }
      }
    }
    std::cout << format("ring at {:.2f} m covers {:.3f}: {:.1f} us, without {:.1f} us, times {:.2f} ({})\n", distance,
                        share, median(with) * 1e6, median(without) * 1e6, median(with) / median(without), sum);
  }
  return 0;
}

engine::ModelPtr load(const std::string& file) {
  char message[1000] = "";
  mjModel* const model = mj_loadXML(file.c_str(), nullptr, message, sizeof message);
  if (model == nullptr) fail(Status::kModel, "{}: {}", file, message);
  return {model, [](const mjModel* old) { mj_deleteModel(const_cast<mjModel*>(old)); }};
}

render::Viewpoint free_camera(const mjModel& model, const char* place) {
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  render::Viewpoint from;
  from.azimuth = camera.azimuth;
  from.elevation = camera.elevation;
  from.distance = 1.5 * model.stat.extent;
  from.look_at = Eigen::Map<const Eigen::Vector3d>(model.stat.center);
  if (place != nullptr) {
    std::sscanf(place, "%lf,%lf,%lf,%lf,%lf,%lf", &from.azimuth, &from.elevation, &from.distance, &from.look_at[0],
                &from.look_at[1], &from.look_at[2]);
  }
  return from;
}

void compare_model(const std::string& what, bool alone) {
  const std::size_t colon = what.find(':');
  const engine::ModelPtr model = load(what.substr(0, colon));
  engine::Physics physics(model, {});
  physics.forward();
  const auto from = free_camera(*model, colon == std::string::npos ? nullptr : what.c_str() + colon + 1);
  const render::View view = render::view_from(*model, physics.data(), from);
  const auto rays = rays::make_renderer(model, {});
  const auto osmesa = alone ? nullptr : osmesa_for(model);
  Picture ours, theirs;
  std::vector<double> a, b;
  for (int round = 0; round < 15; ++round) {
    for (int repeat = 0; repeat < 5; ++repeat) {
      const double time = ours.draw(*rays, *model, physics.data(), view);
      if (round > 0) a.push_back(time);
    }
    if (osmesa == nullptr) continue;
    const double time = theirs.draw(*osmesa, *model, physics.data(), view);
    if (round > 0) b.push_back(time);
  }
  std::cout << format("{:>20}: rays {:.3f} ms, OSMesa {:.2f} ms, rays are {:.1f} times as fast ({})\n",
                      what.substr(0, colon).substr(what.substr(0, colon).rfind('/') + 1), median(a) * 1e3,
                      median(b) * 1e3, median(b) / median(a), ours.sum());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 2) {
      std::cerr << "usage: bench_models ring [ROUNDS] | [--alone] FILE[:AZIMUTH,ELEVATION,DISTANCE,X,Y,Z] ...\n";
      return 2;
    }
    if (std::strcmp(argv[1], "ring") == 0) return compare_ring(argc > 2 ? std::max(2, std::atoi(argv[2])) : 40);
    const bool alone = std::strcmp(argv[1], "--alone") == 0;
    for (int i = alone ? 2 : 1; i < argc; ++i) compare_model(argv[i], alone);
    return 0;
  } catch (const Error& error) {
    std::cerr << error.message() << '\n';
    return 1;
  }
}
