// Agents that are no infants: parts of models that know nothing of the library.
#include <algorithm>

#include "base/fail.h"
#include "body/body.h"
#include "engine/joints.h"

namespace mimo::body {
namespace {

using engine::Kind;

// The body that an actuator works on first of all; -1 for one whose tendon leads nowhere.
int body_of_tendon(const mjModel& model, int tendon) {
  for (int i = model.tendon_adr[tendon]; i < model.tendon_adr[tendon] + model.tendon_num[tendon]; ++i) {
    const int object = model.wrap_objid[i];
    if (model.wrap_type[i] == mjWRAP_JOINT) return model.jnt_bodyid[object];
    if (model.wrap_type[i] == mjWRAP_SITE) return model.site_bodyid[object];
  }
  return -1;
}

int body_of_actuator(const mjModel& model, int actuator) {
  const int target = model.actuator_trnid[2 * actuator];
  switch (model.actuator_trntype[actuator]) {
    case mjTRN_JOINT:
    case mjTRN_JOINTINPARENT: return model.jnt_bodyid[target];
    case mjTRN_SLIDERCRANK:
    case mjTRN_SITE: return model.site_bodyid[target];
    case mjTRN_TENDON: return body_of_tendon(model, target);
    case mjTRN_BODY: return target;
    default: return -1;
  }
}

}  // namespace

Body find_part(const mjModel& model, const std::string& root) {
  Body body;
  body.infant = false;
  body.root = engine::find_or_fail(model, Kind::kBody, root);
  body.bodies = subtree(model, body.root);
  if (body.root == 0) body.bodies.erase(body.bodies.begin());
  for (int id = 0; id < model.njnt; ++id) {
    if (engine::has_one_axis(model, id) && body.has(model.jnt_bodyid[id])) body.joints.push_back(joint(model, id));
  }
  for (int id = 0; id < model.nu; ++id) {
    if (body.has(body_of_actuator(model, id))) body.actuators.push_back(id);
  }
  for (int id = 0; id < model.nsensor; ++id) {
    const bool torque = model.sensor_type[id] == mjSENS_TORQUE;
    if (torque && body.has(model.site_bodyid[model.sensor_objid[id]])) body.torques.push_back(sensor(model, id));
  }
  return body;
}

}  // namespace mimo::body
