#include "rays/renderer.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/fail.h"
#include "base/numbers.h"
#include "base/pool.h"
#include "rays/frame.h"
#include "rays/kernels.h"

namespace mimo::rays {
namespace {

const Path& path_for(const std::vector<Path>& paths, const std::string& name) {
  if (name.empty()) return paths.front();
  const auto found = std::find_if(paths.begin(), paths.end(), [&name](const Path& path) { return name == path.name; });
  if (found == paths.end()) fail(Status::kUnsupported, "the ray renderer has no path \"{}\" on this machine", name);
  return *found;
}

int rays_along_an_edge(int samples) {
  render::require_samples(samples);
  return samples == 0 ? 1 : static_cast<int>(std::lround(std::sqrt(samples)));
}

// A picture in pieces: its rows of tiles.
class Rows final : public Job {
 public:
  Rows(const Grid& picture, DrawRow draw) : picture_(picture), draw_(draw) {}
  std::size_t count() const { return static_cast<std::size_t>(picture_.tile_rows()); }
  void run(std::size_t row, std::size_t) noexcept override { draw_(picture_, static_cast<int>(row)); }

 private:
  const Grid& picture_;
  DrawRow draw_;
};

class RayRenderer final : public render::Renderer {
 public:
  RayRenderer(engine::ModelPtr model, const Options& options)
      : model_(std::move(model)),
        assets_(options.assets ? options.assets : make_assets(model_)),
        samples_(rays_along_an_edge(options.samples)),
        draw_(path_for(paths(), options.simd).draw),
        frame_(*model_, *assets_) {
    quality_ = options;
    if (options.threads > 1) pool_ = std::make_unique<Pool>(static_cast<std::size_t>(options.threads));
  }

  void draw(const mjModel& model, const mjData& data, const render::View& view,
            const render::Picture& picture) override {
    if (picture.width < 1 || picture.height < 1) {
      fail(Status::kRender, "a picture of {} x {} pixels was asked for", picture.width, picture.height);
    }
    frame_.prepare(model, data, view, static_cast<double>(picture.width) / picture.height, quality_);
    const bool one_pass = samples_ == 1 || picture.rgb == nullptr;
    if (one_pass || picture.depth != nullptr || picture.segmentation != nullptr) {
      Grid grid = grid_for(view, picture, 1);
      grid.rgb = one_pass ? picture.rgb : nullptr;
      grid.depth = picture.depth;
      grid.segmentation = picture.segmentation;
      run(grid);
    }
    if (!one_pass) {
      Grid grid = grid_for(view, picture, samples_);
      grid.rgb = picture.rgb;
      run(grid);
    }
  }

 private:
  Grid grid_for(const render::View& view, const render::Picture& picture, int samples) const {
    Grid grid;
    grid.frame = &frame_;
    grid.samples = samples;
    grid.width = picture.width;
    grid.height = picture.height;
    grid.columns = picture.width * samples;
    grid.rows = picture.height * samples;
    const double top = std::tan(view.fovy * kPi / 360);
    const double step = 2 * top / grid.rows;  // pixels are square
    grid.dx = static_cast<float>(step);
    grid.dy = static_cast<float>(-step);
    grid.x = static_cast<float>(step * (0.5 - 0.5 * grid.columns));
    grid.y = static_cast<float>(step * (0.5 * grid.rows - 0.5));
    return grid;
  }

  void run(const Grid& grid) const {
    Rows rows(grid, draw_);
    if (pool_ != nullptr) return pool_->run(rows, rows.count());
    for (std::size_t row = 0; row < rows.count(); ++row) rows.run(row, 0);
  }

  engine::ModelPtr model_;
  std::shared_ptr<const Assets> assets_;
  int samples_;  // rays along a pixel's edge
  DrawRow draw_;
  render::Quality quality_;
  Frame frame_;
  std::unique_ptr<Pool> pool_;  // null: the calling thread does it all
};

}  // namespace

std::vector<std::string> simd_paths() {
  std::vector<std::string> names;
  for (const Path& path : paths()) names.emplace_back(path.name);
  return names;
}

std::shared_ptr<const Textures> make_textures(const engine::ModelPtr& model) {
  return std::make_shared<const Textures>(*model);
}

std::shared_ptr<const Assets> make_assets(const engine::ModelPtr& model, std::shared_ptr<const Textures> textures) {
  if (textures == nullptr) textures = make_textures(model);
  return std::make_shared<const Assets>(model, std::move(textures));
}

std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr model, const Options& options) {
  return std::make_unique<RayRenderer>(std::move(model), options);
}

}  // namespace mimo::rays
