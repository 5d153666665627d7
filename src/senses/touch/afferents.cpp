#include "senses/touch/afferents.h"

#include <algorithm>
#include <cmath>

#include "receptors/touch_afferents.h"

namespace mimo::senses::touch {
namespace {

constexpr double kSmoothing = 0.010;  // s, of forces; and of PC's envelope
constexpr double kNoForce = 1e-5;     // N
constexpr double kStill = 1e-5;       // m/s

}  // namespace

Afferents::Afferents(const std::vector<Patch>& patches, double slip_threshold, double tick)
    : patches_(patches),
      slip_threshold_(slip_threshold),
      tick_(tick),
      kept_(std::exp(-tick / kSmoothing)),
      states_(patches.size()),
      sa1_(patches.size()),
      ra_(patches.size()),
      pc_(patches.size()),
      sa2_(2 * patches.size()),
      restless_(patches.size()) {}

// What presses has pressed for ever: no onset.
void Afferents::rest(const Felt& felt) {
  std::fill(states_.begin(), states_.end(), State());
  for (std::vector<float>* rates : {&sa1_, &ra_, &pc_, &sa2_}) std::fill(rates->begin(), rates->end(), 0.0F);
  restless_.clear();
  for (const int id : felt.sensors()) {
    const auto sensor = static_cast<std::size_t>(id);
    const Feeling& feeling = felt.of(id);
    State& state = states_[sensor];
    state.normal = feeling.normal;
    state.along = feeling.tangent.x();
    state.across = feeling.tangent.y();
    state.depth = receptors::indentation(state.normal, patches_[sensor].spacing);
    restless_.add(id);
    tell(sensor, {}, {});
  }
}

void Afferents::go_on(const Felt& felt) {
  for (const int sensor : felt.sensors()) restless_.add(sensor);
  restless_.each([&](std::size_t sensor) { return update(sensor, felt.of(static_cast<int>(sensor))); });
}

void Afferents::tell(const Felt& felt, const Things& things) {
  for (const int sensor : restless_.all()) tell(static_cast<std::size_t>(sensor), felt.of(sensor), things);
}

bool Afferents::update(std::size_t sensor, const Feeling& feeling) {
  State& state = states_[sensor];
  const auto smooth = [this](double& value, double now) { value = now + kept_ * (value - now); };
  smooth(state.normal, feeling.normal);
  smooth(state.along, feeling.tangent.x());
  smooth(state.across, feeling.tangent.y());
  const double depth = receptors::indentation(state.normal, patches_[sensor].spacing);
  const double speed = (depth - state.depth) / tick_;
  smooth(state.jolts, receptors::pc_rate((speed - state.speed) / tick_));
  if (state.jolts < receptors::kSilent) state.jolts = 0;
  state.depth = depth;
  state.speed = speed;
  const bool gone = feeling.normal == 0 && state.normal < kNoForce && std::abs(speed) < kStill && state.jolts == 0;
  if (!gone) return true;
  state = {};
  tell(sensor, {}, {});
  return false;
}

void Afferents::tell(std::size_t sensor, const Feeling& feeling, const Things& things) {
  const State& state = states_[sensor];
  double ra = receptors::ra_rate(state.speed), pc = state.jolts;
  const double sliding = feeling.normal > 0 ? feeling.sliding / feeling.normal : 0;
  if (sliding > slip_threshold_ && feeling.other >= 0) {
    const Thing& thing = things.by_geom[static_cast<std::size_t>(feeling.other)];
    ra += receptors::ra_of_sliding(sliding, {thing.wavelength, thing.amplitude});
    pc += receptors::pc_of_sliding(sliding, {thing.wavelength, thing.amplitude});
  }
  sa1_[sensor] = static_cast<float>(receptors::sa1_rate(state.depth, state.speed));
  ra_[sensor] = static_cast<float>(ra);
  pc_[sensor] = static_cast<float>(pc);
  const bool stretched = state.normal >= kNoForce && patches_[sensor].region != receptors::Region::kFinger;
  const double force = std::sqrt(state.along * state.along + state.across * state.across);
  const double all = receptors::stretch(force, patches_[sensor].spacing);
  const auto channel = [&](double part) {
    return stretched ? static_cast<float>(receptors::sa2_rate(force > 0 ? all * part / force : 0, all)) : 0.0F;
  };
  sa2_[2 * sensor] = channel(state.along);
  sa2_[2 * sensor + 1] = channel(state.across);
}

void Afferents::save(ByteWriter& to) const {
  for (const State& s : states_) {
    for (const double number : {s.normal, s.along, s.across, s.depth, s.speed, s.jolts}) to.put(number);
  }
  for (const std::vector<float>* rates : {&sa1_, &ra_, &pc_, &sa2_}) to.put(Span<const float>(*rates));
}

void Afferents::load(ByteReader& from) {
  restless_.clear();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    State& s = states_[i];
    for (double* number : {&s.normal, &s.along, &s.across, &s.depth, &s.speed, &s.jolts}) {
      *number = from.take_finite("a touch afferent");
    }
    if (s.normal != 0 || s.jolts != 0 || s.speed != 0) restless_.add(static_cast<int>(i));
  }
  for (std::vector<float>* rates : {&sa1_, &ra_, &pc_, &sa2_}) from.take(Span<float>(*rates));
}

}  // namespace mimo::senses::touch
