// How sharp what touches is: the radius of curvature where two geoms press on each other.
#pragma once

#include "engine/physics.h"
#include "senses/touch/shape.h"

namespace mimo::senses::touch {

// A box or cylinder that stands for flesh has no edges: it is as round there as it is thin.
struct Surfaced {
  int geom;  // -1: a flex, which is flat where it touches
  bool is_flesh;
};

// Of both surfaces together, m; the point is in the world. Flat things on each other count as 100 mm.
double curvature_radius(const mjModel& model, const mjData& data, const Surfaced& one, const Surfaced& other,
                        const Vec3& point);

}  // namespace mimo::senses::touch
