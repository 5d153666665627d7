#include "cli/skin.h"

#include <cmath>
#include <cstring>

#include "programs/world_summary.h"

namespace cli {

using mimo::Vector;

Vector sum(const Vector& a, const Vector& b, double scale) {
  return {a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]};
}

double norm(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

Vector rotated(const double* q, const Vector& v) {
  const Vector u{q[1], q[2], q[3]};
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Vector t = cross(u, v);
  return sum(sum(v, t, 2 * q[0]), cross(u, t), 2);
}

Skin::Skin(const mimo::Env& env, const std::string& fields_of) {
  const mimo::Layout layout = env.layout();
  const auto agents = env.agents();
  for (const mimo_field& field : layout.fields()) {
    for (const mimo_agent_info& agent : agents) {
      if (!fields_of.empty() && fields_of != agent.name) continue;
      if (field.name == prefix(agent) + "touch/force" && field.shape[1] == 3) add(layout, field);
    }
  }
}

void Skin::add(const mimo::Layout& layout, const mimo_field& field) {
  std::size_t force = field.offset;
  for (const mimo::Receptor& receptor : layout.receptors(field.name)) {
    sensors_.push_back({receptor.body, receptor.position, receptor.normal, force});
    force += 3 * sizeof(float);
  }
}

Vector Skin::components(std::size_t sensor, const mimo::Block& block) const {
  float force[3];
  std::memcpy(force, block.data() + sensors_[sensor].force, sizeof force);
  return {double{force[0]}, double{force[1]}, double{force[2]}};
}

double Skin::force(std::size_t sensor, const mimo::Block& block) const { return norm(components(sensor, block)); }

std::vector<Skin::Feeling> Skin::feelings(const mimo::Env& env, const mimo::Block& block) const {
  const auto bodies = env.ids(MIMO_BODY);
  const auto places = env.get_values(MIMO_BODY_POSITION | MIMO_NOW, bodies),
             turns = env.get_values(MIMO_BODY_ORIENTATION | MIMO_NOW, bodies);  // as the picture shows them
  std::vector<Feeling> feelings;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const auto body = static_cast<std::size_t>(sensors_[i].body);
    const Vector place{places[3 * body], places[3 * body + 1], places[3 * body + 2]};
    const double* turn = &turns[4 * body];
    feelings.push_back({sum(place, rotated(turn, sensors_[i].position)), rotated(turn, sensors_[i].normal),
                        rotated(turn, components(i, block))});
  }
  return feelings;
}

}  // namespace cli
