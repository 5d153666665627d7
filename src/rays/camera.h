// The eye that the picture is taken with.
#pragma once

#include <vector>

#include "rays/eye.h"

namespace mimo::rays {

struct Camera : Eye {
  float near_plane = 0;
  float far_plane = 0;
  std::vector<int> seen;         // index of a solid's aspect, -2 if it has none
  std::vector<int> transparent;  // aspects of transparent solids in the order in which they are drawn: the first ones
  int transparent_count = 0;

  // For so many solids at most.
  explicit Camera(std::size_t most);

  void place(const mjModel& model, const render::View& view, double aspect_ratio);
  void look_around(const Solids& solids);
};

}  // namespace mimo::rays
