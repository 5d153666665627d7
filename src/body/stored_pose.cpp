#include "body/stored_pose.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <string>

#include "base/fail.h"
#include "base/names.h"
#include "engine/custom.h"
#include "engine/joints.h"

namespace mimo::body {
namespace {

// Calls visit(name, prefix) for all elements of a kind that are called `what`, with or without a prefix.
template <typename Visit>
void visit_named(const mjModel& model, mjtObj kind, int count, const std::string& what, Visit&& visit) {
  for (int id = 0; id < count; ++id) {
    const char* text = mj_id2name(&model, kind, id);
    const std::string name = text == nullptr ? "" : text;
    if (name.size() < what.size() || name.compare(name.size() - what.size(), what.size(), what) != 0) continue;
    const std::string prefix = name.substr(0, name.size() - what.size());
    if (prefix.empty() || prefix.back() == '/') visit(name, prefix);
  }
}

void place_root(const mjModel& model, int body, Span<const double> pose, Span<double> qpos) {
  double* start = &qpos[static_cast<std::size_t>(engine::free_joint_address(model, body))];
  std::copy(pose.begin(), pose.end(), start);
  mju_normalize4(start + 3);
}

}  // namespace

void read_stored_pose(const mjModel& model, Span<double> qpos) {
  visit_named(model, mjOBJ_NUMERIC, model.nnumeric, names::kRootPose,
              [&](const std::string& name, const std::string& prefix) {
                const Span<const double> pose = engine::custom_numbers(model, name);
                const int body = engine::find(model, engine::Kind::kBody, (prefix + names::kRootBody).c_str());
                if (pose.size() == 7 && body >= 0) place_root(model, body, pose, qpos);
              });
  visit_named(model, mjOBJ_TUPLE, model.ntuple, names::kPose, [&](const std::string& name, const std::string&) {
    for (const engine::TupleEntry& entry : engine::custom_tuple(model, name, engine::Kind::kJoint)) {
      if (!engine::has_one_axis(model, entry.id)) {
        fail(Status::kModel, "{}: joint {} is no hinge or slide", name,
             engine::name(model, engine::Kind::kJoint, entry.id));
      }
      qpos[static_cast<std::size_t>(model.jnt_qposadr[entry.id])] = entry.value;
    }
  });
}

}  // namespace mimo::body
