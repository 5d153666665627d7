// Which sensors feel a touch, and how much of it each: the surface response.
#pragma once

#include <vector>

#include "mimo/agent.h"
#include "senses/touch/skin.h"

namespace mimo::senses::touch {

// Of the header. The distance d runs along the skin, s is the spacing.
enum class Response : std::int32_t {
  kNearest = MIMO_RESPONSE_NEAREST,    // the nearest sensor feels everything
  kLinear = MIMO_RESPONSE_LINEAR,      // 1 - d / 2s
  kGaussian = MIMO_RESPONSE_GAUSSIAN,  // exp(-d^2 / 2 sigma^2) with sigma = 2s/3; nothing beyond 2s
};

struct Share {
  int sensor;
  double weight;
};

class Spread {
 public:
  // The skin outlives the spread.
  Spread(const Skin& skin, Response response);

  // The shares of a touch of a geom at a point (body frame); they add up to 1. Valid until the next call.
  Span<const Share> at(int body, int geom, const Vec3& point);

 private:
  void collect(int anchor, const Vec3& point, double reach);
  void keep_nearest();
  bool weigh(double spacing);

  const Skin& skin_;
  Response response_;
  std::vector<Share> shares_;  // distances, before they become weights
};

}  // namespace mimo::senses::touch
