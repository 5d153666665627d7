// What the one reflecting solid shows.
#pragma once

#include "rays/camera.h"

namespace mimo::rays {

struct Mirror {
  int solid = -1;  // that reflects, -1 for none
  float reflectance = 0;
  Eye eye;  // the mirrored camera's

  // For so many solids at most.
  explicit Mirror(std::size_t most);

  void hold(const Solids& solids, const Camera& camera, bool reflections);
};

}  // namespace mimo::rays
