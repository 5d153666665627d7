// The sensors of one body: where they sit, where outside is, and which ones are neighbours on its skin.
#pragma once

#include <utility>
#include <vector>

#include "engine/physics.h"
#include "observation/receptor.h"
#include "senses/touch/born.h"
#include "senses/touch/shape.h"

namespace mimo::senses::touch {

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
