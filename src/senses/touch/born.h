// The geoms of an infant as they were at 18 months, where its document says so. Sensors are placed there and move with
// the skin, so that an infant of any age has the same ones.
#pragma once

#include <vector>

#include "body/body.h"
#include "senses/touch/shape.h"

namespace mimo::senses::touch {

class BornGeoms {
 public:
  // Of those who have not grown: all is as the model has it.
  BornGeoms() = default;
  // Throws Status::kModel for numbers that do not fit the infant's geoms.
  BornGeoms(const mjModel& model, const body::Body& body);

  bool any() const { return !sizes_.empty(); }
  Shape shape(const mjModel& model, int geom) const;
  Vec3 place(const mjModel& model, int geom) const;

  // Where a point of the geom's skin is now (body frame both). Normals stay: no shape of an infant's turns them.
  Vec3 grown(const mjModel& model, int geom, const Vec3& point) const;
  // How much longer distances on a body's skin are now, the geoms' surfaces taken together.
  double stretch(const mjModel& model, const std::vector<int>& geoms) const;

 private:
  bool knows(int geom) const;

  std::vector<Vec3> sizes_, places_;  // by geom; sizes of 0: none that grows
};

}  // namespace mimo::senses::touch
