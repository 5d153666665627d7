#include "env/step.h"

#include <algorithm>

#include "base/fail.h"

namespace mimo::env {

Span<const StepContact> StepContacts::all() const {
  if (!wanted_) {
    fail(Status::kUnsupported, "contacts of whole steps are not recorded: set step_contacts in mimo_env_config");
  }
  return {pairs_.data(), pairs_.size()};
}

std::size_t StepContacts::find(const engine::Meeting& met) {
  const auto found = std::find_if(pairs_.begin(), pairs_.end(), [&](const auto& pair) {
    return pair.geoms == met.geoms && pair.flexes == met.flexes;
  });
  if (found != pairs_.end()) return static_cast<std::size_t>(found - pairs_.begin());
  StepContact pair{};
  pair.geoms = met.geoms;
  pair.flexes = met.flexes;
  pair.bodies = met.bodies;
  pair.start = elapsed_;
  pairs_.push_back(pair);
  return pairs_.size() - 1;
}

void StepContacts::add(const engine::Physics& physics) {
  const mjModel& model = physics.model();
  const mjData& data = physics.data();
  const double step = model.opt.timestep;
  now_.assign(pairs_.size(), Now());
  for (const engine::Meeting& met : engine::Contacts(model, data)) {
    const mjContact& contact = data.contact[met.number];
    if (contact.efc_address < 0) continue;  // near, but beyond the gap
    const std::size_t pair = find(met);
    if (pair == now_.size()) now_.emplace_back();
    Now& now = now_[pair];
    const std::array<double, 6> force = engine::contact_force(model, data, met.number);
    const Eigen::Map<const Eigen::Matrix3d> axes(contact.frame);  // MuJoCo's rows are Eigen's columns
    now.force += axes * Eigen::Vector3d(force[0], force[1], force[2]);
    const double strength = Eigen::Vector3d(force[0], force[1], force[2]).norm();
    if (strength <= now.strongest) continue;
    now.strongest = strength;
    now.position = Eigen::Map<const Eigen::Vector3d>(contact.pos);
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (now_[i].strongest < 0) continue;
    StepContact& pair = pairs_[i];
    const bool first = pair.end == 0;
    pair.end = elapsed_ + step;
    pair.impulse += step * now_[i].force;
    if (!first && now_[i].force.norm() <= pair.peak_force.norm()) continue;
    pair.peak_force = now_[i].force;
    pair.peak_position = now_[i].position;
  }
  elapsed_ += step;
}

}  // namespace mimo::env
