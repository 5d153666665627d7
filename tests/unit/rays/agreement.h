// Measures of how alike the pictures of two renderers are.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include "base/fail.h"
#include "opengl/renderer.h"
#include "unit/rays/support.h"

namespace mimo::test {

// MuJoCo's own renderer; null where this machine has none.
inline std::unique_ptr<render::Renderer> osmesa_for(const engine::ModelPtr& model,
                                                    const render::Quality& quality = {}) {
  try {
    return opengl::make_renderer(model, quality, {}, opengl::osmesa());
  } catch (const Error& error) {
    if (error.status() != Status::kUnsupported) throw;
    return nullptr;
  }
}

// Mean structural similarity of the luminances (Wang et al. 2004; windows of 7 x 7).
inline double similarity(const Shot& a, const Shot& b) {
  const auto luminance = [](const Shot& shot, int x, int y) {
    const std::array<int, 3> c = shot.color(x, y);
    return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
  };
  constexpr int kWindow = 7;
  double total = 0;
  int windows = 0;
  for (int y = 0; y + kWindow <= a.height; y += 2) {
    for (int x = 0; x + kWindow <= a.width; x += 2) {
      double p = 0, q = 0, pp = 0, qq = 0, pq = 0;
      for (int v = 0; v < kWindow; ++v) {
        for (int u = 0; u < kWindow; ++u) {
          const double s = luminance(a, x + u, y + v);
          const double t = luminance(b, x + u, y + v);
          p += s, q += t, pp += s * s, qq += t * t, pq += s * t;
        }
      }
      const double n = kWindow * kWindow;
      p /= n, q /= n, pp = pp / n - p * p, qq = qq / n - q * q, pq = pq / n - p * q;
      const double c1 = 6.5025;
      const double c2 = 58.5225;
      total += (2 * p * q + c1) * (2 * pq + c2) / ((p * p + q * q + c1) * (pp + qq + c2));
      ++windows;
    }
  }
  return total / windows;
}

struct Agreement {
  double ids = 0, depth = 0, similarity = 0;
  int count = 0;

  void add(const Shot& ours, const Shot& theirs) {
    int same = 0;
    int near = 0;
    for (std::size_t i = 0; i < ours.ids.size(); ++i) {
      same += ours.ids[i] == theirs.ids[i];
      near += std::abs(ours.depth[i] - theirs.depth[i]) <= 1e-3 + 1e-3 * theirs.depth[i];
    }
    const double pixels = static_cast<double>(ours.ids.size());
    ids += same / pixels;
    depth += near / pixels;
    similarity += test::similarity(ours, theirs);
    ++count;
  }
  void expect(double least_ids, double least_depth, double least_similarity) const {
    EXPECT_GE(ids / count, least_ids);
    EXPECT_GE(depth / count, least_depth);
    EXPECT_GE(similarity / count, least_similarity);
    ::testing::Test::RecordProperty("ids", std::to_string(ids / count));
    ::testing::Test::RecordProperty("depth", std::to_string(depth / count));
    ::testing::Test::RecordProperty("similarity", std::to_string(similarity / count));
  }
};

}  // namespace mimo::test
