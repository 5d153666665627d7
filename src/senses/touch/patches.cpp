#include "senses/touch/patches.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "senses/touch/born.h"
#include "senses/touch/spacing.h"
#include "senses/touch/surface.h"

namespace mimo::senses::touch {

using receptors::Region;

namespace {

// On a regular grid of triangles a sensor has this share of its spacing's square to itself.
constexpr double kOfSquare = 0.87;

Region region_of(const mjModel& model, const body::Body& body, int id) {
  return touch::region_of(body::short_name(model, body, id));
}

double area_of(const mjModel& model, int body, const BornGeoms& born) {
  double sum = 0;
  for (const int geom : geoms_with_skin(model, body)) sum += area(born.shape(model, geom));
  return sum;
}

double density(Region region) {
  double sum = 0;
  for (std::size_t kind = 0; kind < receptors::kTouchKinds; ++kind) {
    sum += receptors::afferents_per_square_metre(region, kind);
  }
  return sum;
}

// How many afferents each body of an infant has.
std::map<int, double> afferents_by_body(const mjModel& model, const body::Body& body) {
  std::map<int, double> weights;
  if (!body.infant) return weights;
  const BornGeoms born(model, body);
  std::map<receptors::Territory, double> sums;
  for (const int id : body.bodies) {
    if (default_spacing(body::short_name(model, body, id)) == 0) continue;  // it holds something
    const Region region = region_of(model, body, id);
    weights[id] = density(region) * area_of(model, id, born);
    sums[receptors::territory_of(region)] += weights[id];
  }
  for (auto& [id, weight] : weights) {
    const receptors::Territory territory = receptors::territory_of(region_of(model, body, id));
    if (weight > 0) weight *= receptors::afferents_of(territory) / sums[territory];
  }
  return weights;
}

}  // namespace

receptors::Region region_of(const std::string& name) {
  struct Part {
    const char* in_name;
    Region region;
  };
  constexpr Part kParts[] = {{"head", Region::kFace},     {"eye", Region::kEye},         {"metacarpal", Region::kHand},
                             {"hand", Region::kHand},     {"finger", Region::kFinger},   {"knuckle", Region::kFinger},
                             {"middle", Region::kFinger}, {"distal", Region::kFinger},   {"_th", Region::kFinger},
                             {"foot", Region::kFoot},     {"toe", Region::kFoot},        {"upper_arm", Region::kArm},
                             {"lower_arm", Region::kArm}, {"upper_leg", Region::kThigh}, {"lower_leg", Region::kLeg}};
  for (const Part& part : kParts) {
    if (name.find(part.in_name) != std::string::npos) return part.region;
  }
  return Region::kTrunk;
}

std::vector<Patch> patches(const mjModel& model, const body::Body& body, const Skin& skin) {
  const std::map<int, double> afferents = afferents_by_body(model, body);
  std::map<int, double> sensors;
  for (const Sensor& sensor : skin.sensors()) ++sensors[sensor.body];
  std::vector<Patch> patches;
  for (const Sensor& sensor : skin.sensors()) {
    if (!patches.empty() && sensor.body == skin.sensors()[patches.size() - 1].body) {
      patches.push_back(patches.back());
      continue;
    }
    const Region region = region_of(model, body, sensor.body);
    const double all = std::sqrt(area_of(model, sensor.body, {}) / kOfSquare);
    const double spacing = std::min(skin.spacing(sensor.body), all);
    const auto known = afferents.find(sensor.body);
    patches.push_back({region, spacing,
                       known != afferents.end() ? known->second / sensors[sensor.body]
                                                : kOfSquare * spacing * spacing * density(region)});
  }
  return patches;
}

}  // namespace mimo::senses::touch
