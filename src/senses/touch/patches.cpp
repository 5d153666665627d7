#include "senses/touch/patches.h"

namespace mimo::senses::touch {

using receptors::Region;

receptors::Region region_of(const std::string& name) {
  struct Part {
    const char* in_name;
    Region region;
  };
  constexpr Part kParts[] = {{"head", Region::kFace},     {"eye", Region::kFace},        {"metacarpal", Region::kHand},
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
  std::vector<Patch> patches;
  for (const Sensor& sensor : skin.sensors()) {
    const std::string name = engine::name(model, engine::Kind::kBody, sensor.body);
    patches.push_back({region_of(name.substr(body.prefix.size())), skin.spacing(sensor.body)});
  }
  return patches;
}

}  // namespace mimo::senses::touch
