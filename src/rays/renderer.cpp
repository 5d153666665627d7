#include "render/ray/ray_renderer.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/fail.h"
#include "base/pool.h"
#include "render/ray/assets.h"
#include "render/ray/kernels.h"
#include "render/ray/scene.h"

namespace mimo::render {
namespace {

const ray::Path& path_for(const std::vector<ray::Path>& paths, const std::string& name) {
  if (name.empty()) return paths.front();
  const auto found =
      std::find_if(paths.begin(), paths.end(), [&name](const ray::Path& path) { return name == path.name; });
  if (found == paths.end()) fail(Status::kUnsupported, "the ray renderer has no path \"{}\" on this machine", name);
  return *found;
}

int rays_along_an_edge(int samples) {
  switch (samples) {
    case 0:
    case 1: return 1;
    case 4: return 2;
    case 16: return 4;
    case 64: return 8;
    default: fail(Status::kInvalidArgument, "samples is {}, expected 1, 4, 16 or 64", samples);
  }
}

// A picture in pieces: its rows of tiles.
class Rows final : public Job {
 public:
  Rows(const ray::Job& picture, ray::DrawTile draw) : picture_(picture), draw_(draw) {}
  std::size_t count() const { return static_cast<std::size_t>(picture_.tiles() / picture_.tile_columns()); }
  void run(std::size_t row, std::size_t) noexcept override {
    const int columns = picture_.tile_columns();
    for (int i = 0; i < columns; ++i) draw_(picture_, static_cast<int>(row) * columns + i);
  }

 private:
  const ray::Job& picture_;
  ray::DrawTile draw_;
};

class RayRenderer : public Renderer {
 public:
  RayRenderer(engine::ModelPtr model, const RayOptions& options)
      : model_(std::move(model)),
        assets_(options.assets ? options.assets : make_ray_assets(model_)),
        samples_(rays_along_an_edge(options.samples)),
        draw_(path_for(ray::paths(), options.simd).draw),
        scene_(*model_, *assets_) {
    settings_ = options;
    if (options.threads > 1) pool_ = std::make_unique<Pool>(static_cast<std::size_t>(options.threads));
  }

  void draw(const mjModel& model, const mjData& data, const View& view, const Picture& picture) override {
    if (picture.width < 1 || picture.height < 1) {
      fail(Status::kRender, "a picture of {} x {} pixels was asked for", picture.width, picture.height);
    }
    scene_.prepare(model, data, view, static_cast<double>(picture.width) / picture.height, *assets_, settings_);
    const bool one_pass = samples_ == 1 || picture.rgb == nullptr;
    if (one_pass || picture.depth != nullptr || picture.segmentation != nullptr) {
      ray::Job job = job_for(view, picture, 1);
      job.rgb = one_pass ? picture.rgb : nullptr;
      job.depth = picture.depth;
      job.segmentation = picture.segmentation;
      run(job);
    }
    if (!one_pass) {
      ray::Job job = job_for(view, picture, samples_);
      job.rgb = picture.rgb;
      run(job);
    }
  }

 private:
  ray::Job job_for(const View& view, const Picture& picture, int samples) const {
    ray::Job job;
    job.scene = &scene_;
    job.samples = samples;
    job.width = picture.width;
    job.height = picture.height;
    job.columns = picture.width * samples;
    job.rows = picture.height * samples;
    const double top = std::tan(view.fovy * 3.14159265358979323846 / 360);
    const double step = 2 * top / job.rows;  // pixels are square
    job.dx = static_cast<float>(step);
    job.dy = static_cast<float>(-step);
    job.x = static_cast<float>(step * (0.5 - 0.5 * job.columns));
    job.y = static_cast<float>(step * (0.5 * job.rows - 0.5));
    return job;
  }

  void run(const ray::Job& job) const {
    Rows rows(job, draw_);
    if (pool_ != nullptr) return pool_->run(rows, rows.count());
    for (std::size_t row = 0; row < rows.count(); ++row) rows.run(row, 0);
  }

  engine::ModelPtr model_;
  std::shared_ptr<const ray::Assets> assets_;
  int samples_;  // rays along a pixel's edge
  ray::DrawTile draw_;
  Quality settings_;
  ray::Scene scene_;
  std::unique_ptr<Pool> pool_;  // null: the calling thread does it all
};

}  // namespace

std::vector<std::string> ray_simd_paths() {
  std::vector<std::string> names;
  for (const ray::Path& path : ray::paths()) names.emplace_back(path.name);
  return names;
}

std::shared_ptr<const ray::Assets> make_ray_assets(const engine::ModelPtr& model) {
  return std::make_shared<const ray::Assets>(model);
}

std::unique_ptr<Renderer> make_ray_renderer(engine::ModelPtr model, const RayOptions& options) {
  return std::make_unique<RayRenderer>(std::move(model), options);
}

}  // namespace mimo::render
