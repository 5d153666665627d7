// The geoms of a model: as triangles, and what they look like.
#pragma once

#include <mujoco/mjmodel.h>

#include "geometry/mesh.h"
#include "render/paint.h"

namespace mimo::geometry {

struct Detail {
  int segments;  // of a circle, a multiple of four
  double plane;  // half the length of endless planes, m
};

// In the geom's frame, with its places in the geom's texture.
Mesh mesh_of(const mjModel& model, int geom, const Detail& detail);

struct Material {
  bool visible = false;  // of the groups that MuJoCo draws, and not transparent
  int group = 0;
  render::Paint paint;
};

Material material_of(const mjModel& model, int geom);

}  // namespace mimo::geometry
