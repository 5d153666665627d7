#include "document/hulls.h"

#include <algorithm>

#include "base/fail.h"
#include "document/flat.h"
#include "document/lines.h"
#include "document/loaded_file.h"
#include "engine/meshes.h"

namespace mimo::document {
namespace {

using Points = std::vector<std::array<double, 3>>;

void leave_out_repeated(Points& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

// The same ones every time, in no order that a file could have.
Points some_of(const Points& points, std::size_t count) {
  constexpr std::uint64_t kFactor = 6364136223846793005, kStep = 1442695040888963407;
  Points some;
  std::uint64_t state = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    state = state * kFactor + kStep;
    some.push_back(points[(state >> 32) % points.size()]);
  }
  leave_out_repeated(some);
  return some;
}

}  // namespace

double hull_corners(Points points) {
  constexpr std::size_t kFew = 3000, kLeast = 512, kMost = 4096;  // of fewer, all may be corners
  if (points.size() > kFew) leave_out_repeated(points);
  const auto all = static_cast<double>(points.size());
  if (points.size() <= kFew) return all;
  const Points some = some_of(points, std::clamp(points.size() / 8, kLeast, kMost));
  if (is_flat(some)) return all;
  return std::min(all, all * engine::hull_corners(some) / static_cast<double>(some.size()));
}

Points kept_vertices(pugi::xml_node mesh, const Limits& limits) {
  const LoadedFile file(mesh, "file", limits);
  try {
    return engine::vertices_of("mesh" + file.extension(), file.bytes());
  } catch (const Error& error) {
    fail(error.status(), "{}: {}", where(mesh), error.message());
  }
}

}  // namespace mimo::document
