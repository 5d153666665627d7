#include "env/spontaneous.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/fail.h"
#include "base/names.h"
#include "env/world.h"
#include "movements/spontaneous.h"

namespace mimo::env {
namespace {

// "left_elbow" of "anna/act:left_elbow"; "" of what is no motor, such as a voice.
std::string motor_of(const std::string& action) {
  const std::size_t at = action.find(names::kMotor);
  return at == std::string::npos ? "" : action.substr(at + std::string(names::kMotor).size());
}

}  // namespace

void add_spontaneous(Agent& infant) {
  std::vector<std::string> motors;
  for (const std::string& action : infant.actuation->names()) {
    motors.push_back(motor_of(action));
    const std::size_t at = action.find(names::kMotor);
    if (infant.movements_key != 0 || at == std::string::npos || at == 0) continue;
    Hash hash;  // of "anna/"
    hash.add(action.substr(0, at));
    infant.movements_key = hash.value();
  }
  infant.movements = std::make_shared<movements::Spontaneous>(motors, infant.age->physiology);
}

void require_spontaneous(const World& world, std::size_t agent) {
  const Agent& infant = world.agents()[agent];
  if (infant.movements) return;
  fail(Status::kUnsupported, "agent {} {}, and spontaneous movements are an infant's torques", agent,
       infant.age ? "is not moved by torques" : "is no infant");
}

void spontaneous(const World& world, std::size_t agent, std::uint32_t which, Span<float> actions) {
  const Agent& infant = world.agents()[agent];
  const actuation::Actuation& actuation = *infant.actuation;
  infant.movements->command(world.noise() ^ infant.movements_key, world.data().time, which, actions);
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const float low = actuation.low()[i], high = actuation.high()[i];
    actions[i] = std::clamp(actions[i] > 0 ? actions[i] * high : -actions[i] * low, low, high);
  }
}

}  // namespace mimo::env
