#include "body/stored_pose.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/fail.h"
#include "base/names.h"
#include "engine/custom.h"
#include "engine/joints.h"

namespace mimo::body {
namespace {

// Calls visit(name, prefix) for each of the names that is `what`, with or without a prefix.
template <typename Visit>
void visit_named(const std::vector<std::string>& names, const std::string& what, Visit&& visit) {
  for (const std::string& name : names) {
    if (name.size() < what.size() || name.compare(name.size() - what.size(), what.size(), what) != 0) continue;
    const std::string prefix = name.substr(0, name.size() - what.size());
    if (prefix.empty() || prefix.back() == '/') visit(name, prefix);
  }
}

void place_root(const mjModel& model, int body, Span<const double> pose, Span<double> qpos) {
  double* start = &qpos[static_cast<std::size_t>(engine::free_joint_address(model, body))];
  std::copy(pose.begin(), pose.end(), start);
  engine::normalize_quaternion(start + 3);
}

}  // namespace

void read_stored_pose(const mjModel& model, Span<double> qpos) {
  visit_named(engine::custom_number_names(model), names::kRootPose,
              [&](const std::string& name, const std::string& prefix) {
                const Span<const double> pose = engine::custom_numbers(model, name);
                const int body = engine::find(model, engine::Kind::kBody, (prefix + names::kRootBody).c_str());
                if (pose.size() == 7 && body >= 0) place_root(model, body, pose, qpos);
              });
  visit_named(engine::custom_tuple_names(model), names::kPose, [&](const std::string& name, const std::string&) {
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
