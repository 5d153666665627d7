#include "env/sounds.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "env/things.h"

namespace mimo::env {

bool listens(const std::vector<AgentOptions>& agents) {
  return std::any_of(agents.begin(), agents.end(), [](const AgentOptions& agent) { return agent.hearing.any(); });
}

senses::Soundscape* add_soundscape(observation::Observer& observer, const mjModel& model, double tick,
                                   const std::vector<AgentOptions>& agents, const EnvOptions& options) {
  if (!listens(agents)) return nullptr;
  auto made = std::make_unique<senses::Soundscape>(model, solids_of(model, agents, options), tick, options.play);
  senses::Soundscape* soundscape = made.get();
  observer.add(std::make_unique<senses::Around>(std::move(made)));
  return soundscape;
}

void play(senses::Soundscape* soundscape, const mjModel& model, const std::string& body, Span<const float> samples,
          double rate) {
  if (soundscape == nullptr) fail(Status::kUnsupported, "nobody hears here: switch hearing on for an agent");
  const int id = engine::find_or_fail(model, engine::Kind::kBody, body);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    require(std::isfinite(samples[i]), "samples[{}] is {}, expected a finite number", i, samples[i]);
    require(std::abs(samples[i]) <= 1e6F, "samples[{}] is {}, expected up to 1e6 Pa", i, samples[i]);
  }
  soundscape->play(id, samples, rate);
}

}  // namespace mimo::env
