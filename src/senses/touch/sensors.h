// The sensors of one body: where they sit, also on a body that has grown, where outside is, and which are neighbours.
#pragma once

#include <utility>
#include <vector>

#include "body/body.h"
#include "engine/physics.h"
#include "observation/field.h"
#include "senses/touch/shape.h"

namespace mimo::senses::touch {

// The geoms of an infant as they were at 18 months, where its document says so. Sensors are placed there and move with
// the skin, so that an infant of any age has the same ones.

class BornGeoms {
 public:
  // Of those who have not grown: all is as the model has it.
  BornGeoms() = default;
  // Throws Status::kModel for numbers that do not fit the infant's geoms.
  BornGeoms(const mjModel& model, const body::Body& body);

  bool any() const { return !sizes_.empty(); }
  OuterShape shape(const mjModel& model, int geom) const;
  Vec3 place(const mjModel& model, int geom) const;

  // Where a point of the geom's skin is now (body frame both). Normals stay: no shape of an infant's turns them.
  Vec3 grown(const mjModel& model, int geom, const Vec3& point) const;
  // How much longer distances on a body's skin are now, the geoms' surfaces taken together.
  double stretch(const mjModel& model, const std::vector<int>& geoms) const;

 private:
  bool knows(int geom) const;

  std::vector<Vec3> sizes_, places_;  // by geom; sizes of 0: none that grows
};

// The sensors of one body: where they sit, where outside is, and which ones are neighbours on its skin.

using Sensor = observation::Receptor;

struct BodySensors {
  std::vector<Sensor> sensors;             // in the order of the geoms
  std::vector<std::pair<int, int>> edges;  // neighbours along the skin, by index
};

// Ids of the body's geoms that have a skin: those that can touch something and have a surface to put sensors on.
std::vector<int> geoms_with_skin(const mjModel& model, int body);

// About how many sensors a spacing makes.
double expected_sensors(const mjModel& model, int body, double spacing, const BornGeoms& born);

// Spreads sensors over the surfaces of those geoms as they were born; those inside another geom of the body are left
// out. Then they and their neighbourhoods move to where the skin is now.
BodySensors place_sensors(const mjModel& model, int body, double spacing, const BornGeoms& born);

}  // namespace mimo::senses::touch
