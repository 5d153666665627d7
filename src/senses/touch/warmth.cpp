#include "senses/touch/warmth.h"

#include <algorithm>
#include <cmath>

#include "receptors/thermoreceptors.h"

namespace mimo::senses::touch {
namespace {

constexpr double kTouching = 1e-3;  // N, smoothed
constexpr double kRested = 1e-4;    // degrees

}  // namespace

Warmth::Warmth(const std::vector<Patch>& patches, double air, double tick)
    : patches_(patches),
      rest_(receptors::resting_temperature({37, air})),
      tick_(tick),
      kept_(receptors::skin_kept({37, air}, tick)),
      kept_cold_(std::exp(-tick / receptors::kColdLag)),
      kept_warm_(std::exp(-tick / receptors::kWarmLag)),
      states_(patches.size()),
      temperature_(patches.size()),
      cold_(patches.size()),
      warm_(patches.size()),
      restless_(patches.size()) {
  rest();
}

void Warmth::rest() {
  restless_.clear();
  std::fill(states_.begin(), states_.end(), State{rest_, rest_, rest_});
  for (std::size_t i = 0; i < states_.size(); ++i) tell(i);
}

void Warmth::go_on(const Felt& felt, const Afferents& afferents, const Things& things) {
  for (const int sensor : afferents.restless()) {
    if (afferents.force(static_cast<std::size_t>(sensor)) > kTouching) restless_.add(sensor);
  }
  restless_.each([&](std::size_t sensor) {
    const double force = afferents.force(sensor);
    return update(sensor, force > kTouching ? felt.of(static_cast<int>(sensor)).other : -1, force, things);
  });
}

// A contact that breaks for a step or two goes on: the smoothed force tells.
bool Warmth::update(std::size_t sensor, int touching, double force, const Things& things) {
  State& state = states_[sensor];
  if (force <= kTouching) {
    state.other = -1;
  } else if (touching >= 0 && touching != state.other) {
    state.before = state.surface;
    state.since = 0;
    state.other = touching;
  }
  if (state.other >= 0) {
    const Thing& thing = things.by_geom[static_cast<std::size_t>(state.other)];
    state.since += tick_;
    state.surface = receptors::touched_temperature(state.before, thing.temperature, thing.effusivity, state.since);
  } else {
    state.surface = rest_ + kept_ * (state.surface - rest_);
  }
  state.at_cold = state.surface + kept_cold_ * (state.at_cold - state.surface);
  state.at_warm = state.surface + kept_warm_ * (state.at_warm - state.surface);
  const auto off = [this](double degrees) { return std::abs(degrees - rest_) > kRested; };
  const bool restless = state.other >= 0 || off(state.surface) || off(state.at_cold) || off(state.at_warm);
  temperature_[sensor] = static_cast<float>(state.surface);
  if (restless) return true;
  state = {rest_, rest_, rest_};
  tell(sensor);
  return false;
}

void Warmth::tell() {
  for (const int sensor : restless_.all()) tell(static_cast<std::size_t>(sensor));
}

void Warmth::tell(std::size_t sensor) {
  const State& state = states_[sensor];
  const double factor = receptors::thermal_factor(patches_[sensor].region);
  temperature_[sensor] = static_cast<float>(state.surface);
  const double cooling = (state.surface - state.at_cold) / receptors::kColdLag;
  const double warming = (state.surface - state.at_warm) / receptors::kWarmLag;
  cold_[sensor] = static_cast<float>(factor * receptors::cold_rate(state.at_cold, cooling));
  warm_[sensor] = static_cast<float>(factor * receptors::warm_rate(state.at_warm, warming));
}

void Warmth::save(ByteWriter& to) const {
  for (const State& s : states_) {
    for (const double number : {s.surface, s.at_cold, s.at_warm, s.before, s.since}) to.put(number);
    to.put(std::int32_t{s.other});
  }
}

void Warmth::load(ByteReader& from) {
  restless_.clear();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    State& s = states_[i];
    for (double* number : {&s.surface, &s.at_cold, &s.at_warm, &s.before, &s.since}) {
      *number = from.take_finite("skin's temperature");
    }
    s.other = from.take<std::int32_t>();
    const bool resting = s.other < 0 && s.surface == rest_ && s.at_cold == rest_ && s.at_warm == rest_;
    if (!resting) restless_.add(static_cast<int>(i));
    tell(i);
  }
}

}  // namespace mimo::senses::touch
