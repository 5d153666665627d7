#include "env/sounds.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "env/things.h"
#include "growth/voice.h"
#include "senses/hearing/hearing.h"

namespace mimo::env {

bool listens(const std::vector<AgentOptions>& agents) {
  return std::any_of(agents.begin(), agents.end(), [](const AgentOptions& agent) { return agent.hearing.wanted != 0; });
}

senses::Soundscape* add_soundscape(observation::Observer& observer, const mjModel& model, double tick,
                                   const std::vector<AgentOptions>& agents, const EnvOptions& options) {
  if (!listens(agents)) return nullptr;
  const auto voices =
      std::count_if(agents.begin(), agents.end(), [](const AgentOptions& agent) { return agent.voice; });
  auto made = std::make_unique<senses::Soundscape>(model, solids_of(model, agents, options), tick, options.play,
                                                   static_cast<std::size_t>(voices));
  senses::Soundscape* soundscape = made.get();
  observer.add(std::make_unique<senses::Around>(std::move(made)));
  return soundscape;
}

void add_voice(Perception& agent, const mjModel& model, const AgentOptions& options, senses::Soundscape* soundscape) {
  agent.voice = std::make_shared<sound::Utterance>();
  const auto add = [&](const char* name, double low, double high, const char* unit, double& number) {
    agent.actuation->add_control(options.prefix() + name, low, high, unit,
                                 std::shared_ptr<double>(agent.voice, &number));
  };
  add("voice:loudness", 0, 1, "", agent.voice->loudness);
  add("voice:pitch", -0.5, 0.5, "octave", agent.voice->pitch);
  add("voice:opening", 0.7, 1.3, "", agent.voice->opening);
  add("voice:front", 0.7, 1.3, "", agent.voice->front);
  senses::Mouth mouth = senses::mouth_of(model, agent.body);
  if (soundscape == nullptr) return;
  const double age = (options.growth.body ? options.growth : growth::Growth{}).age;  // of the size of its throat
  mouth.pitch = growth::vocal_pitch(age);
  mouth.formants = growth::vocal_formants(age);
  mouth.told = agent.voice;
  agent.own_sound = soundscape->add(mouth);
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
