#include "render/ray/ray_renderer.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/fail.h"
#include "render/ray/kernels.h"
#include "render/ray/scene.h"
#include "render/ray/textures.h"

namespace mimo::render {
namespace {

const ray::Path& path_for(const std::vector<ray::Path>& paths, const std::string& name) {
  if (name.empty()) return paths.front();
  const auto found =
      std::find_if(paths.begin(), paths.end(), [&name](const ray::Path& path) { return name == path.name; });
  if (found == paths.end()) fail(Status::kUnsupported, "the ray renderer has no path \"{}\" on this machine", name);
  return *found;
}

class RayRenderer : public Renderer {
 public:
  RayRenderer(engine::ModelPtr model, const RayOptions& options)
      : model_(std::move(model)),
        textures_(options.textures ? options.textures : make_ray_textures(model_)),
        executor_(options.executor),
        samples_(options.samples),
        draw_(path_for(ray::paths(), options.simd).draw),
        scene_(*model_) {
    settings_.shadows = options.shadows;
    settings_.reflections = options.reflections;
    settings_.skybox = options.skybox;
    settings_.haze = options.haze;
    settings_.fog = options.fog;
  }

  void draw(const mjModel& model, const mjData& data, const View& view, const Picture& picture) override {
    if (picture.width < 1 || picture.height < 1) {
      fail(Status::kRender, "a picture of {} x {} pixels was asked for", picture.width, picture.height);
    }
    scene_.prepare(model, data, view, static_cast<double>(picture.width) / picture.height, *textures_, settings_);
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
    if (executor_.run == nullptr) {
      const int tiles = job.tiles();
      for (int i = 0; i < tiles; ++i) draw_(job, i);
      return;
    }
    // One piece of work is one row of tiles.
    struct Work {
      const ray::Job* job;
      ray::DrawTile draw;
    } work{&job, draw_};
    executor_.run(
        executor_.self, job.tiles() / job.tile_columns(),
        [](void* context, int row) {
          const Work& all = *static_cast<Work*>(context);
          const int columns = all.job->tile_columns();
          for (int i = 0; i < columns; ++i) all.draw(*all.job, row * columns + i);
        },
        &work);
  }

  engine::ModelPtr model_;
  std::shared_ptr<const ray::Textures> textures_;
  RayExecutor executor_;
  int samples_;
  ray::DrawTile draw_;
  ray::Settings settings_;
  ray::Scene scene_;
};

}  // namespace

std::vector<std::string> ray_simd_paths() {
  std::vector<std::string> names;
  for (const ray::Path& path : ray::paths()) names.emplace_back(path.name);
  return names;
}

std::shared_ptr<const ray::Textures> make_ray_textures(const engine::ModelPtr& model) {
  return std::make_shared<const ray::Textures>(*model);
}

std::unique_ptr<Renderer> make_ray_renderer(engine::ModelPtr model, const RayOptions& options, const LogSink& log) {
  static_cast<void>(log);
  const int samples = options.samples;
  require(samples == 1 || samples == 2 || samples == 4 || samples == 8, "samples is {}, expected 1, 2, 4 or 8", samples);
  const int geom = ray::unsupported_geom(*model);
  if (geom >= 0) {
    const char* name = model->names + model->name_geomadr[geom];
    fail(Status::kUnsupported, "geom {} (\"{}\") is a mesh or a height field, which the ray renderer cannot draw", geom,
         name);
  }
  return std::make_unique<RayRenderer>(std::move(model), options);
}

}  // namespace mimo::render
