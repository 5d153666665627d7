#include "env/spontaneous.h"

#include <algorithm>
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

// Infants of one world have motors of different names, "anna/act:left_elbow", and move differently.
std::uint64_t seed_of(std::uint64_t episode, const std::vector<std::string>& actions) {
  for (const std::string& action : actions) {
    const std::size_t at = action.find(names::kMotor);
    if (at == std::string::npos || at == 0) continue;
    Hash hash;
    hash.add(action.substr(0, at));
    return episode ^ hash.value();
  }
  return episode;
}

}  // namespace

void require_spontaneous(const World& world, std::size_t agent) {
  const Agent& infant = world.agents()[agent];
  if (infant.age && infant.mode == actuation::Mode::kTorque) return;
  fail(Status::kUnsupported, "agent {} {}, and spontaneous movements are an infant's torques", agent,
       infant.age ? "is not moved by torques" : "is no infant");
}

void spontaneous(const World& world, std::size_t agent, std::uint32_t which, Span<float> actions) {
  const Agent& infant = world.agents()[agent];
  const actuation::Actuation& actuation = *infant.actuation;
  std::vector<std::string> motors;
  for (const std::string& name : actuation.names()) motors.push_back(motor_of(name));
  const std::uint64_t seed = seed_of(world.noise(), actuation.names());
  movements::Spontaneous(motors, infant.age->physiology).command(seed, world.data().time, which, actions);
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const float low = actuation.low()[i], high = actuation.high()[i];
    actions[i] = std::clamp(actions[i] > 0 ? actions[i] * high : -actions[i] * low, low, high);
  }
}

}  // namespace mimo::env
