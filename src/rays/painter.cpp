#include "rays/painter.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"

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

Grid grid_for(const Frame& frame, const render::View& view, const render::Picture& picture, int samples) {
  Grid grid;
  grid.frame = &frame;
  grid.samples = samples;
  grid.width = picture.width;
  grid.height = picture.height;
  const auto width = static_cast<std::size_t>(picture.width);
  grid.rgb_row = picture.row_bytes == 0 ? 3 * width : picture.row_bytes;
  grid.depth_row = picture.depth_row == 0 ? width : picture.depth_row;
  grid.segmentation_row = picture.segmentation_row == 0 ? width : picture.segmentation_row;
  grid.columns = picture.width * samples;
  grid.rows = picture.height * samples;
  if (view.edges.given()) {
    const double dx = (view.edges.right - view.edges.left) / grid.columns;
    const double dy = (view.edges.top - view.edges.bottom) / grid.rows;
    grid.dx = static_cast<float>(dx);
    grid.dy = static_cast<float>(-dy);
    grid.x = static_cast<float>(view.edges.left + 0.5 * dx);
    grid.y = static_cast<float>(view.edges.top - 0.5 * dy);
    return grid;
  }
  const double step = 2 * view.half_height() / grid.rows;  // pixels are square
  grid.dx = static_cast<float>(step);
  grid.dy = static_cast<float>(-step);
  grid.x = static_cast<float>(step * (0.5 - 0.5 * grid.columns));
  grid.y = static_cast<float>(step * (0.5 * grid.rows - 0.5));
  return grid;
}

}  // namespace

std::vector<std::string> simd_paths() {
  std::vector<std::string> names;
  for (const Path& path : paths()) names.emplace_back(path.name);
  return names;
}

Painter::Painter(const std::string& simd) : draw_(path_for(paths(), simd).draw) {}

void Painter::draw(const Frame& frame, const render::View& view, const render::Picture& picture, int samples,
                   Pool* pool) const {
  const int along = rays_along_an_edge(samples);
  const bool one_pass = along == 1 || picture.rgb == nullptr;
  if (one_pass || picture.depth != nullptr || picture.segmentation != nullptr) {
    Grid grid = grid_for(frame, view, picture, 1);
    grid.rgb = one_pass ? picture.rgb : nullptr;
    grid.depth = picture.depth;
    grid.segmentation = picture.segmentation;
    run(grid, pool);
  }
  if (!one_pass) {
    Grid grid = grid_for(frame, view, picture, along);
    grid.rgb = picture.rgb;
    run(grid, pool);
  }
}

void Painter::run(const Grid& grid, Pool* pool) const {
  Rows rows(grid, draw_);
  if (pool != nullptr) return pool->run(rows, rows.count());
  for (std::size_t row = 0; row < rows.count(); ++row) rows.run(row, 0);
}

}  // namespace mimo::rays
